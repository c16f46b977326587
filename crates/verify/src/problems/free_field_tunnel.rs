//! A lined tunnel that reaches the sides is in their free field, as a tunnel in plane strain.
//!
//! A slice with a lined opening (`lined`) does not vary along y. With free-field sides across y its slabs hold the same
//! opening, lining and joint, so the model, the slab outside it, and the model with periodic sides across y must move alike. They
//! differ by round-off alone while laws are regular; where concrete cracks and the joint opens, round-off grows with every branch
//! that falls the other way, and the time at which that begins is told.

use tremolite::Domain;
use crate::concrete;
use crate::lined::{END, Joints, slice};
use crate::models::material;
use crate::simulation::{Simulation, whole_steps};
use crate::{Check, Effort, Verification, VerifyError};
use std::collections::BTreeMap;
use tremolite::history::History;
use tremolite::phase::ElementSlot;
use tremolite::{Base, Engine, Side, State};
use tremolite_laws::materials::{Concrete, MohrCoulomb};
use tremolite_laws::{Material, Role, Values};

const NAME: &str = "free_field_tunnel";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a lined tunnel along y: free-field sides, periodic sides and the slab outside move alike",
    source: "a model that does not vary along y",
    from: Effort::Test,
    run,
};

/// Elements along y, of 1 m.
const DEEP: u32 = 3;
const ALONG: [f64; 3] = [0.8, 0.3, 0.52];
/// Motion over the peak that is no more round-off.
const REGULAR: f64 = 1e-8;
const SPRINGS: Base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: None };

/// What the slice is made of.
#[derive(Clone, Copy, PartialEq)]
enum Makeup {
    /// Elastic, lining and rock joined.
    Elastic,
    /// A joint of Bandis' law between them, and rock that yields.
    Jointed,
    /// The same and a lining of the paper's concrete.
    Cracking,
}

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    // The pulse has passed after END; what it broke goes on to ring.
    let end = if effort == Effort::Test { END } else { 5.0 * END };
    for (makeup, word) in [
        (Makeup::Elastic, "elastic"),
        (Makeup::Jointed, "a joint and yielding rock"),
        (Makeup::Cracking, "a joint and cracking concrete"),
    ] {
        let Shaken { rows: [free, slab], damage, slip, yielded } = shake(makeup, Side::FreeField, end)?;
        let Shaken { rows: [periodic, _], .. } = shake(makeup, Side::Periodic, end)?;
        for (other, of) in [(&periodic, "periodic sides"), (&slab, "the slab")] {
            let Apart { before, after, at } = apart(&free, other);
            let quantity = format!("difference from {of} over the peak, {word}");
            if makeup == Makeup::Cracking {
                let note = format!("for information: the largest; it exceeds 1e-8 from {at:.4} s on");
                checks.push(Check::beside(NAME, quantity, before.max(after), 0.0, "1", note));
                let at = at.min(end);
                let quantity = format!("time until which it differs from {of} by less than 1e-8 of the peak, {word}");
                let note = "for information: beside the length of the run; from then on branches of the laws fall differently";
                checks.push(Check::beside(NAME, quantity, at, end, "s", note));
            } else {
                let note = "1e-8: round-off, some hundred branches of the laws included";
                checks.push(Check::new(NAME, quantity, before.max(after), 0.0, REGULAR, "1", note));
            }
        }
        let note = "laws must leave their elastic range, else they say nothing";
        if makeup != Makeup::Elastic {
            let quantity = format!("share of the points of rock that yielded, {word}");
            checks.push(Check::new(NAME, quantity, yielded, 1.0, 0.9, "1", note));
            let quantity = format!("largest slip of the joint over its closure, {word}");
            checks.push(Check::new(NAME, quantity, (slip / CLOSURE).min(1.0), 1.0, 0.9, "1", note));
        }
        if makeup == Makeup::Cracking {
            let quantity = format!("largest tensile damage, {word}");
            checks.push(Check::new(NAME, quantity, damage, 1.0, 0.1, "1", note));
        }
    }
    Ok(checks)
}

/// A run and how far its laws went.
struct Shaken {
    /// Of the model, and of the slab beyond its low side of y if there is one.
    rows: [Rows; 2],
    /// Largest tensile damage.
    damage: f64,
    /// Largest slip of a pair whose bond is broken \[m\].
    slip: f64,
    /// Share of the points of rock that have yielded.
    yielded: f64,
}

/// Largest closure of the joint \[m\].
const CLOSURE: f64 = 2e-3;

/// Displacements \[m\] every thousandth of a second by twice x and z, one of all nodes at such a place.
type Rows = Vec<BTreeMap<[i64; 2], [f64; 3]>>;

/// How far two runs are apart, over the largest displacement.
struct Apart {
    /// Until the first row in which they are by more than [`REGULAR`], and from it on; and its time \[s\].
    before: f64,
    after: f64,
    at: f64,
}

fn apart(a: &Rows, b: &Rows) -> Apart {
    let peak = a.iter().flat_map(BTreeMap::values).flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    let mut apart = Apart { before: 0.0, after: 0.0, at: f64::INFINITY };
    for (k, (a, b)) in a.iter().zip(b).enumerate() {
        let differs = |(key, a): (&[i64; 2], &[f64; 3])| {
            let b = b.get(key).copied().unwrap_or([f64::NAN; 3]);
            (0..3).map(|i| (a[i] - b[i]).abs() / peak).fold(0.0, |most: f64, d| if d <= most { most } else { d })
        };
        let worst = a.iter().map(differs).fold(0.0, |most: f64, d| if d <= most { most } else { d });
        if apart.at.is_infinite() && worst <= REGULAR {
            apart.before = apart.before.max(worst);
            continue;
        }
        apart.at = apart.at.min(1e-3 * k as f64);
        apart.after = if worst <= apart.after { apart.after } else { worst };
    }
    apart
}

fn shake(makeup: Makeup, sides: Side, end: f64) -> Result<Shaken, VerifyError> {
    let numbers = [("normal_stiffness", 5e9), ("max_closure", CLOSURE), ("cohesion", 1e4), ("friction_coefficient", 0.5)];
    let joints = Joints {
        lining: makeup != Makeup::Elastic,
        fault: false,
        law: "bandis",
        numbers: &numbers,
    };
    let mut problem = slice(DEEP, joints, ALONG)?;
    problem.sides = [Side::FreeField, sides];
    problem.base = SPRINGS;
    if makeup != Makeup::Elastic {
        let values = Values::default()
            .with("young", 10e9)
            .with("poisson", 0.25)
            .with("cohesion", 3e5)
            .with("friction_angle", 0.6)
            .with("tensile_strength", 1e5);
        problem.bodies[1].material = material(MohrCoulomb::NAME, &values)?;
    }
    if makeup == Makeup::Cracking {
        problem.bodies[0].material = material(Concrete::NAME, &concrete::values(&[], &[("rate", "ceb")]))?;
        problem.bodies[0].viscosity = 0.06;
    }
    let simulation = Simulation::new(problem)?;
    let stable = simulation.bound();
    // One step for all kinds of sides, whose bounds differ by round-off.
    let step = (stable.to_run(0.85) * 1e7).floor() * 1e-7;
    let (every, dt) = whole_steps(1e-3, step);
    let mut engine: Engine = simulation.engine();
    let mut state = simulation.start(&mut engine, dt, |_| [[0.0; 3]; 2]);
    let mut rows = [Rows::new(), Rows::new()];
    while state.time() < end {
        rows[0].push(section(&simulation, &state, simulation.model.nodes.of(Domain::Model), |y| y.abs() < 1e-6));
        // What lies before the low side of y; the slabs across x do not.
        rows[1].push(section(&simulation, &state, simulation.model.nodes.of(Domain::Slab), |y| y < -1e-6));
        for _ in 0..every {
            engine.step(&mut state);
        }
    }
    engine.finish(&mut state);
    let Simulation { model, assembly, phase, .. } = &simulation;
    let history = History::new(assembly, &state.history);
    let of = |body: usize, role: Role| {
        let slots = model.bodies[body].elements.iter().filter_map(|&e| phase.element_slot[e as usize]);
        let values = |slot: ElementSlot| {
            let column = history.with_role(&slot, role);
            column.into_iter().flat_map(move |column| history.values(&slot, column)).collect::<Vec<_>>()
        };
        slots.flat_map(values).collect::<Vec<f64>>()
    };
    let damage = of(0, Role::TensionDamage).into_iter().fold(0.0, f64::max);
    let plastic = [Role::PlasticShear, Role::PlasticTension].map(|role| of(1, role));
    let yields = plastic[0].iter().zip(&plastic[1]).filter(|(shear, tension)| **shear > 0.0 || **tension > 0.0);
    let yielded = yields.count() as f64 / plastic[0].len().max(1) as f64;
    let totals = model.user_seams().iter().zip(&assembly.contacts);
    let slip = totals.map(|(seam, contacts)| contacts.totals(seam, &state.history).largest_slip).fold(0.0, f64::max);
    Ok(Shaken { rows, damage, slip, yielded })
}

/// Displacements by place in the section; of nodes that interfaces part, the sum.
fn section(
    simulation: &Simulation,
    state: &State,
    nodes: impl Iterator<Item = usize>,
    there: impl Fn(f64) -> bool,
) -> BTreeMap<[i64; 2], [f64; 3]> {
    let mut sums: BTreeMap<[i64; 2], ([f64; 3], f64)> = BTreeMap::new();
    for n in nodes {
        let x = simulation.position(n);
        if !there(x[1]) {
            continue;
        }
        let sum = sums.entry([0, 2].map(|i| (2.0 * x[i]).round() as i64)).or_default();
        (0..3).for_each(|i| sum.0[i] += state.u[n].0[i]);
        sum.1 += 1.0;
    }
    sums.into_iter().map(|(key, (sum, count))| (key, sum.map(|x| x / count))).collect()
}
