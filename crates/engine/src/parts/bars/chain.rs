//! A bar that slides in its bond: where it is along its axis, given the ground.
//!
//! With w the displacement of the bar along its axis and u that of the ground, EA w″ = b(w − u): the bond's force b per length
//! grows with the slip and ends at its strength. By nodes, N_i − N_{i−1} = Σ b, with N the tension of the segments and b the
//! sliders of half a segment on either side; where an interface crosses there are two sliders, one for each side's ground. There
//! is no mass, so w follows u in every evaluation, and the step is not bound by it. w makes a convex energy smallest: Newton's
//! method finds it, with a tridiagonal system a pass, which goes along its step as far as the energy falls. Mostly one pass does;
//! where eight do not, as much slides and yields at once, the [`sweep`] finds it without iteration.
//!
//! Where there is no balance, as a bolt is drawn out by more than its bond holds, nodes give what is left to their sliders, beyond their
//! strength: no force is lost, what it does is booked with friction, and its largest size is kept to be reported.

mod curve;
pub mod elastic;
mod newton;
mod sweep;

use super::Bar;
use super::link::Link;
use super::memory::{BROKEN, BoltMemory, CUT_OFF, LinkMemory, PointMemory};
use crate::bolts::Bolts;
use std::ops::Range;
use tremolite_laws::Row;

/// Passes after which all is found in one sweep.
const MOST_PASSES: u32 = 8;
/// Out of balance over the largest force, and over what forces displacements have in them, that is round-off.
const BALANCED: f64 = 1e-11;
const ROUND_OFF: f64 = 1e-14;
/// Forces this near to a bound are at it.
const NEARLY: f64 = 1.0 - 1e-9;

/// A bolt on its way through an evaluation.
#[derive(Default)]
pub struct Chain {
    links: Vec<Link>,
    free: Vec<bool>,
    /// m
    lengths: Vec<f64>,
    /// Points of each node, by their places in the bolt; the second where an interface crosses.
    nodes: Vec<[Option<usize>; 2]>,
    along: [f64; 3],
    first: usize,
    plates: [bool; 2],
    /// Displacement \[m\] of the ground along the bar by point.
    ground: Vec<f64>,
    /// Force on the ground along the bar \[N\] by point.
    forces: Vec<f64>,
    /// Displacement \[m\] of the bar along its axis by node.
    bar: Vec<f64>,
    /// What is out of balance by node \[N\], how it falls with the node's displacement, and how the tension of each link grows
    /// \[N/m\].
    unbalanced: bool,
    residual: Vec<f64>,
    diagonal: Vec<f64>,
    slopes: Vec<f64>,
    /// A step, where it began, and what eliminates for it.
    step: Vec<f64>,
    from: Vec<f64>,
    upper: Vec<f64>,
}

/// The larger size; what is not a number is larger than all, so that it shows.
fn larger(so_far: f64, now: f64) -> f64 {
    if now.abs() > so_far || now.is_nan() { now.abs() } else { so_far }
}

/// Whether a plate holds the head, the other end, of a bolt of so many segments: not where an excavation took what it pressed on.
fn held(links: usize, plates: [bool; 2], memory: &BoltMemory) -> [bool; 2] {
    let stands = |k: usize| memory.link(k).status < CUT_OFF;
    [plates[0] && stands(0), plates[1] && stands(links - 1)]
}

impl Chain {
    /// Takes a bolt with the displacements of all points of its part.
    pub fn set(&mut self, bars: &[Bar], of: Range<usize>, kind: &Bolts, points: &[Row]) {
        self.links.clear();
        self.links.extend(bars.iter().map(|bar| Link::of(bar, kind)));
        self.free.clear();
        self.free.extend(bars.iter().map(|bar| bar.free));
        self.lengths.clear();
        self.lengths.extend(bars.iter().map(|bar| bar.length));
        (self.first, self.plates) = (of.start, kind.plates);
        self.along = bars.first().map_or([0.0; 3], |bar| bar.along);
        self.ground.clear();
        self.ground.extend(points[of.clone()].iter().map(|row| {
            let [x, y, z] = self.along;
            x * row.0[0] + y * row.0[1] + z * row.0[2]
        }));
        self.nodes.clear();
        let local = |p: u32| p as usize - of.start;
        for (k, bar) in bars.iter().enumerate() {
            let begins = local(bar.points[0]);
            match self.nodes.last_mut().filter(|_| k > 0) {
                Some(node) if node[0] != Some(begins) => node[1] = Some(begins),
                Some(_) => {}
                None => self.nodes.push([Some(begins), None]),
            }
            self.nodes.push([Some(local(bar.points[1])), None]);
        }
        self.forces.clear();
        self.forces.resize(self.ground.len(), 0.0);
    }

    /// Gives each point stiffness \[N/m\] and strength \[N\] from the length \[m\] of the segments beside it that are bonded there;
    /// `of` is asked point by point in their order.
    pub fn tributaries(&self, memory: &mut BoltMemory, mut of: impl FnMut(f64) -> [f64; 2]) {
        let mut lengths = vec![0.0; self.ground.len()];
        for k in 0..self.links.len() {
            if self.free[k] || memory.link(k).status >= CUT_OFF {
                continue;
            }
            let [begins, ends] = self.ends(k);
            lengths[begins] += 0.5 * self.lengths[k];
            lengths[ends] += 0.5 * self.lengths[k];
        }
        for (p, length) in lengths.into_iter().enumerate() {
            let [stiffness, strength] = of(length);
            memory.set_point(p, &PointMemory { stiffness, strength, ..memory.point(p) });
        }
    }

    /// The points in whose ground a link begins and ends.
    fn ends(&self, link: usize) -> [usize; 2] {
        let [first, second] = self.nodes[link];
        let begins = second.or(first).unwrap_or(0);
        [begins, self.nodes[link + 1][0].unwrap_or(0)]
    }

    /// Lets the bar find its place, and the forces on the ground.
    pub fn respond(&mut self, memory: &mut BoltMemory) {
        self.bar.clear();
        self.bar.extend_from_slice(memory.bar);
        let [head, tail] = held(self.links.len(), self.plates, memory);
        if let (true, Some(p)) = (head, self.nodes[0][0]) {
            self.bar[0] = self.ground[p] - memory.point(p).reference;
        }
        let last = self.links.len();
        if let (true, Some(p)) = (tail, self.nodes[last][0]) {
            self.bar[last] = self.ground[p] - memory.point(p).reference;
        }
        let fixed = [head, tail];
        let mut passes = 0;
        loop {
            let mut tried = 0;
            self.evaluate(memory, fixed);
            while self.unbalanced && tried < MOST_PASSES {
                tried += 1;
                self.improve(memory, fixed);
            }
            // Without bounds all is linear, and round-off is all that is left.
            if self.unbalanced && memory.points.iter().all(|p| PointMemory::read(p).strength.is_finite()) {
                self.sweep(memory, fixed);
            }
            passes = tried.max(passes);
            // What breaks leaves its load to the others; no more can break than there are.
            if !self.break_links(memory) {
                break;
            }
        }
        self.settle(memory, fixed, passes);
    }

    /// As if nothing slid or yielded, from an empty memory with the bond's stiffness.
    pub fn respond_elastically(&mut self, memory: &mut BoltMemory) {
        self.links.iter_mut().for_each(|link| (link.yields, link.breaks) = (f64::INFINITY, f64::INFINITY));
        self.respond(memory);
    }

    /// What is out of balance at every node, and how the forces there change.
    fn evaluate(&mut self, memory: &BoltMemory, fixed: [bool; 2]) {
        let last = self.links.len();
        self.residual.clear();
        self.slopes.clear();
        self.diagonal.clear();
        let (mut before, mut slope_before) = (0.0, 0.0);
        // The largest force, and what round-off may make of displacements.
        let (mut largest, mut round_off): (f64, f64) = (0.0, 0.0);
        for i in 0..=last {
            let (after, slope) = match i < last {
                true => self.tension(i, &memory.link(i)),
                false => (0.0, 0.0),
            };
            let mut residual = after - before;
            let mut diagonal = slope_before + slope;
            for p in self.nodes[i].into_iter().flatten() {
                let point = memory.point(p);
                let trial = point.stiffness * (self.ahead(i, p, &point) - point.slip);
                let force = trial.clamp(-point.strength, point.strength);
                residual -= force;
                largest = largest.max(force.abs());
                round_off = round_off.max(point.stiffness * self.bar[i].abs());
                if force == trial {
                    diagonal += point.stiffness;
                }
            }
            largest = largest.max(after.abs());
            round_off = round_off.max(slope * self.bar[i].abs());
            let is_fixed = (i == 0 && fixed[0]) || (i == last && fixed[1]);
            self.residual.push(if is_fixed { 0.0 } else { residual });
            self.diagonal.push(diagonal);
            self.slopes.push(slope);
            (before, slope_before) = (after, slope);
        }
        let enough = BALANCED * largest + ROUND_OFF * round_off;
        self.unbalanced = self.residual.iter().any(|residual| residual.abs() > enough);
    }

    /// Tension of a link where the bar is, and how it grows with the elongation.
    fn tension(&self, k: usize, memory: &LinkMemory) -> (f64, f64) {
        let link = &self.links[k];
        let trial = link.trial(memory, self.bar[k + 1] - self.bar[k]);
        if !Link::is_live(memory) {
            return (trial, 0.0);
        }
        let force = trial.clamp(-link.yields, link.yields);
        (force, if force == trial { link.stiffness } else { 0.0 })
    }

    fn elongation(&self, link: usize) -> f64 {
        self.bar[link + 1] - self.bar[link]
    }

    /// Bar ahead of the ground at a point of a node \[m\].
    fn ahead(&self, node: usize, point: usize, memory: &PointMemory) -> f64 {
        self.bar[node] - (self.ground[point] - memory.reference)
    }

    /// Breaks what is stretched too far, which leaves its load to the others; says whether anything was.
    fn break_links(&mut self, memory: &mut BoltMemory) -> bool {
        let mut any = false;
        for k in 0..self.links.len() {
            let mut link = memory.link(k);
            if self.links[k].is_broken_by(&link, self.elongation(k)) {
                // Booked with the force that it had.
                link.status = BROKEN;
                memory.set_link(k, &link);
                memory.set_factored(0.0);
                any = true;
            }
        }
        any
    }

    /// Remembers where everything has come to, and leaves the forces on the ground.
    fn settle(&mut self, memory: &mut BoltMemory, fixed: [bool; 2], passes: u32) {
        let last = self.links.len();
        let mut whole = memory.whole();
        whole.passes = whole.passes.max(f64::from(passes));
        let mut before = 0.0;
        for i in 0..=last {
            let after = match i < last {
                true => {
                    let mut link = memory.link(i);
                    let force = self.links[i].update(&mut link, self.elongation(i));
                    memory.set_link(i, &link);
                    force
                }
                false => 0.0,
            };
            let points = self.nodes[i];
            let plated = (i == 0 && fixed[0]) || (i == last && fixed[1]);
            let law = |p: usize| {
                let point = memory.point(p);
                let trial = point.stiffness * (self.ahead(i, p, &point) - point.slip);
                trial.clamp(-point.strength, point.strength)
            };
            let bonds = points.map(|p| p.map_or(0.0, law));
            // What the bar gives to the ground here, and what of it no slider's law answers for.
            let given = after - before;
            let rest = given - (bonds[0] + bonds[1]);
            if plated {
                self.forces[points[0].unwrap_or(0)] = given;
            } else {
                let bonded = points.map(|p| p.is_some_and(|p| memory.point(p).stiffness > 0.0));
                whole.rest = larger(whole.rest, rest);
                // Round-off stays with nobody.
                let rest = if self.unbalanced { rest } else { 0.0 };
                let sharing = bonded.iter().filter(|b| **b).count().max(1) as f64;
                for (k, p) in points.into_iter().enumerate().filter_map(|(k, p)| Some((k, p?))) {
                    if bonded[k] {
                        let force = bonds[k] + rest / sharing;
                        let mut point = memory.point(p);
                        self.slide(i, p, force, &mut point);
                        memory.set_point(p, &point);
                        self.forces[p] = force;
                    }
                }
            }
            before = after;
        }
        memory.set_whole(whole);
        memory.bar.copy_from_slice(&self.bar);
    }

    /// Moves the slider of a point to where it has this force.
    fn slide(&self, node: usize, p: usize, force: f64, point: &mut PointMemory) {
        let ahead = self.ahead(node, p, point);
        point.largest = larger(point.largest, ahead);
        if force == point.stiffness * (ahead - point.slip) {
            point.force = force;
            return;
        }
        let slip = ahead - force / point.stiffness;
        point.dissipated += 0.5 * (force + point.force) * (slip - point.slip);
        if force.abs() >= NEARLY * point.strength && slip != point.slip {
            point.slid = 1.0;
        }
        (point.slip, point.force) = (slip, force);
    }

    /// Writes the forces with which the bolt resists over the displacements of its points.
    pub fn push(&self, points: &mut [Row]) {
        for (row, force) in points[self.first..].iter_mut().zip(&self.forces) {
            *row = Row::new(self.along.map(|t| -force * t));
        }
    }
}
