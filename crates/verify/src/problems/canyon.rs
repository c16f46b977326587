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

/// Canyons an eighth and a quarter as wide as the wave is long, η = 2a/λ = ka/π. At half of it the mesh's delay on the way through 16 radii,
/// ⅟₂₄(kh)²kL, is a tenth already.
const SINES: Sines = Sines { fundamental: 0.125 * std::f64::consts::PI, multiples: &[1, 2], settle: 60.0 };

/// Half the box, and its depth, over the radius: at least the first two.
const REACHES: [f64; 3] = [4.0, 8.0, 16.0];

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let (reaches, angles) = match effort {
        Effort::Full => (&REACHES[..], &[30.0, 0.0, 60.0][..]),
        _ => (&REACHES[..2], &[30.0][..]),
    };
    let mut checks = Vec::new();
    for &angle in angles {
        let slice = |reach| Slice { cavity: BARE, elements: 20, layers: 1, reach, coarsest: 0.2 };
        let errors: Vec<Vec<f64>> = reaches
            .iter()
            .map(|&reach| slice(reach).canyon(f64::to_radians(angle), SINES))
            .collect::<Result<_, _>>()?;
        for (k, multiple) in SINES.multiples.iter().enumerate() {
            let of = format!("SH at {angle}°, η = {}", 0.125 * f64::from(*multiple));
            for (pair, reach) in errors.windows(2).zip(reaches.windows(2)) {
                let (before, error) = (pair[0][k], pair[1][k]);
                let p = order(before, error, reach[1] / reach[0]);
                let quantity = format!("error of the displacement over its peak, {of}, box of {} radii", reach[1]);
                let check = match reach[1] == REACHES[2] {
                    true => {
                        let note = "3 %: what the box sends back at 16 radii, as of a cavity in full space, and the mesh's delay";
                        Check::new(NAME, quantity, error, 0.0, 0.03, "1", note)
                    }
                    false => Check::beside(NAME, quantity, error, 0.0, "1", "for information: what the box sends back"),
                };
                checks.push(check.with_order(p));
                let quantity = format!("error with a box of {} radii over that with {}, {of}", reach[1], reach[0]);
                // Of shorter waves the mesh's delay on the longer way is more than what the box sends back.
                let check = match reach[1] < REACHES[2] || *multiple < 2 {
                    true => Check::new(NAME, quantity, error / before, 0.0, 1.0, "1", "below 1: a larger box errs less"),
                    false => Check::beside(NAME, quantity, error / before, 0.0, "1", "for information: with the mesh's delay"),
                };
                checks.push(check.with_order(p));
            }
        }
    }
    Ok(checks)
}
