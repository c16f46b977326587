//! The shaking, step by step.

use super::astray::Limits;
use super::followed::Followed;
use super::outcome::{Ending, Outcome};
use super::{Simulation, Whole};
use crate::error::RunError;
use crate::history::History;
use crate::motion_table;
use crate::observers::{Apart, Audience, Event, LaidOut, Stepped, View, summaries, write_stage_tables};
use crate::places;
use crate::transfer_table;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tremolite_engine::engine::{BodyBooks, Evaluated, Look, See, Seen};
use tremolite_engine::model::Model;
use tremolite_engine::phase::Phase;
use tremolite_engine::ranks::Wanted;
use tremolite_engine::state::State;
use tremolite_engine::{Bytes, Engine, Halt, Incident, Snapshot};
use tremolite_kernels::Lines;
use tremolite_results::{Said, said};

/// Steps of the quiet run.
const QUIET: u64 = 100;
/// Key of what is remembered of it.
const DRIFT: &str = "quiet run";

/// What came of some steps.
#[derive(Clone, Debug, PartialEq)]
pub enum Stepping {
    /// They were made.
    On,
    /// The run is at its end, and all that is looked at there has been.
    Done,
    /// Energy appeared: the halt, and the element where most of it is.
    Failed { halt: Halt, place: Said },
    /// Something moved or closed by more than method and laws are made for: what and where.
    Astray { why: Said },
}

/// Steps of the coarsest level after which somebody asks whether anything went astray: all nodes and pairs are gone through.
const ASTRAY: u64 = 8;

/// A simulation in the shaking.
pub(super) struct Shaking {
    engine: Engine,
    audience: Audience,
    /// Of one of several ranks: its part of observers that look at each node and element by itself, and what others want to be shown.
    apart: Option<(Apart, LaidOut)>,
    followed: Option<Followed>,
    /// The step from which this process went on.
    first: u64,
    /// The balance when it was last looked at.
    balance: Lines,
    bodies: Vec<BodyBooks>,
    ended: Option<End>,
    /// Beyond which something has gone astray.
    limits: Limits,
    /// Wall time of the steps, and what of it went into looks.
    spent: Duration,
    looking: Duration,
    /// What this process holds of parts and state, once it made a step.
    held: Option<Bytes>,
}

impl Shaking {
    pub fn apart(&self) -> Option<&Apart> {
        self.apart.as_ref().map(|(apart, _)| apart)
    }
}

/// The end of a shaking.
struct End {
    /// None where an observer failed: its tables are then short of the state, which cannot go on.
    how: Option<Stepping>,
    seen: Snapshot,
}

impl Simulation {
    /// Makes so many steps of the coarsest level, or fewer where the run ends before. Looks that are due are taken as each step is made; those of the
    /// last step with the call after it.
    ///
    /// # Errors
    /// If a stage is left, or a file cannot be written; nothing goes on then but from a checkpoint.
    pub fn step(&mut self, steps: u64) -> Result<Stepping, RunError> {
        if let Some(stage) = self.stage() {
            return Err(RunError::StageLeft(self.plan.stages[stage].name.clone()));
        }
        if self.plan.duration == 0.0 {
            return Ok(Stepping::Done);
        }
        let mut shaking = match self.shaking.take() {
            Some(shaking) => shaking,
            None => self.begin()?,
        };
        let begin = Instant::now();
        let mut stepped = Ok(Stepping::On);
        for _ in 0..steps {
            stepped = self.one_step(&mut shaking);
            if !matches!(stepped, Ok(Stepping::On)) {
                break;
            }
        }
        shaking.spent += begin.elapsed();
        self.shaking = Some(shaking);
        stepped
    }

    /// From the state where the stages ended, or from the step at which it was stopped.
    fn begin(&mut self) -> Result<Shaking, RunError> {
        let mut engine = Engine::among(&self.model, &self.assembly, &self.phase, self.ranks.as_ref());
        let writes = self.writes();
        let Simulation { model, plan, folder, state, .. } = self;
        if !plan.stages.is_empty() && state.carried.is_empty() {
            engine.hand_over(state, self.dt);
            let drift = engine.quiet_run(state, QUIET);
            state.observers.insert(DRIFT.into(), vec![drift]);
        }
        let first = state.steps();
        // Also where a run goes on: what stands there may have been changed.
        if writes && !plan.stages.is_empty() {
            write_stage_tables(folder, model, plan, &state.observers)?;
        }
        if let Some(incident) = &model.boundaries.incident
            && writes
        {
            let given = plan.recorded.as_ref().map(|recorded| &recorded.motion);
            motion_table::write(folder, incident, given, plan.duration)?;
            if let Some(recorded) = &plan.recorded {
                transfer_table::write(folder, recorded)?;
            }
        }
        if let Some(waves) = &plan.waves
            && writes
        {
            let incident = Incident { motion: waves.incident.clone(), factor: 1.0 };
            motion_table::write(folder, &incident, Some(&waves.motion), plan.duration)?;
        }
        engine.own(state);
        let mut state = std::mem::take(&mut self.state);
        let apart = self.observers_apart(engine.phase(), &mut state);
        self.state = state;
        let apart = apart?;
        let mut audience = self.audience(&self.phase, &self.state)?;
        apart.iter().for_each(|apart| audience.beside(apart));
        let apart = apart.map(|apart| (apart, audience.laid_out(&self.model, &self.phase)));
        engine.glance_at(audience.glanced(&self.phase));
        let ranks = self.ranks.as_ref();
        let followed = ranks.and_then(|ranks| Followed::of(&self.model, ranks, audience.steps()));
        let limits = Limits::new(&self.model, ranks.map(|ranks| &**ranks), &self.state);
        Ok(Shaking {
            engine,
            audience,
            apart,
            followed,
            first,
            balance: Lines::default(),
            bodies: Vec::new(),
            ended: None,
            limits,
            spent: Duration::ZERO,
            looking: Duration::ZERO,
            held: None,
        })
    }

    /// Looks where something is due, and goes on by a step of the coarsest level.
    fn one_step(&mut self, shaking: &mut Shaking) -> Result<Stepping, RunError> {
        if let Some(End { how, .. }) = &shaking.ended {
            return how.clone().ok_or(RunError::Spoiled(self.state.steps()));
        }
        let step = self.state.steps();
        let glances = shaking.audience.glances();
        let see = match shaking.audience.is_due(step) {
            true => See::Look,
            false if glances => See::Glance,
            false => See::Nothing,
        };
        let begin = Instant::now();
        let mut evaluated = shaking.engine.evaluate(std::mem::take(&mut self.state), see);
        // A row of what is no motion would spoil tables that are good until there.
        let looked = evaluated.snapshot().filter(|_| see == See::Look);
        let halt = looked.and_then(|seen| shaking.engine.guard(seen).err());
        if let Some(halt) = halt {
            return Ok(self.fail(shaking, evaluated, halt));
        }
        if see != See::Nothing {
            let told = self.show(shaking, &mut evaluated, see == See::Look);
            shaking.looking += begin.elapsed();
            if let Err(error) = told {
                self.end(shaking, evaluated, None);
                return Err(error);
            }
        }
        if step >= self.steps.total {
            self.end(shaking, evaluated, Some(Stepping::Done));
            return Ok(Stepping::Done);
        }
        let mut told = Ok(());
        loop {
            self.state = shaking.engine.advance(evaluated);
            let steps = self.state.steps();
            if let Some((followed, ranks)) = shaking.followed.as_ref().zip(self.ranks.as_ref()) {
                followed.tell(ranks, &mut self.state);
            }
            let State { u, du, datum, dt, observers: memory, .. } = &mut self.state;
            let stepped = Stepped { model: &self.model, plan: &self.plan, steps, u, datum, du, dt: *dt };
            if told.is_ok() {
                told = shaking.audience.stepped(&stepped, memory);
            }
            if self.phase.is_common(&self.state) {
                break;
            }
            evaluated = shaking.engine.evaluate(std::mem::take(&mut self.state), See::Nothing);
        }
        if let Err(error) = told {
            if self.ranks.is_some() {
                // The others know nothing of it: this rank ends them.
                return Err(error);
            }
            let evaluated = shaking.engine.evaluate(std::mem::take(&mut self.state), See::Look);
            self.end(shaking, evaluated, None);
            return Err(error);
        }
        shaking.held.get_or_insert_with(|| shaking.engine.bytes(&self.state));
        if shaking.engine.watches(&self.state)
            && let Err(halt) = shaking.engine.watch_or_look(&mut self.state)
        {
            let evaluated = shaking.engine.evaluate(std::mem::take(&mut self.state), See::Look);
            return Ok(self.fail(shaking, evaluated, halt));
        }
        if self.state.steps().is_multiple_of(ASTRAY * self.phase.span())
            && let Some(why) = shaking.limits.astray(
                (&self.model, &self.assembly, &self.phase),
                self.ranks.as_deref(),
                &mut self.state,
            )
        {
            let evaluated = shaking.engine.evaluate(std::mem::take(&mut self.state), See::Look);
            let ended = Stepping::Astray { why };
            self.end(shaking, evaluated, Some(ended.clone()));
            return Ok(ended);
        }
        Ok(Stepping::On)
    }

    /// Shows observers what is due: a whole look, which those who glance see as well, or a glance.
    fn show(&self, shaking: &mut Shaking, evaluated: &mut Evaluated, whole: bool) -> Result<(), RunError> {
        let Simulation { model, assembly, phase, plan, .. } = self;
        let mut lent = None;
        if let Some((apart, wants)) = &mut shaking.apart {
            let step = evaluated.state().steps();
            if whole && let Some(Seen { snapshot, history, numbers, .. }) = evaluated.seen() {
                let (phase, history) = (shaking.engine.phase(), History::held(assembly, history));
                apart.look(step, &View { model, assembly, phase, plan, snapshot, history, numbers })?;
            }
            let wanted = match (whole, step >= self.steps.total) {
                (false, _) => wants.glances().clone(),
                (true, false) => wants.at(step),
                // What is looked at once all is done.
                (true, true) => Wanted::ALL,
            };
            shaking.engine.bring(evaluated, &wanted);
            lent = (whole && wants.reads_kept(step)).then_some(&*apart).zip(self.ranks.as_ref());
        }
        let Some(Seen { snapshot, history, numbers, memory }) = evaluated.seen() else { return Ok(()) };
        if let Some((apart, ranks)) = lent {
            apart.lend(ranks, model, assembly, memory);
        }
        let history = History::new(assembly, history);
        let view = View { model, assembly, phase, plan, snapshot, history, numbers };
        if whole {
            shaking.balance = snapshot.balance;
            shaking.bodies.clone_from(&snapshot.bodies);
            shaking.audience.look(snapshot.step, &view, memory)?;
        }
        if let Some((apart, _)) = lent {
            apart.take_back(memory);
        }
        shaking.audience.glance(&view, memory)
    }

    /// Ends where the guard found energy.
    fn fail(&mut self, shaking: &mut Shaking, evaluated: Evaluated, halt: Halt) -> Stepping {
        let mut evaluated = evaluated;
        shaking.engine.bring(&mut evaluated, &Wanted::ALL);
        let place = match evaluated.snapshot() {
            Some(seen) => hottest_element(&self.model, &self.phase, seen),
            None => said!("no element"),
        };
        let failed = Stepping::Failed { halt, place };
        self.end(shaking, evaluated, Some(failed.clone()));
        failed
    }

    /// Ends with a state whose parts have seen it; `how` is none where an observer could not look at it.
    fn end(&mut self, shaking: &mut Shaking, evaluated: Evaluated, how: Option<Stepping>) {
        let seen = evaluated.snapshot().cloned().unwrap_or_default();
        (shaking.balance, shaking.bodies) = (seen.balance, seen.bodies.clone());
        self.state = evaluated.end();
        shaking.ended = Some(End { how, seen });
    }

    /// Bytes that this process holds of parts and state, once the shaking goes on.
    pub fn bytes(&self) -> Option<Bytes> {
        self.shaking.as_ref().map(|shaking| shaking.engine.bytes(&self.state))
    }

    /// Element updates a second of the steps made in this process, without looks; 0 before the first.
    pub fn updates_per_second(&self) -> f64 {
        self.shaking.as_ref().map_or(0.0, |Shaking { first, spent, looking, .. }| {
            let steps = (self.state.steps() - first) as f64;
            steps * self.phase.evaluated_elements / spent.saturating_sub(*looking).as_secs_f64().max(1e-9)
        })
    }

    /// What is seen where the simulation stands: of its last stage, or of the step it has come to. Nothing changes by it.
    ///
    /// # Errors
    /// If there is no phase of that stage.
    pub fn look(&mut self) -> Result<(Arc<Phase>, Look), RunError> {
        let Simulation { phase, state, shaking, .. } = self;
        let phase = phase.clone();
        let look = match shaking {
            Some(Shaking { ended: Some(End { seen, .. }), .. }) => Look {
                snapshot: seen.clone(),
                history: state.history.clone(),
                numbers: state.numbers.clone(),
            },
            Some(shaking) => shaking.engine.look(state),
            // Gone back to, and not gone on with yet.
            None if state.steps() > 0 => {
                Engine::among(&self.model, &self.assembly, &self.phase, self.ranks.as_ref()).look(&self.state)
            }
            None => return self.look_at_stage(),
        };
        Ok((phase, look))
    }

    /// Writes a checkpoint of where the simulation stands, if its guard lets it pass; else the halt, and the element where most
    /// energy is. One that has ended keeps the checkpoint that it has.
    ///
    /// # Errors
    /// If the file cannot be written, or an observer failed before; an older one is then untouched.
    pub fn checkpoint(&mut self) -> Result<Option<(Halt, Said)>, RunError> {
        if let Some(shaking) = &mut self.shaking {
            match &shaking.ended {
                Some(End { how: Some(_), .. }) => return Ok(None),
                Some(End { how: None, .. }) => return Err(RunError::Spoiled(self.state.steps())),
                None => {}
            }
            // The guard asks for numbers of the model as a whole alone.
            let mut seen = shaking.engine.look_at(&self.state, &Wanted::default()).snapshot;
            if let Err(halt) = shaking.engine.guard(&seen) {
                shaking.engine.bring_velocities(&mut seen);
                return Ok(Some((halt, hottest_element(&self.model, &self.phase, &seen))));
            }
        }
        self.write_checkpoint()?;
        Ok(None)
    }

    fn write_checkpoint(&mut self) -> Result<(), RunError> {
        let mut state = std::mem::take(&mut self.state);
        let written = self.keep(&mut state);
        self.state = state;
        written
    }

    /// Ends the simulation where it stands: writes what is written at the end, and says what is known of the run. Nothing goes on behind it but
    /// from a checkpoint.
    ///
    /// # Errors
    /// If a file cannot be written; it may then be called again, once there is room on the disk.
    pub fn finish(&mut self, ending: Ending, stage_seconds: f64) -> Result<Outcome, RunError> {
        if self.shaking.is_none() && self.state.steps() > 0 {
            self.shaking = Some(self.begin()?);
        }
        if self.shaking.as_ref().is_some_and(|shaking| shaking.ended.is_none()) {
            let snapshot = self.look()?.1.snapshot;
            if let Some(shaking) = &mut self.shaking {
                (shaking.balance, shaking.bodies) = (snapshot.balance, snapshot.bodies);
            }
        }
        let time = self.time();
        let mut memory = std::mem::take(&mut self.state.observers);
        self.lend(&mut memory);
        self.state.observers = memory;
        if let Some(shaking) = &mut self.shaking {
            shaking.audience.tell(&Event::End { time }, &mut self.state.observers)?;
        }
        let mut state = std::mem::take(&mut self.state);
        // Nothing goes on with it.
        let Whole(_) = self.whole(&mut state);
        let shaking = self.shaking.take();
        let Simulation { model, plan, steps, dt, stable, .. } = &*self;
        let taken = if shaking.is_some() { state.steps() } else { 0 };
        let seconds = |of: fn(&Shaking) -> Duration| shaking.as_ref().map_or(0.0, |s| of(s).as_secs_f64());
        Ok(Outcome {
            ending,
            steps: *steps,
            taken,
            taken_here: taken - shaking.as_ref().map_or(0, |shaking| shaking.first),
            dt: *dt,
            stable: stable.clone(),
            loop_seconds: seconds(|shaking| shaking.spent),
            step_seconds: seconds(|shaking| shaking.spent.saturating_sub(shaking.looking)),
            stages: summaries(model, plan, &state.observers),
            shaken: shaking.is_some(),
            stage_seconds,
            quiet: state.observers.get(DRIFT).and_then(|drift| drift.first().copied()),
            held: shaking.as_ref().and_then(|shaking| shaking.held),
            balance: shaking.as_ref().map_or(Lines::default(), |shaking| shaking.balance),
            bodies: shaking.map_or(Vec::new(), |shaking| shaking.bodies),
            state,
        })
    }
}

/// The element whose corners move with most energy, or the first of which that is not a number. What elements hold would name those
/// that bear most of the ground's own stress.
fn hottest_element(model: &Model, phase: &Phase, snapshot: &Snapshot) -> Said {
    let mut worst = (f64::NEG_INFINITY, 0);
    let standing = (0..).zip(&phase.element_slot).filter(|(_, slot)| slot.is_some()).map(|(e, _)| e);
    for e in standing {
        let corners = model.mesh.elements[e as usize].nodes();
        let energy: f64 = corners
            .iter()
            .map(|&corner| {
                let node = model.engine_node[corner as usize] as usize;
                let square: f64 = snapshot.velocity[node].xyz().iter().map(|v| v * v).sum();
                0.5 * phase.mass[node] * square
            })
            .sum();
        if !energy.is_finite() {
            worst = (energy, e);
            break;
        }
        if energy > worst.0 {
            worst = (energy, e);
        }
    }
    places::element_at(model, worst.1)
}
