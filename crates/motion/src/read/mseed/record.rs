//! One record of miniSEED: header and samples.
//!
//! Version 2 is the data record of the SEED manual 2.4 (chapter 8): 48 bytes, then blockettes, of which 1000 has the encoding
//! and the record's length, 1001 microseconds of the start and 100 the actual rate. Version 3 is that of FDSN (2023):
//! 40 bytes, little-endian, with a checksum of the record.

use super::samples;
use crate::Error;
use crate::read::date;
use crate::read::source::Source;

/// Samples of one channel, one after the other.
pub(super) struct Record {
    /// Where it begins in the file, and how long it is (bytes, above 0).
    pub at: usize,
    pub length: usize,
    /// Network, station, location and channel, with dots between.
    pub name: String,
    /// Time of the first sample (ns since the beginning of 1970, UTC).
    pub start: i64,
    /// Sampling interval (s), above 0 and finite.
    pub dt: f64,
    /// Samples as they stand in the file; none in records of text and of the log.
    pub samples: Vec<f64>,
    /// Whether they may be other than whole.
    pub float: bool,
}

/// What both versions say in their headers.
struct Header {
    length: usize,
    name: String,
    start: i64,
    /// Samples a second, or 0.
    rate: f64,
    count: usize,
    encoding: u8,
    big: bool,
    /// Where the samples begin and end in the record.
    data: (usize, usize),
}

const CORRUPT: &str = "fetch the record again";
/// Lengths of the fixed headers (bytes).
const HEADER_2: usize = 48;
const HEADER_3: usize = 40;

/// Whether a record of either version begins here.
pub(super) fn begins(bytes: &[u8]) -> bool {
    let clock = |at: usize| match bytes.get(at..at + 3) {
        Some(&[hour, minute, second]) => hour < 24 && minute < 60 && second <= 60,
        _ => false,
    };
    is_3(bytes) && clock(12) || is_2(bytes) && clock(24)
}

fn is_3(bytes: &[u8]) -> bool {
    bytes.starts_with(b"MS\x03")
}

fn is_2(bytes: &[u8]) -> bool {
    let number = |b: &u8| b.is_ascii_digit() || *b == b' ' || *b == 0;
    match bytes.get(..8) {
        Some([sequence @ .., b'D' | b'R' | b'Q' | b'M', b' ' | 0]) => sequence.iter().all(number),
        _ => false,
    }
}

/// The record that begins at byte `at`, of `room` samples at most.
pub(super) fn read(source: &Source, at: usize, room: usize) -> Result<Record, Error> {
    let fault = |problem: String, remedy: &str| Error::binary(source.file, at, problem, remedy);
    let bytes = source.bytes.get(at..).unwrap_or_default();
    if !begins(bytes) {
        return Err(fault("no record of miniSEED begins here".into(), "cut off what is no record"));
    }
    let header = if is_3(bytes) { header_3(bytes) } else { header_2(bytes) };
    let header = header.map_err(|problem| fault(problem, CORRUPT))?;
    let Header { length, count, encoding, .. } = header;
    let Some(record) = bytes.get(..length) else {
        return Err(fault(
            format!("the record that begins here has {length} bytes, but {} are left", bytes.len()),
            "fetch the file again, or cut off its last, incomplete record",
        ));
    };
    if is_3(bytes) && checksum(record) != Some(crc(record)) {
        return Err(fault("the record that begins here has another checksum than it states".into(), CORRUPT));
    }
    let mut found = Record {
        at,
        length,
        name: header.name,
        start: header.start,
        dt: 1.0 / header.rate,
        samples: Vec::new(),
        float: samples::is_float(encoding),
    };
    // Encoding 0 is text.
    if count == 0 || encoding == 0 {
        return Ok(found);
    }
    if samples::name(encoding).is_none() {
        return Err(fault(
            format!("the record that begins here has the encoding {encoding}, which is not read"),
            "write it anew with Steim 2, which programs for seismology can",
        ));
    }
    if !(header.rate > 0.0 && found.dt > 0.0 && found.dt.is_finite()) {
        return Err(fault("the record that begins here has samples, but no rate of them".into(), CORRUPT));
    }
    if count > room {
        return Err(fault(
            format!("the record that begins here promises {count} samples, which makes the file too long"),
            "cut out the earthquake",
        ));
    }
    let (from, to) = header.data;
    let data = record.get(from..to).unwrap_or_default();
    found.samples = samples::decode(encoding, data, count, header.big)
        .map_err(|problem| fault(format!("the record that begins here is broken: {problem}"), CORRUPT))?;
    Ok(found)
}

/// Numbers at places of a header, big-endian or not.
struct Fields<'a> {
    bytes: &'a [u8],
    big: bool,
}

impl Fields<'_> {
    fn take<const N: usize>(&self, at: usize) -> Result<[u8; N], String> {
        let field = self.bytes.get(at..).and_then(|b| b.first_chunk::<N>()).copied();
        let mut field = field.ok_or("the file ends within the record that begins here")?;
        if !self.big {
            field.reverse();
        }
        Ok(field)
    }

    fn u16(&self, at: usize) -> Result<u16, String> {
        self.take(at).map(u16::from_be_bytes)
    }

    fn i16(&self, at: usize) -> Result<i16, String> {
        self.take(at).map(i16::from_be_bytes)
    }

    fn u32(&self, at: usize) -> Result<u32, String> {
        self.take(at).map(u32::from_be_bytes)
    }

    /// Letters and digits without the blanks around them.
    fn code(&self, at: usize, length: usize) -> String {
        let bytes = self.bytes.get(at..at + length).unwrap_or_default();
        let code: String =
            bytes.iter().map(|b| if b.is_ascii_graphic() { *b as char } else { ' ' }).collect();
        code.trim().to_string()
    }

    /// Year, day of the year, hour, minute and second (ns since the beginning of 1970).
    fn time(&self, year: usize, hour: usize, nanoseconds: i64) -> Result<i64, String> {
        let (y, day) = (self.u16(year)?, self.u16(year + 2)?);
        let midnight = date::midnight(y.into(), day.into())
            .ok_or_else(|| format!("the record that begins here has the date {y}, day {day}"))?;
        let [hour, minute, second] = Fields { big: true, ..*self }.take(hour)?.map(i64::from);
        Ok(midnight + (hour * 3600 + minute * 60 + second) * 1_000_000_000 + nanoseconds)
    }
}

fn header_2(bytes: &[u8]) -> Result<Header, String> {
    // The header has no mark of its byte order; its year is one of a few in the right one only.
    let big = Fields { bytes, big: true }.u16(20).is_ok_and(|year| (1900..=2100).contains(&year));
    let fields = Fields { bytes, big };
    let name = [(18, 2), (8, 5), (13, 2), (15, 3)].map(|(at, length)| fields.code(at, length)).join(".");
    let mut start = fields.time(20, 24, i64::from(fields.u16(28)?) * 100_000)?;
    // A correction of the time (0.1 ms) that is not in the start yet.
    if bytes.get(36).is_some_and(|activity| activity & 2 == 0) {
        start += i64::from(fields.u32(40)? as i32) * 100_000;
    }
    let mut rate = rate_2(fields.i16(32)?, fields.i16(34)?);
    let mut data = None;
    let mut blockette = usize::from(fields.u16(46)?);
    while blockette >= HEADER_2 {
        let byte = |at: usize| fields.take::<1>(blockette + at).map(|[b]| b);
        match fields.u16(blockette)? {
            1000 => data = Some((byte(4)?, byte(5)? == 1, byte(6)?)),
            1001 => start += i64::from(byte(5)? as i8) * 1000,
            100 => rate = f64::from(fields.take(blockette + 4).map(f32::from_be_bytes)?),
            _ => {}
        }
        let next = usize::from(fields.u16(blockette + 2)?);
        // Only onwards, so that no ring of blockettes is followed for ever.
        blockette = if next > blockette { next } else { 0 };
    }
    let (encoding, big, power) =
        data.ok_or("the record that begins here does not state its length (it has no blockette 1000)")?;
    // 128 bytes by the manual, at most 2³⁰ by sense.
    if !(7..=30).contains(&power) {
        return Err(format!("the record that begins here states a length of 2^{power} bytes"));
    }
    let (length, from) = (1 << power, usize::from(fields.u16(44)?));
    Ok(Header {
        length,
        name,
        start,
        rate,
        count: fields.u16(30)?.into(),
        encoding,
        big,
        data: (from, length),
    })
}

/// Samples a second by the factor and the multiplier, each of which divides where it is negative; 0 if either is.
fn rate_2(factor: i16, multiplier: i16) -> f64 {
    let (mut above, mut below) = (1.0, 1.0);
    for n in [factor, multiplier].map(f64::from) {
        if n < 0.0 {
            below *= -n;
        } else {
            above *= n;
        }
    }
    above / below
}

fn header_3(bytes: &[u8]) -> Result<Header, String> {
    let fields = Fields { bytes, big: false };
    let rate = fields.take(16).map(f64::from_be_bytes)?;
    let identifier = usize::from(fields.take::<1>(33)?[0]);
    let extra = usize::from(fields.u16(34)?);
    let from = HEADER_3 + identifier + extra;
    let size = |at: usize| fields.u32(at).and_then(|n| usize::try_from(n).map_err(|e| e.to_string()));
    let encoding = fields.take::<1>(15)?[0];
    let length = from.saturating_add(size(36)?);
    Ok(Header {
        length,
        name: name_3(&fields.code(HEADER_3, identifier)),
        start: fields.time(8, 12, fields.u32(4)?.into())?,
        // Negative is the interval in seconds.
        rate: if rate < 0.0 { -1.0 / rate } else { rate },
        count: size(24)?,
        encoding,
        big: matches!(encoding, 10 | 11),
        data: (from, length),
    })
}

/// `FDSN:NET_STA_LOC_B_S_SS` in the words of version 2, other identifiers as they are.
fn name_3(identifier: &str) -> String {
    let parts = identifier.strip_prefix("FDSN:").map(|rest| rest.split('_').collect::<Vec<_>>());
    match parts.as_deref() {
        Some([network, station, location, band, source, direction]) => {
            format!("{network}.{station}.{location}.{band}{source}{direction}")
        }
        _ => identifier.to_string(),
    }
}

/// The checksum that a record of version 3 states.
fn checksum(record: &[u8]) -> Option<u32> {
    Fields { bytes: record, big: false }.u32(28).ok()
}

/// CRC-32C (polynomial 1EDC6F41, here with its bits reversed) of a record of version 3 with zeros for its checksum.
fn crc(record: &[u8]) -> u32 {
    let bytes = record.iter().enumerate().map(|(i, b)| if (28..32).contains(&i) { 0 } else { *b });
    !bytes.fold(!0, |crc, byte| {
        (0..8)
            .fold(crc ^ u32::from(byte), |crc: u32, _| (crc >> 1) ^ (0x82f6_3b78 & (crc & 1).wrapping_neg()))
    })
}
