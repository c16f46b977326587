//! A number with the unit that it is written with, whatever that is: of a key that only the case knows.

use toml::de::DeValue;

use crate::key_path;

/// Significant digits of a number that is drawn: more are beyond what is known of any parameter, and fewer differ by machine.
const DIGITS: usize = 6;

/// A number and its unit as they are written.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    pub number: f64,
    /// Empty for a number without a unit.
    pub unit: String,
}

impl Quantity {
    /// A number, or a text that begins with one; nothing of any other value.
    pub(crate) fn of(value: &DeValue<'_>) -> Option<Quantity> {
        match value {
            DeValue::String(text) => Quantity::parse(text),
            DeValue::Integer(n) => {
                let number = i64::from_str_radix(n.as_str(), n.radix()).ok()? as f64;
                Some(Quantity { number, unit: String::new() })
            }
            DeValue::Float(x) => {
                let number: f64 = x.as_str().parse().ok()?;
                number.is_finite().then_some(Quantity { number, unit: String::new() })
            }
            _ => None,
        }
    }

    /// The number that a text begins with, and the unit that is the rest of it: "1.2 MPa".
    pub fn parse(text: &str) -> Option<Quantity> {
        let text = text.trim();
        let numeric = |c: char| c.is_ascii_digit() || "+-.eE".contains(c);
        let most = text.find(|c: char| !numeric(c)).unwrap_or(text.len());
        let (number, at) = (1..=most).rev().find_map(|at| Some((text[..at].parse::<f64>().ok()?, at)))?;
        number.is_finite().then(|| Quantity { number, unit: text[at..].trim().to_owned() })
    }

    /// The value as it is written in a case, to six significant digits.
    pub fn toml(&self) -> String {
        let number = rounded(self.number);
        if self.unit.is_empty() { number } else { key_path::quoted(&format!("{number} {}", self.unit)) }
    }

    /// The same without quotes.
    pub fn shown(&self) -> String {
        let number = rounded(self.number);
        if self.unit.is_empty() { number } else { format!("{number} {}", self.unit) }
    }
}

/// A number in decimal notation, to six significant digits.
pub fn rounded(number: f64) -> String {
    let number: f64 = format!("{number:.*e}", DIGITS - 1).parse().unwrap_or(number);
    let size = number.abs();
    if size == 0.0 || (1e-4..1e9).contains(&size) { format!("{number}") } else { format!("{number:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_keeps_the_unit_that_it_is_written_with() {
        for (text, number, unit, toml) in [
            ("1.2 MPa", 1.2, "MPa", "\"1.2 MPa\""),
            ("-5e-3m", -5e-3, "m", "\"-0.005 m\""),
            ("0.3333333333", 0.3333333333, "", "0.333333"),
            ("2 e", 2.0, "e", "\"2 e\""),
            ("1e12 Pa", 1e12, "Pa", "\"1e12 Pa\""),
            ("25 %", 25.0, "%", "\"25 %\""),
        ] {
            let quantity = Quantity::parse(text).unwrap_or_else(|| panic!("{text}"));
            assert_eq!((quantity.number, quantity.unit.as_str()), (number, unit), "{text}");
            assert_eq!(quantity.toml(), toml);
        }
        for text in ["", "MPa", "e5", "-", "inf", "nan m"] {
            assert_eq!(Quantity::parse(text), None, "{text}");
        }
    }
}
