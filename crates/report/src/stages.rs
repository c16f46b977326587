//! What came before the earthquake: the stages as a table, and the figures of them.

mod convergence;
mod force_displacement;
mod ground_reaction;
mod maps;
pub mod names;
mod relaxation;
mod seepage;

use tremolite_results::{StageSummary, Summary};

use crate::chapter::figure::{Block, Chapter};
use crate::chapter::text_table::{Cell, Head, TextTable};
use crate::language::{Language, say};
use crate::quantities::scale::{count, figures, trimmed};
use crate::quantities::units::Kind;
use crate::source::Source;
use crate::stages::names::{called, name};

/// A sum over the sum of the sizes of its parts, or a value over the largest of its kind, below this is round-off.
const ROUND_OFF: f64 = 1e-12;
/// Characters.
const SHORT: usize = 12;

/// The chapter; nothing for a run without stages.
pub fn chapter(source: &Source) -> Option<Chapter> {
    let (language, facts) = (source.language, source.facts());
    if facts.computed.stages.is_empty() && source.relaxation.is_none() {
        return None;
    }
    let mut blocks = vec![table(source, &facts)];
    blocks.extend(seepage::table(source, &facts));
    blocks.extend(force_displacement::block(source, &facts));
    let detail = |block| Block { folded: true, ..block };
    blocks.extend(relaxation::block(source, &facts).map(detail));
    blocks.extend(convergence::block(source, &facts));
    blocks.extend(ground_reaction::block(source, &facts).map(detail));
    blocks.extend(monitors(source, &facts).map(detail));
    // Of a run that only excavates the maps are the result.
    let shakes = source.shakes();
    blocks.extend(maps::block(source, &facts).map(|block| Block { folded: shakes, ..block }));
    let heading =
        if source.shakes() { say!(language, "Before the earthquake") } else { say!(language, "Stages") };
    Some(Chapter { id: "before", heading, blocks })
}

fn table(source: &Source, facts: &Summary) -> Block {
    let language = source.language;
    let stages = &facts.computed.stages;
    if stages.is_empty() {
        let note = say!(language, "The table of stages is left out: summary.json lists none yet.");
        return Block { notes: vec![note], ..Block::default() };
    }
    let motion = source.scale(Kind::Displacement);
    let head = vec![
        Head::number("#"),
        Head::words(say!(language, "stage")),
        Head::words(say!(language, "what changed")),
        Head::number(say!(language, "let go")),
        Head::number(say!(language, "cycles")),
        Head::number(say!(language, "out of balance")),
        Head::number(say!(language, "motion left")),
        Head::number(motion.labelled(&say!(language, "largest motion"))),
        Head::number("∫Γ dV (m³)"),
        Head::number(say!(language, "still held")),
    ];
    let row = |(k, stage): (usize, &StageSummary)| {
        let release = if k == 0 || !stage.release.is_finite() {
            "–".into()
        } else {
            format!("{}\u{a0}%", trimmed(&figures(100.0 * stage.release, 3)))
        };
        let held = if stage.held.abs() <= ROUND_OFF { "0".into() } else { figures(stage.held, 2) };
        vec![
            Cell::number(k.to_string()),
            Cell::words(kept(&name(language, &stage.name))),
            Cell::words(changes(language, k, stage)),
            Cell::number(release),
            Cell::number(count(stage.cycles)),
            Cell::number(figures(stage.ratio, 2)),
            Cell::number(if stage.motion_left == 0.0 {
                "0".into()
            } else {
                source.size(Kind::Displacement, stage.motion_left)
            }),
            Cell::number(motion.number(stage.largest_motion)),
            Cell::number(figures(stage.plastic_volume, 3)),
            Cell::number(held),
        ]
    };
    let rows = stages.iter().enumerate().map(row).collect();
    let text = say!(
        language,
        "Stage 0 brings what is there at the start to equilibrium; displacements count from its end. Out of balance: \
                unbalanced forces over all contributions to them, summed over nodes. Motion left: an estimate of what more \
                cycles would bring; it should be small beside the largest motion, which is that of any node within the \
                stage. ∫Γ dV: plastic shear strain summed over the volume that stands. Still held: what a release below \
                100\u{a0}% has not let go, over the same contributions; it should be 0 at the end."
    );
    Block { text, tables: vec![TextTable { head: vec![head], rows }], ..Block::default() }
}

/// A name that is short stays on one line beside the long texts of the next column.
fn kept(name: &str) -> String {
    if name.chars().count() <= SHORT { name.replace(' ', "\u{a0}") } else { name.into() }
}

/// What a stage did, in words.
fn changes(language: Language, k: usize, stage: &StageSummary) -> String {
    let mut parts = Vec::new();
    if !stage.excavated.is_empty() {
        parts.push(say!(language, "excavated {groups}", groups = stage.excavated.join(", ")));
    }
    if !stage.installed.is_empty() {
        parts.push(say!(language, "installed {groups}", groups = stage.installed.join(", ")));
    }
    let said = |k: usize| stage.changed_message.get(k).cloned().unwrap_or_default();
    parts.extend(stage.changed.iter().enumerate().map(|(k, text)| language.tell_or(&said(k), text)));
    match (parts.is_empty(), k) {
        (false, _) => parts.join(&say!(language, "; ")),
        (true, 0) => say!(language, "initial equilibrium"),
        (true, _) => say!(language, "nothing but release"),
    }
}

/// What the monitors show when the stages are done.
fn monitors(source: &Source, facts: &Summary) -> Option<Block> {
    let language = source.language;
    let (k, last) = facts.computed.stages.iter().enumerate().next_back()?;
    let quantities = [("ux", "m"), ("uy", "m"), ("uz", "m"), ("s1", "Pa"), ("s3", "Pa")];
    let value = |of: &indexmap::IndexMap<String, Option<f64>>, name: &str| of.get(name).copied().flatten();
    let largest = |unit: &str| {
        let wanted = || quantities.iter().filter(|(_, u)| *u == unit);
        let all = last
            .monitors
            .values()
            .flat_map(|of| wanted().filter_map(|(name, _)| value(of, name)).collect::<Vec<_>>());
        all.filter(|x| x.is_finite()).fold(0.0, |most, x| f64::max(most, x.abs()))
    };
    let scales = quantities.map(|(_, unit)| source.units.suiting(unit, largest(unit)));
    let known = |name: &str| last.monitors.values().any(|of| value(of, name).is_some_and(f64::is_finite));
    let columns: Vec<usize> = (0..quantities.len()).filter(|&i| known(quantities[i].0)).collect();
    if columns.is_empty() {
        return None;
    }
    let mut head = vec![Head::words(say!(language, "monitor"))];
    head.extend(columns.iter().map(|&i| Head::number(scales[i].labelled(quantities[i].0))));
    let number = |i: usize, x: f64| match x.abs() <= ROUND_OFF * largest(quantities[i].1) {
        true => "0".into(),
        false => scales[i].number(x),
    };
    let row = |(name, of): (&String, &indexmap::IndexMap<String, Option<f64>>)| {
        let mut row = vec![Cell::words(name)];
        let values =
            columns.iter().map(|&i| value(of, quantities[i].0).map_or("–".into(), |x| number(i, x)));
        row.extend(values.map(Cell::number));
        row
    };
    // Those at interfaces and bolts have none of these.
    let has = |of: &indexmap::IndexMap<String, Option<f64>>| {
        columns.iter().any(|&i| of.contains_key(quantities[i].0))
    };
    let rows = last.monitors.iter().filter(|(_, of)| has(of)).map(row).collect();
    let mut text = say!(
        language,
        "After {stage}. Displacements since the initial equilibrium, of a lining since its installation; tension is positive. \
             All stages are in stages.csv.",
        stage = called(language, k, last)
    );
    // A pair alone has the length of its displacement.
    if last.monitors.values().any(|of| of.contains_key("u")) {
        text.push_str(&say!(
            language,
            " A pair shows how much more the first monitor moved than the second."
        ));
    }
    Some(Block {
        heading: say!(language, "Monitors when the stages are done"),
        text,
        tables: vec![TextTable { head: vec![head], rows }],
        ..Block::default()
    })
}
