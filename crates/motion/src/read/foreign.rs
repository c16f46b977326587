//! Files that are no records of a format read here, by their beginnings: what each is, and one way on.

use std::path::Path;

use super::source::Source;
use crate::Error;

/// Place (byte) and beginning of a kind of file, what it is, and the way on. The commands were run with ObsPy 1.5, SciPy 1.17, h5py 3.16.
const KINDS: &[(usize, &[u8], &str, &str)] = &[
    (
        0,
        b"\x93NUMPY",
        "a NumPy array (.npy)",
        "write it as text: numpy.savetxt(\"record.txt\", numpy.load(\"record.npy\"))",
    ),
    (
        0,
        b"MATLAB 5.0 MAT-file",
        "a MATLAB file (.mat)",
        "write the array as text: numpy.savetxt(\"record.txt\", scipy.io.loadmat(\"record.mat\")[\"NAME\"])",
    ),
    (0, b"MATLAB 7.3 MAT-file", "a MATLAB file (.mat 7.3, HDF5)", HDF5),
    (0, b"\x89HDF\r\n\x1a\n", "an HDF5 file", HDF5),
    (512, b"\x89HDF\r\n\x1a\n", "an HDF5 file", HDF5),
    (0, b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "a workbook of Excel (.xls)", "save the sheet as CSV"),
    (30, b"[Content_Types].xml", "a workbook of Excel (.xlsx)", "save the sheet as CSV"),
    (
        0,
        b"version https://git-lfs",
        "a pointer of Git LFS, not the file itself",
        "fetch the file: git lfs pull",
    ),
    (0, b"%PDF", "a PDF document", "give the record itself"),
    (0, b"KMI", "an event file of Kinemetrics (.evt)", OBSPY),
];

const HDF5: &str =
    "write the array as text: numpy.savetxt(\"record.txt\", h5py.File(\"record\")[\"NAME\"][()])";
const OBSPY: &str = "convert it with ObsPy: obspy.read(\"record\").write(\"record.mseed\", format=\"MSEED\")";
const EXPORT: &str = "export it as two columns of text from the program that wrote it";

/// Refuses what is no record.
///
/// # Errors
/// [`Error::Record`] with the kind of file and a way on.
pub(super) fn refused(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    let refuse = |kind: &str, remedy: &str| Err(Error::record(path, 1, format!("this is {kind}"), remedy));
    if let Some((.., kind, remedy)) =
        KINDS.iter().find(|(at, magic, ..)| bytes.get(*at..).is_some_and(|b| b.starts_with(magic)))
    {
        return refuse(kind, remedy);
    }
    // The tag of an event file: K, byte order, version; newer recorders begin with it.
    if let [b'K', 0 | 1, 1..=3, ..] = bytes {
        return refuse("an event file of Kinemetrics (.evt)", OBSPY);
    }
    let head = bytes[..bytes.len().min(1024)].trim_ascii_start().to_ascii_lowercase();
    if head.starts_with(b"<!doctype html") || head.starts_with(b"<html") {
        return refuse(
            "a web page, not the record",
            "download the record itself, after a log-in where one is needed",
        );
    }
    if head.starts_with(b"<?xml") || head.starts_with(b"<fdsnstationxml") {
        return match head.windows(14).any(|w| w == b"fdsnstationxml") {
            true => refuse(
                "station metadata (StationXML)",
                "give the record, with this file as its sensitivity (--sensitivity FILE)",
            ),
            false => refuse("an XML file", EXPORT),
        };
    }
    Ok(())
}

/// Refuses what is left when no binary format was recognised, and is no text either.
///
/// # Errors
/// As [`refused`].
pub(super) fn binary(source: &Source) -> Result<(), Error> {
    let bytes = source.bytes;
    let refuse = |kind: &str, remedy: &str| Err(source.error(0, format!("this is {kind}"), remedy));
    if win32(bytes) {
        return refuse(
            "a file of WIN32 (Hi-net)",
            "export the channel as text or SAC with the network's programs",
        );
    }
    if win(bytes) {
        return refuse("a file of WIN", OBSPY);
    }
    let marked = bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff");
    match !marked && bytes[..bytes.len().min(4096)].contains(&0) {
        true => refuse("a binary file of no format that is read", EXPORT),
        false => Ok(()),
    }
}

/// Month to second as binary-coded decimals.
fn is_time(bytes: Option<&[u8]>) -> bool {
    let Some(&[month, day, hour, minute, second]) = bytes else { return false };
    let within = |byte: u8, low: u8, high: u8| {
        let value = 10 * (byte >> 4) + (byte & 15);
        byte & 15 < 10 && byte >> 4 < 10 && (low..=high).contains(&value)
    };
    within(month, 1, 12)
        && within(day, 1, 31)
        && within(hour, 0, 23)
        && within(minute, 0, 59)
        && within(second, 0, 60)
}

/// Four bytes of zero, then the time of the first second from the century on.
fn win32(bytes: &[u8]) -> bool {
    bytes.starts_with(&[0; 4]) && matches!(bytes.get(4), Some(0x19 | 0x20)) && is_time(bytes.get(6..11))
}

/// Blocks of a second: their length (big-endian), and the time from the year on.
fn win(bytes: &[u8]) -> bool {
    let block = |at: usize| {
        let length = u32::from_be_bytes(bytes.get(at..at + 4)?.try_into().ok()?) as usize;
        (length > 10 && is_time(bytes.get(at + 5..at + 10))).then_some(length)
    };
    block(0).is_some_and(|length| length == bytes.len() || block(length).is_some())
}
