//! Callbacks and observers of a script as observers of the run: they look, remember and may stop.

use crate::arrays::column;
use crate::away::Asker;
use crate::errors::unusable;
use crate::look::{Look, Scene};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use tremolite::RunError;
use tremolite::job::Job;
use tremolite::observers::{Event, Observer, OwnObservers, Schedule, Setting, View, Wants, Which, add_row};
use tremolite::phase::beats::span;
use tremolite::state::Memory;
use tremolite_case::units;
use tremolite_laws::Dimension;
use tremolite_results::own_table::OwnRow;

/// How often a callback looks: steps, or a time such as `"0.05 s"`.
#[derive(FromPyObject)]
pub enum Every {
    Steps(i64),
    Time(String),
}

impl Every {
    /// In steps of the finest level, whole ones of the coarsest.
    fn steps(&self, job: &Job) -> PyResult<u64> {
        let span = span(job.model.nodes.coarsest());
        match self {
            Every::Steps(steps) => match u64::try_from(*steps) {
                Ok(steps) if steps > 0 => Ok(steps.saturating_mul(span)),
                _ => Err(unusable(format!("every = {steps} is no number of steps; give 1 or more"))),
            },
            Every::Time(text) => match units::parse(text, Dimension::TIME) {
                Ok(time) if time > 0.0 => Ok((time / job.dt / span as f64).round().max(1.0) as u64 * span),
                Ok(_) => Err(unusable(format!(
                    "every = {text:?} is no time between looks; give \"0.05 s\" or steps"
                ))),
                Err(fault) => {
                    Err(unusable(format!("every {}; {}", fault.message("every"), fault.remedy("every"))))
                }
            },
        }
    }
}

/// Where an observer is: where the run's results go, what it remembers, and whether the ground shakes.
#[pyclass(frozen, module = "tremolite")]
pub struct Beginning {
    /// The folder of the results.
    #[pyo3(get)]
    out: PathBuf,
    /// The stage before the earthquake that begins or goes on; None where the ground shakes.
    #[pyo3(get)]
    stage: Option<String>,
    /// Time since the earthquake began [s].
    #[pyo3(get)]
    time: f64,
    memory: Py<PyDict>,
}

#[pymethods]
impl Beginning {
    /// What the observer remembers: a dict from name to array (n,) of float64, part of the checkpoint.
    #[getter]
    fn memory<'py>(&self, py: Python<'py>) -> Bound<'py, PyDict> {
        self.memory.bind(py).clone()
    }
}

/// A callback or an observer of a script, with what says when it looks and where it is heard.
pub struct Watch {
    object: Py<PyAny>,
    /// Whether it has methods, rather than being called.
    methods: bool,
    /// Before the names of what it remembers, among what all observers do.
    prefix: String,
    every: u64,
    asker: Asker,
}

impl Watch {
    /// A callable; `every` left out is that of the rows of the histories.
    ///
    /// # Errors
    /// If that is no number of steps and no time.
    pub fn callback(
        object: Py<PyAny>,
        every: Option<&Every>,
        job: &Job,
        asker: &Asker,
    ) -> PyResult<Arc<Self>> {
        let every = every.map_or(Ok(job.steps.histories), |every| every.steps(job))?;
        Ok(Arc::new(Watch { object, methods: false, prefix: "python:".into(), every, asker: asker.clone() }))
    }

    /// A `tremolite.Observer`, or what has its methods.
    ///
    /// # Errors
    /// If it has no `see`, its `every` is no time, or another has its name.
    pub fn observer(
        object: &Bound<'_, PyAny>,
        others: &[Arc<Self>],
        job: &Job,
        asker: &Asker,
    ) -> PyResult<Arc<Self>> {
        let class = object.get_type().name()?;
        if !object.hasattr("see")? || object.is_instance_of::<pyo3::types::PyType>() {
            return Err(unusable(format!(
                "{class} has no method see(self, now); observers are objects: observers=[Drift()]"
            )));
        }
        let given = |name: &str| -> PyResult<Option<Bound<'_, PyAny>>> {
            Ok(object.getattr_opt(name)?.filter(|value| !value.is_none()))
        };
        let name: String = given("name")?.map_or(Ok(class.to_string()), |name| name.extract())?;
        let prefix = format!("python.{name}:");
        if others.iter().any(|other| other.prefix == prefix) {
            return Err(unusable(format!(
                "two observers are called {name:?}, by which their memory is kept; give one another `name`"
            )));
        }
        let every = match given("every")? {
            Some(every) => every.extract::<Every>()?.steps(job)?,
            None => job.steps.histories,
        };
        let object = object.clone().unbind();
        Ok(Arc::new(Watch { object, methods: true, prefix, every, asker: asker.clone() }))
    }

    /// It as an observer of a simulation.
    pub fn observers(self: &Arc<Self>) -> OwnObservers {
        let watch = self.clone();
        vec![Arc::new(move |setting: &Setting| {
            let Setting { model, assembly, phase, steps, plan, folder, memory, time, .. } = *setting;
            let scene = Scene { model: model.clone(), assembly: assembly.clone(), phase: phase.clone() };
            let schedule = Schedule { every: watch.every, last: Some(steps.total) };
            let stage = match phase.stage {
                tremolite::Stage::Before(stage) => Some(plan.stages[usize::from(stage)].name.clone()),
                tremolite::Stage::Shaking => None,
            };
            let held = Held { out: folder.root().to_owned(), stage, time };
            let held = watch.begun(Arc::new(held), watch.ours(memory));
            Ok(Some(Box::new(Watcher { watch: watch.clone(), scene, schedule, held }) as Box<dyn Observer>))
        })]
    }

    /// What of all memory is its own.
    fn ours(&self, memory: &Memory) -> Vec<(String, Vec<f64>)> {
        let ours = memory.range(self.prefix.clone()..);
        let ours = ours.take_while(|(name, _)| name.starts_with(&self.prefix));
        ours.map(|(name, numbers)| (name[self.prefix.len()..].to_owned(), numbers.clone())).collect()
    }

    /// Asks the script, which stops the run by what it raises.
    fn ask<T: Send + 'static>(
        self: &Arc<Self>,
        what: impl FnOnce(&Watch, Python<'_>) -> PyResult<T> + Send + 'static,
    ) -> Option<T> {
        let watch = self.clone();
        let said = self.asker.desk.ask(move |py| {
            what(&watch, py).map_err(|raised| {
                watch.asker.stop.store(true, Ordering::Relaxed);
                watch.asker.desk.raise(raised);
            })
        });
        said?.ok()
    }

    /// What it remembers, as it begins.
    fn begun(self: &Arc<Self>, at: Arc<Held>, ours: Vec<(String, Vec<f64>)>) -> Begun {
        let here = at.clone();
        let memory = self.ask(move |watch, py| watch.begin(py, &here, &ours));
        Begun { at, memory: memory.map(Arc::new) }
    }

    fn begin(&self, py: Python<'_>, at: &Held, ours: &[(String, Vec<f64>)]) -> PyResult<Py<PyDict>> {
        let memory = PyDict::new(py);
        for (name, numbers) in ours {
            memory.set_item(name, column(py, numbers.clone())?.call_method0("copy")?)?;
        }
        let object = self.object.bind(py);
        if self.methods && object.hasattr("begin")? {
            let Held { out, stage, time } = at;
            let memory = memory.clone().unbind();
            let here = Beginning { out: out.clone(), stage: stage.clone(), time: *time, memory };
            object.call_method1("begin", (here,))?;
        }
        Ok(memory.unbind())
    }

    /// Shows it a look, and says what it remembers then, and the rows that it records.
    fn see(
        &self,
        py: Python<'_>,
        look: Look,
        at: &Held,
        memory: &Py<PyDict>,
        ours: &[(String, Vec<f64>)],
    ) -> PyResult<Seen> {
        let look = Bound::new(py, look)?;
        let object = self.object.bind(py);
        let method = PyString::new(py, "see");
        let call = || match self.methods {
            true => object.call_method1(&method, (&look,)),
            false => object.call1((&look,)),
        };
        let said = match call() {
            // It saw half of this look, which the checkpoint has behind it: it sees it again with what it knew before.
            Err(error) if error.is_instance_of::<PyKeyboardInterrupt>(py) => {
                self.asker.stop.store(true, Ordering::Relaxed);
                self.asker.desk.raise(error);
                let before = self.begin(py, at, ours)?;
                let memory = memory.bind(py);
                memory.clear();
                memory.update(before.bind(py).as_mapping())?;
                drop(look.get().take_rows());
                call()?
            }
            said => said?,
        };
        if !said.is_none() && !said.is_truthy()? {
            self.asker.stop.store(true, Ordering::Relaxed);
        }
        Ok((self.kept(memory.bind(py))?, look.get().take_rows()))
    }

    /// What it remembers, as numbers. What is no array of float64 becomes one.
    fn kept(&self, memory: &Bound<'_, PyDict>) -> PyResult<Vec<(String, Vec<f64>)>> {
        let numpy = memory.py().import("numpy")?;
        let (array, at_least) = (numpy.getattr("asarray")?, numpy.getattr("atleast_1d")?);
        let kept = |(name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
            let name: String = name.extract()?;
            let numbers = at_least.call1((array.call1((&value, "float64"))?,))?;
            if numbers.getattr("ndim")?.extract::<usize>()? > 1 {
                let shape = numbers.getattr("shape")?;
                return Err(unusable(format!(
                    "memory[{name:?}] has the shape {shape}; a checkpoint keeps (n,), so keep array.ravel()"
                )));
            }
            if !numbers.is(&value) {
                memory.set_item(&name, &numbers)?;
            }
            Ok((format!("{}{name}", self.prefix), numbers.extract()?))
        };
        let all: Vec<_> = memory.items().iter().map(|item| item.extract()).collect::<PyResult<_>>()?;
        all.into_iter().map(kept).collect()
    }
}

/// What an observer remembers behind a look, and the rows of its own tables.
type Seen = (Vec<(String, Vec<f64>)>, Vec<OwnRow>);

/// Where it began.
struct Held {
    out: PathBuf,
    stage: Option<String>,
    time: f64,
}

/// What it began with; none where it raised.
struct Begun {
    at: Arc<Held>,
    memory: Option<Arc<Py<PyDict>>>,
}

struct Watcher {
    watch: Arc<Watch>,
    scene: Scene,
    schedule: Schedule,
    held: Begun,
}

impl Watcher {
    fn look(&self, view: &View, stage: Option<String>, memory: &mut Memory) -> Result<(), RunError> {
        let Some(dict) = self.held.memory.clone() else { return Ok(()) };
        let (scene, at, ours) = (self.scene.clone(), self.held.at.clone(), self.watch.ours(memory));
        let (snapshot, history) = (view.snapshot.clone(), view.history.octets.to_vec());
        let kept = self.watch.ask(move |watch, py| {
            let look = Look::new(scene, snapshot, history, stage, Some(dict.clone_ref(py)));
            watch.see(py, look, &at, &dict, &ours)
        });
        let Some((kept, rows)) = kept else { return Ok(()) };
        memory.retain(|name, _| !name.starts_with(&self.watch.prefix));
        memory.extend(kept);
        rows.iter().try_for_each(|row| add_row(&self.held.at.out, row, memory))
    }

    fn end(&self) {
        if !self.watch.methods || self.held.memory.is_none() {
            return;
        }
        self.watch.ask(|watch, py| {
            let object = watch.object.bind(py);
            if object.hasattr("end")? { object.call_method0("end").map(drop) } else { Ok(()) }
        });
    }
}

impl Observer for Watcher {
    fn wants(&self) -> Wants {
        Wants { nodes: Which::All, elements: Which::All, ..Wants::looks(self.schedule) }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.look(view, None, memory)?,
            Event::StageEnds(seen) => {
                let name = seen.view.plan.stages[seen.stage].name.clone();
                self.look(&seen.view, Some(name), memory)?;
            }
            Event::End { .. } => self.end(),
            _ => {}
        }
        Ok(())
    }
}
