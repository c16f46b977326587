//! The energy balance: what is booked step by step, and what it says where somebody looks.
//!
//! Parts and blocks of nodes keep their own books, which are added by a fixed tree when somebody looks.

use super::evaluation::{Forces, Probed};
use super::nodes::Measured;
use super::{BodyBooks, Engine, Snapshot, guard, nodes};
use crate::parts::{ElementEnergy, Kept, Motion};
use crate::state::{Ledger, OF_NODES, State};
use crate::sums::tree;
use tremolite_kernels::{Booked, Line, Lines};

/// Books added up \[J\].
struct Totals {
    /// Work of parts by line, and against dampings.
    lines: Lines,
    /// Work on the elements of each account, less what artificial viscosity took of it.
    bodies: Vec<f64>,
}

impl Engine {
    /// Energies of members added up: `own` of their elements, which go into accounts, and `more`.
    pub(super) fn added(&self, of: impl Iterator<Item = (u32, Lines, Lines)>) -> (Lines, Vec<Lines>) {
        let mut accounts = vec![Vec::new(); self.assembly.accounts.len()];
        let mut all = Vec::new();
        for (m, own, more) in of {
            if let Some(account) = self.assembly.account[m as usize] {
                accounts[account as usize].push(own);
            }
            all.push(own + more);
        }
        let plus = |a: Lines, b: Lines| a + b;
        (tree(all, plus), accounts.into_iter().map(|own| tree(own, plus)).collect())
    }

    /// What the counted parts hold, have dissipated and created, by line: by element, and what else they report; and of the
    /// elements of each account.
    pub(super) fn held(&self, state: &State, kept: Kept, energy: &[ElementEnergy]) -> (Lines, Vec<Lines>) {
        let counted = self.phase.active.iter().filter(|&&m| self.assembly.members[m as usize].counted);
        self.added(counted.map(|&m| {
            let (member, slices) = (&self.assembly.members[m as usize], &self.assembly.slices[m as usize]);
            let mut own = Lines::default();
            for element in &energy[slices.elements.clone()] {
                own[Line::Strain] += element.strain;
                own[Line::Hourglass] += element.hourglass;
                own[Line::Dissipated] += element.dissipated;
                own[Line::Created] += element.created;
                own[Line::Band] += element.band;
            }
            let (u, du) = (self.named(member, &state.u), self.named(member, &state.du));
            let motion = Motion::new(&u, &du);
            (m, own, member.part.energy(&motion, slices.kept(&kept)))
        }))
    }

    /// What parts and blocks of nodes booked, by line as it enters the balance.
    fn booked(&self, members: impl Iterator<Item = (u32, Lines)>, blocks: &[f64]) -> Totals {
        let width = OF_NODES + self.assembly.accounts.len();
        let rows = blocks.chunks_exact(width).map(<[f64]>::to_vec).collect();
        let mut nodes = tree(rows, |mut a: Vec<f64>, b| {
            a.iter_mut().zip(b).for_each(|(a, b)| *a += b);
            a
        });
        nodes.resize(width, 0.0);
        let of = members.map(|(m, work)| {
            // Of what parts book that are not counted only that on the model's nodes is in a balance.
            if self.assembly.members[m as usize].counted {
                return (m, work, Lines::default());
            }
            let mut on_sides = Lines::default();
            on_sides[Line::FreeField] = work[Line::FreeField];
            (m, Lines::default(), on_sides)
        });
        let (mut works, accounts) = self.added(of);
        let [rayleigh, base, sides, free_field, levels] = [0, 1, 2, 3, 4].map(|k| nodes[k]);
        works[Line::FreeField] -= free_field;
        let mut lines = Lines::default();
        for &line in Line::ALL.iter().filter(|line| line.booked() == Booked::Work) {
            lines[line] = line.sign() * works[line];
        }
        lines[Line::Rayleigh] = rayleigh;
        lines[Line::BaseDashpots] = base;
        lines[Line::SideDashpots] = sides;
        lines[Line::Levels] = levels;
        let on_elements = nodes[OF_NODES..].iter().zip(accounts);
        Totals { lines, bodies: on_elements.map(|(work, own)| work - own[Line::Viscosity]).collect() }
    }

    /// Counts what came in since this was last done as supplied for good.
    pub(super) fn close_books(&self, state: &mut State) {
        let ledger = &state.ledger;
        let booked = self.booked((0..).zip(ledger.members.iter().copied()), &ledger.blocks).lines;
        let (given, _) = self.given(state, |line| lines_in().any(|one| one == line));
        let now = lines_in().map(|line| ledger.lines[line] + booked[line] - line.sign() * given[line]).sum();
        let supplied = ledger.supplied + gain(ledger.put_in, now);
        (state.ledger.put_in, state.ledger.supplied) = (now, supplied);
    }

    /// What is seen at a state, from the forces just evaluated there, what parts remember and what was probed.
    pub(super) fn snapshot(&self, state: &State, kept: Kept, probed: Probed) -> Snapshot {
        let Forces { contributions, rates, works, .. } = &self.forces;
        let Measured { kinetic, scheme, books, velocity, acceleration } =
            nodes::measure(&self.model, &self.phase, contributions, &rates.products, state);
        let ledger = &state.ledger;
        let before = self.booked((0..).zip(ledger.members.iter().copied()), &ledger.blocks);
        let active = self.phase.active.iter().copied();
        let now = self.booked(active.zip(works.iter().copied()), &books);
        let (held, bodies) = self.held(state, kept, &probed.energy);
        let (given, given_bodies) = self.given(state, |_| true);
        let mut balance = Lines::default();
        for &line in Line::ALL {
            let booked = ledger.lines[line] + before.lines[line] + now.lines[line];
            balance[line] = match line.booked() {
                Booked::Motion => kinetic,
                Booked::Stored => held[line] - ledger.lines[line] - given[line],
                Booked::Spent => held[line] - ledger.lines[line],
                Booked::Damping => booked,
                Booked::Work => booked - line.sign() * given[line],
                Booked::Start => ledger.lines[line],
                Booked::Rest => 0.0,
            };
        }
        balance[Line::Error] = balance.sum();
        let bodies = bodies
            .into_iter()
            .enumerate()
            .map(|(k, mut held)| {
                let work = ledger.bodies[k] + before.bodies[k] + now.bodies[k] - given_bodies[k].sum();
                for &line in Line::ALL {
                    held[line] -= ledger.rest[k][line] + given_bodies[k][line];
                }
                BodyBooks { work, held }
            })
            .collect();
        let moving = guard::kinetic(&self.model, &self.phase, state);
        let stored = Line::ALL.iter().filter(|line| line.booked() == Booked::Stored);
        Snapshot {
            step: state.steps(),
            time: state.time(),
            displacement: (0..state.u.len()).map(|node| state.shown(node)).collect(),
            velocity,
            acceleration,
            stress: probed.stress,
            energy: probed.energy,
            scheme,
            held: moving + stored.map(|&line| balance[line]).sum::<f64>(),
            supplied: ledger.supplied + gain(ledger.put_in, put_in(&balance)),
            balance,
            bodies,
        }
    }
}

/// What came in since the start \[J\]: lines of work that have a minus in the sum of what is found.
fn put_in(balance: &Lines) -> f64 {
    lines_in().map(|line| balance[line]).sum()
}

fn lines_in() -> impl Iterator<Item = Line> {
    Line::ALL.iter().copied().filter(|line| line.booked() == Booked::Work && line.sign() < 0.0)
}

/// By how much more came in \[J\], at least nothing; not a number where that is none.
fn gain(before: f64, now: f64) -> f64 {
    if now < before { 0.0 } else { now - before }
}

impl Ledger {
    /// Books the work of the parts over a step.
    pub(super) fn book(&mut self, active: &[u32], works: &[Lines]) {
        for (&m, &work) in active.iter().zip(works) {
            let own = &mut self.members[m as usize];
            *own = *own + work;
        }
    }
}
