//! The numbers of a legacy file, as text or as bytes.

use super::{EXPORT, Owner, Reader};
use crate::fault::Fault;
use crate::input::{shown, text};
use crate::vtu::{Array, Kind, Values, append_indices, means_something};

/// Numbers worked on at a time; a multiple of three, so that points stay whole.
const PIECE: usize = 3 << 14;
/// What an array holds.
#[derive(Clone, Copy)]
pub(super) enum Content {
    Numbers(Kind),
    Bits,
    Colours,
    Texts,
}

impl Reader<'_, '_> {
    pub(super) fn kind(&mut self) -> Result<Kind, Fault> {
        let name = self.word("a type of number")?;
        let xml = match name.to_lowercase().as_str() {
            "float" => "Float32",
            "double" => "Float64",
            "char" | "signed_char" | "vtktypeint8" => "Int8",
            "unsigned_char" | "vtktypeuint8" => "UInt8",
            "short" | "vtktypeint16" => "Int16",
            "unsigned_short" | "vtktypeuint16" => "UInt16",
            "int" | "vtkidtype" | "vtktypeint32" => "Int32",
            "unsigned_int" | "vtktypeuint32" => "UInt32",
            "long" | "vtktypeint64" => "Int64",
            "unsigned_long" | "vtktypeuint64" => "UInt64",
            _ => {
                return Err(self
                    .input
                    .fault(format!("arrays of type `{}` cannot be read; {EXPORT}", shown(name.as_bytes()))));
            }
        };
        Kind::named(xml).ok_or_else(|| self.input.fault("the type of numbers is unknown"))
    }

    /// So many numbers, from the next line on, given to `take` piece by piece.
    pub(super) fn pieces(
        &mut self,
        count: usize,
        kind: Kind,
        what: &str,
        take: &mut dyn FnMut(Values) -> Result<(), String>,
    ) -> Result<(), Fault> {
        let mut bytes = Vec::new();
        let mut left = count;
        while left > 0 {
            let piece = left.min(PIECE);
            left -= piece;
            let values = if self.binary {
                let Some(numbers) = self.input.bytes(piece * kind.size())? else {
                    return Err(self.input.fault(format!("the file ends in {what}; it is cut short")));
                };
                kind.decode(numbers, true)
            } else {
                bytes.clear();
                let mut words = 0;
                while words < piece {
                    match self.input.field() {
                        Some(word) => {
                            bytes.extend_from_slice(word);
                            bytes.push(b' ');
                            words += 1;
                        }
                        None => self.input.expect(what)?,
                    }
                }
                kind.parse(bytes.split(|&b| b == b' ').filter(|w| !w.is_empty()))
            };
            values
                .and_then(&mut *take)
                .map_err(|problem| self.input.fault(format!("in {what}: {problem}")))?;
        }
        Ok(())
    }

    pub(super) fn numbers(&mut self, count: usize, kind: Kind, what: &str) -> Result<Values, Fault> {
        let mut all = None;
        self.pieces(count, kind, what, &mut |values| {
            match &mut all {
                None => all = Some(values),
                Some(all) => drop(Values::append(all, &values)),
            }
            Ok(())
        })?;
        match all {
            Some(values) => Ok(values),
            None => kind.decode(&[], true).map_err(|problem| self.input.fault(problem)),
        }
    }

    pub(super) fn whole_numbers(&mut self, count: usize, kind: Kind, what: &str) -> Result<Vec<u32>, Fault> {
        let mut all = Vec::new();
        self.pieces(count, kind, what, &mut |values| append_indices(&mut all, &values))?;
        Ok(all)
    }

    pub(super) fn product(&self, a: usize, b: usize) -> Result<usize, Fault> {
        a.checked_mul(b).ok_or_else(|| self.input.fault(format!("{a} times {b} numbers are too many")))
    }

    /// What the array at hand holds.
    pub(super) fn content(&mut self) -> Result<Content, Fault> {
        match self.input.text().split(u8::is_ascii_whitespace).next().unwrap_or_default() {
            b"string" => self.word("a type").map(|_| Content::Texts),
            b"bit" => self.word("a type").map(|_| Content::Bits),
            _ => self.kind().map(Content::Numbers),
        }
    }

    /// Reads an array; one that says nothing about the mesh is passed over.
    pub(super) fn array(
        &mut self,
        name: &str,
        components: usize,
        tuples: usize,
        content: Content,
    ) -> Result<(), Fault> {
        let count = self.product(components, tuples)?;
        let name = decoded(name);
        let what = format!("array `{name}`");
        let byte = Kind::Whole(false, 1);
        let kind = match content {
            Content::Texts => return self.pass_texts(count, &what),
            Content::Bits => {
                // Eight to a byte.
                let count = if self.binary { count.div_ceil(8) } else { count };
                return self.pieces(count, byte, &what, &mut |_| Ok(()));
            }
            // Bytes in a binary file, shares of 1 in a text file.
            Content::Colours => {
                if self.binary {
                    byte
                } else {
                    Kind::F32
                }
            }
            Content::Numbers(kind) => kind,
        };
        if !means_something(&name) {
            return self.pieces(count, kind, &what, &mut |_| Ok(()));
        }
        let values = self.numbers(count, kind, &what)?;
        let arrays = match self.owner {
            Owner::File => &mut self.grid.field_data,
            Owner::Points => &mut self.grid.point_data,
            Owner::Cells => &mut self.grid.cell_data,
        };
        arrays.push(Array::new(name, "", components, values));
        Ok(())
    }

    /// Passes over texts: lines, or in a binary file bytes after their number, whose first two bits say of how many
    /// bytes it is.
    fn pass_texts(&mut self, count: usize, what: &str) -> Result<(), Fault> {
        for _ in 0..count {
            if !self.binary {
                if !self.input.next_line()? {
                    return Err(self.input.fault(format!("the file ends in {what}; it is cut short")));
                }
                continue;
            }
            let first = self.byte(what)?;
            let more = match first >> 6 {
                3 => 0,
                2 => 1,
                1 => 3,
                _ => 7,
            };
            let mut length = u64::from(first & 0x3f);
            for _ in 0..more {
                length = length << 8 | u64::from(self.byte(what)?);
            }
            for _ in 0..length {
                self.byte(what)?;
            }
        }
        Ok(())
    }

    fn byte(&mut self, what: &str) -> Result<u8, Fault> {
        match self.input.bytes(1)?.and_then(|b| b.first().copied()) {
            Some(byte) => Ok(byte),
            None => Err(self.input.fault(format!("the file ends in {what}; it is cut short"))),
        }
    }
}

/// Names have `%20` for a blank.
fn decoded(name: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = name.as_bytes();
    while let Some((&byte, tail)) = rest.split_first() {
        let code = tail.get(..2).filter(|_| byte == b'%').and_then(|hex| std::str::from_utf8(hex).ok());
        match code.and_then(|hex| u8::from_str_radix(hex, 16).ok()) {
            Some(code) => {
                bytes.push(code);
                rest = &tail[2..];
            }
            None => {
                bytes.push(byte);
                rest = tail;
            }
        }
    }
    text(&bytes)
}
