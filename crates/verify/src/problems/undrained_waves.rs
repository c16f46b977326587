//! P waves in rock whose water cannot leave its pores.
//!
//! **Exact.** K_u = K + α²M, so c_p,u = √((λ + α²M + 2G)/ρ) and c_s as without (`biot1941`, `detournay1993`). With grains of 45 GPa and 1 % of pores
//! α is 0.852 and M 43.0 GPa: 3,962 m/s instead of 2,088. A boundary that goes by the drained speed sends (Z_u − Z_d)/(Z_u + Z_d), 31 %, of a P wave
//! back. Here one row of elements above the base has no pressure when the shaking begins, and so neither water in its dashpots: as thick as
//! it is, it fits these, so that what comes back comes from its upper face and is just that.
//!
//! **Step.** A wave of twice the speed wants half the step: at 0.9 of the drained step noise of round-off doubles in every step and more.

use crate::convergence::order;
use crate::models::{QUADRATURES, Solid, column};
use crate::simulation::{Simulation, whole_steps};
use crate::{Check, Effort, Verification, VerifyError};
use std::collections::BTreeMap;
use tremolite::hexahedra::centroid;
use tremolite::water::Spell;
use tremolite::{Base, Incident, Problem, Quadrature, Side, Stage, Water};
use tremolite_mesh::boxes::BoxSpec;
use tremolite_motion::{Motion, ricker_velocity};

const NAME: &str = "undrained_waves";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "undrained P waves: speed, absorbed by a base that knows of the water, and the step that they want",
    source: "`biot1941`, `detournay1993`, d'Alembert's solution, `lysmer1969`",
    from: Effort::Test,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2752.0 };
/// Bulk modulus of grains and of water \[Pa\], and porosity.
const GRAINS: f64 = 45e9;
const WATER: f64 = 2.2e9;
const POROSITY: f64 = 0.01;
/// Pressure at the start \[Pa\].
const PRESSURE: f64 = 2e6;
/// m
const HEIGHT: f64 = 200.0;
/// Peak velocity \[m/s\].
const PEAK: f64 = 0.05;

/// α, M \[Pa\] and c_p,u \[m/s\].
fn rock() -> [f64; 3] {
    let moduli = ROCK.moduli();
    let bulk = moduli.lambda + 2.0 / 3.0 * moduli.mu;
    let alpha = 1.0 - bulk / GRAINS;
    let modulus = 1.0 / (POROSITY / WATER + (alpha - POROSITY) / GRAINS);
    let stiffness = moduli.lambda + 2.0 * moduli.mu + alpha * alpha * modulus;
    [alpha, modulus, (stiffness / ROCK.density).sqrt()]
}

/// A column of rock under the pressure of its water; without a modulus it is drained. `dry` says of which layers it is not there.
fn problem(quadrature: Quadrature, layers: u32, modulus: f64, dry: impl Fn(u32) -> bool) -> Result<Problem, VerifyError> {
    let h = HEIGHT / f64::from(layers);
    let mut problem = ROCK.fill(column(h, layers, 1)?, quadrature);
    let count = problem.mesh.elements.len();
    let p: Vec<f64> = (0..layers).map(|k| if dry(k) { 0.0 } else { PRESSURE }).collect();
    problem.initial = p.iter().map(|p| [-p, -p, -p, 0.0, 0.0, 0.0]).collect();
    let nodes = vec![PRESSURE; problem.mesh.nodes.len()];
    problem.water = Water {
        biot: vec![rock()[0]; count],
        modulus: vec![modulus; count],
        spells: vec![Spell { from: Stage::Before(0), elements: p, nodes }],
    };
    problem.sides = [Side::Periodic; 2];
    problem.base = Base::Viscous;
    Ok(problem)
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let [_, modulus, speed] = rock();
    let mut checks = Vec::new();
    let exact = HEIGHT / speed;
    for (quadrature, word) in QUADRATURES {
        let [coarse, fine] = [40, 80].map(|layers| rise(quadrature, layers));
        let (coarse, fine) = (coarse?, fine?);
        let note = "1 %: the pulse's leading error of dispersion at 80 elements a wavelength is a fifth of that";
        let quantity = format!("error of the surface's displacement over the incident peak, {word}");
        let p = order(coarse.error, fine.error, 2.0);
        checks.push(Check::new(NAME, quantity, fine.error, 0.0, 0.01, "1", note).with_order(p));
        let quantity = format!("order of the surface's displacement, {word}");
        checks.push(Check::new(NAME, quantity, p, 2.0, 0.2, "1", "order 2 in h, Δt ∝ h").with_order(p));
        let quantity = format!("time of 200 m, {word}");
        let note = "a step: the peak is found at steps; drained it would be 95.8 ms";
        checks.push(Check::new(NAME, quantity, fine.travel, exact, fine.dt, "s", note));
        let quantity = format!("velocity left behind over the incident peak, {word}");
        let note = "0.5 %: the base reflects (kh)²/16 of a wave, less than that at three times the peak frequency";
        checks.push(Check::new(NAME, quantity, fine.late, 0.0, 0.005, "1", note));
    }
    for (word, modulus) in [("below the water", modulus), ("drained", 0.0)] {
        let apart = level(modulus)?;
        let note = "1e-12: round-off, all nodes of a level see the same forces";
        let quantity = format!("how far nodes of one level are apart over the peak, free-field sides, layers {word}");
        checks.push(Check::new(NAME, quantity, apart, 0.0, 1e-12, "1", note));
    }
    let drained = ROCK.speeds().0;
    let share = (speed - drained) / (speed + drained);
    for (dry, reference, tolerance, what) in [(false, 0.0, 0.005, "that knows of the water"), (true, share, 0.01 * share, "without")] {
        let sent_back = fall(dry)?;
        let note = "0.5 % of the wave; 1 % of what comes back: (kh)²/24 of dispersion, 80 elements a wavelength";
        let quantity = format!("share of a P wave that comes back from a base {what}");
        checks.push(Check::new(NAME, quantity, sent_back, reference, tolerance, "1", note));
    }
    let steps = [0.0, modulus].map(|modulus| {
        let simulation = Simulation::on_one_level(problem(Quadrature::OnePoint, 40, modulus, |_| false)?)?;
        Ok::<f64, VerifyError>(simulation.stable())
    });
    let [drained, undrained] = steps;
    let (drained, undrained) = (drained?, undrained?);
    for (dt, word, reference) in [(undrained, "undrained", 0.0), (drained, "drained", 1.0)] {
        let simulation = Simulation::on_one_level(problem(Quadrature::OnePoint, 40, modulus, |_| false)?)?;
        let mut engine = simulation.engine();
        let mut state = simulation.start(&mut engine, 0.9 * dt, |n| {
            [[0.0; 3], [0.0, 0.0, 1e-6 * (n as f64 * 12.9898).sin()]]
        });
        for _ in 0..400 {
            engine.step(&mut state);
        }
        let fastest = state.du.iter().map(|du| du.0[2].abs() / state.dt).fold(0.0, |a, b| if b <= a { a } else { b });
        let runs_away = f64::from(u8::from(fastest >= 1e-4 || fastest.is_nan()));
        let quantity = format!("whether 400 steps of 0.9 of the {word} step run away (1)");
        checks.push(Check::new(NAME, quantity, runs_away, reference, 0.0, "1", "a hundred times the velocity that it began with"));
    }
    // Of a column of cubes the highest mode is that of compression along it.
    let note = "3 %: other modes of a cube than that of the P wave take part in its highest";
    checks.push(Check::new(NAME, "undrained step over the drained one", undrained / drained, 2088.172673961392 / speed, 0.03, "1", note));
    Ok(checks)
}

/// Two layers, the water level in the upper one, under a wave of all three components between free-field sides: largest distance of nodes of
/// one level from one another, those of slabs and columns included, over the peak.
fn level(modulus: f64) -> Result<f64, VerifyError> {
    let mesh = BoxSpec::uniform([0.0; 3], [20.0, 15.0, 40.0], [4, 3, 8]).mesh()?;
    let (soft, hard): (Vec<u32>, Vec<u32>) =
        (0..mesh.elements.len() as u32).partition(|&e| centroid(&mesh, e)[2] > 20.0);
    let upper = Solid { young: 1e9, poisson: 0.3, density: 2100.0 };
    let bodies =
        vec![upper.body("soft", soft, Quadrature::Full), ROCK.body("hard", hard, Quadrature::OnePoint)];
    let mut problem = Problem::new(mesh, bodies);
    let p = |z: f64| 9810.0 * (30.0 - z).max(0.0);
    let count = problem.mesh.elements.len();
    let elements: Vec<f64> = (0..count as u32).map(|e| p(centroid(&problem.mesh, e)[2])).collect();
    problem.initial = elements.iter().map(|p| [-p, -p, -p, 0.0, 0.0, 0.0]).collect();
    let nodes = problem.mesh.nodes.iter().map(|x| p(x[2])).collect();
    problem.water = Water {
        biot: vec![rock()[0]; count],
        modulus: vec![modulus; count],
        spells: vec![Spell { from: Stage::Before(0), elements, nodes }],
    };
    problem.sides = [Side::FreeField; 2];
    problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(20.0) };
    let pulse = ricker_velocity(30.0, 0.05, PEAK);
    let motion = Motion::sampled(2e-4, 0.15, |t| pulse(t).along([0.6, 0.3, 0.74]))?;
    problem.incident = Some(Incident { motion, factor: 1.0 });
    let simulation = Simulation::on_one_level(problem)?;
    let (steps, dt) = whole_steps(0.15, 0.9 * simulation.stable());
    let (mut apart, mut peak) = (0.0_f64, 0.0_f64);
    simulation.run_from_rest(dt, steps, |state| {
        let mut first: BTreeMap<i64, [f64; 3]> = BTreeMap::new();
        for n in 0..state.u.len() {
            let (u, z) = (state.u[n].xyz(), (1e3 * simulation.position(n)[2]).round() as i64);
            let other = first.entry(z).or_insert(u);
            for i in 0..3 {
                let d = (u[i] - other[i]).abs();
                apart = if d <= apart { apart } else { d };
                peak = peak.max(u[i].abs());
            }
        }
    })?;
    Ok(apart / peak)
}

struct Risen {
    /// Largest error of the surface's displacement over the incident peak.
    error: f64,
    /// Time between the peaks of velocity of the incident wave at the base and at the surface \[s\], and the step.
    travel: f64,
    dt: f64,
    /// Largest velocity after all has passed, over the incident peak.
    late: f64,
}

/// A pulse as long as the column is high rises through it and leaves.
fn rise(quadrature: Quadrature, layers: u32) -> Result<Risen, VerifyError> {
    let [_, modulus, speed] = rock();
    let frequency = speed / HEIGHT;
    let centre = 1.5 / frequency;
    let pulse = ricker_velocity(frequency, centre, PEAK);
    let passed = centre + 2.0 * HEIGHT / speed + 1.5 / frequency;
    let end = passed + 1.0 / frequency;
    let mut problem = problem(quadrature, layers, modulus, |_| false)?;
    let motion = Motion::sampled(0.002 / frequency, end, |t| pulse(t).along([0.0, 0.0, 1.0]))?;
    problem.incident = Some(Incident { motion, factor: 1.0 });
    let simulation = Simulation::new(problem)?;
    let (steps, dt) = whole_steps(end, 0.9 * simulation.stable());
    let [top, base] = [simulation.node([0.0, 0.0, HEIGHT])?, simulation.node([0.0; 3])?];
    let (mut error, mut late, mut largest, mut peak) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
    let mut fastest = (0.0, 0.0);
    simulation.run_from_rest(dt, steps, |state| {
        let incident = pulse(state.time() - HEIGHT / speed);
        peak = peak.max(incident.u.abs());
        error = error.max((state.u[top].0[2] - 2.0 * incident.u).abs());
        let ([.., v], half) = simulation.velocity(state, top);
        if v > largest {
            (largest, fastest) = (v, (half, v));
        }
        if half > passed {
            let [.., below] = simulation.velocity(state, base).0;
            late = late.max(v.abs()).max(below.abs());
        }
    })?;
    Ok(Risen { error: error / peak, travel: fastest.0 - centre, dt, late: late / PEAK })
}

/// The share of a pulse that runs down, begun in the middle, that comes back there; with a dry row above the base or without.
fn fall(dry: bool) -> Result<f64, VerifyError> {
    let [_, modulus, speed] = rock();
    let problem = problem(Quadrature::OnePoint, 160, modulus, |layer| dry && layer == 0)?;
    let simulation = Simulation::on_one_level(problem)?;
    let mut engine = simulation.engine();
    // u = f(z + ct), a bell of which nothing reaches an end.
    let width = 0.05 * HEIGHT;
    let bell = |x: f64| PEAK * width / speed * (-(x / width).powi(2)).exp();
    let (steps, dt) = whole_steps(HEIGHT / speed, 0.9 * simulation.stable());
    let mut state = simulation.start(&mut engine, dt, |n| {
        let x = simulation.position(n)[2] - 0.5 * HEIGHT;
        [[0.0, 0.0, bell(x)], [0.0, 0.0, -2.0 * x * speed / width.powi(2) * bell(x)]]
    });
    for _ in 0..steps {
        engine.step(&mut state);
    }
    let most = (0..state.u.len()).map(|n| state.u[n].0[2].abs()).fold(0.0, f64::max);
    Ok(most / bell(0.0))
}
