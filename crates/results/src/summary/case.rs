//! What the case asked for and left open, and what it was read from.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use crate::Fact;

/// The case that was run: what it asked for and left open, what is to be known of it, and what it was read from.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct CaseFacts {
    /// How the page is to be set.
    pub report: PageWish,
    /// Whether numbers without a unit were in SI, as the case said of itself.
    pub assume_si: bool,
    /// What was unusual about the case before the run, a sentence each with what to do.
    pub warnings: Vec<String>,
    /// What is true by construction, for people to know.
    pub facts: Vec<Fact>,
    /// What the run read: mesh, records, case.
    pub inputs: Vec<Input>,
    /// Version of the program.
    pub version: String,
    /// What the case left out and the program chose.
    pub defaults_used: Vec<Defaulted>,
}

/// How the case wants its page set, and what is to stand on its first sheet.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct PageWish {
    /// `en` or `zh`.
    pub language: String,
    /// Whether the page holds the model in three dimensions.
    pub view: bool,
    /// The project, and the level of the design earthquake, in the case's words; empty where it does not say.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub project: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    pub design_level: String,
    /// `designed`, `checked`, `reviewed`, `approved` → who did; those left out are lines to sign on.
    #[serde(skip_serializing_if = "IndexMap::is_empty")]
    pub signed: IndexMap<String, String>,
    /// `displacement` (m), `crack_width` (m), `damage` (1), `utilisation` (1) → limit of acceptance.
    #[serde(skip_serializing_if = "IndexMap::is_empty")]
    pub limits: IndexMap<String, f64>,
}

impl Default for PageWish {
    fn default() -> Self {
        PageWish {
            language: "en".into(),
            view: true,
            project: String::new(),
            design_level: String::new(),
            signed: IndexMap::new(),
            limits: IndexMap::new(),
        }
    }
}

/// A file that the run read.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Input {
    /// As the case names it; `case` for the case itself.
    pub name: String,
    /// Where it lay.
    pub path: String,
    /// SHA-256 of its bytes, in hexadecimal digits.
    pub hash: String,
}

/// A key that the case left out.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Defaulted {
    /// The key with its tables, `dynamic.damping.ratio`.
    pub key: String,
    /// The value used, as one would write it in the case, unit included.
    pub value: String,
}

impl Defaulted {
    /// A key and the value used for it.
    pub fn new(key: impl Into<String>, value: impl Into<String>) -> Self {
        Defaulted { key: key.into(), value: value.into() }
    }
}
