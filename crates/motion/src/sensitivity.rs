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

    /// Reads `427336 counts/(m/s2)`; the unit below may be any of [`Units`] with or without parentheses, so that
    /// `4.19e6 counts/g` will do.
    ///
    /// # Errors
    /// A sentence with the form that is read.
    fn from_str(text: &str) -> Result<Sensitivity, String> {
        let read = || {
            let (number, unit) = text.trim().split_once(char::is_whitespace)?;
            let unit = unit.trim().strip_prefix("count")?;
            let unit = unit.strip_prefix('s').unwrap_or(unit).trim_start().strip_prefix('/')?.trim();
            let unit = unit.strip_prefix('(').and_then(|u| u.strip_suffix(')')).unwrap_or(unit);
            Sensitivity::new(number.parse::<f64>().ok()? / unit.parse::<Units>().ok()?.factor()?)
        };
        read().ok_or_else(|| {
            format!(
                "'{}' is not a sensitivity; write it as counts per unit of acceleration, for example \
                 \"427336 counts/(m/s2)\" or \"4.19e6 counts/g\"",
                shown(text)
            )
        })
    }
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
        ] {
            assert!(text.parse::<Sensitivity>().unwrap_err().contains("427336"), "{text}");
        }
    }
}
