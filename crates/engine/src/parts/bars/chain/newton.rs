//! Newton's method for the place of a chain, along each step as far as the energy falls.

use super::super::memory::BoltMemory;
use super::Chain;

/// A pivot below this share of what could hold a node holds it no more.
const LOOSE: f64 = 1e-12;
/// The slope of the energy along a step, over that at its start, that is none.
const FLAT: f64 = 1e-9;
/// How often the end of a step is bisected at most.
const BISECTIONS: u32 = 40;

impl Chain {
    /// Newton's step, as far along it as the energy falls.
    pub(super) fn improve(&mut self, memory: &BoltMemory, fixed: [bool; 2]) {
        self.newton(memory, fixed);
        self.from.clone_from(&self.bar);
        let start = self.downhill();
        let flat = FLAT * start.abs();
        self.go(1.0, memory, fixed);
        if self.downhill() >= -flat {
            return;
        }
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            self.go(middle, memory, fixed);
            let slope = self.downhill();
            if slope.abs() <= flat {
                return;
            }
            if slope > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
    }

    /// By how much the energy falls along the step where the bar is \[J\].
    fn downhill(&self) -> f64 {
        self.residual.iter().zip(&self.step).map(|(r, s)| r * s).sum()
    }

    /// To a share of the step.
    fn go(&mut self, share: f64, memory: &BoltMemory, fixed: [bool; 2]) {
        for ((bar, from), step) in self.bar.iter_mut().zip(&self.from).zip(&self.step) {
            *bar = from + share * step;
        }
        self.evaluate(memory, fixed);
    }

    /// The step that would bring balance if forces changed as they do now. What nothing holds is held by what its bond is when it
    /// does not slide.
    fn newton(&mut self, memory: &BoltMemory, fixed: [bool; 2]) {
        let last = self.links.len();
        self.upper.clear();
        self.step.clear();
        for i in 0..=last {
            if (i == 0 && fixed[0]) || (i == last && fixed[1]) {
                self.upper.push(0.0);
                self.step.push(0.0);
                continue;
            }
            let before = if i > 0 { self.slopes[i - 1] } else { 0.0 };
            let (mut diagonal, mut load) = (self.diagonal[i], self.residual[i]);
            if let (Some(up), Some(step)) = (self.upper.last(), self.step.last()) {
                diagonal += before * up;
                load += before * step;
            }
            let bonds = self.nodes[i].into_iter().flatten().map(|p| memory.point(p).stiffness);
            let firm = before + self.slopes[i] + bonds.sum::<f64>();
            if diagonal <= LOOSE * firm {
                diagonal += firm;
            }
            if diagonal == 0.0 {
                // Nothing is there, not even a bond.
                (diagonal, load) = (1.0, 0.0);
            }
            let inverse = 1.0 / diagonal;
            self.upper.push(-self.slopes[i] * inverse);
            self.step.push(load * inverse);
        }
        let mut next = 0.0;
        for i in (0..=last).rev() {
            next = self.step[i] - self.upper[i] * next;
            self.step[i] = next;
        }
    }
}
