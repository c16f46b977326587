//! Reading of records, one file a format.

mod bhrc;
mod cosmos;
mod csmip;
mod csmnc;
mod date;
mod declared;
mod esm;
mod foreign;
mod fortran;
mod geonet;
mod header;
mod itaca;
mod knet;
mod mseed;
mod packing;
mod pairs;
mod peer_at2;
mod sac;
mod smc;
mod source;
mod stations;
mod text;

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::Arc;

use tremolite_files::text::{Encoding, decode};

use crate::shown::shown;
use crate::{Channel, Error, Orientation, Sensitivity, Units};
use source::Source;
pub use stations::Stations;

/// What a file does not say itself. For files that do say it, a statement here must agree.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ReadOptions {
    /// Units of the numbers.
    pub units: Option<Units>,
    /// What each column holds, for text. By default one column is acceleration, two are time and acceleration.
    pub columns: Option<Vec<TextColumn>>,
    /// Sampling interval (s).
    pub dt: Option<f64>,
    /// What turns counts into acceleration, for formats that hold counts.
    pub sensitivity: Option<Sensitivity>,
    /// Metadata that have the sensitivity and the direction by channel and time, for miniSEED and SAC.
    pub stations: Option<Arc<Stations>>,
    /// Encoding of the text, where it is neither UTF-8 nor GB18030.
    pub encoding: Option<&'static Encoding>,
}

impl ReadOptions {
    /// Takes a sensitivity as users write it: counts per unit of acceleration, or the name of a StationXML file, which ends in `.xml`.
    ///
    /// # Errors
    /// A sentence, if it is neither, or if the file cannot be read.
    pub fn with_sensitivity(
        mut self,
        written: &str,
        place: impl FnOnce(&Path) -> PathBuf,
    ) -> Result<ReadOptions, String> {
        if written.trim().to_ascii_lowercase().ends_with(".xml") {
            let stations = Stations::read(&place(Path::new(written.trim()))).map_err(|e| e.to_string())?;
            self.stations = Some(Arc::new(stations));
        } else {
            self.sensitivity = Some(written.parse()?);
        }
        Ok(self)
    }
}

/// What a column of text holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TextColumn {
    /// Time (s).
    Time,
    /// Acceleration, with its direction if it is known.
    Acceleration(Option<Orientation>),
    /// Nothing that is wanted.
    Skip,
    /// The only one: all numbers are one acceleration, row by row.
    Rows,
}

impl FromStr for TextColumn {
    type Err = String;

    /// Reads `time`, `acceleration`, `skip`, `rows`, or a direction (`east`, `north`, `up`, `N28W`, `332`, see
    /// [`Orientation::parse`]) for an acceleration in that direction.
    fn from_str(word: &str) -> Result<TextColumn, String> {
        match word.trim() {
            "time" => Ok(TextColumn::Time),
            "acceleration" => Ok(TextColumn::Acceleration(None)),
            "skip" => Ok(TextColumn::Skip),
            "rows" => Ok(TextColumn::Rows),
            other => Orientation::parse(other).map(|o| TextColumn::Acceleration(Some(o))).ok_or_else(|| {
                format!(
                    "'{}' is not something a column can hold; use time, acceleration, east, north, up, an \
                     azimuth such as N28W or 332, skip, or rows alone",
                    shown(other)
                )
            }),
        }
    }
}

/// One format that can be read.
pub struct Format {
    /// Its name, for lists and messages.
    pub name: &'static str,
    /// Whether the content looks like this format.
    recognises: fn(&Source) -> bool,
    /// Whether its text has an encoding.
    is_text: bool,
    /// Reads all channels of the file.
    read: fn(&Source, &ReadOptions) -> Result<Vec<Channel>, Error>,
}

/// All formats, tried in this order. The last takes whatever is left.
pub const FORMATS: &[Format] = &[
    Format { name: "GeoNet V1A, V2A", recognises: geonet::recognises, is_text: true, read: geonet::read },
    Format { name: "COSMOS", recognises: cosmos::recognises, is_text: true, read: cosmos::read },
    Format { name: "SMC", recognises: smc::recognises, is_text: true, read: smc::read },
    Format { name: "CSMIP, CDMG, USC", recognises: csmip::recognises, is_text: true, read: csmip::read },
    Format { name: "miniSEED", recognises: mseed::recognises, is_text: false, read: mseed::read },
    Format { name: "SAC", recognises: sac::recognises, is_text: false, read: sac::read },
    Format { name: "CSMNC", recognises: csmnc::recognises, is_text: true, read: csmnc::read },
    Format { name: "BHRC", recognises: bhrc::recognises, is_text: true, read: bhrc::read },
    Format {
        name: "AFAD, CWB, JMA, ASA",
        recognises: declared::recognises,
        is_text: true,
        read: declared::read,
    },
    Format { name: "K-NET, KiK-net", recognises: knet::recognises, is_text: true, read: knet::read },
    Format { name: "ESM (DYNA)", recognises: esm::recognises, is_text: true, read: esm::read },
    Format { name: "ITACA", recognises: itaca::recognises, is_text: true, read: itaca::read },
    Format { name: "PEER AT2", recognises: peer_at2::recognises, is_text: true, read: peer_at2::read },
    Format { name: COLUMNS, recognises: |_| true, is_text: true, read: text::read },
];

/// The last of [`FORMATS`], which alone has columns that can be declared.
const COLUMNS: &str = "text columns";

/// Larger files than this (bytes), packed or unpacked, are not records: an hour of nine columns at 200 Hz is half of it.
const LARGEST: u64 = 1 << 26;
/// Nor are files of more lines, each of which costs memory: at one sample a line it is five hours at 200 Hz.
const MOST_LINES: usize = 4_000_000;

/// Reads all channels of a file; the format is recognised by its content, never by its name.
///
/// # Errors
/// [`Error::Io`], or [`Error::Record`] with the line, or [`Error::Binary`] with the byte, the problem and the way out.
pub fn read(path: &Path, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| file.take(LARGEST + 1).read_to_end(&mut bytes))
        .map_err(|source| Error::Io { file: path.to_path_buf(), source })?;
    read_bytes(path, &bytes, options)
}

/// As [`read`], from content already in memory; `path` serves for names and messages alone.
///
/// # Errors
/// [`Error::Record`], [`Error::Binary`].
pub fn read_bytes(path: &Path, bytes: &[u8], options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    let unpacked = packing::unpacked(path, bytes, LARGEST)?;
    let bytes = &unpacked[..];
    if bytes.iter().filter(|b| matches!(b, b'\n' | b'\r')).count() > MOST_LINES {
        let problem = format!("the file has more than {MOST_LINES} lines");
        return Err(Error::record(path, MOST_LINES, problem, "give a single record"));
    }
    let decoded = decode(bytes, options.encoding);
    let undecoded = decoded.is_none();
    let note = match &decoded {
        Some(text) => text.note(),
        None => Some("The text is neither UTF-8 nor GB18030; `encoding` states its encoding.".to_owned()),
    };
    let text = decoded.map_or_else(|| String::from_utf8_lossy(bytes), |decoded| decoded.text);
    let source = Source::new(path, bytes, &text);
    let Some(format) = of(&source) else {
        return Err(source.error(0, "the format is not known", "convert the record to two columns of text"));
    };
    if format.name == COLUMNS {
        foreign::binary(&source)?;
    }
    if let (true, true, Some(encoding)) = (undecoded, format.is_text, options.encoding) {
        let problem = format!("the text has bytes that are no characters of {}", encoding.name());
        return Err(source.error(0, problem, "declare another encoding, or none"));
    }
    if options.stations.is_some() && format.is_text {
        return Err(source.error(
            0,
            format!("StationXML was declared, but this is a file in the format {}", format.name),
            "remove the declaration; it serves miniSEED and SAC",
        ));
    }
    if options.columns.is_some() && format.name != COLUMNS {
        return Err(source.error(
            0,
            format!("'columns' was declared, but this is a file in the format {}", format.name),
            "remove the declaration; all its components are read",
        ));
    }
    let mut channels = (format.read)(&source, options)?;
    for channel in &mut channels {
        channel.format = format.name;
        channel.remarks.extend(note.clone().filter(|_| format.is_text));
    }
    Ok(channels)
}

/// The format that content is read as; none where it cannot be unpacked.
pub fn recognised(bytes: &[u8]) -> Option<&'static Format> {
    let path = Path::new("");
    let bytes = packing::unpacked(path, bytes, LARGEST).ok()?;
    let text = decode(&bytes, None).map_or_else(|| String::from_utf8_lossy(&bytes), |decoded| decoded.text);
    of(&Source::new(path, &bytes, &text))
}

fn of(source: &Source) -> Option<&'static Format> {
    FORMATS.iter().find(|format| (format.recognises)(source))
}
