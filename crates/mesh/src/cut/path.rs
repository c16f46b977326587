//! The way of a plane through a section: which points go onto it, and which quadrilaterals it parts.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

use super::curve::{Freedom, dot, length, minus};
use super::section::{Section, key};
use super::{Cut, CutError};

/// How far a point may go, as a share of the elements round it.
const FARTHEST: f64 = 0.9;
/// Least length of a piece of the way, as a share of the edge or diagonal that it was.
const LEAST_LENGTH: f64 = 0.3;
/// How far from a corner, in sizes of its elements, a plane may be that bends into it.
const CORNER: f64 = 0.4;
/// What that costs, by the same share: as much as poor elements.
const BENT: f64 = 10.0;
/// Least share of their shape that elements keep where one of their nodes moves alone.
const LEAST_LEFT: f64 = 0.05;
/// What the way pays inside what is whole for each point, by its distance in sizes of elements: enough that it does not go round there.
const ASIDE: f64 = 4.0;
/// How far aside it may go there: a plane that passes a lining comes out where it went in.
const MOST_ASIDE: f64 = 2.0;

/// A way through a section.
pub(super) struct Way {
    /// Steps from point to point that lie on the plane, in its order; where they do not follow one another something whole lies
    /// between.
    pub steps: Vec<[u32; 2]>,
    /// Points that go onto the plane, and where to.
    pub targets: BTreeMap<u32, [f64; 2]>,
}

impl Way {
    /// The steps by the mesh's nodes at the first y.
    pub fn nodes(&self, section: &Section) -> Vec<[u32; 2]> {
        self.steps.iter().map(|step| step.map(|p| section.columns[p as usize][0])).collect()
    }
}

/// The line of a plane in a section.
struct Line {
    through: [f64; 2],
    normal: [f64; 2],
    along: [f64; 2],
}

/// Where a point would go.
#[derive(Clone, Copy)]
struct Target {
    at: [f64; 2],
    /// Its place along the line \[m\].
    place: f64,
    /// What it costs.
    cost: f64,
}

impl Line {
    fn of(cut: &Cut) -> Line {
        let [x, _, z] = cut.plane.normal;
        let size = x.hypot(z);
        let normal = [x / size, z / size];
        Line { through: [cut.plane.through[0], cut.plane.through[2]], normal, along: [normal[1], -normal[0]] }
    }

    fn distance(&self, p: [f64; 2]) -> f64 {
        dot(minus(p, self.through), self.normal)
    }

    fn place(&self, p: [f64; 2]) -> f64 {
        dot(minus(p, self.through), self.along)
    }

    /// Where a point would go, if it can.
    fn target(&self, section: &Section, p: u32) -> Option<Target> {
        let at = section.points[p as usize];
        let off = self.distance(at);
        let spread = section.spread(p);
        let size = (0.5 * (spread[0][0] + spread[1][1])).sqrt();
        let (way, share) = match section.freedom[p as usize] {
            // What lies there by round-off stays.
            _ if off.abs() < 1e-9 * size => ([0.0; 2], 0.0),
            // Where corners and the ends of borders must stay the plane bends into one rather than leave a sliver beside it.
            Freedom::Fixed => ([0.0; 2], off.abs() / size),
            Freedom::Along(curve) => {
                let t = curve.meets(self.normal, -off)?;
                (curve.way(t), t.abs())
            }
            Freedom::Free => {
                let m = self.normal;
                let reach = [0, 1].map(|i| spread[i][0] * m[0] + spread[i][1] * m[1]);
                let farthest = dot(m, reach);
                (reach.map(|x| -off * x / farthest), off.abs() / farthest.sqrt())
            }
        };
        let at = [at[0] + way[0], at[1] + way[1]];
        let fixed = section.freedom[p as usize] == Freedom::Fixed;
        // What is left of an edge that a point slides along: elements see it less than columns beyond the block's sides.
        let crowded = match section.freedom[p as usize] {
            Freedom::Along(_) => 0.5 / ((1.0 - share) * (1.0 - share)),
            _ => 0.0,
        };
        if share > if fixed { CORNER } else { FARTHEST } {
            return None;
        }
        // What the elements round it have left when it alone moves.
        let left = section.round[p as usize].iter().map(|&c| {
            let corners = &section.cells[c as usize].corners;
            let shape = |moved: bool| -> Vec<[f64; 2]> {
                let point = |&q: &u32| if moved && q == p { at } else { section.points[q as usize] };
                corners.iter().map(point).collect()
            };
            quality(&shape(true), width(&shape(false)))
        });
        let left = left.fold(1.0, f64::min);
        let cost = if fixed { BENT * share } else { 0.1 * share + crowded } + 0.5 / (left * left);
        (left > LEAST_LEFT).then(|| Target { at, place: self.place(at), cost })
    }
}

/// A number that can be ordered.
#[derive(Clone, Copy, PartialEq)]
struct Cost(f64);

impl Eq for Cost {}

impl PartialOrd for Cost {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cost {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// The way of the least cost: what elements at it lose in shape, summed.
///
/// # Errors
/// If the plane passes the mesh by, or no way leads along it.
pub(super) fn find(section: &Section, cut: &Cut) -> Result<Way, CutError> {
    let line = Line::of(cut);
    let count = section.points.len() as u32;
    let targets: Vec<Option<Target>> = (0..count).map(|p| line.target(section, p)).collect();
    let misses = || CutError::Misses { name: cut.name.clone() };
    let outline = |p: &u32| section.outer[*p as usize] && targets[*p as usize].is_some();
    let places = || (0..count).filter(outline).filter_map(|p| Some(targets[p as usize]?.place));
    let ends = [places().fold(f64::INFINITY, f64::min), places().fold(f64::NEG_INFINITY, f64::max)];
    if ends[0] > ends[1] {
        return Err(misses());
    }
    let reach = cut.extent.map_or(ends, |extent| [ends[0].max(-extent), ends[1].min(extent)]);
    if reach[0] >= reach[1] {
        return Err(misses());
    }
    // What it costs to begin or end at a point, if that is near enough to the end.
    let at_end = |p: u32, side: usize| -> Option<f64> {
        let target = targets[p as usize]?;
        let spread = section.spread(p);
        let size = (0.5 * (spread[0][0] + spread[1][1])).sqrt();
        let off = (target.place - reach[side]).abs() / size;
        if reach[side] == ends[side] {
            // Points of the outline go to just there, but for a corner.
            return (section.outer[p as usize] && off < CORNER).then_some(0.0);
        }
        (off < 1.0).then_some(10.0 * off * off)
    };
    // What is reached is a step, the point before and the point: two steps in a row must not lie at one element, which would be flat.
    let mut costs: BTreeMap<[u32; 2], f64> = BTreeMap::new();
    let mut from: BTreeMap<[u32; 2], u32> = BTreeMap::new();
    let mut heap = BinaryHeap::new();
    for p in 0..count {
        if let Some(cost) = at_end(p, 0) {
            costs.insert([p, p], cost);
            heap.push(Reverse((Cost(cost), [p, p])));
        }
    }
    let mut best: Option<(f64, [u32; 2])> = None;
    let mut farthest: Option<Target> = None;
    while let Some(Reverse((Cost(cost), [before, p]))) = heap.pop() {
        if costs.get(&[before, p]).is_some_and(|least| cost > *least) || best.is_some_and(|b| b.0 <= cost) {
            continue;
        }
        if let Some(target) = targets[p as usize]
            && farthest.is_none_or(|f| target.place > f.place)
        {
            farthest = Some(target);
        }
        if let Some(more) = at_end(p, 1)
            && best.is_none_or(|b| cost + more < b.0)
        {
            best = Some((cost + more, [before, p]));
        }
        for q in around(section, p) {
            let whole = || section.inside_whole(before, p) && section.inside_whole(p, q);
            if before != p
                && section.round[q as usize].iter().any(|&c| at_all(section, c, [before, p]))
                && !whole()
            {
                continue;
            }
            let Some(step) = step(section, &line, &targets, p, q) else { continue };
            let next = cost + step;
            if costs.get(&[p, q]).is_none_or(|least| next < *least) {
                costs.insert([p, q], next);
                from.insert([p, q], before);
                heap.push(Reverse((Cost(next), [p, q])));
            }
        }
    }
    let Some((_, mut last)) = best else {
        let at = farthest.map_or(line.through, |f| f.at);
        return Err(CutError::NoWay { name: cut.name.clone(), at });
    };
    let mut points = vec![last[1]];
    while let Some(&before) = from.get(&last) {
        points.push(last[0]);
        last = [before, last[0]];
    }
    points.reverse();
    let on = |pair: &[u32]| !section.inside_whole(pair[0], pair[1]);
    let steps: Vec<[u32; 2]> =
        points.windows(2).filter(|pair| on(pair)).map(|pair| [pair[0], pair[1]]).collect();
    let moved = steps.iter().flatten().filter_map(|&p| Some((p, targets[p as usize]?.at)));
    let targets = moved.collect();
    Ok(Way { steps, targets })
}

/// Whether an element is at both points.
fn at_all(section: &Section, cell: u32, points: [u32; 2]) -> bool {
    points.iter().all(|p| section.cells[cell as usize].corners.contains(p))
}

/// Points that a way may go to from one: at the other ends of edges and of diagonals.
fn around(section: &Section, p: u32) -> Vec<u32> {
    let diagonals = section.round[p as usize].iter().filter_map(|&c| {
        let corners = &section.cells[c as usize].corners;
        let at = corners.iter().position(|&q| q == p)?;
        (corners.len() == 4).then(|| corners[(at + 2) % 4])
    });
    section.beside[p as usize].iter().copied().chain(diagonals).collect()
}

/// What a step costs; nothing if it cannot be made.
fn step(section: &Section, line: &Line, targets: &[Option<Target>], p: u32, q: u32) -> Option<f64> {
    let point = |p: u32| section.points[p as usize];
    let cells = section.edges.get(&key(p, q));
    if section.inside_whole(p, q) {
        let spread = section.spread(q);
        let off = line.distance(point(q)).abs() / (0.5 * (spread[0][0] + spread[1][1])).sqrt();
        return (off < MOST_ASIDE).then_some(0.1 + ASIDE * off * off);
    }
    let (a, b) = (targets[p as usize]?, targets[q as usize]?);
    if b.place - a.place < LEAST_LENGTH * length(minus(point(p), point(q))) {
        return None;
    }
    let moved = |c: u32| {
        if c == p {
            a.at
        } else if c == q {
            b.at
        } else {
            point(c)
        }
    };
    let mut cost = 0.5 * (a.cost + b.cost);
    let mut piece = |corners: &[u32], before: f64| {
        let shape: Vec<[f64; 2]> = corners.iter().map(|&c| moved(c)).collect();
        let left = quality(&shape, before);
        cost += if left > 0.0 { 1.0 / (left * left) } else { f64::INFINITY };
    };
    let size = |c: u32| {
        let corners = &section.cells[c as usize].corners;
        width(&corners.iter().map(|&c| point(c)).collect::<Vec<_>>())
    };
    match cells {
        Some(cells) => {
            // Along the outline, or between what is whole and what is not, there is nothing to part.
            if cells.len() != 2 || cells.iter().any(|&c| section.cells[c as usize].whole) {
                return None;
            }
            for &c in cells {
                piece(&section.cells[c as usize].corners, size(c));
            }
        }
        None => {
            let c = section.shared(p, q)?;
            let corners = &section.cells[c as usize].corners;
            let at = corners.iter().position(|&k| k == p)?;
            let corner = |k: usize| corners[(at + k) % 4];
            piece(&[corner(0), corner(1), corner(2)], size(c));
            piece(&[corner(0), corner(2), corner(3)], size(c));
        }
    }
    cost.is_finite().then_some(cost)
}

/// Four times the area over the perimeter: the side of a square \[m\].
pub(super) fn width(shape: &[[f64; 2]]) -> f64 {
    let (mut twice, mut round) = (0.0, 0.0);
    for (k, a) in shape.iter().enumerate() {
        let b = shape[(k + 1) % shape.len()];
        twice += a[0] * b[1] - a[1] * b[0];
        round += length(minus(b, *a));
    }
    2.0 * twice / round
}

/// The smaller of what is left of an element's width and of the sine at its corners; not above 0 if it is inside out.
fn quality(shape: &[[f64; 2]], before: f64) -> f64 {
    let count = shape.len();
    let sines = (0..count).map(|k| {
        let (a, b) =
            (minus(shape[(k + 1) % count], shape[k]), minus(shape[(k + count - 1) % count], shape[k]));
        (a[0] * b[1] - a[1] * b[0]) / (length(a) * length(b))
    });
    let sine = sines.fold(1.0, f64::min);
    let sine = if count == 3 { 2.0 / 3f64.sqrt() * sine } else { sine };
    (width(shape) / before).min(sine).min(1.0)
}
