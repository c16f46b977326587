//! Several ranks write the bytes of one process where water flows to an opening by stages and cannot leave in the earthquake.

use crate::ranks::{Case, how};
use crate::ready::Ready;
use std::path::Path;
use tremolite::job::{Given, Job, Loaded};
use tremolite_case::Change;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/wet-hall");

/// The wet hall, smaller: seepage of each stage, a drain, a lining that cracks with bars in it, on a drained interface; a joint with water
/// that slides; shaken on a free field while water cannot leave; 382 elements on levels of steps. `also` changes it further.
fn hall(also: &[(&str, &str)]) -> Job {
    let changes = [
        ("mesh.caverns.size_near", "4 m"),
        ("mesh.caverns.size_far", "20 m"),
        ("mesh.caverns.size_along", "4 m"),
        ("mesh.caverns.length", "4 m"),
        ("mesh.caverns.sides", "50 m"),
        ("mesh.caverns.below", "40 m"),
        ("mesh.caverns.overburden", "60 m"),
        ("mesh.caverns.cavern[0].width", "12 m"),
        ("mesh.caverns.cavern[0].height", "16 m"),
        ("mesh.caverns.cavern[0].arch_rise", "3 m"),
        ("mesh.plane[0].through", r#"["12 m", 0, "-70 m"]"#),
        ("material.concrete.fracture_energy", "600 N/m"),
        ("monitor[3].at", r#"["-12 m", "2 m", "-70 m"]"#),
        ("monitor[4].at", r#"["12 m", "2 m", "-70 m"]"#),
        ("stage[2].water.drains", r#"[{ from = ["0 m", "0 m", "-90 m"], to = ["0 m", "4 m", "-90 m"] }]"#),
        ("initial.tolerance", "1e-3"),
        ("initial.release_cycles", "50"),
        ("motion.window", r#"{ strongest = "0.1 s" }"#),
        ("motion.processing", r#"["detrend linear", "taper 0.03 s", "pga 3 g", "baseline"]"#),
        ("output.snapshots", "0.05 s"),
    ];
    let changes = changes.iter().chain(also).map(|&(key, value)| Change::new(key, value)).collect();
    let folder = Path::new(FOLDER);
    let given = Given { changes, ..Given::default() };
    let path = folder.join("case.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let mut loaded = Loaded::of_text(&text, &path, folder, &given).unwrap_or_else(|fault| panic!("{fault}"));
    loaded.setup.problem.patch_elements = Some(16);
    Job::of_loaded(loaded).unwrap_or_else(|fault| panic!("{fault}"))
}

fn case(Job { model, assembly, phase, plan, .. }: Job) -> Case {
    Case::of(Ready { model, assembly, phase }, plan)
}

#[test]
fn seepage_to_a_lined_hall_and_an_undrained_earthquake_give_the_same_on_several_ranks() {
    let job = hall(&[]);
    let flows = job.plan.stages.iter().filter_map(|stage| stage.flow.as_ref());
    let taken: Vec<Vec<String>> =
        flows.map(|flow| flow.taken().iter().map(|(place, _)| place.clone()).collect()).collect();
    assert_eq!(taken.len(), 3, "{taken:?}");
    assert!(taken[2].iter().any(|place| place == "drain 1") && taken[2].iter().any(|place| place == "back"));
    assert!(job.model.water.modulus.iter().any(|&m| m > 0.0), "water that cannot leave");
    assert!(job.phase.beats.len() > 1, "levels of steps");
    let ways = [how(1, 2, false), how(2, 1, false), how(2, 2, true), how(3, 1, false), how(3, 2, false)];
    let whole = case(job);
    let others = [
        ("water.earthquake", "drained"),
        ("stage[2].water.drains", "none"),
        ("interface[1].water", "{ drained = true }"),
        ("interface[0].water", "{ factor = 0.4 }"),
    ];
    let others = others.map(|change| (change.0, case(hall(&[change]))));
    let unchanged = whole.as_this(&others);
    assert!(unchanged.is_empty(), "each of them changes something: {unchanged:?}");
    whole.holds("wet hall", &ways);
}
