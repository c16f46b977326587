//! Interfaces that are there from the start and begin loaded, at rest before the shaking and in it.
//!
//! A block under a uniform stress of six components with an oblique plane through it, and a core in a ring with a round
//! interface between, whose pairs have every direction. A pair begins with the traction of the stress on it, and both of its
//! sides take that over its vector area: so a uniform stress is in equilibrium at every node, on a polygon as on a plane, and nothing
//! moves, neither in the initial equilibrium nor in a hundred steps after the hand-over.

use crate::joints::joint;
use crate::models::{QUADRATURES, Solid};
use crate::staged::{Quiet, Rings};
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::hexahedra::centroid;
use tremolite::interface::traction;
use tremolite::Traction;
use tremolite::{Base, Life, Quadrature, Side};
use tremolite_mesh::Face;
use tremolite_mesh::boxes::{BoxSpec, Distortion};

const NAME: &str = "loaded_interface";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "interfaces that begin loaded by a uniform stress with shear: at rest before the shaking and in it",
    source: "equilibrium of a uniform stress",
    from: Effort::Test,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2600.0 };
/// σ \[Pa\]
const STRESS: [f64; 6] = [-6e6, -5e6, -8e6, 0.7e6, -0.5e6, 0.9e6];
/// In the plane of rings one element thick, between rollers along the axis, without shear on these.
const PLANE: [f64; 6] = [-6e6, -5e6, -8e6, 0.0, 0.0, 0.9e6];
/// Size of the models \[m\].
const SIZE: f64 = 4.0;

type Numbers = &'static [(&'static str, f64)];
const LAWS: [(&str, Numbers); 2] = [
    ("coulomb", &[("normal_stiffness", 20e9), ("friction_coefficient", 0.8), ("cohesion", 0.0)]),
    ("bandis", &[("normal_stiffness", 20e9), ("max_closure", 1e-3), ("friction_coefficient", 0.6), ("cohesion", 1e6)]),
];

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let scale = -STRESS[2] * SIZE / ROCK.young;
    for (law, numbers) in LAWS {
        for (quadrature, word) in QUADRATURES {
            for (shape, problem) in [
                ("oblique plane", plane(quadrature, law, numbers)?),
                ("cylinder", cylinder(quadrature, law, numbers)?),
            ] {
                let [before, after, pressure] = rest(problem)?;
                let note = "1e-9: round-off of the forces at nodes; σL/E is 3 mm";
                let of = |what: &str| format!("{what} over σL/E, {shape}, {law}, {word}");
                let quantity = of("motion to equilibrium");
                checks.push(Check::new(NAME, quantity, before / scale, 0.0, 1e-9, "1", note));
                let quantity = of("motion in a hundred steps of the shaking");
                checks.push(Check::new(NAME, quantity, after / scale, 0.0, 1e-9, "1", note));
                let quantity = of("largest error of pressure at a pair over σ_z").replace(" over σL/E", "");
                let note = "1e-9: round-off of stresses";
                checks.push(Check::new(NAME, quantity, pressure, 0.0, 1e-9, "1", note));
            }
        }
    }
    Ok(checks)
}

/// A distorted block of cubes, whose levels lean along x and y in the middle; the plane is the middle one.
fn plane(quadrature: Quadrature, law: &str, numbers: Numbers) -> Result<tremolite::Problem, VerifyError> {
    let mut spec = BoxSpec::uniform([0.0; 3], [SIZE; 3], [4; 3]);
    spec.distortion = Some(Distortion { fraction: 0.1, seed: 3, periodic: [false; 2] });
    let mut mesh = spec.mesh()?;
    let half = 0.5 * SIZE;
    let lower = |e: &u32| centroid(&mesh, *e)[2] < half;
    let sides: (Vec<u32>, Vec<u32>) = (0..mesh.elements.len() as u32).partition(lower);
    for x in &mut mesh.nodes {
        // The middle plane is level but for the lean.
        let near = 1.0 - (x[2] - half).abs() / half;
        let level = if near > 0.6 { half } else { x[2] };
        x[2] = level + near.min(1.0) * (0.3 * (x[0] - half) + 0.15 * (x[1] - half));
    }
    let faces = ["xmin", "xmax", "ymin", "ymax", "top"].map(|name| mesh.faces[name].clone()).concat();
    let solid = ROCK.fill(mesh, quadrature);
    loaded(solid, faces, STRESS, joint([sides.0, sides.1], law, numbers, &[])?)
}

/// A core of wedges and bricks in a ring.
fn cylinder(quadrature: Quadrature, law: &str, numbers: Numbers) -> Result<tremolite::Problem, VerifyError> {
    let radii = vec![0.0, 0.25 * SIZE, 0.5 * SIZE, 0.75 * SIZE, SIZE];
    let rings = Rings::new(radii, 24, true);
    let (core, ring) = (rings.between(0.0, 0.5 * SIZE), rings.between(0.5 * SIZE, SIZE));
    let brick = rings.brick();
    let solid = ROCK.body("rock", core.iter().chain(&ring).copied().collect(), quadrature);
    let faces = rings.edge(|_| PLANE).into_iter().map(|(face, _)| face).collect();
    let apart = brick.elements[0];
    let problem = tremolite::Problem::new(rings.mesh.clone(), vec![solid, brick]);
    let mut problem = loaded(problem, faces, PLANE, joint([core, ring], law, numbers, &[])?)?;
    problem.initial[apart as usize] = [0.0; 6];
    problem.sides[1] = Side::Roller;
    problem.base = Base::Fixed;
    Ok(problem)
}

/// The stress in all elements and on these faces, and the interface.
fn loaded(
    mut problem: tremolite::Problem,
    faces: Vec<Face>,
    stress: [f64; 6],
    interface: tremolite::Interface,
) -> Result<tremolite::Problem, VerifyError> {
    problem.initial = vec![stress; problem.mesh.elements.len()];
    let faces = faces.into_iter().map(|face| (face, stress)).collect();
    problem.tractions = vec![Traction { name: "stress".into(), faces, life: Life::BEFORE }];
    problem.interfaces = vec![interface];
    Ok(problem)
}

/// Largest motion \[m\] to equilibrium, and in the shaking; largest error of the pressure at a pair over σ_z.
fn rest(problem: tremolite::Problem) -> Result<[f64; 3], VerifyError> {
    let stress = problem.initial[0];
    let Quiet { model, assembly, state, moved: [before, after] } = Quiet::new(problem)?;
    let (seam, contacts) = (&model.seams[0], &assembly.contacts[0]);
    let error = seam.pairs.iter().enumerate().map(|(k, pair)| {
        let on = traction(&stress, pair.normal);
        let normal: f64 = (0..3).map(|i| on[i] * pair.normal[i]).sum();
        ((contacts.seen(&state.history, k).pressure + normal) / stress[2]).abs()
    });
    Ok([before, after, error.fold(0.0, f64::max)])
}
