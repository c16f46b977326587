//! One target under libFuzzer: the one that the variable FUZZ_TARGET names. With FUZZ_SEEDS its sound inputs are written into that folder, and
//! nothing else is done. `.ci/fuzz` builds and calls it.

#![no_main]

mod targets;

use libfuzzer_sys::{Corpus, fuzz_target};
use std::path::Path;
use std::sync::LazyLock;
use targets::{TARGETS, Target, seeds};

static TARGET: LazyLock<&Target> = LazyLock::new(|| {
    let name = std::env::var("FUZZ_TARGET").unwrap_or_default();
    let target = TARGETS.iter().find(|target| target.name == name).unwrap_or_else(|| {
        let names: Vec<_> = TARGETS.iter().map(|target| target.name).collect();
        eprintln!("set FUZZ_TARGET to one of: {}", names.join(" "));
        std::process::exit(2)
    });
    if let Some(folder) = std::env::var_os("FUZZ_SEEDS") {
        for (k, seed) in seeds(target, &Path::new(env!("CARGO_MANIFEST_DIR")).join("..")).iter().enumerate() {
            std::fs::write(Path::new(&folder).join(format!("seed-{k}")), seed).expect("a folder for seeds");
        }
        std::process::exit(0);
    }
    target
});

fuzz_target!(|bytes: &[u8]| -> Corpus {
    match (TARGET.takes)(bytes) {
        true => Corpus::Keep,
        false => Corpus::Reject,
    }
});
