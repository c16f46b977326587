//! What a stage is called on the page.

use tremolite_results::StageSummary;

use crate::language::{Language, say};

/// What a stage, as files name it, is called in the page's language: the program itself names the first.
pub fn name(language: Language, stage: &str) -> String {
    match stage {
        "initial equilibrium" => say!(language, "initial equilibrium"),
        other => other.to_owned(),
    }
}

/// A stage as one calls it: its number and its name.
pub fn called(language: Language, k: usize, stage: &StageSummary) -> String {
    if stage.name.is_empty() {
        say!(language, "stage {k}", k = k)
    } else {
        say!(language, "stage {k}, {name}", k = k, name = name(language, &stage.name))
    }
}
