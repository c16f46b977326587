//! A state whose parts have been evaluated, and the step on from there.

use super::evaluation::{Forces, Probed};
use super::{Engine, Snapshot, nodes};
use crate::exchange::To;
use crate::model::Model;
use crate::parts::Kept;
use crate::phase::Phase;
use crate::state::{Memory, State};
use std::sync::Arc;
use tremolite_laws::Octet;

/// A state u^n whose parts have seen it, with the forces that they push with there. It can be looked at and advanced once; it
/// cannot be evaluated again.
pub struct Evaluated {
    model: Arc<Model>,
    phase: Arc<Phase>,
    state: State,
    forces: Forces,
    snapshot: Option<Snapshot>,
    /// Histories and numbers of all ranks, where something is to be seen by the first of several.
    all: Option<(Vec<Octet>, Vec<f64>)>,
}

impl Evaluated {
    /// The state, whose parts remember what they saw.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// What was seen, if that was wished.
    pub fn snapshot(&self) -> Option<&Snapshot> {
        self.snapshot.as_ref()
    }

    /// What observers are shown, with what they remember, if anything was to be seen.
    pub fn seen(&mut self) -> Option<Seen<'_>> {
        let Evaluated { state: State { history, numbers, observers, .. }, snapshot, all, .. } = self;
        let (history, numbers) = match all {
            Some((history, numbers)) => (&*history, &*numbers),
            None => (&*history, &*numbers),
        };
        Some(Seen { snapshot: snapshot.as_ref()?, history, numbers, memory: observers })
    }

    /// The state at the end of a run: what its laws remember is that of its displacements, so that no step goes on from it.
    pub fn end(self) -> State {
        self.state
    }
}

/// What is to be seen as a state is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum See {
    Nothing,
    /// Stresses of some members alone ([`Engine::glance_at`]): the rest of the snapshot is empty, and nothing is booked.
    Glance,
    Look,
}

/// What observers are shown of an evaluated state.
pub struct Seen<'e> {
    pub snapshot: &'e Snapshot,
    /// Histories of the laws and numbers of the parts.
    pub history: &'e [Octet],
    pub numbers: &'e [f64],
    /// What observers remember.
    pub memory: &'e mut Memory,
}

/// What is seen at a state that is left as it is.
#[derive(Clone, Debug, Default)]
pub struct Look {
    pub snapshot: Snapshot,
    /// Histories of the laws and numbers of the parts, as they are once evaluated there.
    pub history: Vec<Octet>,
    pub numbers: Vec<f64>,
}

impl Engine {
    /// Evaluates all active parts at a state, and sees what is wished of it. Of several ranks the first alone sees nodes, elements and what parts
    /// remember; the others of these what is their own, and numbers of the model as a whole.
    pub fn evaluate(&mut self, mut state: State, see: See) -> Evaluated {
        let mut probed =
            (see != See::Nothing).then(|| Probed { glance: see == See::Glance, ..Probed::default() });
        self.evaluate_at(&mut state, probed.as_mut());
        let mut all = None;
        let snapshot = probed.map(|mut probed| {
            if see == See::Glance {
                self.soak(&mut probed.stress, &state.kept());
                self.gather_glanced(&mut probed.stress);
                let (step, time) = (state.steps(), state.time());
                let Probed { stress, energy, .. } = probed;
                return Snapshot { step, time, stress, energy, ..Snapshot::default() };
            }
            let mut snapshot = self.snapshot(&state, state.kept(), probed);
            all = self.gather(&mut snapshot, &state.history, &state.numbers);
            snapshot
        });
        let (model, phase) = (self.model.clone(), self.phase.clone());
        Evaluated { model, phase, state, forces: std::mem::take(&mut self.forces), snapshot, all }
    }

    /// Brings the stresses of a glance together on the first rank.
    fn gather_glanced(&self, stress: &mut Vec<[f64; 6]>) {
        if let Engine { assembly, glanced, ranks: Some(ranks), .. } = self {
            let only = |m: u32| glanced.contains(&m);
            let unknown = (6, [f64::NAN; 6]);
            *stress = ranks.some_members(assembly, only, stress, unknown, |s| s.points.clone(), To::First);
        }
    }

    /// Brings together on the first rank what was seen by several, where there are: histories and numbers of all.
    fn gather(
        &self,
        snapshot: &mut Snapshot,
        history: &[Octet],
        numbers: &[f64],
    ) -> Option<(Vec<Octet>, Vec<f64>)> {
        let Engine { model, assembly, ranks, .. } = self;
        let ranks = ranks.as_ref()?;
        let Snapshot { displacement, velocity, acceleration, stress, pore, energy, .. } = snapshot;
        for rows in [displacement, velocity, acceleration] {
            ranks.nodes(model, rows, To::First);
        }
        *stress = ranks.members(assembly, stress, 6, |s| s.points.clone(), To::First);
        *energy = ranks.members(assembly, energy, 5, |s| s.elements.clone(), To::First);
        // Each rank has some of it, or none has.
        if !model.water.spells.is_empty() {
            *pore = ranks.members(assembly, pore, 1, |s| s.elements.clone(), To::First);
        }
        let history = ranks.members(assembly, history, 8, |s| s.history.clone(), To::First);
        Some((history, ranks.members(assembly, numbers, 1, |s| s.numbers.clone(), To::First)))
    }

    /// Goes on from u^n to u^{n+1}.
    pub fn advance(&mut self, evaluated: Evaluated) -> State {
        let Evaluated { model, phase, mut state, mut forces, .. } = evaluated;
        let Forces { contributions, rates, leads, works } = &mut forces;
        // A given free field is at rest in a quiet run.
        let time = (!self.quiet).then(|| state.time());
        nodes::advance(&model, &phase, time, contributions, &rates.products, leads, &mut state);
        state.ledger.book(&phase.beat(&state).active, works);
        state.step += 1;
        self.forces = forces;
        if self.watches(&state) {
            self.close_books(&mut state);
        }
        state
    }

    /// What is seen at the end of a run: what its parts remember is then that of its displacements, and no step goes on from it.
    pub fn finish(&mut self, state: &mut State) -> Snapshot {
        let mut evaluated = self.evaluate(std::mem::take(state), See::Look);
        let snapshot = evaluated.snapshot.take().unwrap_or_default();
        *state = evaluated.state;
        snapshot
    }

    /// What is seen at a state, which is left as it is: parts are evaluated on copies of their memory. Of several ranks the first alone sees it
    /// whole, as in [`Engine::evaluate`].
    pub fn look(&mut self, state: &State) -> Look {
        let mut probed = Probed::default();
        let (history, numbers) = self.evaluate_copies(state, Some(&mut probed));
        let kept = Kept { history: &history, numbers: &numbers, ..state.kept() };
        let mut snapshot = self.snapshot(state, kept, probed);
        let all = self.gather(&mut snapshot, &history, &numbers);
        let (history, numbers) = all.unwrap_or((history, numbers));
        Look { snapshot, history, numbers }
    }
}
