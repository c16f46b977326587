//! A chain of which nothing slides or yields: what most bolts are in most steps.
//!
//! Its tridiagonal matrix stays as it is from stage to stage, so it is eliminated once, and what is left of it remembered: an
//! evaluation is a way there and a way back, without a division. Where a bound is passed on the way, nothing is remembered and the
//! chain is asked as a whole.

use super::super::Bar;
use super::super::link::Link;
use super::super::memory::{BoltMemory, FACTORED, LinkMemory, NOT_LINEAR, PointMemory};
use super::{held, larger};
use tremolite_laws::Row;

/// Room for one bolt.
#[derive(Default)]
pub struct Elastic {
    /// Of each point, where the bar would be without force from its bond \[m\].
    none: Vec<f64>,
    bonds: Vec<f64>,
    tensions: Vec<f64>,
    /// Of each node.
    bar: Vec<f64>,
}

/// Points of a node by their places in the bolt; the second where an interface crosses.
fn at_node(bars: &[Bar], first: usize, node: usize) -> [Option<usize>; 2] {
    let ends = node.checked_sub(1).map(|k| bars[k].points[1] as usize - first);
    let begins = bars.get(node).map(|bar| bar.points[0] as usize - first);
    match (ends, begins) {
        (Some(a), Some(b)) if a == b => [Some(a), None],
        (Some(a), b) => [Some(a), b],
        (None, b) => [b, None],
    }
}

/// Stiffness \[N/m\] of a link as it stands, and its tension \[N\] without elongation.
fn linear(bar: &Bar, link: &LinkMemory) -> (f64, f64) {
    if Link::is_live(link) {
        (bar.stiffness, -bar.stiffness * (link.reference + link.plastic))
    } else {
        (0.0, link.kept)
    }
}

/// Eliminates the matrix of a bolt as it stands.
pub fn factor(bars: &[Bar], first: usize, plates: [bool; 2], memory: &mut BoltMemory) {
    let fixed = held(bars.len(), plates, memory);
    let (mut before, mut upper) = (0.0, 0.0);
    for i in 0..=bars.len() {
        let after = bars.get(i).map_or(0.0, |bar| linear(bar, &memory.link(i)).0);
        if (i == 0 && fixed[0]) || (i == bars.len() && fixed[1]) {
            memory.factors[i] = [0.0, 0.0];
        } else {
            let bonds = at_node(bars, first, i).into_iter().flatten().map(|p| memory.point(p).stiffness);
            let diagonal = before + after + bonds.sum::<f64>() + before * upper;
            if diagonal <= f64::EPSILON * (before + after) {
                memory.set_factored(NOT_LINEAR);
                return;
            }
            memory.factors[i] = [-after / diagonal, 1.0 / diagonal];
        }
        (before, upper) = (after, memory.factors[i][0]);
    }
    memory.set_factored(FACTORED);
}

impl Elastic {
    /// Lets the bar find its place and writes the forces with which it resists over the displacements of its points; false, with
    /// nothing changed, if anything would slide, yield or break.
    pub fn respond(
        &mut self,
        bars: &[Bar],
        of: std::ops::Range<usize>,
        plates: [bool; 2],
        breaks: f64,
        memory: &mut BoltMemory,
        points: &mut [Row],
    ) -> bool {
        let (first, last, along) = (of.start, bars.len(), bars[0].along);
        let fixed = held(bars.len(), plates, memory);
        self.none.clear();
        self.none.extend(points[of.clone()].iter().zip(&*memory.points).map(|(row, point)| {
            let point = PointMemory::read(point);
            let ground = along[0] * row.0[0] + along[1] * row.0[1] + along[2] * row.0[2];
            ground - point.reference + point.slip
        }));
        self.bar.clear();
        let (mut before, mut tension, mut last_y) = (0.0, 0.0, 0.0);
        for i in 0..=last {
            let (after, next) = if i < last { linear(&bars[i], &memory.link(i)) } else { (0.0, 0.0) };
            let nodes = at_node(bars, first, i);
            let [_, inverse] = memory.factors[i];
            let y = if (i == 0 && fixed[0]) || (i == last && fixed[1]) {
                // A plate's own bond never slips.
                nodes[0].map_or(0.0, |p| self.none[p] - memory.point(p).slip)
            } else {
                let bonds = nodes.into_iter().flatten().map(|p| memory.point(p).stiffness * self.none[p]);
                (next - tension + bonds.sum::<f64>() + before * last_y) * inverse
            };
            self.bar.push(y);
            (before, tension, last_y) = (after, next, y);
        }
        for i in (0..last).rev() {
            self.bar[i] -= memory.factors[i][0] * self.bar[i + 1];
        }
        self.within(bars, first, breaks, memory) && {
            self.commit(bars, of, fixed, memory, points);
            true
        }
    }

    /// Finds all forces; says whether all are within their bounds.
    fn within(&mut self, bars: &[Bar], first: usize, breaks: f64, memory: &BoltMemory) -> bool {
        self.tensions.clear();
        self.bonds.clear();
        self.bonds.resize(self.none.len(), 0.0);
        for i in 0..=bars.len() {
            for p in at_node(bars, first, i).into_iter().flatten() {
                let point = memory.point(p);
                let force = point.stiffness * (self.bar[i] - self.none[p]);
                if force.abs() > point.strength {
                    return false;
                }
                self.bonds[p] = force;
            }
            let Some(bar) = bars.get(i) else { break };
            let (link, elongation) = (memory.link(i), self.bar[i + 1] - self.bar[i]);
            let (stiffness, none) = linear(bar, &link);
            let force = stiffness * elongation + none;
            let live = stiffness > 0.0;
            if live && (force.abs() > bar.yields || elongation - link.reference > breaks * bar.length) {
                return false;
            }
            self.tensions.push(force);
        }
        true
    }

    fn commit(
        &self,
        bars: &[Bar],
        of: std::ops::Range<usize>,
        fixed: [bool; 2],
        memory: &mut BoltMemory,
        points: &mut [Row],
    ) {
        let (last, along) = (bars.len(), bars[0].along);
        let mut before = 0.0;
        for i in 0..=last {
            let tension = self.tensions.get(i).copied().unwrap_or(0.0);
            let plated = (i == 0 && fixed[0]) || (i == last && fixed[1]);
            for p in at_node(bars, of.start, i).into_iter().flatten() {
                let force = if plated { tension - before } else { self.bonds[p] };
                if !plated {
                    let mut point = memory.point(p);
                    point.largest = larger(point.largest, self.bar[i] - self.none[p] + point.slip);
                    point.force = force;
                    memory.set_point(p, &point);
                }
                points[of.start + p] = Row::new(along.map(|t| -force * t));
            }
            if i < last {
                let mut link = memory.link(i);
                (link.elongation, link.force) = (self.bar[i + 1] - self.bar[i], tension);
                if tension.abs() > link.largest.abs() || tension.is_nan() {
                    link.largest = tension;
                }
                memory.set_link(i, &link);
            }
            before = tension;
        }
        memory.bar.copy_from_slice(&self.bar);
    }
}
