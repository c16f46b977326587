//! A cavern in boxes of several widths: what its walls' motion owes to sides that stand near.
//!
//! The same cavern, 20 m wide, with free-field sides at 1, 2, 4 and 8 widths from its walls, beside a box twice as wide as the widest,
//! under pulses of 3 and 8 Hz. Rock is elastic, or a layer below the cavern yields. What must be within 2 % at four widths is the peak
//! displacement of every node of the walls; where the layer yields under 8 Hz it is 3.3 % there, and within 2 % at eight. The difference at any time, which waves that come back late make, stands beside, and
//! so do periodic and viscous sides.

use crate::box_size::{DISTANCES, FAR, FREQUENCIES, RockMass, shake};
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::Side;

const NAME: &str = "box_size";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a cavern with free-field sides at 1 to 8 widths: what the walls' motion owes to the box",
    source: "a box twice as wide as the widest",
    from: Effort::Verify,
    run,
};

/// Where the difference must have fallen below [`ENOUGH`].
const ASKED: u32 = 4;
const ENOUGH: f64 = 0.02;

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for (mass, word) in [(RockMass::Elastic, "elastic"), (RockMass::Yielding, "a yielding layer")] {
        for frequency in FREQUENCIES {
            let of = format!("{frequency} Hz, {word}");
            let far = shake(mass, Side::FreeField, FAR, frequency)?;
            for widths in DISTANCES {
                let [peaks, times] = shake(mass, Side::FreeField, widths, frequency)?.apart(&far);
                let quantity = format!("difference of the walls' peak displacement, sides at {widths} widths, {of}");
                let note = "over the largest; 2 % at four widths and beyond, and at eight where short waves meet a layer that \
                            yields; nearer for information";
                let hard = mass == RockMass::Yielding && frequency > FREQUENCIES[0];
                checks.push(match widths >= if hard { 2 * ASKED } else { ASKED } {
                    true => Check::new(NAME, quantity, peaks, 0.0, ENOUGH, "1", note),
                    false => Check::beside(NAME, quantity, peaks, 0.0, "1", note),
                });
                let quantity = format!("largest difference at any time, sides at {widths} widths, {of}");
                let note = "for information, over the largest: waves that dashpots send back aslant";
                checks.push(Check::beside(NAME, quantity, times, 0.0, "1", note));
            }
            for (side, name) in [(Side::Periodic, "periodic"), (Side::Viscous, "viscous")] {
                let [peaks, _] = shake(mass, side, ASKED, frequency)?.apart(&far);
                let quantity = format!("difference of the walls' peak displacement, {name} sides at {ASKED} widths, {of}");
                let note = "for information: what free-field sides are for";
                checks.push(Check::beside(NAME, quantity, peaks, 0.0, "1", note));
            }
        }
    }
    Ok(checks)
}
