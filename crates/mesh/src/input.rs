//! The bytes of a mesh file in one pass: lines and the fields in them, or raw bytes. Only a piece of the
//! file is in memory at a time, so that a large mesh is not held twice.

use std::io::{ErrorKind, Read, Seek};

use tremolite_files::text::Encoding;

use crate::fault::Fault;

/// Bytes asked for at a time.
const PIECE: usize = 1 << 20;
/// Bytes by which a format is recognised.
const HEAD: usize = 1 << 16;

/// What a file is read from.
pub(crate) trait Source: Read + Seek {}

impl<T: Read + Seek> Source for T {}

/// A file being read.
pub(crate) struct Input<'a> {
    source: Box<dyn Source + 'a>,
    buffer: Vec<u8>,
    /// End of what is valid in `buffer`.
    end: usize,
    /// First byte not given yet.
    next: usize,
    /// The current line in `buffer`, without its end.
    line_start: usize,
    line_end: usize,
    /// First byte of the current line whose field has not been taken.
    cursor: usize,
    /// Number of the current line, from 1.
    line: usize,
    /// Bytes of the file before `buffer`.
    dropped: u64,
    /// Whether raw bytes were taken, so that lines have no number any more.
    raw: bool,
    ended: bool,
    /// Whether a comma separates fields as a blank does.
    pub commas: bool,
    /// The encoding that the user states; files that this one includes have the same.
    pub encoding: Option<&'static Encoding>,
    /// The encoding that was assumed, here or in an included file.
    pub assumed: Option<&'static str>,
}

impl<'a> Input<'a> {
    /// Nothing is read yet.
    pub(crate) fn new(source: impl Source + 'a) -> Self {
        Input {
            source: Box::new(source),
            buffer: Vec::new(),
            end: 0,
            next: 0,
            line_start: 0,
            line_end: 0,
            cursor: 0,
            line: 0,
            dropped: 0,
            raw: false,
            ended: false,
            commas: false,
            encoding: None,
            assumed: None,
        }
    }

    /// With the encoding that the user states.
    pub(crate) fn declared(mut self, encoding: Option<&'static Encoding>) -> Self {
        self.encoding = encoding;
        self
    }

    /// The file's beginning, without a byte order mark; only before anything else is taken.
    pub(crate) fn head(&mut self) -> Result<&[u8], Fault> {
        while self.end < HEAD && self.more()? {}
        if self.buffer[..self.end].starts_with(b"\xef\xbb\xbf") {
            self.next = 3;
        }
        Ok(&self.buffer[self.next..self.end])
    }

    /// Reads on, forgetting what has been given. False at the end of the file.
    fn more(&mut self) -> Result<bool, Fault> {
        if self.ended {
            return Ok(false);
        }
        self.buffer.copy_within(self.next..self.end, 0);
        self.dropped += self.next as u64;
        self.end -= self.next;
        self.next = 0;
        if self.buffer.len() - self.end < PIECE {
            // Doubling, so that one endless line does not cost quadratic time.
            self.buffer.resize((2 * self.end).max(2 * PIECE), 0);
        }
        loop {
            match self.source.read(&mut self.buffer[self.end..]) {
                Ok(0) => {
                    self.ended = true;
                    return Ok(false);
                }
                Ok(count) => {
                    self.end += count;
                    return Ok(true);
                }
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(Fault::whole(format!("it cannot be read: {error}"))),
            }
        }
    }

    /// Goes to the next line that is not blank. False at the end of the file.
    pub(crate) fn advance(&mut self) -> Result<bool, Fault> {
        while self.next_line()? {
            if self.cursor < self.line_end {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Goes to the next line, blank or not. False at the end of the file.
    pub(crate) fn next_line(&mut self) -> Result<bool, Fault> {
        let mut searched = 0;
        let end = loop {
            let fresh = self.next + searched;
            if let Some(length) = self.buffer[fresh..self.end].iter().position(|&b| b == b'\n') {
                break fresh + length;
            }
            searched = self.end - self.next;
            if !self.more()? {
                if self.next == self.end {
                    (self.line_start, self.line_end, self.cursor) = (self.end, self.end, self.end);
                    return Ok(false);
                }
                break self.end;
            }
        };
        let marked = self.line == 0 && self.buffer[..end].starts_with(b"\xef\xbb\xbf");
        self.line += 1;
        self.line_start = if marked { self.next.max(3) } else { self.next };
        self.next = (end + 1).min(self.end);
        self.line_end = self.line_start + self.buffer[self.line_start..end].trim_ascii_end().len();
        self.cursor = self.line_start;
        self.skip_blanks();
        Ok(true)
    }

    /// As [`Input::advance`], where there must be a line.
    pub(crate) fn expect(&mut self, wanted: &str) -> Result<(), Fault> {
        if self.advance()? {
            return Ok(());
        }
        Err(self.fault(format!("the file ends here, expected {wanted}; it is cut short")))
    }

    fn is_blank(&self, byte: u8) -> bool {
        byte.is_ascii_whitespace() || (self.commas && byte == b',')
    }

    fn skip_blanks(&mut self) {
        while self.cursor < self.line_end && self.is_blank(self.buffer[self.cursor]) {
            self.cursor += 1;
        }
    }

    /// What has not been taken of the current line.
    pub(crate) fn text(&self) -> &[u8] {
        &self.buffer[self.cursor..self.line_end]
    }

    /// The current line from its first column, without blanks at its end.
    pub(crate) fn whole_line(&self) -> &[u8] {
        &self.buffer[self.line_start..self.line_end]
    }

    /// The next field of the current line; none at its end.
    pub(crate) fn field(&mut self) -> Option<&[u8]> {
        let start = self.cursor;
        while self.cursor < self.line_end && !self.is_blank(self.buffer[self.cursor]) {
            self.cursor += 1;
        }
        let end = self.cursor;
        self.skip_blanks();
        (start < end).then(|| &self.buffer[start..end])
    }

    /// The next field, a whole number that is not negative.
    pub(crate) fn count(&mut self, what: &str) -> Result<u64, Fault> {
        self.parsed(what, whole)
    }

    /// The next field, a whole number.
    pub(crate) fn integer(&mut self, what: &str) -> Result<i64, Fault> {
        self.parsed(what, parse)
    }

    /// The next field, a finite real number.
    pub(crate) fn real(&mut self, what: &str) -> Result<f64, Fault> {
        self.parsed(what, real)
    }

    fn parsed<T>(&mut self, what: &str, parse: fn(&[u8]) -> Option<T>) -> Result<T, Fault> {
        match self.field().map(parse) {
            Some(Some(number)) => Ok(number),
            None => Err(self.fault(format!("the line ends where {what} should stand"))),
            Some(None) => {
                // The field again, for the message only: the common case does not pay for it.
                let taken = &self.buffer[self.line_start..self.cursor];
                let end = taken.iter().rposition(|&b| !self.is_blank(b)).map_or(0, |i| i + 1);
                let start = taken[..end].iter().rposition(|&b| self.is_blank(b)).map_or(0, |i| i + 1);
                Err(self.misplaced(&taken[start..end], what))
            }
        }
    }

    /// Nothing more may follow in the line.
    pub(crate) fn done(&self) -> Result<(), Fault> {
        if self.cursor == self.line_end {
            return Ok(());
        }
        Err(self.misplaced(self.text(), "the end of the line"))
    }

    /// The fault of text that is not what it should be.
    pub(crate) fn misplaced(&self, text: &[u8], what: &str) -> Fault {
        self.fault(format!("`{}` stands where {what} should", shown(text)))
    }

    /// The next raw bytes, from the end of the current line on; none if the file ends before.
    pub(crate) fn bytes(&mut self, count: usize) -> Result<Option<&[u8]>, Fault> {
        self.raw = true;
        while self.end - self.next < count {
            if !self.more()? {
                return Ok(None);
            }
        }
        let start = self.next;
        self.next += count;
        Ok(Some(&self.buffer[start..start + count]))
    }

    /// The file itself, for a format that is not read from front to back. What was taken so far is forgotten.
    pub(crate) fn source(&mut self) -> &mut (dyn Source + 'a) {
        &mut *self.source
    }

    /// Number of the current line.
    pub(crate) fn line(&self) -> usize {
        self.line
    }

    /// A fault in the current line, or at the current byte of a binary file.
    pub(crate) fn fault(&self, problem: impl Into<String>) -> Fault {
        if self.raw {
            return Fault::whole(format!(
                "near byte {}: {}",
                self.dropped + self.next as u64,
                problem.into()
            ));
        }
        Fault::at(self.line, problem)
    }
}

/// Text of a file as it may stand in a message.
pub(crate) fn shown(text: &[u8]) -> String {
    text[..text.len().min(40)].escape_ascii().to_string()
}

/// Text in UTF-8, or else in Latin-1, in which older programs write names: two of them never become one.
pub(crate) fn text(bytes: &[u8]) -> String {
    match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes.iter().copied().map(char::from).collect(),
    }
}

/// A whole number that is not negative.
pub(crate) fn whole(field: &[u8]) -> Option<u64> {
    let mut number = 0_u64;
    for &digit in field {
        if !digit.is_ascii_digit() {
            return None;
        }
        number = number.checked_mul(10)?.checked_add(u64::from(digit - b'0'))?;
    }
    (!field.is_empty()).then_some(number)
}

/// A finite real number; Fortran's `1.5D+3` too.
pub(crate) fn real(field: &[u8]) -> Option<f64> {
    let number: Option<f64> = parse(field).or_else(|| {
        let d = field.iter().position(|b| matches!(b, b'd' | b'D'))?;
        let mut field = field.get(..64).unwrap_or(field).to_vec();
        *field.get_mut(d)? = b'e';
        parse(&field)
    });
    number.filter(|x| x.is_finite())
}

/// A real number; Fortran may leave the E out before an exponent of three digits.
pub(crate) fn fortran_real(field: &[u8]) -> Option<f64> {
    real(field).or_else(|| {
        let sign = field.iter().skip(1).position(|b| matches!(b, b'+' | b'-'))? + 1;
        real(&[&field[..sign], b"e", &field[sign..]].concat())
    })
}

pub(crate) fn parse<T: std::str::FromStr>(field: &[u8]) -> Option<T> {
    std::str::from_utf8(field).ok()?.parse().ok()
}

#[cfg(test)]
mod tests;
