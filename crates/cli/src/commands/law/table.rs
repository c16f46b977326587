//! The answer as a table: time, strain, stress, and the law's history by its names.

use super::path_file::{STRAIN, STRESS};
use tremolite_laws::path::Response;
use tremolite_results::Column;
use tremolite_results::number::push;

/// Comma-separated, under headers `name [unit]`.
pub fn text(time: &[f64], response: &Response) -> String {
    let history =
        response.columns.iter().map(|c| Column::new(c.name, if c.unit == "1" { "" } else { c.unit }));
    let columns = std::iter::once(Column::new("time", "s"))
        .chain(STRAIN.map(|name| Column::new(name, "")))
        .chain(STRESS.map(|name| Column::new(name, "Pa")))
        .chain(history);
    let mut text = columns.map(|c| c.header()).collect::<Vec<_>>().join(",");
    text.push('\n');
    for (row, t) in time.iter().enumerate() {
        push(&mut text, plain(*t));
        let values = response.strain[row].iter().chain(&response.stress[row]);
        for value in values.chain(response.history.iter().map(|column| &column[row])) {
            text.push(',');
            push(&mut text, plain(*value));
        }
        text.push('\n');
    }
    text
}

/// A number without the sign of a zero.
fn plain(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x }
}
