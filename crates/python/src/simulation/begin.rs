//! How a run begins.

use super::{Held, Simulation, refused};
use crate::away::{Asker, away, pool_of};
use crate::errors::{failed, unusable};
use crate::made::Made;
use crate::watch::{Every, Watch};
use pyo3::prelude::*;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use tremolite::job::Caller;
use tremolite::simulation::Start;
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
    /// `tremolite.Observer`s.
    pub observers: Vec<Py<PyAny>>,
}

impl Simulation {
    /// Prepares the folder and the simulation. What a signal raised meanwhile lies on the desk, and `stop` is set.
    pub fn begin(py: Python<'_>, made: &Made, wish: Wish) -> PyResult<Self> {
        let job = &made.job;
        let Wish { out, resume, overwrite, from, threads, callback, every, observers } = wish;
        if resume && (overwrite || from.is_some()) {
            return Err(unusable("resume goes on with what is there; leave overwrite and from_ out"));
        }
        let asker = Asker::default();
        let mut watches = Vec::new();
        if let Some(callback) = callback {
            watches.push(Watch::callback(callback, every.as_ref(), job, &asker)?);
        }
        for observer in &observers {
            watches.push(Watch::observer(observer.bind(py), &watches, job, &asker)?);
        }
        let pool = pool_of(threads, Some(asker.clone()))?;
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
        let own = watches.iter().flat_map(Watch::observers).collect();
        let Asker { desk, stop } = &asker;
        let back = away(py, &pool, desk, stop, || begun.simulation(job, own))?;
        // It stops the run before its first step: with a checkpoint, so that the folder can be gone on with.
        if let Some(interrupt) = back.interrupt {
            desk.raise(interrupt);
        }
        let simulation = back.result.map_err(|why| desk.raised().unwrap_or_else(|| refused(&why)))?;
        let held = Held { simulation, begun, caller, stage_seconds: 0.0, ending: None, outcome: None };
        let out = folder.root().to_owned();
        Ok(Simulation {
            made: Mutex::new(made.clone()),
            out,
            pool,
            asker,
            watches,
            follows: from.is_some() || resume,
            held: Mutex::new(Some(held)),
        })
    }
}

/// Whether two paths are one folder.
fn same(a: &Path, b: &Path) -> bool {
    let whole = |path: &Path| path.canonicalize().ok();
    whole(a).is_some_and(|a| Some(a) == whole(b))
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
