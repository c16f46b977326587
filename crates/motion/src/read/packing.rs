//! Files that come packed.

use std::borrow::Cow;
use std::io::Read;
use std::path::Path;

use flate2::read::MultiGzDecoder;

use crate::Error;

/// Beginnings of what is packed in other ways, the place (byte) of each, and what undoes it.
const OTHERS: [(usize, &[u8], &str); 5] = [
    (0, b"PK\x03\x04", "unzip"),
    (0, b"BZh", "bunzip2"),
    (0, b"\xfd7zXZ\0", "unxz"),
    (0, b"\x1f\x9d", "uncompress"),
    (257, b"ustar", "tar -x"),
];

const GZIP: &[u8] = &[0x1f, 0x8b];

/// The content of a file, unpacked if gzip packed it, at most `largest` bytes before and after.
///
/// # Errors
/// [`Error::Record`] for what is larger, broken, packed twice or packed by another program.
pub(super) fn unpacked<'a>(path: &Path, bytes: &'a [u8], largest: u64) -> Result<Cow<'a, [u8]>, Error> {
    let refuse = |problem: String, remedy: &str| Err(Error::record(path, 1, problem, remedy));
    let size = |bytes: u64| format!("{} MiB", bytes >> 20);
    if bytes.len() as u64 > largest {
        return refuse(format!("the file is larger than {}", size(largest)), "give a single record");
    }
    let content = if bytes.starts_with(GZIP) {
        let mut content = Vec::new();
        let unpacking = MultiGzDecoder::new(bytes).take(largest + 1).read_to_end(&mut content);
        if content.len() as u64 > largest {
            return refuse(
                format!("the file unpacks to more than {}", size(largest)),
                "this is no record; give a single one",
            );
        }
        if let Err(e) = unpacking {
            return refuse(format!("the packed file is broken: {e}"), "fetch it again");
        }
        if content.starts_with(GZIP) {
            return refuse("the file is packed twice".into(), "unpack it first (gunzip)");
        }
        Cow::Owned(content)
    } else {
        Cow::Borrowed(bytes)
    };
    match OTHERS.iter().find(|(at, magic, _)| content.get(*at..).is_some_and(|c| c.starts_with(magic))) {
        Some((_, _, program)) => refuse(
            "the file is packed in a way that is not read".into(),
            &format!("unpack it first ({program})"),
        ),
        None => Ok(content),
    }
}
