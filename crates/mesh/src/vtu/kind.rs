//! VTK's types of numbers, in bytes and in text.

use super::Values;

/// A number type of VTK.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    F32,
    F64,
    /// Signed or not, of so many bytes.
    Whole(bool, usize),
}

impl Kind {
    /// The type by its name in XML files, such as `UInt8`.
    pub(crate) fn named(name: &str) -> Option<Kind> {
        let (signed, bits) = match name {
            "Float32" => return Some(Kind::F32),
            "Float64" => return Some(Kind::F64),
            _ => match name.strip_prefix('U') {
                Some(rest) => (false, rest.strip_prefix("Int")?),
                None => (true, name.strip_prefix("Int")?),
            },
        };
        let bytes = match bits {
            "8" => 1,
            "16" => 2,
            "32" => 4,
            "64" => 8,
            _ => return None,
        };
        Some(Kind::Whole(signed, bytes))
    }

    /// Bytes of a number.
    pub(crate) fn size(self) -> usize {
        match self {
            Kind::F32 => 4,
            Kind::F64 => 8,
            Kind::Whole(_, bytes) => bytes,
        }
    }

    /// The numbers in bytes.
    pub(crate) fn decode(self, bytes: &[u8], big_endian: bool) -> Result<Values, String> {
        let size = self.size();
        if !bytes.len().is_multiple_of(size) {
            return Err("the last number is broken".to_owned());
        }
        let raw = bytes.chunks_exact(size).map(|number| {
            let add = |sum: u64, byte: &u8| sum << 8 | u64::from(*byte);
            if big_endian { number.iter().fold(0, add) } else { number.iter().rev().fold(0, add) }
        });
        let unused = 64 - 8 * size as u32;
        Ok(match self {
            Kind::F32 => Values::Float32(raw.map(|b| f32::from_bits(b as u32)).collect()),
            Kind::F64 => Values::Float64(raw.map(f64::from_bits).collect()),
            Kind::Whole(false, 1) => Values::UInt8(bytes.to_vec()),
            Kind::Whole(false, 2) => Values::Int32(raw.map(|b| b as i32).collect()),
            Kind::Whole(true, 1..=4) => {
                Values::Int32(raw.map(|b| ((b << unused) as i64 >> unused) as i32).collect())
            }
            Kind::Whole(true, _) => Values::Int64(raw.map(|b| b as i64).collect()),
            Kind::Whole(false, _) => {
                let signed = |b| i64::try_from(b).map_err(|_| format!("{b} is too large"));
                Values::Int64(raw.map(signed).collect::<Result<_, _>>()?)
            }
        })
    }

    /// The numbers in text.
    pub(crate) fn parse<'a>(self, words: impl Iterator<Item = &'a [u8]>) -> Result<Values, String> {
        fn all<'a, T: std::str::FromStr>(words: impl Iterator<Item = &'a [u8]>) -> Result<Vec<T>, String> {
            let wrong = |word: &[u8]| format!("`{}` is no such number", crate::input::shown(word));
            words.map(|word| crate::input::parse(word).ok_or_else(|| wrong(word))).collect()
        }
        Ok(match self {
            Kind::F32 => Values::Float32(all(words)?),
            Kind::F64 => Values::Float64(all(words)?),
            Kind::Whole(false, 1) => Values::UInt8(all(words)?),
            Kind::Whole(false, 2) | Kind::Whole(true, 1..=4) => Values::Int32(all(words)?),
            Kind::Whole(..) => Values::Int64(all(words)?),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_of_every_width_keep_their_sign() {
        let one = |kind: Kind, bytes: &[u8], big| kind.decode(bytes, big).unwrap();
        assert_eq!(one(Kind::Whole(true, 1), &[0xff], false), Values::Int32(vec![-1]));
        assert_eq!(one(Kind::Whole(true, 2), &[0xfe, 0xff], false), Values::Int32(vec![-2]));
        assert_eq!(one(Kind::Whole(false, 2), &[0xff, 0xfe], true), Values::Int32(vec![65534]));
        assert_eq!(one(Kind::Whole(true, 4), &[0xff; 4], true), Values::Int32(vec![-1]));
        assert_eq!(one(Kind::Whole(false, 4), &[0xff; 4], true), Values::Int64(vec![4_294_967_295]));
        assert!(Kind::Whole(false, 8).decode(&[0xff; 8], true).is_err());
        assert_eq!(one(Kind::F64, &1.5_f64.to_be_bytes(), true), Values::Float64(vec![1.5]));
        assert_eq!(Kind::named("UInt16"), Some(Kind::Whole(false, 2)));
        assert_eq!((Kind::named("Int9"), Kind::named("String")), (None, None));
    }
}
