//! Straight galleries across, from one cavern to the next: grid lines exactly along their floors, roofs and walls.
//!
//! A row of the grid runs from one cavern's wall through the rings of rock round it to the other's. The rows nearest
//! to floor and roof are moved there, on the walls, in the rings and in between; the other rows follow.

use super::error::{check_name, value};
use super::layout::Plot;
use super::opening::wall_rows;
use super::profile::Outline;
use super::section::{Part, Section};
use super::stretch::relax;
use super::{CavernError, CavernSpec};

const MOST: usize = 1000;

/// Rows next to floor or roof may become so much higher or lower than they were.
const MOST_CHANGE: f64 = 2.5;

/// A rectangular gallery across, between two neighbouring caverns with straight walls, such as a bus-bar gallery.
/// All lengths in metres.
///
/// The rock in it is the group `NAME.gallery`, the linings' elements that it passes the group `NAME.opening`; they
/// leave `rock` and the linings' groups. Faces of what remains towards them are the face set `NAME.surface`. It is
/// not lined.
///
/// Rows of elements run from wall to wall, as many below floor and roof on either side, with the cuts between benches
/// where they are; where caverns have many benches at unlike levels this may be impossible, and is refused. At floor
/// and roof sizes may change by more than 1.3 from element to element.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Gallery {
    /// Prefix of the names of its groups, as a cavern's.
    pub name: String,
    /// Names of the two caverns.
    pub between: [String; 2],
    /// Its middle in y, and its floor in z above the first cavern's clear floor.
    pub at: [f64; 2],
    /// Along y.
    pub width: f64,
    /// Along z.
    pub height: f64,
}

impl Gallery {
    fn walls(&self) -> [f64; 2] {
        [self.at[0] - 0.5 * self.width, self.at[0] + 0.5 * self.width]
    }
}

/// A level on a cavern's wall that a gallery asks for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pin {
    /// Number of the wall's node, 0 at the foot.
    pub node: usize,
    /// Above the clear floor.
    pub level: f64,
    pub right: bool,
}

/// A gallery's place in the block.
#[derive(Clone, Debug)]
pub(super) struct Passage {
    /// The cavern on the left and the one on the right.
    pub caverns: [usize; 2],
    /// From extrados to extrados.
    pub x: [f64; 2],
    pub z: [f64; 2],
}

pub(super) fn check(spec: &CavernSpec) -> Result<(), CavernError> {
    if spec.galleries.len() > MOST {
        return Err(value("galleries", spec.galleries.len() as f64, format!("at most {MOST} galleries")));
    }
    for (k, gallery) in spec.galleries.iter().enumerate() {
        let taken = spec.galleries[..k].iter().any(|other| other.name == gallery.name)
            || spec.caverns.iter().any(|cavern| cavern.name == gallery.name);
        check_name(&gallery.name, taken)?;
        let key = |key: &str| format!("{}.{key}", gallery.name);
        for (name, length) in [("width", gallery.width), ("height", gallery.height)] {
            if !(length > 0.0 && length <= 1e5) {
                return Err(value(key(name), length, "a length above 0 (and at most 1e5 m)"));
            }
        }
        if !(-1e6..=1e6).contains(&gallery.at[1]) {
            return Err(value(key("at"), gallery.at[1], "a length (and at most 1e6 m)"));
        }
        let [from, to] = gallery.walls();
        if !(from > -0.5 * spec.length && to < 0.5 * spec.length) {
            let must = format!("such that the gallery lies within the block, {} m long", spec.length);
            return Err(value(key("at"), gallery.at[0], must));
        }
    }
    Ok(())
}

/// Planes across y, with those of the galleries' walls; y = 0 is one, unless a wall is too near to it.
pub(super) fn planes(spec: &CavernSpec, along: f64) -> Vec<f64> {
    let half = 0.5 * spec.length;
    let mut stops = vec![-half, half];
    stops.extend(spec.galleries.iter().flat_map(Gallery::walls));
    if stops.iter().all(|y| y.abs() > 0.3 * along) {
        stops.push(0.0);
    }
    stops.sort_by(f64::total_cmp);
    stops.dedup();
    let mut line = vec![-half];
    for pair in stops.windows(2) {
        let n = ((pair[1] - pair[0]) / along).round().max(1.0) as usize;
        line.extend((1..n).map(|k| pair[0] + (pair[1] - pair[0]) * k as f64 / n as f64));
        line.push(pair[1]);
    }
    relax(&mut line, &stops);
    line
}

/// Finds the rows for each gallery's floor and roof and moves them there: `z` and the plots' pins.
pub(super) fn place(
    spec: &CavernSpec,
    z: &mut [f64],
    plots: &mut [Plot],
) -> Result<Vec<Passage>, CavernError> {
    let mut fixed: Vec<(usize, f64)> = vec![(0, z[0]), (z.len() - 1, z[z.len() - 1])];
    fixed.extend(plots.iter().flat_map(|p| [p.rows.start, p.rows.end]).map(|j| (j, z[j])));
    let planes = spec.layers.iter().map(|l| -l.depth);
    fixed.extend(planes.filter_map(|plane| Some((z.iter().position(|&z| z == plane)?, plane))));
    let mut passages = Vec::with_capacity(spec.galleries.len());
    for gallery in &spec.galleries {
        let refuse = |why: &'static str| CavernError::Gallery { gallery: gallery.name.clone(), why };
        let find = |name: &String| spec.caverns.iter().position(|c| c.name == *name);
        let (Some(a), Some(b)) = (find(&gallery.between[0]), find(&gallery.between[1])) else {
            return Err(refuse("names a cavern in `between` that there is not"));
        };
        let (a, b) = if plots[a].centre[0] <= plots[b].centre[0] { (a, b) } else { (b, a) };
        if a == b || plots[a].columns.end > plots[b].columns.start {
            return Err(refuse("needs two caverns in `between` that stand beside one another"));
        }
        let (Outline::Walls(left), Outline::Walls(right)) = (&plots[a].outline, &plots[b].outline) else {
            return Err(refuse("needs caverns with straight walls, not circles or horseshoes"));
        };
        let x = [plots[a].centre[0] + left.outer.half, plots[b].centre[0] - right.outer.half];
        let floor = -spec.overburden - spec.caverns[0].height + gallery.at[1];
        let ends = [floor, floor + gallery.height];
        let mut above = 0;
        for end in ends {
            let row = nearest(spec, z, plots, [a, b], &fixed, end, above).ok_or_else(|| {
                refuse(
                    "finds no row of elements at its floor or roof; it must lie between the feet \
                     of the straight walls and their tops, off the cuts between benches; or lower `near`",
                )
            })?;
            above = row + 1;
            for (k, is_right) in [(a, true), (b, false)] {
                let pin = Pin {
                    node: row - first_row(&plots[k]),
                    level: end - plots[k].centre[1],
                    right: is_right,
                };
                plots[k].pins.push(pin);
            }
            fixed.push((row, end));
        }
        let crossed = plots.iter().enumerate().any(|(k, plot)| {
            k != a
                && k != b
                && plot.columns.start < plots[b].columns.start
                && plot.columns.end > plots[a].columns.end
                && z[plot.rows.start] < ends[1]
                && z[plot.rows.end] > ends[0]
        });
        if crossed {
            return Err(refuse("would cross the surroundings of another cavern"));
        }
        passages.push(Passage { caverns: [a, b], x, z: ends });
    }
    fixed.sort_by_key(|f| f.0);
    fixed.dedup();
    let fits =
        remap(z, &fixed) && plots.iter().zip(&spec.caverns).all(|(plot, c)| plot.levels(c.benches).is_some());
    if let (false, Some(gallery)) = (fits, spec.galleries.last()) {
        let why = "or another leaves too little or too much room for the rows between its floor or roof and a cut \
                   between benches, a foot or a springing; move it or change `near`";
        return Err(CavernError::Gallery { gallery: gallery.name.clone(), why });
    }
    let mut held: Vec<f64> = spec.layers.iter().map(|l| -l.depth).collect();
    held.extend(passages.iter().flat_map(|p| p.z));
    relax(z, &held);
    Ok(passages)
}

/// The row of the grid at a straight wall's foot.
fn first_row(plot: &Plot) -> usize {
    plot.rows.start + plot.counts.inset + plot.counts.slab
}

/// The row from wall to wall that lies nearest to a level, at or above the row `above`.
fn nearest(
    spec: &CavernSpec,
    z: &[f64],
    plots: &[Plot],
    pair: [usize; 2],
    fixed: &[(usize, f64)],
    level: f64,
    above: usize,
) -> Option<usize> {
    let mut walls = Vec::with_capacity(2);
    for k in pair {
        let Outline::Walls(profile) = &plots[k].outline else { return None };
        walls.push(wall_rows(
            plots[k].counts.wall,
            profile.inner.springing,
            spec.caverns[k].benches as usize,
        ));
    }
    let far = |row: usize| -> Option<f64> {
        let kept = |at: f64| (at - level).abs() < 1e-9;
        // What is fixed below stays below, and so above.
        let passes = |j: usize, at: f64| if j == row { kept(at) } else { (j < row) == (at < level) };
        if !fixed.iter().all(|&(j, at)| passes(j, at)) {
            return None;
        }
        let mut sum = (z.get(row)? - level).abs();
        for (k, (levels, bench_of)) in pair.into_iter().zip(&walls) {
            let node = row.checked_sub(first_row(&plots[k]))?;
            if node == 0 || node >= plots[k].counts.wall {
                return None;
            }
            let at = plots[k].centre[1] + levels[node];
            let cut = bench_of[node] != bench_of[node - 1];
            let pinned = plots[k].pins.iter().find(|pin| pin.node == node);
            let taken = pinned.is_some_and(|pin| !kept(plots[k].centre[1] + pin.level));
            let cuts = (1..plots[k].counts.wall).filter(|&t| bench_of[t] != bench_of[t - 1]);
            let mut cuts = cuts.map(|t| (t, plots[k].centre[1] + levels[t]));
            if taken || cut && !kept(at) || !cuts.all(|(t, at)| t == node || (t < node) == (at < level)) {
                return None;
            }
            sum += (at - level).abs();
        }
        Some(sum)
    };
    let rows = (above..z.len()).filter_map(|row| Some((row, far(row)?)));
    rows.min_by(|p, q| p.1.total_cmp(&q.1)).map(|p| p.0)
}

impl Plot {
    /// Levels of the straight wall's nodes over the floor, those that galleries ask for at their places; nothing if
    /// rows come out much higher or lower than they were.
    pub fn levels(&self, benches: u32) -> Option<(Vec<f64>, Vec<u32>)> {
        let Outline::Walls(profile) = &self.outline else { return Some(Default::default()) };
        let wall = self.counts.wall;
        let (mut levels, bench_of) = wall_rows(wall, profile.inner.springing, benches as usize);
        if self.pins.is_empty() {
            return Some((levels, bench_of));
        }
        let cuts = (1..wall).filter(|&t| bench_of[t] != bench_of[t - 1]);
        let mut fixed: Vec<(usize, f64)> =
            [0, wall].into_iter().chain(cuts).map(|t| (t, levels[t])).collect();
        for pin in &self.pins {
            if !fixed.iter().any(|f| f.0 == pin.node) {
                fixed.push((pin.node, pin.level));
            }
        }
        fixed.sort_by_key(|f| f.0);
        let fits = remap(&mut levels, &fixed);
        let held: Vec<f64> = fixed.iter().map(|f| levels[f.0]).collect();
        relax(&mut levels, &held);
        fits.then_some((levels, bench_of))
    }

    /// The level at which node `t` of the outline, and the ring nodes on its line, are held for a gallery.
    pub fn held(&self, t: usize) -> Option<f64> {
        let counts = self.counts;
        let foot = counts.inset + counts.slab;
        let held = |pin: &&Pin| t == foot + if pin.right { counts.vault() - pin.node } else { pin.node };
        self.pins.iter().find(held).map(|pin| self.centre[1] + pin.level)
    }
}

/// Moves the coordinates with the given places there, the others in proportion; false if a part is stretched or
/// squeezed too much.
fn remap(line: &mut [f64], fixed: &[(usize, f64)]) -> bool {
    let old = line.to_vec();
    let mut fits = true;
    for pair in fixed.windows(2) {
        let [(i, a), (j, b)] = [pair[0], pair[1]];
        if i == j {
            continue;
        }
        let factor = (b - a) / (old[j] - old[i]);
        fits &= (1.0 / MOST_CHANGE..=MOST_CHANGE).contains(&factor);
        for k in i..j {
            line[k] = if k == i { a } else { a + factor * (old[k] - old[i]) };
        }
        line[j] = b;
    }
    fits
}

/// What each element belongs to, layer by layer along y: the section's parts, but for the galleries.
pub(super) fn parts(spec: &CavernSpec, section: &Section) -> Vec<Part> {
    let layers = section.y.len() - 1;
    let mut parts = section.parts.repeat(layers);
    for (g, (gallery, passage)) in (0..).zip(spec.galleries.iter().zip(&section.passages)) {
        let [from, to] = gallery.walls();
        let along = (0..layers).filter(|&l| section.y[l] >= from && section.y[l + 1] <= to);
        let along: Vec<usize> = along.collect();
        for (q, quad) in section.quads.iter().enumerate() {
            let middle =
                [0, 1].map(|c| quad.iter().map(|&n| section.points[n as usize][c]).sum::<f64>() / 4.0);
            let inside = |range: [f64; 2], at: f64| at > range[0] && at < range[1];
            if !inside(passage.z, middle[1]) {
                continue;
            }
            let part = match section.parts[q] {
                Part::Rock if inside(passage.x, middle[0]) => Part::Gallery(g),
                // The wall on the side of the other cavern: from the extrados in by no more than half the opening.
                Part::Walls(k) => {
                    let [left, right] = passage.caverns;
                    let near = |edge: f64| (middle[0] - edge).abs() < 0.5 * spec.caverns[k as usize].width;
                    let facing =
                        k as usize == left && near(passage.x[0]) || k as usize == right && near(passage.x[1]);
                    if !facing {
                        continue;
                    }
                    Part::Opening(g)
                }
                _ => continue,
            };
            for &layer in &along {
                parts[layer * section.quads.len() + q] = part;
            }
        }
    }
    parts
}
