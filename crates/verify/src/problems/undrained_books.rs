//! Elements whose water cannot leave their pores: pressure, strength, no locking, and the books of all that.
//!
//! **Point.** Pure shear changes no volume, and so no pressure: rock under −6 MPa all round with p of water and Mohr–Coulomb without dilation
//! bears c cos φ + (6 MPa − p) sin φ (`terzaghi1943`). A uniform strain with the dilatation θ gives p − αMθ, and no less than −100 kPa.
//!
//! **Bending.** What an element's bending modes stretch on one side they shorten on the other: no mean dilatation, and so no pressure and no more
//! stiffness, with as many points as there may be. By the dilatation of each point bricks of several would lock as M/G grows.
//!
//! **Books.** A distorted block that was brought to rest under water is shaken by forces on its top, elastic, yielding with dilation, and where the
//! pressure comes down to the floor. Every force is in a line, by the trapezoidal rule of the scheme: what is left is the ⅛Δt²aᵀMa that belongs to it,
//! and what a plastic law books of its own by σ'⁺ alone, ½Δσ':Δε_p, which is taken off here.

use crate::models::{LAYERED, QUADRATURES, Solid, column, distorted, material, nodes_at_level, shared};
use crate::simulation::Simulation;
use crate::staged::release;
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::engine::Look;
use tremolite::history::History;
use tremolite::stages::{PlannedStage, settle};
use tremolite::water::{Spell, with_pressure};
use tremolite::{Assembly, Base, Engine, Life, Line, Model, Phase, Problem, Quadrature, Side, Snapshot, Stage, State, Traction, Water, stable_step};
use tremolite_laws::materials::MohrCoulomb;
use tremolite_laws::{Material, Role, Row, Values};
use tremolite_mesh::Face;
use tremolite_mesh::boxes::BoxSpec;

const NAME: &str = "undrained_books";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "undrained elements: strength in pure shear, pressure down to its floor, no locking, and a balance that closes",
    source: "`terzaghi1943`, `biot1941`; the balance of the scheme",
    from: Effort::Test,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
const MODULUS: f64 = 43e9;
/// c \[Pa\], φ \[°\]
const COHESION: f64 = 0.5e6;
const FRICTION: f64 = 35.0;
/// Total stress all round \[Pa\].
const TOTAL: f64 = -6e6;

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let all = [QUADRATURES[0], QUADRATURES[1], LAYERED];
    for (quadrature, word) in all {
        for (p, exact) in [(1e6, 3277458.2038997263), (2e6, 2703881.7675486803), (4e6, 1556728.8948465881)] {
            let strained = strained(quadrature, 1.0, p, 0.0, |[_, _, z]| [4e-3 * z, 0.0, 0.0])?;
            let note = "round-off: one return to the yield surface; by total stress it would be 3.851 MPa";
            let quantity = format!("shear that rock bears undrained, p = {} MPa, {word}", p / 1e6);
            checks.push(Check::new(NAME, quantity, strained.stress[5], exact, 1e-6 * exact, "Pa", note));
            let quantity = format!("pressure in pure shear, p = {} MPa, {word}", p / 1e6);
            checks.push(Check::new(NAME, quantity, strained.pressure, p, 1e-6 * p, "Pa", "round-off"));
        }
        for alpha in [1.0, 0.6] {
            // Of −9·10⁻⁶ and of +6·10⁻⁵, which would take off more than there is.
            for (theta, exact) in [(-9e-6, 1e6 + alpha * MODULUS * 9e-6), (6e-5, -1e5)] {
                let stretch = |[x, y, z]: [f64; 3]| [0.5 * theta * x, 0.2 * theta * y, 0.3 * theta * z];
                let strained = strained(quadrature, alpha, 1e6, f64::INFINITY, stretch)?;
                let quantity = format!("pressure at a dilatation of {theta:.0e}, α = {alpha}, {word}");
                checks.push(Check::new(NAME, quantity, strained.pressure, exact, 1e-9 * exact.abs(), "Pa", "round-off"));
                let moduli = ROCK.moduli();
                let bulk = moduli.lambda + 2.0 / 3.0 * moduli.mu;
                let mean = strained.stress[..3].iter().sum::<f64>() / 3.0;
                let by_biot = TOTAL + bulk * theta - alpha * (exact - 1e6);
                let quantity = format!("mean total stress at a dilatation of {theta:.0e}, α = {alpha}, {word}");
                checks.push(Check::new(NAME, quantity, mean, by_biot, 1e-9 * by_biot.abs(), "Pa", "round-off: Kθ − αΔp"));
            }
        }
        let quantity = format!("stiffness that water adds to bending, over that of the rock, {word}");
        let note = "round-off: no mean dilatation; by that of each point it would be of the order of M/E";
        checks.push(Check::new(NAME, quantity, bending(quadrature)?, 0.0, 1e-12, "1", note));
    }
    for alpha in [1.0, 0.6] {
        let note = "energy falls from 1: every crossing of the floor takes some; by p = max(…) alone it grows a thousandfold and more";
        let quantity = format!("energy of motion of a struck box after 2,000 steps at the floor, over the first, α = {alpha}");
        checks.push(Check::new(NAME, quantity, struck(alpha)?, 0.0, 1.0, "1", note));
    }
    for (quadrature, word) in QUADRATURES {
        for alpha in [1.0, 0.6] {
            for (what, kind) in [("elastic", Kind::Elastic), ("yielding with dilation", Kind::Yields), ("down to the floor", Kind::Floor)] {
                let shaken = shake(quadrature, alpha, kind)?;
                if shaken.seen == 0.0 {
                    return Err(VerifyError::Setup(format!("nothing is {what}, α = {alpha}, {word}")));
                }
                let note = "1e-13: round-off of some hundred sums";
                let quantity = format!("error of the balance beyond the scheme's over the peak kinetic energy, {what}, α = {alpha}, {word}");
                checks.push(Check::new(NAME, quantity, shaken.error, 0.0, 1e-13, "1", note));
            }
        }
    }
    Ok(checks)
}

/// α and p in a problem's elements, which began under the total stress.
fn wet(problem: &mut Problem, alpha: f64, modulus: f64, p: f64) {
    let count = problem.mesh.elements.len();
    problem.initial = vec![[TOTAL, TOTAL, TOTAL, 0.0, 0.0, 0.0]; count];
    let nodes = vec![p; problem.mesh.nodes.len()];
    problem.water = Water {
        biot: vec![alpha; count],
        modulus: vec![modulus; count],
        spells: vec![Spell { from: Stage::Before(0), elements: vec![p; count], nodes }],
    };
}

/// Mohr–Coulomb with a dilation \[°\].
fn yielding(dilation: f64) -> Result<std::sync::Arc<dyn tremolite::AnyMaterial>, VerifyError> {
    let values = Values::default()
        .with("young", ROCK.young)
        .with("poisson", ROCK.poisson)
        .with("cohesion", COHESION)
        .with("friction_angle", FRICTION.to_radians())
        .with("dilation_angle", f64::to_radians(dilation))
        .with("tensile_strength", 0.0);
    material(MohrCoulomb::NAME, &values)
}

struct Strained {
    /// Total, of a point \[Pa\].
    stress: [f64; 6],
    pressure: f64,
}

/// A leaning element after a displacement; without an angle of dilation, given as infinite, it is elastic.
fn strained(
    quadrature: Quadrature,
    alpha: f64,
    p: f64,
    dilation: f64,
    u: impl Fn([f64; 3]) -> [f64; 3],
) -> Result<Strained, VerifyError> {
    let mut mesh = BoxSpec::uniform([0.0; 3], [2.0, 3.0, 1.0], [1; 3]).mesh()?;
    mesh.nodes.iter_mut().for_each(|x| x[0] += 0.2 * x[1]);
    mesh.nodes[7][2] += 0.1;
    let mut problem = ROCK.fill(mesh, quadrature);
    if dilation.is_finite() {
        problem.bodies[0].material = yielding(dilation)?;
    }
    wet(&mut problem, alpha, MODULUS, p);
    let simulation = Simulation::on_one_level(problem)?;
    let mut engine = simulation.engine();
    let dt = 0.5 * simulation.stable();
    let mut state = simulation.start(&mut engine, dt, |_| [[0.0; 3]; 2]);
    state.u = (0..state.u.len()).map(|n| Row::new(u(simulation.position(n)))).collect();
    // Twice: the step that comes down to the floor lies below it.
    engine.finish(&mut state);
    let Snapshot { stress, pore, .. } = engine.look(&state).snapshot;
    Ok(Strained { stress: stress[0], pressure: pore[0] })
}

/// Largest change of K w by water over the largest of K w, w an element bent about each axis.
fn bending(quadrature: Quadrature) -> Result<f64, VerifyError> {
    let mut worst = 0.0_f64;
    let modes: [fn([f64; 3]) -> [f64; 3]; 3] =
        [|[x, _, z]| [x * z, 0.0, 0.0], |[x, y, _]| [0.0, x * y, 0.0], |[_, y, z]| [0.0, 0.0, y * z]];
    for mode in modes {
        let products: Vec<Vec<Row>> = [0.0, MODULUS]
            .into_iter()
            .map(|modulus| {
                let mesh = BoxSpec::uniform([-1.0, -1.5, -0.5], [1.0, 1.5, 0.5], [1; 3]).mesh()?;
                let mut problem = ROCK.fill(mesh, quadrature);
                wet(&mut problem, 1.0, modulus, 1e6);
                let simulation = Simulation::on_one_level(problem)?;
                let part = &simulation.assembly.members[0].part;
                let w: Vec<Row> =
                    (0..8).map(|n| Row::new(mode(simulation.position(n)))).collect();
                let mut out = vec![Row::ZERO; part.nodes().len()];
                part.stiffness_times(&w, &mut out, &mut tremolite::parts::Scratch::default());
                Ok(out)
            })
            .collect::<Result<_, VerifyError>>()?;
        let most = products[0].iter().flat_map(Row::xyz).fold(0.0_f64, |m, f| m.max(f.abs()));
        let both = products[0].iter().flat_map(Row::xyz).zip(products[1].iter().flat_map(Row::xyz));
        worst = both.fold(worst, |m, (a, b)| m.max((a - b).abs() / most));
    }
    Ok(worst)
}

/// Energy of motion over that at the start of a box whose top is struck, with hardly any pressure in its pores, at 0.9 of the stable step.
fn struck(alpha: f64) -> Result<f64, VerifyError> {
    let mut problem = ROCK.fill(distorted([6.0; 3], [6; 3], 0.1)?, Quadrature::OnePoint);
    let p = 1e4;
    wet(&mut problem, alpha, MODULUS, p);
    problem.initial = vec![[-p, -p, -p, 0.0, 0.0, 0.0]; problem.mesh.elements.len()];
    problem.base = Base::Fixed;
    let simulation = Simulation::on_one_level(problem)?;
    let mut engine = simulation.engine();
    let mut state = simulation.start(&mut engine, 0.9 * simulation.stable(), |n| {
        [[0.0; 3], if simulation.position(n)[2] > 5.5 { [0.05, 0.0, -0.1] } else { [0.0; 3] }]
    });
    let moving = |state: &State| -> f64 {
        let square = |n: usize| state.du[n].xyz().iter().map(|d| d * d).sum::<f64>();
        (0..state.du.len()).map(|n| simulation.phase.mass[n] * square(n)).sum()
    };
    engine.step(&mut state);
    let first = moving(&state);
    for _ in 0..2000 {
        engine.step(&mut state);
    }
    Ok(moving(&state) / first)
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Elastic,
    Yields,
    Floor,
}

struct Shaken {
    /// Error beyond the scheme's over the peak kinetic energy.
    error: f64,
    /// What the kind wants to be seen: energy of motion, plastic energy, or elements at the floor.
    seen: f64,
}

/// A block that rests under water, shaken by forces on its top; a column where one point yields, in which no hourglass mode moves.
fn shake(quadrature: Quadrature, alpha: f64, kind: Kind) -> Result<Shaken, VerifyError> {
    let p = if kind == Kind::Floor { 0.05e6 } else { 2e6 };
    let column_of_points = kind == Kind::Yields && quadrature == Quadrature::OnePoint;
    let (mesh, side) = match column_of_points {
        true => (column(1.0, 8, 1)?, 1.0),
        false => (distorted([4.0; 3], [4; 3], 0.14)?, 4.0),
    };
    let mut problem = ROCK.fill(mesh, quadrature);
    if column_of_points {
        problem.sides = [Side::Periodic; 2];
    }
    if kind == Kind::Yields {
        problem.bodies[0].material = yielding(12.0)?;
    }
    wet(&mut problem, alpha, MODULUS, p);
    problem.base = Base::Fixed;
    let (_, [.., height]) = problem.mesh.bounds();
    let top = nodes_at_level(&problem.mesh, 2, height);
    // Of the order of the stress that is there.
    let push = [2.4e6, 1.1e6, if kind == Kind::Floor { 3.0e6 } else { -0.9e6 }].map(|s| s * side * side);
    problem.loads.push(shared(&top, push, |t| if t > 0.0 { (2e3 * t).sin() * (-200.0 * t).exp() } else { 0.0 }));
    let (count, area) = (problem.mesh.elements.len() as u32, (side * side) as u32);
    let faces = (count - area..count).map(|element| (Face { element, side: 5 }, problem.initial[0])).collect();
    problem.tractions.push(Traction { name: "top".into(), faces, life: Life::ALWAYS });
    let model = Model::new(problem)?;
    let assembly = Assembly::new(&model)?;
    let stage = PlannedStage { release: release(1.0), ..PlannedStage::new("equilibrium") };
    let (mut state, _) = settle(&model, &assembly, &[stage])
        .map_err(|unsettled| VerifyError::Setup(format!("{unsettled:?}")))?;
    let phase = Phase::of(&model, &assembly, Stage::Shaking)?;
    let mut engine = Engine::new(&model, &assembly, &phase);
    let dt = 0.9 * stable_step(&model, &assembly, &phase).dt;
    engine.hand_over(&mut state, dt);
    let mut law = (kind == Kind::Yields).then(|| LawBooks::new(&model, &assembly, &phase, engine.look(&state)));
    let (mut error, mut peak, mut seen) = (0.0_f64, 0.0_f64, 0.0_f64);
    for step in 0..200 {
        engine.step(&mut state);
        if step % 5 < 4 && law.is_none() {
            continue;
        }
        let look = engine.look(&state);
        let Snapshot { balance, scheme, pore, .. } = &look.snapshot;
        let of_law = law.as_mut().map_or(0.0, |law| law.add(&assembly, &phase, &look));
        error = error.max((balance[Line::Error] - scheme - of_law).abs());
        peak = peak.max(balance[Line::Kinetic]);
        seen = seen.max(match kind {
            Kind::Elastic => balance[Line::Kinetic],
            Kind::Yields => balance[Line::Dissipated],
            Kind::Floor => pore.iter().filter(|p| **p == -1e5).count() as f64,
        });
    }
    Ok(Shaken { error: error / peak, seen })
}

/// What a plastic law books too much: it has σ'⁺:Δε_p, and by the trapezoidal rule it would be ½(σ' + σ'⁺):Δε_p.
struct LawBooks {
    /// Of each point \[m³\].
    weights: Vec<f64>,
    /// Effective stress \[Pa\] and plastic strain of each.
    last: Vec<[[f64; 6]; 2]>,
    sum: f64,
}

impl LawBooks {
    fn new(model: &Model, assembly: &Assembly, phase: &Phase, look: Look) -> Self {
        let mut weights = vec![0.0; look.snapshot.stress.len()];
        for (e, slot) in phase.element_slot.iter().enumerate() {
            let (Some(slot), Ok(hex)) = (slot, tremolite::hexahedra::hex(&model.mesh, e)) else { continue };
            for p in 0..slot.points as usize {
                weights[slot.point as usize + p] = if slot.points == 1 { hex.volume } else { hex.weights[p] };
            }
        }
        LawBooks { last: LawBooks::points(assembly, phase, &look), weights, sum: 0.0 }
    }

    fn points(assembly: &Assembly, phase: &Phase, look: &Look) -> Vec<[[f64; 6]; 2]> {
        let history = History::new(assembly, &look.history);
        let mut all = vec![[[0.0; 6]; 2]; look.snapshot.stress.len()];
        for slot in phase.element_slot.iter().flatten() {
            let Some(first) = history.with_role(slot, Role::PlasticStrain) else { continue };
            for p in 0..slot.points as usize {
                let at = slot.point as usize + p;
                let own = &mut all[at];
                own[0] = with_pressure(look.snapshot.stress[at], look.snapshot.pore[slot.element as usize]);
                own[1] = [0, 1, 2, 3, 4, 5].map(|c| history.values(slot, first + c).nth(p).unwrap_or(f64::NAN));
            }
        }
        all
    }

    fn add(&mut self, assembly: &Assembly, phase: &Phase, look: &Look) -> f64 {
        let now = LawBooks::points(assembly, phase, look);
        for ((now, last), weight) in now.iter().zip(&self.last).zip(&self.weights) {
            let dot: f64 = (0..6).map(|c| (now[0][c] - last[0][c]) * (now[1][c] - last[1][c])).sum();
            self.sum += 0.5 * weight * dot;
        }
        self.last = now;
        self.sum
    }
}
