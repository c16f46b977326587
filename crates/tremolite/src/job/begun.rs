//! A job on its way: from its result folder to its summary.

use super::{Job, Loaded};
use crate::error::RunError;
use crate::evidence::Evidence;
use crate::observers::OwnObservers;
use crate::plan::Plan;
use crate::run::{Control, run};
use crate::setup::MotionFacts;
use crate::simulation::{Built, Outcome, Simulation, Start, check_rest};
use crate::summary::summary;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;
use tremolite_engine::Ranks;
use tremolite_results::{Computed, ResultFolder, RunFacts, Summary, Table, replace_file};

/// Who runs a job, as the summary names it.
#[derive(Clone, Debug)]
pub struct Caller {
    /// Name and version.
    pub program: String,
    /// The command line, if there was one.
    pub command: String,
    /// When it began, in words of its own.
    pub started: String,
    /// From here on the wall time counts.
    pub since: Instant,
}

impl Caller {
    /// A program that begins now and has no command line.
    pub fn new(program: impl Into<String>) -> Caller {
        Caller {
            program: program.into(),
            command: String::new(),
            started: String::new(),
            since: Instant::now(),
        }
    }
}

/// A run of a job that has its folder, which keeps the case as it is run. It borrows nothing, so that a program can hold it beside
/// the job.
pub struct Begun {
    folder: ResultFolder,
    start: Beginning,
    /// Wall time before this run was resumed \[s\], and how often it was.
    earlier: (f64, u64),
}

/// A [`Start`] that holds its folder.
enum Beginning {
    Rest,
    Resume,
    From(ResultFolder),
}

/// Whether there is something that another run's rest could be the beginning of.
fn check_from(plan: &Plan, motion: Option<&MotionFacts>) -> Result<(), RunError> {
    match (plan.stages.is_empty(), motion) {
        (true, _) => Err(RunError::NoRest),
        (false, None) => Err(RunError::RestAlone),
        (false, Some(_)) => Ok(()),
    }
}

impl Loaded {
    /// Whether the case has stages and an earthquake, so that it could begin with what another run had come to between them.
    ///
    /// # Errors
    /// If it has no stages, or no earthquake.
    pub fn check_from(&self) -> Result<(), RunError> {
        check_from(&self.setup.plan, self.setup.motion.as_ref())
    }
}

impl Job {
    /// Whether a run can begin so, before anything is written.
    ///
    /// # Errors
    /// If it is to begin with another run's rest, and that is of another mesh, other materials or stages, or none is there or
    /// asked for.
    pub fn check_start(&self, start: Start) -> Result<(), RunError> {
        let Start::From(other) = start else { return Ok(()) };
        check_from(&self.plan, self.motion.as_ref())?;
        check_rest(&self.model, &self.assembly, &self.plan, self.dt, other)
    }

    /// Keeps the case in the folder of a run.
    ///
    /// # Errors
    /// If the run that is to be resumed is of another case, or the folder cannot be written.
    pub fn begin(&self, folder: &ResultFolder, start: Start) -> Result<Begun, RunError> {
        let source = self.case.source.as_bytes();
        let mut earlier = (0.0, 0);
        if let Start::Resume = start {
            if let Ok(Summary { computed: Computed { wall_seconds, run, .. }, .. }) =
                Summary::read(&folder.summary())
            {
                earlier = (if wall_seconds.is_finite() { wall_seconds } else { 0.0 }, run.resumed + 1);
            }
            self.check_kept(folder.root())?;
        }
        // What is resumed has it.
        if !folder.case().exists() || !matches!(start, Start::Resume) {
            replace_file(&folder.case(), source)?;
        }
        Ok(Begun { earlier, ..self.join(folder, start) })
    }

    /// Whether a folder is of this case, or of none.
    ///
    /// # Errors
    /// [`RunError::OtherCase`] if it keeps another.
    pub fn check_kept(&self, root: &Path) -> Result<(), RunError> {
        let kept = root.join("case.toml");
        match std::fs::read(&kept).is_ok_and(|text| text != self.case.source.as_bytes()) {
            true => Err(RunError::OtherCase { case: self.case.path.clone(), kept }),
            false => Ok(()),
        }
    }

    /// Joins a run that another rank [began](Job::begin), which keeps the case.
    pub fn join(&self, folder: &ResultFolder, start: Start) -> Begun {
        let start = match start {
            Start::Rest => Beginning::Rest,
            Start::Resume => Beginning::Resume,
            Start::From(other) => Beginning::From(other.clone()),
        };
        Begun { folder: folder.clone(), start, earlier: (0.0, 0) }
    }

    /// Runs it in a folder until it ends or is stopped, on the rayon pool that this is called from. The figures and the page are made
    /// of the folder by `tremolite_report`.
    ///
    /// # Errors
    /// As [`Job::check_start`], [`Job::begin`], [`Begun::simulation`] and [`Begun::end`]. A physical or numerical failure is no
    /// error here but an [`Ending`](crate::simulation::Ending).
    pub fn run(
        &self,
        folder: &ResultFolder,
        start: Start,
        caller: &Caller,
        control: &mut Control,
    ) -> Result<(Outcome, Summary), RunError> {
        self.check_start(start)?;
        let begun = self.begin(folder, start)?;
        let outcome = run(begun.simulation(self, Vec::new())?, control)?;
        let summary = begun.end(self, &outcome, caller)?;
        Ok((outcome, summary))
    }
}

impl Begun {
    /// The simulation of the job that was begun, which can be driven by [`run`](crate::run::run) or in any other way; `own` are observers of the program's
    /// own.
    ///
    /// # Errors
    /// If there is no checkpoint to start from, or it is of another model or plan.
    pub fn simulation(&self, job: &Job, own: OwnObservers) -> Result<Simulation, RunError> {
        self.simulation_among(job, own, None)
    }

    /// What a rank has of it, if several work on it ([`Simulation::among`]).
    ///
    /// # Errors
    /// As [`Begun::simulation`].
    pub fn simulation_among(
        &self,
        job: &Job,
        own: OwnObservers,
        ranks: Option<Arc<Ranks>>,
    ) -> Result<Simulation, RunError> {
        let start = match &self.start {
            Beginning::Rest => Start::Rest,
            Beginning::Resume => Start::Resume,
            Beginning::From(other) => Start::From(other),
        };
        let Job { model, assembly, phase, stable, .. } = job;
        let (model, assembly, phase) = (model.clone(), assembly.clone(), phase.clone());
        let built = Built { model, assembly, phase, stable: stable.clone() };
        let first = ranks.as_ref().is_none_or(|ranks| ranks.is_first());
        let simulation = Simulation::among(&built, &job.plan, &self.folder, start, own, ranks)?;
        // What is refused stays as it was.
        if first && matches!(self.start, Beginning::Resume) {
            self.folder.unseal();
        }
        Ok(simulation)
    }

    /// The summary of how the job that was begun ended, which is written into the folder.
    ///
    /// # Errors
    /// If tables of the run cannot be read, or the summary not be written.
    pub fn end(&self, job: &Job, outcome: &Outcome, caller: &Caller) -> Result<Summary, RunError> {
        let Begun { folder, earlier: (earlier, resumed), .. } = self;
        // Before the earthquake there are none.
        let table = |path: &Path| match outcome.shaken {
            true => Table::read(path),
            false => Ok(Table::default()),
        };
        let summary = summary(Evidence {
            model: &job.model,
            assembly: &job.assembly,
            phase: &job.phase,
            plan: &job.plan,
            motion: job.motion.as_ref(),
            survey: &job.survey,
            near: job.near.clone(),
            outcome,
            histories: &table(&folder.monitors())?,
            energy: &table(&folder.energy())?,
            run: RunFacts {
                program: caller.program.clone(),
                command: caller.command.clone(),
                started: caller.started.clone(),
                threads: rayon::current_num_threads() as u64,
                instruction_set: job.model.scheme.isa.name().into(),
                resumed: *resumed,
            },
            inputs: job.inputs.clone(),
            bare_si: job.case.bare_si,
            before: job.said(),
            materials: job.materials.clone(),
            defaulted: job.defaulted(),
            wall_seconds: caller.since.elapsed().as_secs_f64() + earlier,
        });
        summary.write(&folder.summary())?;
        folder.write_checksums()?;
        Ok(summary)
    }
}
