//! A fault through a lined opening: joints that cross.
//!
//! A vertical fault cuts rock and lining in the middle of a slice, from the base to the surface; lining and rock have a joint of
//! their own. Where the two meet, nodes part into four and each pair has its normal.
//! - Bonded and stiff, all of it is the run with shared nodes, with the order 1 in 1/k ([`super::interface_bonded`]).
//! - With bonds that break, a pulse and its mirror image give mirrored motions, to round-off.
//! - A slice twice as long along y, where it is periodic, moves as the slice does.

use super::interface_bonded::{ALONG, differ, limit};
use crate::lined::{Corners, Joints, mirrored, shake, slice};
use crate::{Check, Effort, Verification, VerifyError};

const NAME: &str = "interface_fault";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a fault across a lined opening: shared nodes in the limit, mirror images, twice as long",
    source: "the limit of a stiff joint; symmetry",
    from: Effort::Test,
    run,
};

/// A pulse of 0.5 m/s has stresses of some 3 MPa here.
const WEAK: Joints = Joints {
    lining: true,
    fault: true,
    law: "bandis",
    numbers: &[
        ("normal_stiffness", 20e9),
        ("max_closure", 1e-3),
        ("cohesion", 0.2e6),
        ("friction_coefficient", 0.6),
        ("pressure_for_step", 10e6),
    ],
};

/// Displacements over time, and the areas that slid and opened over that of each joint.
fn run_weak(deep: u32, along: [f64; 3]) -> Result<(Vec<Corners>, Vec<[f64; 2]>), VerifyError> {
    let mut all = Vec::new();
    let (simulation, state) = shake(slice(deep, WEAK, along)?, 1.0, |corners| all.push(corners.clone()))?;
    let shares = simulation.model.user_seams().iter().zip(&simulation.assembly.contacts).map(|(seam, contacts)| {
        let totals = contacts.totals(seam, &state.history);
        [totals.ever_slid, totals.ever_opened].map(|area| area / seam.area())
    });
    Ok((all, shares.collect()))
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = limit(NAME, true, true)?;
    let (all, shares) = run_weak(1, ALONG)?;
    for (share, which) in shares.iter().zip(["lining", "fault"]) {
        let note = "more than a tenth, so that there is something to mirror";
        let quantity = format!("least share of the joint of the {which} that slid and that opened");
        checks.push(Check::new(NAME, quantity, share[0].min(share[1]), 0.55, 0.45, "1", note));
    }
    let (image, _) = run_weak(1, [-ALONG[0], ALONG[1], ALONG[2]])?;
    let image: Vec<Corners> = image
        .iter()
        .map(|corners| corners.iter().map(|(&key, u)| (mirrored(key), [-u[0], u[1], u[2]])).collect())
        .collect();
    let note = "1e-9: round-off, which sliding and impacts do not let grow much in so short a time";
    let quantity = "difference of the mirrored run over the largest displacement";
    checks.push(Check::new(NAME, quantity, differ(&all, &image), 0.0, 1e-9, "1", note));
    let (long, _) = run_weak(2, ALONG)?;
    let quantity = "difference of the run twice as long over the largest displacement";
    checks.push(Check::new(NAME, quantity, differ(&all, &long), 0.0, 1e-9, "1", note));
    Ok(checks)
}
