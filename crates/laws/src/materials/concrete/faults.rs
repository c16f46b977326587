//! Reading the concrete law's keys with every fault named at once.

use super::parameters::PARAMETERS;
use crate::parameter::{BadParameter, Kind, Need, Values};

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
