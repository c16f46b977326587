//! The initial stress, at a few places.

use tremolite_engine::hexahedra::centroid;
use tremolite_engine::{Model, Stage};

/// The initial stress in an element.
#[derive(Clone, Debug, PartialEq)]
pub struct StressAt {
    /// Where, in words.
    pub place: &'static str,
    /// The element's centre \[m\].
    pub at: [f64; 3],
    /// xx, yy, zz, xy, yz, zx \[Pa\], tension positive.
    pub stress: [f64; 6],
}

/// Of the places of [`stress_at_start`] the second: the middle of what is taken out first, or of the model.
pub const MIDDLE: usize = 1;

/// The initial stress at the top, in the middle of what is taken out first (of the model where nothing is) and at the base, one
/// below the other; nothing where there is none.
pub fn stress_at_start(model: &Model) -> Vec<StressAt> {
    if model.elements.initial.is_empty() {
        return Vec::new();
    }
    let (low, high) = model.faces.bounds;
    let standing = model.standing(Stage::Before(0));
    let first = standing.iter().filter_map(|&e| model.elements.lives[e as usize].gone).min();
    let out: Vec<u32> = match first {
        Some(stage) => standing
            .iter()
            .copied()
            .filter(|&e| model.elements.lives[e as usize].gone == Some(stage))
            .collect(),
        None => Vec::new(),
    };
    let middle = match out.len() {
        0 => [0, 1, 2].map(|i| 0.5 * (low[i] + high[i])),
        count => {
            let mut sum = [0.0; 3];
            for centre in out.iter().map(|&e| centroid(&model.mesh, e)) {
                (0..3).for_each(|i| sum[i] += centre[i] / count as f64);
            }
            sum
        }
    };
    let [x, y, _] = middle;
    let within = if out.is_empty() { "in the middle" } else { "in what is excavated first" };
    let nearest = |point: [f64; 3]| {
        let square = |e: &u32| -> f64 {
            let centre = centroid(&model.mesh, *e);
            (0..3).map(|i| (centre[i] - point[i]).powi(2)).sum()
        };
        standing.iter().copied().min_by(|a, b| square(a).total_cmp(&square(b)))
    };
    [("at the top", [x, y, high[2]]), (within, middle), ("at the base", [x, y, low[2]])]
        .into_iter()
        .filter_map(|(place, point)| {
            let e = nearest(point)?;
            Some(StressAt { place, at: centroid(&model.mesh, e), stress: model.elements.initial[e as usize] })
        })
        .collect()
}
