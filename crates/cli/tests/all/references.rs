//! Every reference key in the repository is in references.bib, and every entry there is used.
//!
//! A key is a name in small letters and a year (`pekeris1955`), wherever it stands as a word of its own. A source may
//! also be cited by name and year, as in 'Pekeris (1955)': that uses the entry of the same name and year.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use tremolite_laws::interfaces::INTERFACES;
use tremolite_laws::materials::MATERIALS;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// Files below a folder with one of these endings.
fn files(folder: &Path, endings: &[&str], found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display())) {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files(&path, endings, found);
        } else if path.extension().is_some_and(|e| endings.iter().any(|ending| e == *ending)) {
            found.push(path);
        }
    }
}

/// The documents and sources that may cite.
fn sources() -> Vec<(PathBuf, String)> {
    let mut found = Vec::new();
    for folder in ["crates", "cases", "docs"] {
        files(&root().join(folder), &["rs", "md", "toml"], &mut found);
    }
    for entry in fs::read_dir(root()).unwrap() {
        found.extend(Some(entry.unwrap().path()).filter(|p| p.extension().is_some_and(|e| e == "md")));
    }
    // This file speaks of keys without citing.
    found.retain(|path| !path.ends_with("cli/tests/all/references.rs"));
    found.into_iter().map(|path| (path.clone(), read(&path))).collect()
}

/// Whether a word is a name in small letters and a year, with at most one small letter behind.
fn is_key(word: &str) -> bool {
    let (name, rest) = word.split_at(word.find(|c: char| !c.is_ascii_lowercase()).unwrap_or(word.len()));
    let year = rest.get(..4).and_then(|y| y.parse::<u32>().ok());
    let letter = rest.get(4..).unwrap_or_default();
    name.len() >= 2
        && year.is_some_and(|y| (1800..2100).contains(&y))
        && letter.len() <= 1
        && letter.chars().all(|c| c.is_ascii_lowercase())
}

/// The keys in a text, as words of their own.
fn keys_in(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_')).filter(|word| is_key(word))
}

fn bibliography() -> BTreeSet<String> {
    let text = read(&root().join("references.bib"));
    let mut keys = BTreeSet::new();
    for line in text.lines().filter(|line| line.starts_with('@')) {
        let key = line.split_once('{').and_then(|(_, rest)| rest.strip_suffix(',')).unwrap_or_default();
        assert!(is_key(key), "references.bib: '{line}' has no key of a name in small letters and a year");
        assert!(keys.insert(key.to_owned()), "references.bib: {key} is there twice");
    }
    assert!(!keys.is_empty());
    keys
}

/// Small letters without accents and spaces, so that 'La Borderie' is `laborderie` and 'Bažant' `bazant`.
fn folded(text: &str) -> String {
    let plain = |c: char| match c {
        'é' | 'è' | 'ě' => 'e',
        'ž' => 'z',
        'ü' => 'u',
        'ö' => 'o',
        other => other,
    };
    text.to_lowercase().chars().filter(|c| !c.is_whitespace()).map(plain).collect()
}

#[test]
fn every_key_is_in_the_bibliography() {
    let known = bibliography();
    let mut unknown = Vec::new();
    for (path, text) in sources() {
        for (number, line) in text.lines().enumerate() {
            for key in keys_in(line).filter(|key| !known.contains(*key)) {
                unknown.push(format!("{}:{}: {key}", path.display(), number + 1));
            }
        }
    }
    assert!(unknown.is_empty(), "not in references.bib:\n{}", unknown.join("\n"));
}

#[test]
fn every_entry_of_the_bibliography_is_used() {
    let lines: Vec<String> = sources().iter().flat_map(|(_, text)| text.lines().map(folded)).collect();
    let cited = |key: &str| {
        let at = key.find(|c: char| c.is_ascii_digit()).unwrap_or(key.len());
        let (name, year) = (&key[..at], &key[at..at + 4]);
        lines.iter().any(|line| line.contains(key) || (line.contains(name) && line.contains(year)))
    };
    let unused: Vec<String> = bibliography().into_iter().filter(|key| !cited(key)).collect();
    assert!(unused.is_empty(), "in references.bib, but cited nowhere: {}", unused.join(", "));
}

#[test]
fn every_law_names_its_source_by_key() {
    let known = bibliography();
    for law in MATERIALS.iter().chain(INTERFACES) {
        assert!(
            keys_in(law.source).any(|key| known.contains(key)),
            "{}: no key in '{}'",
            law.name,
            law.source
        );
    }
}

#[test]
fn every_path_in_the_documents_exists() {
    let mut missing = Vec::new();
    for name in ["README.md", "ARCHITECTURE.md", "NOTATION.md", "CONTRIBUTING.md", "docs/laws.md"] {
        let text = read(&root().join(name));
        // Between backticks, and behind `](`.
        let quoted = text.split('`').skip(1).step_by(2);
        let linked =
            text.split("](").skip(1).filter_map(|rest| rest.split_once(')')).map(|(target, _)| target);
        for path in quoted.chain(linked) {
            let first = path.split('/').next().unwrap_or_default();
            let wanted =
                ["crates", "cases", "docs", ".ci"].contains(&first) && !path.contains([' ', '*', '<']);
            if (wanted || path.ends_with(".md") || path.starts_with("LICENSE")) && !root().join(path).exists()
            {
                missing.push(format!("{name}: {path}"));
            }
        }
    }
    assert!(missing.is_empty(), "named, but not there:\n{}", missing.join("\n"));
}

#[test]
fn keys_are_told_from_other_words() {
    for key in ["wang2018", "mc2010", "smith1961b"] {
        assert!(is_key(key), "{key}");
    }
    for word in [
        "n2000",
        "Wang2018",
        "x86",
        "20161113",
        "avx512",
        "mow_pao_1971",
        "wang20181",
        "wang2018bc",
        "sha256",
    ] {
        assert!(!is_key(word), "{word}");
    }
}
