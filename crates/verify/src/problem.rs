//! One verification problem and what comes of it.

use crate::simulation::levels_are_forced;
use crate::{Check, Effort, VerifyError};
use std::collections::BTreeSet;
use std::time::Instant;

/// One verification problem.
#[derive(Clone, Copy, Debug)]
pub struct Verification {
    /// The word on the command line.
    pub name: &'static str,
    /// One line on what is verified.
    pub summary: &'static str,
    /// Where the reference solution comes from.
    pub source: &'static str,
    /// The least effort that takes it in: a test where it takes 2 s at most, else [`Effort::Verify`]. A problem of the
    /// tests does the same at both, so that nothing is lost where only the others are verified.
    pub from: Effort,
    /// Runs it.
    pub run: fn(Effort) -> Result<Vec<Check>, VerifyError>,
}

/// What a problem came to.
#[derive(Clone, Debug)]
pub struct Verified {
    pub checks: Vec<Check>,
    /// Wall time \[s\].
    pub seconds: f64,
}

impl Verified {
    /// How many checks were missed.
    pub fn missed(&self) -> usize {
        self.checks.iter().filter(|check| !check.pass).count()
    }
}

impl Verification {
    /// Runs the problem; one that cannot be run to its end, or has two figures of one id, is a check that is missed.
    pub fn verify(&self, effort: Effort) -> Verified {
        let start = Instant::now();
        let mut checks = (self.run)(effort).unwrap_or_else(|error| vec![Check::broken(self.name, &error)]);
        let seconds = start.elapsed().as_secs_f64();
        if levels_are_forced() {
            checks.iter_mut().filter(|check| check.quantity.contains("order in ")).for_each(Check::only_told);
        }
        let mut ids = BTreeSet::new();
        if let Some(twice) = checks.iter().map(Check::id).find(|id| !ids.insert(id.clone())) {
            checks.push(Check::broken(self.name, &VerifyError::SameId(twice)));
        }
        Verified { checks, seconds }
    }
}
