//! The grid of the block: where its lines run and which rectangle of it each cavern takes.

use std::ops::Range;

use super::gallery::{self, Passage, Pin};
use super::profile::Outline;
use super::rows::{Counts, Wish, whole_numbers};
use super::stretch::{End, GROWTH, relax, stretch};
use super::{CavernError, CavernSpec, Ground};
use crate::boxes::MOST_ELEMENTS;
use crate::grading::graded;

/// A cavern's place in the grid.
pub(super) struct Plot {
    /// The middle of the clear floor: x, z.
    pub centre: [f64; 2],
    pub outline: Outline,
    pub counts: Counts,
    /// Grid lines of the rectangle, first and last.
    pub columns: Range<usize>,
    pub rows: Range<usize>,
    /// Levels on its walls that galleries ask for.
    pub pins: Vec<Pin>,
    /// Where the rings of rock lie between extrados (0) and rectangle (1), both included.
    pub rings: Vec<f64>,
}

/// The lines of the grid and the caverns' places in it.
pub(super) struct Layout {
    pub x: Vec<f64>,
    pub y: Vec<f64>,
    pub z: Vec<f64>,
    /// Level above which there are no caverns' rectangles.
    pub cover: f64,
    pub plots: Vec<Plot>,
    /// The galleries.
    pub passages: Vec<Passage>,
}

/// Rectangle round a cavern while the layout is made. Axis 0 is x, axis 1 is z.
struct Claim {
    /// Extrados.
    body: [[f64; 2]; 2],
    /// Rock between extrados and rectangle, by axis and side.
    margin: [[f64; 2]; 2],
}

impl Claim {
    fn bound(&self, axis: usize, side: usize) -> f64 {
        self.body[side][axis] + [-1.0, 1.0][side] * self.margin[axis][side]
    }

    fn bounds(&self, axis: usize) -> [f64; 2] {
        [self.bound(axis, 0), self.bound(axis, 1)]
    }
}

impl Layout {
    /// `insets`: for each cavern the number of edges below it to the tied point, or the usual one.
    pub fn new(spec: &CavernSpec, insets: &[Option<usize>]) -> Result<Layout, CavernError> {
        let first = &spec.caverns[0];
        let ground = -spec.overburden - first.height;
        let mut plots: Vec<Plot> = Vec::with_capacity(spec.caverns.len());
        let mut claims = Vec::with_capacity(spec.caverns.len());
        for (cavern, inset) in spec.caverns.iter().zip(insets) {
            let outline = Outline::new(cavern);
            let centre = [cavern.at[0] - first.at[0], ground + cavern.at[1] - first.at[1]];
            let (low, high) = outline.bounds();
            let body = [low, high].map(|p| [centre[0] + p[0], centre[1] + p[1]]);
            let mut counts = Counts::new(cavern, &outline, spec.near);
            counts.inset = inset.unwrap_or(counts.inset);
            claims.push(Claim { body, margin: margins(spec.near, &outline, &counts) });
            plots.push(Plot {
                centre,
                outline,
                counts,
                columns: 0..0,
                rows: 0..0,
                pins: Vec::new(),
                rings: Vec::new(),
            });
        }
        let floor = plots.iter().map(|p| p.centre[1]).fold(f64::INFINITY, f64::min);
        let left = claims.iter().map(|c| c.body[0][0]).fold(f64::INFINITY, f64::min);
        let right = claims.iter().map(|c| c.body[1][0]).fold(f64::NEG_INFINITY, f64::max);
        let block = [[left - spec.sides, right + spec.sides], [floor - spec.below, 0.0]];

        shrink(spec, &mut claims, block)?;
        for (plot, claim) in plots.iter_mut().zip(&claims) {
            let mean = claim.margin.as_flattened().iter().sum::<f64>() / 4.0;
            let line = graded(0.0, mean, (Some(spec.near), None), spec.far, GROWTH)
                .map_err(|cause| CavernError::Grading { line: "the rings round a cavern", cause })?;
            plot.rings = line.iter().map(|s| s / mean).collect();
        }

        let [x, z] = [0, 1].map(|axis| lines(spec, axis, block[axis], &claims, &mut plots));
        let (x, mut z) = (x?, z?);
        let along = 2.0 * (spec.length / spec.along.unwrap_or(spec.near) / 2.0).round().max(1.0);
        let elements = along * (x.len() - 1) as f64 * (z.len() - 1) as f64;
        let inside: f64 = plots.iter().map(|p| (p.counts.vault() * p.counts.vault()) as f64 * along).sum();
        if elements + inside > MOST_ELEMENTS as f64 {
            return Err(CavernError::TooMany { elements: elements + inside });
        }
        let passages = gallery::place(spec, &mut z, &mut plots)?;
        let y = if spec.galleries.is_empty() {
            let along = along as usize;
            (0..=along).map(|j| spec.length * (j as f64 / along as f64 - 0.5)).collect()
        } else {
            gallery::planes(spec, spec.length / along)
        };
        let cover = plots.iter().map(|p| z[p.rows.end]).fold(f64::NEG_INFINITY, f64::max);
        Ok(Layout { x, y, z, cover, plots, passages })
    }
}

/// Rock between extrados and rectangle that gives well-shaped rings, by axis and side.
fn margins(near: f64, outline: &Outline, counts: &Counts) -> [[f64; 2]; 2] {
    let profile = match outline {
        Outline::Walls(profile) => profile,
        // Lines from corner to corner at half a right angle, the same on all sides.
        Outline::Closed(tube) => return [[(0.2 * tube.height).max(2.2 * near); 2]; 2],
    };
    // The edges at the foot fan out into as many rows at the rectangle's side.
    let below = (1.2 * (counts.inset + 1) as f64 * near).max(2.2 * near);
    let above = (1.6 * near).max(0.5 * profile.outer.rise);
    // The line from the tied point of the arch, the springing or half-way up, to the rectangle's corner must
    // not lean too much.
    let rise = if counts.ring > 0 { 0.3 * profile.outer.rise } else { profile.outer.rise };
    let side = (0.75 * (rise + above)).max(2.2 * near);
    [[side; 2], [below, above]]
}

/// Makes the margins fit between neighbours and within the block.
fn shrink(spec: &CavernSpec, claims: &mut [Claim], block: [[f64; 2]; 2]) -> Result<(), CavernError> {
    let needed = 1.2 * spec.near;
    for (k, claim) in claims.iter_mut().enumerate() {
        for axis in 0..2 {
            for side in 0..2 {
                let rock = (block[axis][side] - claim.body[side][axis]).abs();
                let inside = (block[axis][side] - claim.body[side][axis]) * [-1.0, 1.0][side] > 0.0;
                if !inside || rock < needed {
                    let key = [["sides", "sides"], ["below", "overburden"]][axis][side];
                    let rock = if inside { rock } else { -rock };
                    let cavern = spec.caverns[k].name.clone();
                    return Err(CavernError::TooNearToEdge { cavern, key, rock, needed });
                }
                claim.margin[axis][side] = claim.margin[axis][side].min(rock / 2.0);
            }
        }
    }
    for b in 1..claims.len() {
        for a in 0..b {
            let gap = |axis: usize| {
                let [a, b] = [&claims[a].body, &claims[b].body];
                let (right, left) = (b[0][axis] - a[1][axis], a[0][axis] - b[1][axis]);
                if right >= left { (right, 1) } else { (left, 0) }
            };
            let axis = if gap(0).0 >= gap(1).0 { 0 } else { 1 };
            let (rock, side) = gap(axis);
            if rock < needed {
                let [first, second] = [a, b].map(|k| spec.caverns[k].name.clone());
                return Err(CavernError::TooClose { first, second, rock, needed });
            }
            let [mine, theirs] = [claims[a].margin[axis][side], claims[b].margin[axis][1 - side]];
            // Two rectangles with less than an element between them share a line instead.
            if mine + theirs + 0.8 * spec.near > rock {
                claims[a].margin[axis][side] = rock * mine / (mine + theirs);
                claims[b].margin[axis][1 - side] = rock * theirs / (mine + theirs);
            }
        }
    }
    Ok(())
}

/// The grid lines along one axis; sets the plots' ranges and the counts that depend on them.
fn lines(
    spec: &CavernSpec,
    axis: usize,
    block: [f64; 2],
    claims: &[Claim],
    plots: &mut [Plot],
) -> Result<Vec<f64>, CavernError> {
    let (fixed, places) = fixed_lines(claims, axis, 0.7 * spec.near);
    let mut stops = vec![block[0]];
    stops.extend(&fixed);
    stops.push(block[1]);
    let length: Vec<f64> = stops.windows(2).map(|s| s[1] - s[0]).collect();

    let wishes: Vec<Wish> = plots
        .iter()
        .zip(&spec.caverns)
        .zip(&places)
        .map(|((plot, cavern), place)| {
            let stretches = place[0] + 1..place[1] + 1;
            let [roof, wall] = plot.outline.lengths();
            if axis == 0 {
                let middle = roof / spec.near - 2.0 * plot.counts.flank as f64;
                // A narrow cavern has a much wider rectangle, which needs columns too.
                let outside = length[stretches.clone()].iter().sum::<f64>() / (1.7 * spec.near);
                let extra = plot.counts.extra_columns();
                let ideal = (middle.max(2.0) + extra as f64).max(outside);
                Wish { stretches, ideal, extra, multiple: 2, weight: 100.0 }
            } else {
                let extra = plot.counts.extra_rows();
                let benches = cavern.benches as usize;
                // A rectangle with no rows but those of the walls is higher than they are.
                let outside = if plot.counts.closed {
                    length[stretches.clone()].iter().sum::<f64>() / (1.7 * spec.near)
                } else {
                    0.0
                };
                let wall = (wall / spec.near).max(benches as f64).max(outside);
                Wish { stretches, ideal: wall + extra as f64, extra, multiple: benches, weight: 1.0 }
            }
        })
        .collect();
    let too_many = |elements: f64| CavernError::TooMany { elements };
    let total: f64 = wishes.iter().map(|w| w.ideal).sum();
    if total > MOST_ELEMENTS as f64 {
        return Err(too_many(total * total));
    }
    let counts = whole_numbers(&length, &wishes);

    let mut line = vec![block[0]];
    let mut at_stop = vec![0];
    for (i, &n) in counts.iter().enumerate() {
        let (from, to) = (stops[i], stops[i + 1]);
        if n > 0 {
            line.extend((1..n).map(|k| from + (to - from) * k as f64 / n as f64));
            line.push(to);
        } else {
            // At a rectangle between the size of its rows or columns and that of its outermost ring.
            let end = |stop: usize| {
                let touching = plots.iter().zip(claims).zip(&places).filter_map(|((plot, claim), place)| {
                    let side = place.iter().position(|&p| p + 1 == stop)?;
                    let ring = claim.margin[axis][side] * (1.0 - plot.rings[plot.rings.len() - 2]);
                    let next = [stop, stop - 1][side];
                    let row = length[next] / counts[next].max(1) as f64;
                    Some(End { next: row, wish: (ring * row).sqrt() })
                });
                let inner = stop > 0 && stop + 1 < stops.len();
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
    let planes: Vec<f64> = spec.layers.iter().map(|l| -l.depth).collect();
    relax(&mut line, if axis == 1 { &planes } else { &[] });
    for (plot, place) in plots.iter_mut().zip(&places) {
        let range = at_stop[place[0] + 1]..at_stop[place[1] + 1];
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

/// The caverns' bounds along an axis, rising, those closer than `tolerance` made one; and for each cavern
/// which of them are its own.
fn fixed_lines(claims: &[Claim], axis: usize, tolerance: f64) -> (Vec<f64>, Vec<[usize; 2]>) {
    let mut bounds: Vec<(f64, usize, usize)> = Vec::with_capacity(2 * claims.len());
    for (k, claim) in claims.iter().enumerate() {
        let [low, high] = claim.bounds(axis);
        bounds.extend([(low, k, 0), (high, k, 1)]);
    }
    bounds.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut fixed = Vec::new();
    let mut places = vec![[0; 2]; claims.len()];
    let mut rest = bounds.as_slice();
    while let Some(start) = rest.first() {
        let n = rest.iter().take_while(|b| b.0 - start.0 < tolerance).count();
        let (together, others) = rest.split_at(n);
        for &(_, k, side) in together {
            places[k][side] = fixed.len();
        }
        fixed.push(together.iter().map(|b| b.0).sum::<f64>() / n as f64);
        rest = others;
    }
    (fixed, places)
}
