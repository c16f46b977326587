//! Records as arrays, both ways; processing and spectra.

use crate::arrays::column;
use crate::errors::unusable;
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;
use tremolite_motion::{
    Channel, Error, Geographic, Intensity, Orientation, Process, ReadOptions, TextColumn, Units, process,
    pseudo_acceleration, read, write_text,
};

/// A channel as Python has it.
#[derive(FromPyObject)]
struct Given<'py> {
    name: String,
    dt: f64,
    acceleration: PyReadonlyArray1<'py, f64>,
    azimuth: Option<f64>,
    up: bool,
    start: f64,
}

/// The channels of a Python `Motion`.
///
/// # Errors
/// If it is none, or a channel is not such as readers hand out.
pub fn of_python(motion: &Bound<'_, PyAny>) -> PyResult<Vec<Channel>> {
    let none = |_| {
        unusable(
            "a record is a tremolite.Motion: Motion.read, Motion.from_stream or Motion(channels) makes one",
        )
    };
    let channels: Vec<Given> = motion.getattr("channels").map_err(none)?.extract().map_err(none)?;
    let channel = |given: Given| {
        let orientation = match (given.up, given.azimuth) {
            (true, _) => Some(Orientation::Up),
            (false, azimuth) => azimuth.map(Orientation::from_degrees),
        };
        let made = Channel::new(given.name, given.dt, given.acceleration.as_array().to_vec());
        let made = Channel { start: given.start, orientation, ..made };
        made.sound().map_err(told)?;
        Ok(made)
    };
    channels.into_iter().map(channel).collect()
}

/// What records and spectra cannot be used for, with the way out.
pub fn told(error: Error) -> PyErr {
    let (message, remedy) = error.message_and_remedy();
    unusable(format!("{message}; {remedy}"))
}

/// Channels as a Python `Motion`.
///
/// # Errors
/// If NumPy is not there.
pub fn to_python<'py>(py: Python<'py>, channels: &[Channel]) -> PyResult<Bound<'py, PyAny>> {
    let module = py.import("tremolite._motion")?;
    let one = module.getattr("Channel")?;
    let channel = |channel: &Channel| {
        let named = PyDict::new(py);
        named.set_item("name", &channel.name)?;
        named.set_item("dt", channel.dt)?;
        named.set_item("acceleration", column(py, channel.acceleration.clone())?)?;
        named.set_item("start", channel.start)?;
        match channel.orientation {
            Some(Orientation::Up) => named.set_item("up", true)?,
            Some(Orientation::Azimuth(azimuth)) => named.set_item("azimuth", azimuth.to_degrees())?,
            None => {}
        }
        one.call((), Some(&named))
    };
    let channels = channels.iter().map(channel).collect::<PyResult<Vec<_>>>()?;
    module.getattr("Motion")?.call1((channels,))
}

/// Reads a record, in whatever format; a `Motion`, and what reading did beside reading, a sentence each.
#[pyfunction]
#[pyo3(signature = (path, units = None, dt = None, sensitivity = None, columns = None, encoding = None))]
fn read_record<'py>(
    py: Python<'py>,
    path: PathBuf,
    units: Option<&str>,
    dt: Option<f64>,
    sensitivity: Option<&str>,
    columns: Option<Vec<String>>,
    encoding: Option<&str>,
) -> PyResult<(Bound<'py, PyAny>, Vec<String>)> {
    let units = units.map(|word| {
        word.parse::<Units>().map_err(|_| {
            unusable(format!(
                "{word:?} is no unit of a record; write \"m/s2\", \"cm/s2\", \"mm/s2\", \"g\" or \"counts\""
            ))
        })
    });
    let columns: Option<Result<Vec<TextColumn>, String>> =
        columns.map(|words| words.iter().map(|word| word.parse()).collect());
    let columns = columns.transpose().map_err(unusable)?;
    let encoding = encoding.map(tremolite_motion::encoding).transpose().map_err(unusable)?;
    let mut options =
        ReadOptions { units: units.transpose()?, columns, dt, encoding, ..ReadOptions::default() };
    if let Some(written) = sensitivity {
        options = options.with_sensitivity(written, std::path::Path::to_path_buf).map_err(unusable)?;
    }
    let channels = py.detach(|| read(&path, &options)).map_err(told)?;
    if let Some(raw) = channels.iter().find(|channel| channel.raw) {
        return Err(unusable(format!(
            "'{}' is in counts, and nothing says what a count is; give sensitivity=",
            raw.name
        )));
    }
    let remarks = channels.iter().flat_map(|channel| channel.remarks.clone()).collect();
    Ok((to_python(py, &channels)?, remarks))
}

/// A record after steps of processing, as `motion.processing` of a case has them.
#[pyfunction]
fn process_record<'py>(motion: &Bound<'py, PyAny>, steps: Vec<String>) -> PyResult<Bound<'py, PyAny>> {
    let mut channels = of_python(motion)?;
    let steps =
        steps.iter().map(|step| Process::parse(step).map_err(|fault| unusable(format!("{step:?}: {fault}"))));
    let steps = steps.collect::<PyResult<Vec<Process>>>()?;
    process(&mut channels.iter_mut().collect::<Vec<_>>(), &steps).map_err(told)?;
    to_python(motion.py(), &channels)
}

/// Writes the channels of a record as text columns, each to its file: reading them gives the same samples bit for bit.
#[pyfunction]
fn write_record(motion: &Bound<'_, PyAny>, paths: Vec<PathBuf>) -> PyResult<()> {
    let channels = of_python(motion)?;
    channels.iter().zip(&paths).try_for_each(|(channel, path)| write_text(channel, &[], path)).map_err(told)
}

/// East, north and up of a record, turned from whatever its channels look to: `dt` [s], `start` [s], and an array (n,) [m/s²] for
/// each.
#[pyfunction]
fn geographic<'py>(motion: &Bound<'py, PyAny>) -> PyResult<(f64, f64, [Bound<'py, PyAny>; 3])> {
    let py = motion.py();
    let Geographic { dt, start, east, north, up, .. } =
        Geographic::from_channels(&of_python(motion)?).map_err(told)?;
    let [east, north, up] = [east, north, up].map(|part| column(py, part));
    Ok((dt, start, [east?, north?, up?]))
}

/// Pseudo-acceleration (n,) [m/s²] at periods [s] of an oscillator with a damping ratio under an acceleration [m/s²].
#[pyfunction]
fn spectrum<'py>(
    py: Python<'py>,
    acceleration: PyReadonlyArray1<'py, f64>,
    dt: f64,
    periods: Vec<f64>,
    damping: f64,
) -> PyResult<Bound<'py, PyAny>> {
    let acceleration = acceleration.as_array().to_vec();
    let spectrum = py.detach(|| pseudo_acceleration(&acceleration, dt, &periods, damping));
    column(py, spectrum.map_err(told)?)
}

/// Measures of how strong an acceleration [m/s²] is, by name, in SI.
#[pyfunction]
fn intensity<'py>(
    py: Python<'py>,
    acceleration: PyReadonlyArray1<'py, f64>,
    dt: f64,
) -> PyResult<Bound<'py, PyDict>> {
    let Intensity { pga, pgv, pgd, arias, t5, t95, d5_95, cav, .. } =
        Intensity::of_samples(&acceleration.as_array().to_vec(), dt);
    let made = PyDict::new(py);
    let named = [
        ("pga", pga),
        ("pgv", pgv),
        ("pgd", pgd),
        ("arias", arias),
        ("t5", t5),
        ("t95", t95),
        ("d5_95", d5_95),
        ("cav", cav),
    ];
    for (name, value) in named {
        made.set_item(name, value)?;
    }
    Ok(made)
}

/// The direction of a component by its label, `NS`, `UP`, `N30E`, or by a channel's code, `HNE`: azimuth [deg] or `"up"`; None where
/// it says none.
#[pyfunction]
fn orientation(label: &str) -> (Option<f64>, bool) {
    match Orientation::of_channel_code(label).or_else(|| Orientation::parse(label)) {
        Some(Orientation::Azimuth(azimuth)) => (Some(azimuth.to_degrees()), false),
        Some(Orientation::Up) => (None, true),
        None => (None, false),
    }
}

pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(read_record, module)?)?;
    module.add_function(wrap_pyfunction!(process_record, module)?)?;
    module.add_function(wrap_pyfunction!(write_record, module)?)?;
    module.add_function(wrap_pyfunction!(geographic, module)?)?;
    module.add_function(wrap_pyfunction!(spectrum, module)?)?;
    module.add_function(wrap_pyfunction!(intensity, module)?)?;
    module.add_function(wrap_pyfunction!(orientation, module)?)
}
