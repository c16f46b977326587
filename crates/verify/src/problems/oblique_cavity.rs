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

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let way = |kind, degrees: f64| -> Way { (kind, degrees.to_radians()) };
    let mut all = vec![(BARE, "bare", way(WaveType::P, 30.0)), (BARE, "bare", way(WaveType::Sv, 25.0)), (BARE, "bare", way(WaveType::Sh, 60.0))];
    let reaches: &[f64] = match effort {
        Effort::Full => &[4.0, 8.0, 16.0],
        _ => &[4.0, 8.0],
    };
    if effort == Effort::Full {
        let more = [(WaveType::P, 60.0), (WaveType::Sv, 50.0), (WaveType::Sh, 30.0)];
        all.extend(more.map(|(kind, angle)| (BARE, "bare", way(kind, angle))));
        let lined = [(WaveType::P, 30.0), (WaveType::Sv, 25.0), (WaveType::Sh, 60.0)];
        all.extend(lined.map(|(kind, angle)| (LINED, "lined", way(kind, angle))));
    }
    let mut checks = Vec::new();
    for (cavity, word, way) in all {
        let slice = |reach| Slice { cavity, elements: 20, layers: 1, reach, coarsest: 0.4 };
        let errors: Vec<Vec<f64>> =
            reaches.iter().map(|&reach| slice(reach).sines_aslant(way, SINES)).collect::<Result<_, _>>()?;
        let of = format!("{word}, {} at {:.0}°", way.0.word(), way.1.to_degrees());
        for (k, multiple) in SINES.multiples.iter().enumerate() {
            let ka = SINES.fundamental * f64::from(*multiple);
            for (pair, reach) in errors.windows(2).zip(reaches.windows(2)) {
                let p = order(pair[0][k], pair[1][k], reach[1] / reach[0]);
                let quantity = format!("error of hoop stress over its peak, {of}, ka = {ka}, box of {} radii", reach[1]);
                let note = "for information: what the box sends back, less the larger it is";
                checks.push(Check::beside(NAME, quantity, pair[1][k], 0.0, "1", note).with_order(p));
            }
        }
    }
    Ok(checks)
}
