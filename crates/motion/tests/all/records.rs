//! Where real records lie that tests read.
//!
//! Most networks do not allow copies of their files. Tests of such files look for them in the folder that the environment variable
//! `TREMOLITE_RECORDS` names and are skipped, with a message, where there is none.

use std::path::{Path, PathBuf};

/// A record of the repository.
pub fn shipped(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/records").join(name)
}

/// A record that may not be shipped, or `None` with a message.
///
/// # Panics
/// If the folder is named but lacks the file: what was meant to be tested would not be.
pub fn local(name: &str) -> Option<PathBuf> {
    let Some(folder) = std::env::var_os("TREMOLITE_RECORDS") else {
        eprintln!("skipped: TREMOLITE_RECORDS names no folder with {name}");
        return None;
    };
    let path = Path::new(&folder).join(name);
    assert!(path.exists(), "{} is not there", path.display());
    Some(path)
}
