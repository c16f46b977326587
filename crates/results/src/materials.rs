//! Materials as a run used them: what was given, what was filled in, what followed from it.

use serde::{Deserialize, Serialize};

use crate::{Said, number};

/// A material and what is made of it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct MaterialFacts {
    /// The law's word in a case.
    pub law: String,
    /// The law in words.
    pub summary: String,
    /// kg/m³
    #[serde(with = "number", default = "number::absent")]
    pub density: f64,
    /// Speed of P waves (m/s), by the elastic moduli.
    #[serde(with = "number", default = "number::absent")]
    pub wave_speed_p: f64,
    /// Speed of S waves (m/s).
    #[serde(with = "number", default = "number::absent")]
    pub wave_speed_s: f64,
    /// How it is damped, in words.
    pub damping: String,
    /// The same as a pattern; empty in files of other versions.
    #[serde(skip_serializing_if = "Said::is_empty")]
    pub damping_message: Said,
    /// What is made of it.
    pub groups: Vec<MaterialGroup>,
    /// The law's parameters and constants.
    pub values: Vec<MaterialValue>,
}

/// Groups of elements that one region of the case names.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct MaterialGroup {
    /// Names of the groups.
    pub names: String,
    /// What messages, tables and figures call it: its groups, or its material with the first of many. Empty in files of older versions.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub body: String,
    /// Number of elements.
    pub elements: u64,
    /// `reduced-integration` or `full-integration`.
    pub element: String,
}

/// Where a value of a material came from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Origin {
    /// The case gives it.
    #[default]
    Given,
    /// The case leaves it out; the law's default.
    Default,
    /// The law works it out from the others.
    Derived,
}

/// A parameter or constant of a law.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct MaterialValue {
    /// Its key in a case, or the constant's name.
    pub name: String,
    /// The value in SI, the smallest where it goes by the size of elements; NaN for a word.
    #[serde(with = "number", default = "number::absent")]
    pub value: f64,
    /// The largest value where it goes by the size of elements, else the same.
    #[serde(with = "number", default = "number::absent")]
    pub most: f64,
    /// The word, of parameters that are words or tables; else empty.
    pub word: String,
    /// SI unit (`rad` for angles); empty for pure numbers and words.
    pub unit: String,
    /// Meaning, in words.
    pub meaning: String,
    /// Where it came from.
    pub origin: Origin,
}
