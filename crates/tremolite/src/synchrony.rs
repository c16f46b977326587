//! How far the monitors move in step: of every two of them the correlation, and the shift in time at which they fit best.
//!
//! Of displacements, as the paper shows them. What hardly moves along a component has no course to compare, and what came loose
//! says nothing of the others: both are left out.

use indexmap::IndexMap;
use tremolite_results::{Synchrony, Table};

/// Components that are looked at.
const COMPONENTS: [&str; 3] = ["ux", "uy", "uz"];
/// A history whose size is this much smaller than the largest of all is left out.
const NEGLIGIBLE: f64 = 0.01;
/// Shifts that are tried, either way \[s\]: far more than a wave takes past a cavern.
const LONGEST: f64 = 0.5;
/// Rows below which there is no course to compare.
const FEWEST: usize = 50;

/// Component → how far the monitors move in step along it; without two that move nothing.
pub fn synchrony<'a>(
    histories: &Table,
    monitors: impl Iterator<Item = &'a str>,
) -> IndexMap<String, Synchrony> {
    let time = histories.column("time").unwrap_or(&[]);
    let (Some([first, second]), true) = (time.first_chunk(), time.len() >= FEWEST) else {
        return IndexMap::new();
    };
    let interval = second - first;
    let monitors: Vec<&str> = monitors.collect();
    let of = |component: &'static str| {
        monitors.iter().filter_map(move |name| {
            Some((component, *name, histories.column(&format!("{name}.{component}"))?))
        })
    };
    let all: Vec<(&str, &str, &[f64])> = COMPONENTS.into_iter().flat_map(of).collect();
    let size = |u: &[f64]| u.iter().fold(0.0, |most: f64, u| most.max(u.abs()));
    let most = all.iter().map(|(_, _, u)| size(u)).fold(0.0, f64::max);
    let mut found = IndexMap::new();
    for component in COMPONENTS {
        let moving: Vec<(&str, &[f64])> = all
            .iter()
            .filter(|(of, _, u)| *of == component && size(u) > NEGLIGIBLE * most)
            .map(|(_, name, u)| (*name, *u))
            .collect();
        if let Some(worst) = worst(&moving, interval) {
            found.insert(component.to_owned(), worst);
        }
    }
    found
}

/// Of all pairs the least correlation and the longest shift; none without a pair.
fn worst(histories: &[(&str, &[f64])], interval: f64) -> Option<Synchrony> {
    let shifts = (LONGEST / interval).round() as i64;
    let mut worst: Option<Synchrony> = None;
    for (k, (name, u)) in histories.iter().enumerate() {
        for (other, v) in &histories[..k] {
            let pair = || format!("{other}-{name}");
            let correlation = correlation(v, u, 0);
            let worst = worst.get_or_insert_with(|| Synchrony {
                correlation,
                least_of: pair(),
                lag: 0.0,
                latest_of: pair(),
            });
            if correlation < worst.correlation {
                (worst.correlation, worst.least_of) = (correlation, pair());
            }
            // Of two that do not fit within the shifts tried there is no lag; their correlation says so.
            let lag = lag(v, u, shifts.min(u.len() as i64 / 4)).map_or(f64::NAN, |rows| rows * interval);
            if lag.abs() > worst.lag.abs() {
                (worst.lag, worst.latest_of) = (lag, pair());
            }
        }
    }
    worst
}

/// Pearson's coefficient of two histories, the second looked at so many rows later, over the rows that both have.
fn correlation(u: &[f64], v: &[f64], rows: i64) -> f64 {
    let (from, later) = (rows.min(0).unsigned_abs() as usize, rows.max(0) as usize);
    let (u, v) = (u.get(from..).unwrap_or(&[]), v.get(later..).unwrap_or(&[]));
    let length = u.len().min(v.len());
    let (u, v) = (&u[..length], &v[..length]);
    let mean = |x: &[f64]| x.iter().sum::<f64>() / length as f64;
    let (a, b) = (mean(u), mean(v));
    let (mut uu, mut vv, mut uv) = (0.0, 0.0, 0.0);
    for (u, v) in u.iter().zip(v) {
        uu += (u - a) * (u - a);
        vv += (v - b) * (v - b);
        uv += (u - a) * (v - b);
    }
    uv / (uu * vv).sqrt()
}

/// By how many rows the second history comes later than the first: uphill from no shift to where the two fit best, so that a
/// motion that repeats itself has no lag of a period, and to a parabola's peak between rows. None where there is no such place
/// within `most` rows.
fn lag(u: &[f64], v: &[f64], most: i64) -> Option<f64> {
    let [before, here, after] = [-1, 0, 1].map(|rows| correlation(u, v, rows));
    let way = if after > here { 1 } else { -1 };
    let (mut behind, mut best, mut next) =
        if after > here { (before, here, after) } else { (after, here, before) };
    let mut rows = 0i64;
    while next > best {
        rows += way;
        if rows.abs() >= most {
            return None;
        }
        (behind, best, next) = (best, next, correlation(u, v, rows + way));
    }
    let bend = behind - 2.0 * best + next;
    let within = if bend < 0.0 { 0.5 * (behind - next) / bend } else { 0.0 };
    best.is_finite().then_some(rows as f64 + way as f64 * within)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tremolite_results::{Column, TableWriter};

    const INTERVAL: f64 = 0.01;

    /// Monitors A, B, C … that move along x, y and z by what is given, of the time \[s\].
    fn histories(rows: u32, motions: &[&dyn Fn(f64) -> [f64; 3]]) -> IndexMap<String, Synchrony> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("monitors.csv");
        let names: Vec<String> = ('A'..).take(motions.len()).map(String::from).collect();
        let mut columns = vec![Column::new("time", "s")];
        for name in &names {
            columns.extend(COMPONENTS.map(|c| Column::new(format!("{name}.{c}"), "m")));
        }
        let mut table = TableWriter::create(&path, &columns).unwrap();
        for row in 0..rows {
            let t = f64::from(row) * INTERVAL;
            let moved = motions.iter().flat_map(|motion| motion(t));
            table.write(&std::iter::once(t).chain(moved).collect::<Vec<f64>>()).unwrap();
        }
        drop(table);
        synchrony(&Table::read(&path).unwrap(), names.iter().map(String::as_str))
    }

    /// An earthquake of sorts.
    fn shaken(t: f64) -> [f64; 3] {
        let u = (-((t - 5.0) / 1.5).powi(2)).exp() * ((7.0 * t).sin() + 0.4 * (19.0 * t).cos());
        [0.03 * u, 1e-5 * u, -0.01 * u]
    }

    #[test]
    fn the_latest_of_all_pairs_and_the_least_alike_are_named() {
        let found = histories(1000, &[&shaken, &|t| shaken(t - 0.02), &|t| shaken(t + 0.013)]);
        assert_eq!(found.keys().collect::<Vec<_>>(), ["ux", "uz"], "what hardly moves has no course");
        for of in found.values() {
            assert_eq!((of.latest_of.as_str(), of.least_of.as_str()), ("B-C", "B-C"));
            // The second of the pair comes earlier, by 33 ms.
            assert!((of.lag + 0.033).abs() < 2e-4, "{}", of.lag);
            assert!(of.correlation > 0.9 && of.correlation < 0.99, "{}", of.correlation);
        }
    }

    #[test]
    fn what_moves_alike_has_no_lag_not_even_one_of_a_period() {
        let steady = |t: f64| [0.01 * (31.416 * t).sin(), 0.0, 0.0];
        for motion in [&shaken as &dyn Fn(f64) -> [f64; 3], &steady] {
            let found = histories(1000, &[motion, motion]);
            assert!(found["ux"].lag.abs() < 1e-9 && (found["ux"].correlation - 1.0).abs() < 1e-12);
        }
        let late = histories(1000, &[&steady, &|t| steady(t - 0.01)]);
        assert!((late["ux"].lag - 0.01).abs() < 1e-4, "{}", late["ux"].lag);
    }

    #[test]
    fn one_monitor_few_rows_and_one_that_stands_still_are_no_pair() {
        assert!(histories(1000, &[&shaken]).is_empty());
        assert!(histories(20, &[&shaken, &shaken]).is_empty());
        let still = |_| [0.0; 3];
        let found = histories(1000, &[&shaken, &still, &|t| shaken(t - 0.02)]);
        assert_eq!(found["ux"].latest_of, "A-C");
        assert!((found["ux"].lag - 0.02).abs() < 2e-4);
    }
}
