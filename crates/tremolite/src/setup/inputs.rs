//! What a run read, with hashes by which one can tell later whether it was the same.

use sha2::{Digest, Sha256};
use std::io::Read;
use std::path::{Path, PathBuf};
use tremolite_case::Case;
use tremolite_results::{Input, Summary};

/// Name of the case among its inputs.
const CASE: &str = "case";

/// The case and the files that it names. A file that cannot be read any more has no hash.
pub fn inputs(case: &Case) -> Vec<Input> {
    let whole = |path: &Path| std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let mut inputs = vec![Input {
        name: CASE.into(),
        path: whole(&case.directory().join(case.path.file_name().unwrap_or_default())).display().to_string(),
        hash: hex(&Sha256::digest(case.source.as_bytes())),
    }];
    for file in case.files() {
        let path = whole(&case.resolve(&file.value));
        let name = file.value.display().to_string();
        if inputs.iter().all(|input| input.name != name) {
            inputs.push(Input {
                name,
                hash: hash(&path).unwrap_or_default(),
                path: path.display().to_string(),
            });
        }
    }
    inputs
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

fn hash(path: &Path) -> std::io::Result<String> {
    let mut file = std::fs::File::open(path)?;
    let (mut hasher, mut buffer) = (Sha256::new(), vec![0; 1 << 16]);
    loop {
        match file.read(&mut buffer)? {
            0 => return Ok(hex(&hasher.finalize())),
            read => hasher.update(&buffer[..read]),
        }
    }
}

/// The folder in which the case of a result folder once lay: from there it names its files. None for a case that is no
/// result folder's.
pub fn original_folder(case: &Path) -> Option<PathBuf> {
    let summary = Summary::read(&case.with_file_name("summary.json")).ok()?;
    let original = summary.inputs.into_iter().find(|input| input.name == CASE)?;
    Some(Path::new(&original.path).parent()?.to_owned())
}

/// Inputs of a result folder's case that are not what that run read, a sentence each.
pub fn changed(case: &Path, now: &[Input]) -> Vec<String> {
    let Ok(summary) = Summary::read(&case.with_file_name("summary.json")) else { return Vec::new() };
    let earlier = |name: &str| summary.inputs.iter().find(|input| input.name == name);
    now.iter()
        .filter(|input| earlier(&input.name).is_some_and(|earlier| earlier.hash != input.hash))
        .map(|input| match input.name.as_str() {
            CASE => "the case is not what that run read".to_owned(),
            name => format!("{name} ({}) is not what that run read: its contents have changed", input.path),
        })
        .collect()
}
