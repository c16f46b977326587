//! What a case says of materials that the mesh or the laws object to.

use std::path::Path;
use tremolite::laws;
use tremolite::setup::{Laws, setup};
use tremolite_case::Case;
use tremolite_laws::{Isa, LawInfo};

/// A block of concrete of three elements of 2 × 2 × 6 m under a sampled pulse.
fn case(folder: &Path, energy: &str, strength: &str, fields: &str) -> Case {
    let samples: Vec<String> = (0..40).map(|i| (f64::from(i) * 0.3).sin().to_string()).collect();
    std::fs::write(folder.join("pulse.txt"), samples.join("\n")).unwrap();
    let text = format!(
        r#"
title = "block"
[mesh.box]
x = {{ to = "2 m", elements = 1 }}
y = {{ to = "2 m", elements = 1 }}
z = {{ to = "18 m", elements = 3 }}
[material.weak]
law = "concrete-damage"
young = "25 GPa"
poisson = 0.17
density = "2700 kg/m3"
tensile_strength = "{strength}"
cohesion = "2 MPa"
friction_angle = "46 deg"
fracture_energy = "{energy}"
[[region]]
groups = ["rock"]
material = "weak"
element = "full"
[motion]
kind = "outcrop"
east = {{ file = "pulse.txt", units = "m/s2", dt = "0.01 s" }}
process = ["baseline"]
[dynamic]
base = "viscous"
sides = "periodic"
[output]
fields = ["{fields}"]
"#
    );
    let infos: Vec<LawInfo> = laws().iter().map(|l| l.info).collect();
    Case::parse(&folder.join("case.toml"), &text, &infos).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn elements_too_large_for_the_fracture_energy_are_refused_by_number_group_extent_and_limit() {
    let folder = tempfile::tempdir().unwrap();
    // 2 G_f E/f_t² = 4.51 m.
    let case = case(folder.path(), "130 N/m", "1.2 MPa", "damage");
    let refused = setup(&case, &Laws::default(), Isa::best()).err().unwrap().to_string();
    for words in ["of 'rock'", "extends over 6.00 m", "2 others", "below 4.51 m", "raise the fracture energy"]
    {
        assert!(refused.contains(words), "{words}: {refused}");
    }
    // 6.94 m.
    let case = self::case(folder.path(), "200 N/m", "1.2 MPa", "damage");
    let made = setup(&case, &Laws::default(), Isa::best()).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(made.warnings, []);
}

#[test]
fn what_a_law_finds_unusual_and_a_field_that_none_can_fill_are_warned_of_once() {
    let folder = tempfile::tempdir().unwrap();
    let case = case(folder.path(), "9000 N/m", "2 MPa", "plastic");
    let made = setup(&case, &Laws::default(), Isa::best()).unwrap_or_else(|e| panic!("{e}"));
    let warnings = case.report(made.warnings.clone()).to_string();
    assert_eq!(made.warnings.len(), 2, "{warnings}");
    assert!(warnings.contains("counts as shear failure"), "{warnings}");
    assert!(warnings.contains("the field 'plastic'"), "{warnings}");
}
