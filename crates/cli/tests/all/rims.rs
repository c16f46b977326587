//! What says that ground with a fault does not begin at rest, and where.

use crate::stage_case::{bytes, code, errors, run};
use serde_json::Value;
use std::path::Path;
use tremolite_mesh::boxes::BoxSpec;

/// Ground of 40 × 2 × 32 m with an upright fault through a hall that is dug later and beside a gallery, which is there from the start
/// or is rock.
fn case(folder: &Path, gallery: &str) {
    let mut mesh = BoxSpec::uniform([0.0; 3], [40.0, 2.0, 32.0], [40, 1, 32]).mesh().unwrap();
    let group = |e: u32| match (e % 40, e / 40) {
        (18..22, 20..24) => "hall",
        (20..24, 6..10) => "gallery",
        (x, _) if x < 20 => "low",
        _ => "high",
    };
    let of = |name: &str| (0..1280).filter(|&e| group(e) == name).collect::<Vec<u32>>();
    mesh.groups = ["hall", "gallery", "low", "high"].map(|name| (name.to_owned(), of(name))).into();
    tremolite_mesh::write(folder.join("ground.msh"), &mesh).unwrap();
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
groups = ["low", "high", "hall"]
material = "rock"
element = "full-integration"
[[region]]
groups = ["gallery"]
material = {gallery}
[[interface]]
name = "fault"
between = ["low", "high"]
law = "coulomb"
normal_stiffness = "1 GPa/m"
cohesion = "0.5 MPa"
friction_coefficient = 0.6
[initial]
lateral = 0.6
[[stage]]
name = "hall"
excavate = ["hall"]
"#
    );
    std::fs::write(folder.join("case.toml"), text).unwrap();
}

/// Those of the initial stress, and of the motion to equilibrium, each as a whole and at its worst place: value, whether it passes,
/// and what is said of it.
fn checks(folder: &Path) -> Vec<(f64, bool, String)> {
    let run = run(folder, "out", &["--overwrite"]);
    assert_eq!(code(&run), 0, "{}", errors(&run));
    let summary: Value = serde_json::from_slice(&bytes(folder, "out", "summary.json")).unwrap();
    let line = |id: &str| {
        let lines = summary["checks"].as_array().unwrap();
        let line = lines.iter().find(|line| line["id"] == id).unwrap();
        let note = line["note"].as_str().unwrap().to_owned();
        (line["value"].as_f64().unwrap(), line["pass"].as_bool().unwrap(), note)
    };
    let ids =
        ["initial_stress_change", "initial_stress_change_local", "initial_motion", "initial_motion_local"];
    ids.map(line).to_vec()
}

/// An opening in stress that knows nothing of it: a twelfth of the stress of all changes, and four fifths of that beside it.
#[test]
fn stress_that_does_not_fit_at_one_place_is_told_with_it_and_with_the_interface_there() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    case(folder, "\"rock\"\nelement = \"full-integration\"");
    let good = checks(folder);
    for (value, pass, _) in &good {
        assert!(*pass && *value < 1e-9, "{good:?}");
    }
    let stage = String::from_utf8_lossy(&bytes(folder, "out", "stages/000.vtu")).into_owned();
    assert!(stage.contains("\"initial_motion\""));

    case(folder, "\"void\"");
    let wrong = checks(folder);
    assert!(wrong[0].1 && !wrong[1].1 && !wrong[3].1, "{wrong:?}");
    for (_, _, note) in [&wrong[1], &wrong[3]] {
        assert!(note.contains("beside interface 'fault'"), "{note}");
    }
}
