//! Parameters that the elastic–plastic laws share, and the reading of them with every fault named at once.

use std::collections::BTreeMap;

use crate::material::Moduli;
use crate::materials::elastic::read_moduli;
use crate::parameter::{BadParameter, Dimension, Kind, Need, Parameter, Values};

pub(in crate::materials) const fn number(
    name: &'static str,
    dimension: Dimension,
    need: Need,
    doc: &'static str,
) -> Parameter {
    Parameter { name, kind: Kind::Number(dimension), need, doc }
}

pub(in crate::materials) const COHESION: Parameter =
    number("cohesion", Dimension::PRESSURE, Need::Required, "cohesion c, zero or more");

pub(in crate::materials) const FRICTION_ANGLE: Parameter =
    number("friction_angle", Dimension::ANGLE, Need::Required, "friction angle φ, from 0 up to 89.9°");

pub(in crate::materials) const DILATION_ANGLE: Parameter =
    number("dilation_angle", Dimension::ANGLE, Need::Number(0.0), "dilation angle ψ, from 0 up to φ");

/// M = (1 + sin x)/(1 − sin x), the slope in σ₁ over σ₃ of an angle.
pub(in crate::materials) fn slope(angle: f64) -> f64 {
    (1.0 + angle.sin()) / (1.0 - angle.sin())
}

/// Collects what is wrong while reading goes on.
pub(in crate::materials) struct Reading<'a> {
    values: &'a Values,
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

    pub fn moduli(&mut self) -> Option<Moduli> {
        read_moduli(self.values).map_err(|faults| self.faults.extend(faults)).ok()
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
        let Kind::Table(known) = entry.kind else { return None };
        let faults = self.faults.len();
        for column in known.iter().filter(|c| c.need == Need::Required && !columns.contains_key(c.name)) {
            self.fault(name, format!("has no column {}", column.name), "add it");
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

    /// c, φ and ψ of a Mohr–Coulomb envelope.
    pub fn envelope(&mut self) -> Option<[f64; 3]> {
        let cohesion =
            self.number("cohesion", |c| c >= 0.0, "zero or positive", "for rock 0.1 to 50 MPa is usual");
        let friction = self.number(
            "friction_angle",
            is_angle,
            ANGLES,
            "for rock 20 to 60 deg is usual; write the unit, as in \"42 deg\"",
        );
        let most = friction.unwrap_or(LARGEST_ANGLE);
        let dilation = self.number(
            "dilation_angle",
            |psi| (0.0..=most).contains(&psi),
            "from 0 up to the friction angle",
            "beyond it flow would give out energy; 0 to a quarter of it is usual",
        );
        if cohesion == Some(0.0) && friction == Some(0.0) {
            self.fault("cohesion", "is 0 and so is the friction angle", "give at least one of them");
            return None;
        }
        Some([cohesion?, friction?, dilation?])
    }
}

/// 89.9°: slopes stay below 1.4·10⁶.
pub(in crate::materials) const LARGEST_ANGLE: f64 = 89.9 * std::f64::consts::PI / 180.0;

/// What an angle must be.
pub(in crate::materials) const ANGLES: &str = "from 0 to 89.9 deg";

/// An angle that a slope can be made of.
pub(in crate::materials) fn is_angle(angle: f64) -> bool {
    (0.0..=LARGEST_ANGLE).contains(&angle)
}
