//! The tables of a study, written from what lies there.

use super::gathered;
use super::planned::Planned;
use crate::exit::Failure;
use std::path::Path;
use tremolite_case::study::StudyFile;
use tremolite_results::replace_file;
use tremolite_results::study::Study;
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
    replace_file(&out.join("study.csv"), results::csv(&found).as_bytes()).map_err(Failure::failed)?;
    found.write(&out.join("study.json")).map_err(Failure::failed)?;
    Ok((found, missing))
}

/// The plan of some runs.
pub fn plan(study: &StudyFile, plan: &Plan, planned: &[Planned], chosen: &[usize]) -> String {
    let prepared: Vec<Prepared> = chosen.iter().map(|run| planned[*run].prepared.clone()).collect();
    let runs = chosen.iter().map(|run| plan.runs[*run].clone()).collect();
    results::plan_csv(study, &Plan { runs, ..plan.clone() }, &prepared)
}
