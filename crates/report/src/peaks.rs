//! Tables of peaks: of monitors and of pairs of them, and the largest stresses of groups.

use serde::Serialize;
use tremolite_results::Summary;

use crate::contact_monitors::QUANTITIES;
use crate::facts::{ByName, duration};
use crate::scale::{Scale, moment, quantity, trimmed};
use crate::source::Source;

/// Peaks of one family of quantities in one unit.
#[derive(Serialize)]
pub struct PeakTable {
    pub heading: &'static str,
    pub unit: String,
    pub rows: Vec<PeakRow>,
}

/// One history's peaks.
#[derive(Serialize)]
pub struct PeakRow {
    /// Empty where it is that of the row above.
    pub monitor: String,
    pub quantity: String,
    pub max: String,
    pub t_max: String,
    pub min: String,
    pub t_min: String,
    pub residual: String,
}

/// Time between the rows that peaks are taken from (s).
pub fn interval(source: &Source) -> Option<String> {
    let time = source.monitors.as_ref().ok()?.column("time")?;
    let [first, second, ..] = time else { return None };
    Some(trimmed(&quantity("s", second - first)))
}

/// Peaks of all monitors, and of pairs, by family.
pub fn peaks(source: &Source) -> Vec<PeakTable> {
    let (summary, duration) = (source.facts(), duration(source));
    let peak_table = |heading, unit, all, wanted| peak_table(heading, unit, all, wanted, duration);
    let tables = [
        peak_table("Displacement", "m", &summary.monitors, &["ux", "uy", "uz"][..]),
        peak_table("Relative displacement", "m", &summary.relative, &["ux", "uy", "uz"][..]),
        group_stress(&summary, duration),
        peak_table(
            "Principal stress of monitors, tension positive",
            "Pa",
            &summary.monitors,
            &["s1", "s3"][..],
        ),
        peak_table("Gap and slip of monitors on interfaces", "m", &summary.monitors, &QUANTITIES[..3]),
        peak_table(
            "Pressure, compression positive, and shear of monitors on interfaces",
            "Pa",
            &summary.monitors,
            &QUANTITIES[3..6],
        ),
        peak_table("Velocity", "m/s", &summary.monitors, &["vx", "vy", "vz"][..]),
        peak_table("Acceleration", "m/s2", &summary.monitors, &["ax", "ay", "az"][..]),
    ];
    tables.into_iter().filter(|table| !table.rows.is_empty()).collect()
}

/// The largest stresses of each group.
fn group_stress(summary: &Summary, duration: f64) -> PeakTable {
    let all = || summary.stress.values().flat_map(|s| [s.s1.value.abs(), s.s3.value.abs()]);
    let scale = Scale::suiting("Pa", all().filter(|x| x.is_finite()).fold(0.0, f64::max));
    let rows = summary.stress.iter().flat_map(|(group, stress)| {
        let row = |monitor: &str, quantity: &str| PeakRow {
            monitor: monitor.to_owned(),
            quantity: quantity.to_owned(),
            max: String::new(),
            t_max: String::new(),
            min: String::new(),
            t_min: String::new(),
            residual: String::new(),
        };
        let s1 = PeakRow {
            max: scale.number(stress.s1.value),
            t_max: moment(stress.s1.time, duration),
            ..row(group, "s1")
        };
        let s3 = PeakRow {
            min: scale.number(stress.s3.value),
            t_min: moment(stress.s3.time, duration),
            ..row("", "s3")
        };
        [s1, s3]
    });
    let heading = "Principal stress of groups, tension positive; of 2×2×2 elements at the fibre while intact, else at points";
    let rows: Vec<PeakRow> = rows.collect();
    PeakTable { heading, unit: scale.unit, rows }
}

fn peak_table(heading: &'static str, unit: &str, all: &ByName, wanted: &[&str], duration: f64) -> PeakTable {
    let sizes =
        all.values().flat_map(|by_quantity| by_quantity.iter()).filter(|(q, _)| wanted.contains(&q.as_str()));
    let most = sizes.map(|(_, p)| p.largest().1.abs()).filter(|x| x.is_finite()).fold(0.0, f64::max);
    let scale = Scale::suiting(unit, most);
    // Round-off of a component that does not move would be the longest numbers of the table.
    let idle = |x: f64| x.abs() < 1e-6 * most;
    let number = |x: f64| if idle(x) { "0".into() } else { scale.number(x) };
    let time = |t: f64, x: f64| if idle(x) { String::new() } else { moment(t, duration) };
    let mut rows = Vec::new();
    for (monitor, by_quantity) in all {
        let mut name = monitor.clone();
        for (quantity, p) in by_quantity.iter().filter(|(q, _)| wanted.contains(&q.as_str())) {
            rows.push(PeakRow {
                monitor: std::mem::take(&mut name),
                quantity: quantity.clone(),
                max: number(p.max),
                t_max: time(p.t_max, p.max),
                min: number(p.min),
                t_min: time(p.t_min, p.min),
                residual: number(p.residual),
            });
        }
    }
    PeakTable { heading, unit: scale.unit, rows }
}
