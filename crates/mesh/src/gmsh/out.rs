//! Numbers of an MSH file on their way out, as text or as bytes.

use std::io::{self, Write};

use crate::shortest::Shortest;

/// Numbers as text or as bytes.
pub(super) struct Out<'a> {
    pub out: &'a mut dyn Write,
    pub binary: bool,
    /// Whether a line begins.
    pub fresh: bool,
}

impl Out<'_> {
    pub(super) fn text(&mut self, text: &str) -> io::Result<()> {
        if !self.fresh {
            self.end()?;
        }
        writeln!(self.out, "{text}")
    }

    fn gap(&mut self) -> io::Result<()> {
        if !std::mem::replace(&mut self.fresh, false) {
            self.out.write_all(b" ")?;
        }
        Ok(())
    }

    pub(super) fn tag(&mut self, number: u32) -> io::Result<()> {
        if self.binary {
            return self.out.write_all(&number.to_le_bytes());
        }
        self.gap()?;
        write!(self.out, "{number}")
    }

    pub(super) fn count(&mut self, number: u64) -> io::Result<()> {
        if self.binary {
            return self.out.write_all(&number.to_le_bytes());
        }
        self.gap()?;
        write!(self.out, "{number}")
    }

    pub(super) fn real(&mut self, x: f64) -> io::Result<()> {
        if self.binary {
            return self.out.write_all(&x.to_le_bytes());
        }
        self.gap()?;
        write!(self.out, "{}", Shortest(x))
    }

    /// The end of a line of a text file.
    pub(super) fn end(&mut self) -> io::Result<()> {
        self.fresh = true;
        if self.binary { Ok(()) } else { writeln!(self.out) }
    }

    /// The last line of a section of numbers.
    pub(super) fn close(&mut self, section: &str) -> io::Result<()> {
        if self.binary {
            writeln!(self.out)?;
        }
        self.text(&format!("$End{section}"))
    }
}
