//! Text of files whose encoding is not stated: UTF-8, UTF-16 by its mark, GB18030.

use std::borrow::Cow;

pub use encoding_rs::Encoding;
use encoding_rs::{GB18030, UTF_8};

/// The text of a file, and the encoding in which it is written.
#[derive(Debug, PartialEq)]
pub struct Text<'a> {
    /// Without a byte order mark.
    pub text: Cow<'a, str>,
    /// UTF-8 also for ASCII.
    pub encoding: &'static Encoding,
    /// Whether neither a mark nor the caller states the encoding, and UTF-8 does not fit.
    pub assumed: bool,
}

impl Text<'_> {
    /// A sentence for the user where the encoding is an assumption.
    pub fn note(&self) -> Option<String> {
        let name = self.encoding.name();
        self.assumed
            .then(|| format!("The text is not UTF-8 and was read as {name}; `encoding` states another."))
    }
}

/// The encoding of a name such as `gbk`, `big5`, `shift_jis` or `windows-1252` (the labels of the WHATWG standard), in any case.
///
/// # Errors
/// A sentence with examples of names.
pub fn encoding(name: &str) -> Result<&'static Encoding, String> {
    Encoding::for_label(name.as_bytes()).ok_or_else(|| {
        format!(
            "encoding: '{}' is not known. Use utf-8, gb18030, big5, shift_jis, euc-kr or windows-1252.",
            name.chars().filter(|c| !c.is_control()).take(40).collect::<String>()
        )
    })
}

/// Decodes bytes: by a byte order mark, else by the `declared` encoding, else as UTF-8, else as GB18030. `None` if the encoding that
/// applies has no character for some of the bytes.
pub fn decode<'a>(bytes: &'a [u8], declared: Option<&'static Encoding>) -> Option<Text<'a>> {
    if let Some((encoding, mark)) = Encoding::for_bom(bytes) {
        let text = encoding.decode_without_bom_handling_and_without_replacement(&bytes[mark..])?;
        return Some(Text { text, encoding, assumed: false });
    }
    let with = |encoding: &'static Encoding, assumed| {
        let text = encoding.decode_without_bom_handling_and_without_replacement(bytes)?;
        Some(Text { text, encoding, assumed })
    };
    match declared {
        Some(encoding) => with(encoding, false),
        None => with(UTF_8, false).or_else(|| with(GB18030, true)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use encoding_rs::{BIG5, UTF_16BE, UTF_16LE};

    fn decoded(bytes: &[u8], declared: Option<&'static Encoding>) -> Option<(String, &'static str, bool)> {
        decode(bytes, declared).map(|t| (t.text.to_string(), t.encoding.name(), t.note().is_some()))
    }

    #[test]
    fn utf_8_and_marked_utf_16_are_read_without_a_note() {
        let rock = "围岩 é\n";
        let plain = |name| Some((rock.to_owned(), name, false));
        assert_eq!(decoded(rock.as_bytes(), None), plain("UTF-8"));
        assert_eq!(decoded(&[b"\xef\xbb\xbf", rock.as_bytes()].concat(), None), plain("UTF-8"));
        let little: Vec<u8> =
            [0xfeff].into_iter().chain(rock.encode_utf16()).flat_map(u16::to_le_bytes).collect();
        assert_eq!(decoded(&little, None), plain(UTF_16LE.name()));
        let big: Vec<u8> =
            [0xfeff].into_iter().chain(rock.encode_utf16()).flat_map(u16::to_be_bytes).collect();
        assert_eq!(decoded(&big, None), plain(UTF_16BE.name()));
        assert_eq!(decoded(&little[..little.len() - 1], None), None, "half a character");
        assert_eq!(
            decoded(&little, Some(GB18030)),
            plain(UTF_16LE.name()),
            "the mark goes before what is declared"
        );
    }

    #[test]
    fn what_is_not_utf_8_is_gb18030_with_a_note_if_that_fits() {
        let gbk = b"\xce\xa7\xd1\xd2, \xb3\xc4\xc6\xf6";
        assert_eq!(decoded(gbk, None), Some(("围岩, 衬砌".into(), "gb18030", true)));
        let note = decode(gbk, None).unwrap().note().unwrap();
        assert!(note.contains("gb18030") && note.contains("`encoding`"), "{note}");
        for latin in [&b"caf\xe9"[..], b"\xe9 1", b"\xff"] {
            assert_eq!(decoded(latin, None), None, "{latin:?}");
        }
    }

    #[test]
    fn another_encoding_is_declared_by_its_name() {
        assert_eq!(decoded(b"\xb3\xf2", encoding("Big5").ok()), Some(("圍".into(), BIG5.name(), false)));
        assert_eq!(
            decoded(b"caf\xe9", encoding("latin1").ok()),
            Some(("café".into(), "windows-1252", false))
        );
        assert_eq!(decoded(b"\xff", encoding("big5").ok()), None);
        let refusal = encoding("klingon\n").unwrap_err();
        assert!(refusal.contains("'klingon'") && refusal.contains("shift_jis"), "{refusal}");
    }
}
