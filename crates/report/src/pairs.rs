//! Pairs of monitors: how the names in a table's headers tell them from monitors, and what their columns are.

use std::borrow::Cow;

use tremolite_results::Table;

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

/// Histories of one quantity, each less the mean of all in every row.
pub fn from_mean<'a>(histories: Vec<(String, Cow<'a, [f64]>)>) -> Vec<(String, Cow<'a, [f64]>)> {
    let rows = histories.iter().map(|(_, values)| values.len()).min().unwrap_or(0);
    let mean = |row: usize| {
        histories.iter().map(|(_, values)| values[row]).sum::<f64>() / histories.len().max(1) as f64
    };
    let mean: Vec<f64> = (0..rows).map(mean).collect();
    let less = |values: Cow<'a, [f64]>| values.iter().zip(&mean).map(|(x, m)| x - m).collect::<Vec<_>>();
    histories.into_iter().map(|(name, values)| (name, less(values).into())).collect()
}
