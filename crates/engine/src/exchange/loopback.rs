//! Ranks that are threads of one process: for tests, which need no other machine.

use super::{Exchange, Halo, To, room};
use std::collections::{HashMap, VecDeque};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};

/// Letters by sender and receiver, in the order in which they were sent, and ranks that are gone.
#[derive(Default)]
struct Letters {
    boxes: HashMap<(u32, u32), VecDeque<Vec<f64>>>,
    gone: Vec<u32>,
}

#[derive(Default)]
struct Post {
    letters: Mutex<Letters>,
    arrived: Condvar,
}

impl Post {
    fn letters(&self) -> MutexGuard<'_, Letters> {
        // Letters are whole whoever panicked.
        self.letters.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A rank of several that are threads of one process.
pub struct Loopback {
    rank: u32,
    ranks: u32,
    post: Arc<Post>,
}

impl Loopback {
    /// So many ranks that reach one another.
    pub fn ranks(ranks: u32) -> Vec<Loopback> {
        let post = Arc::new(Post::default());
        (0..ranks).map(|rank| Loopback { rank, ranks, post: post.clone() }).collect()
    }

    fn send(&self, to: u32, words: &[f64]) {
        self.post.letters().boxes.entry((self.rank, to)).or_default().push_back(words.to_vec());
        self.post.arrived.notify_all();
    }

    /// # Panics
    /// If the sender is gone.
    fn receive(&self, from: u32) -> Vec<f64> {
        let mut letters = self.post.letters();
        loop {
            if let Some(words) = letters.boxes.get_mut(&(from, self.rank)).and_then(VecDeque::pop_front) {
                return words;
            }
            assert!(!letters.gone.contains(&from), "rank {from} is gone");
            letters = self.post.arrived.wait(letters).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

impl Drop for Loopback {
    fn drop(&mut self) {
        self.post.letters().gone.push(self.rank);
        self.post.arrived.notify_all();
    }
}

impl Exchange for Loopback {
    fn rank(&self) -> u32 {
        self.rank
    }

    fn ranks(&self) -> u32 {
        self.ranks
    }

    fn start(&self, halo: &Halo, words: &mut Vec<f64>) {
        halo.send.iter().for_each(|(to, own)| self.send(*to, &words[own.clone()]));
    }

    fn finish(&self, halo: &Halo, words: &mut Vec<f64>) {
        let words = room(words, halo.words()[1]);
        for (from, own) in &halo.receive {
            words[own.clone()].copy_from_slice(&self.receive(*from));
        }
    }

    fn gather(&self, own: &[f64], counts: &[usize], to: To) -> Vec<f64> {
        assert_eq!(own.len(), counts[self.rank as usize], "rank {} says what it has", self.rank);
        let others = || (0..self.ranks).filter(|&other| other != self.rank);
        match to {
            To::First if self.rank > 0 => {
                self.send(0, own);
                return Vec::new();
            }
            To::First => {}
            To::All => others().for_each(|other| self.send(other, own)),
        }
        let mut all = Vec::with_capacity(counts.iter().sum());
        for (rank, &count) in (0..self.ranks).zip(counts) {
            let before = all.len();
            match rank == self.rank {
                true => all.extend_from_slice(own),
                false => all.extend(self.receive(rank)),
            }
            assert_eq!(all.len() - before, count, "rank {rank} sends what rank {} waits for", self.rank);
        }
        all
    }

    fn agree(&self, bits: u64) -> u64 {
        let all = self.gather(&[f64::from_bits(bits)], &vec![1; self.ranks as usize], To::All);
        all.into_iter().fold(0, |all, bits| all | bits.to_bits())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranks_are_told_what_the_others_have_and_which_of_them_are_gone() {
        std::thread::scope(|scope| {
            for one in Loopback::ranks(3) {
                scope.spawn(move || {
                    let me = one.rank();
                    // To each rank as many numbers as its own number, and to itself nothing.
                    let counts = |of: &dyn Fn(u32) -> u32| {
                        (0..3).map(|k| if k == me { 0 } else { of(k) as usize }).collect::<Vec<_>>()
                    };
                    let halo = Halo::new(counts(&|to| to).into_iter(), counts(&|_| me).into_iter());
                    let [sent, received] = halo.words();
                    one.start(&halo, &mut vec![f64::from(me); sent]);
                    let mut words = vec![f64::NAN; received];
                    one.finish(&halo, &mut words);
                    for (from, own) in &halo.receive {
                        assert!(words[own.clone()].iter().all(|&word| word == f64::from(*from)));
                    }
                    assert_eq!(
                        one.gather(&vec![7.0 + f64::from(me); me as usize], &[0, 1, 2], To::All),
                        [8.0, 9.0, 9.0]
                    );
                    assert_eq!(one.agree(1 << me), 0b111);
                });
            }
        });
        let mut two = Loopback::ranks(2);
        let (second, first) = (two.pop().unwrap(), two.pop().unwrap());
        drop(second);
        let waits = std::panic::AssertUnwindSafe(|| first.agree(0));
        assert!(std::panic::catch_unwind(waits).is_err(), "nobody waits for who is gone");
    }
}
