//! A staged cavern under a wave at an angle: quiet before it comes, in halves, and its mirror image.

use crate::waves_at_angles::{CASE, given};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use tremolite::RunError;
use tremolite::job::{Caller, Job};
use tremolite::run::Control;
use tremolite::simulation::{Ending, Go, Start};
use tremolite_results::{ResultFolder, Status, Table};

/// [`CASE`] with a core that a stage takes out, in rock under its weight.
fn staged(azimuth: &str) -> String {
    let core = "[[mesh.box.part]]\ngroup = \"core\"\nx = [\"15 m\", \"25 m\"]\ny = [\"10 m\", \"20 m\"]\nz = [\"15 m\", \"25 m\"]\n\
                [material.rock]";
    CASE.replace("[material.rock]", core)
        .replace("groups = [\"rock\"]", "groups = [\"rock\", \"core\"]")
        .replace("azimuth = \"30 deg\"", &format!("azimuth = \"{azimuth} deg\""))
        .replace(
            "[motion]",
            "[initial]\nlateral = 0.5\nrelease_cycles = 50\ntolerance = 1e-4\n[[stage]]\nname = \"out\"\nexcavate = [\"core\"]\n[motion]",
        )
        // The first monitors in the walls of what is taken out, at both ends of x.
        .replace("at = [\"10 m\", \"10 m\", \"40 m\"]", "at = [\"14 m\", \"15 m\", \"20 m\"]")
        .replace("at = [\"30 m\", \"10 m\", \"40 m\"]", "at = [\"26 m\", \"15 m\", \"20 m\"]")
}

fn job(text: &str) -> Job {
    Job::of_text(text, Path::new("."), &given()).unwrap_or_else(|fault| panic!("{fault}"))
}

fn make(parent: &Path, name: &str) -> ResultFolder {
    ResultFolder::create(Some(&parent.join(name)), name, false).unwrap()
}

fn run(job: &Job, folder: &ResultFolder, start: Start) -> Result<tremolite_results::Summary, RunError> {
    let mut control = Control { stop: &AtomicBool::new(false), progress: &mut |_| {} };
    job.run(folder, start, &Caller::new("test"), &mut control).map(|(_, summary)| summary)
}

fn bytes(folder: &ResultFolder) -> BTreeMap<&'static str, Vec<u8>> {
    let all = [
        ("monitors", folder.monitors()),
        ("field", folder.free_field()),
        ("energy", folder.energy()),
        ("motion", folder.motion()),
    ];
    all.into_iter().map(|(name, path)| (name, std::fs::read(path).unwrap())).collect()
}

#[test]
fn a_staged_cavern_is_quiet_goes_on_where_it_stopped_and_has_its_mirror_image() {
    let folder = tempfile::tempdir().unwrap();
    let parent = folder.path();
    let one = job(&staged("30"));
    let whole = make(parent, "whole");
    let summary = run(&one, &whole, Start::Rest).unwrap();
    assert_eq!(summary.conclusion.status, Status::Done);
    let drift = summary.case.facts.iter().find(|fact| fact.id == "drift_without_motion").unwrap();
    assert!(drift.value < 1e-9, "{drift:?}");
    let failed: Vec<_> =
        summary.soundness.checks.iter().filter(|line| !line.pass && !line.not_applicable).collect();
    // The cavern stands half its width from the sides, which is what such checks are for.
    assert!(failed.iter().all(|line| line.id != "free_field_theory"), "{failed:?}");

    let halves = make(parent, "halves");
    let begun = one.begin(&halves, Start::Rest).unwrap();
    let mut simulation = begun.simulation(&one, Vec::new()).unwrap();
    while simulation.stage().is_some() {
        simulation.relax(&mut |_| Go::On).unwrap();
    }
    let half = simulation.steps().1.total / 2;
    simulation.step(half).unwrap();
    simulation.checkpoint().unwrap();
    let outcome = simulation.finish(Ending::Stopped, 0.0).unwrap();
    begun.end(&one, &outcome, &Caller::new("test")).unwrap();
    drop((begun, simulation));
    assert_ne!(bytes(&whole), bytes(&halves));
    drop(halves);
    let again = || ResultFolder::resume(Some(&parent.join("halves")), "halves").unwrap();
    // Another wave is not gone on with.
    let other = run(&job(&staged("31")), &again(), Start::Resume);
    assert!(matches!(other, Err(RunError::OtherCase { .. } | RunError::Checkpoint(_))), "{:?}", other.err());
    let folder = again();
    run(&one, &folder, Start::Resume).unwrap();
    assert!(bytes(&whole) == bytes(&folder));

    let mirror = make(parent, "mirror");
    run(&job(&staged("330")), &mirror, Start::Rest).unwrap();
    let [own, other] = [&whole, &mirror].map(|folder| Table::read(&folder.monitors()).unwrap());
    let (mut worst, mut most) = (0.0_f64, 0.0_f64);
    for (name, image, sign) in [("A.ux", "B.ux", -1.0), ("A.uz", "B.uz", 1.0), ("B.uy", "A.uy", 1.0)] {
        for (a, b) in own.column(name).unwrap().iter().zip(other.column(image).unwrap()) {
            worst = worst.max((a - sign * b).abs());
            most = most.max(a.abs());
        }
    }
    // What the stages leave to their tolerance is not mirrored to round-off.
    assert!(most > 0.0 && worst < 1e-3 * most, "{worst:e} of {most:e}");
}
