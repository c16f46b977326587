//! Patterns of bolts on the faces that a stage lays bare.
//!
//! Faces are taken opening by opening: what belongs together of what is excavated. Rows are planes across the opening's axis;
//! in each the bolts follow the line in which it cuts the faces. What ends the opening, and so has its normal along the axis, has
//! rows of its own.

use super::heads::Heads;
use super::slice::{cut, spread};
use super::wall::{Looks, Vector, Wall, cross, dot};
use std::collections::BTreeMap;
use tremolite_case::{BoltPattern, BoltedFaces};

/// Share of a face's size by which a head lies in the rock, lest it be in none.
const WITHIN: f64 = 1e-9;
/// sin 5°: what points less into the rock runs along the wall (an assumption).
const ALONG: f64 = 0.087;
/// Share of an opening's faces that may look up where it is a shaft (an assumption).
const ROOF: f64 = 0.05;
/// How even the walls of a shaft lie around it: the least over the most of their area by direction (an assumption).
const EVEN: f64 = 0.8;
/// How even they must lie for no direction to be the axis (an assumption).
const NO_AXIS: f64 = 0.95;

/// A pattern laid out.
#[derive(Clone, Debug, Default)]
pub struct Laid {
    /// Head and other end of each bolt \[m\].
    pub bolts: Vec<[Vector; 2]>,
    /// Places left without one, since the direction that is asked for runs along the wall.
    pub along: usize,
}

/// Lays a pattern out on the faces of one opening, and keeps its distance from heads that are there. `chosen` says of each
/// which are to be bolted, if they look the right way.
pub fn lay(pattern: &BoltPattern, walls: &[Wall], chosen: &[bool], heads: &mut Heads, laid: &mut Laid) {
    let axis = axis(walls);
    let wanted = |w: &usize| {
        chosen[*w]
            && match (pattern.faces.value, walls[*w].looks()) {
                (_, Looks::Down) => false,
                (BoltedFaces::Systematic, _) => true,
                (BoltedFaces::Crown, looks) => looks == Looks::Up,
                (BoltedFaces::Walls, looks) => looks == Looks::Sideways,
            }
    };
    let (ends, sides): (Vec<usize>, Vec<usize>) =
        (0..walls.len()).filter(wanted).partition(|&w| walls[w].ends(axis));
    grid(pattern, walls, &sides, axis, heads, laid);
    let across = match cross([0.0, 0.0, 1.0], axis) {
        [0.0, 0.0, _] => [1.0, 0.0, 0.0],
        across => across,
    };
    for end in patches(walls, &ends) {
        grid(pattern, walls, &end, across, heads, laid);
    }
}

/// Bolts in rows across an axis.
fn grid(
    pattern: &BoltPattern,
    walls: &[Wall],
    of: &[usize],
    axis: Vector,
    heads: &mut Heads,
    laid: &mut Laid,
) {
    let levels = of.iter().flat_map(|&w| &walls[w].corners).map(|&x| dot(x, axis));
    let (low, high) =
        levels.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    if low > high {
        return;
    }
    let [along, around] = pattern.spacing.value;
    for level in spread(low, high, along) {
        for line in cut(walls, of, axis, level, high - low) {
            for (place, normal) in line.places(walls, around) {
                let direction = match &pattern.direction {
                    None => normal,
                    Some(given) => {
                        let inward = dot(given.value, normal);
                        if inward.abs() < ALONG {
                            laid.along += 1;
                            continue;
                        }
                        given.value.map(|x| x * inward.signum())
                    }
                };
                if heads.take(place) {
                    let at = |distance: f64| [0, 1, 2].map(|i| place[i] + distance * direction[i]);
                    // Along the bolt, so that it stays where it was meant to be.
                    let within = WITHIN * along.min(around);
                    laid.bolts.push([at(within), at(pattern.length.value)]);
                }
            }
        }
    }
}

/// Direction in which an opening runs: the horizontal one that its faces' normals have least, and upwards for a shaft, whose
/// walls lie evenly around it under no roof. Along y where the faces say nothing, as the generator's caverns run.
fn axis(walls: &[Wall]) -> Vector {
    let sum = |f: &dyn Fn(Vector) -> f64| {
        let bolted = walls.iter().filter(|wall| wall.looks() != Looks::Down);
        bolted.map(|wall| wall.area * f(wall.normal)).sum::<f64>()
    };
    let (xx, yy, xy, zz) =
        (sum(&|n| n[0] * n[0]), sum(&|n| n[1] * n[1]), sum(&|n| n[0] * n[1]), sum(&|n| n[2] * n[2]));
    let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
    let size = half.hypot(xy);
    let even = (mean - size) / (mean + size);
    if zz < ROOF * (xx + yy + zz) && even > EVEN {
        [0.0, 0.0, 1.0]
    } else if mean <= 1e-9 * zz || even > NO_AXIS {
        [0.0, 1.0, 0.0]
    } else {
        // Normals are along this angle from x most, and the axis is across.
        let (sin, cos) = (0.5 * xy.atan2(half)).sin_cos();
        [-sin, cos, 0.0]
    }
}

/// Faces that share edges.
fn patches(walls: &[Wall], of: &[usize]) -> Vec<Vec<usize>> {
    let edges = |w: usize| {
        let nodes = &walls[w].nodes;
        (0..nodes.len()).map(move |i| {
            let (a, b) = (nodes[i], nodes[(i + 1) % nodes.len()]);
            [a.min(b), a.max(b)]
        })
    };
    let mut at: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
    of.iter().for_each(|&w| edges(w).for_each(|edge| at.entry(edge).or_default().push(w)));
    let mut seen = vec![false; walls.len()];
    let mut patches = Vec::new();
    for &first in of {
        if std::mem::replace(&mut seen[first], true) {
            continue;
        }
        let mut patch = vec![first];
        let mut next = 0;
        while next < patch.len() {
            for edge in edges(patch[next]) {
                for &w in &at[&edge] {
                    if !std::mem::replace(&mut seen[w], true) {
                        patch.push(w);
                    }
                }
            }
            next += 1;
        }
        patches.push(patch);
    }
    patches
}
