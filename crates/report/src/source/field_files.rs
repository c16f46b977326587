//! Field files, each read once for all figures that are cut out of it.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use tremolite_results::{Fields, Pvd, Snapshot};

/// What was read so far: few files, as figures show the first, the last, and one in between.
#[derive(Default)]
pub struct FieldFiles {
    read: RefCell<BTreeMap<PathBuf, Result<Rc<Fields>, String>>>,
}

impl FieldFiles {
    /// The file, or a sentence that says why it cannot be read.
    pub fn open(&self, path: &Path) -> Result<Rc<Fields>, String> {
        let mut read = self.read.borrow_mut();
        let file = || Fields::read(path).map(Rc::new).map_err(|e| format!("{e}."));
        read.entry(path.to_owned()).or_insert_with(file).clone()
    }

    /// The file of a snapshot.
    pub fn at(&self, pvd: &Pvd, snapshot: &Snapshot) -> Result<Rc<Fields>, String> {
        self.open(&pvd.locate(snapshot))
    }
}
