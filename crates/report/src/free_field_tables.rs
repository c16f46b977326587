//! Tables of the free field: columns beside theory, and the model at its corners beside columns.

use tremolite_results::{FreeField, Station};

use crate::free_field_beside::{Drawn, alike, corners};
use crate::free_field_numbers::{self, AXES, PLACES, SAME, from_column, from_theory, largest, percent};
use crate::scale::Scale;
use crate::text_table::{Cell, Head, TextTable};

/// A peak beside the largest that counts; round-off is none.
fn peak(values: &[f64], most: f64, scale: &Scale) -> Cell {
    let size = largest(values);
    Cell::number(scale.number(if size < SAME * most { 0.0 } else { size }))
}

fn share(share: Option<f64>) -> Cell {
    Cell::number(share.map_or("–".into(), |s| percent(s).replace("\u{a0}%", "")))
}

/// Headings: whose and along which axis, then two numbers and how far they are apart at each place.
fn head(whose: &str, numbers: [&str; 2], scale: &Scale) -> Vec<Vec<Head>> {
    let mut over = vec![Head::words("").over(2)];
    over.extend(PLACES.map(|place| Head::number(place).over(3)));
    let mut head = [whose, "along"].map(Head::words).to_vec();
    for _ in PLACES {
        head.extend(numbers.map(|what| Head::number(scale.labelled(what))));
        head.push(Head::number("differs by (%)"));
    }
    vec![over, head]
}

/// Whether a station has values along an axis.
fn has(station: &Station, axis: usize) -> bool {
    station.places().iter().any(|of| !of.measured[axis].is_empty() || !of.theory[axis].is_empty())
}

fn largest_of(station: &Station) -> f64 {
    free_field_numbers::peak(station, |of| &of.measured)
}

/// Peaks of all columns that differ, beside theory.
pub fn of_columns(found: &FreeField, moving: &[usize], scale: &Scale) -> TextTable {
    let mut rows = Vec::new();
    for group in alike(&found.columns) {
        let column = group[0];
        let mut name = Cell::words(column.name.as_str());
        if group.len() > 1 {
            name = name.with(format!("{} columns of the same values", group.len()));
        }
        let most = largest_of(column);
        for &axis in moving.iter().filter(|&&axis| has(column, axis)) {
            let mut row = vec![std::mem::take(&mut name), Cell::words(AXES[axis])];
            for (k, of) in column.places().into_iter().enumerate() {
                row.extend([&of.measured, &of.theory].map(|of| peak(&of[axis], most, scale)));
                row.push(share(from_theory(column, k, axis)));
            }
            rows.push(row);
        }
    }
    TextTable { head: head("column", ["peak", "theory"], scale), rows }
}

/// Peaks of the model at its corners beside those of the columns that stand for them; of its mean beside the column that is drawn.
pub fn of_corners(found: &FreeField, drawn: &Drawn, moving: &[usize], scale: &Scale) -> TextTable {
    let mut rows = Vec::new();
    for beside in corners(found) {
        let column = beside.column.or(drawn.column.filter(|_| found.corners.is_empty()));
        let mut name = Cell::words(beside.place.trim_start_matches("corner "));
        if let Some(column) = column {
            name = name.with(format!("beside {}", column.name));
        }
        let most = column.map_or(f64::NAN, largest_of).max(largest_of(beside.model));
        for &axis in moving.iter().filter(|&&axis| has(beside.model, axis)) {
            let mut row = vec![std::mem::take(&mut name), Cell::words(AXES[axis])];
            for (k, of) in beside.model.places().into_iter().enumerate() {
                let own = column.map_or(&[][..], |column| &column.places()[k].measured[axis]);
                row.extend([&of.measured[axis], own].map(|values| peak(values, most, scale)));
                row.push(share(column.and_then(|column| from_column(beside.model, column, k, axis))));
            }
            rows.push(row);
        }
    }
    TextTable { head: head("model at", ["model", "column"], scale), rows }
}
