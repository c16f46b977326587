//! Which field files of the shaking figures are cut out of.

use std::rc::Rc;

use tremolite_results::{Fields, Pvd, Snapshot, Status};

use crate::language::say;
use crate::quantities::scale::moment;
use crate::source::Source;

/// The field files of the shaking.
pub struct Snapshots<'a> {
    source: &'a Source,
    pvd: Pvd,
}

impl<'a> Snapshots<'a> {
    /// Those of a folder, at least one.
    ///
    /// # Errors
    /// A sentence that says why there are none.
    pub fn of(source: &'a Source) -> Result<Self, String> {
        let path = source.folder.pvd();
        if !path.exists() {
            return Err(say!(source.language, "There is no fields.pvd in the result folder."));
        }
        let pvd = Pvd::read(&path).map_err(|e| format!("{e}."))?;
        if pvd.snapshots().is_empty() {
            return Err(say!(source.language, "fields.pvd lists no field file yet."));
        }
        Ok(Snapshots { source, pvd })
    }

    /// As [`of`](Self::of), of which the last can be read.
    ///
    /// # Errors
    /// A sentence that says why it cannot, or why there are none.
    pub fn readable(source: &'a Source) -> Result<Self, String> {
        let snapshots = Self::of(source)?;
        snapshots.read(snapshots.last()).map(|_| snapshots)
    }

    /// All of them, as they were written.
    pub fn all(&self) -> &[Snapshot] {
        self.pvd.snapshots()
    }

    /// The first.
    pub fn first(&self) -> &Snapshot {
        &self.all()[0]
    }

    /// The last.
    pub fn last(&self) -> &Snapshot {
        &self.all()[self.all().len() - 1]
    }

    /// The one nearest to a time.
    pub fn nearest(&self, time: f64) -> &Snapshot {
        let far = |snapshot: &&Snapshot| (snapshot.time - time).abs();
        self.all().iter().min_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(self.last())
    }

    /// Its file.
    ///
    /// # Errors
    /// A sentence that says why it cannot be read.
    pub fn read(&self, snapshot: &Snapshot) -> Result<Rc<Fields>, String> {
        self.source.fields.at(&self.pvd, snapshot)
    }

    /// A time, in words.
    pub fn at(&self, time: f64) -> String {
        say!(self.source.language, "at {time}\u{a0}s", time = moment(time, self.source.duration()))
    }

    /// What the first file stands for: nothing has shaken yet, or something has.
    pub fn before(&self) -> String {
        let first = self.first().time;
        if first == 0.0 { say!(self.source.language, "before the earthquake, t = 0") } else { self.at(first) }
    }

    /// What the last file stands for.
    pub fn after(&self) -> String {
        let time = moment(self.last().time, self.source.duration());
        // Of a run that was stopped, failed, or is still going on the last file is not the end.
        match self.source.summary.as_ref().is_ok_and(|summary| summary.conclusion.status == Status::Done) {
            true => say!(self.source.language, "after the earthquake, t = {time}\u{a0}s", time = time),
            false => say!(self.source.language, "so far, t = {time}\u{a0}s", time = time),
        }
    }
}
