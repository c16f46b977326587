//! Edges of a developed surface: its outline, the cuts, and the creases.

use std::collections::BTreeMap;

use super::Corners;
use super::folds::Folds;

/// Fold \[rad\] from which on an edge is drawn.
const CREASE: f64 = 25.0 * std::f64::consts::PI / 180.0;

/// What comes apart by less than this part of the whole is a tear of a dome or the like. It shows by itself, and drawn would
/// blacken fine meshes.
const TEAR: f64 = 0.3;

type Lines = Vec<[[f64; 2]; 2]>;

/// Edges with nothing beside them but tears, and creases.
pub fn edges(folds: &Folds, own: &[usize], placed: &BTreeMap<usize, (usize, Corners)>) -> (Lines, Lines) {
    let (mut outline, mut creases) = (Vec::new(), Vec::new());
    let tear = TEAR * extent(placed.values().flat_map(|(_, corners)| corners));
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
                Some((g, [c, d])) if folds.angle(f, g) <= CREASE && apart([a, b], [c, d]) < tear => {}
                _ => outline.push([a, b]),
            }
        }
    }
    (outline, creases)
}

/// Distance of the middles of two edges.
fn apart([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> f64 {
    let [x, y] = [0, 1].map(|i| 0.5 * (a[i] + b[i] - c[i] - d[i]));
    x.hypot(y)
}

/// Length of what points lie within, along v.
fn extent<'a>(points: impl Iterator<Item = &'a [f64; 2]>) -> f64 {
    let ends =
        points.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], p| [low.min(p[1]), high.max(p[1])]);
    ends[1] - ends[0]
}
