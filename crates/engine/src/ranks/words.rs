//! Values as numbers, and sums by a tree whose branches lie on several ranks.

use crate::parts::ElementEnergy;
use tremolite_kernels::Lines;
use tremolite_laws::{Octet, Row};

/// What is exchanged as so many numbers.
pub trait Words: Clone {
    fn put(&self, words: &mut Vec<f64>);
    /// From as many as [`Words::put`] left.
    fn take(words: &[f64]) -> Self;
}

impl Words for f64 {
    fn put(&self, words: &mut Vec<f64>) {
        words.push(*self);
    }

    fn take(words: &[f64]) -> Self {
        words[0]
    }
}

impl Words for Vec<f64> {
    fn put(&self, words: &mut Vec<f64>) {
        words.extend_from_slice(self);
    }

    fn take(words: &[f64]) -> Self {
        words.to_vec()
    }
}

impl<const N: usize> Words for [f64; N] {
    fn put(&self, words: &mut Vec<f64>) {
        words.extend_from_slice(self);
    }

    fn take(words: &[f64]) -> Self {
        std::array::from_fn(|k| words[k])
    }
}

impl Words for Row {
    fn put(&self, words: &mut Vec<f64>) {
        words.extend_from_slice(&self.0);
    }

    fn take(words: &[f64]) -> Self {
        Row(Words::take(words))
    }
}

impl Words for Octet {
    fn put(&self, words: &mut Vec<f64>) {
        words.extend_from_slice(&self.0);
    }

    fn take(words: &[f64]) -> Self {
        Octet(Words::take(words))
    }
}

impl Words for Lines {
    fn put(&self, words: &mut Vec<f64>) {
        words.extend(self.iter().map(|(_, x)| x));
    }

    fn take(words: &[f64]) -> Self {
        let mut lines = Lines::default();
        lines.values_mut().zip(words).for_each(|(x, word)| *x = *word);
        lines
    }
}

impl Words for ElementEnergy {
    fn put(&self, words: &mut Vec<f64>) {
        let ElementEnergy { strain, hourglass, dissipated, created, band } = *self;
        words.extend([strain, hourglass, dissipated, created, band]);
    }

    fn take(words: &[f64]) -> Self {
        let [strain, hourglass, dissipated, created, band] = Words::take(words);
        ElementEnergy { strain, hourglass, dissipated, created, band }
    }
}

/// The tree by which all sums over blocks and members are added (`sums`), whose leaves are values of several ranks. Each rank adds what lies under branches that are all its
/// own; what meets there is added by all.
pub struct Tree<T> {
    /// Level by level from the leaves up: whose all leaves below are, or [`SEVERAL`].
    of: Vec<Vec<u32>>,
    values: Vec<Vec<Option<T>>>,
}

const SEVERAL: u32 = u32::MAX;

impl<T: Words + Default> Tree<T> {
    /// Of leaves of these ranks; `own` are those of `rank`, in their order.
    pub fn new(of: Vec<u32>, rank: u32, own: impl IntoIterator<Item = T>) -> Self {
        let mut own = own.into_iter();
        let leaves = of.iter().map(|&one| if one == rank { own.next() } else { None }).collect();
        let (mut of, mut values) = (vec![of], vec![leaves]);
        while let Some(last) = of.last().filter(|last| last.len() > 1) {
            let next: Vec<u32> = last
                .chunks(2)
                .map(|pair| if pair.iter().all(|one| *one == pair[0]) { pair[0] } else { SEVERAL })
                .collect();
            values.push(vec![None; next.len()]);
            of.push(next);
        }
        Tree { of, values }
    }

    /// Adds what is under branches of a rank alone, or of several.
    pub(super) fn grow(&mut self, rank: u32, plus: impl Fn(T, T) -> T) {
        for k in 1..self.of.len() {
            for j in 0..self.of[k].len() {
                if self.of[k][j] != rank || self.values[k][j].is_some() {
                    continue;
                }
                let below = &mut self.values[k - 1];
                let first = below[2 * j].take();
                let second = below.get_mut(2 * j + 1).and_then(Option::take);
                self.values[k][j] = match (first, second) {
                    (Some(a), Some(b)) => Some(plus(a, b)),
                    (a, _) => a,
                };
            }
        }
    }

    /// The highest branches that are one rank's: level and place, and the rank.
    pub(super) fn summits(&self) -> Vec<([usize; 2], u32)> {
        let mut all = Vec::new();
        for (k, level) in self.of.iter().enumerate() {
            for (j, &rank) in level.iter().enumerate() {
                let above = self.of.get(k + 1).map(|above| above[j / 2]);
                if rank != SEVERAL && above.is_none_or(|above| above == SEVERAL) {
                    all.push(([k, j], rank));
                }
            }
        }
        all
    }

    pub(super) fn put(&self, [k, j]: [usize; 2], words: &mut Vec<f64>) {
        self.values[k][j].clone().unwrap_or_default().put(words);
    }

    pub(super) fn take(&mut self, [k, j]: [usize; 2], words: &[f64]) {
        self.values[k][j] = Some(T::take(words));
    }

    pub(super) fn sum(mut self, plus: impl Fn(T, T) -> T) -> T {
        self.grow(SEVERAL, plus);
        self.values.pop().and_then(|mut top| top.pop().flatten()).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sums::tree;

    /// Sums of numbers whose order shows in the last bits, of leaves shared out in several ways.
    #[test]
    fn branches_on_several_ranks_add_as_one_tree_does() {
        let plus = |a: f64, b: f64| a + b;
        for count in 0..70u32 {
            let leaf = |k: u32| (f64::from(k) + 0.1).sin() * 10f64.powi(k as i32 % 17);
            let whole = tree((0..count).map(leaf).collect(), plus);
            for ranks in 1..5u32 {
                for deal in [0, 1, 2] {
                    let of = |k: u32| match deal {
                        0 => k * ranks / count.max(1),
                        1 => k % ranks,
                        _ => (k * 7 + k / 3) % ranks,
                    };
                    let owners: Vec<u32> = (0..count).map(of).collect();
                    let own = |rank: u32| (0..count).filter(move |&k| of(k) == rank).map(leaf);
                    let mut grown: Vec<Tree<f64>> =
                        (0..ranks).map(|rank| Tree::new(owners.clone(), rank, own(rank))).collect();
                    (0..ranks).zip(&mut grown).for_each(|(rank, tree)| tree.grow(rank, plus));
                    let mut sum = Tree::new(owners.clone(), ranks, []);
                    for (place, rank) in sum.summits() {
                        let mut words = Vec::new();
                        grown[rank as usize].put(place, &mut words);
                        sum.take(place, &words);
                    }
                    assert_eq!(sum.sum(plus).to_bits(), whole.to_bits(), "{count} {ranks} {deal}");
                    if deal == 0 && count > 0 {
                        // Where two shares meet, one branch a level is of several ranks, and has one of a single rank beside it.
                        let levels = count.next_power_of_two().ilog2();
                        let most = (ranks - 1) * levels + ranks;
                        assert!(
                            grown[0].summits().len() <= most as usize,
                            "contiguous shares send few numbers"
                        );
                    }
                }
            }
        }
    }
}
