//! Water in a joint, under a lining and in rock that does not notice it.
//!
//! **Joint.** With the total pressure σ and water w a joint of friction μ slides at μ(σ − w) (`terzaghi1943`). Two bricks, pressed by 2 MPa with
//! 1 MPa of water, the upper one moved sideways: 0.7 MPa at μ = 0.7, where dry it is 1.4 MPa.
//!
//! **Block.** One of height h on a wet plane slides as soon as the ground accelerates by more than μ(g − w/ρh), and with a more it gains a − that:
//! w is held through the earthquake. Axes move with the ground; the block is rigid.
//!
//! **Unchanged pressure.** Elastic rock moves as dry rock under the same total stress, whatever α, to round-off: an opening is taken out of a distorted block.
//!
//! **Lining.** Water comes back behind a ring of concrete that stood in drained rock: Δp = p₀(1 − ln(r/a)/ln(b/a)). Total stress and motion are
//! those of a thick ring in rock with the stress −αΔp; where nothing bonds the two they part, and the lining carries p₀ on its outside, −p₀a; where it
//! is tied rock takes it along and pulls at it; where the interface is drained nothing presses on it.

use crate::joints::{joint, together};
use crate::models::{QUADRATURES, Solid, distorted};
use crate::staged::{Rested, Rings, SINCE_CHANGE, UNTIL_CHANGE, growing, release};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;
use tremolite::hexahedra::centroid;
use tremolite::parts::loads::Load;
use tremolite::stages::{PlannedStage, settle};
use tremolite::water::Spell;
use tremolite::{
    Assembly, Engine, Life, Model, Phase, Prescribed, Problem, Quadrature, Stage, Traction, Water, stable_step,
};
use tremolite_mesh::Mesh;
use tremolite_mesh::boxes::BoxSpec;

const NAME: &str = "wet_joint";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "water in joints, behind a lining and in elastic rock: effective stress in friction, external head, the same motion as dry",
    source: "`terzaghi1943`, `biot1941`; rings in closed form",
    from: Effort::Test,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
const GRAVITY: f64 = 9.81;

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for (water, exact) in [(0.0, 1.4e6), (1e6, 0.7e6), (2e6, 0.0)] {
        let note = "1e-3 of the dry strength: it slides at its limit, and what presses it still swings as it slides for the last time";
        let quantity = format!("shear that slides a joint under 2 MPa with {} MPa of water", water / 1e6);
        checks.push(Check::new(NAME, quantity, slide(water)?, exact, 1.4e3, "Pa", note));
    }
    for (water, exact) in [(0.0, 4.905), (100e3, 3.053148148148148)] {
        let note = "1e-6: a rigid block slides at its limit, with the pressure of its rest";
        let quantity = format!("ground acceleration that slides a block, {} kPa", water / 1e3);
        checks.push(Check::new(NAME, quantity, block(water)?, exact, 1e-6 * exact, "m/s2", note));
    }
    for (quadrature, word) in QUADRATURES {
        for alpha in [1.0, 0.6] {
            let [dry, wet] = [None, Some(alpha)].map(|alpha| opened(quadrature, alpha));
            let (dry, wet) = (dry?, wet?);
            let most = dry.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
            let both = dry.iter().flatten().zip(wet.iter().flatten());
            let apart = both.fold(0.0_f64, |m, (a, b)| m.max((a - b).abs())) / most;
            if most < 1e-4 {
                return Err(VerifyError::Setup(format!("an opening that moves its walls by {most:e} m shows nothing")));
            }
            let note = "1e-6: both at rest to 1e-9 of all contributions";
            let quantity = format!("motion of wet rock less that of dry, over the largest, α = {alpha}, {word}");
            checks.push(Check::new(NAME, quantity, apart, 0.0, 1e-6, "1", note));
        }
    }
    for (how, exact, word) in [
        (Joined::Tied, TIED, "tied"),
        (Joined::Bonded, bonded(), "bonded"),
        (Joined::Apart, -HEAD * WALL, "without a bond"),
        (Joined::Drained, 0.0, "without a bond, drained"),
    ] {
        let found = lining(how)?;
        let note = "1 %: of order 2 in the angle of an element, 0.4 % its square; 1e-3 of p₀a where it is nothing";
        let tolerance = if exact == 0.0 { 1e-3 * HEAD * WALL } else { 0.01 * f64::abs(exact) };
        let quantity = format!("thrust of a lining when water comes back behind it, {word}");
        checks.push(Check::new(NAME, quantity, found, exact, tolerance, "N/m", note));
    }
    Ok(checks)
}

/// The same pressures \[Pa\] throughout, from the first stage on, in elements with this α.
fn even(mesh: &Mesh, alpha: f64, elements: f64, nodes: f64) -> Water {
    let (count, places) = (mesh.elements.len(), mesh.nodes.len());
    let spell = Spell { from: Stage::Before(0), elements: vec![elements; count], nodes: vec![nodes; places] };
    Water { biot: vec![alpha; count], spells: vec![spell], ..Water::default() }
}

/// Two bricks one on the other, nodes between them doubled.
fn bricks(height: f64) -> Result<Mesh, VerifyError> {
    let brick = |low: f64| BoxSpec::uniform([0.0, 0.0, low], [1.0, 1.0, low + height], [1; 3]).mesh();
    Ok(together(&brick(-height)?, &brick(0.0)?))
}

/// Shear \[Pa\] of a joint under 2 MPa with so much water, moved sideways by a millimetre.
fn slide(water: f64) -> Result<f64, VerifyError> {
    const PRESSURE: f64 = 2e6;
    let mesh = bricks(1.0)?;
    let numbers = [("normal_stiffness", 20e9), ("friction_coefficient", 0.7), ("cohesion", 0.0)];
    let mut problem = ROCK.fill(mesh, Quadrature::OnePoint);
    problem.water = even(&problem.mesh, 1.0, water, water);
    problem.interfaces = vec![joint([vec![0], vec![1]], "coulomb", &numbers, &[])?];
    problem.initial = vec![[-PRESSURE, -PRESSURE, -PRESSURE, 0.0, 0.0, 0.0]; 2];
    let moved = |name: &str, element: u32, to: f64| Prescribed {
        name: name.into(),
        corners: (0..8).map(|k| (element, k)).collect(),
        to: [Some(to), Some(0.0), if element == 0 { Some(0.0) } else { None }],
        life: SINCE_CHANGE,
    };
    problem.bed.rollers = [false; 2];
    // It does not rock.
    problem.ties = (9..16).map(|n| (8, n)).collect();
    let top = tremolite_mesh::Face { element: 1, side: 5 };
    problem.tractions = vec![Traction {
        name: "weight above".into(),
        faces: vec![(top, problem.initial[0])],
        life: Life::BEFORE,
    }];
    problem.prescribed = vec![moved("base", 0, 0.0), moved("block", 1, 1e-3)];
    let rested = Rested::new(problem, &[release(1.0), release(1.0)])?;
    let (seam, contacts) = (&rested.model.seams[0], &rested.assembly.contacts[0]);
    let pairs = 0..seam.pairs.len();
    let all = pairs.map(|k| {
        let [a, b] = contacts.seen(&rested.state.history, k).shear;
        a.hypot(b)
    });
    Ok(all.sum::<f64>() / seam.pairs.len() as f64)
}

/// Acceleration \[m/s²\] of the ground at which a block on a plane with water slides: what the block gains beside it less what acts.
fn block(water: f64) -> Result<f64, VerifyError> {
    const HEIGHT: f64 = 10.0;
    const ACTS: f64 = 8.0;
    let mesh = bricks(HEIGHT)?;
    let numbers = [("normal_stiffness", 20e9), ("friction_coefficient", 0.5), ("cohesion", 0.0)];
    let mut problem = ROCK.fill(mesh, Quadrature::OnePoint);
    // Neither has pores: the water is in the joint alone.
    problem.water = even(&problem.mesh, 0.0, 0.0, water);
    let mut between = joint([vec![0], vec![1]], "coulomb", &numbers, &[])?;
    between.water = Some(1.0);
    problem.interfaces = vec![between];
    let weight = ROCK.density * GRAVITY * HEIGHT;
    problem.initial = vec![[0.0, 0.0, -weight, 0.0, 0.0, 0.0], [0.0, 0.0, -0.5 * weight, 0.0, 0.0, 0.0]];
    problem.gravity = GRAVITY;
    problem.bed.rollers = [false; 2];
    problem.held = (0..8).map(|n| (n, [true; 3])).collect();
    problem.ties = (9..16).map(|n| (8, n)).collect();
    let mass = ROCK.density * HEIGHT / 8.0;
    problem.loads = vec![Load {
        forces: (8..16).map(|n| (n, [-ACTS * mass, 0.0, 0.0])).collect(),
        factor: Arc::new(|time| f64::from(u8::from(time > 0.0))),
    }];
    let model = Model::new(problem)?;
    let assembly = Assembly::new(&model)?;
    let stage = PlannedStage { release: release(1.0), ..PlannedStage::new("equilibrium") };
    let (mut state, _) = settle(&model, &assembly, &[stage])
        .map_err(|unsettled| VerifyError::Setup(format!("{unsettled:?}")))?;
    let phase = Phase::of(&model, &assembly, Stage::Shaking)?;
    let dt = stable_step(&model, &assembly, &phase).to_run(0.5);
    let mut engine = Engine::new(&model, &assembly, &phase);
    engine.hand_over(&mut state, dt);
    let node = model.engine_node[8] as usize;
    let mut speed = |steps: u64| {
        for _ in 0..steps {
            engine.step(&mut state);
        }
        (state.time(), state.du[node].0[0] / dt)
    };
    // All friction is there by then.
    let ((t0, v0), (t1, v1)) = (speed(2000), speed(2000));
    Ok(ACTS + (v1 - v0) / (t1 - t0))
}

/// Motion of all nodes \[m\] as an opening is taken out of a distorted block under a joint, in rock with α or without water.
fn opened(quadrature: Quadrature, alpha: Option<f64>) -> Result<Vec<[f64; 3]>, VerifyError> {
    const SIZE: f64 = 6.0;
    let mesh = distorted([SIZE; 3], [6; 3], 0.1)?;
    let mut problem = ROCK.fill(mesh, quadrature);
    let count = problem.mesh.elements.len();
    let near = |e: &u32, low: [f64; 3], high: [f64; 3]| {
        let x = centroid(&problem.mesh, *e);
        (0..3).all(|i| x[i] > low[i] && x[i] < high[i])
    };
    let core: Vec<u32> =
        (0..count as u32).filter(|e| near(e, [2.0; 3], [4.0; 3])).collect();
    problem.lives = vec![Life::ALWAYS; count];
    core.iter().for_each(|&e| problem.lives[e as usize] = UNTIL_CHANGE);
    let stress = [-6e6, -5e6, -8e6, 0.0, 0.0, 0.0];
    problem.initial = vec![stress; count];
    let faces = ["xmin", "xmax", "ymin", "ymax", "top"].map(|name| problem.mesh.faces[name].clone()).concat();
    let faces = faces.into_iter().map(|face| (face, stress)).collect();
    problem.tractions = vec![Traction { name: "stress".into(), faces, life: Life::BEFORE }];
    if let Some(alpha) = alpha {
        problem.water = even(&problem.mesh, alpha, 1.5e6, 1.5e6);
    }
    let nodes = problem.mesh.nodes.len() as u32;
    let rested = Rested::new(problem, &[release(1.0), release(1.0)])?;
    Ok((0..nodes).map(|n| rested.shown(n)).collect())
}

/// p₀ \[Pa\], a and b, and the lining's thickness \[m\].
const HEAD: f64 = 1e6;
const WALL: f64 = 5.0;
const OUTER: f64 = 50.0;
const THICK: f64 = 0.5;
const CONCRETE: Solid = Solid { young: 25e9, poisson: 0.17, density: 2500.0 };

/// Normal stiffness of the joint \[Pa/m\].
const STIFF: f64 = 2e11;

/// Thrust \[N/m\] of the tied ring, and motion outwards \[m\] of the wall with it, and of one that the lining has left, which water presses
/// on: rings in closed form.
const TIED: f64 = 132_320.732_841_271_76;
const TOGETHER: f64 = 4.791_124_808_709_544_5e-5;
const LEFT: f64 = 6.991_716_441_105_144e-4;

/// Thrust \[N/m\] where a bonded joint of this stiffness is between: it parts by −p'/k, p' being what passes less the water.
fn bonded() -> f64 {
    let tied = -TIED / WALL;
    // Motion per pressure between the two, inwards of the lining and outwards of the rock.
    let [ring, rock] = [-TOGETHER / tied, (LEFT - TOGETHER) / (HEAD - tied)];
    let (gives, joint) = (ring + rock, 1.0 / STIFF);
    -WALL * (HEAD * joint + gives * tied) / (gives + joint)
}

/// What is between a lining and rock.
#[derive(Clone, Copy, PartialEq)]
enum Joined {
    Tied,
    Bonded,
    Apart,
    Drained,
}

/// Change of a lining's thrust \[N/m\], tension positive, when the water comes back.
fn lining(how: Joined) -> Result<f64, VerifyError> {
    const AROUND: u32 = 24;
    let inner = WALL - THICK;
    let mut radii: Vec<f64> = (0..=2).map(|k| inner + THICK * f64::from(k) / 2.0).collect();
    radii.extend(growing(WALL, OUTER, FRAC_PI_2 / f64::from(AROUND)));
    let rings = Rings::new(radii, AROUND, false);
    let (ring, rock) = (rings.between(inner, WALL), rings.between(WALL, OUTER));
    let brick = rings.brick();
    let bodies = vec![
        CONCRETE.body("lining", ring.clone(), Quadrature::Full),
        ROCK.body("rock", rock.clone(), Quadrature::OnePoint),
        brick,
    ];
    let mut problem = Problem::new(rings.mesh.clone(), bodies);
    problem.held = rings.symmetry();
    let mesh = &problem.mesh;
    let log = (OUTER / WALL).ln();
    let drained = |x: [f64; 3]| HEAD * ((x[0].hypot(x[2]) / WALL).ln() / log).clamp(0.0, 1.0);
    let of_elements = |p: &dyn Fn([f64; 3]) -> f64| -> Vec<f64> {
        (0..mesh.elements.len() as u32).map(|e| p(centroid(mesh, e))).collect()
    };
    let spell = |from: u16, p: &dyn Fn([f64; 3]) -> f64| Spell {
        from: Stage::Before(from),
        elements: of_elements(p),
        nodes: mesh.nodes.iter().map(|&x| p(x)).collect(),
    };
    let mut biot = vec![0.0; mesh.elements.len()];
    rock.iter().for_each(|&e| biot[e as usize] = 1.0);
    problem.water = Water { biot, spells: vec![spell(0, &drained), spell(1, &|_| HEAD)], ..Water::default() };
    if how != Joined::Tied {
        let strength = if how == Joined::Bonded { 5e6 } else { 0.0 };
        let mut numbers = vec![("normal_stiffness", STIFF), ("friction_coefficient", 0.0), ("cohesion", strength)];
        if strength > 0.0 {
            numbers.push(("tensile_strength", strength));
        }
        let mut between = joint([ring.clone(), rock], "coulomb", &numbers, &[])?;
        between.water = (how == Joined::Drained).then_some(0.0);
        problem.interfaces = vec![between];
    }
    let rested = Rested::new(problem, &[release(1.0), release(1.0)])?;
    Ok(-rings.section(&rested, &ring, [inner, WALL])[0])
}
