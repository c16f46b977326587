//! A lined, jointed opening below the water, dug and lined in stages, and then shaken with water that stays or cannot leave.
//!
//! The slice with a lined opening (`lined`) in rock that yields, with water that the digging draws down around it and a joint without a bond
//! behind the lining. It is symmetric in x, so the mirrored wave must move it as the mirror image; nothing may move before a wave
//! comes; and what water takes is in the balance, which errs by what plastic laws book of a step (first order) as without water. How much further the
//! lining is moved drained or undrained is for information: neither is the safe side for all.

use crate::lined::{Corners, Joints, ROCK, corners, mirrored, slice};
use crate::models::material;
use crate::simulation::{Simulation, whole_steps};
use crate::staged::{SINCE_CHANGE, UNTIL_CHANGE, release};
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::hexahedra::centroid;
use tremolite::sheet::faces_on;
use tremolite::stages::{PlannedStage, settle};
use tremolite::water::Spell;
use tremolite::{Base, Life, Line, Problem, Quadrature, Side, Stage, Traction, Water};
use tremolite_laws::materials::MohrCoulomb;
use tremolite_laws::{Material, Values};

const NAME: &str = "undrained_cavern";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a lined opening in jointed wet rock, in stages and shaken drained and undrained: rest, mirror image, balance",
    source: "reflection in x; the balance of the scheme",
    from: Effort::Verify,
    run,
};

const GRAVITY: f64 = 9.81;
const WATER: f64 = 9810.0;
/// Ground above the slice that its initial stress counts, and water above its top \[m\]; K₀ of effective stress.
const ABOVE: f64 = 60.0;
const HEAD: f64 = 40.0;
const LATERAL: f64 = 0.7;
const DEEP: u32 = 2;
const ALPHA: f64 = 0.8;
const MODULUS: f64 = 30e9;
/// Half the wall of the lining that looks at the rock, and its roof \[m\]: the drained rock ends so far from it.
const AXIS: [f64; 2] = [0.0, 7.5];

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let along = [0.6, 0.3, 0.74];
    let mut closures = Vec::new();
    for (modulus, word) in [(MODULUS, "undrained"), (0.0, "drained")] {
        let plain = shake(along, modulus)?;
        let other = shake([-along[0], along[1], along[2]], modulus)?;
        let (mut worst, mut peak) = (0.0_f64, 0.0_f64);
        for (one, two) in plain.rows.iter().zip(&other.rows) {
            for (key, [x, y, z]) in one {
                let Some([u, v, w]) = two.get(&mirrored(*key)) else {
                    return Err(VerifyError::Setup("a corner has no mirror image".into()));
                };
                let apart = [x + u, y - v, z - w].into_iter().fold(0.0, |m: f64, d| m.max(d.abs()));
                worst = if apart <= worst { worst } else { apart };
                peak = peak.max(x.abs()).max(z.abs());
            }
        }
        let note = "1e-10: round-off, with which contacts slide and rock yields a little earlier or later";
        let quantity = format!("difference from the mirror image over the peak, {word}");
        checks.push(Check::new(NAME, quantity, worst / peak, 0.0, 1e-10, "1", note));
        let note = "1e-9 m: by construction, since what is out of balance is held";
        let quantity = format!("motion in a hundred steps without a wave, {word}");
        checks.push(Check::new(NAME, quantity, plain.drift, 0.0, 1e-9, "m", note));
        let note = "2e-3: first order of the steps in which rock yields";
        let quantity = format!("energy error over all that was supplied, {word}");
        checks.push(Check::new(NAME, quantity, plain.error, 0.0, 2e-3, "1", note));
        let note = "what water took of all that was supplied, for information";
        let quantity = format!("pore_water over all that was supplied, {word}");
        checks.push(Check::beside(NAME, quantity, plain.water, 0.0, "1", note));
        let quantity = format!("least and largest change of pressure, {word}");
        let note = "MPa, for information";
        checks.push(Check::beside(NAME, format!("{quantity}: largest"), plain.pressures[1], 0.0, "Pa", note));
        checks.push(Check::beside(NAME, format!("{quantity}: least"), plain.pressures[0], 0.0, "Pa", note));
        closures.push(plain.closure);
    }
    let note = "largest change of the opening's width in the earthquake, for information: which of the two moves a lining more depends on the case";
    let [undrained, drained] = closures[..] else { return Ok(checks) };
    checks.push(Check::beside(NAME, "change of width undrained beside drained", undrained, drained, "m", note));
    Ok(checks)
}

struct Shaken {
    rows: Vec<Corners>,
    drift: f64,
    error: f64,
    /// `pore_water` over all that was supplied.
    water: f64,
    /// Least and largest change of pressure \[Pa\].
    pressures: [f64; 2],
    /// Largest change of the opening's width \[m\].
    closure: f64,
}

fn shake(along: [f64; 3], modulus: f64) -> Result<Shaken, VerifyError> {
    let simulation = Simulation::on_one_level(problem(along, modulus)?)?;
    let stages =
        [1.0, 0.6, 0.9].map(|share| PlannedStage { release: release(share), ..PlannedStage::new("stage") });
    let (mut state, _) = settle(&simulation.model, &simulation.assembly, &stages)
        .map_err(|unsettled| VerifyError::Setup(format!("{unsettled:?}")))?;
    let mut engine = simulation.engine();
    let (every, dt) = whole_steps(1e-3, simulation.bound().to_run(0.9));
    engine.hand_over(&mut state, dt);
    let drift = engine.quiet_run(&state, 100);
    let before = engine.look(&state).snapshot.pore;
    let mut shaken =
        Shaken { rows: Vec::new(), drift, error: 0.0, water: 0.0, pressures: [0.0; 2], closure: 0.0 };
    // Its walls at half height.
    let walls = [-2.0, 2.0].map(|x| simulation.node([x, 0.0, 8.0]));
    let [left, right] = walls;
    let (left, right) = (left?, right?);
    while state.time() < crate::lined::END {
        for _ in 0..every {
            engine.step(&mut state);
        }
        let shown = |n: usize| state.shown(n).xyz();
        shaken.closure = shaken.closure.max((shown(right)[0] - shown(left)[0]).abs());
        shaken.rows.push(corners(&simulation, &state));
        let snapshot = engine.look(&state).snapshot;
        for (now, before) in snapshot.pore.iter().zip(&before) {
            let change = now - before;
            shaken.pressures = [shaken.pressures[0].min(change), shaken.pressures[1].max(change)];
        }
        shaken.error = snapshot.balance[Line::Error].abs() / snapshot.supplied;
        shaken.water = snapshot.balance[Line::PoreWater] / snapshot.supplied;
    }
    Ok(shaken)
}

/// The slice in its stages: level ground, dug, lined.
fn problem(along: [f64; 3], modulus: f64) -> Result<Problem, VerifyError> {
    let numbers = [("normal_stiffness", 20e9), ("max_closure", 1e-3), ("cohesion", 0.0), ("friction_coefficient", 0.6)];
    let joints = Joints { lining: true, fault: false, law: "bandis", numbers: &numbers };
    let mut problem = slice(DEEP, joints, along)?;
    let values = Values::default()
        .with("young", 10e9)
        .with("poisson", 0.25)
        .with("cohesion", 4e5)
        .with("friction_angle", 0.6)
        .with("dilation_angle", 0.1)
        .with("tensile_strength", 1e5);
    let rock = material(MohrCoulomb::NAME, &values)?;
    problem.bodies[1].material = rock.clone();
    let mesh = &mut problem.mesh;
    let mut known = vec![false; mesh.elements.len()];
    problem.bodies.iter().flat_map(|body| &body.elements).for_each(|&e| known[e as usize] = true);
    let mut before: Vec<u32> = (0u32..).zip(&known).filter(|(_, known)| !**known).map(|(e, _)| e).collect();
    problem.lives = vec![Life::ALWAYS; mesh.elements.len()];
    before.iter().for_each(|&e| problem.lives[e as usize] = UNTIL_CHANGE);
    let lining = problem.bodies[0].elements.clone();
    for &e in &lining {
        let stand_in = mesh.elements.len() as u32;
        mesh.elements.push(mesh.elements[e as usize]);
        problem.lives.push(UNTIL_CHANGE);
        problem.lives[e as usize] = Life { born: Stage::Before(2), ..SINCE_CHANGE };
        problem.stand_ins.push((stand_in, e));
        before.push(stand_in);
    }
    let mut body = ROCK.body("excavated", before, Quadrature::OnePoint);
    body.material = rock;
    problem.bodies.push(body);

    let (_, high) = mesh.bounds();
    let count = mesh.elements.len() as u32;
    let unit_weight = ROCK.density * GRAVITY;
    // Still water, and what the opening draws down: none at 2 m from its lining, all of it 5 m further.
    let still = |z: f64| WATER * (HEAD + high[2] - z);
    let drawn = |[x, _, z]: [f64; 3]| {
        let far = (x - AXIS[0]).hypot(z - AXIS[1]);
        still(z) * ((far - 5.0) / 5.0).clamp(0.0, 1.0)
    };
    let at = |e: u32| centroid(&problem.mesh, e);
    let stress = |e: u32| {
        let z = at(e)[2];
        let vertical = -unit_weight * (ABOVE + high[2] - z);
        let lateral = LATERAL * (vertical + still(z)) - still(z);
        [lateral, lateral, vertical, 0.0, 0.0, 0.0]
    };
    problem.initial = (0..count).map(stress).collect();
    problem.gravity = GRAVITY;
    let mut biot = vec![ALPHA; count as usize];
    lining.iter().for_each(|&e| biot[e as usize] = 0.0);
    let spell = |from: u16, p: &dyn Fn([f64; 3]) -> f64| Spell {
        from: Stage::Before(from),
        elements: (0..count).map(|e| p(at(e))).collect(),
        nodes: problem.mesh.nodes.iter().map(|&x| p(x)).collect(),
    };
    problem.water = Water {
        modulus: vec![modulus; count as usize],
        biot,
        spells: vec![spell(0, &|[_, _, z]| still(z)), spell(1, &drawn)],
    };
    // The pores of what takes the lining's place are those of rock, its own none: they are not one element.
    let above = [0.0, 0.0, -unit_weight * ABOVE, 0.0, 0.0, 0.0];
    let faces = faces_on(&problem.mesh, 0..count, 2, high[2], 1e-6).into_iter().map(|face| (face, above)).collect();
    problem.tractions = vec![Traction { name: "overburden".into(), faces, life: Life::BEFORE }];
    problem.sides = [Side::FreeField; 2];
    problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: None };
    Ok(problem)
}
