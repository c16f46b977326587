//! The step against the equations of the method as they are written.
//!
//! The engine runs a leapfrog that is meant to be (20), (21) and (25)–(27) of Wang et al. (2018) in other words:
//!
//! (20) u^{n+1} = u^n + Δt v^n + ½Δt² a^n − ½Δt M⁻¹C (2Δt v^n − u^n + u^{n−1}),  a^n = M⁻¹(F^n − K u^n),
//! (21) v^{n+1} = (u^{n+1} − u^n)/Δt + ½Δt M⁻¹(F^{n+1} − K u^{n+1}) − ½ M⁻¹C (u^{n+1} − u^n),
//! (25)–(27) u⁰ = v⁰ = 0, u^{−1} = ½Δt² a⁰.
//!
//! Both run side by side on a small distorted block with both of Rayleigh's terms, under random forces that grow from
//! zero (the start takes v⁰ = 0, which (21) gives only if a⁰ = 0). They must agree to round-off.
//!
//! Dashpots of base and sides, D, are not in the C of (20): they act on ½(u^{n+1} − u^{n−1})/Δt, which a lumped matrix
//! allows at no cost. In (20) a node with ½ΔtM⁻¹D = κ moves as if its mass were M/(1 − κ), and κ = cΔt/h is near 1 at
//! the edge of any mesh at its stable step: an absorbing boundary would reflect with order 1 in h. So with dashpots
//! the literal scheme is
//! u^{n+1} − 2u^n + u^{n−1} = Δt² (a^n − M⁻¹C v^n) − ½Δt M⁻¹D (u^{n+1} − u^{n−1}),
//! (M + ½ΔtD) (v^{n+1} − (u^{n+1} − u^n)/Δt) = ½Δt M a^{n+1} − ½(C + D)(u^{n+1} − u^n),
//! which is (20) and (21) for D = 0. C and D together are not proportional.
//!
//! The paper prints K u^n in (21). With it the matrix of one undamped step of a mode, from (u, v) to the next, is
//! \[1 − ½s, Δt; −Δtω², 1\], s = (ωΔt)²: its determinant is 1 + ½s, so the motion grows by √(1 + ½s) a step, 1.0025
//! at ωΔt = 0.1. With K u^{n+1} the determinant is 1.

use crate::convergence::Oscillation;
use crate::dense::{Dense, dot};
use crate::models::{QUADRATURES, Solid, distorted};
use crate::simulation::Simulation;
use crate::stiffness::Assembled;
use crate::{Check, Effort, Verification, VerifyError};
use std::sync::Arc;
use tremolite::parts::loads::Load;
use tremolite::{Base, Quadrature, Rayleigh, Side};

const NAME: &str = "scheme_literal";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "the step equals (20), (21), (25)-(27) as written; the print's K u^n grows",
    source: "wang2018 (20)-(27), with K u^{n+1} in (21) and the dashpots on the mean velocity",
    from: Effort::Test,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };

/// What damps the block.
#[derive(Clone, Copy, PartialEq)]
enum Damping {
    None,
    Rayleigh,
    /// Rayleigh's, and dashpots on the base and the sides normal to x.
    Dashpots,
}

/// A block of 2 × 2 × 2 distorted elements; undamped, it stands on a fixed base and is not loaded.
fn block(quadrature: Quadrature, damping: Damping) -> Result<Simulation, VerifyError> {
    let mut problem = ROCK.fill(distorted([2.0, 2.2, 1.8], [2; 3], 0.15)?, quadrature);
    match damping {
        Damping::None => problem.base = Base::Fixed,
        Damping::Rayleigh | Damping::Dashpots => {
            problem.rayleigh = Rayleigh { mass: 50.0, stiffness: 2e-5 };
            problem.loads = vec![random_load(problem.mesh.nodes.len() as u32)];
        }
    }
    if damping == Damping::Dashpots {
        problem.base = Base::Viscous;
        problem.sides = [Side::Viscous, Side::Free];
    }
    Simulation::on_one_level(problem)
}

/// Forces without symmetry.
fn random_load(nodes: u32) -> Load {
    let at = |n: u32, i: u32| 1e6 * f64::from(17 * n * n + 5 * n + 11 * i).sin();
    let forces = (0..nodes).map(|n| (n, [at(n, 0), at(n, 1), at(n, 2)])).collect();
    Load { forces, factor: Arc::new(|t: f64| (900.0 * t).sin() + 0.3 * (2100.0 * t).sin()) }
}

/// The scheme as it is written, on dense matrices.
struct Literal<'a> {
    dt: f64,
    system: &'a Assembled,
    rayleigh: Rayleigh,
    /// M + ½ΔtD
    heavy: Dense,
    force: Vec<f64>,
    factor: Arc<dyn Fn(f64) -> f64 + Send + Sync>,
    /// Whether (21) takes K u^n, as it is printed.
    printed: bool,
}

/// u^{n−1}, u^n, v^n
struct Three {
    before: Vec<f64>,
    u: Vec<f64>,
    v: Vec<f64>,
}

impl<'a> Literal<'a> {
    fn new(system: &'a Assembled, dt: f64, rayleigh: Rayleigh) -> Self {
        let n = system.mass.len();
        let mut heavy = Dense::zero(n);
        for i in 0..n {
            for j in 0..n {
                let mass = if i == j { system.mass[i] } else { 0.0 };
                heavy.set(i, j, mass + 0.5 * dt * system.dashpots.at(i, j));
            }
        }
        let factor = Arc::new(|_: f64| 0.0);
        Literal { dt, system, rayleigh, heavy, force: vec![0.0; n], factor, printed: false }
    }

    /// C x, Rayleigh's.
    fn damping_times(&self, x: &[f64]) -> Vec<f64> {
        let k = self.system.stiffness.times(x);
        let Rayleigh { mass, stiffness } = self.rayleigh;
        (0..x.len()).map(|i| mass * self.system.mass[i] * x[i] + stiffness * k[i]).collect()
    }

    /// F − K u at a time.
    fn pull(&self, t: f64, u: &[f64]) -> Vec<f64> {
        let (k, f) = (self.system.stiffness.times(u), (self.factor)(t));
        (0..u.len()).map(|i| f * self.force[i] - k[i]).collect()
    }

    /// (20) and (21), without dashpots.
    fn step(&self, n: u64, s: Three) -> Three {
        let (dt, m) = (self.dt, &self.system.mass);
        let t = n as f64 * dt;
        let pull = self.pull(t, &s.u);
        let lag: Vec<f64> = (0..m.len()).map(|i| 2.0 * dt * s.v[i] - s.u[i] + s.before[i]).collect();
        let c = self.damping_times(&lag);
        let next: Vec<f64> = (0..m.len())
            .map(|i| s.u[i] + dt * s.v[i] + (0.5 * dt * dt * pull[i] - 0.5 * dt * c[i]) / m[i])
            .collect();
        let increment: Vec<f64> = (0..m.len()).map(|i| next[i] - s.u[i]).collect();
        let ahead = self.pull(t + dt, if self.printed { &s.u } else { &next });
        let c = self.damping_times(&increment);
        let v = (0..m.len()).map(|i| increment[i] / dt + (0.5 * dt * ahead[i] - 0.5 * c[i]) / m[i]).collect();
        Three { before: s.u, u: next, v }
    }

    /// The two equations of the module's text, with dashpots.
    fn step_with_dashpots(&self, n: u64, s: Three) -> Result<Three, VerifyError> {
        let (dt, m) = (self.dt, &self.system.mass);
        let t = n as f64 * dt;
        let (pull, c) = (self.pull(t, &s.u), self.damping_times(&s.v));
        let d = self.system.dashpots.times(&s.before);
        let right: Vec<f64> = (0..m.len())
            .map(|i| m[i] * (2.0 * s.u[i] - s.before[i]) + dt * dt * (pull[i] - c[i]) + 0.5 * dt * d[i])
            .collect();
        let next = self.heavy.solve(&right)?;
        let increment: Vec<f64> = (0..m.len()).map(|i| next[i] - s.u[i]).collect();
        let (ahead, c) = (self.pull(t + dt, &next), self.damping_times(&increment));
        let d = self.system.dashpots.times(&increment);
        let right: Vec<f64> = (0..m.len()).map(|i| 0.5 * (dt * ahead[i] - c[i] - d[i])).collect();
        let gain = self.heavy.solve(&right)?;
        let v = (0..m.len()).map(|i| increment[i] / dt + gain[i]).collect();
        Ok(Three { before: s.u, u: next, v })
    }
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for (quadrature, word) in QUADRATURES {
        for (damping, which) in
            [(Damping::Rayleigh, "Rayleigh"), (Damping::Dashpots, "Rayleigh and dashpots")]
        {
            let differences = side_by_side(quadrature, damping)?;
            let note =
                "round-off of 500 steps, each summing 100 products in another order: 500 × 100 × 1.1e-16";
            for (what, difference) in ["displacement", "velocity"].into_iter().zip(differences) {
                let quantity =
                    format!("{what}: engine less literal scheme, over its largest; {which}, {word}");
                checks.push(Check::new(NAME, quantity, difference, 0.0, 6e-12, "1", note));
            }
        }
    }
    checks.extend(print_grows()?);
    Ok(checks)
}

/// Largest differences of displacement and velocity over 500 steps, relative to the largest of each.
fn side_by_side(quadrature: Quadrature, damping: Damping) -> Result<[f64; 2], VerifyError> {
    let simulation = block(quadrature, damping)?;
    let system = Assembled::new(&simulation);
    let dt = 0.9 * simulation.stable();
    let load = &simulation.model.loading.loads[0];
    let mut literal = Literal::new(&system, dt, simulation.model.scheme.rayleigh);
    literal.factor = load.factor.clone();
    for (k, &(node, i)) in system.unknowns.iter().enumerate() {
        literal.force[k] = load.forces.iter().filter(|(n, _)| *n as usize == node).map(|(_, f)| f[i]).sum();
    }
    let zero = vec![0.0; system.mass.len()];
    let mut s = Three { before: zero.clone(), u: zero.clone(), v: zero };

    let mut engine = simulation.engine();
    let mut state = simulation.start(&mut engine, dt, |_| [[0.0; 3]; 2]);
    let (mut difference, mut largest) = ([0.0f64; 2], [0.0f64; 2]);
    for n in 0..500 {
        engine.step(&mut state);
        s = match damping {
            Damping::Dashpots => literal.step_with_dashpots(n, s)?,
            Damping::None | Damping::Rayleigh => literal.step(n, s),
        };
        let velocity = engine.look(&state).snapshot.velocity;
        let found = [system.gather(&state.u), system.gather(&velocity)];
        for (k, (found, exact)) in found.iter().zip([&s.u, &s.v]).enumerate() {
            for (x, y) in found.iter().zip(exact) {
                difference[k] = difference[k].max((x - y).abs());
                largest[k] = largest[k].max(y.abs());
            }
        }
    }
    Ok([difference[0] / largest[0], difference[1] / largest[1]])
}

/// Growth a step of one mode at ωΔt = 0.1, with (21) as printed and as corrected.
fn print_grows() -> Result<Vec<Check>, VerifyError> {
    let simulation = block(Quadrature::OnePoint, Damping::None)?;
    let system = Assembled::new(&simulation);
    let (lambda, shapes) = system.modes();
    let shape = &shapes.values[..system.mass.len()];
    let dt = 0.1 / lambda[0].sqrt();
    let growth = |printed: bool| {
        let mut literal = Literal::new(&system, dt, Rayleigh::default());
        literal.printed = printed;
        let mut s = Three { before: shape.to_vec(), u: shape.to_vec(), v: vec![0.0; shape.len()] };
        let mut q = Vec::new();
        for step in 0..400 {
            let weighted: Vec<f64> = s.u.iter().zip(&system.mass).map(|(u, m)| u * m).collect();
            q.push(dot(shape, &weighted));
            s = literal.step(step, s);
        }
        Oscillation::fit(&q).growth()
    };
    let note = "one mode obeys its recurrence exactly; what remains is round-off";
    let text = |which: &str| format!("growth a step at ωΔt = 0.1, (21) {which}");
    Ok(vec![
        Check::new(NAME, text("with K u^n as printed"), growth(true), 1.005f64.sqrt(), 1e-9, "1", note),
        Check::new(NAME, text("with K u^{n+1}"), growth(false), 1.0, 1e-9, "1", note),
    ])
}
