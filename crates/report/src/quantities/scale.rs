//! Units as an engineer writes them (mm, MPa, kJ), and numbers to go with them.

/// A display unit: a value in SI times `factor` is a number of `unit`.
#[derive(Clone, Debug, PartialEq)]
pub struct Scale {
    pub factor: f64,
    /// As written on the page, `m/s²`; empty for a pure number.
    pub unit: String,
}

/// Display units of an SI unit, largest first: the size (in SI) from which on it serves, its factor, its name.
type Ladder = &'static [(f64, f64, &'static str)];

const LADDERS: [(&str, Ladder); 9] = [
    ("m", &[(1.0, 1.0, "m"), (1e-3, 1e3, "mm"), (1e-6, 1e6, "µm"), (1e-9, 1e9, "nm")]),
    ("m/s", &[(0.1, 1.0, "m/s"), (1e-4, 1e3, "mm/s"), (1e-7, 1e6, "µm/s")]),
    ("m/s2", &[(1e-2, 1.0, "m/s²"), (1e-5, 1e3, "mm/s²"), (1e-8, 1e6, "µm/s²")]),
    ("Pa", &[(1e9, 1e-9, "GPa"), (1e5, 1e-6, "MPa"), (1e2, 1e-3, "kPa"), (0.1, 1.0, "Pa")]),
    ("Pa/m", &[(1e12, 1e-12, "TPa/m"), (1e8, 1e-9, "GPa/m"), (1e5, 1e-6, "MPa/m"), (1e2, 1e-3, "kPa/m")]),
    ("N", &[(1e6, 1e-6, "MN"), (1e3, 1e-3, "kN"), (0.1, 1.0, "N")]),
    ("J", &[(1e9, 1e-9, "GJ"), (1e6, 1e-6, "MJ"), (1e3, 1e-3, "kJ"), (1e-1, 1.0, "J"), (1e-4, 1e3, "mJ")]),
    ("s", &[(0.1, 1.0, "s"), (1e-3, 1e3, "ms"), (1e-6, 1e6, "µs")]),
    ("Hz", &[(1e6, 1e-6, "MHz"), (1e3, 1e-3, "kHz"), (1e-2, 1.0, "Hz")]),
];

impl Scale {
    /// The display unit that suits values in the SI unit `unit` up to the size `largest`.
    ///
    /// Units without prefixes here, and sizes beyond the prefixes, get a power of ten (`10⁻¹² m`).
    pub fn suiting(unit: &str, largest: f64) -> Scale {
        let unit = if unit == "m/s^2" || unit == "m/s²" { "m/s2" } else { unit };
        let plain = Scale { factor: 1.0, unit: pretty(unit) };
        let size = largest.abs();
        if !size.is_finite() || size == 0.0 {
            return plain;
        }
        let ladder = LADDERS.iter().find(|(name, _)| *name == unit).map_or(&[][..], |(_, steps)| steps);
        if let Some((_, factor, label)) = ladder.iter().find(|(from, ..)| size >= *from)
            && size * factor < 1e5
        {
            return Scale { factor: *factor, unit: (*label).into() };
        }
        if (1e-2..1e5).contains(&size) {
            return plain;
        }
        let power = ((size.log10() / 3.0).floor() as i32 * 3).clamp(-300, 300);
        Scale {
            factor: 10_f64.powi(-power),
            unit: format!("10{} {}", superscript(power), pretty(unit)).trim().into(),
        }
    }

    /// A title with the unit behind it, `stress (MPa)`.
    pub fn labelled(&self, title: &str) -> String {
        if self.unit.is_empty() { title.to_owned() } else { format!("{title} ({})", self.unit) }
    }

    /// A value in this unit, to three figures, without the unit.
    pub fn number(&self, value: f64) -> String {
        figures(value * self.factor, 3)
    }

    /// A value with its unit.
    pub fn quantity(&self, value: f64) -> String {
        let number = self.number(value);
        if self.unit.is_empty() || !value.is_finite() {
            number
        } else {
            format!("{number}\u{a0}{}", self.unit)
        }
    }
}

/// A value in an SI unit, to three figures, in the unit that suits it.
pub fn quantity(unit: &str, value: f64) -> String {
    let scale = Scale::suiting(unit, value);
    if unit.is_empty() {
        figures(value, 3)
    } else if scale.unit.starts_with("10") {
        // No prefix reaches that far: better 2.50 × 10⁻¹⁴ m than 25.0 of 10⁻¹⁵ m.
        format!("{}\u{a0}{}", figures(value, 3), pretty(unit))
    } else {
        scale.quantity(value)
    }
}

/// A number to so many significant figures, a dash where there is none. Whole numbers are never rounded
/// before the point, so 1234 stays 1234; below 0.001 and from 10⁶ on it is written with a power of ten.
pub fn figures(value: f64, count: i32) -> String {
    if value.is_nan() {
        return "–".into();
    }
    let minus = if value < 0.0 { "−" } else { "" };
    let size = value.abs();
    if size.is_infinite() {
        return format!("{minus}∞");
    }
    if size == 0.0 {
        return "0".into();
    }
    if !(1e-3..1e6).contains(&size) {
        let text = format!("{size:.*e}", (count - 1).max(0) as usize);
        let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{minus}{digits}\u{202f}×\u{202f}10{}", superscript(power.parse().unwrap_or(0)));
    }
    let decimals = (count - 1 - size.log10().floor() as i32).max(0);
    format!("{minus}{size:.*}", decimals as usize)
}

/// A number without needless zeros, for what people chose themselves: 10, 0.5, 1.33.
pub fn trimmed(text: &str) -> String {
    // The mantissa of a number with a power of ten ends at the narrow blank.
    let (digits, rest) =
        text.split_at(text.find(|c: char| !(c.is_ascii_digit() || "−.".contains(c))).unwrap_or(text.len()));
    let digits =
        if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits };
    format!("{digits}{rest}")
}

/// A moment of a history that lasts `duration`, both in s: to about the thousandth part of the whole.
pub fn moment(time: f64, duration: f64) -> String {
    if !time.is_finite() {
        return "–".into();
    }
    let decimals = 3.0 - duration.abs().log10().floor();
    let decimals = if decimals.is_finite() { decimals.clamp(0.0, 9.0) as usize } else { 3 };
    format!("{time:.decimals$}")
}

/// A count with its thousands apart: 97 652.
pub fn count(value: u64) -> String {
    let digits = value.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

/// A time span for people: `48 s`, `12 min 5 s`, `3 h 20 min`.
pub fn span(seconds: f64) -> String {
    if !seconds.is_finite() || seconds < 0.0 {
        return "–".into();
    }
    if seconds < 60.0 {
        return format!("{}\u{a0}s", figures(seconds, 3));
    }
    let whole = seconds.round() as u64;
    if whole < 3600 {
        format!("{}\u{a0}min {}\u{a0}s", whole / 60, whole % 60)
    } else {
        format!("{}\u{a0}h {}\u{a0}min", whole / 3600, whole % 3600 / 60)
    }
}

/// A power as it stands behind a 10.
pub fn superscript(power: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digits = power.unsigned_abs().to_string();
    let raised = digits.chars().filter_map(|c| c.to_digit(10)).map(|d| DIGITS[d as usize]);
    if power < 0 { std::iter::once('⁻').chain(raised).collect() } else { raised.collect() }
}

fn pretty(unit: &str) -> String {
    unit.replace("m/s2", "m/s²").replace("m2", "m²").replace("m3", "m³")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_those_of_the_field() {
        assert_eq!(quantity("m", 0.0479), "47.9\u{a0}mm");
        assert_eq!(quantity("Pa", -0.85e6), "−0.850\u{a0}MPa");
        assert_eq!(quantity("Pa", 25e9), "25.0\u{a0}GPa");
        assert_eq!(quantity("J", 1.5e5), "150\u{a0}kJ");
        assert_eq!(quantity("m/s2", 3.5), "3.50\u{a0}m/s²");
        assert_eq!(quantity("s", 8e-5), "80.0\u{a0}µs");
        assert_eq!(quantity("m", 2.5e-14), "2.50\u{202f}×\u{202f}10⁻¹⁴\u{a0}m");
        assert_eq!(quantity("N/m", 130.0), "130\u{a0}N/m");
        assert_eq!(quantity("Pa", 0.0), "0\u{a0}Pa");
        assert_eq!(quantity("m", f64::NAN), "–");
        assert_eq!(quantity("", f64::NEG_INFINITY), "−∞");
    }

    #[test]
    fn numbers_keep_their_figures() {
        assert_eq!(figures(1234.4, 3), "1234");
        assert_eq!(figures(0.00999, 3), "0.00999");
        assert_eq!(figures(2.3e-14, 2), "2.3\u{202f}×\u{202f}10⁻¹⁴");
        assert_eq!(figures(f64::MAX, 3), "1.80\u{202f}×\u{202f}10³⁰⁸");
        assert_eq!(trimmed("−0.500"), "−0.5");
        assert_eq!(trimmed("100"), "100");
        assert_eq!(trimmed("1.00\u{202f}×\u{202f}10⁻⁹"), "1\u{202f}×\u{202f}10⁻⁹");
        assert_eq!(trimmed("1.20\u{a0}mm"), "1.2\u{a0}mm");
        assert_eq!(moment(13.2, 19.5), "13.20");
        assert_eq!(moment(0.01234, 0.5), "0.0123");
        assert_eq!(moment(1.0, f64::NAN), "1.000");
        assert_eq!(count(97_652), "97\u{202f}652");
        assert_eq!(count(652), "652");
        assert_eq!(span(725.4), "12\u{a0}min 5\u{a0}s");
        assert_eq!(span(12_000.0), "3\u{a0}h 20\u{a0}min");
    }
}
