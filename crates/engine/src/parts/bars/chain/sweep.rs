//! Balance of a chain in one sweep, whatever slides and yields.
//!
//! What lies on one side of a node needs a tension T(w) to hold it at w: a curve that only rises, in straight pieces. A bond adds its
//! own, bent where it begins to slide. A link shifts every point of the curve by its elongation q + N/k under that tension, and ends it at
//! yield. So the curve goes from node to node; at the far end it is solved, and the way back gives every node. Nothing is iterated,
//! so there is nothing that may not settle; it takes a time that grows with the square of the number of segments, and is asked
//! where Newton's method is slow.

use super::super::link::Link;
use super::super::memory::BoltMemory;
use super::curve::Curve;
use super::{Chain, NEARLY};

impl Chain {
    /// Puts the bar where it is in balance.
    pub(super) fn sweep(&mut self, memory: &BoltMemory, fixed: [bool; 2]) {
        let last = self.links.len();
        let [first, end] = [self.bar[0], self.bar[last]];
        // Of each node, from the link before it and with its own bonds.
        let mut curves: Vec<[Curve; 2]> = Vec::with_capacity(last + 1);
        for i in 0..=last {
            let from = match i.checked_sub(1) {
                None => Curve::constant(0.0),
                Some(k) => {
                    let (link, memory) = (&self.links[k], memory.link(k));
                    let none = memory.reference + memory.plastic;
                    if !Link::is_live(&memory) {
                        Curve::constant(link.trial(&memory, 0.0))
                    } else if k == 0 && fixed[0] {
                        Curve::held(first + none, link.stiffness, link.yields)
                    } else {
                        let mut curve = curves[k][1].clone();
                        curve.link(link.stiffness, none, link.yields);
                        curve
                    }
                }
            };
            let mut whole = from.clone();
            for p in self.nodes[i].into_iter().flatten() {
                let point = memory.point(p);
                whole.bond(self.ground[p] - point.reference + point.slip, point.stiffness, point.strength);
            }
            curves.push([from, whole]);
        }
        self.bar[last] = if fixed[1] { end } else { curves[last][1].inverse(0.0, end) };
        for i in (0..last).rev() {
            let (link, of) = (&self.links[i], memory.link(i));
            let force = curves[i + 1][0].at(self.bar[i + 1]);
            self.bar[i] = if i == 0 && fixed[0] {
                first
            } else if Link::is_live(&of) && force.abs() < NEARLY * link.yields {
                self.bar[i + 1] - of.reference - of.plastic - force / link.stiffness
            } else {
                curves[i][1].inverse(force, self.bar[i])
            };
        }
        self.evaluate(memory, fixed);
    }
}
