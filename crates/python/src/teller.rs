//! Words of how far a run is, for a script.

use crate::away::Asker;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use tremolite::job::Job;
use tremolite::run::Progress;

/// Tells a script how far a run is.
pub struct Teller {
    tell: Arc<Py<PyAny>>,
    job: Arc<Job>,
    asker: Asker,
}

impl Teller {
    pub fn new(tell: Py<PyAny>, job: &Arc<Job>, asker: &Asker) -> Self {
        Teller { tell: Arc::new(tell), job: job.clone(), asker: asker.clone() }
    }

    pub fn tell(&self, now: Progress) {
        let (tell, asker) = (self.tell.clone(), self.asker.clone());
        let stage = now.stage.map(|stage| self.job.plan.stages[stage].name.clone());
        self.asker.desk.ask(move |py| {
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
            if let Err(error) = said() {
                asker.stop.store(true, Ordering::Relaxed);
                asker.desk.raise(error);
            }
        });
    }
}
