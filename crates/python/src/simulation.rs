//! A run that a script holds: stage by stage, step by step, with looks between them; and one that goes to its end.

mod begin;
mod end;
mod stages;

pub use begin::Wish;
pub use stages::{StageEnd, Stages};

use crate::away::{Asker, Back, away};
use crate::errors::{failed, stopped, unusable};
use crate::look::{Look, Scene};
use crate::made::Made;
use crate::teller::Teller;
use crate::watch::Watch;
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::ThreadPool;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard};
use tremolite::RunError;
use tremolite::job::{Begun, Caller, Job};
use tremolite::phase::beats::span;
use tremolite::run::{Control, Progress, run};
use tremolite::simulation::{self, Ending, Outcome, Stepping};

/// A run that a script drives, in its folder, on threads of its own. Made by `Job.start`; use it by `with`, which finishes it.
///
/// First its stages, if there are any, one by one: `for stage in simulation.stages(): ...`; then `step(n)` until it returns False.
/// `look()` shows where it stands. Results do not depend on how it is driven. One thread at a time may drive it.
#[pyclass(frozen, module = "tremolite")]
pub struct Simulation {
    made: Mutex<Made>,
    out: PathBuf,
    pool: ThreadPool,
    asker: Asker,
    watches: Vec<Arc<Watch>>,
    /// Whether it began with another run's stages, or with its own of another time.
    follows: bool,
    held: Mutex<Option<Held>>,
}

/// What moves.
struct Held {
    simulation: simulation::Simulation,
    begun: Begun,
    caller: Caller,
    stage_seconds: f64,
    /// How it ended, once it has.
    ending: Option<Ending>,
    /// What is known of it then, where the summary could not be written.
    outcome: Option<Outcome>,
}

impl Held {
    /// Ends it where it stands, and writes what is written at the end.
    fn finish(&mut self, job: &Job) -> Result<Outcome, RunError> {
        let outcome = match self.outcome.take() {
            Some(outcome) => outcome,
            None => {
                let ending = match &self.ending {
                    Some(ending) => ending.clone(),
                    None => match self.simulation.checkpoint()? {
                        Some((halt, place)) => Ending::Failed { halt, place },
                        None => Ending::Stopped,
                    },
                };
                self.simulation.finish(ending, self.stage_seconds)?
            }
        };
        match self.begun.end(job, &outcome, &self.caller) {
            Ok(_) => Ok(outcome),
            Err(why) => {
                self.outcome = Some(outcome);
                Err(why)
            }
        }
    }
}

impl Simulation {
    /// To its end, or to where it is stopped.
    pub fn run<'py>(self, py: Python<'py>, progress: Option<Py<PyAny>>) -> PyResult<Bound<'py, PyAny>> {
        let mut held = self.held()?;
        let Held { simulation, begun, caller, .. } = held.take().ok_or_else(over)?;
        drop(held);
        let job = &self.job()?;
        let Simulation { pool, asker, .. } = &self;
        let Asker { desk, stop } = asker;
        let teller = progress.map(|tell| Teller::new(tell, job, asker));
        let back = away(py, pool, desk, stop, || -> Result<Outcome, RunError> {
            let mut tell = |now: Progress| {
                if let Some(teller) = &teller {
                    teller.tell(now);
                }
            };
            let outcome = run(simulation, &mut Control { stop, progress: &mut tell })?;
            begun.end(job, &outcome, &caller)?;
            Ok(outcome)
        })?;
        self.ended(py, back)
    }

    /// Whether Ctrl-C or a script has stopped it.
    pub fn is_to_stop(&self) -> bool {
        self.asker.stop.load(Ordering::Relaxed)
    }

    fn made(&self) -> PyResult<MutexGuard<'_, Made>> {
        // It is held for moments alone, and nothing panics then.
        self.made.lock().map_err(failed)
    }

    fn job(&self) -> PyResult<Arc<Job>> {
        Ok(self.made()?.job.clone())
    }

    fn held(&self) -> PyResult<MutexGuard<'_, Option<Held>>> {
        self.held.try_lock().map_err(|_| {
            unusable("this simulation is being driven by another thread or by the caller of this callback; wait for it")
        })
    }

    /// Work on what moves, away.
    fn drive<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&mut Held, &AtomicBool) -> Result<T, RunError> + Send,
    ) -> PyResult<T> {
        let mut held = self.held()?;
        let moving = held.as_mut().ok_or_else(over)?;
        if moving.outcome.is_some() {
            return Err(unusable(
                "this simulation has ended, and its summary could not be written; call finish() again",
            ));
        }
        let Simulation { pool, asker: Asker { desk, stop }, .. } = self;
        stop.store(false, Ordering::Relaxed);
        let back = away(py, pool, desk, stop, || work(moving, stop));
        let Back { result, interrupt } = match back {
            Ok(back) => back,
            // Work that broke off leaves nothing whole to go on with; the checkpoint in the folder stays.
            Err(why) => {
                *held = None;
                return Err(why);
            }
        };
        // Ctrl-C while a script's code ran is one like any other.
        let interrupt = match desk.raised() {
            Some(raised) if raised.is_instance_of::<PyKeyboardInterrupt>(py) => Some(raised),
            Some(raised) => return Err(raised),
            None => interrupt,
        };
        let result = result.map_err(|why| refused(&why))?;
        let Some(interrupt) = interrupt else { return Ok(result) };
        let Back { result, .. } =
            away(py, pool, desk, &AtomicBool::new(false), || moving.simulation.checkpoint())?;
        result.map_err(|why| refused(&why))?;
        Err(stopped(py, interrupt, &self.out))
    }
}

#[pymethods]
impl Simulation {
    /// An iterator over the stages that are left: each comes to rest, and is then handed out as a `StageEnd` with its number, name,
    /// cycles and ratio. Between two the script may look, or stop by `break`.
    ///
    /// Raises `RunError` where a stage does not come to rest.
    fn stages(slf: Py<Self>) -> Stages {
        Stages::of(slf)
    }

    /// Puts another stage behind those that the case has: a dict of what `[[stage]]` of a case knows, `{"name": "bench 3", "excavate":
    /// ["hall.bench3"], "bolts": {...}}`, so that a script may decide between two stages what comes next.
    ///
    /// The case grows by it, and the run is that of the case as it then is, with the same bytes as if it had been written so: since lives
    /// of elements go by all stages, those that are done are brought to rest again before this returns, which takes their time once more.
    /// Raises `CaseError`, and leaves all as it is, where the stage is none; `Error` once the ground shakes, with a callback, which would see
    /// stages twice, and behind another run's stages.
    fn add_stage(&self, py: Python<'_>, stage: &Bound<'_, PyDict>) -> PyResult<()> {
        self.grow(py, stage)
    }

    /// Makes `steps` steps of the coarsest level, or fewer where the earthquake ends before. True while it goes on, and until a callback
    /// returns False.
    ///
    /// Ctrl-C writes a checkpoint and raises `Stopped`; the simulation can go on. Raises `RunError` where a stage is left.
    #[pyo3(signature = (steps = 1))]
    fn step(&self, py: Python<'_>, steps: u64) -> PyResult<bool> {
        self.drive(py, |held, stop| {
            for _ in 0..steps {
                match held.simulation.step(1)? {
                    Stepping::On => {}
                    Stepping::Done => {
                        held.ending = Some(Ending::Done);
                        return Ok(false);
                    }
                    Stepping::Failed { halt, place } => {
                        held.ending = Some(Ending::Failed { halt, place });
                        return Ok(false);
                    }
                    Stepping::Astray { why } => {
                        held.ending = Some(Ending::Astray { why });
                        return Ok(false);
                    }
                }
                if stop.load(Ordering::Relaxed) {
                    return Ok(false);
                }
            }
            Ok(true)
        })
    }

    /// A `Look` at where it stands. Nothing changes by it.
    fn look(&self, py: Python<'_>) -> PyResult<Look> {
        let (phase, look, stage) = self.drive(py, |held, _| {
            let (phase, look) = held.simulation.look()?;
            let stage = match phase.stage {
                tremolite::Stage::Before(stage) => {
                    Some(held.simulation.plan().stages[usize::from(stage)].name.clone())
                }
                tremolite::Stage::Shaking => None,
            };
            Ok((phase, look, stage))
        })?;
        let job = self.job()?;
        let scene = Scene { model: job.model.clone(), assembly: job.assembly.clone(), phase };
        Ok(Look::new(scene, look.snapshot, look.history, stage, None))
    }

    /// Writes a checkpoint of where it stands.
    ///
    /// Raises `RunError` where energy has appeared; an older checkpoint then stays.
    fn checkpoint(&self, py: Python<'_>) -> PyResult<()> {
        match self.drive(py, |held, _| held.simulation.checkpoint())? {
            None => Ok(()),
            Some((_, place)) => {
                Err(failed(format!("no checkpoint is written: energy has appeared, most at {place}")))
            }
        }
    }

    /// Goes back to the checkpoint in its folder.
    fn restore(&self, py: Python<'_>) -> PyResult<()> {
        self.drive(py, |held, _| {
            held.ending = None;
            held.simulation.restore()
        })
    }

    /// Ends it where it stands, with a checkpoint if it is not at its end: writes the summary and the page, and returns a `Result`. Where a file
    /// cannot be written, `RunError` says so, and it may be called again.
    pub fn finish<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let mut held = self.held()?;
        let moving = held.as_mut().ok_or_else(over)?;
        let job = &self.job()?;
        let Simulation { pool, asker: Asker { desk, stop }, .. } = self;
        let back = match away(py, pool, desk, stop, || moving.finish(job)) {
            Ok(back) => back,
            Err(why) => {
                *held = None;
                return Err(why);
            }
        };
        // What could not be written, on a full disk for one, can be once there is room.
        if back.result.is_ok() {
            *held = None;
        }
        drop(held);
        self.ended(py, back)
    }

    /// The folder of the results.
    #[getter]
    fn out(&self) -> &Path {
        &self.out
    }

    /// Time since the earthquake began [s].
    #[getter]
    fn time(&self) -> PyResult<f64> {
        Ok(self.held()?.as_ref().ok_or_else(over)?.simulation.time())
    }

    /// Steps of the finest level since then.
    #[getter]
    fn taken(&self) -> PyResult<u64> {
        Ok(self.held()?.as_ref().ok_or_else(over)?.simulation.taken())
    }

    /// The stage that comes next or goes on; None once all are done.
    #[getter]
    fn stage(&self) -> PyResult<Option<String>> {
        let held = self.held()?;
        let simulation = &held.as_ref().ok_or_else(over)?.simulation;
        Ok(simulation.stage().map(|stage| simulation.plan().stages[stage].name.clone()))
    }

    /// A step of `step` [s], of the coarsest level.
    #[getter]
    fn dt(&self) -> PyResult<f64> {
        let job = self.job()?;
        Ok(job.dt * span(job.model.nodes.coarsest()) as f64)
    }

    fn __enter__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    /// Finishes it, where `finish` was not called.
    #[pyo3(signature = (*_error))]
    fn __exit__(&self, py: Python<'_>, _error: &Bound<'_, pyo3::types::PyTuple>) -> PyResult<bool> {
        if self.held()?.is_some() {
            self.finish(py)?;
        }
        Ok(false)
    }
}

fn over() -> PyErr {
    unusable("this simulation is finished; start another, with resume=True to go on")
}

/// Why a run could not begin or go on.
fn refused(why: &RunError) -> PyErr {
    match why {
        RunError::OtherCase { .. } => {
            failed(format!("{why}; resume with that one, or start again without resume"))
        }
        RunError::StageLeft(_) => failed(format!("{why}: go through stages() first")),
        why => failed(why),
    }
}
