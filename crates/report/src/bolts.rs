//! The chapter on bolts: what became of each group, what they carried stage by stage, and where they carry most.

mod force;
pub mod key_result;
mod map;

use indexmap::IndexMap;
use tremolite_results::{BoltLines, BoltPeak, BoltRow, BoltSummary, EARTHQUAKE, Pvd, Summary};

use crate::chapter::figure::{Block, Chapter};
use crate::chapter::text_table::{Cell, Head, TextTable};
use crate::language::{Language, say};
use crate::quantities::scale::{count, figures, moment, trimmed};
use crate::quantities::units::Kind;
use crate::source::Source;
use crate::stages;

const ID: &str = "bolts";
/// Groups side by side in one table.
const ABREAST: usize = 6;

/// The chapter; nothing for a run without bolts.
pub fn chapter(source: &Source) -> Option<Chapter> {
    let (language, facts) = (source.language, source.facts());
    if facts.parts.bolts.is_empty() && source.bolts.is_none() && !source.folder.bolts_pvd().exists() {
        return None;
    }
    let mut first = Block::default();
    if facts.parts.bolts.is_empty() {
        first.notes.push(say!(language, "No table of groups: the summary does not hold them yet."));
    } else {
        first.text = say!(
            language,
            "Of each group over the whole run. Forces are those of largest size of any stage and step, tension positive; a bolt counts under \
                      every heading it comes under, and what an excavation has taken of it counts no more. Places in m."
        );
        first.tables = vec![groups(source, &facts), deeds(source, &facts)];
    }
    let mut blocks = vec![first];
    match &source.bolts {
        Some(Ok(rows)) => {
            let detail = |block| Block { folded: source.shakes(), ..block };
            blocks.extend(by_stage(source, rows, &facts).into_iter().map(detail));
        }
        Some(Err(why)) => blocks.push(left_out(language, why)),
        None => {
            blocks.push(left_out(language, &say!(language, "There is no bolts.csv in the result folder.")));
        }
    }
    match last(source) {
        Ok(Last { lines, when, shaken }) => {
            blocks.extend(map::block(source, &lines, &when));
            let along = force::block(source, &lines, &facts, (&when, shaken));
            blocks.extend(along.into_iter().map(|block| Block { folded: true, ..block }));
        }
        Err(why) => blocks.push(left_out(language, &why)),
    }
    Some(Chapter { id: ID, heading: say!(language, "Bolts"), blocks })
}

fn left_out(language: Language, why: &str) -> Block {
    Block { notes: vec![say!(language, "Left out. {why}", why = why)], ..Block::default() }
}

/// The segments of the last file.
struct Last {
    lines: BoltLines,
    /// Of when they are, in words.
    when: String,
    /// Whether that is in the earthquake.
    shaken: bool,
}

fn last(source: &Source) -> Result<Last, String> {
    let language = source.language;
    let path = source.folder.bolts_pvd();
    if !path.exists() {
        return Err(say!(language, "There is no bolts.pvd in the result folder."));
    }
    let pvd = Pvd::read(&path).map_err(|e| format!("{e}."))?;
    let none = || say!(language, "bolts.pvd lists no file yet.");
    let last = pvd.snapshots().last().ok_or_else(none)?;
    let lines = BoltLines::read(&pvd.locate(last)).map_err(|e| format!("{e}."))?;
    // Without field files the list of the stages stays.
    let shaken = !last.file.contains("stage-");
    let when = if shaken {
        say!(language, "at {time}\u{a0}s", time = moment(last.time, source.duration()))
    } else {
        say!(language, "after the stages")
    };
    Ok(Last { lines, when, shaken })
}

/// What there is of each group.
fn groups(source: &Source, facts: &Summary) -> TextTable {
    let language = source.language;
    let head = vec![
        Head::words(say!(language, "group")),
        Head::words(say!(language, "placed in")),
        Head::number(say!(language, "bolts")),
        Head::number(say!(language, "left out")),
        Head::number(say!(language, "shortened")),
        Head::number(say!(language, "length (m)")),
        Head::number(say!(language, "yield at")),
        Head::number(say!(language, "cut by excavations")),
    ];
    let row = |(name, group): (&String, &BoltSummary)| {
        let placed = match group.placed.as_str() {
            "" => say!(language, "the start"),
            EARTHQUAKE => say!(language, "the earthquake"),
            stage => stage.to_owned(),
        };
        let yields = match group.yield_force.is_finite() {
            true => source.quantity(Kind::Force, group.yield_force),
            false => say!(language, "never"),
        };
        let gone = match group.gone {
            0 => String::new(),
            gone => say!(language, "{number} wholly", number = count(gone)),
        };
        vec![
            Cell::words(name.as_str()),
            Cell::words(placed),
            Cell::number(count(group.bolts)),
            Cell::number(count(group.left_out)),
            Cell::number(count(group.shortened)),
            Cell::number(figures(group.length, 3)),
            Cell::number(yields),
            Cell::number(count(group.cut)).with(gone),
        ]
    };
    TextTable { head: vec![head], rows: facts.parts.bolts.iter().map(row).collect() }
}

/// What became of it.
fn deeds(source: &Source, facts: &Summary) -> TextTable {
    let language = source.language;
    let head = vec![
        Head::words(say!(language, "group")),
        Head::number(say!(language, "largest force")),
        Head::words(say!(language, "of")),
        Head::number(say!(language, "over yield")),
        Head::number(say!(language, "yielded")),
        Head::number(say!(language, "broke")),
        Head::number(say!(language, "bond slid")),
    ];
    let row = |(name, group): (&String, &BoltSummary)| {
        let mut row = vec![Cell::words(name.as_str())];
        if !group.there {
            row.extend([Cell::number("–"), Cell::words(say!(language, "not placed yet"))]);
            row.extend((0..4).map(|_| Cell::number("–")));
            return row;
        }
        let over = match group.yield_force.is_finite() {
            true => figures(group.force_over_yield, 2),
            false => "–".into(),
        };
        let slid = match (group.bonded, group.slid) {
            (false, 0) => Cell::number("–").with(say!(language, "no bond")),
            (_, 0) => Cell::number("0"),
            (_, number) => {
                let slip = source.quantity(Kind::Opening, group.max_slip);
                Cell::number(count(number)).with(say!(language, "by up to {slip}", slip = slip))
            }
        };
        row.extend([
            Cell::number(source.quantity(Kind::Force, group.largest.force)),
            place(language, &group.largest, facts.computed.model.duration),
            Cell::number(over),
            Cell::number(count(group.yielded)),
            Cell::number(count(group.broken)),
            slid,
        ]);
        row
    };
    TextTable { head: vec![head], rows: facts.parts.bolts.iter().map(row).collect() }
}

/// Which bolt, where and when.
fn place(language: Language, peak: &BoltPeak, duration: f64) -> Cell {
    if peak.bolt == 0 {
        return Cell::words("");
    }
    let [x, y, z] = peak.at.map(|c| trimmed(&format!("{c:.1}").replace('-', "−")));
    let at = format!("({x},\u{a0}{y},\u{a0}{z})");
    let place = match peak.stage.as_str() {
        EARTHQUAKE => {
            say!(language, "{at}, at\u{a0}{time}\u{a0}s", at = at, time = moment(peak.time, duration))
        }
        stage => {
            say!(language, "{at}, in {stage}", at = at, stage = stages::names::name(language, stage))
        }
    };
    Cell::words(say!(language, "bolt\u{a0}{number}", number = peak.bolt)).with(place)
}

/// What each group carried at most at the end of each stage, and in the rows of the earthquake.
fn by_stage(source: &Source, rows: &[BoltRow], facts: &Summary) -> Option<Block> {
    let language = source.language;
    // By stage, then by group: the largest share of yield, and the largest force.
    let mut stages: IndexMap<&str, IndexMap<&str, (f64, f64)>> = IndexMap::new();
    let mut names: IndexMap<&str, ()> = facts.parts.bolts.keys().map(|name| (name.as_str(), ())).collect();
    for row in rows {
        names.entry(&row.name).or_default();
        let most = stages.entry(&row.stage).or_default().entry(&row.name).or_default();
        *most = (most.0.max(row.force_over_yield), most.1.max(row.max_force.abs()));
    }
    if stages.len() < 2 {
        return None;
    }
    let all: Vec<&str> = names.into_keys().collect();
    let table = |names: &[&str]| {
        let head = names.iter().map(|name| Head::number(*name));
        let cell = |most: Option<&(f64, f64)>| match most {
            None => Cell::number("–"),
            Some((0.0, force)) => Cell::number(source.quantity(Kind::Force, *force)),
            Some((over, force)) => Cell::number(figures(*over, 2)).with(source.quantity(Kind::Force, *force)),
        };
        let row = |(stage, groups): (&&str, &IndexMap<&str, (f64, f64)>)| {
            let stage = match *stage {
                EARTHQUAKE => say!(language, "earthquake, largest of its rows"),
                stage => stages::names::name(language, stage),
            };
            std::iter::once(Cell::words(stage))
                .chain(names.iter().map(|name| cell(groups.get(name))))
                .collect()
        };
        TextTable {
            head: vec![std::iter::once(Head::words(say!(language, "at the end of"))).chain(head).collect()],
            rows: stages.iter().map(row).collect(),
        }
    };
    Some(Block {
        heading: say!(language, "Force over yield, stage by stage"),
        text: say!(
            language,
            "Of the bolt of each group that is nearest to yield then, with the largest force below it; of groups that never \
               yield the force. A group that takes on load in every stage after its own holds ground that still moves."
        ),
        tables: all.chunks(ABREAST).map(table).collect(),
        ..Block::default()
    })
}
