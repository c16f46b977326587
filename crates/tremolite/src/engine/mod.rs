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

mod nodes;
mod power;

pub use power::{Limit, StableStep, stable_step};

use crate::model::Model;
use crate::parts::{ElementEnergy, Motion, Own, ProbeOut, Scratch, Slices, Tick, Work};
use crate::phase::Phase;
use crate::state::State;
use nodes::Rates;
use rayon::prelude::*;
use tremolite_laws::Row;

/// Stresses, energies and velocities at one time, for observers.
#[derive(Clone, Debug, Default)]
pub struct Snapshot {
    /// Stress \[Pa\] of every point, global axes, in the order of parts.
    pub stress: Vec<[f64; 6]>,
    /// Energies of every element, in the order of parts.
    pub energy: Vec<ElementEnergy>,
    /// v̂ \[m/s\] by engine node.
    pub velocity: Vec<Row>,
    /// dv/dt \[m/s²\] by engine node.
    pub acceleration: Vec<Row>,
    /// Lines of the balance at this time.
    pub balance: Balance,
    /// Work done on the elements since the start, and what they held then \[J\]: ½ f·(Δu⁻ + Δu⁺) over all steps.
    pub internal: f64,
}

/// The energy balance at one time \[J\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Balance {
    pub kinetic: f64,
    /// What elements would give back: ∫ [`tremolite_laws::Material::stored_energy`].
    pub strain: f64,
    pub hourglass: f64,
    /// Taken by damage and plastic flow, as laws book it step by step.
    pub dissipated: f64,
    /// Given out by laws that have no potential, as they book it: enters the sum with a minus.
    pub created: f64,
    /// Taken by damping over a band, and whatever laws that keep no books take: the work done on the elements less all
    /// other lines. Zero by definition where there are neither; the error then tests the laws as well.
    pub band: f64,
    pub rayleigh: f64,
    pub base_dashpots: f64,
    pub side_dashpots: f64,
    pub springs: f64,
    pub input: f64,
    pub initial: f64,
    /// What is found less what was put in.
    pub error: f64,
}

impl Balance {
    /// Names and values of the lines, in the order of energy.csv.
    pub fn lines(&self) -> [(&'static str, f64); 13] {
        [
            ("kinetic", self.kinetic),
            ("strain", self.strain),
            ("hourglass", self.hourglass),
            ("dissipated", self.dissipated),
            ("created_by_law", self.created),
            ("band_damping", self.band),
            ("rayleigh_damping", self.rayleigh),
            ("base_dashpots", self.base_dashpots),
            ("side_dashpots", self.side_dashpots),
            ("base_springs", self.springs),
            ("input", self.input),
            ("initial", self.initial),
            ("error", self.error),
        ]
    }
}

/// Why a step could not be taken.
#[derive(Clone, Debug, PartialEq)]
pub enum Halt {
    /// More kinetic energy than was ever supplied, or numbers that are not finite.
    Energy { kinetic: f64, supplied: f64, step: u64, time: f64 },
}

/// Kinetic energy beyond this multiple of all energy ever supplied stops a run. In a stable run the discrete energy
/// bounds it: at most 2 where all energy sits at the mesh's highest frequency, near 1 for waves the mesh carries.
const GUARD: f64 = 3.0;

/// The engine for one machine.
pub struct Engine<'a> {
    model: &'a Model,
    phase: &'a Phase,
    contributions: Vec<Row>,
    rates: Rates,
    /// The parts' own work, if they were evaluated at the state's displacements already.
    evaluated: Option<Work>,
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

/// One part with its slices.
struct Job<'j> {
    part: usize,
    out: &'j mut [Row],
    own: Own<'j>,
}

impl<'a> Engine<'a> {
    /// An engine for a phase of a model.
    pub fn new(model: &'a Model, phase: &'a Phase) -> Self {
        let (.., contributions, _, _) = phase.totals();
        Engine {
            model,
            phase,
            contributions: vec![Row::ZERO; contributions],
            rates: Rates::new(model, phase),
            evaluated: None,
        }
    }

    /// Gives a state an initial displacement \[m\] and velocity \[m/s\] by engine node: the start of (25)–(27),
    /// generalised to v⁰ ≠ 0, u^0 − u^{−1} = Δt v⁰ − ½Δt² (a⁰ − D v⁰). Tied nodes take their master's values, and
    /// the step must be set.
    pub fn start(&mut self, state: &mut State, u: Vec<Row>, v: &[Row]) {
        let dt = state.dt;
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
        let minus: f64 = self
            .phase
            .counted_nodes
            .clone()
            .map(|n| 0.5 * self.phase.mass[n] * state.du[n].0.iter().map(|d| d * d).sum::<f64>() / (dt * dt))
            .sum();
        state.ledger = crate::state::Ledger {
            initial: now.kinetic + now.strain + now.hourglass,
            supplied: minus + now.strain + now.hourglass,
            springs: -now.springs,
            input: -now.input,
            rayleigh: -now.rayleigh,
            base_dashpots: -now.base_dashpots,
            side_dashpots: -now.side_dashpots,
            parts: now.strain + now.hourglass - (snapshot.internal + now.springs - now.input),
        };
    }

    /// Evaluates all parts at u^n, and the products with K that ξ ≠ 0 needs.
    fn evaluate(&mut self, state: &mut State, probe: Option<ProbeOut>) -> Work {
        let phase = self.phase;
        let tick = Tick { time: state.time(), dt: state.dt };
        let motion = Motion { u: &state.u, du: &state.du };
        let slices = &phase.slices;
        let jobs: Vec<Job> = split(&mut self.contributions, slices, |s| s.contributions.clone())
            .into_iter()
            .zip(split(&mut state.history, slices, |s| s.history.clone()))
            .zip(split(&mut state.overstress, slices, |s| s.overstress.clone()))
            .zip(split(&mut state.numbers, slices, |s| s.numbers.clone()))
            .enumerate()
            .map(|(part, (((out, history), overstress), numbers))| Job {
                part,
                out,
                own: Own { history, overstress, numbers },
            })
            .collect();
        let works: Vec<Work> = match probe {
            None => jobs
                .into_par_iter()
                .map_init(Scratch::default, |scratch, job| {
                    phase.parts[job.part].forces(&tick, &motion, job.own, job.out, scratch)
                })
                .collect(),
            Some(probe) => {
                let stress = split(probe.stress, slices, |s| s.points.clone());
                let energy = split(probe.energy, slices, |s| s.elements.clone());
                jobs.into_par_iter()
                    .zip(stress)
                    .zip(energy)
                    .map_init(Scratch::default, |scratch, ((job, stress), energy)| {
                        let to = ProbeOut { stress, energy };
                        phase.parts[job.part].probe(&tick, &motion, job.own, job.out, to, scratch)
                    })
                    .collect()
            }
        };
        self.rates.update(self.model, phase, &self.contributions, state);
        works.into_iter().fold(Work::default(), |sum, w| Work {
            springs: sum.springs + w.springs,
            input: sum.input + w.input,
        })
    }

    /// What observers see at u^n. Laws and boundaries remember what they saw, so a state is observed at most once a
    /// step, and [`Engine::step`] goes on from there.
    pub fn observe(&mut self, state: &mut State) -> Snapshot {
        let (_, _, _, points, elements) = self.phase.totals();
        let mut snapshot = Snapshot {
            stress: vec![[0.0; 6]; points],
            energy: vec![ElementEnergy::default(); elements],
            ..Snapshot::default()
        };
        let probe = ProbeOut { stress: &mut snapshot.stress, energy: &mut snapshot.energy };
        let work = self.evaluate(state, Some(probe));
        self.evaluated = Some(work);
        let sums;
        (sums, snapshot.velocity, snapshot.acceleration) =
            nodes::measure(self.model, self.phase, &self.contributions, &self.rates, state);

        let counted = self.phase.slices[..self.phase.counted_parts].last().map_or(0, |s| s.elements.end);
        let mut held = ElementEnergy::default();
        for element in &snapshot.energy[..counted] {
            held.strain += element.strain;
            held.hourglass += element.hourglass;
            held.dissipated += element.dissipated;
            held.created += element.created;
        }
        let ledger = &state.ledger;
        let mut balance = Balance {
            kinetic: sums.kinetic,
            strain: held.strain,
            hourglass: held.hourglass,
            dissipated: held.dissipated,
            created: held.created,
            band: 0.0,
            rayleigh: ledger.rayleigh + sums.rayleigh,
            base_dashpots: ledger.base_dashpots + sums.base_dashpots,
            side_dashpots: ledger.side_dashpots + sums.side_dashpots,
            springs: ledger.springs + work.springs,
            input: ledger.input - work.input,
            initial: ledger.initial,
            error: 0.0,
        };
        // All parts but the elements book their own work.
        snapshot.internal = ledger.parts + sums.parts - balance.springs + balance.input;
        if !self.phase.keeps_books() {
            balance.band = snapshot.internal - held.strain - held.hourglass - held.dissipated + held.created;
        }
        balance.error = balance.kinetic + balance.strain + balance.hourglass + balance.dissipated
            - balance.created
            + balance.band
            + balance.rayleigh
            + balance.base_dashpots
            + balance.side_dashpots
            + balance.springs
            - balance.input
            - balance.initial;
        snapshot.balance = balance;
        snapshot
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
        let sums = nodes::advance(self.model, self.phase, &self.contributions, &self.rates, state);
        let ledger = &mut state.ledger;
        ledger.springs += work.springs;
        ledger.input -= work.input;
        ledger.supplied += (-work.input).max(0.0);
        ledger.rayleigh += sums.rayleigh;
        ledger.base_dashpots += sums.base_dashpots;
        ledger.side_dashpots += sums.side_dashpots;
        ledger.parts += sums.parts;
        state.step += 1;
        // Written so that a kinetic energy that is not a number halts as well.
        if sums.kinetic <= GUARD * state.ledger.supplied {
            Ok(())
        } else {
            Err(Halt::Energy {
                kinetic: sums.kinetic,
                supplied: state.ledger.supplied,
                step: state.step,
                time,
            })
        }
    }
}
