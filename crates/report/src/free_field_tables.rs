//! Tables of the free field: columns beside theory, and the model at its corners beside columns.

use tremolite_results::{FreeField, Station};

use crate::free_field_beside::{Drawn, alike, corners};
use crate::free_field_numbers::{AXES, PLACES, from_column, from_theory, largest, percent};
use crate::scale::Scale;
use crate::text_table::{Cell, Head, TextTable};

fn peak(values: &[f64], scale: &Scale) -> Cell {
    Cell::number(scale.number(largest(values)))
}

fn share(share: Option<f64>) -> Cell {
    Cell::number(share.map_or("–".into(), |s| percent(s).replace("\u{a0}%", "")))
}

/// Headings: words, then two numbers and how far they are apart at each place.
fn head(words: &[&str], numbers: [&str; 2], apart: &str, scale: &Scale) -> Vec<Vec<Head>> {
    let mut over = vec![Head::words("").over(words.len())];
    over.extend(PLACES.map(|place| Head::number(place).over(3)));
    let mut head: Vec<Head> = words.iter().map(|word| Head::words(*word)).collect();
    for _ in PLACES {
        head.extend(numbers.map(|what| Head::number(scale.labelled(what))));
        head.push(Head::number(apart));
    }
    vec![over, head]
}

/// Whether a station has values along an axis.
fn has(station: &Station, axis: usize) -> bool {
    station.places().iter().any(|of| !of.measured[axis].is_empty() || !of.theory[axis].is_empty())
}

/// Peaks of all columns that differ, beside theory.
pub fn of_columns(found: &FreeField, moving: &[usize], scale: &Scale) -> TextTable {
    let mut rows = Vec::new();
    for group in alike(&found.columns) {
        let column = group[0];
        let mut name = Cell::words(column.name.as_str());
        if group.len() > 1 {
            name = name.with(format!("all {} of the same values", group.len()));
        }
        for &axis in moving.iter().filter(|&&axis| has(column, axis)) {
            let mut row = vec![std::mem::take(&mut name), Cell::words(AXES[axis])];
            for (k, of) in column.places().into_iter().enumerate() {
                row.extend([peak(&of.measured[axis], scale), peak(&of.theory[axis], scale)]);
                row.push(share(from_theory(column, k, axis)));
            }
            rows.push(row);
        }
    }
    TextTable {
        head: head(&["column", "along"], ["peak", "theory"], "differs by (% of theory's peak)", scale),
        rows,
    }
}

/// Peaks of the model at its corners beside those of the columns that stand for them; of its mean beside the column that is drawn.
pub fn of_corners(found: &FreeField, drawn: &Drawn, moving: &[usize], scale: &Scale) -> TextTable {
    let mut rows = Vec::new();
    for beside in corners(found) {
        let column = beside.column.or(drawn.column.filter(|_| found.corners.is_empty()));
        let mut words = [
            Cell::words(beside.place.trim_start_matches("corner ")),
            Cell::words(column.map_or("–", |column| column.name.as_str())),
        ];
        for &axis in moving.iter().filter(|&&axis| has(beside.model, axis)) {
            let mut row = words.each_mut().map(std::mem::take).to_vec();
            row.push(Cell::words(AXES[axis]));
            for (k, of) in beside.model.places().into_iter().enumerate() {
                let own = column.map_or(&[][..], |column| &column.places()[k].measured[axis]);
                row.extend([peak(&of.measured[axis], scale), peak(own, scale)]);
                row.push(share(column.and_then(|column| from_column(beside.model, column, k, axis))));
            }
            rows.push(row);
        }
    }
    let apart = "differs by (% of the column's peak)";
    TextTable { head: head(&["model at", "column", "along"], ["model", "column"], apart, scale), rows }
}
