//! What the end leaves in a section with bars, the width of its crack; and the lines round what the sections bear.

use super::{Judged, LAST, states};
use crate::plan::Plan;
use crate::strength::JudgedBy;
use tremolite_engine::state::Memory;
use tremolite_results::{Border, LastingCrack, SectionStrength};
use tremolite_sections::{CrackRule, Section};

/// Kinds of sections whose lines a summary keeps, and points of a line.
const KINDS: usize = 3;
const POINTS: usize = 120;
/// Sections are of one kind whose thickness \[m\] and bars \[m²/m\] differ by less.
const THICKNESS: f64 = 0.005;
const AREA: f64 = 2e-6;

/// N and M of a station at the end: of the last step, or of the last stage where nothing shook.
pub fn forces(plan: &Plan, stations: usize, memory: &Memory, k: usize) -> Option<[f64; 2]> {
    if let Some(last) = memory.get(LAST) {
        return Some([*last.get(2 * k)?, *last.get(2 * k + 1)?]);
    }
    let all = states(plan, stations, memory, k);
    all.last().map(|state| [state.forces[0], state.forces[1]])
}

/// Keeps the crack of a station where it is wider than those before.
pub fn crack(of: &mut SectionStrength, by: &JudgedBy, station: &Judged, forces: Option<[f64; 2]>) {
    let (Some(diameter), Some(forces)) = (by.bar_diameter, forces) else { return };
    if station.layers.is_empty() || !forces.iter().all(|x| x.is_finite()) {
        return;
    }
    let kept = of.crack.get_or_insert_with(LastingCrack::default);
    let concrete = by.rule.concrete();
    let section = Section { thickness: station.station.thickness, concrete, layers: station.layers.clone() };
    let Some(found) = CrackRule::en(by.grade().compression, diameter).crack(&section, forces) else {
        kept.without += 1;
        return;
    };
    // One of bars that yield is no number in the file, and the widest.
    let size = |width: f64| if width.is_nan() { f64::INFINITY } else { width };
    if kept.station == 0 || found.width > size(kept.width) {
        *kept = LastingCrack {
            width: found.width,
            stress: found.stress,
            spacing: found.spacing,
            station: station.number,
            at: station.station.place,
            forces,
            without: kept.without,
        };
    }
}

/// Counts a station to its kind of section.
pub fn count(of: &mut SectionStrength, station: &Judged) {
    let bars = [1.0, -1.0]
        .map(|side| station.layers.iter().filter(|l| side * l.depth > 0.0).map(|l| l.area).sum::<f64>());
    let thickness = station.station.thickness;
    let depths = [1.0, -1.0].map(|side| {
        let own = station.layers.iter().filter(|l| side * l.depth > 0.0);
        own.map(|l| 0.5 * thickness - side * l.depth).fold(f64::NAN, f64::min)
    });
    let same = |border: &&mut Border| {
        (border.thickness - thickness).abs() < THICKNESS
            && border.bars.iter().zip(bars).all(|(a, b)| (a - b).abs() < AREA)
    };
    if let Some(border) = of.borders.iter_mut().find(same) {
        border.stations += 1;
        return;
    }
    let all = station.shaking.border();
    let every = all.len().div_ceil(POINTS).max(1);
    let mut line: Vec<[f64; 2]> = all.iter().copied().step_by(every).collect();
    line.extend(line.first().copied());
    of.borders.push(Border { thickness, bars, depths, stations: 1, line });
}

/// The most frequent kinds first, and no more than are kept.
pub fn sort(of: &mut SectionStrength) {
    of.borders.sort_by_key(|border| std::cmp::Reverse(border.stations));
    of.borders.truncate(KINDS);
}
