//! Fields of a large model are written in pieces, the same on any number of ranks, and read as the grid of one file.

use crate::ranks::{Case, files, how, same, through};
use crate::ranks_pit::{pit_case, pit_problem};
use std::sync::Arc;
use tremolite::Ranks;
use tremolite::simulation::{Start, Stepping};
use tremolite_mesh::vtu::Grid;
use tremolite_results::{Pvd, ResultFolder};

/// With a group that is in one piece alone.
fn in_pieces(most: usize) -> Case {
    let mut problem = pit_problem();
    problem.mesh.groups.insert("corner".into(), vec![0, 1, 2]);
    let mut case = pit_case(problem);
    case.plan.field_elements = most;
    case
}

#[test]
fn fields_in_pieces_are_the_same_on_several_ranks_and_hold_what_one_file_holds() {
    let elements = in_pieces(usize::MAX).built.model.mesh.elements.len();
    let case = in_pieces(elements / 5);
    case.holds("pieces", &[how(2, 1, false), how(3, 1, true)]);
    let whole = case.alone();
    let names: Vec<String> = whole.0.keys().map(|name| name.to_string_lossy().replace('\\', "/")).collect();
    let has = |name: &str| names.iter().any(|other| other == name);
    assert!(
        has("fields/000001.pvtu")
            && has("fields/000001-0002.vtu")
            && !has("fields/000001-0005.vtu")
            && has("stages/002.pvtu"),
        "{names:?}"
    );
    assert!(!has("fields/000001.vtu") && !has("stages/002.vtu"), "{names:?}");

    let parent = tempfile::tempdir().unwrap();
    let of = |name: &str, case: &Case| {
        let folder = ResultFolder::create(Some(&parent.path().join(name)), "ranks", true).unwrap();
        through(case.simulation(&folder, Start::Rest, None));
        folder
    };
    let [one, pieces] =
        [("one", in_pieces(usize::MAX)), ("pieces", case)].map(|(name, case)| of(name, &case));
    let mut compared = 0;
    for list in [ResultFolder::pvd, ResultFolder::stages_pvd] {
        let [one, pieces] = [&one, &pieces].map(|folder| Pvd::read(&list(folder)).unwrap());
        for (a, b) in one.snapshots().iter().zip(pieces.snapshots()) {
            assert_eq!(a.time, b.time);
            let [a, b] = [one.locate(a), pieces.locate(b)].map(|path| Grid::read(&path).unwrap());
            assert!(a == b && a.cell_array("group:corner").is_some(), "{}", pieces.snapshots()[0].file);
            compared += 1;
        }
    }
    assert!(compared >= 5, "{compared} files");
    // A folder that is used again is emptied of pieces too.
    let root = pieces.root().to_owned();
    drop(pieces);
    ResultFolder::create(Some(&root), "ranks", true).unwrap();
    assert!(std::fs::read_dir(root.join("fields")).is_ok_and(|mut entries| entries.next().is_none()));
}

/// Stopped on two ranks and gone on with on three, where the file of a time may be written in part.
#[test]
fn pieces_that_a_stopped_run_left_are_written_again_by_other_ranks() {
    let case = in_pieces(50);
    let whole = case.alone();
    let folder = tempfile::tempdir().unwrap();
    let results = ResultFolder::create(Some(folder.path()), "ranks", true).unwrap();
    let stop = |folder: &ResultFolder, ranks: Option<Arc<Ranks>>| {
        let first = ranks.as_ref().is_none_or(|ranks| ranks.is_first());
        let mut simulation = case.simulation(folder, Start::Rest, ranks);
        while simulation.stage().is_some() {
            simulation.relax(&mut |_| tremolite::simulation::Go::On).unwrap();
        }
        assert_eq!(simulation.step(2).unwrap(), Stepping::On);
        assert_eq!(simulation.checkpoint().unwrap(), None);
        simulation.step(u64::MAX).unwrap();
        if first {
            // As if it had been killed between two pieces of the last file.
            let mut pieces: Vec<_> =
                std::fs::read_dir(folder.fields()).unwrap().map(|e| e.unwrap().path()).collect();
            pieces.sort();
            let last = pieces.pop().unwrap();
            assert!(last.extension().is_some_and(|x| x == "pvtu"), "{}", last.display());
            std::fs::remove_file(last).unwrap();
            std::fs::write(pieces.pop().unwrap(), "half").unwrap();
        }
        String::new()
    };
    case.in_folder(how(2, 1, false), &results, &stop);
    let go_on = |folder: &ResultFolder, ranks| through(case.simulation(folder, Start::Resume, ranks));
    let (state, _) = case.in_folder(how(3, 1, false), &results, &go_on);
    same("pieces, resumed", &whole, &files(results.root(), state));
}
