//! Largest and smallest values of histories.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use crate::{Subject, Table, number};

/// The extremes of one history and what remains at its end. Values in the history's SI unit, times in s.
///
/// A number that does not exist (no finite value in the history) is NaN, in JSON `null`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Peaks {
    /// Largest value, with its sign.
    #[serde(with = "number", default = "number::absent")]
    pub max: f64,
    /// Time of the largest value; the first, where several are equal.
    #[serde(with = "number", default = "number::absent")]
    pub t_max: f64,
    /// Smallest value, with its sign.
    #[serde(with = "number", default = "number::absent")]
    pub min: f64,
    /// Time of the smallest value; the first, where several are equal.
    #[serde(with = "number", default = "number::absent")]
    pub t_min: f64,
    /// Last value. For a displacement of an elastic model this is mostly the motion that is still under
    /// way; let the model come to rest before calling it permanent.
    #[serde(with = "number", default = "number::absent")]
    pub residual: f64,
    /// Largest and smallest value of all steps, of which the rows hold a few; for displacement, velocity and
    /// acceleration of monitors.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub step_max: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub step_min: Option<f64>,
}

impl Peaks {
    /// Peaks of a history. Values that are not finite are passed over.
    pub fn of(time: &[f64], values: &[f64]) -> Self {
        let nan = f64::NAN;
        let mut peaks = Peaks {
            max: nan,
            t_max: nan,
            min: nan,
            t_min: nan,
            residual: nan,
            step_max: None,
            step_min: None,
        };
        for (&t, &x) in time.iter().zip(values).filter(|(_, x)| x.is_finite()) {
            // Written so that the first finite value replaces the NaN.
            if peaks.max.is_nan() || x > peaks.max {
                (peaks.max, peaks.t_max) = (x, t);
            }
            if peaks.min.is_nan() || x < peaks.min {
                (peaks.min, peaks.t_min) = (x, t);
            }
            peaks.residual = x;
        }
        peaks
    }

    /// Time and value of the larger of the two extremes by size, with its sign.
    pub fn largest(&self) -> (f64, f64) {
        if self.max.abs() >= self.min.abs() || self.min.is_nan() {
            (self.t_max, self.max)
        } else {
            (self.t_min, self.min)
        }
    }
}

/// Quantity → peaks of what a table's columns belong to, by name, in the table's order.
pub type PeaksByName = IndexMap<String, IndexMap<String, Peaks>>;

/// Peaks of every column of the monitors, those on interfaces and bolts included, then of the pairs of monitors, in a table with
/// a column `time`. Empty without it.
pub fn peaks_by_monitor(table: &Table) -> [PeaksByName; 2] {
    let mut found = [PeaksByName::new(), PeaksByName::new()];
    let Some(time) = table.column("time") else { return found };
    for (column, values) in table.columns.iter().zip(&table.values) {
        let Some(name) = column.subject.name() else { continue };
        let of = usize::from(matches!(column.subject, Subject::Relative(_)));
        let peaks = Peaks::of(time, values);
        found[of].entry(name).or_default().insert(column.quantity.clone(), peaks);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_have_signs_and_first_times() {
        let peaks = Peaks::of(&[0.0, 1.0, 2.0, 3.0, 4.0], &[0.0, 2.0, -3.0, 2.0, 0.5]);
        assert_eq!(
            peaks,
            Peaks {
                max: 2.0,
                t_max: 1.0,
                min: -3.0,
                t_min: 2.0,
                residual: 0.5,
                step_max: None,
                step_min: None
            }
        );
        assert_eq!(peaks.largest(), (2.0, -3.0));
    }

    #[test]
    fn peaks_pass_over_what_is_not_finite() {
        let peaks = Peaks::of(&[0.0, 1.0, 2.0, 3.0], &[f64::NAN, 1.0, f64::INFINITY, f64::NAN]);
        assert_eq!(
            peaks,
            Peaks {
                max: 1.0,
                t_max: 1.0,
                min: 1.0,
                t_min: 1.0,
                residual: 1.0,
                step_max: None,
                step_min: None
            }
        );
        assert!(Peaks::of(&[], &[]).max.is_nan());
        assert!(Peaks::of(&[0.0], &[f64::NAN]).largest().1.is_nan());
    }
}
