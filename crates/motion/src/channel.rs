//! One component of a record.

use std::path::PathBuf;

use crate::shown::rounded;
use crate::{Error, Orientation, Units};

/// Sampling intervals of records \[s\], those of slow channels of seismometers among them.
pub(crate) const INTERVALS: std::ops::RangeInclusive<f64> = 1e-6..=1e3;
/// No sample is larger, in m/s² or counts: the squares of a long record stay numbers.
pub(crate) const LARGEST: f64 = 1e12;

/// One component of a recorded acceleration, equally spaced in time.
///
/// Readers hand out channels with at least two samples, all finite, and `dt > 0`.
#[derive(Debug, Clone, PartialEq)]
pub struct Channel {
    /// What to call it in tables: the file's stem, with the component's label where the file has several.
    pub name: String,
    /// The component's label, by which a case may name it whatever its file is called; empty where the file has one channel.
    pub label: String,
    /// The file it came from.
    pub file: PathBuf,
    /// The format it was read in, as [`FORMATS`](crate::FORMATS) names it; empty without a file.
    pub format: &'static str,
    /// Sampling interval (s).
    pub dt: f64,
    /// Time of the first sample (s): of the file's time column, else 0.
    pub start: f64,
    /// Samples (m/s²), or counts where [`raw`](Channel::raw).
    pub acceleration: Vec<f64>,
    /// The unit found in the file, or the one declared for it.
    pub units: Units,
    /// Whether the samples are counts still, since nothing says what a count is. Such a channel can be looked at, filtered and
    /// written; [`Geographic`](crate::Geographic), the way into a model, refuses it.
    pub raw: bool,
    /// Whether the samples are those of a sensor that by the file does not record acceleration, such as a seismometer. They
    /// can be looked at and no more: see [`of_accelerometer`](Channel::of_accelerometer).
    pub other_sensor: bool,
    /// Time of the first sample (s, of a clock that the record's files share), where the file states it: see [`align`].
    pub clock: Option<f64>,
    /// What reading did beside reading, in sentences for the user: times that were made equal, a scale of the header.
    pub remarks: Vec<String>,
    /// The positive direction, where the file states it.
    pub orientation: Option<Orientation>,
}

impl Channel {
    /// A channel of samples in m/s², from 0, of no file.
    pub fn new(name: impl Into<String>, dt: f64, acceleration: Vec<f64>) -> Channel {
        Channel {
            name: name.into(),
            label: String::new(),
            file: PathBuf::new(),
            format: "",
            dt,
            start: 0.0,
            acceleration,
            units: Units::MetrePerSecond2,
            raw: false,
            other_sensor: false,
            clock: None,
            remarks: Vec::new(),
            orientation: None,
        }
    }

    /// Whether a case means this channel by a name: its own, or its label alone.
    pub fn is_called(&self, name: &str) -> bool {
        self.name == name || (!self.label.is_empty() && self.label == name)
    }

    /// Time of the last sample (s).
    pub fn end(&self) -> f64 {
        self.start + self.duration()
    }

    /// Time from the first to the last sample (s).
    pub fn duration(&self) -> f64 {
        self.acceleration.len().saturating_sub(1) as f64 * self.dt
    }

    /// Refuses a channel that was put together in memory and is not such as readers hand out.
    ///
    /// # Errors
    /// [`Error::Unsuitable`] if there are less than two samples, if one is not finite or larger than any acceleration, or if its
    /// times are not those of a record.
    pub fn sound(&self) -> Result<(), Error> {
        let Channel { name, dt, start, acceleration, .. } = self;
        if !INTERVALS.contains(dt) || !start.is_finite() {
            return Err(Error::unsuitable(
                format!(
                    "'{name}' begins at {start} s with a sampling interval of {dt} s, which is none of a record"
                ),
                "correct the interval: 0.001 s to 0.05 s are usual",
            ));
        }
        if acceleration.len() < 2 {
            return Err(Error::unsuitable(
                format!("'{name}' has {} samples", acceleration.len()),
                "give two and more",
            ));
        }
        match acceleration.iter().position(|a| a.is_nan() || a.abs() > LARGEST) {
            Some(k) => Err(Error::unsuitable(
                format!("sample {} of '{name}' is {}, which is no acceleration", k + 1, acceleration[k]),
                "correct the value",
            )),
            None => Ok(()),
        }
    }

    /// Refuses samples of a sensor that does not record acceleration: no sensitivity makes acceleration of them.
    ///
    /// # Errors
    /// [`Error::Unsuitable`] if [`other_sensor`](Channel::other_sensor).
    pub fn of_accelerometer(&self) -> Result<(), Error> {
        if !self.other_sensor {
            return Ok(());
        }
        Err(Error::unsuitable(
            format!("'{}' is by its channel's code of a sensor that does not record acceleration", self.name),
            "give the record of an accelerometer, whose channel codes have N as their second letter, as in HNE; or correct the \
             record to acceleration with another program, and give that with its units",
        ))
    }

    /// The samples between `start` and `end` (s), both in the record's own time and both included.
    ///
    /// The window may reach beyond the record; then there is less in it, which `start`, `end()` of the result
    /// tell. A thousandth of an interval is allowed for round-off in the limits.
    ///
    /// # Errors
    /// [`Error::Unsuitable`] if the limits are not in order or fewer than two samples lie between them.
    pub fn window(&self, start: f64, end: f64) -> Result<Channel, Error> {
        // Negated, so that NaN is refused as well.
        if !(start < end) {
            return Err(Error::unsuitable(
                format!("the window from {} s to {} s has no length", rounded(start), rounded(end)),
                "give the earlier time first, as in window = [\"20.5 s\", \"40 s\"]",
            ));
        }
        let first = ((start - self.start) / self.dt - 1e-3).ceil().max(0.0);
        let last = ((end - self.start) / self.dt + 1e-3).floor().min(self.acceleration.len() as f64 - 1.0);
        if !(last - first >= 1.0) {
            return Err(Error::unsuitable(
                format!(
                    "the window from {} s to {} s holds no two samples of record '{}', which runs from {} s to {} s",
                    rounded(start),
                    rounded(end),
                    self.name,
                    rounded(self.start),
                    rounded(self.end())
                ),
                "choose a window inside the record",
            ));
        }
        // Both lie in 0..len by the lines above.
        let (first, last) = (first as usize, last as usize);
        Ok(self.at(first as f64 * self.dt, self.acceleration[first..=last].to_vec()))
    }

    /// This channel with other samples, of which the first is `later` (s) than its own was.
    pub(crate) fn at(&self, later: f64, acceleration: Vec<f64>) -> Channel {
        Channel {
            name: self.name.clone(),
            label: self.label.clone(),
            file: self.file.clone(),
            start: self.start + later,
            clock: self.clock.map(|clock| clock + later),
            acceleration,
            remarks: self.remarks.clone(),
            ..*self
        }
    }
}

/// Sets the channels' own times by their clocks, if all of them have one: components of one earthquake need not begin together.
/// The first channel keeps its times.
pub fn align(channels: &mut [&mut Channel]) {
    let clocks: Option<Vec<f64>> = channels.iter().map(|c| c.clock).collect();
    let Some(clocks) = clocks else { return };
    let Some(first) = channels.first().map(|c| c.start) else { return };
    for (channel, clock) in channels.iter_mut().zip(&clocks) {
        channel.start = first + (clock - clocks[0]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ramp(start: f64, dt: f64, count: usize) -> Channel {
        let acceleration = (0..count).map(|i| start + i as f64 * dt).collect();
        Channel { start, ..Channel::new("ramp", dt, acceleration) }
    }

    #[test]
    fn a_window_keeps_the_samples_between_its_limits_with_their_times() {
        let cut = ramp(20.52, 0.005, 3902).window(25.0, 30.0).unwrap();
        assert_eq!(cut.acceleration.len(), 1001);
        assert!((cut.start - 25.0).abs() < 1e-9 && (cut.end() - 30.0).abs() < 1e-9);
        assert!((cut.acceleration[0] - 25.0).abs() < 1e-9);
    }

    #[test]
    fn a_window_beyond_the_record_is_clipped_and_one_outside_is_refused() {
        let record = ramp(20.52, 0.005, 3902);
        assert_eq!(record.window(20.5, 50.0).unwrap(), record);
        for (a, b) in
            [(0.0, 20.0), (41.0, 50.0), (30.0, 30.0), (30.0, 20.0), (f64::NAN, 30.0), (30.0, f64::NAN)]
        {
            assert!(record.window(a, b).is_err(), "{a} {b}");
        }
        let late = ramp(0.1 + 0.2, 0.01, 101);
        assert_ne!(late.start.to_string(), "0.3");
        let message = late.window(0.1 + 0.7 * 3.0, 50.0).unwrap_err().to_string();
        assert!(
            message.contains("from 2.2 s to 50 s") && message.contains("from 0.3 s to 1.3 s"),
            "{message}"
        );
    }

    #[test]
    fn clocks_set_the_times_of_components_that_do_not_begin_together() {
        let (mut a, mut b) = (ramp(0.0, 0.01, 101), ramp(0.0, 0.01, 101));
        (a.clock, b.clock) = (Some(1e9), None);
        align(&mut [&mut a, &mut b]);
        assert_eq!((a.start, b.start), (0.0, 0.0));
        b.clock = Some(1e9 + 0.5);
        align(&mut [&mut a, &mut b]);
        assert_eq!((a.start, b.start), (0.0, 0.5));
        let cut = b.window(0.75, 2.0).unwrap();
        assert_eq!((cut.start, cut.clock), (0.75, Some(1e9 + 0.75)));
    }
}
