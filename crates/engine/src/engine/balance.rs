//! The energy balance: what is booked step by step, and what it says where somebody looks.
//!
//! Parts and blocks of nodes keep their own books, which are added by a fixed tree when somebody looks.

use super::evaluation::{Forces, Probed};
use super::measure::{Measured, measure};
use super::{BodyBooks, Engine, Snapshot};
use crate::parts::{ElementEnergy, Kept, Motion};
use crate::ranks::Tree;
use crate::state::{Ledger, OF_NODES, State};
use crate::sums::{tree, tree_of_rows};
use rayon::prelude::*;
use tremolite_kernels::{Booked, Line, Lines};

/// Books added up \[J\].
struct Totals {
    /// Work of parts by line, and against dampings.
    lines: Lines,
    /// Work on the elements of each account, less what artificial viscosity and water in pores took of it.
    bodies: Vec<f64>,
}

impl Engine {
    /// Energies of members added up: those of their elements, which go into accounts, and others. `of` is asked for both in the order
    /// of members, of those that this process has.
    pub(super) fn added(
        &self,
        members: impl Iterator<Item = u32> + Clone,
        mut of: impl FnMut(u32) -> [Lines; 2],
    ) -> (Lines, Vec<Lines>) {
        let account = &self.assembly.account;
        let mut accounts = vec![Vec::new(); self.assembly.accounts.len()];
        let mut all = Vec::new();
        for m in members.clone().filter(|&m| self.has(m as usize)) {
            let [own, more] = of(m);
            if let Some(account) = account[m as usize] {
                accounts[account as usize].push(own);
            }
            all.push(own + more);
        }
        let plus = |a: Lines, b: Lines| a + b;
        let Some(ranks) = &self.ranks else {
            return (tree(all, plus), accounts.into_iter().map(|own| tree(own, plus)).collect());
        };
        let mut of_accounts = vec![Vec::new(); accounts.len()];
        let mut of_all = Vec::new();
        for m in members {
            let rank = ranks.division.of_member[m as usize];
            if let Some(account) = account[m as usize] {
                of_accounts[account as usize].push(rank);
            }
            of_all.push(rank);
        }
        let own = of_accounts.into_iter().zip(accounts);
        let lists = std::iter::once((of_all, all)).chain(own);
        let trees = lists.map(|(of, own)| Tree::new(of, ranks.rank(), own)).collect();
        let mut sums = ranks.sums(Line::ALL.len(), trees, plus).into_iter();
        (sums.next().unwrap_or_default(), sums.collect())
    }

    /// The same of the members that enter the balance, on all threads.
    pub(super) fn added_at_once(&self, of: impl Fn(u32) -> [Lines; 2] + Sync) -> (Lines, Vec<Lines>) {
        let own: Vec<u32> = self.counted().filter(|&m| self.has(m as usize)).collect();
        let found: Vec<[Lines; 2]> = own.par_iter().map(|&m| of(m)).collect();
        let mut found = found.into_iter();
        self.added(self.counted(), |_| found.next().unwrap_or_default())
    }

    /// Active members that enter the balance.
    pub(super) fn counted(&self) -> impl Iterator<Item = u32> + Clone {
        self.phase.active.iter().copied().filter(|&m| self.assembly.members[m as usize].counted)
    }

    /// What the counted parts hold, have dissipated and created, by line: by element, and what else they report; and of the
    /// elements of each account.
    pub(super) fn held(&self, state: &State, kept: Kept, energy: &[ElementEnergy]) -> (Lines, Vec<Lines>) {
        self.added_at_once(|m| {
            let (member, slices) = (&self.assembly.members[m as usize], &self.assembly.held[m as usize]);
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
            [own, member.part.energy(&motion, slices.kept(&kept))]
        })
    }

    /// What parts and blocks of nodes booked, by line as it enters the balance. Works are asked for in the order of members, of those
    /// that this process has.
    fn booked(
        &self,
        members: impl Iterator<Item = u32> + Clone,
        mut work: impl FnMut(u32) -> Lines,
        blocks: &[f64],
    ) -> Totals {
        let width = OF_NODES + self.assembly.accounts.len();
        let mut nodes = match &self.ranks {
            None => tree_of_rows(blocks, width),
            Some(ranks) => {
                let rows = blocks.chunks_exact(width).map(<[f64]>::to_vec);
                let plus = |mut a: Vec<f64>, b: Vec<f64>| {
                    a.iter_mut().zip(b).for_each(|(a, b)| *a += b);
                    a
                };
                let of = &ranks.division.of_block;
                let own = rows.zip(of).filter(|(_, of)| **of == ranks.rank()).map(|(row, _)| row);
                let trees = vec![Tree::new(of.clone(), ranks.rank(), own)];
                ranks.sums(width, trees, plus).pop().unwrap_or_default()
            }
        };
        nodes.resize(width, 0.0);
        let (mut works, accounts) = self.added(members, |m| {
            let work = work(m);
            // Of what parts book that are not counted only that on the model's nodes is in a balance.
            if self.assembly.members[m as usize].counted {
                return [work, Lines::default()];
            }
            let mut on_sides = Lines::default();
            on_sides[Line::FreeField] = work[Line::FreeField];
            [Lines::default(), on_sides]
        });
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
        Totals {
            lines,
            bodies: on_elements
                .map(|(work, own)| work - own[Line::Viscosity] - own[Line::PoreWater])
                .collect(),
        }
    }

    /// What was booked until now.
    fn booked_before(&self, ledger: &Ledger) -> Totals {
        self.booked(0..ledger.members.len() as u32, |m| ledger.members[m as usize], &ledger.blocks)
    }

    /// Counts what came in since this was last done as supplied for good.
    pub(super) fn close_books(&self, state: &mut State) {
        let ledger = &state.ledger;
        let booked = self.booked_before(ledger).lines;
        let (given, _) = self.given(state, |line| lines_in().any(|one| one == line));
        let now = lines_in().map(|line| ledger.lines[line] + booked[line] - line.sign() * given[line]).sum();
        let supplied = ledger.supplied + gain(ledger.put_in, now);
        (state.ledger.put_in, state.ledger.supplied) = (now, supplied);
    }

    /// The sum of what was found in blocks of nodes.
    fn of_blocks(&self, found: Vec<(usize, [f64; 2])>) -> [f64; 2] {
        let plus = |a: [f64; 2], b: [f64; 2]| [a[0] + b[0], a[1] + b[1]];
        let Some(ranks) = &self.ranks else {
            return tree(found.into_iter().map(|(_, one)| one).collect(), plus);
        };
        let of = &ranks.division.of_block;
        let own = found.into_iter().filter(|(block, _)| of[*block] == ranks.rank()).map(|(_, one)| one);
        let trees = vec![Tree::new(of.clone(), ranks.rank(), own)];
        ranks.sums(2, trees, plus).pop().unwrap_or_default()
    }

    /// What is seen at a state, from the forces just evaluated there, what parts remember and what was probed.
    pub(super) fn snapshot(&self, state: &State, kept: Kept, mut probed: Probed) -> Snapshot {
        let pore = self.soak(&mut probed.stress, &kept);
        let Forces { contributions, rates, works, .. } = &self.forces;
        let Measured { energies, books, velocity, acceleration } =
            measure(&self.model, &self.phase, contributions, &rates.products, state);
        let [kinetic, scheme] = self.of_blocks(energies);
        let ledger = &state.ledger;
        let before = self.booked_before(ledger);
        let mut works = works.iter().copied();
        let now =
            self.booked(self.phase.active.iter().copied(), |_| works.next().unwrap_or_default(), &books);
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
        let moving = self.kinetic(state);
        let stored = Line::ALL.iter().filter(|line| line.booked() == Booked::Stored);
        Snapshot {
            step: state.steps(),
            time: state.time(),
            displacement: (0..state.u.len()).into_par_iter().map(|node| state.shown(node)).collect(),
            velocity,
            acceleration,
            stress: probed.stress,
            pore,
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
