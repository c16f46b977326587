//! Energy over many impacts, and over a cycle of slip.
//!
//! **Bounces.** Rigid blocks of one mass fall on a joint without a bond, slide along it, leave it, and come back: 100 times.
//! Explicit steps find the joint somewhere within a step. Where a block comes in with the velocity v, is x₀ above the joint
//! before a step and x₁ below it after, the trapezoidal rule takes ½k x₁x₀ too much; where it leaves, too little. With x₁ = fvΔt
//! that is f(1 − f) (ω_cΔt)² of its energy, a quarter of (ω_cΔt)² at most; over many impacts such errors mostly cancel. Blocks
//! start at different heights, under different weights. Undamped, their energies keep, root mean square, within what one impact
//! may do. With the default dashpots and step (1 % of critical, ω_cΔt = 0.8) they lose energy on the whole under each weight. One
//! that comes back in step with Δt may gain at each impact for a while: that is shown for information.
//!
//! **Cycle of slip.** Where the tangential stiffness follows the closure, slip out under the pressure p₁ and back under p₂ gives
//! out ½t²(1/k_t2 − 1/k_t1) per area, as the spring that holds t is softer on the way back. Forces that change slowly do this to
//! a block, with damping in proportion to mass; the line `created_by_interface` must hold just that, and the loads get it less
//! what damping takes.

use crate::convergence::order;
use crate::joints::{joint, together};
use crate::models::Solid;
use crate::simulation::{Simulation, whole_steps};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::PI;
use std::sync::Arc;
use tremolite::parts::loads::Load;
use tremolite::{Interface, Line, Lines, Quadrature, Rayleigh};
use tremolite_mesh::Mesh;
use tremolite_mesh::boxes::BoxSpec;

const NAME: &str = "contact_cycles";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "energy of a hundred impacts, undamped and with the defaults; a cycle of slip that gives out energy",
    source: "the trapezoidal rule's error at an impact, derived in the problem",
    from: Effort::Verify,
    run,
};

/// Accelerations by weight \[m/s²\]: flights as long as contacts, and up to four times as long.
const WEIGHTS: [f64; 5] = [5.0, 8.0, 9.81, 12.0, 20.0];
const BLOCK: Solid = Solid { young: 1e9, poisson: 0.0, density: 2500.0 };
/// Mass of a block \[kg\].
const MASS: f64 = 2500.0;

/// A law with its numbers and words.
type Spring = (&'static str, &'static [(&'static str, f64)], &'static [(&'static str, &'static str)]);

/// k_n or k_n0 \[Pa/m\], and T \[m\].
const STIFFNESS: f64 = 1e9;
const CLOSURE: f64 = 1e-3;
const LINEAR: Spring = ("coulomb", &[("normal_stiffness", STIFFNESS), ("friction_coefficient", 0.05)], &[]);
const CURVED: Spring = (
    "bandis",
    &[("normal_stiffness", STIFFNESS), ("max_closure", CLOSURE), ("closure_floor", 0.9), ("friction_coefficient", 0.05)],
    &[("tangential", "constant")],
);
const FOLLOWING: Spring =
    ("bandis", &[("normal_stiffness", STIFFNESS), ("max_closure", CLOSURE), ("friction_coefficient", 2.0)], &[]);

/// Cubes of 1 m, each of whose nodes move as one, on held ones; the first node of each.
fn blocks(count: u32, law: Spring, damping: Option<f64>) -> Result<(tremolite::Problem, Vec<u32>), VerifyError> {
    let mut mesh = Mesh::default();
    for low in [-1.0, 0.0] {
        for k in 0..count {
            let x = 2.0 * f64::from(k);
            mesh = together(&mesh, &BoxSpec::uniform([x, 0.0, low], [x + 1.0, 1.0, low + 1.0], [1; 3]).mesh()?);
        }
    }
    let mut problem = BLOCK.fill(mesh, Quadrature::OnePoint);
    let firsts: Vec<u32> = (0..count).map(|k| 8 * (count + k)).collect();
    problem.held = (0..8 * count).map(|n| (n, [true; 3])).collect();
    problem.ties = firsts.iter().flat_map(|&n| (1..8).map(move |k| (n, n + k))).collect();
    let mut interface = joint([(0..count).collect(), (count..2 * count).collect()], law.0, law.1, law.2)?;
    interface.damping = damping.unwrap_or(interface.damping);
    problem.interfaces = vec![interface];
    Ok((problem, firsts))
}

/// Speeds at the start \[m/s\], into the joint and along it: friction takes 1 m/s in 100 impacts.
const SPEED: f64 = 0.05;
const ALONG: f64 = 2.0;
/// Of each weight.
const STARTS: u32 = 20;
const BLOCKS: u32 = STARTS * WEIGHTS.len() as u32;
const BOUNCES: u32 = 100;

/// Energy of each block's motion normal to the joint over that at the start, less 1, once it has left it `bounces` times.
fn bounce(law: Spring, step: f64, damping: Option<f64>, bounces: u32) -> Result<Vec<f64>, VerifyError> {
    let weight = |k: usize| WEIGHTS[k % WEIGHTS.len()];
    let (mut problem, firsts) = blocks(BLOCKS, law, damping)?;
    let weights = firsts.iter().enumerate().map(|(k, &n)| (n, [0.0, 0.0, -weight(k) * MASS])).collect();
    problem.loads = vec![Load { forces: weights, factor: Arc::new(|_| 1.0) }];
    let simulation = Simulation::on_one_level(problem)?;
    let nodes: Vec<usize> = firsts.iter().map(|&n| simulation.model.engine_node[n as usize] as usize).collect();
    let dt = step / simulation.assembly.contacts[0].frequency;
    let mut engine = simulation.engine();
    let height = |start: usize| SPEED * dt * (0.1 + (start / WEIGHTS.len()) as f64 / f64::from(STARTS));
    let mut state = simulation.start(&mut engine, dt, |node| {
        let block = simulation.model.mesh_node[node] as usize / 8;
        match block.checked_sub(BLOCKS as usize) {
            Some(k) => [[0.0, 0.0, height(k)], [ALONG, 0.0, -SPEED]],
            None => [[0.0; 3]; 2],
        }
    });
    // Between two steps above the joint a parabola is exact.
    let energy = |g: f64, z: f64, half: f64| 0.5 * (half - 0.5 * g * dt).powi(2) + g * z;
    let mut left = vec![(0, false, f64::NAN); nodes.len()];
    // Blocks that come to rest leave no more.
    let most = (f64::from(bounces) * (PI + 2.0 * SPEED / WEIGHTS[0] * (STIFFNESS / MASS).sqrt()) / step * 2.0) as u64;
    while left.iter().any(|&(count, ..)| count < bounces) && state.steps() < most {
        engine.step(&mut state);
        for (k, ((count, closed, found), &node)) in left.iter_mut().zip(&nodes).enumerate() {
            let (z, dz) = (state.u[node].0[2], state.du[node].0[2]);
            if *closed && z > 0.0 {
                *count += 1;
            }
            *closed = z <= 0.0;
            if z > 0.0 && *count <= bounces {
                let first = 0.5 * SPEED * SPEED + weight(k) * height(k);
                *found = energy(weight(k), z, dz / dt) / first - 1.0;
            }
        }
    }
    Ok(left.into_iter().map(|(.., found)| found).collect())
}

fn rms(x: &[f64]) -> f64 {
    (x.iter().map(|x| x * x).sum::<f64>() / x.len() as f64).sqrt()
}

fn extremes(x: &[f64]) -> [f64; 2] {
    [f64::max, f64::min].map(|of| x.iter().copied().fold(x[0], of))
}

/// What a slip out under one pressure and back under another comes to.
struct Cycle {
    /// Books at the end \[J\], and the part of their error that is the scheme's.
    lines: Lines,
    scheme: f64,
}

/// Pressures and shear of the cycle \[Pa\], on 1 m².
const PRESSURES: [f64; 2] = [1e6, 0.25e6];
const SHEAR: f64 = 0.2e6;

/// From `from` to `to` while s goes from 0 to 1, smoothly.
fn ramp(from: f64, to: f64, s: f64) -> f64 {
    from + (to - from) * (0.5 - 0.5 * (PI * s.clamp(0.0, 1.0)).cos())
}

/// Pressed to p₁, sheared, eased to p₂, let back, and eased.
fn cycle() -> Result<Cycle, VerifyError> {
    let (mut problem, firsts) = blocks(1, FOLLOWING, None)?;
    // 40 periods of the softest spring, 500 rad/s, which is critically damped.
    let stage = 0.5;
    problem.rayleigh = Rayleigh { mass: 1000.0, stiffness: 0.0 };
    let [p1, p2] = PRESSURES;
    let pressed = move |t: f64| ramp(0.0, p1, t / stage) + ramp(0.0, p2 - p1, t / stage - 2.0) + ramp(0.0, -p2, t / stage - 4.0);
    let sheared = move |t: f64| ramp(0.0, SHEAR, t / stage - 1.0) + ramp(0.0, -SHEAR, t / stage - 3.0);
    problem.loads = vec![
        Load { forces: vec![(firsts[0], [0.0, 0.0, -1.0])], factor: Arc::new(pressed) },
        Load { forces: vec![(firsts[0], [1.0, 0.0, 0.0])], factor: Arc::new(sheared) },
    ];
    let simulation = Simulation::new(problem)?;
    let (steps, dt) = whole_steps(5.2 * stage, 0.8 / simulation.assembly.contacts[0].frequency);
    let snapshot = simulation.run_from_rest(dt, steps, |_| {})?;
    Ok(Cycle { lines: snapshot.balance, scheme: snapshot.scheme })
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for law in [LINEAR, CURVED] {
        let of = |what: &str, step: f64| format!("{what}, ω_cΔt = {step}, {}", law.0);
        let name = "change of energy over 100 impacts, undamped, rms";
        let coarse = bounce(law, 0.2, Some(0.0), BOUNCES)?;
        let note = "1 %: (ω_cΔt)²/4, the largest error of one impact";
        checks.push(Check::new(NAME, of(name, 0.2), rms(&coarse), 0.0, 0.01, "1", note));
        let fine = bounce(law, 0.1, Some(0.0), BOUNCES)?;
        let note = "0.5 %: half of that at 0.2; one impact's error is a quarter, what is left of many goes by chance";
        let check = Check::new(NAME, of(name, 0.1), rms(&fine), 0.0, 0.005, "1", note);
        checks.push(check.with_order(order(rms(&coarse), rms(&fine), 2.0)));
        let wide = bounce(law, 0.5, Some(0.0), BOUNCES)?;
        for (step, changes) in [(0.2, coarse), (0.5, wide)] {
            let note = "for information: of 20 starts under each of five weights";
            for (k, which) in ["largest", "smallest"].into_iter().enumerate() {
                let quantity = of(&format!("{which} change of energy over 100 impacts, undamped"), step);
                checks.push(Check::beside(NAME, quantity, extremes(&changes)[k], 0.0, "1", note));
            }
        }
        for impacts in [5, 20] {
            let changes = bounce(law, Interface::LIMIT, None, impacts)?;
            let of = |what: &str| of(&format!("{what} over {impacts} impacts, default damping"), Interface::LIMIT);
            let mean = |weight: usize| {
                let own = changes.iter().skip(weight).step_by(WEIGHTS.len());
                own.sum::<f64>() / f64::from(STARTS)
            };
            let worst = (0..WEIGHTS.len()).map(mean).fold(-1.0, f64::max);
            let note = "between −1 and 0: they lose energy on the whole";
            let quantity = of("mean change of energy of 20 starts, under the weight where it is largest,");
            checks.push(Check::new(NAME, quantity, worst, -0.5, 0.5, "1", note));
            let note = "for information: in step with Δt a block may gain for a while";
            checks.push(Check::beside(NAME, of("largest change of energy"), extremes(&changes)[0], 0.0, "1", note));
        }
    }

    let Cycle { lines, scheme } = cycle()?;
    // k_n = k_n0 (1 + p/(k_n0 T))² on the hyperbola; k_t = k_n/2.5.
    let shear_stiffness = PRESSURES.map(|p| STIFFNESS * (1.0 + p / (STIFFNESS * CLOSURE)).powi(2) / 2.5);
    let exact = 0.5 * SHEAR * SHEAR * (1.0 / shear_stiffness[1] - 1.0 / shear_stiffness[0]);
    let created = lines[Line::CreatedByInterface];
    let note = "0.1 %: forces change over 40 periods of the softest spring";
    checks.push(Check::new(NAME, "created by a cycle of slip", created, exact, 1e-3 * exact, "J", note));
    let damped = lines[Line::Rayleigh] + lines[Line::ContactDamping];
    let gained = -lines[Line::Input] + damped;
    let note = "0.1 %: as the line";
    checks.push(Check::new(NAME, "got from a cycle of slip by loads and damping", gained, exact, 1e-3 * exact, "J", note));
    let quantity = "error of the balance over what a cycle of slip created";
    let note = "1e-3: the trapezoidal rule along the hyperbola, (Δg/T)² a step";
    checks.push(Check::new(NAME, quantity, (lines[Line::Error] - scheme) / exact, 0.0, 1e-3, "1", note));
    Ok(checks)
}
