//! The page itself.

use minijinja::Value;
use minijinja::value::Serde;
use serde::Serialize;
use tremolite_results::study::{RunStatus, Study, StudyRun};

use super::Figure;
use super::fragility::{caption, limit};
use super::paper::told;
use crate::language::Language;
use crate::page::templates::{STYLE, environment, markup};

const TEMPLATE: &str = include_str!("../../template/study.html");

/// Rows of the table of runs that the page shows; study.csv has all.
const ROWS: usize = 400;

/// Figures by the chapter that they stand in.
pub struct Parts {
    pub fragility: Vec<Figure>,
    pub rising: Vec<Figure>,
    pub tornado: Vec<Figure>,
    pub scatter: Vec<Figure>,
}

impl Parts {
    pub fn all(&self) -> impl Iterator<Item = &Figure> {
        [&self.fragility, &self.rising, &self.tornado, &self.scatter].into_iter().flatten()
    }
}

#[derive(Serialize)]
struct Page<'a> {
    style: Value,
    study: &'a Study,
    counts: Vec<(&'static str, usize)>,
    programs: Vec<String>,
    fits: Vec<Vec<String>>,
    chapters: Vec<Chapter>,
    over_records: Vec<Vec<String>>,
    head: Vec<String>,
    runs: Vec<Vec<String>>,
    more: usize,
    ended: Vec<(String, &'static str, String)>,
}

#[derive(Serialize)]
struct Chapter {
    heading: &'static str,
    figures: Vec<(String, Value, String)>,
}

pub fn html(study: &Study, parts: &Parts) -> Result<String, minijinja::Error> {
    let chapter = |heading, figures: &[Figure]| Chapter {
        heading,
        figures: figures.iter().map(|f| (f.file.clone(), markup(&f.svg), f.caption.clone())).collect(),
    };
    let chapters = vec![
        chapter("Fragility", &parts.fragility),
        chapter("Over intensity", &parts.rising),
        chapter("What one key changes", &parts.tornado),
        chapter("What goes together", &parts.scatter),
    ];
    let count = |status: RunStatus| study.runs.iter().filter(|run| run.status == status).count();
    let counts = [
        ("at their end", RunStatus::Done),
        ("stopped by the guard in the earthquake", RunStatus::Failed),
        ("not at rest before the earthquake", RunStatus::Restless),
        ("refused or ended from outside", RunStatus::Broken),
        ("not needed: a lower level was beyond the limit", RunStatus::NotNeeded),
        ("still to run", RunStatus::Pending),
    ];
    let mut programs: Vec<String> =
        study.runs.iter().map(|r| r.program.clone()).filter(|p| !p.is_empty()).collect();
    programs.sort();
    programs.dedup();
    let no_result =
        |run: &&StudyRun| matches!(run.status, RunStatus::Failed | RunStatus::Restless | RunStatus::Broken);
    let page = Page {
        style: markup(STYLE),
        study,
        counts: counts
            .into_iter()
            .map(|(words, status)| (words, count(status)))
            .filter(|(_, n)| *n > 0)
            .collect(),
        programs,
        fits: study.fragilities.iter().map(|f| fit(study, f)).collect(),
        chapters: chapters.into_iter().filter(|c| !c.figures.is_empty()).collect(),
        over_records: over_records(study),
        head: head(study),
        runs: study.runs.iter().take(ROWS).map(|run| row(study, run)).collect(),
        more: study.runs.len().saturating_sub(ROWS),
        ended: study
            .runs
            .iter()
            .filter(no_result)
            .map(|run| (run.name.clone(), run.status.word(), run.why.clone()))
            .collect(),
    };
    let mut environment = environment(Language::default())?;
    environment.add_template("study.html", TEMPLATE)?;
    environment.get_template("study.html")?.render(Serde(&page))
}

fn fit(study: &Study, f: &tremolite_results::study::StudyFragility) -> Vec<String> {
    let of = limit(study, f);
    let interval = |[low, high]: [f64; 2]| format!("{} to {}", told(low), told(high));
    let dash = || "–".to_owned();
    let [theta, beta, error, correlation] = match &f.fit {
        Some(fit) => {
            let [[a, b], [_, c]] = fit.covariance;
            let error = format!("{}, {}", told(a.sqrt()), told(c.sqrt()));
            [format!("{} {}", told(fit.theta), f.unit), told(fit.beta), error, told(b / (a * c).sqrt())]
        }
        None => [dash(), dash(), dash(), dash()],
    };
    let [of_theta, of_beta] = match &f.bounds {
        Some(b) => [interval(b.theta), interval(b.beta)],
        None => [dash(), dash()],
    };
    vec![of, f.by.clone(), theta, of_theta, beta, of_beta, error, correlation, f.method.clone(), caption(f)]
}

fn over_records(study: &Study) -> Vec<Vec<String>> {
    let row = |o: &tremolite_results::study::OverRecords| {
        let code = o.by_code.map_or_else(|| "–".to_owned(), told);
        let records = format!("{} of {}", o.records, o.of);
        vec![
            o.title.clone(),
            o.level.clone().unwrap_or_default(),
            o.measure.clone(),
            records,
            told(o.mean),
            told(o.largest),
            code,
        ]
    };
    study.over_records.iter().take(ROWS).map(row).collect()
}

fn head(study: &Study) -> Vec<String> {
    let shown = |c: &tremolite_results::study::StudyColumn| {
        let unit = if c.shown.is_empty() { c.unit.clone().unwrap_or_default() } else { c.shown.clone() };
        if unit.is_empty() { c.name.clone() } else { format!("{} ({unit})", c.name) }
    };
    let mut head = vec!["run".to_owned()];
    head.extend(study.parameters.iter().map(|p| p.name.clone()));
    if study.runs.iter().any(|r| r.record.is_some()) {
        head.push("record".to_owned());
    }
    if study.runs.iter().any(|r| r.factor.is_some()) {
        head.push("factor".to_owned());
    }
    head.extend(study.intensities.iter().chain(&study.measures).map(shown));
    head.push("ended".to_owned());
    head
}

fn row(study: &Study, run: &StudyRun) -> Vec<String> {
    let number = |x: Option<f64>| x.map_or_else(|| "–".to_owned(), told);
    let mut row = vec![run.name.clone()];
    row.extend(
        run.values
            .iter()
            .map(|v| v.as_deref().map_or_else(|| "as it is".to_owned(), |v| v.trim_matches('"').to_owned())),
    );
    if study.runs.iter().any(|r| r.record.is_some()) {
        row.push(run.record.clone().unwrap_or_default());
    }
    if study.runs.iter().any(|r| r.factor.is_some()) {
        row.push(number(run.factor));
    }
    row.extend(
        run.intensities.iter().zip(&study.intensities).map(|(x, c)| number(x.map(|x| x / c.shown_factor))),
    );
    row.extend(run.measures.iter().map(|x| number(*x)));
    row.push(run.status.word().to_owned());
    row
}
