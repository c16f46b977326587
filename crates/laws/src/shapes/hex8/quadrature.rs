//! Where an element's law is evaluated.

use super::geometry::{determinant_at, gauss_point};
use super::{CORNERS, Hex8};
use std::sync::LazyLock;

/// Points through a thickness, equally spaced with both faces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Layers {
    Seven,
    #[default]
    Nine,
    Thirteen,
}

impl Layers {
    pub const ALL: [Layers; 3] = [Layers::Seven, Layers::Nine, Layers::Thirteen];

    /// How many.
    pub const fn count(self) -> usize {
        match self {
            Layers::Seven => 7,
            Layers::Nine => 9,
            Layers::Thirteen => 13,
        }
    }
}

/// Points of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Quadrature {
    /// One point and elastic stabilisation: fast, for rock.
    OnePoint,
    /// 2×2×2 points: for linings of several elements through their thickness.
    Full,
    /// 2×2 points in the plane of a lining, and several through its thickness: for linings one element thick.
    Layered(Layers),
}

impl Quadrature {
    /// Integration points in an element.
    pub const fn points(self) -> usize {
        match self {
            Quadrature::OnePoint => 1,
            Quadrature::Full => 8,
            Quadrature::Layered(layers) => 4 * layers.count(),
        }
    }

    /// Shares of the points in a mean over an element, as if det J were the same everywhere.
    pub fn shares(self) -> &'static [f64] {
        const EIGHT: [f64; 8] = [0.125; 8];
        static LAYERED: LazyLock<[Vec<f64>; 3]> = LazyLock::new(|| {
            Layers::ALL.map(|layers| {
                let through = Through::of(layers);
                (0..4 * through.count).map(|p| 0.125 * through.weight[p / 4]).collect()
            })
        });
        match self {
            Quadrature::OnePoint => &[1.0],
            Quadrature::Full => &EIGHT,
            Quadrature::Layered(layers) => &LAYERED[layers as usize],
        }
    }
}

/// Most points of an element.
pub const MOST_POINTS: usize = 4 * MOST_LAYERS;

pub(super) const MOST_LAYERS: usize = Layers::Thirteen.count();

/// Places ζ and weights of the points through a thickness, which goes from −1 to 1.
///
/// Equally spaced points with both ends; all weights are the spacing but for the outer two at each end, which make the integrals
/// of 1 and ζ² exact. So a cubic is integrated exactly, and a moment that cracks have gone into errs less than with as many
/// Gauss–Lobatto points, whose places come nowhere near the front of a crack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Through {
    pub zeta: [f64; MOST_LAYERS],
    pub weight: [f64; MOST_LAYERS],
    pub count: usize,
    /// Σ w ζ² and Σ w ζ⁴; Σ w is 2.
    pub square: f64,
    pub fourth: f64,
}

impl Through {
    /// Those of this many layers.
    pub fn of(layers: Layers) -> &'static Through {
        static ALL: LazyLock<[Through; 3]> = LazyLock::new(|| Layers::ALL.map(Through::new));
        &ALL[layers as usize]
    }

    fn new(layers: Layers) -> Self {
        let count = layers.count();
        let spacing = 2.0 / (count - 1) as f64;
        let mut zeta = [0.0; MOST_LAYERS];
        let mut weight = [0.0; MOST_LAYERS];
        // Counted from the middle, so that both halves have the same bits.
        for k in 0..count {
            zeta[k] = (2.0 * k as f64 - (count - 1) as f64) / (count - 1) as f64;
            weight[k] = spacing;
        }
        let inner = &zeta[2..count - 2];
        let half = 0.5 * (2.0 - spacing * inner.len() as f64);
        let square = 0.5 * (2.0 / 3.0 - spacing * inner.iter().map(|z| z * z).sum::<f64>());
        let second = (half - square) / (1.0 - zeta[1] * zeta[1]);
        for (end, next) in [(0, 1), (count - 1, count - 2)] {
            (weight[end], weight[next]) = (half - second, second);
        }
        let sum = |power: i32| (0..count).map(|k| weight[k] * zeta[k].powi(power)).sum();
        Through { zeta, weight, count, square: sum(2), fourth: sum(4) }
    }
}

/// The points of an element by their places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Points {
    pub quadrature: Quadrature,
    /// Natural axis through the thickness, 0 for ξ, of layered elements; meaningless for others.
    pub axis: usize,
}

impl Points {
    /// How many.
    pub fn count(&self) -> usize {
        self.quadrature.points()
    }

    /// Natural coordinates of a point, in the order of histories and stresses: of 2×2×2 points bit 0 of the number is ξ; of
    /// layered ones four of a layer follow each other, bit 0 along the axis that comes after that of the thickness.
    pub fn natural(&self, p: usize) -> [f64; 3] {
        match self.quadrature {
            Quadrature::OnePoint => [0.0; 3],
            Quadrature::Full => gauss_point(p),
            Quadrature::Layered(layers) => {
                let [first, second, _] = gauss_point(p % 4);
                let mut natural = [0.0; 3];
                natural[(self.axis + 1) % 3] = first;
                natural[(self.axis + 2) % 3] = second;
                natural[self.axis] = Through::of(layers).zeta[p / 4];
                natural
            }
        }
    }

    /// Volumes of the points of an element \[m³\].
    pub fn weights(&self, hex: &Hex8) -> Vec<f64> {
        match self.quadrature {
            Quadrature::OnePoint => vec![hex.volume],
            Quadrature::Full => hex.weights.to_vec(),
            Quadrature::Layered(layers) => {
                let weight = &Through::of(layers).weight;
                let at = |p: usize| weight[p / 4] * determinant_at(&hex.corners, self.natural(p));
                (0..self.count()).map(at).collect()
            }
        }
    }
}

/// The corners of an element, as numbers in VTK order, numbered so that ζ is the natural axis `axis`: the axes change places in
/// turn, and a corner has as signs those along the axes that follow.
pub fn turned(axis: usize) -> [usize; 8] {
    CORNERS.map(|c| {
        let mut old = [0.0; 3];
        for (k, sign) in c.into_iter().enumerate() {
            old[(axis + 1 + k) % 3] = sign;
        }
        CORNERS.iter().position(|corner| *corner == old).unwrap_or(0)
    })
}
