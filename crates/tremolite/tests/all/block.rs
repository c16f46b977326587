//! A small shaken block, for the tests of the engine and of runs.

use tremolite::{Base, Body, Incident, Problem, Quadrature, Rayleigh, Side, elastic};
use tremolite_laws::Moduli;
use tremolite_mesh::boxes::{BoxSpec, Distortion};
use tremolite_motion::{Motion, Sample, ricker_velocity};

/// A block of 12 × 10 × 14 m with a stiffer slab of full elements in the middle, distorted, with periodic sides, a
/// viscous-spring base and a pulse along all three axes.
pub fn block(elements: [u32; 3]) -> Problem {
    let mut spec = BoxSpec::uniform([0.0; 3], [12.0, 10.0, 14.0], elements);
    spec.distortion = Some(Distortion { fraction: 0.1, seed: 3, periodic: [true; 2] });
    let mesh = spec.mesh().unwrap();
    let middle: Vec<bool> = (0..mesh.elements.len() as u32)
        .map(|e| (tremolite::hexahedra::centroid(&mesh, e)[2] - 7.0).abs() < 1.5)
        .collect();
    let choose = |want: bool| (0u32..).zip(&middle).filter(|(_, m)| **m == want).map(|(e, _)| e).collect();
    let body = |name: &str, elements, young, nu, quadrature| Body {
        name: name.into(),
        elements,
        material: elastic(Moduli::from_young_poisson(young, nu)),
        density: 2700.0,
        quadrature,
        viscosity: 0.0,
    };
    let bodies = vec![
        body("rock", choose(false), 1e9, 0.25, Quadrature::OnePoint),
        body("slab", choose(true), 5e9, 0.17, Quadrature::Full),
    ];
    let mut problem = Problem::new(mesh, bodies);
    problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(20.0) };
    problem.sides = [Side::Periodic; 2];
    problem.rayleigh = Rayleigh { mass: 0.4, stiffness: 0.0 };
    problem.incident = Some(Incident { motion: pulse(), factor: 0.5 });
    problem
}

/// A pulse of 12 Hz, 0.3 s long.
pub fn pulse() -> Motion {
    let v = ricker_velocity(12.0, 0.12, 0.3);
    Motion::sampled(1e-3, 0.3, |t| {
        let s = v(t);
        Sample {
            a: [s.a, 0.5 * s.a, -0.7 * s.a],
            v: [s.v, 0.5 * s.v, -0.7 * s.v],
            u: [s.u, 0.5 * s.u, -0.7 * s.u],
        }
    })
    .unwrap()
}
