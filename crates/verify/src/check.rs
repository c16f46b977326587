//! One figure beside its reference.

use crate::VerifyError;
use crate::convergence::Order;
use crate::id::snake_case;
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
    /// Largest |value − reference| that passes, in `unit`; none where the difference is for information, as between a
    /// model and a test of the material.
    pub tolerance: Option<f64>,
    /// For information, whether the value is a number.
    pub pass: bool,
    /// Order of convergence found between the two finest of the meshes or steps that were run.
    pub order: Option<f64>,
    /// What the order was found from: the size of elements or steps over the finest, and the error there; coarsest first.
    pub levels: Vec<[f64; 2]>,
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
        value: impl Into<f64>,
        reference: f64,
        tolerance: f64,
        unit: &'static str,
        note: impl Into<String>,
    ) -> Self {
        let value = value.into();
        Check {
            name,
            quantity: quantity.into(),
            value,
            reference,
            tolerance: Some(tolerance),
            pass: (value - reference).abs() <= tolerance,
            order: None,
            levels: Vec::new(),
            unit,
            note: note.into(),
        }
    }

    /// Sets a value beside a measured one that the model need not meet.
    pub fn beside(
        name: &'static str,
        quantity: impl Into<String>,
        value: impl Into<f64>,
        measured: f64,
        unit: &'static str,
        note: impl Into<String>,
    ) -> Self {
        let value = value.into();
        let pass = value.is_finite();
        Check { tolerance: None, pass, ..Check::new(name, quantity, value, measured, 0.0, unit, note) }
    }

    /// Adds the order of convergence, for the reader; an order that must be met is a check of its own.
    pub fn with_order(mut self, order: Order) -> Self {
        self.order = Some(order.value());
        self.levels = order.levels().to_vec();
        self
    }

    /// Makes it one for information, where it says what the setting does not let one judge.
    pub(crate) fn only_told(&mut self) {
        self.tolerance = None;
        self.pass = self.value.is_finite();
    }

    /// The figure's name for programs, in snake case: the words of problem and quantity, and so unique over all problems
    /// ([`crate::Verification::verify`]).
    pub fn id(&self) -> String {
        snake_case(&format!("{} {}", self.name, self.quantity))
    }

    /// What a reader is told of a figure that did not simply pass: how far one for information is from its reference, and
    /// why another was missed.
    pub fn remark(&self) -> Option<String> {
        let Check { value, reference, note, .. } = self;
        let (off, unit) = (value - reference, self.unit_behind());
        match self.tolerance {
            _ if !value.is_finite() => Some(format!("MISS: {value} is no figure; {note}")),
            Some(_) if self.pass => None,
            Some(tolerance) => Some(format!(
                "MISS: {:.1e}{unit} from the reference, {:.3} times the tolerance; {note}",
                off.abs(),
                off.abs() / tolerance
            )),
            // Of nothing there are no percent.
            None if *reference == 0.0 => Some(format!("for information: {off:+.1e}{unit}")),
            None => Some(format!("for information: {:+.1} %", 100.0 * off / reference.abs())),
        }
    }

    /// The unit as it stands behind a number.
    fn unit_behind(&self) -> String {
        if self.unit == "1" { String::new() } else { format!(" {}", self.unit) }
    }

    /// The check of a problem that could not be run to its end.
    pub(crate) fn broken(name: &'static str, error: &VerifyError) -> Self {
        Check::new(name, "the problem runs", f64::NAN, 1.0, 0.0, "1", error.to_string())
    }
}

impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Check { name, quantity, value, reference, .. } = self;
        write!(f, "{name}: {quantity} = {value:.6e}{}, reference {reference:.6e}", self.unit_behind())?;
        self.tolerance.map_or(Ok(()), |tolerance| write!(f, " ± {tolerance:.1e}"))?;
        self.order.map_or(Ok(()), |order| write!(f, ", order {order:.2}"))?;
        self.remark().map_or(Ok(()), |remark| write!(f, "  {remark}"))
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
    fn a_figure_for_information_passes_if_it_is_a_number_and_shows_its_distance() {
        let check = |value, reference| Check::beside("x", "q", value, reference, "m", "");
        assert!(check(5.0, 2.0).pass && !check(f64::NAN, 2.0).pass);
        assert_eq!(
            check(1.5, 2.0).to_string(),
            "x: q = 1.500000e0 m, reference 2.000000e0  for information: -25.0 %"
        );
        assert_eq!(check(-1.5, -2.0).remark().unwrap(), "for information: +25.0 %");
    }

    #[test]
    fn beside_a_reference_of_zero_stands_the_difference_with_its_unit() {
        let remark = |unit| Check::beside("x", "q", 0.031, 0.0, unit, "").remark().unwrap();
        assert_eq!([remark("1"), remark("m")], ["for information: +3.1e-2", "for information: +3.1e-2 m"]);
    }

    #[test]
    fn a_miss_says_how_far_it_is_beyond_which_tolerance_and_what_the_tolerance_is() {
        let check = |value| Check::new("x", "q", value, 1.0, 0.125, "m", "an eighth: theory");
        assert_eq!(check(1.1).remark(), None);
        assert_eq!(
            check(1.25).to_string(),
            "x: q = 1.250000e0 m, reference 1.000000e0 ± 1.2e-1  MISS: 2.5e-1 m from the reference, 2.000 times the \
             tolerance; an eighth: theory"
        );
        assert_eq!(check(f64::INFINITY).remark().unwrap(), "MISS: inf is no figure; an eighth: theory");
    }

    #[test]
    fn a_problem_that_breaks_is_a_miss_that_says_why() {
        let check = Check::broken("x", &VerifyError::Singular(7));
        assert!(!check.pass && check.to_string().contains("MISS") && check.to_string().contains("row 7"));
    }
}
