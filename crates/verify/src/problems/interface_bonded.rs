//! A joint that holds, and is stiff, against nodes that are shared.
//!
//! A lined opening under a pulse (P and SV), once with the nodes of lining and rock shared and once with a bonded joint of the
//! stiffness k between them. What the joint adds to the compliance is 1/k, so displacements differ by the first order of 1/k.
//! All runs have the same step. The lining has corners of 90° and stands on feet, so that single nodes have two and three
//! partners.

use crate::convergence::order;
use crate::lined::{Corners, Joints, shake, slice};
use crate::{Check, Effort, Verification, VerifyError};

const NAME: &str = "interface_bonded";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a bonded stiff joint between lining and rock gives the run with shared nodes, with the order 1 in 1/k",
    source: "the limit of a stiff joint",
    from: Effort::Test,
    run,
};

/// k \[Pa/m\], and a step that all of them allow \[s\].
const STIFFNESSES: [f64; 3] = [50e9, 100e9, 200e9];
const STEP: f64 = 1e-3 / 36.0;

/// P and SV together.
pub(super) const ALONG: [f64; 3] = [0.6, 0.0, 0.8];

/// Displacements of all corners over time.
pub(super) fn history(joints: Joints) -> Result<Vec<Corners>, VerifyError> {
    let mut all = Vec::new();
    let (simulation, state) = shake(slice(1, joints, ALONG)?, STEP, |corners| all.push(corners.clone()))?;
    for (seam, contacts) in simulation.model.user_seams().iter().zip(&simulation.assembly.contacts) {
        let totals = contacts.totals(seam, &state.history);
        if totals.ever_opened + totals.ever_slid > 0.0 {
            return Err(VerifyError::Setup("the bond broke".into()));
        }
    }
    Ok(all)
}

/// Largest difference over the largest displacement.
pub(super) fn differ(a: &[Corners], b: &[Corners]) -> f64 {
    let (mut most, mut largest) = (0.0_f64, 0.0_f64);
    for (a, b) in a.iter().zip(b) {
        for (key, u) in a {
            let other = b.get(key).copied().unwrap_or([f64::NAN; 3]);
            for i in 0..3 {
                let off = (u[i] - other[i]).abs();
                most = if off.is_nan() { f64::INFINITY } else { most.max(off) };
                largest = largest.max(u[i].abs());
            }
        }
    }
    most / largest
}

/// Checks of joints that hold, against the run without any.
pub(super) fn limit(name: &'static str, lining: bool, fault: bool) -> Result<Vec<Check>, VerifyError> {
    let shared = history(Joints { lining: false, fault: false, law: "coulomb", numbers: &[] })?;
    let mut found = Vec::new();
    for k in STIFFNESSES {
        let numbers = [("normal_stiffness", k), ("shear_stiffness", k), ("cohesion", 1e12), ("friction_coefficient", 0.0)];
        found.push(differ(&shared, &history(Joints { lining, fault, law: "coulomb", numbers: &numbers })?));
    }
    let [coarse, middle, fine] = [0, 1, 2].map(|i| found[i]);
    let p = order(middle, fine, 2.0).after(coarse, 2.0);
    let note = "1 %: falls as 1/k";
    let quantity = "difference of displacements from shared nodes over the largest, k = 200 GPa/m";
    let check = Check::new(name, quantity, fine, 0.0, 0.01, "1", note).with_order(p);
    let mut checks = vec![check];
    for (p, which) in [(order(coarse, middle, 2.0), "50 to 100"), (p, "100 to 200")] {
        let note = "1: the compliance 1/k is added; the next term is E/(hk) of it, 0.1 at 100 GPa/m";
        let quantity = format!("order in 1/k from {which} GPa/m");
        checks.push(Check::new(name, quantity, p, 1.0, 0.15, "1", note).with_order(p));
    }
    Ok(checks)
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    limit(NAME, true, false)
}
