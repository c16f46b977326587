//! A callback as an observer of the run: it looks, remembers and may stop.

use crate::arrays::column;
use crate::away::Desk;
use crate::errors::unusable;
use crate::look::{Look, Scene};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use tremolite::RunError;
use tremolite::job::Job;
use tremolite::observers::{Event, Observer, OwnObservers, Schedule, Setting, View, Wants, Which};
use tremolite::phase::beats::span;
use tremolite::state::Memory;
use tremolite_case::units;
use tremolite_laws::Dimension;

/// Before the names of what callbacks remember, among what all observers do.
const OURS: &str = "python:";

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

/// A callback, with what it said.
pub struct Watch {
    callback: Py<PyAny>,
    every: u64,
    desk: Arc<Desk>,
    stop: Arc<AtomicBool>,
    raised: Mutex<Option<PyErr>>,
}

impl Watch {
    /// `every` left out is that of the rows of the histories.
    ///
    /// # Errors
    /// If that is no number of steps and no time.
    pub fn new(
        callback: Py<PyAny>,
        every: Option<&Every>,
        job: &Job,
        desk: &Arc<Desk>,
        stop: &Arc<AtomicBool>,
    ) -> PyResult<Arc<Self>> {
        let every = every.map_or(Ok(job.steps.histories), |every| every.steps(job))?;
        let (desk, stop) = (desk.clone(), stop.clone());
        Ok(Arc::new(Watch { callback, every, desk, stop, raised: Mutex::default() }))
    }

    /// The callback as an observer of a simulation.
    pub fn observers(self: &Arc<Self>) -> OwnObservers {
        let watch = self.clone();
        vec![Arc::new(move |setting: &Setting| {
            let Setting { model, assembly, phase, steps, .. } = *setting;
            let scene = Scene { model: model.clone(), assembly: assembly.clone(), phase: phase.clone() };
            let schedule = Schedule { every: watch.every, last: Some(steps.total) };
            Ok(Some(Box::new(Watcher { watch: watch.clone(), scene, schedule }) as Box<dyn Observer>))
        })]
    }

    /// What the callback raised.
    pub fn raised(&self) -> Option<PyErr> {
        self.raised.lock().ok()?.take()
    }

    fn call(&self, py: Python<'_>, look: Look, memory: &Py<PyDict>) -> PyResult<Vec<(String, Vec<f64>)>> {
        let said = self.callback.bind(py).call1((look,))?;
        if !said.is_none() && !said.is_truthy()? {
            self.stop.store(true, Ordering::Relaxed);
        }
        let array = py.import("numpy")?.getattr("asarray")?;
        let kept = |(name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
            let name: String = name.extract()?;
            let numbers = array.call1((value, "float64"))?;
            if numbers.getattr("ndim")?.extract::<usize>()? > 1 {
                let shape = numbers.getattr("shape")?;
                return Err(unusable(format!(
                    "memory[{name:?}] has the shape {shape}; a checkpoint keeps (n,), so keep array.ravel()"
                )));
            }
            let numbers = numbers.call_method0("ravel")?;
            Ok((format!("{OURS}{name}"), numbers.extract()?))
        };
        memory.bind(py).iter().map(kept).collect()
    }
}

struct Watcher {
    watch: Arc<Watch>,
    scene: Scene,
    schedule: Schedule,
}

impl Watcher {
    fn look(&self, view: &View, stage: Option<String>, memory: &mut Memory) {
        // A run that stops has no more to say, and goes on with this look another time.
        if self.watch.stop.load(Ordering::Relaxed) {
            return;
        }
        let (watch, scene) = (self.watch.clone(), self.scene.clone());
        let (snapshot, history) = (view.snapshot.clone(), view.history.octets.to_vec());
        let ours = memory.range(OURS.to_owned()..).take_while(|(name, _)| name.starts_with(OURS));
        let ours: Vec<(String, Vec<f64>)> =
            ours.map(|(n, v)| (n[OURS.len()..].to_owned(), v.clone())).collect();
        let kept = self.watch.desk.ask(move |py| {
            let called = remembered(py, ours).and_then(|memory| {
                let look = Look::new(scene, snapshot, history, stage, Some(memory.clone_ref(py)));
                watch.call(py, look, &memory)
            });
            called.map_err(|raised| {
                watch.stop.store(true, Ordering::Relaxed);
                if let Ok(mut held) = watch.raised.lock() {
                    *held = Some(raised);
                }
            })
        });
        if let Some(Ok(kept)) = kept {
            memory.retain(|name, _| !name.starts_with(OURS));
            memory.extend(kept);
        }
    }
}

/// What a callback remembers, as arrays that it may write to.
fn remembered(py: Python<'_>, ours: Vec<(String, Vec<f64>)>) -> PyResult<Py<PyDict>> {
    let memory = PyDict::new(py);
    for (name, numbers) in ours {
        memory.set_item(name, column(py, numbers)?.call_method0("copy")?)?;
    }
    Ok(memory.unbind())
}

impl Observer for Watcher {
    fn wants(&self) -> Wants {
        Wants { nodes: Which::All, elements: Which::All, ..Wants::looks(self.schedule) }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.look(view, None, memory),
            Event::StageEnds(seen) => {
                let name = seen.view.plan.stages[seen.stage].name.clone();
                self.look(&seen.view, Some(name), memory);
            }
            _ => {}
        }
        Ok(())
    }
}
