//! The numbers of a data array, however the file holds them: as text, base64 or raw bytes, whole or in
//! compressed blocks, in either byte order.

use std::io::{self, BufReader, Read};

use flate2::bufread::ZlibDecoder;

use super::{Kind, Values};

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

#[cfg(test)]
mod tests {
    use super::*;

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
}
