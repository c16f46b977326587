//! What a run leaves of bolts, and that it leaves the same when it was stopped.

use crate::block::block;
use crate::ready::Ready;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use tremolite::plan::{BoltMonitor, Monitor, Plan};
use tremolite::quantities::{BOLT, MONITOR, RELATIVE};
use tremolite::run::{Control, Progress, run};
use tremolite::simulation::{Built, Ending, Outcome, Simulation, Start};
use tremolite::stages::PlannedStage;
use tremolite::{Bar, Bolts, Problem, Stage};
use tremolite_mesh::locate::Locator;
use tremolite_results::{BoltLines, Column, EARTHQUAKE, Pvd, ResultFolder, Table, columns, read_bolts};

/// Two bolts of 4 m that a stage places, and one for the shaking alone.
pub fn bolted() -> Problem {
    let bar = |x: f64| Bar { points: vec![[x, 5.0, 5.0], [x + 0.5, 5.2, 9.0]], areas: vec![5e-4] };
    let group = |name: &str, bars: Vec<Bar>, born: Stage, yields: f64| Bolts {
        name: name.into(),
        bars,
        young: 200e9,
        yields,
        breaks: f64::INFINITY,
        bond: None,
        pretension: 0.0,
        free_length: 0.0,
        plates: [false; 2],
        born,
    };
    let mut problem = block([12, 12, 16]);
    problem.time_step.given = Some(2e-5);
    problem.bolts = vec![
        group("crown, east", vec![bar(3.0), bar(6.0)], Stage::Before(1), 400e6),
        group("late", vec![bar(9.0)], Stage::Shaking, f64::INFINITY),
    ];
    problem
}

pub fn plan() -> Plan {
    let monitor =
        |name: &str, x: f64, set: usize| BoltMonitor { name: name.into(), point: [x, 5.1, 7.0], set };
    let mesh = bolted().mesh;
    let locator = Locator::new(&mesh, None);
    let at = |name: &str, point: [f64; 3]| Monitor {
        name: name.into(),
        point,
        location: locator.locate(point, 1e-6).unwrap(),
    };
    Plan {
        page: tremolite_results::PageWish::default(),
        boundaries: Default::default(),
        target: None,
        title: "bolts".into(),
        stages: ["start", "bench 1"].map(PlannedStage::new).into(),
        duration: 0.12,
        recorded: None,
        waves: None,
        histories: 0.002,
        snapshots: Some(0.02),
        fields: Vec::new(),
        field_elements: 250_000,
        checkpoint: None,
        monitors: vec![at("a.b-c", [6.0, 5.0, 8.0]), at("d.ux", [6.0, 5.0, 2.0])],
        pairs: Vec::new(),
        bolts: vec![monitor("B", 6.2, 0), monitor("L", 9.2, 1)],
        bars: 0,
        water: false,
        relatives: vec![[0, 1]],
        sections: Vec::new(),
    }
}

fn go(folder: &Path, resume: bool, stop: bool) -> Outcome {
    let Ready { model, assembly, phase } = Ready::new(bolted());
    let results = match resume {
        true => ResultFolder::open_existing(folder).unwrap(),
        false => ResultFolder::create(Some(folder), "bolts", true).unwrap(),
    };
    let stopped = AtomicBool::new(false);
    let mut tell = |p: Progress| {
        if stop && p.step >= 1 {
            stopped.store(true, Ordering::Relaxed);
        }
    };
    let mut control = Control { stop: &stopped, progress: &mut tell };
    let start = if resume { Start::Resume } else { Start::Rest };
    Simulation::new(&Built::of(&model, &assembly, &phase), &plan(), &results, start, Vec::new())
        .and_then(|simulation| run(simulation, &mut control))
        .unwrap()
}

#[test]
fn bolts_are_written_as_they_stand_and_a_stopped_run_resumes_to_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let (whole, parts) = (folder.path().join("whole"), folder.path().join("parts"));
    assert_eq!(go(&whole, false, false).ending, Ending::Done);
    let results = ResultFolder::open_existing(&whole).unwrap();

    let rows = read_bolts(&results.bolts()).unwrap();
    let count = |stage: &str, name: &str| rows.iter().filter(|r| r.stage == stage && r.name == name).count();
    // The row at 0 s and six more.
    assert_eq!([count("start", "crown, east"), count("bench 1", "crown, east")], [0, 2]);
    assert_eq!(
        [count(EARTHQUAKE, "crown, east"), count(EARTHQUAKE, "late"), count("bench 1", "late")],
        [14, 7, 0]
    );
    assert!(rows.iter().all(|row| row.time.is_nan() == (row.stage != EARTHQUAKE)));
    let most = |name: &str| {
        rows.iter().filter(|r| r.name == name).map(|r| r.largest_force.abs()).fold(0.0, f64::max)
    };
    assert!(most("crown, east") > 0.0 && most("late") > 0.0);
    assert!(rows.iter().all(|row| row.name != "late" || row.force_over_yield == 0.0));

    let list = Pvd::read(&results.bolts_pvd()).unwrap();
    assert_eq!(list.snapshots().len(), 7, "of the shaking alone");
    let lines = BoltLines::read(&list.locate(&list.snapshots()[6])).unwrap();
    assert_eq!(lines.groups, ["crown, east", "late"]);
    let before = BoltLines::read(&results.bolt_fields().join("stage-001.vtu")).unwrap();
    assert!(before.lines.len() < lines.lines.len() && before.lines.iter().all(|line| line.group == 0));
    assert!(!results.bolt_fields().join("stage-000.vtu").exists(), "nothing is placed");

    // What a monitor sees is what the files hold of its segment.
    let table = Table::read(&results.monitors()).unwrap();
    assert_eq!(table.columns.len(), 1 + 2 * (MONITOR.len() + BOLT.len()) + RELATIVE.len());
    let force = table.column("B.force").unwrap();
    let last = *force.last().unwrap() as f32;
    let of_bolt = lines.lines.iter().filter(|line| line.group == 0 && line.bolt == 2);
    assert!(of_bolt.clone().any(|line| line.force == f64::from(last)), "{last}");
    assert!(table.column("L.force_over_yield").unwrap().iter().all(|x| *x == 0.0));
    let stages = std::fs::read_to_string(results.stages()).unwrap();
    let fields =
        |row: usize| stages.lines().nth(row).unwrap().rsplit(',').map(str::to_owned).collect::<Vec<_>>();
    assert!(fields(2)[..BOLT.len()].iter().all(|x| x == "NaN"), "L is not placed in the stages: {stages}");
    assert!(fields(2)[BOLT.len()..2 * BOLT.len()].iter().all(|x| x != "NaN"), "{stages}");

    // The monitors' columns are the same in both tables, in headers and in what is told of them.
    let told = |table: &Path| -> Vec<Column> {
        serde_json::from_slice(&std::fs::read(columns::beside(table)).unwrap()).unwrap()
    };
    let (of_stages, of_shaking) = (told(&results.stages()), told(&results.monitors()));
    assert_eq!((of_shaking.len(), of_stages.len()), (table.columns.len(), fields(0).len()));
    assert_eq!(of_stages[of_stages.len() - of_shaking.len() + 1..], of_shaking[1..]);
    let mut headers = fields(0);
    headers.reverse();
    assert_eq!(headers, of_stages.iter().map(Column::header).collect::<Vec<_>>());
    assert!(headers.contains(&"a.b-c-d.ux.u [m]".to_owned()), "{headers:?}");

    assert_eq!(go(&parts, false, true).ending, Ending::Stopped);
    assert_eq!(go(&parts, true, false).ending, Ending::Done);
    for file in
        ["bolts.csv", "bolts.pvd", "bolts/000006.vtu", "bolts/stage-001.vtu", "monitors.csv", "stages.csv"]
    {
        let bytes = |folder: &Path| std::fs::read(folder.join(file)).unwrap();
        assert!(bytes(&whole) == bytes(&parts), "{file}");
    }
}
