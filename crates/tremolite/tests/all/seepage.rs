//! Cases in which water flows to an opening: pressures of each stage, what a lining closes, drains, and what is refused.

use std::sync::atomic::AtomicBool;
use tremolite::Stage;
use tremolite::hexahedra::centroid;
use tremolite::job::{Caller, Given, Inputs, Job};
use tremolite::run::Control;
use tremolite::seepage::StageFlow;
use tremolite::simulation::{Ending, Go, Start};
use tremolite::stages::flow_in;
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::vtu::{Grid, Values};
use tremolite_results::{ResultFolder, Status, read_sections};

const HALL: &str = r#"title = "hall in wet rock"
[mesh.file]
path = "hall.msh"
unit = "1 m"
[water]
level = "-5 m"
pressure = "seepage"
heads = { xmin = "-5 m", xmax = "-5 m" }
[material.rock]
law = "elastic"
young = "2 GPa"
poisson = 0.25
unit_weight = "27 kN/m3"
water = { biot = 1, hydraulic_conductivity = "1e-7 m/s" }
[material.concrete]
law = "elastic"
young = "25 GPa"
poisson = 0.2
unit_weight = "25 kN/m3"
water = "none"
[[region]]
groups = ["rock", "core"]
material = "rock"
element = "reduced-integration"
[[region]]
groups = ["shell"]
material = "concrete"
element = "full-integration"
[[interface]]
name = "joint"
between = ["shell", "rock"]
law = "coulomb"
normal_stiffness = "20 GPa/m"
friction_coefficient = 0.6
cohesion = "0 Pa"
[initial]
lateral = 0.5
[[stage]]
name = "dig"
excavate = ["core"]
[[stage]]
name = "line"
install = ["shell"]
"#;

/// A block of 60 × 10 × 60 m with a hall of 10 m that has a shell of 5 m around it.
fn given() -> Given {
    let mut mesh = BoxSpec::uniform([0.0, 0.0, -60.0], [60.0, 10.0, 0.0], [12, 2, 12]).mesh().unwrap();
    let far = |e: u32| {
        let [x, _, z] = centroid(&mesh, e);
        (x - 30.0).abs().max((z + 30.0).abs())
    };
    let within =
        |low: f64, high: f64| (0..288).filter(|&e| (low..high).contains(&far(e))).collect::<Vec<u32>>();
    let groups = [("core", within(0.0, 5.0)), ("shell", within(5.0, 10.0)), ("rock", within(10.0, 60.0))];
    mesh.groups = groups.map(|(name, elements)| (name.to_owned(), elements)).into();
    let inputs = Inputs { meshes: [("hall.msh".to_owned(), mesh)].into(), ..Inputs::default() };
    Given { inputs, ..Given::default() }
}

fn job(text: &str) -> Result<Job, String> {
    let folder = tempfile::tempdir().unwrap();
    Job::of_text(text, folder.path(), &given()).map_err(|fault| fault.to_string())
}

fn made(text: &str) -> Job {
    job(text).unwrap_or_else(|fault| panic!("{fault}"))
}

/// Pressure \[Pa\] of an element at a place in a stage.
fn p(job: &Job, at: [f64; 3], stage: u16) -> f64 {
    let mesh = &job.model.mesh;
    let near = |e: &usize| {
        let x = centroid(mesh, *e as u32);
        (0..3).all(|i| (x[i] - at[i]).abs() < 1e-6)
    };
    let e = (0..288).find(near).unwrap();
    job.model.water.pressure(e, Stage::Before(stage))
}

fn flow(job: &Job, stage: usize) -> &StageFlow {
    flow_in(&job.plan.stages, stage).unwrap()
}

/// Beside the wall, and far from it.
const WALL: [f64; 3] = [42.5, 2.5, -32.5];
const FAR: [f64; 3] = [57.5, 2.5, -32.5];
const STILL: f64 = 9810.0 * 27.5;

/// The hall drains its rock; what flows to it comes from the sides, and its mirror image is its own.
#[test]
fn an_opening_drains_the_rock_until_its_lining_closes_it() {
    let job = made(HALL);
    assert!((p(&job, WALL, 0) - STILL).abs() < 1e-6);
    let own = flow(&job, 1);
    assert_eq!(own.taken().len(), 1);
    let (name, q) = &own.taken()[0];
    assert_eq!(name, "shell");
    assert!(*q > 0.0 && (own.inflow / q - 1.0).abs() < 1e-6 && own.mass_error < 1e-6);
    let heads: f64 = own.places[own.heads..].iter().map(|(_, q)| q).sum();
    assert!((heads + q).abs() < 1e-6 * q);
    assert!((own.places[1].1 / own.places[2].1 - 1.0).abs() < 1e-6, "mirror image: {:?}", own.places);
    assert!(p(&job, WALL, 1) < 0.3 * STILL, "{}", p(&job, WALL, 1));
    assert!(p(&job, FAR, 1) > p(&job, WALL, 1) && p(&job, FAR, 1) < STILL);
    let mirrored = p(&job, [60.0 - WALL[0], WALL[1], WALL[2]], 1);
    assert!((mirrored - p(&job, WALL, 1)).abs() < 1e-6 * STILL);
    // Behind the shell the water rises again.
    assert!((p(&job, WALL, 2) / STILL - 1.0).abs() < 1e-9);
    assert!(flow(&job, 2).taken().is_empty() && flow(&job, 2).inflow == 0.0);
}

/// A drained interface, and walls that are named, stay open behind a lining.
#[test]
fn a_lining_may_be_drained() {
    let open = made(HALL);
    let interface =
        made(&HALL.replace("cohesion = \"0 Pa\"\n", "cohesion = \"0 Pa\"\nwater = { drained = true }\n"));
    let named = made(
        &HALL
            .replace("install = [\"shell\"]\n", "install = [\"shell\"]\nwater = { drained = [\"shell\"] }\n"),
    );
    for (job, name) in [(&interface, "joint"), (&named, "shell")] {
        assert_eq!(flow(job, 2).taken()[0].0, name);
        assert_eq!(p(job, WALL, 2), p(&open, WALL, 1));
    }
    // Nothing but the named walls takes water.
    let closed =
        made(&HALL.replace("excavate = [\"core\"]\n", "excavate = [\"core\"]\nwater = { drained = [] }\n"));
    assert!((p(&closed, WALL, 1) / STILL - 1.0).abs() < 1e-9);
    // A void full of water has its head at the wall: at the level of the ground nothing flows.
    let full = made(&HALL.replace(
        "excavate = [\"core\"]\n",
        "excavate = [\"core\"]\nwater = { filled = { \"rock\" = \"-5 m\" } }\n",
    ));
    assert!((p(&full, WALL, 1) / STILL - 1.0).abs() < 1e-9);
}

#[test]
fn drains_take_water_and_say_so() {
    let drained = |from: &str| {
        let drain = format!(
            "install = [\"shell\"]\nwater = {{ drains = [{{ from = [{from}, \"0 m\", \"-50 m\"], to = [{from}, \"10 m\", \"-50 m\"] }}] }}\n"
        );
        made(&HALL.replace("install = [\"shell\"]\n", &drain))
    };
    let job = drained("\"30 m\"");
    let (name, q) = &flow(&job, 2).taken()[0];
    assert!(name == "drain 1" && *q > 0.0, "{name} {q}");
    assert!(p(&job, WALL, 2) < 0.95 * STILL);
    let [left, right] = ["\"20 m\"", "\"40 m\""].map(drained);
    let image = [60.0 - WALL[0], WALL[1], WALL[2]];
    assert!((p(&left, WALL, 2) - p(&right, image, 2)).abs() < 1e-6 * STILL);
    let away = HALL.replace("install = [\"shell\"]\n", "install = [\"shell\"]\nwater = { drains = [{ from = [\"90 m\", \"0 m\", \"0 m\"], to = [\"90 m\", \"9 m\", \"0 m\"] }] }\n");
    assert!(self::job(&away).err().unwrap().contains("this drain passes no ground"));
    let group = HALL.replace(
        "install = [\"shell\"]\n",
        "install = [\"shell\"]\nwater = { drains = [{ on = \"rock\" }] }\n",
    );
    assert!(p(&made(&group), WALL, 2) == 0.0);
}

/// Ground at the head of its level has the level's pressures.
#[test]
fn level_ground_at_the_head_has_the_pressures_of_the_level() {
    let plain = HALL.split("[[stage]]").next().unwrap();
    let plain = plain.replace("groups = [\"rock\", \"core\"]", "groups = [\"rock\", \"core\", \"shell\"]");
    let plain = plain.replace(
        "[[region]]\ngroups = [\"shell\"]\nmaterial = \"concrete\"\nelement = \"full-integration\"\n",
        "",
    );
    let plain = &plain[..plain.find("[[interface]]").unwrap()];
    let flows = format!("{plain}[initial]\nlateral = 0.5\n[[stage]]\nname = \"later\"\n");
    let job = made(&flows);
    let [start, later] = &job.model.water.spells[..] else { panic!("two spells") };
    let most = start.elements.iter().copied().fold(0.0, f64::max);
    for (a, b) in start.elements.iter().zip(&later.elements).chain(start.nodes.iter().zip(&later.nodes)) {
        assert!((a - b).abs() < 1e-15 * most, "{a} {b}");
    }
    assert_eq!(flow(&job, 1).inflow, 0.0);
}

/// The pressures come of the case alone.
#[test]
fn pressures_have_the_same_bits_on_any_number_of_threads() {
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| made(HALL).model.water.clone())
    };
    assert_eq!(on(1), on(2));
}

/// The field of a stage has the flow of each element at that element.
#[test]
fn the_field_has_the_flow_of_its_elements() {
    let folder = tempfile::tempdir().unwrap();
    let job = made(&format!("{HALL}[output]\nfields = [\"seepage\"]\n"));
    let results = ResultFolder::create(Some(folder.path()), "field", true).unwrap();
    let mut control = Control { stop: &AtomicBool::new(false), progress: &mut |_| {} };
    job.run(&results, Start::Rest, &Caller::new("test"), &mut control).unwrap();
    let grid = Grid::read(&results.stage_fields().join("001.vtu")).unwrap();
    let array = |name: &str| &grid.cell_data.iter().find(|array| array.name == name).unwrap().values;
    let (Values::Int64(elements), Values::Float32(found)) = (array("element"), array("seepage")) else {
        panic!("other kinds of numbers")
    };
    let exact = &flow(&job, 1).velocities;
    let moves = elements.iter().filter(|&&e| exact[e as usize - 1] != [0.0; 3]).count();
    assert!(moves > 200 && found.len() == 3 * elements.len());
    for (e, found) in elements.iter().zip(found.chunks(3)) {
        assert_eq!(exact[*e as usize - 1].map(|q| q as f32), found, "element {e}");
    }
}

/// What a stopped run goes on with is found anew, and is the same: so are its files.
#[test]
fn a_resumed_run_has_the_pressures_of_one_that_never_stopped() {
    let folder = tempfile::tempdir().unwrap();
    let text = HALL.replace(
        "lateral = 0.5\n",
        "lateral = 0.5\n[[monitor]]\nname = \"A\"\nat = [\"44 m\", \"2 m\", \"-32 m\"]\n",
    );
    let job = made(&text);
    let make = |name: &str| ResultFolder::create(Some(&folder.path().join(name)), name, false).unwrap();
    let through = |results: &ResultFolder, start: Start| {
        let stop = AtomicBool::new(false);
        let mut control = Control { stop: &stop, progress: &mut |_| {} };
        made(&text).run(results, start, &Caller::new("test"), &mut control).unwrap().1
    };
    let all = make("whole");
    let whole = through(&all, Start::Rest);
    assert_eq!(whole.conclusion.status, Status::Done, "{}", whole.conclusion.verdict);
    // Stopped when the hall has been dug, before its lining is placed.
    let half = make("parts");
    let begun = job.begin(&half, Start::Rest).unwrap();
    let mut simulation = begun.simulation(&job, Vec::new()).unwrap();
    (0..2).for_each(|_| drop(simulation.relax(&mut |_| Go::On).unwrap()));
    assert!(simulation.stage().is_some());
    assert!(simulation.checkpoint().unwrap().is_none());
    let outcome = simulation.finish(Ending::Stopped, 0.0).unwrap();
    let stopped = begun.end(&job, &outcome, &Caller::new("test")).unwrap();
    assert_eq!(stopped.conclusion.status, Status::Stopped, "{}", stopped.conclusion.verdict);
    drop((begun, half, simulation));
    let parts = ResultFolder::resume(Some(&folder.path().join("parts")), "parts").unwrap();
    let resumed = through(&parts, Start::Resume);
    assert_eq!((resumed.conclusion.status, resumed.computed.run.resumed), (Status::Done, 1));
    let bytes = |folder: &ResultFolder| std::fs::read(folder.stages()).unwrap();
    assert_eq!(bytes(&all), bytes(&parts));
    assert_eq!(resumed.computed.stages, whole.computed.stages);
    let flow = whole.computed.stages[1].seepage.as_ref().unwrap();
    assert!(flow.taken["shell"] > 0.0 && whole.computed.stages[0].seepage.is_none());
}

#[test]
fn what_does_not_flow_is_refused_with_a_way_out() {
    let refused = |from: &str, to: &str, words: &[&str]| {
        assert!(HALL.contains(from), "{from}");
        let fault = job(&HALL.replacen(from, to, 1)).err().unwrap_or_else(|| panic!("{to} is taken"));
        words.iter().for_each(|word| assert!(fault.contains(word), "{to}: no '{word}' in {fault}"));
    };
    let heads = "heads = { xmin = \"-5 m\", xmax = \"-5 m\" }\n";
    refused(heads, "", &["where the water of the seepage comes from", "heads = { sides"]);
    refused("pressure = \"seepage\"\n", "", &["`heads` has a meaning only with steady seepage"]);
    refused(
        ", hydraulic_conductivity = \"1e-7 m/s\"",
        "",
        &["no material of a region has a hydraulic conductivity", "1e-7 m/s"],
    );
    refused("xmax = ", "xmaxx = ", &["nothing is called 'xmaxx'", "did you mean 'xmax'"]);
    refused(
        "excavate = [\"core\"]\n",
        "excavate = [\"core\"]\nwater = { level = \"-9 m\" }\n",
        &["`level` of a stage", "heads"],
    );
    refused(
        "excavate = [\"core\"]\n",
        "excavate = [\"core\"]\nwater = { drained = [\"halls\"] }\n",
        &["no group of the mesh fits 'halls'"],
    );
    // A head below its ground brings no water; with no wall open either nothing is determined.
    let low = HALL.replace(heads, "heads = { top = \"-5 m\" }\n");
    let low = low.replacen("excavate = [\"core\"]\n", "excavate = [\"core\"]\nwater = { drained = [] }\n", 1);
    let fault = job(&low).err().unwrap();
    assert!(
        fault.contains("no water can come to or leave the ground") && fault.contains("give `heads`"),
        "{fault}"
    );
}

/// A void that reaches the plane of a head is warned of, and a level with an opening below it names seepage as the remedy.
#[test]
fn what_is_doubtful_is_said() {
    let has = |text: &str, words: &str| made(text).said().iter().any(|one| one.contains(words));
    assert!(!has(HALL, "comes in right beside it"));
    assert!(has(&HALL.replace("xmin = \"-5 m\", xmax", "sides"), "comes in right beside it"));
    assert!(has(&HALL.replace("xmin = \"-5 m\"", "xmin = \"-500 m\""), "no water comes in there"));
    let level = HALL.replace("pressure = \"seepage\"\nheads = { xmin = \"-5 m\", xmax = \"-5 m\" }\n", "");
    assert!(has(&level, "pressure = \"seepage\""));
    let tied = HALL.find("[[interface]]").unwrap()..HALL.find("[initial]").unwrap();
    let mut tied = HALL.replace(&HALL[tied], "");
    tied.push_str("[[stage]]\nname = \"rise\"\nwater = { heads = { xmin = \"0 m\", xmax = \"0 m\" } }\n");
    // Once, and not once a stage in which the water changes.
    tied.push_str("[[stage]]\nname = \"fall\"\nwater = { heads = { xmin = \"-5 m\", xmax = \"-5 m\" } }\n");
    let bonded =
        made(&tied).said().iter().filter(|one| one.contains("it does not feel the water behind it")).count();
    assert_eq!(bonded, 1);
    // A head on the walls of the void, which is empty; full, it presses and nothing is to be said.
    let held = HALL.replace("xmin = \"-5 m\", xmax", "shell = \"-5 m\", xmin = \"-5 m\", xmax");
    assert!(has(&held, "a void that is empty in stage 'dig'"));
    assert_eq!(made(&held).said().iter().filter(|one| one.contains("a void that is empty")).count(), 1);
    let dig = "excavate = [\"core\"]\n";
    let full = "excavate = [\"core\"]\nwater = { filled = { \"rock\" = \"-5 m\" } }\n";
    assert!(!has(&held.replace(dig, full), "a void that is empty"));
    // The rock behind a tight shell has no wall that could be drained.
    let line = "install = [\"shell\"]\n";
    let rock = HALL.replace(line, &format!("{line}water = {{ drained = [\"rock\"] }}\n"));
    assert!(has(&rock, "'rock' drains no wall here") && has(&rock, "such as 'shell'"));
    let shell = HALL.replace(line, &format!("{line}water = {{ drained = [\"shell\"] }}\n"));
    assert!(!has(&shell, "drains no wall"));
}

/// Of two words on one wall the water that fills the void holds: that presses on it, and a drain under water drains nothing.
#[test]
fn a_wall_that_is_full_and_drained_is_full() {
    let dig = |water: &str| {
        let stage = format!("excavate = [\"core\"]\nwater = {{ {water} }}\n");
        made(&HALL.replace("excavate = [\"core\"]\n", &stage))
    };
    let full = dig("filled = { \"rock\" = \"-15 m\" }");
    let both = dig("filled = { \"rock\" = \"-15 m\" }, drained = [\"rock\"]");
    let drained = dig("drained = [\"rock\"]");
    assert_eq!(p(&both, WALL, 1), p(&full, WALL, 1));
    assert!(p(&drained, WALL, 1) < 0.5 * p(&full, WALL, 1));
}

/// A shell with pores below still water: its thrust of effective stress is that of total stress and the pressure at its height over its
/// thickness, and where the water is the same through the thickness, in walls, it bends nothing. Without pores there is one thrust.
#[test]
fn a_lining_with_pores_has_its_forces_in_both_stresses() {
    let folder = tempfile::tempdir().unwrap();
    let still = HALL
        .replace("pressure = \"seepage\"\nheads = { xmin = \"-5 m\", xmax = \"-5 m\" }\n", "")
        .replace(", hydraulic_conductivity = \"1e-7 m/s\"", "");
    let rows = |name: &str, text: &str| {
        let results = ResultFolder::create(Some(&folder.path().join(name)), name, true).unwrap();
        let mut control = Control { stop: &AtomicBool::new(false), progress: &mut |_| {} };
        made(text).run(&results, Start::Rest, &Caller::new("test"), &mut control).unwrap();
        read_sections(&results.sections()).unwrap()
    };
    let porous = rows("porous", &still.replace("water = \"none\"", "water = { biot = 0.6 }"));
    let (total, effective): (Vec<_>, Vec<_>) = porous.into_iter().partition(|row| row.lining == "shell");
    assert!(total.len() > 6 && total.len() == effective.len(), "{} {}", total.len(), effective.len());
    let mut walls = 0;
    for (t, e) in total.iter().zip(&effective) {
        assert_eq!((e.lining.as_str(), e.station, e.place), ("shell, effective", t.station, t.place));
        let pressure = 9810.0 * (-5.0 - t.place[2]);
        let [n, m, q] = [0, 1, 2].map(|i| e.forces[i] - t.forces[i]);
        let size = pressure * t.thickness;
        assert!((n / size - 1.0).abs() < 1e-9, "{n} of {size} at {:?}", t.place);
        assert!(q.abs() < 1e-9 * size, "{q} at {:?}", t.place);
        if (t.place[0] - 30.0).abs() > 5.0 {
            walls += 1;
            assert!(m.abs() < 1e-9 * size * t.thickness, "{m} at {:?}", t.place);
        }
    }
    assert!(walls >= 4, "{walls}");
    assert!(rows("tight", &still).iter().all(|row| row.lining == "shell"));
}
