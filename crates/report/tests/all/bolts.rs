//! What bolts did is on the page of a run that has some, and on no other.

use std::f64::consts::PI;
use std::fs;
use std::path::Path;

use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::vtu::{Array, Grid, Values};
use tremolite_report::write;
use tremolite_results::{
    BoltPeak, BoltRow, BoltSummary, BoltWriter, Column, Computed, Conclusion, EARTHQUAKE, PartFacts, Pvd,
    ResultFolder, StageSummary, Status, Summary, TableWriter,
};

/// Force at which one yields (N): 25 mm of 400 MPa.
const YIELD: f64 = 1.96e5;
const LENGTH: f64 = 6.0;
const PIECES: usize = 12;

/// A bolt that is made up: its group, its number there, head, direction, and how hard it is worked at its worst.
struct Made {
    group: usize,
    bolt: u32,
    head: [f64; 3],
    along: [f64; 3],
    load: f64,
}

/// A cavern 20 m wide with walls 20 m high below a vault, its axis along y; rows of 1.5 m.
fn bolts() -> Vec<Made> {
    let mut all: Vec<Made> = Vec::new();
    let mut numbers = [0; 3];
    for row in 0..20 {
        let y = 0.75 + 1.5 * f64::from(row);
        // The ground pushes more where a joint runs through, at y = 18.
        let along_axis = 1.0 + 0.35 * (-((y - 18.0) / 4.0_f64).powi(2)).exp();
        let mut add = |group: usize, head: [f64; 3], along: [f64; 3], load: f64| {
            numbers[group] += 1;
            all.push(Made { group, bolt: numbers[group], head, along, load: load * along_axis });
        };
        for k in 0..13 {
            let angle = PI * (f64::from(k) + 1.0) / 14.0;
            let (c, s) = (angle.cos(), angle.sin());
            add(0, [10.0 * c, y, 6.0 * s], [c, 0.0, s], 0.32 + 0.18 * s);
        }
        for k in 0..13 {
            let z = -0.75 - 1.5 * f64::from(k);
            // The right wall bulges in its middle.
            let bulge = (PI * -z / 20.0).sin();
            add(1, [-10.0, y, z], [-1.0, 0.0, 0.0], 0.25 + 0.3 * bulge);
            add(1, [10.0, y, z], [1.0, 0.0, 0.0], 0.3 + 0.44 * bulge);
        }
        add(2, [-10.0, y, -21.0], [-1.0, 0.0, -0.2], 0.0);
    }
    all
}

/// Force (N) in a piece of a bolt: more towards the head, and where bolts of the right wall cross a joint.
fn force(bolt: &Made, piece: usize) -> f64 {
    let s = (piece as f64 + 0.5) / PIECES as f64;
    let joint = if bolt.head[0] > 9.0 { 0.5 * (-((s - 0.55) / 0.12_f64).powi(2)).exp() } else { 0.0 };
    YIELD * bolt.load * ((1.0 - s).powf(0.7) * (0.5 + s).min(1.0) + joint).min(1.0 / bolt.load.max(1e-9))
}

fn grid(all: &[Made]) -> Grid {
    let mut grid = Grid::default();
    let (mut at, mut group, mut number, mut now, mut state) = (vec![], vec![], vec![], vec![], vec![]);
    for bolt in all {
        let first = grid.points.len() as u32;
        for k in 0..=PIECES {
            let s = LENGTH * k as f64 / PIECES as f64;
            grid.points.push([0, 1, 2].map(|i| bolt.head[i] + s * bolt.along[i]));
            at.push(s as f32);
        }
        for k in 0..PIECES {
            grid.connectivity.extend([first + k as u32, first + k as u32 + 1]);
            grid.offsets.push(grid.connectivity.len() as u32);
            grid.types.push(3);
            group.push(bolt.group as i32);
            number.push(bolt.bolt as i32);
            now.push((0.9 * force(bolt, k)) as f32);
            let gone = bolt.group == 2 && bolt.bolt == 1;
            state.push(if gone {
                4
            } else if force(bolt, k) >= YIELD {
                2
            } else {
                0_u8
            });
        }
    }
    let scaled = |by: f64| Values::Float32(now.iter().map(|f| (f64::from(*f) * by) as f32).collect());
    let marks = |g: i32| Values::UInt8(group.iter().map(|of| u8::from(*of == g)).collect());
    grid.point_data = vec![Array::new("from_head", "m", 1, Values::Float32(at))];
    grid.cell_data = vec![
        Array::new("force", "N", 1, scaled(1.0)),
        Array::new("force_over_yield", "", 1, scaled(1.0 / YIELD)),
        Array::new("force_max", "N", 1, scaled(1.0 / 0.9)),
        Array::new("force_over_yield_max", "", 1, scaled(1.0 / 0.9 / YIELD)),
        Array::new("slip_max", "m", 1, scaled(1e-8)),
        Array::new("state", "", 1, Values::UInt8(state)),
        Array::new("group:crown", "", 1, marks(0)),
        Array::new("group:walls", "", 1, marks(1)),
        Array::new("group:toe", "", 1, marks(2)),
        Array::new("group", "", 1, Values::Int32(group.clone())),
        Array::new("bolt", "", 1, Values::Int32(number)),
    ];
    grid
}

/// The ground around the cavern.
fn ground() -> Grid {
    let mesh = BoxSpec::uniform([-30.0, 0.0, -40.0], [30.0, 30.0, 25.0], [60, 1, 65]).mesh().unwrap();
    let middle = |e: &u32| {
        let nodes = mesh.elements[*e as usize].nodes();
        [0, 2].map(|i| nodes.iter().map(|n| mesh.nodes[*n as usize][i]).sum::<f64>() / nodes.len() as f64)
    };
    let open = |[x, z]: [f64; 2]| match z {
        z if z > 0.0 => (x / 10.0).powi(2) + (z / 6.0).powi(2) < 1.0,
        z => x.abs() < 10.0 && z > -20.0,
    };
    let stands: Vec<u32> = (0..mesh.elements.len() as u32).filter(|e| !open(middle(e))).collect();
    let (mut grid, _) = Grid::from_mesh(&mesh, Some(&stands));
    grid.cell_data = vec![Array::new("body", "", 1, Values::Int32(vec![0; stands.len()]))];
    grid
}

fn summary(all: &[Made]) -> Summary {
    let group = |g: usize, placed: &str| {
        let own = || all.iter().filter(|bolt| bolt.group == g);
        let most = own().max_by(|a, b| force(a, 0).total_cmp(&force(b, 0))).unwrap();
        let yielded = own().filter(|bolt| (0..PIECES).any(|k| force(bolt, k) >= YIELD)).count() as u64;
        let largest = (0..PIECES).map(|k| force(most, k)).fold(0.0, f64::max);
        let loaded = largest > 0.0;
        BoltSummary {
            bolts: own().count() as u64,
            given: own().count() as u64 + 3,
            shortened: 4,
            left_out: 3,
            length: LENGTH * own().count() as f64,
            segments: (own().count() * PIECES) as u64,
            placed: placed.into(),
            there: true,
            bonded: g != 2,
            yield_force: if g == 2 { f64::NAN } else { YIELD },
            largest: BoltPeak {
                force: largest,
                bolt: if loaded { u64::from(most.bolt) } else { 0 },
                at: most.head,
                stage: if loaded { EARTHQUAKE.into() } else { String::new() },
                time: 5.25,
            },
            force_over_yield: if g == 2 { 0.0 } else { largest / YIELD },
            yielded,
            slid: if g == 1 { 12 } else { 0 },
            cut: u64::from(g == 2),
            gone: u64::from(g == 2),
            max_slip: if g == 1 { 3.1e-3 } else { 0.0 },
            ..BoltSummary::default()
        }
    };
    let stage = |name: &str| StageSummary { name: name.into(), ..StageSummary::default() };
    let mut summary = Summary {
        title: "A bolted cavern".into(),
        conclusion: Conclusion {
            status: Status::Done,
            outcome: "The run reached its end, 12.00 s.".into(),
            ..Conclusion::default()
        },
        computed: Computed {
            stages: ["", "crown", "bench 1", "bench 2"].map(stage).into(),
            ..Computed::default()
        },
        parts: PartFacts {
            bolts: [("crown", "crown"), ("walls", "bench 1"), ("toe", "")]
                .into_iter()
                .enumerate()
                .map(|(g, (name, placed))| (name.to_owned(), group(g, placed)))
                .collect(),
            ..PartFacts::default()
        },
        ..Summary::default()
    };
    summary.computed.model.duration = 12.0;
    summary.computed.motion.kind = "outcrop".into();
    summary
}

fn rows(all: &[Made]) -> Vec<BoltRow> {
    let mut rows = Vec::new();
    let times = [("crown", f64::NAN, 0.6), ("bench 1", f64::NAN, 0.75), ("bench 2", f64::NAN, 0.8)];
    for (k, (stage, time, share)) in
        times.into_iter().chain([(EARTHQUAKE, 0.0, 0.8), (EARTHQUAKE, 5.5, 0.97)]).enumerate()
    {
        for bolt in all.iter().filter(|bolt| bolt.group != 1 || k > 0) {
            let most = share * (0..PIECES).map(|k| force(bolt, k)).fold(0.0, f64::max);
            rows.push(BoltRow {
                bolt: bolt.bolt,
                name: ["crown", "walls", "toe"][bolt.group].into(),
                time,
                max_force: most,
                force_over_yield: if bolt.group == 2 { 0.0 } else { most / YIELD },
                max_slip: 0.0,
                state: "elastic".into(),
                stage: stage.into(),
                place: bolt.head,
                largest_force: most,
                cut_off: 0.0,
            });
        }
    }
    rows
}

/// A result folder as a run with bolts leaves it.
pub fn results(root: &Path) -> ResultFolder {
    let folder = ResultFolder::create(Some(root), "bolts", true).unwrap();
    let all = bolts();
    summary(&all).write(&folder.summary()).unwrap();
    BoltWriter::create(&folder.bolts(), &rows(&all)).unwrap();
    fs::create_dir_all(folder.bolt_fields()).unwrap();
    grid(&all).write(&folder.bolt_fields().join("000012.vtu")).unwrap();
    Pvd::create(&folder.bolts_pvd()).unwrap().add(12.0, "bolts/000012.vtu").unwrap();
    ground().write(&folder.fields().join("000012.vtu")).unwrap();
    Pvd::create(&folder.pvd()).unwrap().add(12.0, "fields/000012.vtu").unwrap();
    let columns = ["A.force", "A.state"].map(|name| Column::new(name, "N"));
    let columns = [vec![Column::new("time", "s")], columns.to_vec()].concat();
    let mut table = TableWriter::create(&folder.monitors(), &columns).unwrap();
    (0..100).for_each(|k| table.write(&[0.12 * f64::from(k), 1e5 + 1e3 * f64::from(k), 0.0]).unwrap());
    folder
}

fn page(folder: &ResultFolder) -> String {
    fs::read_to_string(write(folder.root()).unwrap()).unwrap()
}

/// A figure, which is well-formed.
fn figure(folder: &ResultFolder, name: &str) -> String {
    let text = fs::read_to_string(folder.figures().join(name)).unwrap();
    roxmltree::Document::parse(&text).unwrap_or_else(|e| panic!("{name}: {e}"));
    assert!(!text.contains("NaN") && !text.contains("inf"), "{name}");
    text
}

#[test]
fn the_table_has_every_group_with_what_became_of_it() {
    let temp = tempfile::tempdir().unwrap();
    let page = page(&results(temp.path()));
    for text in [
        "<h2>Bolts</h2>",
        "<td>bench 1</td>",
        "(10,\u{a0}18.8,\u{a0}−9.8), at\u{a0}5.25\u{a0}s",
        "196\u{a0}kN",
        "by up to 3.10\u{a0}mm",
        "no bond",
        "1 wholly",
        "Force of the bolt nearest to yield",
        "Force over yield, stage by stage",
        "earthquake, largest of its rows",
        "bolts.csv",
        "bolts.pvd",
    ] {
        assert!(page.contains(text), "{text}");
    }
    assert!(!page.split_once("</main>").unwrap().0.contains("NaN"));
}

#[test]
fn a_group_that_is_not_placed_yet_has_no_forces() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let mut facts = summary(&bolts());
    for group in facts.parts.bolts.values_mut() {
        *group = BoltSummary {
            there: false,
            bolts: 4,
            given: 4,
            placed: EARTHQUAKE.into(),
            ..BoltSummary::default()
        };
    }
    facts.write(&folder.summary()).unwrap();
    let page = page(&folder);
    assert!(page.contains("not placed yet") && page.contains("the earthquake</td>"));
    assert!(!page.contains("Largest force of a bolt"));
}

#[test]
fn the_map_draws_what_is_left_over_the_section_and_names_the_worst() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let page = page(&folder);
    let svg = figure(&folder, "bolts-map.svg");
    for text in ["largest force over yield", ">ground<", ">0.5<", ">1.0<"] {
        assert!(svg.contains(text), "{text}");
    }
    for text in [
        "Largest: 1.0 of yield in walls, bolt",
        "Not drawn: 12 segments that excavations took.",
        "at 12.00\u{a0}s",
    ] {
        assert!(page.contains(text), "{text}");
    }
    let force = figure(&folder, "bolts-force.svg");
    assert!(force.contains("force, tension positive (kN)") && force.contains("walls, bolt"));
    assert!(!force.contains("toe, bolt"), "it carries nothing");
    assert!(page.contains("Yield: crown at 196\u{a0}kN; walls at 196\u{a0}kN."));
}

#[test]
fn bolts_that_never_yield_are_drawn_by_their_force() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let mut grid = grid(&bolts());
    for array in grid.cell_data.iter_mut().filter(|array| array.name.starts_with("force_over")) {
        array.values = Values::Float32(vec![0.0; array.values.len()]);
    }
    grid.write(&folder.bolt_fields().join("000012.vtu")).unwrap();
    let page = page(&folder);
    assert!(figure(&folder, "bolts-map.svg").contains("largest force (kN)"));
    assert!(page.contains("no bolt of these yields"));
}

#[test]
fn what_is_missing_is_said_and_what_is_cut_off_is_not_drawn() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let mut grid = grid(&bolts());
    for array in grid.cell_data.iter_mut().filter(|array| array.name == "state") {
        array.values = Values::UInt8(vec![4; array.values.len()]);
    }
    grid.write(&folder.bolt_fields().join("000012.vtu")).unwrap();
    assert!(!page(&folder).contains("Where bolts carry most"), "all were cut off");
    fs::write(folder.bolt_fields().join("000012.vtu"), "no file").unwrap();
    assert!(page(&folder).contains("000012.vtu: "), "with the reason");
    fs::write(folder.bolts(), "bolt,name\n1,crown\n").unwrap();
    assert!(page(&folder).contains("is missing"));
    fs::remove_file(folder.bolts()).unwrap();
    fs::remove_file(folder.bolts_pvd()).unwrap();
    let with_table = page(&folder);
    assert!(with_table.contains("There is no bolts.csv") && with_table.contains("There is no bolts.pvd"));
    fs::remove_file(folder.summary()).unwrap();
    assert!(!page(&folder).contains("<h2>Bolts</h2>"), "nothing tells of bolts");
}

#[test]
fn lines_of_bolts_in_the_energy_balance_have_words_and_axes_of_their_own_in_the_one_unit() {
    let temp = tempfile::tempdir().unwrap();
    let folder = results(temp.path());
    let lines = ["kinetic", "strain", "bolts", "bolt_friction", "bolt_plastic", "error"];
    let columns = lines.map(|name| Column::new(name, "J"));
    let columns = [vec![Column::new("time", "s")], columns.to_vec()].concat();
    let mut table = TableWriter::create(&folder.energy(), &columns).unwrap();
    (0..100)
        .map(f64::from)
        .for_each(|k| table.write(&[0.12 * k, 1e6, 1e6 * k, 20.0 * k, 5.0 * k, 0.0, 1.0]).unwrap());
    let page = page(&folder);
    let svg = figure(&folder, "energy.svg");
    for text in
        ["energy (MJ)", "energy of bolts (MJ)", "held by bolts and their bonds", "bonds of bolts that slide"]
    {
        assert!(svg.contains(text), "{text}");
    }
    assert!(page.contains(
        "At the end bolts hold 0.00198\u{a0}MJ; their bonds have taken 495\u{a0}J, their yield 0\u{a0}MJ."
    ));
    assert!(page.contains("Zero throughout: bolts that yield and break."));
}
