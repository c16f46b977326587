//! A bonded bar pulled in rock that is held: elastic, sliding, yielding, and unloaded.
//!
//! Bond over 4 m behind a free length of 2 m with a plate at its head. The pretension pulls, constant through its stage, and is
//! locked by the next. N and slip are those of `bolted::Bonded`. Then the rock that holds the bond is moved against the head, by
//! displacements that are given:
//!
//! - **Yield**, by δ away from the head. The head's force grows by δ/(ℓ/EA + coth(βL)/(EAβ)), ℓ the free length, up to σ_y A; from
//!   δ_y on the free length alone stretches, by (δ − δ_y)/ℓ.
//! - **Unloading** to no force at the head, towards it. Sliders that have slid forwards slide back after 2S, those that have not
//!   are elastic: so the change is the solution of a pull by as much with 2S for S, as long as it slides back within what had
//!   slid. δ is the free length's shortening and that solution's slip at x = 0. What stays holds itself, with bond forces of the
//!   other sign near the head.
//!
//! **Errors.** Half a segment's sliders at each end, all of a bar's in the nodes: of order 2 in the length h of segments. At a front the
//! bond's force bends, and what sums miss there goes by where the front falls between points: no order is seen from one h to the next,
//! but at every h it is at most h²Sβ/8 (`bolted::Bonded::front_error`), and of the rest as much.

use crate::bolted::{AREA, Bonded, STEEL, bolts};
use crate::convergence::order;
use crate::models::Solid;
use crate::staged::{Rested, release};
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::bolts::{SegmentSeen, SegmentState};
use tremolite::{Engine, Quadrature, Side};
use tremolite_laws::Row;
use tremolite_mesh::boxes::BoxSpec;

const NAME: &str = "bolt_pull_out";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a bonded bar pulled in held rock: elastic, sliding to a front, yielding, unloaded to what stays",
    source: "the bar on elastic and perfectly plastic sliders, solved in closed form in `bolted`",
    from: Effort::Test,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
const BOND: Bonded = Bonded { bar: STEEL * AREA, bond: 1e8, strength: 50e3, length: 4.0 };
/// Free length, and where the head is in its element of 1 m \[m\].
const FREE: f64 = 2.0;
const HEAD: f64 = 0.1;
/// Longest segments \[m\].
const SEGMENTS: [f64; 3] = [0.1, 0.05, 0.025];
/// Pulls \[N\]: within what the bond carries without sliding, S tanh(βL)/β = 49.5 kN, and beyond. Yield.
const ELASTIC: f64 = 20e3;
const SLIDES: f64 = 150e3;
const YIELDS: f64 = 40e3;

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = pulled("elastic", ELASTIC)?;
    checks.extend(pulled("sliding", SLIDES)?);
    checks.extend(yielding()?);
    checks.extend(unloaded()?);
    Ok(checks)
}

/// A pulled bar at rest after some stages.
struct Pulled {
    rested: Rested,
}

impl Pulled {
    fn new(pull: f64, yields: f64, segment: f64, stages: usize) -> Result<Self, VerifyError> {
        let mesh = BoxSpec::uniform([0.0; 3], [1.0, 1.0, 7.0], [1, 1, 7]).mesh()?;
        let mut problem = ROCK.fill(mesh, Quadrature::OnePoint);
        problem.held = (0..problem.mesh.nodes.len() as u32).map(|n| (n, [true; 3])).collect();
        problem.sides = [Side::Roller; 2];
        let mut kind = bolts(&[[[0.4, 0.6, HEAD], [0.4, 0.6, HEAD + FREE + BOND.length]]], AREA);
        kind.bond = Some(BOND.bond(segment));
        (kind.free_length, kind.plates, kind.pretension) = (FREE, [true, false], pull);
        kind.yields = yields / AREA;
        problem.bolts = vec![kind];
        Ok(Pulled { rested: Rested::new(problem, &vec![release(1.0); stages])? })
    }

    fn seen(&self) -> Vec<SegmentSeen> {
        self.rested.assembly.bolts[0].seen(&self.rested.state.numbers, 0)
    }

    /// The bonded segments with the places of their ends \[m\] behind the free length.
    fn bonded(&self) -> Vec<([f64; 2], SegmentSeen)> {
        let bolt = &self.rested.model.bolts[0].bolts[0];
        let at = |p: u32| bolt.points[p as usize].at - FREE;
        let all = bolt.segments.iter().zip(self.seen()).filter(|(of, _)| !of.free);
        all.map(|(of, seen)| (of.points.map(at), seen)).collect()
    }

    /// Force \[N\] of the free length.
    fn head(&self) -> SegmentSeen {
        self.seen()[0]
    }

    /// Largest |N − what is exact| \[N\].
    fn off(&self, exact: impl Fn(f64) -> f64) -> f64 {
        let all = self.bonded().into_iter().map(|([a, b], seen)| (seen.force - exact(0.5 * (a + b))).abs());
        all.fold(0.0, f64::max)
    }

    /// Moves the rock of the bond along the bar \[m\]; what is in the element of the head stays.
    fn move_bond(&mut self, by: f64) {
        let Rested { model, assembly, phase, state, .. } = &mut self.rested;
        for (row, &node) in state.u.iter_mut().zip(&model.mesh_node) {
            if model.mesh.nodes[node as usize][2] > 1.5 {
                *row = Row::new([0.0, 0.0, by]);
            }
        }
        Engine::new(model, assembly, phase).finish(state);
    }

    /// Where the bond's force, of what N falls by from segment to segment, comes down to its strength, on the line through the
    /// first two places behind \[m\].
    fn front(&self) -> f64 {
        let bonded = self.bonded();
        let bond: Vec<[f64; 2]> = bonded
            .windows(2)
            .map(|w| {
                let ([_, at], [a, b]) = (w[0].0, [0, 1].map(|k| w[k].0[1] - w[k].0[0]));
                [at, (w[0].1.force - w[1].1.force) / (0.5 * (a + b))]
            })
            .collect();
        let behind = bond.iter().position(|[_, b]| *b < (1.0 - 1e-9) * BOND.strength).unwrap_or(0);
        let [[x, b], [y, c]] = [bond[behind], bond[(behind + 1).min(bond.len() - 1)]];
        x - (BOND.strength - b) * (y - x) / (b - c)
    }
}

/// A check of errors that fall with the length of segments, and one of the order.
fn falling(of: &str, errors: &[f64], note: &str) -> [Check; 2] {
    let last = errors.len() - 1;
    let p = order(errors[last - 1], errors[last], 2.0).after(errors[last - 2], 2.0);
    let note = format!("1 %: {note}");
    [
        Check::new(NAME, of, errors[last], 0.0, 0.01, "1", note).with_order(p),
        Check::new(NAME, format!("order in the length of segments, {of}"), p, 2.0, 0.1, "1", "order 2"),
    ]
}

/// The same where a bond slides, with the error that a front may have at every length of segments.
fn bounded(of: &str, errors: &[f64], bounds: [f64; 3], note: &str) -> [Check; 2] {
    let most = errors.iter().zip(bounds).map(|(error, bound)| error / bound).fold(0.0, f64::max);
    let why = "2: once for the front, once for what is smooth; of order 2 at 0.1, 0.05 and 0.025 m";
    [
        Check::new(NAME, of, errors[errors.len() - 1], 0.0, 0.01, "1", format!("1 %: {note}")),
        Check::new(NAME, format!("{of}, over the bound of a front"), most, 0.0, 2.0, "1", why),
    ]
}

fn pulled(word: &str, pull: f64) -> Result<Vec<Check>, VerifyError> {
    let (mut forces, mut slips, mut fronts) = (Vec::new(), Vec::new(), Vec::new());
    let slid = BOND.slid(pull);
    for segment in SEGMENTS {
        let pulled = Pulled::new(pull, f64::INFINITY, segment, 1)?;
        forces.push(pulled.off(|x| BOND.force(pull, x)) / pull);
        let slip = |([a, _], seen): ([f64; 2], SegmentSeen)| {
            // Towards the head the bar is behind the rock.
            (seen.slip + BOND.slip(pull, a)).abs() / BOND.slip(pull, 0.0)
        };
        slips.push(pulled.bonded().into_iter().map(slip).fold(0.0, f64::max));
        fronts.push((pulled.front() - slid).abs() / slid);
        let free = pulled.head().force;
        if free != pull {
            return Err(VerifyError::Setup(format!("the free length has {free} N")));
        }
    }
    let [force, slip] =
        ["force along the bond, error over P", "slip along the bond, error over that at its head"]
            .map(|of| format!("{of}, {word}"));
    let mut checks = Vec::new();
    if slid == 0.0 {
        let note = "(βh)²/24 of segments, whose ends have half of their sliders, is below 1e-4";
        checks.extend(falling(&force, &forces, note));
        checks.extend(falling(&slip, &slips, note));
    } else {
        let note = "h²Sβ/8 is below 1e-4 of P";
        let bounds = SEGMENTS.map(|h| BOND.front_error(h) / pull);
        checks.extend(bounded(&force, &forces, bounds, note));
        // What forces err by stretches the bar.
        let stretched = pull * BOND.length / (BOND.bar * BOND.slip(pull, 0.0));
        checks.extend(bounded(&slip, &slips, bounds.map(|bound| bound * stretched), note));
        let note = "2 %: where what N falls by comes down to S, on the line through the first two places behind; it bends by β²h²";
        let quantity = "place of the front where sliding ends, error over its distance from the head";
        checks.push(Check::new(NAME, quantity, fronts[2], 0.0, 0.02, "1", note));
        checks.push(Check::new(NAME, "place of the front, 0.05 m", fronts[1], 0.0, 0.02, "1", note));
    }
    Ok(checks)
}

fn yielding() -> Result<Vec<Check>, VerifyError> {
    let softness = FREE / BOND.bar + 1.0 / ((BOND.beta() * BOND.length).tanh() * BOND.bar * BOND.beta());
    let until = (YIELDS - ELASTIC) * softness;
    let (mut halfway, mut strains) = (Vec::new(), Vec::new());
    let (mut last, mut others) = (SegmentSeen::default(), 0);
    for segment in SEGMENTS {
        let mut pulled = Pulled::new(ELASTIC, YIELDS, segment, 2)?;
        pulled.move_bond(0.5 * until);
        halfway.push((pulled.head().force / (0.5 * (ELASTIC + YIELDS)) - 1.0).abs());
        pulled.move_bond(3.0 * until);
        last = pulled.head();
        strains.push((last.plastic_strain * FREE / (2.0 * until) - 1.0).abs());
        others = pulled.bonded().iter().filter(|(_, seen)| seen.state >= SegmentState::Yielded).count();
    }
    let note = "the bond's share of the softness errs by (βh)²/12";
    let mut checks = falling("force halfway to yield, relative error", &halfway, note).to_vec();
    let note = "round-off";
    checks.push(Check::new(NAME, "force at yield over σ_y A", last.force / YIELDS, 1.0, 1e-12, "1", note));
    let yielded = f64::from(u8::from(last.state == SegmentState::Yielded));
    checks.push(Check::new(
        NAME,
        "whether the free length is said to yield",
        yielded,
        1.0,
        0.0,
        "1",
        "it does",
    ));
    let note = "the bond has less to carry than the free length";
    checks.push(Check::new(NAME, "bonded segments that yield", others as f64, 0.0, 0.0, "1", note));
    let note = "from yield on all of the motion is plastic";
    checks.extend(falling("plastic elongation, relative error", &strains, note));
    Ok(checks)
}

fn unloaded() -> Result<Vec<Check>, VerifyError> {
    let back = Bonded { strength: 2.0 * BOND.strength, ..BOND };
    let by = SLIDES * FREE / BOND.bar + back.slip(SLIDES, 0.0);
    let exact = |x: f64| BOND.force(SLIDES, x) - back.force(SLIDES, x);
    let [slid, slid_back] = [BOND.slid(SLIDES), back.slid(SLIDES)];
    let (mut heads, mut forces, mut apart) = (Vec::new(), Vec::new(), 0.0_f64);
    for segment in SEGMENTS {
        let mut once = Pulled::new(SLIDES, f64::INFINITY, segment, 2)?;
        once.move_bond(-by);
        heads.push(once.head().force.abs() / SLIDES);
        forces.push(once.off(exact) / SLIDES);
        let mut slowly = Pulled::new(SLIDES, f64::INFINITY, segment, 2)?;
        (1..=40).for_each(|k| slowly.move_bond(-by * f64::from(k) / 40.0));
        let pairs = once.seen().into_iter().zip(slowly.seen());
        apart = pairs.map(|(a, b)| (a.force - b.force).abs() / SLIDES).fold(apart, f64::max);
    }
    let note = format!("{slid:.3} m had slid, {slid_back:.3} m slide back");
    let bounds = SEGMENTS.map(|h| (BOND.front_error(h) + back.front_error(h)) / SLIDES);
    let mut checks = bounded("force at the head after unloading, over P", &heads, bounds, &note).to_vec();
    checks.extend(bounded("forces that stay along the bond, error over P", &forces, bounds, &note));
    let note = "1e-9: nothing slides to and fro on the way, so that any steps lead to the same; what is out of balance is 1e-11";
    checks.push(Check::new(
        NAME,
        "unloaded at once and in 40 steps, difference over P",
        apart,
        0.0,
        1e-9,
        "1",
        note,
    ));
    let largest = (0..400).map(|k| exact(0.01 * f64::from(k))).fold(0.0, f64::max) / SLIDES;
    let note = "at least a tenth: so much there is to compare";
    checks.push(Check::new(
        NAME,
        "largest force that stays, over P, a tenth at least",
        largest.min(0.1),
        0.1,
        0.0,
        "1",
        note,
    ));
    let bounds = f64::from(u8::from(slid_back > 0.3 && slid_back < slid));
    let note = "else the superposition would not hold, or nothing would slide back";
    checks.push(Check::new(NAME, "slides back within what had slid", bounds, 1.0, 0.0, "1", note));
    Ok(checks)
}
