//! Growth: how much neighbouring elements differ in length across the face they share.

use std::collections::HashMap;

use super::blocks::{blocks, gallery, with_galleries};
use super::{corners, made};
use crate::cavern::{CavernSpec, GroundSurface, RockLayer, build};
use crate::mesh::{Face, Mesh};

/// Where a pair of neighbours lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Zone {
    /// One is a lining's or of shotcrete, or touches such, or lies in an opening.
    Lining,
    /// One lies in the rock round a cavern that leads over to the grid.
    Surroundings,
    /// They meet at the level of a gallery's floor or roof.
    Level,
    /// In the grid.
    Grid,
    /// They are neighbours along y.
    Along,
}

/// From the face to the opposite one \[m\], between their middles.
fn length(mesh: &Mesh, face: Face) -> f64 {
    let nodes = mesh.elements[face.element as usize].nodes();
    let near: Vec<u32> = mesh.face_nodes(face).collect();
    let middle = |near_side: bool| -> [f64; 3] {
        let side = nodes.iter().filter(|n| near.contains(n) == near_side);
        let mut sum = [0.0; 3];
        side.for_each(|&n| (0..3).for_each(|c| sum[c] += mesh.nodes[n as usize][c] / 4.0));
        sum
    };
    let (a, b) = (middle(true), middle(false));
    (0..3).map(|c| (b[c] - a[c]).powi(2)).sum::<f64>().sqrt()
}

/// Elements that touch a lining or shotcrete, or lie in an opening, and those that lie in a cavern's surroundings. Rock
/// beyond a cavern's end is divided as the cavern is, and counts as what it goes on from.
fn marks(mesh: &Mesh, spec: &CavernSpec) -> (Vec<bool>, Vec<bool>) {
    let section = build::build(spec).unwrap();
    let (points, quads) = (section.points.len(), section.quads.len());
    let mut touched = vec![false; points];
    let mut lining = vec![false; quads];
    for (group, list) in &mesh.groups {
        let hollow = group.ends_with(".excavation");
        if hollow || [".lining", ".shotcrete", ".opening"].iter().any(|end| group.ends_with(end)) {
            for &e in list {
                lining[e as usize % quads] = true;
                if !hollow {
                    mesh.elements[e as usize]
                        .nodes()
                        .iter()
                        .for_each(|&n| touched[n as usize % points] = true);
                }
            }
        }
    }
    let touches = |e: usize| mesh.elements[e].nodes().iter().any(|&n| touched[n as usize % points]);
    let rectangles = section.surroundings;
    let within = |e: usize| {
        let nodes = mesh.elements[e].nodes();
        let middle = [0, 2].map(|c| nodes.iter().map(|&n| mesh.nodes[n as usize][c]).sum::<f64>() / 8.0);
        rectangles.iter().any(|r| (0..2).all(|c| middle[c] > r[c][0] && middle[c] < r[c][1]))
    };
    let elements = 0..mesh.elements.len();
    (elements.clone().map(|e| lining[e % quads] || touches(e)).collect(), elements.map(within).collect())
}

/// Largest growth by zone. `level` has the same elements under level ground, as `spec` says.
fn growth(mesh: &Mesh, level: &Mesh, spec: &CavernSpec) -> HashMap<Zone, f64> {
    let (lining, around) = marks(level, spec);
    let floor = -spec.overburden - spec.caverns[0].height;
    let levels: Vec<f64> =
        spec.galleries.iter().flat_map(|g| [floor + g.at[1], floor + g.at[1] + g.height]).collect();
    let mut open: HashMap<[u32; 4], Face> = HashMap::new();
    let mut largest: HashMap<Zone, f64> = HashMap::new();
    for element in 0..mesh.elements.len() as u32 {
        for side in 0..6 {
            let face = Face { element, side };
            let key = corners(mesh, face);
            let Some(other) = open.remove(&key) else {
                open.insert(key, face);
                continue;
            };
            let pair = [face.element as usize, other.element as usize];
            let at_level =
                levels.iter().any(|l| key.iter().all(|&n| (level.nodes[n as usize][2] - l).abs() < 1e-6));
            let zone = if matches!(side, 2 | 3) {
                Zone::Along
            } else if pair.iter().any(|&e| lining[e]) {
                Zone::Lining
            } else if pair.iter().any(|&e| around[e]) {
                Zone::Surroundings
            } else if at_level {
                Zone::Level
            } else {
                Zone::Grid
            };
            let (a, b) = (length(mesh, face), length(mesh, other));
            let most = largest.entry(zone).or_insert(1.0);
            *most = most.max(a / b).max(b / a);
        }
    }
    largest
}

/// The bounds that [`CavernSpec::mesh`] states.
fn check(name: &str, spec: &CavernSpec, grid: f64) {
    let mesh = made(name, spec);
    // The grid is that under the highest ground.
    let top = build::build(spec).unwrap().block[1][1];
    let flat = match spec.ground {
        GroundSurface::Level => GroundSurface::Level,
        _ => GroundSurface::Table { x: vec![0.0], y: vec![0.0], heights: vec![top] },
    };
    let flat = CavernSpec { ground: flat, ..spec.clone() };
    let largest = growth(&mesh, &made(name, &flat), &flat);
    for (zone, most) in
        [(Zone::Grid, grid), (Zone::Along, 1.3), (Zone::Level, 2.0), (Zone::Surroundings, 4.0)]
    {
        let got = largest.get(&zone).copied().unwrap_or(1.0);
        assert!(got <= most + 1e-9, "{name} {zone:?}: {got}");
    }
}

#[test]
fn elements_grow_slowly_outside_the_transitions() {
    for (name, spec) in blocks() {
        check(name, &spec, 1.3);
    }
}

#[test]
fn elements_grow_slowly_beside_galleries_at_any_level() {
    for floor in [0.0, 2.6, 5.45, 9.0, 14.4, 18.4, 21.0] {
        check(&format!("gallery at {floor}"), &with_galleries(vec![gallery("bus", [0.0, floor])]), 1.3);
    }
    let three = vec![gallery("a", [-12.0, 14.4]), gallery("b", [3.0, 14.4]), gallery("c", [15.0, 6.0])];
    check("three galleries", &with_galleries(three), 1.3);
}

#[test]
fn elements_grow_slowly_with_layers_and_under_a_slope() {
    let (_, spec) = blocks().swap_remove(4);
    let layer = |name: &str, depth: f64| RockLayer { name: name.to_owned(), depth, ..RockLayer::default() };
    let layers = vec![layer("soil", 0.0), layer("weathered", 11.3), layer("sound", 105.7)];
    check("layers", &CavernSpec { layers, ..spec.clone() }, 1.3);
    for (x, grid) in [(0.1, 1.3), (0.3, 1.4)] {
        check("slope", &CavernSpec { ground: GroundSurface::Inclined { x, y: 0.05 }, ..spec.clone() }, grid);
    }
}
