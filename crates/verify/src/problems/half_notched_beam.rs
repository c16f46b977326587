//! The half-notched beam of Grégoire, Rojas-Solano & Pijaudier-Cabot (2013): force over the opening of its notch, beside the tests.
//!
//! 50 × 50 mm, a span of 125 mm, a notch of 25 mm in the middle. E 37 GPa, f_t 3.9 MPa, G_f = 143.2 N/m from Model Code's
//! 73 f_cm^0.18 (`mc2010`), none of them fitted; the exponential law with the compliance split, no effect of rate.
//!
//! **What is met**: the largest force, within 15 % of the envelope of the tests on every mesh, though above it: 11 to 13 % above its top.
//!
//! **What is missed**: past it the beam is too tough, 1.9 times the middle of the envelope at 0.1 mm of opening and 1.8 times at 0.2 mm.
//!
//! **Why.** The meshes agree within 2 %, so it is neither the size of the elements nor the width of the notch, which is one element (but
//! one point in each of five elements over the ligament is too few). The
//! tests' own work says it: to 0.2 mm their cracks took 0.67 of what the model's took. With G_f less by that ratio, 96 N/m, the force is
//! that of the tests at 0.2 mm and still 39 % above at 0.1 mm: the concrete of this section of 25 mm took less than Model Code's G_f, as
//! is known of short ligaments (`duan2007`), and its softening falls faster at first, with a longer tail, than one exponential can.
//! `driver = "stress"` lowers all forces, but because it cracks at 0.71 f_t under biaxial tension, and takes less than G_f. Friction at the supports
//! is no reason: it bears part of the moment, μ·45/62.5 of it for a crack that has come to 45 mm, and the model has none.

use crate::specimen::beams::{Beam, HALF_NOTCHED};
use crate::specimen::{BAND, Mix, STRESS, Tested, Words, measured, steps};
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::Quadrature;

const NAME: &str = "half_notched_beam";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a notched beam of concrete in bending: largest force and force over the notch's opening, beside tests, by mesh and G_f",
    source: "`gregoire2013`",
    from: Effort::Verify,
    run,
};

/// Openings \[m\] at which forces are compared.
const OPENINGS: [f64; 2] = [0.1e-3, 0.2e-3];

/// Element \[m\] with which all else than the mesh is changed.
const OTHERS: f64 = 5e-3;

/// Ways of the machine \[m\], past an opening of 0.2 mm.
pub fn ways() -> Vec<f64> {
    steps(&[(0.01e-3, 0.01e-3), (0.06e-3, 0.005e-3), (0.14e-3, 0.01e-3)])
}

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let curve = measured::HALF_NOTCHED;
    let (low, high) = (0.85 * measured::most(curve, 1), 1.15 * measured::most(curve, 2));
    let drive = |beam: Beam, size: f64, mix: Mix, words: &'static Words, quadrature| {
        beam.test(&beam.plate(size, [0.01; 2]), mix, words, quadrature, Beam::ramp(size), ways())
    };
    let own = |size, mix| drive(HALF_NOTCHED, size, mix, BAND, Quadrature::Full);
    let tails = |checks: &mut Vec<Check>, tested: &Tested, word: &str| {
        for opening in OPENINGS {
            let mm = 1e3 * opening;
            let middle = 0.5 * (measured::at(curve, mm, 1) + measured::at(curve, mm, 2));
            let quantity = format!("force at an opening of {mm} mm, {word}");
            let note = "for information: beside the middle of the tests' envelope";
            checks.push(Check::beside(NAME, quantity, tested.force_at_opening(opening), middle, "N", note));
        }
    };
    let peak = |tested: &Tested, word: &str| {
        let quantity = format!("largest force, {word}");
        let note = "what is asked: 15 % beyond the tests' envelope to either side";
        Check::new(NAME, quantity, tested.peak(), 0.5 * (low + high), 0.5 * (high - low), "N", note)
    };
    let mix = HALF_NOTCHED.mix;
    let sizes: &[f64] = if effort == Effort::Full { &[5e-3, 2.5e-3, 1.25e-3] } else { &[5e-3, 2.5e-3] };
    let mut peaks = Vec::new();
    let mut ratio = f64::NAN;
    for &size in sizes {
        let tested = own(size, mix)?;
        let word = format!("{} mm", 1e3 * size);
        peaks.push(tested.peak());
        checks.push(peak(&tested, &word));
        tails(&mut checks, &tested, &word);
        let note = "3 %: trapezes over the steps of the machine, and what cracks at once in a step";
        let quantity = format!("held and taken over the machine's work, {word}");
        checks.push(Check::new(NAME, quantity, tested.booked(), 1.0, 0.03, "1", note));
        if size == OTHERS {
            ratio = taken(&tested, |r| measured_middle(r.opening)) / taken(&tested, |r| r.force);
        }
    }
    let (least, most) = peaks.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), &p| (a.min(p), b.max(p)));
    let note = "6 % to either side of their middle, as for the panel";
    checks.push(Check::new(NAME, "largest over smallest force of the meshes", most / least, 1.0, 1.06 / 0.94 - 1.0, "1", note));

    let one = drive(HALF_NOTCHED, 2.5e-3, mix, BAND, Quadrature::OnePoint)?;
    checks.push(peak(&one, "2.5 mm, one-point"));
    let middle = 0.5 * (measured::most(curve, 1) + measured::most(curve, 2));
    let one = drive(HALF_NOTCHED, OTHERS, mix, BAND, Quadrature::OnePoint)?;
    let note = "for information: one point in each of five elements over the ligament is too few, 17 % above the envelope";
    checks.push(Check::beside(NAME, "largest force, 5 mm, one-point", one.peak(), middle, "N", note));
    let note = "for information: to 0.2 mm of opening, less ½ F u, over what the model's crack took; the way by the model's opening";
    checks.push(Check::beside(NAME, "what the tests' cracks took over what the model's took", ratio, 1.0, "1", note));
    let less = own(OTHERS, Mix { energy: ratio * mix.energy, ..mix })?;
    let word = "5 mm, with the tests' own G_f";
    checks.push(peak(&less, word));
    tails(&mut checks, &less, word);
    if effort == Effort::Full {
        let stress = drive(HALF_NOTCHED, OTHERS, mix, STRESS, Quadrature::Full)?;
        let word = "5 mm, driver stress";
        let note = "for information: beside the middle of the tests' envelope";
        checks.push(Check::beside(NAME, format!("largest force, {word}"), stress.peak(), middle, "N", note));
        tails(&mut checks, &stress, word);
    }
    Ok(checks)
}

/// The middle of the tests' envelope \[N\] at an opening \[m\].
fn measured_middle(opening: f64) -> f64 {
    0.5 * (measured::at(measured::HALF_NOTCHED, 1e3 * opening, 1) + measured::at(measured::HALF_NOTCHED, 1e3 * opening, 2))
}

/// ∫F du − ½ F u \[J\] to an opening of 0.2 mm, of this force along the ways of a run.
fn taken(tested: &Tested, force: impl Fn(&crate::specimen::Reading) -> f64) -> f64 {
    let readings: Vec<_> = tested.readings.iter().take_while(|r| r.opening <= OPENINGS[1]).collect();
    let work: f64 = readings.windows(2).map(|p| 0.5 * (force(p[0]) + force(p[1])) * (p[1].way - p[0].way)).sum();
    readings.last().map_or(f64::NAN, |end| work - 0.5 * force(end) * end.way)
}
