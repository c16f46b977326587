//! What stays of runs: with `keep = "tables"` fields go as a run is done, and what a group shook from once it serves nobody.

use super::Queue;
use crate::exit::Failure;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use tremolite_case::study::Keep;
use tremolite_results::study::RunStatus;
use tremolite_results::{HAND_OVER, ResultFolder};

/// Folders of results that hold fields and figures alone.
const FIELDS: [&str; 4] = ["fields", "interfaces", "stages", "bolts"];

impl Queue<'_> {
    /// Removes what is not kept of all runs: this program may have been ended before it did.
    pub fn tidy_all(&self) -> Result<(), Failure> {
        if self.study.run.keep != Keep::Tables {
            return Ok(());
        }
        let done = |run: &usize| self.outcome(*run).status == RunStatus::Done;
        (0..self.planned.len()).filter(done).try_for_each(|run| self.tidy(run))?;
        let groups: BTreeSet<_> = self.planned.iter().map(|planned| planned.before).collect();
        groups.into_iter().try_for_each(|group| self.drop_hand_overs(group))
    }

    /// Removes the fields of a run that is done.
    pub(super) fn tidy(&self, run: usize) -> Result<(), Failure> {
        if self.study.run.keep != Keep::Tables {
            return Ok(());
        }
        let root = self.folder(run).results();
        FIELDS.iter().try_for_each(|fields| {
            remove(&root.join(fields), |path| fs::remove_dir_all(path))?;
            remove(&root.join(format!("{fields}.pvd")), |path| fs::remove_file(path))
        })?;
        let gone = |name: &str| {
            let rest = |fields: &str| name.strip_prefix(fields);
            FIELDS.into_iter().filter_map(rest).any(|rest| rest == ".pvd" || rest.starts_with('/'))
        };
        ResultFolder::open_existing(&root)
            .and_then(|results| results.leave_out(gone))
            .map_err(Failure::failed)
    }

    /// Removes what the runs of a group shook from once none of them can want it: none is left, and none was ended from outside, which is likely
    /// to be asked for again.
    pub(super) fn drop_hand_overs(&self, group: Option<usize>) -> Result<(), Failure> {
        let Some(group) = group.filter(|_| self.study.run.keep == Keep::Tables) else { return Ok(()) };
        let of_group = || (0..self.planned.len()).filter(|other| self.planned[*other].before == Some(group));
        let serves = |run: usize| match self.outcome(run).status {
            RunStatus::Pending => !self.is_not_needed(run),
            status => status == RunStatus::Error,
        };
        if of_group().any(serves) {
            return Ok(());
        }
        of_group().try_for_each(|other| {
            remove(&self.folder(other).results().join("checkpoint").join(HAND_OVER), |path| {
                fs::remove_file(path)
            })
        })
    }
}

fn remove(path: &Path, how: impl Fn(&Path) -> std::io::Result<()>) -> Result<(), Failure> {
    match how(path) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => {
            Err(Failure::failed(format!("{}: {e}", path.display())))
        }
        _ => Ok(()),
    }
}
