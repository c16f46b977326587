//! What came before the earthquake is on the page: stages, convergence, plastic zones, section forces.

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::fs;
use std::path::Path;

use tremolite_mesh::vtu::{Array, Grid, Values};
use tremolite_mesh::{Element, Mesh, Shape};
use tremolite_report::write;
use tremolite_results::{
    Column, Computed, Conclusion, Pvd, ResultFolder, SectionRow, Soundness, StageSummary, Status, Summary,
    TableWriter, TrustLine, said, write_sections, write_stages,
};

/// Radius of the excavation and thickness of the lining (m).
const RADIUS: f64 = 5.0;
const LINING: f64 = 0.4;
const AROUND: usize = 48;
const NAMES: [&str; 6] = ["", "top heading", "top heading, rest", "bench", "lining", "bench, rest"];

/// A circular tunnel under 5.4 MPa, K0 = 0.7, let go in steps, as far as files tell of it; numbers are made up after
/// Kirsch's solution.
fn stages() -> Vec<StageSummary> {
    let radial = [0.0, 4.1, 7.9, 11.2, 11.2, 12.6];
    let release = [f64::NAN, 0.5, 1.0, 0.7, 0.0, 1.0];
    let stage = |k: usize| {
        let u = 1e-3 * radial[k];
        let walls = [
            ("tunnel.crown", [2e-5, 0.0, -u]),
            ("tunnel.floor", [1e-5, 0.0, 0.8 * u]),
            ("tunnel.wall.left", [0.55 * u, 0.0, -0.2 * u]),
            ("tunnel.wall.right", [-0.6 * u, 0.0, -0.2 * u]),
            ("hall.crown", [0.0, 0.0, -0.3 * u]),
            ("hall.wall.left", [0.4 * u, 0.0, 0.0]),
            ("hall.wall.right", [0.1 * u, 0.0, 0.0]),
        ];
        let groups = |of: &[&str]| of.iter().map(|&name| name.to_owned()).collect();
        let monitors = [
            ("ux", Some(1e-5)),
            ("uz", (k > 0).then_some(-u)),
            ("s1", (k < 4).then_some(-1e5 * k as f64)),
            ("s3", Some(-9.3e6)),
        ];
        let monitors = monitors.map(|(name, value)| (name.to_owned(), value));
        StageSummary {
            name: NAMES[k].into(),
            excavated: groups(match k {
                1 => &["tunnel.bench1"],
                3 => &["tunnel.bench2", "tunnel.bench3"],
                _ => &[],
            }),
            installed: groups(if k == 4 { &["tunnel.lining"] } else { &[] }),
            changed: if k == 5 { vec!["tunnel.lining becomes hardened concrete".into()] } else { Vec::new() },
            changed_message: Vec::new(),
            seepage: None,
            release: release[k],
            tolerance: 1e-5,
            cycles: 260 + 90 * k as u64,
            ratio: 8.7e-6,
            motion_left: if k == 0 { 0.0 } else { 1.3e-6 },
            largest_motion: if k == 0 { 7.2e-6 } else { 1.2e-3 * (radial[k] - radial[k - 1]).max(0.001) },
            plastic_volume: 0.021 * k as f64,
            held: [0.0, 3e-2, 0.0, 1e-2, 1e-2, 0.0][k],
            monitors: [("A".to_owned(), monitors.into())].into(),
            moved: Default::default(),
            walls: if k == 0 {
                Default::default()
            } else {
                walls.map(|(name, u)| (name.to_owned(), u)).into()
            },
        }
    };
    (0..NAMES.len()).map(stage).collect()
}

fn relaxation(folder: &ResultFolder, stages: &[StageSummary]) {
    let columns = [("stage", ""), ("cycle", ""), ("ratio", ""), ("motion_left", "m"), ("motion", "m")]
        .map(|(n, u)| Column::new(n, u));
    let mut table = TableWriter::create(&folder.relaxation(), &columns).unwrap();
    for (k, stage) in stages.iter().enumerate() {
        let last = stage.cycles as f64;
        for cycle in (10..=stage.cycles).step_by(10) {
            let s = cycle as f64 / last;
            let ratio = 3e-2 * (stage.ratio / 3e-2).powf(s) * (1.0 + 0.4 * (1.0 - s) * (40.0 * s).sin());
            let motion = stage.largest_motion * (1.0 - (-4.0 * s).exp());
            table
                .write(&[
                    k as f64,
                    cycle as f64,
                    ratio,
                    0.5 * stage.largest_motion * (-6.0 * s).exp(),
                    motion,
                ])
                .unwrap();
        }
    }
}

/// A ring of rock between the tunnel and a square, with the lining in it.
fn section_mesh() -> (Mesh, Vec<(f64, f64, bool)>) {
    let rings: Vec<f64> =
        std::iter::once(RADIUS - LINING).chain((0..=16).map(|i| RADIUS * 1.12_f64.powi(i))).collect();
    let mut mesh = Mesh::default();
    for y in [-1.0, 1.0] {
        for (i, r) in rings.iter().enumerate() {
            for j in 0..AROUND {
                let angle = TAU * j as f64 / AROUND as f64;
                let (c, s) = (angle.cos(), angle.sin());
                // From the circle to the square.
                let share = ((i as f64 - 1.0) / (rings.len() - 2) as f64).max(0.0);
                let stretch = 1.0 + share * (1.0 / c.abs().max(s.abs()) - 1.0);
                mesh.nodes.push([r * stretch * c, y, r * stretch * s - 200.0]);
            }
        }
    }
    let layer = (rings.len() * AROUND) as u32;
    let mut polar = Vec::new();
    for i in 0..rings.len() - 1 {
        for j in 0..AROUND {
            let node = |i: usize, j: usize| (i * AROUND + j % AROUND) as u32;
            let (a, b, c, d) = (node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1));
            let nodes = [a, b, b + layer, a + layer, d, c, c + layer, d + layer];
            mesh.elements.push(Element::new(Shape::Hex8, &nodes));
            polar.push((0.5 * (rings[i] + rings[i + 1]), TAU * (j as f64 + 0.5) / AROUND as f64, i == 0));
        }
    }
    (mesh, polar)
}

/// The last stage's file, with principal stresses after Kirsch.
fn fields(folder: &ResultFolder) {
    let (mesh, polar) = section_mesh();
    let (mut grid, _) = Grid::from_mesh(&mesh, None);
    let (vertical, lateral) = (-5.4e6, -3.8e6);
    let stress = |&(r, angle, lining): &(f64, f64, bool)| {
        if lining {
            return (-0.1e6, -3.2e6);
        }
        let (q, twice) = ((RADIUS / r).powi(2), (2.0 * angle).cos());
        let (mean, half) = (0.5 * (vertical + lateral), 0.5 * (lateral - vertical));
        let radial = mean * (1.0 - q) + half * (1.0 - 4.0 * q + 3.0 * q * q) * twice;
        let hoop = mean * (1.0 + q) - half * (1.0 + 3.0 * q * q) * twice;
        let shear = -half * (1.0 + 2.0 * q - 3.0 * q * q) * (2.0 * angle).sin();
        let (middle, radius) = (0.5 * (radial + hoop), (0.5 * (radial - hoop)).hypot(shear));
        (middle + radius, middle - radius)
    };
    let strain = |&(r, angle, lining): &(f64, f64, bool)| {
        let reach = 5.6 + 1.6 * angle.cos().powi(2);
        if lining || r > reach { 0.0 } else { 2.4e-3 * (reach - r) }
    };
    let state = |cell: &(f64, f64, bool)| match strain(cell) {
        0.0 => 0,
        _ if cell.1.sin().abs() > 0.9 => 4 | 8,
        _ if cell.1.cos().abs() > 0.97 => 1 | 4,
        _ => 4,
    };
    let mut put =
        |name: &str, unit: &str, values: Values| grid.cell_data.push(Array::new(name, unit, 1, values));
    put("body", "", Values::Int32(polar.iter().map(|cell| i32::from(cell.2)).collect()));
    put("plastic_state", "", Values::Int32(polar.iter().map(state).collect()));
    put("plastic_shear_strain", "", Values::Float64(polar.iter().map(strain).collect()));
    put("s1", "Pa", Values::Float64(polar.iter().map(|cell| stress(cell).0).collect()));
    put("s3", "Pa", Values::Float64(polar.iter().map(|cell| stress(cell).1).collect()));
    let mut pvd = Pvd::create(&folder.stages_pvd()).unwrap();
    fs::create_dir_all(folder.stage_fields()).unwrap();
    grid.write(&folder.stage_fields().join("005.vtu")).unwrap();
    pvd.add(5.0, "stages/005.vtu").unwrap();
}

/// A lining without invert between y = −3 and 3 m.
fn sections(folder: &ResultFolder, shaken: bool) {
    let mut rows = Vec::new();
    let mut station = 0;
    for y in [-3.0, 0.0, 3.0] {
        for k in 0..40 {
            let angle = -0.25 * PI + 1.5 * PI * f64::from(k) / 39.0;
            let r = RADIUS - 0.5 * LINING;
            let place = [r * angle.cos(), y, r * angle.sin() - 200.0];
            let twice = (2.0 * (angle - FRAC_PI_2)).cos();
            let forces = [-1.35e6 + 0.3e6 * twice, 4.2e4 * twice, 6e4 * (2.0 * angle).sin()];
            let row = SectionRow {
                lining: "tunnel.lining".into(),
                station,
                place,
                when: "lining".into(),
                time: [f64::NAN; 3],
                forces,
                thrust_at_moment: forces[0],
                moment_at_thrust: forces[1],
                thickness: LINING,
            };
            rows.push(SectionRow { forces: forces.map(|f| 0.05 * f), ..row.clone() });
            rows.push(SectionRow { when: "bench, rest".into(), ..row.clone() });
            if shaken {
                let swing = [0.45e6, 6.5e4, 5e4].map(|f| f * (0.6 + 0.4 * (2.0 * angle).sin().powi(2)));
                for (when, sign) in [("min", -1.0), ("max", 1.0)] {
                    let forces = [0, 1, 2].map(|i| forces[i] + sign * swing[i]);
                    rows.push(SectionRow { when: when.into(), time: [6.2, 7.4, 7.9], forces, ..row.clone() });
                }
            }
            station += 1;
        }
    }
    hall(&mut rows, station, shaken);
    write_sections(&folder.sections(), &rows).unwrap();
}

/// A hall's lining, whose corners have no stations: half the floor, a wall, the crown, the other wall, the rest of the floor.
fn hall(rows: &mut Vec<SectionRow>, first: u32, shaken: bool) {
    let steps = |from: [f64; 2], to: [f64; 2], n: u32| {
        (0..n).map(move |k| [0, 1].map(|i| from[i] + (to[i] - from[i]) * (f64::from(k) + 0.5) / f64::from(n)))
    };
    let crown = (0..16)
        .map(|k| (PI * (f64::from(k) + 0.5) / 16.0).sin_cos())
        .map(|(s, c)| [45.0 + 8.5 * c, 24.0 + 4.0 * s]);
    let outline: Vec<[f64; 2]> = steps([45.0, -5.0], [52.5, -5.0], 8)
        .chain(steps([53.5, -4.0], [53.5, 23.0], 24))
        .chain(crown)
        .chain(steps([36.5, 23.0], [36.5, -4.0], 24))
        .chain(steps([37.5, -5.0], [45.0, -5.0], 8))
        .collect();
    for (k, [x, z]) in outline.into_iter().enumerate() {
        let wall = (2.0 * PI * (z + 4.0) / 27.0).sin();
        let forces = [-0.9e6 - 2e4 * (24.0 - z), 1.1e5 * wall, 7e4 * wall.abs() - 3e4];
        let (station, place) = (first + k as u32, [x, 0.0, z - 200.0]);
        let row = |when: &str, time: f64, share: f64| SectionRow {
            lining: "hall.lining".into(),
            station,
            place,
            when: when.into(),
            time: [time; 3],
            forces: [forces[0] + share * 4e5, forces[1] + share * 9e4, forces[2] + share * 4e4],
            thrust_at_moment: forces[0] + share * 2e5,
            moment_at_thrust: forces[1] + share * 3e4,
            thickness: 1.0,
        };
        rows.push(row("bench, rest", f64::NAN, 0.0));
        if shaken {
            rows.extend([row("min", 5.1, -1.0), row("max", 5.8, 1.4)]);
        }
    }
}

/// All that a run of stages alone writes.
pub fn example(root: &Path, shaken: bool) -> ResultFolder {
    let folder = ResultFolder::create(Some(root), "case", false).unwrap();
    let stages = stages();
    write_stages(&folder.stages(), &[Column::new("A.uz", "m")], &stages).unwrap();
    relaxation(&folder, &stages);
    fields(&folder);
    sections(&folder, shaken);
    let mut summary = Summary {
        title: "A tunnel in stages".into(),
        conclusion: Conclusion {
            status: Status::Done,
            outcome: "The run reached its end: every stage came to rest.".into(),
            ..Conclusion::default()
        },
        computed: Computed { stages, ..Computed::default() },
        soundness: Soundness {
            checks: vec![
                TrustLine::at_most(
                    "at_rest",
                    said!("out of balance at the end of stages, the worst"),
                    8.7e-6,
                    1e-5,
                    "",
                ),
                TrustLine::at_most(
                    "unreleased_force",
                    said!("forces still held after the last stage"),
                    0.0,
                    1e-9,
                    "",
                ),
            ],
            ..Soundness::default()
        },
        ..Summary::default()
    };
    summary.monitors.monitor_positions.insert("A".into(), [0.0, 0.0, -195.0]);
    summary.computed.model.elements = 816;
    summary.computed.model.nodes = 1728;
    if shaken {
        summary.computed.motion.kind = "outcrop".into();
        summary.computed.model.duration = 20.0;
        let columns = [Column::new("time", "s"), Column::new("A.ux", "m")];
        let mut table = TableWriter::create(&folder.monitors(), &columns).unwrap();
        (0..200).for_each(|k| table.write(&[0.1 * f64::from(k), 0.01 * (0.3 * f64::from(k)).sin()]).unwrap());
    }
    summary.write(&folder.summary()).unwrap();
    folder
}

fn page(folder: &ResultFolder) -> String {
    fs::read_to_string(write(folder.root()).unwrap()).unwrap()
}

/// Every drawing is well-formed XML and of numbers; returns their names.
fn drawings(folder: &ResultFolder) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for entry in fs::read_dir(folder.figures()).unwrap() {
        let path = entry.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        roxmltree::Document::parse(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        assert!(!text.contains("NaN") && !text.contains("inf"), "{}", path.display());
        names.push(path.file_name().unwrap().to_str().unwrap().into());
    }
    names.sort();
    names
}

const FIGURES: [&str; 16] = [
    "convergence-2.svg",
    "convergence.svg",
    "lining-forces-2.svg",
    "lining-forces.svg",
    "lining-shape-2.svg",
    "lining-shape.svg",
    "reaction-2.svg",
    "reaction.svg",
    "relaxation.svg",
    "section-mesh.svg",
    "stage-plastic-strain.svg",
    "stage-plastic.svg",
    "stage-s1.svg",
    "stage-s3.svg",
    "thrust-moment-2.svg",
    "thrust-moment.svg",
];

#[test]
fn a_static_study_has_a_whole_page_that_misses_nothing() {
    let temp = tempfile::tempdir().unwrap();
    let folder = example(temp.path(), false);
    let page = page(&folder);
    assert_eq!(drawings(&folder), FIGURES);
    for text in [
        "<h2>Stages</h2>",
        "This is a static study",
        "Is the lining whole when the stages are done?",
        "excavated tunnel.<wbr>bench2, tunnel.<wbr>bench3",
        "installed tunnel.<wbr>lining",
        "initial equilibrium",
        ">50\u{a0}%<",
        ">0.00130\u{a0}mm<",
        "tolerance 1\u{202f}×\u{202f}10⁻⁵",
        "Largest motion of a wall in the stages",
        "stages.csv",
        "Run: all 2 checks pass",
    ] {
        assert!(page.contains(text), "{text}");
    }
    for text in [
        "There is no",
        "monitors.csv<",
        "energy.csv",
        "Left out",
        "id=\"peaks\"",
        "No structure is judged",
        "shakes",
    ] {
        assert!(!page.contains(text), "{text}");
    }
}

#[test]
fn with_an_earthquake_what_it_did_comes_first_and_envelopes_have_their_times() {
    let temp = tempfile::tempdir().unwrap();
    let folder = example(temp.path(), true);
    let page = page(&folder);
    let at = |text: &str| page.find(text).unwrap_or_else(|| panic!("{text}"));
    assert!(at("<h2>Displacement</h2>") < at("<h2>Section forces of the linings</h2>"));
    assert!(at("<h2>Section forces of the linings</h2>") < at("<h2>Before the earthquake</h2>"));
    // The largest and smallest of all stations, each at its own time. N swings by 450 kN/m · 0.6 about −1350 + 300 at the
    // crown, and by 450 about −1350 half-way to the walls; stations are 3.5° apart.
    for text in
        ["while the ground shakes", "6.20\u{a0}s, (", "7.40\u{a0}s, (", "7.90\u{a0}s, (", "id=\"peaks\""]
    {
        assert!(page.contains(text), "{text}");
    }
    assert!(!page.contains("static study"));
}

#[test]
fn motions_towards_the_opening_are_positive_and_both_components_are_tabled() {
    let temp = tempfile::tempdir().unwrap();
    let folder = example(temp.path(), false);
    let page = page(&folder);
    // After the last stage the crown came down by 12.6 mm, the walls by 0.55 and 0.6 of that.
    assert!(page.contains("crown, 12.6\u{a0}mm towards the opening"));
    for number in [">−12.6<", ">10.1<", ">6.9<", ">−7.6<", ">14.5<"] {
        assert!(page.contains(number), "{number}");
    }
}

#[test]
fn what_the_files_do_not_hold_is_left_out_with_a_sentence() {
    let temp = tempfile::tempdir().unwrap();
    let folder = example(temp.path(), false);
    let mut summary = Summary::read(&folder.summary()).unwrap();
    for stage in &mut summary.computed.stages {
        stage.walls.clear();
        stage.monitors.clear();
    }
    summary.soundness.checks.clear();
    summary.write(&folder.summary()).unwrap();
    fs::write(folder.sections(), "lining,station\n").unwrap();
    fs::remove_file(folder.stages_pvd()).unwrap();
    fs::write(folder.relaxation(), "stage,cycle,ratio,motion_left [m],motion [m]\n0,1,0,0,0\n").unwrap();
    for name in drawings(&folder) {
        fs::remove_file(folder.figures().join(name)).unwrap();
    }
    let page = page(&folder);
    for text in [
        "names no points of walls",
        "sections.csv has no rows yet",
        "wrote no fields of the stages",
        "holds no ratio that is not zero",
    ] {
        assert!(page.contains(text), "{text}");
    }
    assert!(drawings(&folder).is_empty());
    fs::remove_file(folder.summary()).unwrap();
    assert!(self::page(&folder).contains("has not come to the earthquake"));
}

#[test]
fn nothing_yielded_is_a_sentence_and_no_figure() {
    let temp = tempfile::tempdir().unwrap();
    let folder = example(temp.path(), false);
    let path = folder.stage_fields().join("005.vtu");
    let mut grid = Grid::read(&path).unwrap();
    for array in &mut grid.cell_data {
        if array.name.starts_with("plastic") {
            array.values = Values::Float64(vec![0.0; grid.types.len()]);
        }
    }
    grid.write(&path).unwrap();
    assert!(page(&folder).contains("nothing has yielded after stage 5, bench, rest"));
    assert!(!drawings(&folder).iter().any(|name| name.starts_with("stage-plastic")));
}

#[test]
fn values_that_are_no_numbers_are_dashes_and_break_lines() {
    let temp = tempfile::tempdir().unwrap();
    let folder = example(temp.path(), true);
    let mut summary = Summary::read(&folder.summary()).unwrap();
    for stage in &mut summary.computed.stages {
        (stage.ratio, stage.motion_left, stage.held) = (f64::NAN, f64::NAN, f64::NAN);
        (stage.largest_motion, stage.plastic_volume) = (f64::NAN, f64::NAN);
    }
    summary.computed.stages[2].walls.shift_remove("tunnel.crown");
    summary.computed.stages[3].name = "<b>&".into();
    summary.write(&folder.summary()).unwrap();
    let mut rows = tremolite_results::read_sections(&folder.sections()).unwrap();
    rows.iter_mut().step_by(7).for_each(|row| row.forces = [f64::NAN, f64::INFINITY, f64::NAN]);
    write_sections(&folder.sections(), &rows).unwrap();
    let page = page(&folder);
    assert!(page.contains("<td class=\"n\">–</td>") && !page.contains("<b>"));
    assert_eq!(
        drawings(&folder).iter().filter(|name| FIGURES.contains(&name.as_str())).count(),
        FIGURES.len()
    );
}
