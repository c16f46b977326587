//! Concrete in triaxial compression fails at Mohr–Coulomb's c1 = f_c + N c3.
//!
//! (13)–(14) of `wang2018` compare strains, but e1 ≥ ε_c is c1 ≥ f_c + N c3 for any c2 between c3 and c1. The strength is
//! found by halving, to round-off, without and with an intermediate stress.

use crate::concrete::{SPLITS, concrete, fc, slope, strength};
use crate::{Check, Effort, Verification, VerifyError};

const NAME: &str = "concrete_triaxial";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "concrete confined by 0 to 20 MPa fails at Mohr–Coulomb, whatever the middle stress",
    source: "`wang2018` (13)-(14): Mohr–Coulomb in compression",
    from: Effort::Test,
    run,
};

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for split in SPLITS {
        // Driven by strain, Poisson's expansion would raise D⁺ first and end the search.
        let law = concrete(&[], &[("split", split), ("driver", "stress")])?;
        for confinement in [0.0, 0.1e6, 1e6, 5e6, 20e6] {
            let exact = fc() + slope() * confinement;
            for (middle, word) in [(0.0, "c2 = c3"), (0.5, "c2 midway"), (1.0, "c2 = c1")] {
                let found = strength(&law, 4.0 * exact, |c1| {
                    let c2 = confinement + middle * (c1 - confinement);
                    [-confinement, -c2.max(confinement), -c1.max(confinement)]
                });
                let quantity = format!("strength at c3 = {} MPa, {word}, {split} split", confinement / 1e6);
                let note = "1e-12: round-off of the principal values, times N";
                checks.push(Check::new(NAME, quantity, found, exact, 1e-12 * exact, "Pa", note));
            }
        }
    }
    Ok(checks)
}
