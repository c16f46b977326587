//! The section across the caverns: a conforming set of quadrilaterals with a part each.

use super::passage::Passage;
use crate::note::Note;

/// What a quadrilateral belongs to; the number is that of the cavern.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Part {
    Rock,
    /// Of a lining, with the bench that it is beside, as of the two below.
    Crown(u32, u32),
    Walls(u32, u32),
    Floor(u32, u32),
    /// Shotcrete, with the bench that it is beside.
    Shotcrete(u32, u32),
    /// Bench, counted from 1 at the top.
    Bench(u32, u32),
    /// Rock in a gallery; here the number is the gallery's.
    Gallery(u32),
    /// Lining that a gallery passes; here the number is the gallery's.
    Opening(u32),
}

impl Part {
    /// The cavern whose lining this is part of.
    pub fn lining(self) -> Option<u32> {
        match self {
            Part::Crown(k, _) | Part::Walls(k, _) | Part::Floor(k, _) => Some(k),
            Part::Rock | Part::Shotcrete(..) | Part::Bench(..) | Part::Gallery(_) | Part::Opening(_) => None,
        }
    }

    /// The cavern whose shotcrete this is.
    pub fn shotcrete(self) -> Option<u32> {
        match self {
            Part::Shotcrete(k, _) => Some(k),
            _ => None,
        }
    }

    /// The bench that this is, or that it is beside as a part of a lining or shotcrete.
    pub fn bench(self) -> Option<u32> {
        match self {
            Part::Crown(_, b)
            | Part::Walls(_, b)
            | Part::Floor(_, b)
            | Part::Shotcrete(_, b)
            | Part::Bench(_, b) => Some(b),
            Part::Rock | Part::Gallery(_) | Part::Opening(_) => None,
        }
    }

    /// The cavern that this is part of.
    pub fn cavern(self) -> Option<u32> {
        self.lining().or(self.shotcrete()).or(self.opening())
    }

    /// The gallery that this is part of.
    pub fn gallery(self) -> Option<u32> {
        match self {
            Part::Gallery(g) | Part::Opening(g) => Some(g),
            _ => None,
        }
    }

    /// The cavern whose opening this is part of.
    pub fn opening(self) -> Option<u32> {
        match self {
            Part::Bench(k, _) => Some(k),
            _ => None,
        }
    }
}

/// Quadrilaterals in the plane (x, z), counter-clockwise with x to the right and z up.
#[derive(Default)]
pub(super) struct Section {
    pub points: Vec<[f64; 2]>,
    pub quads: Vec<[u32; 4]>,
    pub parts: Vec<Part>,
    /// Coordinates of the planes across y.
    pub y: Vec<f64>,
    /// The caverns' rectangles: lowest and highest x and z.
    pub surroundings: Vec<[[f64; 2]; 2]>,
    /// The galleries.
    pub passages: Vec<Passage>,
    /// Lowest and highest x and z of the block.
    pub block: [[f64; 2]; 2],
    /// Where it departs from what was asked for.
    pub notes: Vec<Note>,
}

impl Section {
    /// Level above which there are no caverns' rectangles.
    pub fn cover(&self) -> f64 {
        self.surroundings.iter().map(|[_, z]| z[1]).fold(f64::NEG_INFINITY, f64::max)
    }

    pub fn point(&mut self, x: [f64; 2]) -> u32 {
        self.points.push(x);
        self.points.len() as u32 - 1
    }

    pub fn quad(&mut self, nodes: [u32; 4], part: Part) {
        self.quads.push(nodes);
        self.parts.push(part);
    }

    /// Smallest over the corners of the sine between the edges: the scaled Jacobian of the extruded element.
    pub fn scaled_jacobian(&self, quad: &[u32; 4]) -> f64 {
        let p = quad.map(|n| self.points[n as usize]);
        (0..4)
            .map(|i| {
                let edge = |j: usize| [p[j % 4][0] - p[i][0], p[j % 4][1] - p[i][1]];
                let (a, b) = (edge(i + 1), edge(i + 3));
                (a[0] * b[1] - a[1] * b[0]) / (a[0].hypot(a[1]) * b[0].hypot(b[1]))
            })
            .fold(f64::INFINITY, f64::min)
    }

    /// Smallest scaled Jacobian of the quadrilaterals from `first` on, and of those of linings and shotcrete among them.
    pub fn worst(&self, first: usize) -> [f64; 2] {
        let mut worst = [f64::INFINITY; 2];
        for (quad, part) in self.quads[first..].iter().zip(&self.parts[first..]) {
            let jacobian = self.scaled_jacobian(quad);
            // Without a shape: worse than any other.
            let jacobian = if jacobian.is_nan() { -1.0 } else { jacobian };
            worst[0] = worst[0].min(jacobian);
            if part.lining().or(part.shotcrete()).is_some() {
                worst[1] = worst[1].min(jacobian);
            }
        }
        worst
    }
}
