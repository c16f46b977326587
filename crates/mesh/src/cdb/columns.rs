//! Numbers in fixed columns, as Fortran formats give them.

use crate::fault::Fault;
use crate::input::{Input, parse};

/// Columns of a block: whole numbers, then real ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Columns {
    pub integers: usize,
    integer_width: usize,
    real_width: usize,
}

impl Columns {
    /// Reads the line with the block's format, such as `(3i9,6e21.13e3)`.
    pub(super) fn read(input: &mut Input) -> Result<Self, Fault> {
        input.expect("the format of the block")?;
        Self::parse(input.text())
            .ok_or_else(|| input.misplaced(input.text(), "a format such as (3i9,6e21.13e3)"))
    }

    fn parse(text: &[u8]) -> Option<Self> {
        let text = std::str::from_utf8(text).ok()?.to_ascii_lowercase();
        let mut parts = text.strip_prefix('(')?.split(')').next()?.split(',');
        let (count, width) = parts.next()?.split_once('i')?;
        let integers = if count.is_empty() { 1 } else { count.trim().parse().ok()? };
        let integer_width = width.trim().parse().ok()?;
        let real_width = match parts.next().and_then(|part| part.split_once(['e', 'g', 'f'])) {
            Some((_, width)) => width.split('.').next()?.trim().parse().ok()?,
            None => 0,
        };
        let good = (1..=100).contains(&integers) && (1..=100).contains(&integer_width) && real_width <= 100;
        good.then_some(Columns { integers, integer_width, real_width })
    }

    /// The whole number in column `k`, without blanks; none beyond the line's end or where it is blank.
    pub(super) fn integer<'l>(&self, line: &'l [u8], k: usize) -> Option<&'l [u8]> {
        cut(line, k * self.integer_width, self.integer_width).filter(|field| !field.is_empty())
    }

    /// The real number in column `k` of those after the whole numbers; none beyond the line's end.
    pub(super) fn real<'l>(&self, line: &'l [u8], k: usize) -> Option<&'l [u8]> {
        cut(line, self.integers * self.integer_width + k * self.real_width, self.real_width)
    }
}

fn cut(line: &[u8], start: usize, width: usize) -> Option<&[u8]> {
    Some(line.get(start..)?.get(..width).unwrap_or(&line[start..]).trim_ascii())
        .filter(|_| start < line.len())
}

/// A whole number with a sign.
pub(super) fn integer(field: &[u8]) -> Option<i64> {
    parse(field)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_of_all_releases_are_understood() {
        let columns =
            |integers, integer_width, real_width| Some(Columns { integers, integer_width, real_width });
        assert_eq!(Columns::parse(b"(3i9,6e21.13e3)"), columns(3, 9, 21));
        assert_eq!(Columns::parse(b"(1i9,3e20.9e3)"), columns(1, 9, 20));
        assert_eq!(Columns::parse(b"(3I8,6E16.9)"), columns(3, 8, 16));
        assert_eq!(Columns::parse(b"(i8,6g16.9)"), columns(1, 8, 16));
        assert_eq!(Columns::parse(b"(19i10)"), columns(19, 10, 0));
        for wrong in ["", "(", "(i)", "3i9", "(3i9,6e)", "(0i9)", "(3i0)", "(999999999i9)", "(3x9)"] {
            assert_eq!(Columns::parse(wrong.as_bytes()), None, "{wrong}");
        }
    }

    #[test]
    fn fields_touch_and_end_early() {
        let columns = Columns { integers: 2, integer_width: 3, real_width: 8 };
        let line = b" 12345 1.5E+00-2.5E+00 3";
        assert_eq!(
            (columns.integer(line, 0), columns.integer(line, 1)),
            (Some(b"12".as_slice()), Some(b"345".as_slice()))
        );
        let reals = [0, 1, 2, 3].map(|k| columns.real(line, k));
        assert_eq!(reals, [Some(b"1.5E+00".as_slice()), Some(b"-2.5E+00"), Some(b"3"), None]);
    }
}
