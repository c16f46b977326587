//! A lined opening in rock under a pulse from below, a slice of it, with joints where a problem wants them.

use crate::VerifyError;
use crate::joints::joint;
use crate::models::Solid;
use crate::simulation::{Simulation, whole_steps};
use std::collections::BTreeMap;
use tremolite::hexahedra::centroid;
use tremolite::{Base, Incident, Interface, Problem, Quadrature, Side, State};
use tremolite_mesh::boxes::{BoxError, BoxSpec};
use tremolite_motion::{Motion, ricker_velocity};

pub const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2500.0 };
const LINING: Solid = Solid { young: 30e9, poisson: 0.2, density: 2400.0 };
/// Half the width and the height \[m\] of the slice; elements of 1 m.
const HALF: u32 = 8;
const HEIGHT: u32 = 16;
/// Peak frequency \[Hz\] of the pulse, its centre and the end of the run \[s\], its peak \[m/s\].
const FREQUENCY: f64 = 30.0;
const CENTRE: f64 = 0.05;
pub const END: f64 = 0.1;
const PEAK: f64 = 0.5;

/// Which joints are there, of the same law and values.
#[derive(Clone, Copy, Debug)]
pub struct Joints<'a> {
    /// Between lining and rock; vertical through the middle of all.
    pub lining: bool,
    pub fault: bool,
    pub law: &'a str,
    pub numbers: &'a [(&'a str, f64)],
}

/// The slice: 16 by 16 m with an opening 4 m wide and 3 m high, walls and roof of the lining 1 m thick, no floor: it stands
/// on its feet. Viscous sides across x, periodic ones across y, a viscous base, a pulse along `along`.
///
/// # Errors
/// If it cannot be built.
pub fn slice(deep: u32, joints: Joints, along: [f64; 3]) -> Result<Problem, VerifyError> {
    let mesh = mesh(deep)?;
    let at = |e: u32| centroid(&mesh, e);
    let inside = |e: u32, half: f64, top: f64| {
        let x = at(e);
        x[0].abs() < half && x[2] > 6.0 && x[2] < top
    };
    let all = 0..mesh.elements.len() as u32;
    let (lining, rock): (Vec<u32>, Vec<u32>) =
        all.filter(|&e| !inside(e, 2.0, 9.0)).partition(|&e| inside(e, 3.0, 10.0));
    let both = || lining.iter().chain(&rock).copied();
    let (left, right): (Vec<u32>, Vec<u32>) = both().partition(|&e| at(e)[0] < 0.0);
    let mut interfaces: Vec<Interface> = Vec::new();
    for (there, name, sides) in
        [(joints.lining, "lining", [lining.clone(), rock.clone()]), (joints.fault, "fault", [left, right])]
    {
        if there {
            let mut interface = joint(sides, joints.law, joints.numbers, &[])?;
            interface.name = name.into();
            interfaces.push(interface);
        }
    }
    let bodies =
        vec![LINING.body("lining", lining, Quadrature::Full), ROCK.body("rock", rock, Quadrature::OnePoint)];
    let mut problem = Problem::new(mesh, bodies);
    problem.interfaces = interfaces;
    problem.sides = [Side::Viscous, Side::Periodic];
    problem.base = Base::Viscous;
    let pulse = ricker_velocity(FREQUENCY, CENTRE, PEAK);
    let motion = Motion::sampled(2e-4, END, |t| pulse(t).along(along))?;
    problem.incident = Some(Incident { motion, factor: 1.0 });
    Ok(problem)
}

fn mesh(deep: u32) -> Result<tremolite_mesh::Mesh, BoxError> {
    let (half, depth) = (f64::from(HALF), f64::from(deep));
    BoxSpec::uniform([-half, 0.0, 0.0], [half, depth, f64::from(HEIGHT)], [2 * HALF, deep, HEIGHT]).mesh()
}

/// Displacements \[m\] of the corners of elements in the first metre of y: by twice the centre's x and z, and twice the
/// corner's.
pub type Corners = BTreeMap<[i64; 4], [f64; 3]>;

/// Runs a slice with steps of at most `dt` \[s\] and what interfaces allow; every thousandth of a second `see` gets the
/// corners, and at the end the state.
///
/// # Errors
/// If it does not run.
pub fn shake(
    problem: Problem,
    dt: f64,
    mut see: impl FnMut(&Corners),
) -> Result<(Simulation, State), VerifyError> {
    let simulation = Simulation::new(problem)?;
    let stable = simulation.bound();
    let (every, dt) = whole_steps(1e-3, dt.min(stable.to_run(0.9)));
    let mut engine = simulation.engine();
    let mut state = simulation.start(&mut engine, dt, |_| [[0.0; 3]; 2]);
    while state.time() < END {
        for _ in 0..every {
            engine.step(&mut state);
        }
        see(&corners(&simulation, &state));
    }
    drop(engine);
    Ok((simulation, state))
}

/// Corners of elements in the first metre of y.
pub fn corners(simulation: &Simulation, state: &State) -> Corners {
    let model = &simulation.model;
    let mut corners = Corners::new();
    let twice = |x: f64| (2.0 * x).round() as i64;
    for (e, _) in model.elements.body_of.iter().enumerate().filter(|(_, body)| body.is_some()) {
        let centre = centroid(&model.mesh, e as u32);
        for &node in model.mesh.elements[e].nodes().iter().filter(|_| centre[1] < 1.0) {
            let (x, own) = (model.mesh.nodes[node as usize], model.engine_node[node as usize]);
            if x[1] == 0.0 {
                let key = [twice(centre[0]), twice(centre[2]), twice(x[0]), twice(x[2])];
                corners.insert(key, state.u[own as usize].xyz());
            }
        }
    }
    corners
}

/// The corner's mirror image across x = 0.
pub fn mirrored([a, b, c, d]: [i64; 4]) -> [i64; 4] {
    [-a, b, -c, d]
}
