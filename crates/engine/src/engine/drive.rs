//! Nodes that a stage moves, and what it takes to move them.

use super::Engine;
use super::gather::force;
use crate::life::Stage;
use crate::state::State;
use tremolite_laws::Row;

impl Engine {
    /// Brings the phase's driven nodes to this share of their way, from [`State::start`] on. What they gained times the forces
    /// last evaluated \[J\].
    pub(super) fn move_driven(&self, state: &mut State, way: f64) -> f64 {
        let driven = &self.phase.driven;
        if driven.is_empty() {
            return 0.0;
        }
        let mut works = vec![[0.0; 3]; driven.len()];
        let held = driven.iter().zip(&mut works).filter(|(moved, _)| self.phase.holds(moved.node));
        for (moved, works) in held {
            let node = moved.node as usize;
            let force = force(&self.phase, &self.forces.contributions, node);
            let zero = state.datum.get(node).copied().unwrap_or(Row::ZERO);
            for (i, to) in moved.to.iter().enumerate() {
                let Some(to) = to else { continue };
                let from = state.start[node].0[i];
                // The end itself is met to the last bit.
                let end = zero.0[i] + to;
                let next = if way < 1.0 { from + way * (end - from) } else { end };
                let gained = next - state.u[node].0[i];
                state.u[node].0[i] = next;
                state.du[node].0[i] = gained;
                works[i] = gained * force.0[i];
            }
        }
        let nodes: Vec<u32> = driven.iter().map(|moved| moved.node).collect();
        let works = self.at_nodes(&nodes, 3, |k| works[k]);
        let mut sum = 0.0;
        for (moved, works) in driven.iter().zip(works) {
            (0..3).filter(|&i| moved.to[i].is_some()).for_each(|i| sum += works[i]);
        }
        sum
    }

    /// The phase's stage.
    pub fn stage(&self) -> Stage {
        self.phase.stage
    }

    /// The force \[N\] with which each of [`Boundaries::prescribed`](crate::boundary::Boundaries::prescribed) pushes on the model along x, y and z where a state is, of the
    /// components that it holds; 0 of those that are not there in the phase's stage.
    pub fn reactions(&mut self, state: &State) -> Vec<[f64; 3]> {
        self.evaluate_copies(state, None);
        let mut reactions = vec![[0.0; 3]; self.model.boundaries.prescribed.len()];
        let driven = &self.phase.driven;
        if driven.is_empty() {
            return reactions;
        }
        let nodes: Vec<u32> = driven.iter().map(|moved| moved.node).collect();
        let now = |k: usize| force(&self.phase, &self.forces.contributions, nodes[k] as usize);
        let forces = self.at_nodes(&nodes, 4, now);
        for (moved, force) in driven.iter().zip(forces) {
            let reaction = &mut reactions[moved.by as usize];
            (0..3).filter(|&i| moved.to[i].is_some()).for_each(|i| reaction[i] += force.0[i]);
        }
        reactions
    }
}
