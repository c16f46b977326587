//! The tables of a study, written from what lies there.

use super::gathered;
use super::planned::Planned;
use crate::exit::Failure;
use std::path::Path;
use tremolite_case::study::StudyFile;
use tremolite_results::replace_file;
use tremolite_results::study::{RunStatus, Study};
use tremolite_study::outcome::{Outcome, RunFolder};
use tremolite_study::plan::Plan;
use tremolite_study::results::{self, Missing, Prepared};

/// `study.csv` and `study.json`, of what is there; and what results lack that the study asks for.
pub fn write(
    study: &StudyFile,
    plan: &Plan,
    planned: &[Planned],
    out: &Path,
) -> Result<(Study, Vec<Missing>), Failure> {
    let (found, missing) = gathered(study, plan, planned, out);
    write_found(&found, out)?;
    Ok((found, missing))
}

/// The same when no more is run: a run that was killed before it had its page is given one, and each has the limits of acceptance that its case
/// gives, since to find whether they are met takes all tables of a run.
pub fn write_with_limits(
    study: &StudyFile,
    plan: &Plan,
    planned: &[Planned],
    out: &Path,
) -> Result<(Study, Vec<Missing>), Failure> {
    for (run, Planned { prepared, .. }) in plan.runs.iter().zip(planned) {
        let folder = RunFolder::new(out, &run.name);
        let is_done = || Outcome::of(&folder, &prepared.bare).status == RunStatus::Done;
        if !out.join(RunFolder::page(&run.name)).exists() && is_done() {
            // What has no page leads to none.
            let _ = tremolite_report::write(&folder.results());
        }
    }
    let (mut found, missing) = gathered(study, plan, planned, out);
    for run in found.runs.iter_mut().filter(|run| run.status == RunStatus::Done) {
        // Results that cannot be read are the page's to tell.
        run.limits = tremolite_report::limits(&RunFolder::new(out, &run.name).results()).unwrap_or_default();
    }
    write_found(&found, out)?;
    Ok((found, missing))
}

fn write_found(found: &Study, out: &Path) -> Result<(), Failure> {
    replace_file(&out.join("study.csv"), results::csv(found).as_bytes()).map_err(Failure::failed)?;
    found.write(&out.join("study.json")).map_err(Failure::failed)
}

/// The plan of some runs.
pub fn plan(study: &StudyFile, plan: &Plan, planned: &[Planned], chosen: &[usize]) -> String {
    let prepared: Vec<Prepared> = chosen.iter().map(|run| planned[*run].prepared.clone()).collect();
    let runs = chosen.iter().map(|run| plan.runs[*run].clone()).collect();
    results::plan_csv(study, &Plan { runs, ..plan.clone() }, &prepared)
}
