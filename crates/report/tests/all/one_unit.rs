//! One unit for one quantity over all sections, in the folders that the other tests write.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use tremolite_report::write;
use tremolite_results::{ResultFolder, Summary};

use crate::{bolts, deconvolved, free_field, interface_results, page, spectra, stages};

/// Where moduli, speeds of waves and stiffnesses are, and what others wrote.
const NOT_OF_THE_RUN: [&str; 6] = ["findings", "checks", "model", "materials", "defaults_used", "case"];

/// Units that stand in brackets behind titles, or behind a number, by what they are prefixes of.
fn units(text: &str) -> BTreeMap<&'static str, BTreeSet<String>> {
    let starts = text.split(['(', '\u{a0}']).skip(1);
    let words = starts.filter_map(|from| {
        from.split(|c: char| c.is_whitespace() || "),;:.<>\"，。；：）".contains(c)).next()
    });
    let mut found: BTreeMap<&str, BTreeSet<String>> = BTreeMap::new();
    for word in words {
        let symbols = ["m", "m/s", "m/s²", "Pa", "N", "J"];
        let prefixes = ["", "n", "µ", "m", "c", "k", "M", "G"];
        let symbol =
            symbols.into_iter().find(|symbol| prefixes.iter().any(|p| format!("{p}{symbol}") == word));
        // Metres alone are those of places and sizes.
        if let Some(symbol) = symbol.filter(|_| word != "m") {
            found.entry(symbol).or_default().insert(word.to_owned());
        }
    }
    found
}

/// The sections of a page but those, and its top.
fn shown(page: &str) -> String {
    let (main, _) = page.split_once("</main>").unwrap();
    let mut parts = main.split("<section id=\"");
    let top = parts.next().unwrap().split_once("</style>").unwrap().1;
    let kept = parts.filter(|part| !NOT_OF_THE_RUN.iter().any(|id| part.starts_with(&format!("{id}\""))));
    std::iter::once(top).chain(kept).collect::<Vec<_>>().join(" ")
}

/// A folder for a test to be written into.
type Made = fn(&Path) -> ResultFolder;

#[test]
fn a_quantity_has_one_unit_in_every_section() {
    let shaken_column: Made = |root| {
        let folder = free_field::results(root);
        free_field::motion(&folder);
        let columns: free_field::Columns =
            &[("reference.surface.vx", &free_field::surface), ("reference.base.vx", &free_field::base)];
        free_field::free_field(&folder, columns);
        folder
    };
    // A strong group beside one that hardly carries anything.
    let bolted: Made = |root| {
        let folder = bolts::results(root);
        let mut summary = Summary::read(&folder.summary()).unwrap();
        summary.parts.bolts[0].yield_force = 2.5e6;
        summary.write(&folder.summary()).unwrap();
        folder
    };
    let folders: [(&str, Made, &[&str]); 8] = [
        ("page", page::results, &["m", "Pa", "J", "m/s"]),
        ("bolts", bolted, &["N"]),
        ("interfaces", interface_results::results, &["m", "Pa", "J"]),
        ("stages", |root| stages::example(root, false), &["m", "Pa"]),
        ("stages and an earthquake", |root| stages::example(root, true), &["m", "Pa"]),
        ("free field", shaken_column, &["m/s"]),
        ("spectra", spectra::shaken, &["m/s²"]),
        ("a record of the surface", deconvolved::recorded, &["m/s", "m/s²"]),
    ];
    for (name, make, wanted) in folders {
        let temp = tempfile::tempdir().unwrap();
        let folder = make(temp.path());
        let page = fs::read_to_string(write(folder.root()).unwrap()).unwrap();
        let found = units(&shown(&page));
        for kind in wanted {
            assert!(found.contains_key(kind), "{name} shows {found:?}, but nothing in {kind}");
        }
        for (kind, units) in found {
            assert_eq!(units.len(), 1, "{name}: {kind} in {units:?}");
        }
    }
}
