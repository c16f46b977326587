//! The model beside the columns that stand for its corners, and which of them are drawn.

use tremolite_results::{FreeField, Station};

use crate::free_field::numbers::{SAME, from_column, from_theory, largest, peak};
use crate::language::{Language, say};

/// The model at one of its corners, or its mean over them, beside a column.
#[derive(Clone)]
pub struct Beside<'a> {
    pub model: &'a Station,
    /// `corner xmin-ymin`.
    pub place: String,
    pub column: Option<&'a Station>,
}

/// Where something is farthest from what it should be.
#[derive(Clone, Copy)]
pub struct Farthest {
    /// Of the peak.
    pub share: f64,
    /// Of a station's places.
    pub place: usize,
    pub axis: usize,
}

/// What is drawn, and why that.
pub struct DrawnCorner<'a> {
    pub column: Option<&'a Station>,
    pub model: Option<Beside<'a>>,
    /// How far the model is from the column that is drawn.
    pub apart: Option<Farthest>,
    pub why: String,
}

/// The largest over all places and axes; of equal ones the first.
fn farthest(of: impl Fn(usize, usize) -> Option<f64>) -> Option<Farthest> {
    let all = (0..2).flat_map(|place| (0..3).map(move |axis| (place, axis)));
    let known = all.filter_map(|(place, axis)| Some(Farthest { share: of(place, axis)?, place, axis }));
    known.reduce(|a, b| if b.share > a.share { b } else { a })
}

/// The one of the largest share; of equal ones the first.
fn worst<T>(of: impl Iterator<Item = (T, Farthest)>) -> Option<(T, Farthest)> {
    of.reduce(|a, b| if b.1.share > a.1.share { b } else { a })
}

/// The column farthest from its theory.
pub fn farthest_from_theory(found: &FreeField) -> Option<(&Station, Farthest)> {
    let of = |column| Some((column, farthest(|place, axis| from_theory(column, place, axis))?));
    worst(found.columns.iter().filter_map(of))
}

/// Columns that moved alike and have the same theory, by the first of them.
pub fn alike(columns: &[Station]) -> Vec<Vec<&Station>> {
    let mut all: Vec<Vec<&Station>> = Vec::new();
    for column in columns {
        match all.iter_mut().find(|known| same(known[0], column)) {
            Some(known) => known.push(column),
            None => all.push(vec![column]),
        }
    }
    all
}

/// Whether two columns have the same values.
pub fn same(a: &Station, b: &Station) -> bool {
    let near = SAME * peak(a, |of| &of.measured);
    let near = if near.is_nan() { 0.0 } else { near };
    let equal = |a: &f64, b: &f64| (a - b).abs() <= near || a == b || (a.is_nan() && b.is_nan());
    histories(a)
        .zip(histories(b))
        .all(|(a, b)| a.len() == b.len() && a.iter().zip(b).all(|(a, b)| equal(a, b)))
}

/// All values of a station.
fn histories(of: &Station) -> impl Iterator<Item = &Vec<f64>> {
    of.places().into_iter().flat_map(|of| of.measured.iter().chain(&of.theory))
}

/// The model at each corner beside each column that stands for it, of columns that are the same one; in a file without corners
/// their mean beside no column.
pub fn corners(language: Language, found: &FreeField) -> Vec<Beside<'_>> {
    let mean = |model| Beside { model, place: say!(language, "mean of the four corners"), column: None };
    if found.corners.is_empty() {
        return found.model.iter().map(mean).collect();
    }
    let groups = alike(&found.columns);
    let mut all = Vec::new();
    for model in &found.corners {
        let of = |column| Beside { model, place: say!(language, "corner {name}", name = model.name), column };
        let serving = groups.iter().filter_map(|group| group.iter().find(|c| c.serves(&model.name)));
        let before = all.len();
        all.extend(serving.map(|column| of(Some(*column))));
        if all.len() == before {
            all.push(of(None));
        }
    }
    all
}

impl<'a> DrawnCorner<'a> {
    /// The corner of the model that is farthest from its column, and that column. Where there is no such pair, the column farthest
    /// from theory, without theory the one farthest from the model's mean, and beside it the mean or the corner that moves most.
    pub fn of(language: Language, found: &'a FreeField) -> DrawnCorner<'a> {
        let all = corners(language, found);
        let beside = |beside: Beside<'a>| {
            let column = beside.column?;
            let farthest = farthest(|place, axis| from_column(beside.model, column, place, axis))?;
            Some((beside, farthest))
        };
        let pairs: Vec<_> = all.iter().cloned().filter_map(beside).collect();
        let several = pairs.len() > 1;
        if let Some((model, apart)) = worst(pairs.into_iter()) {
            let column = model.column;
            let why = match column {
                Some(column) if several => say!(
                    language,
                    "Drawn is the corner of the model that is farthest from its column, {corner}, and that column, {column}.",
                    corner = model.model.name,
                    column = column.name
                ),
                _ => String::new(),
            };
            return DrawnCorner { column, model: Some(model), apart: Some(apart), why };
        }
        let size = |beside: &Beside| {
            let size = peak(beside.model, |of| &of.measured);
            if size.is_nan() { 0.0 } else { size }
        };
        // Of equal ones the first.
        let model = all.into_iter().reduce(|a, b| if size(&b) > size(&a) { b } else { a });
        let from_mean = || {
            let mean = model.as_ref().filter(|_| found.corners.is_empty())?.model;
            let of = |column| Some((column, farthest(|place, axis| from_column(mean, column, place, axis))?));
            worst(found.columns.iter().filter_map(of))
        };
        let of_theory = || {
            let (column, _) = farthest_from_theory(found)?;
            let why = say!(
                language,
                "Of the {number} columns the one farthest from theory is drawn, {column}.",
                number = found.columns.len(),
                column = column.name
            );
            Some((column, why))
        };
        let of_mean = || {
            let (column, _) = from_mean()?;
            let why = say!(
                language,
                "Of the {number} columns the one farthest from the model is drawn, {column}.",
                number = found.columns.len(),
                column = column.name
            );
            Some((column, why))
        };
        let first = || {
            let column = found.columns.first()?;
            let why = say!(language, "Of the columns the first is drawn, {column}.", column = column.name);
            Some((column, why))
        };
        let (column, why) = of_theory().or_else(of_mean).or_else(first).unzip();
        let why = why.filter(|_| found.columns.len() > 1).unwrap_or_default();
        let model = model.map(|beside| match found.corners.is_empty() {
            true => Beside { column, ..beside },
            false => beside,
        });
        DrawnCorner { column, model, apart: None, why }
    }

    /// The largest velocity of the model along an axis (m/s).
    pub fn largest(&self, axis: usize) -> f64 {
        let places = self.model.iter().flat_map(|beside| beside.model.places());
        places.map(|of| largest(&of.measured[axis])).fold(0.0, f64::max)
    }
}
