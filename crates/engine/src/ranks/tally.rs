//! What exchanging costs.

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::time::Duration;

/// Counts of a rank since it began.
#[derive(Debug, Default)]
pub struct Tally {
    halos: AtomicU64,
    words: AtomicU64,
    waited: AtomicU64,
    worked: AtomicU64,
}

/// What a rank's exchanging took so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Took {
    /// Messages of contributions, one for each evaluation, and bytes that were sent in all of them.
    pub halos: u64,
    pub bytes: u64,
    /// Time for which it waited for others, and in which its parts were evaluated \[s\].
    pub waited: f64,
    pub worked: f64,
}

impl Tally {
    pub(super) fn sent(&self, words: usize) {
        self.halos.fetch_add(1, Relaxed);
        self.words.fetch_add(words as u64, Relaxed);
    }

    pub(super) fn waited(&self, time: Duration) {
        self.waited.fetch_add(time.as_nanos() as u64, Relaxed);
    }

    pub(crate) fn worked(&self, time: Duration) {
        self.worked.fetch_add(time.as_nanos() as u64, Relaxed);
    }

    /// What it took so far.
    pub fn took(&self) -> Took {
        let seconds = |nanos: &AtomicU64| nanos.load(Relaxed) as f64 * 1e-9;
        Took {
            halos: self.halos.load(Relaxed),
            bytes: 8 * self.words.load(Relaxed),
            waited: seconds(&self.waited),
            worked: seconds(&self.worked),
        }
    }
}
