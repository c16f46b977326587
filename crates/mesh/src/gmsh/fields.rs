//! Lines and the numbers in them, without a copy.

use crate::read::Fault;

/// The lines of a piece of a file that are not blank.
pub(super) struct Lines<'a> {
    rest: &'a [u8],
    /// Number of the line last given, from 1.
    number: usize,
}

impl<'a> Lines<'a> {
    /// The lines of `rest`, which begins after line `before` of the file.
    pub(super) fn after(before: usize, rest: &'a [u8]) -> Self {
        Lines { rest, number: before }
    }

    /// What has not been given yet.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.rest
    }

    /// The next line of a section that must have one.
    ///
    /// # Errors
    /// That the section ends before `wanted`.
    pub(super) fn expect(&mut self, wanted: &str) -> Result<Fields<'a>, Fault> {
        let line = self.number;
        self.next().ok_or_else(|| {
            Fault::at(
                line,
                format!("the section ends here, expected {wanted}; the file is cut short or damaged"),
            )
        })
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Fields<'a>;

    fn next(&mut self) -> Option<Fields<'a>> {
        while !self.rest.is_empty() {
            let end = self.rest.iter().position(|&b| b == b'\n');
            let (line, rest) = match end {
                Some(end) => (&self.rest[..end], &self.rest[end + 1..]),
                None => (self.rest, &self.rest[self.rest.len()..]),
            };
            self.rest = rest;
            self.number += 1;
            let line = line.trim_ascii();
            if !line.is_empty() {
                return Some(Fields { text: line, line: self.number });
            }
        }
        None
    }
}

/// The fields of a line.
#[derive(Clone, Copy)]
pub(super) struct Fields<'a> {
    /// What has not been taken yet, without blanks at either end.
    pub text: &'a [u8],
    /// Number of the line in the file, from 1.
    pub line: usize,
}

impl<'a> Fields<'a> {
    /// The next field.
    fn field(&mut self, what: &str) -> Result<&'a [u8], Fault> {
        if self.text.is_empty() {
            return Err(Fault::at(self.line, format!("the line ends where {what} should stand")));
        }
        let end = self.text.iter().position(u8::is_ascii_whitespace).unwrap_or(self.text.len());
        let (field, rest) = self.text.split_at(end);
        self.text = rest.trim_ascii_start();
        Ok(field)
    }

    /// The next field, a whole number that is not negative.
    pub(super) fn count(&mut self, what: &str) -> Result<u64, Fault> {
        let field = self.field(what)?;
        let mut number = 0_u64;
        for &digit in field {
            number = (digit.is_ascii_digit())
                .then(|| number.checked_mul(10)?.checked_add(u64::from(digit - b'0')))
                .flatten()
                .ok_or_else(|| self.not(field, what))?;
        }
        Ok(number)
    }

    /// The next field, a whole number.
    pub(super) fn integer(&mut self, what: &str) -> Result<i64, Fault> {
        let field = self.field(what)?;
        parsed(field).ok_or_else(|| self.not(field, what))
    }

    /// The next field, a finite real number.
    pub(super) fn real(&mut self, what: &str) -> Result<f64, Fault> {
        let field = self.field(what)?;
        parsed(field).filter(|x: &f64| x.is_finite()).ok_or_else(|| self.not(field, what))
    }

    /// Nothing more may follow.
    pub(super) fn end(self) -> Result<(), Fault> {
        if self.text.is_empty() { Ok(()) } else { Err(self.not(self.text, "the end of the line")) }
    }

    /// The fault of a field that is not what it should be.
    fn not(&self, field: &[u8], what: &str) -> Fault {
        let shown = &field[..field.len().min(40)];
        Fault::at(self.line, format!("`{}` stands where {what} should", shown.escape_ascii()))
    }
}

fn parsed<T: std::str::FromStr>(field: &[u8]) -> Option<T> {
    std::str::from_utf8(field).ok()?.parse().ok()
}
