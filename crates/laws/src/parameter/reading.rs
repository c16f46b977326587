//! Reading parameters with every fault named at once.

use std::collections::BTreeMap;

use super::{BadParameter, Kind, Need, Parameter, Values};

/// Collects what is wrong while reading goes on.
pub(crate) struct Reading<'a> {
    pub values: &'a Values,
    parameters: &'static [Parameter],
    pub faults: Vec<BadParameter>,
}

impl<'a> Reading<'a> {
    pub fn new(values: &'a Values, parameters: &'static [Parameter]) -> Self {
        Reading { values, parameters, faults: Vec::new() }
    }

    pub fn fault(&mut self, name: &'static str, problem: impl Into<String>, remedy: impl Into<String>) {
        self.faults.push(BadParameter::new(name, problem, remedy));
    }

    /// A number, or the default that its entry declares.
    pub fn number(
        &mut self,
        name: &'static str,
        holds: impl Fn(f64) -> bool,
        range: &str,
        remedy: &str,
    ) -> Option<f64> {
        let declared = self.parameters.iter().find(|p| p.name == name).map(|p| p.need);
        match (self.values.0.contains_key(name), declared) {
            (false, Some(Need::Number(x))) => Some(x),
            _ => match self.values.number_where(name, holds, &format!("must be {range}"), remedy) {
                Ok(x) => Some(x),
                Err(fault) => {
                    self.faults.push(fault);
                    None
                }
            },
        }
    }

    /// A number that may be left out: `Some(None)` where it is, `None` where it is wrong.
    pub fn optional(
        &mut self,
        name: &'static str,
        holds: impl Fn(f64) -> bool,
        range: &str,
        remedy: &str,
    ) -> Option<Option<f64>> {
        if !self.values.0.contains_key(name) {
            return Some(None);
        }
        self.number(name, holds, range, remedy).map(Some)
    }

    /// A table's columns if it is given, those that its entry requires among them, as many rows in each,
    /// all finite; else nothing, and faults are kept.
    pub fn table(&mut self, name: &'static str) -> Option<&'a BTreeMap<String, Vec<f64>>> {
        let values = self.values;
        let columns = values.table(name)?;
        let entry = self.parameters.iter().find(|p| p.name == name)?;
        let (known, what) = match entry.kind {
            Kind::Table(known) => (known, "column"),
            Kind::Set(known) => (known, "value"),
            Kind::Number(_) | Kind::Word(_) => return None,
        };
        let faults = self.faults.len();
        for column in known.iter().filter(|c| c.need == Need::Required && !columns.contains_key(c.name)) {
            self.fault(name, format!("has no {what} {}", column.name), "add it");
        }
        if columns.values().any(|c| c.iter().any(|x| !x.is_finite())) {
            self.fault(name, "holds numbers that are not finite", "give finite values");
        }
        let mut rows = columns.values().map(Vec::len);
        let first = rows.next();
        if first == Some(0) || rows.any(|n| Some(n) != first) {
            self.fault(name, "has columns of unlike lengths", "give every column one value a row");
        }
        (self.faults.len() == faults).then_some(columns)
    }

    /// A word, or the default that its entry declares.
    pub fn word(&mut self, name: &'static str) -> Option<&'static str> {
        let entry = self.parameters.iter().find(|p| p.name == name)?;
        let Kind::Word(words) = entry.kind else { return None };
        let default = if let Need::Word(word) = entry.need { word } else { "" };
        let given = if self.values.0.contains_key(name) {
            self.values.word(name).unwrap_or("a number")
        } else {
            default
        };
        let found = words.iter().find(|word| **word == given).copied();
        if found.is_none() {
            self.fault(name, format!("{given} is not known"), format!("one of {}", words.join(", ")));
        }
        found
    }
}
