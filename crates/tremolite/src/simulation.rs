//! A simulation that anybody can hold: stages before the earthquake one by one, then steps, with looks between them.
//!
//! It owns the state and shares the model, and nothing outside ever sees a state within a step. Whoever drives it decides when to
//! go on; results do not depend on how. Files are written by its observers as it goes, so that what is done stays done.

mod astray;
mod followed;
mod outcome;
mod shaking;
mod stages;

pub use outcome::{Ending, Outcome};
pub use shaking::Stepping;
pub use stages::{Cycle, Go, StageEnd};

use crate::checkpoint::{self, Among, CheckpointError};
use crate::error::RunError;
use crate::fingerprint::fingerprint;
use crate::levels::{levels, longest_step};
use crate::observers::{
    Apart, Audience, Event, OwnObservers, Setting, check_tables, forget_own_tables, observers_among_ranks,
    summaries,
};
use crate::plan::{Plan, Steps};
use crate::trust;
use shaking::Shaking;
use std::sync::Arc;
use tremolite_engine::assembly::Assembly;
pub use tremolite_engine::engine::Look;
use tremolite_engine::engine::{Proof, prove};
use tremolite_engine::exchange::To;
use tremolite_engine::model::Model;
use tremolite_engine::phase::Phase;
use tremolite_engine::phase::beats::span;
use tremolite_engine::ranks::Columns;
use tremolite_engine::state::{Memory, State};
use tremolite_engine::{ModelError, Ranks, StableStep, Stage, finer_levels, stable_step};
use tremolite_results::{ResultFolder, TrustLine};

/// The step of the finest level that a model runs with, and the plan in steps.
pub fn choose_step(model: &Model, plan: &Plan, stable: &StableStep) -> (f64, Steps) {
    let longest = longest_step(model, stable);
    plan.steps(plan.row(longest.min(stable.dt)), longest, span(model.nodes.coarsest()))
}

/// What a simulation shares with whoever made it: a model, its parts, those that are active as the ground shakes, and the stable step,
/// which takes hundreds of products to find.
#[derive(Clone)]
pub struct Built {
    pub model: Arc<Model>,
    pub assembly: Arc<Assembly>,
    /// Of the shaking.
    pub phase: Arc<Phase>,
    pub stable: StableStep,
}

impl Built {
    /// Finds the stable step.
    pub fn of(model: &Arc<Model>, assembly: &Arc<Assembly>, phase: &Arc<Phase>) -> Self {
        let stable = stable_step(model, assembly, phase);
        Built { model: model.clone(), assembly: assembly.clone(), phase: phase.clone(), stable }
    }

    /// The same with the levels of steps that a plan leaves worth having, if the surroundings of their borders are stable with them:
    /// where not, with finer levels there, or in the end with one.
    ///
    /// # Errors
    /// If its boundaries or interfaces cannot be made, as for the model before.
    pub fn levelled(self, plan: &Plan) -> Result<Self, ModelError> {
        let dt = longest_step(&self.model, &self.stable);
        let mut levels = levels(&self.model, &self.assembly, &self.phase, plan, &self.stable)?;
        for _ in 0..TRIES {
            if levels.coarsest() == 0 {
                break;
            }
            let model = self.model.at_levels(&levels);
            let assembly = self.assembly.again(&model)?;
            let phase = Phase::of(&model, &assembly, Stage::Shaking)?;
            let Proof { grown, .. } = prove(&model, &assembly, &phase, dt);
            if grown.is_empty() {
                let stable = self.stable.renumbered(&self.assembly, &model, &assembly);
                return Ok(Built { model, assembly, phase, stable });
            }
            levels = finer_levels(&model, &assembly, &phase, &grown);
        }
        Ok(self)
    }
}

/// Sets of levels that are tried before a run has one level.
const TRIES: usize = 4;

/// What a run begins with.
#[derive(Clone, Copy, Debug)]
pub enum Start<'a> {
    /// Rest, before all stages.
    Rest,
    /// The checkpoint of its own folder, or what its earthquake began with where there is none yet.
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

/// A model on its way through a plan.
///
/// Works on the rayon pool that it is called from. The bits of the results depend neither on its size nor on how the simulation is
/// driven.
pub struct Simulation {
    model: Arc<Model>,
    assembly: Arc<Assembly>,
    plan: Arc<Plan>,
    /// Of the shaking.
    phase: Arc<Phase>,
    folder: ResultFolder,
    /// Makers of observers of which each of several ranks has its own part, and of all others; and whether what these do not want is not a number to
    /// them.
    apart: OwnObservers,
    observers: OwnObservers,
    poisoned: bool,
    stable: StableStep,
    dt: f64,
    steps: Steps,
    fingerprint: u64,
    state: State,
    /// The shaking, once it goes on.
    shaking: Option<Shaking>,
    /// The rank that this process is, where several work on the model. The first alone has observers and writes.
    ranks: Option<Arc<Ranks>>,
    /// How often it was asked whether to stop, and what any rank has wished for since all were asked.
    asked: u64,
    wished: u64,
    fallen_back: Option<String>,
}

/// What a rank has itself of a state that is [whole](Simulation::whole).
#[must_use]
struct Whole(Option<Columns>);

impl Whole {
    /// Leaves of the state what the rank has itself.
    fn give_back(self, state: &mut State) {
        if let Some(own) = self.0 {
            own.give_back(state);
        }
    }
}

/// Askings whether to stop between times at which ranks agree.
const AGREE: u64 = 8;

impl Simulation {
    /// A simulation of a plan on a model, which writes its files into a folder. `own` are observers of a program's own, which are told
    /// behind those of the program.
    ///
    /// # Errors
    /// If there is no checkpoint to start from, or it is of another model or plan.
    pub fn new(
        built: &Built,
        plan: &Plan,
        folder: &ResultFolder,
        start: Start,
        own: OwnObservers,
    ) -> Result<Self, RunError> {
        Simulation::among(built, plan, folder, start, own, None)
    }

    /// What a rank has of one, if there are several: all of them call the same functions in the same order, and read the same checkpoint. The
    /// first has the observers, and writes; of the others nothing is to be had but numbers of the model as a whole.
    ///
    /// # Errors
    /// As [`Simulation::new`]. An error on one rank is not told to the others: who drives it ends them all.
    pub fn among(
        built: &Built,
        plan: &Plan,
        folder: &ResultFolder,
        start: Start,
        own: OwnObservers,
        ranks: Option<Arc<Ranks>>,
    ) -> Result<Self, RunError> {
        let Built { model, mut assembly, phase, stable } = built.clone();
        if let Some(ranks) = &ranks {
            assembly = Arc::new(assembly.of_rank(&ranks.division, ranks.rank()));
        }
        let (dt, steps) = choose_step(&model, plan, &stable);
        let fingerprint = fingerprint(&model, &assembly, plan, dt);
        let [apart, others] = observers_among_ranks();
        let mut simulation = Simulation {
            model,
            assembly,
            plan: Arc::new(plan.clone()),
            phase,
            folder: folder.clone(),
            apart,
            observers: others.into_iter().chain(own).collect(),
            poisoned: false,
            stable,
            dt,
            steps,
            fingerprint,
            state: State::default(),
            shaking: None,
            ranks,
            asked: 0,
            wished: 0,
            fallen_back: None,
        };
        if let Some(ranks) = &simulation.ranks {
            let all = ranks.each(f64::from_bits(fingerprint));
            if let Some(other) = all.iter().position(|one| one.to_bits() != all[0].to_bits()) {
                return Err(RunError::OtherRank(other));
            }
        }
        match start {
            Start::Rest => simulation.state = simulation.at_rest(),
            Start::Resume if checkpoint::is_hand_over_alone(&folder.checkpoint()) => {
                simulation.fallen_back =
                    Some("no checkpoint is there; the run goes on from where the earthquake began".into());
                simulation.shake_from(folder)?
            }
            Start::Resume => simulation.restore()?,
            Start::From(other) => {
                simulation.shake_from(other)?;
                simulation.hand_over_begins()?;
            }
        }
        Ok(simulation)
    }

    /// Begins with what a run had come to before its earthquake.
    fn shake_from(&mut self, folder: &ResultFolder) -> Result<(), RunError> {
        let mut state = self.at_rest();
        checkpoint::read_hand_over(&folder.checkpoint(), &mut state, self.fingerprint, &self.among_ranks())?;
        self.state = state;
        self.state.dt = self.dt;
        if folder.root() == self.folder.root() {
            self.check_tables(&self.state)?;
        } else {
            forget_own_tables(&mut self.state.observers);
        }
        self.take_stages()
    }

    /// From now on what an observer does not want is not a number to it: a mode for tests, slower, with the same files where every
    /// observer names what it sees.
    #[must_use]
    pub fn poisoned(mut self) -> Self {
        self.poisoned = true;
        self
    }

    /// Takes other observers than the program's and its own.
    #[must_use]
    pub fn observed_by(mut self, observers: OwnObservers) -> Self {
        (self.apart, self.observers) = (Vec::new(), observers);
        self
    }

    /// What observers of a phase are made from, where the run goes on from a state.
    fn setting<'s>(&'s self, phase: &'s Arc<Phase>, state: &'s State) -> Setting<'s> {
        let Simulation { folder, model, assembly, plan, .. } = self;
        Setting {
            folder,
            model,
            assembly,
            phase,
            plan,
            steps: self.steps,
            memory: &state.observers,
            step: state.steps(),
            time: state.time(),
            dt: self.dt,
        }
    }

    /// The observers of a phase, which goes on from a state.
    fn audience(&self, phase: &Arc<Phase>, state: &State) -> Result<Audience, RunError> {
        let setting = self.setting(phase, state);
        let Some(ranks) = &self.ranks else {
            let all = [&self.apart[..], &self.observers].concat();
            return Audience::of(&all, &setting, self.poisoned);
        };
        let own = match ranks.is_first() {
            true => Audience::of(&self.observers, &setting, self.poisoned)?,
            false => Audience::default(),
        };
        Ok(own.of_first(ranks))
    }

    /// A rank's part of those that look at each node and element by itself, with what the state remembers of that; `phase` is what the rank has of the
    /// shaking. None in one process, where they are among the others.
    fn observers_apart(&self, phase: &Arc<Phase>, state: &mut State) -> Result<Option<Apart>, RunError> {
        if self.ranks.is_none() {
            return Ok(None);
        }
        let mut memory = std::mem::take(&mut state.observers);
        let apart = Apart::of(&self.apart, &self.setting(phase, state), &mut memory);
        state.observers = memory;
        apart.map(Some)
    }

    /// Whether this process writes files.
    fn writes(&self) -> bool {
        self.ranks.as_ref().is_none_or(|ranks| ranks.is_first())
    }

    /// Gives a state what nodes and books have, on the first rank.
    fn nodes_whole(&self, state: &mut State) {
        if let Some(ranks) = &self.ranks {
            ranks.whole(&self.model, state, To::First);
        }
    }

    /// A state with all that nodes, books and members have, on the first rank, for as long as it is written or looked at.
    fn whole(&self, state: &mut State) -> Whole {
        Whole(self.ranks.as_ref().map(|ranks| {
            ranks.whole(&self.model, state, To::First);
            ranks.collect(&self.assembly, state, To::First)
        }))
    }

    /// What all ranks do together, if there are several: stop if any wishes so, write a checkpoint if the first does. All are asked now and
    /// then, so it may come a few steps later.
    pub fn agreed(&mut self, stop: bool, checkpoint: bool) -> [bool; 2] {
        let Some(ranks) = &self.ranks else { return [stop, checkpoint] };
        self.wished |= u64::from(stop) | (u64::from(checkpoint && ranks.is_first()) << 1);
        self.asked += 1;
        if !self.asked.is_multiple_of(AGREE) {
            return [false; 2];
        }
        let all = ranks.agree(std::mem::take(&mut self.wished));
        [all & 1 > 0, all & 2 > 0]
    }

    /// The rank that this process is, where several work on the model.
    pub fn ranks(&self) -> Option<&Arc<Ranks>> {
        self.ranks.as_ref()
    }

    /// Tells observers that another run's stages were taken over.
    fn take_stages(&mut self) -> Result<(), RunError> {
        let Some(last) = self.plan.stages.len().checked_sub(1) else { return Ok(()) };
        let phase = Phase::of(&self.model, &self.assembly, Stage::Before(last as u16))?;
        let mut audience = self.audience(&phase, &self.state)?;
        audience.tell(&Event::StagesTaken, &mut self.state.observers)
    }

    /// Who has the columns of a state.
    fn among_ranks(&self) -> Among<'_> {
        Among(self.ranks.as_ref().map(|ranks| (&**ranks, &*self.assembly)))
    }

    fn at_rest(&self) -> State {
        let mut state = self.assembly.rest();
        state.dt = self.dt;
        state
    }

    /// Whether the tables in its folder begin with what a state knows of them, where this process writes them.
    fn check_tables(&self, state: &State) -> Result<(), RunError> {
        if self.writes() { check_tables(self.folder.root(), &state.observers) } else { Ok(()) }
    }

    /// Goes back to the checkpoint in its folder. Tables are cut back to it as soon as it goes on.
    ///
    /// # Errors
    /// If there is none, it is damaged or of another model or plan, or a table was changed since.
    pub fn restore(&mut self) -> Result<(), RunError> {
        let mut state = self.at_rest();
        let folder = self.folder.clone();
        match checkpoint::read(&folder.checkpoint(), &mut state, self.fingerprint, &self.among_ranks()) {
            Ok(damaged) => {
                self.check_tables(&state)?;
                let why = damaged.map(|why| why.what());
                self.fallen_back =
                    why.map(|why| format!("{why}; the run goes on from the checkpoint before"));
                (self.state, self.shaking) = (state, None);
                Ok(())
            }
            // What the earthquake began with is of the same run.
            Err(why @ (CheckpointError::Damaged { .. } | CheckpointError::Io { .. }))
                if self.shake_from(&folder).is_ok() =>
            {
                self.fallen_back =
                    Some(format!("{}; the run goes on from where the earthquake began", why.what()));
                self.shaking = None;
                Ok(())
            }
            Err(why) => Err(why.into()),
        }
    }

    /// Writes a checkpoint, once the tables that it knows are on the disk; of several ranks the first does.
    fn keep(&self, state: &mut State) -> Result<(), RunError> {
        self.nodes_whole(state);
        self.lend(&mut state.observers);
        if self.writes() {
            self.folder.sync()?;
        }
        let written =
            checkpoint::write(&self.folder.checkpoint(), state, self.fingerprint, &self.among_ranks());
        self.take_back(&mut state.observers);
        Ok(written?)
    }

    /// Gives the first rank's memory what observers keep on all ranks.
    fn lend(&self, memory: &mut Memory) {
        if let Some((apart, ranks)) = self.apart().zip(self.ranks.as_ref()) {
            apart.lend(ranks, &self.model, &self.assembly, memory);
        }
    }

    /// Takes it out again.
    fn take_back(&self, memory: &mut Memory) {
        if let Some(apart) = self.apart() {
            apart.take_back(memory);
        }
    }

    fn apart(&self) -> Option<&Apart> {
        self.shaking.as_ref()?.apart()
    }

    /// Why the run does not go on from its last checkpoint, where that is so.
    pub fn fallen_back(&self) -> Option<&str> {
        self.fallen_back.as_deref()
    }

    /// The step \[s\], and the plan in steps.
    pub fn steps(&self) -> (f64, Steps) {
        (self.dt, self.steps)
    }

    pub fn model(&self) -> &Arc<Model> {
        &self.model
    }

    pub fn assembly(&self) -> &Arc<Assembly> {
        &self.assembly
    }

    /// Checks whose value is known of the stages that are at rest: the same that the summary will have.
    pub fn checks_of_stages(&self) -> Vec<TrustLine> {
        let memory = &self.state.observers;
        let stages = summaries(&self.model, &self.plan, memory);
        trust::of_stages(&self.model, &self.plan, &stages, memory)
    }

    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Steps taken since t = 0.
    pub fn taken(&self) -> u64 {
        self.state.steps()
    }

    /// Time since the earthquake began \[s\].
    pub fn time(&self) -> f64 {
        self.state.time()
    }

    /// The number of the stage that comes next or goes on; none once all are done.
    pub fn stage(&self) -> Option<usize> {
        let next = self.state.stage as usize;
        (next < self.plan.stages.len()).then_some(next)
    }
}
