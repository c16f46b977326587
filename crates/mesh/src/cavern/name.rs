//! Names that groups of a mesh begin or end with.

use super::CavernError;

/// The first part of a group's name, or the last; `taken` if another has it.
pub(super) fn check(name: &str, taken: bool) -> Result<(), CavernError> {
    let forbidden = |c: char| c.is_whitespace() || c.is_control() || ".*?[]{}\"'".contains(c);
    let must = if name.is_empty() || name.contains(forbidden) {
        "be a word without dots, stars, question marks, brackets, quotes or blanks"
    } else if name == "rock" || taken {
        "be used once, and not be \"rock\""
    } else {
        return Ok(());
    };
    Err(CavernError::Name { name: name.to_owned(), must })
}
