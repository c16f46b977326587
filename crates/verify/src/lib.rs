//! Verification: problems with exact or published solutions, run through the engine that cases use.
//!
//! One problem a file under [`problems`]: the solution and its source, the numerical model, and what is compared.
//! [`PROBLEMS`] lists them; [`run`] runs some or all and hands on each [`Check`] as it is found.
//!
//! A tolerance states what theory or convergence lets one expect, and its note gives the reason. It is never what
//! happens to pass.
//!
//! ```
//! use tremolite_verify::{Effort, run};
//!
//! let missed = run(&["discrete_energy"], Effort::Quick, &mut |check| println!("{check}"))?;
//! assert_eq!(missed, 0);
//! # Ok::<(), tremolite_verify::UnknownName>(())
//! ```

mod check;
mod concrete;
mod convergence;
mod dense;
mod error;
mod models;
pub mod problems;
mod rock;
mod simulation;
mod stiffness;

pub use check::Check;
pub use error::{UnknownName, VerifyError};
pub use problems::PROBLEMS;

/// How much time a run may take.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Effort {
    /// Seconds a problem: what the tests run.
    #[default]
    Quick,
    /// Finer meshes and further variants, up to a minute a problem.
    Full,
}

/// One verification problem.
#[derive(Clone, Copy, Debug)]
pub struct Problem {
    /// The word on the command line.
    pub name: &'static str,
    /// One line on what is verified.
    pub summary: &'static str,
    /// Where the reference solution comes from.
    pub source: &'static str,
    /// Runs it.
    pub run: fn(Effort) -> Result<Vec<Check>, VerifyError>,
}

impl Problem {
    /// Runs the problem; one that cannot be run to its end is a check that is missed.
    pub fn checks(&self, effort: Effort) -> Vec<Check> {
        match (self.run)(effort) {
            Ok(checks) => checks,
            Err(error) => vec![Check::broken(self.name, &error)],
        }
    }
}

/// Runs the problems of these names, or all if there are none, in the order of [`PROBLEMS`]; returns how many checks
/// were missed.
///
/// # Errors
/// If a name is not in the list; then nothing is run.
pub fn run(names: &[&str], effort: Effort, see: &mut dyn FnMut(&Check)) -> Result<usize, UnknownName> {
    if let Some(unknown) = names.iter().find(|name| PROBLEMS.iter().all(|p| p.name != **name)) {
        return Err(UnknownName { name: (*unknown).to_owned() });
    }
    let mut missed = 0;
    for problem in PROBLEMS.iter().filter(|p| names.is_empty() || names.contains(&p.name)) {
        for check in problem.checks(effort) {
            missed += usize::from(!check.pass);
            see(&check);
        }
    }
    Ok(missed)
}

#[cfg(test)]
mod tests;
