//! Station metadata in StationXML: sensitivity and direction of a channel by epochs.

use std::path::{Path, PathBuf};

use roxmltree::{Document, Node};

use super::date;
use super::header::Direction;
use crate::shown::shown;
use crate::{Error, Orientation, Sensitivity};

/// Larger files than this (bytes) are not the metadata of some stations.
const LARGEST: u64 = 1 << 26;
/// Dips this close to vertical or horizontal (degrees) count as such.
const TILT: f64 = 5.0;

/// The channels of a StationXML file.
#[derive(Debug, Clone, PartialEq)]
pub struct Stations {
    file: PathBuf,
    epochs: Vec<Written>,
}

/// A channel's epoch as it stands in the file.
#[derive(Debug, Clone, PartialEq)]
struct Written {
    /// Network, station, location and channel, with dots between.
    name: String,
    /// In s from the beginning of 1970, infinite where they are not stated.
    span: [f64; 2],
    since: String,
    azimuth: Option<f64>,
    dip: Option<f64>,
    /// `427336 COUNTS/M/S**2`, and the frequency (Hz).
    sensitivity: Option<String>,
    frequency: Option<f64>,
}

/// One channel in one epoch.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Epoch {
    pub sensitivity: Sensitivity,
    /// By azimuth and dip; none where they are not stated.
    pub direction: Option<Direction>,
    from: String,
}

impl Epoch {
    /// What the user is told of it.
    pub fn remarks(&self) -> Vec<String> {
        vec![
            self.from.clone(),
            "The instrument's response was not removed: one number is its whole sensitivity.".into(),
        ]
    }
}

impl Stations {
    /// Reads a file.
    ///
    /// # Errors
    /// [`Error::Io`], or [`Error::Record`] for what is no StationXML.
    pub fn read(path: &Path) -> Result<Stations, Error> {
        let io = |source| Error::Io { file: path.to_path_buf(), source };
        if std::fs::metadata(path).map_err(io)?.len() > LARGEST {
            return Err(Error::record(
                path,
                1,
                "the file is larger than 64 MiB",
                "request the station alone",
            ));
        }
        let bytes = std::fs::read(path).map_err(io)?;
        Stations::from_bytes(path, &bytes)
    }

    /// The same of content in memory; `path` serves for messages alone.
    ///
    /// # Errors
    /// [`Error::Record`].
    pub fn from_bytes(path: &Path, bytes: &[u8]) -> Result<Stations, Error> {
        let refuse = |line: u32, problem: String| {
            Error::record(
                path,
                line as usize,
                problem,
                "give StationXML with level=response or level=channel",
            )
        };
        let text = std::str::from_utf8(bytes).map_err(|_| refuse(1, "the file is not UTF-8".into()))?;
        let document = Document::parse(text).map_err(|e| refuse(e.pos().row, format!("no XML: {e}")))?;
        if document.root_element().tag_name().name() != "FDSNStationXML" {
            return Err(refuse(1, "the file is no StationXML (FDSNStationXML)".into()));
        }
        let mut epochs = Vec::new();
        for network in children(document.root_element(), "Network") {
            for station in children(network, "Station") {
                for channel in children(station, "Channel") {
                    let name = |node: Node, key| node.attribute(key).unwrap_or("").trim().to_owned();
                    let location = name(channel, "locationCode");
                    let parts =
                        [name(network, "code"), name(station, "code"), location, name(channel, "code")];
                    let written = written(parts.join("."), channel).map_err(|problem| refuse(1, problem))?;
                    epochs.push(written);
                }
            }
        }
        if epochs.is_empty() {
            return Err(refuse(1, "the file describes no channel".into()));
        }
        Ok(Stations { file: path.to_path_buf(), epochs })
    }

    /// The one epoch of a channel that a record from `begin` to `end` (s from the beginning of 1970) lies in.
    ///
    /// # Errors
    /// The problem and the remedy, if there is none or more than one, or if it has no sensitivity to acceleration.
    pub(super) fn epoch(&self, name: &str, begin: f64, end: f64) -> Result<Epoch, (String, String)> {
        let file = self.file.display();
        let mut of_channel = self.epochs.iter().filter(|e| e.name == name).peekable();
        if of_channel.peek().is_none() {
            let mut names: Vec<&str> = self.epochs.iter().map(|e| e.name.as_str()).collect();
            names.dedup();
            names.truncate(6);
            return Err((
                format!("channel {name}: not in {file}, which has {}", names.join(", ")),
                "give the StationXML of this channel".into(),
            ));
        }
        let found: Vec<&Written> = of_channel.filter(|e| e.span[0] <= end && begin < e.span[1]).collect();
        let epoch = match found[..] {
            [epoch] => epoch,
            [] => {
                return Err((
                    format!("channel {name}: {file} has no epoch at the time of the record"),
                    "request the metadata of that time".into(),
                ));
            }
            _ => {
                let since: Vec<&str> = found.iter().map(|e| e.since.as_str()).collect();
                return Err((
                    format!("channel {name}: the record lies in {} epochs of {file}, since {}", found.len(), since.join(" and ")),
                    "cut the record at the change, or declare the number: sensitivity = \"427336 counts/(m/s2)\"".into(),
                ));
            }
        };
        let Some(text) = &epoch.sensitivity else {
            return Err((
                format!(
                    "channel {name}: {file} states no InstrumentSensitivity for the epoch since {}",
                    epoch.since
                ),
                "request it with level=response".into(),
            ));
        };
        let sensitivity: Sensitivity = text.parse().map_err(|problem| {
            (format!("channel {name} in {file}: {problem}"), "give the record of an accelerometer".to_owned())
        })?;
        let direction = epoch.dip.map(|dip| match epoch.azimuth {
            _ if (dip + 90.0).abs() <= TILT => Direction::Along(Orientation::Up),
            _ if (dip - 90.0).abs() <= TILT => Direction::Down,
            Some(azimuth) if dip.abs() <= TILT => Direction::Along(Orientation::from_degrees(azimuth)),
            _ => Direction::Unknown,
        });
        let at = epoch.frequency.map_or(String::new(), |f| format!(" at {f} Hz"));
        let from = format!("The sensitivity is {sensitivity}{at}, by {file}, epoch since {}.", epoch.since);
        Ok(Epoch { sensitivity, direction, from })
    }
}

/// Elements of a name, whatever their namespace.
fn children<'a, 'i>(node: Node<'a, 'i>, name: &'static str) -> impl Iterator<Item = Node<'a, 'i>> {
    node.children().filter(move |n| n.is_element() && n.tag_name().name() == name)
}

fn child<'a, 'i>(node: Node<'a, 'i>, name: &'static str) -> Option<Node<'a, 'i>> {
    children(node, name).next()
}

fn written(name: String, channel: Node) -> Result<Written, String> {
    let number = |node: Option<Node>| node?.text()?.trim().parse::<f64>().ok().filter(|v| v.is_finite());
    let time = |key: &str, otherwise: f64| match channel.attribute(key) {
        None => Ok(otherwise),
        Some(text) => {
            let plain = text.trim().trim_end_matches('Z').trim_end_matches("+00:00");
            // Far years stand for no end.
            let far = plain.get(..4).and_then(|y| y.parse::<u16>().ok()).is_some_and(|year| year > 2100);
            let time = if far { Some(f64::INFINITY) } else { date::seconds(plain) };
            time.ok_or_else(|| format!("{key} of {name}: '{}' is no time", shown(text)))
        }
    };
    let span = [time("startDate", f64::NEG_INFINITY)?, time("endDate", f64::INFINITY)?];
    let whole = child(channel, "Response").and_then(|r| child(r, "InstrumentSensitivity"));
    let unit = |key| Some(child(child(whole?, key)?, "Name")?.text()?.trim().to_owned());
    let value = number(whole.and_then(|w| child(w, "Value")));
    let sensitivity = match (value, unit("InputUnits"), unit("OutputUnits")) {
        (Some(value), Some(input), Some(output)) => Some(format!("{value} {output}/{input}")),
        _ => None,
    };
    Ok(Written {
        span,
        since: channel.attribute("startDate").unwrap_or("the beginning").to_owned(),
        azimuth: number(child(channel, "Azimuth")),
        dip: number(child(channel, "Dip")),
        sensitivity,
        frequency: number(whole.and_then(|w| child(w, "Frequency"))),
        name,
    })
}
