//! No run overwrites another by accident.

use std::fs;

use tremolite_results::{Error, HAND_OVER, ResultFolder, Status, Summary, replace_file};

#[test]
fn runs_of_one_case_are_numbered_on_and_the_last_with_a_checkpoint_is_resumed() {
    let temp = tempfile::tempdir().unwrap();
    let names: Vec<_> = (0..3)
        .map(|_| ResultFolder::create_numbered(temp.path(), "cavern", false).unwrap())
        .map(|folder| folder.root().file_name().unwrap().to_str().unwrap().to_owned())
        .collect();
    assert_eq!(names, ["cavern", "cavern-2", "cavern-3"]);

    let none = ResultFolder::resume_numbered(temp.path(), "cavern");
    assert!(matches!(none, Err(Error::NoResults { .. })));
    for name in ["cavern", "cavern-2"] {
        fs::create_dir(temp.path().join(name).join("checkpoint")).unwrap();
        fs::write(temp.path().join(name).join("checkpoint/state.bin"), "x").unwrap();
    }
    let resumed = ResultFolder::resume_numbered(temp.path(), "cavern").unwrap();
    assert_eq!(resumed.root(), temp.path().join("cavern-2"));
}

#[test]
fn an_empty_folder_and_one_with_only_the_case_are_free() {
    let temp = tempfile::tempdir().unwrap();
    fs::write(temp.path().join("case.toml"), "title = 'x'").unwrap();
    let folder = ResultFolder::create(Some(temp.path()), "x", false).unwrap();
    assert!(folder.fields().is_dir() && folder.figures().is_dir() && folder.log().is_file());
    assert!(folder.case().exists());
}

#[test]
fn a_given_folder_with_results_is_refused_or_emptied_of_results_alone() {
    let temp = tempfile::tempdir().unwrap();
    drop(ResultFolder::create(Some(temp.path()), "x", false).unwrap());
    let folder = ResultFolder::open_existing(temp.path()).unwrap();
    fs::write(folder.summary(), "{}").unwrap();
    fs::write(folder.free_field(), "old").unwrap();
    fs::write(folder.fields().join("0001.vtu"), "old").unwrap();
    fs::create_dir(folder.interface_fields()).unwrap();
    let of_interfaces =
        [folder.interfaces(), folder.interfaces_pvd(), folder.interface_fields().join("0001.vtu")];
    of_interfaces.iter().for_each(|path| fs::write(path, "old").unwrap());
    fs::write(folder.fields().join("notes.md"), "mine").unwrap();
    fs::write(temp.path().join("letter.txt"), "mine").unwrap();
    let lock = temp.path().join("run.lock");
    fs::remove_file(&lock).unwrap();

    fs::write(temp.path().join("film.part"), "a user's own").unwrap();
    fs::write(folder.fields().join("0002.vtu.4711.part"), "half").unwrap();
    let refused = ResultFolder::create(Some(temp.path()), "x", false).unwrap_err();
    assert!(matches!(refused, Error::Held { .. }));
    assert!(refused.to_string().contains("--resume") && refused.to_string().contains("--overwrite"));
    assert!(folder.summary().exists() && !lock.exists());

    ResultFolder::create(Some(temp.path()), "x", true).unwrap();
    assert!(!folder.summary().exists() && !folder.fields().join("0001.vtu").exists());
    assert!(of_interfaces.iter().all(|path| !path.exists()), "a later run may have no interface");
    assert!(!folder.free_field().exists(), "nor a column");
    assert!(temp.path().join("film.part").exists() && !folder.fields().join("0002.vtu.4711.part").exists());
    assert!(folder.fields().join("notes.md").exists() && temp.path().join("letter.txt").exists());
}

#[test]
fn a_case_name_cannot_lead_out_of_the_results() {
    let temp = tempfile::tempdir().unwrap();
    for (name, expected) in [
        ("../../etc/passwd", "etc-passwd"),
        ("..", "case"),
        ("", "case"),
        ("a/b\\c:d\0e", "a-b-c-d-e"),
        ("映秀湾 2008", "映秀湾-2008"),
        (".hidden", "hidden"),
    ] {
        let folder = ResultFolder::create_numbered(&temp.path().join("r"), name, true).unwrap();
        assert_eq!(folder.root(), temp.path().join("r").join(expected));
    }
    let long = ResultFolder::create_numbered(temp.path(), &"域".repeat(500), false).unwrap();
    assert!(long.root().is_dir());
}

#[test]
fn only_a_folder_with_results_opens() {
    let temp = tempfile::tempdir().unwrap();
    assert!(ResultFolder::open_existing(temp.path()).is_err());
    let missing = ResultFolder::open_existing(&temp.path().join("nowhere")).unwrap_err();
    assert!(missing.to_string().contains("no such folder"));
    fs::write(temp.path().join("monitors.csv"), "time [s]\n").unwrap();
    assert!(ResultFolder::open_existing(temp.path()).is_ok());
    assert!(ResultFolder::resume(Some(temp.path()), "x").is_err());
}

#[test]
fn a_replaced_file_is_whole_and_leaves_no_litter() {
    let temp = tempfile::tempdir().unwrap();
    let path = temp.path().join("a.json");
    replace_file(&path, b"one").unwrap();
    replace_file(&path, b"two").unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"two");
    fs::create_dir(temp.path().join("b.json")).unwrap();
    assert!(replace_file(&temp.path().join("b.json"), b"x").is_err());
    assert_eq!(fs::read_dir(temp.path()).unwrap().count(), 2);
}

#[test]
fn a_folder_that_a_run_writes_into_is_refused_to_others_until_the_run_ends() {
    let temp = tempfile::tempdir().unwrap();
    let first = temp.path().join("cavern");
    let run = ResultFolder::create(Some(&first), "x", false).unwrap();
    fs::create_dir(run.checkpoint()).unwrap();
    fs::write(run.checkpoint().join("state.bin"), "x").unwrap();
    fs::write(run.summary(), "{}").unwrap();
    let kept = run.clone();
    drop(run);

    let others = [
        ResultFolder::create(Some(&first), "x", false),
        ResultFolder::create(Some(&first), "x", true),
        ResultFolder::create_numbered(temp.path(), "cavern", true),
        ResultFolder::resume(Some(&first), "x"),
        ResultFolder::resume_numbered(temp.path(), "cavern"),
    ];
    for other in others {
        let refused = other.unwrap_err();
        assert!(matches!(refused, Error::Busy { .. }), "{refused}");
        assert!(refused.to_string().contains(first.to_str().unwrap()), "{refused}");
    }
    assert!(kept.summary().exists(), "nothing was removed");
    // Readers are not kept out, and a run without a folder of its own gets the next.
    assert!(ResultFolder::open_existing(&first).is_ok());
    let next = ResultFolder::create_numbered(temp.path(), "cavern", false).unwrap();
    assert_eq!(next.root(), temp.path().join("cavern-2"));

    drop(kept);
    drop(ResultFolder::resume(Some(&first), "x").unwrap());
    ResultFolder::create(Some(&first), "x", true).unwrap();
    assert!(!first.join("summary.json").exists());
}

/// What the earthquake began with is enough for a run that was killed or stopped and whose checkpoints are lost; one that ended keeps it for others.
#[test]
fn a_run_that_did_not_end_goes_on_from_where_its_earthquake_began() {
    let temp = tempfile::tempdir().unwrap();
    let folder = ResultFolder::create(Some(temp.path()), "cavern", false).unwrap();
    fs::create_dir(folder.checkpoint()).unwrap();
    assert!(!ResultFolder::goes_on(temp.path()));
    fs::write(folder.checkpoint().join(HAND_OVER), "x").unwrap();
    assert!(ResultFolder::goes_on(temp.path()));
    for (status, goes_on) in [(Status::Stopped, true), (Status::Failed, false), (Status::Done, false)] {
        let mut summary = Summary::default();
        summary.conclusion.status = status;
        summary.write(&folder.summary()).unwrap();
        assert_eq!(ResultFolder::goes_on(temp.path()), goes_on, "{status:?}");
    }
}
