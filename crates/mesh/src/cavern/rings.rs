//! The rings of rock round a cavern.

use super::plot::Plot;
use super::section::{Part, Section};

/// The rings of rock between the outside of lining and shotcrete and the rectangle's rim.
pub(super) fn rings(section: &mut Section, plot: &Plot, outline: &[u32], rim: &[u32], free: &mut Vec<u32>) {
    let n = rim.len();
    let mut inner = outline.to_vec();
    for (layer, &s) in plot.rings.iter().enumerate().skip(1) {
        let outer: Vec<u32> = if layer + 1 == plot.rings.len() {
            rim.to_vec()
        } else {
            (0..n)
                .map(|t| {
                    let (a, b) = (section.points[outline[t] as usize], section.points[rim[t] as usize]);
                    let level = plot.held(t);
                    let z = level.unwrap_or_else(|| a[1] + s * (b[1] - a[1]));
                    let node = section.point([a[0] + s * (b[0] - a[0]), z]);
                    if level.is_none() {
                        free.push(node);
                    }
                    node
                })
                .collect()
        };
        for t in 0..n {
            let u = (t + 1) % n;
            section.quad([outer[t], inner[t], inner[u], outer[u]], Part::Rock);
        }
        inner = outer;
    }
}
