//! What a stage is called on the page.

use tremolite_results::StageSummary;

use crate::language::{Language, say};

/// A stage as one calls it: its number and its name.
pub fn called(language: Language, k: usize, stage: &StageSummary) -> String {
    if stage.name.is_empty() {
        say!(language, "stage {k}", k = k)
    } else {
        say!(language, "stage {k}, {name}", k = k, name = stage.name)
    }
}
