//! Edges through the thickness of linings one element thick: how much stiffer than the lining they make it.
//!
//! Edges that fan out make trapezoids of an element's sides, which bend too stiffly in an element that passes the patch test
//! (`macneal1987`). With L the length of a side, t the thickness and φ the angle between the edges at its ends the error goes with (Lφ/t)². A
//! curved lining has φ = L/R, so Lφ/t = L²/(tR), and the uniform stretch of its thickness takes part of the error; edges that lean to and fro keep it.

use crate::stacks::stacks;
use std::collections::BTreeMap;
use tremolite_case::{self as case, Case};
use tremolite_engine::hexahedra::hex_nodes;
use tremolite_engine::{Body, Quadrature};
use tremolite_laws::shapes::hex8::turned;
use tremolite_mesh::{Mesh, Shape};

type Vector = [f64; 3];

/// L²/(tR) from which on elements are too long for their curvature: 5 % of stiffness.
const CURVED: f64 = 0.6;
/// Angle \[rad\] to the normal from which on edges lean.
const LEANS: f64 = 5.0 * std::f64::consts::PI / 180.0;
/// Stiffness over that of the lining, less 1, for a unit (Lφ/t)²: of rings pinched at 4 to 16 elements a quarter, R/t of 10 to 50.
const OF_CURVES: f64 = 0.15;
/// The same of edges that lean to and fro: of strips by 5°, 10° and 20°, L/t of 5.
const OF_LEANS: f64 = 0.5;
/// The stiffness over that of the lining, less 1, from which on edges that lean are told.
const TOLD: f64 = 0.05;
/// Share of a lining from which on it is told.
const SHARE: f64 = 0.05;
/// Cosine of the angle between a normal and those of the elements beside it, below which a lining has a corner there.
const CORNER: f64 = 0.866;

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn plus(a: Vector, k: f64, b: Vector) -> Vector {
    [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: Vector) -> Vector {
    let length = dot(a, a).sqrt();
    if length > 0.0 { a.map(|x| x / length) } else { a }
}

/// An element by the edges through its thickness, in turn.
struct Cell {
    /// The nodes at the ends of each edge.
    edges: Vec<[u32; 2]>,
    /// The middle of each edge, and the edge.
    middles: Vec<Vector>,
    across: Vec<Vector>,
    /// Of the surface through the middles, along the edges, as long as its area.
    normal: Vector,
    centre: Vector,
}

impl Cell {
    fn new(mesh: &Mesh, edges: Vec<[u32; 2]>) -> Cell {
        let at = |n: u32| mesh.nodes[n as usize];
        let middles: Vec<Vector> =
            edges.iter().map(|&[a, b]| plus(at(a), 0.5, plus(at(b), -1.0, at(a)))).collect();
        let across: Vec<Vector> = edges.iter().map(|&[a, b]| plus(at(b), -1.0, at(a))).collect();
        let count = middles.len();
        let mut normal = [0.0; 3];
        for k in 0..count {
            let side = |k: usize| plus(middles[k % count], -1.0, middles[0]);
            normal = plus(normal, 0.5, cross(side(k), side(k + 1)));
        }
        if across.iter().map(|&edge| dot(edge, normal)).sum::<f64>() < 0.0 {
            normal = normal.map(|x| -x);
        }
        let centre = middles.iter().fold([0.0; 3], |sum, &x| plus(sum, 1.0 / count as f64, x));
        Cell { edges, middles, across, normal, centre }
    }

    fn thickness(&self) -> f64 {
        let normal = unit(self.normal);
        self.across.iter().map(|&edge| dot(edge, normal)).sum::<f64>() / self.across.len() as f64
    }
}

/// An edge by its nodes in ascending order, and whether it leads from the first to the second.
fn key([a, b]: [u32; 2]) -> ([u32; 2], f64) {
    if a < b { ([a, b], 1.0) } else { ([b, a], -1.0) }
}

/// Elements of a lining one element thick.
fn cells(mesh: &Mesh, body: &Body) -> Vec<Cell> {
    let layered = matches!(body.quadrature, Quadrature::Layered(_));
    let single = stacks(mesh, &body.elements).into_iter().filter(|stack| layered || stack.len() == 1);
    let mut axes: BTreeMap<u32, usize> = single.flatten().collect();
    if layered {
        let wedges = body.elements.iter().filter(|&&e| mesh.elements[e as usize].shape == Shape::Wedge6);
        axes.extend(wedges.map(|&e| (e, 2)));
    }
    let of = |(e, axis): (u32, usize)| {
        let nodes = match mesh.elements[e as usize].shape {
            Shape::Wedge6 => mesh.elements[e as usize].nodes[..6].to_vec(),
            _ => turned(axis).map(|k| hex_nodes(mesh, e as usize)[k]).to_vec(),
        };
        let half = nodes.len() / 2;
        Cell::new(mesh, (0..half).map(|k| [nodes[k], nodes[k + half]]).collect())
    };
    axes.into_iter().map(of).collect()
}

/// A side of an element that is too stiff.
#[derive(Clone, Copy)]
struct Side {
    /// L²/(tR).
    curve: f64,
    /// Of the edges at its ends to the normal \[rad\], the larger.
    lean: f64,
    /// Expected stiffness over that of the lining.
    stiffness: f64,
    /// The longest side that would not be too long for the curvature \[m\].
    length: f64,
    place: Vector,
}

impl Side {
    fn is_curved(&self) -> bool {
        self.curve > CURVED
    }
}

/// The stiffest side of each cell that is too stiff, with the cell's area.
fn too_stiff(cells: &[Cell]) -> Vec<(f64, Option<Side>)> {
    let mut beside: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
    for (number, cell) in cells.iter().enumerate() {
        cell.edges.iter().for_each(|&edge| beside.entry(key(edge).0).or_default().push(number));
    }
    // The normal at an edge, along it; none at a corner of the lining.
    let normals: BTreeMap<[u32; 2], Option<Vector>> = beside
        .iter()
        .map(|(&nodes, around)| {
            let oriented = |&c: &usize| {
                let sign = cells[c].edges.iter().find(|&&e| key(e).0 == nodes).map_or(1.0, |&e| key(e).1);
                cells[c].normal.map(|x| sign * x)
            };
            let sum = unit(around.iter().map(oriented).fold([0.0; 3], |sum, n| plus(sum, 1.0, n)));
            let smooth = around.iter().all(|c| dot(unit(oriented(c)), sum) > CORNER);
            (nodes, smooth.then_some(sum))
        })
        .collect();
    let of = |cell: &Cell| {
        let (own, thickness) = (unit(cell.normal), cell.thickness());
        let count = cell.edges.len();
        let mut most: Option<Side> = None;
        for (i, j) in (0..count).map(|i| (i, (i + 1) % count)) {
            let way = plus(cell.middles[j], -1.0, cell.middles[i]);
            let (length, along) = (dot(way, way).sqrt(), unit(way));
            // Whether the lining goes on beyond an end of the side.
            let goes_on = |k: usize, forwards: f64| {
                let beyond = |&c: &usize| {
                    forwards * dot(plus(cells[c].centre, -1.0, cell.middles[k]), along) > 0.1 * length
                };
                beside[&key(cell.edges[k]).0].iter().any(beyond)
            };
            let normal = |k: usize| {
                let (nodes, sign) = key(cell.edges[k]);
                normals[&nodes].map(|n| n.map(|x| sign * x))
            };
            let (Some(mut first), Some(mut last)) = (normal(i), normal(j)) else { continue };
            match (goes_on(i, -1.0), goes_on(j, 1.0)) {
                (true, true) => {}
                (true, false) => last = unit(plus(own.map(|x| 2.0 * x), -1.0, first)),
                (false, true) => first = unit(plus(own.map(|x| 2.0 * x), -1.0, last)),
                (false, false) => continue,
            }
            let (start, end) = (unit(cell.across[i]), unit(cell.across[j]));
            let turn = dot(plus(last, -1.0, first), along);
            let fan = dot(plus(end, -1.0, start), along) - turn;
            let angle = |a: Vector, b: Vector| dot(cross(a, b), cross(a, b)).sqrt().asin();
            let (curve, leaning) = (length * turn.abs() / thickness, length * fan.abs() / thickness);
            let side = Side {
                curve,
                lean: angle(start, first).max(angle(end, last)),
                stiffness: 1.0 + OF_CURVES * curve * curve + OF_LEANS * leaning * leaning,
                length: length * (CURVED / curve).sqrt(),
                place: cell.centre,
            };
            let leans = side.lean > LEANS && OF_LEANS * leaning * leaning > TOLD;
            let stiffest = most.is_none_or(|most| side.stiffness > most.stiffness);
            if (side.is_curved() || leans) && stiffest {
                most = Some(side);
            }
        }
        (dot(cell.normal, cell.normal).sqrt(), most)
    };
    cells.iter().map(of).collect()
}

/// Linings whose edges through the thickness make them too stiff in bending.
pub fn warnings(case: &Case, mesh: &Mesh, bodies: &[Body]) -> Vec<case::Diagnostic> {
    let regions = case.regions.iter().filter(|r| matches!(r.fill, case::Fill::Solid { .. }));
    let of = |(region, body): (&case::Region, &Body)| {
        if body.quadrature == Quadrature::OnePoint {
            return None;
        }
        let found = too_stiff(&cells(mesh, body));
        let whole: f64 = found.iter().map(|(area, _)| area).sum();
        let stiff: Vec<(f64, Side)> =
            found.into_iter().filter_map(|(area, side)| Some((area, side?))).collect();
        let area: f64 = stiff.iter().map(|(area, _)| area).sum();
        let (_, worst) = *stiff.iter().max_by(|a, b| a.1.stiffness.total_cmp(&b.1.stiffness))?;
        if area <= SHARE * whole {
            return None;
        }
        let [x, y, z] = worst.place;
        let share = 100.0 * area / whole;
        let stiffness = format!(
            "bending stiffness of '{}': about {:.2} times its own in {share:.0} % of it",
            body.name, worst.stiffness
        );
        let (why, remedy) = match worst.is_curved() {
            true => (
                format!("L²/(tR) of an element: {:.2} ({CURVED})", worst.curve),
                format!("make its elements {:.2} m long or shorter round the curve", worst.length),
            ),
            false => (
                format!(
                    "edges through the thickness lean: {:.0}° (5°) off the normal",
                    worst.lean.to_degrees()
                ),
                "lay the edges through its thickness along the normal of its surface".to_owned(),
            ),
        };
        let message = format!("{stiffness}. {why} at ({x:.2}, {y:.2}, {z:.2}) m");
        Some(case::Diagnostic::new(region.span.clone(), message, remedy))
    };
    regions.zip(bodies).filter_map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use tremolite_mesh::Element;

    /// A row of hexahedra in x and z, one in y, by the ends of their edges.
    fn row(edges: impl Fn(usize) -> [[f64; 2]; 2], count: usize) -> Vec<Cell> {
        let mut mesh = Mesh::default();
        for (k, y) in (0..=count).flat_map(|k| [0.0, 1.0].map(|y| (k, y))) {
            mesh.nodes.extend(edges(k).map(|[x, z]| [x, y, z]));
        }
        for k in 0..count as u32 {
            let n = |i: u32| 4 * k + i;
            let nodes = [n(0), n(4), n(6), n(2), n(1), n(5), n(7), n(3)];
            mesh.elements.push(Element::new(Shape::Hex8, &nodes));
        }
        let of = |e: usize| {
            let n = mesh.elements[e].nodes;
            Cell::new(&mesh, (0..4).map(|k| [n[k], n[k + 4]]).collect())
        };
        (0..count).map(of).collect()
    }

    fn ring(thickness: f64, count: usize) -> Vec<Cell> {
        row(
            |k| {
                let (sin, cos) = (0.5 * std::f64::consts::PI * k as f64 / count as f64).sin_cos();
                [5.0 - 0.5 * thickness, 5.0 + 0.5 * thickness].map(|r| [r * sin, r * cos])
            },
            count,
        )
    }

    /// Edges of a strip that lean to and fro by an angle, or alike.
    fn strip(degrees: f64, alike: bool) -> Vec<Cell> {
        row(
            |k| {
                let to = if alike || k % 2 == 0 { 1.0 } else { -1.0 };
                let lean = 0.125 * to * degrees.to_radians().tan();
                [-1.0, 1.0].map(|side| [1.2 * k as f64 + side * lean, 0.125 * side])
            },
            10,
        )
    }

    fn stiffest(cells: &[Cell]) -> Option<Side> {
        let found = too_stiff(cells).into_iter().filter_map(|(_, side)| side);
        found.max_by(|a, b| a.stiffness.total_cmp(&b.stiffness))
    }

    /// Deflections over those of curved beams: 0.644 of 4 elements a quarter, R/t 10; 0.380 and 0.105 of 4 at 20 and 50; 0.774 of 8 at 50.
    #[test]
    fn elements_too_long_for_their_curvature_are_told_with_the_stiffness_that_pinched_rings_had() {
        for (thickness, count, deflection) in
            [(0.5, 4, 0.644), (0.25, 4, 0.380), (0.1, 4, 0.105), (0.1, 8, 0.774)]
        {
            let side = stiffest(&ring(thickness, count)).unwrap();
            assert!(side.is_curved());
            let expected = side.stiffness * deflection;
            assert!(
                (0.8..1.25).contains(&expected),
                "{thickness}, {count}: {} and {deflection}",
                side.stiffness
            );
            // The length that is advised is that of a ring which is not told.
            let length = 2.5 * std::f64::consts::PI / count as f64;
            let finer = (count as f64 * length / side.length).ceil() as usize;
            assert!(stiffest(&ring(thickness, finer)).is_none(), "{thickness}: {finer} a quarter");
        }
        assert!(stiffest(&ring(0.5, 12)).is_none());
        assert!(stiffest(&ring(0.25, 16)).is_none());
    }

    /// Deflections over theory of strips of 12 m × 0.25 m: 0.72, 0.413 and 0.17.
    #[test]
    fn edges_that_lean_to_and_fro_are_told_with_the_stiffness_that_strips_had() {
        for (degrees, deflection) in [(5.5, 0.68), (10.0, 0.413), (20.0, 0.17)] {
            let side = stiffest(&strip(degrees, false)).unwrap();
            assert!(!side.is_curved());
            assert!((side.lean.to_degrees() - degrees).abs() < 1e-6, "{}", side.lean.to_degrees());
            let expected = side.stiffness * deflection;
            assert!((0.8..1.25).contains(&expected), "{degrees}°: {} and {deflection}", side.stiffness);
        }
        assert!(stiffest(&strip(4.9, false)).is_none());
        // Parallelepipeds bend exactly.
        assert!(stiffest(&strip(20.0, true)).is_none());
    }
}
