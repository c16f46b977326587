//! A table that grows with a run, and what the state knows of it.

use super::own_tables;
use crate::error::RunError;
use std::path::Path;
use tremolite_engine::state::Memory;
use tremolite_results::{Column, Extent, TableWriter};

/// Before the name of a file, the key of what the state knows of it: the bytes written and their checksum.
const MEMORY: &str = "table ";

/// What the state knows of a table.
pub(super) fn known(path: &Path, memory: &Memory) -> Option<Extent> {
    let kept = memory.get(&key(path))?;
    kept.first_chunk().map(|kept| Extent::of_kept(*kept))
}

/// Has the state know what is in a table.
pub(super) fn remember(path: &Path, extent: Extent, memory: &mut Memory) {
    memory.insert(key(path), extent.kept().into());
}

/// Asks whether the tables in a folder begin with what the state knows of them.
///
/// # Errors
/// If one does not, or cannot be read.
pub(crate) fn check(root: &Path, memory: &Memory) -> Result<(), RunError> {
    let all = memory.range(MEMORY.to_owned()..).take_while(|(key, _)| key.starts_with(MEMORY));
    for (key, kept) in all {
        if let Some(kept) = kept.first_chunk() {
            Extent::of_kept(*kept).check(&root.join(&key[MEMORY.len()..]))?;
        }
    }
    own_tables::check(root, memory)
}

fn key(path: &Path) -> String {
    format!("{MEMORY}{}", path.file_name().unwrap_or_default().to_string_lossy())
}

/// A table of numbers in the folder of results, to which an observer adds a row now and then. A run that is resumed goes on with it where its
/// state left it.
#[derive(Debug)]
pub struct RunTable {
    path: std::path::PathBuf,
    writer: TableWriter,
}

impl RunTable {
    /// Starts the table, or goes on with it where the state left it: rows that came later go.
    ///
    /// # Errors
    /// If the file cannot be written, or does not begin with what the state knows of it.
    pub fn new(path: &Path, columns: &[Column], memory: &Memory) -> Result<Self, RunError> {
        let writer = match known(path, memory) {
            Some(extent) => TableWriter::resume(path, columns, extent)?,
            None => TableWriter::create(path, columns)?,
        };
        Ok(RunTable { path: path.to_owned(), writer })
    }

    /// Adds a row.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&mut self, row: &[f64], memory: &mut Memory) -> Result<(), RunError> {
        self.writer.write(row)?;
        remember(&self.path, self.writer.extent(), memory);
        Ok(())
    }
}
