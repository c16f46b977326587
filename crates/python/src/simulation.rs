//! A run that a script holds: stage by stage, step by step, with looks between them; and one that goes to its end.

use crate::away::{Back, Desk, away, pool};
use crate::errors::{RunWarning, failed, refused as case_refused, stopped, unusable};
use crate::look::{Look, Scene};
use crate::made::Made;
use crate::watch::{Every, Watch};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::ThreadPool;
use std::ffi::CString;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard};
use std::time::Instant;
use tremolite::RunError;
use tremolite::job::{Begun, Caller, Job};
use tremolite::phase::beats::span;
use tremolite::run::{Control, Progress, run};
use tremolite::simulation::{self, Ending, Go, Outcome, Start, Stepping};
use tremolite_case::Case;
use tremolite_laws::materials::MATERIALS;
use tremolite_results::{ResultFolder, replace_file};

/// How a run is asked for.
#[derive(Default)]
pub struct Wish {
    pub out: Option<PathBuf>,
    pub resume: bool,
    pub overwrite: bool,
    pub from: Option<PathBuf>,
    pub threads: Option<usize>,
    pub callback: Option<Py<PyAny>>,
    pub every: Option<Every>,
}

/// A run that a script drives, in its folder, on threads of its own. Made by `Job.start`; use it by `with`, which finishes it.
///
/// First its stages, if there are any, one by one: `for stage in simulation.stages(): ...`; then `step(n)` until it returns False.
/// `look()` shows where it stands. Results do not depend on how it is driven. One thread at a time may drive it.
#[pyclass(frozen, module = "tremolite")]
pub struct Simulation {
    made: Mutex<Made>,
    out: PathBuf,
    pool: ThreadPool,
    desk: Arc<Desk>,
    stop: Arc<AtomicBool>,
    watch: Option<Arc<Watch>>,
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
}

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
    /// Prepares the folder and the simulation.
    pub fn begin(py: Python<'_>, made: &Made, wish: Wish) -> PyResult<Self> {
        let job = &made.job;
        let Wish { out, resume, overwrite, from, threads, callback, every } = wish;
        if resume && (overwrite || from.is_some()) {
            return Err(unusable("resume goes on with what is there; leave overwrite and from_ out"));
        }
        let (desk, stop) = (Arc::new(Desk::default()), Arc::new(AtomicBool::new(false)));
        let watch =
            callback.map(|callback| Watch::new(callback, every.as_ref(), job, &desk, &stop)).transpose()?;
        let pool = pool(threads)?;
        let caller = Caller {
            started: now(py)?,
            ..Caller::new(format!("tremolite {} (Python)", env!("CARGO_PKG_VERSION")))
        };
        let other = from.as_deref().map(ResultFolder::open_existing).transpose().map_err(unusable)?;
        let start = match &other {
            Some(other) => Start::From(other),
            None if resume => Start::Resume,
            None => Start::Rest,
        };
        job.check_start(start).map_err(unusable)?;
        if let (Some(from), Some(out)) = (&from, &out)
            && same(from, out)
        {
            return Err(unusable(format!(
                "from_ {} is where the results would go; give another out",
                from.display()
            )));
        }
        let folder = match resume {
            true => ResultFolder::resume(out.as_deref(), &job.name()),
            false => ResultFolder::create(out.as_deref(), &job.name(), overwrite),
        };
        let folder = folder.map_err(|why| {
            unusable(
                why.to_string()
                    .replace("--overwrite", "overwrite=True")
                    .replace("--resume", "resume=True")
                    .replace("--out", "out"),
            )
        })?;
        let begun = job.begin(&folder, start).map_err(|why| refused(&why))?;
        if !resume {
            replace_file(&folder.log(), format!("{}\n", caller.program).as_bytes()).map_err(failed)?;
        }
        let own = watch.as_ref().map_or_else(Vec::new, Watch::observers);
        let back = away(py, &pool, &desk, &stop, || begun.simulation(job, own))?;
        let simulation = back.result.map_err(|why| refused(&why))?;
        let held = Held { simulation, begun, caller, stage_seconds: 0.0, ending: None };
        let out = folder.root().to_owned();
        Ok(Simulation {
            made: Mutex::new(made.clone()),
            out,
            pool,
            desk,
            stop,
            watch,
            follows: from.is_some() || resume,
            held: Mutex::new(Some(held)),
        })
    }

    /// To its end, or to where it is stopped.
    pub fn run<'py>(self, py: Python<'py>, progress: Option<Py<PyAny>>) -> PyResult<Bound<'py, PyAny>> {
        let mut held = self.held()?;
        let Held { simulation, begun, caller, .. } = held.take().ok_or_else(over)?;
        drop(held);
        let job = &self.job()?;
        let Simulation { pool, desk, stop, watch, .. } = &self;
        let teller = progress.map(|tell| Teller::new(tell, job, desk, stop));
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
        let raised = teller.and_then(|teller| teller.raised());
        self.ended(py, back, raised, watch.as_deref())
    }

    /// The results of what has ended, or why it was broken off.
    fn ended<'py>(
        &self,
        py: Python<'py>,
        back: Back<Result<Outcome, RunError>>,
        raised: Option<PyErr>,
        watch: Option<&Watch>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let page = py.detach(|| tremolite_report::write(&self.out));
        if let Some(raised) = watch.and_then(Watch::raised).or(raised) {
            // Ctrl-C while a callback ran.
            let in_order = back.result.is_ok_and(|outcome| outcome.ending == Ending::Stopped);
            return Err(if in_order { stopped(py, raised, &self.out) } else { raised });
        }
        let outcome = back.result.map_err(|why| refused(&why))?;
        if let Some(interrupt) = back.interrupt {
            return match outcome.ending {
                Ending::Stopped => Err(stopped(py, interrupt, &self.out)),
                // It came as the run ended.
                _ => Err(interrupt),
            };
        }
        page.map_err(failed)?;
        let result = result(py, &self.out)?;
        if !matches!(outcome.ending, Ending::Done | Ending::Stopped) {
            let verdict: String = result.getattr("verdict")?.extract()?;
            let text = CString::new(verdict.replace('\0', " ")).unwrap_or_default();
            PyErr::warn(py, &py.get_type::<RunWarning>(), &text, 1)?;
        }
        Ok(result)
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
        let Simulation { pool, desk, stop, watch, .. } = self;
        stop.store(false, Ordering::Relaxed);
        let Back { result, interrupt } = away(py, pool, desk, stop, || work(moving, stop))?;
        if let Some(raised) = watch.as_ref().and_then(|watch| watch.raised()) {
            return Err(raised);
        }
        let result = result.map_err(|why| refused(&why))?;
        let Some(interrupt) = interrupt else { return Ok(result) };
        let Back { result, .. } =
            away(py, pool, desk, &AtomicBool::new(false), || moving.simulation.checkpoint())?;
        result.map_err(|why| refused(&why))?;
        Err(stopped(py, interrupt, &self.out))
    }

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
}

#[pymethods]
impl Simulation {
    /// An iterator over the stages that are left: each comes to rest, and is then handed out as a `StageEnd` with its number, name,
    /// cycles and ratio. Between two the script may look, or stop by `break`.
    ///
    /// Raises `RunError` where a stage does not come to rest.
    fn stages(slf: Py<Self>) -> Stages {
        Stages(slf)
    }

    /// Puts another stage behind those that the case has: a dict of what `[[stage]]` of a case knows, `{"name": "bench 3", "excavate":
    /// ["hall.bench3"], "bolts": {...}}`, so that a script may decide between two stages what comes next.
    ///
    /// The case grows by it, and the run is that of the case as it then is, with the same bytes as if it had been written so: since lives
    /// of elements go by all stages, those that are done are brought to rest again before this returns, which takes their time once more.
    /// Raises `CaseError`, and leaves all as it is, where the stage is none; `Error` once the ground shakes, with a callback, which would see
    /// stages twice, and behind another run's stages.
    fn add_stage(&self, py: Python<'_>, stage: &Bound<'_, PyDict>) -> PyResult<()> {
        let (done, taken) = {
            let held = self.held()?;
            let simulation = &held.as_ref().ok_or_else(over)?.simulation;
            (simulation.stage().unwrap_or(simulation.plan().stages.len()), simulation.taken())
        };
        if self.watch.is_some() || self.follows {
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
        let case = case.map_err(|report| case_refused(py, &report))?;
        let threads = Some(self.pool.current_num_threads());
        let made = Made::build(py, &case, &old.given(), old.fields.clone(), threads)?;
        // The folder is let go of first.
        drop(self.held()?.take());
        let wish = Wish { out: Some(self.out.clone()), overwrite: true, threads, ..Wish::default() };
        let anew = Simulation::begin(py, &made, wish)?;
        *self.held()? = anew.held()?.take();
        *self.made()? = made;
        for _ in 0..done {
            self.relax(py)?;
        }
        Ok(())
    }

    /// Makes `steps` steps of the coarsest level, or fewer where the earthquake ends before. True while it goes on.
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
                }
                if stop.load(Ordering::Relaxed) {
                    break;
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

    /// Ends it where it stands, with a checkpoint if it is not at its end: writes the summary and the page, and returns a `Result`.
    fn finish<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let mut held = self.held()?;
        let Held { mut simulation, begun, caller, stage_seconds, ending } = held.take().ok_or_else(over)?;
        drop(held);
        let job = &self.job()?;
        let Simulation { pool, desk, stop, watch, .. } = self;
        let back = away(py, pool, desk, stop, || -> Result<Outcome, RunError> {
            let ending = match ending {
                Some(ending) => ending,
                None => match simulation.checkpoint()? {
                    Some((halt, place)) => Ending::Failed { halt, place },
                    None => Ending::Stopped,
                },
            };
            let outcome = simulation.finish(ending, stage_seconds)?;
            begun.end(job, &outcome, &caller)?;
            Ok(outcome)
        })?;
        self.ended(py, back, None, watch.as_deref())
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

/// Tells a script how far a run is.
struct Teller {
    tell: Arc<Py<PyAny>>,
    job: Arc<Job>,
    desk: Arc<Desk>,
    stop: Arc<AtomicBool>,
    raised: Arc<Mutex<Option<PyErr>>>,
}

impl Teller {
    fn new(tell: Py<PyAny>, job: &Arc<Job>, desk: &Arc<Desk>, stop: &Arc<AtomicBool>) -> Self {
        let (job, desk, stop) = (job.clone(), desk.clone(), stop.clone());
        Teller { tell: Arc::new(tell), job, desk, stop, raised: Arc::default() }
    }

    fn tell(&self, now: Progress) {
        let (tell, raised, stop) = (self.tell.clone(), self.raised.clone(), self.stop.clone());
        let stage = now.stage.map(|stage| self.job.plan.stages[stage].name.clone());
        self.desk.ask(move |py| {
            let said = || -> PyResult<()> {
                let words = PyDict::new(py);
                words.set_item("stage", stage)?;
                words.set_item("share", now.share)?;
                words.set_item("cycle", now.cycle)?;
                words.set_item("step", now.step)?;
                words.set_item("steps", now.total)?;
                words.set_item("time", now.time)?;
                tell.call1(py, (words,)).map(drop)
            };
            if let (Err(error), Ok(mut held)) = (said(), raised.lock()) {
                stop.store(true, Ordering::Relaxed);
                *held = Some(error);
            }
        });
    }

    fn raised(&self) -> Option<PyErr> {
        self.raised.lock().ok()?.take()
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

/// Whether two paths are one folder.
fn same(a: &Path, b: &Path) -> bool {
    let whole = |path: &Path| path.canonicalize().ok();
    whole(a).is_some_and(|a| Some(a) == whole(b))
}

/// The results in a folder.
fn result<'py>(py: Python<'py>, root: &Path) -> PyResult<Bound<'py, PyAny>> {
    py.import("tremolite._results")?.getattr("Result")?.call1((root,))
}

/// The time of day, in words.
fn now(py: Python<'_>) -> PyResult<String> {
    let zone = py.import("datetime")?.getattr("timezone")?.getattr("utc")?;
    py.import("datetime")?
        .getattr("datetime")?
        .call_method1("now", (zone,))?
        .call_method0("isoformat")?
        .extract()
}
