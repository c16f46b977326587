//! P and S waves through a column of rock with bolts: the step, and the balance of energy.
//!
//! A column 4 m wide of elements of 1 m with bolts along it and across all axes, moving with the rock or bonded, under a pulse
//! from below.
//!
//! - The stable step is that of the rock: bolts have no mass, and their stiffness is little beside that of what they lie in.
//! - The error of the balance is that of the scheme, (ωΔt/2)² of the energy, with bolts as without, and of order 2 in Δt.
//! - With a bond and a bar that are weak, bonds slide and bars yield. What friction takes is found a second time, from what is seen of
//!   bolts alone: displacements of the rock at the points give the slip at one end of a segment by that at the other, forces of
//!   segments those of the bond between; ∫F ds less what the bond stores is what friction took. The balance must close as before.
//! - The model's mirror image moves as its mirror image, sliding and yielding included.

use tremolite::Snapshot;
use tremolite::engine::See;
use tremolite::Domain;
use crate::bolted::{AREA, Watched, bolts};
use crate::convergence::order;
use crate::models::{Solid, column};
use crate::simulation::{Simulation, whole_steps};
use crate::{Check, Effort, Verification, VerifyError};
use std::collections::BTreeMap;
use tremolite::{Base, Bolts, Bond, Incident, Line, Quadrature, Side};
use tremolite_motion::{Motion, ricker_velocity};

const NAME: &str = "bolted_wave";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "P and S waves through bolted rock: stable step, balance of energy with friction and yield, mirror image",
    source: "the discrete balance of energy; reflection in x",
    from: Effort::Test,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
const LAYERS: u32 = 20;
const ACROSS: u32 = 4;
/// Peak frequency \[Hz\], centre and end \[s\], peak \[m/s\].
const PULSE: [f64; 4] = [50.0, 0.03, 0.075, 0.5];
const P: [f64; 3] = [0.0, 0.0, 1.0];
const S: [f64; 3] = [0.8, 0.6, 0.0];

const FIRM: Bond = Bond { stiffness: 1e9, strength: 1e7, friction: 0.0, perimeter: 0.0, segment: 0.5 };
const WEAK: Bond = Bond { strength: 4e3, ..FIRM };
/// Stress \[Pa\] at which weak bars yield.
const YIELDS: f64 = 15e6;

/// Vertical and oblique.
fn kind(bond: Option<Bond>, yields: f64) -> Bolts {
    let bars = [
        [[1.3, 1.7, 6.2], [1.3, 1.7, 12.4]],
        [[2.8, 0.6, 4.1], [2.8, 0.6, 9.3]],
        [[0.6, 0.8, 10.3], [3.3, 2.9, 15.2]],
        [[3.4, 2.2, 5.7], [0.4, 3.1, 8.8]],
        [[0.3, 2.4, 12.1], [3.7, 2.6, 12.9]],
    ];
    Bolts { bond, yields, ..bolts(&bars, AREA) }
}

fn problem(kind: Option<Bolts>, along: [f64; 3]) -> Result<tremolite::Problem, VerifyError> {
    let mut problem = ROCK.fill(column(1.0, LAYERS, ACROSS)?, Quadrature::OnePoint);
    problem.sides = [Side::Periodic; 2];
    problem.base = Base::Viscous;
    let [frequency, centre, end, peak] = PULSE;
    let pulse = ricker_velocity(frequency, centre, peak);
    let motion = Motion::sampled(2e-4, end, |t| pulse(t).along(along))?;
    problem.incident = Some(Incident { motion, factor: 1.0 });
    problem.bolts = kind.into_iter().collect();
    Ok(problem)
}

/// What a run came to.
#[derive(Default)]
struct Outcome {
    /// Largest error of the balance over what was supplied.
    error: f64,
    friction: f64,
    plastic: f64,
    /// What friction and yield took by what is seen \[J\].
    by_hand: [f64; 2],
    /// Largest force of any segment \[N\].
    force: f64,
}

fn shake(kind: Option<Bolts>, along: [f64; 3], steps: u64, dt: f64) -> Result<Outcome, VerifyError> {
    let simulation = Simulation::on_one_level(problem(kind, along)?)?;
    let model = &simulation.model;
    let mut watched: Vec<Watched> = model.bolts.iter().flat_map(|set| &set.bolts).map(Watched::new).collect();
    let mut engine = simulation.engine();
    let mut state = simulation.start(&mut engine, dt, |_| [[0.0; 3]; 2]);
    let (mut out, mut supplied) = (Outcome::default(), 0.0_f64);
    engine.step(&mut state);
    for _ in 0..steps {
        // What the bolts remember is that of the same displacements.
        let evaluated = engine.evaluate(state, See::Look);
        let Some(&Snapshot { balance, supplied: so_far, .. }) = evaluated.snapshot() else { break };
        supplied = supplied.max(so_far);
        out.error = out.error.max(balance[Line::Error].abs());
        (out.friction, out.plastic) = (balance[Line::BoltFriction], balance[Line::BoltPlastic]);
        for (b, watched) in watched.iter_mut().enumerate() {
            out.force = out.force.max(watched.look(&simulation, evaluated.state(), b));
        }
        state = engine.advance(evaluated);
    }
    out.error /= supplied;
    let sum = |of: fn(&Watched) -> f64| watched.iter().map(of).sum();
    out.by_hand = [sum(Watched::friction), sum(Watched::plastic)];
    Ok(out)
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let stable = |kind: Option<Bolts>| Ok::<_, VerifyError>(Simulation::on_one_level(problem(kind, P)?)?.stable());
    let bare = stable(None)?;
    let kinds = [("moving with the rock", None), ("bonded", Some(FIRM))];
    for (word, bond) in kinds {
        let ratio = stable(Some(kind(bond, f64::INFINITY)))? / bare;
        let note = "1 %: EA/ℓ is a hundredth of what an element has, at some of its nodes";
        checks.push(Check::new(
            NAME,
            format!("stable step over that of the rock, {word}"),
            ratio,
            1.0,
            0.01,
            "1",
            note,
        ));
    }
    for (wave, along) in [("P", P), ("S", S)] {
        let (steps, dt) = whole_steps(PULSE[2], 0.9 * bare);
        let twice = |kind: Option<Bolts>| -> Result<[Outcome; 2], VerifyError> {
            Ok([shake(kind.clone(), along, steps, dt)?, shake(kind, along, 2 * steps, 0.5 * dt)?])
        };
        let rock = twice(None)?;
        let of_order = |o: &[Outcome; 2]| order(o[0].error, o[1].error, 2.0);
        checks.push(
            Check::beside(
                NAME,
                format!("{wave}: error of the balance, rock alone"),
                rock[0].error,
                0.0,
                "1",
                "the scheme's",
            )
            .with_order(of_order(&rock)),
        );
        let all = [
            ("moving with the rock", None, f64::INFINITY),
            ("bonded", Some(FIRM), f64::INFINITY),
            ("sliding and yielding", Some(WEAK), YIELDS),
        ];
        for (word, bond, yields) in all {
            let bolted = twice(Some(kind(bond, yields)))?;
            let of = |what: &str| format!("{wave}: {what}, {word}");
            let note = "5 %: bolts hold a hundredth of the energy; the error is the scheme's, (ωΔt/2)²";
            let ratio = bolted[0].error / rock[0].error;
            let quantity = of("error of the balance over that of the rock alone");
            checks
                .push(Check::new(NAME, quantity, ratio, 1.0, 0.05, "1", note).with_order(of_order(&bolted)));
            let note = "the error's size stays that of the scheme as Δt is halved";
            let quantity = of("order in Δt of the error of the balance");
            checks.push(Check::new(NAME, quantity, of_order(&bolted), 2.0, 0.1, "1", note).with_order(of_order(&bolted)));
            checks.push(Check::beside(
                NAME,
                of("largest force"),
                bolted[0].force,
                0.0,
                "N",
                "so much bolts are pulled",
            ));
            if yields.is_finite() {
                for (o, word) in bolted.iter().zip(["", ", half the step"]) {
                    let note =
                        "1e-9: round-off of sums; from forces of segments and displacements of the rock";
                    let quantity = of(&format!("friction over ∫F ds less what bonds store{word}"));
                    checks.push(Check::new(NAME, quantity, o.friction / o.by_hand[0], 1.0, 1e-9, "1", note));
                    let quantity = of(&format!("plastic work over ∫N dε_p ℓ{word}"));
                    let note = "1e-9: round-off of sums; from forces and plastic strains of segments";
                    checks.push(Check::new(NAME, quantity, o.plastic / o.by_hand[1], 1.0, 1e-9, "1", note));
                }
                let spent = |a: f64| f64::from(u8::from(a > 0.0));
                checks.push(Check::new(
                    NAME,
                    of("bonds slide"),
                    spent(bolted[0].friction),
                    1.0,
                    0.0,
                    "1",
                    "J > 0",
                ));
                checks.push(Check::new(
                    NAME,
                    of("bars yield"),
                    spent(bolted[0].plastic),
                    1.0,
                    0.0,
                    "1",
                    "J > 0",
                ));
                let note = "for information: over the same with half the step";
                for (what, value) in [
                    ("friction_coefficient", bolted[0].friction / bolted[1].friction),
                    ("plastic work", bolted[0].plastic / bolted[1].plastic),
                ] {
                    checks.push(Check::beside(
                        NAME,
                        of(&format!("{what} over that with half the step")),
                        value,
                        1.0,
                        "1",
                        note,
                    ));
                }
            }
        }
    }
    let (steps, dt) = whole_steps(PULSE[2], 0.9 * bare);
    let along = [0.48, 0.36, 0.8];
    let plain = rows(kind(Some(WEAK), YIELDS), along, steps, dt, 1.0)?;
    let mut mirrored = kind(Some(WEAK), YIELDS);
    let width = f64::from(ACROSS);
    mirrored.bars.iter_mut().flat_map(|bar| &mut bar.points).for_each(|x| x[0] = width - x[0]);
    let mirrored = rows(mirrored, [-along[0], along[1], along[2]], steps, dt, -1.0)?;
    let (mut apart, mut peak) = (0.0_f64, 0.0_f64);
    for (&[x, y, z], one) in &plain {
        let Some(other) = mirrored.get(&[i64::from(ACROSS) - x, y, z]) else {
            return Err(VerifyError::Setup("the mirror image has other nodes".into()));
        };
        for (a, b) in one.iter().zip(other) {
            peak = peak.max(a.abs());
            apart = if (a - b).abs() <= apart { apart } else { (a - b).abs() };
        }
    }
    let note = "1e-10: round-off, with which bonds slide a little earlier or later";
    checks.push(Check::new(
        NAME,
        "difference from the mirror image over the peak",
        apart / peak,
        0.0,
        1e-10,
        "1",
        note,
    ));
    Ok(checks)
}

/// Displacements over all rows by the place of the node, x counted along `sense`.
fn rows(
    kind: Bolts,
    along: [f64; 3],
    steps: u64,
    dt: f64,
    sense: f64,
) -> Result<BTreeMap<[i64; 3], Vec<f64>>, VerifyError> {
    let simulation = Simulation::on_one_level(problem(Some(kind), along)?)?;
    let mut rows: BTreeMap<[i64; 3], Vec<f64>> = BTreeMap::new();
    simulation.run_from_rest(dt, steps, |state| {
        if state.step.is_multiple_of(10) {
            for n in simulation.model.nodes.of(Domain::Model) {
                let [x, y, z] = state.u[n].xyz();
                let place = simulation.position(n).map(|x| x.round() as i64);
                rows.entry(place).or_default().extend([sense * x, y, z]);
            }
        }
    })?;
    Ok(rows)
}
