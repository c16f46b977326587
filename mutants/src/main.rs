//! Builds changes that cargo-mutants lists into the sources themselves, each behind a switch that is asked while the program runs.
//!
//! ```text
//! tremolite-mutants ROOT [COPY] < LIST
//! ```
//!
//! LIST is what `cargo mutants --list --json` prints, with a `switch` (a number from 1) of those that are wanted. Writes the files of ROOT that are changed to COPY, where
//! they are not there as they are to be. Without COPY it writes the numbers of those that cannot be switched, one a line: what a constant, the length of an array, a `const fn`
//! or a condition with a `let` is made of, and fields left out of a literal.

mod changed;
mod places;

use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;

/// A place in a file, from 1.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, PartialOrd, Ord)]
pub struct At {
    pub line: usize,
    pub column: usize,
}

#[derive(Clone, Copy, Debug, Deserialize)]
pub struct Span {
    pub start: At,
}

/// A change as cargo-mutants tells of it.
#[derive(Clone, Debug, Deserialize)]
pub struct Mutant {
    pub switch: Option<u32>,
    pub file: String,
    pub genre: String,
    pub span: Span,
    pub replacement: String,
}

fn main() -> Result<(), String> {
    let root = std::env::args().nth(1).ok_or("usage: tremolite-mutants ROOT [COPY] < LIST")?;
    let copy = std::env::args().nth(2);
    let all: Vec<Mutant> = serde_json::from_reader(std::io::stdin()).map_err(|e| format!("the list: {e}"))?;
    let mut of_files: BTreeMap<String, Vec<Mutant>> = BTreeMap::new();
    for mutant in all.into_iter().filter(|mutant| mutant.switch.is_some()) {
        of_files.entry(mutant.file.clone()).or_default().push(mutant);
    }
    // Where the switches are asked for.
    of_files.entry(ASKED_IN.to_owned()).or_default();
    for (file, mutants) in of_files {
        let path = Path::new(&root).join(&file);
        let told = |e: &dyn std::fmt::Display| format!("{}: {e}", path.display());
        let text = std::fs::read_to_string(&path).map_err(|e| told(&e))?;
        let places = places::of(&text).map_err(|e| told(&e))?;
        let Some(copy) = copy.as_deref().map(Path::new) else {
            let left = mutants.iter().filter(|mutant| changed::place(&places, mutant).is_none());
            left.filter_map(|mutant| mutant.switch).for_each(|switch| println!("{switch}"));
            continue;
        };
        let asks = if file.starts_with("crates/laws/") { "crate" } else { "tremolite_laws" };
        let mut changed = changed::changed(&text, &places, &mutants, &format!("{asks}::mutant::on"));
        if file == ASKED_IN {
            changed.push_str("\n#[doc(hidden)]\npub mod mutant;\n");
            put(&copy.join("crates/laws/src/mutant.rs"), include_str!("switch.rs"))?;
        }
        put(&copy.join(&file), &changed)?;
    }
    Ok(())
}

const ASKED_IN: &str = "crates/laws/src/lib.rs";

/// A file that is as it is to be keeps its time, and nothing is built again for it.
fn put(path: &Path, text: &str) -> Result<(), String> {
    if std::fs::read_to_string(path).is_ok_and(|old| old == text) {
        return Ok(());
    }
    let told = |e: std::io::Error| format!("{}: {e}", path.display());
    path.parent().map_or(Ok(()), std::fs::create_dir_all).map_err(told)?;
    std::fs::write(path, text).map_err(told)
}
