//! A law in a file of its own: the same keys, checks and defaults as in a case.

use std::path::Path;

use tremolite_case::{LawFile, LawKind, Report};
use tremolite_laws::materials::MATERIALS;

const CONCRETE: &str = r#"
[material]
law = "concrete-damage"
young = "25 GPa"
poisson = 0.17
unit_weight = "27 kN/m3"
tensile_strength = "1.2 MPa"
cohesion = "2.0 MPa"
friction_angle = "46 deg"
"#;

fn parse(source: &str) -> Result<LawFile, Report> {
    LawFile::parse(Path::new("law.toml"), source, MATERIALS)
}

#[test]
fn a_law_file_is_read_in_si_with_defaults_listed() {
    let file = parse(CONCRETE).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((file.kind, file.law.value.as_str()), (LawKind::Material, "concrete-damage"));
    assert_eq!(file.parameters.number("young"), Ok(25e9));
    assert_eq!(file.parameters.optional("friction_angle"), Some(46f64.to_radians()));
    assert_eq!(file.parameters.word("split"), Some("compliance"));
    assert_eq!(file.parameters.word("evolution"), Some("exponential"));
    assert_eq!(file.size, None);
    assert!(
        file.defaulted
            .iter()
            .any(|d| (d.key.as_str(), d.value.as_str()) == ("material.residual_tension", "0.1"))
    );
    assert_eq!(&CONCRETE[file.span.clone()], "[material]");
}

#[test]
fn the_size_stands_above_the_table_or_in_it_and_a_point_needs_no_density() {
    let above = parse(&format!("size = \"25 cm\"{CONCRETE}")).unwrap_or_else(|e| panic!("{e}"));
    let inside = parse(&format!("{CONCRETE}size = \"0.25 m\"")).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(above.size.map(|s| s.value), Some(0.25));
    assert_eq!(inside.size.map(|s| s.value), Some(0.25));
    assert_eq!(above.parameters, inside.parameters, "the size is no parameter of the law");
    let without = CONCRETE.replace("unit_weight = \"27 kN/m3\"\n", "");
    assert_eq!(parse(&without).map(|f| f.parameters), Ok(above.parameters));
}

#[test]
fn each_mistake_is_reported_at_its_line_with_a_way_out() {
    let change = |from: &str, to: &str| CONCRETE.replace(from, to);
    #[rustfmt::skip]
    let bad = [
        (change("young = \"25 GPa\"", "yung = 1"), 4, "`yung` is no key of `material`", "did you mean `young`?"),
        (change("\"1.2 MPa\"", "\"1.2 m\""), 7, "is a length", "such as"),
        (change("poisson = 0.17", "poisson = 0.5"), 5, "below 0.5", "0.15 to 0.35"),
        (change("friction_angle = \"46 deg\"\n", ""), 2, "`friction_angle` is missing", "deg"),
        (change("concrete-damage", "concret-damage"), 3, "cannot be \"concret-damage\"", "\"concrete-damage\""),
        (change("unit_weight", "density = \"1 kg/m3\"\nunit_weight"), 7, "cannot stand beside `density`", "exactly one"),
        (change("[material]", "[material.lining]"), 2, "without a name", "instead of [material.lining]"),
        (format!("{}\n[material.a]\nlaw = \"elastic\"", change("[material]", "[material.lining]")), 2, "without a name", "instead of [material.lining]"),
        (format!("size = \"-1 m\"{CONCRETE}"), 1, "must be above 0", "above 0"),
        (format!("size = \"1 m\"{CONCRETE}size = \"1 m\""), 10, "given twice", "keep one"),
        (format!("title = 1{CONCRETE}"), 1, "`title` is no key of `law file`", "keys here: size"),
        (format!("{CONCRETE}[interface]\nlaw = \"bandis\"\n"), 10, "one law", "keep [material] or [interface]"),
        ("material = 3\n".to_owned(), 1, "should be a table", "[material]"),
        (String::new(), 1, "no material and no interface", "[material] or [interface]"),
        ("[material]\n".to_owned(), 1, "`law` is missing", "law = "),
        ("[material\n".to_owned(), 1, "", "bracket"),
    ];
    for (source, line, says, remedy) in bad {
        let report = parse(&source).expect_err(&source);
        let [problem] = &report.problems[..] else { panic!("{source}\n{report}") };
        assert_eq!(report.position(problem).0, line, "{source}\n{report}");
        assert!(problem.message.contains(says) && problem.remedy.contains(remedy), "{report}");
    }
}

#[test]
fn a_law_file_that_cannot_be_read_is_reported_by_name() {
    let report = LawFile::read(Path::new("none.toml"), MATERIALS).expect_err("no such file");
    assert!(report.to_string().contains("none.toml") && report.to_string().contains("law file"), "{report}");
}

const ROCK: &str = r#"
[material]
law = "mohr-coulomb"
young = "10 GPa"
poisson = 0.25
cohesion = "2.18 MPa"
friction_angle = "42 deg"
"#;

const SOFTENING: &str = r#"
[material.softening]
plastic_shear_strain = [0, 0.005, 2e-2]
cohesion = ["2.18 MPa", "1.2 MPa", "500 kPa"]
friction_angle = ["42 deg", "46 deg", "0.5 rad"]
"#;

#[test]
fn a_table_of_columns_is_read_in_si() {
    let file = parse(&format!("{ROCK}{SOFTENING}")).unwrap_or_else(|e| panic!("{e}"));
    let columns = file.parameters.table("softening").expect("the table is there");
    assert_eq!(columns["plastic_shear_strain"], [0.0, 0.005, 0.02]);
    assert_eq!(columns["cohesion"], [2.18e6, 1.2e6, 0.5e6]);
    assert_eq!(columns["friction_angle"], [42f64.to_radians(), 46f64.to_radians(), 0.5]);
    assert!(!columns.contains_key("tensile_strength"));
    let inline = "softening = { plastic_shear_strain = [0, 1e-3], cohesion = [\"2.18 MPa\", 0] }";
    let file = parse(&format!("{ROCK}{inline}")).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(file.parameters.table("softening").map(|c| &c["cohesion"][..]), Some(&[2.18e6, 0.0][..]));
}

#[test]
fn each_mistake_in_a_table_of_columns_is_reported_at_its_line() {
    let change = |from: &str, to: &str| format!("{ROCK}{}", SOFTENING.replace(from, to));
    #[rustfmt::skip]
    let bad = [
        (change("cohesion = [", "cohesiom = ["), 11, "`cohesiom` is no key of `material.softening`", "did you mean `cohesion`?"),
        (change("\"1.2 MPa\", ", ""), 11, "`cohesion` has 2 numbers, but `plastic_shear_strain` has 3", "one number a row"),
        (change("\"500 kPa\"", "\"500 kN\""), 11, "is a force", "stress"),
        (change("\"46 deg\"", "46"), 12, "`friction_angle` has no unit", "deg"),
        (change("\"46 deg\"", "\"96 deg\""), 12, "at most 89.9 deg", "cannot"),
        (change("[\"2.18 MPa\"", "[\"2.2 MPa\""), 11, "does not begin with the peak strength", "`cohesion`"),
        (change("0.005, 2e-2", "0.005, 0.005"), 10, "must grow from 0", "peak"),
        (change("plastic_shear_strain = [0, 0.005, 2e-2]\n", ""), 9, "has no column plastic_shear_displacement", "give [0"),
        (format!("{ROCK}softening = 0.1"), 8, "should be a table of columns", "plastic_shear_displacement = ["),
    ];
    for (source, line, says, remedy) in bad {
        let report = parse(&source).expect_err(&source);
        let text = report.to_string();
        assert!(text.contains(&format!("law.toml:{line}:")), "{line}: {text}");
        assert!(text.contains(says) && text.contains(remedy), "{says}: {text}");
    }
}

#[test]
fn all_that_is_missing_is_named_at_once_with_its_unit() {
    for (law, keys) in [
        (
            "concrete-damage",
            &["`friction_angle`", "`young`", "`poisson`", "`tensile_strength`", "`compressive_strength`"][..],
        ),
        ("drucker-prager", &["`young`", "`poisson`", "`cohesion`", "`friction_angle`"]),
        ("hoek-brown", &["young = \"… GPa\"", "compressive_strength = \"… MPa\"", "gsi = …", "m_i = …"]),
        ("mohr-coulomb", &["cohesion = \"… MPa\"", "friction_angle = \"… deg\""]),
    ] {
        let Err(report) = parse(&format!("[material]\nlaw = \"{law}\"\n")) else {
            panic!("{law} is incomplete")
        };
        let text = report.to_string();
        for key in keys {
            assert_eq!(text.matches(key).count(), 1, "{key} once in\n{text}");
        }
    }
    // What is wrong as well is named beside it.
    let Err(report) = parse("[material]\nlaw = \"drucker-prager\"\ncohesion = \"-1.0 Pa\"\n") else {
        panic!()
    };
    for words in ["`young` is missing", "`cohesion` must be zero", "`friction_angle` is missing"] {
        assert!(report.to_string().contains(words), "{report}");
    }
}

/// A key may be written out though another word makes it idle: what is unusual is a warning of the law, not an error.
#[test]
fn every_key_of_concrete_may_be_written_out() {
    let all = format!(
        r#"{CONCRETE}residual_tension = 0.1
residual_shear = 0.2
ultimate_strain_ratio = 10.0
rate = "none"
reference_rate = "3e-5 1/s"
driver = "strain"
shear_tension = "nominal"
split = "effective"
evolution = "residual"
"#
    );
    for (from, to) in [("", ""), ("\"effective\"", "\"compliance\""), ("rate = \"none\"", "rate = \"ceb\"")] {
        assert!(parse(&all.replacen(from, to, usize::from(!from.is_empty()))).is_ok(), "{to}");
    }
    let exponential = all
        .replace("ultimate_strain_ratio = 10.0", "fracture_energy = \"130 N/m\"")
        .replace("\"residual\"", "\"exponential\"");
    assert!(parse(&exponential).is_ok());
}

const JOINT: &str = r#"
[interface]
law = "bandis"
normal_stiffness = "20 GPa/m"
max_closure = "2 mm"
friction_coefficient = 0.7
"#;

#[test]
fn an_interface_law_is_read_in_si_with_defaults_listed() {
    let file = parse(JOINT).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((file.kind, file.law.value.as_str()), (LawKind::Interface, "bandis"));
    assert_eq!(file.parameters.number("normal_stiffness"), Ok(20e9));
    assert_eq!(file.parameters.number("cohesion"), Ok(0.0));
    assert_eq!((file.size, &JOINT[file.span.clone()]), (None, "[interface]"));
    let said: Vec<(&str, &str)> = file.defaulted.iter().map(|d| (d.key.as_str(), d.value.as_str())).collect();
    assert!(said.contains(&("interface.tensile_strength", "the cohesion")), "{said:?}");
}

#[test]
fn each_mistake_in_an_interface_law_is_reported_at_its_line() {
    let change = |from: &str, to: &str| JOINT.replace(from, to);
    let no_meaning = "has no meaning for an interface law alone";
    #[rustfmt::skip]
    let bad = [
        (change("normal_stiffness = \"20 GPa/m\"\n", ""), 2, "`normal_stiffness` is missing", "GPa/m"),
        (change("friction_coefficient = 0.7\n", ""), 2, "`friction_coefficient` is missing", "friction_angle"),
        (change("friction_coefficient = 0.7", "friction_coeficient = 0.7\nfriction_coefficient = 0.7"), 6, "`friction_coeficient` is no key of `interface`", "did you mean `friction_coefficient`?"),
        (change("0.7", "-0.7"), 6, "must be zero or positive", ""),
        (change("\"2 mm\"", "\"2 MPa\""), 5, "is a stress", "such as"),
        (change("\"bandis\"\n", "\"bandi\"\n"), 3, "cannot be \"bandi\"", "did you mean \"bandis\"?"),
        (change("law = \"bandis\"\nnormal_stiffness = \"20 GPa/m\"\nmax_closure = \"2 mm\"\nfriction_coefficient = 0.7\n", "law = \"tied\""), 3, "cannot be \"tied\"", "\"bandis\", \"coulomb\""),
        (format!("size = \"1 m\"{JOINT}"), 1, &format!("`size` {no_meaning}"), "leave it out"),
        (format!("{JOINT}size = \"1 m\""), 7, &format!("`size` {no_meaning}"), "leave it out"),
        (format!("{JOINT}name = \"a\""), 7, &format!("`name` {no_meaning}"), "leave it out"),
        (format!("{JOINT}between = [\"a\", \"b\"]"), 7, &format!("`between` {no_meaning}"), "leave it out"),
        (format!("{JOINT}contact_limit = 1"), 7, &format!("`contact_limit` {no_meaning}"), "leave it out"),
        (change("[interface]", "[interface.joint]"), 2, "one interface, without a name", "instead of [interface.joint]"),
        (change("[interface]", "[[interface]]"), 2, "one interface, not a list", "[interface] instead of [[interface]]"),
        (format!("{JOINT}[material]\nlaw = \"elastic\""), 7, "one law", "keep [material] or [interface]"),
        ("interface = 3".to_owned(), 1, "`interface` should be a table", "write [interface]"),
        ("[interface]\n".to_owned(), 1, "`law` is missing", "law = "),
    ];
    for (source, line, says, remedy) in bad {
        let report = parse(&source).expect_err(&source);
        let [problem] = &report.problems[..] else { panic!("{source}\n{report}") };
        assert_eq!(report.position(problem).0, line, "{source}\n{report}");
        assert!(problem.message.contains(says) && problem.remedy.contains(remedy), "{report}");
    }
}
