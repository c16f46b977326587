//! The chapter on bolts: what became of each group, what they carried stage by stage, and where they carry most.

use indexmap::IndexMap;
use tremolite_results::{BoltLines, BoltPeak, BoltRow, BoltSummary, EARTHQUAKE, Pvd, Summary};

use crate::figure::{Block, Chapter};
use crate::scale::{count, figures, moment, quantity, trimmed};
use crate::source::Source;
use crate::text_table::{Cell, Head, TextTable};
use crate::{bolt_force, bolt_map};

const ID: &str = "bolts";
/// Groups side by side in one table.
const ABREAST: usize = 6;

/// The chapter; nothing for a run without bolts.
pub fn chapter(source: &Source) -> Option<Chapter> {
    let facts = source.facts();
    if facts.bolts.is_empty() && source.bolts.is_none() && !source.folder.bolts_pvd().exists() {
        return None;
    }
    let mut first = Block::default();
    if facts.bolts.is_empty() {
        first.notes.push("No table of groups: the summary does not hold them yet.".into());
    } else {
        first.text = "Of each group over the whole run. Forces are those of largest size of any stage and step, tension positive; a bolt counts under \
                      every heading it comes under, and what an excavation has taken of it counts no more. Places in m."
            .into();
        first.tables = vec![groups(&facts), deeds(&facts)];
    }
    let mut blocks = vec![first];
    match &source.bolts {
        Some(Ok(rows)) => blocks.extend(by_stage(rows, &facts)),
        Some(Err(why)) => blocks.push(left_out(why)),
        None => blocks.push(left_out("There is no bolts.csv in the result folder.")),
    }
    match last(source) {
        Ok((lines, when)) => {
            blocks.extend(bolt_map::block(source, &lines, &when));
            blocks.extend(bolt_force::block(&lines, &facts, &when));
        }
        Err(why) => blocks.push(left_out(&why)),
    }
    Some(Chapter { id: ID, heading: "Bolts".into(), blocks })
}

fn left_out(why: &str) -> Block {
    Block { notes: vec![format!("Left out. {why}")], ..Block::default() }
}

/// The segments of the last file, and of when they are.
fn last(source: &Source) -> Result<(BoltLines, String), String> {
    let path = source.folder.bolts_pvd();
    if !path.exists() {
        return Err("There is no bolts.pvd in the result folder.".into());
    }
    let pvd = Pvd::read(&path).map_err(|e| format!("{e}."))?;
    let last = pvd.snapshots().last().ok_or("bolts.pvd lists no file yet.")?;
    let lines = BoltLines::read(&pvd.locate(last)).map_err(|e| format!("{e}."))?;
    // Without field files the list of the stages stays.
    let when = if last.file.contains("stage-") {
        "when the stages are done".into()
    } else {
        format!("at {}\u{a0}s", moment(last.time, crate::facts::duration(source)))
    };
    Ok((lines, when))
}

/// What there is of each group.
fn groups(facts: &Summary) -> TextTable {
    let head = vec![
        Head::words("group"),
        Head::words("placed in"),
        Head::number("bolts"),
        Head::number("left out"),
        Head::number("shortened"),
        Head::number("length (m)"),
        Head::number("yield at"),
        Head::number("cut by excavations"),
    ];
    let row = |(name, group): (&String, &BoltSummary)| {
        let placed = match group.placed.as_str() {
            "" => "the start",
            EARTHQUAKE => "the earthquake",
            stage => stage,
        };
        let yields = match group.yield_force.is_finite() {
            true => quantity("N", group.yield_force),
            false => "never".into(),
        };
        let gone = if group.gone > 0 { format!("{} wholly", count(group.gone)) } else { String::new() };
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
    TextTable { head: vec![head], rows: facts.bolts.iter().map(row).collect() }
}

/// What became of it.
fn deeds(facts: &Summary) -> TextTable {
    let head = vec![
        Head::words("group"),
        Head::number("largest force"),
        Head::words("of"),
        Head::number("over yield"),
        Head::number("yielded"),
        Head::number("broke"),
        Head::number("bond slid"),
    ];
    let row = |(name, group): (&String, &BoltSummary)| {
        let mut row = vec![Cell::words(name.as_str())];
        if !group.there {
            row.extend([Cell::number("–"), Cell::words("not placed yet")]);
            row.extend((0..4).map(|_| Cell::number("–")));
            return row;
        }
        let over = match group.yield_force.is_finite() {
            true => figures(group.force_over_yield, 2),
            false => "–".into(),
        };
        let slid = match (group.bonded, group.slid) {
            (false, 0) => Cell::number("–").with("no bond"),
            (_, 0) => Cell::number("0"),
            (_, number) => {
                Cell::number(count(number)).with(format!("by up to {}", quantity("m", group.max_slip)))
            }
        };
        row.extend([
            Cell::number(quantity("N", group.largest.force)),
            place(&group.largest, facts.model.duration),
            Cell::number(over),
            Cell::number(count(group.yielded)),
            Cell::number(count(group.broken)),
            slid,
        ]);
        row
    };
    TextTable { head: vec![head], rows: facts.bolts.iter().map(row).collect() }
}

/// Which bolt, where and when.
fn place(peak: &BoltPeak, duration: f64) -> Cell {
    if peak.bolt == 0 {
        return Cell::words("");
    }
    let [x, y, z] = peak.at.map(|c| trimmed(&format!("{c:.1}").replace('-', "−")));
    let when = match peak.stage.as_str() {
        EARTHQUAKE => format!("at\u{a0}{}\u{a0}s", moment(peak.time, duration)),
        stage => format!("in {stage}"),
    };
    Cell::words(format!("bolt\u{a0}{}", peak.bolt)).with(format!("({x},\u{a0}{y},\u{a0}{z}), {when}"))
}

/// What each group carried at most at the end of each stage, and in the rows of the earthquake.
fn by_stage(rows: &[BoltRow], facts: &Summary) -> Option<Block> {
    // By stage, then by group: the largest share of yield, and the largest force.
    let mut stages: IndexMap<&str, IndexMap<&str, (f64, f64)>> = IndexMap::new();
    let mut names: IndexMap<&str, ()> = facts.bolts.keys().map(|name| (name.as_str(), ())).collect();
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
            Some((0.0, force)) => Cell::number(quantity("N", *force)),
            Some((over, force)) => Cell::number(figures(*over, 2)).with(quantity("N", *force)),
        };
        let row = |(stage, groups): (&&str, &IndexMap<&str, (f64, f64)>)| {
            let stage = if *stage == EARTHQUAKE { "earthquake, largest of its rows" } else { stage };
            std::iter::once(Cell::words(stage))
                .chain(names.iter().map(|name| cell(groups.get(name))))
                .collect()
        };
        TextTable {
            head: vec![std::iter::once(Head::words("at the end of")).chain(head).collect()],
            rows: stages.iter().map(row).collect(),
        }
    };
    Some(Block {
        heading: "Force over yield, stage by stage".into(),
        text: "Of the bolt of each group that is nearest to yield then, with the largest force below it; of groups that never \
               yield the force. A group that takes on load in every stage after its own holds ground that still moves."
            .into(),
        tables: all.chunks(ABREAST).map(table).collect(),
        ..Block::default()
    })
}
