//! Target spectra, and motions that are made to fit one.

use crate::arrays::column;
use crate::errors::unusable;
use crate::motion::{of_python, to_python, told};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;
use tremolite_motion::{
    Channel, Envelope, Misfit, TargetSpectrum, artificial, correlation, matched, misfit, scale_to, select,
};

/// A band of periods \[s\], the shorter first.
type Band = Option<(f64, f64)>;

/// A component by its place: what to multiply it by, its misfit, the largest, and the period \[s\] of that.
type Row = (usize, f64, f64, f64, f64);

/// A response spectrum that motions are to fit: pseudo-acceleration, horizontal.
///
/// `Target("EN 1998-1 type 1 ground B 2 m/s2")`, or the path of a CSV file with the columns `period [s]` and `sa [m/s2]` or `sa [g]`; both for 5 %
/// damping. `Target.of_table` takes arrays.
#[pyclass(frozen, module = "tremolite")]
pub struct Target {
    spectrum: TargetSpectrum,
}

#[pymethods]
impl Target {
    #[new]
    fn new(words: PathBuf) -> PyResult<Self> {
        let read = if words.is_file() {
            TargetSpectrum::read(&words)
        } else {
            TargetSpectrum::parse(&words.to_string_lossy())
        };
        Ok(Target { spectrum: read.map_err(told)? })
    }

    /// A target of pseudo-accelerations (n,) [m/s²] at rising periods (n,) [s], straight between them in logarithms, for a damping ratio.
    #[staticmethod]
    #[pyo3(signature = (periods, sa, *, damping = 0.05, name = "target"))]
    fn of_table(periods: Vec<f64>, sa: Vec<f64>, damping: f64, name: &str) -> PyResult<Self> {
        if periods.len() != sa.len() {
            return Err(unusable(format!(
                "{} periods have {} accelerations; give one a period",
                periods.len(),
                sa.len()
            )));
        }
        let points: Vec<[f64; 2]> = periods.into_iter().zip(sa).map(|(t, a)| [t, a]).collect();
        Ok(Target { spectrum: TargetSpectrum::of_table(name, damping, &points).map_err(told)? })
    }

    #[getter]
    fn name(&self) -> &str {
        &self.spectrum.name
    }

    /// Ratio to critical damping for which it holds.
    #[getter]
    fn damping(&self) -> f64 {
        self.spectrum.damping
    }

    /// The shortest and the longest period [s] for which it says something.
    #[getter]
    fn range(&self) -> (f64, f64) {
        self.spectrum.range().into()
    }

    /// Pseudo-acceleration (n,) [m/s²] at periods (n,) [s]; beyond `range` that of its end.
    fn at<'py>(&self, py: Python<'py>, periods: Vec<f64>) -> PyResult<Bound<'py, PyAny>> {
        column(py, periods.into_iter().map(|t| self.spectrum.at(t)).collect())
    }

    fn __repr__(&self) -> String {
        let [from, to] = self.spectrum.range();
        format!("<target {:?}, {from:.3} s to {to:.3} s>", self.spectrum.name)
    }
}

impl Target {
    fn band(&self, asked: Band) -> PyResult<[f64; 2]> {
        self.spectrum.band(asked.map(|(from, to)| [from, to])).map_err(told)
    }
}

fn only(motion: &Bound<'_, PyAny>) -> PyResult<Channel> {
    let channels = of_python(motion)?;
    channels.into_iter().next().ok_or_else(|| unusable("a record has one channel and more"))
}

fn said<'py>(py: Python<'py>, found: &Misfit) -> PyResult<Bound<'py, PyDict>> {
    let made = PyDict::new(py);
    for (name, value) in [("largest", found.largest), ("period", found.period), ("rms", found.rms)] {
        made.set_item(name, value)?;
    }
    Ok(made)
}

/// The first channel of a record made to fit a target in a band [s], as a record of one; what it was multiplied by, and its misfits before and
/// after.
#[pyfunction]
#[pyo3(signature = (motion, target, band, tolerance))]
fn match_record<'py>(
    motion: &Bound<'py, PyAny>,
    target: &Bound<'py, Target>,
    band: Band,
    tolerance: f64,
) -> PyResult<(Bound<'py, PyAny>, f64, [Bound<'py, PyDict>; 2])> {
    let (py, target, channel) = (motion.py(), target.get(), only(motion)?);
    let band = target.band(band)?;
    let made = py.detach(|| matched(&channel, &target.spectrum, band, tolerance)).map_err(told)?;
    let misfits = [said(py, &made.before)?, said(py, &made.after)?];
    Ok((to_python(py, &[made.channel])?, made.factor, misfits))
}

/// How far the first channel of a record is from a target in a band [s], and the factor that brings it to it in the mean of the logarithm.
#[pyfunction]
fn misfit_of<'py>(
    motion: &Bound<'py, PyAny>,
    target: &Bound<'py, Target>,
    band: Band,
) -> PyResult<(Bound<'py, PyDict>, f64)> {
    let (py, target, channel) = (motion.py(), target.get(), only(motion)?);
    let band = target.band(band)?;
    let (found, factor) = py.detach(|| {
        let (a, dt) = (&channel.acceleration, channel.dt);
        (misfit(a, dt, &target.spectrum, band), scale_to(a, dt, &target.spectrum, band))
    });
    Ok((said(py, &found.map_err(told)?)?, factor.map_err(told)?))
}

/// Artificial motions, each a channel of one record, and the largest correlation of two.
#[pyfunction]
fn artificial_record<'py>(
    target: &Bound<'py, Target>,
    band: Band,
    envelope: (f64, Option<f64>, Option<f64>),
    dt: f64,
    seeds: (u64, u64),
    tolerance: f64,
) -> PyResult<(Bound<'py, PyAny>, f64)> {
    let ((duration, rise, fall), (seed, count)) = (envelope, seeds);
    let (py, target) = (target.py(), target.get());
    let band = target.band(band)?;
    let last = seed.checked_add(count).filter(|_| (1..=100).contains(&count));
    let last = last.ok_or_else(|| unusable("count is from 1 to 100"))?;
    let envelope = Envelope::new(duration, rise, fall).map_err(told)?;
    let made = py
        .detach(|| artificial(&target.spectrum, band, envelope, dt, seed..last, tolerance))
        .map_err(told)?;
    let channels: Vec<Channel> = made.into_iter().map(|one| one.channel).collect();
    let mut most = 0.0_f64;
    for (i, a) in channels.iter().enumerate() {
        channels[..i]
            .iter()
            .for_each(|b| most = most.max(correlation(&a.acceleration, &b.acceleration).abs()));
    }
    Ok((to_python(py, &channels)?, most))
}

/// Channels of a record by rising misfit to a target: number, factor, misfit, largest and its period, of those whose factor is within `factors`;
/// and how many are not.
#[pyfunction]
fn select_records(
    motion: &Bound<'_, PyAny>,
    target: &Bound<'_, Target>,
    band: Band,
    factors: (f64, f64),
) -> PyResult<(Vec<Row>, usize)> {
    let (py, target, channels) = (motion.py(), target.get(), of_python(motion)?);
    let band = target.band(band)?;
    if !(factors.0 > 0.0 && factors.0 < factors.1) {
        return Err(unusable("factors are two above 0, the smaller first"));
    }
    let found = py.detach(|| select(&channels, &target.spectrum, band, factors.into()));
    let [fit, unfit] = found.map_err(told)?;
    let row = |c: tremolite_motion::Candidate| (c.record, c.factor, c.misfit, c.largest, c.period);
    Ok((fit.into_iter().map(row).collect(), unfit.len()))
}

pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Target>()?;
    module.add_function(wrap_pyfunction!(match_record, module)?)?;
    module.add_function(wrap_pyfunction!(misfit_of, module)?)?;
    module.add_function(wrap_pyfunction!(artificial_record, module)?)?;
    module.add_function(wrap_pyfunction!(select_records, module)?)
}
