//! Records as plain text.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;

use crate::{Channel, Error, Orientation, Units};

/// Writes a channel as two columns, time (s) and acceleration (m/s², or counts of a raw one), replacing the file.
///
/// The file says its own units, interval and, where it is known, direction in comments that [`crate::read`] understands, and
/// reading it gives the same samples bit for bit. `notes`, the steps of processing for instance, become comments, one a line.
///
/// # Errors
/// [`Error::Io`] if the file cannot be written.
pub fn write_text(channel: &Channel, notes: &[String], path: &Path) -> Result<(), Error> {
    let write = || -> std::io::Result<()> {
        let mut out = BufWriter::new(File::create(path)?);
        let title = format!("{}, acceleration, time from the record's zero", channel.name);
        for note in std::iter::once(&title).chain(notes) {
            // A line break in a name would end the comment.
            writeln!(out, "# {}", note.replace(|c: char| c.is_control(), " "))?;
        }
        let units = if channel.raw { Units::Counts } else { Units::MetrePerSecond2 };
        writeln!(out, "# units = \"{units}\"")?;
        writeln!(out, "# dt = \"{} s\"", channel.dt)?;
        match channel.orientation {
            // To a billionth of a degree, so that east is 90 whatever its radians are.
            Some(Orientation::Azimuth(azimuth)) => {
                writeln!(out, "# direction = \"{}\"", (azimuth.to_degrees() * 1e9).round() / 1e9)?
            }
            Some(Orientation::Up) => writeln!(out, "# direction = \"up\"")?,
            None => {}
        }
        for (i, a) in channel.acceleration.iter().enumerate() {
            writeln!(out, "{:.6} {a:e}", channel.start + i as f64 * channel.dt)?;
        }
        out.into_inner().map_err(|e| e.into_error())?.sync_all()
    };
    write().map_err(|source| Error::Io { file: path.to_path_buf(), source })
}
