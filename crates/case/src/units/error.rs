//! What can be wrong with a value and its unit.

use tremolite_laws::parameter::Dimension;

use super::{example, likely, name, name_for};

/// Why a value with a unit was refused: what is wrong, and what to write. Both take the key that the value stands for, as
/// it tells a unit weight from a stiffness; an empty one says nothing.
#[derive(Clone, Debug, PartialEq)]
pub enum UnitError {
    /// The text does not start with a number.
    NoNumber { wanted: Dimension },
    /// A comma in the number.
    Comma,
    /// A number without its unit.
    NoUnit { number: String, wanted: Dimension },
    /// A unit that is not known; `meant` is the one with the same letters, if there is one.
    Unknown { unit: String, meant: Option<String>, wanted: Dimension },
    /// Text that is no product of powers of units.
    Malformed { unit: String, wanted: Dimension },
    /// A good unit of another dimension.
    WrongDimension { unit: String, found: Dimension, wanted: Dimension },
    /// Too large for a double.
    NotFinite,
}

impl UnitError {
    /// What is wrong with the value of this key, to be read after the key.
    pub fn message(&self, key: &str) -> String {
        match self {
            UnitError::NoNumber { .. } => "does not start with a number".to_owned(),
            UnitError::Comma => "has a comma in its number".to_owned(),
            UnitError::NoUnit { wanted, .. } => {
                format!("has no unit, {} is expected", name_for(key, *wanted))
            }
            UnitError::Unknown { unit, .. } => format!("has an unknown unit `{unit}`"),
            UnitError::Malformed { unit, .. } => format!("has a unit that cannot be read, `{unit}`"),
            UnitError::WrongDimension { unit, found, wanted } => {
                format!("is {} (`{unit}`), {} is expected", name(*found), name_for(key, *wanted))
            }
            UnitError::NotFinite => "is too large a number".to_owned(),
        }
    }

    /// What to write instead, with an example.
    pub fn remedy(&self, key: &str) -> String {
        match self {
            UnitError::Comma => "write the decimal point as a dot: \"0.5 m\"".to_owned(),
            UnitError::NotFinite => "give a finite value".to_owned(),
            UnitError::Unknown { meant: Some(meant), .. } => format!("did you mean `{meant}`?"),
            UnitError::NoUnit { number, wanted } => {
                format!("write the unit: \"{}\"", likely(key, number.parse().unwrap_or(1.0), *wanted))
            }
            UnitError::WrongDimension { found: Dimension::DENSITY, .. } if key == "unit_weight" => {
                "give a mass per volume as `density`, in place of `unit_weight`".to_owned()
            }
            UnitError::WrongDimension { found: Dimension::UNIT_WEIGHT, .. } if key == "density" => {
                "give a weight per volume as `unit_weight`, in place of `density`".to_owned()
            }
            UnitError::NoNumber { wanted }
            | UnitError::Unknown { wanted, .. }
            | UnitError::Malformed { wanted, .. }
            | UnitError::WrongDimension { wanted, .. } => {
                format!("write {} such as \"{}\"", name_for(key, *wanted), example(key, *wanted))
            }
        }
    }
}

impl std::fmt::Display for UnitError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message(""))
    }
}

impl std::error::Error for UnitError {}
