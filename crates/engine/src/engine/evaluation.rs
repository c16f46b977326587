//! All active parts evaluated at a state: what they push with, the work that they book, and what was to be seen of them.

use super::Engine;
use super::node_step::Lead;
use super::rates::Rates;
use super::split::split;
use crate::assembly::{Assembly, Slices};
use crate::member::Member;
use crate::model::Model;
use crate::parts::{ElementEnergy, Kept, Motion, Own, ProbeOut, Scratch, Tick, UNKNOWN};
use crate::phase::Phase;
use crate::state::State;
use rayon::prelude::*;
use std::borrow::Cow;
use std::cell::RefCell;
use std::collections::HashSet;
use std::time::Instant;
use tremolite_kernels::Lines;
use tremolite_laws::{Octet, Row};

/// Forces at a state, and room for the next.
#[derive(Clone, Debug, Default)]
pub(super) struct Forces {
    /// What each part pushes its nodes with, part by part.
    pub contributions: Vec<Row>,
    pub rates: Rates,
    /// Velocities that leaders leave to those who follow them.
    pub leads: Vec<Lead>,
    /// Work that each active part books \[J\].
    pub works: Vec<Lines>,
}

impl Forces {
    pub fn room(model: &Model, assembly: &Assembly, phase: &Phase) -> Self {
        Forces {
            contributions: phase.room(assembly),
            rates: Rates::new(model, assembly, phase),
            leads: vec![Lead::default(); phase.leaders.len()],
            works: Vec::new(),
        }
    }
}

/// Stress of every point and energies of every element, as a probe leaves them.
#[derive(Clone, Debug, Default)]
pub(super) struct Probed {
    pub stress: Vec<[f64; 6]>,
    pub energy: Vec<ElementEnergy>,
    /// Whether only the members of a glance are probed; stresses of others are then not numbers.
    pub glance: bool,
}

/// What an evaluation works on.
enum Subject<'s> {
    /// A state, whose parts remember what they saw.
    State(&'s mut State),
    /// A state that is left as it is. What parts then remember of histories and numbers goes to these copies of it, the rest of
    /// their memory to copies that are dropped.
    Copies { state: &'s State, history: &'s mut [Octet], numbers: &'s mut [f64] },
}

impl Subject<'_> {
    fn state(&self) -> &State {
        match self {
            Subject::State(state) => state,
            Subject::Copies { state, .. } => state,
        }
    }
}

/// Memory that a part may write.
enum Memory<'m, T> {
    Own(&'m mut [T]),
    /// To be copied before.
    Foreign(&'m [T]),
}

impl<'m, T: Clone> Memory<'m, T> {
    fn again(&mut self) -> Memory<'_, T> {
        match self {
            Memory::Own(own) => Memory::Own(own),
            Memory::Foreign(all) => Memory::Foreign(all),
        }
    }

    fn each(
        self,
        slices: &[&Slices],
        range: impl Fn(&Slices) -> std::ops::Range<usize>,
    ) -> Vec<Memory<'m, T>> {
        match self {
            Memory::Own(all) => split(all, slices, |s| range(s)).into_iter().map(Memory::Own).collect(),
            Memory::Foreign(all) => slices.iter().map(|s| Memory::Foreign(&all[range(s)])).collect(),
        }
    }

    /// The memory itself, or a copy of it in `room`.
    fn or_copy(self, room: &'m mut Vec<T>) -> &'m mut [T] {
        match self {
            Memory::Own(own) => own,
            Memory::Foreign(all) => {
                room.clear();
                room.extend_from_slice(all);
                room
            }
        }
    }
}

/// One active part with its slices.
struct Job<'j> {
    member: &'j Member,
    out: &'j mut [Row],
    history: &'j mut [Octet],
    overstress: Memory<'j, Octet>,
    numbers: &'j mut [f64],
    reference: Memory<'j, Row>,
    initial: &'j [Octet],
    /// Where stresses and energies go, if they are wanted.
    probe: Option<ProbeOut<'j>>,
}

/// Room that a thread reuses from part to part.
#[derive(Default)]
struct Room {
    scratch: Scratch,
    overstress: Vec<Octet>,
    reference: Vec<Row>,
    u: Vec<Row>,
    du: Vec<Row>,
}

thread_local! {
    static ROOM: RefCell<Room> = RefCell::default();
}

impl Engine {
    /// Evaluates all active parts at a state, which remember what they saw, and the products with K that ξ ≠ 0 needs.
    pub(super) fn evaluate_at(&mut self, state: &mut State, probed: Option<&mut Probed>) {
        self.parts_at(Subject::State(state), probed);
        self.rates_at(state, state.kept());
    }

    /// The same on copies of what parts remember of histories and numbers, which are given back as evaluated; the state is left as
    /// it is.
    pub(super) fn evaluate_copies(
        &mut self,
        state: &State,
        probed: Option<&mut Probed>,
    ) -> (Vec<Octet>, Vec<f64>) {
        let (mut history, mut numbers) = (state.history.clone(), state.numbers.clone());
        self.parts_at(Subject::Copies { state, history: &mut history, numbers: &mut numbers }, probed);
        self.rates_at(state, Kept { history: &history, numbers: &numbers, ..state.kept() });
        (history, numbers)
    }

    /// Rows of all nodes as a member may know them: all that it did not name is not a number where the engine is poisoned.
    pub(super) fn named<'r>(&self, member: &Member, rows: &'r [Row]) -> Cow<'r, [Row]> {
        if !self.poisoned {
            return Cow::Borrowed(rows);
        }
        let mut room = Vec::new();
        named(member, rows, &mut room);
        Cow::Owned(room)
    }

    fn rates_at(&mut self, state: &State, kept: Kept) {
        let Engine { model, assembly, phase, forces, ranks, .. } = self;
        forces.rates.update(model, assembly, phase, &forces.contributions, state, kept, ranks.as_deref());
    }

    fn parts_at(&mut self, subject: Subject, probed: Option<&mut Probed>) {
        let Engine { model, assembly, phase, forces, poisoned, glanced, ranks, .. } = self;
        if forces.contributions.is_empty() {
            *forces = Forces::room(model, assembly, phase);
        }
        let poisoned = *poisoned;
        let number = phase.beat_number(subject.state());
        let beat = &phase.beats[number];
        let mut tick = phase.tick(subject.state());
        if self.quiet {
            tick.time = -f64::MIN_POSITIVE;
        }
        let totals = assembly.held_totals();
        let mut probes = probed.map(|Probed { stress, energy, glance }| {
            let unknown = if *glance { f64::NAN } else { 0.0 };
            *stress = vec![[unknown; 6]; totals.points.end];
            *energy = vec![ElementEnergy::default(); totals.elements.end];
            Probes { out: ProbeOut { stress, energy }, only: glance.then_some(&*glanced) }
        });
        let mut columns = Columns::of(subject);
        let Some((ranks, ours)) = ranks.as_ref().zip(phase.ours.as_ref()) else {
            let contributions = &mut forces.contributions;
            let jobs = columns.jobs(assembly, &beat.active, contributions, probes.as_mut());
            forces.works = evaluate_all(phase, tick, jobs, poisoned);
            return;
        };
        // What others wait for first.
        let slots = &ours.halos[number];
        let some = |wanted: bool| -> Vec<u32> {
            let all = beat.active.iter().zip(&slots.early);
            all.filter(|(_, early)| **early == wanted).map(|(&m, _)| m).collect()
        };
        let begin = Instant::now();
        let [mut early, mut late] = [true, false].map(|wanted| {
            let contributions = &mut forces.contributions;
            let jobs = columns.jobs(assembly, &some(wanted), contributions, probes.as_mut());
            let works = evaluate_all(phase, tick, jobs, poisoned);
            if wanted {
                ranks.start(slots, contributions);
            }
            works.into_iter()
        });
        let works = slots.early.iter().filter_map(|&is| if is { early.next() } else { late.next() });
        forces.works = works.collect();
        ranks.tally.worked(begin.elapsed());
        ranks.finish(slots, &mut forces.contributions);
    }
}

/// Where members leave what a probe sees, and which alone are probed, if not all.
struct Probes<'p> {
    out: ProbeOut<'p>,
    only: Option<&'p HashSet<u32>>,
}

/// What parts read and write of a subject.
struct Columns<'c> {
    u: &'c [Row],
    du: &'c [Row],
    history: &'c mut [Octet],
    overstress: Memory<'c, Octet>,
    numbers: &'c mut [f64],
    reference: Memory<'c, Row>,
    initial: &'c [Octet],
}

impl<'c> Columns<'c> {
    fn of(subject: Subject<'c>) -> Self {
        match subject {
            Subject::State(State { u, du, history, overstress, numbers, reference, initial, .. }) => {
                let (overstress, reference) = (Memory::Own(overstress), Memory::Own(reference));
                Columns { u, du, history, overstress, numbers, reference, initial }
            }
            Subject::Copies { state, history, numbers } => {
                let State { u, du, overstress, reference, initial, .. } = state;
                let (overstress, reference) = (Memory::Foreign(overstress), Memory::Foreign(reference));
                Columns { u, du, history, overstress, numbers, reference, initial }
            }
        }
    }

    /// Some members, ascending, with what each alone reads and writes.
    fn jobs<'j>(
        &'j mut self,
        assembly: &'j Assembly,
        active: &[u32],
        contributions: &'j mut [Row],
        probes: Option<&'j mut Probes>,
    ) -> (Motion<'j>, Vec<Job<'j>>) {
        let slices: Vec<&Slices> = active.iter().map(|&m| &assembly.held[m as usize]).collect();
        let slices = &slices[..];
        let only = probes.as_ref().and_then(|probes| probes.only);
        let mut probes = probes.map(|Probes { out, .. }| {
            let stress = split(out.stress, slices, |s| s.points.clone());
            let energy = split(out.energy, slices, |s| s.elements.clone());
            stress.into_iter().zip(energy).map(|(stress, energy)| ProbeOut { stress, energy })
        });
        let Columns { u, du, history, overstress, numbers, reference, initial } = self;
        let jobs = split(contributions, slices, |s| s.contributions.clone())
            .into_iter()
            .zip(split(history, slices, |s| s.history.clone()))
            .zip(overstress.again().each(slices, |s| s.overstress.clone()))
            .zip(split(numbers, slices, |s| s.numbers.clone()))
            .zip(reference.again().each(slices, |s| s.reference.clone()))
            .zip(active.iter().zip(slices))
            .map(|(((((out, history), overstress), numbers), reference), (&m, slices))| Job {
                member: &assembly.members[m as usize],
                out,
                history,
                overstress,
                numbers,
                reference,
                initial: &initial[slices.initial.clone()],
                probe: probes
                    .as_mut()
                    .and_then(Iterator::next)
                    .filter(|_| only.is_none_or(|only| only.contains(&m))),
            })
            .collect();
        (Motion::new(u, du), jobs)
    }
}

/// Evaluates parts side by side, and gives the work of each.
fn evaluate_all(phase: &Phase, tick: Tick, (motion, jobs): (Motion, Vec<Job>), poisoned: bool) -> Vec<Lines> {
    // One by one: members differ in cost, and half of what is left would be too much to hand over at the end.
    jobs.into_par_iter()
        .with_max_len(1)
        .map(|job| {
            // Taken, not borrowed: a part that goes parallel itself may be given another on this very thread.
            let mut room = ROOM.take();
            let span = phase.span_of(job.member);
            let tick = Tick { step: tick.step / span, dt: span as f64 * tick.dt, ..tick };
            let work = evaluate(job, &tick, &Motion { span: span as f64, ..motion }, &mut room, poisoned);
            ROOM.set(room);
            work
        })
        .collect()
}

/// Evaluates one part; all but what it names is poisoned for it if so wished.
fn evaluate(job: Job, tick: &Tick, motion: &Motion, room: &mut Room, poisoned: bool) -> Lines {
    let Job { member, out, history, overstress, numbers, reference, initial, probe } = job;
    let Room { scratch, overstress: copied, reference: copied_reference, u, du } = room;
    let own = Own {
        history,
        overstress: overstress.or_copy(copied),
        numbers,
        reference: reference.or_copy(copied_reference),
        initial,
    };
    let motion = match poisoned {
        true => {
            out.fill(UNKNOWN);
            named(member, motion.u, u);
            named(member, motion.du, du);
            Motion { u, du, ..*motion }
        }
        false => *motion,
    };
    match probe {
        None => member.part.forces(tick, &motion, own, out, scratch),
        Some(to) => member.part.probe(tick, &motion, own, out, to, scratch),
    }
}

/// A motion at the nodes that a member pushes or reads; not a number elsewhere.
fn named(member: &Member, rows: &[Row], room: &mut Vec<Row>) {
    room.clear();
    room.resize(rows.len(), UNKNOWN);
    for &node in member.part.nodes().iter().chain(&member.reads.nodes) {
        room[node as usize] = rows[node as usize];
    }
}
