//! Files that come packed.

use std::borrow::Cow;
use std::io::Read;
use std::path::Path;

use flate2::read::MultiGzDecoder;

use super::foreign;
use crate::Error;

/// Beginnings of what is packed in other ways, the place (byte) of each, its name, and what undoes it.
const OTHERS: [(usize, &[u8], &str, &str); 9] = [
    (0, b"PK\x03\x04", "zip", "unzip"),
    (0, b"BZh", "bzip2", "bunzip2"),
    (0, b"\xfd7zXZ\0", "xz", "unxz"),
    (0, b"\x1f\x9d", "compress", "uncompress"),
    (0, b"\x28\xb5\x2f\xfd", "Zstandard", "unzstd"),
    (0, b"\x04\x22\x4d\x18", "LZ4", "unlz4"),
    (0, b"7z\xbc\xaf\x27\x1c", "7-Zip", "7z x"),
    (0, b"Rar!\x1a\x07", "RAR", "unrar x"),
    (257, b"ustar", "tar", "tar -xf"),
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
    foreign::refused(path, &content)?;
    match OTHERS.iter().find(|(at, magic, ..)| content.get(*at..).is_some_and(|c| c.starts_with(magic))) {
        Some((.., name, program)) => refuse(
            format!("the file is packed by {name}, which is not read"),
            &format!("unpack it first ({program})"),
        ),
        None => Ok(content),
    }
}
