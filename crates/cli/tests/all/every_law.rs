//! Every law of the program from a file, along a path of strains.

#[path = "../../../laws/tests/all/common/samples.rs"]
#[allow(dead_code)]
mod samples;

use crate::law::answer;
use samples::{Columns, Sample, samples};
use tremolite_case::units;
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
    let Some(Kind::Table(own)) = parameters.iter().find(|p| p.name == key).map(|p| p.kind) else {
        panic!("{key} is no table of the law");
    };
    let columns = columns.iter().map(|(column, numbers)| {
        let numbers: Vec<String> = numbers.iter().map(|x| number(own, column, *x)).collect();
        format!("{column} = [{}]\n", numbers.join(", "))
    });
    format!("[material.{key}]\n{}", columns.collect::<String>())
}

fn file(law: &LawInfo, sample: &Sample) -> String {
    let mut text = format!("size = \"0.25 m\"\n[material]\nlaw = \"{}\"\n", law.name);
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

#[test]
fn every_law_follows_a_path_of_strains() {
    let path = "time,exx,eyy,ezz,gxy,gyz,gzx\n0,0,0,0,0,0,0\n1,1e-3,-2e-3,1e-3,2e-3,0,1e-3\n";
    for law in MATERIALS {
        for sample in samples(law.name) {
            let which = format!("{}, {}", law.name, sample.variant);
            let (table, code) = answer(&file(law, sample), path, &["--divide", "20"]);
            assert_eq!((code, table.rows()), (0, 21), "{which}");
            for column in law.history {
                assert!(table.column(column.name).is_some(), "{which}: {}", column.name);
            }
            assert!(table.values.iter().flatten().all(|x| x.is_finite()), "{which}");
        }
    }
}
