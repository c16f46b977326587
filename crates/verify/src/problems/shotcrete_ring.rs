//! A tunnel whose shotcrete is placed when a part of the stress is released, and hardens before the rest is.
//!
//! Thrust and moment of a ring that was placed young are those of two lined openings (`michell`, exact for a thick ring) in
//! sum: one of the young modulus for the share that is let go while it is young, one of the old modulus for the rest; what was
//! let go before it came loads it with nothing, and the change of the modulus itself changes nothing. A ring that had had the
//! old modulus throughout carries more; it is beside.
//!
//! **Model.** As `lined_tunnel`: a quarter out to four radii, 15 cm of shotcrete with 2×2×2 points. Of one element
//! through it, as is usual, thrust is as good, and the moment, a sixtieth of thrust times thickness here, 4 % too large. The
//! first stage takes out the core and the rock in the ring's place and lets go 40 %; the second places the ring and lets go half
//! of what is held, 30 %; the third changes its modulus and lets go the rest. The edge gets, with each of these two shares, the
//! tractions of its own exact solution.

use crate::convergence::order;
use crate::michell::{Lining, Opening};
use crate::models::Solid;
use crate::staged::{Rested, Rings, UNTIL_CHANGE, growing, release};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::FRAC_PI_2;
use tremolite::Traction;
use tremolite::{Life, Quadrature, Stage};

const NAME: &str = "shotcrete_ring";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "shotcrete placed after a part of the release, its modulus changed before the rest: thrust and moment",
    source: "Michell's solution for a thick ring, twice",
    from: Effort::Verify,
    run,
};

/// The vertical stress \[Pa\], and the horizontal one over it.
const PRESSURE: f64 = 5e6;
const LATERAL: f64 = 0.5;
const ROCK: Solid = Solid { young: 2e9, poisson: 0.25, density: 2700.0 };
/// Young's modulus \[Pa\] of shotcrete after hours, and after a month.
const YOUNG: f64 = 5e9;
const HARD: f64 = 25e9;
/// Inner and outer radius \[m\].
const RING: [f64; 2] = [4.0, 4.15];
/// Radius of the edge \[m\].
const EDGE: f64 = 4.0 * RING[1];
/// Shares of what is held that the first and the second stage let go.
const BEFORE: f64 = 0.4;
const WHILE_YOUNG: f64 = 0.5;
/// Elements around the quarter and through the ring: coarse and fine.
const MESHES: [[u32; 2]; 2] = [[24, 2], [48, 4]];

/// The ring in stages: placed, changed with nothing let go, and all let go.
const PLACED: Stage = Stage::Before(2);
const CHANGED: Stage = Stage::Before(3);

fn shotcrete(young: f64) -> Solid {
    Solid { young, poisson: 0.2, density: 2400.0 }
}

fn opening(young: f64) -> Opening {
    let lining = Some(Lining { solid: shotcrete(young), inner: RING[0], joint: None });
    Opening { rock: ROCK, radius: RING[1], far: [-LATERAL * PRESSURE, -PRESSURE], lining }
}

/// Thrust on the mean and in cos 2θ \[N/m\], moment in cos 2θ \[N\], of an opening whose lining was there all the time.
fn exact(young: f64) -> [f64; 3] {
    let solved = opening(young).solve();
    let [beside, above] = [0.0, FRAC_PI_2].map(|angle| solved.section(angle));
    [0.5 * (beside[0] + above[0]), 0.5 * (beside[0] - above[0]), 0.5 * (beside[1] - above[1])]
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let (young, hard) = (exact(YOUNG), exact(HARD));
    let shares = [(1.0 - BEFORE) * WHILE_YOUNG, (1.0 - BEFORE) * (1.0 - WHILE_YOUNG)];
    let expected: Vec<f64> = (0..3).map(|k| shares[0] * young[k] + shares[1] * hard[k]).collect();
    let meshes = [MESHES[0], MESHES[1], [MESHES[1][0], 1]];
    let [coarse, fine, thin] = meshes.map(|mesh| ring(mesh, &[release(WHILE_YOUNG), release(1.0)]));
    let (coarse, fine, thin) = (coarse?, fine?, thin?);
    let mut checks = Vec::new();
    let what = ["mean thrust", "thrust in cos 2θ", "moment in cos 2θ"];
    let units = ["N/m", "N/m", "N"];
    for k in 0..3 {
        let p = order((coarse[k] - expected[k]).abs(), (fine[k] - expected[k]).abs(), 2.0);
        let note = "0.5 % of thrust, 1 % of the moment, as of a lining that is thicker";
        let tolerance = if k == 2 { 0.01 } else { 0.005 } * expected[k].abs();
        checks.push(Check::new(NAME, what[k], fine[k], expected[k], tolerance, units[k], note).with_order(p));
        let note = "for information: one element through it, as is usual";
        let quantity = format!("{}, of one layer", what[k]);
        checks.push(Check::beside(NAME, quantity, thin[k], expected[k], units[k], note));
        let note = "for information: a ring as stiff from the start";
        let stiff = (shares[0] + shares[1]) * hard[k];
        checks.push(Check::beside(NAME, format!("{}, beside a hard ring", what[k]), fine[k], stiff, units[k], note));
    }
    let [placed, changed] = [&[release(WHILE_YOUNG)][..], &[release(WHILE_YOUNG), release(0.0)]]
        .map(|releases| ring(MESHES[0], releases));
    let (placed, changed) = (placed?, changed?);
    let note = "1e-5: at the same ν the change itself moves nothing; 1e-9 of all contributions is out of balance at rest";
    for k in [0, 2] {
        let quantity = format!("{}, after the change alone over before", what[k]);
        checks.push(Check::new(NAME, quantity, changed[k] / placed[k], 1.0, 1e-5, "1", note));
    }
    Ok(checks)
}

/// Thrust and moment as of [`exact`] at the end of stages that place the ring and change it.
fn ring([around, layers]: [u32; 2], releases: &[tremolite::engine::Release]) -> Result<[f64; 3], VerifyError> {
    let [inner, outer] = RING;
    let mut radii: Vec<f64> = (0..=4).map(|i| inner * f64::from(i) / 4.0).collect();
    radii.extend((1..=layers).map(|i| inner + (outer - inner) * f64::from(i) / f64::from(layers)));
    radii.extend(growing(outer, EDGE, FRAC_PI_2 / f64::from(around)));
    let rings = Rings::new(radii, around, false);
    let (lining, core) = (rings.between(inner, outer), rings.between(0.0, inner));
    let mut rock = rings.between(outer, EDGE);
    let mut mesh = rings.mesh.clone();
    let mut lives = vec![Life::ALWAYS; mesh.elements.len()];
    core.iter().for_each(|&e| lives[e as usize] = UNTIL_CHANGE);
    rock.extend(&core);
    let (mut stand_ins, mut successors, mut first) = (Vec::new(), Vec::new(), Vec::new());
    for &e in &lining {
        lives[e as usize] = Life { born: CHANGED, gone: None };
        // The rock in its place, and the ring while it is young.
        for life in [UNTIL_CHANGE, Life { born: PLACED, gone: Some(CHANGED) }] {
            let other = mesh.elements.len() as u32;
            stand_ins.push((other, e));
            mesh.elements.push(mesh.elements[e as usize]);
            lives.push(life);
            if life == UNTIL_CHANGE {
                rock.push(other);
            } else {
                first.push(other);
                successors.push((e, other));
            }
        }
    }
    let far = [-LATERAL * PRESSURE, -ROCK.poisson * (1.0 + LATERAL) * PRESSURE, -PRESSURE, 0.0, 0.0, 0.0];
    let mut initial = vec![far; mesh.elements.len()];
    let brick = rings.brick();
    let unstressed = lining.iter().chain(&first).chain(&brick.elements);
    unstressed.for_each(|&e| initial[e as usize] = [0.0; 6]);
    let bodies = vec![
        ROCK.body("rock", rock, Quadrature::OnePoint),
        shotcrete(YOUNG).body("young", first.clone(), Quadrature::Full),
        shotcrete(HARD).body("hard", lining.clone(), Quadrature::Full),
        brick,
    ];
    let mut problem = tremolite::Problem::new(mesh, bodies);
    problem.lives = lives;
    problem.stand_ins = stand_ins;
    problem.successors = successors;
    problem.initial = initial;
    problem.held = rings.symmetry();
    // Of each share that is let go with the ring in place, the exact change at the edge.
    let (young, hard) = (opening(YOUNG).solve(), opening(HARD).solve());
    let part = |share: f64, more: [f64; 6], less: [f64; 6]| [0, 1, 2, 3, 4, 5].map(|i| share * (more[i] - less[i]));
    let while_young = |angle| part(1.0 - BEFORE, young.change(EDGE, angle), [0.0; 6]);
    let since = |angle| part((1.0 - BEFORE) * (1.0 - WHILE_YOUNG), hard.change(EDGE, angle), young.change(EDGE, angle));
    let life = |born| Life { born, gone: None };
    problem.tractions = vec![
        Traction { name: "far".into(), faces: rings.edge(|_| far), life: Life::BEFORE },
        Traction { name: "while young".into(), faces: rings.edge(while_young), life: life(PLACED) },
        Traction { name: "since".into(), faces: rings.edge(since), life: life(CHANGED) },
    ];
    let releases = [&[release(1.0), release(BEFORE)], releases].concat();
    let rested = Rested::new(problem, &releases)?;
    let now = if releases.len() > 3 { &lining } else { &first };
    Ok(rings.section(&rested, now, RING))
}
