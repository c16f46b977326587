//! The check of a normal stiffness that was given for the interface of a lining.

use crate::evidence::Evidence;
use std::collections::BTreeMap;
use tremolite_engine::outer_faces::NEAR;
use tremolite_engine::{Model, Seam, Side};
use tremolite_mesh::Mesh;
use tremolite_results::{Said, TrustLine, said, snake};

/// Closure under a pressure over what the ground around the opening gives under it: of a hall of 12 × 18 m the lining's largest stress
/// is 4 % below that of one that is tied where it is 0.035, 10 % where it is 0.1, 75 % where it is 10.
const CLOSURE: f64 = 0.1;
const ID: &str = "lining_interface_compliance";
/// Mean distance of an interface's surface from its middle, over its extent, below which it goes around nothing.
const FLAT: f64 = 0.05;

fn name() -> Said {
    said!("compliance of a lining's interface over that of the ground round the opening")
}

/// A line for each interface between a lining and the ground, whose stiffness was given.
pub(super) fn lines(evidence: &Evidence) -> Vec<TrustLine> {
    let Evidence { model, assembly, .. } = evidence;
    let mut lines = Vec::new();
    for (seam, contacts) in model.user_seams().iter().zip(&assembly.contacts) {
        let Some(ground) = ground_beside(model, seam).filter(|_| !contacts.chosen) else { continue };
        let stiffness = contacts.law.stiffness(0.0)[0];
        // 2G/R, what an opening of radius R resists an even pressure with (`kirsch1898`): the least of the linings that it holds.
        let of_lining = |radius: f64| ground / radius / stiffness;
        let Some(radius) = radii(&model.mesh, seam, &mirrors(model)).into_iter().min_by(f64::total_cmp)
        else {
            continue;
        };
        let line = TrustLine::at_most(
            format!("{ID}_{}", snake(&seam.name)),
            said!("{check}, {interface}", check = name(), interface = &seam.name),
            of_lining(radius),
            CLOSURE,
            "",
        );
        lines.push(line.with("normal_stiffness", stiffness).with("radius", radius).with("ground", ground / radius).with_note(said!(
            "at equal pressure, unloaded: {given} GPa/m beside the {ground} GPa/m of an opening of {radius} m radius, 2G/R; so soft a \
             layer keeps the ground's motion from the lining: see that a test says so, or leave `normal_stiffness` out",
            given = format!("{:.3}", 1e-9 * stiffness),
            ground = format!("{:.3}", 1e-9 * ground / radius),
            radius = format!("{radius:.1}"),
        )));
    }
    if lines.is_empty() {
        lines.push(TrustLine::not_applicable(
            ID,
            name(),
            said!("no lining has an interface whose stiffness was given"),
        ));
    }
    lines
}

/// 2G \[Pa\] of the ground, the mean over the faces, where the other side is a lining: what begins with a stage or cracks, beside
/// what does neither.
fn ground_beside(model: &Model, seam: &Seam) -> Option<f64> {
    let lining = |element: u32| {
        let cracks =
            model.elements.body_of[element as usize].is_some_and(|b| model.bodies[b].material.info().damages);
        cracks || model.elements.lives[element as usize].is_later()
    };
    let mut ground = None;
    for side in 0..2 {
        let [own, others] =
            [side, 1 - side].map(|side| seam.faces.iter().map(move |faces| faces[side].element));
        if own.clone().all(lining) && !others.clone().any(lining) {
            let moduli = others
                .filter_map(|e| Some(model.bodies[model.elements.body_of[e as usize]?].material.moduli().mu));
            let (sum, count) = moduli.fold((0.0, 0.0), |(sum, count), mu| (sum + 2.0 * mu, count + 1.0));
            ground = Some(sum / count);
        }
    }
    ground
}

/// Of each connected part of an interface that goes around something, the mean distance of its surface from its middle along the
/// normals \[m\]: the radius of a circle or a sphere, twice area over girth of any other section.
fn radii(mesh: &Mesh, seam: &Seam, mirrors: &[(usize, f64)]) -> Vec<f64> {
    let mut part: BTreeMap<u32, usize> = BTreeMap::new();
    let mut parts: Vec<Vec<usize>> = Vec::new();
    for (f, faces) in seam.faces.iter().enumerate() {
        let nodes: Vec<u32> = mesh.face_nodes(faces[0]).collect();
        let mut met: Vec<usize> = nodes.iter().filter_map(|n| part.get(n).copied()).collect();
        met.sort_unstable();
        met.dedup();
        let into = met.first().copied().unwrap_or_else(|| {
            parts.push(Vec::new());
            parts.len() - 1
        });
        for other in met.into_iter().skip(1) {
            let moved = std::mem::take(&mut parts[other]);
            let of_moved = moved.iter().flat_map(|&f| mesh.face_nodes(seam.faces[f][0]));
            of_moved.for_each(|n| _ = part.insert(n, into));
            parts[into].extend(moved);
        }
        nodes.into_iter().for_each(|n| _ = part.insert(n, into));
        parts[into].push(f);
    }
    parts.iter().filter_map(|faces| radius(mesh, seam, mirrors, faces)).collect()
}

/// Planes that stand for the other half of the model: the axis across each, and where it is \[m\].
fn mirrors(model: &Model) -> Vec<(usize, f64)> {
    let (low, high) = model.faces.bounds;
    let rollers = (0..2).filter(|&axis| model.boundaries.sides[axis] == Side::Roller);
    rollers.flat_map(|axis| [(axis, low[axis]), (axis, high[axis])]).collect()
}

fn radius(mesh: &Mesh, seam: &Seam, mirrors: &[(usize, f64)], faces: &[usize]) -> Option<f64> {
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    // Middle, area vector and area of each face: half the cross product of the diagonals.
    let flat: Vec<([f64; 3], [f64; 3], f64)> = faces
        .iter()
        .map(|&f| {
            let x: Vec<[f64; 3]> =
                mesh.face_nodes(seam.faces[f][0]).map(|n| mesh.nodes[n as usize]).collect();
            let minus = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
            let (a, b) = match x[..] {
                [p, q, r, s] => (minus(r, p), minus(s, q)),
                [p, q, r] => (minus(q, p), minus(r, p)),
                _ => ([0.0; 3], [0.0; 3]),
            };
            let vector = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
            let vector = vector.map(|v| 0.5 * v);
            let middle = [0, 1, 2].map(|i| x.iter().map(|x| x[i]).sum::<f64>() / x.len().max(1) as f64);
            (middle, vector, dot(vector, vector).sqrt())
        })
        .collect();
    let area: f64 = flat.iter().map(|(.., area)| area).sum();
    let mut middle = [0, 1, 2].map(|i| flat.iter().map(|(x, _, area)| area * x[i]).sum::<f64>() / area);
    // Of an opening that ends on one such plane the middle lies there.
    let nodes = || faces.iter().flat_map(|&f| mesh.face_nodes(seam.faces[f][0]));
    let (from, to) = mesh.bounds();
    for axis in 0..2 {
        let near = NEAR * (to[axis] - from[axis]);
        let ends = mirrors.iter().filter(|(across, at)| {
            *across == axis && nodes().any(|n| (mesh.nodes[n as usize][axis] - at).abs() <= near)
        });
        if let [(_, at)] = ends.collect::<Vec<_>>()[..] {
            middle[axis] = *at;
        }
    }
    let away = |x: &[f64; 3]| [0, 1, 2].map(|i| x[i] - middle[i]);
    let radius = flat.iter().map(|(x, vector, _)| dot(away(x), *vector)).sum::<f64>().abs() / area;
    let extent = flat.iter().map(|(x, ..)| dot(away(x), away(x)).sqrt()).fold(0.0, f64::max);
    (radius > FLAT * extent).then_some(radius)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tremolite_engine::{Body, Interface, Problem, Quadrature, elastic, hexahedra::centroid};
    use tremolite_laws::{Moduli, Values};
    use tremolite_mesh::boxes::BoxSpec;

    #[test]
    fn the_radius_is_that_of_each_opening_whatever_its_length_and_mesh_and_a_plane_has_none() {
        // Two holes of 2 × 4 m and 4 × 4 m in a slice, filled, and a plane across it.
        for size in [1.0, 0.5] {
            let count = |length: f64| (length / size) as u32;
            let mesh =
                BoxSpec::uniform([0.0; 3], [20.0, 2.0, 8.0], [count(20.0), 2, count(8.0)]).mesh().unwrap();
            let inside = |e: &u32| {
                let [x, _, z] = centroid(&mesh, *e);
                (2.0..6.0).contains(&z) && ((3.0..5.0).contains(&x) || (9.0..13.0).contains(&x))
            };
            let right = |e: &u32| centroid(&mesh, *e)[0] > 16.0;
            let all = 0..mesh.elements.len() as u32;
            let (fill, ground): (Vec<u32>, Vec<u32>) = all.clone().partition(inside);
            let (beyond, this): (Vec<u32>, Vec<u32>) = all.partition(right);
            let law =
                tremolite_kernels::interface_laws().into_iter().find(|l| l.info.name == "coulomb").unwrap();
            let values = Values::default().with("normal_stiffness", 1e9).with("friction_coefficient", 0.5);
            let body = |name: &str, elements: &[u32]| Body {
                name: name.into(),
                elements: elements.to_vec(),
                material: elastic(Moduli::from_young_poisson(1e10, 0.25)),
                density: 2700.0,
                quadrature: Quadrature::OnePoint,
                viscosity: 0.0,
            };
            let mut problem = Problem::new(mesh.clone(), vec![body("fill", &fill), body("ground", &ground)]);
            let of = |name: &str, sides| Interface::new(name, sides, law, values.clone());
            problem.interfaces = vec![of("linings", [fill, ground]), of("plane", [beyond, this])];
            let model = Model::new(problem).unwrap();
            let mut found = radii(&model.mesh, &model.seams[0], &[]);
            found.sort_by(f64::total_cmp);
            // Twice area over girth.
            assert_eq!(found.len(), 2);
            assert!((found[0] - 16.0 / 12.0).abs() < 1e-12 && (found[1] - 2.0).abs() < 1e-12, "{found:?}");
            assert!(radii(&model.mesh, &model.seams[1], &[]).is_empty());
            // Half of the larger one at a plane of symmetry has the same.
            let seam = &model.seams[0];
            let half = |f: &usize| centroid(&model.mesh, seam.faces[*f][0].element)[0] > 11.0;
            let faces: Vec<usize> = (0..seam.faces.len()).filter(half).collect();
            let found = radius(&model.mesh, seam, &[(0, 11.0)], &faces).unwrap();
            assert!((found - 2.0).abs() < 1e-12, "{found}");
        }
    }
}
