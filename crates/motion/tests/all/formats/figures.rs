//! Real files against figures of an independent reading.

use std::path::Path;

use tremolite_motion::{Channel, Error, Orientation, ReadOptions, Units, read, read_bytes};

use crate::records;

/// What an independent reading gave for one channel, in the file's unit.
pub struct Figures {
    pub name: &'static str,
    pub npts: usize,
    pub dt: f64,
    /// The largest value in magnitude, with its sign, and its index: the first if there are several.
    pub peak: (f64, usize),
    pub first: f64,
    pub last: f64,
    pub sum: f64,
    pub orientation: Option<Orientation>,
}

pub fn azimuth(degrees: f64) -> Option<Orientation> {
    Some(Orientation::from_degrees(degrees))
}

/// Reads a real file, if it is at hand, and compares every channel; `None` if it is not.
pub fn compare(file: &str, units: Units, expected: &[Figures]) -> Option<Vec<Channel>> {
    let path = records::local(file)?;
    let channels = read(&path, &ReadOptions::default()).unwrap();
    assert_eq!(channels.len(), expected.len(), "{file}");
    for (c, e) in channels.iter().zip(expected) {
        let factor = units.factor().unwrap_or(1.0);
        let same = |ours: f64, theirs: f64, what: &str| {
            let theirs = theirs * factor;
            assert!(
                (ours - theirs).abs() <= 1e-12 * theirs.abs() + 1e-15,
                "{}: {what} {ours}, not {theirs}",
                e.name
            );
        };
        assert_eq!(c.name, e.name);
        assert_eq!(
            (c.units, c.raw, c.acceleration.len(), c.dt),
            (units, units == Units::Counts, e.npts, e.dt)
        );
        let at =
            (0..e.npts).fold(0, |m, i| if c.acceleration[i].abs() > c.acceleration[m].abs() { i } else { m });
        assert_eq!(at, e.peak.1, "{}", e.name);
        same(c.acceleration[at], e.peak.0, "peak");
        same(c.acceleration[0], e.first, "first");
        same(c.acceleration[e.npts - 1], e.last, "last");
        let (sum, scale) = c.acceleration.iter().fold((0.0, 0.0), |(s, m), a| (s + a, m + a.abs()));
        assert!((sum - e.sum * factor).abs() <= 1e-12 * scale, "{}: sum {sum}", e.name);
        assert_eq!(c.orientation, e.orientation, "{}", e.name);
    }
    Some(channels)
}

/// Reads a file written in a test.
pub fn parse(text: &str, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    read_bytes(Path::new("small.rec"), text.as_bytes(), options)
}

/// The message with which a file is refused.
pub fn refusal(text: &str) -> String {
    parse(text, &ReadOptions::default()).unwrap_err().to_string()
}

/// Numbers in columns, with a line break behind every `per_line`.
pub fn columns(numbers: &[f64], per_line: usize, width: usize, decimals: usize) -> String {
    let lines = numbers
        .chunks(per_line)
        .map(|line| line.iter().map(|x| format!("{x:width$.decimals$}")).collect::<String>() + "\n");
    lines.collect()
}

/// Asserts that channels hold these accelerations (m/s²).
pub fn same(channel: &Channel, expected: &[f64]) {
    assert_eq!(channel.acceleration.len(), expected.len());
    for (a, e) in channel.acceleration.iter().zip(expected) {
        assert!((a - e).abs() <= 1e-12 * e.abs(), "{:?}", channel.acceleration);
    }
}
