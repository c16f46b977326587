//! The numbers of a legacy file, as text or as bytes.

use super::{EXPORT, Owner, Reader};
use crate::input::shown;
use crate::read::Fault;
use crate::vtu::{Array, Kind, Values, append_indices};

/// Numbers worked on at a time; a multiple of three, so that points stay whole.
const PIECE: usize = 3 << 14;
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

    /// Reads an array.
    pub(super) fn array(
        &mut self,
        name: String,
        components: usize,
        tuples: usize,
        kind: Kind,
    ) -> Result<(), Fault> {
        let values = self.numbers(self.product(components, tuples)?, kind, &format!("array `{name}`"))?;
        let arrays = match self.owner {
            Owner::File => &mut self.grid.field_data,
            Owner::Points => &mut self.grid.point_data,
            Owner::Cells => &mut self.grid.cell_data,
        };
        arrays.push(Array::new(decoded(&name), "", components, values));
        Ok(())
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
    String::from_utf8_lossy(&bytes).into_owned()
}
