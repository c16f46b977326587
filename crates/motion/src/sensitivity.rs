//! What a digitiser's counts are as acceleration.

use std::fmt;
use std::str::FromStr;

use crate::Units;
use crate::shown::shown;

/// What a user can do about a record in counts.
pub(crate) const REMEDY: &str = "give its sensitivity, which the network's station metadata state, for example sensitivity = \
                                 \"427336 counts/(m/s2)\"";

/// Counts per m/s²: the whole chain from the ground to the file, above 0 and finite. StationXML calls it `InstrumentSensitivity`
/// and states it in counts per M/S**2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sensitivity(f64);

impl Sensitivity {
    /// From counts per m/s²; none unless above 0 and finite.
    pub fn new(counts: f64) -> Option<Sensitivity> {
        (counts > 0.0 && counts.is_finite() && (1.0 / counts).is_finite()).then_some(Sensitivity(counts))
    }

    /// Counts per m/s².
    pub fn counts(self) -> f64 {
        self.0
    }

    /// What one count is (m/s²).
    pub fn per_count(self) -> f64 {
        1.0 / self.0
    }
}

impl fmt::Display for Sensitivity {
    /// The form that is read.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} counts/(m/s2)", self.0)
    }
}

impl FromStr for Sensitivity {
    type Err = String;

    /// Reads `427336 counts/(m/s2)` as people type it: in any case, with or without a blank before `counts` and parentheses,
    /// with digits in threes (`427,336`), and over any of [`Units`], so that StationXML's `4.27E5 COUNTS/M/S**2` and
    /// `4.19e6 counts/g` will do.
    ///
    /// # Errors
    /// A sentence with the form that is read; for counts per m/s, that this is a velocity sensor's.
    fn from_str(text: &str) -> Result<Sensitivity, String> {
        let below = |word: &str| {
            let unit = word.strip_prefix('(').and_then(|u| u.strip_suffix(')')).unwrap_or(word);
            unit.parse::<Units>().ok()?.factor()
        };
        let found = parts(text);
        if let Some((_, unit)) = &found
            && ["m/s", "(m/s)", "cm/s", "(cm/s)", "mm/s", "(mm/s)", "nm/s", "(nm/s)"].contains(&unit.as_str())
        {
            return Err(format!(
                "'{}' is the sensitivity of a velocity sensor, which does not record acceleration; give the record of an \
                 accelerometer (channel codes HN?, BN?, EN?) and its sensitivity, such as \"427336 counts/(m/s2)\"",
                shown(text)
            ));
        }
        found.and_then(|(number, unit)| Sensitivity::new(number / below(&unit)?)).ok_or_else(|| {
            format!(
                "'{}' is not a sensitivity; write it as counts per unit of acceleration, for example \
                 \"427336 counts/(m/s2)\" or \"4.19e6 counts/g\"",
                shown(text)
            )
        })
    }
}

/// The number and what stands behind `counts/`, in small letters and without blanks.
fn parts(text: &str) -> Option<(f64, String)> {
    let word: String = text.to_lowercase().split_whitespace().collect();
    let (number, unit) = word.split_once("count")?;
    let unit = unit.strip_prefix('s').unwrap_or(unit).strip_prefix('/')?;
    Some((ungrouped(number)?.parse().ok()?, unit.to_owned()))
}

/// A number without the commas that group its digits in threes; nothing for commas that do not, which may be decimal ones.
fn ungrouped(number: &str) -> Option<String> {
    let (whole, rest) = number.split_at(number.find(['.', 'e']).unwrap_or(number.len()));
    let mut groups = whole.split(',');
    let first = groups.next()?;
    let digits = |group: &str| group.bytes().all(|b| b.is_ascii_digit());
    let grouped = whole.contains(',') && (1..=3).contains(&first.len()) && digits(first);
    let sound = groups.all(|group| grouped && group.len() == 3 && digits(group));
    // A comma after a single zero is a decimal one.
    (sound && !(grouped && first == "0") && !rest.contains(',')).then(|| whole.replace(',', "") + rest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::STANDARD_GRAVITY;

    #[test]
    fn a_sensitivity_is_counts_over_an_acceleration() {
        for (text, counts) in [
            ("427336 counts/(m/s2)", 427336.0),
            ("1e6 counts/(M/S**2)", 1e6),
            ("4.19e6 counts/g", 4.19e6 / STANDARD_GRAVITY),
            ("4273.36 count / gal", 427336.0),
            ("427336counts/(m/s2)", 427336.0),
            ("4.27E5 COUNTS/M/S**2", 4.27e5),
            ("427,336 Counts/(m/s^2)", 427336.0),
            ("1,427,336.5 counts/m/s/s", 1427336.5),
            ("4.27e5counts/(cm/s2)", 4.27e7),
        ] {
            let found: Sensitivity = text.parse().unwrap();
            assert!((found.counts() / counts - 1.0).abs() < 1e-12, "{text}");
            assert_eq!(found.to_string().parse(), Ok(found));
        }
        for text in [
            "",
            "427336",
            "0 counts/g",
            "-1 counts/g",
            "inf counts/g",
            "1e-320 counts/g",
            "5 counts",
            "5 counts/(m/s)",
            "5 V/g",
            "5 counts/counts",
            "4,27 counts/g",
            "42,7336 counts/g",
            ",427 counts/g",
            "0,427 counts/g",
            "1.4,273 counts/g",
            "1000,000 counts/g",
            "427336, counts/g",
        ] {
            assert!(text.parse::<Sensitivity>().unwrap_err().contains("427336"), "{text}");
        }
        for text in ["6.3e8 counts/(m/s)", "6.3E8 COUNTS/M/S", "6.3e8counts/(cm/s)"] {
            let message = text.parse::<Sensitivity>().unwrap_err();
            assert!(message.contains("velocity sensor") && message.contains("427336"), "{message}");
        }
    }
}
