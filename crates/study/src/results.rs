//! All runs of a study put together: the table, what records say together, what keys change, and fragility curves.

mod fragilities;
mod influence;

use std::path::Path;

use indexmap::IndexMap;
use tremolite_case::Language;
use tremolite_case::study::{Quantity, StudyFile};
use tremolite_results::Class;
use tremolite_results::study::{OverRecords, RunStatus, Study, StudyColumn, StudyRun};

use crate::codes;
use crate::measure::Results;
use crate::outcome::{Outcome, RunFolder};
use crate::plan::{Plan, Run};
use crate::prepare::told;
use crate::table;

/// What is known of a run before it is run.
#[derive(Clone, Debug, PartialEq)]
pub struct Prepared {
    /// The case on one line.
    pub bare: String,
    /// What its motion is multiplied by.
    pub factor: Option<f64>,
    /// Each measure of intensity of the plan, of the motion as it is given to the model, SI; none without an earthquake.
    pub intensities: Vec<Option<f64>>,
}

/// A measure that the results of a run do not hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Missing {
    pub measure: String,
    pub run: String,
    pub why: String,
}

/// Puts together what lies below `out`. Runs whose results lack a measure are told as well.
pub fn gather(study: &StudyFile, plan: &Plan, prepared: &[Prepared], out: &Path) -> (Study, Vec<Missing>) {
    let mut missing = Vec::new();
    let mut units: Vec<Option<String>> = study.measures.iter().map(|m| m.unit.clone()).collect();
    let mut runs: Vec<StudyRun> = Vec::new();
    for (run, prepared) in plan.runs.iter().zip(prepared) {
        let folder = RunFolder::new(out, &run.name);
        let outcome = Outcome::checked(&folder, &prepared.bare);
        let root = folder.results();
        let results = if outcome.status == RunStatus::Done { Results::of(&root) } else { None };
        let numbers = study.measures.iter().enumerate().map(|(k, measure)| {
            let results = results.as_ref()?;
            if units[k].is_none() {
                units[k] = results.unit(measure);
            }
            match results.number(measure) {
                Ok(number) => number,
                Err(why) => {
                    let (measure, run) = (measure.name.value.clone(), run.name.clone());
                    missing.push(Missing { measure, run, why });
                    None
                }
            }
        });
        let measures = numbers.collect();
        let page = RunFolder::page(&run.name);
        let page = if outcome.has_ended() && out.join(&page).exists() { page } else { String::new() };
        runs.push(StudyRun { page, ..row(study, plan, run, prepared, outcome, measures) });
    }
    end_chains(study, plan, &mut runs);
    let plain = |name: &str, unit: Option<String>| StudyColumn {
        name: name.to_owned(),
        unit,
        shown: String::new(),
        shown_factor: 1.0,
    };
    let mut found = Study {
        title: study.title.value.clone(),
        language: study.language.unwrap_or(Language::En).word().to_owned(),
        file: study.path.file_name().map(|f| f.to_string_lossy().into_owned()).unwrap_or_default(),
        case: study.case.value.to_string_lossy().into_owned(),
        parameters: plan.parameters.iter().map(|p| plain(&p.path, p.unit.clone())).collect(),
        intensities: plan.intensities.iter().map(|m| intensity_column(plan, m)).collect(),
        measures: study.measures.iter().zip(units).map(|(m, unit)| plain(&m.name.value, unit)).collect(),
        rises: plan.rises,
        runs,
        ..Study::default()
    };
    found.over_records = over_records(&found, study.records.len());
    found.tornados = influence::tornados(&found);
    found.influences = influence::influences(study, &found);
    found.fragilities = fragilities::of(study, plan, &found);
    (found, missing)
}

fn intensity_column(plan: &Plan, measure: &crate::intensity::Measure) -> StudyColumn {
    let (shown, shown_factor) = plan.told_in(measure);
    let si = match measure.unit().0 {
        "g" => "m/s2",
        other => other,
    };
    StudyColumn { name: measure.to_string(), unit: Some(si.to_owned()), shown, shown_factor }
}

fn row(
    study: &StudyFile,
    plan: &Plan,
    run: &Run,
    prepared: &Prepared,
    outcome: Outcome,
    measures: Vec<Option<f64>>,
) -> StudyRun {
    let sample = &plan.samples[run.sample];
    let (state, reliance) = outcome.classes;
    StudyRun {
        name: run.name.clone(),
        title: sample.title.clone(),
        sample: run.sample,
        beside: sample.beside,
        record: run.record.map(|r| study.records[r].name.value.clone()),
        level: run.level.map(|l| plan.levels[l].text.clone()),
        factor: prepared.factor,
        values: sample.values.clone(),
        intensities: prepared.intensities.clone(),
        measures,
        status: outcome.status,
        why: outcome.why,
        program: outcome.program,
        page: String::new(),
        limits: IndexMap::new(),
        state,
        reliance,
    }
}

/// Whether a run of rising levels ends its chain: it was stopped by the guard, or is beyond the limit.
pub fn ends_chain(study: &StudyFile, run: &StudyRun) -> bool {
    use tremolite_case::study::Levels;
    let Some(Levels::Ida(ida)) = study.scale.as_ref().map(|s| &s.levels) else { return false };
    let measure = study.measures.iter().position(|m| m.name.value == ida.until.value);
    let beyond = measure.and_then(|k| run.measures[k]).is_some_and(|x| x > ida.above);
    // A run that was refused or ended from outside says nothing of the level.
    beyond || matches!(run.status, RunStatus::Failed | RunStatus::NotConverged)
}

/// Runs above the one that ends their chain are not needed, whatever lies there.
fn end_chains(study: &StudyFile, plan: &Plan, runs: &mut [StudyRun]) {
    let mut ended: Option<usize> = None;
    for (run, row) in plan.runs.iter().zip(runs) {
        if ended == Some(run.chain) {
            *row = StudyRun {
                status: RunStatus::NotNeeded,
                measures: vec![None; row.measures.len()],
                why: String::new(),
                page: String::new(),
                state: None,
                reliance: None,
                ..row.clone()
            };
        } else if ends_chain(study, row) {
            ended = Some(run.chain);
        }
    }
}

/// Results of each sample and level over its records.
fn over_records(study: &Study, records: usize) -> Vec<OverRecords> {
    if records < 2 || study.rises {
        return Vec::new();
    }
    let mut found = Vec::new();
    let mut groups: Vec<(usize, &Option<String>)> = Vec::new();
    for run in &study.runs {
        if groups.contains(&(run.sample, &run.level)) {
            continue;
        }
        groups.push((run.sample, &run.level));
        let all: Vec<&StudyRun> =
            study.runs.iter().filter(|r| r.sample == run.sample && r.level == run.level).collect();
        for (k, measure) in study.measures.iter().enumerate() {
            let results: Vec<f64> = all.iter().filter_map(|r| r.measures[k]).collect();
            if results.is_empty() {
                continue;
            }
            found.push(OverRecords {
                sample: run.sample,
                title: run.title.clone(),
                level: run.level.clone(),
                measure: measure.name.clone(),
                records: results.len(),
                of: all.len(),
                mean: results.iter().sum::<f64>() / results.len() as f64,
                largest: results.iter().copied().fold(f64::NEG_INFINITY, f64::max),
                // A run without the result would be left out of the largest as of the mean.
                by_code: if results.len() == all.len() { codes::by_code(&results) } else { None },
            });
        }
    }
    found
}

/// All limits of acceptance that runs were held to, with their units, in the order in which they come.
fn limits(study: &Study) -> IndexMap<&str, &str> {
    let all = study.runs.iter().flat_map(|run| &run.limits);
    all.map(|(name, of)| (name.as_str(), of.unit.as_str())).collect()
}

/// Columns of how a run ended, the last of the table.
const COLUMNS_OF_END: [&str; 5] = ["state", "reliance", "status", "why", "program"];

/// The runs as a table of comma-separated columns.
pub fn csv(study: &Study) -> String {
    let with_unit = |c: &StudyColumn| match &c.unit {
        Some(unit) if !unit.is_empty() => format!("{} [{unit}]", c.name),
        _ => c.name.clone(),
    };
    let mut headers: Vec<String> = ["run", "sample", "record", "level", "factor"].map(str::to_owned).into();
    headers.extend(study.parameters.iter().map(with_unit));
    headers.extend(study.intensities.iter().map(with_unit));
    headers.extend(study.measures.iter().map(with_unit));
    let limits = limits(study);
    for (name, unit) in &limits {
        headers.push(if *unit == "1" { format!("limits.{name}") } else { format!("limits.{name} [{unit}]") });
        headers.push(format!("limits.{name}.met"));
    }
    headers.extend(COLUMNS_OF_END.map(str::to_owned));
    let number = |x: &Option<f64>| x.map_or_else(String::new, |x| x.to_string());
    let rows: Vec<Vec<String>> = study
        .runs
        .iter()
        .map(|run| {
            let text = |t: &Option<String>| t.clone().unwrap_or_default();
            let factor = run.factor.map_or_else(String::new, told);
            let mut row =
                vec![run.name.clone(), run.title.clone(), text(&run.record), text(&run.level), factor];
            row.extend(
                run.values
                    .iter()
                    .zip(&study.parameters)
                    .map(|(value, p)| cell(value.as_deref(), p.unit.is_some())),
            );
            row.extend(run.intensities.iter().map(number));
            row.extend(run.measures.iter().map(number));
            for (name, _) in &limits {
                let of = run.limits.get(*name);
                row.push(number(&of.and_then(|of| of.found)));
                row.push(of.and_then(|of| of.met).map_or_else(String::new, |met| met.to_string()));
            }
            row.push(run.state.map_or_else(String::new, |state| state.key().to_owned()));
            row.push(run.reliance.map_or_else(String::new, |reliance| reliance.key().to_owned()));
            row.extend([run.status.word().to_owned(), run.why.clone(), run.program.clone()]);
            row
        })
        .collect();
    table::written(&headers, &rows)
}

/// A value of a key as a cell: the number alone where the column has its unit.
fn cell(value: Option<&str>, numbers: bool) -> String {
    let Some(value) = value else { return String::new() };
    let bare = value.trim_matches('"');
    match Quantity::parse(bare) {
        Some(quantity) if numbers => quantity.number.to_string(),
        _ => bare.to_owned(),
    }
}

/// The plan alone as a table.
pub fn plan_csv(study: &StudyFile, plan: &Plan, prepared: &[Prepared]) -> String {
    let rows: Vec<StudyRun> = plan
        .runs
        .iter()
        .zip(prepared)
        .map(|(run, prepared)| {
            let nothing = Outcome::pending();
            row(study, plan, run, prepared, nothing, Vec::new())
        })
        .collect();
    let plain = |p: &crate::plan::Parameter| StudyColumn {
        name: p.path.clone(),
        unit: p.unit.clone(),
        ..StudyColumn::default()
    };
    let whole = csv(&Study {
        parameters: plan.parameters.iter().map(plain).collect(),
        intensities: plan.intensities.iter().map(|m| intensity_column(plan, m)).collect(),
        runs: rows,
        ..Study::default()
    });
    // Without how each ended.
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(whole.as_bytes());
    let rows: Vec<Vec<String>> = reader
        .records()
        .flatten()
        .map(|row| {
            row.iter().take(row.len().saturating_sub(COLUMNS_OF_END.len())).map(str::to_owned).collect()
        })
        .collect();
    rows.split_first().map_or_else(String::new, |(headers, rows)| table::written(headers, rows))
}

#[cfg(test)]
mod tests;
