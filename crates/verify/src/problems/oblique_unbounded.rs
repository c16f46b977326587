//! How much of the errors of `oblique_waves` the mesh makes by itself: the same box without boundaries.
//!
//! In a mesh that goes on around the box, and whose nodes in the box are put the forces that the exact field lacks there to obey the scheme,
//! the exact field less the model's is what lumped masses, one-point elements and finite steps make of the wave on its way through the box,
//! and of its reflection at the surface. It runs away on all sides: no boundary drives it, and none is near. A boundary without any error
//! of its own would leave this. Boundaries that are driven by the exact field may leave less, since they pull a late wave on.
//!
//! Forces of nodes on a face of the box count half, on an edge a quarter, since as much of their elements is the box's.
//!
//! In full, SV at 55° along an axis of the mesh is tried with one thing unlike at a time, and its error is set beside that straight up: the lag of the mesh makes
//! 2.3 of it, a box whose sides are pulled less 2.8.

use super::oblique_waves::{ELEMENTS, GROUNDS, LARGE, POISSON, STEP, Way, error_of, field_in, outer, pulse};
use crate::convergence::order;
use crate::lattice::Lattice;
use crate::simulation::{Simulation, whole_steps};
use crate::{Check, Effort, Verification, VerifyError};
use std::collections::HashMap;
use std::sync::Arc;
use tremolite::free_field::GivenField;
use tremolite::waves::{LayeredGround, ObliqueField, Rock, Stratum, WaveType};
use tremolite::{Base, Problem, Quadrature, Side, State, Top};
use tremolite_laws::Row;
use tremolite_mesh::boxes::BoxSpec;

const NAME: &str = "oblique_unbounded";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "errors of oblique_waves that the mesh makes by itself: the same box without boundaries",
    source: "the exact field's residual in the scheme, radiated by a mesh that goes on",
    from: Effort::Verify,
    run,
};

/// Elements of the mesh around the box on each side, of those where the errors run away and of those in which residuals are found.
const AROUND: u32 = 14;
const RING: u32 = 1;

/// Waves at angles in full alone: each takes some twenty seconds.
const WAYS: [(WaveType, f64, f64); 3] =
    [(WaveType::Sv, 55.0, 30.0), (WaveType::P, 50.0, 30.0), (WaveType::Sv, 0.0, 90.0)];

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for way in WAYS.into_iter().filter(|_| effort == Effort::Full) {
        let (kind, angle, azimuth) = way;
        let of = format!("{} at {angle}° towards {azimuth}° in rock", kind.word());
        let [coarse, fine] = [errors(way, 1)?, errors(way, 2)?];
        for (at, place) in ["off the edges of the box", "at edges and corners"].into_iter().enumerate() {
            let quantity = format!("largest error {place} without any boundary, {of}");
            let note = "for information: beside it that of the box with its boundary";
            let p = order(coarse.unbounded[at], fine.unbounded[at], 2.0);
            checks.push(Check::beside(NAME, quantity, coarse.unbounded[at], coarse.bounded[at], "1", note));
            let quantity = format!("order in h of the error {place} without any boundary, {of}");
            checks.push(Check::new(NAME, quantity, p, 2.0, 0.1, "1", "what is wrong of the scheme is of order 2"));
            let quantity = format!("what the boundary adds {place}, {of}");
            let p = order(coarse.own[at], fine.own[at], 2.0);
            let note = "for information: the box with its boundary less that without";
            checks.push(Check::beside(NAME, quantity, coarse.own[at], coarse.unbounded[at], "1", note).with_order(p));
        }
    }
    if effort == Effort::Full {
        checks.extend(one_at_a_time()?);
    }
    checks.extend(straight_up()?);
    Ok(checks)
}

/// SV at 55° along an axis of the mesh, of which [`oblique_waves`](super::oblique_waves) misses 1 %.
const STEEP: Way = (WaveType::Sv, 55.0, 0.0);

/// Its error where one thing is unlike, and beside that straight up what the lag of the mesh says.
fn one_at_a_time() -> Result<Vec<Check>, VerifyError> {
    let ground = &GROUNDS[0];
    let error = |way: Way, cells: [u32; 3], finer: [u32; 3], step: f64, change: &dyn Fn(&mut Problem)| {
        let mut problem = ground.problem(cells, 1)?;
        let counts = [0, 1, 2].map(|i| cells[i] * finer[i]);
        problem.mesh = BoxSpec::uniform([0.0; 3], ground.size(cells), counts).mesh()?;
        problem.bodies[0].elements = (0..problem.mesh.elements.len() as u32).collect();
        change(&mut problem);
        let ([inside, ..], peak) = error_of(ground, problem, cells, way, step)?;
        Ok::<_, VerifyError>((inside, inside * peak))
    };
    let same = |_: &mut Problem| {};
    let plain = |way: Way| error(way, LARGE, [1; 3], STEP, &same);
    let ((whole, steep), (_, straight)) = (plain(STEEP)?, plain((WaveType::Sv, 0.0, 0.0))?);
    let [x, y, z] = LARGE;
    let full = |problem: &mut Problem| problem.bodies[0].quadrature = Quadrature::Full;
    let open = |problem: &mut Problem| problem.top = Top::Viscous;
    let one: [u32; 3] = [1; 3];
    let found = [
        ("with half the step", error(STEEP, LARGE, one, 0.5 * STEP, &same)?.0),
        ("with a quarter of the step", error(STEEP, LARGE, one, 0.25 * STEP, &same)?.0),
        ("with 2 × 2 × 2 points an element", error(STEEP, LARGE, one, STEP, &full)?.0),
        ("with ground going on above: once through the box", error(STEEP, LARGE, one, STEP, &open)?.0),
        ("in a box half as high", error(STEEP, [x, y, z / 2], one, STEP, &same)?.0),
        ("in a box twice as long both ways", error(STEEP, [2 * x, 2 * y, z], one, STEP, &same)?.0),
        ("with elements half as high", error(STEEP, LARGE, [1, 1, 2], STEP, &same)?.0),
        ("with elements half as long along the wave's way", error(STEEP, LARGE, [1, 2, 1], STEP, &same)?.0),
        ("with elements half as wide across it", error(STEEP, LARGE, [2, 1, 1], STEP, &same)?.0),
        ("with fifteen elements a shear wave", finer_by(15.0 / ELEMENTS, STEEP)?),
    ];
    let beside = |(words, value): (&str, f64)| {
        let quantity = format!("largest error off the edges of the box, SV at 55° towards 0° in rock, {words}");
        Check::beside(NAME, quantity, value, whole, "1", "for information: beside it as it is")
    };
    let mut checks: Vec<Check> = found.into_iter().map(beside).collect();
    let quantity = "error in displacement of SV at 55° over that straight up";
    let expected = lag(55.0) / lag(0.0);
    let note = "for information: beside it the ratio of lags on the way up and down, at the slowness of the field along the ground";
    checks.push(Check::beside(NAME, quantity, steep / straight, expected, "1", note));
    Ok(checks)
}

/// The error with more elements in the same box.
fn finer_by(factor: f64, way: Way) -> Result<f64, VerifyError> {
    let ground = &GROUNDS[0];
    let mut problem = ground.problem(LARGE, 1)?;
    let counts = LARGE.map(|count| (f64::from(count) * factor).round() as u32);
    problem.mesh = BoxSpec::uniform([0.0; 3], ground.size(LARGE), counts).mesh()?;
    problem.bodies[0].elements = (0..problem.mesh.elements.len() as u32).collect();
    Ok(error_of(ground, problem, LARGE, way, STEP)?.0[0])
}

/// By how much the phase of an SV wave that goes at an angle along an axis lags on its way up, over (kh)² of its way: k' = k (1 + ε) at
/// one frequency is all in the upward part where the part along the ground is that of the field, ε / cos θ.
///
/// An element with one point has shear ∂u_i/∂x_j less (k_j h)²/24 + (k_l h)²/8 for l ≠ j, and of ∂σ_xx/∂z as in plane stress across y the
/// stabilisation, 2μ/(1 − ν). With lumped masses this makes ε of an SV wave (kh)² (cos² 2θ/24 + sin² 2θ (1/12 − 1/(48 (1 − ν)))), of
/// which central differences take back (ωΔt)²/24.
fn lag(degrees: f64) -> f64 {
    let angle = degrees.to_radians();
    let (sin, cos) = (2.0 * angle).sin_cos();
    let space = cos * cos / 24.0 + sin * sin * (1.0 / 12.0 - 1.0 / (48.0 * (1.0 - POISSON)));
    let speeds = (1.0 - 2.0 * POISSON) / (2.0 * (1.0 - POISSON));
    (space - STEP * STEP * speeds / 24.0) / angle.cos()
}

/// Over the field's largest displacement, off the edges of the box and on them.
struct Errors {
    /// Of the box with its boundary, and without any; and the difference of the two.
    bounded: [f64; 2],
    unbounded: [f64; 2],
    own: [f64; 2],
}

/// Rock of a box with so many elements around it on all sides but above, in which no wave comes in.
fn surrounded(finer: u32, around: u32) -> Result<Problem, VerifyError> {
    let ground = &GROUNDS[0];
    let mut problem = ground.problem(LARGE, finer)?;
    let (size, pad) = (ground.size(LARGE), f64::from(around) * ground.element() / f64::from(finer));
    let cells = [0, 1, 2].map(|i| LARGE[i] * finer + if i == 2 { around } else { 2 * around });
    problem.mesh =
        BoxSpec::uniform([-pad; 3], [size[0] + pad, size[1] + pad, size[2]], cells).mesh()?;
    problem.bodies[0].elements = (0..problem.mesh.elements.len() as u32).collect();
    problem.base = Base::Viscous;
    problem.sides = [Side::Viscous; 2];
    Ok(problem)
}

/// The field in the box and an element around it.
fn field(problem: &Problem, finer: u32, way: Way) -> Result<ObliqueField, VerifyError> {
    let ground = &GROUNDS[0];
    let (size, ring) = (ground.size(LARGE), f64::from(RING) * ground.element() / f64::from(finer));
    let stratum = Stratum {
        thickness: size[2] + ring,
        rock: Rock::of(&problem.bodies[0], problem.rayleigh),
    };
    let layered =
        LayeredGround::new([stratum], Top::Free).ok_or_else(|| VerifyError::Setup("no layers".into()))?;
    field_in(layered, [[-ring; 3], [size[0] + ring, size[1] + ring, size[2]]], way)
}

/// Nodes by place, in thousandths of an element.
fn by_place(simulation: &Simulation, element: f64) -> HashMap<[i64; 3], usize> {
    let place = |n: usize| simulation.position(n).map(|x| (1e3 * x / element).round() as i64);
    (0..simulation.model.mesh_node.len()).map(|n| (place(n), n)).collect()
}

fn errors(way: Way, finer: u32) -> Result<Errors, VerifyError> {
    let ground = &GROUNDS[0];
    let (size, element) = (ground.size(LARGE), ground.element() / f64::from(finer));
    let mut bounded = ground.problem(LARGE, finer)?;
    let field = Arc::new(field(&bounded, finer, way)?);
    bounded.free_field = Some(field.clone());
    let bounded = Simulation::on_one_level(bounded)?;
    let near = Simulation::on_one_level(surrounded(finer, RING)?)?;
    let far = Simulation::on_one_level(surrounded(finer, AROUND * finer)?)?;
    let (_, duration) = pulse(0)?;
    let stable = [&bounded, &near, &far].map(Simulation::stable).into_iter().fold(f64::INFINITY, f64::min);
    let (steps, dt) = whole_steps(field.lead() + duration, 0.9 * stable);

    // Of each node of the box: its numbers in the three meshes, whether it is on an edge, and the share of its forces.
    let [in_near, in_far] = [&near, &far].map(|simulation| by_place(simulation, element));
    let mut nodes = Vec::new();
    for (place, &n) in &by_place(&bounded, element) {
        let at = bounded.position(n);
        let [Some(&near), Some(&far)] = [in_near.get(place), in_far.get(place)] else {
            return Err(VerifyError::Setup("a node of the box is not in the mesh around it".into()));
        };
        // The surface is where the ground ends.
        let faces = outer(size, at) - usize::from(at[2] > size[2] - 1e-6);
        nodes.push((n, near, far, usize::from(outer(size, at) > 1), 0.5_f64.powi(faces as i32)));
    }
    let places: Vec<[f64; 3]> = (0..near.model.mesh_node.len()).map(|n| near.position(n)).collect();
    let exact = |time: f64| -> Vec<[f64; 3]> { places.iter().map(|&at| field.displacement(at, time)).collect() };

    let rest = |simulation: &Simulation| {
        let mut engine = simulation.engine();
        let state = simulation.start(&mut engine, dt, |_| [[0.0; 3]; 2]);
        (engine, state)
    };
    let [(mut in_box, mut shaken), (mut in_ring, mut one), (mut outside, mut lag)] =
        [&bounded, &near, &far].map(rest);
    let (mut before, mut now) = (exact(-dt), exact(0.0));
    let (mut peak, mut worst) = (0.0_f64, [[0.0_f64; 2]; 3]);
    for step in 0..steps {
        let after = exact((step + 1) as f64 * dt);
        in_box.step(&mut shaken);
        // One step from the exact field, in the mesh with one element around.
        set(&mut one, &before, &now);
        in_ring.step(&mut one);
        outside.step(&mut lag);
        for &(n, near, far, edge, share) in &nodes {
            for i in 0..3 {
                let wrong = share * (after[near][i] - one.u[near].0[i]);
                lag.u[far].0[i] += wrong;
                lag.du[far].0[i] += wrong;
                let (without, with) = (lag.u[far].0[i], after[near][i] - shaken.u[n].0[i]);
                for (worst, error) in worst.iter_mut().zip([with, without, with - without]) {
                    worst[edge] = worst[edge].max(error.abs());
                    if error.is_nan() {
                        return Err(VerifyError::Setup("an error is no number".into()));
                    }
                }
                peak = peak.max(after[near][i].abs());
            }
        }
        (before, now) = (now, after);
    }
    let [bounded, unbounded, own] = worst.map(|of| of.map(|most| most / peak));
    Ok(Errors { bounded, unbounded, own })
}

/// Puts a state where the field was a step before and is now.
fn set(state: &mut State, before: &[[f64; 3]], now: &[[f64; 3]]) {
    state.u = now.iter().map(|u| Row::new(*u)).collect();
    let change = |(now, before): (&[f64; 3], &[f64; 3])| Row::new([0, 1, 2].map(|i| now[i] - before[i]));
    state.du = now.iter().zip(before).map(change).collect();
}

/// Straight up, where elements are a chain of masses: that on the dashpot of a base, and that without an end.
fn straight_up() -> Result<Vec<Check>, VerifyError> {
    let ground = &GROUNDS[0];
    let (motion, duration) = pulse(0)?;
    let mut found = Vec::new();
    for finer in [1, 2] {
        let element = ground.element() / f64::from(finer);
        let (_, speed, density) = ground.layers[0];
        let chain = Lattice {
            mass: density * element,
            spring: density * speed * speed / element,
            dashpot: density * speed,
            cells: (LARGE[2] * finer) as usize,
        };
        // As in a box, whose step goes by waves of compression; ν = 0.3.
        let (steps, dt) = whole_steps(duration, 0.9 * element / (speed * 3.5_f64.sqrt()));
        let height = f64::from(LARGE[2] * finer) * element;
        let field = |k: i64, time: f64| {
            let way = |z: f64| motion.at((time - z / speed).max(0.0)).u[0];
            let z = k as f64 * element;
            way(z) + way(2.0 * height - z)
        };
        let lag = chain.lag(field, dt, steps);
        let mut driven = vec![vec![0.0; chain.cells + 1]];
        driven.extend(chain.shaken(&motion, dt, steps));
        let (mut peak, mut worst) = (0.0_f64, [0.0_f64; 3]);
        for (step, (driven, lag)) in driven.iter().zip(&lag).enumerate() {
            for (k, (u, lag)) in driven.iter().zip(lag).enumerate() {
                let exact = field(k as i64, step as f64 * dt);
                let with = exact - u;
                for (worst, error) in worst.iter_mut().zip([with, *lag, with - lag]) {
                    *worst = worst.max(error.abs());
                }
                peak = peak.max(exact.abs());
            }
        }
        found.push(worst.map(|most| most / peak));
    }
    let (coarse, fine) = (found[0], found[1]);
    let said = [
        ("a chain of masses straight up on the dashpot of a base", "for information: from theory, as today's base errs"),
        ("the same chain without an end below", "for information: from theory, what the mesh makes by itself"),
        ("the one less the other", "for information: by so much a base without an error of its own would differ from today's"),
    ];
    let each = (0..3).flat_map(|k| {
        let (quantity, note) = said[k];
        let p = order(coarse[k], fine[k], 2.0);
        [
            Check::beside(NAME, quantity, coarse[k], coarse[0], "1", note),
            Check::new(NAME, format!("order in h of {quantity}"), p, 2.0, 0.1, "1", "order 2").with_order(p),
        ]
    });
    Ok(each.collect())
}
