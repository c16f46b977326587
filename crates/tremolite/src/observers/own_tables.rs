//! Tables of a program's own: what the state knows of them, and how they are cut back to it.

use super::observer::Setting;
use crate::error::RunError;
use std::path::Path;
use tremolite_engine::state::Memory;
use tremolite_results::Extent;
use tremolite_results::own_table::{self, OwnRow};

/// Before the name of a table, the key of what the state knows of it: the bytes written and their checksum.
const MEMORY: &str = "own table:";

/// Cuts all of them back to the state that a stage or the shaking goes on from, whoever goes on with it: rows that came later go.
///
/// # Errors
/// If one does not begin with what the state knows of it, or cannot be written.
pub fn cut_back(setting: &Setting) -> Result<(), RunError> {
    Ok(own_table::cut_back(setting.folder.root(), &known(setting.memory))?)
}

/// Asks whether all of them begin with what the state knows of them.
pub(super) fn check(root: &Path, memory: &Memory) -> Result<(), RunError> {
    let all = known(memory);
    Ok(all.iter().try_for_each(|(table, extent)| extent.check(&own_table::path(root, table)))?)
}

/// What the state knows of each, by its name.
fn known(memory: &Memory) -> Vec<(&str, Extent)> {
    let all = memory.range(MEMORY.to_owned()..).take_while(|(key, _)| key.starts_with(MEMORY));
    all.filter_map(|(key, kept)| Some((&key[MEMORY.len()..], extent(kept)?))).collect()
}

/// Adds a row to a table in the folder `root` of the results, behind what the state knows of it.
///
/// # Errors
/// If the table has other columns, or cannot be written.
pub fn add_row(root: &Path, row: &OwnRow, memory: &mut Memory) -> Result<(), RunError> {
    let key = format!("{MEMORY}{}", row.table);
    let now = own_table::add(root, row, memory.get(&key).and_then(|kept| extent(kept)))?;
    memory.insert(key, now.kept().into());
    Ok(())
}

fn extent(kept: &[f64]) -> Option<Extent> {
    kept.first_chunk().map(|kept| Extent::of_kept(*kept))
}

/// Leaves out what is known of the tables of another run, whose stages this one begins with: they lie in its folder.
pub fn forget(memory: &mut Memory) {
    memory.retain(|key, _| !key.starts_with(MEMORY));
}
