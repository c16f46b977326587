//! What a run read, with hashes by which one can tell later whether it was the same.

use super::memory::Inputs;
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};
use tremolite_case::Case;
use tremolite_results::checksums::{hash, hex};
use tremolite_results::{Input, Summary};

/// Name of the case among its inputs.
const CASE: &str = "case";

/// The case and what it names. A file that cannot be read any more has no hash; what is in memory has no path.
pub fn inputs(case: &Case, held: &Inputs) -> Vec<Input> {
    let whole = |path: &Path| std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let mut inputs = vec![Input {
        name: CASE.into(),
        path: whole(&case.directory().join(case.path.file_name().unwrap_or_default())).display().to_string(),
        hash: hex(&Sha256::digest(case.source.as_bytes())),
    }];
    for file in case.files() {
        let name = file.value.display().to_string();
        if inputs.iter().any(|input| input.name == name) {
            continue;
        }
        inputs.push(match held.contents(&file.value) {
            Some(contents) => Input { name, hash: hex(&contents.finalize()), path: String::new() },
            None => {
                let path = whole(&case.resolve(&file.value));
                let hash = hash(&path).unwrap_or_default();
                Input { name, hash, path: path.display().to_string() }
            }
        });
    }
    inputs
}

/// The folder in which the case of a result folder once lay: from there it names its files. None for a case that is no
/// result folder's.
pub fn original_folder(case: &Path) -> Option<PathBuf> {
    let summary = Summary::read(&case.with_file_name("summary.json")).ok()?;
    let original = summary.case.inputs.into_iter().find(|input| input.name == CASE)?;
    Some(Path::new(&original.path).parent()?.to_owned())
}

/// Inputs of a result folder's case that are not what that run read, a sentence each.
pub fn changed(case: &Path, now: &[Input]) -> Vec<String> {
    let Ok(summary) = Summary::read(&case.with_file_name("summary.json")) else { return Vec::new() };
    let earlier = |now: &Input| summary.case.inputs.iter().find(|input| input.name == now.name);
    let sentence = |now: &Input| {
        let earlier = earlier(now).filter(|earlier| earlier.hash != now.hash)?;
        let name = &now.name;
        Some(match (earlier.path.is_empty(), now.path.is_empty()) {
            _ if name == CASE => "the case is not what that run read".to_owned(),
            (false, false) => {
                format!("{name} ({}) is not what that run read: its contents have changed", now.path)
            }
            (true, true) => format!("{name} is not what that run had in memory: its contents have changed"),
            // One is hashed by its bytes, the other by its numbers.
            (true, false) => format!("{name} ({}) may not be what that run had in memory", now.path),
            (false, true) => format!("{name}, which is in memory, may not be what that run read"),
        })
    };
    now.iter().filter_map(sentence).collect()
}
