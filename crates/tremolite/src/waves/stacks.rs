//! Points of faces of which a wave makes one course of force, and what a node takes of them together.
//!
//! What pushes a node is a sum over the points of its faces of a matrix times the stress there. Under one wave that differs with the
//! height and the delay alone, so all points of a node make one course of force; and where a mesh has its nodes in rows, those of a row
//! have the same course but for its size and delay. Where they are not, points with one delay, such as those one above another on a
//! side, make one that nodes beside share.

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

/// Points together.
#[derive(Clone, Debug)]
pub struct Stack {
    /// Samples by which the first of them is later.
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

    /// The points of a place, by delay and height.
    fn points(&self, place: &Place) -> Vec<Point> {
        let mut points: Vec<Point> = Vec::with_capacity(place.shares.len() + place.ends.len());
        let mut point = |at: [f64; 3], force: &dyn Fn(&[f64; 6]) -> [f64; 3]| {
            let (late, height) = (self.late(at), at[2] - self.base);
            let of = self.stress.map(|stress| {
                let [x, y, z] = force(&stress);
                [x, y, z, 0.0]
            });
            let key = [rounded(late, DELAYS), rounded(height / self.height, HEIGHTS)];
            points.push(Point { key, late, height, of });
        };
        place.shares.iter().for_each(|&(at, area)| point(at, &|stress| times(stress, area)));
        place.ends.iter().for_each(|end| point(end.at, &|stress| end.force(stress)));
        points.sort_by_key(|point| point.key);
        points
    }

    /// All of a place together; nothing where it is pushed with nothing.
    pub fn whole(&self, place: &Place) -> Option<Stack> {
        Stack::of(&self.points(place))
    }

    /// The points of a place that have one delay together, by delay.
    pub fn of(&self, place: &Place) -> Vec<Stack> {
        let points = self.points(place);
        points.chunk_by(|a, b| a.key[0] == b.key[0]).filter_map(Stack::of).collect()
    }
}

/// A point of a face, with what one of each component of stress pushes a node with there.
struct Point {
    /// Its delay and height, rounded.
    key: [i64; 2],
    late: f64,
    height: f64,
    of: [[f64; 4]; 4],
}

impl Stack {
    /// Of points in their order.
    fn of(points: &[Point]) -> Option<Stack> {
        let first = points.first()?;
        let mut stack = Stack { late: first.late, size: 0.0, terms: Vec::new(), key: Vec::new() };
        let mut behind = 0.0;
        for of_one in points.chunk_by(|a, b| a.key == b.key) {
            let Point { key: [_, height], late, .. } = of_one[0];
            // The same for all nodes of a row, as a difference of rounded delays were not; and one number for all that count as one.
            let apart = rounded(late - first.late, DELAYS);
            if stack.key.len() >= 2 && apart != stack.key[stack.key.len() - 2] {
                behind = (late - first.late).max(0.0);
            }
            let mut of = [[0.0; 4]; 4];
            for point in of_one {
                of.iter_mut().flatten().zip(point.of.iter().flatten()).for_each(|(sum, x)| *sum += x);
            }
            stack.key.extend([apart, height]);
            stack.terms.push(Term { behind, height: of_one[0].height, of });
        }
        stack.over_its_size()
    }

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
        let places = self.key.as_chunks::<2>().0.iter().zip(&self.terms);
        places
            .filter_map(|(&[_, height], term)| {
                let key = vec![0, height];
                let terms = vec![Term { behind: 0.0, ..term.clone() }];
                let alone = Stack { late: self.late + term.behind, size: 0.0, terms, key }.over_its_size()?;
                Some(Stack { size: alone.size * self.size, ..alone })
            })
            .collect()
    }
}
