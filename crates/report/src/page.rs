//! The page: the template filled in.
//!
//! [`contents`] is its order.

pub mod contents;
pub mod size;
pub mod templates;

use minijinja::Value;
use minijinja::value::Serde;
use serde::Serialize;
use tremolite_results::Defaulted;

use crate::chapter::figure::{Block, Figure, Section};
use crate::chapter::text_table::TextTable;
use crate::damage::crack_widths::width_by_mesh;
use crate::damage::{self, CrackRow, DamageTable};
use crate::drawing::svg;
use crate::facts::key_results::key_results;
use crate::facts::materials::{self, MaterialTable};
use crate::facts::peaks::{self, PeakTable};
use crate::facts::{self, Check, Fact, Outcome};
use crate::histories::gaps;
use crate::interfaces::{self, InterfaceTable};
use crate::language::say;
use crate::page::contents::{Content, Placed};
use crate::page::templates::{SCRIPT, STYLE, environment, markup};
use crate::source::Source;
use crate::verdict::{self, Verdict};

const TEMPLATE: &str = include_str!("../template/report.html");

#[derive(Serialize)]
struct Page {
    language: &'static str,
    style: Value,
    /// The blocks of the view in three dimensions.
    view: Value,
    script: Value,
    title: String,
    verdict: Verdict,
    outcome: Outcome,
    findings: Vec<Outcome>,
    cards: Vec<Fact>,
    checks: Vec<Check>,
    warnings: Vec<Value>,
    model: Vec<Fact>,
    materials: Vec<MaterialTable>,
    damage: Vec<DamageTable>,
    cracks: Vec<CrackRow>,
    interfaces: Option<InterfaceTable>,
    /// In their order.
    sections: Vec<PagePart>,
    /// What to say in the place of the shaking; nothing where there is one.
    still: Option<String>,
    peaks: Vec<PeakTable>,
    /// What peaks are taken from.
    peaks_of: String,
    /// What is to be said beside widths of cracks.
    width_by_mesh: String,
    defaulted: Vec<Defaulted>,
    has_summary: bool,
    /// Whether to say that there was nothing to judge.
    unjudged: bool,
    run: Vec<Fact>,
    cut: bool,
    /// That a table has values that are no number.
    gaps: Option<String>,
    /// Of the result files those that are there: what they are, and their names.
    files: Vec<(String, Vec<&'static str>)>,
    /// The case as it was read.
    case: Option<String>,
    /// That some figures are drawings alone, for the sake of the page's size; empty where none is.
    drawings: String,
}

/// A block as it is set.
#[derive(Serialize)]
struct Paragraph {
    heading: String,
    lead: String,
    text: String,
    tables: Vec<TextTable>,
    figures: Vec<PageDrawing>,
    notes: Vec<String>,
}

/// One section: what the template sets by its id; or figures, or blocks with tables and figures, or the reason for having
/// none.
#[derive(Default, Serialize)]
struct PagePart {
    id: String,
    heading: String,
    template: bool,
    why: String,
    figures: Vec<PageDrawing>,
    blocks: Vec<Paragraph>,
}

#[derive(Serialize)]
struct PageDrawing {
    /// The name by which the manifest of the curves knows it; empty for a figure without.
    curves: String,
    svg: Value,
    /// How much of a page of paper it wants: `tall` all of it, `high` more than half; else nothing.
    height: &'static str,
    caption: String,
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
    let title = if summary.title.is_empty() {
        let path = source.folder.root();
        path.file_name().map_or_else(|| say!(language, "Results"), |name| name.to_string_lossy().into_owned())
    } else {
        summary.title.clone()
    };
    let page = Page {
        language: language.code(),
        view: markup(&data),
        script: markup(SCRIPT),
        style: markup(STYLE),
        title,
        verdict: verdict::verdict(source),
        outcome: facts::outcome(source),
        findings: facts::findings(language, &summary),
        cards: key_results(source),
        checks: facts::checks(language, &summary),
        warnings: facts::warnings(language, &summary),
        model: facts::model(source, &summary),
        materials: materials::tables(language, &summary),
        damage: damage::tables(source.language, &summary),
        cracks: damage::cracks(source, &summary),
        interfaces: interfaces::table(source, &summary),
        still: source.still(),
        sections: sections.iter().map(part).collect(),
        peaks: peaks::peaks(source),
        peaks_of: peaks_of(source),
        width_by_mesh: width_by_mesh(source.language),
        defaulted: summary.case.defaulted.clone(),
        has_summary: source.summary.is_ok(),
        unjudged: source.summary.is_ok()
            && summary.conclusion.findings.is_empty()
            && source.still().is_none()
            && !summary.computed.stages.iter().any(|stage| stage.plastic_volume > 0.0),
        run: facts::run(language, &summary),
        cut: [Some(&source.monitors), Some(&source.energy), source.relaxation.as_ref()]
            .into_iter()
            .flatten()
            .any(|table| table.as_ref().is_ok_and(|t| t.cut))
            || matches!(&source.free_field, Some(Ok(found)) if found.cut),
        gaps: gaps::told(source),
        files: files(source),
        case: source.case.clone(),
        drawings: match left {
            0 => String::new(),
            _ => say!(
                language,
                "To keep the page small {figures} figures with curves, far down, are drawings alone.",
                figures = left
            ),
        },
    };
    let mut environment = environment(language)?;
    environment.add_template("report.html", TEMPLATE)?;
    environment.get_template("report.html")?.render(Serde(&page))
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

fn paragraph(block: &Block) -> Paragraph {
    Paragraph {
        heading: block.heading.clone(),
        lead: block.lead.clone(),
        text: block.text.clone(),
        tables: block.tables.clone(),
        figures: block.figures.iter().map(drawing).collect(),
        notes: block.notes.clone(),
    }
}

fn part(placed: &Placed) -> PagePart {
    let part = PagePart { id: placed.id.clone(), heading: placed.heading.clone(), ..PagePart::default() };
    match &placed.content {
        Content::Template => PagePart { template: true, ..part },
        Content::Section(Section::LeftOut { why, .. }) => PagePart { why: why.clone(), ..part },
        Content::Section(Section::Drawn(figures)) => {
            PagePart { figures: figures.iter().map(drawing).collect(), ..part }
        }
        Content::Section(Section::Told(chapter)) => {
            PagePart { blocks: chapter.blocks.iter().map(paragraph).collect(), ..part }
        }
    }
}

/// Height over width from which on a figure has a page of its own, or more than half of one: shrunk to half a page its texts
/// could not be read.
const TALL: f64 = 1.0;
const HIGH: f64 = 0.75;

fn drawing(figure: &Figure) -> PageDrawing {
    let height = match svg::proportion(&figure.svg) {
        Some(proportion) if proportion > TALL => "tall",
        Some(proportion) if proportion > HIGH => "high",
        _ => "",
    };
    PageDrawing {
        curves: figure.curves.as_ref().map(|_| figure.file.clone()).unwrap_or_default(),
        svg: markup(&figure.svg),
        height,
        caption: figure.caption.clone(),
    }
}
