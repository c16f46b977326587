//! A wave in ground under stress is the wave in ground without.
//!
//! A slice with a lined opening (`lined`) has initial stress and weight. It comes to rest in a stage, or what is out of
//! balance is held as it is; then it is handed over to the shaking, and a pulse comes up through a base of dashpots and springs. As all
//! is elastic, displacements since the hand-over are those of the same model from rest without stress or weight, and so are all
//! lines of the energy balance, though what is stored at the hand-over is far more than what the wave brings. The same with a
//! Mohr–Coulomb rock that is never near yield.

use crate::lined::{END, Joints, ROCK, slice};
use crate::models::material;
use crate::simulation::whole_steps;
use crate::staged::release;
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::hexahedra::centroid;
use tremolite::stages::{PlannedStage, settle};
use tremolite::{Assembly, Base, Engine, Incident, Line, Model, Phase, Rayleigh, Snapshot, Stage, stable_step};
use tremolite_laws::materials::MohrCoulomb;
use tremolite_laws::{Material, Row, Values};
use tremolite_motion::{Motion, ricker_velocity};

const NAME: &str = "hand_over_wave";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a pulse in a lined slice under stress: displacements and every line of the balance as without stress",
    source: "superposition",
    from: Effort::Test,
    run,
};

const GRAVITY: f64 = 9.81;
/// Direction of the wave's motion.
const ALONG: [f64; 3] = [0.48, 0.36, 0.8];
/// Ground above the slice that its initial stress counts \[m\], and K₀.
const ABOVE: f64 = 84.0;
const LATERAL: f64 = 0.8;
/// Of the pulse: peak frequency \[Hz\], centre \[s\] and peak \[m/s\]. So late it begins with 1e-15 of its peak: a run from rest takes
/// the half of its first step that one after a hand-over does not.
const PULSE: [f64; 3] = [30.0, 0.065, 0.01];
/// Rows in a run.
const ROWS: u64 = 10;

/// How a run begins.
#[derive(Clone, Copy, PartialEq)]
enum Begin {
    /// Without stress or weight.
    Unstressed,
    /// What is out of balance is held.
    Held,
    /// At rest after a stage.
    Settled,
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for (yields, law) in [(false, "elastic"), (true, "Mohr–Coulomb")] {
        let plain = shake(yields, Begin::Unstressed)?;
        for (begin, word) in [(Begin::Held, "held"), (Begin::Settled, "after a stage")] {
            let stressed = shake(yields, begin)?;
            let (mut peak, mut apart, mut largest) = (0.0_f64, 0.0_f64, 0.0_f64);
            let mut lines: Vec<(Line, f64)> = Vec::new();
            for (a, b) in plain.rows.iter().zip(&stressed.rows) {
                for (a, b) in a.displacement.iter().zip(&b.displacement) {
                    peak = peak.max(length(*a));
                    apart = apart.max(length(Row([0, 1, 2, 3].map(|i| a.0[i] - b.0[i]))));
                }
                largest = a.balance.iter().fold(largest, |most, (_, x)| most.max(x.abs()));
                lines.extend(a.balance.iter().zip(b.balance.iter()).map(|((line, a), (_, b))| (line, (a - b).abs())));
            }
            let note = "1e-9: what is not let go moves nothing; round-off of 1e-12 of the static displacements";
            let quantity = format!("difference of displacements over the peak, {law}, {word}");
            checks.push(Check::new(NAME, quantity, apart / peak, 0.0, 1e-9, "1", note));
            let (line, worst) =
                lines.into_iter().fold((Line::Error, 0.0), |most, next| if next.1 > most.1 { next } else { most });
            let note = format!("1e-6: round-off of what is stored at the hand-over; the worst is '{}'", line.name());
            let quantity = format!("largest difference of a line of the balance over the largest, {law}, {word}");
            checks.push(Check::new(NAME, quantity, worst / largest, 0.0, 1e-6, "1", note));
            let note = "for information: how much the lines must do without";
            let quantity = format!("energy stored at the hand-over over the largest line, {law}, {word}");
            checks.push(Check::beside(NAME, quantity, stressed.stored / largest, 0.0, "1", note));
        }
    }
    Ok(checks)
}

fn length(row: Row) -> f64 {
    row.xyz().iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// A run: what is seen at its rows, and the elements' energy \[J\] at its start.
struct Shaken {
    rows: Vec<Snapshot>,
    stored: f64,
}

fn shake(yields: bool, begin: Begin) -> Result<Shaken, VerifyError> {
    let none = Joints { lining: false, fault: false, law: "coulomb", numbers: &[] };
    let mut problem = slice(1, none, ALONG)?;
    problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: None };
    let [frequency, centre, peak] = PULSE;
    let pulse = ricker_velocity(frequency, centre, peak);
    let motion = Motion::sampled(2e-4, END, |t| pulse(t).along(ALONG))?;
    problem.incident = Some(Incident { motion, factor: 1.0 });
    problem.rayleigh = Rayleigh { mass: 2.0, stiffness: 1e-5 };
    if yields {
        let values = Values::default()
            .with("young", ROCK.young)
            .with("poisson", ROCK.poisson)
            .with("cohesion", 50e6)
            .with("friction_angle", 0.7)
            .with("dilation_angle", 0.1)
            .with("tensile_strength", 20e6);
        problem.bodies[1].material = material(MohrCoulomb::NAME, &values)?;
    }
    if begin != Begin::Unstressed {
        let high = problem.mesh.bounds().1[2];
        let mut initial = vec![[0.0; 6]; problem.mesh.elements.len()];
        for &e in &problem.bodies[1].elements {
            let s = -ROCK.density * GRAVITY * (ABOVE + high - centroid(&problem.mesh, e)[2]);
            initial[e as usize] = [LATERAL * s, LATERAL * s, s, 0.0, 0.0, 0.0];
        }
        problem.initial = initial;
        problem.gravity = GRAVITY;
    }
    let model = Model::new(problem)?;
    let assembly = Assembly::new(&model)?;
    let stage = PlannedStage { release: release(1.0), ..PlannedStage::new("equilibrium") };
    let stages = [stage];
    let stages = if begin == Begin::Settled { &stages[..] } else { &[] };
    let (mut state, _) =
        settle(&model, &assembly, stages).map_err(|unsettled| VerifyError::Setup(format!("{unsettled:?}")))?;
    let phase = Phase::of(&model, &assembly, Stage::Shaking)?;
    let mut engine = Engine::new(&model, &assembly, &phase);
    let (steps, dt) = whole_steps(END, stable_step(&model, &assembly, &phase).to_run(0.9));
    let mut stored = 0.0;
    if begin == Begin::Unstressed {
        state.dt = dt;
        let still = vec![Row::ZERO; state.u.len()];
        engine.start(&mut state, still.clone(), &still);
    } else {
        engine.hand_over(&mut state, dt);
        stored = state.ledger.lines[Line::Strain];
    }
    let mut rows = Vec::new();
    for step in 1..=steps {
        engine.step(&mut state);
        if step % (steps / ROWS) == 0 {
            rows.push(engine.look(&state).snapshot);
        }
    }
    Ok(Shaken { rows, stored })
}
