//! How far a run can be trusted.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use crate::{TrustLine, number};

/// How far the run can be trusted, in numbers.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Soundness {
    /// Line of the energy balance → its value at the end (J).
    #[serde(deserialize_with = "number::deserialize_map")]
    pub energy: IndexMap<String, f64>,
    /// Each a number against its limit; every check is here, those that do not apply with the reason.
    pub checks: Vec<TrustLine>,
}
