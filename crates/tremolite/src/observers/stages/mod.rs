//! What is seen of the stages before the shaking.

mod beginning;
mod beside;
mod grids;
mod relaxation;
mod rows;

pub use beginning::{Beginning, Begins, uneven};
pub use beside::{Beside, BesidePlanes};
pub use grids::StageGrids;
pub use relaxation::Relaxation;
pub use rows::{StageRows, summaries};

use crate::error::RunError;
use crate::plan::Plan;
use tremolite_engine::Model;
use tremolite_engine::state::Memory;
use tremolite_results::ResultFolder;

/// Writes stages.csv and relaxation.csv of what the state remembers, as observers do at the end of a stage.
///
/// # Errors
/// If a file cannot be written.
pub(crate) fn write_tables(
    folder: &ResultFolder,
    model: &Model,
    plan: &Plan,
    memory: &Memory,
) -> Result<(), RunError> {
    rows::write(folder, model, plan, memory)?;
    relaxation::write(folder, memory)
}
