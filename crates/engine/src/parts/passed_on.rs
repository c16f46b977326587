//! What elements outside a side pass on to the nodes of that side.
//!
//! T = ½ Σ (f_back − f_front) over the elements, f their resisting forces at the pairs of nodes that stand one behind the other:
//! what ground outside would push with in a field that does not vary along the normal. What both feel alike belongs to the
//! elements' own inertia and stays with them. It needs neither stresses nor areas, so it is exact for every law, quadrature and
//! damping. The coupling is one-way: the elements do not feel the side's nodes.

use super::{ElementEnergy, Entry, Kept, Motion, Own, Part, ProbeOut, Scratch, StateSizes, Tick};
use tremolite_kernels::{Line, Lines};
use tremolite_laws::{Column, Row};

/// A patch of elements outside a side with the nodes of the side.
pub struct PassedOn {
    elements: Box<dyn Part>,
    /// The elements' nodes, then those of the side.
    nodes: Vec<u32>,
    /// Places of front and back among the elements' nodes, for each node of the side.
    pairs: Vec<[u16; 2]>,
    /// Whether the side is the model's, so that work on it is in the balance; not so of a slab's end.
    booked: bool,
}

/// Numbers remembered a node of the side: the last force, and that at the hand-over.
const REMEMBERED: usize = 6;

impl PassedOn {
    /// From a patch, and for each node of the side its engine node with the places of front and back among the patch's nodes. Work
    /// on the side is booked if that is the model's own.
    pub fn new(elements: Box<dyn Part>, sides: Vec<(u32, [u16; 2])>, booked: bool) -> Self {
        let (sources, pairs): (Vec<u32>, Vec<[u16; 2]>) = sides.into_iter().unzip();
        let nodes = elements.nodes().iter().copied().chain(sources).collect();
        PassedOn { elements, nodes, pairs, booked }
    }

    /// Splits off what is the patch's own.
    fn own<'o>(&self, own: Own<'o>) -> (Own<'o>, &'o mut [f64]) {
        let at = self.elements.state_sizes().numbers;
        let Own { history, overstress, numbers, reference, initial } = own;
        let (numbers, rest) = numbers.split_at_mut(at);
        (Own { history, overstress, numbers, reference, initial }, rest)
    }

    fn kept<'k>(&self, kept: Kept<'k>) -> Kept<'k> {
        Kept { numbers: &kept.numbers[..self.elements.state_sizes().numbers], ..kept }
    }

    fn split<'r>(&self, out: &'r mut [Row]) -> (&'r mut [Row], &'r mut [Row]) {
        out.split_at_mut(self.elements.nodes().len())
    }

    /// ½(f_front − f_back) at each node of the side: what resists T.
    fn differences(&self, forces: &[Row], out: &mut [Row]) {
        for (out, pair) in out.iter_mut().zip(&self.pairs) {
            let [front, back] = pair.map(|place| forces[place as usize]);
            *out = Row([0, 1, 2, 3].map(|i| 0.5 * (front.0[i] - back.0[i])));
        }
    }

    /// T for the side, and its work since the last step counted from the hand-over. While time stands still sides rest on
    /// rollers, and nothing is passed on.
    fn pass_on(&self, tick: &Tick, x: &Motion, last: &mut [f64], forces: &[Row], out: &mut [Row]) -> f64 {
        if tick.dt == 0.0 {
            out.fill(Row::ZERO);
            return 0.0;
        }
        self.differences(forces, out);
        let mut work = 0.0;
        let sources = &self.nodes[self.elements.nodes().len()..];
        for ((&node, force), last) in sources.iter().zip(out).zip(last.chunks_exact_mut(REMEMBERED)) {
            let du = x.increment(node);
            for i in 0..3 {
                work += 0.5 * (force.0[i] + last[i] - 2.0 * last[3 + i]) * du.0[i];
                last[i] = force.0[i];
            }
        }
        if self.booked { work } else { 0.0 }
    }
}

impl Part for PassedOn {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    fn bytes(&self) -> usize {
        self.elements.bytes() + size_of_val(&self.nodes[..]) + size_of_val(&self.pairs[..])
    }

    fn state_sizes(&self) -> StateSizes {
        let own = self.elements.state_sizes();
        StateSizes { numbers: own.numbers + REMEMBERED * self.pairs.len(), ..own }
    }

    fn elements(&self) -> (usize, usize) {
        self.elements.elements()
    }

    fn columns(&self) -> &'static [Column] {
        self.elements.columns()
    }

    fn keeps_books(&self) -> bool {
        self.elements.keeps_books()
    }

    fn enter(&self, entry: &Entry, own: Own) {
        self.elements.enter(entry, self.own(own).0);
    }

    fn pressures(&self, kept: Kept, change: &mut [f64]) {
        self.elements.pressures(self.kept(kept), change);
    }

    fn begin(&self, x: &Motion, own: Own) {
        self.elements.begin(x, self.own(own).0);
    }

    fn settle(&self, own: Own) {
        let (own, last) = self.own(own);
        self.elements.settle(own);
        for last in last.chunks_exact_mut(REMEMBERED) {
            last.copy_within(..3, 3);
        }
    }

    fn forces(&self, tick: &Tick, x: &Motion, own: Own, out: &mut [Row], scratch: &mut Scratch) -> Lines {
        let (own, last) = self.own(own);
        let (forces, sides) = self.split(out);
        let mut lines = self.elements.forces(tick, x, own, forces, scratch);
        lines[Line::FreeField] += self.pass_on(tick, x, last, forces, sides);
        lines
    }

    fn probe(
        &self,
        tick: &Tick,
        x: &Motion,
        own: Own,
        out: &mut [Row],
        probe: ProbeOut,
        scratch: &mut Scratch,
    ) -> Lines {
        let (own, last) = self.own(own);
        let (forces, sides) = self.split(out);
        let mut lines = self.elements.probe(tick, x, own, forces, probe, scratch);
        lines[Line::FreeField] += self.pass_on(tick, x, last, forces, sides);
        lines
    }

    fn energy(&self, x: &Motion, kept: Kept) -> Lines {
        self.elements.energy(x, self.kept(kept))
    }

    /// Without the side, which the elements do not feel: the stable step is that of each by itself.
    fn stiffness_times(&self, w: &[Row], out: &mut [Row], scratch: &mut Scratch) {
        let (forces, sides) = self.split(out);
        self.elements.stiffness_times(w, forces, scratch);
        sides.fill(Row::ZERO);
    }

    fn stress_forces(&self, stress: &[[f64; 6]], out: &mut [Row], scratch: &mut Scratch) {
        let (forces, sides) = self.split(out);
        self.elements.stress_forces(stress, forces, scratch);
        sides.fill(Row::ZERO);
    }

    fn stiffness_energy(&self, w: &[Row], energy: &mut [ElementEnergy], scratch: &mut Scratch) {
        self.elements.stiffness_energy(w, energy, scratch);
    }

    /// With the side: what ground outside would push with holds its damping too.
    fn damping_times(&self, u: &[Row], kept: Kept, w: &[Row], out: &mut [Row], scratch: &mut Scratch) {
        let (forces, sides) = self.split(out);
        self.elements.damping_times(u, self.kept(kept), w, forces, scratch);
        self.differences(forces, sides);
    }

    fn viscosity_times(&self, w: &[Row], out: &mut [Row], scratch: &mut Scratch) -> bool {
        let (forces, sides) = self.split(out);
        sides.fill(Row::ZERO);
        self.elements.viscosity_times(w, forces, scratch)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parts::constant::Constant;

    /// The elements, the numbers of five nodes and two places for each of the two of the side.
    #[test]
    fn bytes_are_those_of_elements_nodes_and_places() {
        let elements = || Box::new(Constant::new([3, 5, 8].map(|node| (node, [1.0; 3]))));
        let own = elements().bytes();
        let part = PassedOn::new(elements(), vec![(1, [0, 1]), (2, [1, 2])], true);
        assert_eq!(part.nodes(), [3, 5, 8, 1, 2]);
        assert_eq!(part.bytes(), own + 5 * size_of::<u32>() + 2 * 2 * size_of::<u16>());
    }
}
