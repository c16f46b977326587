//! Faults through a hall that is not yet dug: at rest, and what says so where one is not.

use crate::stage_case::{bytes, code, errors, run};
use serde_json::Value;
use std::path::Path;
use tremolite_mesh::Mesh;
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::split::{Cut, split};

/// Ground of 24 × 2 × 16 m with a hall in its middle, below and above a level plane half-way up the hall.
fn ground() -> Mesh {
    let mut mesh = BoxSpec::uniform([0.0; 3], [24.0, 2.0, 16.0], [12, 1, 8]).mesh().unwrap();
    let group = |e: u32| {
        let (x, z) = (e % 12, e / 12);
        match ((4..8).contains(&x) && (2..6).contains(&z), z < 4) {
            (true, _) => "hall",
            (_, true) => "low",
            (_, false) => "high",
        }
    };
    let of = |name: &str| (0..96).filter(|&e| group(e) == name).collect::<Vec<u32>>();
    mesh.groups = ["hall", "low", "high"].map(|name| (name.to_owned(), of(name))).into();
    mesh
}

fn case(folder: &Path, mesh: &Mesh, stiffness: &str) {
    tremolite_mesh::write(folder.join("ground.msh"), mesh).unwrap();
    let text = format!(
        r#"title = "ground"
[mesh.file]
path = "ground.msh"
[material.rock]
law = "elastic"
young = "2 GPa"
poisson = 0.25
density = "2600 kg/m3"
[[region]]
groups = ["*"]
material = "rock"
element = "full"
[[interface]]
name = "fault"
between = ["low", "high"]
law = "coulomb"
normal_stiffness = "{stiffness}"
cohesion = "5 MPa"
friction = 0.6
[initial]
lateral = 0.6
[[stage]]
name = "hall"
excavate = ["hall"]
"#
    );
    std::fs::write(folder.join("case.toml"), text).unwrap();
}

/// The checks of the initial equilibrium: value, whether it passes, and what is said of it.
fn checks(folder: &Path) -> Vec<(f64, bool, String)> {
    let run = run(folder, "out", &["--overwrite"]);
    assert_eq!(code(&run), 0, "{}", errors(&run));
    let summary: Value = serde_json::from_slice(&bytes(folder, "out", "summary.json")).unwrap();
    let line = |id: &str| {
        let lines = summary["trust"].as_array().unwrap();
        let line = lines.iter().find(|line| line["id"] == id).unwrap();
        (
            line["value"].as_f64().unwrap(),
            line["pass"].as_bool().unwrap(),
            line["note"].as_str().unwrap().to_owned(),
        )
    };
    let ids =
        ["initial_motion", "initial_motion_local", "initial_stress_change", "initial_stress_change_local"];
    ids.map(line).to_vec()
}

/// A mesh that comes parted with the rock of the hall on one side alone was what the program once made by itself.
#[test]
fn rock_that_hangs_on_one_side_of_a_fault_is_seen_at_its_place_and_tied_rock_is_at_rest() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let mesh = ground();
    case(folder, &mesh, "0.3 GPa/m");
    let good = checks(folder);
    for (value, pass, _) in &good {
        assert!(*pass && *value < 1e-9, "{good:?}");
    }
    let stage = String::from_utf8_lossy(&bytes(folder, "out", "stages/000.vtu")).into_owned();
    assert!(stage.contains("\"initial_motion\""));

    let mut parted = mesh.clone();
    let times: Vec<_> = (0..96).map(|e| 0..u32::from(!mesh.groups["hall"].contains(&e))).collect();
    let cut = Cut { name: "fault", sides: [&mesh.groups["low"], &mesh.groups["high"]] };
    split(&mut parted, &[cut], &times).unwrap();
    case(folder, &parted, "0.3 GPa/m");
    let wrong = checks(folder);
    println!("{wrong:?}");
    assert!(wrong[2].1 && !wrong[1].1 && !wrong[3].1, "{wrong:?}");
    for (_, _, note) in [&wrong[1], &wrong[3]] {
        assert!(note.contains("beside interface 'fault'"), "{note}");
    }
}
