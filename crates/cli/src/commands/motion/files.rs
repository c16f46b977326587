//! Records by their files, and what the files do not say.

use crate::exit::Failure;
use std::path::{Path, PathBuf};
use tremolite_motion::{Channel, ReadOptions, TextColumn, Units, encoding, read};

#[derive(clap::Args)]
pub struct Files {
    /// Records in any supported format
    #[arg(required = true)]
    files: Vec<PathBuf>,
    #[command(flatten)]
    declared: Declared,
    #[arg(long)]
    pub json: bool,
}

/// What files do not say themselves.
#[derive(clap::Args)]
pub struct Declared {
    /// Units of text files: g, m/s2, cm/s2, mm/s2 or counts
    #[arg(long)]
    units: Option<String>,
    /// Columns of text files from the left: time, acceleration, east, north, up, an azimuth or skip; or rows alone, for one
    /// series in rows of numbers
    #[arg(long, value_delimiter = ',', value_name = "COLUMN,…")]
    columns: Option<Vec<String>>,
    /// Sampling interval of one-column text files: "0.005 s", "5 ms", or a bare number in s
    #[arg(long, value_parser = interval)]
    dt: Option<f64>,
    /// What a count is, for files in counts: "427336 counts/(m/s2)", or the StationXML file of miniSEED and SAC
    #[arg(long)]
    sensitivity: Option<String>,
    /// Encoding of text that is neither UTF-8 nor GB18030: big5, shift_jis, windows-1252 …
    #[arg(long)]
    encoding: Option<String>,
}

impl Declared {
    /// The same, read.
    pub fn options(&self) -> Result<ReadOptions, Failure> {
        let units = self.units.as_deref().map(str::parse::<Units>).transpose().map_err(Failure::input)?;
        let read = |words: &Vec<String>| {
            words.iter().map(|word| word.parse()).collect::<Result<Vec<TextColumn>, String>>()
        };
        let columns = self.columns.as_ref().map(read).transpose().map_err(Failure::input)?;
        let encoding = self.encoding.as_deref().map(encoding).transpose().map_err(Failure::input)?;
        let options = ReadOptions { units, columns, dt: self.dt, encoding, ..ReadOptions::default() };
        match &self.sensitivity {
            Some(written) => options.with_sensitivity(written, Path::to_path_buf).map_err(Failure::input),
            None => Ok(options),
        }
    }
}

impl Files {
    /// The channels of all files, in their order; some may be in counts still. Faults are told of all files at once.
    pub fn channels(&self) -> Result<Vec<Channel>, Failure> {
        let options = self.declared.options()?;
        let (mut all, mut faults) = (Vec::new(), Vec::new());
        for file in &self.files {
            match read(file, &options) {
                Ok(channels) => all.extend(channels),
                Err(fault) => faults.push(fault.to_string()),
            }
        }
        if faults.is_empty() { Ok(all) } else { Err(Failure::input(faults.join("\nerror: "))) }
    }

    /// The same, none of a sensor that does not record acceleration.
    pub fn of_accelerometers(&self) -> Result<Vec<Channel>, Failure> {
        let channels = self.channels()?;
        for c in &channels {
            c.of_accelerometer().map_err(|e| Failure::input(format!("{}: {e}", c.file.display())))?;
        }
        Ok(channels)
    }

    /// The same, in m/s² throughout.
    pub fn accelerations(&self) -> Result<Vec<Channel>, Failure> {
        let channels = self.of_accelerometers()?;
        match channels.iter().find(|c| c.raw) {
            Some(raw) => Err(Failure::input(format!(
                "{}: '{}' is in counts, and nothing says what a count is; give its sensitivity, which the network's station \
                 metadata state, for example --sensitivity \"427336 counts/(m/s2)\"",
                raw.file.display(),
                raw.name
            ))),
            None => Ok(channels),
        }
    }
}

/// A time (s) with or without its unit.
pub fn interval(text: &str) -> Result<f64, String> {
    let word = text.trim();
    let (number, unit) = match (word.strip_suffix("ms"), word.strip_suffix('s')) {
        (Some(number), _) => (number, 1e-3),
        (None, Some(number)) => (number, 1.0),
        (None, None) => (word, 1.0),
    };
    match number.trim().parse::<f64>() {
        Ok(value) if value > 0.0 && value.is_finite() => Ok(value * unit),
        _ => Err("write a time above 0, such as \"0.005 s\" or \"5 ms\"".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::interval;

    #[test]
    fn intervals_are_read_with_or_without_their_unit() {
        for text in ["0.005", "0.005 s", "0.005s", " 5 ms", "5e-3 s"] {
            assert_eq!(interval(text), Ok(0.005), "{text}");
        }
        for text in ["", "s", "0 s", "-1", "nan", "inf s", "5 Hz", "1 s s"] {
            assert!(interval(text).is_err_and(|e| e.contains("0.005 s")), "{text}");
        }
    }
}
