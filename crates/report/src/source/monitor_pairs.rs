//! Pairs of monitors: how the names in a table's headers tell them from monitors, and what their columns are.

use std::borrow::Cow;

use indexmap::IndexMap;
use tremolite_results::{Peaks, Summary, Table};

/// Monitors, or pairs, that have columns, in the table's order.
pub fn names(table: &Table) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for (name, _) in table.columns.iter().filter_map(|column| column.name.rsplit_once('.')) {
        if !names.iter().any(|known| known == name) {
            names.push(name.into());
        }
    }
    names
}

/// The two names that `pair` joins with a hyphen; names may hold hyphens themselves.
fn halves<'a>(pair: &'a str, names: &[String]) -> Option<(&'a str, &'a str)> {
    let known = |half: &str| names.iter().any(|name| name == half);
    pair.match_indices('-')
        .map(|(i, _)| (&pair[..i], &pair[i + 1..]))
        .find(|(first, second)| known(first) && known(second))
}

/// Whether a name in the headers is that of a pair of two other names.
pub fn is_pair(name: &str, names: &[String]) -> bool {
    halves(name, names).is_some()
}

/// A pair with the peaks of its quantities.
pub type PairPeaks<'a> = (&'a str, &'a IndexMap<String, Peaks>);

/// The pairs of a run of which no monitor came loose, and the names of the others. What a loose piece does is no strain of the
/// lining.
pub fn held(facts: &Summary) -> (Vec<PairPeaks<'_>>, Vec<&str>) {
    let names: Vec<String> = facts.monitors.keys().cloned().collect();
    let is_loose = |monitor: &str| facts.monitors_on_broken_elements.iter().any(|name| name == monitor);
    let (mut held, mut loose) = (Vec::new(), Vec::new());
    for (pair, peaks) in &facts.relative {
        match halves(pair, &names) {
            Some((first, second)) if is_loose(first) || is_loose(second) => loose.push(pair.as_str()),
            _ => held.push((pair.as_str(), peaks)),
        }
    }
    (held, loose)
}

/// The column of a pair or, without one, the difference of its monitors' columns.
pub fn difference<'a>(
    table: &'a Table,
    monitors: &[String],
    pair: &str,
    quantity: &str,
) -> Option<Cow<'a, [f64]>> {
    if let Some(column) = table.column(&format!("{pair}.{quantity}")) {
        return Some(column.into());
    }
    let (first, second) = halves(pair, monitors)?;
    let first = table.column(&format!("{first}.{quantity}"))?;
    let second = table.column(&format!("{second}.{quantity}"))?;
    Some(first.iter().zip(second).map(|(a, b)| a - b).collect::<Vec<_>>().into())
}

/// Histories of one quantity, each less the mean in every row of those of which `counts` is true by name.
pub fn from_mean<'a>(
    histories: Vec<(String, Cow<'a, [f64]>)>,
    counts: impl Fn(&str) -> bool,
) -> Vec<(String, Cow<'a, [f64]>)> {
    let of_mean: Vec<&[f64]> =
        histories.iter().filter(|(name, _)| counts(name)).map(|(_, values)| values.as_ref()).collect();
    let rows = histories.iter().map(|(_, values)| values.len()).min().unwrap_or(0);
    let mean =
        |row: usize| of_mean.iter().map(|values| values[row]).sum::<f64>() / of_mean.len().max(1) as f64;
    let mean: Vec<f64> = (0..rows).map(mean).collect();
    let less = |values: Cow<'a, [f64]>| values.iter().zip(&mean).map(|(x, m)| x - m).collect::<Vec<_>>();
    histories.into_iter().map(|(name, values)| (name, less(values).into())).collect()
}

#[cfg(test)]
mod tests {
    use super::from_mean;

    #[test]
    fn the_mean_is_of_those_that_count() {
        let histories = || ["A", "B", "C"].map(|n| (n.to_owned(), vec![1.0, 2.0].into())).to_vec();
        let mut strayed = histories();
        strayed[2].1 = vec![10.0, -40.0].into();
        let less = from_mean(strayed, |name| name != "C");
        assert_eq!(
            less.iter().map(|(_, v)| v.to_vec()).collect::<Vec<_>>(),
            [[0.0, 0.0], [0.0, 0.0], [9.0, -42.0]]
        );
        assert!(from_mean(histories(), |_| true).iter().all(|(_, v)| v[..] == [0.0, 0.0]));
    }
}
