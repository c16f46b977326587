//! Points of faces that a wave reaches at one time, and what a node takes of them together.
//!
//! What pushes a node is a sum over the points of its faces of a matrix times the stress there. Under one wave that differs with the
//! height and the delay alone, so points with one delay, such as those one above another on a side, make one series of force:
//! a stack. Where a mesh has its nodes in rows the stacks of a row are alike but for their size.

use super::rows::Term;
use tremolite_engine::boundary::matrix::times;
use tremolite_engine::free_field::Place;

/// Delays closer than this part of a sample, and heights than this part of the ground's, are one.
const DELAYS: f64 = 16_777_216.0;
const HEIGHTS: f64 = 1e9;
/// Numbers of a matrix over its largest, likewise.
const ENTRIES: f64 = 1e9;

/// What places stacks are found with: of one wave.
pub struct Stacking {
    /// Stress xx, yy, zz, xy, yz, zx of one of each component that is kept.
    pub stress: [[f64; 6]; 4],
    /// Samples by which the wave is later, a metre along x and y.
    pub slowness: [f64; 2],
    /// Where it is not later \[m\]
    pub at: [f64; 2],
    /// m, and the height of the ground above.
    pub base: f64,
    pub height: f64,
}

/// Points with one delay.
#[derive(Clone, Debug)]
pub struct Stack {
    /// Samples.
    pub late: f64,
    /// The largest number of its matrices, with its sign, which the terms are over.
    pub size: f64,
    pub terms: Vec<Term>,
    /// The same of all that are alike but for their size and delay.
    pub key: Vec<i64>,
}

impl Stack {
    /// Its delay, the same of all that count as one.
    pub fn late_key(&self) -> i64 {
        rounded(self.late, DELAYS)
    }
}

fn rounded(x: f64, parts: f64) -> i64 {
    (x * parts).round() as i64
}

impl Stacking {
    /// Samples by which the wave is later at a place.
    pub fn late(&self, at: [f64; 3]) -> f64 {
        self.slowness[0] * (at[0] - self.at[0]) + self.slowness[1] * (at[1] - self.at[1])
    }

    /// The stacks of a place, by delay.
    pub fn of(&self, place: &Place) -> Vec<Stack> {
        let mut points: Vec<([i64; 2], f64, Term)> = Vec::with_capacity(place.shares.len());
        let mut point = |at: [f64; 3], force: &dyn Fn(&[f64; 6]) -> [f64; 3]| {
            let (late, height) = (self.late(at), at[2] - self.base);
            let of = self.stress.map(|stress| {
                let [x, y, z] = force(&stress);
                [x, y, z, 0.0]
            });
            points.push((
                [rounded(late, DELAYS), rounded(height / self.height, HEIGHTS)],
                late,
                Term { height, of },
            ));
        };
        place.shares.iter().for_each(|&(at, area)| point(at, &|stress| times(stress, area)));
        place.ends.iter().for_each(|end| point(end.at, &|stress| end.force(stress)));
        points.sort_by_key(|point| point.0);
        let mut stacks: Vec<Stack> = Vec::new();
        for of_one in points.chunk_by(|a, b| a.0[0] == b.0[0]) {
            let mut stack = Stack { late: of_one[0].1, size: 0.0, terms: Vec::new(), key: Vec::new() };
            for of_height in of_one.chunk_by(|a, b| a.0 == b.0) {
                let mut of = [[0.0; 4]; 4];
                for (_, _, term) in of_height {
                    of.iter_mut().flatten().zip(term.of.iter().flatten()).for_each(|(sum, x)| *sum += x);
                }
                stack.key.push(of_height[0].0[1]);
                stack.terms.push(Term { height: of_height[0].2.height, of });
            }
            stacks.extend(stack.over_its_size());
        }
        stacks
    }
}

impl Stack {
    /// With terms over its size; nothing where it pushes with nothing.
    fn over_its_size(mut self) -> Option<Stack> {
        let numbers = || self.terms.iter().flat_map(|term| term.of.iter().flatten().copied());
        let most = numbers().fold(0.0_f64, |most, x| most.max(x.abs()));
        // The first of those that are as large to round-off.
        self.size = numbers().find(|x| x.abs() > 0.0 && x.abs() >= (1.0 - 1e-6) * most)?;
        for term in &mut self.terms {
            term.of.iter_mut().flatten().for_each(|x| *x /= self.size);
            self.key.extend(term.of.iter().flatten().map(|&x| rounded(x, ENTRIES)));
        }
        Some(self)
    }

    /// Each of its points by itself.
    pub fn points(&self) -> Vec<Stack> {
        let heights = self.key.iter().zip(&self.terms);
        heights
            .filter_map(|(&height, term)| {
                let key = vec![height];
                let alone = Stack { late: self.late, size: 0.0, terms: vec![term.clone()], key };
                let alone = alone.over_its_size()?;
                Some(Stack { size: alone.size * self.size, ..alone })
            })
            .collect()
    }
}
