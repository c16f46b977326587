//! Better places for the nodes beside a plane that has been put into a mesh.
//!
//! The stable step goes by nodes: at each by the stiffness that its elements bring over their mass, k/m = Σ V b·b / Σ V/n for mean gradients b
//! in n corners, in units of c². Nodes move one at a time, within the plane where they lie on it and within the borders that the cut keeps, to
//! where a high power of these ratios and of the elements' faults is least (Freitag & Knupp 2002 do so for condition numbers).

use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::freedom::{self, Freedom};
use super::polyhedron::corner_areas;
use super::{Ground, Made};
use crate::plane::Plane;
use crate::quality;
use crate::topology::{cross, dot, minus, norm};
use crate::{Mesh, Shape};

/// The power of (step without the plane over that of a node) in what is made least.
const POWER: i32 = 6;
/// A scaled Jacobian that counts as much as a step as long as without the plane.
const JACOBIAN: f64 = 0.45;
/// An element's own step, over the smallest without the plane, that does.
const OWN_STEP: f64 = 0.2;
/// A face on a side of the block, by its height over the same: ground that goes on beyond it has such elements.
const SIDE_FACE: f64 = 0.4;
/// Faults of elements and ratios of nodes up to which nothing moves: scaled Jacobians above a third, four fifths of the step.
const GOOD_FAULT: f64 = 6.0;
const GOOD_RATIO: f64 = 1.5;
const SWEEPS: usize = 24;
/// First way that is tried, as a share of the mean way to corners of a node's elements, and the share by which it shrinks where none is better.
const FIRST: f64 = 0.2;
const SHRINKS: f64 = 0.5;
const LAST: f64 = 0.002;

/// What a node may do.
enum Way {
    Free,
    /// Within the plane of this normal.
    Flat([f64; 3]),
    /// Along this direction.
    Line([f64; 3]),
}

/// What an element brings to its corners, in its own order, and its fault.
#[derive(Clone, Copy, Default)]
struct Share {
    stiffness: [f64; 8],
    mass: f64,
    fault: f64,
}

struct Patch<'a> {
    mesh: &'a mut Mesh,
    /// Elements at each node that may move, and what each brings.
    at: HashMap<u32, Vec<u32>>,
    shares: HashMap<u32, Share>,
    /// Stiffness over c² and mass over density of nodes \[m, m³\].
    sums: HashMap<u32, [f64; 2]>,
    /// The largest ratio of the mesh without the plane \[1/m²\], and its smallest step length \[m\].
    reference: f64,
    smallest: f64,
    /// Nodes on sides of the block: a bit for each.
    sides: HashMap<u32, u8>,
}

/// Moves nodes of what a plane changed to where the step is longest. `bent` are nodes that stand for the plane off it: they stay.
pub(super) fn smooth(
    made: &mut Made,
    ground: &Ground<'_>,
    bent: &BTreeSet<u32>,
    parts: &[u32],
    earlier: &[Plane],
) {
    let parts: Vec<u32> = made.origin.iter().map(|&e| parts[e as usize]).collect();
    let borders = Borders { parts: &parts, planes: &[earlier, &[ground.plane]].concat() };
    let nodes: BTreeSet<u32> = made.changed.iter().flat_map(|&e| nodes_of(&made.mesh, e)).collect();
    let mut at: HashMap<u32, Vec<u32>> = nodes.iter().map(|&n| (n, Vec::new())).collect();
    let mut near: BTreeSet<u32> = BTreeSet::new();
    for (e, element) in (0u32..).zip(&made.mesh.elements) {
        for n in element.nodes() {
            if let Some(list) = at.get_mut(n) {
                list.push(e);
                near.insert(e);
            }
        }
    }
    let near: Vec<u32> = near.into_iter().collect();
    let ways = ways(&made.mesh, ground, &nodes, &near, bent, &borders);
    let reference = ratios(ground.mesh, ground.smallest, 0..ground.mesh.elements.len() as u32).into_values();
    let reference = reference.map(|[k, m]| k / m).fold(0.0, f64::max);
    // Sums need all elements at the corners of those that may change.
    let corners: BTreeSet<u32> = near.iter().flat_map(|&e| nodes_of(&made.mesh, e)).collect();
    let around: Vec<u32> = (0u32..)
        .zip(&made.mesh.elements)
        .filter(|(_, element)| element.nodes().iter().any(|n| corners.contains(n)))
        .map(|(e, _)| e)
        .collect();
    let sums = ratios(&made.mesh, ground.smallest, around.into_iter());
    let smallest = ground.smallest;
    let sides = sides(&made.mesh, &corners);
    let mut patch =
        Patch { mesh: &mut made.mesh, at, shares: HashMap::new(), sums, reference, smallest, sides };
    for &e in &near {
        let share = patch.share(e, None);
        patch.shares.insert(e, share);
    }
    let mut moved: BTreeSet<u32> = BTreeSet::new();
    patch.sweep(&ways, &mut moved);
    let more: BTreeSet<u32> = moved.iter().filter_map(|n| patch.at.get(n)).flatten().copied().collect();
    let mut changed: BTreeSet<u32> = made.changed.iter().copied().collect();
    changed.extend(more);
    made.changed = changed.into_iter().collect();
    let ways = made.mesh.nodes.iter().zip(&ground.mesh.nodes).map(|(a, b)| norm(minus(*a, *b)));
    made.moved = ways.fold(0.0, f64::max);
}

struct Borders<'a> {
    parts: &'a [u32],
    planes: &'a [Plane],
}

/// The nodes that may move, and how.
fn ways(
    mesh: &Mesh,
    ground: &Ground<'_>,
    nodes: &BTreeSet<u32>,
    near: &[u32],
    bent: &BTreeSet<u32>,
    borders: &Borders<'_>,
) -> BTreeMap<u32, Way> {
    let (low, high) = mesh.bounds();
    let tolerance = 1e-9 * norm(minus(high, low));
    let freedom = freedom::of(mesh, near, borders.parts, borders.planes);
    let normal = ground.plane.normal;
    // Beyond the upright edges of the block columns of ground may stand, whose step goes by the shortest piece of an edge alone.
    let on_an_edge =
        |x: [f64; 3]| (0..2).all(|i| (x[i] - low[i]).abs() < tolerance || (x[i] - high[i]).abs() < tolerance);
    let way = |n: u32| -> Option<Way> {
        let fixed = bent.contains(&n) || ground.partners.contains_key(&n);
        if fixed || on_an_edge(mesh.nodes[n as usize]) {
            return None;
        }
        let on = ground.plane.distance(mesh.nodes[n as usize]).abs() < tolerance;
        match (freedom.get(&n)?, on) {
            (Freedom::Free, false) => Some(Way::Free),
            (Freedom::Free, true) => Some(Way::Flat(normal)),
            (Freedom::Flat(border), false) => Some(Way::Flat(*border)),
            (Freedom::Flat(border), true) => {
                let line = cross(*border, normal);
                let size = norm(line);
                Some(if size > 1e-3 { Way::Line(line.map(|c| c / size)) } else { Way::Flat(normal) })
            }
            // Along a straight edge; a bent one would lose its shape.
            (Freedom::Lines(lines), false) => match lines[..] {
                [[before, behind]] => {
                    let (one, two) = (norm(before), norm(behind));
                    let is_straight = dot(before, behind) < -(1.0 - 1e-9) * one * two;
                    is_straight.then(|| Way::Line(behind.map(|c| c / two)))
                }
                _ => None,
            },
            (Freedom::Lines(_), true) => None,
        }
    };
    nodes.iter().filter_map(|&n| Some((n, way(n)?))).collect()
}

impl Way {
    /// Directions to try, of length 1.
    fn tries(&self) -> Vec<[f64; 3]> {
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let both = |along: &[[f64; 3]]| along.iter().flat_map(|a| [*a, a.map(|c| -c)]).collect();
        match self {
            Way::Free => {
                let third = (1.0f64 / 3.0).sqrt();
                let diagonal =
                    |k: usize| std::array::from_fn(|i| if k >> i & 1 == 1 { -third } else { third });
                both(&[axes[0], axes[1], axes[2], diagonal(0), diagonal(1), diagonal(2), diagonal(4)])
            }
            Way::Line(line) => both(&[*line]),
            Way::Flat(normal) => {
                let least = (0..3).min_by(|&i, &j| normal[i].abs().total_cmp(&normal[j].abs())).unwrap_or(0);
                let one = cross(*normal, axes[least]);
                let size = norm(one);
                let one = one.map(|c| c / size);
                let two = cross(*normal, one);
                let half = std::f64::consts::FRAC_1_SQRT_2;
                let slant = |s: f64| std::array::from_fn(|i| half * (one[i] + s * two[i]));
                both(&[one, two, slant(1.0), slant(-1.0)])
            }
        }
    }
}

impl Patch<'_> {
    fn sweep(&mut self, ways: &BTreeMap<u32, Way>, moved: &mut BTreeSet<u32>) {
        let mut reach: BTreeMap<u32, f64> = BTreeMap::new();
        for _ in 0..SWEEPS {
            let mut any = false;
            for (&n, way) in ways {
                let size = *reach.entry(n).or_insert(FIRST);
                if size < LAST || self.is_good(n) {
                    continue;
                }
                any = true;
                let now = self.value(n, None);
                let (x, length) = (self.mesh.nodes[n as usize], size * self.edge(n));
                let places = way.tries().into_iter().map(|to| std::array::from_fn(|i| x[i] + length * to[i]));
                let values = places.map(|x| (self.value(n, Some(x)), x));
                match values.min_by(|a, b| a.0.total_cmp(&b.0)) {
                    Some((value, x)) if value < (1.0 - 1e-6) * now => {
                        self.go(n, x);
                        moved.insert(n);
                    }
                    _ => drop(reach.insert(n, SHRINKS * size)),
                }
            }
            if !any {
                break;
            }
        }
    }

    /// What an element brings, with one of its corners elsewhere if that is given.
    fn share(&self, e: u32, elsewhere: Option<(u32, [f64; 3])>) -> Share {
        let element = &self.mesh.elements[e as usize];
        let mut places = [[0.0; 3]; 8];
        for (place, &n) in places.iter_mut().zip(element.nodes()) {
            *place = match elsewhere {
                Some((m, x)) if m == n => x,
                _ => self.mesh.nodes[n as usize],
            };
        }
        let x = &places[..element.nodes().len()];
        let (stiffness, mass, own) = stiffness(element.shape, x, self.smallest);
        let jacobian = quality::scaled_jacobian(element.shape, x);
        let jacobian = if jacobian.is_nan() { -1.0 } else { jacobian };
        let mut fault = power(JACOBIAN, jacobian) + power(OWN_STEP, own / self.smallest);
        for face in element.shape.faces() {
            let bits = face.iter().map(|&k| self.sides.get(&element.nodes[k]).copied().unwrap_or_default());
            if bits.fold(u8::MAX, |all, own| all & own) != 0 {
                fault += power(SIDE_FACE, height(face.iter().map(|&k| x[k])) / self.smallest);
            }
        }
        Share { stiffness, mass, fault }
    }

    /// What a node's place costs: of the elements at it and all their corners.
    fn value(&self, n: u32, place: Option<[f64; 3]>) -> f64 {
        let mut change: Vec<(u32, [f64; 2])> = Vec::with_capacity(32);
        let mut fault = 0.0;
        for &e in &self.at[&n] {
            let old = self.shares[&e];
            let new = place.map_or(old, |x| self.share(e, Some((n, x))));
            fault += new.fault;
            for (k, &m) in self.mesh.elements[e as usize].nodes().iter().enumerate() {
                let here = change.iter().position(|(n, _)| *n == m).unwrap_or_else(|| {
                    change.push((m, self.sums[&m]));
                    change.len() - 1
                });
                let sum = &mut change[here].1;
                sum[0] += new.stiffness[k] - old.stiffness[k];
                sum[1] += new.mass - old.mass;
            }
        }
        fault + change.iter().map(|(_, [k, m])| (k / m / self.reference).powi(POWER / 2)).sum::<f64>()
    }

    fn go(&mut self, n: u32, place: [f64; 3]) {
        self.mesh.nodes[n as usize] = place;
        for e in self.at[&n].clone() {
            let new = self.share(e, None);
            let old = self.shares.insert(e, new).unwrap_or_default();
            for (k, &m) in self.mesh.elements[e as usize].nodes().iter().enumerate() {
                if let Some(sum) = self.sums.get_mut(&m) {
                    sum[0] += new.stiffness[k] - old.stiffness[k];
                    sum[1] += new.mass - old.mass;
                }
            }
        }
    }

    fn is_good(&self, n: u32) -> bool {
        self.at[&n].iter().all(|e| {
            let corners = self.mesh.elements[*e as usize].nodes().iter();
            let ratios = corners.map(|m| self.sums[m]).map(|[k, m]| k / m / self.reference);
            self.shares[e].fault < GOOD_FAULT && ratios.fold(0.0, f64::max) < GOOD_RATIO
        })
    }

    /// The mean way to the corners of the elements at a node \[m\].
    fn edge(&self, n: u32) -> f64 {
        let x = self.mesh.nodes[n as usize];
        let corners: BTreeSet<u32> = self.at[&n].iter().flat_map(|&e| nodes_of(self.mesh, e)).collect();
        let ways = corners.iter().map(|&m| norm(minus(self.mesh.nodes[m as usize], x)));
        ways.sum::<f64>() / (corners.len() - 1).max(1) as f64
    }
}

/// For nodes on sides normal to x and y a bit for each of the four.
fn sides(mesh: &Mesh, nodes: &BTreeSet<u32>) -> HashMap<u32, u8> {
    let (low, high) = mesh.bounds();
    let tolerance = 1e-9 * norm(minus(high, low));
    let bits = |n: u32| {
        let x = mesh.nodes[n as usize];
        let levels = [(0, low), (0, high), (1, low), (1, high)];
        let on = levels.iter().enumerate().filter(|(_, (axis, at))| (x[*axis] - at[*axis]).abs() < tolerance);
        on.fold(0, |bits, (k, _)| bits | 1 << k)
    };
    nodes.iter().map(|&n| (n, bits(n))).filter(|(_, bits)| *bits != 0).collect()
}

/// The height of a triangle over its longest edge \[m\], or about that of a quadrilateral.
fn height(corners: impl Iterator<Item = [f64; 3]>) -> f64 {
    let x: Vec<[f64; 3]> = corners.collect();
    let longest = (0..x.len()).map(|k| norm(minus(x[(k + 1) % x.len()], x[k]))).fold(0.0, f64::max);
    let across = match x[..] {
        [a, b, c] => cross(minus(b, a), minus(c, a)),
        [a, b, c, d] => cross(minus(c, a), minus(d, b)).map(|c| 0.5 * c),
        _ => return longest,
    };
    norm(across) / longest
}

fn nodes_of(mesh: &Mesh, e: u32) -> impl Iterator<Item = u32> + '_ {
    mesh.elements[e as usize].nodes().iter().copied()
}

/// What a value below a good one costs: a power, and below a tenth of the good one a line, so that what is turned inside out turns back.
fn power(good: f64, value: f64) -> f64 {
    let least = 0.1 * good;
    (good / value.max(least)).powi(POWER) * (1.0 + (least - value).max(0.0) / good * f64::from(10 * POWER))
}

/// Stiffness over c² \[m\] and mass over density \[m³\] of the corners of elements.
fn ratios(mesh: &Mesh, smallest: f64, elements: impl Iterator<Item = u32>) -> HashMap<u32, [f64; 2]> {
    let mut sums: HashMap<u32, [f64; 2]> = HashMap::new();
    for e in elements {
        let element = &mesh.elements[e as usize];
        let x: Vec<[f64; 3]> = element.nodes().iter().map(|&n| mesh.nodes[n as usize]).collect();
        let (stiffness, mass, _) = stiffness(element.shape, &x, smallest);
        for (k, &n) in element.nodes().iter().enumerate() {
            let sum = sums.entry(n).or_default();
            sum[0] += stiffness[k];
            sum[1] += mass;
        }
    }
    sums
}

/// V b·b of an element's corners \[m\], the volume of each \[m³\], and the element's own step length \[m\] (as `polyhedron::step_length`). In the first
/// two a volume below a thousandth of `smallest`³ counts as that.
fn stiffness(shape: Shape, x: &[[f64; 3]], smallest: f64) -> ([f64; 8], f64, f64) {
    let squares = corner_areas(shape, x).map(|a| dot(a, a));
    let volume = quality::volume(shape, x);
    let own = volume.max(0.0) * (1.5 / squares.iter().sum::<f64>()).sqrt();
    let volume = volume.max(1e-3 * smallest.powi(3));
    (squares.map(|square| square / volume), volume / x.len() as f64, own)
}
