//! Steps as a case file writes them.

use std::fmt;

use super::Process;
use crate::Units;
use crate::shown::shown;

/// What [`Process::parse`] reads, for messages.
const FORMS: &str = "use 'detrend linear', 'baseline', 'baseline polynomial 3', 'pre-event 5 s', 'taper 1 s', \
                     'highpass 0.1 Hz', 'lowpass 20 Hz', 'bandpass 0.1 Hz 20 Hz', 'resample 0.005 s', 'scale 0.35', 'pga 0.3 g', 'pga 3 m/s2', 'match' or 'match 0.1 s 2 s'";

/// Between what has no unit and how it is written with one.
const LACKS_UNIT: &str = " without a unit; write ";

/// Degrees of a baseline's polynomial: above, it begins to follow the shaking.
const DEGREES: std::ops::RangeInclusive<usize> = 1..=10;

impl Process {
    /// Reads a step as the case file writes it: `detrend linear`, `baseline`, `baseline polynomial 3`, `pre-event 5 s`,
    /// `taper 1 s`, `highpass 0.1 Hz`, `lowpass 20 Hz`, `bandpass 0.1 Hz 20 Hz`, `resample 0.005 s`, `scale 0.35`, `pga 0.3 g`,
    /// `match`, `match 0.1 s 2 s`. Times and corners have their unit, which may stand once behind both corners.
    ///
    /// # Errors
    /// A sentence that names the fault and the forms that are read.
    pub fn parse(text: &str) -> Result<Process, String> {
        // Where a unit alone lacks, the form with it is all that is asked for.
        let wrong = |problem: String| match problem.contains(LACKS_UNIT) {
            true => format!("'{}': {problem}", shown(text)),
            false => format!("'{}': {problem}; {FORMS}", shown(text)),
        };
        if let Some(peak) =
            text.trim_start().strip_prefix("pga").filter(|p| p.starts_with(char::is_whitespace))
        {
            return peak_acceleration(peak.trim()).map_err(wrong);
        }
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
            match rest.last() {
                Some(number) if !unit.is_empty() && !number.eq_ignore_ascii_case(unit) => {
                    Err(wrong(format!("a number{LACKS_UNIT}{} {unit}", shown(number))))
                }
                _ => Ok(values),
            }
        };
        let positive = |values: Vec<f64>| match values.iter().find(|v| **v <= 0.0) {
            Some(v) => Err(wrong(format!("{v} is not above 0"))),
            None => Ok(values),
        };
        match name {
            "detrend" if rest == ["linear"] => Ok(Process::DetrendLinear),
            "baseline" if rest.is_empty() => Ok(Process::Baseline),
            "baseline" if rest.first() == Some(&"polynomial") => match &rest[1..] {
                [word] => match word.parse() {
                    Ok(degree) if DEGREES.contains(&degree) => Ok(Process::BaselinePolynomial { degree }),
                    _ => Err(wrong(format!("'{}' is not a degree from 1 to 10", shown(word)))),
                },
                _ => Err(wrong("one degree is expected, from 1 to 10".into())),
            },
            "pre-event" => Ok(Process::PreEvent { seconds: positive(numbers("s", 1)?)?[0] }),
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
            "resample" => Ok(Process::Resample { seconds: positive(numbers("s", 1)?)?[0] }),
            "match" if rest.is_empty() => Ok(Process::Match { band: None }),
            "match" => {
                let periods = positive(numbers("s", 2)?)?;
                if periods[0] >= periods[1] {
                    return Err(wrong("the shorter period comes first".into()));
                }
                Ok(Process::Match { band: Some([periods[0], periods[1]]) })
            }
            "scale" => Ok(Process::Scale(numbers("", 1)?[0])),
            _ => Err(wrong("not a known step".into())),
        }
    }
}

/// A peak with its unit, such as `0.3 g` or `2.5 m/s2`. A bare number is refused: 0.3 m/s² in place of 0.3 g is ten times too weak.
fn peak_acceleration(text: &str) -> Result<Process, String> {
    // An exponent's letter belongs to the number.
    let end = text.find(|c: char| c.is_alphabetic() && !matches!(c, 'e' | 'E')).unwrap_or(text.len());
    let (number, unit) = text.split_at(end);
    let value = match number.trim().parse::<f64>() {
        Ok(value) if value.is_finite() => value,
        _ => return Err(format!("'{}' is no number with a unit of acceleration", shown(text))),
    };
    if unit.is_empty() {
        return Err(format!("a peak{LACKS_UNIT}pga {value} g or pga {value} m/s2"));
    }
    let units: Units = unit.parse()?;
    if units.factor().is_none() {
        return Err("a peak in counts is no acceleration".into());
    }
    if value <= 0.0 {
        return Err(format!("{value} is not above 0"));
    }
    Ok(Process::PeakAcceleration { value, units })
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
            Process::BaselinePolynomial { degree } => write!(f, "baseline polynomial {degree}"),
            Process::PreEvent { seconds } => write!(f, "pre-event {seconds} s"),
            Process::Taper { seconds } => write!(f, "taper {seconds} s"),
            Process::Highpass { hz } => write!(f, "highpass {hz} Hz"),
            Process::Lowpass { hz } => write!(f, "lowpass {hz} Hz"),
            Process::Bandpass { low, high } => write!(f, "bandpass {low} Hz {high} Hz"),
            Process::Resample { seconds } => write!(f, "resample {seconds} s"),
            Process::Scale(factor) => write!(f, "scale {factor}"),
            Process::PeakAcceleration { value, units } => write!(f, "pga {value} {units}"),
            Process::Match { band: None } => f.write_str("match"),
            Process::Match { band: Some([from, to]) } => write!(f, "match {from} s {to} s"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn peak(value: f64, units: Units) -> Process {
        Process::PeakAcceleration { value, units }
    }

    #[test]
    fn steps_are_read_as_the_case_file_writes_them_and_printed_alike() {
        for (text, step) in [
            ("baseline", Process::Baseline),
            ("baseline polynomial 3", Process::BaselinePolynomial { degree: 3 }),
            ("pre-event 5 s", Process::PreEvent { seconds: 5.0 }),
            ("pga 0.3 g", peak(0.3, Units::G)),
            ("pga 2.5 m/s2", peak(2.5, Units::MetrePerSecond2)),
            ("detrend linear", Process::DetrendLinear),
            ("resample 0.005 s", Process::Resample { seconds: 0.005 }),
            ("taper 1 s", Process::Taper { seconds: 1.0 }),
            ("highpass 0.1 Hz", Process::Highpass { hz: 0.1 }),
            ("lowpass 20 Hz", Process::Lowpass { hz: 20.0 }),
            ("bandpass 0.1 Hz 20 Hz", Process::Bandpass { low: 0.1, high: 20.0 }),
            ("scale 0.35", Process::Scale(0.35)),
            ("scale -1", Process::Scale(-1.0)),
            ("match", Process::Match { band: None }),
            ("match 0.1 s 2 s", Process::Match { band: Some([0.1, 2.0]) }),
        ] {
            assert_eq!(Process::parse(text), Ok(step));
            assert_eq!(step.to_string(), text);
        }
        for (text, step) in [
            (" bandpass  0.1 20hz", Process::Bandpass { low: 0.1, high: 20.0 }),
            ("taper 1.s", Process::Taper { seconds: 1.0 }),
            ("pre-event 2s", Process::PreEvent { seconds: 2.0 }),
            ("pga 3e-1g", peak(0.3, Units::G)),
            (" pga  2.5m/s2 ", peak(2.5, Units::MetrePerSecond2)),
            ("pga 250 gal", peak(250.0, Units::CentimetrePerSecond2)),
        ] {
            assert_eq!(Process::parse(text), Ok(step), "{text}");
        }
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
            "match 2 s",
            "match 2 s 1 s",
            "lowpass NaN Hz",
            "scale inf",
            "scale",
            "scale 2 s",
            "notch 50 Hz",
            "lowpass Hz",
            "baseline 3",
            "baseline polynomial",
            "baseline polynomial 0",
            "baseline polynomial 11",
            "baseline polynomial 2.5",
            "baseline polynomial 3 4",
            "pre-event",
            "pre-event 0 s",
            "pre-event 5 Hz",
            "pga",
            "pga g",
            "pga 0 g",
            "pga -1 g",
            "pga nan g",
            "pga inf",
            "pga 0.3 s",
            "pga 5 counts",
            "pga 1 2 g",
            "pga0.3 g",
        ] {
            let message = Process::parse(text).unwrap_err();
            assert!(message.contains("'bandpass 0.1 Hz 20 Hz'"), "{text}: {message}");
        }
        for (bare, said) in [
            ("taper 2", "write 2 s"),
            ("bandpass 0.1 20", "write 20 Hz"),
            ("match 0.1 2", "write 2 s"),
            ("highpass 0.1 Hz 3", "expected"),
            ("pga 3e-1 ", "write pga 0.3 g"),
        ] {
            let message = Process::parse(bare).unwrap_err();
            assert!(message.contains(said), "{message}");
        }
        let bare = Process::parse("pga 0.3").unwrap_err();
        assert_eq!(bare, "'pga 0.3': a peak without a unit; write pga 0.3 g or pga 0.3 m/s2");
    }
}
