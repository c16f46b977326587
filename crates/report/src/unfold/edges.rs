//! Edges of a developed surface: its outline, the cuts, and the creases.

use std::collections::BTreeMap;

use super::Corners;
use super::folds::Folds;

/// Fold \[rad\] from which on an edge is drawn.
const CREASE: f64 = 25.0 * std::f64::consts::PI / 180.0;

type Lines = Vec<[[f64; 2]; 2]>;

/// Edges with nothing beside them, and creases.
pub fn edges(folds: &Folds, own: &[usize], placed: &BTreeMap<usize, (usize, Corners)>) -> (Lines, Lines) {
    let (mut outline, mut creases) = (Vec::new(), Vec::new());
    for &f in own {
        let Some((_, corners)) = placed.get(&f) else { continue };
        for (k, beside) in folds.facets[f].beside.iter().enumerate() {
            let [a, b] = [corners[k], corners[(k + 1) % corners.len()]];
            let across = beside.and_then(|(g, j)| {
                let (_, theirs) = placed.get(&g)?;
                Some((g, [theirs[(j + 1) % theirs.len()], theirs[j]]))
            });
            let near = |p: [f64; 2], q: [f64; 2]| {
                (p[0] - q[0]).hypot(p[1] - q[1]) < 0.01 * (b[0] - a[0]).hypot(b[1] - a[1])
            };
            match across {
                Some((g, [c, d])) if near(a, c) && near(b, d) => {
                    if f < g && folds.angle(f, g) > CREASE {
                        creases.push([a, b]);
                    }
                }
                _ => outline.push([a, b]),
            }
        }
    }
    (outline, creases)
}
