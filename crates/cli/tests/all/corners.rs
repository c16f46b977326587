//! Concrete that drops to a plateau: small elements are warned of and fail a check of the run, large ones and the crack band pass.

use crate::unseen::{line, run};
use std::path::Path;
use tremolite_results::Summary;

/// l_ch = E G_f/f_t² of 25 GPa, 130 N/m and 1.2 MPa \[m\].
const LENGTH: f64 = 25e9 * 130.0 / (1.2e6 * 1.2e6);

/// A plain column of 60 m of cubes of edge `size` \[m\], whose free top sends a pulse back as tension, `motion` times as strong as
/// one that tears it in many places; with what was warned of before the run.
fn column(folder: &Path, size: f64, evolution: &str, motion: f64) -> (Summary, String) {
    let acceleration = |k: u32| {
        let x = (std::f64::consts::PI * 6.0 * (0.002 * f64::from(k) - 0.25)).powi(2);
        format!("{:.6}\n", 12.0 * (1.0 - 2.0 * x) * (-x).exp())
    };
    std::fs::write(folder.join("pulse.txt"), (0..500).map(acceleration).collect::<String>()).unwrap();
    let case = format!(
        r#"title = "column"
[mesh.box]
x = {{ to = "{size} m", elements = 1 }}
y = {{ to = "{size} m", elements = 1 }}
z = {{ to = "60 m", elements = {} }}
[material.concrete]
law = "concrete-damage"
young = "25 GPa"
poisson = 0.17
unit_weight = "25 kN/m3"
compressive_strength = "30 MPa"
friction_angle = "37 deg"
tensile_strength = "1.2 MPa"
fracture_energy = "130 N/m"
{evolution}
[[region]]
groups = ["rock"]
material = "concrete"
element = "reduced-integration"
[motion]
kind = "incident"
east = {{ file = "pulse.txt", units = "m/s2", dt = "0.002 s" }}
up = {{ from = "east", factor = 0.5 }}
processing = ["baseline", "scale {motion}"]
[dynamic]
sides = "periodic"
[output]
histories = "0.005 s"
"#,
        60.0 / size
    );
    let summary = run(folder, &case);
    let warned = summary.case.warnings.join("\n");
    (summary, warned)
}

#[test]
fn a_plateau_in_small_elements_is_warned_of_and_fails_and_the_crack_band_on_the_same_mesh_passes() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    const RESIDUAL: &str = "evolution = \"residual\"\nresidual_tension = 0.1";
    let (small, warned) = column(folder, 0.5, RESIDUAL, 1.0);
    let failing = line(&small, "plateau_corner_strength_rock");
    // α + (1 − α) √(πh/(2 l_ch)); every element is a cube of 0.5 m.
    let left = 0.1 + 0.9 * (std::f64::consts::FRAC_PI_2 * 0.5 / LENGTH).sqrt();
    assert!(!failing.pass && (failing.value / left - 1.0).abs() < 1e-6, "{failing:?}");
    assert!(
        failing.numbers["cracked"] > 0.0 && (failing.numbers["extent"] - 0.5).abs() < 1e-9,
        "{failing:?}"
    );
    assert!(failing.note.contains("0.500 m") && failing.note.contains("\"exponential\""), "{failing:?}");
    for words in ["'rock' drops to a plateau", "0.500 m", "some 63 %", "evolution = \"exponential\""] {
        assert!(warned.contains(words), "{words}: {warned}");
    }

    // The default.
    let (band, warned) = column(folder, 0.5, "", 1.0);
    assert!(band.parts.damage["rock"].measures["d_tension"].largest > 0.9, "it cracks as well");
    assert!(line(&band, "plateau_corner_strength").not_applicable && !warned.contains("plateau"), "{warned}");

    let (large, warned) = column(folder, 2.0, RESIDUAL, 1.0);
    let passing = line(&large, "plateau_corner_strength_rock");
    assert!(passing.pass && passing.value == 1.0 && passing.numbers["cracked"] > 0.0, "{passing:?}");
    assert!(!warned.contains("plateau"), "{warned}");

    // What bears it though its corners are too weak is right.
    let (whole, warned) = column(folder, 0.5, RESIDUAL, 0.05);
    let whole = line(&whole, "plateau_corner_strength_rock");
    assert!(whole.pass && whole.value == 1.0 && whole.note.contains("none of it has cracked"), "{whole:?}");
    assert!(warned.contains("plateau"), "{warned}");
}
