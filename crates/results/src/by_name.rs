//! Whose columns are by their names alone, of tables without a file of columns, as older versions left them. The one place that
//! takes names apart: the last dot stands before the quantity, and a pair of monitors is what joins two names that the table has.

use crate::column::{Column, Subject};

/// What stands behind the name of a monitor where the free field at its level is meant.
const BESIDE: &str = ".free_field";

/// Completes the columns of `monitors`, `interfaces` and so on; those of other tables are nobody's.
pub(crate) fn complete(table: &str, columns: &mut [Column]) {
    let split = |column: &Column| {
        column.name.rsplit_once('.').map(|(name, quantity)| (name.to_owned(), quantity.to_owned()))
    };
    let all: Vec<(String, String)> = columns.iter().filter_map(split).collect();
    for column in columns {
        let Some((name, quantity)) = split(column) else { continue };
        let told = match table {
            "monitors" => (monitored(&name, &all), quantity),
            "interfaces" => (Subject::Interface(name), quantity),
            "damage" => (Subject::Group(name), quantity),
            "spectra" => spectrum(name, quantity),
            "free_field" => ground(name, quantity),
            _ => continue,
        };
        (column.subject, column.quantity) = told;
    }
}

/// What a name of monitors.csv is, among all names with their quantities.
fn monitored(name: &str, all: &[(String, String)]) -> Subject {
    if let Some(pair) = halves(name, |name| all.iter().any(|(other, _)| other == name)) {
        return Subject::Relative(pair.map(str::to_owned));
    }
    let has = |quantity: &&str| all.iter().any(|(other, q)| other == name && q == quantity);
    if ["gap", "pressure", "shear1"].iter().all(has) {
        Subject::Pair(name.into())
    } else if has(&"force_over_yield") {
        Subject::Bolt(name.into())
    } else {
        Subject::Monitor(name.into())
    }
}

/// The two known names that a pair's joins with a hyphen, of a pair that no table has.
pub fn halves(pair: &str, known: impl Fn(&str) -> bool) -> Option<[&str; 2]> {
    let joins = pair.match_indices('-').map(|(i, _)| [&pair[..i], &pair[i + 1..]]);
    joins.into_iter().find(|halves| halves.iter().all(|half| known(half)))
}

fn spectrum(name: String, quantity: String) -> (Subject, String) {
    match name.strip_suffix(BESIDE) {
        Some(monitor) => (Subject::Monitor(monitor.into()), format!("free_field.{quantity}")),
        None if ["given", "incident", "free_field.surface", "free_field.base", "free_field.equivalent"]
            .contains(&name.as_str()) =>
        {
            (Subject::None, format!("{name}.{quantity}"))
        }
        None => (Subject::Monitor(name), quantity),
    }
}

fn ground(name: String, quantity: String) -> (Subject, String) {
    if let Some(monitor) = name.strip_suffix(BESIDE) {
        return (Subject::Monitor(monitor.into()), format!("free_field.{quantity}"));
    }
    let Some((whose, place)) = name.rsplit_once('.') else {
        return (Subject::None, format!("{name}.{quantity}"));
    };
    let quantity = format!("{place}.{quantity}");
    match whose.strip_prefix("model.") {
        Some(edge) => (Subject::Edge(edge.into()), quantity),
        None if whose == "model" => (Subject::Model, quantity),
        None => (Subject::Column(whose.into()), quantity),
    }
}
