//! What the fuzzer of `fuzz/` kept, once more and without it: inputs that reach different code, and those that failed once.

#[path = "../../../../fuzz/src/targets/mod.rs"]
mod targets;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use targets::{TARGETS, seeds};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// What is in a folder, in order.
fn files(at: &Path) -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = fs::read_dir(at).into_iter().flatten().map(|e| e.unwrap().path()).collect();
    files.sort();
    files
}

#[test]
fn every_kept_input_of_every_target_is_read_or_refused() {
    let corpus = root().join("fuzz/corpus");
    let known: BTreeSet<&str> = TARGETS.iter().map(|target| target.name).collect();
    for folder in files(&corpus) {
        let name = folder.file_name().unwrap().to_str().unwrap();
        assert!(known.contains(name), "{name} is the folder of no target");
    }
    for target in TARGETS {
        let own = files(&corpus.join(target.name)).into_iter().map(|path| fs::read(path).unwrap());
        let inputs: Vec<Vec<u8>> = own.chain(seeds(target, &root())).collect();
        let meant = inputs.iter().filter(|input| (target.takes)(input)).count();
        assert!(meant > 0, "{}: no input is meant for it", target.name);
    }
}
