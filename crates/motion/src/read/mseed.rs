//! miniSEED, versions 2 and 3: records of one or more channels, joined in time.
//!
//! The samples are counts of a digitiser, and what a count is stands elsewhere, in the station's StationXML; so they stay counts
//! unless a sensitivity is declared, or read from StationXML. Floats may be accelerations already, if their units are declared. A channel is named by
//! network, station, location and code. The code's second letter is the instrument (SEED manual, appendix A): counts
//! of anything but an accelerometer (`N`) are not taken for acceleration. Times are UTC. The last record of a channel need not be
//! full, and records may come in any order, but each must begin where the one before ends, to half a sample.

mod record;
mod samples;

use std::collections::BTreeMap;

use super::header::Direction;
use super::source::Source;
use super::{ReadOptions, date};
use crate::{Channel, Error, Orientation, Units};
use record::Record;

/// Larger files than this (samples) are not records: three components at 200 Hz for a day come to less. Steim's compression packs
/// seven samples into four bytes, so that the limit for the file's length would not do.
const MOST: usize = 1 << 26;

pub(super) fn recognises(source: &Source) -> bool {
    record::begins(source.bytes) || is_volume(source.bytes)
}

/// Whether a full SEED volume begins here, which is metadata first and data records after that.
fn is_volume(bytes: &[u8]) -> bool {
    bytes.get(..11).is_some_and(|b| b[..6].iter().all(u8::is_ascii_digit) && b[6..] == *b"V 010")
}

pub(super) fn read(source: &Source, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    if is_volume(source.bytes) {
        return Err(Error::binary(
            source.file,
            0,
            "this is a full SEED volume, not miniSEED",
            "convert it with ObsPy: obspy.read(\"record\").write(\"record.mseed\", format=\"MSEED\"); and declare its sensitivity",
        ));
    }
    let mut channels: BTreeMap<String, Vec<Record>> = BTreeMap::new();
    let (mut at, mut room) = (0, MOST);
    while at < source.bytes.len() {
        let record = record::read(source, at, room)?;
        at += record.length;
        room = room.saturating_sub(record.samples.len());
        if !record.samples.is_empty() {
            channels.entry(record.name.clone()).or_default().push(record);
        }
    }
    let earliest = channels.values().flatten().map(|r| r.start).min();
    let Some(earliest) = earliest else {
        return Err(Error::binary(source.file, 0, "no record holds samples", "give the file of the samples"));
    };
    let several = channels.len() > 1;
    let read = |(name, mut records): (String, Vec<Record>)| {
        let in_order = records.is_sorted_by_key(|r| r.start);
        records.sort_by_key(|r| r.start);
        let (at, start, dt) = (records[0].at, records[0].start, records[0].dt);
        let mut remarks = joined(source, &name, &records)?;
        if !in_order {
            remarks.push("records were not in the order of time, and were put into it".to_string());
        }
        let float = records.iter().all(|r| r.float);
        let seconds = start as f64 / 1e9;
        let samples: usize = records.iter().map(|r| r.samples.len()).sum();
        let epoch =
            options.stations.as_ref().map(|s| s.epoch(&name, seconds, seconds + dt * (samples - 1) as f64));
        let epoch =
            epoch.transpose().map_err(|(problem, remedy)| Error::binary(source.file, at, problem, remedy))?;
        let sensitivity = epoch.as_ref().map(|e| e.sensitivity).or(options.sensitivity);
        let options = &ReadOptions { sensitivity, ..options.clone() };
        let units = units(source, at, &name, float, options)?;
        remarks.extend(instrument(&name).remark());
        remarks.extend(epoch.iter().flat_map(|e| e.remarks()));
        let by_code =
            || Orientation::of_channel_code(code(&name)).map_or(Direction::Unknown, Direction::Along);
        let direction = epoch.and_then(|e| e.direction).unwrap_or_else(by_code);
        let dt = source.stated_interval(0, dt, options.dt).map_err(|e| e.at_byte(at))?;
        let mut values = Vec::with_capacity(samples);
        records.into_iter().for_each(|mut r| values.append(&mut r.samples));
        let label = several.then_some(name.as_str());
        let channel = Channel {
            start: (start - earliest) as f64 / 1e9,
            clock: Some(seconds),
            // Floats in a declared unit of acceleration are what another program made of them.
            other_sensor: units == Units::Counts && !instrument(&name).accelerates(),
            remarks,
            ..source.channel(label, dt, values)
        };
        source.converted(0, units, options, direction.given_to(channel)).map_err(|e| e.at_byte(at))
    };
    channels.into_iter().map(read).collect()
}

/// Checks that records, in order of time, follow each other without a gap; remarks on what their times do together.
fn joined(source: &Source, name: &str, records: &[Record]) -> Result<Vec<String>, Error> {
    let seconds = |from: &Record, to: &Record| (to.start - from.start) as f64 / 1e9;
    let mut before = 0;
    for pair in records.windows(2) {
        let (a, b) = (&pair[0], &pair[1]);
        let fault = |problem: String, remedy: &str| Error::binary(source.file, b.at, problem, remedy);
        // libmseed's tolerance for rates that are the same.
        if !((b.dt / a.dt - 1.0).abs() <= 1e-4) {
            return Err(fault(
                format!("channel {name} changes its interval from {} s to {} s", a.dt, b.dt),
                "cut the record to one side of the change",
            ));
        }
        let late = seconds(a, b) - a.samples.len() as f64 * a.dt;
        if !(late.abs() <= 0.5 * a.dt) {
            let kind = if late > 0.0 { "a gap" } else { "an overlap" };
            let end = a.start.saturating_add((a.samples.len() as f64 * a.dt * 1e9) as i64);
            return Err(fault(
                format!(
                    "channel {name} has {kind} of {:.6} s: a record ends at {}, the next begins at {}",
                    late.abs(),
                    date::written(end),
                    date::written(b.start)
                ),
                "cut the record to one side of it",
            ));
        }
        before += a.samples.len();
    }
    let (first, last) = (&records[0], &records[records.len() - 1]);
    let drift = seconds(first, last) - before as f64 * first.dt;
    Ok(if drift.abs() > 0.5 * first.dt {
        vec![format!(
            "by the times of its records it is {:.6} s {} than its samples, whose interval was kept",
            drift.abs(),
            if drift > 0.0 { "longer" } else { "shorter" }
        )]
    } else {
        Vec::new()
    })
}

/// The channel's code, behind the last dot of its name.
fn code(name: &str) -> &str {
    name.rsplit('.').next().unwrap_or(name)
}

/// What a channel measures, by the second letter of its code.
#[derive(Clone, Copy, PartialEq)]
enum Instrument {
    Accelerometer,
    /// `G`, an accelerometer before the year 2000, a gravimeter since.
    Perhaps,
    /// `H`, `L` and `P`.
    Velocity,
    Other,
}

fn instrument(name: &str) -> Instrument {
    match code(name).as_bytes() {
        [_, b'N', _] => Instrument::Accelerometer,
        [_, b'G', _] => Instrument::Perhaps,
        [_, b'H' | b'L' | b'P', _] => Instrument::Velocity,
        _ => Instrument::Other,
    }
}

/// Whether a channel is of an accelerometer, perhaps, by its code.
pub(super) fn accelerates(name: &str) -> bool {
    instrument(name).accelerates()
}

impl Instrument {
    /// Whether it records acceleration, perhaps.
    fn accelerates(self) -> bool {
        matches!(self, Instrument::Accelerometer | Instrument::Perhaps)
    }

    fn remark(self) -> Option<String> {
        let remark = match self {
            Instrument::Accelerometer => return None,
            Instrument::Perhaps => {
                "G in the channel's code was an accelerometer until 2000 and is a gravimeter since: see which it is"
            }
            Instrument::Velocity => {
                "by its code the channel is not of an accelerometer but of a seismometer, whose counts are velocity"
            }
            Instrument::Other => "by its code the channel is not of an accelerometer",
        };
        Some(remark.into())
    }
}

/// Units of a channel's samples: counts, or for floats what was declared.
pub(super) fn units(
    source: &Source,
    at: usize,
    name: &str,
    float: bool,
    options: &ReadOptions,
) -> Result<Units, Error> {
    let fault = |problem: String, remedy: &str| Err(Error::binary(source.file, at, problem, remedy));
    let known = instrument(name).accelerates();
    match (options.units.unwrap_or(Units::Counts), options.sensitivity) {
        (Units::Counts, Some(_)) if !known => fault(
            format!(
                "channel {name} is not of an accelerometer by the second letter of its code, but a sensitivity \
                 to acceleration was declared"
            ),
            "give a file of an accelerometer's channels alone: their second letter is N, as in HNE",
        ),
        (Units::Counts, _) => Ok(Units::Counts),
        (units, _) if float => Ok(units),
        (units, _) => fault(
            format!(
                "channel {name} holds whole numbers, which are counts, but units = \"{units}\" was declared"
            ),
            "declare a sensitivity in its place, as the station's StationXML states it, for example \
             \"427336 counts/(m/s2)\"",
        ),
    }
}
