//! Numbers in result files.

use indexmap::IndexMap;
use serde::{Deserialize, Deserializer, Serializer};

/// Appends a number as the tables print it: the shortest decimal that reads back as the same bits.
///
/// So nothing is lost, and equal runs give equal bytes. Numbers from 0.001 up to (not including)
/// 10⁷ are written plainly, others with an exponent (`2.5e-7`); not-a-number is `NaN`, infinities are `inf`
/// and `-inf`. Python, NumPy and pandas read all of these.
pub fn push(text: &mut String, x: f64) {
    use std::fmt::Write;
    let size = x.abs();
    // Writing to a String cannot fail.
    let _ = if x == 0.0 || (1e-3..1e7).contains(&size) || !x.is_finite() {
        write!(text, "{x}")
    } else {
        write!(text, "{x:e}")
    };
}

/// Serialises a number for `serde(with = "number")`: JSON has no NaN and no infinity, so these
/// become `null`.
pub fn serialize<S: Serializer>(x: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    if x.is_finite() { serializer.serialize_f64(*x) } else { serializer.serialize_none() }
}

/// Reads a number back; `null` is NaN.
pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    Ok(Option::<f64>::deserialize(deserializer)?.unwrap_or(f64::NAN))
}

/// Two numbers, of which either may be none.
pub(crate) fn deserialize_pair<'de, D: Deserializer<'de>>(deserializer: D) -> Result<[f64; 2], D::Error> {
    Ok(<[Option<f64>; 2]>::deserialize(deserializer)?.map(|x| x.unwrap_or(f64::NAN)))
}

/// Reads named numbers; `null`, as which NaN is written, is NaN again.
pub(crate) fn deserialize_map<'de, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<IndexMap<String, f64>, D::Error> {
    let map = IndexMap::<String, Option<f64>>::deserialize(deserializer)?;
    Ok(map.into_iter().map(|(name, x)| (name, x.unwrap_or(f64::NAN))).collect())
}

/// The value of a number that the file does not give.
pub(crate) fn absent() -> f64 {
    f64::NAN
}

/// Whether it is not a number, by reference as serde asks.
pub(crate) fn is_absent(x: &f64) -> bool {
    x.is_nan()
}

#[cfg(test)]
mod tests {
    use super::push;

    fn text(x: f64) -> String {
        let mut out = String::new();
        push(&mut out, x);
        out
    }

    #[test]
    fn numbers_are_short_and_plain_where_that_reads_best() {
        assert_eq!(text(0.0), "0");
        assert_eq!(text(0.1), "0.1");
        assert_eq!(text(19.5), "19.5");
        assert_eq!(text(0.001), "0.001");
        assert_eq!(text(2.5e-7), "2.5e-7");
        assert_eq!(text(-1.64e6), "-1640000");
        assert_eq!(text(1e7), "1e7");
        assert_eq!(text(f64::NAN), "NaN");
        assert_eq!(text(f64::NEG_INFINITY), "-inf");
    }

    #[test]
    fn every_number_reads_back_as_the_same_bits() {
        // A multiplicative walk over bit patterns: all exponents and signs, subnormals included.
        let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
        for _ in 0..20_000 {
            bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let x = f64::from_bits(bits);
            if !x.is_nan() {
                assert_eq!(text(x).parse::<f64>().map(f64::to_bits), Ok(bits));
            }
        }
    }
}
