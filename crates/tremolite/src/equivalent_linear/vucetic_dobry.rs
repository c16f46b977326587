//! The curves of `vucetic1991`, by plasticity index alone.
//!
//! Read off the published figures, as they are handed on in pyStrata (MIT licence; its file `published_curves.toml`): a few hundredths of G/G_max
//! and a few parts in a thousand of damping are within the width of a line.

use super::table::CurveTable;

const STRAINS: [f64; 9] = [1e-6, 3.16e-6, 1e-5, 3.16e-5, 1e-4, 3.16e-4, 1e-3, 3.16e-3, 1e-2];

/// Plasticity index \[%\], G/G_max and damping ratio at the strains.
const CURVES: [(f64, [f64; 9], [f64; 9]); 6] = [
    (
        0.0,
        [1.0, 1.0, 0.96, 0.88, 0.7, 0.47, 0.26, 0.11, 0.03],
        [0.01, 0.01, 0.01, 0.03, 0.054, 0.098, 0.15, 0.203, 0.24],
    ),
    (
        15.0,
        [1.0, 1.0, 0.99, 0.94, 0.81, 0.64, 0.41, 0.22, 0.1],
        [0.01, 0.01, 0.01, 0.026, 0.045, 0.075, 0.116, 0.16, 0.2],
    ),
    (
        30.0,
        [1.0, 1.0, 1.0, 0.98, 0.9, 0.75, 0.53, 0.35, 0.17],
        [0.01, 0.01, 0.01, 0.021, 0.038, 0.059, 0.088, 0.125, 0.169],
    ),
    (
        50.0,
        [1.0, 1.0, 1.0, 1.0, 0.95, 0.84, 0.67, 0.47, 0.25],
        [0.01, 0.01, 0.01, 0.018, 0.029, 0.043, 0.062, 0.095, 0.135],
    ),
    (
        100.0,
        [1.0, 1.0, 1.0, 1.0, 0.98, 0.92, 0.81, 0.63, 0.37],
        [0.01, 0.01, 0.01, 0.015, 0.02, 0.029, 0.041, 0.065, 0.098],
    ),
    (
        200.0,
        [1.0, 1.0, 1.0, 1.0, 1.0, 0.96, 0.89, 0.75, 0.53],
        [0.01, 0.01, 0.01, 0.013, 0.016, 0.021, 0.03, 0.048, 0.081],
    ),
];

/// The curves at a plasticity index \[%\] from 0 to 200, linear between those that are published; nothing beyond.
pub fn table(plasticity_index: f64) -> Option<CurveTable> {
    if !(0.0..=200.0).contains(&plasticity_index) {
        return None;
    }
    let above = CURVES.iter().position(|(index, ..)| *index >= plasticity_index)?;
    let (high, low) = (&CURVES[above], &CURVES[above.saturating_sub(1)]);
    let share = if high.0 > low.0 { (plasticity_index - low.0) / (high.0 - low.0) } else { 1.0 };
    let between = |a: f64, b: f64| a + share * (b - a);
    let points = STRAINS
        .iter()
        .enumerate()
        .map(|(k, strain)| [*strain, between(low.1[k], high.1[k]), between(low.2[k], high.2[k])]);
    CurveTable::new(points.collect()).ok()
}
