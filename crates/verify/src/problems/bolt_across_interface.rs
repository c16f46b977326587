//! A bolt through a joint that opens, or slides along its own plane, given the motion of both sides.
//!
//! Two blocks that part rigidly by δ, their joint level or leaning. Where the bolt is bonded, it is pulled out of both:
//! the slips at the joint are together δ·t, t along the bolt, and the force there is the same on both sides (`bolted::Bonded`);
//! without sliding N = EA β δ·t/(coth βL₁ + coth βL₂). The bond of the shorter side gives way altogether where
//! N = S L₁, whatever δ is then.
//!
//! Where it moves with the rock, what the joint opens is the strain of the one segment that runs through it, which ends where the
//! bolt leaves the elements beside the joint: N = EA δ·t/ℓ goes by the mesh, and doubles as elements are halved.

use std::sync::Arc;
use crate::bolted::{AREA, Bonded, STEEL, bisect, bolts};
use crate::convergence::order;
use crate::joints::joint;
use crate::models::Solid;
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::bolts::SegmentSeen;
use tremolite::hexahedra::centroid;
use tremolite::{Assembly, Bolts, Engine, Model, Phase, Quadrature, Side, Stage};
use tremolite_laws::Row;
use tremolite_mesh::boxes::BoxSpec;

const NAME: &str = "bolt_across_interface";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a bolt across a joint that opens or slides: bonded within and beyond the bond's strength, and without bond",
    source: "two bars pulled out of elastic and perfectly plastic sliders, solved in closed form in `bolted`",
    from: Effort::Test,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
/// Height of the blocks together, and that of their joint in the middle of plan \[m\]; of a block in plan.
const HIGH: f64 = 8.0;
const JOINT: f64 = 4.0;
const WIDE: f64 = 4.0;
/// On the side of the head, and on the other.
const BELOW: Bonded = Bonded { bar: STEEL * AREA, bond: 1e8, strength: 50e3, length: 1.5 };
const ABOVE: Bonded = Bonded { length: 2.5, ..BELOW };
/// Longest segments \[m\].
const SEGMENTS: [f64; 3] = [0.1, 0.05, 0.025];

/// A joint with a bolt and a motion of what is above.
struct Case {
    word: &'static str,
    /// Rise of the joint along x.
    lean: f64,
    /// Along the bolt, head below.
    along: [f64; 3],
    /// Direction in which what is above moves.
    moves: [f64; 3],
}

const CASES: [Case; 3] = [
    Case { word: "opening, bolt at right angles", lean: 0.0, along: [0.0, 0.0, 1.0], moves: [0.0, 0.0, 1.0] },
    Case { word: "opening, oblique bolt", lean: 0.0, along: [0.36, -0.48, 0.8], moves: [0.0, 0.0, 1.0] },
    Case {
        word: "sliding along a leaning joint",
        lean: 0.25,
        along: [0.48, 0.36, 0.8],
        moves: [1.0, 0.0, 0.25],
    },
];

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for case in &CASES {
        checks.extend(bonded(case)?);
    }
    checks.extend(moving_with_the_rock()?);
    Ok(checks)
}

/// Force \[N\] at a joint whose sides part by δ \[m\] along the bolt.
fn force_at(parting: f64) -> f64 {
    let most = BELOW.strength * BELOW.length;
    bisect(0.0, most, |pull| BELOW.slip(pull, 0.0) + ABOVE.slip(pull, 0.0) < parting)
}

/// Forces of the segments with the places of their ends \[m\] above the joint.
fn forces(
    case: &Case,
    kind: Bolts,
    elements: u32,
    parting: f64,
) -> Result<(Arc<Model>, Vec<SegmentSeen>), VerifyError> {
    let mut mesh =
        BoxSpec::uniform([0.0; 3], [WIDE, WIDE, HIGH], [elements / 2, elements / 2, elements]).mesh()?;
    let all = 0..mesh.elements.len() as u32;
    let (below, above): (Vec<u32>, Vec<u32>) = all.partition(|&e| centroid(&mesh, e)[2] < JOINT);
    for x in &mut mesh.nodes {
        x[2] += case.lean * (x[0] - 0.5 * WIDE) * (1.0 - (x[2] - JOINT).abs() / JOINT);
    }
    let mut problem = ROCK.fill(mesh, Quadrature::OnePoint);
    let numbers = [("normal_stiffness", 10e9), ("friction_coefficient", 0.5), ("cohesion", 0.0)];
    problem.interfaces = vec![joint([below, above.clone()], "coulomb", &numbers, &[])?];
    problem.sides = [Side::Roller; 2];
    problem.bolts = vec![kind];
    let model = Model::new(problem)?;
    let assembly = Assembly::new(&model)?;
    let phase = Phase::of(&model, &assembly, Stage::Before(0))?;
    let mut state = assembly.rest();
    let t: f64 = (0..3).map(|i| case.along[i] * case.moves[i]).sum();
    let motion = Row::new(case.moves.map(|d| parting * d / t));
    for &e in &above {
        for &node in model.mesh.elements[e as usize].nodes() {
            state.u[model.engine_node[node as usize] as usize] = motion;
        }
    }
    Engine::new(&model, &assembly, &phase).finish(&mut state);
    let seen = assembly.bolts[0].seen(&state.numbers, 0);
    Ok((model, seen))
}

/// The bar that crosses the joint in the middle of plan.
fn bar(case: &Case) -> [[f64; 3]; 2] {
    let middle = [0.5 * WIDE, 0.5 * WIDE, JOINT];
    [-BELOW.length, ABOVE.length].map(|by| [0, 1, 2].map(|i| middle[i] + by * case.along[i]))
}

/// Largest error of forces over that at the joint, and the largest force.
fn off(case: &Case, segment: f64, parting: f64) -> Result<[f64; 2], VerifyError> {
    let mut kind = bolts(&[bar(case)], AREA);
    kind.bond = Some(BELOW.bond(segment));
    let (model, seen) = forces(case, kind, 8, parting)?;
    let set = &model.bolts[0];
    if set.cuts.crossings != 1 {
        return Err(VerifyError::Setup(format!("{:?}", set.cuts)));
    }
    let pull = force_at(parting);
    let (mut error, mut most) = (0.0_f64, 0.0_f64);
    for (of, seen) in set.bolts[0].segments.iter().zip(seen) {
        let [a, b] = of.points.map(|p| set.bolts[0].points[p as usize].at - BELOW.length);
        let middle = 0.5 * (a + b);
        let exact = if middle < 0.0 { BELOW.force(pull, -middle) } else { ABOVE.force(pull, middle) };
        error = error.max((seen.force - exact).abs() / pull);
        most = most.max(seen.force);
    }
    Ok([error, most])
}

fn bonded(case: &Case) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let tanh = |of: &Bonded| (of.beta() * of.length).tanh();
    let softness = (1.0 / tanh(&BELOW) + 1.0 / tanh(&ABOVE)) / (BELOW.bar * BELOW.beta());
    // No slip beyond S/k on either side; a length that slides; the shorter side without any hold.
    for (what, parting) in [("within the bond's strength", 20e3 * softness), ("where the bond slides", 3e-3)]
    {
        if what.starts_with("within") && (force_at(parting) / 20e3 - 1.0).abs() > 1e-9 {
            return Err(VerifyError::Setup("the closed form is not the one without sliding".into()));
        }
        let mut errors = Vec::new();
        for segment in SEGMENTS {
            errors.push(off(case, segment, parting)?[0]);
        }
        let quantity = format!("force {what}, error over that at the joint, {}", case.word);
        let note = "1 %: of order 2 in the length of segments";
        if what.starts_with("within") {
            let p = order(errors[1], errors[2], 2.0).after(errors[0], 2.0);
            checks.push(Check::new(NAME, &*quantity, errors[2], 0.0, 0.01, "1", note).with_order(p));
            let note = "order 2; oblique bars are cut where they leave elements, so that not all segments are halved";
            checks.push(Check::new(
                NAME,
                format!("order in the length of segments, {quantity}"),
                p,
                2.0,
                0.2,
                "1",
                note,
            ));
        } else {
            checks.push(Check::new(NAME, &*quantity, errors[2], 0.0, 0.01, "1", note));
            let bound = |h: f64| 2.0 * BELOW.front_error(h) / force_at(parting);
            let most = errors.iter().zip(SEGMENTS).map(|(error, h)| error / bound(h)).fold(0.0, f64::max);
            let note = "2: once for the fronts on both sides, once for what is smooth; of order 2 at 0.1, 0.05 and 0.025 m";
            checks.push(Check::new(
                NAME,
                format!("{quantity}, over the bound of fronts"),
                most,
                0.0,
                2.0,
                "1",
                note,
            ));
        }
    }
    let [_, most] = off(case, SEGMENTS[2], 0.1)?;
    let exact = BELOW.strength * (BELOW.length - 0.5 * SEGMENTS[2]);
    let note = "0.1 %: the largest of any segment, S times the length behind its middle; segments are cut where elements end, and so \
                are not all of one length";
    let quantity = format!("force with the shorter side pulled out over S L₁, {}", case.word);
    checks.push(Check::new(NAME, quantity, most / exact, 1.0, 1e-3, "1", note));
    Ok(checks)
}

fn moving_with_the_rock() -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let parting = 1e-4;
    for case in &CASES[..2] {
        for elements in [8, 16] {
            // One element on either side, along the bolt.
            let length = 2.0 * HIGH / f64::from(elements) / case.along[2];
            let (model, seen) = forces(case, bolts(&[bar(case)], AREA), elements, parting)?;
            let most = seen.iter().map(|seen| seen.force).fold(0.0, f64::max);
            let others = seen
                .iter()
                .filter(|seen| seen.force != most)
                .map(|seen| seen.force.abs())
                .fold(0.0, f64::max);
            let size = HIGH / f64::from(elements);
            let exact = BELOW.bar * parting / length;
            let of = |what: &str| format!("{what}, without bond, elements of {size} m, {}", case.word);
            if model.bolts[0].cuts.crossings != 1 {
                return Err(VerifyError::Setup(format!("{:?}", model.bolts[0].cuts)));
            }
            let note = "1e-9: round-off; by the two elements beside the joint";
            checks.push(Check::new(
                NAME,
                of("force at the joint over EA δ/ℓ"),
                most / exact,
                1.0,
                1e-9,
                "1",
                note,
            ));
            let note = "1e-9: the blocks are rigid";
            checks.push(Check::new(
                NAME,
                of("force elsewhere over that"),
                others / exact,
                0.0,
                1e-9,
                "1",
                note,
            ));
        }
    }
    Ok(checks)
}
