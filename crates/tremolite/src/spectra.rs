//! spectra.csv: response spectra of the motion, of the free field and of the monitors, from the histories that the run wrote.
//!
//! Pseudo-acceleration at 5 % of critical damping, at the periods of `tremolite motion spectrum`. Of the motion: of the
//! accelerations in motion.csv. Of everything else: of the acceleration between rows of the histories, the velocity of a row less
//! that of the last over the time between, as in monitors.csv; so what rings above the rows' Nyquist frequency is not in it, and
//! a monitor's curve and the free field's beside it mean the same. A mean over a row, joined linearly to the next, takes
//! sinc³ of an amplitude, and oscillators are looked at in the rows: steady motion at twenty rows a period comes out 1 to 2.5 %
//! low, at ten 5 to 9 %, at five 20 %. Below five there is no number. Nothing but what came while the histories last is in any of them,
//! so the motion of a run that was stopped counts as far as the run came.

use crate::error::RunError;
use crate::plan::Plan;
use std::collections::HashSet;
use tremolite_motion::{default_periods, pseudo_acceleration};
use tremolite_results::{Column, ResultFolder, Subject, Table, TableWriter};

/// Share of critical damping.
pub const DAMPING: f64 = 0.05;
/// Rows of the histories a period below which their spectra say too little.
const ROWS_A_PERIOD: f64 = 5.0;
const AXES: [&str; 3] = ["x", "y", "z"];

/// A point at which there are spectra: whose, and what stands before its acceleration.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    subject: Subject,
    place: &'static str,
}

const GIVEN: &str = "given.";
const INCIDENT: &str = "incident.";
const SURFACE: &str = "free_field.surface.";
const BASE: &str = "free_field.base.";
/// The surface of the equivalent-linear column beside ground that yields.
const EQUIVALENT: &str = "free_field.equivalent.";
/// The free field at the level of a monitor.
const BESIDE: &str = "free_field.";

impl Point {
    fn column(&self, axis: &str) -> Column {
        Column::of(self.subject.clone(), format!("{}a{axis}", self.place), "m/s2")
    }
}

/// The points, in the order of the file, each with three columns, or as many as its history has.
pub fn points(plan: &Plan, free_field: bool) -> Vec<Point> {
    let of_ground =
        if free_field { &[GIVEN, INCIDENT, SURFACE, BASE, EQUIVALENT][..] } else { &[GIVEN, INCIDENT] };
    let nobodys = |place: &&'static str| Point { subject: Subject::None, place };
    let mut points: Vec<Point> = of_ground.iter().map(nobodys).collect();
    // A file has no two columns of one name, and monitors are many.
    let mut taken: HashSet<String> = points.iter().map(|point| point.column("x").name).collect();
    for monitor in &plan.monitors {
        let of = |place| Point { subject: Subject::Monitor(monitor.name.clone()), place };
        let beside = free_field.then(|| of(BESIDE));
        points.extend(Some(of("")).filter(|own| taken.insert(own.column("x").name)));
        taken.extend(beside.iter().map(|point| point.column("x").name));
        points.extend(beside);
    }
    points
}

/// A history with its step \[s\].
struct History {
    dt: f64,
    acceleration: Vec<f64>,
    /// The period \[s\] below which it says too little.
    shortest: f64,
}

impl History {
    fn spectrum(&self, periods: &[f64]) -> Vec<f64> {
        let none = || vec![f64::NAN; periods.len()];
        if self.acceleration.len() < 2 || !self.acceleration.iter().all(|a| a.is_finite()) {
            return none();
        }
        // Refused only for periods that are none.
        let mut spectrum =
            pseudo_acceleration(&self.acceleration, self.dt, periods, DAMPING).unwrap_or_else(|_| none());
        for (s, _) in spectrum.iter_mut().zip(periods).filter(|(_, period)| **period < self.shortest) {
            *s = f64::NAN;
        }
        spectrum
    }
}

/// How many rows are equally far apart, from the first on, and how far \[s\]: a run may end between two rows.
fn even(time: &[f64]) -> (usize, f64) {
    let [first, second, ..] = time else { return (time.len(), f64::NAN) };
    let dt = second - first;
    let even = |pair: &&[f64]| (pair[1] - pair[0] - dt).abs() < 1e-6 * dt;
    (1 + time.windows(2).take_while(even).count(), dt)
}

/// A column of the motion, up to a time \[s\].
fn of_motion(table: &Table, name: &str, until: f64) -> Option<History> {
    let time = table.column("time")?;
    let (rows, dt) = even(time);
    let came = time.iter().take(rows).filter(|t| **t <= until + 1e-6 * dt).count();
    Some(History { dt, acceleration: table.column(name)?[..came].to_vec(), shortest: 0.0 })
}

/// A column of the histories that holds accelerations.
fn of_rows(table: &Table, name: &str) -> Option<History> {
    let (rows, dt) = even(table.column("time")?);
    let acceleration = table.column(name)?[..rows].to_vec();
    Some(History { dt, acceleration, shortest: ROWS_A_PERIOD * dt })
}

/// A column that holds velocities.
fn between_rows(table: &Table, name: &str) -> Option<History> {
    let (rows, dt) = even(table.column("time")?);
    let velocity = &table.column(name)?[..rows];
    let change = velocity.windows(2).map(|pair| (pair[1] - pair[0]) / dt);
    let acceleration = std::iter::once(0.0).chain(change).collect();
    Some(History { dt, acceleration, shortest: ROWS_A_PERIOD * dt })
}

/// Writes the file from what the run has written so far; `column` is the one that stands for the free field.
///
/// # Errors
/// If a file cannot be read or this one not be written.
pub(crate) fn write(folder: &ResultFolder, plan: &Plan, column: Option<&str>) -> Result<(), RunError> {
    let [motion, monitors, free_field] =
        [folder.motion(), folder.monitors(), folder.free_field()].map(|path| Table::read(&path));
    let (motion, monitors, free_field) = (motion?, monitors?, free_field?);
    let end = monitors.column("time").and_then(|time| time.last()).copied().unwrap_or(f64::INFINITY);
    let history = |point: &Point, axis: &str| match (&point.subject, point.place, column) {
        (_, GIVEN | INCIDENT, _) => of_motion(&motion, &point.column(axis).name, end),
        (_, SURFACE, Some(column)) => between_rows(&free_field, &format!("{column}.top.v{axis}")),
        (_, BASE, Some(column)) => between_rows(&free_field, &format!("{column}.base.v{axis}")),
        (_, EQUIVALENT, Some(column)) => {
            between_rows(&free_field, &format!("{column}.top.v{axis}_equivalent"))
        }
        (Subject::Monitor(name), BESIDE, _) => between_rows(&free_field, &format!("{name}.{BESIDE}v{axis}")),
        _ => of_rows(&monitors, &point.column(axis).name),
    };
    let periods = default_periods();
    let mut columns = vec![Column::new("period", "s")];
    let mut spectra = vec![periods.clone()];
    for point in points(plan, column.is_some()) {
        for axis in AXES {
            let Some(history) = history(&point, axis) else { continue };
            columns.push(point.column(axis));
            spectra.push(history.spectrum(&periods));
        }
    }
    let mut table = TableWriter::create(&folder.spectra(), &columns)?;
    let row = |k: usize| spectra.iter().map(move |of| of[k]);
    table.write(&(0..periods.len()).flat_map(row).collect::<Vec<f64>>())?;
    Ok(table.sync()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_that_comes_too_early_at_the_end_is_left_out() {
        assert_eq!(even(&[0.0, 0.1, 0.2, 0.3000000001]), (4, 0.1));
        assert_eq!(even(&[0.0, 0.1, 0.2, 0.25]), (3, 0.1));
        assert_eq!(even(&[1.0]).0, 1);
        let history = History { dt: 0.1, acceleration: vec![0.0, f64::NAN, 0.0], shortest: 0.0 };
        assert!(history.spectrum(&[0.1]).iter().all(|s| s.is_nan()), "no largest of what is not known");
        let history = History { dt: 0.1, acceleration: vec![0.0, 1.0, 0.0, 0.0], shortest: 0.5 };
        let spectrum = history.spectrum(&[0.4, 0.5, 1.0]);
        assert!(spectrum[0].is_nan() && spectrum[1] > 0.0 && spectrum[2] > 0.0);
    }

    #[test]
    fn the_motion_counts_as_far_as_the_run_came() {
        let columns = [Column::new("time", "s"), Column::new("given.ax", "m/s2")];
        let values = vec![(0..11).map(|k| 0.1 * f64::from(k)).collect(), vec![1.0; 11]];
        let table = Table::new(columns.to_vec(), values);
        let rows = |until| of_motion(&table, "given.ax", until).unwrap().acceleration.len();
        assert_eq!((rows(0.45), rows(0.5), rows(f64::INFINITY)), (5, 6, 11));
    }
}
