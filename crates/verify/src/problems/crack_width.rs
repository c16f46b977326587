//! How wide the crack is of a piece of lining that was pulled apart along its ring and then through its thickness.
//!
//! A block of 2 m along the ring and 0.5 m through the thickness, one element long and one, two or four thick, of which one is half as
//! strong, is stretched along one edge until that element alone has cracked, and then pulled apart along the other by 6 mm. Its faces are
//! led, so what they go apart is known, and no more than f_t L/E of it is elastic: that is the tolerance. Through the thickness all
//! of it is the crack of the weak element, and the others have none; along the ring each of them opens by all of it.
//!
//! The law softens by the extent across the first crack, which stays. Were the width taken across that, it would be 24 mm and more of the
//! 6 mm in the first order, and 1.5 mm or less in the second, where one element is thick.

use crate::concrete::{FT, THRESHOLD, YOUNG, values};
use crate::models::{LAYERED, QUADRATURES, material};
use crate::simulation::Simulation;
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::history::History;
use tremolite::{Body, Quadrature, State};
use tremolite_laws::materials::Concrete;
use tremolite_laws::{Material, Role};
use tremolite_mesh::boxes::BoxSpec;

const NAME: &str = "crack_width";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a piece of lining pulled apart along its ring and then through its thickness, and the other way round",
    source: "the way of its faces",
    from: Effort::Test,
    run,
};

/// Edges \[m\]: ring, cavern, thickness.
const EDGES: [f64; 3] = [2.0, 1.0, 0.5];
/// Strain of the first way over the threshold of the others, and the second way \[m\].
const FIRST: f64 = 0.75;
const SECOND: f64 = 6e-3;
/// Strength of the weak element over that of the others.
const WEAK: f64 = 0.5;
const DENSITY: f64 = 2752.0;

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let quadratures: Vec<(Quadrature, &str)> = match effort {
        Effort::Test => vec![QUADRATURES[0], LAYERED],
        _ => QUADRATURES.into_iter().chain([LAYERED]).collect(),
    };
    for (quadrature, word) in quadratures {
        for thick in [1u32, 2, 4] {
            for (axes, order) in
                [([0, 2], "first the ring, then the thickness"), ([2, 0], "first the thickness, then the ring")]
            {
                let widths = widths(quadrature, thick, axes)?;
                let elastic = THRESHOLD * EDGES[axes[1]];
                let note = "f_t L/E: more of the way cannot be elastic";
                let mut add = |what: &str, found: f64, tolerance: f64, note: &str| {
                    let quantity = format!("{what}, {thick} thick, {order}, {word}");
                    checks.push(Check::new(NAME, quantity, found, SECOND, tolerance, "m", note));
                };
                let widest = widths.iter().copied().fold(0.0, f64::max);
                if axes[1] == 0 {
                    let least = widths.iter().copied().fold(f64::INFINITY, f64::min);
                    add("widest crack", widest, elastic, note);
                    add("narrowest crack", least, elastic, note);
                    continue;
                }
                add("widest crack", widest, elastic, note);
                add("sum of cracks", widths.iter().sum(), elastic, note);
            }
        }
    }
    Ok(checks)
}

/// Widths \[m\] of the widest crack in each element of the row through the thickness.
fn widths(quadrature: Quadrature, thick: u32, axes: [usize; 2]) -> Result<Vec<f64>, VerifyError> {
    let mesh = BoxSpec::uniform([0.0; 3], EDGES, [1, 1, thick]).mesh()?;
    let body = |name: &str, elements: Vec<u32>, strength: f64| -> Result<Body, VerifyError> {
        let numbers = [("fracture_energy", 130.0), ("tensile_strength", strength)];
        let values = values(&numbers, &[("evolution", "exponential"), ("split", "compliance")]);
        let material = material(Concrete::NAME, &values)?;
        Ok(Body { name: name.into(), elements, material, density: DENSITY, quadrature, viscosity: 0.06 })
    };
    let mut bodies = vec![body("weak", vec![thick / 2], WEAK * FT)?];
    let rest: Vec<u32> = (0..thick).filter(|&e| e != thick / 2).collect();
    if !rest.is_empty() {
        bodies.push(body("concrete", rest, FT)?);
    }
    let mut problem = tremolite::Problem::new(mesh, bodies);
    problem.held = (0u32..)
        .zip(&problem.mesh.nodes)
        .map(|(n, x)| {
            // Cracked along the ring, elements keep no stiffness through the thickness: then that is led everywhere.
            let faces = x[2] < 1e-9 || x[2] > EDGES[2] - 1e-9;
            (n, [true, true, faces || axes[1] == 0])
        })
        .collect();
    let simulation = Simulation::new(problem)?;
    // So slowly that the faces that move add nothing: 200 times the way of a wave through the block, each way.
    let duration = 200.0 * EDGES[0] / (YOUNG / DENSITY).sqrt();
    // Where all is led nothing bounds the step.
    let dt = (0.5 * simulation.stable()).min(duration / 2_000.0);
    let steps = (duration / dt).ceil();
    let mut engine = simulation.engine();
    let mut state = simulation.start(&mut engine, dt, |_| [[0.0; 3]; 2]);
    for (axis, way) in [(axes[0], FIRST * THRESHOLD * EDGES[axes[0]]), (axes[1], SECOND)] {
        lead(&simulation, &mut state, axis, way / steps);
        for _ in 0..steps as u64 {
            engine.step(&mut state);
        }
    }
    // Widths are found where somebody looks, and a look leaves the state as it is.
    let seen = engine.look(&state);
    let history = History::new(&simulation.assembly, &seen.history);
    let widest = |slot| {
        let column = history.with_role(slot, Role::CrackWidth)?;
        Some(history.values(slot, column).fold(0.0, f64::max))
    };
    let slots = simulation.phase.element_slot.iter();
    Ok(slots.map(|slot| slot.as_ref().and_then(widest).unwrap_or(f64::NAN)).collect())
}

/// Lets all move along an axis as a stretching does, by a way \[m\] a step of its far face, and along no other.
fn lead(simulation: &Simulation, state: &mut State, axis: usize, way: f64) {
    for (n, du) in state.du.iter_mut().enumerate() {
        let at = simulation.position(n);
        for i in 0..3 {
            du.0[i] = if i == axis { way * at[i] / EDGES[i] } else { 0.0 };
        }
    }
}
