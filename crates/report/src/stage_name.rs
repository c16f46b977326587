//! What a stage is called on the page.

use tremolite_results::StageSummary;

/// A stage as one calls it: its number and its name.
pub fn called(k: usize, stage: &StageSummary) -> String {
    if stage.name.is_empty() { format!("stage {k}") } else { format!("stage {k}, {}", stage.name) }
}
