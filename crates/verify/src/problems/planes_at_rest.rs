//! Level ground at rest across planes cut through its bricks.
//!
//! Ground of bricks of 2 m under its weight, K₀ = 0.6, between rollers on a fixed base, is cut by a plane of each dip ([`tremolite_mesh::cut`]),
//! with its two sides joined and with a joint in it that holds (μ = 2.5 on 20 GPa/m). The stress is that of equilibrium, so nothing should
//! move; the joint's pairs should bear its normal stress and shear.
//!
//! - **Planes that strike along y**, in a block of 30 × 2 × 20 m, at eight offsets a quarter of 1 m apart: all of a brick's width.
//! - **Planes of other strikes**, in a block of 16 m a side, at one place each.
//!
//! **Errors.** A piece with one point has the stress at its middle, and its weight in equal parts at its nodes: of a linear stress that leaves
//! on nodes what is of order h³, so level ground moves by order h², as in `gravity_column`. The step and the scaled Jacobian
//! are those that the program promises of a plane that it does not refuse.

use crate::joints::joint;
use crate::models::Solid;
use crate::staged::Quiet;
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::hexahedra::centroid;
use tremolite::{Assembly, Base, Model, Phase, Problem, Quadrature, Side, Stage, stable_step};
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::cut::{Bounds, Cut, cut};
use tremolite_mesh::plane::Plane;
use tremolite_mesh::{Mesh, quality};

const NAME: &str = "planes_at_rest";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "planes of 20 to 75° cut through level ground: step and shape of what is left, and rest, joined and on a joint",
    source: "equilibrium of level ground",
    from: Effort::Test,
    run,
};

const GRAVITY: f64 = 9.81;
const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
const LATERAL: f64 = 0.6;
const DIPS: [f64; 8] = [20.0, 30.0, 40.0, 45.0, 50.0, 55.0, 65.0, 75.0];
/// Dip directions of the planes of other strikes, dip by dip \[°\].
const DIRECTIONS: [f64; 8] = [30.0, 75.0, 120.0, 30.0, 200.0, 60.0, 75.0, 15.0];
const OFFSETS: u32 = 8;
/// Least step over that of the mesh without the plane, and least scaled Jacobian.
const LEAST_STEP: f64 = 0.4;
const LEAST_JACOBIAN: f64 = 0.15;
/// Motion to equilibrium over the settlement under the weight: of planes along y, and of others, beside which elements are unlike. For a dip
/// of 60°, 75°, bricks of 2 m leave 1.3·10⁻², of 1 m 2.9·10⁻³: order 2.1.
const RESTS: f64 = 5e-3;
const OBLIQUE_RESTS: f64 = 2e-2;

/// What is left of the ground with a plane; the worst of several.
#[derive(Clone, Copy, Debug)]
struct Left {
    step: f64,
    jacobian: f64,
    /// Motion to equilibrium over the settlement under the weight: joined, and on the joint.
    moved: [f64; 2],
    /// Motion in the steps of a shaking that nothing drives, over the same.
    after: [f64; 2],
    refused: u32,
}

impl Left {
    const NOTHING: Left =
        Left { step: f64::INFINITY, jacobian: f64::INFINITY, moved: [0.0; 2], after: [0.0; 2], refused: 0 };

    fn worst(self, other: Left) -> Left {
        let most = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].max(b[1])];
        Left {
            step: self.step.min(other.step),
            jacobian: self.jacobian.min(other.jacobian),
            moved: most(self.moved, other.moved),
            after: most(self.after, other.after),
            refused: self.refused + other.refused,
        }
    }
}

/// Level ground between rollers, its surface at z = 0.
fn ground(mesh: Mesh) -> Problem {
    let weight = ROCK.density * GRAVITY;
    let at = |e: u32| weight * centroid(&mesh, e)[2];
    let stress = (0..mesh.elements.len() as u32).map(|e| [LATERAL * at(e), LATERAL * at(e), at(e), 0.0, 0.0, 0.0]);
    let stress = stress.collect();
    let mut problem = ROCK.fill(mesh, Quadrature::OnePoint);
    problem.gravity = GRAVITY;
    problem.initial = stress;
    problem.sides = [Side::Roller; 2];
    problem.base = Base::Fixed;
    problem
}

/// The stable step \[s\] of a mesh of rock.
fn step(mesh: Mesh) -> Result<f64, VerifyError> {
    let model = Model::new(ground(mesh))?;
    let assembly = Assembly::new(&model)?;
    let phase = Phase::of(&model, &assembly, Stage::Shaking)?;
    Ok(stable_step(&model, &assembly, &phase).dt)
}

/// Level ground cut by a plane; `whole` is the step without it.
fn left(base: &Mesh, whole: f64, plane: Plane) -> Result<Left, VerifyError> {
    let mut mesh = base.clone();
    let name = || "plane".to_owned();
    let refused = Left { refused: 1, ..Left::NOTHING };
    let bounds = Bounds { free: [true; 2], ..Bounds::default() };
    let Ok(done) = cut(&mut mesh, &[Cut::through(&name(), plane)], &bounds) else {
        return Ok(refused);
    };
    // As the program refuses it, which goes by the pieces and what is beside them.
    let step = step(mesh.clone())? / whole;
    if step < LEAST_STEP {
        return Ok(refused);
    }
    let height = -base.bounds().0[2];
    let moduli = ROCK.moduli();
    let settles = 0.5 * ROCK.density * GRAVITY * height * height / (moduli.lambda + 2.0 * moduli.mu);
    let mut jointed = ground(mesh.clone());
    let sides = ["plane.below", "plane.above"].map(|side| mesh.groups[side].clone());
    let numbers = [("normal_stiffness", 20e9), ("friction_coefficient", 2.5)];
    jointed.interfaces = vec![joint(sides, "coulomb", &numbers, &[])?];
    let (joined, on_a_joint) = (Quiet::new(ground(mesh.clone()))?.moved, Quiet::new(jointed)?.moved);
    let jacobian = quality::summary_of(&mesh, done.changed.iter().copied()).min_scaled_jacobian;
    Ok(Left {
        step,
        jacobian,
        moved: [joined[0] / settles, on_a_joint[0] / settles],
        after: [joined[1] / settles, on_a_joint[1] / settles],
        refused: 0,
    })
}

/// The figures of planes.
fn say(checks: &mut Vec<Check>, what: &str, left: Left, rests: f64) {
    let note = "no less than 0.4, as the program promises of a plane that it cuts";
    let quantity = format!("step over that without the plane, {what}");
    checks.push(Check::new(NAME, quantity, left.step, 1.0, 1.0 - LEAST_STEP, "1", note));
    let note = "no less than 0.15, as the program promises; a brick has 1";
    let quantity = format!("smallest scaled Jacobian, {what}");
    checks.push(Check::new(NAME, quantity, left.jacobian, 1.0, 1.0 - LEAST_JACOBIAN, "1", note));
    for (k, word) in ["joined", "on a joint"].into_iter().enumerate() {
        let note = "of order h² of pieces with one point, as large as the ground is high in some ten bricks";
        let quantity = format!("motion to equilibrium over the settlement, {what}, {word}");
        checks.push(Check::new(NAME, quantity, left.moved[k], 0.0, rests, "1", note));
        let note = "1e-7: what the equilibrium leaves out of balance";
        let quantity = format!("motion in a hundred steps over the settlement, {what}, {word}");
        checks.push(Check::new(NAME, quantity, left.after[k], 0.0, 1e-7, "1", note));
    }
}

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let mut refused = 0;
    let base = BoxSpec::uniform([-15.0, -1.0, -20.0], [15.0, 1.0, 0.0], [15, 1, 10]).mesh()?;
    let whole = step(base.clone())?;
    let tests = effort == Effort::Test;
    for (d, dip) in DIPS.into_iter().enumerate() {
        let mut worst = Left::NOTHING;
        // The tests take one offset of each dip, another one each time.
        for k in (0..OFFSETS).filter(|k| !tests || *k == d as u32) {
            let plane = Plane::dipping([0.25 * f64::from(k), 0.0, -10.0], dip.to_radians(), 90_f64.to_radians());
            worst = worst.worst(left(&base, whole, plane)?);
        }
        refused += worst.refused;
        say(&mut checks, &format!("strike along y, dip {dip}°"), worst, RESTS);
    }
    let note = "none of these";
    checks.push(Check::new(NAME, "planes along y refused", f64::from(refused), 0.0, 0.0, "1", note));
    if !tests {
        let base = BoxSpec::uniform([-8.0, -8.0, -16.0], [8.0, 8.0, 0.0], [8, 8, 8]).mesh()?;
        let whole = step(base.clone())?;
        let (mut refused, mut tried) = (0, 0);
        for (dip, direction) in DIPS.into_iter().zip(DIRECTIONS) {
            let mut worst = Left::NOTHING;
            for k in (0..OFFSETS).filter(|k| effort == Effort::Full || *k == 1) {
                let through = [0.25 * f64::from(k), 0.0, -8.0];
                let plane = Plane::dipping(through, dip.to_radians(), direction.to_radians());
                worst = worst.worst(left(&base, whole, plane)?);
                tried += 1;
            }
            refused += worst.refused;
            if worst.step.is_finite() {
                say(&mut checks, &format!("dip {dip}°, dip direction {direction}°"), worst, OBLIQUE_RESTS);
            }
        }
        let note = format!("of {tried}, as the program says: move the plane by half an element");
        checks.push(Check::beside(NAME, "planes of other strikes refused", f64::from(refused), 0.0, "1", note));
    }
    Ok(checks)
}
