//! Ground under its own weight: layers in equilibrium stay where they are, settle as the integral says, and level ground in a
//! distorted mesh hardly moves.
//!
//! A column between rollers on a fixed base, of layers i with ρ_i and M_i = λ_i + 2μ_i: σ_z = −∫ρg from the surface, and the
//! surface settles by ∫|σ_z|/M. Elements of one height with the stress at their middle are in equilibrium with half of their
//! weight at either end, whatever the lateral stress; and nodes settle exactly, as stress is linear in an element. So both are exact
//! to what the relaxation leaves.
//!
//! In a distorted mesh the stress at the centre of an element is not in equilibrium with its weight. What is left is of order h³ on each
//! node and cancels within an element, so level ground moves by order 2 in h. It is held against what an opening
//! of 4 × 4 m moves in the same mesh, 26 m below the surface: 20 m of ground are a pressure on top.

use crate::convergence::order;
use crate::models::{QUADRATURES, Solid, distorted};
use crate::staged::{Rested, UNTIL_CHANGE, release};
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::hexahedra::centroid;
use tremolite::Traction;
use tremolite::{Life, Quadrature};
use tremolite_mesh::boxes::BoxSpec;

const NAME: &str = "gravity_column";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "layers under their weight: at rest with initial stress, settlement without, level ground in a distorted mesh",
    source: "equilibrium of a column",
    from: Effort::Test,
    run,
};

const GRAVITY: f64 = 9.81;
/// Layers from below, and the height of each in elements of 1 m.
const LAYERS: [(Solid, u32); 3] = [
    (Solid { young: 20e9, poisson: 0.2, density: 2700.0 }, 10),
    (Solid { young: 2e9, poisson: 0.3, density: 2300.0 }, 6),
    (Solid { young: 0.2e9, poisson: 0.4, density: 1900.0 }, 4),
];
const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2600.0 };
/// Edge \[m\] of the block of level ground, and its elements along an edge.
const EDGE: f64 = 12.0;
/// Ground above it that is given as a pressure \[m\].
const ABOVE: f64 = 20.0;
const DIVISIONS: [u32; 2] = [6, 12];

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let settles = settlement();
    for (quadrature, word) in QUADRATURES {
        let settled = column(quadrature, None)?;
        let note = "1e-5: nodes are exact; motion left is 1e-7 of that so far";
        let quantity = format!("settlement of layers under their weight, {word}");
        let surface = settled.state.u.iter().map(|u| -u.0[2]).fold(0.0, f64::max);
        checks.push(Check::new(NAME, quantity, surface, settles, 1e-5 * settles, "m", note));
        for (lateral, which) in [(None, "ν/(1 − ν)"), (Some(1.4), "1.4")] {
            let rested = column(quadrature, Some(lateral))?;
            let quantity = format!("motion from equilibrium over that settlement, K0 = {which}, {word}");
            let note = "1e-10: round-off of stresses and forces at nodes";
            checks.push(Check::new(NAME, quantity, most(&rested) / settles, 0.0, 1e-10, "1", note));
        }
        let [coarse, fine] = [level(quadrature, DIVISIONS[0], false)?, level(quadrature, DIVISIONS[1], false)?];
        let (coarse, fine) = (most(&coarse), most(&fine));
        let opened = level(quadrature, DIVISIONS[1], true)?;
        let moved = (0..opened.state.u.len())
            .flat_map(|n| opened.state.shown(n).xyz())
            .fold(0.0, |most: f64, x| most.max(x.abs()));
        let quantity = format!("motion of level ground in a distorted mesh over an excavation's, {word}");
        let note = "1e-3: what is left on nodes is of order h³ and cancels within an element";
        let p = order(coarse, fine, 2.0);
        checks.push(Check::new(NAME, quantity, fine / moved, 0.0, 1e-3, "1", note).with_order(p));
        let note = "2 within 0.6: the two meshes are distorted at random, each on its own";
        let quantity = format!("order in h of the motion of level ground, {word}");
        checks.push(Check::new(NAME, quantity, p, 2.0, 0.6, "1", note).with_order(p));
    }
    Ok(checks)
}

/// The layer of an element at a height \[m\], and the stress \[Pa\] along z there.
fn at_height(z: f64) -> (usize, f64) {
    let (mut foot, mut found, mut stress) = (0.0, 0, 0.0);
    for (i, (solid, height)) in LAYERS.iter().enumerate() {
        let top = foot + f64::from(*height);
        if z >= foot {
            found = i;
        }
        stress -= solid.density * GRAVITY * (top - z.max(foot)).max(0.0);
        foot = top;
    }
    (found, stress)
}

/// ∫|σ_z|/M \[m\]
fn settlement() -> f64 {
    let (mut above, mut sum) = (0.0, 0.0);
    for (solid, height) in LAYERS.iter().rev() {
        let (height, weight) = (f64::from(*height), solid.density * GRAVITY);
        let moduli = solid.moduli();
        sum += (above + 0.5 * weight * height) * height / (moduli.lambda + 2.0 * moduli.mu);
        above += weight * height;
    }
    sum
}

/// The column at rest, with initial stress of a lateral ratio (that of a column between rollers if none) or without.
fn column(quadrature: Quadrature, initial: Option<Option<f64>>) -> Result<Rested, VerifyError> {
    let layers: u32 = LAYERS.iter().map(|(_, n)| n).sum();
    let mesh = BoxSpec::uniform([0.0; 3], [2.0, 2.0, f64::from(layers)], [2, 2, layers]).mesh()?;
    let mut elements = [Vec::new(), Vec::new(), Vec::new()];
    let mut stress = Vec::new();
    for e in 0..mesh.elements.len() as u32 {
        let (layer, vertical) = at_height(centroid(&mesh, e)[2]);
        elements[layer].push(e);
        let poisson = LAYERS[layer].0.poisson;
        let ratio = initial.flatten().unwrap_or(poisson / (1.0 - poisson));
        stress.push([ratio * vertical, ratio * vertical, vertical, 0.0, 0.0, 0.0]);
    }
    let bodies = LAYERS
        .iter()
        .zip(elements)
        .map(|((solid, _), elements)| solid.body("layer", elements, quadrature))
        .collect();
    let mut problem = tremolite::Problem::new(mesh, bodies);
    problem.gravity = GRAVITY;
    if initial.is_some() {
        problem.initial = stress;
    }
    Rested::new(problem, &[release(1.0)])
}

/// Level ground with K₀ = ν/(1 − ν) in a distorted mesh, at rest; with an opening along y in its middle if wanted.
fn level(quadrature: Quadrature, divisions: u32, open: bool) -> Result<Rested, VerifyError> {
    let mesh = distorted([EDGE; 3], [divisions; 3], 0.15)?;
    let all = 0..mesh.elements.len() as u32;
    let centres: Vec<[f64; 3]> = all.map(|e| centroid(&mesh, e)).collect();
    let top = mesh.faces["top"].clone();
    let mut problem = ROCK.fill(mesh, quadrature);
    let pressure = -ROCK.density * GRAVITY * ABOVE;
    let pressed = top.into_iter().map(|face| (face, [pressure, pressure, pressure, 0.0, 0.0, 0.0])).collect();
    problem.tractions = vec![Traction { name: "above".into(), faces: pressed, life: Life::BEFORE }];
    let ratio = ROCK.poisson / (1.0 - ROCK.poisson);
    problem.initial = centres
        .iter()
        .map(|x| -ROCK.density * GRAVITY * (ABOVE + EDGE - x[2]))
        .map(|s| [ratio * s, ratio * s, s, 0.0, 0.0, 0.0])
        .collect();
    problem.gravity = GRAVITY;
    let inside = |x: &[f64; 3]| (x[0] - 0.5 * EDGE).abs().max((x[2] - 0.5 * EDGE).abs()) < 2.0;
    let life = |x| if open && inside(x) { UNTIL_CHANGE } else { Life::ALWAYS };
    problem.lives = centres.iter().map(life).collect();
    let stages = [release(1.0), release(1.0)];
    Rested::new(problem, &stages[..1 + usize::from(open)])
}

/// The largest displacement \[m\] of all, by component.
fn most(rested: &Rested) -> f64 {
    rested.state.u.iter().flat_map(|u| u.xyz()).fold(0.0, |most: f64, x| most.max(x.abs()))
}
