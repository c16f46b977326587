//! The page: the template filled in.
//!
//! [`contents`] is its order.

pub mod contents;
pub mod part;
pub mod size;
pub mod templates;

use minijinja::Value;
use minijinja::value::Serde;
use serde::Serialize;
use tremolite_results::{Defaulted, Summary};

use crate::damage::crack_widths::width_by_mesh;
use crate::damage::rates::{RateRow, rates};
use crate::damage::{self, CrackRow, DamageTable};
use crate::facts::key_results::key_results;
use crate::facts::materials::{self, MaterialTable};
use crate::facts::peaks::{self, PeakTable};
use crate::facts::{self, Check, Fact, Outcome};
use crate::histories::gaps;
use crate::interfaces::{self, InterfaceTable};
use crate::language::{Language, say};
use crate::page::contents::Placed;
use crate::page::part::{PagePart, part};
use crate::page::templates::{SCRIPT, STYLE, environment, markup};
use crate::sheets::{Sheets, sheets};
use crate::source::Source;
use crate::verdict::{self, Verdict};

const TEMPLATE: &str = include_str!("../template/report.html");

/// What the template sets. What only one section says is in a field of that section's name.
#[derive(Serialize)]
struct Page {
    frame: Frame,
    head: Head,
    sheets: Sheets,
    /// In their order.
    sections: Vec<PagePart>,
    /// Whether there is a summary: without one several sections can only say so.
    has_summary: bool,
    findings: Findings,
    shaking: Shaking,
    damage: Damage,
    interfaces: Option<InterfaceTable>,
    /// Lines of the trust report.
    checks: Vec<Check>,
    given: Given,
    run: Run,
}

/// What holds the page, whatever stands on it.
#[derive(Serialize)]
struct Frame {
    language: &'static str,
    style: Value,
    /// The blocks of the view in three dimensions.
    view: Value,
    script: Value,
}

/// What stands above the contents.
#[derive(Serialize)]
struct Head {
    title: String,
    /// In what the case's bare numbers were, where it has any.
    units: Option<String>,
    verdict: Verdict,
    /// Whether a table ends in the middle of a line.
    cut: bool,
    /// That a table has values that are no number.
    gaps: Option<String>,
    cards: Vec<Fact>,
}

/// How the run ended and what became of each structure.
#[derive(Serialize)]
struct Findings {
    run: Outcome,
    structures: Vec<Outcome>,
    /// Whether to say that there was nothing to judge.
    unjudged: bool,
}

/// What moved, or why nothing did.
#[derive(Serialize)]
struct Shaking {
    /// What to say in the place of the shaking; nothing where there is one.
    still: Option<String>,
    peaks: Vec<PeakTable>,
    /// What peaks are taken from.
    peaks_of: String,
}

/// What is damaged at the end.
#[derive(Serialize)]
struct Damage {
    tables: Vec<DamageTable>,
    cracks: Vec<CrackRow>,
    rates: Vec<RateRow>,
    /// What is to be said beside widths of cracks.
    width_by_mesh: String,
}

/// What was given: the model, its materials and the case.
#[derive(Serialize)]
struct Given {
    model: Vec<Fact>,
    materials: Vec<MaterialTable>,
    /// What was said before the run.
    warnings: Vec<Value>,
    defaulted: Vec<Defaulted>,
    /// The case as it was read.
    case: Option<String>,
}

/// The run itself, and what it left.
#[derive(Serialize)]
struct Run {
    facts: Vec<Fact>,
    /// Of the result files those that are there: what they are, and their names.
    files: Vec<(String, Vec<&'static str>)>,
    /// That some figures are drawings alone, for the sake of the page's size; empty where none is.
    drawings: String,
}

/// The page as text; `data` is what its script reads, and so many figures were `left` without. All text from files is escaped by the template; only the drawings, which
/// escape their own texts, go in as they are.
pub fn html(
    source: &Source,
    sections: &[Placed],
    left: usize,
    data: String,
) -> Result<String, minijinja::Error> {
    let language = source.language;
    let summary = source.facts();
    let page = Page {
        frame: Frame {
            language: language.code(),
            style: markup(STYLE),
            view: markup(&data),
            script: markup(SCRIPT),
        },
        head: head(source, &summary),
        sheets: sheets(source, &summary, sections),
        sections: sections.iter().map(part).collect(),
        has_summary: source.summary.is_ok(),
        findings: findings(source, &summary),
        shaking: Shaking { still: source.still(), peaks: peaks::peaks(source), peaks_of: peaks_of(source) },
        damage: Damage {
            tables: damage::tables(language, &summary),
            cracks: damage::cracks(source, &summary),
            rates: rates(language, &summary),
            width_by_mesh: width_by_mesh(language),
        },
        interfaces: interfaces::table(source, &summary),
        checks: facts::checks(language, &summary),
        given: Given {
            model: facts::model(source, &summary),
            materials: materials::tables(language, &summary),
            warnings: facts::warnings(language, &summary),
            defaulted: summary.case.defaults_used.clone(),
            case: source.case.clone(),
        },
        run: Run {
            facts: facts::run(language, &summary),
            files: files(source),
            drawings: drawings(language, left),
        },
    };
    let mut environment = environment(language)?;
    environment.add_template("report.html", TEMPLATE)?;
    environment.get_template("report.html")?.render(Serde(&page))
}

fn head(source: &Source, summary: &Summary) -> Head {
    let title = if summary.title.is_empty() {
        let path = source.folder.root();
        path.file_name()
            .map_or_else(|| say!(source.language, "Results"), |name| name.to_string_lossy().into_owned())
    } else {
        summary.title.clone()
    };
    let mut tables =
        [Some(&source.monitors), Some(&source.energy), source.relaxation.as_ref()].into_iter().flatten();
    let cut = tables.any(|table| table.as_ref().is_ok_and(|t| t.cut))
        || matches!(&source.free_field, Some(Ok(found)) if found.cut);
    let units = summary.case.assume_si.then(|| {
        say!(
            source.language,
            "The case says units = \"SI\": its numbers without a unit are in SI, angles excepted."
        )
    });
    Head {
        title,
        units,
        verdict: verdict::verdict(source),
        cut,
        gaps: gaps::told(source),
        cards: key_results(source),
    }
}

fn findings(source: &Source, summary: &Summary) -> Findings {
    Findings {
        run: facts::outcome(source),
        structures: facts::findings(source.language, summary),
        unjudged: source.summary.is_ok()
            && summary.conclusion.findings.is_empty()
            && source.still().is_none()
            && !summary.computed.stages.iter().any(|stage| stage.plastic_volume > 0.0),
    }
}

/// That so many figures were left as drawings.
fn drawings(language: Language, left: usize) -> String {
    match left {
        0 => String::new(),
        _ => say!(
            language,
            "To keep the page small {figures} figures with curves, far down, are drawings alone.",
            figures = left
        ),
    }
}

/// What peaks are taken from.
fn peaks_of(source: &Source) -> String {
    let language = source.language;
    let first = say!(language, "Times in s. The last column is the value at the end of the run.");
    let Some(interval) = peaks::interval(source) else { return first };
    say!(
        language,
        "{first} Taken from the rows of monitors.csv, {interval} apart; beside them the largest and the smallest value of all steps, where \
         those were followed. Where the two differ the rows are too far apart (a shorter output.histories shows it), or something rings: \
         an acceleration of one step is that of a crack that closes as well as that of the ground.",
        first = first,
        interval = interval
    )
}

/// The result files that are there.
fn files(source: &Source) -> Vec<(String, Vec<&'static str>)> {
    let language = source.language;
    let kinds = [
        (
            say!(language, "Numbers in full"),
            &[
                "monitors.csv",
                "energy.csv",
                "motion.csv",
                "free_field.csv",
                "spectra.csv",
                "depth.csv",
                "damage.csv",
                "interfaces.csv",
                "stages.csv",
                "relaxation.csv",
                "sections.csv",
                "utilisation.csv",
                "bolts.csv",
                "summary.json",
            ][..],
        ),
        (say!(language, "Fields for ParaView"), &["fields.pvd", "interfaces.pvd", "bolts.pvd", "stages.pvd"]),
        (say!(language, "The case as it was read"), &["case.toml"]),
    ];
    let root = source.folder.root();
    let there = |names: &[&'static str]| -> Vec<&'static str> {
        names.iter().copied().filter(|name| root.join(name).exists()).collect()
    };
    kinds
        .map(|(what, names)| (what, there(names)))
        .into_iter()
        .filter(|(_, names)| !names.is_empty())
        .collect()
}
