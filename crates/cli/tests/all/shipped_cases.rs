//! The cases that come with the program are accepted as they stand.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Every case under `cases/`, by its path; a folder of laws holds none.
fn cases() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let folders = fs::read_dir(root).unwrap().map(|entry| entry.unwrap().path());
    let files = folders
        .filter(|folder| folder.is_dir() && !folder.ends_with("laws"))
        .flat_map(|folder| fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()));
    // A study is made of a case and is none.
    let is_study =
        |file: &PathBuf| fs::read_to_string(file).unwrap().lines().any(|line| line.starts_with("case "));
    let mut cases: Vec<PathBuf> =
        files.filter(|file| file.extension().is_some_and(|e| e == "toml") && !is_study(file)).collect();
    cases.sort();
    cases
}

/// Accepted by `check`, with one level of steps: the proof of levels takes most of the time, and quick.toml runs with them elsewhere. The hall
/// to which water flows, in three stages, is one element long.
fn is_accepted(case: &Path) {
    let mut check = Command::new(env!("CARGO_BIN_EXE_tremolite"));
    check.args(["check", "--set", "dynamic.levels=1"]);
    if case.parent().is_some_and(|folder| folder.ends_with("wet-hall")) {
        for key in ["size_near", "length", "size_along"] {
            check.arg("--set").arg(format!("mesh.caverns.{key}=\"1.2 m\""));
        }
    }
    let done = check.arg(case).output().unwrap();
    let told = String::from_utf8_lossy(&done.stderr);
    assert!(done.status.success(), "{}: {told}", case.display());
}

/// The one of 97,000 elements, apart so that it goes beside the others.
const FULL: &str = "yingxiuwan/case.toml";

#[test]
fn every_case_is_accepted() {
    let cases = cases();
    for name in ["first-shake/case.toml", FULL, "yingxiuwan/quick.toml"] {
        assert!(cases.iter().any(|case| case.ends_with(name)), "{name}");
    }
    cases.iter().filter(|case| !case.ends_with(FULL)).for_each(|case| is_accepted(case));
}

#[test]
fn the_full_case_is_accepted() {
    let full = cases().into_iter().find(|case| case.ends_with(FULL)).unwrap();
    is_accepted(&full);
}
