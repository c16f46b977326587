//! The tables of keys against what is read.

use std::collections::BTreeSet;

use toml::de::{DeTable, DeValue};
use tremolite_laws::materials::MATERIALS;

use super::*;
use crate::fields::reads;
use crate::keys::Need;
use crate::suggest;

const EVERY_KEY: &str = include_str!("../../tests/cases/every-key.toml");

fn all_tables() -> Vec<&'static Table> {
    let mut tables: Vec<&'static Table> = vec![&CASE];
    let mut next = 0;
    while next < tables.len() {
        let found = tables[next].keys.iter().flat_map(|k| suggest::tables(&k.kind));
        tables.extend(found.collect::<Vec<_>>());
        next += 1;
    }
    tables
}

/// Cases that together use every kind of mesh, initial stress, motion, window and base.
fn cases() -> Vec<String> {
    let (before, rest) = EVERY_KEY.split_once("[mesh.caverns]").expect("a mesh of caverns");
    let (_, after) = rest.split_once("[material.rock]").expect("a material");
    let with_stress = |stress: &str| EVERY_KEY.replace("lateral = { x = 0.8, y = 1.2 }", stress);
    let with_mesh = |mesh: &str| format!("{before}{mesh}\n[material.rock]{after}");
    let axis = "{ from = \"-1 m\", to = \"1 m\", elements = 3, growth = 1.1 }";
    let (head, rest) = EVERY_KEY.split_once("east = {").expect("a component");
    let (_, tail) = rest.split_once("process").expect("processing");
    let (with_motion, rest) = EVERY_KEY.split_once("kind = \"within\"").expect("a motion");
    let (_, component) = rest.split_once("\neast = ").expect("a component");
    let (component, dynamic) = component.split_once("[dynamic]").expect("boundaries");
    let with_waves =
        |waves: &str| format!("{with_motion}kind = \"outcrop\"\neast = {component}{waves}[dynamic]{dynamic}");
    vec![
        EVERY_KEY.to_owned(),
        with_mesh(&format!(
            "[mesh.box]\nx = {axis}\ny = {axis}\nz = {axis}\ngroup = \"soil\"\npart = [{{ group = \"notch\", x = [0, \"1 m\"], y = [\"-1 m\", \"1 m\"], z = [\"-1 m\", 0] }}]"
        )),
        with_mesh("[mesh.file]\npath = \"site.msh\"\nunit = \"1 mm\"\nrotate = \"20 deg\""),
        with_stress(
            "stress = { at = [\"1 m\", \"2 m\", \"3 m\"], zz = \"-1 MPa\", gradient = { zz = \"27 kN/m3\" } }",
        ),
        with_stress(
            "measured = [{ at = [0, 0, \"3 m\"], xx = \"1 Pa\", yy = \"2 Pa\", zz = \"3 Pa\", xy = 0, yz = 0, zx = 0 }]",
        ),
        EVERY_KEY.replace(
            "points = [[[\"0 m\", \"1 m\", \"-210 m\"], [0, \"1 m\", \"-204.5 m\"]]]",
            "file = \"bolts.csv\"",
        ),
        EVERY_KEY
            .replace(
                "[material.rock]",
                "[material.clay]\nlaw = \"mohr-coulomb\"\nyoung = \"1 GPa\"\npoisson = 0.3\ndensity = \"2.2 t/m3\"\n\
                 cohesion = \"0.1 MPa\"\nfriction_angle = \"20 deg\"\n[material.rock]",
            )
            .replace("extent = \"80 m\"", "seam = { material = \"clay\", thickness = \"0.1 m\" }"),
        EVERY_KEY
            .replace("[material.rock]", "[water]\nlevel = \"3 m\"\n[material.rock]\nwater = { biot = 0.9 }")
            .replacen("[[stage]]", "[[stage]]\nwater = { level = \"1 m\", filled = { \"top\" = \"2 m\" } }", 1)
            .replacen("[[interface]]", "[[interface]]\nwater = { drained = true }", 1),
        EVERY_KEY
            .replace(
                "[material.rock]",
                "[water]\nlevel = \"3 m\"\npressure = \"seepage\"\nheads = { sides = \"3 m\" }\n[material.rock]\n\
                 water = { hydraulic_conductivity = \"1e-7 m/s\" }",
            )
            .replacen(
                "[[stage]]",
                "[[stage]]\nwater = { heads = { top = \"9 m\" }, drained = [\"a\"], drains = [{ on = \"a\" }, \
                 { from = [\"0 m\", \"1 m\", \"2 m\"], to = [\"0 m\", \"1 m\", \"9 m\"] }] }",
                1,
            ),
        EVERY_KEY
            .replace("kind = \"within\"\ndepth = \"50 m\"", "kind = \"surface\"")
            .replace(
                "unit_weight = \"19 kN/m3\", damping = 0.05",
                "unit_weight = \"19 kN/m3\", darendeli = { plasticity_index = 15, stress = \"50 kPa\" }",
            )
            .replace(
                "damping = \"2 %\"",
                "curves = { strain = [1e-5, 1e-4], modulus = [1.0, 0.8], damping = [0.01, 0.03] }",
            )
            .replace("target = { period = [\"0.1 s\", \"0.5 s\"], sa = [\"5 m/s2\", \"2 m/s2\"] }", "target = { file = \"code.csv\" }"),
        format!("{head}file = \"a.V2A\"\nwindow = {{ strongest = \"12 s\" }}\nprocess{tail}"),
        with_waves(
            "[[motion.wave]]\ntype = \"SV\"\nangle = \"20 deg\"\nazimuth = \"30 deg\"\ncomponent = \"east\"\nscale = 0.5\nsurface_component = \"up\"\n\
             [[motion.wave]]\ntype = \"SH\"\nangle = \"0 deg\"\nazimuth = \"0 deg\"\ncomponent = \"north\"\n\
             [[motion.wave]]\ntype = \"P\"\nangle = \"0 deg\"\nazimuth = \"0 deg\"\ncomponent = \"up\"\n",
        ),
    ]
}

#[test]
fn every_key_of_the_tables_is_read() {
    reads::take();
    for case in cases() {
        if let Err(report) = Case::parse(Path::new("every-key.toml"), &case, MATERIALS) {
            panic!("{report}");
        }
    }
    let read = reads::take();
    // The law's parameters are read by the list of its parameters.
    let listed: BTreeSet<(&str, &str)> =
        all_tables().iter().flat_map(|t| t.keys.iter().map(|k| (t.path, k.name))).collect();
    assert_eq!(read, listed);
}

#[test]
fn every_default_is_a_good_value_of_its_key() {
    for table in all_tables() {
        for key in table.keys {
            let (Need::Default(text) | Need::RequiredBeside(_, text)) = key.need else { continue };
            let value = DeValue::parse(text).unwrap_or_else(|e| panic!("{}: {e}", key.name));
            let mut checker = Checker::new(&CASE, MATERIALS.into(), &DeTable::new());
            assert!(checker.value(&key.kind, value.get_ref(), 0..0, key.name).is_some(), "{}", key.name);
            assert_eq!(checker.problems, []);
        }
    }
}

#[test]
fn every_key_has_a_doc_and_stands_once() {
    for table in all_tables() {
        let names: BTreeSet<&str> = table.keys.iter().map(|k| k.name).collect();
        assert_eq!(names.len(), table.keys.len(), "{}", table.path);
        for key in table.keys {
            assert!(key.doc.len() > 5, "{}.{}", table.path, key.name);
        }
        for name in table.choice.iter().flat_map(|g| g.iter()) {
            assert!(names.contains(name), "{}.{name}", table.path);
        }
    }
}

#[test]
fn a_law_from_outside_the_list_brings_its_own_keys() {
    use tremolite_laws::parameter::{BadParameter, Dimension, Kind, LawInfo, Need, Parameter};
    const PARAMETERS: &[Parameter] = &[
        Parameter {
            name: "stickiness",
            kind: Kind::Number(Dimension::PRESSURE),
            need: Need::Required,
            doc: "k",
        },
        Parameter {
            name: "tilt",
            kind: Kind::Number(Dimension::ANGLE),
            need: Need::Number(0.5),
            doc: "tilt",
        },
        Parameter {
            name: "mood",
            kind: Kind::Word(&["calm", "wild"]),
            need: Need::Word("calm"),
            doc: "mood",
        },
        Parameter {
            name: "spare",
            kind: Kind::Number(Dimension::NONE),
            need: Need::Optional("unused"),
            doc: "x",
        },
    ];
    let glue = LawInfo {
        name: "glue",
        summary: "",
        source: "",
        parameters: PARAMETERS,
        history: &[],
        pressure_dependent: false,
        damages: false,
        chosen: |values, _| values.clone(),
        check: |values| match values.number("stickiness") {
            Ok(k) if k > 1e6 => Err(vec![BadParameter::new("stickiness", "is too sticky", "thin it")]),
            _ => Ok(()),
        },
    };
    let source = EVERY_KEY.replace(
        "law = \"elastic\"\nyoung = \"10 GPa\"\npoisson = 0.25",
        "law = \"glue\"\nstickiness = \"7 kPa\"",
    );
    let laws = [MATERIALS[0], glue];
    let case = Case::parse(Path::new("glue.toml"), &source, &laws).unwrap_or_else(|e| panic!("{e}"));
    let values = &case.materials[0].parameters;
    assert_eq!(values.number("stickiness"), Ok(7000.0));
    assert_eq!(values.number("tilt"), Ok(0.5));
    assert_eq!(values.word("mood"), Some("calm"));
    assert_eq!(values.optional("spare"), None);
    let defaulted: Vec<(&str, &str)> =
        case.defaulted.iter().map(|d| (d.key.as_str(), d.value.as_str())).collect();
    assert!(defaulted.contains(&("material.rock.tilt", "28.6479 deg")), "{defaulted:?}");
    assert!(defaulted.contains(&("material.rock.mood", "calm")));
    assert!(defaulted.contains(&("material.rock.spare", "unused")));

    let source = source.replace("\"7 kPa\"", "\"7 GPa\"");
    let report = Case::parse(Path::new("glue.toml"), &source, &laws).expect_err("too sticky");
    let [problem] = &report.problems[..] else { panic!("{report}") };
    assert_eq!(&source[problem.span.clone()], "\"7 GPa\"");
    assert_eq!(
        (problem.message.as_str(), problem.remedy.as_str()),
        ("`stickiness` is too sticky", "thin it")
    );
}
