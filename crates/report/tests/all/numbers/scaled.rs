//! Copies of a result folder in which every number is another, each by a factor of its own.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use serde_json::Value;

use super::field_files::fields;
use super::known::{Content, Kind, factor};
use super::leaves::Leaves;
use super::tables::{listed, table};

/// Writes the copy `copy` of `from` into `to`; 0 is as it was.
pub fn scaled(from: &Path, to: &Path, copy: u64) -> Content {
    let mut content = Content { places: factor(copy, "places"), ..Content::default() };
    fs::create_dir_all(to).unwrap();
    let mut files: Vec<_> = fs::read_dir(from).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    for path in files {
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        let at = to.join(&name);
        if path.is_dir() {
            if !["figures", "checkpoint"].contains(&name.as_str()) {
                fields(&path, &at, &name, copy, &mut content);
            }
        } else if name == "summary.json" {
            let mut summary: Value = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
            let mut leaves = Leaves { copy, content: &mut content, by_name: BTreeMap::new() };
            leaves.scale(&mut summary, &mut Vec::new());
            leaves.over();
            leaves.peaks(&summary);
            let whole = summary["wall_seconds"].as_f64().unwrap_or(f64::NAN).round();
            for (what, part) in
                [("hours", whole / 3600.0), ("minutes", whole / 60.0 % 60.0), ("seconds", whole % 60.0)]
            {
                leaves.know(Kind::Leaf, format!("{what} of wall_seconds"), part.floor());
            }
            fs::write(at, serde_json::to_vec(&summary).unwrap()).unwrap();
        } else if name.ends_with(".csv") {
            fs::write(at, table(&name, &fs::read_to_string(&path).unwrap(), copy, &mut content)).unwrap();
        } else if name.ends_with(".pvd") {
            fs::write(at, listed(&name, &fs::read_to_string(&path).unwrap(), copy, &mut content)).unwrap();
        } else if name == "case.toml" {
            fs::copy(&path, at).unwrap();
        }
    }
    content.names.sort_by_key(|name| std::cmp::Reverse(name.len()));
    content.names.dedup();
    content
}
