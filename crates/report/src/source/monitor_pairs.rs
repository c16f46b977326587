//! Pairs of monitors, and whose columns a table has.

use std::borrow::Cow;

use indexmap::IndexSet;
use tremolite_results::limits::{PairPeaks, held_pairs, monitors_of};
use tremolite_results::{Subject, Summary, Table};

use crate::source::Source;

/// Names of those of which `wanted` is true that have columns, in the table's order.
pub fn names(table: &Table, wanted: impl Fn(&Subject) -> bool) -> Vec<String> {
    let subjects = table.columns.iter().map(|column| &column.subject);
    let names: IndexSet<String> =
        subjects.filter(|subject| wanted(subject)).filter_map(Subject::name).collect();
    names.into_iter().collect()
}

pub fn is_pair(subject: &Subject) -> bool {
    matches!(subject, Subject::Relative(_))
}

/// The pairs of a run of which no monitor is on a broken element, and the names of the others: nothing holds such an element.
pub fn held<'a>(source: &Source, facts: &'a Summary) -> (Vec<PairPeaks<'a>>, Vec<&'a str>) {
    held_pairs(source.monitors.as_ref().ok(), facts)
}

/// The column of a pair or, in files of older versions that have none, the difference of its monitors'.
pub fn difference<'a>(
    table: &'a Table,
    facts: &Summary,
    pair: &str,
    quantity: &str,
) -> Option<Cow<'a, [f64]>> {
    if let Some(column) = table.column(&format!("{pair}.{quantity}")) {
        return Some(column.into());
    }
    let [first, second] = monitors_of(Some(table), facts, pair)?;
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
