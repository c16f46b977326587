//! Curves by points.

/// Curves by points, linear in the logarithm of strain between them, and as at the first and last beyond.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveTable {
    /// Rising shear strains with G/G_max and damping ratio.
    points: Vec<[f64; 3]>,
}

impl CurveTable {
    /// A table of \[shear strain, G/G_max, damping ratio\].
    ///
    /// # Errors
    /// Words on what cannot be: strains that do not rise from above 0, a modulus that is not in (0, 1] or rises, a damping ratio that is not in [0, 0.5).
    pub fn new(points: Vec<[f64; 3]>) -> Result<Self, String> {
        for (k, &[strain, modulus, damping]) in points.iter().enumerate() {
            let row = k + 1;
            let before = if k > 0 { points[k - 1] } else { [0.0, 1.0, 0.0] };
            if !(strain.is_finite() && strain > before[0]) {
                return Err(format!("row {row}: strains rise from above 0, and {strain} does not"));
            }
            if !(modulus > 0.0 && modulus <= before[1]) {
                return Err(format!(
                    "row {row}: G/Gmax falls from 1 at most and stays above 0, and {modulus} does not"
                ));
            }
            if !(0.0..0.5).contains(&damping) {
                return Err(format!("row {row}: a damping ratio is from 0 to 0.5, and {damping} is not"));
            }
        }
        match points.is_empty() {
            true => Err("a table of curves has a row at least".into()),
            false => Ok(CurveTable { points }),
        }
    }

    /// Of points that were measured on a law: damping ratios up to 2/π, that of a body which does nothing but yield.
    pub(super) fn measured(points: Vec<[f64; 3]>) -> Self {
        CurveTable { points }
    }

    /// G/G_max and damping ratio at a shear strain.
    pub fn at(&self, strain: f64) -> [f64; 2] {
        let above = self.points.partition_point(|p| p[0] <= strain);
        let (Some(low), Some(high)) = (above.checked_sub(1), self.points.get(above)) else {
            let [_, modulus, damping] = self.points[above.saturating_sub(1)];
            return [modulus, damping];
        };
        let low = &self.points[low];
        let share = (strain / low[0]).ln() / (high[0] / low[0]).ln();
        [1, 2].map(|k| low[k] + share * (high[k] - low[k]))
    }
}
