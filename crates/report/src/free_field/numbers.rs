//! The numbers behind the section of the free field: the wave at the times of the rows, and how far histories are apart.
//!
//! A difference is over the largest component of what it is measured by, at surface or base: the norm of the checks 'free field against one-dimensional theory' and 'motion at the model's corners against the free field', though of rows and not of steps.

use tremolite_results::{Station, Velocities};

use crate::language::{Language, say};
use crate::quantities::scale::figures;
use crate::source::Source;

pub const AXES: [&str; 3] = ["x", "y", "z"];
/// What the places of a station are called.
pub fn places(language: Language) -> [String; 2] {
    [say!(language, "surface"), say!(language, "base")]
}

/// By how much of their peak histories may differ and count as the same: round-off.
pub const SAME: f64 = 1e-9;

/// What was asked for (m/s): peaks of the motion given and of the incident wave, and the wave at the times of the rows.
#[derive(Default)]
pub struct Wave {
    pub given: [f64; 3],
    pub incident: [f64; 3],
    pub at_rows: [Vec<f64>; 3],
}

impl Wave {
    pub fn of(source: &Source, rows: &[f64]) -> Wave {
        let Some(Ok(table)) = &source.motion else { return Wave::default() };
        let time = table.column("time").unwrap_or(&[]);
        let velocity = |of: &str| AXES.map(|axis| table.column(&format!("{of}.v{axis}")).unwrap_or(&[]));
        let incident = velocity("incident");
        Wave {
            given: velocity("given").map(largest),
            incident: incident.map(largest),
            at_rows: incident.map(|values| interpolated(time, values, rows)),
        }
    }
}

/// A history at other times, linear between its own; not a number beyond them. Empty for an empty history.
pub fn interpolated(time: &[f64], values: &[f64], rows: &[f64]) -> Vec<f64> {
    let at = |&t: &f64| {
        let after = time.partition_point(|x| *x <= t);
        let (before, after) = (after.checked_sub(1)?, after.min(time.len() - 1));
        let step = time[after] - time[before];
        let part = if t == time[before] { 0.0 } else { (t - time[before]) / step };
        Some((1.0 - part) * values[before] + part * values[after])
    };
    if values.is_empty() { Vec::new() } else { rows.iter().map(|t| at(t).unwrap_or(f64::NAN)).collect() }
}

/// The largest finite size; not a number where there is none.
pub fn largest(values: &[f64]) -> f64 {
    values.iter().filter(|x| x.is_finite()).map(|x| x.abs()).reduce(f64::max).unwrap_or(f64::NAN)
}

/// The largest velocity of a station of those it had, or of those that theory has for it: any component, surface or base.
pub fn peak(station: &Station, of: fn(&Velocities) -> &[Vec<f64>; 3]) -> f64 {
    let histories = station.places().into_iter().flat_map(of);
    histories.map(|values| largest(values)).fold(f64::NAN, f64::max)
}

/// How far two histories are apart at most, over a peak; none where they have no row in common.
fn apart(a: &[f64], b: &[f64], peak: f64) -> Option<f64> {
    let both = a.iter().zip(b).filter(|(a, b)| a.is_finite() && b.is_finite());
    let most = both.map(|(a, b)| (a - b).abs()).reduce(f64::max)?;
    Some(if most == 0.0 { 0.0 } else { most / peak })
}

/// How far a column is from its theory at one of its places along an axis, over the peak of theory.
pub fn from_theory(column: &Station, place: usize, axis: usize) -> Option<f64> {
    let of = column.places()[place];
    apart(&of.measured[axis], &of.theory[axis], peak(column, |of| &of.theory))
}

/// How far a station of the model is from a column at a place along an axis, over the peak of the column.
pub fn from_column(model: &Station, column: &Station, place: usize, axis: usize) -> Option<f64> {
    let [model, own] = [model, column].map(|station| &station.places()[place].measured[axis]);
    apart(model, own, peak(column, |of| &of.measured))
}

/// A share in per cent; round-off is none.
pub fn percent(share: f64) -> String {
    format!("{}\u{a0}%", if share < SAME { "0".into() } else { figures(100.0 * share, 2) })
}
