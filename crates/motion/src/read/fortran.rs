//! Formats of Fortran that headers state: `(8F10.5)`, `(10I8)`, `(1P,5E15.7)`.

use super::source::Columns;

/// The columns of the first format in parentheses in a line; `None` if there is none, or one of several kinds of numbers.
///
/// Numbers of such a format are taken to be printed with their decimal points and exponents, as Fortran prints them, so that
/// the digits behind the point and the scale factor (`1P`) say nothing more.
pub(super) fn columns(line: &str) -> Option<Columns> {
    line.split('(').skip(1).find_map(|rest| plain(rest.split_once(')')?.0))
}

/// `8F10.5`: how many, a letter, and the width.
fn plain(format: &str) -> Option<Columns> {
    let format: String = format.chars().filter(|c| *c != ' ').collect::<String>().to_ascii_uppercase();
    let scaled = |(scale, rest): (&str, &str)| {
        let digits = scale.trim_start_matches(['+', '-']);
        let is_scale = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
        is_scale.then(|| rest.trim_start_matches(',').to_string())
    };
    let format = format.split_once('P').map_or(Some(format.clone()), scaled)?;
    let at = format.find(|c: char| !c.is_ascii_digit())?;
    let (count, rest) = format.split_at(at);
    let rest = rest.strip_prefix(['I', 'F', 'E', 'D', 'G'])?;
    let width = rest.split('.').next()?;
    let per_line = if count.is_empty() { 1 } else { count.parse().ok()? };
    let width = width.parse().ok()?;
    // Lines of numbers are short; absurd columns could not be told from places in a line.
    let sound = (1..=1000).contains(&per_line) && (1..=100).contains(&width);
    sound.then_some(Columns { per_line, width })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_are_read_as_fortran_means_them() {
        for (line, found) in [
            (" 100 values on 10 lines, Format= (10I8)", Some((10, 8))),
            ("units=cm/sec2(04),Format=(8F10.5)", Some((8, 10))),
            ("Format=(1E15.6)", Some((1, 15))),
            ("Format: (8f9.6)", Some((8, 9))),
            ("(1P, 5E15.7)", Some((5, 15))),
            ("(1P5E15.7)", Some((5, 15))),
            ("(E15.7)", Some((1, 15))),
            ("(8F10.5", None),
            ("(8A10)", None),
            ("(0F10.5)", None),
            ("(8F0)", None),
            ("(99999999999999999999F10.5)", None),
            ("(UNITS: CM)", None),
            ("()", None),
            ("(é)", None),
        ] {
            let found = found.map(|(per_line, width)| Columns { per_line, width });
            assert_eq!(columns(line), found, "{line}");
        }
    }
}
