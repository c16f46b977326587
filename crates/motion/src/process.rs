//! Processing of a record, written as data so that a case file can hold it and a report can print it.

use std::fmt;

use crate::baseline::{bring_to_rest, detrend_linear, taper};
use crate::shown::shown;
use crate::{Band, Channel, Error, Filter};

/// One step of processing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Process {
    /// Takes off the straight line of best fit (least squares).
    DetrendLinear,
    /// Brings velocity and displacement to zero at the end by a slow, smooth correction of the acceleration, so
    /// that a window cut from a record does not drift. Its period is the record's length, so it does not touch the
    /// shaking; whatever permanent displacement the record had is lost.
    Baseline,
    /// Fades in and out with half a cosine wave of this length (s) at both ends.
    Taper { seconds: f64 },
    /// Fourth-order Butterworth high-pass, forwards and backwards; corner (Hz).
    Highpass { hz: f64 },
    /// Fourth-order Butterworth low-pass, forwards and backwards; corner (Hz).
    Lowpass { hz: f64 },
    /// Fourth-order Butterworth band-pass (eight poles), forwards and backwards; corners (Hz).
    Bandpass { low: f64, high: f64 },
    /// Multiplies by a number.
    Scale(f64),
}

/// What [`Process::parse`] reads, for messages.
const FORMS: &str = "use 'detrend linear', 'baseline', 'taper 1 s', 'highpass 0.1 Hz', 'lowpass 20 Hz', \
                     'bandpass 0.1 Hz 20 Hz' or 'scale 0.35'";

impl Process {
    /// Reads a step as the case file writes it: `detrend linear`, `baseline`, `taper 1 s`, `highpass 0.1 Hz`,
    /// `lowpass 20 Hz`, `bandpass 0.1 Hz 20 Hz`, `scale 0.35`. Numbers without a unit are in s and Hz.
    ///
    /// # Errors
    /// A sentence that names the fault and the forms that are read.
    pub fn parse(text: &str) -> Result<Process, String> {
        let wrong = |problem: String| format!("'{}': {problem}; {FORMS}", shown(text));
        // A unit may stand right behind its number.
        let spaced = split_units(text);
        let mut words = spaced.split_whitespace();
        let name = words.next().ok_or_else(|| wrong("the step is empty".into()))?;
        let rest: Vec<&str> = words.collect();
        let numbers = |unit: &str, count: usize| -> Result<Vec<f64>, String> {
            let mut values = Vec::new();
            for word in &rest {
                match word.parse::<f64>() {
                    Ok(value) if value.is_finite() => values.push(value),
                    Err(_) if word.eq_ignore_ascii_case(unit) => {}
                    _ => return Err(wrong(format!("'{}' is out of place", shown(word)))),
                }
            }
            if values.len() != count {
                return Err(wrong(format!("{count} number(s) expected, {} found", values.len())));
            }
            Ok(values)
        };
        let positive = |values: Vec<f64>| match values.iter().find(|v| **v <= 0.0) {
            Some(v) => Err(wrong(format!("{v} is not above 0"))),
            None => Ok(values),
        };
        match name {
            "detrend" if rest == ["linear"] => Ok(Process::DetrendLinear),
            "baseline" if rest.is_empty() => Ok(Process::Baseline),
            "taper" => Ok(Process::Taper { seconds: positive(numbers("s", 1)?)?[0] }),
            "highpass" => Ok(Process::Highpass { hz: positive(numbers("Hz", 1)?)?[0] }),
            "lowpass" => Ok(Process::Lowpass { hz: positive(numbers("Hz", 1)?)?[0] }),
            "bandpass" => {
                let corners = positive(numbers("Hz", 2)?)?;
                if corners[0] >= corners[1] {
                    return Err(wrong("the lower corner must come first and be below the upper one".into()));
                }
                Ok(Process::Bandpass { low: corners[0], high: corners[1] })
            }
            "scale" => Ok(Process::Scale(numbers("", 1)?[0])),
            _ => Err(wrong("not a known step".into())),
        }
    }

    /// Applies the step to a channel in place.
    ///
    /// # Errors
    /// [`Error::Process`] if a corner is not below the Nyquist frequency, the corners are not in order, the
    /// record is not longer than the filter's padding ([`Filter::padding`]) or than two tapers, or values
    /// leave the range of numbers. The channel is then as before.
    pub fn apply(&self, channel: &mut Channel) -> Result<(), Error> {
        let refuse = |problem: String, remedy: String| Error::Process {
            channel: channel.name.clone(),
            step: self.to_string(),
            problem,
            remedy,
        };
        let filtered = |band: Band| -> Result<Vec<f64>, Error> {
            let filter =
                Filter::design(band, channel.dt).map_err(|[problem, remedy]| refuse(problem, remedy))?;
            filter.zero_phase(&channel.acceleration).ok_or_else(|| {
                refuse(
                    format!(
                        "the record has {} samples and the filter needs more than {}",
                        channel.acceleration.len(),
                        filter.padding()
                    ),
                    "take a longer window".into(),
                )
            })
        };
        let mut values = match *self {
            Process::Highpass { hz } => filtered(Band::High(hz))?,
            Process::Lowpass { hz } => filtered(Band::Low(hz))?,
            Process::Bandpass { low, high } => filtered(Band::Pass(low, high))?,
            Process::DetrendLinear | Process::Baseline | Process::Taper { .. } | Process::Scale(_) => {
                channel.acceleration.clone()
            }
        };
        match *self {
            Process::DetrendLinear => detrend_linear(&mut values),
            Process::Baseline => bring_to_rest(&mut values, channel.dt),
            Process::Taper { seconds } => {
                if !(seconds > 0.0 && 2.0 * seconds <= channel.duration()) {
                    return Err(refuse(
                        format!("the record lasts {} s, less than two tapers", channel.duration()),
                        "shorten the taper or take a longer window".into(),
                    ));
                }
                taper(&mut values, channel.dt, seconds);
            }
            Process::Scale(factor) => values.iter_mut().for_each(|v| *v *= factor),
            Process::Highpass { .. } | Process::Lowpass { .. } | Process::Bandpass { .. } => {}
        }
        if values.iter().any(|v| !v.is_finite()) {
            return Err(refuse(
                "the result is not finite".into(),
                "check the record's values and the numbers of this step".into(),
            ));
        }
        channel.acceleration = values;
        Ok(())
    }
}

/// Puts a space between a number and a unit written right behind it (`20Hz`, `1s`).
fn split_units(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 4);
    let mut previous = ' ';
    for c in text.chars() {
        if matches!(c, 'H' | 'h' | 's') && (previous.is_ascii_digit() || previous == '.') {
            out.push(' ');
        }
        out.push(c);
        previous = c;
    }
    out
}

impl fmt::Display for Process {
    /// The form that [`Process::parse`] reads.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Process::DetrendLinear => f.write_str("detrend linear"),
            Process::Baseline => f.write_str("baseline"),
            Process::Taper { seconds } => write!(f, "taper {seconds} s"),
            Process::Highpass { hz } => write!(f, "highpass {hz} Hz"),
            Process::Lowpass { hz } => write!(f, "lowpass {hz} Hz"),
            Process::Bandpass { low, high } => write!(f, "bandpass {low} Hz {high} Hz"),
            Process::Scale(factor) => write!(f, "scale {factor}"),
        }
    }
}

/// Applies the steps in order.
///
/// # Errors
/// That of the first step that cannot be applied (see [`Process::apply`]); earlier steps stay applied.
pub fn process(channel: &mut Channel, steps: &[Process]) -> Result<(), Error> {
    steps.iter().try_for_each(|step| step.apply(channel))
}

/// The lowest upper corner (Hz) among the steps: what the user cut off on purpose. `None` without a low-pass.
pub fn lowest_lowpass(steps: &[Process]) -> Option<f64> {
    steps
        .iter()
        .filter_map(|step| match step {
            Process::Lowpass { hz } => Some(*hz),
            Process::Bandpass { high, .. } => Some(*high),
            _ => None,
        })
        .min_by(f64::total_cmp)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn channel(acceleration: Vec<f64>) -> Channel {
        Channel::new("test", 0.01, acceleration)
    }

    #[test]
    fn steps_are_read_as_the_case_file_writes_them_and_printed_alike() {
        for (text, step) in [
            ("baseline", Process::Baseline),
            ("detrend linear", Process::DetrendLinear),
            ("taper 1 s", Process::Taper { seconds: 1.0 }),
            ("highpass 0.1 Hz", Process::Highpass { hz: 0.1 }),
            ("lowpass 20 Hz", Process::Lowpass { hz: 20.0 }),
            ("bandpass 0.1 Hz 20 Hz", Process::Bandpass { low: 0.1, high: 20.0 }),
            ("scale 0.35", Process::Scale(0.35)),
            ("scale -1", Process::Scale(-1.0)),
        ] {
            assert_eq!(Process::parse(text), Ok(step));
            assert_eq!(step.to_string(), text);
        }
        assert_eq!(Process::parse(" bandpass  0.1 20hz"), Ok(Process::Bandpass { low: 0.1, high: 20.0 }));
        assert_eq!(Process::parse("taper 1.s"), Ok(Process::Taper { seconds: 1.0 }));
    }

    #[test]
    fn steps_that_mean_nothing_are_refused_with_the_forms() {
        for text in [
            "",
            "detrend",
            "detrend quadratic",
            "taper",
            "taper 1 Hz",
            "taper -1 s",
            "taper 1 s 2 s",
            "bandpass 20 Hz 0.1 Hz",
            "bandpass 1 Hz",
            "highpass 0 Hz",
            "lowpass NaN Hz",
            "scale inf",
            "scale",
            "scale 2 s",
            "notch 50 Hz",
            "lowpass Hz",
        ] {
            let message = Process::parse(text).unwrap_err();
            assert!(message.contains("'bandpass 0.1 Hz 20 Hz'"), "{text}: {message}");
        }
    }

    #[test]
    fn steps_apply_in_order() {
        let mut record = channel((0..101).map(|i| 1.0 + 0.1 * f64::from(i)).collect());
        let mut other = record.clone();
        process(&mut record, &[Process::DetrendLinear, Process::Taper { seconds: 0.2 }]).unwrap();
        process(&mut other, &[Process::Taper { seconds: 0.2 }, Process::DetrendLinear]).unwrap();
        assert!(record.acceleration.iter().all(|a| a.abs() < 1e-12));
        assert!(other.acceleration.iter().any(|a| a.abs() > 0.1));
    }

    #[test]
    fn a_refused_step_says_why_and_leaves_the_record_alone() {
        let record = channel((0..27).map(f64::from).collect());
        for (step, word) in [
            (Process::Lowpass { hz: 60.0 }, "Nyquist"),
            (Process::Bandpass { low: 5.0, high: 5.0 }, "lower corner"),
            (Process::Bandpass { low: 1.0, high: 5.0 }, "27 samples"),
            (Process::Taper { seconds: 0.14 }, "two tapers"),
            (Process::Scale(1e308), "finite"),
        ] {
            let mut touched = record.clone();
            let message = step.apply(&mut touched).unwrap_err().to_string();
            assert!(message.contains(word) && message.contains("test"), "{message}");
            assert_eq!(touched, record);
        }
    }

    #[test]
    fn the_lowest_upper_corner_counts() {
        let steps = [Process::Bandpass { low: 0.1, high: 20.0 }, Process::Lowpass { hz: 15.0 }];
        assert_eq!(lowest_lowpass(&steps), Some(15.0));
        assert_eq!(lowest_lowpass(&[Process::DetrendLinear]), None);
    }
}
