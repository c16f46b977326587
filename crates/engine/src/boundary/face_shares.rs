//! What the points of driven faces give to their nodes.
//!
//! ∫ N σ_ff·n dA by 2 × 2 points a face. Nodes at edges of the model, where a plane's faces end, take of the field's
//! traction what an element takes up ([`End`]). Elsewhere two faces meet, and what neither takes up cancels.

use crate::free_field::{End, Place};
use std::collections::BTreeSet;
use tremolite_laws::Moduli;
use tremolite_mesh::topology::{FacePoint, face_points};
use tremolite_mesh::{Face, Mesh};

/// Two nodes between which an edge of a face runs, the lower number first.
type Edge = [u32; 2];

fn edge(a: u32, b: u32) -> Edge {
    [a.min(b), a.max(b)]
}

/// Edges of one plane's faces that belong to one face alone.
fn ends(mesh: &Mesh, faces: &[Face]) -> BTreeSet<Edge> {
    let mut once = BTreeSet::new();
    for &face in faces {
        let (corners, _) = face_points(mesh, face);
        for (k, &n) in corners.iter().enumerate() {
            let edge = edge(n, corners[(k + 1) % corners.len()]);
            if !once.remove(&edge) {
                once.insert(edge);
            }
        }
    }
    once
}

/// The nodes of one plane's faces, a node once a face, with what the points of the face give to it. `lacking` is that of
/// [`End`], of the element behind a face.
pub fn face_shares(mesh: &Mesh, faces: &[Face], lacking: impl Fn(Face) -> [f64; 2]) -> Vec<(u32, Place)> {
    let edges = ends(mesh, faces);
    let mut out = Vec::new();
    for &face in faces {
        let (corners, points) = face_points(mesh, face);
        // Behind a triangle is no element with axes along its sides.
        let four = <&[FacePoint; 4]>::try_from(&points[..]).ok();
        for (k, &n) in corners.iter().enumerate() {
            let shares = points.iter().map(|point| (point.at, point.area.map(|a| point.shapes[k] * a)));
            let ended = four.map_or([false; 2], |_| ended(&corners, k, &edges));
            let ends =
                four.filter(|_| ended != [false; 2]).map(|four| at_corner(four, k, ended, lacking(face)));
            let ends = ends.unwrap_or_default();
            out.push((n, Place { shares: shares.collect(), ends, ..Place::default() }));
        }
    }
    out
}

/// What [lacks](End::lacking) in the stress out of a face of an element with these moduli, of that of a field with moduli that
/// water may have raised.
pub fn lacking(own: Moduli, field: Moduli) -> [f64; 2] {
    let poisson = own.poisson();
    let share = field.lambda * (1.0 + poisson) / (3.0 * field.lambda + 2.0 * field.mu);
    [poisson, share - poisson].map(|part| part / (1.0 - poisson))
}

/// Whether the faces of the plane end at a corner of a quadrilateral, as one goes along its first axis and along its second.
fn ended(corners: &[u32], k: usize, ends: &BTreeSet<Edge>) -> [bool; 2] {
    // Corners go round: the first axis from 0 to 1 and from 3 to 2, the second from 0 to 3 and from 1 to 2.
    let along = [corners[k ^ 1], corners[3 - k]];
    [1, 0].map(|axis| ends.contains(&edge(corners[k], along[axis])))
}

fn size(a: [f64; 3]) -> f64 {
    (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]).sqrt()
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    let size = size(a);
    a.map(|x| x / size)
}

/// What a corner of a quadrilateral takes of its four points beside its shares, where faces end there along one axis or both.
fn at_corner(points: &[FacePoint; 4], corner: usize, ended: [bool; 2], lacking: [f64; 2]) -> Vec<End> {
    let along = [[[0, 1], [3, 2]], [[0, 3], [1, 2]]].map(|pairs: [[usize; 2]; 2]| {
        unit([0, 1, 2].map(|i| pairs.iter().map(|&[k, l]| points[l].at[i] - points[k].at[i]).sum()))
    });
    let own = |k: usize| points[k].shapes[corner] * size(points[k].area);
    let end = |k: usize| {
        let across = [k ^ 1, 3 - k];
        let beside = [0, 1].map(|axis| if ended[axis] { 0.5 * (own(across[axis]) - own(k)) } else { 0.0 });
        End { at: points[k].at, normal: unit(points[k].area), along, lacking, beside }
    };
    (0..4).map(end).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A face across x from 0 to 1 m along y and z, its first axis y.
    fn face() -> [FacePoint; 4] {
        let g = 0.5 / 3.0_f64.sqrt();
        [[-g, -g], [g, -g], [g, g], [-g, g]].map(|[r, s]| FacePoint {
            at: [0.0, 0.5 + r, 0.5 + s],
            area: [0.25, 0.0, 0.0],
            shapes: [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
                .map(|[a, b]| (0.5 + a * r) * (0.5 + b * s)),
        })
    }

    /// What a corner takes of a stress that varies over the face.
    fn taken(
        corner: usize,
        ended: [bool; 2],
        of: [f64; 2],
        stress: impl Fn([f64; 3]) -> [f64; 6],
    ) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for point in face() {
            let on = stress(point.at);
            let traction = [on[0], on[3], on[5]];
            (0..3).for_each(|i| sum[i] += point.shapes[corner] * point.area[0] * traction[i]);
        }
        for end in at_corner(&face(), corner, ended, of) {
            let force = end.force(&stress(end.at));
            (0..3).for_each(|i| sum[i] += force[i]);
        }
        sum
    }

    /// τ_xy = y and τ_xz = y: of the first a node at an end along y takes a quarter of the middle's, of the second ∫ N y.
    #[test]
    fn shear_along_the_way_to_an_end_is_that_of_the_middle() {
        let shear = |at: [f64; 3]| [0.0, 0.0, 0.0, at[1], 0.0, at[1]];
        for (ended, along, across) in [
            ([false; 2], 1.0 / 12.0, 1.0 / 12.0),
            ([true, false], 1.0 / 8.0, 1.0 / 12.0),
            ([false, true], 1.0 / 12.0, 1.0 / 12.0),
            ([true; 2], 1.0 / 8.0, 1.0 / 12.0),
        ] {
            let [out, y, z] = taken(0, ended, [0.3, 0.1], shear);
            assert!(
                out.abs() < 1e-15 && (y - along).abs() < 1e-15 && (z - across).abs() < 1e-15,
                "{ended:?}: {y} {z}"
            );
        }
    }

    /// Of σ_xx that goes along y with ν/(1 − ν) σ_yy and a share of tr σ, a node at an end along y takes a quarter of the middle's too, and of
    /// what goes with σ_zz ∫ N y.
    #[test]
    fn stress_out_of_the_face_is_that_of_the_middle_as_far_as_it_lacks() {
        let lacking = [0.3, 0.1];
        // 0.3 σ_yy + 0.1 tr σ = σ_xx, of σ_yy = 2y and σ_zz = 5y.
        let [y, z] = [2.0, 5.0];
        let x = (lacking[0] * y + lacking[1] * (y + z)) / (1.0 - lacking[1]);
        let stress = |at: [f64; 3]| [x * at[1], y * at[1], z * at[1], 0.0, 0.0, 0.0];
        for (ended, share) in [([false; 2], 1.0 / 12.0), ([true, false], 1.0 / 8.0)] {
            let [out, ..] = taken(0, ended, lacking, stress);
            assert!((out - share * x).abs() < 1e-15, "{ended:?}: {out}");
        }
        // As far as σ_zz alone goes, nothing lacks along y but by the trace.
        let stress = |at: [f64; 3]| [at[1], 0.0, at[1], 0.0, 0.0, 0.0];
        let [out, ..] = taken(0, [true, false], [0.3, 0.0], stress);
        assert!((out - 1.0 / 12.0).abs() < 1e-15, "{out}");
    }

    /// On a face whose sides are not square the traction along a side, and not across the other, is that of the middle: τ = p e₁ and τ = p e₂
    /// at p e₁ + q e₂.
    #[test]
    fn shear_on_a_skew_face_goes_by_its_sides() {
        let [c, s] = [0.6, 0.8];
        let skew: [FacePoint; 4] = face().map(|point| {
            let [_, p, q] = point.at;
            let area = point.area.map(|a| s * a);
            FacePoint { at: [0.0, p + c * q, s * q], area, shapes: point.shapes }
        });
        let taken = |direction: [f64; 2], ended: [bool; 2]| {
            let stress = |at: [f64; 3]| {
                let p = at[1] - c * at[2] / s;
                [0.0, 0.0, 0.0, p * direction[0], 0.0, p * direction[1]]
            };
            let mut sum = [0.0; 2];
            for point in &skew {
                let on = stress(point.at);
                let own = point.shapes[0] * point.area[0];
                (sum[0], sum[1]) = (sum[0] + own * on[3], sum[1] + own * on[5]);
            }
            for end in at_corner(&skew, 0, ended, [0.0; 2]) {
                let force = end.force(&stress(end.at));
                (sum[0], sum[1]) = (sum[0] + force[1], sum[1] + force[2]);
            }
            sum
        };
        for (direction, ended, share) in [
            ([1.0, 0.0], [true, false], s / 8.0),
            ([c, s], [true, false], s / 12.0),
            ([1.0, 0.0], [false, true], s / 12.0),
        ] {
            let found = taken(direction, ended);
            let near = (0..2).all(|i| (found[i] - share * direction[i]).abs() < 1e-15);
            assert!(near, "{direction:?} {ended:?}: {found:?}");
        }
    }

    /// Of four faces of a plane the eight edges around it are ends, and at each node the edges that leave it there.
    #[test]
    fn a_plane_ends_at_the_edges_that_are_of_one_face() {
        let mesh =
            tremolite_mesh::boxes::BoxSpec::uniform([0.0; 3], [1.0, 2.0, 2.0], [1, 2, 2]).mesh().unwrap();
        let faces =
            crate::outer_faces::OuterFaces::of(&mesh, mesh.bounds(), &[0, 1, 2, 3]).planes[0][0].clone();
        assert_eq!(faces.len(), 4);
        let found = ends(&mesh, &faces);
        let around = |n: u32| mesh.nodes[n as usize][1..].iter().any(|x| *x == 0.0 || *x == 2.0);
        let along = |[a, b]: Edge| {
            let [a, b] = [a, b].map(|n| mesh.nodes[n as usize]);
            (0..3).map(|i| (a[i] - b[i]).abs()).sum::<f64>()
        };
        assert_eq!(found.len(), 8);
        assert!(found.iter().all(|&edge| edge.into_iter().all(around) && along(edge) == 1.0), "{found:?}");
        // A corner lacks along both of its edges, the middle of a side along the way out alone, the middle of all nowhere.
        let places = face_shares(&mesh, &faces, |_| [0.0; 2]);
        for (n, place) in &places {
            let at = mesh.nodes[*n as usize];
            let beside = [1, 2].map(|i| {
                let along = |end: &End| (0..2).find(|&axis| end.along[axis][i].abs() > 0.9).unwrap();
                place.ends.iter().any(|end| end.beside[along(end)] != 0.0)
            });
            assert_eq!(beside, [1, 2].map(|i| at[i] == 0.0 || at[i] == 2.0), "{at:?}");
        }
    }

    /// A stress that is the same everywhere is taken whole, whatever the axes.
    #[test]
    fn an_even_stress_needs_nothing_beside() {
        let even = |_: [f64; 3]| [3.0, -2.0, 5.0, 0.7, 0.2, -0.4];
        for corner in 0..4 {
            let found = taken(corner, [true; 2], [0.4, 0.2], even);
            assert!(found.iter().zip([0.75, 0.175, -0.1]).all(|(f, e)| (f - e).abs() < 1e-15), "{found:?}");
        }
    }

    /// σ_xx less what lacks along y is that of plane stress across y with the element's own moduli, water or not.
    #[test]
    fn what_lacks_leaves_plane_stress() {
        let own = Moduli { lambda: 1.7, mu: 0.9 };
        let strain = [0.3, -0.5, 0.6, 0.0, 0.0, 0.0];
        let expected = 2.0 * own.mu / (1.0 - own.poisson()) * (strain[0] + own.poisson() * strain[2]);
        for water in [0.0, 5.0] {
            let field = Moduli { lambda: own.lambda + water, ..own };
            let stress = field.stress(&strain);
            let [across, whole] = lacking(own, field);
            let found = stress[0] - across * stress[1] - whole * (stress[0] + stress[1] + stress[2]);
            assert!((found - expected).abs() < 1e-14, "{water}: {found} {expected}");
        }
    }
}
