//! A state with motion to begin with.

use super::Engine;
use crate::state::State;
use tremolite_kernels::{Booked, Line};
use tremolite_laws::Row;

impl Engine {
    /// Gives a state an initial displacement \[m\] and velocity \[m/s\] by engine node: the start of (25)–(27),
    /// generalised to v⁰ ≠ 0, u^0 − u^{−1} = Δt v⁰ − ½Δt² (a⁰ − D v⁰). Tied nodes take their master's values, and
    /// the step must be set. Of one process alone.
    pub fn start(&mut self, state: &mut State, u: Vec<Row>, v: &[Row]) {
        let dt = state.dt;
        // What was booked before belongs to another balance.
        state.ledger = state.ledger.cleared();
        state.u = u;
        state.du = v.iter().map(|v| Row(v.0.map(|x| x * dt))).collect();
        for &(node, master) in &self.phase.tied {
            state.u[node as usize] = state.u[master as usize];
            state.du[node as usize] = state.du[master as usize];
        }
        // With v⁻ = v⁰ the engine answers v̂ = v⁰ + ½Δt (a⁰ − D v⁰): go back from v⁰ by as much.
        let predicted = self.look(state).snapshot;
        for (du, ahead) in state.du.iter_mut().zip(&predicted.velocity) {
            for i in 0..3 {
                du.0[i] = 2.0 * du.0[i] - dt * ahead.0[i];
            }
        }
        // The balance starts here: what the ledger would book for the step before the first is cancelled.
        let snapshot = self.look(state).snapshot;
        let now = snapshot.balance;
        // The guard compares with the kinetic energy of v⁻, which may exceed that of v⁰.
        let minus = self.kinetic(state);
        let (held, _) = self.held(state, state.kept(), &snapshot.energy);
        let mut ledger = state.ledger.cleared();
        let mut stored = 0.0;
        for &line in Line::ALL {
            match line.booked() {
                Booked::Stored => stored += held[line],
                // What springs hold at the start was supplied.
                Booked::Work => {
                    stored += held[line];
                    ledger.lines[line] = line.sign() * held[line] - now[line];
                }
                // What was spent before the start is no part of this balance.
                Booked::Spent => ledger.lines[line] = held[line],
                Booked::Damping => ledger.lines[line] = -now[line],
                Booked::Motion | Booked::Start | Booked::Rest => {}
            }
        }
        ledger.lines[Line::Initial] = now[Line::Kinetic] + stored;
        ledger.supplied = minus + stored;
        for (own, books) in ledger.bodies.iter_mut().zip(&snapshot.bodies) {
            *own = -books.error();
        }
        state.ledger = ledger;
    }
}
