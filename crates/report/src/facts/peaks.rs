//! Tables of peaks: of monitors and of pairs of them, and the largest stresses of groups.

use indexmap::IndexMap;
use serde::Serialize;
use tremolite_results::{Peaks, Summary};

use crate::facts::ByName;
use crate::interfaces::monitors::QUANTITIES;
use crate::language::say;
use crate::quantities::scale::{figures, moment, trimmed};
use crate::quantities::units::Kind;
use crate::source::Source;

/// Monitors, or pairs of them, in a table, at most; of more nobody reads each.
const MOST: usize = 84;

/// Peaks of one family of quantities in one unit.
#[derive(Serialize)]
pub struct PeakTable {
    pub heading: String,
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
    /// The largest of all steps, where it was followed through every one.
    pub step_max: String,
    pub min: String,
    pub t_min: String,
    pub step_min: String,
    pub residual: String,
}

/// Time between the rows that peaks are taken from (s).
pub fn interval(source: &Source) -> Option<String> {
    let time = source.monitors.as_ref().ok()?.column("time")?;
    let [first, second, ..] = time else { return None };
    Some(format!("{}\u{a0}s", trimmed(&figures(second - first, 3))))
}

/// Peaks of all monitors, and of pairs, by family.
pub fn peaks(source: &Source) -> Vec<PeakTable> {
    let (summary, language) = (source.facts(), source.language);
    let table = |heading, kind, all, wanted| peak_table(source, heading, kind, all, wanted);
    let (monitors, components) = (&summary.monitors.peaks, &["ux", "uy", "uz"][..]);
    let tables = [
        table(say!(language, "Displacement"), Kind::Displacement, monitors, components),
        table(
            say!(language, "Relative displacement"),
            Kind::Displacement,
            &summary.monitors.relative,
            components,
        ),
        group_stress(source, &summary),
        table(
            say!(language, "Principal stress of monitors, tension positive"),
            Kind::Stress,
            monitors,
            &["s1", "s3", "s1_elastic"][..],
        ),
        table(
            say!(language, "Gap and slip of monitors on interfaces"),
            Kind::Opening,
            monitors,
            &QUANTITIES[..3],
        ),
        table(
            say!(language, "Pressure, compression positive, and shear of monitors on interfaces"),
            Kind::Stress,
            monitors,
            &QUANTITIES[3..6],
        ),
        table(say!(language, "Velocity"), Kind::Velocity, monitors, &["vx", "vy", "vz"][..]),
        table(say!(language, "Acceleration"), Kind::Acceleration, monitors, &["ax", "ay", "az"][..]),
    ];
    tables.into_iter().filter(|table| !table.rows.is_empty()).collect()
}

/// The largest stresses of each group.
fn group_stress(source: &Source, summary: &Summary) -> PeakTable {
    let (scale, duration) = (source.scale(Kind::Stress), source.duration());
    let rows = summary.parts.stress.iter().flat_map(|(group, stress)| {
        let row = |monitor: &str, quantity: &str| PeakRow {
            monitor: monitor.to_owned(),
            quantity: quantity.to_owned(),
            max: String::new(),
            t_max: String::new(),
            step_max: String::new(),
            min: String::new(),
            t_min: String::new(),
            step_min: String::new(),
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
    let heading = say!(
        source.language,
        "Principal stress of groups, tension positive; at the fibre of intact elements with several points, otherwise at points"
    );
    let rows: Vec<PeakRow> = rows.collect();
    PeakTable { heading, unit: scale.unit, rows }
}

fn peak_table(source: &Source, heading: String, kind: Kind, all: &ByName, wanted: &[&str]) -> PeakTable {
    let (scale, duration) = (source.scale(kind), source.duration());
    let sizes =
        all.values().flat_map(|by_quantity| by_quantity.iter()).filter(|(q, _)| wanted.contains(&q.as_str()));
    let most = sizes.map(|(_, p)| p.largest().1.abs()).filter(|x| x.is_finite()).fold(0.0, f64::max);
    // Round-off of a component that does not move would be the longest numbers of the table.
    let idle = |x: f64| x.abs() < 1e-6 * most;
    let number = |x: f64| if idle(x) { "0".into() } else { scale.number(x) };
    let time = |t: f64, x: f64| if idle(x) { String::new() } else { moment(t, duration) };
    let of_monitor = |by_quantity: &IndexMap<String, Peaks>| {
        let own = by_quantity.iter().filter(|(q, _)| wanted.contains(&q.as_str()));
        own.map(|(_, p)| p.largest().1.abs()).map(|x| if x.is_finite() { x } else { 0.0 }).reduce(f64::max)
    };
    let mut listed: Vec<(usize, f64)> =
        all.values().enumerate().filter_map(|(k, peaks)| Some((k, of_monitor(peaks)?))).collect();
    let having = listed.len();
    listed.sort_by(|a, b| b.1.total_cmp(&a.1));
    listed.truncate(MOST);
    listed.sort_by_key(|(k, _)| *k);
    let heading = match having > MOST {
        true => say!(
            source.language,
            "{heading}: the {most} of {all} that reach most",
            heading = heading,
            most = MOST,
            all = having
        ),
        false => heading,
    };
    let mut rows = Vec::new();
    for (monitor, by_quantity) in listed.iter().filter_map(|(k, _)| all.get_index(*k)) {
        let mut name = monitor.clone();
        for (quantity, p) in by_quantity.iter().filter(|(q, _)| wanted.contains(&q.as_str())) {
            rows.push(PeakRow {
                monitor: std::mem::take(&mut name),
                quantity: quantity.clone(),
                max: number(p.max),
                t_max: time(p.t_max, p.max),
                step_max: p.step_max.map_or(String::new(), number),
                min: number(p.min),
                t_min: time(p.t_min, p.min),
                step_min: p.step_min.map_or(String::new(), number),
                residual: number(p.residual),
            });
        }
    }
    PeakTable { heading, unit: scale.unit, rows }
}
