//! The chapter on section forces of linings: after the last stage, and between which values they went while the ground shook.

mod along_lining;
mod borders;
mod on_shape;
pub mod stations;
mod strength;
mod thrust_moment;
pub mod used;

use crate::chapter::figure::{Block, Chapter};
use crate::chapter::text_table::{Cell, Head, TextTable};
use crate::language::{Language, say};
use crate::quantities::scale::{moment, trimmed};
use crate::section_forces::stations::{Extreme, Lining, Station, kilo, linings};
use crate::section_maps::section_view::plane;
use crate::source::Source;

/// The chapter; nothing for a run that wrote no section forces.
pub fn chapter(source: &Source) -> Option<Chapter> {
    const ID: &str = "forces";
    let language = source.language;
    let heading = say!(language, "Section forces of the linings");
    let rows = match source.sections.as_ref()? {
        Ok(rows) => rows,
        Err(why) => {
            let note = say!(language, "Left out. {why}", why = why);
            let block = Block { notes: vec![note], ..Block::default() };
            return Some(Chapter { id: ID, heading, blocks: vec![block] });
        }
    };
    let facts = source.facts();
    let linings = linings(language, rows, &facts);
    let shaken = linings.iter().any(Lining::shaken);
    let mut text = say!(
        language,
        "Integrated through the thickness, a metre of the cavern's length. Tension is positive; a positive moment stretches the \
         intrados; where shear is positive, what comes next, \
         going round by the wall of greater x over the crown, pushes towards the intrados. The table has the extremes of all stations of a lining, with time and place (x, y, z in m). \
         Look where the moment is large while the thrust is small or pulls: there the lining cracks first."
    );
    text.push_str(&if shaken {
        say!(
            language,
            " Each of N, M and Q has its largest and smallest value at a time of its own: the envelope is no state that the \
             lining was ever in."
        )
    } else if source.shakes() {
        say!(language, " The file holds no extremes of the shaking.")
    } else {
        String::new()
    });
    if !facts.computed.water.is_empty() {
        text.push_str(&say!(
            language,
            " They are of total stress. A lining with pores stands a second time, as 'effective', with forces of the stress that its material feels, total and the pressure in its pores; in concrete without pores the two are the same."
        ));
    }
    let mut blocks = vec![Block {
        text,
        tables: vec![table(language, &linings, facts.computed.model.duration)],
        ..Block::default()
    }];
    blocks.extend(used::block(source, &facts));
    let judged = source.utilisation.as_ref().and_then(|rows| rows.as_ref().ok());
    let y = plane(&facts.monitors.monitor_positions);
    for (number, lining) in linings.iter().enumerate() {
        let (y, section) = lining.section(y);
        let mut block = Block { heading: lining.name.clone(), ..Block::default() };
        let suffix = if number == 0 { String::new() } else { format!("-{}", number + 1) };
        let used = judged.and_then(|rows| used::figure(language, &lining.name, &section, rows, &suffix));
        block.figures.extend(used);
        block.figures.extend(on_shape::figure(language, lining, (y, &section), &suffix));
        // By its code where one judges it, bars included; else as plain concrete.
        let coded = facts.parts.sections.get(&lining.name).zip(judged);
        let coded = coded.and_then(|(of, rows)| borders::figure(language, &lining.name, of, rows, &suffix));
        match coded.map_or_else(|| strength::figure(source, lining, &facts, &suffix), Ok) {
            Ok(figure) => block.figures.push(figure),
            Err(why) => block.notes.push(why),
        }
        if block.figures.is_empty() {
            block.notes.push(say!(language, "No figure: fewer than two stations have numbers."));
        }
        blocks.push(block);
        // The same forces along the lining, and in pairs.
        let figures = along_lining::figure(language, lining, (y, &section), &suffix).into_iter();
        let figures: Vec<_> =
            figures.chain(thrust_moment::figure(language, lining, &section, &suffix)).collect();
        if !figures.is_empty() {
            let heading =
                say!(language, "{lining}: forces along it, and pairs of N and M", lining = lining.name);
            blocks.push(Block { heading, figures, folded: true, ..Block::default() });
        }
    }
    Some(Chapter { id: ID, heading, blocks })
}

/// The largest and smallest of each force, over all stations.
fn table(language: Language, linings: &[Lining], duration: f64) -> TextTable {
    let shaken = linings.iter().any(Lining::shaken);
    let extremes = || [Head::number(say!(language, "largest")), Head::number(say!(language, "smallest"))];
    let mut over = vec![Head::words("").over(2), Head::number(say!(language, "after the stages")).over(2)];
    let mut head = vec![Head::words(say!(language, "lining")), Head::words("")];
    head.extend(extremes());
    if shaken {
        over.push(Head::number(say!(language, "while the ground shakes")).over(2));
        head.extend(extremes());
    }
    let mut rows = Vec::new();
    for lining in linings {
        for (i, force) in stations::forces(language).into_iter().enumerate() {
            let label = if i == 0 { lining.name.as_str() } else { "" };
            let mut row = vec![Cell::words(label), Cell::words(force)];
            let after: Vec<_> = lining.stations.iter().map(|s| (s, s.after[i], f64::NAN)).collect();
            let shaking = |of: fn(&Station) -> Option<Extreme>| -> Vec<(&Station, f64, f64)> {
                let each = lining.stations.iter().filter_map(|s| Some((s, of(s)?)));
                each.map(|(s, e)| (s, e.forces[i], e.time[i])).collect()
            };
            row.extend([entry(&after, 1.0, duration), entry(&after, -1.0, duration)]);
            if shaken {
                row.push(entry(&shaking(|s| s.most), 1.0, duration));
                row.push(entry(&shaking(|s| s.least), -1.0, duration));
            }
            rows.push(row);
        }
    }
    TextTable { head: vec![over, head], rows }
}

/// The largest (`sign` 1) or smallest of values, with station and time.
fn entry(values: &[(&Station, f64, f64)], sign: f64, duration: f64) -> Cell {
    let finite = values.iter().filter(|(_, value, _)| value.is_finite());
    let Some((station, value, time)) = finite.max_by(|a, b| (sign * a.1).total_cmp(&(sign * b.1))) else {
        return Cell::number("–");
    };
    let [x, y, z] = station.place.map(|c| trimmed(&format!("{c:.1}").replace('-', "−")));
    let at = if time.is_finite() { format!("{}\u{a0}s, ", moment(*time, duration)) } else { String::new() };
    Cell::number(kilo(*value)).with(format!("{at}({x}, {y}, {z})"))
}
