//! The numbers of an MSH file, written as text or as bytes.

use crate::fault::Fault;
use crate::input::Input;

/// How a file's numbers are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Encoding {
    Ascii,
    /// Binary, least significant byte first.
    Little,
    /// Binary, most significant byte first.
    Big,
}

/// A file with the way its numbers are written.
pub(super) struct Numbers<'i, 'a> {
    pub input: &'i mut Input<'a>,
    pub encoding: Encoding,
}

impl Numbers<'_, '_> {
    /// In a text file, goes to the next line.
    pub(super) fn begin(&mut self, wanted: &str) -> Result<(), Fault> {
        if self.encoding != Encoding::Ascii {
            return Ok(());
        }
        self.input.expect(wanted)?;
        if self.input.text().starts_with(b"$End") {
            let problem =
                format!("the section ends here, expected {wanted}; the file is cut short or damaged");
            return Err(self.input.fault(problem));
        }
        Ok(())
    }

    /// A whole number of four bytes.
    pub(super) fn tag(&mut self, what: &str) -> Result<i64, Fault> {
        match self.encoding {
            Encoding::Ascii => self.input.integer(what),
            _ => Ok(i64::from(i32::from_le_bytes(self.raw(what)?))),
        }
    }

    /// A whole number of four bytes that is not negative.
    pub(super) fn short(&mut self, what: &str) -> Result<u64, Fault> {
        match self.encoding {
            Encoding::Ascii => self.input.count(what),
            _ => {
                let number = self.tag(what)?;
                u64::try_from(number).map_err(|_| self.input.misplaced(number.to_string().as_bytes(), what))
            }
        }
    }

    /// A whole number of eight bytes that is not negative.
    pub(super) fn count(&mut self, what: &str) -> Result<u64, Fault> {
        match self.encoding {
            Encoding::Ascii => self.input.count(what),
            _ => Ok(u64::from_le_bytes(self.raw(what)?)),
        }
    }

    /// A finite real number.
    pub(super) fn real(&mut self, what: &str) -> Result<f64, Fault> {
        if self.encoding == Encoding::Ascii {
            return self.input.real(what);
        }
        let number = f64::from_le_bytes(self.raw(what)?);
        if !number.is_finite() {
            return Err(self.input.misplaced(number.to_string().as_bytes(), what));
        }
        Ok(number)
    }

    /// In a text file, checks that the line ends here.
    pub(super) fn end(&mut self) -> Result<(), Fault> {
        if self.encoding == Encoding::Ascii { self.input.done() } else { Ok(()) }
    }

    /// Passes over numbers of so many bytes in a binary file; in a text file the rest of a line costs nothing.
    pub(super) fn pass(&mut self, count: u64, bytes: u64, what: &str) -> Result<(), Fault> {
        if self.encoding == Encoding::Ascii {
            return Ok(());
        }
        // One by one: the count may be damaged, and then the file ends first.
        for _ in 0..count {
            for _ in 0..bytes / 4 {
                self.raw::<4>(what)?;
            }
        }
        Ok(())
    }

    /// The section's last line.
    pub(super) fn close(&mut self, section: &str) -> Result<(), Fault> {
        self.input.expect(&format!("$End{section}"))?;
        if self.input.text().strip_prefix(b"$End") != Some(section.as_bytes()) {
            let problem = format!(
                "the section ${section} should end here with $End{section}; its counts are wrong, or it is damaged"
            );
            return Err(self.input.fault(problem));
        }
        Ok(())
    }

    fn raw<const N: usize>(&mut self, what: &str) -> Result<[u8; N], Fault> {
        let Some(bytes) = self.input.bytes(N)? else {
            return Err(self.input.fault(format!("the file ends here, expected {what}; it is cut short")));
        };
        let mut raw = [0; N];
        raw.copy_from_slice(bytes);
        if self.encoding == Encoding::Big {
            raw.reverse();
        }
        Ok(raw)
    }
}
