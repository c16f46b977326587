//! The units in which records are written.

use std::fmt;
use std::str::FromStr;

use crate::shown::shown;

/// Standard gravity (m/s²), exact by definition: what 'g' means in a record.
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// A unit of acceleration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Units {
    /// Multiples of [`STANDARD_GRAVITY`].
    G,
    /// m/s².
    MetrePerSecond2,
    /// cm/s², gal.
    CentimetrePerSecond2,
    /// mm/s².
    MillimetrePerSecond2,
    /// What a digitiser counts; an acceleration only by a [`Sensitivity`](crate::Sensitivity).
    Counts,
}

impl Units {
    /// The factor from this unit to m/s²; none for counts.
    pub fn factor(self) -> Option<f64> {
        match self {
            Units::G => Some(STANDARD_GRAVITY),
            Units::MetrePerSecond2 => Some(1.0),
            Units::CentimetrePerSecond2 => Some(1e-2),
            Units::MillimetrePerSecond2 => Some(1e-3),
            Units::Counts => None,
        }
    }
}

impl fmt::Display for Units {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Units::G => "g",
            Units::MetrePerSecond2 => "m/s2",
            Units::CentimetrePerSecond2 => "cm/s2",
            Units::MillimetrePerSecond2 => "mm/s2",
            Units::Counts => "counts",
        })
    }
}

impl FromStr for Units {
    type Err = String;

    /// Reads the spellings met in records: `g`, `gal`, `counts`, and `m`, `cm` or `mm` over `s2`, `s^2`, `s**2`, `s²`,
    /// `s/s`, `sec2`, `sec/sec`, in any case.
    ///
    /// # Errors
    /// A sentence with the accepted units. `mg` and units of velocity are refused, not guessed at.
    fn from_str(text: &str) -> Result<Units, String> {
        let mut word: String =
            text.chars().filter(|c| !c.is_whitespace()).flat_map(char::to_lowercase).collect();
        for (long, short) in [("sec", "s"), ("**", ""), ("^", ""), ("²", "2"), ("s/s", "s2")] {
            word = word.replace(long, short);
        }
        match word.as_str() {
            "g" => Ok(Units::G),
            "m/s2" => Ok(Units::MetrePerSecond2),
            "cm/s2" | "gal" | "gals" => Ok(Units::CentimetrePerSecond2),
            "mm/s2" => Ok(Units::MillimetrePerSecond2),
            "count" | "counts" => Ok(Units::Counts),
            _ => Err(format!(
                "'{}' is not a unit of acceleration known here; use g, m/s2, cm/s2 (or gal), mm/s2 or counts",
                shown(text)
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn common_spellings_of_one_unit_are_the_same_unit() {
        for (unit, spellings) in [
            (Units::G, &["g", "G", " g "][..]),
            (Units::MetrePerSecond2, &["m/s2", "m/s/s", "M/S^2", "m/s²", "m/sec/sec", "m/s**2"]),
            (Units::CentimetrePerSecond2, &["cm/s2", "gal", "Gal", "GAL", "cm/s/s", "CM/SEC/SEC", "cm/sec2"]),
            (Units::MillimetrePerSecond2, &["mm/s2", "mm/s/s", "mm/s^2"]),
            (Units::Counts, &["counts", "Counts", "count"]),
        ] {
            for word in spellings {
                assert_eq!(word.parse(), Ok(unit), "{word}");
            }
            assert_eq!(unit.to_string().parse(), Ok(unit));
        }
    }

    #[test]
    fn units_that_are_not_accelerations_are_refused() {
        for word in ["", "cm/s", "mg", "CM/SEC", "s2"] {
            assert!(word.parse::<Units>().is_err(), "{word}");
        }
    }
}
