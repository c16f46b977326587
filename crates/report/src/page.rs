//! The page: the template filled in.

use minijinja::syntax::SyntaxConfig;
use minijinja::value::Serde;
use minijinja::{AutoEscape, Environment, Value};
use serde::Serialize;
use tremolite_results::Defaulted;

use crate::blocks::Blocks;
use crate::cards;
use crate::damage::{self, CrackRow, DamageTable};
use crate::facts::{self, Check, Fact, Outcome};
use crate::figure::{Block, Chapter, Section};
use crate::interfaces::{self, InterfaceTable};
use crate::materials::{self, MaterialTable};
use crate::peaks::{self, PeakTable};
use crate::source::Source;
use crate::svg::escape;
use crate::text_table::TextTable;
use crate::view;

const TEMPLATE: &str = include_str!("../template/report.html");
const STYLE: &str = include_str!("../template/report.css");
/// Built from `page/src`, checked in.
const SCRIPT: &str = include_str!("../page/dist/page.js");

#[derive(Serialize)]
struct Page {
    language: &'static str,
    style: Value,
    /// The blocks of the view in three dimensions.
    view: Value,
    script: Value,
    title: String,
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
    chapters: Vec<Leaf>,
    /// What to say in the place of the shaking; nothing where there is one.
    still: Option<String>,
    sections: Vec<Part>,
    peaks: Vec<PeakTable>,
    interval: Option<String>,
    defaulted: Vec<Defaulted>,
    has_summary: bool,
    /// Whether to say that there was nothing to judge.
    unjudged: bool,
    run: Vec<Fact>,
    cut: bool,
    /// Of the result files those that are there: what they are, and their names.
    files: Vec<(&'static str, Vec<&'static str>)>,
}

/// A chapter as it is set.
#[derive(Serialize)]
struct Leaf {
    id: &'static str,
    heading: String,
    blocks: Vec<Paragraph>,
}

/// A block as it is set.
#[derive(Serialize)]
struct Paragraph {
    heading: String,
    lead: String,
    text: String,
    tables: Vec<TextTable>,
    figures: Vec<Drawing>,
    notes: Vec<String>,
}

/// One section with figures, or blocks with tables and figures, or the reason for having none.
#[derive(Default, Serialize)]
struct Part {
    id: &'static str,
    heading: String,
    why: String,
    figures: Vec<Drawing>,
    blocks: Vec<Paragraph>,
}

#[derive(Serialize)]
struct Drawing {
    svg: Value,
    caption: String,
}

/// The page as text. All text from files is escaped by the template; only the drawings, which escape their
/// own texts, go in as they are.
pub fn html(source: &Source, chapters: &[Chapter], sections: &[Section]) -> Result<String, minijinja::Error> {
    let (summary, language) = (source.facts(), source.language);
    let title = if summary.title.is_empty() {
        let path = source.folder.root();
        path.file_name().map_or_else(|| "Results".into(), |name| name.to_string_lossy().into_owned())
    } else {
        summary.title.clone()
    };
    let mut blocks = Blocks::default();
    let view = view::embedded(source, &mut blocks) + &blocks.elements();
    let page = Page {
        language: source.language.code(),
        view: Value::from_safe_string(view),
        script: Value::from_safe_string(SCRIPT.into()),
        style: Value::from_safe_string(STYLE.into()),
        title,
        outcome: facts::outcome(source),
        findings: facts::findings(language, &summary),
        cards: cards::key_results(source),
        checks: facts::checks(language, &summary),
        warnings: facts::warnings(language, &summary),
        model: facts::model(language, &summary),
        materials: materials::tables(language, &summary),
        damage: damage::tables(&summary),
        cracks: damage::cracks(&summary),
        interfaces: interfaces::table(&summary),
        chapters: chapters.iter().map(leaf).collect(),
        still: source.still(),
        sections: sections.iter().map(part).collect(),
        peaks: peaks::peaks(source),
        interval: peaks::interval(source),
        defaulted: summary.defaulted.clone(),
        has_summary: source.summary.is_ok(),
        unjudged: source.summary.is_ok()
            && summary.findings.is_empty()
            && source.still().is_none()
            && !summary.stages.iter().any(|stage| stage.plastic_volume > 0.0),
        run: facts::run(language, &summary),
        cut: [Some(&source.monitors), Some(&source.energy), source.relaxation.as_ref()]
            .into_iter()
            .flatten()
            .any(|table| table.as_ref().is_ok_and(|t| t.cut))
            || matches!(&source.free_field, Some(Ok(found)) if found.cut),
        files: files(source),
    };
    let mut environment = Environment::new();
    environment.set_auto_escape_callback(|_| AutoEscape::Html);
    environment.set_syntax(SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build()?);
    environment.add_filter("dots", dots);
    environment.add_function("t", move |english: &str| language.pattern(english).to_owned());
    environment.add_template("report.html", TEMPLATE)?;
    environment.get_template("report.html")?.render(Serde(&page))
}

/// A name of several parts, which may break behind its dots and nowhere else.
fn dots(name: String) -> Value {
    Value::from_safe_string(escape(&name).replace('.', ".<wbr>"))
}

/// The result files that are there.
fn files(source: &Source) -> Vec<(&'static str, Vec<&'static str>)> {
    let kinds = [
        (
            "Numbers in full",
            &[
                "monitors.csv",
                "energy.csv",
                "motion.csv",
                "free_field.csv",
                "damage.csv",
                "interfaces.csv",
                "stages.csv",
                "relaxation.csv",
                "sections.csv",
                "bolts.csv",
                "summary.json",
            ][..],
        ),
        ("Fields for ParaView", &["fields.pvd", "interfaces.pvd", "bolts.pvd", "stages.pvd"]),
        ("The case as it was read", &["case.toml"]),
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

fn leaf(chapter: &Chapter) -> Leaf {
    let paragraph = |block: &Block| Paragraph {
        heading: block.heading.clone(),
        lead: block.lead.clone(),
        text: block.text.clone(),
        tables: block.tables.clone(),
        figures: block.figures.iter().map(drawing).collect(),
        notes: block.notes.clone(),
    };
    Leaf {
        id: chapter.id,
        heading: chapter.heading.clone(),
        blocks: chapter.blocks.iter().map(paragraph).collect(),
    }
}

fn part(section: &Section) -> Part {
    match section {
        Section::LeftOut { heading, why } => {
            Part { heading: heading.clone(), why: why.clone(), ..Part::default() }
        }
        Section::Drawn(figures) => Part {
            heading: figures.first().map(|figure| figure.heading.clone()).unwrap_or_default(),
            figures: figures.iter().map(drawing).collect(),
            ..Part::default()
        },
        Section::Told(chapter) => {
            let Leaf { id, heading, blocks } = leaf(chapter);
            Part { id, heading, blocks, ..Part::default() }
        }
    }
}

fn drawing(figure: &crate::figure::Figure) -> Drawing {
    Drawing { svg: Value::from_safe_string(figure.svg.clone()), caption: figure.caption.clone() }
}
