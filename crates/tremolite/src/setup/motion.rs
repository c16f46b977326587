//! The motion of a case: records read, cut, processed and turned into the model's axes.

use tremolite_case::{self as case, Case, Component, Direction, Problem, Records, Window};
use tremolite_motion::{
    Channel, Column, Geographic, Intensity, Kind, Motion, Orientation, Process, ReadOptions, Units,
    highest_frequency, read, strongest_window,
};

/// The share of the velocity's energy below what counts as the highest frequency.
pub const ENERGY_SHARE: f64 = 0.999;

/// What of the motion is worth reporting.
#[derive(Clone, Debug)]
pub struct MotionFacts {
    pub kind: Kind,
    /// Factor from the given motion to the incident wave.
    pub factor: f64,
    /// Along x, y, z of the model: measures of the processed given motion (before the factor).
    pub intensity: [Intensity; 3],
    /// Where the components came from, in words.
    pub source: String,
    /// The part of the record that is used \[s\].
    pub window: [f64; 2],
    /// Frequency below which 99.9 % of the velocity's energy lies \[Hz\].
    pub highest_frequency: f64,
    /// Lowest low-pass corner that was applied \[Hz\].
    pub lowpass: Option<f64>,
}

/// The given motion in the model's axes, and what to report of it; nothing if there is none or it was refused.
pub fn build(case: &Case, problems: &mut Vec<Problem>) -> Option<(Motion, MotionFacts)> {
    let motion = case.motion.as_ref()?;
    let before = problems.len();
    let steps = steps(motion, problems);
    let kind = match motion.kind.value {
        case::MotionKind::Outcrop => Kind::Outcrop,
        case::MotionKind::Incident => Kind::Incident,
        case::MotionKind::Within => Kind::Within,
    };
    let factor = kind.incident_factor();
    if factor.is_none() {
        problems.push(Problem::at(
            &motion.kind,
            "a motion within the ground holds up-going and down-going waves; this version cannot part them",
            "deconvolve it to the up-going wave and give kind = \"incident\", or use an outcrop record",
        ));
    }
    let mut channels = match &motion.records {
        Records::File(file) => {
            all_channels(case, &case.resolve(&file.value), &file.span, problems).map(Channels::Oriented)
        }
        Records::Components(components) => components_of(case, components, problems),
    }?;
    if let Some(window) = &motion.window
        && let Err(e) = channels.cut(window.value)
    {
        problems.push(Problem::at(window, e.to_string(), "choose a window inside the record"));
    }
    for (step, word) in steps.iter().zip(&motion.process) {
        if let Err(e) = step.apply(&mut channels.each()) {
            problems.push(Problem::at(word, e.to_string(), "change this step of the processing"));
        }
    }
    if problems.len() > before {
        return None;
    }
    let (source, window) = channels.facts();
    let made = channels.geographic().and_then(|ground| {
        Motion::from_acceleration(ground.dt, ground.model_axes(motion.model_x_azimuth.value))
    });
    let made = match made {
        Ok(made) => made,
        Err(e) => {
            let remedy = "give east, north and up one by one, each with its file and channel";
            problems.push(Problem::new(motion.span.clone(), e.to_string(), remedy));
            return None;
        }
    };
    let Some(highest_frequency) = highest_frequency(&made, ENERGY_SHARE) else {
        let message = "the motion is zero everywhere, so the run would do nothing";
        problems.push(Problem::new(
            motion.span.clone(),
            message,
            "check the records, the window and the scale",
        ));
        return None;
    };
    if let Some(problem) = factor.and_then(|factor| beyond_any_earthquake(&motion.span, &made, factor)) {
        problems.push(problem);
        return None;
    }
    let facts = MotionFacts {
        kind,
        factor: factor?,
        intensity: made.acceleration.each_ref().map(|a| Intensity::of_samples(a, made.dt)),
        source,
        window,
        highest_frequency,
        lowpass: tremolite_motion::lowest_lowpass(&steps),
    };
    Some((made, facts))
}

/// More than any ground has moved in an earthquake: peaks of the incident wave \[m/s²\], \[m/s\], \[m\].
const LIMITS: [(f64, &str); 3] = [(5.0 * 9.80665, "m/s2"), (5.0, "m/s"), (5.0, "m")];

/// The refusal of an incident wave that is a mistake of units or a drifting record.
fn beyond_any_earthquake(place: &std::ops::Range<usize>, motion: &Motion, factor: f64) -> Option<Problem> {
    let series = [
        ("acceleration", &motion.acceleration),
        ("velocity", &motion.velocity),
        ("displacement", &motion.displacement),
    ];
    for ((what, components), (limit, unit)) in series.into_iter().zip(LIMITS) {
        let peak = factor * components.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        if peak > limit {
            return Some(Problem::new(
                place.clone(),
                format!(
                    "the incident wave reaches {peak:.3} {unit} of {what}, more than any earthquake: the limit is \
                     {limit:.3} {unit}"
                ),
                "look at the record's units and scale; velocity and displacement that grow are drift, which \"baseline\" as \
                 the last step of motion.process takes out",
            ));
        }
    }
    None
}

/// The steps of processing; those that cannot be read are among the problems.
fn steps(motion: &case::Motion, problems: &mut Vec<Problem>) -> Vec<Process> {
    motion
        .process
        .iter()
        .filter_map(|word| match Process::parse(word) {
            Ok(step) => Some(step),
            Err(message) => {
                let remedy = "write, say, \"pre-event 5 s\", \"taper 1 s\", \"bandpass 0.1 Hz 20 Hz\", \"pga 0.3 g\" and \"baseline\", each a step of its own";
                problems.push(Problem::at(word, message, remedy));
                None
            }
        })
        .collect()
}

/// Channels as they were found.
enum Channels {
    /// Two horizontal ones and perhaps a vertical one, by the orientations in their file.
    Oriented(Vec<Channel>),
    /// East, north, up.
    Named(Box<[Option<Channel>; 3]>),
}

impl Channels {
    fn each(&mut self) -> Vec<&mut Channel> {
        match self {
            Channels::Oriented(all) => all.iter_mut().collect(),
            Channels::Named(all) => all.iter_mut().flatten().collect(),
        }
    }

    fn cut(&mut self, window: Window) -> Result<(), tremolite_motion::Error> {
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

    fn facts(&mut self) -> (String, [f64; 2]) {
        let channels = self.each();
        let words: Vec<String> = channels.iter().map(|c| format!("{} ({})", c.name, c.units)).collect();
        let window = channels.first().map_or([0.0; 2], |c| [c.start, c.end()]);
        (words.join("; "), window)
    }

    fn geographic(&self) -> Result<Geographic, tremolite_motion::Error> {
        match self {
            Channels::Oriented(all) => Geographic::from_channels(all),
            Channels::Named(named) => {
                let [east, north, up] = named.as_ref();
                Geographic::from_parts(east.as_ref(), north.as_ref(), up.as_ref())
            }
        }
    }
}

fn all_channels(
    _: &Case,
    path: &std::path::Path,
    span: &std::ops::Range<usize>,
    problems: &mut Vec<Problem>,
) -> Option<Vec<Channel>> {
    match read(path, &ReadOptions::default()) {
        Ok(channels) => Some(channels),
        Err(e) => {
            problems.push(Problem::new(
                span.clone(),
                e.to_string(),
                "give a record in a format that is known",
            ));
            None
        }
    }
}

/// East, north and up, each from its own record or another's times a factor.
fn components_of(
    case: &Case,
    components: &[Option<Component>; 3],
    problems: &mut Vec<Problem>,
) -> Option<Channels> {
    let before = problems.len();
    let mut found: [Option<Channel>; 3] = [None, None, None];
    for (axis, component) in components.iter().enumerate() {
        if let Some(Component::Record(record)) = component {
            found[axis] = record_channel(case, record, axis, problems);
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
                found[axis] = Some(channel);
            }
        }
    }
    (problems.len() == before).then_some(Channels::Named(Box::new(found)))
}

fn record_channel(
    case: &Case,
    record: &case::Record,
    axis: usize,
    problems: &mut Vec<Problem>,
) -> Option<Channel> {
    let units = record.units.as_ref().and_then(|u| {
        let known =
            [Units::G, Units::MetrePerSecond2, Units::CentimetrePerSecond2, Units::MillimetrePerSecond2];
        known.into_iter().find(|k| k.factor().is_some_and(|factor| (factor / u.value - 1.0).abs() < 1e-9))
    });
    let columns: Vec<Column> = record
        .columns
        .iter()
        .map(|c| match c.value {
            case::Column::Time => Column::Time,
            case::Column::Acceleration => Column::Acceleration(None),
            case::Column::Skip => Column::Skip,
        })
        .collect();
    let options = ReadOptions {
        units,
        columns: (!columns.is_empty()).then_some(columns),
        dt: record.dt.as_ref().map(|d| d.value),
        sensitivity: None,
    };
    let channels = match read(&case.resolve(&record.file.value), &options) {
        Ok(channels) => channels,
        Err(e) => {
            problems.push(Problem::at(
                &record.file,
                e.to_string(),
                "mend the file, or say what it holds with units, columns and dt",
            ));
            return None;
        }
    };
    let names: Vec<String> = channels.iter().map(|c| c.name.clone()).collect();
    let chosen = match &record.channel {
        Some(wanted) => channels.into_iter().find(|c| c.name == wanted.value),
        None if channels.len() == 1 => channels.into_iter().next(),
        None => {
            let wanted = [Orientation::EAST, Orientation::NORTH, Orientation::Up][axis];
            channels.into_iter().find(|c| c.orientation == Some(wanted))
        }
    };
    if chosen.is_none() {
        let message = format!("the channel is not clear: the file has {}", names.join(", "));
        let remedy = "name one with channel = \"…\", or give motion.file to use all by their orientation";
        match &record.channel {
            Some(wanted) => problems.push(Problem::at(wanted, message, remedy)),
            None => problems.push(Problem::at(&record.file, message, remedy)),
        }
    }
    chosen
}
