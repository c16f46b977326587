//! Whether a face would come to lie on others.

use std::collections::HashMap;

/// How far two convex outlines may lie over one another, as a part of the smaller one's width: what double curvature
/// makes of neighbours.
const SLACK: f64 = 0.1;

/// Outlines in a plane, found by their squares.
pub struct Laid {
    side: f64,
    outlines: Vec<Vec<[f64; 2]>>,
    squares: HashMap<[i64; 2], Vec<usize>>,
}

impl Laid {
    /// Nothing yet; `side` should be about twice the size of an outline.
    pub fn new(side: f64) -> Self {
        Laid { side, outlines: Vec::new(), squares: HashMap::new() }
    }

    pub fn add(&mut self, outline: &[[f64; 2]]) {
        for square in self.squares_of(outline) {
            self.squares.entry(square).or_default().push(self.outlines.len());
        }
        self.outlines.push(outline.to_vec());
    }

    pub fn is_under(&self, outline: &[[f64; 2]]) -> bool {
        let mut near: Vec<usize> = self
            .squares_of(outline)
            .filter_map(|square| self.squares.get(&square))
            .flatten()
            .copied()
            .collect();
        near.sort_unstable();
        near.dedup();
        near.iter().any(|&k| overlap(outline, &self.outlines[k]))
    }

    fn squares_of(&self, outline: &[[f64; 2]]) -> impl Iterator<Item = [i64; 2]> + use<> {
        let ends = |i: usize| {
            let [low, high] = ends(outline, |p| p[i]);
            [low, high].map(|x| (x / self.side).floor() as i64)
        };
        let ([a, b], [c, d]) = (ends(0), ends(1));
        (a..=b).flat_map(move |i| (c..=d).map(move |j| [i, j]))
    }
}

fn ends(outline: &[[f64; 2]], along: impl Fn(&[f64; 2]) -> f64) -> [f64; 2] {
    let all = outline.iter().map(along);
    all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
}

/// By separating lines along the edges of both.
fn overlap(one: &[[f64; 2]], other: &[[f64; 2]]) -> bool {
    let lines = |outline: &[[f64; 2]]| {
        let n = outline.len();
        let edge = |k: usize| {
            let (a, b) = (outline[k], outline[(k + 1) % n]);
            [b[1] - a[1], a[0] - b[0]]
        };
        (0..n).map(edge).collect::<Vec<_>>()
    };
    lines(one).into_iter().chain(lines(other)).all(|across| {
        let along = |p: &[f64; 2]| p[0] * across[0] + p[1] * across[1];
        let ([a, b], [c, d]) = (ends(one, along), ends(other, along));
        b.min(d) - a.max(c) > SLACK * (b - a).min(d - c)
    })
}
