//! What can be wrong with a value and its unit.

use tremolite_laws::parameter::Dimension;

use super::{example, name};

/// Why a value with a unit was refused. `Display` says what is wrong, [`UnitError::remedy`] what to write.
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
    /// What to write instead, with an example.
    pub fn remedy(&self) -> String {
        match self {
            UnitError::Comma => "write the decimal point as a dot: \"0.5 m\"".to_owned(),
            UnitError::NotFinite => "give a finite value".to_owned(),
            UnitError::Unknown { meant: Some(meant), .. } => format!("did you mean `{meant}`?"),
            UnitError::NoUnit { number, wanted } => {
                let like = example(*wanted);
                let unit = like.split_once(' ').map_or("", |(_, unit)| unit);
                format!("write the unit: \"{number} {unit}\"")
            }
            UnitError::NoNumber { wanted }
            | UnitError::Unknown { wanted, .. }
            | UnitError::Malformed { wanted, .. }
            | UnitError::WrongDimension { wanted, .. } => {
                format!("write {} such as \"{}\"", name(*wanted), example(*wanted))
            }
        }
    }
}

impl std::fmt::Display for UnitError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            UnitError::NoNumber { .. } => write!(f, "does not start with a number"),
            UnitError::Comma => write!(f, "has a comma in its number"),
            UnitError::NoUnit { wanted, .. } => write!(f, "has no unit, {} is expected", name(*wanted)),
            UnitError::Unknown { unit, .. } => write!(f, "has an unknown unit `{unit}`"),
            UnitError::Malformed { unit, .. } => write!(f, "has a unit that cannot be read, `{unit}`"),
            UnitError::WrongDimension { unit, found, wanted } => {
                write!(f, "is {} (`{unit}`), {} is expected", name(*found), name(*wanted))
            }
            UnitError::NotFinite => write!(f, "is too large a number"),
        }
    }
}

impl std::error::Error for UnitError {}
