//! Every text of the page has a Chinese pattern with the same slots, and no Chinese pattern is left over.
//!
//! Texts are the patterns of `say!` (the page's own) and `said!` (those of `summary.json`), and `t('…')` in the template.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Write;
use std::path::Path;

use proc_macro2::{TokenStream, TokenTree};
use tremolite_report::chinese::TABLES;
use tremolite_report::chinese::materials::LAWS;

/// The first text in the brackets of every `say!` and `said!`, whatever they stand in.
fn spoken(tokens: TokenStream, found: &mut Vec<String>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (k, token) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = token else { continue };
        let named = k >= 2
            && matches!(&tokens[k - 1], TokenTree::Punct(p) if p.as_char() == '!')
            && matches!(&tokens[k - 2], TokenTree::Ident(i) if i == "say" || i == "said");
        if named {
            let text = group.stream().into_iter().find_map(|token| match token {
                TokenTree::Literal(literal) => syn::parse_str::<syn::LitStr>(&literal.to_string()).ok(),
                _ => None,
            });
            found.extend(text.map(|text| text.value()));
        }
        spoken(group.stream(), found);
    }
}

/// The texts of all `t('…')` of a template.
fn asked(template: &str) -> impl Iterator<Item = String> {
    template.split("t('").skip(1).filter_map(|rest| Some(rest.split_once("')")?.0.to_owned()))
}

fn sources(folder: &Path, found: &mut BTreeMap<String, String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.insert(path.display().to_string(), fs::read_to_string(&path).unwrap());
        }
    }
}

fn slots(pattern: &str) -> BTreeSet<&str> {
    pattern.split('{').skip(1).filter_map(|rest| Some(rest.split_once('}')?.0)).collect()
}

/// Pattern → one of the files that have it.
fn patterns() -> BTreeMap<String, String> {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut files = BTreeMap::new();
    sources(&crates.join("report/src"), &mut files);
    sources(&crates.join("tremolite/src"), &mut files);
    sources(&crates.join("study/src"), &mut files);
    sources(&crates.join("results/src/assessment"), &mut files);
    let assessment = crates.join("results/src/assessment.rs");
    files.insert(assessment.display().to_string(), fs::read_to_string(&assessment).unwrap());
    let mut patterns = BTreeMap::new();
    for (file, text) in files {
        let mut found = Vec::new();
        spoken(text.parse().unwrap_or_else(|e| panic!("{file}: {e}")), &mut found);
        patterns.extend(found.into_iter().map(|pattern| (pattern, file.clone())));
    }
    for name in ["report.html", "compare.html", "study.html"] {
        let template = crates.join("report/template").join(name);
        let text = fs::read_to_string(&template).unwrap();
        patterns.extend(asked(&text).map(|pattern| (pattern, template.display().to_string())));
    }
    patterns
}

/// Set by the checks before a release.
const RELEASE: &str = "TREMOLITE_RELEASE";

/// Warns of what has no Chinese yet, which stands in English on the page; only before a release nothing may lack it.
pub fn lacking(missing: &[String]) {
    let text = missing.join("\n");
    assert!(missing.is_empty() || std::env::var_os(RELEASE).is_none(), "{text}");
    if !missing.is_empty() {
        // Not by eprintln, which tests that pass keep to themselves.
        let mut beside = std::io::stderr();
        writeln!(beside, "warning: {text}").unwrap();
    }
}

#[test]
fn every_text_has_a_chinese_one_with_the_same_slots() {
    let chinese: BTreeMap<&str, &str> = TABLES.iter().flat_map(|table| table.iter().copied()).collect();
    let (mut faults, mut missing) = (Vec::new(), Vec::new());
    for (pattern, file) in patterns() {
        match chinese.get(pattern.as_str()) {
            None => missing.push(format!("{file}: no Chinese for \"{pattern}\"")),
            Some(text) if slots(text) != slots(&pattern) => {
                faults.push(format!("{file}: other slots in \"{pattern}\" and \"{text}\""));
            }
            Some(_) => {}
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    lacking(&missing);
}

#[test]
fn no_chinese_text_is_left_over_or_given_twice() {
    let patterns = patterns();
    let mut seen = BTreeSet::new();
    // Those of laws are looked up beside the laws.
    let of_law = |english: &str| LAWS.iter().any(|(known, _)| *known == english);
    for (english, _) in TABLES.iter().flat_map(|table| table.iter()) {
        assert!(patterns.contains_key(*english) || of_law(english), "nothing says \"{english}\" any more");
        assert!(seen.insert(english), "\"{english}\" stands twice");
    }
}

#[test]
fn texts_are_found_wherever_they_stand() {
    let source = r#"fn f() { vec![say!(self.language, "a {b} \
        c", b = g(said!("inner")))] }"#;
    let mut found = Vec::new();
    spoken(source.parse().unwrap(), &mut found);
    assert_eq!(found, ["a {b} c", "inner"]);
    assert_eq!(asked("{{ t('one') }} {{ t('two') | f }}").collect::<Vec<_>>(), ["one", "two"]);
}
