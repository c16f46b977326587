//! A round cavity, bare and lined, in a space without end under steady P, SV and SH waves at angles.
//!
//! What waves at an angle come through stands round the cavity: base, sides and top. So the exact stresses at the wall
//! (`scattering`, `pao1973`) try the field, the boundaries that bring it in, and what these do with what the cavity scatters. Errors are the
//! box's, as under a wave straight up (`cavity_sines`), and fall as it grows.

use crate::convergence::order;
use crate::full_space::aslant::{Sines, Way};
use crate::full_space::{BARE, LINED, Slice};
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::waves::WaveType;

const NAME: &str = "oblique_cavity";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "round cavity, bare and lined, in full space under P, SV and SH waves at angles: hoop stress in amplitude and phase",
    source: "`pao1973`",
    from: Effort::Verify,
    run,
};

const SINES: Sines = Sines { fundamental: 0.1, multiples: &[1, 3, 5], settle: 60.0 };

/// Half the box over the radius: at least the first two.
const REACHES: [f64; 3] = [4.0, 8.0, 16.0];
const BARE_WAYS: [(WaveType, f64); 6] = [
    (WaveType::Sv, 25.0),
    (WaveType::Sv, 50.0),
    (WaveType::P, 30.0),
    (WaveType::P, 60.0),
    (WaveType::Sh, 30.0),
    (WaveType::Sh, 60.0),
];
const LINED_WAYS: [(WaveType, f64); 3] = [(WaveType::P, 30.0), (WaveType::Sv, 25.0), (WaveType::Sh, 60.0)];

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let bare = BARE_WAYS.map(|way| (BARE, "bare", way));
    let all = bare.into_iter().chain(LINED_WAYS.map(|way| (LINED, "lined", way)));
    let (elements, reaches, count) = match effort {
        Effort::Full => (20, &REACHES[..], BARE_WAYS.len() + LINED_WAYS.len()),
        _ => (10, &REACHES[..2], 1),
    };
    let mut checks = Vec::new();
    for (cavity, word, (kind, degrees)) in all.take(count) {
        let way: Way = (kind, f64::to_radians(degrees));
        let slice = |reach| Slice { cavity, elements, layers: 1, reach, coarsest: 0.4 };
        let errors: Vec<Vec<f64>> =
            reaches.iter().map(|&reach| slice(reach).sines_aslant(way, SINES)).collect::<Result<_, _>>()?;
        for (k, multiple) in SINES.multiples.iter().enumerate() {
            let of = format!("{word}, {} at {degrees}°, ka = 0.{multiple}", kind.word());
            for (pair, reach) in errors.windows(2).zip(reaches.windows(2)) {
                let (before, error) = (pair[0][k], pair[1][k]);
                let p = order(before, error, reach[1] / reach[0]);
                let quantity = format!("error of hoop stress over its peak, {of}, box of {} radii", reach[1]);
                // Of shorter waves the mesh's delay on the way through 16 radii, ⅟₂₄(kh)²kL, is as large as what the box sends back.
                let box_alone = reach[1] < REACHES[2] || *multiple < 5;
                let check = match reach[1] == REACHES[2] && box_alone {
                    true => {
                        let note = "3 %: 1 to 2 % are the box's at 16 radii, as under a wave straight up";
                        Check::new(NAME, quantity, error, 0.0, 0.03, "1", note)
                    }
                    false => Check::beside(NAME, quantity, error, 0.0, "1", "for information: what the box sends back"),
                };
                checks.push(check.with_order(p));
                let quantity = format!("error with a box of {} radii over that with {}, {of}", reach[1], reach[0]);
                let note = "below 1: a larger box errs less";
                let check = match box_alone {
                    true => Check::new(NAME, quantity, error / before, 0.0, 1.0, "1", note),
                    false => Check::beside(NAME, quantity, error / before, 0.0, "1", "for information: with the mesh's delay"),
                };
                checks.push(check.with_order(p));
            }
        }
    }
    Ok(checks)
}
