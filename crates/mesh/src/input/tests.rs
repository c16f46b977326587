use std::io::Cursor;

use super::*;

/// Gives a few bytes at a time.
struct Slow<'a>(&'a [u8], usize);

impl Read for Slow<'_> {
    fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
        let count = self.1.min(self.0.len()).min(into.len());
        into[..count].copy_from_slice(&self.0[..count]);
        self.0 = &self.0[count..];
        Ok(count)
    }
}

impl Seek for Slow<'_> {
    fn seek(&mut self, _: std::io::SeekFrom) -> std::io::Result<u64> {
        Err(ErrorKind::Unsupported.into())
    }
}

#[test]
fn lines_and_bytes_do_not_depend_on_how_the_file_comes_in() {
    let file = b"\xef\xbb\xbfone 2\r\n\n  \t\n 3.5,x\nraw\x00\n\xff end\nlast";
    for step in 1..file.len() {
        let mut input = Input::new(Slow(file, step));
        assert!(input.advance().unwrap());
        assert_eq!(input.field().unwrap(), b"one");
        assert_eq!(input.count("a number").unwrap(), 2);
        input.done().unwrap();
        input.commas = true;
        assert!(input.advance().unwrap());
        assert_eq!((input.line(), input.whole_line()), (4, b" 3.5,x".as_slice()));
        assert_eq!(input.real("a number").unwrap(), 3.5);
        assert_eq!(input.text(), b"x");
        assert_eq!(input.bytes(6).unwrap().unwrap(), b"raw\x00\n\xff");
        assert!(input.advance().unwrap());
        assert_eq!(input.text(), b"end");
        assert!(input.advance().unwrap());
        assert_eq!(input.text(), b"last");
        assert!(!input.advance().unwrap() && !input.advance().unwrap());
        assert_eq!(input.bytes(1).unwrap(), None);
    }
}

#[test]
fn numbers_are_read_exactly_or_refused() {
    assert_eq!((whole(b"18446744073709551615"), whole(b"18446744073709551616")), (Some(u64::MAX), None));
    assert_eq!((whole(b""), whole(b"-1"), whole(b"1.0")), (None, None, None));
    assert_eq!(
        (real(b"-1.5D+3"), real(b"1d0"), real(b"inf"), real(b"d")),
        (Some(-1500.0), Some(1.0), None, None)
    );
}

#[test]
fn a_wrong_field_is_named_with_its_line() {
    let mut input = Input::new(Cursor::new(b"\n12 x7 9\n"));
    input.expect("a line").unwrap();
    input.count("a count").unwrap();
    let fault = input.real("a coordinate").unwrap_err();
    assert_eq!((fault.line, fault.problem.as_str()), (Some(2), "`x7` stands where a coordinate should"));
    let fault = input.expect("another line").unwrap_err();
    assert_eq!(fault.problem, "the file ends here, expected another line; it is cut short");
}

#[test]
fn text_that_is_not_utf_8_is_latin_1() {
    assert_eq!((text("Körper".as_bytes()), text(b"K\xf6rper")), ("Körper".to_owned(), "Körper".to_owned()));
    assert_ne!(text(b"\xe4"), text(b"\xf6"));
}

#[test]
fn fortran_leaves_out_the_letter_of_an_exponent() {
    for (text, value) in [
        ("1.5-101", 1.5e-101),
        ("-1.5+101", -1.5e101),
        ("1.5-3", 1.5e-3),
        ("-.5+2", -50.0),
        ("2.5D-1", 0.25),
        ("7.E+2", 700.0),
    ] {
        assert_eq!(fortran_real(text.as_bytes()), Some(value), "{text}");
    }
    for wrong in ["", "x", "1.5-", "1.5-3-2", "-", "1e400"] {
        assert_eq!(fortran_real(wrong.as_bytes()), None, "{wrong}");
    }
}
