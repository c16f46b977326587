//! The numbers behind the section of the free field: the wave at the times of the rows, how far histories are apart, and which
//! column is drawn.

use tremolite_results::{FreeField, Station, Velocities};

use crate::scale::figures;
use crate::source::Source;

pub const AXES: [&str; 3] = ["x", "y", "z"];

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
fn interpolated(time: &[f64], values: &[f64], rows: &[f64]) -> Vec<f64> {
    let at = |&t: &f64| {
        let after = time.partition_point(|x| *x <= t);
        let (before, after) = (after.checked_sub(1)?, after.min(time.len() - 1));
        let step = time[after] - time[before];
        let part = if t == time[before] { 0.0 } else { (t - time[before]) / step };
        Some((1.0 - part) * values[before] + part * values[after])
    };
    if values.is_empty() { Vec::new() } else { rows.iter().map(|t| at(t).unwrap_or(f64::NAN)).collect() }
}

/// The column that is drawn, and why it is that one.
pub struct Drawn<'a> {
    pub column: Option<&'a Station>,
    pub why: String,
}

impl<'a> Drawn<'a> {
    /// The one farthest from theory; without theory the one farthest from the model.
    pub fn of(found: &'a FreeField, moving: &[usize]) -> Drawn<'a> {
        let model = found.model.as_ref();
        let farthest = |of: &dyn Fn(&Velocities, &Velocities, usize) -> Option<f64>| {
            let distance = |column: &'a Station| {
                let none = Velocities::default();
                let beside = model.map_or([&none; 2], Station::places);
                let places = column.places().into_iter().zip(beside);
                let each = places
                    .flat_map(|(own, model)| moving.iter().filter_map(move |&axis| of(own, model, axis)));
                Some((column, each.reduce(f64::max)?))
            };
            // Of equal ones the first.
            found.columns.iter().filter_map(distance).reduce(|a, b| if b.1 > a.1 { b } else { a })
        };
        let theory = farthest(&|own, _, axis| apart(&own.measured[axis], &own.theory[axis]));
        let beside = || farthest(&|own, model, axis| apart(&own.measured[axis], &model.measured[axis]));
        let (column, from) = match theory {
            Some((column, _)) => (Some(column), "theory"),
            None => match beside() {
                Some((column, _)) => (Some(column), "the model"),
                None => (found.columns.first(), ""),
            },
        };
        let why = match (column, found.columns.len(), from) {
            (Some(column), 2.., "") => format!("Of the columns the first is drawn, {}.", column.name),
            (Some(column), n @ 2.., from) => {
                format!("Of the {n} columns the one farthest from {from} is drawn, {}.", column.name)
            }
            _ => String::new(),
        };
        Drawn { column, why }
    }
}

/// The largest finite size; not a number where there is none.
pub fn largest(values: &[f64]) -> f64 {
    values.iter().filter(|x| x.is_finite()).map(|x| x.abs()).reduce(f64::max).unwrap_or(f64::NAN)
}

/// How far two histories are apart at most, over the larger of their peaks; none where they have no row in common.
pub fn apart(a: &[f64], b: &[f64]) -> Option<f64> {
    let both = a.iter().zip(b).filter(|(a, b)| a.is_finite() && b.is_finite());
    let most = both.map(|(a, b)| (a - b).abs()).reduce(f64::max)?;
    let peak = largest(a).max(largest(b));
    Some(if most == 0.0 { 0.0 } else { most / peak })
}

/// A share in per cent.
pub fn percent(share: f64) -> String {
    format!("{}\u{a0}%", if share == 0.0 { "0".into() } else { figures(100.0 * share, 2) })
}
