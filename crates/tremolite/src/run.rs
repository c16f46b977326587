//! A run: a simulation driven to its end, with a word now and then of how far it is, checkpoints, and a stop in good order.

use crate::error::RunError;
use crate::simulation::{Cycle, Ending, Go, Outcome, Simulation, StageEnd, Stepping};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// How far a run is.
#[derive(Clone, Copy, Debug, Default)]
pub struct Progress {
    /// Number of the stage before the earthquake that is going on, its cycle and what is out of balance over all contributions;
    /// no number in the earthquake.
    pub stage: Option<usize>,
    pub cycle: u64,
    pub ratio: f64,
    /// From 0 to 1: of the stages, or of the earthquake.
    pub share: f64,
    pub step: u64,
    pub total: u64,
    /// Simulated time \[s\].
    pub time: f64,
    /// Element updates a second so far.
    pub updates_per_second: f64,
}

/// What a run listens and talks to.
pub struct Control<'a> {
    /// Set from outside: stop at the next step with a checkpoint.
    pub stop: &'a AtomicBool,
    pub progress: &'a mut dyn FnMut(Progress),
}

/// How often progress is told.
const TELL: Duration = Duration::from_millis(200);

/// When something was last done, and how often it shall be.
struct Clock {
    last: Instant,
    every: Option<Duration>,
}

impl Clock {
    fn new(every: Option<Duration>) -> Self {
        Clock { last: Instant::now(), every }
    }

    /// Whether it is due, and done with this.
    fn strikes(&mut self) -> bool {
        let now = Instant::now();
        let strikes = self.every.is_some_and(|every| now - self.last >= every);
        if strikes {
            self.last = now;
        }
        strikes
    }
}

/// Drives a simulation to its end, or to where it is stopped.
///
/// # Errors
/// If a file cannot be written. A physical or numerical failure is no error here but an [`Ending`].
pub fn run(simulation: Simulation, control: &mut Control) -> Result<Outcome, RunError> {
    run_checking(simulation, control, &mut |_, _| {})
}

/// The same, with a look at the simulation whenever a stage, by its number, is at rest. [`Control::stop`], set there, ends the run before the
/// next.
///
/// # Errors
/// As [`run`].
pub fn run_checking(
    mut simulation: Simulation,
    control: &mut Control,
    at_rest: &mut dyn FnMut(&Simulation, usize),
) -> Result<Outcome, RunError> {
    let begin = Instant::now();
    let mut tell = Clock::new(Some(TELL));
    let mut keep = Clock::new(simulation.plan().checkpoint.map(Duration::from_secs_f64));
    let ending = through_stages(&mut simulation, control, &mut tell, &mut keep, at_rest)?;
    let stage_seconds = begin.elapsed().as_secs_f64();
    let ending = match ending {
        Some(ending) => ending,
        None => shake(&mut simulation, control, &mut tell, &mut keep)?,
    };
    simulation.finish(ending, stage_seconds)
}

/// Through the stages that are left; how it ended, unless it goes on.
fn through_stages(
    simulation: &mut Simulation,
    control: &mut Control,
    tell: &mut Clock,
    keep: &mut Clock,
    at_rest: &mut dyn FnMut(&Simulation, usize),
) -> Result<Option<Ending>, RunError> {
    let Control { stop, progress } = control;
    let stages = simulation.plan().stages.len() as f64;
    while let Some(stage) = simulation.stage() {
        let name = simulation.plan().stages[stage].name.clone();
        let end = simulation.relax(&mut |&Cycle { stage, cycle, rest, share }| {
            // Before the first cycle nothing is known of the balance.
            if rest.cycles > 0 && tell.strikes() {
                progress(Progress {
                    stage: Some(stage),
                    share: (stage as f64 + share) / stages,
                    cycle,
                    ratio: rest.ratio,
                    ..Progress::default()
                });
            }
            match (stop.load(Ordering::Relaxed), keep.strikes()) {
                (true, _) => Go::Stop,
                (false, true) => Go::Checkpoint,
                (false, false) => Go::On,
            }
        })?;
        match end {
            StageEnd::AtRest(_) => at_rest(simulation, stage),
            StageEnd::Stopped => return Ok(Some(Ending::Stopped)),
            StageEnd::Restless { relaxed, place } => {
                return Ok(Some(Ending::Restless { stage: name, relaxed, place }));
            }
            StageEnd::SnappedBack { lost, held } => {
                return Ok(Some(Ending::SnappedBack { stage: name, lost, held }));
            }
        }
    }
    Ok(None)
}

/// Through the shaking.
fn shake(
    simulation: &mut Simulation,
    control: &mut Control,
    tell: &mut Clock,
    keep: &mut Clock,
) -> Result<Ending, RunError> {
    let (_, steps) = simulation.steps();
    loop {
        if tell.strikes() {
            (control.progress)(Progress {
                share: simulation.taken() as f64 / steps.total as f64,
                step: simulation.taken(),
                total: steps.total,
                time: simulation.time(),
                updates_per_second: simulation.updates_per_second(),
                ..Progress::default()
            });
        }
        let [stop, keep] = simulation.agreed(control.stop.load(Ordering::Relaxed), keep.strikes());
        if stop || keep {
            if let Some((halt, place)) = simulation.checkpoint()? {
                return Ok(Ending::Failed { halt, place });
            }
            if stop {
                return Ok(Ending::Stopped);
            }
        }
        match simulation.step(1)? {
            Stepping::On => {}
            Stepping::Done => return Ok(Ending::Done),
            Stepping::Failed { halt, place } => return Ok(Ending::Failed { halt, place }),
            Stepping::Astray { why } => return Ok(Ending::Astray { why }),
        }
    }
}
