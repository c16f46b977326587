//! The check of Rayleigh damping by mass.

use crate::evidence::Evidence;
use std::f64::consts::PI;
use tremolite_results::{TrustLine, said};

/// Damping ratio at the motion's central frequency: rock and concrete have 1 to 5 %. In a lined hall under a pulse the lining's largest
/// stress falls by 2 % where it is 0.6 %, by a tenth where it is 5 %, and by 28 % where it is 16 %.
pub(crate) const MOST: f64 = 0.05;

/// The ratio that a mass coefficient \[1/s\] is at a frequency \[Hz\].
pub(crate) fn ratio(mass: f64, frequency: f64) -> f64 {
    mass / (4.0 * PI * frequency)
}

pub(super) fn line(evidence: &Evidence) -> TrustLine {
    const ID: &str = "mass_damping";
    let name = said!("damping ratio by mass at the motion's central frequency");
    let mass = evidence.model.scheme.rayleigh.mass;
    if mass == 0.0 {
        return TrustLine::not_applicable(ID, name, said!("no damping is proportional to mass"));
    }
    let motion = evidence.plan.shaken_by(evidence.model);
    let Some(frequency) = motion.and_then(|motion| tremolite_motion::highest_frequency(motion, 0.5)) else {
        return TrustLine::not_applicable(ID, name, said!("no wave comes in"));
    };
    TrustLine::at_most(ID, name, ratio(mass, frequency), MOST, "")
        .with("mass", mass)
        .with("frequency", frequency)
        .with_note(said!(
            "ω/(4πf) with {mass} 1/s and {frequency} Hz, below which half of the input's energy lies: it damps the motion of the ground as a whole, slow motion most; damping over a band takes the same share at every frequency of the band",
            mass = mass.to_string(),
            frequency = format!("{frequency:.2}"),
        ))
}
