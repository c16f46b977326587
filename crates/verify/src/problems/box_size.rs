//! A cavern in boxes of several widths: sides that stand at four widths change the motion of its walls by less than 2 %.
//!
//! The same cavern, 20 m wide, with free-field sides at 1, 2, 4 and 8 widths from its walls, beside a box twice as wide as the widest.
//! Rock is elastic, or a layer below the cavern yields. Periodic and viscous sides stand beside, for information.

use crate::box_size::{Ground, shake};
use crate::{Check, Effort, Problem, VerifyError};
use tremolite::Side;

const NAME: &str = "box_size";

pub const PROBLEM: Problem = Problem {
    name: NAME,
    summary: "a cavern with free-field sides at 1 to 8 widths: what the walls' motion owes to the box",
    source: "a box twice as wide as the widest",
    from: Effort::Verify,
    run,
};

/// Of sides, in widths of the cavern.
pub const DISTANCES: [u32; 4] = [1, 2, 4, 8];
/// And of those that all are compared with.
pub const FAR: u32 = 16;
/// Where the difference must have fallen below [`ENOUGH`].
const ASKED: u32 = 4;
const ENOUGH: f64 = 0.02;

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for (ground, word) in [(Ground::Elastic, "elastic"), (Ground::Yielding, "a yielding layer")] {
        let far = shake(ground, Side::FreeField, FAR)?;
        let mut last = f64::INFINITY;
        for widths in DISTANCES {
            let found = shake(ground, Side::FreeField, widths)?.apart(&far);
            let quantity = format!("difference of the walls' velocity over the peak, sides at {widths} widths, {word}");
            let note = "2 % at four widths and beyond; nearer for information";
            checks.push(match widths >= ASKED {
                true => Check::new(NAME, quantity, found, 0.0, ENOUGH, "1", note),
                false => Check::beside(NAME, quantity, found, 0.0, "1", note),
            });
            let quantity = format!("difference over that of the sides before, sides at {widths} widths, {word}");
            let note = "it must fall with the width of the box";
            if last.is_finite() {
                checks.push(Check::new(NAME, quantity, found / last, 0.5, 0.5, "1", note));
            }
            last = found;
        }
        for (side, name) in [(Side::Periodic, "periodic"), (Side::Viscous, "viscous")] {
            let found = shake(ground, side, ASKED)?.apart(&far);
            let quantity = format!("difference with {name} sides at {ASKED} widths, {word}");
            checks.push(Check::beside(NAME, quantity, found, 0.0, "1", "for information: what free-field sides are for"));
        }
    }
    Ok(checks)
}
