//! An elastic block that slides on a slope of rock that shakes.
//!
//! A block of 12 × 3 m lies on a slope of 20° in a hill, on a joint without cohesion, μ = 0.5. The hill comes to rest under its
//! weight, then a Ricker of acceleration rises through the base, horizontal. Beside it stands a rigid block (`newmark1965`), driven
//! by the mean motion of the rock's own nodes under the block, step by step: with a_t and a_n that motion's acceleration down the
//! slope and out of it, v_t and v_n its velocity, ω mass damping, and w the velocity of the slip,
//! ẇ = g sin θ − a_t − ω(w + v_t) − μ(g cos θ + a_n + ω v_n) while it slides.
//!
//! **What it is for.** Every piece of such a model may agree with theory and the block still slide too far: friction follows the
//! pressure, pairs that slide feed vibrations at the mesh's own frequencies, and where nothing damps these they grow as the mesh is
//! refined. [`tremolite::Interface::viscosity`] damps them; a run without it stands beside, for information.
//!
//! **Errors.** An elastic block is not rigid: parts of it slip before all of it does, and it begins to slide with what the shear
//! strain beneath it lets go, of the order of v/c. So it slides further by some 1 % here whatever the mesh, the joint's stiffness and
//! the step, and by a quarter of that where waves are four times as fast.

use crate::hill::{ANGLE, hill};
use crate::joints::joint;
use crate::models::{Solid, material};
use crate::convergence::order;
use crate::simulation::whole_steps;
use crate::staged::release;
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::PI;
use tremolite::stages::{PlannedStage, settle};
use tremolite::{
    Assembly, Base, Engine, Incident, Interface, Model, Phase, Quadrature, Rayleigh, Side, Stage, State,
    stable_step,
};
use tremolite_laws::materials::MohrCoulomb;
use tremolite_laws::{Material, Row, Values};
use tremolite_motion::{Motion, Sample};

const NAME: &str = "block_on_slope";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "an elastic block slides on a shaken slope: as far as Newmark's rigid block, whatever mesh and step",
    source: "newmark1965, integrated with the rock's own motion",
    from: Effort::Verify,
    run,
};

const GRAVITY: f64 = 9.81;
const ROCK: Solid = Solid { young: 20e9, poisson: 0.2, density: 25e3 / GRAVITY };
const FRICTION: f64 = 0.5;
/// Peak of the acceleration that comes in, against the direction in which the slope falls \[m/s²\], its frequency \[Hz\] and
/// centre \[s\]; the end of the run \[s\].
const PEAK: f64 = 2.0;
const FREQUENCY: f64 = 2.0;
const CENTRE: f64 = 0.75;
const END: f64 = 2.0;

/// What differs between runs.
#[derive(Clone, Copy)]
struct Variant {
    /// Elements along [`SIZE`].
    divide: u32,
    /// The interface's law, with a tangential stiffness if it has several, and a normal stiffness \[Pa/m\] if it is given.
    law: &'static str,
    tangential: Option<&'static str>,
    stiffness: Option<f64>,
    viscosity: f64,
    /// Of the step that is allowed.
    step: f64,
    /// Mass damping ω \[1/s\].
    damping: f64,
    yields: bool,
    /// Of the speeds of waves.
    faster: f64,
}

const PLAIN: Variant = Variant {
    divide: 1,
    law: "coulomb",
    tangential: None,
    stiffness: Some(10e9),
    viscosity: Interface::VISCOSITY,
    step: 1.0,
    damping: 0.0,
    yields: false,
    faster: 1.0,
};

/// Slip down the slope \[m\] of the model, and of Newmark's block.
struct Slip {
    model: f64,
    rigid: f64,
}

impl Slip {
    fn ratio(&self) -> f64 {
        self.model / self.rigid
    }
}

/// What a variant makes of the hill.
fn problem(variant: &Variant) -> Result<tremolite::Problem, VerifyError> {
    let (mesh, first) = hill(variant.divide);
    let ground: Vec<u32> = (0..first).collect();
    let block: Vec<u32> = (first..mesh.elements.len() as u32).collect();
    let mut numbers = vec![("friction_coefficient", FRICTION), ("cohesion", 0.0)];
    numbers.extend(variant.stiffness.map(|k| ("normal_stiffness", k)));
    if variant.law == "bandis" {
        numbers.push(("max_closure", 2e-3));
    }
    let words: Vec<_> = variant.tangential.map(|word| ("tangential", word)).into_iter().collect();
    let mut joint = joint([block.clone(), ground.clone()], variant.law, &numbers, &words)?;
    joint.viscosity = variant.viscosity;
    let rock = Solid { young: ROCK.young * variant.faster.powi(2), ..ROCK };
    let mut bodies = vec![
        rock.body("ground", ground, Quadrature::OnePoint),
        rock.body("block", block, Quadrature::OnePoint),
    ];
    if variant.yields {
        let values = Values::default()
            .with("young", ROCK.young)
            .with("poisson", ROCK.poisson)
            .with("cohesion", 0.1e6)
            .with("friction_angle", 0.7)
            .with("dilation_angle", 0.1)
            .with("tensile_strength", 0.05e6);
        let law = material(MohrCoulomb::NAME, &values)?;
        bodies.iter_mut().for_each(|body| body.material = law.clone());
    }
    let mut problem = tremolite::Problem::new(mesh, bodies);
    problem.interfaces = vec![joint];
    problem.gravity = GRAVITY;
    problem.sides = [Side::FreeField, Side::Periodic];
    problem.base = Base::Viscous;
    problem.rayleigh = Rayleigh { mass: variant.damping, stiffness: 0.0 };
    let k = PI * FREQUENCY;
    let motion = Motion::sampled(1e-3, END, |t| {
        let tau = k * (t - CENTRE);
        let bell = PEAK * (-tau * tau).exp();
        let along = |x: f64| [-x, 0.0, 0.0];
        Sample {
            a: along((1.0 - 2.0 * tau * tau) * bell),
            v: along((t - CENTRE) * bell),
            u: along(-bell / (2.0 * k * k)),
        }
    })?;
    problem.incident = Some(Incident { motion, factor: 1.0 });
    Ok(problem)
}

fn slide(variant: &Variant) -> Result<Slip, VerifyError> {
    let model = Model::new(problem(variant)?)?;
    let assembly = Assembly::new(&model)?;
    let stage = PlannedStage { release: release(1.0), ..PlannedStage::new("equilibrium") };
    let (mut state, _) =
        settle(&model, &assembly, &[stage]).map_err(|unsettled| VerifyError::Setup(format!("{unsettled:?}")))?;
    let phase = Phase::of(&model, &assembly, Stage::Shaking)?;
    let mut engine = Engine::new(&model, &assembly, &phase);
    let most = variant.step * stable_step(&model, &assembly, &phase).to_run(0.9);
    let (steps, dt) = whole_steps(END, most);
    engine.hand_over(&mut state, dt);

    let (sine, cosine) = ANGLE.sin_cos();
    let [down, out] = [[cosine, 0.0, -sine], [sine, 0.0, cosine]];
    let pairs = &model.seams[0].pairs;
    let area: f64 = pairs.iter().map(|pair| pair.area).sum();
    // Mean motion of a side: 0 the block's, 1 the ground's.
    let mean = |rows: &[Row], side: usize, along: [f64; 3]| -> f64 {
        let sum = pairs.iter().map(|pair| {
            let row = rows[model.engine_node[pair.nodes[side] as usize] as usize].xyz();
            pair.area * (0..3).map(|i| row[i] * along[i]).sum::<f64>()
        });
        sum.sum::<f64>() / area
    };
    let apart = |state: &State| mean(&state.u, 0, down) - mean(&state.u, 1, down);
    let start = apart(&state);
    // Velocities are those between two steps, as w is.
    let (mut rigid, mut w, mut last) = (0.0, 0.0_f64, [0.0; 2]);
    for _ in 0..steps {
        engine.step(&mut state);
        let now = [down, out].map(|along| mean(&state.du, 1, along) / dt);
        let [a_t, a_n] = [0, 1].map(|i| (now[i] - last[i]) / dt);
        let [v_t, v_n] = [0, 1].map(|i| variant.damping * 0.5 * (now[i] + last[i]));
        let free = w + dt * (GRAVITY * sine - a_t - variant.damping * w - v_t);
        let friction = dt * FRICTION * (GRAVITY * cosine + a_n + v_n).max(0.0);
        w = if free.abs() <= friction { 0.0 } else { free - friction.copysign(free) };
        rigid += w * dt;
        last = now;
    }
    Ok(Slip { model: apart(&state) - start, rigid })
}

/// Joints, each with its name.
fn joints() -> Vec<(String, Variant)> {
    let bandis = |word| Variant { law: "bandis", tangential: Some(word), ..PLAIN };
    let laws = [
        ("Coulomb", PLAIN),
        ("Bandis, following", bandis("following")),
        ("Bandis, constant", bandis("constant")),
    ];
    let given = laws.iter().map(|(name, law)| (format!("{name}, 10 GPa/m"), *law));
    let stiff = |stiffness: Option<f64>| move |law: &Variant| Variant { stiffness, ..*law };
    let chosen = laws.iter().map(|(name, law)| (format!("{name}, stiffness left out"), stiff(None)(law)));
    let others = [("1 GPa/m", 1e9), ("100 GPa/m", 100e9)];
    let others = others.map(|(name, k)| (format!("Coulomb, {name}"), stiff(Some(k))(&PLAIN)));
    given.chain(chosen).chain(others).collect()
}

/// The elastic block's slip over the rigid one's, at most.
const MOST: f64 = 0.02;

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let mut compare = |name: String, variant: Variant| -> Result<Slip, VerifyError> {
        let slip = slide(&variant)?;
        let note = "2 %: what is elastic, 1 % here, which the check of faster waves shows to be of the order of v/c";
        checks.push(Check::new(NAME, format!("slip, {name}"), slip.model, slip.rigid, MOST * slip.rigid, "m", note));
        Ok(slip)
    };
    let meshes = [(1, "1.5 m"), (2, "0.75 m"), (3, "0.5 m")];
    let all = effort == Effort::Full;
    let mut plain = Vec::new();
    for (divide, size) in meshes.into_iter().take(if all { 3 } else { 2 }) {
        // Off the coarse mesh the first joint stands for all.
        let joints = joints().into_iter().take(if all || divide == 1 { usize::MAX } else { 1 });
        for (k, (name, joint)) in joints.enumerate() {
            let joint = Variant { divide, ..joint };
            let slip = compare(format!("{size}, {name}"), joint)?;
            if k == 0 {
                plain.push(slip);
            }
            if all || k == 0 {
                compare(format!("{size}, {name}, half the step"), Variant { step: 0.5, ..joint })?;
            }
        }
    }
    compare("Mohr–Coulomb rock".into(), Variant { yields: true, ..PLAIN })?;
    compare("mass damping of 3 1/s".into(), Variant { damping: 3.0, ..PLAIN })?;
    let faster = compare("waves four times as fast".into(), Variant { faster: 4.0, ..PLAIN })?;
    let order = order(plain[0].ratio() - 1.0, faster.ratio() - 1.0, 4.0);
    let note = "what an elastic block slides beyond a rigid one is of the order of v/c";
    checks.push(Check::new(NAME, "order in 1/c of the slip beyond the rigid block's", order, 1.0, 0.2, "1", note).with_order(order));
    let apart = (plain[1].model / plain[0].model - 1.0).abs();
    let note = "a quarter of a per cent: the mesh decides nothing, a block that chatters slides three times as far";
    checks.push(Check::new(NAME, "slip on half the elements over that on whole ones, less 1", apart, 0.0, 0.0025, "1", note));
    let bare = slide(&Variant { viscosity: 0.0, ..PLAIN })?;
    let note = "for information: pairs that slide feed what nothing damps";
    checks.push(Check::beside(NAME, "slip without viscosity over Newmark's, 1.5 m", bare.model / plain[0].rigid, 1.0, "1", note));
    Ok(checks)
}
