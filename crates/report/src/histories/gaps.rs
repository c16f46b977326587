//! Values of monitors that are no number where there should be one: a run that went wrong, or a damaged file.

use tremolite_results::{Column, Subject};

use crate::language::say;
use crate::quantities::scale::moment;
use crate::source::Source;

/// A sentence that names the file, the first such time and a column; nothing where all is well. A history without any number
/// is that of what does not stand; monitors on interfaces and bolts may begin and end.
pub fn told(source: &Source) -> Option<String> {
    let table = source.monitors.as_ref().ok()?;
    let times = table.column("time")?;
    let should = |column: &Column| matches!(column.subject, Subject::Monitor(_) | Subject::Relative(_));
    let gap = |values: &Vec<f64>| {
        let row = values.iter().position(|x| !x.is_finite())?;
        values.iter().any(|x| x.is_finite()).then_some(row)
    };
    let columns = table.columns.iter().zip(&table.values).filter(|(column, _)| should(column));
    let gaps = columns.filter_map(|(column, values)| Some((gap(values)?, &column.name)));
    let (row, name) = gaps.min_by_key(|(row, _)| *row)?;
    Some(say!(
        source.language,
        "{file} has values that are no number, first at {time}\u{a0}s ({column}): the run went wrong there, or the file is \
         damaged. Figures and peaks leave them out.",
        file = "monitors.csv",
        time = moment(times[row], source.duration()),
        column = name
    ))
}
