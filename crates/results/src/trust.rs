//! The trust report: numbers against limits, and facts.
//!
//! Their texts are given as [`Said`] alone, and the English beside it is made of that: no text is without a pattern by
//! oversight, and the two cannot part.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use crate::{Said, number};

/// On which side of its limit a number should be.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Bound {
    /// value ≤ limit.
    #[default]
    AtMost,
    /// value ≥ limit.
    AtLeast,
}

/// One line of the trust report: a number against its limit.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct TrustLine {
    /// By which scripts and translations know it: snake case, once in a summary.
    pub id: String,
    /// What was measured.
    pub name: String,
    /// The same as a pattern; empty in files of other versions.
    #[serde(skip_serializing_if = "Said::is_empty")]
    pub name_message: Said,
    /// The number; NaN if it could not be had.
    #[serde(with = "number", default = "number::absent")]
    pub value: f64,
    /// Its limit.
    #[serde(with = "number", default = "number::absent")]
    pub limit: f64,
    /// On which side of the limit it should be.
    pub bound: Bound,
    /// Whether it is. False is a warning, not a failure of the run.
    pub pass: bool,
    /// SI unit; empty for a pure number.
    pub unit: String,
    /// What it means or where it was found, in words; may be empty.
    pub note: String,
    /// The same as a pattern.
    #[serde(skip_serializing_if = "Said::is_empty")]
    pub note_message: Said,
    /// Whether there was nothing to measure, as the note says; the line then neither passes nor warns.
    pub not_applicable: bool,
    /// What the value was made of, by name, SI units.
    #[serde(deserialize_with = "number::deserialize_map")]
    pub numbers: IndexMap<String, f64>,
}

impl TrustLine {
    /// A line that passes if `value ≤ limit`. NaN does not pass.
    pub fn at_most(id: impl Into<String>, name: Said, value: f64, limit: f64, unit: &str) -> Self {
        let pass = value <= limit;
        TrustLine { bound: Bound::AtMost, pass, ..Self::line(id.into(), name, value, limit, unit) }
    }

    /// A line that passes if `value ≥ limit`. NaN does not pass.
    pub fn at_least(id: impl Into<String>, name: Said, value: f64, limit: f64, unit: &str) -> Self {
        let pass = value >= limit;
        TrustLine { bound: Bound::AtLeast, pass, ..Self::line(id.into(), name, value, limit, unit) }
    }

    /// A line that passes if the share of a part in a whole is at most the limit. It does not apply where both are 0, with the reason.
    pub fn share_at_most(
        id: impl Into<String>,
        name: Said,
        [part, whole]: [f64; 2],
        limit: f64,
        why: Said,
    ) -> Self {
        match part == 0.0 && whole == 0.0 {
            true => Self::not_applicable(id, name, why),
            false => Self::at_most(id, name, part / whole, limit, ""),
        }
    }

    /// A line that cannot be judged, with the reason. Its `pass` is true, so that no reader takes it for a warning.
    pub fn not_applicable(id: impl Into<String>, name: Said, why: Said) -> Self {
        let line = Self::line(id.into(), name, f64::NAN, f64::NAN, "").with_note(why);
        TrustLine { not_applicable: true, pass: true, ..line }
    }

    /// The same line with a note.
    pub fn with_note(mut self, note: Said) -> Self {
        self.note = note.to_string();
        self.note_message = note;
        self
    }

    /// The same line with one of the numbers that it was made of.
    pub fn with(mut self, name: &str, value: f64) -> Self {
        self.numbers.insert(name.into(), value);
        self
    }

    fn line(id: String, name: Said, value: f64, limit: f64, unit: &str) -> Self {
        let line = TrustLine { id, name: name.to_string(), value, limit, ..TrustLine::default() };
        TrustLine { name_message: name, unit: unit.into(), ..line }
    }
}

/// Something that holds by construction.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Fact {
    /// As of a [`TrustLine`].
    pub id: String,
    /// What it is.
    pub name: String,
    /// The same as a pattern; empty in files of other versions.
    #[serde(skip_serializing_if = "Said::is_empty")]
    pub name_message: Said,
    /// The number.
    #[serde(with = "number", default = "number::absent")]
    pub value: f64,
    /// SI unit; empty for a pure number.
    pub unit: String,
    /// What it means, in words; may be empty.
    pub note: String,
    /// The same as a pattern.
    #[serde(skip_serializing_if = "Said::is_empty")]
    pub note_message: Said,
    /// Numbers that the note gives, by name, SI units.
    #[serde(deserialize_with = "number::deserialize_map", skip_serializing_if = "IndexMap::is_empty")]
    pub numbers: IndexMap<String, f64>,
}

impl Fact {
    pub fn new(id: impl Into<String>, name: Said, value: f64, unit: &str, note: Said) -> Self {
        Fact {
            id: id.into(),
            name: name.to_string(),
            name_message: name,
            value,
            unit: unit.into(),
            note: note.to_string(),
            note_message: note,
            numbers: IndexMap::new(),
        }
    }

    /// The same fact with one of the numbers that its note gives.
    pub fn with(mut self, name: &str, value: f64) -> Self {
        self.numbers.insert(name.into(), value);
        self
    }
}

/// A name of the user's as part of an id: letters and digits in small, `_` for all else.
pub fn snake(name: &str) -> String {
    let plain: String =
        name.chars().map(|c| if c.is_alphanumeric() { c.to_ascii_lowercase() } else { '_' }).collect();
    plain.split('_').filter(|part| !part.is_empty()).collect::<Vec<_>>().join("_")
}

/// Makes ids unique where names of the user's come out the same: the second gets `_2`.
pub fn tell_apart<'a>(ids: impl Iterator<Item = &'a mut String>) {
    let mut seen: IndexMap<String, u32> = IndexMap::new();
    for id in ids {
        let count = seen.entry(id.clone()).or_insert(0);
        *count += 1;
        if *count > 1 {
            *id = format!("{id}_{count}");
        }
    }
}
