//! Sums that are the same bits on any number of threads, and shared out in any way: by blocks, which a fixed tree adds.

use crate::node_table::Nodes;
use rayon::prelude::*;
use std::ops::Range;

/// The sum of some, added in pairs, the pairs in pairs, and so on.
pub fn tree<T: Default>(mut all: Vec<T>, plus: impl Fn(T, T) -> T) -> T {
    while all.len() > 1 {
        let mut rest = all.into_iter();
        let mut sums = Vec::with_capacity(rest.len().div_ceil(2));
        while let Some(a) = rest.next() {
            sums.push(match rest.next() {
                Some(b) => plus(a, b),
                None => a,
            });
        }
        all = sums;
    }
    all.pop().unwrap_or_default()
}

/// The sum over all nodes of what `one` finds in a block of them.
pub fn over_nodes<T: Default + Send>(
    nodes: &Nodes,
    one: impl Fn(Range<usize>) -> T + Sync,
    plus: impl Fn(T, T) -> T,
) -> T {
    tree(nodes.blocks.par_iter().map(|block| one(block.nodes.clone())).collect(), plus)
}

#[cfg(test)]
mod tests {
    use super::tree;

    #[test]
    fn a_tree_adds_all_in_an_order_that_their_number_alone_sets() {
        for count in 0..40u32 {
            let all: Vec<String> = (0..count).map(|k| k.to_string()).collect();
            let flat: String = all.concat();
            let sum = tree(all, |a, b| if a.is_empty() { b } else { format!("({a}{b})") });
            assert_eq!(sum.replace(['(', ')'], ""), flat);
            let depth = sum.chars().scan(0, |d, c| {
                *d += i32::from(c == '(') - i32::from(c == ')');
                Some(*d)
            });
            assert!(depth.max().unwrap_or(0) <= (f64::from(count.max(1))).log2().ceil() as i32, "{sum}");
        }
    }
}
