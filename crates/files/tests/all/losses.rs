//! What a machine that loses power leaves of files that were replaced, and of files that grow.

use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;
use tremolite_files::record::{self, Loss};
use tremolite_files::{Appended, make_folder, remove, replace_with};

const LOSSES: [Loss; 4] = [Loss::All, Loss::Contents, Loss::Torn, Loss::Nothing];

fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut all = BTreeMap::new();
    for entry in std::fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let name = entry.file_name().into_string().unwrap();
        match entry.path().is_dir() {
            true => all.extend(files(&entry.path()).into_iter().map(|(k, v)| (format!("{name}/{k}"), v))),
            false => drop(all.insert(name, std::fs::read(entry.path()).unwrap())),
        }
    }
    all
}

/// One test, since there is one record.
#[test]
fn what_is_replaced_is_old_or_new_and_what_grows_keeps_what_was_synced() {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path().join("run");
    record::begin(folder.path());
    make_folder(&root.join("fields")).unwrap();
    replace_with(&root.join("fields/state"), b"old").unwrap();
    let begun = record::so_far();
    replace_with(&root.join("fields/state"), b"newer").unwrap();
    let mut table = Appended::create(&root.join("table")).unwrap();
    table.write_all(b"first,").unwrap();
    table.sync().unwrap();
    let synced = record::so_far();
    table.write_all(b"second,").unwrap();
    table.cut(6).unwrap();
    table.write_all(b"third").unwrap();
    remove(&root.join("fields/state")).unwrap();
    let acts = record::end();

    for loss in LOSSES {
        for count in 0..=acts.len() {
            let left = tempfile::tempdir().unwrap();
            record::leave(&acts[..count], loss, folder.path(), left.path()).unwrap();
            let left = files(left.path());
            let state = left.get("run/fields/state").map(Vec::as_slice);
            let removed = count + 1 >= acts.len();
            assert!(
                [Some(&b"old"[..]), Some(b"newer")].contains(&state) || count < begun || removed,
                "{loss:?} {count}: {state:?}"
            );
            if count >= synced {
                assert!(left["run/table"].starts_with(b"first,"), "{loss:?} {count}");
            }
        }
    }
    // The last of all: what was not synced is lost, torn or kept.
    let end = |loss| {
        let left = tempfile::tempdir().unwrap();
        record::leave(&acts, loss, folder.path(), left.path()).unwrap();
        files(left.path()).remove("run/table").unwrap()
    };
    assert_eq!(end(Loss::All), b"first,");
    assert_eq!(end(Loss::Torn), b"first,th\0\0\0");
    assert_eq!(end(Loss::Nothing), b"first,third");

    // A name that was given without syncing content or folder, as by std::fs alone, is one of an empty file or none.
    record::begin(folder.path());
    let mut bare = Appended::create(&root.join("bare")).unwrap();
    bare.write_all(b"all of it").unwrap();
    let acts = record::end();
    for (loss, left) in [(Loss::All, None), (Loss::Contents, Some(0)), (Loss::Torn, Some(9))] {
        let to = tempfile::tempdir().unwrap();
        record::leave(&acts, loss, &root, to.path()).unwrap();
        assert_eq!(files(to.path()).get("bare").map(Vec::len), left, "{loss:?}");
    }
}
