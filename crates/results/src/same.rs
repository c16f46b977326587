//! Whether two runs have the same results, bit by bit.

use crate::Error;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Files and folders of a result folder that may differ between runs of the same bits: what was written when the clock said so, what was
/// said, and the page, which is made of all else and says when, where and how long.
pub const OTHER_FILES: [&str; 5] = ["SHA256SUMS", "checkpoint", "log.txt", "report.html", "run.lock"];
/// What may differ of summary.json: the clock, host and program, ranks and threads, and how often the run was taken up again.
pub const OTHER_FACTS: [&str; 3] = ["wall_seconds", "element_updates_per_second", "run"];

/// What differs between two result folders beyond what may: files by their paths, and facts of summary.json.
///
/// # Errors
/// [`Error::Io`] if a file cannot be read.
pub fn differences(one: &Path, other: &Path) -> Result<Vec<String>, Error> {
    let [one, other] = [files(one)?, files(other)?];
    let mut found = Vec::new();
    for path in one.keys().chain(other.keys().filter(|path| !one.contains_key(*path))) {
        let name = path.display();
        match (one.get(path), other.get(path)) {
            (Some(a), Some(b)) if a == b => {}
            (Some(a), Some(b)) if path.as_os_str() == "summary.json" => found.extend(facts(a, b)),
            (Some(_), Some(_)) => found.push(name.to_string()),
            _ => found.push(format!("{name}, which one has")),
        }
    }
    Ok(found)
}

fn files(folder: &Path) -> Result<BTreeMap<PathBuf, Vec<u8>>, Error> {
    let mut files = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in std::fs::read_dir(&next).map_err(Error::io(&next, "read"))? {
            let path = entry.map_err(Error::io(&next, "read"))?.path();
            let name = path.strip_prefix(folder).unwrap_or(&path).to_owned();
            if OTHER_FILES.iter().any(|other| name.as_os_str() == *other) {
                continue;
            }
            if path.is_dir() {
                folders.push(path);
            } else {
                let bytes = std::fs::read(&path).map_err(Error::io(&path, "read"))?;
                files.insert(name, bytes);
            }
        }
    }
    Ok(files)
}

/// Facts that differ between two summaries.
fn facts(one: &[u8], other: &[u8]) -> Vec<String> {
    let read = |bytes: &[u8]| serde_json::from_slice::<Value>(bytes).unwrap_or_default();
    let [one, other] = [read(one), read(other)];
    let (Some(one), Some(other)) = (one.as_object(), other.as_object()) else {
        return vec!["summary.json".into()];
    };
    let keys = one.keys().chain(other.keys().filter(|key| !one.contains_key(*key)));
    let differ = keys.filter(|key| !OTHER_FACTS.contains(&key.as_str()) && one.get(*key) != other.get(*key));
    differ.map(|key| format!("summary.json: {key}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_the_same_but_for_clocks_and_machines() {
        let folders = [(); 2].map(|()| tempfile::tempdir().unwrap());
        let [one, other] = folders.each_ref().map(|folder| folder.path());
        let write = |folder: &Path, name: &str, text: &str| {
            let path = folder.join(name);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        };
        for (folder, seconds) in [(one, "1.5"), (other, "2.5")] {
            write(folder, "fields/a.vtu", "1");
            write(folder, "log.txt", seconds);
            write(folder, "checkpoint/state.bin", seconds);
            write(
                folder,
                "summary.json",
                &format!("{{\"wall_seconds\":{seconds},\"run\":{{\"threads\":{seconds}}},\"steps\":3}}"),
            );
        }
        assert!(differences(one, other).unwrap().is_empty());
        write(other, "fields/a.vtu", "2");
        write(other, "fields/b.vtu", "2");
        write(other, "summary.json", "{\"steps\":4}");
        let found = differences(one, other).unwrap();
        assert_eq!(found, ["fields/a.vtu", "summary.json: steps", "fields/b.vtu, which one has"]);
        assert!(differences(one, &other.join("none")).is_err());
    }
}
