//! `tremolite list`: laws with their parameters, keys of every interface, quantities.

use std::process::Command;
use tremolite_laws::interfaces::INTERFACES;
use tremolite_laws::materials::MATERIALS;

#[test]
fn list_names_every_parameter_with_its_unit_and_what_stands_for_it() {
    for (what, laws) in [("materials", MATERIALS), ("interfaces", INTERFACES)] {
        let text = list(what);
        for law in laws {
            let (_, part) = text.split_once(&format!("{}: ", law.name)).unwrap();
            let part = part.split("\n\n").next().unwrap();
            // A history may have the name of a table's column.
            let (parameters, history) = part.split_once("  history").unwrap_or((part, ""));
            let line = |lines: &str, name: &str| {
                lines
                    .lines()
                    .map(str::to_owned)
                    .find(|l| l.split_whitespace().next() == Some(name))
                    .unwrap_or_else(|| panic!("{name}"))
            };
            for p in law.parameters {
                let line = line(parameters, p.name);
                assert!(line.contains(p.doc) && line.ends_with(']'), "{line}");
                assert_ne!(line.split_whitespace().nth(1), Some("SI"), "{line}");
            }
            for column in law.history {
                assert!(line(history, column.name).contains(column.doc));
            }
        }
    }
    assert!(list("materials").contains("[default 5 ms]"), "defaults have their units");
}

#[test]
fn list_names_the_keys_of_every_interface_and_the_states() {
    let text = list("interfaces");
    for (name, unit, end) in [
        ("name", "name", "[required]"),
        ("between", "list", "[required]"),
        ("law", "word", "or \"tied\": nothing slides or opens [required]"),
        ("corner", "deg, rad", "[default 45 deg; only where `law` is not \"tied\"]"),
        ("contact_damping", "1", "[default 0.01; only where `law` is not \"tied\"]"),
        ("contact_limit", "1", "[default 0.8; only where `law` is not \"tied\"]"),
        ("viscosity", "1", "[default 0.06; only where `law` is not \"tied\"]"),
    ] {
        let start = format!("    {name:25} {unit:10} ");
        assert!(text.lines().any(|l| l.starts_with(&start) && l.ends_with(end)), "{name}:\n{text}");
    }
    for state in ["    0 bonded ", "    1 stuck ", "    2 sliding ", "    3 open "] {
        assert!(text.contains(state), "{state}");
    }
    let quantities = list("quantities");
    for line in [
        "monitors with `interface`\n    gap ",
        "interfaces.csv",
        "    ever_slid          m2 ",
        "monitors with `bolt`\n    force              N ",
        "bolts.csv, a row for each bolt",
        "    from_head          m ",
    ] {
        assert!(quantities.contains(line), "{line}:\n{quantities}");
    }
}

#[test]
fn list_names_the_keys_of_bolts_and_of_their_bond() {
    let text = list("bolts");
    for (name, unit, end) in [
        ("diameter", "m", "[required]"),
        ("spacing", "m", "[required; only beside `pattern`]"),
        ("young", "Pa", "[default 200 GPa]"),
        ("yield", "Pa", "[left out: never: the steel stays elastic whatever its force]"),
        ("pretension", "N", "[left out: none]"),
        ("strength", "N/m", "without confinement [required]"),
        ("friction_angle", "deg, rad", "[default 0 deg]"),
    ] {
        let start = format!("    {name:25} {unit:10} ");
        assert!(text.lines().any(|l| l.starts_with(&start) && l.ends_with(end)), "{name}:\n{text}");
    }
    assert!(text.contains("    systematic       Crown and walls."), "{text}");
}

fn list(what: &str) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_tremolite")).args(["list", what]).output().unwrap();
    assert!(output.status.success());
    String::from_utf8(output.stdout).unwrap()
}
