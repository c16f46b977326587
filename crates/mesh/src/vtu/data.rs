//! The numbers of a data array, however the file holds them: as text, base64 or raw bytes, whole or in
//! compressed blocks, in either byte order.

use std::borrow::Cow;
use std::io::Read;

use flate2::read::ZlibDecoder;

use super::Values;

/// How a file writes its arrays.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    pub big_endian: bool,
    /// Bytes of a number in the headers of arrays: 4 or 8.
    pub word: usize,
    pub compressed: bool,
}

/// The bytes of an array and its header.
pub(super) enum Source<'a> {
    Raw(&'a [u8]),
    Base64(&'a [u8]),
}

impl Source<'_> {
    /// The first `count` bytes; none if there are fewer.
    fn first(&self, count: usize) -> Option<Cow<'_, [u8]>> {
        match self {
            Source::Raw(bytes) => bytes.get(..count).map(Cow::Borrowed),
            Source::Base64(text) => {
                let bytes = base64(text, count);
                (bytes.len() == count).then_some(Cow::Owned(bytes))
            }
        }
    }
}

/// Decodes base64 until `limit` bytes are there or the text ends. Padding may stand in the middle, where a
/// header was encoded on its own; blanks are passed over.
fn base64(text: &[u8], limit: usize) -> Vec<u8> {
    let mut bytes = Vec::new();
    let (mut bits, mut filled) = (0_u32, 0);
    for &c in text {
        if bytes.len() >= limit {
            break;
        }
        let digit = match c {
            b'A'..=b'Z' => c - b'A',
            b'a'..=b'z' => c - b'a' + 26,
            b'0'..=b'9' => c - b'0' + 52,
            b'+' => 62,
            b'/' => 63,
            b'=' => {
                (bits, filled) = (0, 0);
                continue;
            }
            _ if c.is_ascii_whitespace() => continue,
            _ => break,
        };
        bits = (bits << 6) | u32::from(digit);
        filled += 6;
        if filled >= 8 {
            filled -= 8;
            bytes.push((bits >> filled) as u8);
            bits &= (1 << filled) - 1;
        }
    }
    bytes.truncate(limit);
    bytes
}

/// The bytes of an array without its header, uncompressed. Memory grows with what is really there, not with
/// what a header claims.
pub(super) fn bytes(source: &Source, layout: Layout) -> Result<Vec<u8>, String> {
    let short = || "the data are cut short".to_owned();
    let word = |bytes: &[u8], i: usize| -> Result<usize, String> {
        let bytes = bytes.get(i * layout.word..(i + 1) * layout.word).ok_or_else(short)?;
        let add = |number: u64, byte: &u8| number << 8 | u64::from(*byte);
        let number =
            if layout.big_endian { bytes.iter().fold(0, add) } else { bytes.iter().rev().fold(0, add) };
        usize::try_from(number).map_err(|_| short())
    };
    let size = |words: usize, more: usize| words.checked_mul(layout.word)?.checked_add(more);
    let first = |count: Option<usize>| count.and_then(|c| source.first(c)).ok_or_else(short);
    if !layout.compressed {
        let length = word(&first(size(1, 0))?, 0)?;
        return Ok(first(size(1, length))?[layout.word..].to_vec());
    }
    // Number of blocks, length of a block, length of the last one if it is shorter (else 0), and the
    // compressed length of each.
    let head = first(size(1, 0))?;
    let count = word(&head, 0)?;
    let words = count.checked_add(3).ok_or_else(short)?;
    let head = if count == 0 { return Ok(Vec::new()) } else { first(size(words, 0))? };
    let (block, last) = (word(&head, 1)?, word(&head, 2)?);
    let mut total = 0_usize;
    for i in 0..count {
        total = total.checked_add(word(&head, 3 + i)?).ok_or_else(short)?;
    }
    let all = first(size(words, total))?;
    let mut rest = &all[words * layout.word..];
    let mut out = Vec::new();
    for i in 0..count {
        let (packed, tail) = rest.split_at(word(&head, 3 + i)?);
        rest = tail;
        let wanted = if last != 0 && i + 1 == count { last } else { block };
        let before = out.len();
        ZlibDecoder::new(packed)
            .take((wanted as u64).saturating_add(1))
            .read_to_end(&mut out)
            .map_err(|e| format!("block {i}: {e}"))?;
        if out.len() - before != wanted {
            return Err(format!("block {i} does not have {wanted} bytes"));
        }
    }
    Ok(out)
}

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
    fn base64_is_decoded_across_padding() {
        // RFC 4648, section 10.
        assert_eq!(base64(b"Zm9vYmFy", 99), b"foobar");
        assert_eq!(base64(b"Zm9v\n Yg==Zm8=Zg==", 99), b"foobfof");
        assert_eq!((base64(b"Zm9vYmFy", 4), base64(b"Z*", 9)), (b"foob".to_vec(), vec![]));
    }

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
