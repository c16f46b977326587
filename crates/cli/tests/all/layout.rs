//! The tests of a crate are one binary, and none of their files is left out of it.

use std::fs;
use std::path::Path;

/// Names of the Rust files of a folder, without their ending.
fn rust_files(folder: &Path) -> Vec<String> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter_map(|name| name.strip_suffix(".rs").map(str::to_owned))
        .collect()
}

#[test]
fn every_file_of_tests_is_a_module_of_its_crates_one_binary() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut binaries = 0;
    for folder in fs::read_dir(crates).unwrap().map(|entry| entry.unwrap().path().join("tests")) {
        if !folder.exists() {
            continue;
        }
        let main = fs::read_to_string(folder.join("all/main.rs")).unwrap_or_default();
        binaries += 1;
        let beside = rust_files(&folder);
        assert!(beside.is_empty(), "{}: {beside:?} belong in the folder all", folder.display());
        for name in rust_files(&folder.join("all")).iter().filter(|name| *name != "main") {
            let has = main.lines().any(|line| line == format!("mod {name};"));
            assert!(has, "{}: all/main.rs has no `mod {name};`, so its tests do not run", folder.display());
        }
    }
    assert!(binaries >= 9, "{binaries}");
}
