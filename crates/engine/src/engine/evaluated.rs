//! A state whose parts have been evaluated, and the step on from there.

use super::evaluation::{Forces, Probed};
use super::{Engine, Snapshot, nodes};
use crate::assembly::Slices;
use crate::exchange::To;
use crate::model::Model;
use crate::parts::{ElementEnergy, Kept};
use crate::phase::Phase;
use crate::ranks::Wanted;
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

/// Room on the first of several ranks for what it is shown, as one process has it.
#[derive(Clone, Debug, Default)]
pub(super) struct Shown {
    stress: Vec<[f64; 6]>,
    energy: Vec<ElementEnergy>,
    pore: Vec<f64>,
    history: Vec<Octet>,
    numbers: Vec<f64>,
}

impl Shown {
    /// Makes it as long as the columns are; what is in it from before is not a number where it is poisoned.
    fn lay_out(&mut self, totals: &Slices, wet: bool, poisoned: bool) {
        fn fit<T: Clone>(all: &mut Vec<T>, length: usize, unknown: T, poisoned: bool) {
            if poisoned {
                all.clear();
            }
            all.resize(length, unknown);
        }
        let nan = f64::NAN;
        let energy = ElementEnergy { strain: nan, hourglass: nan, dissipated: nan, created: nan, band: nan };
        fit(&mut self.stress, totals.points.end, [nan; 6], poisoned);
        fit(&mut self.energy, totals.elements.end, energy, poisoned);
        fit(&mut self.pore, if wet { totals.elements.end } else { 0 }, nan, poisoned);
        fit(&mut self.history, totals.history.end, Octet([nan; 8]), poisoned);
        fit(&mut self.numbers, totals.numbers.end, nan, poisoned);
    }
}

impl Engine {
    /// Evaluates all active parts at a state, and sees what is wished of it. Of several ranks each sees nodes, elements and what parts remember as
    /// far as they are its own, where it holds them, until they are [brought together](Engine::bring); numbers of the model as a whole all see.
    pub fn evaluate(&mut self, mut state: State, see: See) -> Evaluated {
        let mut probed =
            (see != See::Nothing).then(|| Probed { glance: see == See::Glance, ..Probed::default() });
        self.evaluate_at(&mut state, probed.as_mut());
        let snapshot = probed.map(|mut probed| {
            if see == See::Glance {
                self.soak(&mut probed.stress, &state.kept());
                let (step, time) = (state.steps(), state.time());
                let Probed { stress, energy, .. } = probed;
                return Snapshot { step, time, stress, energy, ..Snapshot::default() };
            }
            self.snapshot(&state, state.kept(), probed)
        });
        let (model, phase) = (self.model.clone(), self.phase.clone());
        Evaluated { model, phase, state, forces: std::mem::take(&mut self.forces), snapshot, all: None }
    }

    /// Brings together on the first rank what is wanted of what was seen by several, once; all else is unknown there.
    pub fn bring(&mut self, evaluated: &mut Evaluated, wanted: &Wanted) {
        let Evaluated { state, snapshot: Some(snapshot), all, .. } = evaluated else { return };
        let mut shown = std::mem::take(&mut self.shown);
        *all = self.gather(snapshot, (&state.history, &state.numbers), wanted, &mut shown);
        self.shown = shown;
    }

    /// Brings velocities \[m/s\] of all nodes together on the first rank, whatever else was brought.
    pub fn bring_velocities(&self, snapshot: &mut Snapshot) {
        if let Some(ranks) = &self.ranks {
            ranks.nodes(&self.model, &mut snapshot.velocity, To::First);
        }
    }

    /// The same into a snapshot: histories and numbers of members on the first of several ranks.
    fn gather(
        &self,
        snapshot: &mut Snapshot,
        (history, numbers): (&[Octet], &[f64]),
        wanted: &Wanted,
        shown: &mut Shown,
    ) -> Option<(Vec<Octet>, Vec<f64>)> {
        let Engine { model, assembly, ranks, .. } = self;
        let ranks = ranks.as_ref()?;
        let Snapshot { displacement, velocity, acceleration, stress, pore, energy, .. } = snapshot;
        let mut rows = [displacement, velocity, acceleration];
        // A glance has none. Pressures each rank has some of, or none has.
        let looked = !rows[0].is_empty();
        let wet = looked && !model.water.spells.is_empty();
        let Wanted { blocks, members, histories } = wanted;
        let mut of_laws = histories.clone();
        of_laws.join(members);
        let mut letter = ranks.letter();
        if looked {
            rows.iter().for_each(|rows| letter.nodes(model, blocks, rows, 4));
        }
        let of = (&**assembly, members);
        letter.members(of, stress, 6, |s| s.points.clone());
        letter.members(of, energy, 5, |s| s.elements.clone());
        if wet {
            letter.members(of, pore, 1, |s| s.elements.clone());
        }
        letter.members((assembly, &of_laws), history, 8, |s| s.history.clone());
        letter.members(of, numbers, 1, |s| s.numbers.clone());
        let mut arrived = letter.send()?;
        shown.lay_out(&assembly.totals(), wet, ranks.is_poisoned());
        if looked {
            rows.iter_mut().for_each(|rows| arrived.nodes(model, blocks, rows));
        }
        arrived.members(of, &mut shown.stress, 6, |s| s.points.clone());
        arrived.members(of, &mut shown.energy, 5, |s| s.elements.clone());
        if wet {
            arrived.members(of, &mut shown.pore, 1, |s| s.elements.clone());
        }
        arrived.members((assembly, &of_laws), &mut shown.history, 8, |s| s.history.clone());
        arrived.members(of, &mut shown.numbers, 1, |s| s.numbers.clone());
        let Shown { stress, energy, pore, history, numbers } = std::mem::take(shown);
        (snapshot.stress, snapshot.energy) = (stress, energy);
        if wet {
            snapshot.pore = pore;
        }
        Some((history, numbers))
    }

    /// Goes on from u^n to u^{n+1}.
    pub fn advance(&mut self, evaluated: Evaluated) -> State {
        let Evaluated { model, phase, mut state, mut forces, snapshot, all } = evaluated;
        if let (Some((history, numbers)), Some(snapshot)) = (all, snapshot) {
            let Snapshot { stress, energy, pore, .. } = snapshot;
            self.shown = Shown { stress, energy, pore, history, numbers };
        }
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
        self.bring(&mut evaluated, &Wanted::ALL);
        let snapshot = evaluated.snapshot.take().unwrap_or_default();
        *state = evaluated.state;
        snapshot
    }

    /// What is seen at a state, which is left as it is: parts are evaluated on copies of their memory. Of several ranks the first alone sees it
    /// whole.
    pub fn look(&mut self, state: &State) -> Look {
        self.look_at(state, &Wanted::ALL)
    }

    /// The same, of which no more than is wanted comes to the first of several ranks.
    pub fn look_at(&mut self, state: &State, wanted: &Wanted) -> Look {
        let mut probed = Probed::default();
        let (history, numbers) = self.evaluate_copies(state, Some(&mut probed));
        let kept = Kept { history: &history, numbers: &numbers, ..state.kept() };
        let mut snapshot = self.snapshot(state, kept, probed);
        let all = self.gather(&mut snapshot, (&history, &numbers), wanted, &mut Shown::default());
        let (history, numbers) = all.unwrap_or((history, numbers));
        Look { snapshot, history, numbers }
    }
}
