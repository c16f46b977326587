//! Interfaces of a case: what is said of them, and the checks of a run that can fail, each with the model that fails it.

use std::path::Path;
use std::process::{Command, Output};
use tremolite_mesh::boxes::BoxSpec;
use tremolite_results::{Summary, Table, TrustLine};

fn tremolite(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tremolite")).current_dir(folder).args(args).output().unwrap()
}

fn errors(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Rock of 8 × 8 × 20 m with a slab of 4 m on top, the joint between them by these keys, under a wave of 4 Hz and this peak
/// acceleration \[m/s²\] along x and z.
fn slab(folder: &Path, joint: &str, dynamic: &str, peaks: [f64; 2]) {
    model(folder, [8.0, 8.0, 24.0], |x| x[2] > 20.0, joint, dynamic, peaks);
}

/// A block of 8 m inside a rock of 12 m, which can only rattle there.
fn rattle(folder: &Path, joint: &str, dynamic: &str, peaks: [f64; 2]) {
    model(folder, [12.0; 3], |x| x.iter().all(|x| (x - 6.0).abs() < 4.0), joint, dynamic, peaks);
}

/// A box of cubes of 2 m, with those of the slab apart.
fn model(
    folder: &Path,
    size: [f64; 3],
    inside: impl Fn([f64; 3]) -> bool,
    joint: &str,
    dynamic: &str,
    [x, z]: [f64; 2],
) {
    let mut mesh = BoxSpec::uniform([0.0; 3], size, size.map(|l| (l / 2.0) as u32)).mesh().unwrap();
    let centre = |e: u32| {
        let nodes = mesh.elements[e as usize].nodes();
        [0, 1, 2].map(|i| nodes.iter().map(|&n| mesh.nodes[n as usize][i]).sum::<f64>() / nodes.len() as f64)
    };
    let (slab, rock): (Vec<u32>, Vec<u32>) =
        (0..mesh.elements.len() as u32).partition(|&e| inside(centre(e)));
    mesh.groups = [("rock".to_owned(), rock), ("slab".to_owned(), slab)].into();
    tremolite_mesh::write(folder.join("slab.msh"), &mesh).unwrap();
    for (axis, peak) in [("x", x), ("z", z)] {
        let pulse: String = (0..100)
            .map(|k| {
                let t = (std::f64::consts::PI * 4.0 * (0.01 * f64::from(k) - 0.4)).powi(2);
                format!("{:.6}\n", peak * (1.0 - 2.0 * t) * (-t).exp())
            })
            .collect();
        std::fs::write(folder.join(format!("{axis}.txt")), pulse).unwrap();
    }
    let case = format!(
        r#"title = "slab"
[mesh.file]
path = "slab.msh"
[material.rock]
law = "elastic"
young = "2 GPa"
poisson = 0.25
density = "2500 kg/m3"
[[region]]
groups = ["rock", "slab"]
material = "rock"
element = "reduced-integration"
[[interface]]
name = "joint"
between = ["rock", "slab"]
{joint}
[motion]
kind = "incident"
east = {{ file = "x.txt", units = "m/s2", dt = "0.01 s" }}
up = {{ file = "z.txt", units = "m/s2", dt = "0.01 s" }}
processing = ["baseline"]
[dynamic]
sides = "periodic"
{dynamic}
[[monitor]]
name = "pair"
at = ["4 m", "4 m", "20 m"]
interface = "joint"
[[monitor]]
name = "low"
at = ["4 m", "4 m", "2 m"]
[[monitor]]
name = "high"
at = ["4 m", "4 m", "11 m"]
[[monitor_pair]]
between = ["low", "high"]
[output]
histories = "0.01 s"
snapshots = "0.5 s"
"#
    );
    std::fs::write(folder.join("case.toml"), case).unwrap();
}

fn summary_of(folder: &Path) -> Summary {
    let run = tremolite(folder, &["run", "case.toml", "--out", "results", "--overwrite"]);
    assert!(run.status.success(), "{}", errors(&run));
    Summary::read(&folder.join("results/summary.json")).unwrap()
}

fn line<'s>(summary: &'s Summary, id: &str) -> &'s TrustLine {
    summary
        .soundness
        .checks
        .iter()
        .find(|line| line.id == id)
        .unwrap_or_else(|| panic!("{id}: {:?}", summary.soundness.checks))
}

const GOOD: &str = "law = \"bandis\"\nnormal_stiffness = \"20 GPa/m\"\nmax_closure = \"2 mm\"\ncohesion = \"10 kPa\"\nfriction_coefficient = 0.6\n";

const LINES: [&str; 8] = [
    "interface_gap_joint",
    "energy_created_by_interfaces",
    "interface_closure_joint",
    "interface_slip_joint",
    "contact_above_pressure_limit_joint",
    "contact_energy_error_joint",
    "contact_frequency_step_joint",
    "contact_penalty_compliance_joint",
];

#[test]
fn each_check_of_an_interface_has_a_model_that_fails_it() {
    let folder = tempfile::tempdir().unwrap();
    slab(folder.path(), GOOD, "", [2.0, 2.0]);
    let good = summary_of(folder.path());
    for id in LINES {
        assert!(line(&good, id).pass, "{:?}", line(&good, id));
    }
    let bad = [
        (
            "interface_closure_joint",
            GOOD.replace("\"2 mm\"", "\"0.001 mm\"\nclosure_floor = 0.05"),
            "",
            [2.0, 2.0],
        ),
        ("interface_slip_joint", GOOD.replace("0.6", "0").replace("\"10 kPa\"", "\"0 Pa\""), "", [40.0, 0.0]),
        (
            "contact_above_pressure_limit_joint",
            format!("{GOOD}pressure_for_step = \"1 kPa\""),
            "",
            [2.0, 2.0],
        ),
        (
            "contact_energy_error_joint",
            GOOD.replace("20 GPa/m", "400 GPa/m").replace("10 kPa", "0 Pa") + "contact_damping = 0.0",
            "time_step = \"0.1 ms\"",
            [2.0, 20.0],
        ),
        ("interface_gap_joint", GOOD.replace("\"10 kPa\"", "\"0 Pa\""), "", [0.0, 40.0]),
        (
            "energy_created_by_interfaces",
            GOOD.replace("0.6", "0.1").replace("2 mm", "0.02 mm"),
            "",
            [2.0, 2.0],
        ),
        ("interface_without_initial_stress", GOOD.to_owned(), "", [2.0, 2.0]),
        (
            "contact_frequency_step_joint",
            format!("{GOOD}contact_limit = 0.05"),
            "time_step = \"0.1 ms\"",
            [2.0, 2.0],
        ),
        // Where the step is given the choice keeps to it, however soft that makes the joint.
        (
            "contact_penalty_compliance_joint",
            GOOD.replace("normal_stiffness = \"20 GPa/m\"\n", ""),
            "time_step = \"0.5 ms\"",
            [2.0, 2.0],
        ),
    ];
    for (id, joint, dynamic, peaks) in bad {
        let model = if id == "contact_energy_error_joint" { rattle } else { slab };
        model(folder.path(), &joint, dynamic, peaks);
        // What impacts give out may stop the run.
        let _ = tremolite(folder.path(), &["run", "case.toml", "--out", "results", "--overwrite"]);
        let summary = Summary::read(&folder.path().join("results/summary.json")).unwrap();
        let found = line(&summary, id);
        assert!(!found.pass && !found.not_applicable, "{found:?}");
    }
}

#[test]
fn results_of_an_interface_are_where_scripts_expect_them() {
    let folder = tempfile::tempdir().unwrap();
    slab(folder.path(), GOOD, "", [2.0, 2.0]);
    let summary = summary_of(folder.path());
    let results = folder.path().join("results");
    let header = std::fs::read_to_string(results.join("interfaces.csv")).unwrap();
    assert_eq!(
        header.lines().next().unwrap(),
        "time [s],joint.sliding [m2],joint.open [m2],joint.ever_slid [m2],joint.ever_opened [m2],joint.max_gap [m],\
         joint.max_slip [m],joint.impact_gain [J]"
    );
    let monitors = Table::read(&results.join("monitors.csv")).unwrap();
    for name in ["gap", "slip1", "slip2", "pressure", "shear1", "shear2", "state"] {
        assert!(monitors.column(&format!("pair.{name}")).is_some(), "{name}");
    }
    let energy = Table::read(&results.join("energy.csv")).unwrap();
    for name in ["interface", "friction", "created_by_interface", "contact_damping"] {
        assert!(energy.column(name).is_some() && summary.soundness.energy.contains_key(name), "{name}");
    }
    assert!(results.join("interfaces.pvd").is_file() && results.join("interfaces/000002.vtu").is_file());
    let joint = &summary.parts.interfaces["joint"];
    assert!((joint.area - 64.0).abs() < 1e-9 && joint.pairs == 25 && joint.ends == 0, "{joint:?}");
    assert!(joint.ever_slid > 0.0 && joint.max_slip.value > 0.0, "{joint:?}");
    assert!(summary.conclusion.findings.iter().any(|finding| finding.id == "interface_joint"));
    // The monitor on the interface stands before those that the difference is of.
    let difference = monitors.column("low-high.ux").unwrap();
    let [low, high] = ["low.ux", "high.ux"].map(|name| monitors.column(name).unwrap());
    assert!(difference.iter().zip(low.iter().zip(high)).all(|(d, (a, b))| *d == a - b));
    assert!(
        summary.monitors.relative.contains_key("low-high")
            && summary.parts.pairs["pair"].at == [4.0, 4.0, 20.0]
    );
    let last = Table::read(&results.join("interfaces.csv")).unwrap();
    assert_eq!(*last.column("joint.ever_slid").unwrap().last().unwrap(), joint.ever_slid);
}

#[test]
fn what_is_wrong_with_an_interface_is_said_at_its_place_before_any_computing() {
    let folder = tempfile::tempdir().unwrap();
    slab(folder.path(), &GOOD.replace("normal_stiffness = \"20 GPa/m\"\n", ""), "", [2.0, 2.0]);
    let check = tremolite(folder.path(), &["check", "--verbose", "case.toml"]);
    let said = String::from_utf8_lossy(&check.stdout).into_owned();
    assert!(check.status.success(), "{}", errors(&check));
    for words in [
        "joint: bandis, 25 pairs over 64.0 m2, no ends inside the model",
        "chosen by the mesh and the step; closes by",
        "impacts allow",
        "interface[joint].normal_stiffness = ",
        "interface[joint].pressure_for_step = ",
    ] {
        assert!(said.contains(words), "{words}: {said}");
    }
    for (joint, dynamic, words) in [
        (GOOD.replace("10 kPa", "50 MPa"), "", &["case.toml:19", "cohesion", "larger"][..]),
        (GOOD.to_owned(), "base = \"viscous-spring\"", &["crosses the vertical edge", "viscous"]),
        (GOOD.to_owned(), "time_step = \"0.5 s\"", &["above the stable step"]),
    ] {
        slab(folder.path(), &joint, dynamic, [2.0, 2.0]);
        let check = tremolite(folder.path(), &["check", "case.toml"]);
        for word in words {
            assert!(errors(&check).contains(word), "{word}: {}", errors(&check));
        }
    }
    slab(folder.path(), GOOD, "", [2.0, 2.0]);
    let case = std::fs::read_to_string(folder.path().join("case.toml")).unwrap();
    let apart = case.replace("between = [\"rock\", \"slab\"]", "between = [\"rock\", \"sla\"]");
    std::fs::write(folder.path().join("case.toml"), apart).unwrap();
    let refused = tremolite(folder.path(), &["run", "case.toml", "--out", "none"]);
    assert_eq!(refused.status.code(), Some(2), "{}", errors(&refused));
    assert!(
        errors(&refused).contains("no group of the mesh fits 'sla'") && !folder.path().join("none").exists()
    );
}

/// Takes the slab's nodes on the joint apart, as meshes of other programs have them.
fn part(folder: &Path) {
    let path = folder.join("slab.msh");
    let mut mesh = tremolite_mesh::read(&path).unwrap();
    let mut copies = std::collections::BTreeMap::new();
    for e in mesh.groups["slab"].clone() {
        for k in 0..8 {
            let node = mesh.elements[e as usize].nodes[k];
            if mesh.nodes[node as usize][2] == 20.0 {
                let copy = *copies.entry(node).or_insert_with(|| {
                    mesh.nodes.push(mesh.nodes[node as usize]);
                    mesh.nodes.len() as u32 - 1
                });
                mesh.elements[e as usize].nodes[k] = copy;
            }
        }
    }
    (mesh.node_ids, mesh.element_ids) = (Vec::new(), Vec::new());
    assert_eq!(copies.len(), 25);
    tremolite_mesh::write(&path, &mesh).unwrap();
}

/// The largest difference of two runs in a column, over its largest size.
fn difference(folder: &Path, column: &str) -> f64 {
    let [a, b] = ["a", "b"].map(|name| Table::read(&folder.join(name).join("monitors.csv")).unwrap());
    let [a, b] = [&a, &b].map(|table| table.column(column).unwrap());
    let most = a.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / most
}

#[test]
fn a_mesh_that_comes_parted_is_tied_or_jointed_as_one_that_shares_its_nodes() {
    let folder = tempfile::tempdir().unwrap();
    for (joint, column) in [("law = \"tied\"", "high.ux"), (GOOD, "high.ux"), (GOOD, "pair.slip1")] {
        for out in ["a", "b"] {
            slab(folder.path(), joint, "", [2.0, 2.0]);
            if joint != GOOD {
                let case = std::fs::read_to_string(folder.path().join("case.toml")).unwrap();
                let monitor = "[[monitor]]\nname = \"pair\"\nat = [\"4 m\", \"4 m\", \"20 m\"]\ninterface = \"joint\"\n";
                assert!(case.contains(monitor));
                std::fs::write(folder.path().join("case.toml"), case.replace(monitor, "")).unwrap();
            }
            if out == "b" {
                part(folder.path());
            }
            let run = tremolite(folder.path(), &["run", "case.toml", "--out", out, "--overwrite"]);
            assert!(run.status.success(), "{}", errors(&run));
            assert!(!errors(&run).contains("lie within"), "doubled nodes are meant here: {}", errors(&run));
        }
        let apart = difference(folder.path(), column);
        assert!(apart < 1e-9, "{joint}, {column}: {apart}");
    }
}

/// Without initial stress and bond a pair opens and slides by round-off: that is no area.
#[test]
fn before_the_wave_comes_nothing_has_opened_or_slid() {
    let folder = tempfile::tempdir().unwrap();
    slab(folder.path(), &GOOD.replace("10 kPa", "0 Pa"), "duration = \"0.02 s\"", [2.0, 2.0]);
    let joint = summary_of(folder.path()).parts.interfaces["joint"].clone();
    assert_eq!([joint.ever_slid, joint.ever_opened, joint.sliding, joint.open], [0.0; 4], "{joint:?}");
}

/// A stiffness that the program chooses passes the check of it, with either law and whatever pressure is given: it is ten times that of the
/// elements beside it, 2 m of 2.4 GPa on both sides, or more. The step pays. What is given is left as it is.
#[test]
fn chosen_stiffnesses_pass_their_own_check_and_leave_given_pressures_as_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let check = |joint: &str| -> serde_json::Value {
        rattle(folder.path(), joint, "", [2.0, 2.0]);
        let check = tremolite(folder.path(), &["check", "case.toml", "--json"]);
        assert!(check.status.success(), "{}", errors(&check));
        serde_json::from_slice(&check.stdout).unwrap()
    };
    let open = GOOD.replace("normal_stiffness = \"20 GPa/m\"\n", "");
    let linear = "law = \"coulomb\"\ncohesion = \"10 kPa\"\nfriction_coefficient = 0.6\n".to_owned();
    for joint in [open.clone(), format!("{open}pressure_for_step = \"7 MPa\""), linear] {
        assert!(check(&joint)["interfaces"]["joint"]["chosen"].as_bool().unwrap());
        slab(folder.path(), &joint, "duration = \"0.01 s\"", [2.0, 2.0]);
        let summary = summary_of(folder.path());
        let found = line(&summary, "contact_penalty_compliance_joint");
        assert!(found.pass && !found.not_applicable, "{found:?}");
        let stiffness = found.numbers["normal_stiffness"];
        assert!((found.value * stiffness / (2.4e9 / 4.0) - 1.0).abs() < 1e-9, "{found:?}");
    }
    let given = check(&format!("{open}pressure_for_step = \"7 MPa\""));
    assert!(
        (given["interfaces"]["joint"]["straight_from"].as_f64().unwrap() / 7e6 - 1.0).abs() < 1e-9,
        "{given}"
    );
}
