//! A rectangular section of concrete with layers of steel, and its forces where it stays plane.

use crate::Concrete;

/// Steel at one depth, elastic and plastic alike in tension and compression.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// m² a metre.
    pub area: f64,
    /// From the mid-surface, positive towards the intrados \[m\].
    pub depth: f64,
    /// Pa
    pub young: f64,
    /// Stress at which it yields \[Pa\].
    pub yields: f64,
    /// Strain in tension beyond which it carries nothing; infinite where there is no such limit.
    pub breaks: f64,
}

/// A section, a metre wide.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// m
    pub thickness: f64,
    pub concrete: Concrete,
    /// Concrete is not taken out for the steel, as in the elements of a lining.
    pub layers: Vec<Layer>,
}

impl Section {
    /// N \[N/m\] and M \[N m/m\] at the strain `middle` + `curvature` · y, y from the mid-surface towards the intrados. Exact: stress is
    /// a polynomial of second degree between the depths where its law changes, and Simpson's rule is exact to the third.
    pub fn forces(&self, middle: f64, curvature: f64) -> [f64; 2] {
        let half = 0.5 * self.thickness;
        let mut cuts = vec![-half, half];
        if curvature != 0.0 {
            let at = |strain: f64| (strain - middle) / curvature;
            cuts.extend([at(0.0), at(-self.concrete.plateau)].into_iter().filter(|y| y.abs() < half));
        }
        cuts.sort_by(f64::total_cmp);
        let mut sums = [0.0; 2];
        for pair in cuts.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            for (y, weight) in [(from, 1.0), (0.5 * (from + to), 4.0), (to, 1.0)] {
                let force = weight / 6.0 * (to - from) * self.concrete.stress(middle + curvature * y);
                sums = [sums[0] + force, sums[1] + force * y];
            }
        }
        for layer in &self.layers {
            let strain = middle + curvature * layer.depth;
            let stress = (layer.young * strain).clamp(-layer.yields, layer.yields);
            // A limit is reached, not passed, by states of the diagram, whose strains have round-off.
            let force = if strain > layer.breaks * (1.0 + 1e-9) { 0.0 } else { layer.area * stress };
            sums = [sums[0] + force, sums[1] + force * layer.depth];
        }
        sums
    }
}
