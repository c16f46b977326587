//! A round cavity in a space without end, bare and lined, under a step of stress that comes as a P wave.
//!
//! The incident stress rises from 0 to σ₀ in the time in which the wave travels a radius, by a smooth ramp. Behind the front
//! σ_θ swings beyond the static 8/3 σ₀ at the bare wall beside the cavity, to 2.94 σ₀ (ν = ¼), and comes to it from above. The
//! exact course is the Fourier sum of the steady solution (`pao1973`, `scattering`).
//!
//! Until anything can come back from the box mesh and step alone err, with order 2: the wave is delayed by ⅟₂₄(kh)² of its way, and
//! the ramp's components go up to two waves a radius. Later the box errs, as under steady waves ([`super::cavity_sines`]).

use crate::convergence::order;
use crate::full_space::{BARE, LINED, Slice};
use crate::scattering::Cavity;
use crate::{Check, Effort, Verification, VerifyError};

const NAME: &str = "cavity_step";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "round cavity in full space, bare and lined, under a step of stress: hoop stress all round until it is nearly static",
    source: "`pao1973`",
    from: Effort::Verify,
    run,
};

/// Rise and end, in times in which the wave travels a radius.
const RISE: f64 = 1.0;
const END: f64 = 20.0;
/// Size of the largest elements over the radius: with those thrice as large S waves of the ramp's higher components come back
/// from where elements grow (1.5 % of the peak, at any distance of the box).
const COARSEST: f64 = 0.1;

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    compare(&mut checks, LINED, "lined", [40, 64], [4.0, 8.0])?;
    if effort == Effort::Full {
        compare(&mut checks, LINED, "lined", [64, 96], [6.0, 12.0])?;
        compare(&mut checks, BARE, "bare", [40, 64], [4.0, 8.0])?;
        compare(&mut checks, BARE, "bare", [64, 96], [6.0, 12.0])?;
    }
    Ok(checks)
}

/// Two meshes and two boxes, by elements along the square round the cavity and half the box over the radius.
fn compare(
    checks: &mut Vec<Check>,
    cavity: Cavity,
    word: &str,
    [coarse, fine]: [u32; 2],
    [small, large]: [f64; 2],
) -> Result<(), VerifyError> {
    let at =
        |elements, reach| Slice { cavity, elements, layers: 1, reach, coarsest: COARSEST }.step(RISE, END);
    let [early, _] = at(coarse, large)?;
    let [_, near] = at(fine, small)?;
    let [before, whole] = at(fine, large)?;

    let around = 4 * fine;
    let quantity =
        format!("{word}: error of hoop stress over its peak, {around} around, box of {large} radii");
    let note = "3 %: 2 % of mesh and step at 256 around, of order 2, and 1 % that the box sends back towards the end";
    checks.push(Check::new(NAME, quantity, whole, 0.0, 0.03, "1", note));
    let quantity =
        format!("{word}: error with a box of {large} radii over that with {small}, {around} around");
    let note = "below 1: a larger box errs less";
    checks.push(Check::new(NAME, quantity, whole / near, 0.0, 1.0, "1", note));
    let p = order(early, before, f64::from(fine) / f64::from(coarse));
    let quantity = format!(
        "{word}: order in h before anything comes back, {} and {around} around, box of {large} radii",
        4 * coarse
    );
    let note = "2 of mesh and step; (kh)² of the ramp's highest components is not small in the coarser mesh";
    checks.push(Check::new(NAME, quantity, p, 2.0, 0.3, "1", note).with_order(p));
    Ok(())
}
