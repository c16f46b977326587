//! Values with units: "25 GPa", "27 kN/m3", "46 deg", "0.3 1/s".
//!
//! A value is a number and a unit. Units are joined by `*` (or `·`) and `/`, read from left to right, each with an
//! optional power: `m3`, `m^3`, `m³`, `s^-2`. SI prefixes go with the units engineers use them with. `g` is the
//! gram, but standard gravity (9.80665 m/s²) where it stands alone and an acceleration is wanted.

mod error;
mod symbols;

pub use error::UnitError;

use symbols::{NAMED, Named, PREFIXES, SYMBOLS, Symbol};
use tremolite_laws::parameter::Dimension;

/// Standard gravity, m/s² (exact, CGPM 1901).
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// Reads a value with its unit and returns it in SI (angles in rad).
///
/// A pure number may stand without a unit, or in `%`.
///
/// # Errors
/// No number, an unknown unit, another dimension than `wanted`, anything behind the unit, or a value that does not
/// fit a double.
pub fn parse(text: &str, wanted: Dimension) -> Result<f64, UnitError> {
    let text = text.trim();
    let (digits, exponent, unit) = split_number(text).ok_or(UnitError::NoNumber { wanted })?;
    if unit.starts_with(',') {
        return Err(UnitError::Comma);
    }
    let unit = match unit.trim_start() {
        "" if wanted == Dimension::NONE => Compound::ONE,
        "" => return Err(UnitError::NoUnit { number: text.to_owned(), wanted }),
        unit => Compound::parse(unit, wanted)?,
    };
    let power = exponent.saturating_add(i64::from(unit.tens));
    let value = format!("{digits}e{power}").parse::<f64>().map_or(f64::NAN, |x| x * unit.factor);
    if value.is_finite() { Ok(value) } else { Err(UnitError::NotFinite) }
}

/// Reads a unit alone, such as "cm/s2", and returns its value in SI.
///
/// # Errors
/// As [`parse`].
pub fn parse_unit(text: &str, wanted: Dimension) -> Result<f64, UnitError> {
    let unit = Compound::parse(text.trim(), wanted)?;
    let value = format!("1e{}", unit.tens).parse::<f64>().map_or(f64::NAN, |x| x * unit.factor);
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(UnitError::NotFinite) }
}

/// A value in SI as an engineer would write it, to six digits: `format(2.5e10, PRESSURE)` is "25 GPa".
pub fn format(value: f64, dimension: Dimension) -> String {
    let (unit, scale) = match named("", dimension) {
        Some(n) => {
            let fits = |&&(_, scale, from): &&(&str, f64, f64)| {
                if value == 0.0 { scale == 1.0 } else { value.abs() >= from }
            };
            let (unit, scale, _) = n.units.iter().rev().find(fits).unwrap_or(&n.units[0]);
            ((*unit).to_owned(), *scale)
        }
        None => (si(dimension), 1.0),
    };
    let number = digits(value / scale);
    if unit.is_empty() { number } else { format!("{number} {unit}") }
}

/// What a dimension is called, with its article: "a length". Others than the usual ones by their SI unit.
pub fn name(dimension: Dimension) -> String {
    let names: Vec<&str> = NAMED.iter().filter(|n| n.dimension == dimension).map(|n| n.name).collect();
    if names.is_empty() { format!("a value in {}", si(dimension)) } else { names.join(" or ") }
}

/// What is wanted of a key, where its dimension alone has several names.
pub fn name_for(key: &str, dimension: Dimension) -> String {
    if key.is_empty() {
        name(dimension)
    } else {
        named(key, dimension).map_or_else(|| name(dimension), |n| n.name.to_owned())
    }
}

/// A value of this dimension as one might write it for a key.
pub fn example(key: &str, dimension: Dimension) -> String {
    if key == "diameter" {
        return "25 mm".to_owned();
    }
    // Steel per metre of lining.
    if key == "area" && dimension == Dimension::LENGTH {
        return "1570 mm2/m".to_owned();
    }
    // Strengths and pressures have the dimension of a modulus.
    if dimension == Dimension::PRESSURE && !key.is_empty() && !is_modulus(key) {
        return if key == "yield" { "400 MPa" } else { "2 MPa" }.to_owned();
    }
    named(key, dimension).map_or_else(|| format!("1 {}", si(dimension)), |n| n.example.to_owned())
}

/// The dimensions that have a name, each with an example and the units that it may stand in besides.
pub fn listed() -> Vec<(&'static str, &'static str, Vec<String>)> {
    let of = |n: &Named| {
        let own = n.example.split_once(' ').map_or("", |(_, unit)| unit);
        let written = n.units.iter().map(|(unit, ..)| (*unit).to_owned());
        let symbols = SYMBOLS.iter().filter(|s| s.dimension == n.dimension && s.name != "1").flat_map(|s| {
            std::iter::once(s.name.to_owned()).chain(s.prefixes.chars().map(|p| format!("{p}{}", s.name)))
        });
        let mut all: Vec<String> = Vec::new();
        for unit in written.chain(symbols).filter(|unit| !unit.is_empty() && unit != own) {
            // μ and µ are one letter to people.
            if !all.contains(&unit) && !unit.contains(['\u{b5}', '\u{3bc}']) {
                all.push(unit);
            }
        }
        (n.name, n.example, all)
    };
    NAMED.iter().map(of).collect()
}

/// A bare number as it was probably meant for a key: `likely("cohesion", 2.18, PRESSURE)` is "2.18 MPa",
/// `likely("young", 25e9, PRESSURE)` "25 GPa".
pub fn likely(key: &str, value: f64, dimension: Dimension) -> String {
    let number = digits(value);
    match dimension {
        // Lengths and times span too much for a guess, but for those of bars, cracks and joints.
        Dimension::LENGTH if key.contains("diameter") && value >= 1.0 => return format!("{number} mm"),
        // Cracks and the closures of joints are fractions of a millimetre.
        Dimension::LENGTH if matches!(key, "crack_width" | "max_closure") && value >= 0.005 => {
            return format!("{number} mm");
        }
        // A limit of a metre is none.
        Dimension::LENGTH if matches!(key, "displacement" | "relative_displacement") && value >= 1.0 => {
            return format!("{number} mm");
        }
        // Steel per metre of lining.
        Dimension::LENGTH if key == "area" && value >= 1.0 => return format!("{number} mm2/m"),
        Dimension::LENGTH if key == "area" => return format!("{number} m2/m"),
        Dimension::LENGTH => return format!("{number} m"),
        Dimension::TIME => return format!("{number} s"),
        Dimension::RATE if !key.contains("rate") && key != "mass" => return format!("{number} Hz"),
        Dimension::ANGLE if value.abs() < 2.0 && value.fract() != 0.0 => return format!("{number} rad"),
        _ => {}
    }
    let usual = parse(usual(key, dimension), dimension).unwrap_or(1.0);
    // How far, in powers of ten, the number would be from what is usual.
    let far = |scale: f64| (value.abs() * scale / usual).log10().abs();
    let units = named(key, dimension).map_or(&[][..], |n| n.units);
    match units.iter().min_by(|a, b| far(a.1).total_cmp(&far(b.1))) {
        Some((unit, scale, _)) if *scale != 1.0 => format!("{number} {unit}"),
        _ => format(value, dimension),
    }
}

fn is_modulus(key: &str) -> bool {
    ["young", "modulus", "stiffness"].iter().any(|word| key.contains(word))
}

/// A usual value of a key. Moduli and strengths have one dimension.
fn usual(key: &str, dimension: Dimension) -> &'static str {
    match named(key, dimension) {
        // The steel of bolts and bars.
        _ if dimension == Dimension::PRESSURE && key == "yield" => "400 MPa",
        _ if dimension == Dimension::PRESSURE && !is_modulus(key) => "10 MPa",
        Some(named) => named.example,
        None => "",
    }
}

fn named(key: &str, dimension: Dimension) -> Option<&'static Named> {
    let mut all = NAMED.iter().filter(|n| n.dimension == dimension);
    let of_two = key.contains("stiffness") || key == "strength";
    if of_two { all.next_back() } else { all.next() }
}

/// A dimension as a product of SI units, to be read back by [`parse_unit`].
fn si(dimension: Dimension) -> String {
    let powers =
        [("kg", dimension.mass), ("m", dimension.length), ("s", dimension.time), ("rad", dimension.angle)];
    let text: Vec<String> = powers
        .iter()
        .filter(|(_, n)| *n != 0)
        .map(|(unit, n)| if *n == 1 { (*unit).to_owned() } else { format!("{unit}^{n}") })
        .collect();
    if text.is_empty() { "1".to_owned() } else { text.join("*") }
}

/// Six significant digits without trailing zeros.
fn digits(x: f64) -> String {
    let rounded: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    let size = rounded.abs();
    if size == 0.0 || (1e-4..1e7).contains(&size) { format!("{rounded}") } else { format!("{rounded:e}") }
}

/// Splits "-1.5e3 kPa" into "-1.5", 3 and " kPa"; nothing if the text does not start with a number.
fn split_number(text: &str) -> Option<(&str, i64, &str)> {
    let bytes = text.as_bytes();
    let digits_from = |from: usize| bytes[from..].iter().take_while(|b| b.is_ascii_digit()).count();
    let sign = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let whole = digits_from(sign);
    let mut end = sign + whole;
    let mut count = whole;
    if bytes.get(end) == Some(&b'.') {
        let fraction = digits_from(end + 1);
        count += fraction;
        end += 1 + fraction;
    }
    if count == 0 {
        return None;
    }
    let mantissa = &text[..end];
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let signed = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let start = end + 1;
        let length = signed + digits_from(start + signed);
        if length > signed {
            let exponent = &text[start..start + length];
            // An exponent beyond i64 saturates; the value is then refused as not finite, or is 0.
            let beyond = if exponent.starts_with('-') { i64::MIN } else { i64::MAX };
            return Some((mantissa, exponent.parse().unwrap_or(beyond), &text[start + length..]));
        }
    }
    Some((mantissa, 0, &text[end..]))
}

/// A product of powers of units: SI value `factor · 10^tens`.
struct Compound {
    tens: i32,
    factor: f64,
}

impl Compound {
    const ONE: Compound = Compound { tens: 0, factor: 1.0 };

    fn parse(text: &str, wanted: Dimension) -> Result<Compound, UnitError> {
        if text == "g" && wanted == Dimension::ACCELERATION {
            return Ok(Compound { tens: 0, factor: STANDARD_GRAVITY });
        }
        // Far longer than any real unit; keeps the sums of powers far from overflow.
        if text.len() > 100 {
            return Err(UnitError::Malformed {
                unit: text.chars().take(20).collect::<String>() + "…",
                wanted,
            });
        }
        let malformed = || UnitError::Malformed { unit: text.to_owned(), wanted };
        let mut product = Compound::ONE;
        let mut sum = [0_i32; 4];
        let mut sign = 1;
        let mut rest = text;
        let mut first = true;
        loop {
            let (symbol, prefix, power, after) = read_factor(rest, wanted, text)?;
            if symbol.name == "1" && !first {
                return Err(malformed());
            }
            let n = sign * power;
            product.tens += n * (symbol.tens + prefix);
            product.factor *= symbol.factor.powi(n);
            let d = symbol.dimension;
            for (sum, exponent) in sum.iter_mut().zip([d.length, d.mass, d.time, d.angle]) {
                *sum += n * i32::from(exponent);
            }
            let mut chars = after.trim_start().chars();
            sign = match chars.next() {
                None => break,
                Some('*' | '·' | '⋅') => 1,
                Some('/') => -1,
                Some(_) => return Err(malformed()),
            };
            rest = chars.as_str().trim_start();
            first = false;
        }
        let [length, mass, time, angle] = sum.map(|n| i8::try_from(n).map_err(|_| malformed()));
        let found = Dimension { length: length?, mass: mass?, time: time?, angle: angle? };
        if found == wanted {
            Ok(product)
        } else {
            Err(UnitError::WrongDimension { unit: text.to_owned(), found, wanted })
        }
    }
}

/// Reads one unit and its power; returns the unit, its prefix's power of ten, its power, and what follows.
fn read_factor<'a>(
    text: &'a str,
    wanted: Dimension,
    whole: &str,
) -> Result<(&'static Symbol, i32, i32, &'a str), UnitError> {
    let malformed = || UnitError::Malformed { unit: whole.to_owned(), wanted };
    let is_letter = |c: char| (c.is_alphabetic() && !SUPERSCRIPTS.contains(c)) || c == '%' || c == '°';
    let length = match text.strip_prefix('1') {
        Some(_) => 1,
        None => text.find(|c| !is_letter(c)).unwrap_or(text.len()),
    };
    if length == 0 {
        return Err(malformed());
    }
    let (name, after) = text.split_at(length);
    let (symbol, prefix) = look_up(name).ok_or_else(|| UnitError::Unknown {
        unit: name.to_owned(),
        meant: meant(name),
        wanted,
    })?;
    if name == "1" {
        return Ok((symbol, prefix, 1, after));
    }
    let (power, after) = read_power(after).ok_or_else(malformed)?;
    Ok((symbol, prefix, power, after))
}

const SUPERSCRIPTS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/// Reads a power of one digit, 1 where there is none; nothing if it is malformed.
fn read_power(text: &str) -> Option<(i32, &str)> {
    let superscript = |c: char| SUPERSCRIPTS.chars().position(|s| s == c);
    let caret = text.strip_prefix('^');
    let rest = caret.unwrap_or(text);
    let (sign, rest) = match rest.strip_prefix('-').or_else(|| rest.strip_prefix('⁻')) {
        Some(rest) => (-1, rest),
        None => (1, rest),
    };
    let signed = rest.len() < caret.unwrap_or(text).len();
    let mut chars = rest.chars();
    let digit = |c: char| c.to_digit(10).map(|d| d as usize).or_else(|| superscript(c));
    match chars.next().and_then(digit) {
        Some(n) => {
            let rest = chars.as_str();
            let more = rest.chars().next().and_then(digit).is_some();
            // One digit is enough for any unit there is; n is at most 9.
            if more { None } else { Some((sign * n as i32, rest)) }
        }
        None if caret.is_some() || signed => None,
        None => Some((1, text)),
    }
}

fn look_up(name: &str) -> Option<(&'static Symbol, i32)> {
    if let Some(symbol) = SYMBOLS.iter().find(|s| s.name == name) {
        return Some((symbol, 0));
    }
    let prefix = name.chars().next()?;
    let (_, tens) = PREFIXES.iter().find(|(c, _)| *c == prefix)?;
    let base = &name[prefix.len_utf8()..];
    let symbol = SYMBOLS.iter().find(|s| s.name == base && s.prefixes.contains(prefix))?;
    Some((symbol, *tens))
}

/// The unit that was probably meant: the same letters in another case.
fn meant(name: &str) -> Option<String> {
    let prefixed = SYMBOLS.iter().flat_map(|s| s.prefixes.chars().map(move |p| format!("{p}{}", s.name)));
    let candidates = SYMBOLS.iter().map(|s| s.name.to_owned()).chain(prefixed);
    let folded = name.to_lowercase();
    let same = candidates.filter(|c| c.to_lowercase() == folded);
    // "mpa" and "Mpa" are megapascals, not some rarer unit: prefer the larger prefix.
    same.max_by_key(|c| look_up(c).map(|(_, tens)| tens))
}

#[cfg(test)]
mod tests;
