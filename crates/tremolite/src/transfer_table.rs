//! transfer.csv: how much of the incident wave moves the place where a motion was recorded, by frequency.

use crate::error::RunError;
use crate::plan::Recorded;
use tremolite_results::{Column, ResultFolder, TableWriter};

/// How far above the band of the record the table goes, as a part of it.
const ABOVE: f64 = 1.5;
/// Rows, at most.
const MOST: usize = 4000;

/// The frequencies of the rows \[Hz\].
fn frequencies(recorded: &Recorded) -> Vec<f64> {
    let most = (ABOVE * recorded.band).min(0.5 / recorded.motion.dt);
    let all = recorded.place.frequencies(0, most);
    let every = all.len().div_ceil(MOST);
    // The bottoms of dips may be sharp.
    let dips = (0..3).flat_map(|axis| recorded.place.shares(axis, most));
    let dips = dips.filter(|(.., bottom)| *bottom).map(|(hertz, ..)| hertz);
    let mut rows: Vec<f64> = all.into_iter().skip(every - 1).step_by(every).chain(dips).collect();
    rows.sort_by(f64::total_cmp);
    rows.dedup();
    rows
}

/// How many numbers the file holds.
pub fn numbers(recorded: &Recorded) -> usize {
    4 * frequencies(recorded).len()
}

/// Writes a row a frequency: the amplitude of the record over that of the incident wave, along the model's axes.
///
/// # Errors
/// If the file cannot be written.
pub fn write(folder: &ResultFolder, recorded: &Recorded) -> Result<(), RunError> {
    let mut columns = vec![Column::new("frequency", "Hz")];
    columns.extend(["x", "y", "z"].map(|axis| Column::new(axis, "1")));
    let mut table = TableWriter::create(&folder.transfer(), &columns)?;
    for hertz in frequencies(recorded) {
        let over = |axis: usize| recorded.place.transfer(axis, hertz).norm();
        table.write(&[hertz, over(0), over(1), over(2)])?;
    }
    Ok(table.sync()?)
}
