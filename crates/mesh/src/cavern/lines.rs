//! Where the lines of the grid run along one axis.

use std::ops::Range;

use super::claims::Claim;
use super::layout::Plot;
use super::rows::{Wish, whole_numbers};
use super::stretch::{End, relax, stretch};
use super::{Cavern, CavernError, CavernSpec, Ground};
use crate::boxes::MOST_ELEMENTS;

/// A bound of a cavern's rectangle: where it is, the cavern, the side.
type Bound = (f64, usize, usize);

/// Lines of the block along one axis that come before all others.
struct Stops {
    /// From one end of the block to the other.
    at: Vec<f64>,
    /// For each cavern the stops at the ends of its rectangle.
    places: Vec<[usize; 2]>,
}

impl Stops {
    /// The ends of the block, the caverns' bounds, those closer than `tolerance` made one, and the galleries'
    /// `levels`, where such a line meets one of them there exactly.
    fn new(block: [f64; 2], claims: &[Claim], axis: usize, tolerance: f64, levels: &[f64]) -> Stops {
        let mut bounds: Vec<Bound> = Vec::with_capacity(2 * claims.len());
        for (k, claim) in claims.iter().enumerate() {
            let [low, high] = claim.bounds(axis);
            bounds.extend([(low, k, 0), (high, k, 1)]);
        }
        bounds.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut lines: Vec<(f64, &[Bound])> = Vec::new();
        let mut rest = bounds.as_slice();
        while let Some(start) = rest.first() {
            let n = rest.iter().take_while(|b| b.0 - start.0 < tolerance).count();
            let (together, others) = rest.split_at(n);
            let met = levels.iter().find(|l| together.iter().any(|b| (b.0 - **l).abs() < 1e-9));
            let mean = together.iter().map(|b| b.0).sum::<f64>() / n as f64;
            lines.push((met.copied().unwrap_or(mean), together));
            rest = others;
        }
        for &level in levels {
            if lines.iter().all(|line| line.0 != level) {
                lines.push((level, &[]));
            }
        }
        lines.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut at = vec![block[0]];
        let mut places = vec![[0; 2]; claims.len()];
        for (line, together) in lines {
            for &(_, k, side) in together {
                places[k][side] = at.len();
            }
            at.push(line);
        }
        at.push(block[1]);
        Stops { at, places }
    }

    /// The stop at a level that is one.
    fn place(&self, level: f64) -> usize {
        let after = self.at.partition_point(|at| *at < level);
        let nearer = after > 0 && level - self.at[after - 1] < self.at[after.min(self.at.len() - 1)] - level;
        if nearer || after == self.at.len() { after - 1 } else { after }
    }

    fn length(&self, stretches: Range<usize>) -> f64 {
        self.at[stretches.end] - self.at[stretches.start]
    }
}

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
        return Err(CavernError::TooMany { elements: total * total });
    }
    let counts = whole_numbers(&length, &wishes);

    let mut line = vec![block[0]];
    let mut at_stop = vec![0];
    for (i, &n) in counts.iter().enumerate() {
        let (from, to) = (stops.at[i], stops.at[i + 1]);
        if n > 0 {
            line.extend((1..n).map(|k| from + (to - from) * k as f64 / n as f64));
            line.push(to);
        } else {
            // At a rectangle between the size of its rows or columns and that of its outermost ring.
            let end = |stop: usize| {
                let touching =
                    plots.iter().zip(claims).zip(&stops.places).filter_map(|((plot, claim), place)| {
                        let side = place.iter().position(|&p| p == stop)?;
                        let ring = claim.margin[axis][side] * (1.0 - plot.rings[plot.rings.len() - 2]);
                        let next = [stop, stop - 1][side];
                        let row = length[next] / counts[next].max(1) as f64;
                        Some(End { next: row, wish: (ring * row).sqrt() })
                    });
                let inner = stop > 0 && stop + 1 < stops.at.len();
                inner.then(|| {
                    let most = |a: End, b: End| End { next: a.next.max(b.next), wish: a.wish.max(b.wish) };
                    let end = touching.reduce(most).unwrap_or(End { next: spec.near, wish: spec.near });
                    End { next: end.next, wish: end.wish.max(spec.near).min(spec.far) }
                })
            };
            let ends = [end(i), end(i + 1)];
            let smaller = ends.iter().flatten().fold(spec.far, |least, end| least.min(end.wish));
            if to - from < 1.5 * smaller {
                line.push(to);
                at_stop.push(line.len() - 1);
                continue;
            }
            let name = ["x", "z"][axis];
            // Where the ground will bend the rock above the caverns, no line stays level.
            let level = axis == 1 && (spec.ground == Ground::Level || i + 1 < counts.len());
            let cuts: Vec<f64> =
                spec.layers.iter().filter(|l| level && l.dip == 0.0).map(|l| -l.depth).collect();
            let part = stretch(from, to, ends, spec.far, &cuts)
                .map_err(|cause| CavernError::Grading { line: name, cause })?;
            line.extend(&part[1..]);
        }
        at_stop.push(line.len() - 1);
    }
    let planes = spec.layers.iter().filter(|_| axis == 1).map(|l| -l.depth);
    let held: Vec<f64> = planes.chain(levels.iter().copied()).collect();
    relax(&mut line, &held);
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
