//! Softening of a layer under a pulse: what `check` says of it, and elements that are too large for it.

use crate::stage_case::{code, errors, tremolite};
use std::path::Path;

/// A column of 48 m with a layer of 8 m that softens, under a pulse of 2 Hz from below (a Ricker wavelet of 6 m/s² at the outcrop).
fn column(folder: &Path, elements: usize, softening: &str) {
    let pulse: String = (0..800)
        .map(|k| {
            let t = 0.005 * f64::from(k);
            let x = (std::f64::consts::PI * 2.0 * (t - 1.0)).powi(2);
            format!("{t} {:.9e}\n", 2.0 * (1.0 - 2.0 * x) * (-x).exp())
        })
        .collect();
    std::fs::write(folder.join("ricker2.txt"), format!("# units = \"m/s2\"\n{pulse}")).unwrap();
    let text = format!(
        r#"title = "column with a layer that softens"
[mesh.box]
group = "rock"
x = {{ to = "2 m", elements = 1 }}
y = {{ to = "2 m", elements = 1 }}
z = {{ from = "-48 m", to = "0 m", elements = {elements} }}
part = [{{ group = "weak", z = ["-24 m", "-16 m"] }}]
[material.rock]
law = "elastic"
young = "3 GPa"
poisson = 0.3
unit_weight = "25 kN/m3"
[material.weak]
law = "mohr-coulomb"
young = "0.4 GPa"
poisson = 0.3
unit_weight = "20 kN/m3"
cohesion = "150 kPa"
friction_angle = "20 deg"
tensile_strength = "10 kPa"
softening = {softening}
[[region]]
groups = ["rock"]
material = "rock"
element = "one-point"
[[region]]
groups = ["weak"]
material = "weak"
element = "one-point"
[initial]
lateral = 0.7
[motion]
kind = "outcrop"
east = {{ file = "ricker2.txt" }}
process = ["scale 3"]
[dynamic]
base = "viscous-spring"
sides = "periodic"
[[monitor]]
name = "top"
at = ["0 m", "0 m", "0 m"]
[output]
snapshots = "none"
histories = "0.02 s"
"#
    );
    std::fs::write(folder.join("case.toml"), text).unwrap();
}

const BY_SLIP: &str =
    r#"{ plastic_shear_displacement = ["0 mm", "20 mm"], cohesion = ["150 kPa", "5 kPa"] }"#;

#[test]
fn softening_over_strain_is_warned_of_and_elements_beyond_the_limit_are_refused_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let check = |softening: &str| {
        column(folder, 12, softening);
        let done = tremolite(folder, &["check", "case.toml"]);
        (code(&done), errors(&done))
    };
    let (status, said) = check(r#"{ plastic_shear_strain = [0, 0.01], cohesion = ["150 kPa", "5 kPa"] }"#);
    assert!(status == 0 && said.contains("softening over plastic strain has no length"), "{said}");
    let (status, said) = check(BY_SLIP);
    assert!(status == 0 && !said.contains("softening"), "{said}");
    // E δ/(2 Δf_c) = 0.4 GPa × 5 mm/(2 × 0.414 MPa), in elements of 4 m.
    let short = BY_SLIP.replace("20 mm", "5 mm");
    let (status, said) = check(&short);
    assert_eq!(status, 2, "{said}");
    assert!(said.contains("softening elements must stay below 2.41 m"), "{said}");
    assert!(said.contains("plastic displacements of the softening 1.7 times as long"), "{said}");
    // The remedy holds as it is written.
    let (status, said) = check(&BY_SLIP.replace("20 mm", "8.5 mm"));
    assert_eq!(status, 0, "{said}");
}
