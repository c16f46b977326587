//! Problems by their names.

use crate::{PROBLEMS, Verification};

/// A name that no problem has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no verification problem '{name}'; there are {}", names())]
pub struct UnknownName {
    pub name: String,
}

fn names() -> String {
    PROBLEMS.iter().map(|p| p.name).collect::<Vec<_>>().join(", ")
}

/// The problems of these names, or all if there are none, in the order of [`PROBLEMS`].
///
/// # Errors
/// If a name is not in the list.
pub fn select(names: &[&str]) -> Result<Vec<&'static Verification>, UnknownName> {
    if let Some(unknown) = names.iter().find(|name| PROBLEMS.iter().all(|p| p.name != **name)) {
        return Err(UnknownName { name: (*unknown).to_owned() });
    }
    Ok(PROBLEMS.iter().filter(|p| names.is_empty() || names.contains(&p.name)).collect())
}
