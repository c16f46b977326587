//! A thin strip of lining with one element through its thickness.
//!
//! A concrete strip of 12 × 1.2 × 0.25 m in ten elements, clamped at one end, bends across its thickness. Theory:
//! deflection PL³/(3EI) + PL/(κGA), κ = 10(1 + ν)/(12 + 11ν) (Timoshenko; Cowper 1966), and the first frequency
//! 1.8751² √(EI/(ρA))/L² of the Euler beam, which shear and rotation lower by less than (t/L)². A hexahedron without the
//! hourglass field either locks here (by 1 + ½(a/t)², a the element's length: 13 times too stiff) or has no stiffness at
//! all. The engine itself runs the free vibration, from the first mode of its own K and M.

use crate::convergence::Oscillation;
use crate::models::{QUADRATURES, Solid, nodes_at_level};
use crate::simulation::Simulation;
use crate::stiffness::Assembled;
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::TAU;
use tremolite::Quadrature;
use tremolite_mesh::boxes::BoxSpec;

const NAME: &str = "cantilever_thin";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "lining strip with one element through its thickness: deflection and first frequency",
    source: "Timoshenko and Euler beams; Cowper 1966",
    from: Effort::Test,
    run,
};

const CONCRETE: Solid = Solid { young: 25e9, poisson: 0.17, density: 2752.0 };
const LENGTH: f64 = 12.0;
const WIDTH: f64 = 1.2;
const THICKNESS: f64 = 0.25;
const ELEMENTS: u32 = 10;

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let moduli = CONCRETE.moduli();
    let (area, inertia) = (WIDTH * THICKNESS, WIDTH * THICKNESS.powi(3) / 12.0);
    let nu = CONCRETE.poisson;
    let kappa = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
    let bending = CONCRETE.young * inertia;
    let deflection = LENGTH.powi(3) / (3.0 * bending) + LENGTH / (kappa * moduli.mu * area);
    let frequency =
        1.875_104_068_711_961_f64.powi(2) / (LENGTH * LENGTH) * (bending / (CONCRETE.density * area)).sqrt();
    let mut checks = Vec::new();
    for (quadrature, word) in QUADRATURES {
        let [u, w] = strip(quadrature)?;
        let note = "2 %: ten elements of constant moment miss 1/(4·10²) = 0.25 %; the clamp holds the width of the first \
                    element, which may stiffen it by ν² = 3 %, and it gives less than a third of the deflection";
        let quantity = format!("tip deflection over theory, {word}");
        checks.push(Check::new(NAME, quantity, u / deflection, 1.0, 0.02, "1", note));
        let note = "1 %: half that of the deflection, for ω goes with the root of the stiffness";
        let quantity = format!("first frequency over theory, {word}");
        checks.push(Check::new(NAME, quantity, w / frequency, 1.0, 0.01, "1", note));
    }
    Ok(checks)
}

/// Deflection \[m\] under a unit force at the tip, and first frequency \[rad/s\].
fn strip(quadrature: Quadrature) -> Result<[f64; 2], VerifyError> {
    let mesh = BoxSpec::uniform([0.0; 3], [LENGTH, WIDTH, THICKNESS], [ELEMENTS, 1, 1]).mesh()?;
    let [root, tip] = [0.0, LENGTH].map(|x| nodes_at_level(&mesh, 0, x));
    let mut problem = CONCRETE.fill(mesh, quadrature);
    problem.held = root.into_iter().map(|n| (n, [true; 3])).collect();
    let simulation = Simulation::new(problem)?;
    let system = Assembled::new(&simulation);
    let share = 1.0 / tip.len() as f64;
    let forces: Vec<(u32, [f64; 3])> = tip.iter().map(|&n| (n, [0.0, 0.0, share])).collect();
    let static_u = system.solve(&simulation, &forces)?;
    let tip: Vec<usize> = tip.iter().map(|&n| simulation.model.engine_node[n as usize] as usize).collect();
    let deflection = tip.iter().map(|&n| static_u[n][2]).sum::<f64>() * share;

    let (lambda, shapes) = system.modes();
    let mode = system.spread(&simulation, &shapes.values[..system.mass.len()]);
    let dt = 0.9 * simulation.stable();
    let mut engine = simulation.engine();
    let mut state = simulation.start(&mut engine, dt, |n| [mode[n], [0.0; 3]]);
    // A period in about a hundred samples: near a step apart cosines differ by round-off only.
    let every = (TAU / (100.0 * lambda[0].sqrt() * dt)) as usize;
    let mut q = Vec::new();
    for _ in 0..100 {
        q.push(state.u[tip[0]].0[2]);
        for _ in 0..every {
            engine.step(&mut state);
        }
    }
    let frequency = Oscillation::fit_undamped(&q).angle() / (every as f64 * dt);
    Ok([deflection, frequency])
}
