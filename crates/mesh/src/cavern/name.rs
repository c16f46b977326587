//! Names that groups of a mesh begin or end with.

use super::CavernError;
use super::error::Named;

/// The first part of a group's name, or the last of a layer's; `taken` if another has it.
pub(super) fn check(of: Named, name: &str, taken: bool) -> Result<(), CavernError> {
    let forbidden = |c: char| c.is_whitespace() || c.is_control() || ".*?[]{}\"'".contains(c);
    let why = if name.is_empty() || name.contains(forbidden) {
        "a name is a word without dots, stars, question marks, brackets, quotes or blanks".to_owned()
    } else if name == "rock" {
        match of {
            Named::Layer => "its group would be \"rock.rock\"".to_owned(),
            _ => "\"rock\" is the group of the rock".to_owned(),
        }
    } else if taken {
        "the name is used twice".to_owned()
    } else {
        return Ok(());
    };
    Err(CavernError::Name { of, name: name.to_owned(), why })
}
