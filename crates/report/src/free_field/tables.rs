//! Tables of the free field: columns beside theory, and the model at its corners beside columns.

use tremolite_results::{FreeField, Station};

use crate::chapter::text_table::{Cell, Head, TextTable};
use crate::free_field::at_corners::{DrawnCorner, alike, corners};
use crate::free_field::numbers::{self, AXES, SAME, from_column, from_theory, largest, percent, places};
use crate::language::{Language, say};
use crate::quantities::scale::Scale;

/// A peak beside the largest that counts; round-off is none.
fn peak(values: &[f64], most: f64, scale: &Scale) -> Cell {
    let size = largest(values);
    Cell::number(scale.number(if size < SAME * most { 0.0 } else { size }))
}

fn share(share: Option<f64>) -> Cell {
    Cell::number(share.map_or("–".into(), |s| percent(s).replace("\u{a0}%", "")))
}

/// Headings: whose and along which axis, then two numbers and how far they are apart at each place.
fn head(language: Language, whose: String, numbers: [String; 2], scale: &Scale) -> Vec<Vec<Head>> {
    let mut over = vec![Head::words("").over(2)];
    over.extend(places(language).map(|place| Head::number(place).over(3)));
    let mut head = vec![Head::words(whose), Head::words(say!(language, "along"))];
    for _ in places(language) {
        head.extend(numbers.iter().map(|what| Head::number(scale.labelled(what))));
        head.push(Head::number(say!(language, "differs by (%)")));
    }
    vec![over, head]
}

/// Whether a station has values along an axis.
fn has(station: &Station, axis: usize) -> bool {
    station.places().iter().any(|of| !of.measured[axis].is_empty() || !of.theory[axis].is_empty())
}

fn largest_of(station: &Station) -> f64 {
    numbers::peak(station, |of| &of.measured)
}

/// Peaks of all columns that differ, beside theory.
pub fn of_columns(language: Language, found: &FreeField, moving: &[usize], scale: &Scale) -> TextTable {
    let mut rows = Vec::new();
    for group in alike(&found.columns) {
        let column = group[0];
        let mut name = Cell::words(column.name.as_str());
        if group.len() > 1 {
            name = name.with(say!(language, "{number} columns of the same values", number = group.len()));
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
    TextTable {
        head: head(
            language,
            say!(language, "column"),
            [say!(language, "peak"), say!(language, "theory")],
            scale,
        ),
        rows,
    }
}

/// Peaks of the model at its corners beside those of the columns that stand for them; of its mean beside the column that is drawn.
pub fn of_corners(
    language: Language,
    found: &FreeField,
    drawn: &DrawnCorner,
    moving: &[usize],
    scale: &Scale,
) -> TextTable {
    let mut rows = Vec::new();
    for beside in corners(language, found) {
        let column = beside.column.or(drawn.column.filter(|_| found.corners.is_empty()));
        let mut name = Cell::words(if found.corners.is_empty() { &beside.place } else { &beside.model.name });
        if let Some(column) = column {
            name = name.with(say!(language, "beside {column}", column = column.name));
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
    TextTable {
        head: head(
            language,
            say!(language, "model at"),
            [say!(language, "model"), say!(language, "column")],
            scale,
        ),
        rows,
    }
}
