//! A run: stages before the earthquake, then the loop that steps, lets observers look, and stops in good order.

mod before;
mod beside;
mod kept;
mod moved;

pub(crate) use beside::Beside;
pub(crate) use kept::{Beginning, uneven};
pub(crate) use moved::{damped, first_step, let_go};

use crate::checkpoint;
use crate::error::RunError;
use crate::fingerprint::fingerprint;
use crate::history::History;
use crate::motion_table;
use crate::observers::{Depth, OBSERVERS, Observer, OwnObservers, SectionForces, Setting, Stepped, View};
use crate::places;
use crate::plan::{Plan, Steps};
use crate::spectra;
use crate::transfer_table;
use before::{Before, Stages};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use tremolite_engine::assembly::Assembly;
use tremolite_engine::engine::{BodyBooks, Relaxed, Seen};
use tremolite_engine::model::Model;
use tremolite_engine::phase::Phase;
use tremolite_engine::state::State;
use tremolite_engine::{Engine, Halt, Snapshot, StableStep, Stage, stable_step};
use tremolite_kernels::Lines;
use tremolite_results::{ResultFolder, Said, StageSummary};

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

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Ending {
    Done,
    /// The signal came; a checkpoint was written.
    Stopped,
    /// A stage did not come to rest: its name, how it ended, and where most moves.
    Restless {
        stage: String,
        relaxed: Relaxed,
        place: Said,
    },
    /// What a stage moves snapped back: its name, and what \[J\] it let go at once of what it held.
    SnappedBack {
        stage: String,
        lost: f64,
        held: f64,
    },
    /// Energy appeared: the halt, and the element where most of it is.
    Failed {
        halt: Halt,
        place: Said,
    },
}

/// What is known of a run at its end besides its files.
#[derive(Clone, Debug)]
pub struct Outcome {
    pub ending: Ending,
    pub steps: Steps,
    /// Steps taken in all, and in this process.
    pub taken: u64,
    pub taken_here: u64,
    pub dt: f64,
    pub stable: StableStep,
    /// Wall time of the loop in this process \[s\], observers included, and of its steps alone.
    pub loop_seconds: f64,
    pub step_seconds: f64,
    /// The stages that came to rest.
    pub stages: Vec<StageSummary>,
    /// Whether it came to the earthquake.
    pub shaken: bool,
    /// Wall time of the stages in this process \[s\].
    pub stage_seconds: f64,
    /// Largest displacement \[m\] in a quiet run from the hand-over; none without stages or before it.
    pub quiet: Option<f64>,
    pub balance: Lines,
    /// The books of each account of the assembly, when it was last looked at.
    pub bodies: Vec<BodyBooks>,
    pub state: State,
}

impl Outcome {
    /// Element updates a second of the steps.
    pub fn updates_per_second(&self, elements: usize) -> f64 {
        self.taken_here as f64 * elements as f64 / self.step_seconds.max(1e-9)
    }

    /// The last stage that was come to its end, or the shaking; none before the first.
    pub fn stage(&self) -> Option<Stage> {
        match (self.shaken, self.stages.len().checked_sub(1)) {
            (true, _) => Some(Stage::Shaking),
            (false, last) => Some(Stage::Before(u16::try_from(last?).ok()?)),
        }
    }

    /// What laws remember at the end.
    pub fn history<'a>(&'a self, assembly: &'a Assembly) -> History<'a> {
        History { assembly, octets: &self.state.history }
    }
}

/// What a run listens and talks to.
pub struct Control<'a> {
    /// Set from outside: stop at the next step with a checkpoint.
    pub stop: &'a AtomicBool,
    pub progress: &'a mut dyn FnMut(Progress),
    /// Observers of the program's own.
    pub observers: OwnObservers,
}

/// The step a model runs with and the plan in steps.
pub fn choose_step(model: &Model, plan: &Plan, stable: &StableStep) -> (f64, Steps) {
    plan.steps(model.time_step.given.unwrap_or_else(|| stable.to_run(model.time_step.safety)))
}

/// Steps of the quiet run.
const QUIET: u64 = 100;
/// Key of what is remembered of it.
const DRIFT: &str = "quiet run";

/// How often progress is told.
const TELL: Duration = Duration::from_millis(200);

/// What a run begins with.
#[derive(Clone, Copy, Debug)]
pub enum Start<'a> {
    /// Rest, before all stages.
    Rest,
    /// The checkpoint of its own folder.
    Resume,
    /// What another run of the same model had come to before the earthquake.
    From(&'a ResultFolder),
}

/// Whether a run with steps of `dt` \[s\] can begin with another's rest, before anything is written.
///
/// # Errors
/// If it is that of another mesh, other materials or stages, or there is none.
pub fn check_rest(
    model: &Model,
    assembly: &Assembly,
    plan: &Plan,
    dt: f64,
    other: &ResultFolder,
) -> Result<(), RunError> {
    Ok(checkpoint::check_hand_over(&other.checkpoint(), fingerprint(model, assembly, plan, dt))?)
}

/// Runs a plan on a model and writes its result files.
///
/// Works on the current rayon pool. The bits of the results do not depend on its size.
///
/// # Errors
/// If a file cannot be written or the checkpoint cannot be used. A physical or numerical failure is no error here
/// but an [`Ending`].
pub fn run(
    model: &Arc<Model>,
    assembly: &Arc<Assembly>,
    phase: &Arc<Phase>,
    plan: &Plan,
    folder: &ResultFolder,
    start: Start,
    control: &mut Control,
) -> Result<Outcome, RunError> {
    let stable = stable_step(model, assembly, phase);
    let (dt, steps) = choose_step(model, plan, &stable);
    let fingerprint = fingerprint(model, assembly, plan, dt);
    let mut state = assembly.rest();
    state.dt = dt;
    match start {
        Start::Rest => {}
        Start::Resume => checkpoint::read(&folder.checkpoint(), &mut state, fingerprint)?,
        Start::From(other) => {
            checkpoint::read_hand_over(&other.checkpoint(), &mut state, fingerprint)?;
            state.dt = dt;
        }
    }
    let stages = Stages { model, assembly, plan, folder, fingerprint };
    let begin = Instant::now();
    let ended = match stages.run(&mut state, control)? {
        Before::Done => None,
        Before::Stopped => Some(Ending::Stopped),
        Before::Failed { stage, relaxed, place } => {
            Some(Ending::Restless { stage: plan.stages[stage].name.clone(), relaxed, place })
        }
        Before::SnappedBack { stage, lost, held } => {
            Some(Ending::SnappedBack { stage: plan.stages[stage].name.clone(), lost, held })
        }
    };
    let stage_seconds = begin.elapsed().as_secs_f64();
    if matches!(start, Start::From(_)) {
        stages.write(&state)?;
    }
    let done = ended.is_none();
    if done && !plan.stages.is_empty() && state.carried.is_empty() {
        checkpoint::write_hand_over(&folder.checkpoint(), &mut state, fingerprint)?;
    }
    if !done || plan.duration == 0.0 {
        return Ok(Outcome {
            ending: ended.unwrap_or(Ending::Done),
            steps,
            taken: 0,
            taken_here: 0,
            dt,
            stable,
            loop_seconds: 0.0,
            step_seconds: 0.0,
            stages: kept::summaries(model, plan, &state.observers),
            shaken: false,
            stage_seconds,
            quiet: None,
            balance: Lines::default(),
            bodies: Vec::new(),
            state,
        });
    }
    let mut engine = Engine::new(model, assembly, phase);
    if !plan.stages.is_empty() && state.carried.is_empty() {
        engine.hand_over(&mut state, dt);
        let drift = engine.quiet_run(&state, QUIET);
        state.observers.insert(DRIFT.into(), vec![drift]);
    }
    let first = state.steps();
    if let Some(incident) = &model.incident
        && first == 0
    {
        let given = plan.recorded.as_ref().map(|recorded| &recorded.motion);
        motion_table::write(folder, incident, given, plan.duration)?;
        if let Some(recorded) = &plan.recorded {
            transfer_table::write(folder, recorded)?;
        }
    }

    let setting = Setting {
        folder,
        model,
        assembly,
        phase,
        plan,
        steps,
        memory: &state.observers,
        step: first,
        time: state.time(),
        dt,
    };
    let mut observers: Vec<Box<dyn Observer>> = Vec::new();
    for make in OBSERVERS {
        observers.extend(make(&setting)?);
    }
    for make in &control.observers {
        observers.extend(make(&setting)?);
    }

    let elements = phase.counted_elements;
    let begin = Instant::now();
    let (mut told, mut kept) = (begin, begin);
    let mut observing = Duration::ZERO;
    let (mut balance, mut bodies) = (Lines::default(), Vec::new());
    let ending = loop {
        let now = Instant::now();
        if now - told >= TELL {
            told = now;
            let seconds = (now - begin).saturating_sub(observing).as_secs_f64();
            (control.progress)(Progress {
                share: state.steps() as f64 / steps.total as f64,
                step: state.steps(),
                total: steps.total,
                time: state.time(),
                updates_per_second: (state.steps() - first) as f64 * elements as f64 / seconds,
                ..Progress::default()
            });
        }
        // Before the parts are evaluated, so that a resumed run evaluates them once as well.
        let stop = control.stop.load(Ordering::Relaxed);
        let due = plan.checkpoint.is_some_and(|every| (now - kept).as_secs_f64() >= every);
        if stop || due {
            checkpoint::write(&folder.checkpoint(), &mut state, fingerprint)?;
            kept = now;
            if stop {
                // A look at a copy, since the state's own parts must see each step once.
                let snapshot = engine.look(&state).snapshot;
                (balance, bodies) = (snapshot.balance, snapshot.bodies);
                break Ending::Stopped;
            }
        }
        let step = state.steps();
        let due = observers.iter().any(|o| o.schedule().due(step));
        let begin_look = Instant::now();
        let mut evaluated = engine.evaluate(std::mem::take(&mut state), due);
        if let Some(Seen { snapshot, history, numbers, memory }) = evaluated.seen() {
            balance = snapshot.balance;
            bodies.clone_from(&snapshot.bodies);
            let history = History { assembly, octets: history };
            let view = View { model, assembly, phase, plan, snapshot, history, numbers };
            for observer in observers.iter_mut().filter(|o| o.schedule().due(step)) {
                observer.see(&view, memory)?;
            }
            observing += begin_look.elapsed();
            if let Err(halt) = engine.guard(snapshot) {
                let place = hottest_element(model, phase, snapshot);
                state = evaluated.end();
                break Ending::Failed { halt, place };
            }
        }
        if step >= steps.total {
            state = evaluated.end();
            break Ending::Done;
        }
        let stepped;
        (state, stepped) = engine.advance(evaluated);
        if let Err(halt) = stepped {
            let place = hottest_element(model, phase, &engine.look(&state).snapshot);
            break Ending::Failed { halt, place };
        }
        let State { u, du, datum, dt, observers: memory, .. } = &mut state;
        let stepped = Stepped { model, plan, u, datum, du, dt: *dt };
        observers.iter_mut().for_each(|observer| observer.stepped(&stepped, memory));
    };
    let loop_seconds = begin.elapsed().as_secs_f64();
    SectionForces::of(model).write(folder, plan, &state.observers)?;
    if model.incident.is_some() {
        spectra::write(folder, model, plan)?;
    }
    if let Some(depth) = Depth::of(model, plan) {
        depth.write(folder, model, plan, &state)?;
    }
    Ok(Outcome {
        ending,
        steps,
        taken: state.steps(),
        taken_here: state.steps() - first,
        dt,
        stable,
        loop_seconds,
        step_seconds: loop_seconds - observing.as_secs_f64(),
        stages: kept::summaries(model, plan, &state.observers),
        shaken: true,
        stage_seconds,
        quiet: state.observers.get(DRIFT).and_then(|drift| drift.first().copied()),
        balance,
        bodies,
        state,
    })
}

/// The element that holds most energy, or the first whose energy is not a number.
fn hottest_element(model: &Model, phase: &Phase, snapshot: &Snapshot) -> Said {
    let mut worst = (f64::NEG_INFINITY, 0);
    for (e, slot) in phase.element_slot.iter().enumerate() {
        let Some(slot) = slot else { continue };
        let energy = snapshot.energy[slot.element as usize].held();
        if !energy.is_finite() {
            worst = (energy, e);
            break;
        }
        if energy > worst.0 {
            worst = (energy, e);
        }
    }
    places::element_at(model, worst.1 as u32)
}

/// Seconds a step takes here, from a short timing of the real engine on a state of its own.
pub fn time_step_cost(model: &Arc<Model>, assembly: &Arc<Assembly>, phase: &Arc<Phase>, dt: f64) -> f64 {
    let mut state = assembly.rest();
    state.dt = dt;
    let mut engine = Engine::new(model, assembly, phase);
    // At rest with a tiny motion, so that no number is subnormal or zero throughout.
    let v = vec![tremolite_laws::Row::new([1e-6, 2e-6, 3e-6]); state.u.len()];
    let u = state.u.clone();
    engine.start(&mut state, u, &v);
    let mut best = f64::INFINITY;
    let begin = Instant::now();
    let mut rounds = 0;
    while rounds < 3 || (begin.elapsed().as_secs_f64() < 0.3 && rounds < 50) {
        let start = Instant::now();
        for _ in 0..4 {
            // A step that halts costs as much as any other.
            let _ = engine.step(&mut state);
        }
        best = best.min(start.elapsed().as_secs_f64() / 4.0);
        rounds += 1;
    }
    best
}
