//! Numbers without a unit: refused, unless the file says that they are in SI.

use std::path::Path;

use tremolite_case::*;
use tremolite_laws::materials::MATERIALS;

const EVERY_KEY: &str = include_str!("../cases/every-key.toml");

fn parse(source: &str) -> Result<Case, Report> {
    Case::parse(Path::new("case.toml"), source, MATERIALS)
}

/// In SI what has another unit than an angle's.
fn si(value: &str) -> Option<String> {
    let (number, unit) = value.split_once(' ')?;
    let power = match unit {
        "m" | "s" | "Hz" | "1/s" | "m/s" | "m/s2" | "N/m" | "kg/m3" => 0,
        "cm" => -2,
        "mm" | "ms" => -3,
        "mm2/m" => -6,
        "kN" | "kN/m" | "kN/m3" | "km" | "kPa" => 3,
        "MPa" => 6,
        "GPa" | "GPa/m" => 9,
        _ => return None,
    };
    number.parse::<f64>().ok()?;
    format!("{number}e{power}").parse::<f64>().ok().map(|x| format!("{x:?}"))
}

/// A case with its numbers in SI, and how many have lost their unit.
fn bare(source: &str) -> (String, usize) {
    let mut found = 0;
    let lines = source.lines().map(|line| {
        // Steps of processing are texts, units and all.
        if line.starts_with("process") {
            return line.to_owned();
        }
        let words = line.split('"').collect::<Vec<_>>();
        let mut out = words[0].to_owned();
        for pair in words[1..].chunks(2) {
            match si(pair[0]) {
                Some(number) => {
                    found += 1;
                    out += &number;
                }
                None => out += &format!("\"{}\"", pair[0]),
            }
            out += pair.get(1).unwrap_or(&"");
        }
        out
    });
    let text = lines.collect::<Vec<_>>().join("\n");
    (text, found)
}

/// What a case holds, without the places of its values in the text.
fn held(case: &Case) -> String {
    let Case { mesh, materials, regions, interfaces, initial, stages, reinforcement, .. } = case;
    let Case { motion, dynamic, monitors, relatives, output, page, .. } = case;
    let all = format!(
        "{mesh:?}{materials:?}{regions:?}{interfaces:?}{initial:?}{stages:?}{reinforcement:?}\
         {motion:?}{dynamic:?}{monitors:?}{relatives:?}{output:?}{page:?}"
    );
    let mut parts = all.split("span: ");
    let first = parts.next().unwrap_or("").to_owned();
    parts.fold(first, |out, part| out + part.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.'))
}

#[test]
fn a_case_in_si_throughout_is_the_case_with_units() {
    let (text, count) = bare(EVERY_KEY);
    assert!(count > 100, "{count} numbers have lost their unit");
    let with_units = parse(EVERY_KEY).unwrap_or_else(|e| panic!("{e}"));
    let in_si = parse(&format!("units = \"SI\"\n{text}")).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(held(&in_si), held(&with_units));
    assert_eq!((with_units.bare_si, in_si.bare_si), (false, true));
}

#[test]
fn each_bare_number_is_refused_where_the_file_does_not_say_si() {
    let (text, count) = bare(EVERY_KEY);
    let report = parse(&text).expect_err("bare numbers");
    let bare = report.problems.iter().filter(|p| p.message.contains("has no unit")).count();
    // An instant of 0 s needs no unit.
    assert!(bare <= count && bare + 5 >= count, "{bare} of {count}:\n{report}");
    // The way out for a file in SI throughout is said once.
    assert_eq!(report.to_string().matches("units = \"SI\"").count(), 1);
}

#[test]
fn zero_needs_no_unit_and_an_angle_always_does() {
    let corner = EVERY_KEY.replace("at = [\"0 m\", \"1 m\", \"-210 m\"]", "at = [0, 0.0, -0]");
    assert!(parse(&corner).is_ok());
    for head in ["", "units = \"SI\"\n"] {
        for angle in ["42", "0.7", "0"] {
            let source = format!("{head}{EVERY_KEY}")
                .replace("model_x_azimuth = \"30 deg\"", &format!("model_x_azimuth = {angle}"));
            let report = parse(&source).expect_err("an angle without a unit").to_string();
            assert!(report.contains("`model_x_azimuth` has no unit: an angle is expected"), "{report}");
            assert!(!report.contains("at the top of the file"), "{report}");
        }
    }
}

#[test]
fn only_si_can_be_said_and_only_above_all_tables() {
    let other = parse(&format!("units = \"US\"\n{EVERY_KEY}")).expect_err("US units").to_string();
    assert!(other.contains("`units` cannot be \"US\"") && other.contains("write one of \"SI\""), "{other}");
    let within = EVERY_KEY.replace("[initial]", "[initial]\nunits = \"SI\"");
    let within = parse(&within).expect_err("in a table").to_string();
    assert!(within.contains("`units` is no key of `initial`"), "{within}");
    assert!(within.contains("belongs above all tables"), "{within}");
}

#[test]
fn a_law_file_and_a_mesh_of_its_own_say_so_as_well() {
    let law = "size = 0.5\n[material]\nlaw = \"mohr-coulomb\"\nyoung = 1e10\npoisson = 0.25\ncohesion = 2.18e6\n\
               friction_angle = \"42 deg\"\n[material.softening]\nplastic_shear_strain = [0, 0.01]\ncohesion = [2.18e6, 5e5]\n";
    let law_of = |text: &str| LawFile::parse(Path::new("law.toml"), text, MATERIALS);
    let refused = law_of(law).expect_err("bare").to_string();
    for words in ["\"0.5 m\"", "\"10 GPa\"", "\"2.18 MPa\"", "\"500 kPa\""] {
        assert!(refused.contains(words), "{words}: {refused}");
    }
    let in_si = law_of(&format!("units = \"SI\"\n{law}")).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(in_si.parameters.number("cohesion"), Ok(2.18e6));
    let mesh = "[mesh.box]\nx = { to = 4, elements = 2 }\ny = { to = 4, elements = 2 }\nz = { to = 4, elements = 2 }\n";
    let mesh_of = |text: &str| MeshAlone::parse(Path::new("mesh.toml"), text);
    assert!(mesh_of(mesh).expect_err("bare").to_string().contains("write \"4 m\""));
    assert!(mesh_of(&format!("units = \"SI\"\n{mesh}")).is_ok_and(|found| found.is_some()));
}

/// In a file in SI a modulus that no ground has is a slip all the same.
#[test]
fn a_modulus_of_pascals_is_refused_in_si_as_well() {
    let source = format!("units = \"SI\"\n{EVERY_KEY}").replace("young = \"10 GPa\"", "young = 25");
    let report = parse(&source).expect_err("25 Pa").to_string();
    assert!(report.contains("a bare number is in Pa") && report.contains("\"25 GPa\"?"), "{report}");
}
