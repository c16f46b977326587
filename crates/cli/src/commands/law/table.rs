//! The answer as a table: time, motion, stress, and the law's history by its names.

use tremolite_results::Column;
use tremolite_results::number::push;

/// The header of a column of a law's history.
pub fn of_history(column: &tremolite_laws::Column) -> Column {
    Column::new(column.name, if column.unit == "1" { "" } else { column.unit })
}

/// Comma-separated, under headers `name [unit]`.
pub fn text(
    columns: impl Iterator<Item = Column>,
    rows: impl Iterator<Item = impl Iterator<Item = f64>>,
) -> String {
    let mut text = columns.map(|c| c.header()).collect::<Vec<_>>().join(",");
    text.push('\n');
    for row in rows {
        for (k, value) in row.enumerate() {
            if k > 0 {
                text.push(',');
            }
            push(&mut text, plain(value));
        }
        text.push('\n');
    }
    text
}

/// A number without the sign of a zero.
fn plain(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x }
}
