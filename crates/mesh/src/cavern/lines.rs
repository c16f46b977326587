//! Where the lines of the grid run along one axis.

use std::ops::Range;

use super::claims::Claim;
use super::plot::Plot;
use super::rows::{Wish, whole_numbers};
use super::spread::Spread;
use super::stops::Stops;
use super::stretch::{End, relax, stretch};
use super::{Cavern, CavernError, CavernSpec, GroundSurface};
use crate::boxes::MOST_ELEMENTS;

/// The grid lines along one axis; sets the plots' ranges and the counts that depend on them. `levels`: those of
/// galleries' floors and roofs, each of which becomes a line.
pub(super) fn lines(
    spec: &CavernSpec,
    axis: usize,
    block: [f64; 2],
    levels: &[f64],
    claims: &[Claim],
    plots: &mut [Plot],
) -> Result<Vec<f64>, CavernError> {
    let stops = Stops::new(block, claims, axis, 0.7 * spec.near, levels);
    let length: Vec<f64> = stops.at.windows(2).map(|s| s[1] - s[0]).collect();
    let mut wishes = Vec::with_capacity(plots.len());
    for ((plot, cavern), place) in plots.iter().zip(&spec.caverns).zip(&stops.places) {
        let stretches = place[0]..place[1];
        if axis == 0 {
            wishes.push(columns(spec.near, plot, stretches, &stops));
        } else if plot.stops.is_some() {
            rows_with_galleries(plot, stretches, &stops, &mut wishes);
        } else {
            wishes.push(rows(spec.near, plot, cavern, stretches, &stops));
        }
    }
    let total: f64 = wishes.iter().map(|w| w.ideal).sum();
    if total > MOST_ELEMENTS as f64 {
        return Err(CavernError::TooMany { elements: total * total, near: spec.near, along: spec.step() });
    }
    let counts = whole_numbers(&length, &wishes);

    let inside = inside(&stops.at, &counts);
    let mut line = vec![block[0]];
    let mut at_stop = vec![0];
    for (i, part) in inside.iter().enumerate() {
        let end = |stop: usize| {
            // At a rectangle between the size of its rows or columns and that of its outermost ring.
            let touching =
                plots.iter().zip(claims).zip(&stops.places).filter_map(|((plot, claim), place)| {
                    let side = place.iter().position(|&p| p == stop)?;
                    let ring = claim.margin[axis][side] * (1.0 - plot.rings[plot.rings.len() - 2]);
                    let row = match (side, &inside[[stop, stop - 1][side]][..]) {
                        (0, [first, second, ..]) => second - first,
                        (1, [.., before, last]) => last - before,
                        _ => spec.near,
                    };
                    Some(End { next: row, wish: (ring * row).sqrt() })
                });
            let inner = stop > 0 && stop + 1 < stops.at.len();
            inner.then(|| {
                let most = |a: End, b: End| End { next: a.next.max(b.next), wish: a.wish.max(b.wish) };
                let end = touching.reduce(most).unwrap_or(End { next: spec.near, wish: spec.near });
                End { next: end.next, wish: end.wish.max(spec.near).min(spec.far) }
            })
        };
        if part.is_empty() {
            let last = i + 1 == inside.len();
            line.extend(outside(spec, axis, [stops.at[i], stops.at[i + 1]], [end(i), end(i + 1)], last)?);
        } else {
            line.extend(&part[1..]);
        }
        at_stop.push(line.len() - 1);
    }
    let planes = spec.layers.iter().filter(|_| axis == 1).map(|l| -l.depth);
    let held: Vec<f64> = planes.chain(stops.at.iter().copied()).collect();
    let mut relaxed = line.clone();
    relax(&mut relaxed, &held);
    if relaxed.windows(2).all(|p| p[1] - p[0] <= spec.far) {
        line = relaxed;
    }
    for (plot, place) in plots.iter_mut().zip(&stops.places) {
        let range = at_stop[place[0]]..at_stop[place[1]];
        if axis == 0 {
            plot.counts.columns = range.len().saturating_add_signed(-plot.counts.extra_columns());
            plot.columns = range;
        } else {
            plot.counts.wall = range.len().saturating_add_signed(-plot.counts.extra_rows());
            plot.rows = range;
        }
    }
    Ok(line)
}

/// Coordinates of the stretches with elements of rectangles, both ends included; none of the others.
fn inside(stops: &[f64], counts: &[usize]) -> Vec<Vec<f64>> {
    // Of a rectangle alone all rows and columns are alike; where stops are close they grow from there.
    let sizes = stops.windows(2).zip(counts).filter(|(_, n)| **n > 0).map(|(s, n)| (s[1] - s[0]) / *n as f64);
    let spread = Spread::new(stops, sizes.fold(0.0, f64::max));
    let mut parts = vec![Vec::new(); counts.len()];
    let mut i = 0;
    while i < counts.len() {
        let run = counts[i..].iter().take_while(|n| **n > 0).count();
        let mut line = vec![stops[i]];
        (i..i + run).for_each(|k| spread.fill(k, counts[k], &mut line));
        relax(&mut line, stops);
        let mut rest = line.as_slice();
        for k in i..i + run {
            parts[k] = rest[..=counts[k]].to_vec();
            rest = &rest[counts[k]..];
        }
        i += run.max(1);
    }
    parts
}

/// Coordinates of a stretch that no rectangle covers, without its start. `last`: it is the last along its axis.
fn outside(
    spec: &CavernSpec,
    axis: usize,
    [from, to]: [f64; 2],
    ends: [Option<End>; 2],
    last: bool,
) -> Result<Vec<f64>, CavernError> {
    let smaller = ends.iter().flatten().fold(spec.far, |least, end| least.min(end.wish));
    if to - from < 1.5 * smaller {
        return Ok(vec![to]);
    }
    // Where the ground will bend the rock above the caverns, no line stays level.
    let level = axis == 1 && (spec.ground == GroundSurface::Level || !last);
    let cuts: Vec<f64> = spec.layers.iter().filter(|l| level && l.dip == 0.0).map(|l| -l.depth).collect();
    let line = ["x", "z"][axis];
    // Where even the largest elements are too many it is their size that is wrong.
    let key = if (to - from) / spec.far > MOST_ELEMENTS as f64 / 100.0 { "size_far" } else { "size_near" };
    let mut part = stretch(from, to, ends, spec.far, &cuts).map_err(|cause| CavernError::Grading {
        line,
        key,
        cause,
    })?;
    part.remove(0);
    Ok(part)
}

/// Columns of the rectangle round a cavern.
fn columns(near: f64, plot: &Plot, stretches: Range<usize>, stops: &Stops) -> Wish {
    let middle = plot.outline.lengths()[0] / near - 2.0 * plot.counts.flank as f64;
    // A narrow cavern has a much wider rectangle, which needs columns too.
    let outside = stops.length(stretches.clone()) / (1.7 * near);
    let extra = plot.counts.extra_columns();
    let ideal = (middle.max(2.0) + extra as f64).max(outside);
    Wish { stretches, ideal, extra, multiple: 2, weight: 100.0, exact: false, uneven: Vec::new() }
}

/// Rows of the rectangle round a cavern whose walls have no galleries.
fn rows(near: f64, plot: &Plot, cavern: &Cavern, stretches: Range<usize>, stops: &Stops) -> Wish {
    let extra = plot.counts.extra_rows();
    let benches = cavern.benches as usize;
    // A rectangle with no rows but those of the walls is higher than they are.
    let outside = if plot.counts.closed { stops.length(stretches.clone()) / (1.7 * near) } else { 0.0 };
    let wall = (plot.outline.lengths()[1] / near).max(benches as f64).max(outside);
    Wish {
        stretches,
        ideal: wall + extra as f64,
        extra,
        multiple: benches,
        weight: 1.0,
        exact: false,
        uneven: Vec::new(),
    }
}

/// Rows of a rectangle from its base to the first gallery's level, from each to the next, and to its top.
fn rows_with_galleries(plot: &Plot, stretches: Range<usize>, stops: &Stops, wishes: &mut Vec<Wish>) {
    let Some(wall) = &plot.stops else { return };
    let mut from = (stretches.start, 0.0);
    let levels = plot.galleries.iter().map(|&level| (stops.place(plot.centre[1] + level), level));
    let last = (stretches.end, plot.outline.lengths()[1]);
    let foot = plot.first_row() as isize;
    for to in levels.chain([last]) {
        let below = if from.0 == stretches.start { foot } else { 0 };
        let above = if to.0 == stretches.end { plot.counts.extra_rows() - foot } else { 0 };
        let extra = below + above;
        let (ideal, least) = wall.wanted(from.1, to.1);
        wishes.push(Wish {
            stretches: from.0..to.0,
            ideal: ideal + extra as f64,
            extra,
            multiple: least,
            weight: 0.0,
            exact: least == 0,
            uneven: (0..=ideal as usize + 8).map(|more| wall.uneven(from.1, to.1, least + more)).collect(),
        });
        from = to;
    }
}
