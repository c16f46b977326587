//! What was seen of the free field, as the state remembers it.

use super::columns::watched;
use tremolite_engine::column::corner_name;
use tremolite_engine::model::Model;
use tremolite_engine::state::Memory;

/// Key of what the observer remembers: [`NUMBERS`] of each column.
const MEMORY: &str = "free field";
/// The numbers of a column.
const NUMBERS: usize = 9;

/// What was seen of the free field.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FreeFieldSeen {
    /// By the model's columns.
    pub columns: Vec<ColumnSeen>,
}

/// What was seen of one column \[m/s\].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ColumnSeen {
    pub name: String,
    /// Against theory, where there is some.
    pub theory: Option<Theory>,
    /// Whether it has yielded or cracked.
    pub damaged: bool,
    /// Largest difference of the model's own corners from it in any step, at its top and base.
    pub corners: [f64; 2],
    /// Its largest velocity, at top or base.
    pub peak: f64,
}

/// A column against theory \[m/s\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Theory {
    /// Largest difference in a row, at its top and base.
    pub difference: [f64; 2],
    /// Largest predicted velocity in the rows, and over the run.
    pub seen: f64,
    pub peak: f64,
}

impl Theory {
    /// Largest difference over the largest velocity.
    pub fn error(&self) -> f64 {
        most(self.difference[0], self.difference[1]) / self.peak
    }
}

/// The larger of two, and what is no number if either is.
pub fn most(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

impl FreeFieldSeen {
    /// What the state remembers of a model's columns.
    pub fn of(model: &Model, memory: &Memory) -> Option<Self> {
        let names = watched(model).into_iter().map(|column| column.name);
        Self::named(memory, names)
    }

    /// What the state remembers of a given free field at the four corners of the model.
    pub fn at_corners(memory: &Memory) -> Option<Self> {
        Self::named(memory, (0..4).map(corner_name))
    }

    /// What the state remembers of columns of these names.
    pub(super) fn named(memory: &Memory, names: impl IntoIterator<Item = String>) -> Option<Self> {
        let numbers = memory.get(MEMORY)?;
        let columns = names.into_iter().zip(numbers.chunks(NUMBERS)).map(|(name, numbers)| {
            let &[known, top, base, seen, most, damaged, surface, below, peak] = numbers else {
                return ColumnSeen { name, ..ColumnSeen::default() };
            };
            let theory = Theory { difference: [top, base], seen, peak: most };
            ColumnSeen {
                name,
                theory: (known > 0.0).then_some(theory),
                damaged: damaged > 0.0,
                corners: [surface, below],
                peak,
            }
        });
        Some(FreeFieldSeen { columns: columns.collect() })
    }

    pub(super) fn keep(&self, memory: &mut Memory) {
        let mut kept = Vec::new();
        for column in &self.columns {
            let flag = |set: bool| f64::from(u8::from(set));
            let Theory { difference: [top, base], seen, peak } = column.theory.unwrap_or_default();
            kept.extend([flag(column.theory.is_some()), top, base, seen, peak, flag(column.damaged)]);
            kept.extend(column.corners);
            kept.push(column.peak);
        }
        memory.insert(MEMORY.into(), kept);
    }

    /// The last three numbers of a column as they are kept, to follow every step: corners at top and base, peak.
    pub(super) fn every_step(memory: &mut Memory) -> impl Iterator<Item = &mut [f64; 3]> {
        let kept = memory.get_mut(MEMORY).map_or(&mut [][..], Vec::as_mut_slice);
        kept.chunks_mut(NUMBERS).filter_map(<[f64]>::last_chunk_mut)
    }
}
