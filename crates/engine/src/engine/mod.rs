//! The step: explicit, central differences, second order in Δt with every kind of damping (`wang2018` (20)–(27)).
//!
//! With D = M⁻¹C for Rayleigh's damping and a = M⁻¹(F + P − f_int), (20) and the corrected (21), whose forces are those
//! at u^{n+1}, are exactly the leapfrog
//!
//! v̂ = v⁻ + ½Δt (a^n − D v⁻),  v⁺ = v⁻ + Δt (a^n − D v̂),  u^{n+1} = u^n + Δt v⁺,
//!
//! where v⁻ = (u^n − u^{n−1})/Δt and v̂ is the v^n of (21): insert (21) into (20). So the state is u^n and
//! u^n − u^{n−1}, and one evaluation of the forces makes a step.
//!
//! **Dashpots** of boundaries act on ½(v⁻ + v⁺) instead, which lumped matrices allow at the price of a 3×3 solve a
//! boundary node. Inside the C of (20) they would multiply the mass of their node by 1/(1 − ½Δt D); at an absorbing
//! base ½Δt D = c Δt/h is near 1, and the base would reflect with order 1 in h (verification problem
//! `incident_pulse`).
//!
//! **Balance.** Multiplying by the mean increment ½(Δu^n + Δu^{n+1}) makes every line of the ledger exact: the change
//! of ½ v⁻ᵀM v⁻ equals the work of all forces. Contributions of parts are summed node by node in the order of parts,
//! chunks of nodes in ascending order, so bits do not depend on threads.

mod accounts;
mod bonded;
mod drive;
mod freed;
mod gather;
mod hand_over;
mod node_step;
mod nodes;
mod power;
mod product;
mod rates;
mod relax;
mod strained;
mod take_over;

pub use power::{ContactLimit, Limit, StableStep, stable_step, viscous_share};
pub use relax::{Relaxed, Release, Rest, Watch};

use crate::assembly::{Assembly, Slices};
use crate::member::Member;
use crate::model::Model;
use crate::parts::{ElementEnergy, Motion, Own, ProbeOut, Scratch};
use crate::phase::Phase;
use crate::state::{Ledger, State};
use node_step::Lead;
use nodes::NodeSums;
use rates::Rates;
use rayon::prelude::*;
use std::sync::{Mutex, PoisonError};
use tremolite_kernels::{Booked, Line, Lines};
use tremolite_laws::Row;

/// What is seen at one time, beside the histories and numbers that parts keep.
#[derive(Clone, Debug, Default)]
pub struct Snapshot {
    /// Steps since t = 0, and the time \[s\].
    pub step: u64,
    pub time: f64,
    /// Displacement \[m\] by engine node.
    pub displacement: Vec<Row>,
    /// v̂ \[m/s\] by engine node.
    pub velocity: Vec<Row>,
    /// dv/dt \[m/s²\] by engine node.
    pub acceleration: Vec<Row>,
    /// Stress \[Pa\] of every point, global axes, in the order of members.
    pub stress: Vec<[f64; 6]>,
    /// Energies of every element, in the order of members.
    pub energy: Vec<ElementEnergy>,
    /// The energy balance at this time.
    pub balance: Lines,
    /// ⅛Δt²aᵀMa \[J\]: the part of the balance's error that belongs to the scheme and shrinks with Δt².
    pub scheme: f64,
    /// The balance of each account ([`Assembly::accounts`]).
    pub bodies: Vec<BodyBooks>,
}

/// The books of a body's elements \[J\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyBooks {
    /// Work done on them, but for what artificial viscosity took, and what they held and had lost at the start.
    pub work: f64,
    /// What they hold, have dissipated and created.
    pub held: Lines,
}

impl BodyBooks {
    /// Work that is in none of their lines \[J\].
    pub fn error(&self) -> f64 {
        self.work - self.held.sum()
    }
}

/// Why a step could not be taken.
#[derive(Clone, Debug, PartialEq)]
pub enum Halt {
    /// More kinetic energy than was ever supplied, or numbers that are not finite.
    Energy { kinetic: f64, supplied: f64, step: u64, time: f64 },
    /// More energy held by elements and motion than was ever supplied.
    Held { held: f64, supplied: f64, step: u64, time: f64 },
}

/// Kinetic energy beyond this multiple of all energy ever supplied stops a run. In a stable run the discrete energy
/// bounds it: at most 2 where all energy sits at the mesh's highest frequency, near 1 for waves the mesh carries. Whoever
/// looks also compares all energy held.
const GUARD: f64 = 3.0;
/// What counts as supplied before the wave comes, as a share of the kinetic energy of a model that moves as fast as the wave does at
/// its peak. A record may begin with noise that changes its sign within a few steps: it moves the base before its work is booked,
/// and that work may be negative.
const NOISE: f64 = 1e-6;

/// The engine for one machine.
pub struct Engine<'a> {
    model: &'a Model,
    assembly: &'a Assembly,
    phase: &'a Phase,
    contributions: Vec<Row>,
    rates: Rates,
    /// Velocities that leaders leave to those who follow them.
    leads: Vec<Lead>,
    /// The parts' own work, if they were evaluated at the state's displacements already.
    evaluated: Option<Works>,
    /// Whether loads and waves stay as they are just before t = 0.
    quiet: bool,
    /// Energy that the guard leaves to noise \[J\].
    noise: f64,
    /// One for each thread, which alone locks it.
    scratches: Vec<Mutex<Scratch>>,
}

/// Work that parts book themselves \[J\].
struct Works {
    lines: Lines,
    /// What artificial viscosity took, by account.
    viscosity: Vec<f64>,
}

impl Works {
    /// What came in: positive work by lines of what is put in, which have a minus in the sum of what is found.
    fn supplied(&self) -> f64 {
        let put_in = |line: &&Line| line.booked() == Booked::Work && line.sign() < 0.0;
        Line::ALL.iter().filter(put_in).map(|&line| (line.sign() * self.lines[line]).max(0.0)).sum()
    }
}

/// A slice of `data` for each part; the slices' ranges ascend without gaps.
fn split<'d, T>(
    mut data: &'d mut [T],
    slices: &[Slices],
    range: impl Fn(&Slices) -> std::ops::Range<usize>,
) -> Vec<&'d mut [T]> {
    slices
        .iter()
        .map(|s| {
            let (own, rest) = std::mem::take(&mut data).split_at_mut(range(s).len());
            data = rest;
            own
        })
        .collect()
}

/// One active part with its slices.
struct Job<'j> {
    member: &'j Member,
    out: &'j mut [Row],
    own: Own<'j>,
    /// Where stresses and energies go, if they are wanted.
    probe: Option<ProbeOut<'j>>,
}

impl<'a> Engine<'a> {
    /// An engine for a phase of a model.
    pub fn new(model: &'a Model, assembly: &'a Assembly, phase: &'a Phase) -> Self {
        Engine {
            model,
            assembly,
            phase,
            contributions: vec![Row::ZERO; assembly.totals().contributions.end],
            rates: Rates::new(model, assembly),
            leads: nodes::leads(phase),
            evaluated: None,
            quiet: false,
            noise: noise(model, phase),
            scratches: (0..rayon::current_num_threads()).map(|_| Mutex::default()).collect(),
        }
    }

    /// Gives a state an initial displacement \[m\] and velocity \[m/s\] by engine node: the start of (25)–(27),
    /// generalised to v⁰ ≠ 0, u^0 − u^{−1} = Δt v⁰ − ½Δt² (a⁰ − D v⁰). Tied nodes take their master's values, and
    /// the step must be set.
    pub fn start(&mut self, state: &mut State, u: Vec<Row>, v: &[Row]) {
        let dt = state.dt;
        // What was booked before belongs to another balance.
        state.ledger = Ledger::new(self.assembly.accounts.len());
        state.u = u;
        state.du = v.iter().map(|v| Row(v.0.map(|x| x * dt))).collect();
        for &(node, master) in &self.phase.tied {
            state.u[node as usize] = state.u[master as usize];
            state.du[node as usize] = state.du[master as usize];
        }
        // With v⁻ = v⁰ the engine answers v̂ = v⁰ + ½Δt (a⁰ − D v⁰): go back from v⁰ by as much.
        let predicted = self.observe(&mut state.clone());
        for (du, ahead) in state.du.iter_mut().zip(&predicted.velocity) {
            for i in 0..3 {
                du.0[i] = 2.0 * du.0[i] - dt * ahead.0[i];
            }
        }
        // The balance starts here: what the ledger would book for the step before the first is cancelled.
        let snapshot = self.observe(&mut state.clone());
        let now = snapshot.balance;
        self.evaluated = None;
        // The guard compares with the kinetic energy of v⁻, which may exceed that of v⁰.
        let minus = self.kinetic(state);
        let (held, _) = self.held(state, &snapshot.energy);
        let mut ledger = Ledger::new(self.assembly.accounts.len());
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

    /// ½v⁻ᵀMv⁻ \[J\]. That of v̂ has in it what the forces are about to do, which is not supplied yet.
    fn kinetic(&self, state: &State) -> f64 {
        let Phase { counted_nodes, mass, .. } = self.phase;
        let square = |n: usize| state.du[n].0.iter().map(|d| d * d).sum::<f64>() / (state.dt * state.dt);
        counted_nodes.clone().map(|n| 0.5 * mass[n] * square(n)).sum()
    }

    /// Evaluates all active parts at u^n, and the products with K that ξ ≠ 0 needs.
    fn evaluate(&mut self, state: &mut State, probe: Option<ProbeOut>) -> Works {
        let Engine { model, assembly, phase, .. } = *self;
        let scratches = &self.scratches;
        let mut tick = phase.tick(state);
        if self.quiet {
            tick.time = -f64::MIN_POSITIVE;
        }
        let motion = Motion { u: &state.u, du: &state.du };
        let slices = &assembly.slices;
        let mut probes = probe.map(|probe| {
            let stress = split(probe.stress, slices, |s| s.points.clone());
            let energy = split(probe.energy, slices, |s| s.elements.clone());
            stress.into_iter().zip(energy).map(|(stress, energy)| ProbeOut { stress, energy })
        });
        let all = split(&mut self.contributions, slices, |s| s.contributions.clone())
            .into_iter()
            .zip(split(&mut state.history, slices, |s| s.history.clone()))
            .zip(split(&mut state.overstress, slices, |s| s.overstress.clone()))
            .zip(split(&mut state.numbers, slices, |s| s.numbers.clone()))
            .zip(split(&mut state.reference, slices, |s| s.reference.clone()))
            .zip(assembly.members.iter().zip(slices))
            .map(|(((((out, history), overstress), numbers), reference), (member, slices))| Job {
                member,
                out,
                own: Own {
                    history,
                    overstress,
                    numbers,
                    reference,
                    initial: &state.initial[slices.initial.clone()],
                },
                probe: probes.as_mut().and_then(Iterator::next),
            });
        let mut active = phase.active.iter().copied().peekable();
        let jobs: Vec<Job> =
            (0u32..).zip(all).filter_map(|(m, job)| active.next_if_eq(&m).map(|_| job)).collect();
        // One by one: members differ in cost, and half of what is left would be too much to hand over at the end.
        let works: Vec<Lines> = jobs
            .into_par_iter()
            .with_max_len(1)
            .map(|Job { member, out, own, probe }| {
                let thread = rayon::current_thread_index().unwrap_or(0) % scratches.len();
                let scratch = &mut scratches[thread].lock().unwrap_or_else(PoisonError::into_inner);
                match probe {
                    None => member.part.forces(&tick, &motion, own, out, scratch),
                    Some(to) => member.part.probe(&tick, &motion, own, out, to, scratch),
                }
            })
            .collect();
        self.rates.update(model, assembly, phase, &self.contributions, state);
        let mut viscosity = vec![0.0; assembly.accounts.len()];
        for (work, &m) in works.iter().zip(&phase.active) {
            if let Some(account) = assembly.account[m as usize] {
                viscosity[account as usize] += work[Line::Viscosity];
            }
        }
        // Of what parts book that are not counted only that on the model's nodes is in a balance.
        let counted = works.into_iter().zip(&phase.active).fold(Lines::default(), |mut sum, (work, &m)| {
            if assembly.members[m as usize].counted {
                return sum + work;
            }
            sum[Line::FreeField] += work[Line::FreeField];
            sum
        });
        Works { lines: counted, viscosity }
    }

    /// What the counted parts hold, have dissipated and created, by line: by element, and what else they report; and of the
    /// elements of each account.
    fn held(&self, state: &State, energy: &[ElementEnergy]) -> (Lines, Vec<Lines>) {
        let mut held = Lines::default();
        let mut bodies = vec![Lines::default(); self.assembly.accounts.len()];
        let motion = Motion { u: &state.u, du: &state.du };
        for &m in &self.phase.active {
            let (member, slices) = (&self.assembly.members[m as usize], &self.assembly.slices[m as usize]);
            if !member.counted {
                continue;
            }
            let mut own = Lines::default();
            for element in &energy[slices.elements.clone()] {
                own[Line::Strain] += element.strain;
                own[Line::Hourglass] += element.hourglass;
                own[Line::Dissipated] += element.dissipated;
                own[Line::Created] += element.created;
                own[Line::Band] += element.band;
            }
            if let Some(account) = self.assembly.account[m as usize] {
                let body = &mut bodies[account as usize];
                *body = *body + own;
            }
            held = held + own + member.part.energy(&motion, slices.kept(state));
        }
        (held, bodies)
    }

    /// What observers see at u^n. Laws and boundaries remember what they saw, so a state is observed at most once a
    /// step, and [`Engine::step`] goes on from there.
    pub fn observe(&mut self, state: &mut State) -> Snapshot {
        let totals = self.assembly.totals();
        let mut snapshot = Snapshot {
            step: state.steps(),
            time: state.time(),
            displacement: (0..state.u.len()).map(|node| state.shown(node)).collect(),
            stress: vec![[0.0; 6]; totals.points.end],
            energy: vec![ElementEnergy::default(); totals.elements.end],
            ..Snapshot::default()
        };
        let probe = ProbeOut { stress: &mut snapshot.stress, energy: &mut snapshot.energy };
        let work = self.evaluate(state, Some(probe));
        let sums;
        (sums, snapshot.velocity, snapshot.acceleration) =
            nodes::measure(self.model, self.phase, &self.contributions, &self.rates.products, state);

        let (held, bodies) = self.held(state, &snapshot.energy);
        let (given, given_bodies) = self.given(state);
        let taken = sums.dampings();
        let mut put_in = work.lines;
        put_in[Line::FreeField] -= sums.free_field;
        let (ledger, balance) = (&state.ledger, &mut snapshot.balance);
        for &line in Line::ALL {
            balance[line] = match line.booked() {
                Booked::Motion => sums.kinetic,
                Booked::Stored => held[line] - ledger.lines[line] - given[line],
                Booked::Spent => held[line] - ledger.lines[line],
                Booked::Damping => ledger.lines[line] + taken[line],
                Booked::Work => ledger.lines[line] + line.sign() * (put_in[line] - given[line]),
                Booked::Start => ledger.lines[line],
                Booked::Rest => 0.0,
            };
        }
        balance[Line::Error] = balance.sum();
        snapshot.scheme = sums.scheme;
        snapshot.bodies = bodies
            .into_iter()
            .enumerate()
            .map(|(k, mut held)| {
                let work = ledger.bodies[k] + sums.bodies[k] - work.viscosity[k] - given_bodies[k].sum();
                for &line in Line::ALL {
                    held[line] -= ledger.rest[k][line] + given_bodies[k][line];
                }
                BodyBooks { work, held }
            })
            .collect();
        self.evaluated = Some(work);
        snapshot
    }

    /// Whether more energy is held than was ever supplied: what the guard cannot see in every step.
    ///
    /// # Errors
    /// [`Halt::Held`] if so.
    pub fn guard(&self, state: &State, snapshot: &Snapshot) -> Result<(), Halt> {
        let stored = Line::ALL.iter().filter(|line| line.booked() == Booked::Stored);
        let held = self.kinetic(state) + stored.map(|&line| snapshot.balance[line]).sum::<f64>();
        let supplied = state.ledger.supplied + self.evaluated.as_ref().map_or(0.0, Works::supplied);
        if held <= GUARD * (supplied + self.noise) {
            return Ok(());
        }
        Err(Halt::Held { held, supplied, step: snapshot.step, time: snapshot.time })
    }

    /// One step from u^n to u^{n+1}.
    ///
    /// # Errors
    /// [`Halt::Energy`] if energy appeared; the state is then that of the failed step.
    pub fn step(&mut self, state: &mut State) -> Result<(), Halt> {
        let work = match self.evaluated.take() {
            Some(work) => work,
            None => self.evaluate(state, None),
        };
        let time = state.time();
        let Engine { model, phase, contributions, rates, leads, noise, .. } = self;
        let sums = nodes::advance(model, phase, contributions, &rates.products, leads, state);
        state.ledger.book(&work, &sums);
        state.step += 1;
        // Written so that a kinetic energy that is not a number halts as well.
        if sums.kinetic <= GUARD * (state.ledger.supplied + *noise) {
            Ok(())
        } else {
            Err(Halt::Energy {
                kinetic: sums.kinetic,
                supplied: state.ledger.supplied,
                step: state.steps(),
                time,
            })
        }
    }
}

/// [`NOISE`] \[J\]; nothing where no wave comes in.
fn noise(model: &Model, phase: &Phase) -> f64 {
    let Some(incident) = &model.incident else { return 0.0 };
    let largest = |v: &Vec<f64>| v.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let square: f64 = incident.motion.velocity.iter().map(|v| (incident.factor * largest(v)).powi(2)).sum();
    NOISE * 0.5 * phase.mass[phase.counted_nodes.clone()].iter().sum::<f64>() * square
}

impl Ledger {
    /// Books a step: the parts' own work, and what the node pass found.
    fn book(&mut self, work: &Works, sums: &NodeSums) {
        let taken = sums.dampings();
        for &line in Line::ALL {
            match line.booked() {
                Booked::Work => self.lines[line] += line.sign() * work.lines[line],
                Booked::Damping => self.lines[line] += taken[line],
                Booked::Motion | Booked::Stored | Booked::Spent | Booked::Start | Booked::Rest => {}
            }
        }
        self.lines[Line::FreeField] += sums.free_field;
        self.supplied += work.supplied() + sums.free_field.max(0.0);
        for ((own, more), viscosity) in self.bodies.iter_mut().zip(&sums.bodies).zip(&work.viscosity) {
            *own += more - viscosity;
        }
    }
}
