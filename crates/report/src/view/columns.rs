//! The arrays of a part over the files, as f32 until their ranges are known.
//!
//! Quantisation needs the range over all times. Files are so read once and their scalars kept, 4 bytes a value, rather than
//! read a second time: unpacking a file takes longer than all else. A column that equals the one before it shares
//! its memory; what stays zero costs nothing.

use std::rc::Rc;

/// An array of the files with one number a cell or point.
pub struct PartColumn {
    pub name: String,
    pub unit: String,
    pub at_cells: bool,
    /// By time, by the part's cell or point; shorter than the part where cells came later. NaN where nothing stands.
    pub times: Vec<Option<Rc<[f32]>>>,
}

impl PartColumn {
    /// The values at a time, where there are any.
    pub fn at(&self, time: usize) -> Option<&[f32]> {
        self.times.get(time)?.as_deref()
    }

    /// Least and largest value over all times; none without values.
    pub fn range(&self) -> Option<(f32, f32)> {
        let mut range: Option<(f32, f32)> = None;
        let mut before: Option<&Rc<[f32]>> = None;
        for values in self.times.iter().flatten() {
            if before.is_some_and(|b| Rc::ptr_eq(b, values)) {
                continue;
            }
            before = Some(values);
            for &v in values.iter().filter(|v| v.is_finite()) {
                let (low, high) = range.unwrap_or((v, v));
                range = Some((low.min(v), high.max(v)));
            }
        }
        range
    }
}

/// All columns of a part, in the order of the files.
#[derive(Default)]
pub struct Columns(pub Vec<PartColumn>);

impl Columns {
    /// Adds the values of an array at time number `time`.
    pub fn add(&mut self, time: usize, name: &str, unit: &str, at_cells: bool, values: Vec<f32>) {
        let known = self.0.iter().position(|c| c.name == name && c.at_cells == at_cells);
        let place = known.unwrap_or_else(|| {
            self.0.push(PartColumn { name: name.into(), unit: unit.into(), at_cells, times: Vec::new() });
            self.0.len() - 1
        });
        let column = &mut self.0[place];
        column.times.resize(time, None);
        let before = column.times.last().into_iter().flatten().next();
        let same = |b: &&Rc<[f32]>| {
            b.len() == values.len() && b.iter().zip(&values).all(|(a, b)| a.to_bits() == b.to_bits())
        };
        let shared = before.filter(same).cloned();
        column.times.push(Some(shared.unwrap_or_else(|| values.into())));
    }
}
