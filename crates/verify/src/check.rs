//! One figure beside its reference.

use crate::VerifyError;
use std::fmt;

/// One compared figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// Name of the problem.
    pub name: &'static str,
    /// What is compared.
    pub quantity: String,
    pub value: f64,
    /// Exact or published value; 0 where `value` is an error.
    pub reference: f64,
    /// Largest |value − reference| that passes, in `unit`.
    pub tolerance: f64,
    pub pass: bool,
    /// Order of convergence found between the two finest of the meshes or steps that were run.
    pub order: Option<f64>,
    /// SI unit of value, reference and tolerance; '1' for a pure number.
    pub unit: &'static str,
    /// Why the tolerance is what it is, and what else a reader should know.
    pub note: String,
}

impl Check {
    /// Compares a value with its reference; a value that is not a number misses.
    pub fn new(
        name: &'static str,
        quantity: impl Into<String>,
        value: f64,
        reference: f64,
        tolerance: f64,
        unit: &'static str,
        note: impl Into<String>,
    ) -> Self {
        Check {
            name,
            quantity: quantity.into(),
            value,
            reference,
            tolerance,
            pass: (value - reference).abs() <= tolerance,
            order: None,
            unit,
            note: note.into(),
        }
    }

    /// Adds the order of convergence, for the reader; an order that must be met is a check of its own.
    pub fn with_order(mut self, order: f64) -> Self {
        self.order = Some(order);
        self
    }

    /// The check of a problem that could not be run to its end.
    pub(crate) fn broken(name: &'static str, error: &VerifyError) -> Self {
        Check::new(name, "the problem runs", f64::NAN, 1.0, 0.0, "1", error.to_string())
    }
}

impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Check { name, quantity, value, reference, tolerance, unit, .. } = self;
        let word = if self.pass { "pass" } else { "MISS" };
        let unit = if *unit == "1" { String::new() } else { format!(" {unit}") };
        write!(
            f,
            "{word} {name}: {quantity} = {value:.6e}{unit}, reference {reference:.6e} ± {tolerance:.1e}"
        )?;
        self.order.map_or(Ok(()), |order| write!(f, ", order {order:.2}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_passes_within_its_tolerance_alone() {
        let check = |value| Check::new("x", "q", value, 1.0, 0.125, "m", "");
        assert!(check(1.125).pass && check(0.875).pass);
        assert!(!check(1.1251).pass && !check(0.8749).pass && !check(f64::NAN).pass);
    }

    #[test]
    fn a_problem_that_breaks_is_a_miss_that_says_why() {
        let check = Check::broken("x", &VerifyError::Singular(7));
        assert!(!check.pass && check.note.contains("row 7"));
    }
}
