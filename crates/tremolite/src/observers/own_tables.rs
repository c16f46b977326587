//! Tables of a program's own: what the state knows of them, and how they are cut back to it.

use super::observer::Setting;
use crate::error::RunError;
use tremolite_engine::state::Memory;
use tremolite_results::own_table::{self, OwnRow};

/// Before the name of a table, the key of what the state knows of it: the bytes written.
const MEMORY: &str = "own table:";

/// Cuts all of them back to the state that a stage or the shaking goes on from, whoever goes on with it: rows that came later go.
///
/// # Errors
/// If one is shorter than the state knows it, or cannot be written.
pub fn cut_back(setting: &Setting) -> Result<(), RunError> {
    let all = setting.memory.range(MEMORY.to_owned()..);
    let ours = all.take_while(|(key, _)| key.starts_with(MEMORY));
    let kept: Vec<(&str, u64)> = ours.map(|(key, bytes)| (&key[MEMORY.len()..], bytes[0] as u64)).collect();
    Ok(own_table::cut_back(setting.folder.root(), &kept)?)
}

/// Adds a row to a table in the folder `root` of the results, behind what the state knows of it.
///
/// # Errors
/// If the table has other columns, or cannot be written.
pub fn add_row(root: &std::path::Path, row: &OwnRow, memory: &mut Memory) -> Result<(), RunError> {
    let key = format!("{MEMORY}{}", row.table);
    let bytes = own_table::add(root, row, memory.get(&key).map(|bytes| bytes[0] as u64))?;
    memory.insert(key, vec![bytes as f64]);
    Ok(())
}

/// Leaves out what is known of the tables of another run, whose stages this one begins with: they lie in its folder.
pub fn forget(memory: &mut Memory) {
    memory.retain(|key, _| !key.starts_with(MEMORY));
}
