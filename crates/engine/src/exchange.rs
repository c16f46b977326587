//! What ranks that work on one model together tell one another: processes on one machine or on many, or threads of a test.
//!
//! All is numbers, handed over bit by bit. Every rank makes the same calls in the same order; nothing is added on the way, so no sum
//! depends on how a message went.

mod loopback;

pub use loopback::Loopback;

use std::ops::Range;

/// Whom a rank sends numbers to and receives numbers from at once, and where they lie among all that it sends and receives.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Halo {
    /// (rank, its numbers), ascending by rank, without gaps.
    pub send: Vec<(u32, Range<usize>)>,
    pub receive: Vec<(u32, Range<usize>)>,
}

impl Halo {
    /// Of so many numbers for, and from, each rank.
    pub fn new(send: impl Iterator<Item = usize>, receive: impl Iterator<Item = usize>) -> Self {
        Halo { send: ranges(send), receive: ranges(receive) }
    }

    /// Numbers that are sent, and that are received.
    pub fn words(&self) -> [usize; 2] {
        [&self.send, &self.receive].map(|all| all.last().map_or(0, |(_, range)| range.end))
    }
}

fn ranges(counts: impl Iterator<Item = usize>) -> Vec<(u32, Range<usize>)> {
    let mut at = 0;
    let mut all = Vec::new();
    for (rank, count) in (0..).zip(counts) {
        if count > 0 {
            all.push((rank, at..at + count));
            at += count;
        }
    }
    all
}

/// Who is given what all ranks have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum To {
    /// Rank 0, which speaks and writes.
    First,
    All,
}

/// One rank's way to the others. A call that waits for a rank that is gone does not come back: it ends this rank as well, by a panic
/// or with the whole process.
pub trait Exchange: Send + Sync {
    /// Which of them it is, from 0.
    fn rank(&self) -> u32;
    /// How many there are.
    fn ranks(&self) -> u32;
    /// Begins to send the first of these numbers, as many as the halo sends, and to receive others. One halo is on its way at a time. The
    /// memory may be kept until it has arrived; then other memory is left in its place.
    fn start(&self, halo: &Halo, words: &mut Vec<f64>);
    /// Waits for what the halo receives, which are then the first of `words`. Its memory may be kept, as above.
    fn finish(&self, halo: &Halo, words: &mut Vec<f64>);
    /// All ranks' numbers, those of rank 0 first, of which there are so many of each; nothing where they are not given.
    fn gather(&self, own: &[f64], counts: &[usize], to: To) -> Vec<f64>;
    /// The bits that any rank sets.
    fn agree(&self, bits: u64) -> u64;
}

/// Makes sure that there is room for so many numbers, and gives it; nothing is cut off, so that nothing is filled again.
pub fn room(words: &mut Vec<f64>, count: usize) -> &mut [f64] {
    if words.len() < count {
        words.resize(count, 0.0);
    }
    &mut words[..count]
}

/// One process, which has nobody to tell anything.
#[derive(Clone, Copy, Debug, Default)]
pub struct Alone;

impl Exchange for Alone {
    fn rank(&self) -> u32 {
        0
    }

    fn ranks(&self) -> u32 {
        1
    }

    fn start(&self, _: &Halo, _: &mut Vec<f64>) {}

    fn finish(&self, _: &Halo, _: &mut Vec<f64>) {}

    fn gather(&self, own: &[f64], _: &[usize], _: To) -> Vec<f64> {
        own.to_vec()
    }

    fn agree(&self, bits: u64) -> u64 {
        bits
    }
}
