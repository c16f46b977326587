//! Planes that cut any mesh: nodes near them move onto them, and elements that they still cross are divided.
//!
//! Of each edge that the plane crosses one end moves onto it, or the edge takes a node there; which, is the cheapest choice of all
//! (`choose.rs`), where moving by a share r of an edge costs about r². An element with corners on both sides is parted into two bodies,
//! whose faces of five and more corners fall into triangles and quadrilaterals by their nodes alone, so that neighbours match; each
//! body becomes hexahedra, wedges, pyramids and tetrahedra without another node on its faces (`polyhedron.rs`). Only elements with
//! corners on both sides are divided. Where what comes out is poor, its nodes become dearer, and the choice is made anew. Through a thin
//! lining the plane goes as on its outer face (`columns.rs`), and in the end nodes move to where the step is longest (`smooth.rs`).

mod choose;
mod columns;
mod flow;
mod freedom;
mod pieces;
mod polyhedron;
mod smooth;
#[cfg(test)]
mod tests;

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use super::{Cut, CutError, LEAST_JACOBIAN};
use crate::Mesh;
use crate::places::middle;
use crate::plane::Plane;
use crate::topology::{dot, minus, norm};
use choose::{Choice, Prices, cheapest};
use freedom::Freedom;
use pieces::Pieces;

/// Greatest way of a node onto the plane, as a share of an edge in that direction.
const MOST_SHARE: f64 = 0.7;
/// How far off the plane a node that cannot move may stand in for it, as a share of an edge.
const MOST_BEND: f64 = 0.4;
/// Price of such a node.
const BENT: f64 = 3.0;
/// Price of an edge that takes a node, and of one on a side, where the opposite one would want it as well.
const PARTED: f64 = 1.0;
const ON_A_SIDE: f64 = 1e4;
/// How often a choice is made anew where elements come out poor.
const TRIES: usize = 24;
/// How often that is done anew, where elements are poor even after nodes have moved to better places.
const ROUNDS: usize = 5;
/// Scaled Jacobian that is good enough.
const GOOD_JACOBIAN: f64 = 0.18;
/// Rings of nodes beside the plane that follow its nodes, as tried.
const RINGS: [usize; 2] = [0, 1];
/// Sweeps by which they find their places.
const SWEEPS: usize = 20;
/// Elements within so many of their own sizes of the plane are looked at.
const NEAR: f64 = 6.0;

/// A mesh with a plane in it, and what changed.
pub(super) struct Made {
    pub mesh: Mesh,
    /// Elements that were moved or divided, ascending.
    pub changed: Vec<u32>,
    /// Greatest way of a node \[m\].
    pub moved: f64,
    /// Elements above and below, ascending; of a plane with an extent those that touch it.
    pub sides: [Vec<u32>; 2],
    /// For each element of `mesh` the one that it was part of.
    pub origin: Vec<u32>,
}

/// By how much nodes and edges are dearer, where what they made was poor.
#[derive(Default)]
struct Dearer {
    nodes: HashMap<u32, f64>,
    edges: HashMap<[u32; 2], f64>,
}

/// What is known of a mesh near a plane.
struct Ground<'a> {
    mesh: &'a Mesh,
    plane: Plane,
    /// Elements that the plane may change.
    near: Vec<u32>,
    freedom: HashMap<u32, Freedom>,
    /// Distances from the plane of the nodes of `near` \[m\]; 0 within round-off.
    off: HashMap<u32, f64>,
    /// Nodes joined with each by an edge.
    beside: HashMap<u32, BTreeSet<u32>>,
    /// Edges that the plane crosses, the node above first.
    crossed: BTreeSet<[u32; 2]>,
    /// Nodes through a lining's thickness, with those that stand for them.
    leads: HashMap<u32, u32>,
    /// Nodes of linings, which only the plane moves.
    lined: HashSet<u32>,
    /// Nodes that move with each, on sides that match, and the axes of the sides.
    partners: HashMap<u32, Vec<(u32, usize)>>,
    /// The smallest step length of all elements \[m\].
    smallest: f64,
}

/// Puts a plane into a mesh. `parts` says for each element which part it belongs to: the borders between parts keep their shape, as do the
/// planes that were put there before. Nodes through the thickness of `thin` elements move together. Sides of axes that are `free` need not match.
pub(super) fn cut(
    mesh: &Mesh,
    cut: &Cut,
    thin: &[bool],
    parts: &[u32],
    earlier: &[Plane],
    free: [bool; 2],
) -> Result<Made, CutError> {
    let ground = Ground::of(mesh, cut.plane, thin, parts, earlier, free);
    if ground.crossed.is_empty() {
        return Err(CutError::Misses { name: cut.name.clone() });
    }
    let mut dearer = Dearer::default();
    let mut trouble = cut.plane.through;
    let mut best: Option<(f64, Made)> = None;
    for _ in 0..ROUNDS {
        let Some(pieces) = choose_pieces(&ground, &mut dearer, &mut trouble) else { continue };
        let bent = pieces.bent(&ground);
        let mut made = pieces.apply(&ground, cut);
        smooth::smooth(&mut made, &ground, &bent, parts, earlier);
        let poor: BTreeMap<u32, f64> = made
            .changed
            .iter()
            .map(|&e| (e, jacobian_of(&made.mesh, e)))
            .filter(|(_, jacobian)| *jacobian < GOOD_JACOBIAN)
            .collect();
        let jacobian = poor.values().copied().fold(GOOD_JACOBIAN, f64::min);
        for &e in poor.keys() {
            trouble = middle(&made.mesh, e);
            let from = made.origin[e as usize];
            dearer.nodes_of(&ground, mesh.elements[from as usize].nodes(), 4.0);
        }
        if best.as_ref().is_none_or(|b| jacobian > b.0) {
            best = Some((jacobian, made));
        }
        if jacobian >= GOOD_JACOBIAN {
            break;
        }
    }
    let Some((_, made)) = best else {
        return Err(CutError::NoWay { name: cut.name.clone(), at: [trouble[0], trouble[2]] });
    };
    let worst = crate::quality::summary_of(&made.mesh, made.changed.iter().copied());
    if worst.min_scaled_jacobian.is_nan() || worst.min_scaled_jacobian < LEAST_JACOBIAN {
        let at = worst.worst.map_or(cut.plane.through, |e| middle(&made.mesh, e));
        return Err(CutError::Poor { name: cut.name.clone(), jacobian: worst.min_scaled_jacobian, at });
    }
    Ok(made)
}

/// The best of some choices, each with what was poor of those before dearer; nothing if none has elements.
fn choose_pieces(ground: &Ground<'_>, dearer: &mut Dearer, trouble: &mut [f64; 3]) -> Option<Pieces> {
    let mesh = ground.mesh;
    let mut best: Option<(f64, Pieces)> = None;
    for trial in 0..TRIES {
        let choice = ground.all_of(cheapest(&ground.prices(dearer)));
        let mut bad: BTreeSet<u32> = BTreeSet::new();
        let mut moved_too_far = false;
        if let Some(edge) = choice.edges.iter().find(|edge| ground.on_a_side(**edge)) {
            *trouble = mesh.nodes[edge[0] as usize];
        } else {
            for rings in RINGS {
                let moves = ground.spread(&choice, rings);
                // Partners that want unlike ways leave nodes off the plane, which may bend by little.
                if let Some(n) = ground.too_far(&choice, &moves) {
                    *trouble = mesh.nodes[n as usize];
                    *dearer.nodes.entry(n).or_insert(1.0) *= 4.0;
                    moved_too_far = true;
                    break;
                }
                match Pieces::of(ground, &choice, moves) {
                    Ok(pieces) => {
                        let (score, poor) = pieces.score(ground);
                        bad.extend(poor);
                        if best.as_ref().is_none_or(|b| score > 1.02 * b.0) {
                            best = Some((score, pieces));
                        }
                    }
                    Err(elements) => {
                        *trouble = middle(mesh, elements[0]);
                        bad.extend(elements);
                    }
                }
            }
        }
        if bad.is_empty() && !moved_too_far {
            break;
        }
        for element in bad {
            let nodes = mesh.elements[element as usize].nodes();
            // Nodes twice as often as edges: to part more is the way out more often than to part less.
            if trial % 3 < 2 {
                let leads = nodes.iter().map(|n| ground.lead(*n)).filter(|n| choice.nodes.contains(n));
                for n in leads.collect::<BTreeSet<u32>>() {
                    *dearer.nodes.entry(n).or_insert(1.0) *= 1.2 + 2.0 * chance(n, trial);
                }
            } else {
                let own = |edge: &&[u32; 2]| edge.iter().all(|n| nodes.contains(n));
                let leads = choice.edges.iter().filter(own).map(|edge| edge.map(|n| ground.lead(n)));
                for edge in leads.collect::<BTreeSet<[u32; 2]>>() {
                    *dearer.edges.entry(edge).or_insert(1.0) *= 1.5 + 4.0 * chance(edge[0] ^ edge[1], trial);
                }
            }
        }
    }
    best.map(|(_, pieces)| pieces)
}

/// A number from 0 to 1 that looks like chance, the same everywhere: alike prices of an element's nodes would rise alike, and the choice
/// stay as it is.
fn chance(n: u32, trial: usize) -> f64 {
    let mixed = (n as u64 + 1)
        .wrapping_mul(0x9E37_79B9_7F4A_7C15)
        .wrapping_add(trial as u64)
        .wrapping_mul(0xBF58_476D_1CE4_E5B9);
    (mixed >> 40) as f64 / (1u64 << 24) as f64
}

fn jacobian_of(mesh: &Mesh, e: u32) -> f64 {
    let element = &mesh.elements[e as usize];
    let x: Vec<[f64; 3]> = element.nodes().iter().map(|&n| mesh.nodes[n as usize]).collect();
    let jacobian = crate::quality::scaled_jacobian(element.shape, &x);
    if jacobian.is_nan() { -1.0 } else { jacobian }
}

impl Dearer {
    /// Makes all nodes of an element dearer, by those that lead.
    fn nodes_of(&mut self, ground: &Ground<'_>, nodes: &[u32], times: f64) {
        for n in nodes.iter().map(|n| ground.lead(*n)).collect::<BTreeSet<u32>>() {
            *self.nodes.entry(n).or_insert(1.0) *= times;
        }
    }
}

impl<'a> Ground<'a> {
    fn of(
        mesh: &'a Mesh,
        plane: Plane,
        thin: &[bool],
        parts: &[u32],
        earlier: &[Plane],
        free: [bool; 2],
    ) -> Ground<'a> {
        let leads = columns::leads(mesh, thin);
        let (low, high) = mesh.bounds();
        let tolerance = 1e-9 * norm(minus(high, low));
        let distance = |n: u32| {
            let lead = leads.get(&n).copied().unwrap_or(n);
            let off = plane.distance(mesh.nodes[lead as usize]);
            if off.abs() < tolerance { 0.0 } else { off }
        };
        let partners = partners(mesh, free);
        let mut near: BTreeSet<u32> = BTreeSet::new();
        let mut opposite: BTreeSet<u32> = BTreeSet::new();
        for (e, element) in (0u32..).zip(&mesh.elements) {
            let of = || element.nodes().iter().map(|&n| distance(n));
            let (least, most) = (of().fold(f64::INFINITY, f64::min), of().fold(f64::NEG_INFINITY, f64::max));
            let reach = NEAR * (most - least);
            if least < reach && most > -reach {
                near.insert(e);
                let across = |n: &u32| partners.get(n).into_iter().flatten().map(|(m, _)| *m);
                opposite.extend(element.nodes().iter().flat_map(across));
            }
        }
        // What moves with nodes near the plane is looked at as well; twice, for the edges where sides meet.
        let more: Vec<u32> =
            opposite.iter().filter_map(|n| partners.get(n)).flatten().map(|(m, _)| *m).collect();
        opposite.extend(more);
        let beside_them = (0u32..).zip(&mesh.elements);
        near.extend(
            beside_them.filter(|(_, e)| e.nodes().iter().any(|n| opposite.contains(n))).map(|(e, _)| e),
        );
        let near: Vec<u32> = near.into_iter().collect();
        let mut off = HashMap::new();
        let mut beside: HashMap<u32, BTreeSet<u32>> = HashMap::new();
        let mut crossed = BTreeSet::new();
        for &e in &near {
            let element = &mesh.elements[e as usize];
            for face in element.shape.faces() {
                for (k, &a) in face.iter().enumerate() {
                    let [a, b] = [a, face[(k + 1) % face.len()]].map(|k| element.nodes[k]);
                    off.entry(a).or_insert_with(|| distance(a));
                    beside.entry(a).or_default().insert(b);
                    beside.entry(b).or_default().insert(a);
                    let (of_a, of_b) = (distance(a), distance(b));
                    if of_a * of_b < 0.0 {
                        crossed.insert(if of_a > 0.0 { [a, b] } else { [b, a] });
                    }
                }
            }
        }
        let freedom = freedom::of(mesh, &near, parts, earlier);
        let at = |n: u32| mesh.nodes[n as usize];
        let steps = mesh.elements.iter().map(|e| polyhedron::step_length(e, &at));
        let smallest = steps.fold(f64::INFINITY, f64::min);
        let lined = mesh.elements.iter().zip(thin).filter(|(_, thin)| **thin);
        let lined = lined.flat_map(|(e, _)| e.nodes().iter().copied()).collect();
        Ground { mesh, plane, near, freedom, off, beside, crossed, leads, lined, partners, smallest }
    }

    /// The node by which the plane goes at another, most often that itself.
    fn lead(&self, n: u32) -> u32 {
        self.leads.get(&n).copied().unwrap_or(n)
    }

    fn at(&self, n: u32) -> [f64; 3] {
        self.mesh.nodes[n as usize]
    }

    fn is_free(&self, n: u32) -> &Freedom {
        static FIXED: Freedom = Freedom::Lines(Vec::new());
        self.freedom.get(&n).unwrap_or(&FIXED)
    }

    /// A way as a share of the edges at a node, in its direction.
    fn share(&self, n: u32, way: [f64; 3]) -> f64 {
        let x = self.at(n);
        let along = |&m: &u32| {
            let edge = minus(self.at(m), x);
            dot(way, edge).max(0.0) / dot(edge, edge)
        };
        self.beside.get(&n).into_iter().flatten().map(along).fold(0.0, f64::max)
    }

    /// Whether both ends of an edge have partners across the same sides.
    fn on_a_side(&self, [a, b]: [u32; 2]) -> bool {
        let axes = |n: u32| self.partners.get(&n).into_iter().flatten().map(|(_, axis)| *axis);
        axes(a).any(|axis| axes(b).any(|other| other == axis))
    }

    fn prices(&self, dearer: &Dearer) -> Prices {
        let mut prices = Prices::default();
        for edge in self.crossed.iter().map(|edge| edge.map(|n| self.lead(n))) {
            for n in edge {
                let price = match self.is_free(n).onto(&self.plane, self.at(n)) {
                    Some(way) if self.share(n, way) <= MOST_SHARE => {
                        let share = self.share(n, way);
                        Some(0.02 + share * share * (1.0 + (share / 0.5).powi(4)))
                    }
                    _ => {
                        let away = self.plane.normal.map(|c| -self.off[&n] * c);
                        (self.share(n, away) <= MOST_BEND).then_some(BENT)
                    }
                };
                if let Some(price) = price {
                    prices.nodes.insert(n, price * dearer.nodes.get(&n).copied().unwrap_or(1.0));
                }
            }
            let [a, b] = edge.map(|n| self.off[&n].abs());
            let least = a.min(b) / (a + b);
            let price = if self.on_a_side(edge) { ON_A_SIDE } else { PARTED * (0.5 + 0.1 / least) };
            prices.edges.insert(edge, price * dearer.edges.get(&edge).copied().unwrap_or(1.0));
        }
        prices
    }

    /// The way of a node onto the plane: within the slice where it goes by another, as that one if it has none.
    fn way(&self, n: u32) -> [f64; 3] {
        let own = |n: u32| {
            let way = self.is_free(n).onto(&self.plane, self.at(n));
            way.filter(|way| self.share(n, *way) <= MOST_SHARE)
        };
        let lead = self.lead(n);
        if lead == n {
            return own(n).unwrap_or_default();
        }
        let through = minus(self.at(lead), self.at(n));
        let thick = norm(through);
        let across = dot(self.plane.normal, through) / thick;
        let along: [f64; 3] = std::array::from_fn(|i| self.plane.normal[i] - across * through[i] / thick);
        let off = self.plane.distance(self.at(n));
        let within = match self.is_free(n) {
            Freedom::Free => (dot(along, along) > 0.1).then(|| along.map(|c| -off * c / dot(along, along))),
            other => other.onto(&self.plane, self.at(n)),
        };
        // Shares along the thickness do not count: all through it goes the same way.
        let short = |way: &[f64; 3]| {
            let x = self.at(n);
            let beside = self.beside.get(&n).into_iter().flatten().filter(|m| self.lead(**m) != lead);
            let share = |m: &u32| {
                let edge = minus(self.at(*m), x);
                dot(*way, edge).max(0.0) / dot(edge, edge)
            };
            beside.map(share).fold(0.0, f64::max) <= MOST_SHARE
        };
        within.filter(short).unwrap_or_else(|| self.is_free(n).follow(own(lead).unwrap_or_default()))
    }

    /// A choice among nodes that lead, with those that go by them.
    fn all_of(&self, chosen: Choice) -> Choice {
        let nodes = self.off.keys().copied().filter(|n| chosen.nodes.contains(&self.lead(*n)));
        let edges =
            self.crossed.iter().copied().filter(|edge| chosen.edges.contains(&edge.map(|n| self.lead(n))));
        Choice { nodes: nodes.collect(), edges: edges.collect() }
    }

    /// The ways of nodes: those chosen onto the plane, their partners with them, and so many rings of nodes beside them between.
    fn spread(&self, choice: &Choice, rings: usize) -> BTreeMap<u32, [f64; 3]> {
        let mut moves: BTreeMap<u32, [f64; 3]> = BTreeMap::new();
        let mut count: BTreeMap<u32, f64> = BTreeMap::new();
        for &n in &choice.nodes {
            let way = self.way(n);
            // Nodes that are partners go the mean of what they want.
            for m in self.together(n) {
                let sum = moves.entry(m).or_default();
                *sum = std::array::from_fn(|i| sum[i] + way[i]);
                *count.entry(m).or_default() += 1.0;
            }
        }
        for (n, way) in &mut moves {
            *way = way.map(|w| w / count[n]);
        }
        let given: BTreeSet<u32> = moves.keys().copied().collect();
        let mut front = given.clone();
        let mut follow: BTreeSet<u32> = BTreeSet::new();
        for _ in 0..rings {
            front = front.iter().flat_map(|n| self.beside.get(n).into_iter().flatten().copied()).collect();
            follow.extend(&front);
        }
        // What lies on sides stays, so that they match.
        let follow: Vec<u32> = follow
            .into_iter()
            .filter(|n| !given.contains(n) && !self.partners.contains_key(n) && self.off[n] != 0.0)
            .filter(|n| !self.lined.contains(n))
            .collect();
        for _ in 0..if follow.is_empty() { 0 } else { SWEEPS } {
            for &n in &follow {
                let (mut sum, mut weight) = ([0.0; 3], 0.0);
                for &m in &self.beside[&n] {
                    let near = 1.0 / norm(minus(self.at(m), self.at(n)));
                    let way = moves.get(&m).copied().unwrap_or_default();
                    (0..3).for_each(|i| sum[i] += near * way[i]);
                    weight += near;
                }
                let way = self.is_free(n).follow(sum.map(|s| s / weight));
                moves.insert(n, way);
            }
        }
        // None comes nearer to the plane than a quarter of its distance.
        for n in follow {
            let (off, way) = (self.off[&n], moves[&n]);
            let nearer = -dot(way, self.plane.normal) / off;
            if nearer > 0.75 {
                moves.insert(n, self.is_free(n).follow(way.map(|w| 0.75 * w / nearer)));
            }
        }
        moves.retain(|_, way| *way != [0.0; 3]);
        moves
    }

    /// The chosen node that stays farthest off the plane, if that is more than the plane may bend.
    fn too_far(&self, choice: &Choice, moves: &BTreeMap<u32, [f64; 3]>) -> Option<u32> {
        let left = |n: u32| {
            let way = moves.get(&n).copied().unwrap_or_default();
            let x = self.at(n);
            let off = self.plane.distance(std::array::from_fn(|i| x[i] + way[i]));
            self.share(n, self.plane.normal.map(|c| -off * c))
        };
        let leads = choice.nodes.iter().filter(|n| !self.leads.contains_key(n));
        let worst = leads.map(|&n| (left(n), n)).max_by(|a, b| a.0.total_cmp(&b.0))?;
        (worst.0 > MOST_BEND).then_some(worst.1)
    }

    /// A node with those that move with it.
    fn together(&self, n: u32) -> BTreeSet<u32> {
        let mut all = BTreeSet::from([n]);
        let mut front = vec![n];
        while let Some(at) = front.pop() {
            for &(m, _) in self.partners.get(&at).into_iter().flatten() {
                if all.insert(m) {
                    front.push(m);
                }
            }
        }
        all
    }
}

/// For nodes on sides normal to x and y the node at the same place on the opposite side; none where not all have one, or where sides are free.
fn partners(mesh: &Mesh, free: [bool; 2]) -> HashMap<u32, Vec<(u32, usize)>> {
    let mut all: HashMap<u32, Vec<(u32, usize)>> = HashMap::new();
    let (low, high) = mesh.bounds();
    for axis in (0..2).filter(|&axis| !free[axis]) {
        let tolerance = 1e-9 * (high[axis] - low[axis]);
        let place = |x: [f64; 3]| [1 - axis, 2].map(|i| (x[i] / (1e3 * tolerance)).round() as i64);
        let on = |level: f64| {
            let is = move |x: &[f64; 3]| (x[axis] - level).abs() < tolerance;
            (0u32..).zip(&mesh.nodes).filter(move |(_, x)| is(x))
        };
        let other: HashMap<[i64; 2], u32> = on(high[axis]).map(|(n, x)| (place(*x), n)).collect();
        let pairs: Vec<[u32; 2]> =
            on(low[axis]).filter_map(|(n, x)| Some([n, *other.get(&place(*x))?])).collect();
        if pairs.len() < other.len() || pairs.len() < on(low[axis]).count() {
            continue;
        }
        for [a, b] in pairs {
            all.entry(a).or_default().push((b, axis));
            all.entry(b).or_default().push((a, axis));
        }
    }
    all
}
