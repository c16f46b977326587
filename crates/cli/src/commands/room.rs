//! Whether this machine has room for a run, and how long it would take.

use crate::machine;
use crate::terminal::{bytes, duration};
use std::path::Path;
use tremolite::job::Job;

/// Share of what is free that a run may take: other programs grow as well.
const SHARE: f64 = 0.8;
/// Time \[s\] beyond which a run is told to be long.
const LONG: f64 = 12.0 * 3600.0;
/// Bytes of memory that an element takes at the least, of any law: what is read of a mesh is judged by them before a model is made.
const LEAST: u64 = 1000;

/// What is free, before anything is read.
pub struct Free {
    memory: Option<u64>,
    disk: Option<u64>,
}

impl Free {
    /// Of this machine's memory, and on the disk of a folder, which need not be there yet.
    pub fn now(folder: &Path) -> Free {
        Free { memory: machine::free_memory(), disk: machine::free_disk(folder) }
    }

    /// Why a mesh of so many elements is too large for the memory, if it is.
    pub fn lacks_for_mesh(&self, elements: usize) -> Option<String> {
        let sentence = |free| lacks("memory", LEAST * elements as u64, free, "more than");
        self.memory.and_then(sentence).map(|text| format!("{text} ({elements} elements); {COARSER}"))
    }

    /// Why a job is too large for memory or disk, if it is.
    pub fn lacks_for(&self, job: &Job) -> Vec<String> {
        let disk = tremolite::disk::disk(&job.model, &job.assembly, &job.phase, &job.plan, job.steps).total();
        let memory = self.memory.and_then(|free| lacks("memory", job.survey.bytes as u64, free, "some"));
        let disk = self.disk.and_then(|free| lacks("disk", disk, free, "up to"));
        let finer = "write field files more seldom, `snapshots` of [output], and fewer `fields`, or give a folder on a larger disk";
        let memory = memory.map(|text| format!("{text}; {COARSER}"));
        memory.into_iter().chain(disk.map(|text| format!("{text}; {finer}"))).collect()
    }
}

const COARSER: &str = "make elements coarser where waves allow it, or take a larger machine";

fn lacks(what: &str, needed: u64, free: u64, least: &str) -> Option<String> {
    let shown = |n: u64| bytes(usize::try_from(n).unwrap_or(usize::MAX));
    (needed as f64 > SHARE * free as f64).then(|| {
        format!(
            "the run needs {least} {} of {what}, beyond {:.0} % of the {} that are free",
            shown(needed),
            100.0 * SHARE,
            shown(free)
        )
    })
}

/// That a run is long, and what it goes by.
pub fn long(seconds: f64, set_by: &str) -> Option<String> {
    (seconds > LONG).then(|| {
        format!(
            "the run would take {}: the step is set by {set_by}; {}, make elements coarser where waves allow it, or shake for a \
             shorter time",
            duration(seconds),
            if set_by.starts_with("interface") { "give it a lower `normal_stiffness`" } else { "make that one larger" }
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_needs_more_than_four_fifths_of_what_is_free_is_said() {
        let free = Free { memory: Some(10_000_000_000), disk: None };
        assert_eq!(free.lacks_for_mesh(7_900_000), None);
        let text = free.lacks_for_mesh(8_100_000).unwrap();
        assert!(
            text.contains("more than 8.1 GB of memory, beyond 80 % of the 10.0 GB")
                && text.contains("coarser"),
            "{text}"
        );
        // Where the system does not tell what is free nothing is refused.
        assert_eq!(Free { memory: None, disk: None }.lacks_for_mesh(usize::MAX >> 16), None);
    }

    #[test]
    fn runs_of_more_than_half_a_day_are_said() {
        assert_eq!(long(11.9 * 3600.0, "an element"), None);
        let text = long(13.0 * 3600.0, "element 7 of 'lining'").unwrap();
        assert!(text.contains("13.0 h") && text.contains("element 7 of 'lining'"), "{text}");
    }
}
