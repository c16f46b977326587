//! Words of how far a run is, for a script.

use crate::away::Desk;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use tremolite::job::Job;
use tremolite::run::Progress;

/// Tells a script how far a run is.
pub struct Teller {
    tell: Arc<Py<PyAny>>,
    job: Arc<Job>,
    desk: Arc<Desk>,
    stop: Arc<AtomicBool>,
    raised: Arc<Mutex<Option<PyErr>>>,
}

impl Teller {
    pub fn new(tell: Py<PyAny>, job: &Arc<Job>, desk: &Arc<Desk>, stop: &Arc<AtomicBool>) -> Self {
        let (job, desk, stop) = (job.clone(), desk.clone(), stop.clone());
        Teller { tell: Arc::new(tell), job, desk, stop, raised: Arc::default() }
    }

    pub fn tell(&self, now: Progress) {
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

    /// What the script raised.
    pub fn raised(&self) -> Option<PyErr> {
        self.raised.lock().ok()?.take()
    }
}
