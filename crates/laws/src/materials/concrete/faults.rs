//! Reading the concrete law's keys with every fault named at once.

use super::Split;
use super::parameters::PARAMETERS;
use crate::parameter::{BadParameter, Kind, Need, Value, Values};

/// Collects what is wrong while reading goes on, so that one run names every mistake.
#[derive(Default)]
pub(super) struct Faults(pub Vec<BadParameter>);

impl Faults {
    pub fn keep<T>(&mut self, read: Result<T, BadParameter>) -> Option<T> {
        read.map_err(|fault| self.0.push(fault)).ok()
    }

    /// A number in the table, or the one that the parameter's own entry declares.
    pub fn number(
        &mut self,
        values: &Values,
        name: &'static str,
        holds: impl Fn(f64) -> bool,
        range: &str,
    ) -> Option<f64> {
        let declared = PARAMETERS.iter().find(|p| p.name == name).map(|p| p.need);
        match (values.optional(name), declared) {
            (None, Some(Need::Number(x))) => Some(x),
            _ => self.keep(values.number_where(
                name,
                holds,
                &format!("must be {range}"),
                "give a value in that range",
            )),
        }
    }

    /// A number that may be left out.
    pub fn optional(&mut self, values: &Values, name: &'static str) -> Option<f64> {
        values.optional(name)?;
        self.number(values, name, |x| x > 0.0, "positive")
    }

    /// Refuses keys that say something other than their default and have no meaning with the words chosen.
    pub fn idle(&mut self, values: &Values, exponential: bool, static_alone: bool, split: Split) {
        let says = |name: &str| {
            let declared = PARAMETERS.iter().find(|p| p.name == name).map(|p| p.need);
            match (values.0.get(name), declared) {
                (Some(Value::Number(x)), Some(Need::Number(own))) => *x != own,
                (Some(Value::Word(word)), Some(Need::Word(own))) => word != own,
                (given, _) => given.is_some(),
            }
        };
        for (name, idle, with, remedy) in [
            (
                "residual_tension",
                exponential,
                "evolution = exponential, which falls to nothing",
                "leave it out, or choose evolution = \"residual\"",
            ),
            ("reference_rate", static_alone, "rate = none", "leave it out, or choose a rate law"),
            ("rate_filter_time", static_alone, "rate = none", "leave it out, or choose a rate law"),
            (
                "shear_tension",
                split == Split::Compliance,
                "split = compliance, which tests what the point carries",
                "leave it out, or choose split = \"effective\"",
            ),
        ] {
            if idle && says(name) && self.0.iter().all(|fault| fault.name != name) {
                self.0.push(BadParameter::new(name, format!("has no meaning with {with}"), remedy));
            }
        }
    }

    /// The position of a word in the parameter's list; the declared word where none is given.
    pub fn word(&mut self, values: &Values, name: &'static str) -> &'static str {
        let Some((words, first)) =
            PARAMETERS.iter().find(|p| p.name == name).and_then(|p| match (p.kind, p.need) {
                (Kind::Word(words), Need::Word(first)) => Some((words, first)),
                _ => None,
            })
        else {
            return "";
        };
        let given = values.word(name).unwrap_or(first);
        match words.iter().find(|w| **w == given) {
            Some(word) => word,
            None => {
                self.0.push(BadParameter::new(
                    name,
                    format!("{given} is not known"),
                    format!("one of {}", words.join(", ")),
                ));
                first
            }
        }
    }
}
