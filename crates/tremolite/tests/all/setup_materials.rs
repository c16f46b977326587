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
evolution = "residual"
split = "effective"
fracture_energy = "{energy}"
[[region]]
groups = ["rock"]
material = "weak"
element = "full-integration"
[motion]
kind = "outcrop"
east = {{ file = "pulse.txt", units = "m/s2", dt = "0.01 s" }}
processing = ["baseline"]
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
    for words in
        ["of 'rock'", "extends over 6.00 m", "2 others", "below 4.51 m", "`ultimate_strain_ratio` in place"]
    {
        assert!(refused.contains(words), "{words}: {refused}");
    }
    // 6.94 m.
    let case = self::case(folder.path(), "200 N/m", "1.2 MPa", "damage");
    let made = setup(&case, &Laws::default(), Isa::best()).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(made.warnings, []);
}

/// A lined hall of concrete whose sizes along and across are these \[m\].
fn hall(folder: &Path, near: &str, along: &str) -> Case {
    let text = case(folder, "130 N/m", "1.2 MPa", "damage");
    let (_, rest) = text.source.split_once("[motion]").unwrap();
    let text = format!(
        r#"
title = "hall"
[mesh.caverns]
overburden = "40 m"
below = "30 m"
sides = "30 m"
length = "3 m"
size_near = "{near} m"
size_far = "9 m"
size_along = "{along} m"
[[mesh.caverns.cavern]]
name = "hall"
width = "10.5 m"
height = "16 m"
arch_rise = "3.5 m"
lining = {{ walls = "0.6 m", crown = "0.5 m" }}
[material.rock]
law = "elastic"
young = "9 GPa"
poisson = 0.25
density = "2700 kg/m3"
[material.concrete]
law = "concrete-damage"
grade = "C25/30"
friction_angle = "46 deg"
density = "2500 kg/m3"
[[region]]
groups = ["rock"]
material = "rock"
element = "reduced-integration"
[[region]]
groups = ["hall.lining"]
material = "concrete"
[[region]]
groups = ["hall.bench*"]
material = "void"
[motion]{rest}"#
    );
    let infos: Vec<LawInfo> = laws().iter().map(|l| l.info).collect();
    Case::parse(&folder.join("case.toml"), &text, &infos).unwrap_or_else(|e| panic!("{e}"))
}

/// Round a vault elements are larger than the size that is asked for: what is named has to do all the same.
#[test]
fn the_sizes_that_a_refusal_names_are_taken() {
    let folder = tempfile::tempdir().unwrap();
    let refused = setup(&hall(folder.path(), "1.5", "1.5"), &Laws::default(), Isa::best()).err().unwrap();
    let refused = refused.to_string();
    let between = |from: &str, to: &str| {
        let rest = refused.split_once(from).unwrap_or_else(|| panic!("{from}: {refused}")).1;
        rest.split_once(to).unwrap_or_else(|| panic!("{to}: {refused}")).0.to_owned()
    };
    let (near, along) = (between("give `size_near` ", " m"), between("and `size_along` ", " m"));
    assert!(refused.contains("size_near = \"1.5 m\""), "shown where it is written: {refused}");
    let taken = setup(&hall(folder.path(), &near, &along), &Laws::default(), Isa::best());
    assert!(taken.is_ok(), "{near}, {along}: {}", taken.err().unwrap());
}

#[test]
fn what_a_law_finds_unusual_and_a_field_that_none_can_fill_are_warned_of_once() {
    let folder = tempfile::tempdir().unwrap();
    let case = case(folder.path(), "9000 N/m", "2 MPa", "plastic");
    let made = setup(&case, &Laws::default(), Isa::best()).unwrap_or_else(|e| panic!("{e}"));
    let warnings = case.report(made.warnings.clone()).to_string();
    assert_eq!(made.warnings.len(), 3, "{warnings}");
    // 9,000 N/m make l_ch 56 m, of which elements of 2 × 2 × 6 m are a small part.
    assert!(
        warnings.contains("drops to a plateau") && warnings.contains("half of its elements are 2.000 m"),
        "{warnings}"
    );
    assert!(warnings.contains("counts as shear failure"), "{warnings}");
    assert!(warnings.contains("the field 'plastic'"), "{warnings}");
}

/// A slab of concrete, one element thick, under the same pulse.
fn slab(folder: &Path, element: &str) -> Result<(), String> {
    let samples: Vec<String> = (0..40).map(|i| (f64::from(i) * 0.3).sin().to_string()).collect();
    std::fs::write(folder.join("pulse.txt"), samples.join("\n")).unwrap();
    let text = format!(
        r#"
title = "slab"
[mesh.box]
x = {{ to = "4 m", elements = 4 }}
y = {{ to = "2 m", elements = 2 }}
z = {{ to = "0.5 m", elements = 1 }}
[material.weak]
law = "concrete-damage"
young = "25 GPa"
poisson = 0.17
density = "2700 kg/m3"
tensile_strength = "1.2 MPa"
cohesion = "2 MPa"
friction_angle = "46 deg"
evolution = "residual"
split = "effective"
fracture_energy = "130 N/m"
[[region]]
groups = ["rock"]
material = "weak"
{element}
[motion]
kind = "outcrop"
east = {{ file = "pulse.txt", units = "m/s2", dt = "0.01 s" }}
processing = ["baseline"]
[dynamic]
base = "viscous"
sides = "periodic"
[output]
fields = ["damage"]
"#
    );
    let infos: Vec<LawInfo> = laws().iter().map(|l| l.info).collect();
    let case = Case::parse(&folder.join("case.toml"), &text, &infos).map_err(|e| e.to_string())?;
    let made = setup(&case, &Laws::default(), Isa::best()).map_err(|e| e.to_string())?;
    match made.warnings.is_empty() {
        true => Ok(()),
        false => Err(case.report(made.warnings).to_string()),
    }
}

#[test]
fn one_layer_of_2x2x2_points_is_warned_of_and_layers_are_as_many_as_there_are() {
    let folder = tempfile::tempdir().unwrap();
    let said = |element: &str| slab(folder.path(), element).err().unwrap_or_default();
    let warned = said("element = \"full-integration\"");
    assert!(warned.contains("one element thick") && warned.contains("\"layered\""), "{warned}");
    for good in ["element = \"layered\"", "element = \"layered\"\npoints_through = 13"] {
        assert_eq!(said(good), "", "{good}");
    }
    let refused = said("element = \"layered\"\npoints_through = 8");
    assert!(refused.contains("7, 9 or 13"), "{refused}");
    let refused = said("element = \"full-integration\"\npoints_through = 9");
    assert!(refused.contains("points_through"), "{refused}");
    // What the generator has not made must say it.
    let refused = said("");
    assert!(refused.contains("must say how its elements are integrated"), "{refused}");
}

/// A region of many groups makes a body that is called by its material; the material lists all of them.
#[test]
fn a_body_of_many_groups_is_called_by_its_material() {
    let folder = tempfile::tempdir().unwrap();
    let text = case(folder.path(), "200 N/m", "1.2 MPa", "damage").source;
    let made = |parts: usize| {
        let part = |k: usize| {
            let (low, high) = (3 * k, 3 * (k + 1));
            format!("[[mesh.box.part]]\ngroup = \"layer{k}\"\nz = [\"{low} m\", \"{high} m\"]\n")
        };
        let all: String = (0..parts).map(part).collect();
        let text = text
            .replace("elements = 3 }", "elements = 6 }")
            .replace("[material.weak]", &format!("{all}[material.weak]"))
            .replace("groups = [\"rock\"]", "groups = [\"rock\", \"layer*\"]");
        let infos: Vec<LawInfo> = laws().iter().map(|l| l.info).collect();
        let case =
            Case::parse(&folder.path().join("case.toml"), &text, &infos).unwrap_or_else(|e| panic!("{e}"));
        setup(&case, &Laws::default(), Isa::best()).unwrap_or_else(|e| panic!("{e}"))
    };
    let few = made(2);
    assert_eq!(few.problem.bodies[0].name.split(", ").count(), 3);
    assert_eq!(few.materials["weak"].groups[0].names, few.problem.bodies[0].name);
    let many = made(5);
    let (name, group) = (&many.problem.bodies[0].name, &many.materials["weak"].groups[0]);
    assert!(name.starts_with("weak (") && name.ends_with(" and 5 more groups)"), "{name}");
    assert_eq!((&group.body, group.names.split(", ").count()), (name, 6));
}
