//! The records of a case: read, put on one time base, and looked at for what they say of themselves.

use super::memory::{Inputs, checked};
use std::ops::Range;
use std::path::Path;
use tremolite_case::{
    self as case, Case, Component, Diagnostic, Direction, RecordUnit, Records, Spanned, Window,
};
use tremolite_motion::{
    Channel, Encoding, Geographic, Orientation, ReadOptions, TextColumn, Units, align, common_time_base,
    read, strongest_window,
};

/// A component whose file states another direction, by more than this \[deg\], is warned of: no network turns its sensors
/// further from the direction that it names them by, and two components are 90° apart.
const LARGEST_TURN: f64 = 30.0;

/// The channels of a case on one time base, and what is to be warned of; nothing if one was refused.
pub fn of(
    case: &Case,
    motion: &case::Motion,
    held: &Inputs,
    problems: &mut Vec<Diagnostic>,
) -> Option<(Channels, Vec<Diagnostic>)> {
    let mut warnings = Vec::new();
    // Each with the place of its file in the case.
    let (mut channels, places) = match &motion.records {
        Records::File(file) => {
            let encoding = encoding(motion.encoding.as_ref(), problems)?;
            let options = ReadOptions { encoding, ..ReadOptions::default() };
            let options = with_sensitivity(case, options, motion.sensitivity.as_ref(), problems)?;
            let all = channels(case, &file.value, held, &options)
                .map_err(|(message, mut remedy)| {
                    if ["units =", "columns =", "dt ="].iter().any(|key| remedy.contains(key)) {
                        remedy +=
                            "; such files go in as components, east = { file = \"…\", units = \"cm/s2\" }";
                    }
                    problems.push(Diagnostic::at(file, message, remedy));
                })
                .ok()?;
            let places = vec![file.span.clone(); all.len()];
            (Channels::Oriented(all), places)
        }
        Records::Components(components) => {
            let found = components_of(case, components, held, problems)?;
            let place = |component: &Option<Component>| match component {
                Some(Component::Record(record)) => Some(record.file.span.clone()),
                Some(Component::Scaled { from, .. }) => Some(from.span.clone()),
                None => None,
            };
            for (axis, channel) in found.iter().enumerate() {
                if let (Some(channel), Some(place)) = (channel, place(&components[axis])) {
                    warnings.extend(turned(channel, axis, place));
                }
            }
            (Channels::Named(Box::new(found)), components.iter().filter_map(place).collect())
        }
    };
    refuse_what_is_no_acceleration(&mut channels, &places, problems)?;
    align(&mut channels.each());
    let before: Vec<Channel> = channels.all().into_iter().cloned().collect();
    if let Err(e) = channels.share_time() {
        let (message, remedy) = e.message_and_remedy();
        problems.push(Diagnostic::new(motion.span.clone(), message, remedy));
        return None;
    }
    for ((whole, kept), place) in before.iter().zip(channels.all()).zip(&places) {
        warnings.extend(not_shared(whole, kept, place));
    }
    for (channel, place) in channels.each().iter().zip(&places) {
        let remark = |remark: &String| {
            Diagnostic::new(
                place.clone(),
                remark.clone(),
                "nothing, if that is meant; else look at the record's file",
            )
        };
        warnings.extend(channel.remarks.iter().map(remark));
    }
    Some((channels, warnings))
}

/// Share of a component's ∫a² dt that may lie outside the span that all components have.
const NOT_SHARED: f64 = 0.01;

/// A component of which the span that all components share leaves something out.
fn not_shared(whole: &Channel, kept: &Channel, place: &Range<usize>) -> Option<Diagnostic> {
    let mean = whole.acceleration.iter().sum::<f64>() / whole.acceleration.len() as f64;
    let energy = |inside: bool| -> f64 {
        let span = kept.start - 0.5 * whole.dt..=kept.end() + 0.5 * whole.dt;
        let time = |k: usize| whole.start + k as f64 * whole.dt;
        let samples =
            whole.acceleration.iter().enumerate().filter(|(k, _)| inside || !span.contains(&time(*k)));
        samples.map(|(_, a)| (a - mean).powi(2)).sum()
    };
    let share = energy(false) / energy(true);
    (share > NOT_SHARED).then(|| {
        Diagnostic::new(
            place.clone(),
            format!(
                "'{}': {:.0} % of its energy (∫a² dt) does not enter; it lasts from {:.2} s to {:.2} s, all components together from {:.2} s to \
                 {:.2} s",
                whole.name,
                100.0 * share,
                whole.start,
                whole.end(),
                kept.start,
                kept.end()
            ),
            "give components of one length, the shorter ones with zeros at their ends, or leave the shortest component out",
        )
    })
}

/// Nothing, if one channel is of a sensor that does not record acceleration, or in counts still.
fn refuse_what_is_no_acceleration(
    channels: &mut Channels,
    places: &[Range<usize>],
    problems: &mut Vec<Diagnostic>,
) -> Option<()> {
    let before = problems.len();
    for (channel, place) in channels.each().iter().zip(places) {
        if problems[before..].iter().any(|p| p.span == *place) {
            continue;
        }
        // First, since for such a sensor there is no sensitivity to ask for.
        if let Err(e) = channel.of_accelerometer() {
            let (message, remedy) = e.message_and_remedy();
            problems.push(Diagnostic::new(place.clone(), message, remedy));
        } else if channel.raw {
            problems.push(Diagnostic::new(
                place.clone(),
                format!("'{}' is in counts, and nothing says what a count is", channel.name),
                "write, beside file, sensitivity = \"427336 counts/(m/s2)\" with the figure that the network's station metadata \
                 state",
            ));
        }
    }
    (problems.len() == before).then_some(())
}

/// The options with the sensitivity or the StationXML file that is written; none if it cannot be read, which is then among the problems.
fn with_sensitivity(
    case: &Case,
    options: ReadOptions,
    written: Option<&Spanned<String>>,
    problems: &mut Vec<Diagnostic>,
) -> Option<ReadOptions> {
    let Some(written) = written else { return Some(options) };
    match options.with_sensitivity(&written.value, |file| case.resolve(file)) {
        Ok(options) => Some(options),
        Err(message) => {
            let remedy = "take the figure from the network's station metadata, where it is often called InstrumentSensitivity";
            problems.push(Diagnostic::at(written, message, remedy));
            None
        }
    }
}

/// The encoding that is written; none if there is no such, which is then among the problems.
fn encoding(
    written: Option<&Spanned<String>>,
    problems: &mut Vec<Diagnostic>,
) -> Option<Option<&'static Encoding>> {
    let Some(written) = written else { return Some(None) };
    match tremolite_motion::encoding(&written.value) {
        Ok(encoding) => Some(Some(encoding)),
        Err(message) => {
            problems.push(Diagnostic::at(written, message, "write one of these names"));
            None
        }
    }
}

/// Warns of a component whose file states a direction that is not the one it is given for.
fn turned(channel: &Channel, axis: usize, place: Range<usize>) -> Option<Diagnostic> {
    let stated = channel.orientation?;
    let fits = match (stated, axis) {
        (Orientation::Up, 2) => true,
        (Orientation::Azimuth(azimuth), 0 | 1) => {
            let wanted = if axis == 0 { 90.0 } else { 0.0 };
            let apart = (azimuth.to_degrees() - wanted).rem_euclid(360.0);
            apart.min(360.0 - apart) <= LARGEST_TURN
        }
        _ => false,
    };
    let word = ["east", "north", "up"][axis];
    (!fits).then(|| {
        Diagnostic::new(
            place,
            format!("'{}' is given as `{word}`, but its file states its direction as {stated}", channel.name),
            "look whether files or channels are mixed up; a file with all components is turned by its own directions as \
             motion.file",
        )
    })
}

/// Channels as they were found.
#[derive(Clone)]
pub enum Channels {
    /// Two horizontal ones and perhaps a vertical one, by the orientations in their file.
    Oriented(Vec<Channel>),
    /// East, north, up.
    Named(Box<[Option<Channel>; 3]>),
}

impl Channels {
    /// Those that are there, in their order.
    pub fn each(&mut self) -> Vec<&mut Channel> {
        match self {
            Channels::Oriented(all) => all.iter_mut().collect(),
            Channels::Named(all) => all.iter_mut().flatten().collect(),
        }
    }

    /// The same to read.
    pub fn all(&self) -> Vec<&Channel> {
        match self {
            Channels::Oriented(all) => all.iter().collect(),
            Channels::Named(all) => all.iter().flatten().collect(),
        }
    }

    /// Those that do not say that they are vertical.
    pub fn horizontal(&self) -> Vec<&Channel> {
        match self {
            Channels::Oriented(all) => {
                all.iter().filter(|c| c.orientation != Some(Orientation::Up)).collect()
            }
            Channels::Named(all) => all[..2].iter().flatten().collect(),
        }
    }

    /// Sets them, aligned by their clocks where all have one, on one time base, by interpolation where their samples differ.
    fn share_time(&mut self) -> Result<(), tremolite_motion::Error> {
        let channels = self.each();
        let shared = common_time_base(&channels.iter().map(|c| &**c).collect::<Vec<_>>())?;
        for (channel, on_base) in channels.into_iter().zip(shared) {
            *channel = on_base;
        }
        Ok(())
    }

    /// Cuts them to the window.
    pub fn cut(&mut self, window: Window) -> Result<(), tremolite_motion::Error> {
        let mut channels = self.each();
        let (from, to) = match window {
            Window::Between(from, to) => (from, to),
            Window::Strongest(length) => {
                let shared: Vec<&Channel> = channels.iter().map(|c| &**c).collect();
                let strongest = strongest_window(&shared, length)?;
                (strongest.start, strongest.end)
            }
        };
        for channel in &mut channels {
            **channel = channel.window(from, to)?;
        }
        Ok(())
    }

    /// Where they came from, in words, and from when to when they last \[s\].
    pub fn facts(&mut self) -> (String, [f64; 2]) {
        let channels = self.each();
        let words: Vec<String> = channels.iter().map(|c| format!("{} ({})", c.name, c.units)).collect();
        let window = channels.first().map_or([0.0; 2], |c| [c.start, c.end()]);
        (words.join("; "), window)
    }

    /// East, north and up of them.
    pub fn geographic(&self) -> Result<Geographic, tremolite_motion::Error> {
        match self {
            Channels::Oriented(all) => Geographic::from_channels(all),
            Channels::Named(named) => {
                let [east, north, up] = named.as_ref();
                Geographic::from_parts(east.as_ref(), north.as_ref(), up.as_ref())
            }
        }
    }
}

/// East, north and up, each from its own record or another's times a factor.
fn components_of(
    case: &Case,
    components: &[Option<Component>; 3],
    held: &Inputs,
    problems: &mut Vec<Diagnostic>,
) -> Option<[Option<Channel>; 3]> {
    let before = problems.len();
    let mut found: [Option<Channel>; 3] = [None, None, None];
    for (axis, component) in components.iter().enumerate() {
        if let Some(Component::Record(record)) = component {
            found[axis] = record_channel(case, record, axis, held, problems);
        }
    }
    for (axis, component) in components.iter().enumerate() {
        if let Some(Component::Scaled { from, factor }) = component {
            let source = match from.value {
                Direction::East => 0,
                Direction::North => 1,
                Direction::Up => 2,
            };
            if let Some(mut channel) = found[source].clone() {
                channel.acceleration.iter_mut().for_each(|a| *a *= factor.value);
                channel.name = format!("{} times {}", channel.name, factor.value);
                // What was remarked on it is said at its own file, and it looks another way now.
                channel.remarks.clear();
                channel.orientation = None;
                found[axis] = Some(channel);
            }
        }
    }
    (problems.len() == before).then_some(found)
}

/// The channels of a file, or of what is in memory by its name; else what is wrong and what to do about it.
fn channels(
    case: &Case,
    file: &Path,
    held: &Inputs,
    options: &ReadOptions,
) -> Result<Vec<Channel>, (String, String)> {
    match held.record(file) {
        Some(channels) => checked(file, channels, options.dt),
        None => read(&case.resolve(file), options).map_err(|e| e.message_and_remedy()),
    }
}

fn record_channel(
    case: &Case,
    record: &case::Record,
    axis: usize,
    held: &Inputs,
    problems: &mut Vec<Diagnostic>,
) -> Option<Channel> {
    let units = record.units.as_ref().and_then(|u| match u.value {
        RecordUnit::Counts => Some(Units::Counts),
        RecordUnit::Acceleration(value) => {
            let known =
                [Units::G, Units::MetrePerSecond2, Units::CentimetrePerSecond2, Units::MillimetrePerSecond2];
            known.into_iter().find(|k| k.factor().is_some_and(|factor| (factor / value - 1.0).abs() < 1e-9))
        }
    });
    let columns: Vec<TextColumn> = record
        .columns
        .iter()
        .map(|c| match c.value {
            case::TextColumn::Time => TextColumn::Time,
            case::TextColumn::Acceleration => TextColumn::Acceleration(None),
            case::TextColumn::Skip => TextColumn::Skip,
            case::TextColumn::Rows => TextColumn::Rows,
        })
        .collect();
    let options = ReadOptions {
        units,
        columns: (!columns.is_empty()).then_some(columns),
        dt: record.dt.as_ref().map(|d| d.value),
        encoding: encoding(record.encoding.as_ref(), problems)?,
        ..ReadOptions::default()
    };
    let options = with_sensitivity(case, options, record.sensitivity.as_ref(), problems)?;
    let channels = match channels(case, &record.file.value, held, &options) {
        Ok(channels) => channels,
        Err((message, remedy)) => {
            problems.push(Diagnostic::at(&record.file, message, remedy));
            return None;
        }
    };
    // The label stays what it is where the file is renamed.
    let shown = |c: &Channel| if c.label.is_empty() { c.name.clone() } else { c.label.clone() };
    let names: Vec<String> = channels.iter().map(shown).collect();
    let chosen = match &record.channel {
        Some(wanted) => channels.into_iter().find(|c| c.is_called(&wanted.value)),
        None if channels.len() == 1 => channels.into_iter().next(),
        None => {
            let wanted = [Orientation::EAST, Orientation::NORTH, Orientation::Up][axis];
            let mut fitting = channels.into_iter().filter(|c| c.orientation == Some(wanted));
            // Two sensors of one direction, one of them deeper perhaps, are not one the other.
            fitting.next().filter(|_| fitting.next().is_none())
        }
    };
    if chosen.is_none() {
        let message = format!("the channel is not clear: the file has {}", names.join(", "));
        let remedy = "name one with channel = \"…\", or give motion.file to use all by their orientation";
        match &record.channel {
            Some(wanted) => problems.push(Diagnostic::at(wanted, message, remedy)),
            None => problems.push(Diagnostic::at(&record.file, message, remedy)),
        }
    }
    chosen
}
