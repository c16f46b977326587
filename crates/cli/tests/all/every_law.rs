//! Every law of the program from a file, along a path of strains, or of gaps and slips.

#[path = "../../../laws/tests/all/common/samples.rs"]
#[allow(dead_code)]
pub mod samples;

use crate::law::answer;
use samples::{Columns, Sample, samples};
use tremolite_case::{LawKind, units};
use tremolite_laws::interfaces::INTERFACES;
use tremolite_laws::materials::MATERIALS;
use tremolite_laws::{Kind, LawInfo, Parameter};

/// A number as a user writes it: with the unit of its dimension.
fn number(parameters: &[Parameter], key: &str, x: f64) -> String {
    let Some(Kind::Number(dimension)) = parameters.iter().find(|p| p.name == key).map(|p| p.kind) else {
        panic!("{key} is no number of the law");
    };
    format!("\"{}\"", units::format(x, dimension))
}

fn table(parameters: &[Parameter], key: &str, columns: Columns) -> String {
    let columns = |own: &[Parameter], list: bool| -> Vec<String> {
        let line = |(column, numbers): &(&str, &[f64])| {
            let numbers: Vec<String> = numbers.iter().map(|x| number(own, column, *x)).collect();
            let numbers = numbers.join(", ");
            if list { format!("{column} = [{numbers}]\n") } else { format!("{column} = {numbers}\n") }
        };
        columns.iter().map(line).collect()
    };
    let columns = match parameters.iter().find(|p| p.name == key).map(|p| p.kind) {
        Some(Kind::Table(own)) => columns(own, true),
        Some(Kind::Set(own)) => columns(own, false),
        _ => panic!("{key} is no table of the law"),
    };
    format!("[material.{key}]\n{}", columns.concat())
}

fn file(kind: LawKind, law: &LawInfo, sample: &Sample) -> String {
    let mut text = format!("[{}]\nlaw = \"{}\"\n", kind.word(), law.name);
    for (key, x) in sample.numbers {
        text += &format!("{key} = {}\n", number(law.parameters, key, *x));
    }
    for (key, word) in sample.words {
        text += &format!("{key} = \"{word}\"\n");
    }
    for (key, columns) in sample.tables {
        text += &table(law.parameters, key, columns);
    }
    text
}

const SLIPS: [&str; 2] = ["plastic_shear_displacement", "plastic_tension_displacement"];

/// Drives all samples of all laws along a path of so many rows.
fn follows(kind: LawKind, laws: &[LawInfo], before: &str, path: &str, rows: usize) {
    for law in laws {
        for sample in samples(law.name) {
            let which = format!("{}, {}", law.name, sample.variant);
            let text = before.to_owned() + &file(kind, law, sample);
            let (table, code) = answer(&text, path, &["--divide", "20"]);
            assert_eq!((code, table.rows()), (0, rows), "{which}");
            // Slips are kept where the softening goes by them.
            let slips =
                sample.tables.iter().any(|(_, columns)| columns.iter().any(|(name, _)| SLIPS.contains(name)))
                    || sample.numbers.iter().any(|(name, _)| SLIPS.iter().any(|slip| name.ends_with(slip)));
            for column in law.history.iter().filter(|column| slips || !SLIPS.contains(&column.name)) {
                assert!(table.column(column.name).is_some(), "{which}: {}", column.name);
            }
            assert!(table.values.iter().flatten().all(|x| x.is_finite()), "{which}");
        }
    }
}

#[test]
fn every_material_follows_a_path_of_strains() {
    let path = "time,exx,eyy,ezz,gxy,gyz,gzx\n0,0,0,0,0,0,0\n1,1e-3,-2e-3,1e-3,2e-3,0,1e-3\n";
    follows(LawKind::Material, MATERIALS, "size = \"0.25 m\"\n", path, 21);
}

#[test]
fn every_interface_follows_a_path_of_gaps_and_one_of_pressures() {
    let gaps =
        "time,gap [mm],slip1 [mm],slip2 [mm]\n0,0,0,0\n1,-0.4,0.5,0.1\n2,0.3,-0.5,0.1\n3,-0.2,1,-0.2\n";
    follows(LawKind::Interface, INTERFACES, "", gaps, 61);
    let pressures =
        "time,pressure [MPa],slip1 [mm],slip2 [mm]\n0,0,0,0\n1,3,0.5,0.1\n2,0,-0.5,0.1\n3,30,1,-0.2\n";
    follows(LawKind::Interface, INTERFACES, "", pressures, 61);
}
