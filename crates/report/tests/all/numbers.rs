//! Every number on the page stands in a file: with other numbers in the files, each by a factor of its own, each number of
//! the page is another, and still that of its file in the unit shown.

mod scaled;
mod sources;
mod tokens;

use std::path::Path;

use tremolite_report::Language;

use self::scaled::Kind;
use self::sources::{Pages, Source};
use super::{bolts, free_field, interface_results, maps, page, report, spectra, stages};

/// By how much numbers are scaled at most, up and down.
const SPREAD: f64 = 0.04;

fn survey(root: &Path) {
    let pages = Pages::of(root, 8, Language::English);
    let mut counts = std::collections::BTreeMap::<String, usize>::new();
    for k in 0..pages.tokens.len() {
        let source = pages.source(k);
        let token = &pages.tokens[k];
        let kind = match &source {
            Source::In(kind, _) => format!("{kind:?}"),
            other => format!("{other:?}").split('(').next().unwrap().to_owned(),
        };
        *counts.entry(kind).or_default() += 1;
        match source {
            Source::Zero | Source::In(Kind::Leaf, _) => {}
            other => println!("{other:?}\n     {}", token.told()),
        }
    }
    println!("{counts:?}");
}

#[test]
#[ignore = "of a folder in TREMOLITE_RESULTS"]
fn numbers_of_a_real_run() {
    survey(Path::new(&std::env::var("TREMOLITE_RESULTS").unwrap()));
}

#[test]
fn survey_of_made_up_folders() {
    let which = std::env::var("WHICH").unwrap_or_default();
    let temp = tempfile::tempdir().unwrap();
    match which.as_str() {
        "stages" => drop(stages::example(temp.path(), true)),
        "bolts" => drop(bolts::results(temp.path())),
        "interfaces" => drop(interface_results::results(temp.path())),
        "page" => drop(page::results(temp.path())),
        _ => drop(report::results(temp.path(), &["A", "B"])),
    }
    survey(temp.path());
}
