//! The page itself.

use indexmap::IndexSet;
use minijinja::Value;
use minijinja::value::Serde;
use serde::Serialize;
use tremolite_results::study::{RunStatus, Study, StudyLimit, StudyRun};

use super::Figure;
use super::fragility::{caption, limit, over, word};
use super::paper::{measured, told};
use crate::language::{Language, say};
use crate::page::templates::{STYLE, environment, markup};
use crate::quantities::scale::{figures, trimmed};
use crate::verdict::word as class_word;

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
    language: &'static str,
    about: String,
    counts: Vec<String>,
    mixed: Option<String>,
    fits: Vec<Vec<String>>,
    chapters: Vec<Chapter>,
    over_records: Vec<Vec<String>>,
    head: Vec<String>,
    runs: Vec<Vec<Cell>>,
    more: Option<String>,
    /// With their pages and why.
    ended: Vec<(Cell, String, String)>,
}

/// A cell of the table of runs.
#[derive(Default, Serialize)]
struct Cell {
    text: String,
    /// Where it leads; empty for nowhere.
    link: String,
    /// `pass` or `fail` of a limit; else empty.
    class: &'static str,
    note: String,
}

impl Cell {
    fn plain(text: String) -> Cell {
        Cell { text, ..Cell::default() }
    }
}

#[derive(Serialize)]
struct Chapter {
    heading: String,
    figures: Vec<(String, Value, String)>,
}

pub fn html(study: &Study, language: Language, parts: &Parts) -> Result<String, minijinja::Error> {
    let chapter = |heading: String, figures: &[Figure]| Chapter {
        heading,
        figures: figures.iter().map(|f| (f.file.clone(), markup(&f.svg), f.caption.clone())).collect(),
    };
    let chapters = vec![
        chapter(say!(language, "Fragility"), &parts.fragility),
        chapter(say!(language, "Over intensity"), &parts.rising),
        chapter(say!(language, "What one key changes"), &parts.tornado),
        chapter(say!(language, "What goes together"), &parts.scatter),
    ];
    let count = |status: RunStatus| study.runs.iter().filter(|run| run.status == status).count();
    let counts = [
        RunStatus::Done,
        RunStatus::Failed,
        RunStatus::NotConverged,
        RunStatus::Error,
        RunStatus::NotNeeded,
        RunStatus::Pending,
    ];
    let mut programs: Vec<String> =
        study.runs.iter().map(|r| r.program.clone()).filter(|p| !p.is_empty()).collect();
    programs.sort();
    programs.dedup();
    let mixed = || {
        say!(
            language,
            "The runs are of {some} programs ({names}): set only those of one beside one another.",
            some = programs.len(),
            names = programs.join(", ")
        )
    };
    let no_result = |run: &&StudyRun| {
        matches!(run.status, RunStatus::Failed | RunStatus::NotConverged | RunStatus::Error)
    };
    let more = study.runs.len().saturating_sub(ROWS);
    let page = Page {
        style: markup(STYLE),
        study,
        language: language.code(),
        about: say!(
            language,
            "A study of {case} by {file}: {runs} runs.",
            case = study.case,
            file = study.file,
            runs = study.runs.len()
        ),
        counts: counts
            .into_iter()
            .map(|status| (status, count(status)))
            .filter(|(_, n)| *n > 0)
            .map(|(status, n)| counted(language, status, n))
            .chain(met(study, language))
            .collect(),
        mixed: (programs.len() > 1).then(mixed),
        fits: study.fragilities.iter().map(|f| fit(study, language, f)).collect(),
        chapters: chapters.into_iter().filter(|c| !c.figures.is_empty()).collect(),
        over_records: over_records(study, language),
        head: head(study, language),
        runs: study.runs.iter().take(ROWS).map(|run| row(study, language, run)).collect(),
        more: (more > 0).then(|| say!(language, "{some} more are in study.csv.", some = more)),
        ended: study
            .runs
            .iter()
            .filter(no_result)
            .map(|run| {
                let name = Cell { link: address(&run.page), ..Cell::plain(run.name.clone()) };
                (name, ended(language, run.status), run.why.clone())
            })
            .collect(),
    };
    let mut environment = environment(language)?;
    environment.add_template("study.html", TEMPLATE)?;
    environment.get_template("study.html")?.render(Serde(&page))
}

/// How many runs ended so.
fn counted(language: Language, status: RunStatus, n: usize) -> String {
    match status {
        RunStatus::Done => say!(language, "{some} at their end", some = n),
        RunStatus::Failed => say!(language, "{some} stopped by the guard in the earthquake", some = n),
        RunStatus::NotConverged => say!(language, "{some} not at rest before the earthquake", some = n),
        RunStatus::Error => say!(language, "{some} refused or ended from outside", some = n),
        RunStatus::NotNeeded => {
            say!(language, "{some} not needed: a lower level was beyond the limit", some = n)
        }
        RunStatus::Pending => say!(language, "{some} still to run", some = n),
    }
}

/// How a run ended, in a word.
fn ended(language: Language, status: RunStatus) -> String {
    match status {
        RunStatus::Done => say!(language, "done"),
        RunStatus::Failed => say!(language, "failed"),
        RunStatus::NotConverged => say!(language, "not converged"),
        RunStatus::Error => say!(language, "run error"),
        RunStatus::NotNeeded => say!(language, "not-needed"),
        RunStatus::Pending => say!(language, "pending"),
    }
}

fn fit(study: &Study, language: Language, f: &tremolite_results::study::StudyFragility) -> Vec<String> {
    let of = limit(study, f, language);
    let interval =
        |[low, high]: [f64; 2]| say!(language, "{least} to {most}", least = told(low), most = told(high));
    let dash = || "–".to_owned();
    let [theta, beta, error, correlation] = match &f.fit {
        Some(fit) => {
            let [[a, b], [_, c]] = fit.covariance;
            let error = format!("{}, {}", told(a.sqrt()), told(c.sqrt()));
            [measured(fit.theta, &f.unit), told(fit.beta), error, told(b / (a * c).sqrt())]
        }
        None => [dash(), dash(), dash(), dash()],
    };
    let [of_theta, of_beta] = match &f.bounds {
        Some(b) => [interval(b.theta), interval(b.beta)],
        None => [dash(), dash()],
    };
    vec![
        of,
        f.by.clone(),
        theta,
        of_theta,
        beta,
        of_beta,
        error,
        correlation,
        word(&f.method, language),
        caption(f, language),
    ]
}

fn over_records(study: &Study, language: Language) -> Vec<Vec<String>> {
    let row = |o: &tremolite_results::study::OverRecords| {
        let code = o.by_code.map_or_else(|| "–".to_owned(), told);
        let records = say!(language, "{some} of {all}", some = o.records, all = o.of);
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

fn head(study: &Study, language: Language) -> Vec<String> {
    let shown = |c: &tremolite_results::study::StudyColumn| {
        let unit = if c.shown.is_empty() { c.unit.clone().unwrap_or_default() } else { c.shown.clone() };
        over(&c.name, &unit)
    };
    let mut head = vec![say!(language, "run")];
    head.extend(study.parameters.iter().map(|p| p.name.clone()));
    if study.runs.iter().any(|r| r.record.is_some()) {
        head.push(say!(language, "record"));
    }
    if study.runs.iter().any(|r| r.factor.is_some()) {
        head.push(say!(language, "factor"));
    }
    head.extend(study.intensities.iter().chain(&study.measures).map(shown));
    head.extend(limits(study).into_iter().map(|name| limit_name(language, name)));
    if has_classes(study) {
        head.extend([say!(language, "state"), say!(language, "reliance")]);
    }
    head.push(say!(language, "ended"));
    head
}

/// Whether results of a run tell its state; those of older versions do not.
fn has_classes(study: &Study) -> bool {
    study.runs.iter().any(|run| run.state.is_some())
}

fn row(study: &Study, language: Language, run: &StudyRun) -> Vec<Cell> {
    let number = |x: Option<f64>| Cell::plain(x.map_or_else(|| "–".to_owned(), told));
    let mut row = vec![Cell { link: address(&run.page), ..Cell::plain(run.name.clone()) }];
    row.extend(run.values.iter().map(|v| {
        let as_written = |v: &str| v.trim_matches('"').to_owned();
        Cell::plain(v.as_deref().map_or_else(|| say!(language, "as it is"), as_written))
    }));
    if study.runs.iter().any(|r| r.record.is_some()) {
        row.push(Cell::plain(run.record.clone().unwrap_or_default()));
    }
    if study.runs.iter().any(|r| r.factor.is_some()) {
        row.push(number(run.factor));
    }
    row.extend(
        run.intensities.iter().zip(&study.intensities).map(|(x, c)| number(x.map(|x| x / c.shown_factor))),
    );
    row.extend(run.measures.iter().map(|x| number(*x)));
    row.extend(limits(study).into_iter().map(|name| held(language, run.limits.get(name))));
    if has_classes(study) {
        let dash = || "–".to_owned();
        row.push(Cell::plain(run.state.map_or_else(dash, |class| class_word(language, class))));
        row.push(Cell::plain(run.reliance.map_or_else(dash, |class| class_word(language, class))));
    }
    row.push(Cell::plain(ended(language, run.status)));
    row
}

/// All limits of acceptance that runs were held to, in the order in which they come.
fn limits(study: &Study) -> IndexSet<&str> {
    study.runs.iter().flat_map(|run| run.limits.keys().map(String::as_str)).collect()
}

/// How many runs meet all of their limits, of those that have any; nothing where none has.
fn met(study: &Study, language: Language) -> Option<String> {
    let held: Vec<&StudyRun> = study.runs.iter().filter(|run| !run.limits.is_empty()).collect();
    let all = |run: &&&StudyRun| run.limits.values().all(|limit| limit.met == Some(true));
    (!held.is_empty()).then(|| {
        say!(
            language,
            "{some} of {all} runs with results meet all limits of acceptance of their case",
            some = held.iter().filter(all).count(),
            all = held.len()
        )
    })
}

/// What a limit is called, by its key.
fn limit_name(language: Language, key: &str) -> String {
    match key {
        "displacement" => say!(language, "Displacement of a monitor"),
        "relative_displacement" => say!(language, "Relative displacement of two monitors"),
        "crack_width" => say!(language, "Crack width"),
        "damage" => say!(language, "Cracked share of a lining's volume"),
        "crushing" => say!(language, "Crushed or sheared share of a lining's volume"),
        "utilisation" => say!(language, "Utilisation of a section"),
        other => other.to_owned(),
    }
}

/// Whether a limit is met, with what was found.
fn held(language: Language, limit: Option<&StudyLimit>) -> Cell {
    let Some(limit) = limit else { return Cell::plain("–".into()) };
    let (class, text) = match limit.met {
        Some(true) => ("pass", say!(language, "met")),
        Some(false) => ("fail", say!(language, "not met")),
        None => ("", say!(language, "not known")),
    };
    // Widths and displacements are told in millimetres.
    let size = |x: f64| match limit.unit.as_str() {
        "m" => format!("{}\u{a0}mm", trimmed(&figures(1e3 * x, 3))),
        _ => told(x),
    };
    let note = match limit.found {
        Some(found) => format!("{}, ≤ {}", size(found), size(limit.limit)),
        None if limit.met == Some(false) => format!("∞, ≤ {}", size(limit.limit)),
        None => format!("≤ {}", size(limit.limit)),
    };
    Cell { class, note, ..Cell::plain(text) }
}

/// A path as an address: what has a meaning there is written by its number.
fn address(path: &str) -> String {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"/._-~".contains(&byte);
    path.bytes().map(|b| if plain(b) { char::from(b).to_string() } else { format!("%{b:02X}") }).collect()
}
