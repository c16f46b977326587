//! Where the layers of lining and shotcrete lie.

use super::rows::Counts;
use super::section::Part;
use super::tube::Across;

/// The place of a node so many layers out from the intrados.
pub(super) fn place(counts: &Counts, layer: usize, [inner, lined, outer]: Across) -> [f64; 2] {
    let lining = counts.layers - counts.shotcrete;
    let (from, to, i, n) = if layer <= lining {
        (inner, lined, layer, lining)
    } else {
        (lined, outer, layer - lining, counts.shotcrete)
    };
    let s = if n == 0 { 0.0 } else { i as f64 / n as f64 };
    [0, 1].map(|c| from[c] + s * (to[c] - from[c]))
}

/// What a layer, counted from the intrados, is where a lining would be `lining`.
pub(super) fn part(counts: &Counts, layer: usize, lining: Part) -> Part {
    match (lining.lining(), lining.bench()) {
        (Some(k), Some(bench)) if layer + counts.shotcrete >= counts.layers => Part::Shotcrete(k, bench),
        _ => lining,
    }
}
