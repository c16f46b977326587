//! What an observer is, what it says that it wants to be shown, and what it is told.

use crate::error::RunError;
use crate::history::History;
use crate::plan::{Plan, Steps};
use std::sync::Arc;
use tremolite_engine::Snapshot;
use tremolite_engine::Stage;
use tremolite_engine::assembly::{Assembly, Slices};
use tremolite_engine::engine::Rest;
use tremolite_engine::member::Kind;
use tremolite_engine::model::Model;
use tremolite_engine::phase::Phase;
use tremolite_engine::phase::beats::span;
use tremolite_engine::state::Memory;
use tremolite_laws::Row;
use tremolite_results::ResultFolder;

/// Something that looks at a run. It is made anew for each stage before the shaking and for the shaking: all that it remembers from
/// one time that it is told something to the next, or to the next observer of its kind, is in the memory that it is given, which is
/// part of the state. So a resumed run goes on as if it had never stopped.
pub trait Observer: Send {
    /// What it is to be told and shown: that and nothing else. It is asked once.
    fn wants(&self) -> Wants;
    /// Is told what happened; it looks, writes and remembers.
    ///
    /// # Errors
    /// If a result file cannot be written.
    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError>;
}

/// When an observer looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Schedule {
    /// Every so many steps.
    pub every: u64,
    /// At the last step as well, whatever its number.
    pub last: Option<u64>,
}

impl Schedule {
    /// Whether to look at this step.
    pub fn due(&self, step: u64) -> bool {
        step.is_multiple_of(self.every) || Some(step) == self.last
    }
}

/// Which of a kind: engine nodes, elements of the mesh or members, by their numbers.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Which {
    #[default]
    Nothing,
    Some(Vec<u32>),
    All,
}

impl Which {
    /// Some of a kind, each once.
    pub fn some(all: impl IntoIterator<Item = usize>) -> Self {
        let mut all: Vec<u32> = all.into_iter().map(|one| one as u32).collect();
        all.sort_unstable();
        all.dedup();
        Which::Some(all)
    }

    /// What any of both is.
    pub(super) fn and(self, other: &Which) -> Self {
        match (self, other) {
            (Which::All, _) | (_, Which::All) => Which::All,
            (Which::Nothing, other) => other.clone(),
            (own, Which::Nothing) => own,
            (Which::Some(own), Which::Some(other)) => {
                Which::some(own.iter().chain(other).map(|&one| one as usize))
            }
        }
    }

    /// Members of some kinds.
    pub fn members(assembly: &Assembly, wanted: impl Fn(Kind) -> bool) -> Self {
        let members = assembly.members.iter().enumerate();
        Which::some(members.filter(|(_, member)| wanted(member.kind)).map(|(m, _)| m))
    }

    /// Engine nodes of some elements.
    pub fn corners(model: &Model, elements: impl IntoIterator<Item = u32>) -> Self {
        let corners = elements.into_iter().flat_map(|e| model.mesh.elements[e as usize].nodes());
        Which::some(corners.map(|&node| model.engine_node[node as usize] as usize))
    }
}

/// What an observer wants to be told and shown. Energy balances it sees in every look.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Wants {
    /// When it looks in the shaking.
    pub looks: Option<Schedule>,
    /// Whether it glances at every step of the coarsest level, its last included: at times and stresses of the elements that it
    /// wants and what members remember, nothing else. Cheaper than a look where the elements are few.
    pub glances: bool,
    /// Of how many cycles of a stage's relaxation it is told of one.
    pub cycles: Option<u64>,
    /// Engine nodes whose motion it sees in looks and at the end of a stage.
    pub nodes: Which,
    /// Elements of the mesh whose stress, energies and history it sees there.
    pub elements: Which,
    /// Elements of which it sees the history alone.
    pub histories: Which,
    /// Members of the assembly of which it sees all that they remember there: pairs, bolts, parts of a program's own.
    pub members: Which,
    /// Engine nodes of whose motion it is told in every step.
    pub steps: Which,
    /// Columns of its memory that go by what it sees of one node or element alone, and what they have a number of. An observer with such columns
    /// keeps nothing else and has no files: of several ranks each has its own part of it.
    pub keeps: Vec<(String, Keeps)>,
    /// Whether it reads in looks what others keep so.
    pub reads_kept: bool,
}

/// What a column of memory has a number of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keeps {
    /// Each engine node.
    Nodes,
    /// Each element, in the order of members.
    Elements,
}

impl Wants {
    /// Whether it looks at a step.
    pub(super) fn look_at(&self, step: u64) -> bool {
        self.looks.is_some_and(|schedule| schedule.due(step))
    }

    /// Looks by a schedule at numbers of the model as a whole.
    pub fn looks(schedule: Schedule) -> Self {
        Wants { looks: Some(schedule), ..Wants::default() }
    }
}

/// What happened, in this order.
pub enum Event<'e> {
    /// A stage before the shaking begins, or goes on where it was stopped: its number.
    StageBegins(usize),
    /// A cycle of its relaxation was made.
    Cycle(CycleMade<'e>),
    /// It came to rest, or was given up.
    StageEnds(StageSeen<'e>),
    /// All stages were those of another run: what is remembered of them is to be written.
    StagesTaken,
    /// A look that was due, before the step on from there.
    Look(View<'e>),
    /// The same for those who glance, where there need not be a look.
    Glance(View<'e>),
    /// A step was made.
    Step(Stepped<'e>),
    /// The shaking is over, or stops here at this time \[s\]: what is written whole is to be written.
    End { time: f64 },
}

/// A cycle of a stage's relaxation.
#[derive(Clone, Copy)]
pub struct CycleMade<'e> {
    pub stage: usize,
    /// How near to rest it left the model.
    pub rest: &'e Rest,
    /// Whether pairs that begin under load have been given what passed between their sides, in the initial equilibrium.
    pub freed: bool,
}

/// What an observer sees at u^n: numbers of that time, wherever the state itself is kept.
#[derive(Clone, Copy)]
pub struct View<'a> {
    pub model: &'a Model,
    pub assembly: &'a Assembly,
    pub phase: &'a Phase,
    pub plan: &'a Plan,
    pub snapshot: &'a Snapshot,
    /// What laws remember at points.
    pub history: History<'a>,
    /// What other parts remember.
    pub numbers: &'a [f64],
}

impl<'a> View<'a> {
    /// What a part remembers beside histories of points.
    pub fn numbers_of(&self, slices: &Slices) -> &'a [f64] {
        &self.numbers[slices.numbers.clone()]
    }
}

/// The end of a stage. Nothing in it has a velocity.
#[derive(Clone, Copy)]
pub struct StageSeen<'e> {
    pub stage: usize,
    /// Whether it came to rest; else it was given up, and `rest` and `last` tell how it moved then.
    pub at_rest: bool,
    pub rest: &'e Rest,
    pub view: View<'e>,
    /// Displacement \[m\] by engine node since the model was made; that of `view` counts from the initial equilibrium.
    pub u: &'e [Row],
    /// What it was when the stage began, and by how much the last cycle changed it.
    pub start: &'e [Row],
    pub last: &'e [Row],
    /// Displacements \[m\] from which elements count that begin later than the model, member by member.
    pub reference: &'e [Row],
}

/// A step of the finest level just made. Nodes of coarser levels are in the middle of theirs unless [`Stepped::own`] says otherwise:
/// where they are is not told.
#[derive(Clone, Copy)]
pub struct Stepped<'a> {
    pub model: &'a Model,
    pub plan: &'a Plan,
    /// Steps of the finest level made since t = 0.
    pub steps: u64,
    /// u^{n+1} and u^{n+1} − u^n by engine node \[m\], and the step \[s\], of the finest level; the increment of a node is the same
    /// in all steps of the finest level that are in one of its own.
    pub u: &'a [Row],
    /// What u was at t = 0 \[m\]; empty where that was nothing.
    pub datum: &'a [Row],
    pub du: &'a [Row],
    pub dt: f64,
}

impl Stepped<'_> {
    /// The step \[s\] of the slowest of some engine nodes, where that has just come to its end: all of them are then at times of
    /// their own.
    pub fn own(&self, nodes: impl IntoIterator<Item = usize>) -> Option<f64> {
        let slowest = nodes.into_iter().map(|n| self.model.nodes.level[n]).max().unwrap_or(0);
        let span = span(slowest);
        self.steps.is_multiple_of(span).then_some(span as f64 * self.dt)
    }
}

/// What observers are made from, when a stage or the shaking begins or goes on.
pub struct Setting<'a> {
    pub folder: &'a ResultFolder,
    pub model: &'a Arc<Model>,
    pub assembly: &'a Arc<Assembly>,
    /// Of the stage, or of the shaking.
    pub phase: &'a Arc<Phase>,
    pub plan: &'a Arc<Plan>,
    pub steps: Steps,
    /// What was remembered before; empty at the start.
    pub memory: &'a Memory,
    /// Step and time \[s\] since t = 0 from which the run goes on, and the step \[s\].
    pub step: u64,
    pub time: f64,
    pub dt: f64,
}

impl Setting<'_> {
    /// The schedule of the rows of histories.
    pub fn rows(&self) -> Schedule {
        Schedule { every: self.steps.histories, last: Some(self.steps.total) }
    }

    /// Whether the earthquake begins or goes on, rather than a stage.
    pub fn shakes(&self) -> bool {
        self.phase.stage == Stage::Shaking
    }
}

/// Makes an observer, or nothing where it would have nothing to see.
///
/// # Errors
/// If a file of its cannot be written or gone on with.
pub type MakeObserver = dyn Fn(&Setting) -> Result<Option<Box<dyn Observer>>, RunError> + Send + Sync;

/// Observers of a program's own, which are told behind those of the program.
pub type OwnObservers = Vec<Arc<MakeObserver>>;
