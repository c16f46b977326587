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

/// [`tree`] of rows of numbers that lie one after another, column by column.
pub fn tree_of_rows(rows: &[f64], width: usize) -> Vec<f64> {
    let mut all = rows.to_vec();
    let mut count = rows.len() / width.max(1);
    while count > 1 {
        for k in 0..count.div_ceil(2) {
            for i in 0..width {
                let first = all[2 * k * width + i];
                let alone = 2 * k + 1 == count;
                all[k * width + i] = if alone { first } else { first + all[(2 * k + 1) * width + i] };
            }
        }
        count = count.div_ceil(2);
    }
    all.truncate(width);
    all
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
    use super::{tree, tree_of_rows};

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

    #[test]
    fn rows_are_added_in_the_order_of_the_tree() {
        for count in 0..40 {
            let rows: Vec<f64> =
                (0..3 * count).map(|k| f64::from(k * k + 1).sqrt().powi(k % 7 - 3)).collect();
            let each = rows.chunks_exact(3).map(<[f64]>::to_vec).collect();
            let plus = |a: Vec<f64>, b: Vec<f64>| a.iter().zip(&b).map(|(a, b)| a + b).collect();
            assert_eq!(tree_of_rows(&rows, 3), tree(each, plus), "{count}");
        }
    }
}
