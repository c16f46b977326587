//! Two equal bars that meet.
//!
//! Bars of length L without Poisson's effect meet with the relative velocity v. Steps of pressure ½ρcv run into both, come back
//! from their free ends as tension and part the bars after 2L/c, when each has just the other's velocity and no stress
//! (Graff 1975, chapter 2). The joint has no bond; its stiffness E/h, h the element, is that of one element more, so it goes
//! with the mesh. Contact damping is the default.
//!
//! **Errors.** The joint delays a front by h/c, and the row spreads it over (h²L)^{1/3} ([`super::bar_step_wave`]): the contact's
//! end moves by no more, and less where the pressure falls below half the plateau. Momentum lags by what the spread fronts
//! still carry when the bars part: of mv a part of the order (h/L)^{2/3}.

use crate::convergence::order;
use crate::joints::joint;
use crate::models::Solid;
use crate::simulation::{Simulation, whole_steps};
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::{Line, Quadrature};
use tremolite_mesh::boxes::BoxSpec;

const NAME: &str = "bars_collide";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "two equal bars meet: in contact for 2L/c under ½ρcv, velocities exchanged",
    source: "d'Alembert's solution (Graff 1975, chapter 2)",
    from: Effort::Test,
    run,
};

const BAR: Solid = Solid { young: 10e9, poisson: 0.0, density: 2700.0 };
/// L \[m\] and v \[m/s\].
const LENGTH: f64 = 10.0;
const MEETING: f64 = 2.0;

/// What a run shows.
struct Outcome {
    /// Time of the contact's end, until which the pressure stays above half the plateau, over 2L/c.
    time: f64,
    /// Mean pressure from 0.2 to 0.8 of 2L/c over ½ρcv.
    plateau: f64,
    /// Mean velocity of the bar that was hit, less that before, over v.
    exchanged: f64,
    /// Energy that contact damping took, and the balance's error, over the kinetic energy at the start.
    damped: f64,
    error: f64,
    /// ½k(vΔt)² over it.
    step: f64,
}

fn collide(n: u32) -> Result<Outcome, VerifyError> {
    let h = LENGTH / f64::from(n);
    let mesh = BoxSpec::uniform([0.0; 3], [h, h, 2.0 * LENGTH], [1, 1, 2 * n]).mesh()?;
    let mut problem = BAR.fill(mesh, Quadrature::OnePoint);
    let stiffness = BAR.young / h;
    let numbers = [("normal_stiffness", stiffness), ("friction_coefficient", 0.5)];
    problem.interfaces = vec![joint([(0..n).collect(), (n..2 * n).collect()], "coulomb", &numbers, &[])?];
    let simulation = Simulation::new(problem)?;
    let speed = (BAR.young / BAR.density).sqrt();
    let contact = 2.0 * LENGTH / speed;
    let stable = simulation.bound();
    let (steps, dt) = whole_steps(1.5 * contact, stable.to_run(0.9));

    // Nodes of the upper bar: those of its elements.
    let mut upper = vec![false; simulation.phase.mass.len()];
    for element in &simulation.model.mesh.elements[n as usize..2 * n as usize] {
        for &node in element.nodes() {
            upper[simulation.model.engine_node[node as usize] as usize] = true;
        }
    }
    let velocity = |node: usize| [0.0, 0.0, if upper[node] { -0.5 } else { 0.5 } * MEETING];
    let mut engine = simulation.engine();
    let mut state = simulation.start(&mut engine, dt, |node| [[0.0; 3], velocity(node)]);
    let pressure = 0.5 * BAR.density * speed * MEETING;
    let (mut sum, mut count, mut last, mut before) = (0.0, 0.0, 0.0, 0.0);
    for _ in 0..steps {
        let time = state.time();
        engine.step(&mut state);
        let seen = simulation.assembly.contacts[0].seen(&state.history, 0);
        let over = [before, seen.pressure].map(|p| p - 0.5 * pressure);
        if over[0] > 0.0 && over[1] <= 0.0 {
            last = time - dt * over[1] / (over[1] - over[0]);
        }
        before = seen.pressure;
        if (0.2..0.8).contains(&(time / contact)) {
            (sum, count) = (sum + seen.pressure, count + 1.0);
        }
    }
    let snapshot = engine.finish(&mut state);
    let (mut momentum, mut mass) = (0.0, 0.0);
    for (node, &m) in simulation.phase.mass.iter().enumerate().filter(|(node, _)| upper[*node]) {
        momentum += m * snapshot.velocity[node].0[2];
        mass += m;
    }
    let initial = snapshot.balance[Line::Initial];
    Ok(Outcome {
        time: last / contact,
        plateau: sum / count / pressure,
        exchanged: (momentum / mass + 0.5 * MEETING) / MEETING,
        damped: snapshot.balance[Line::ContactDamping] / initial,
        error: (snapshot.balance[Line::Error] - snapshot.scheme) / initial,
        step: 0.5 * stiffness * h * h * (MEETING * dt).powi(2) / initial,
    })
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let [coarse, fine] = [100, 200].map(collide);
    let (coarse, fine) = (coarse?, fine?);
    let note = "2 %, of the order (h/L)^2/3 = 2.9 % at 200 elements a bar";
    let mut checks = Vec::new();
    for (what, found) in [
        ("time of contact over 2L/c", [coarse.time, fine.time]),
        ("velocity given over v", [coarse.exchanged, fine.exchanged]),
        ("mean pressure over ½ρcv", [coarse.plateau, fine.plateau]),
    ] {
        let p = order((found[0] - 1.0).abs(), (found[1] - 1.0).abs(), 2.0);
        checks.push(Check::new(NAME, what, found[1], 1.0, 0.02, "1", note).with_order(p));
    }
    let p = order(coarse.exchanged - 1.0, fine.exchanged - 1.0, 2.0);
    let note = "2/3 by the spread of fronts";
    checks.push(Check::new(NAME, "order in h of the velocity given", p, 2.0 / 3.0, 0.15, "1", note).with_order(p));
    let p = order(coarse.damped, fine.damped, 2.0);
    let note = "1 %: the dashpots are 1 % of critical for one element, and act while the front is in it";
    let check = Check::new(NAME, "energy taken by contact damping over all", fine.damped, 0.0, 0.01, "1", note);
    checks.push(check.with_order(p));
    let note = "½k(vΔt)² of an impact's first step, by the trapezoidal rule";
    checks.push(Check::new(NAME, "error of the balance over all energy", fine.error, 0.0, fine.step, "1", note));
    Ok(checks)
}
