//! From rest to the shaking: what all parts do at rest is held from then on, so nothing moves but by waves.
//!
//! **Balance.** What is held is constant, and does the work Σ f⁰·Δu, with f⁰ what every part did to its nodes at the hand-over. So
//! each line of the balance counts from there, less its own parts' f⁰·Δu: stored energy as the gain less that work (each alone is
//! ten to a hundred times what a wave brings). Weight and other constant loads are then in no line, and neither is what is held.

use super::Engine;
use super::evaluation::Probed;
use super::gather::{dot, force};
use crate::bolts::BoltSet;
use crate::parts::{Entry, Motion, Scratch};
use crate::state::State;
use crate::water::with_pressure;
use std::collections::HashMap;
use tremolite_kernels::{Booked, Line, Lines};
use tremolite_laws::Row;

/// Share of what is stored at the hand-over that counts as supplied: else round-off would halt a run before the wave comes.
const ROUND_OFF: f64 = 1e-12;

impl Engine {
    /// Begins the shaking with steps of `dt` \[s\] where a state rests: displacements and the balance count from here.
    pub fn hand_over(&mut self, state: &mut State, dt: f64) {
        self.whole(state);
        state.begin(dt);
        state.held = Vec::new();
        state.carried = Vec::new();
        state.carried_hourglass = Vec::new();
        state.datum = state.u.clone();
        state.ledger = state.ledger.cleared();
        self.quiet = true;
        self.free_pairs(state);
        self.enter(state);
        let mut probed = Probed::default();
        self.evaluate_at(state, Some(&mut probed));
        self.quiet = false;
        state.carried_hourglass = self.own_rows(&self.stabilisation(&probed.stress));
        state.carried = self.own_rows(&self.forces.contributions);
        let (held, bodies) = self.held(state, state.kept(), &probed.energy);
        let mut ledger = state.ledger.cleared();
        for &line in Line::ALL {
            match line.booked() {
                Booked::Stored => {
                    ledger.lines[line] = held[line];
                    ledger.supplied += ROUND_OFF * held[line].abs();
                }
                Booked::Spent => ledger.lines[line] = held[line],
                Booked::Motion | Booked::Work | Booked::Damping | Booked::Start | Booked::Rest => {}
            }
        }
        ledger.rest = bodies;
        state.ledger = ledger;
        state.held = self.forces_now(state.u.len());
        self.settle(state);
        self.own(state);
    }

    /// Force \[N\] of all parts on each node, of the forces last evaluated; on a rank not a number where it does not know it.
    pub(super) fn forces_now(&self, nodes: usize) -> Vec<Row> {
        (0..nodes).map(|n| force(&self.phase, &self.forces.contributions, n)).collect()
    }

    /// Contributions of this process's own parts, to be kept.
    fn own_rows(&self, rows: &[Row]) -> Vec<Row> {
        let mut own = rows[..self.assembly.held_totals().contributions.end].to_vec();
        self.assembly.close(&mut own);
        own
    }

    /// Forces \[N\] of the elements' stabilisation at the displacements last evaluated, where the points had these stresses.
    fn stabilisation(&self, stress: &[[f64; 6]]) -> Vec<Row> {
        let mut all = vec![Row::ZERO; self.forces.contributions.len()];
        let mut scratch = Scratch::default();
        for &m in self.phase.members() {
            let (member, slices) = (&self.assembly.members[m as usize], &self.assembly.held[m as usize]);
            if member.part.elements().0 == 0 {
                continue;
            }
            let own = &mut all[slices.contributions.clone()];
            member.part.stress_forces(&stress[slices.points.clone()], own, &mut scratch);
            for (own, whole) in own.iter_mut().zip(&self.forces.contributions[slices.contributions.clone()]) {
                *own = Row([0, 1, 2, 3].map(|i| whole.0[i] - own.0[i]));
            }
        }
        all
    }

    /// Tells all active parts that their own books count from here.
    fn settle(&self, state: &mut State) {
        for &m in self.phase.members() {
            let slices = &self.assembly.held[m as usize];
            self.assembly.members[m as usize].part.settle(slices.own(state).1);
        }
    }

    /// Work \[J\] of what is held since the hand-over by the line of the part that does so much less, of those lines that are
    /// `wanted`, and by account.
    pub(super) fn given(&self, state: &State, wanted: impl Fn(Line) -> bool + Sync) -> (Lines, Vec<Lines>) {
        if state.carried.is_empty() {
            return (Lines::default(), vec![Lines::default(); self.assembly.accounts.len()]);
        }
        self.added_at_once(|m| {
            let (member, slices) = (&self.assembly.members[m as usize], &self.assembly.held[m as usize]);
            let work = |carried: &[Row]| -> f64 {
                let own = carried[slices.contributions.clone()].iter().zip(member.part.nodes());
                own.map(|(&force, &node)| dot(force, state.shown(node as usize))).sum()
            };
            let mut own = Lines::default();
            if member.part.elements().0 > 0 {
                if !wanted(Line::Strain) {
                    return [own, Lines::default()];
                }
                own[Line::Hourglass] = work(&state.carried_hourglass);
                own[Line::Strain] = work(&state.carried) - own[Line::Hourglass];
            } else if let Some(line) = member.line.filter(|&line| wanted(line)) {
                own[line] = work(&state.carried);
            }
            [own, Lines::default()]
        })
    }

    /// Steps of the shaking without motion on a copy of a state: the largest displacement \[m\] that comes of it.
    pub fn quiet_run(&mut self, state: &State, steps: u64) -> f64 {
        let mut copy = state.clone();
        self.quiet = true;
        for _ in 0..steps {
            self.step(&mut copy);
        }
        self.quiet = false;
        let held = copy.u.iter().zip(&state.u).enumerate().filter(|(n, _)| self.phase.holds(*n as u32));
        let moved = held.map(|(_, (a, b))| {
            let d = Row([0, 1, 2, 3].map(|i| a.0[i] - b.0[i]));
            dot(d, d).sqrt()
        });
        // A displacement that is no number is the largest.
        let largest = |most: f64, d: f64| if d <= most { most } else { d };
        let moved = moved.fold(0.0, largest);
        match &self.ranks {
            None => moved,
            Some(ranks) => ranks.each(moved).into_iter().fold(0.0, largest),
        }
    }

    /// Tells all active parts that the phase's stage begins.
    pub(super) fn enter(&mut self, state: &mut State) {
        // Only bonds with friction ask for the stress, which takes an evaluation; what laws would remember of it is dropped.
        let confined = |set: &BoltSet| set.kind.bond.is_some_and(|bond| bond.friction > 0.0);
        let later: HashMap<u32, u32> =
            self.model.elements.successors.iter().map(|(&later, &of)| (of, later)).collect();
        let phase = self.phase.clone();
        let stands = phase.stands(&self.model, &self.assembly);
        let standing = |mut element: u32| {
            while !stands[element as usize] {
                element = *later.get(&element)?;
            }
            Some(element)
        };
        let stresses = self.model.bolts.iter().any(confined).then(|| {
            let named = phase.active.iter().flat_map(|&m| &self.assembly.members[m as usize].reads.elements);
            let asked = named.filter_map(|&element| standing(element)).collect();
            self.mean_stresses(state, &asked)
        });
        let Engine { model, assembly, .. } = &*self;
        let of_element = |element: u32| {
            let element = standing(element)?;
            let mean = *stresses.as_ref()?.get(&element)?;
            // A bond feels what presses rock on it, not what water does.
            Some(with_pressure(mean, model.water.pressure(element as usize, phase.stage)))
        };
        let u = state.u.clone();
        for &m in phase.members() {
            let (member, slices) = (&assembly.members[m as usize], &assembly.held[m as usize]);
            // What a member did not name it cannot know.
            let stress = |element: u32| match member.reads.elements.binary_search(&element) {
                Ok(_) => of_element(element),
                Err(_) => Some([f64::NAN; 6]),
            };
            let named = self.named(member, &u);
            let entry = Entry { stage: phase.stage, u: &named, stress: &stress };
            member.part.enter(&entry, slices.own(state).1);
        }
    }

    /// Tells the parts whose life begins with the phase's stage: they count from the displacements as they are, and so do the
    /// results at nodes that slept. Nodes that others hold from now on are where those are.
    pub(super) fn wake(&mut self, state: &mut State) {
        let (assembly, phase) = (self.assembly.clone(), self.phase.clone());
        for (node, others) in &phase.joined {
            let rows = [Some(&mut state.u), Some(&mut state.datum).filter(|datum| !datum.is_empty())];
            rows.into_iter().flatten().for_each(|rows| rows[*node as usize] = mean(rows, others));
        }
        let lent = self.lent(state);
        for &m in phase.members() {
            let (member, slices) = (&assembly.members[m as usize], &assembly.held[m as usize]);
            if member.life.born != phase.stage || !member.life.is_later() {
                continue;
            }
            if member.kind.patch().is_some_and(|patch| self.model.patches[patch].takes_over) {
                self.take_over(m as usize, state, &lent);
                continue;
            }
            let (Motion { u, du, .. }, own) = slices.own(state);
            let (u, du) = (self.named(member, u), self.named(member, du));
            member.part.begin(&Motion::new(&u, &du), own);
        }
        self.give_way(state);
        self.free_pairs(state);
        if state.datum.is_empty() {
            return;
        }
        for &node in &phase.woken {
            state.datum[node as usize] = state.u[node as usize];
        }
    }
}

/// The mean of the rows of some nodes: theirs, where they have the same.
fn mean(rows: &[Row], nodes: &[u32]) -> Row {
    let Some(&first) = nodes.first() else { return Row::ZERO };
    let (first, share) = (rows[first as usize], 1.0 / nodes.len() as f64);
    let mut mean = first;
    for &node in nodes {
        (0..3).for_each(|i| mean.0[i] += share * (rows[node as usize].0[i] - first.0[i]));
    }
    mean
}
