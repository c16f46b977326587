//! A canyon half round in the surface of ground under steady SH waves at 0, 30 and 60°: the surface's displacement.
//!
//! Trifunac's series (`trifunac1973`; `scattering::across`): what the canyon amplifies and hides in its shadow, in amplitude and phase, at
//! its wall and on the surface within three radii.

use crate::convergence::order;
use crate::full_space::aslant::Sines;
use crate::full_space::{BARE, Slice};
use crate::{Check, Effort, Verification, VerifyError};

const NAME: &str = "canyon";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "half-round canyon under SH waves at 0, 30 and 60°: displacement of wall and surface in amplitude and phase",
    source: "`trifunac1973`",
    from: Effort::Verify,
    run,
};

/// Canyons a quarter and half as wide as the wave is long, η = 2a/λ = ka/π.
const SINES: Sines = Sines { fundamental: 0.25 * std::f64::consts::PI, multiples: &[1, 2], settle: 60.0 };

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let reaches: &[f64] = if effort == Effort::Full { &[4.0, 8.0, 16.0] } else { &[4.0, 8.0] };
    let mut checks = Vec::new();
    for angle in [0.0_f64, 30.0, 60.0] {
        let slice = |reach| Slice { cavity: BARE, elements: 20, layers: 1, reach, coarsest: 0.2 };
        let errors: Vec<Vec<f64>> =
            reaches.iter().map(|&reach| slice(reach).canyon(angle.to_radians(), SINES)).collect::<Result<_, _>>()?;
        for (k, multiple) in SINES.multiples.iter().enumerate() {
            let eta = 0.25 * f64::from(*multiple);
            for (pair, reach) in errors.windows(2).zip(reaches.windows(2)) {
                let p = order(pair[0][k], pair[1][k], reach[1] / reach[0]);
                let quantity = format!("error of the displacement over its peak, SH at {angle}°, η = {eta}, box of {} radii", reach[1]);
                let note = "for information: what the box sends back, less the larger it is";
                checks.push(Check::beside(NAME, quantity, pair[1][k], 0.0, "1", note).with_order(p));
            }
        }
    }
    Ok(checks)
}
