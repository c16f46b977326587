//! Stages before the earthquake: one by one, and more of them than the case had.

use super::{Simulation, Wish, over};
use crate::errors::{failed, refused, unusable};
use crate::made::Made;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::atomic::Ordering;
use std::time::Instant;
use tremolite::simulation::{self, Ending, Go};
use tremolite_case::Case;
use tremolite_laws::materials::MATERIALS;

/// A stage that has come to rest.
#[pyclass(frozen, module = "tremolite", get_all)]
pub struct StageEnd {
    /// Its place among the stages, from 0.
    number: usize,
    name: String,
    /// Cycles of relaxation.
    cycles: u64,
    /// What is out of balance over all contributions.
    ratio: f64,
}

#[pymethods]
impl StageEnd {
    fn __repr__(&self) -> String {
        format!("<stage {} {:?} at rest after {} cycles>", self.number, self.name, self.cycles)
    }
}

/// The stages that are left: each comes to rest as it is asked for.
#[pyclass(frozen, module = "tremolite")]
pub struct Stages(Py<Simulation>);

impl Stages {
    pub(super) fn of(simulation: Py<Simulation>) -> Self {
        Stages(simulation)
    }
}

#[pymethods]
impl Stages {
    fn __iter__(slf: PyRef<'_, Self>) -> PyRef<'_, Self> {
        slf
    }

    fn __next__(&self, py: Python<'_>) -> PyResult<Option<StageEnd>> {
        self.0.get().relax(py)
    }
}

impl Simulation {
    /// Brings the next stage to rest; none where none is left.
    fn relax(&self, py: Python<'_>) -> PyResult<Option<StageEnd>> {
        let end = self.drive(py, |held, stop| {
            let Some(number) = held.simulation.stage() else { return Ok(None) };
            let name = held.simulation.plan().stages[number].name.clone();
            let begin = Instant::now();
            let end =
                held.simulation.relax(&mut |_| if stop.load(Ordering::Relaxed) { Go::Stop } else { Go::On });
            held.stage_seconds += begin.elapsed().as_secs_f64();
            let end = end?;
            held.ending = match &end {
                simulation::StageEnd::Restless { relaxed, place } => {
                    Some(Ending::Restless { stage: name.clone(), relaxed: *relaxed, place: place.clone() })
                }
                simulation::StageEnd::SnappedBack { lost, held } => {
                    Some(Ending::SnappedBack { stage: name.clone(), lost: *lost, held: *held })
                }
                _ => None,
            };
            Ok(Some((number, name, end)))
        })?;
        match end {
            None => Ok(None),
            Some((number, name, simulation::StageEnd::AtRest(rest))) => {
                Ok(Some(StageEnd { number, name, cycles: rest.cycles, ratio: rest.ratio }))
            }
            Some((_, name, simulation::StageEnd::Stopped)) => Err(failed(format!(
                "the stage {name:?} was stopped; ask for the next stage to go on with it"
            ))),
            Some((_, name, simulation::StageEnd::Restless { place, .. })) => Err(failed(format!(
                "the stage {name:?} does not come to rest: most moves at {place}; finish() says more"
            ))),
            Some((_, name, simulation::StageEnd::SnappedBack { .. })) => {
                Err(failed(format!("what the stage {name:?} moves snapped back; finish() says more")))
            }
        }
    }

    /// As `add_stage`.
    pub(super) fn grow(&self, py: Python<'_>, stage: &Bound<'_, PyDict>) -> PyResult<()> {
        let (done, taken) = {
            let held = self.held()?;
            let simulation = &held.as_ref().ok_or_else(over)?.simulation;
            (simulation.stage().unwrap_or(simulation.plan().stages.len()), simulation.taken())
        };
        if !self.watches.is_empty() || self.follows {
            return Err(unusable(
                "stages are added to a run of its own without a callback; look between stages instead, and leave callback and from_ out",
            ));
        }
        if taken > 0 {
            return Err(unusable("the ground shakes already; add stages before the first step"));
        }
        let stages = PyDict::new(py);
        stages.set_item("stage", vec![stage])?;
        let added: String = py.import("tremolite._toml")?.call_method1("document", (stages,))?.extract()?;
        let old = self.made()?.clone();
        let text = format!("{}\n\n{added}", old.case.source.trim_end());
        let case = Case::parse_in(&old.case.path, &old.case.directory, &text, &[], MATERIALS);
        let case = case.map_err(|report| refused(py, &report))?;
        let threads = Some(self.pool.current_num_threads());
        let made = Made::build(py, &case, &old.given(), old.fields.clone(), threads)?;
        // The folder is let go of first.
        drop(self.held()?.take());
        let wish = Wish { out: Some(self.out.clone()), overwrite: true, threads, ..Wish::default() };
        let anew = Simulation::begin(py, &made, wish)?;
        *self.held()? = anew.held()?.take();
        *self.made()? = made;
        if let Some(interrupt) = anew.asker.desk.raised() {
            return Err(interrupt);
        }
        for _ in 0..done {
            self.relax(py)?;
        }
        Ok(())
    }
}
