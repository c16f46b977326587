//! How what is held is let go: faster or slower, at once or in benches.
//!
//! A square opening of 8 m in Mohr–Coulomb rock at a depth of 300 m with K₀ = 0.8, excavated in one stage, and with a lining of half a
//! metre that the last part of the release damages. What yields or softens depends on the path to rest. A ramp of 200 cycles must be
//! as good as one of 400 by what is judged: ∫Γ dV, the mean motion of the wall, the mean damage of a lining that softens
//! exponentially. That is so with a fifth of the lining damaged (0.187, 0.186, 0.186, 0.186 after 200, 400, 800, 1600 cycles). At its
//! onset mean damage is that of a few points (0.018, 0.019, 0.0196, 0.020), and a law that softens to a residual strength jumps from one
//! pattern of cracks to another where it is near to both (0.292 after 100 cycles, 0.333 after 200): both are for information.
//!
//! Two benches end where one does if all is elastic; where rock yields they need not.

use crate::models::{Solid, material};
use crate::staged::{Rested, UNTIL_CHANGE};
use crate::{Check, Effort, Verification, VerifyError, concrete};
use tremolite::engine::Release;
use tremolite::hexahedra::{centroid, hex};
use tremolite::history::History;
use tremolite::Traction;
use tremolite::{Life, Quadrature, Stage};
use tremolite_laws::materials::{Concrete, MohrCoulomb};
use tremolite_laws::{Material, Role, Values};
use tremolite_mesh::Mesh;
use tremolite_mesh::boxes::{Axis, BoxSpec};

const NAME: &str = "release_ramp";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "ramps of 200 and 400 cycles, one bench and two: flow of rock, motion of the wall, damage of a lining",
    source: "agreement of paths to the same end",
    from: Effort::Verify,
    run,
};

const ROCK: Solid = Solid { young: 5e9, poisson: 0.25, density: 2600.0 };
const GRAVITY: f64 = 9.81;
/// Lines of the mesh from the middle of the opening outwards \[m\].
const LINES: [f64; 10] = [1.75, 3.5, 4.0, 4.5, 5.25, 6.5, 8.5, 11.5, 16.0, 22.0];
/// Half the opening, and within the lining \[m\].
const HALF: f64 = 4.0;
const CLEAR: f64 = 3.5;
/// Ground above the block \[m\], and K₀.
const ABOVE: f64 = 280.0;
const LATERAL: f64 = 0.8;
/// φ and ψ \[°\], f_t \[Pa\]
const STRENGTH: [f64; 3] = [38.0, 8.0, 0.3e6];
/// c \[Pa\] of rock without a lining and of rock behind one.
const WEAK: f64 = 0.8e6;
const FIRM: f64 = 1.2e6;

/// What is done in stages.
#[derive(Clone, Copy, PartialEq)]
enum Works {
    One,
    Benches,
    /// A lining whose law softens so, and the share released before it comes.
    Lined(&'static str, f64),
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let weak = |cycles| excavate(Some(WEAK), Works::One, cycles);
    let [once, fast, slow] = [weak(1)?, weak(200)?, weak(400)?];
    let note = "1 %: far below what a mesh errs; judged by sums, as single nodes depend on the path more";
    let firm = |what: &str, fast: f64, slow: f64| {
        Check::new(NAME, format!("{what}, 200 cycles over 400"), fast / slow, 1.0, 0.01, "1", note)
    };
    let beside = |quantity: String, value: f64, reference: f64, note: &str| {
        Check::beside(NAME, quantity, value, reference, "1", format!("for information: {note}"))
    };
    checks.push(firm("∫Γ dV", fast.flow, slow.flow));
    checks.push(firm("mean motion of the wall", fast.motion, slow.motion));
    let note = "without a ramp rock yields on the way that need not at rest";
    let quantity = |what: &str| format!("{what}, released at once over 400 cycles");
    checks.push(beside(quantity("∫Γ dV"), once.flow / slow.flow, 1.0, note));
    checks.push(beside(quantity("mean motion of the wall"), once.motion / slow.motion, 1.0, note));
    let note = "so much there is to compare";
    checks.push(beside("∫Γ dV over the opening's volume".into(), fast.flow, 0.0, note));

    for (cohesion, evolution, share, tested) in [
        (FIRM, "exponential", 0.85, true),
        (WEAK, "exponential", 0.95, false),
        (FIRM, "residual", 0.85, false),
        (FIRM, "residual", 0.8, false),
    ] {
        let [fast, slow] = [200, 400].map(|cycles| excavate(Some(cohesion), Works::Lined(evolution, share), cycles));
        let (fast, slow) = (fast?, slow?);
        let what = format!("mean damage of a lining after {share}, {evolution}");
        checks.push(beside(what.clone(), fast.damage, 0.0, note));
        if tested {
            checks.push(firm(&what, fast.damage, slow.damage));
            checks.push(firm("∫Γ dV behind that lining", fast.flow, slow.flow));
        } else {
            let why = "few points at onset, and jumps between patterns of cracks";
            checks.push(beside(format!("{what}, 200 cycles over 400"), fast.damage / slow.damage, 1.0, why));
        }
    }

    let [one, two] = [Works::One, Works::Benches].map(|works| excavate(None, works, 200));
    let note = "1e-6: all is linear; what is out of balance at rest is 1e-9 of all contributions";
    let quantity = "mean motion of the wall, two benches over one, elastic";
    checks.push(Check::new(NAME, quantity, two?.motion / one?.motion, 1.0, 1e-6, "1", note));
    let two = excavate(Some(WEAK), Works::Benches, 200)?;
    let note = "rock that yields remembers the path";
    let quantity = |what: &str| format!("{what}, two benches over one, yielding");
    checks.push(beside(quantity("mean motion of the wall"), two.motion / fast.motion, 1.0, note));
    checks.push(beside(quantity("∫Γ dV"), two.flow / fast.flow, 1.0, note));
    Ok(checks)
}

/// What stages came to.
struct Outcome {
    /// ∫Γ dV of the rock over the volume of the opening.
    flow: f64,
    /// Mean length of the motion of the wall \[m\].
    motion: f64,
    /// Mean damage of the lining.
    damage: f64,
}

fn mesh() -> Result<Mesh, VerifyError> {
    let lines: Vec<f64> = LINES.iter().rev().map(|x| -x).chain([0.0]).chain(LINES).collect();
    let axis = || Axis::Coordinates(lines.clone());
    Ok(BoxSpec { x: axis(), y: Axis::uniform(0.0, 1.0, 1), z: axis(), distortion: None }.mesh()?)
}

/// With rock of a cohesion \[Pa\], elastic if none.
fn excavate(cohesion: Option<f64>, works: Works, cycles: u64) -> Result<Outcome, VerifyError> {
    let mut mesh = mesh()?;
    let far = |x: [f64; 3]| x[0].abs().max(x[2].abs());
    let centres: Vec<[f64; 3]> = (0..mesh.elements.len() as u32).map(|e| centroid(&mesh, e)).collect();
    let mut lives = vec![Life::ALWAYS; mesh.elements.len()];
    let (mut rock, mut lining, mut stand_ins) = (Vec::new(), Vec::new(), Vec::new());
    for (e, &x) in (0u32..).zip(&centres) {
        let rest_of_bench = works == Works::Benches && x[2] < 0.0;
        let gone = Some(Stage::Before(if rest_of_bench { 2 } else { 1 }));
        match (works, far(x)) {
            (Works::Lined(..), r) if r > CLEAR && r < HALF => {
                lives[e as usize] = Life { born: Stage::Before(2), gone: None };
                let twin = mesh.elements.len() as u32;
                mesh.elements.push(mesh.elements[e as usize]);
                lives.push(UNTIL_CHANGE);
                stand_ins.push((twin, e));
                rock.push(twin);
                lining.push(e);
                continue;
            }
            (_, r) if r < HALF => lives[e as usize] = Life { born: Stage::Before(0), gone },
            _ => {}
        }
        rock.push(e);
    }
    let high = mesh.bounds().1[2];
    let stress = |z: f64| {
        let s = -ROCK.density * GRAVITY * (ABOVE + high - z);
        [LATERAL * s, LATERAL * s, s, 0.0, 0.0, 0.0]
    };
    let of = |e: usize| if lining.contains(&(e as u32)) { [0.0; 6] } else { stress(centroid(&mesh, e as u32)[2]) };
    let initial = (0..mesh.elements.len()).map(of).collect();
    let top = mesh.faces["top"].iter().map(|&face| (face, stress(high))).collect();
    let nodes = mesh.nodes.clone();
    let mut body = ROCK.body("rock", rock.clone(), Quadrature::OnePoint);
    if let Some(cohesion) = cohesion {
        let [friction, dilation, tension] = STRENGTH;
        let values = Values::default()
            .with("young", ROCK.young)
            .with("poisson", ROCK.poisson)
            .with("cohesion", cohesion)
            .with("friction_angle", friction.to_radians())
            .with("dilation_angle", dilation.to_radians())
            .with("tensile_strength", tension);
        body.material = material(MohrCoulomb::NAME, &values)?;
    }
    let mut bodies = vec![body];
    let mut releases = vec![Release { cycles, tolerance: [1e-9, 1e-7], most: 200_000, ..Release::default() }; 2];
    match works {
        Works::One => {}
        Works::Benches => releases.push(releases[1]),
        Works::Lined(evolution, share) => {
            releases.push(releases[1]);
            releases[1].share = share;
            let solid = Solid { young: concrete::YOUNG, poisson: concrete::POISSON, density: 2400.0 };
            let mut body = solid.body("lining", lining.clone(), Quadrature::Full);
            let energy: &[(&str, f64)] = &[("fracture_energy", 130.0)];
            let values = concrete::values(energy, &[("evolution", evolution)]);
            body.material = material(Concrete::NAME, &values)?;
            bodies.push(body);
        }
    }
    let mut problem = tremolite::Problem::new(mesh, bodies);
    problem.lives = lives;
    problem.stand_ins = stand_ins;
    problem.initial = initial;
    problem.gravity = GRAVITY;
    problem.tractions = vec![Traction { name: "above".into(), faces: top, life: Life::BEFORE }];
    let rested = Rested::new(problem, &releases)?;

    let wall = |x: &[f64; 3]| (far(*x) - HALF).abs() < 1e-9;
    let wall: Vec<u32> = (0..nodes.len() as u32).filter(|&n| wall(&nodes[n as usize])).collect();
    let lengths = wall.iter().map(|&n| rested.shown(n).iter().map(|u| u * u).sum::<f64>().sqrt());
    let motion = lengths.sum::<f64>() / wall.len() as f64;
    let history = History::new(&rested.assembly, &rested.state.history);
    let sum = |elements: &[u32], role: Role| {
        let (mut sum, mut all) = (0.0, 0.0);
        for &e in elements {
            let Some(slot) = rested.phase.element_slot[e as usize] else { continue };
            let volume = hex(&rested.model.mesh, e as usize).map_or(0.0, |hex| hex.corner_volumes.iter().sum());
            let values = history.with_role(&slot, role).map(|column| history.values(&slot, column));
            let mean = values.map_or(0.0, |values| values.sum::<f64>() / f64::from(slot.points));
            sum += volume * mean;
            all += volume;
        }
        (sum, all)
    };
    let (flow, _) = sum(&rock, Role::PlasticShear);
    let (damage, volume) = sum(&lining, Role::MeanDamagePeak);
    Ok(Outcome { flow: flow / (4.0 * HALF * HALF), motion, damage: damage / volume })
}
