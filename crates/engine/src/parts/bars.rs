//! Bolts, anchors and reinforcing bars as a part.
//!
//! A bar carries along its axis alone. Its points see the motion of what they lie in by the shape functions there, and give their
//! force to the same nodes with the same weights: so forces do the work that the bar takes up, and any uniform strain is seen
//! exactly, whatever strain the elements assume. Without a bond a segment strains as its two points part. With one the bar has a
//! displacement of its own along its axis.
//!
//! What is remembered lies bolt by bolt among the numbers of the part ([`memory`]).

mod chain;
mod link;
pub mod memory;

use super::{Entry, Kept, Motion, Own, Part, Reads, Scratch, StateSizes, Tick};
use crate::bolts::Bolts;
use crate::life::Stage;
use chain::Chain;
use chain::elastic::{self, Elastic};
use link::Link;
use memory::{BoltMemory, CUT_OFF, FACTORED, Layout};
use std::sync::Arc;
use tremolite_kernels::{Line, Lines};
use tremolite_laws::{Isa, Row};

/// A segment among the points of its part.
#[derive(Clone, Debug)]
pub struct Bar {
    pub points: [u32; 2],
    pub along: [f64; 3],
    /// m
    pub length: f64,
    /// EA/L \[N/m\], and the force at which it yields \[N\].
    pub stiffness: f64,
    pub yields: f64,
    pub free: bool,
    pub gone: Option<Stage>,
}

/// A bolt among the points and segments of its part.
#[derive(Clone, Debug)]
pub struct Bolt {
    /// First of its points and of its segments; those of the next begin where these end.
    pub points: std::ops::Range<usize>,
    pub bars: std::ops::Range<usize>,
    /// First of its numbers.
    pub at: usize,
}

/// Bolts of one kind that a thread works on together.
pub struct Bars {
    pub kind: Arc<Bolts>,
    /// Engine nodes.
    pub nodes: Vec<u32>,
    /// Weights of point p: `start[p]..start[p + 1]`, each with the place of its node among `nodes`.
    pub start: Vec<u32>,
    pub place: Vec<u32>,
    pub weight: Vec<f64>,
    /// The elements that each point lies in, where it is on a face between them.
    pub hosts: Vec<[u32; 2]>,
    pub bars: Vec<Bar>,
    pub bolts: Vec<Bolt>,
    pub numbers: usize,
}

impl Bars {
    fn layout(&self, bolt: &Bolt) -> Layout {
        Layout::of(self.kind.bond.is_some(), bolt.bars.len(), bolt.points.len())
    }

    fn memory<'n>(&self, bolt: &Bolt, numbers: &'n mut [f64]) -> BoltMemory<'n> {
        let layout = self.layout(bolt);
        BoltMemory::of(&layout, &mut numbers[bolt.at..bolt.at + layout.numbers()])
    }

    /// Forces on the nodes at displacements of these. No operation is fused, so the bits are the same with and without AVX2.
    fn respond(&self, u: &[Row], points: &mut Vec<Row>, out: &mut [Row], numbers: &mut [f64]) {
        #[cfg(target_arch = "x86_64")]
        if Isa::Avx2.available() {
            #[target_feature(enable = "avx2")]
            unsafe fn wide(
                bars: &Bars,
                u: &[Row],
                points: &mut Vec<Row>,
                out: &mut [Row],
                numbers: &mut [f64],
            ) {
                bars.gather(u, points);
                bars.pull(points, numbers);
                bars.scatter(points, out);
            }
            // SAFETY: the processor has AVX2.
            unsafe { wide(self, u, points, out, numbers) };
            return;
        }
        self.gather(u, points);
        self.pull(points, numbers);
        self.scatter(points, out);
    }

    /// Displacement of every point.
    #[inline(always)]
    fn gather(&self, u: &[Row], points: &mut Vec<Row>) {
        points.clear();
        points.extend(self.start.windows(2).map(|range| {
            let mut sum = Row::ZERO;
            for k in range[0] as usize..range[1] as usize {
                let (row, weight) = (&u[self.nodes[self.place[k] as usize] as usize], self.weight[k]);
                for i in 0..4 {
                    sum.0[i] += weight * row.0[i];
                }
            }
            sum
        }));
    }

    /// Forces of points on the nodes.
    #[inline(always)]
    fn scatter(&self, points: &[Row], out: &mut [Row]) {
        out.fill(Row::ZERO);
        for (force, range) in points.iter().zip(self.start.windows(2)) {
            for k in range[0] as usize..range[1] as usize {
                let (row, weight) = (&mut out[self.place[k] as usize], self.weight[k]);
                for i in 0..4 {
                    row.0[i] += weight * force.0[i];
                }
            }
        }
    }

    /// How far the points of a segment have parted along it \[m\].
    #[inline(always)]
    fn elongation(&self, bar: &Bar, points: &[Row]) -> f64 {
        let [a, b] = bar.points.map(|p| &points[p as usize].0);
        (0..3).map(|i| bar.along[i] * (b[i] - a[i])).sum()
    }

    /// Every bolt's forces at the displacements of its points, left in their place.
    #[inline(always)]
    fn pull(&self, points: &mut [Row], numbers: &mut [f64]) {
        let mut chain = Chain::default();
        let (mut elastic, mut elongations) = (Elastic::default(), Vec::new());
        for bolt in &self.bolts {
            let mut memory = self.memory(bolt, numbers);
            let bars = &self.bars[bolt.bars.clone()];
            match &self.kind.bond {
                None => {
                    elongations.clear();
                    elongations.extend(bars.iter().map(|bar| self.elongation(bar, points)));
                    points[bolt.points.clone()].fill(Row::ZERO);
                    for (k, (bar, &elongation)) in bars.iter().zip(&elongations).enumerate() {
                        let mut link = memory.link(k);
                        let force = Link::of(bar, &self.kind).update(&mut link, elongation);
                        memory.set_link(k, &link);
                        pull(bar, force, points);
                    }
                }
                Some(_) => {
                    let plates = self.kind.plates;
                    if memory.whole().factored == 0.0 {
                        elastic::factor(bars, bolt.points.start, plates, &mut memory);
                    }
                    let of = bolt.points.clone();
                    let simple = memory.whole().factored == FACTORED
                        && elastic.respond(bars, of, plates, self.kind.breaks, &mut memory, points);
                    if !simple {
                        chain.set(bars, bolt.points.clone(), &self.kind, points);
                        chain.respond(&mut memory);
                        chain.push(points);
                    }
                }
            }
        }
    }

    /// The same as if nothing ever yielded, slid or was cut, for small motions about rest.
    fn respond_elastically(&self, points: &mut [Row]) {
        let mut chain = Chain::default();
        for bolt in &self.bolts {
            let bars = &self.bars[bolt.bars.clone()];
            match &self.kind.bond {
                None => {
                    let forces: Vec<f64> =
                        bars.iter().map(|bar| bar.stiffness * self.elongation(bar, points)).collect();
                    points[bolt.points.clone()].fill(Row::ZERO);
                    bars.iter().zip(forces).for_each(|(bar, force)| pull(bar, force, points));
                }
                Some(bond) => {
                    let layout = self.layout(bolt);
                    let mut numbers = vec![0.0; layout.numbers()];
                    let mut memory = BoltMemory::of(&layout, &mut numbers);
                    chain.set(bars, bolt.points.clone(), &self.kind, points);
                    chain.tributaries(&mut memory, |length| [bond.stiffness * length, f64::INFINITY]);
                    chain.respond_elastically(&mut memory);
                    chain.push(points);
                }
            }
        }
    }

    /// Force per length \[N/m\] at which the bond of a point slides: with the pressure on its host across the bar.
    fn strength(&self, point: usize, along: [f64; 3], entry: &Entry) -> f64 {
        let Some(bond) = &self.kind.bond else { return 0.0 };
        let mut confinement = 0.0;
        if bond.friction > 0.0 {
            // Of what stands there: an excavation may have taken one of them.
            let pressures =
                self.hosts[point].map(|host| Some(pressure_across(&(entry.stress)(host)?, along)));
            let standing = pressures.iter().flatten().count().max(1) as f64;
            confinement = pressures.iter().flatten().sum::<f64>() / standing;
        }
        bond.strength + bond.perimeter * bond.friction * confinement
    }

    /// What a bolt holds on to where a stage begins.
    fn enter_bolt(&self, bolt: &Bolt, entry: &Entry, points: &[Row], memory: &mut BoltMemory) {
        let kind = &*self.kind;
        let bars = &self.bars[bolt.bars.clone()];
        let first = entry.stage == kind.born;
        if first {
            memory.clear();
            let tensioned = |bar: &Bar| kind.pretension > 0.0 && (kind.free_length == 0.0 || bar.free);
            for (k, bar) in bars.iter().enumerate() {
                let mut link = memory.link(k);
                if kind.bond.is_none() {
                    link.reference = self.elongation(bar, points);
                    link.elongation = link.reference;
                }
                if tensioned(bar) {
                    (link.kept, link.force) = (kind.pretension, kind.pretension);
                }
                memory.set_link(k, &link);
            }
            if let (Some(bar), Some(_)) = (bars.first(), kind.bond) {
                for (k, row) in points[bolt.points.clone()].iter().enumerate() {
                    let mut point = memory.point(k);
                    point.reference = (0..3).map(|i| bar.along[i] * row.0[i]).sum();
                    memory.set_point(k, &point);
                }
            }
        }
        for (k, bar) in bars.iter().enumerate() {
            let mut link = memory.link(k);
            if !first && link.kept > 0.0 {
                link.reference = link.elongation - link.kept / bar.stiffness;
                link.kept = 0.0;
            }
            if bar.gone.is_some_and(|gone| gone <= entry.stage) {
                (link.force, link.kept, link.status) = (0.0, 0.0, CUT_OFF);
            }
            link.largest = 0.0;
            memory.set_link(k, &link);
        }
        if let (Some(bond), Some(along)) = (&kind.bond, bars.first().map(|bar| bar.along)) {
            let strengths: Vec<f64> = bolt.points.clone().map(|p| self.strength(p, along, entry)).collect();
            let mut chain = Chain::default();
            chain.set(bars, bolt.points.clone(), kind, points);
            let mut next = strengths.into_iter();
            chain
                .tributaries(memory, |length| [bond.stiffness * length, length * next.next().unwrap_or(0.0)]);
            memory.set_factored(0.0);
        }
    }
}

/// Mean pressure \[Pa\] across a direction, 0 in tension.
fn pressure_across(stress: &[f64; 6], t: [f64; 3]) -> f64 {
    let [xx, yy, zz, xy, yz, zx] = *stress;
    let along = xx * t[0] * t[0]
        + yy * t[1] * t[1]
        + zz * t[2] * t[2]
        + 2.0 * (xy * t[0] * t[1] + yz * t[1] * t[2] + zx * t[2] * t[0]);
    let pressure = -0.5 * (xx + yy + zz - along);
    // Not `max`, to which what is not a number would be none.
    if pressure < 0.0 { 0.0 } else { pressure }
}

/// Adds the forces with which a segment under tension resists to those of its points.
#[inline(always)]
fn pull(bar: &Bar, force: f64, points: &mut [Row]) {
    let [a, b] = bar.points;
    for i in 0..3 {
        let component = force * bar.along[i];
        points[a as usize].0[i] -= component;
        points[b as usize].0[i] += component;
    }
}

impl Part for Bars {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    fn bytes(&self) -> usize {
        let Bars { nodes, start, place, weight, hosts, bars, bolts, .. } = self;
        let weights = size_of_val(&start[..]) + size_of_val(&place[..]) + size_of_val(&weight[..]);
        let bolts = size_of_val(&hosts[..]) + size_of_val(&bars[..]) + size_of_val(&bolts[..]);
        size_of_val(&nodes[..]) + weights + bolts
    }

    /// The elements in which it lies, by whose stress friction goes.
    fn reads(&self) -> Reads {
        if self.kind.bond.is_none_or(|bond| bond.friction <= 0.0) {
            return Reads::default();
        }
        let mut elements: Vec<u32> = self.hosts.iter().flatten().copied().collect();
        elements.sort_unstable();
        elements.dedup();
        Reads { elements, ..Reads::default() }
    }

    fn state_sizes(&self) -> StateSizes {
        StateSizes { numbers: self.numbers, ..StateSizes::default() }
    }

    fn enter(&self, entry: &Entry, own: Own) {
        let mut points = Vec::new();
        self.gather(entry.u, &mut points);
        for bolt in &self.bolts {
            self.enter_bolt(bolt, entry, &points, &mut self.memory(bolt, own.numbers));
        }
    }

    fn forces(&self, _: &Tick, x: &Motion, own: Own, out: &mut [Row], scratch: &mut Scratch) -> Lines {
        self.respond(x.u, &mut scratch.rows, out, own.numbers);
        Lines::default()
    }

    fn energy(&self, _: &Motion, kept: Kept) -> Lines {
        let mut lines = Lines::default();
        for bolt in &self.bolts {
            let layout = self.layout(bolt);
            let (_, links, points) = layout.seen(&kept.numbers[bolt.at..bolt.at + layout.numbers()]);
            for (bar, link) in self.bars[bolt.bars.clone()].iter().zip(links) {
                lines[Line::Bolts] += 0.5 * link.force * link.force / bar.stiffness;
                lines[Line::BoltPlastic] += link.dissipated;
            }
            for point in points {
                if point.stiffness > 0.0 {
                    lines[Line::Bolts] += 0.5 * point.force * point.force / point.stiffness;
                }
                lines[Line::BoltFriction] += point.dissipated;
            }
        }
        lines
    }

    fn stiffness_times(&self, w: &[Row], out: &mut [Row], scratch: &mut Scratch) {
        self.gather(w, &mut scratch.rows);
        self.respond_elastically(&mut scratch.rows);
        self.scatter(&scratch.rows, out);
    }
}

#[cfg(test)]
mod tests {
    use super::pressure_across;

    /// Along t = (2, 3, 6)/7 a stress t⊗t leaves nothing across, one of three across is their mean, and tension is none.
    #[test]
    fn pressure_across_a_bar_leaves_out_what_is_along_it() {
        let t = [2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0];
        let along = [t[0] * t[0], t[1] * t[1], t[2] * t[2], t[0] * t[1], t[1] * t[2], t[2] * t[0]];
        // What is along, and what is the same all around.
        let stress = |a: f64, p: f64| [0, 1, 2, 3, 4, 5].map(|i| a * along[i] - if i < 3 { p } else { 0.0 });
        for a in [-5e6, 0.0, 3e6] {
            let found = pressure_across(&stress(a, 2e6), t);
            assert!((found - 2e6).abs() < 1e-6, "{a}: {found}");
            assert_eq!(pressure_across(&stress(a, -1e6), t), 0.0);
        }
        // Across, 4 MPa along (3, −2, 0)/√13 and nothing along the other.
        let n = [3.0 / 13.0_f64.sqrt(), -2.0 / 13.0_f64.sqrt(), 0.0];
        let found =
            pressure_across(&[-4e6 * n[0] * n[0], -4e6 * n[1] * n[1], 0.0, -4e6 * n[0] * n[1], 0.0, 0.0], t);
        assert!((found - 2e6).abs() < 1e-6, "{found}");
        assert!(pressure_across(&[f64::NAN; 6], t).is_nan());
    }
}
