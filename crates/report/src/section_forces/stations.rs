//! Linings with the section forces of their stations.

use indexmap::IndexMap;
use tremolite_results::{SectionRow, Summary};

use crate::language::{Language, say};
use crate::stages::names::called;

/// Stations whose y differ by less lie in one section (m).
const SAME: f64 = 0.01;

/// A step this many times the usual one leaves something out.
const GAP: f64 = 2.2;
/// Cosine of the angle between the steps before and after one that goes round a corner: beyond 75°, which even a crown of
/// six stations keeps to.
const CORNER: f64 = 0.26;

/// The three forces with their symbols and the units in which they are shown: thousands of the SI ones.
pub fn forces(language: Language) -> [String; 3] {
    [
        say!(language, "N, thrust, tension positive (kN/m)"),
        say!(language, "M, moment (kN\u{a0}m/m)"),
        say!(language, "Q, shear (kN/m)"),
    ]
}
/// From SI to what is shown.
pub const KILO: f64 = 1e-3;

/// A station: where it is and what it carries.
#[derive(Clone, Debug, PartialEq)]
pub struct Station {
    pub number: u32,
    pub place: [f64; 3],
    /// m; not a number in files of older versions.
    pub thickness: f64,
    /// N, M, Q when the stages are done; not a number without.
    pub after: [f64; 3],
    /// Smallest and largest while the ground shakes, with their times.
    pub least: Option<Extreme>,
    pub most: Option<Extreme>,
}

/// One of N, M and Q each, at a time of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    pub forces: [f64; 3],
    pub time: [f64; 3],
    /// N at the time of M, and M at the time of N.
    pub thrust: f64,
    pub moment: f64,
}

/// A lining: its stations in their order.
#[derive(Clone, Debug, PartialEq)]
pub struct Lining {
    pub name: String,
    pub stations: Vec<Station>,
    /// After which stage, in words.
    pub after: String,
}

impl Lining {
    pub fn shaken(&self) -> bool {
        self.stations.iter().any(|s| s.least.is_some() || s.most.is_some())
    }

    /// The stations of the section nearest to a plane y, by default to the middle, and its y.
    pub fn section(&self, y: Option<f64>) -> (f64, Vec<&Station>) {
        let mut at: Vec<f64> = self.stations.iter().map(|s| s.place[1]).collect();
        at.sort_by(f64::total_cmp);
        let ends = at.first().zip(at.last()).map_or(0.0, |(low, high)| 0.5 * (low + high));
        let wanted = y.unwrap_or(ends);
        // Stations of one section need not have one y to the last bit.
        let mut slices: Vec<(f64, f64)> = Vec::new();
        for y in at {
            match slices.last_mut() {
                Some((_, to)) if y - *to < SAME => *to = y,
                _ => slices.push((y, y)),
            }
        }
        let away = |slice: &(f64, f64)| (0.5 * (slice.0 + slice.1) - wanted).abs();
        let nearest = slices.into_iter().min_by(|a, b| away(a).total_cmp(&away(b)));
        let (from, to) = nearest.unwrap_or((wanted, wanted));
        let inside = |s: &&Station| (from..=to).contains(&s.place[1]);
        (0.5 * (from + to), self.stations.iter().filter(inside).collect())
    }
}

/// Whether a row is an extreme of the shaking; a stage may be called `min`.
fn is_extreme(row: &SectionRow) -> bool {
    matches!(row.when.as_str(), "min" | "max") && row.time.iter().any(|t| t.is_finite())
}

/// All linings of the file.
pub fn linings(language: Language, rows: &[SectionRow], facts: &Summary) -> Vec<Lining> {
    let mut by_name: IndexMap<&str, Vec<&SectionRow>> = IndexMap::new();
    for row in rows {
        by_name.entry(&row.lining).or_default().push(row);
    }
    by_name.into_iter().map(|(name, rows)| lining(language, name, &rows, facts)).collect()
}

fn lining(language: Language, name: &str, rows: &[&SectionRow], facts: &Summary) -> Lining {
    let stage = |row: &&&SectionRow| !is_extreme(row);
    // The last stage of which there are rows; the file goes by stages in their order.
    let of = |name: &str| rows.iter().filter(stage).any(|row| row.when == name);
    let last = facts.computed.stages.iter().enumerate().rev().find(|(_, s)| of(&s.name));
    let when =
        last.map(|(_, s)| s.name.clone()).or_else(|| rows.iter().rfind(stage).map(|row| row.when.clone()));
    let after = match (&last, &when) {
        (Some((k, stage)), _) => say!(language, "after {stage}", stage = called(language, *k, stage)),
        (None, Some(when)) => say!(language, "after stage {name}", name = when),
        (None, None) => say!(language, "before the shaking"),
    };
    let mut stations: IndexMap<u32, Station> = IndexMap::new();
    for row in rows {
        let station = stations.entry(row.station).or_insert(Station {
            number: row.station,
            place: row.place,
            thickness: row.thickness,
            after: [f64::NAN; 3],
            least: None,
            most: None,
        });
        let extreme = Extreme {
            forces: row.forces,
            time: row.time,
            thrust: row.thrust_at_moment,
            moment: row.moment_at_thrust,
        };
        match (is_extreme(row), row.when.as_str()) {
            (true, "min") => station.least = Some(extreme),
            (true, _) => station.most = Some(extreme),
            // Of stages of one name the last counts.
            (false, name) if when.as_deref() == Some(name) => station.after = row.forces,
            (false, _) => {}
        }
    }
    let mut stations: Vec<Station> = stations.into_values().collect();
    stations.sort_by_key(|s| s.number);
    Lining { name: name.into(), stations, after }
}

/// A force in thousands: whole ones from a hundred on, else to a tenth.
pub fn kilo(value: f64) -> String {
    let size = (value * KILO).abs();
    let text = if size >= 100.0 { format!("{size:.0}") } else { format!("{size:.1}") };
    let minus = value < 0.0 && text.contains(|c: char| c.is_ascii_digit() && c != '0');
    if minus { format!("−{text}") } else { text }
}

/// Whether the lining goes on from each station to the next, and from the last to the first: stations are missing where
/// walls meet, and at its ends.
pub fn joints(section: &[&Station]) -> Vec<bool> {
    let number = section.len();
    let step = |k: usize| {
        let (a, b) = (section[k % number], section[(k + 1) % number]);
        [b.place[0] - a.place[0], b.place[2] - a.place[2]]
    };
    let mut usual: Vec<f64> = section.windows(2).map(|pair| distance(pair[0], pair[1])).collect();
    usual.sort_by(f64::total_cmp);
    let usual = usual.get(usual.len() / 2).copied().unwrap_or(0.0);
    let long = |[x, z]: [f64; 2]| x.hypot(z) > GAP * usual;
    let corner = |[ax, az]: [f64; 2], [bx, bz]: [f64; 2]| {
        ax * bx + az * bz < CORNER * (ax.hypot(az) * bx.hypot(bz)).max(1e-12)
    };
    let joint = |k: usize| {
        let (before, after) = (step(k + number - 1), step(k + 1));
        // Across a gap there is no telling which way the lining went.
        !long(step(k)) && (number < 4 || long(before) || long(after) || !corner(before, after))
    };
    (0..number).map(|k| number > 2 && joint(k) || number == 2 && k == 0).collect()
}

/// Between two stations in the section (m).
pub fn distance(a: &Station, b: &Station) -> f64 {
    (a.place[0] - b.place[0]).hypot(a.place[2] - b.place[2])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(station: u32, y: f64, when: &str, time: f64, n: f64) -> SectionRow {
        SectionRow {
            lining: "l".into(),
            station,
            place: [f64::from(station), y, 0.0],
            when: when.into(),
            time: [time; 3],
            forces: [n, 0.0, 0.0],
            thrust_at_moment: n,
            moment_at_thrust: 0.0,
            thickness: 0.5,
        }
    }

    #[test]
    fn a_stage_called_min_is_a_stage_and_the_last_stage_counts() {
        let nan = f64::NAN;
        let rows = [
            row(0, 0.0, "min", nan, 1.0),
            row(0, 0.0, "last", nan, 2.0),
            row(0, 0.0, "min", 1.5, -3.0),
            row(0, 0.0, "max", 2.5, 4.0),
        ];
        let lining = &linings(Language::English, &rows, &Summary::default())[0];
        let station = &lining.stations[0];
        assert_eq!((station.after[0], lining.after.as_str()), (2.0, "after stage last"));
        assert_eq!(station.least.map(|e| (e.forces[0], e.time[0])), Some((-3.0, 1.5)));
        assert_eq!(station.most.map(|e| e.forces[0]), Some(4.0));
    }

    #[test]
    fn a_box_breaks_at_its_corners_and_a_ring_closes() {
        let joints = |points: &[[f64; 2]]| -> Vec<bool> {
            let rows: Vec<SectionRow> = (0..)
                .zip(points)
                .map(|(k, p)| SectionRow { place: [p[0], 0.0, p[1]], ..row(k, 0.0, "s", f64::NAN, 0.0) })
                .collect();
            let lining = linings(Language::English, &rows, &Summary::default()).remove(0);
            super::joints(&lining.section(None).1)
        };
        let ring: Vec<[f64; 2]> = (0..12)
            .map(|k| (f64::from(k) * std::f64::consts::TAU / 12.0).sin_cos())
            .map(|(s, c)| [c, s])
            .collect();
        assert_eq!(joints(&ring), [true; 12]);
        let open = joints(&ring[..9]);
        assert!(open[..8].iter().all(|on| *on) && !open[8]);
        // Three stations a wall, a corner's distance of 1.4 between walls.
        let wall = [
            [4.0, 1.0],
            [4.0, 2.0],
            [4.0, 3.0],
            [3.0, 4.0],
            [2.0, 4.0],
            [1.0, 4.0],
            [0.0, 3.0],
            [0.0, 2.0],
            [0.0, 1.0],
        ];
        assert_eq!(joints(&wall), [true, true, false, true, true, false, true, true, false]);
    }

    #[test]
    fn the_section_nearest_to_the_plane_is_drawn() {
        let rows: Vec<SectionRow> = (0..9)
            .map(|k| row(k, f64::from(k / 3) * 2.0 + f64::from(k) * 1e-9, "s", f64::NAN, 0.0))
            .collect();
        let lining = &linings(Language::English, &rows, &Summary::default())[0];
        let numbers = |y| lining.section(y).1.iter().map(|s| s.number).collect::<Vec<_>>();
        assert_eq!(numbers(Some(0.3)), [0, 1, 2]);
        assert_eq!(numbers(None), [3, 4, 5], "the middle");
        assert_eq!(numbers(Some(99.0)), [6, 7, 8]);
    }
}
