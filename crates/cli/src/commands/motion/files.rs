//! Records by their files, and what the files do not say.

use crate::exit::Failure;
use std::path::PathBuf;
use tremolite_motion::{Channel, ReadOptions, Sensitivity, Units, read};

#[derive(clap::Args)]
pub struct Files {
    /// Records in any supported format
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Units of text files: g, m/s2, cm/s2, mm/s2 or counts
    #[arg(long)]
    units: Option<String>,
    /// Sampling interval of one-column text files, in s
    #[arg(long)]
    dt: Option<f64>,
    /// What a count is, for files in counts: "427336 counts/(m/s2)"
    #[arg(long)]
    sensitivity: Option<String>,
    #[arg(long)]
    pub json: bool,
}

impl Files {
    /// The channels of all files, in their order; some may be in counts still. Faults are told of all files at once.
    pub fn channels(&self) -> Result<Vec<Channel>, Failure> {
        let units = self.units.as_deref().map(str::parse::<Units>).transpose().map_err(Failure::input)?;
        let sensitivity =
            self.sensitivity.as_deref().map(str::parse::<Sensitivity>).transpose().map_err(Failure::input)?;
        let options = ReadOptions { units, dt: self.dt, sensitivity, ..ReadOptions::default() };
        let (mut all, mut faults) = (Vec::new(), Vec::new());
        for file in &self.files {
            match read(file, &options) {
                Ok(channels) => all.extend(channels),
                Err(fault) => faults.push(fault.to_string()),
            }
        }
        if faults.is_empty() { Ok(all) } else { Err(Failure::input(faults.join("\nerror: "))) }
    }

    /// The same, in m/s² throughout.
    pub fn accelerations(&self) -> Result<Vec<Channel>, Failure> {
        let channels = self.channels()?;
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
