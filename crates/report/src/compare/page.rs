//! The page of a comparison.

use minijinja::value::Serde;
use serde::Serialize;
use tremolite_results::Assessment;

use super::Run;
use super::case_text::{Changes, changes};
use super::ended::{status, warning};
use super::histories::{figures_of, parting};
use super::numbers::{checks, head, tables};
use crate::chapter::text_table::{Cell, TextTable};
use crate::language::{Language, say};
use crate::page::templates::{SCRIPT, STYLE, environment, markup};
use crate::quantities::scale::{count, quantity, span, trimmed};
use crate::script::blocks::Blocks;
use crate::script::curves::embedded;
use crate::verdict::{assessment, word};

const TEMPLATE: &str = include_str!("../../template/compare.html");

#[derive(Serialize)]
struct ComparePage {
    language: &'static str,
    style: minijinja::Value,
    script: minijinja::Value,
    /// What the script reads.
    data: minijinja::Value,
    title: String,
    /// That runs are not done.
    warning: Option<String>,
    /// What each run is.
    runs: TextTable,
    changes: Vec<Changes>,
    tables: Vec<ComparePart>,
    parting: Option<TextTable>,
    checks: TextTable,
    /// Name by which the script knows it, and drawing.
    figures: Vec<(String, minijinja::Value)>,
    /// Why a run has no summary or no histories.
    missing: Vec<String>,
}

#[derive(Serialize)]
struct ComparePart {
    heading: String,
    table: TextTable,
}

/// The page as text.
pub fn html(runs: &[Run], language: Language) -> Result<String, minijinja::Error> {
    let names: Vec<&str> = runs.iter().map(|run| run.name.as_str()).collect();
    let figures = figures_of(runs, language);
    let mut blocks = Blocks::default();
    let of_figures =
        figures.iter().filter_map(|figure| Some((figure.file.as_str(), figure.curves.as_ref()?)));
    let (curves, _) = embedded(of_figures, &mut blocks, usize::MAX);
    let page = ComparePage {
        language: language.code(),
        style: markup(STYLE),
        script: markup(SCRIPT),
        data: markup(&(curves + &blocks.elements())),
        title: say!(language, "Comparison: {runs}", runs = names.join(", ")),
        warning: warning(runs, language),
        runs: what_they_are(runs, language),
        changes: changes(runs),
        tables: tables(runs, language)
            .into_iter()
            .map(|t| ComparePart { heading: t.heading, table: t.table })
            .collect(),
        parting: parting(runs, language),
        checks: checks(runs, language),
        figures: figures.into_iter().map(|f| (f.file, markup(&f.svg))).collect(),
        missing: missing(runs),
    };
    let mut environment = environment(language)?;
    environment.add_template("compare.html", TEMPLATE)?;
    environment.get_template("compare.html")?.render(Serde(&page))
}

fn missing(runs: &[Run]) -> Vec<String> {
    let mut missing = Vec::new();
    for run in runs {
        let reasons = [run.source.summary.as_ref().err(), run.source.monitors.as_ref().err()];
        missing.extend(reasons.into_iter().flatten().map(|why| format!("{}: {why}", run.name)));
    }
    missing
}

fn what_they_are(runs: &[Run], language: Language) -> TextTable {
    let facts: Vec<_> = runs.iter().map(|run| run.source.facts()).collect();
    let known = |text: String, known: bool| Cell::number(if known { text } else { "–".into() });
    let row = |label: String, of: &dyn Fn(&tremolite_results::Summary) -> Cell| -> Vec<Cell> {
        std::iter::once(Cell::words(label)).chain(facts.iter().map(of)).collect()
    };
    let ended = std::iter::once(Cell::words(say!(language, "how it ended")));
    let found: Vec<Assessment> = runs.iter().map(|run| assessment(&run.source)).collect();
    let judged = |label: String, of: &dyn Fn(&Assessment) -> String| -> Vec<Cell> {
        std::iter::once(Cell::words(label)).chain(found.iter().map(|found| Cell::number(of(found)))).collect()
    };
    let rows = vec![
        row(say!(language, "title"), &|s| Cell::words(&s.title)),
        ended.chain(runs.iter().map(|run| status(run, language))).collect(),
        judged(say!(language, "state"), &|found| word(language, found.state.class)),
        judged(say!(language, "reliance"), &|found| word(language, found.reliance.class)),
        row(say!(language, "checks that pass"), &|s| {
            let (judged, warnings) = (s.judged(), s.warnings());
            let text = say!(
                language,
                "{passed} of {judged}",
                passed = judged.saturating_sub(warnings),
                judged = judged
            );
            known(text, judged > 0)
        }),
        row(say!(language, "elements"), &|s| {
            known(count(s.computed.model.elements), s.computed.model.elements > 0)
        }),
        row(say!(language, "time step"), &|s| {
            known(quantity("s", s.computed.model.time_step), s.computed.model.time_step > 0.0)
        }),
        row(say!(language, "shaking"), &|s| {
            known(trimmed(&quantity("s", s.computed.model.duration)), s.computed.model.duration > 0.0)
        }),
        row(say!(language, "wall-clock time"), &|s| {
            known(span(s.computed.wall_seconds), s.computed.wall_seconds > 0.0)
        }),
        row(say!(language, "program"), &|s| known(s.case.version.clone(), !s.case.version.is_empty())),
    ];
    TextTable { head: vec![head(runs)], rows }
}
