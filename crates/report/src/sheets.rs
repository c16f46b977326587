//! The page's two sheets: what is signed. The first has project, verdict, limits, earthquake and model; the second figures, parts,
//! checks that warn, and the limits of the method.

mod earthquake;
pub mod limits;
mod model;
mod parts;

use minijinja::Value;
use serde::Serialize;
use tremolite_results::Summary;

use crate::chapter::figure::Figure;
use crate::chapter::text_table::TextTable;
use crate::damage::rates::{goes_by_rate, stronger};
use crate::facts::{self, Check, Fact};
use crate::language::{Language, say};
use crate::page::contents::{Content, Placed};
use crate::page::templates::markup;
use crate::sheets::limits::LimitRow;
use crate::source::Source;

/// What the template sets of both sheets.
#[derive(Serialize)]
pub struct Sheets {
    project: String,
    /// When the run started, and by what.
    dated: String,
    limits: Vec<LimitRow>,
    /// That some are not met; empty where all are.
    beyond: String,
    /// What to say where there are none.
    unlimited: String,
    earthquake: Vec<Fact>,
    model: Vec<Fact>,
    /// The record's spectrum, with that which the design calls for.
    spectrum: Option<SheetFigure>,
    signed: Vec<Signature>,
    figures: Vec<SheetFigure>,
    parts: TextTable,
    /// What is to be said below them.
    around: Vec<String>,
    warns: Vec<Check>,
    /// That no check warns, or that there are none.
    unwarned: String,
    method: Vec<String>,
}

#[derive(Serialize)]
struct Signature {
    role: String,
    name: String,
}

#[derive(Serialize)]
struct SheetFigure {
    heading: String,
    svg: Value,
    /// The same for a phone; nothing where one drawing serves all.
    slim: Value,
}

/// Figures that a sheet shows, the most telling first, by the beginnings of their files' names.
const TELLING: [&str; 10] = [
    "utilisation",
    "lining-damage",
    "damage",
    "developed",
    "section-strength",
    "lining-shape",
    "relative",
    "displacement",
    "section-deformed",
    "section-mesh",
];
/// The spectra of the motion, which the first sheet shows.
const SPECTRUM: &str = "input-spectra.svg";
/// As many as there is room for.
const FIGURES: usize = 4;

/// Both sheets.
pub fn sheets(source: &Source, summary: &Summary, sections: &[Placed]) -> Sheets {
    let language = source.language;
    let limits = limits::rows(source, summary);
    let warns: Vec<Check> =
        facts::checks(language, summary).into_iter().filter(|check| check.class == "fail").collect();
    Sheets {
        project: summary.case.report.project.clone(),
        dated: dated(language, summary),
        unlimited: match limits.is_empty() {
            true => say!(
                language,
                "No limits of acceptance are given: [report.limits] in the case, or tremolite report --limits FILE."
            ),
            false => String::new(),
        },
        beyond: match limits.iter().any(LimitRow::is_beyond) {
            true => say!(language, "not all are met"),
            false => String::new(),
        },
        limits,
        earthquake: earthquake::facts(source, summary),
        model: model::facts(source, summary),
        spectrum: drawn(sections).into_iter().find(|figure| figure.file == SPECTRUM).map(spectrum),
        signed: signed(language, summary),
        figures: figures(sections),
        parts: parts::table(source, summary),
        around: parts::around(source, summary),
        unwarned: match (warns.is_empty(), summary.judged()) {
            (true, 0) => say!(language, "Nothing was checked."),
            (true, all) => say!(language, "None: all {judged} checks pass.", judged = all),
            _ => String::new(),
        },
        warns,
        method: method(source, summary),
    }
}

fn dated(language: Language, summary: &Summary) -> String {
    let run = &summary.computed.run;
    match run.started.is_empty() {
        true => String::new(),
        false => {
            // To the minute: 2026-11-26T01:54:06Z.
            let started: String = run.started.chars().take(16).collect();
            let dated = say!(
                language,
                "Run of {started} UTC, {program}.",
                started = started.replace('T', " "),
                program = run.program
            );
            // The case by the beginning of its hash: enough to tell which file was run.
            let case = summary.case.inputs.iter().find(|input| input.name == "case");
            match case.map(|input| input.hash.chars().take(12).collect::<String>()) {
                Some(hash) if !hash.is_empty() => {
                    say!(language, "{run} Case {hash}.", run = dated, hash = hash)
                }
                _ => dated,
            }
        }
    }
}

fn signed(language: Language, summary: &Summary) -> Vec<Signature> {
    let roles = [
        ("designed", say!(language, "Designed")),
        ("checked", say!(language, "Checked")),
        ("reviewed", say!(language, "Reviewed")),
        ("approved", say!(language, "Approved")),
    ];
    let name = |role: &str| summary.case.report.signed.get(role).cloned().unwrap_or_default();
    roles.into_iter().map(|(key, role)| Signature { name: name(key), role }).collect()
}

/// All figures of the page.
fn drawn(sections: &[Placed]) -> Vec<&Figure> {
    let mut all = Vec::new();
    for placed in sections {
        if let Content::Section(section) = &placed.content {
            all.extend(section.figures());
        }
    }
    all
}

/// A drawing that begins at the height of those beside it.
fn set(svg: &str) -> Value {
    markup(&svg.replacen("<svg ", "<svg preserveAspectRatio=\"xMinYMin meet\" ", 1))
}

/// One of several side by side.
fn sheet_figure(figure: &Figure) -> SheetFigure {
    let svg = set(figure.narrow.as_ref().unwrap_or(&figure.svg));
    SheetFigure { heading: figure.heading.clone(), svg, slim: Value::from("") }
}

/// One as wide as the sheet, which on a phone gives way to its narrow drawing.
fn spectrum(figure: &Figure) -> SheetFigure {
    let slim = figure.narrow.as_ref().map_or_else(|| Value::from(""), |narrow| set(narrow));
    SheetFigure { heading: figure.heading.clone(), svg: set(&figure.svg), slim }
}

fn figures(sections: &[Placed]) -> Vec<SheetFigure> {
    let all = drawn(sections);
    let each = TELLING.iter().filter_map(|wanted| all.iter().find(|figure| figure.file.starts_with(wanted)));
    each.take(FIGURES).map(|figure| sheet_figure(figure)).collect()
}

/// What the method leaves out, for whoever signs.
fn method(source: &Source, summary: &Summary) -> Vec<String> {
    let language = source.language;
    let mut all = vec![
        match summary.computed.water.is_empty() {
            true => {
                say!(
                    language,
                    "Displacements and strains are small; there is no pore water and no temperature."
                )
            }
            false => say!(
                language,
                "Displacements and strains are small; water does not flow during the earthquake, and there is no temperature."
            ),
        },
        say!(language, "Plane waves come in from below; the ground beside the model is that of its sides."),
        match limits::tells_directions(summary) {
            true => say!(
                language,
                "The width of a crack is the sum of parallel ones in an element, and so depends on the mesh. A crack whose normal lies within 45° of the thickness is parallel to the wall: no bars cross it, and no limit of width judges it. Pieces that come loose are not followed."
            ),
            false => say!(
                language,
                "The width of a crack is the sum of parallel ones in an element, and so depends on the mesh; they may lie parallel to the wall, where bars round it do not cross them. Pieces that come loose are not followed."
            ),
        },
    ];
    if source.shakes() && goes_by_rate(summary) {
        let first = say!(
            language,
            "Concrete that is strained fast is stronger: thrust and moment may exceed what its static strength allows."
        );
        all.push(match stronger(language, summary) {
            Some(told) => say!(language, "{first} {second}", first = first, second = told),
            None => first,
        });
    }
    if summary.parts.sections.values().any(|of| !of.yields) {
        all.push(say!(
            language,
            "An elastic lining does not crack and so sheds no force: what it carries beyond its strength a real one could not."
        ));
    }
    if source.shakes() {
        all.push(say!(
            language,
            "Peaks of monitors and of cracks are those of the output rows; sections are judged in every step."
        ));
    }
    if summary.parts.sections.is_empty() {
        all.push(say!(
            language,
            "No section is judged by a code: [[section]] in the case asks for it. Detailing is not checked."
        ));
    } else {
        all.push(say!(
            language,
            "Utilisations are those of sections across the cavern's axis; slenderness, detailing and anchorage are not checked."
        ));
    }
    if !summary.computed.water.is_empty() && source.sections.is_some() {
        all.push(say!(
            language,
            "Section forces are of total stress; in a lining with pores the effective thrust is more tensile."
        ));
    }
    all
}
