//! The numbers of a data array, however the file holds them: as text, base64 or raw bytes, whole or in
//! compressed blocks, in either byte order.

use std::io::{self, BufRead, BufReader, Read};

use flate2::bufread::ZlibDecoder;

use super::Values;

/// Bytes worked on at a time; a multiple of every number's size.
const PIECE: usize = 1 << 16;

/// How a file writes its arrays.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    pub big_endian: bool,
    /// Bytes of a number in the headers of arrays: 4 or 8.
    pub word: usize,
    pub compressed: bool,
}

/// What takes an array's numbers, piece by piece, so that a large one is not held twice.
pub(super) type Take<'t> = &'t mut dyn FnMut(Values) -> Result<(), String>;

/// Bytes in base64. Padding may stand in the middle, where a header was encoded on its own; blanks are passed over,
/// and anything else ends them.
pub(super) struct Base64<R> {
    from: R,
    bits: u32,
    filled: u32,
}

impl<R: BufRead> Base64<R> {
    pub(super) fn new(from: R) -> Self {
        Base64 { from, bits: 0, filled: 0 }
    }
}

impl<R: BufRead> Read for Base64<R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let mut count = 0;
        while count < into.len() {
            let text = self.from.fill_buf()?;
            if text.is_empty() {
                break;
            }
            let (mut used, mut ended) = (0, false);
            for &c in text {
                if count == into.len() {
                    break;
                }
                used += 1;
                let digit = match c {
                    b'A'..=b'Z' => c - b'A',
                    b'a'..=b'z' => c - b'a' + 26,
                    b'0'..=b'9' => c - b'0' + 52,
                    b'+' => 62,
                    b'/' => 63,
                    b'=' => {
                        (self.bits, self.filled) = (0, 0);
                        continue;
                    }
                    _ if c.is_ascii_whitespace() => continue,
                    _ => {
                        // It is left where it is, and ends every later read as well.
                        (used, ended) = (used - 1, true);
                        break;
                    }
                };
                self.bits = (self.bits << 6) | u32::from(digit);
                self.filled += 6;
                if self.filled >= 8 {
                    self.filled -= 8;
                    into[count] = (self.bits >> self.filled) as u8;
                    count += 1;
                    self.bits &= (1 << self.filled) - 1;
                }
            }
            self.from.consume(used);
            if ended {
                break;
            }
        }
        Ok(count)
    }
}

/// Numbers from bytes that come in pieces of any length.
struct Numbers<'t> {
    kind: Kind,
    big_endian: bool,
    /// The beginning of a number whose end is in the next piece.
    broken: Vec<u8>,
    take: Take<'t>,
}

impl Numbers<'_> {
    fn piece(&mut self, bytes: &[u8]) -> Result<(), String> {
        let mut all = std::mem::take(&mut self.broken);
        let bytes = if all.is_empty() {
            bytes
        } else {
            all.extend_from_slice(bytes);
            &all
        };
        let (whole, rest) = bytes.split_at(bytes.len() - bytes.len() % self.kind.size());
        self.broken = rest.to_vec();
        if whole.is_empty() { Ok(()) } else { (self.take)(self.kind.decode(whole, self.big_endian)?) }
    }

    /// All of a stream; how many bytes there were.
    fn all(&mut self, mut from: impl Read) -> Result<u64, String> {
        let mut piece = vec![0; PIECE];
        let mut total = 0;
        loop {
            match from.read(&mut piece) {
                Ok(0) => return Ok(total),
                Ok(count) => {
                    total += count as u64;
                    self.piece(&piece[..count])?;
                }
                Err(e) if e.kind() == io::ErrorKind::Interrupted => {}
                Err(e) => return Err(e.to_string()),
            }
        }
    }
}

/// Reads an array with its header, from its first byte on. Memory grows with what is really there, not with what a
/// header claims.
pub(super) fn binary(from: &mut dyn Read, layout: Layout, kind: Kind, take: Take) -> Result<(), String> {
    let short = || "the data are cut short".to_owned();
    let word = |from: &mut dyn Read| -> Result<u64, String> {
        let mut bytes = [0; 8];
        let bytes = &mut bytes[..layout.word];
        from.read_exact(bytes).map_err(|_| short())?;
        let add = |number: u64, byte: &u8| number << 8 | u64::from(*byte);
        Ok(if layout.big_endian { bytes.iter().fold(0, add) } else { bytes.iter().rev().fold(0, add) })
    };
    let mut numbers = Numbers { kind, big_endian: layout.big_endian, broken: Vec::new(), take };
    if layout.compressed {
        // Number of blocks, length of a block, length of the last one if it is shorter (else 0), and the
        // compressed length of each.
        let count = word(from)?;
        if count == 0 {
            return Ok(());
        }
        let (block, last) = (word(from)?, word(from)?);
        let mut packed = Vec::new();
        for _ in 0..count {
            packed.push(word(from)?);
        }
        for (i, &length) in packed.iter().enumerate() {
            let wanted = if last != 0 && i + 1 == packed.len() { last } else { block };
            let mut bytes = BufReader::with_capacity(PIECE, (&mut *from).take(length));
            let found = numbers
                .all(ZlibDecoder::new(&mut bytes).take(wanted.saturating_add(1)))
                .map_err(|e| format!("block {i}: {e}"))?;
            if found != wanted {
                return Err(format!("block {i} does not have {wanted} bytes"));
            }
            // What the decoder did not need.
            io::copy(&mut bytes, &mut io::sink()).map_err(|e| e.to_string())?;
            if bytes.into_inner().limit() > 0 {
                return Err(short());
            }
        }
    } else {
        let length = word(from)?;
        if numbers.all(from.take(length))? != length {
            return Err(short());
        }
    }
    if numbers.broken.is_empty() { Ok(()) } else { Err("the last number is broken".to_owned()) }
}

/// Reads an array written as text.
pub(super) fn text(from: &mut dyn Read, kind: Kind, take: Take) -> Result<(), String> {
    let mut all = Vec::new();
    let mut broken = 0;
    loop {
        all.truncate(broken);
        let more = from.take(PIECE as u64).read_to_end(&mut all).map_err(|e| e.to_string())?;
        // The last word may go on in the next piece.
        let end = match all.iter().rposition(u8::is_ascii_whitespace) {
            _ if more == 0 => all.len(),
            Some(end) => end,
            None => 0,
        };
        let words = all[..end].split(u8::is_ascii_whitespace).filter(|w| !w.is_empty());
        take(kind.parse(words)?)?;
        if more == 0 {
            return Ok(());
        }
        all.copy_within(end.., 0);
        broken = all.len() - end;
    }
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
    fn base64_is_decoded_across_padding_however_much_is_asked_for() {
        for (text, exact) in [
            // RFC 4648, section 10.
            (b"Zm9vYmFy".as_slice(), b"foobar".as_slice()),
            (b"Zm9v\n Yg==Zm8=Zg==", b"foobfof"),
            (b"Zm9v*Zm9v", b"foo"),
            (b"Z*", b""),
        ] {
            for step in 1..9 {
                let mut reader = Base64::new(text);
                let mut all = Vec::new();
                while (&mut reader).take(step).read_to_end(&mut all).unwrap() > 0 {}
                assert_eq!(all, exact, "{step}");
            }
        }
    }

    #[test]
    fn words_and_numbers_go_on_from_piece_to_piece() {
        let words: Vec<String> = (0..30_000).map(|n| format!("{n}")).collect();
        let mut all = Vec::new();
        let mut take = |values: Values| {
            all.extend((0..values.len()).map(|i| values.get(i)));
            Ok(())
        };
        text(&mut words.join(" \n").as_bytes(), Kind::Whole(true, 4), &mut take).unwrap();
        let mut numbers =
            Numbers { kind: Kind::Whole(true, 4), big_endian: false, broken: Vec::new(), take: &mut take };
        let bytes: Vec<u8> = (0..1000).flat_map(i32::to_le_bytes).collect();
        bytes.chunks(7).for_each(|piece| numbers.piece(piece).unwrap());
        assert!(numbers.broken.is_empty());
        let wanted: Vec<f64> = (0..30_000).chain(0..1000).map(f64::from).collect();
        assert!(all == wanted);
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
