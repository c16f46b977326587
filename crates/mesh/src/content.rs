//! The content of a mesh file: unpacked where gzip packed it, and text in UTF-8.

use std::io::{self, Cursor, Read};

use flate2::read::MultiGzDecoder;
use tremolite_files::text::{Encoding, decode};

use crate::fault::Fault;
use crate::input::{Input, Source};

/// The first bytes of a packed file.
const GZIP: [u8; 2] = [0x1f, 0x8b];
/// Most bytes that a packed file may hold: the unpacked content is in memory.
const LARGEST: u64 = 1 << 32;

/// The input of a file. Text that is not UTF-8 is decoded: by its byte order mark, by the `declared` encoding, or as
/// GB18030 if that fits. Text that fits none stays as it is.
///
/// # Errors
/// If the packed content is broken, larger than [`LARGEST`] or packed again, or text is not in the declared encoding.
pub(crate) fn open<'a>(
    source: impl Source + 'a,
    declared: Option<&'static Encoding>,
) -> Result<Input<'a>, Fault> {
    let mut source: Box<dyn Source + 'a> = Box::new(source);
    let unread = |e: io::Error| Fault::whole(format!("it cannot be read: {e}"));
    if begins(&mut *source).map_err(unread)? == GZIP {
        source = Box::new(Cursor::new(unpacked(&mut *source)?));
    }
    let mut bytes = Vec::new();
    let text = Text::of(&mut *source).map_err(unread)?;
    let marked = matches!(begins(&mut *source).map_err(unread)?, [0xff, 0xfe] | [0xfe, 0xff]);
    let plain = if declared.is_some() { text.ascii } else { text.utf_8 };
    if !marked && (plain || text.binary) {
        return Ok(Input::new(source).declared(declared));
    }
    source.read_to_end(&mut bytes).map_err(unread)?;
    match decode(&bytes, declared) {
        Some(found) => {
            let assumed = found.assumed.then(|| found.encoding.name());
            let content = Cursor::new(found.text.into_owned().into_bytes());
            let mut input = Input::new(content).declared(declared);
            input.assumed = assumed;
            Ok(input)
        }
        None => match declared {
            Some(encoding) => Err(Fault::whole(format!(
                "the text is not {}; state another encoding, or write it in UTF-8",
                encoding.name()
            ))),
            None => Ok(Input::new(Cursor::new(bytes))),
        },
    }
}

/// The first two bytes, and back to the beginning.
fn begins(source: &mut dyn Source) -> io::Result<[u8; 2]> {
    let mut head = Vec::new();
    source.rewind()?;
    Read::take(&mut *source, 2).read_to_end(&mut head)?;
    source.rewind()?;
    Ok([head.first().copied().unwrap_or(0), head.get(1).copied().unwrap_or(0)])
}

fn unpacked(source: &mut dyn Source) -> Result<Vec<u8>, Fault> {
    let broken = |e| Fault::whole(format!("the packed file is broken ({e}); fetch or pack it again"));
    let mut content = Vec::new();
    MultiGzDecoder::new(source).take(LARGEST + 1).read_to_end(&mut content).map_err(broken)?;
    if content.len() as u64 > LARGEST {
        let most = LARGEST >> 30;
        return Err(Fault::whole(format!(
            "the file unpacks to more than {most} GiB; unpack it first (gunzip)"
        )));
    }
    if content.starts_with(&GZIP) {
        return Err(Fault::whole("the file is packed twice; unpack it first (gunzip)"));
    }
    Ok(content)
}

/// What bytes are as text.
#[derive(Debug, PartialEq)]
struct Text {
    ascii: bool,
    utf_8: bool,
    /// Whether there is a zero.
    binary: bool,
}

impl Text {
    /// Reads up to the end or to the first zero, with little in memory.
    fn of(source: &mut dyn Source) -> io::Result<Self> {
        let mut text = Text { ascii: true, utf_8: true, binary: false };
        let mut buffer = vec![0; 1 << 18];
        // The beginning of a character whose end comes in the next piece.
        let mut begun: Vec<u8> = Vec::new();
        loop {
            let count = match source.read(&mut buffer) {
                Ok(0) => break,
                Ok(count) => count,
                Err(e) if e.kind() == io::ErrorKind::Interrupted => continue,
                Err(e) => return Err(e),
            };
            let piece = &buffer[..count];
            if piece.contains(&0) {
                text.binary = true;
                break;
            }
            text.ascii &= piece.is_ascii();
            if !text.utf_8 || (begun.is_empty() && piece.is_ascii()) {
                continue;
            }
            begun.extend_from_slice(piece);
            match std::str::from_utf8(&begun) {
                Ok(_) => begun.clear(),
                Err(e) if e.error_len().is_none() => drop(begun.drain(..e.valid_up_to())),
                Err(_) => text.utf_8 = false,
            }
        }
        text.utf_8 &= begun.is_empty();
        Ok(text)
    }
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use flate2::Compression;
    use flate2::write::GzEncoder;
    use tremolite_files::text::encoding;

    use super::*;

    fn packed(bytes: &[u8]) -> Vec<u8> {
        let mut out = GzEncoder::new(Vec::new(), Compression::fast());
        out.write_all(bytes).unwrap();
        out.finish().unwrap()
    }

    fn head(bytes: &[u8], declared: Option<&'static Encoding>) -> Result<Vec<u8>, String> {
        let mut input = open(Cursor::new(bytes), declared).map_err(|fault| fault.problem)?;
        input.head().map(<[u8]>::to_vec).map_err(|fault| fault.problem)
    }

    #[test]
    fn content_is_what_was_packed_and_broken_packing_is_refused() {
        let good = packed(b"$MeshFormat\n");
        assert_eq!(head(&good, None).unwrap(), b"$MeshFormat\n");
        assert_eq!(head(&[packed(b"one "), packed(b"two")].concat(), None).unwrap(), b"one two");
        assert_eq!(head(b"plain", None).unwrap(), b"plain");
        for end in 2..good.len() {
            assert!(head(&good[..end], None).unwrap_err().contains("the packed file is broken"), "{end}");
        }
        assert!(head(&packed(&good), None).unwrap_err().contains("packed twice"));
    }

    #[test]
    fn text_is_decoded_and_binary_content_stays_as_it_is() {
        let rock = "ZGROUP 围岩\n";
        let utf_16: Vec<u8> =
            [0xfeff].into_iter().chain(rock.encode_utf16()).flat_map(u16::to_le_bytes).collect();
        let gbk = b"ZGROUP \xce\xa7\xd1\xd2\n";
        let big_5 = b"ZGROUP \xb3\xf2\n";
        for bytes in [rock.as_bytes(), &utf_16, gbk, &packed(gbk)] {
            assert_eq!(head(bytes, None).unwrap(), rock.as_bytes());
        }
        assert_eq!(head(big_5, encoding("big5").ok()).unwrap(), "ZGROUP 圍\n".as_bytes());
        assert!(head(b"\xff\n", encoding("big5").ok()).unwrap_err().contains("the text is not Big5"));
        // Latin-1 has no mark, and GB18030 does not fit; a zero is no text.
        for bytes in [&b"caf\xe9"[..], b"\xce\xa7\0"] {
            assert_eq!(head(bytes, None).unwrap(), bytes);
        }
        assert_eq!(open(Cursor::new(gbk), None).ok().and_then(|input| input.assumed), Some("gb18030"));
    }

    #[test]
    fn a_character_may_be_cut_between_two_pieces() {
        for before in (1 << 18) - 4..(1 << 18) + 1 {
            let bytes = ["x".repeat(before).as_bytes(), "围".as_bytes()].concat();
            let text = Text::of(&mut Cursor::new(&bytes)).unwrap();
            assert_eq!(text, Text { ascii: false, utf_8: true, binary: false });
            assert!(!Text::of(&mut Cursor::new(&bytes[..before + 2])).unwrap().utf_8);
        }
    }
}
