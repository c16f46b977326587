//! The discrete energy of the undamped scheme is constant.
//!
//! Velocity Verlet conserves, exactly and not only on average,
//! E = ½ v̂ᵀM v̂ + ½ uᵀK u − ⅛Δt² aᵀM a,
//! with v̂ = v^n of (21) and a = −M⁻¹K u^n: since v^{n±½} = v̂ ± ½Δt a this is ½ (v^{n−½})ᵀM v^{n+½} + ½ uᵀK u, and the
//! step changes neither sum. The block is distorted and starts with random velocities, so every mode takes part, at
//! 0.9 of the stable step, over 10,000 steps. Energies are the engine's own: kinetic, strain and hourglass.

use crate::models::{QUADRATURES, Solid, distorted};
use crate::simulation::Simulation;
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::{Base, Engine, Line, Quadrature, State};

const NAME: &str = "discrete_energy";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "½v'Mv + ½u'Ku − ⅛Δt²a'Ma stays constant over 10,000 undamped steps",
    source: "exact invariant of velocity Verlet, from wang2018 (20)-(21) with C = 0",
    from: Effort::Test,
    run,
};

const STEPS: usize = 10_000;
const EVERY: usize = 100;

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for (quadrature, word) in QUADRATURES {
        let note = "round-off alone: 10,000 steps of some hundred sums each add up to 1e-12 if the errors are random, \
                    and to 1e-10 if all were of one sign";
        let quantity = format!("largest relative change of the discrete energy, {word}");
        checks.push(Check::new(NAME, quantity, drift(quadrature)?, 0.0, 1e-10, "1", note));
    }
    Ok(checks)
}

fn drift(quadrature: Quadrature) -> Result<f64, VerifyError> {
    let rock = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
    let mut problem = rock.fill(distorted([4.0; 3], [4; 3], 0.14)?, quadrature);
    problem.base = Base::Fixed;
    let simulation = Simulation::on_one_level(problem)?;
    let dt = 0.9 * simulation.stable();
    let mut engine = simulation.engine();
    let random = |n: usize, i: usize| 0.1 * ((3 * n + i) as f64 * 12.9898).sin();
    let mut state = simulation.start(&mut engine, dt, |n| {
        let held = simulation.phase.inverse_mass[n].0[0] == 0.0;
        [[0.0; 3], [0, 1, 2].map(|i| if held { 0.0 } else { random(n, i) })]
    });
    let first = energy(&simulation, &mut engine, &mut state);
    let mut worst = 0.0f64;
    for _ in 0..STEPS / EVERY {
        for _ in 0..EVERY {
            engine.step(&mut state);
        }
        worst = worst.max((energy(&simulation, &mut engine, &mut state) / first - 1.0).abs());
    }
    Ok(worst)
}

/// E at the state.
fn energy(simulation: &Simulation, engine: &mut Engine, state: &mut State) -> f64 {
    let snapshot = engine.look(state).snapshot;
    let mass = simulation.phase.mass.iter();
    let square = |a: &tremolite_laws::Row| a.xyz().iter().map(|x| x * x).sum::<f64>();
    let ama: f64 = mass.zip(&snapshot.acceleration).map(|(m, a)| m * square(a)).sum();
    let balance = &snapshot.balance;
    balance[Line::Kinetic] + balance[Line::Strain] + balance[Line::Hourglass]
        - 0.125 * state.dt * state.dt * ama
}
