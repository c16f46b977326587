//! About how long a run takes on several ranks: a model made of counts and rates, not a measurement.
//!
//! A step takes as long as the rank with most work, its messages come on top of it as if nothing overlapped, and rows are looked at
//! by the first rank alone. What cannot be counted is assumed: [`NETWORK`].

use crate::job::Checked;
use crate::survey::Survey;
use serde::Serialize;
use tremolite_engine::Division;

/// What lies between ranks.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Network {
    /// Seconds until a message is there, however short.
    pub latency: f64,
    /// Bytes a second that a rank sends or takes.
    pub bandwidth: f64,
}

/// Assumed: what networks of 100 Gbit/s and more are sold with. Neither was measured.
pub const NETWORK: Network = Network { latency: 2e-6, bandwidth: 1e10 };

/// Steps of the finest level from one sum over all ranks to the next.
const SUMS_EVERY: f64 = 8.0;

impl Network {
    /// Seconds a step in which a rank sends so many bytes to so many others, and sums over all ranks.
    pub fn step(&self, neighbours: usize, bytes: f64, ranks: u32) -> f64 {
        let stages = f64::from(ranks).log2().ceil();
        neighbours as f64 * self.latency + bytes / self.bandwidth + 2.0 * stages * self.latency / SUMS_EVERY
    }
}

/// What one rank does.
#[derive(Clone, Debug, Serialize)]
pub struct OfRank {
    /// Share of the work of all.
    pub work: f64,
    /// Nodes that it moves, those that others move as well included.
    pub nodes: usize,
    /// Ranks that it sends contributions to.
    pub neighbours: usize,
    /// Bytes that it sends in a step of the finest level, in the mean over one of the coarsest.
    pub bytes: f64,
}

/// Wall time \[s\] of a run, each rank on a machine like this one.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Seconds {
    /// Stages, as shared out as steps are.
    pub stages: f64,
    /// Evaluations of the rank with most work.
    pub steps: f64,
    /// Messages of steps.
    pub messages: f64,
    /// Rows of histories: what is sent to the first rank, and what it does with it.
    pub rows: f64,
}

impl Seconds {
    pub fn all(&self) -> f64 {
        self.stages + self.steps + self.messages + self.rows
    }
}

/// How a run would be shared out.
#[derive(Clone, Debug, Serialize)]
pub struct SharedOut {
    pub ranks: u32,
    /// Work of the rank with most over the mean.
    pub imbalance: f64,
    /// The same once parts have cracked, at worst.
    pub imbalance_cracked: f64,
    /// Nodes that are moved by one rank more, over all nodes.
    pub moved_again: f64,
    /// Patches that there are: no rank beyond them has work.
    pub patches: usize,
    /// Bytes of memory that the rank with most work takes while it computes, about, and the first where it looks and writes.
    pub memory_bytes: usize,
    pub first_bytes: usize,
    pub of_rank: Vec<OfRank>,
    pub network: Network,
    pub seconds: Seconds,
    /// Time on one machine over that on all, and over as many.
    pub efficiency: f64,
}

impl SharedOut {
    pub fn of(checked: &Checked, ranks: u32) -> SharedOut {
        let job = checked.job;
        let division = Division::even(&job.model, &job.assembly, ranks);
        let whole: f64 = division.weights.iter().sum();
        let traffic = job.phase.traffic(&job.model, &job.assembly, &division);
        let of_rank: Vec<OfRank> = traffic
            .iter()
            .zip(&division.weights)
            .map(|(one, weight)| OfRank {
                work: weight / whole,
                nodes: one.nodes,
                neighbours: one.neighbours,
                bytes: one.bytes,
            })
            .collect();
        let most = of_rank.iter().map(|rank| rank.work).fold(0.0, f64::max);
        let total = if job.motion.is_some() { job.steps.total as f64 } else { 0.0 };
        let message = of_rank
            .iter()
            .map(|rank| NETWORK.step(rank.neighbours, rank.bytes, division.ranks))
            .fold(0.0, f64::max);
        let alone = Seconds {
            stages: checked.stage_seconds(),
            steps: checked.cost * total,
            messages: 0.0,
            rows: checked.seconds() - checked.stage_seconds() - checked.cost * total,
        };
        // A row needs no more of the state than one of the two checkpoints has.
        let state = 0.5 * checked.disk.checkpoint as f64;
        let sent = if division.ranks > 1 { state / NETWORK.bandwidth } else { 0.0 };
        let rows = if job.motion.is_some() { job.plan.duration / job.plan.histories } else { 0.0 };
        let seconds = Seconds {
            stages: alone.stages * most,
            steps: alone.steps * division.imbalance / f64::from(division.ranks),
            messages: if division.ranks > 1 { message * total } else { 0.0 },
            rows: alone.rows + sent * rows,
        };
        let Survey { bytes, shared, .. } = job.survey;
        let moved: usize = of_rank.iter().map(|rank| rank.nodes).sum();
        SharedOut {
            ranks: division.ranks,
            imbalance: division.imbalance,
            imbalance_cracked: division.imbalance_cracked,
            moved_again: moved as f64 / job.model.nodes.len() as f64 - 1.0,
            patches: job.model.patches.len(),
            memory_bytes: bytes - shared + (most * shared as f64) as usize,
            first_bytes: bytes + (most * shared as f64) as usize,
            efficiency: alone.all() / seconds.all() / f64::from(division.ranks),
            of_rank,
            network: NETWORK,
            seconds,
        }
    }
}

/// Cases like one another of any size, on machines of several cores: what [`SharedOut`] finds for a model at hand, carried on by
/// counts that grow with an element's volume and a rank's surface.
#[derive(Clone, Copy, Debug)]
pub struct Machines {
    /// Updates a second of one machine, where memory bounds it.
    pub rate: f64,
    /// Updates an element in a step of the finest level.
    pub share: f64,
    /// Bytes that a rank of n elements sends in such a step, over n to the power of 2/3.
    pub surface: f64,
    /// Ranks that one in the midst of others sends to.
    pub neighbours: usize,
    pub network: Network,
    /// What the first rank does for rows over what one machine's steps take.
    pub first: f64,
}

/// Seconds a step on some machines: of their work, their messages, and the first one's rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    pub work: f64,
    pub messages: f64,
    pub rows: f64,
}

impl Step {
    pub fn all(&self) -> f64 {
        self.work + self.messages + self.rows
    }
}

impl Machines {
    /// A case of so many elements on so many machines, of one rank each.
    pub fn step(&self, elements: f64, machines: u32) -> Step {
        let own = elements / f64::from(machines);
        let whole = elements * self.share / self.rate;
        let neighbours = self.neighbours.min(machines as usize - 1);
        let messages = match machines {
            0 | 1 => 0.0,
            _ => self.network.step(neighbours, self.surface * own.powf(2.0 / 3.0), machines),
        };
        Step { work: whole / f64::from(machines), messages, rows: self.first * whole }
    }

    /// Time on one machine over that on all, and over as many; the first one's rows left out if they are not to count.
    pub fn strong(&self, elements: f64, machines: u32, rows: bool) -> f64 {
        let of = |step: Step| if rows { step.all() } else { step.work + step.messages };
        of(self.step(elements, 1)) / of(self.step(elements, machines)) / f64::from(machines)
    }

    /// The same where each machine has so many elements, however many machines there are.
    pub fn weak(&self, each: f64, machines: u32, rows: bool) -> f64 {
        let of = |step: Step| if rows { step.all() } else { step.work + step.messages };
        of(self.step(each, 1)) / of(self.step(each * f64::from(machines), machines))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIKE: Machines =
        Machines { rate: 4e8, share: 0.26, surface: 200.0, neighbours: 12, network: NETWORK, first: 0.0 };

    #[test]
    fn one_machine_is_as_efficient_as_itself_and_many_lose_by_their_surface() {
        for rows in [false, true] {
            assert_eq!(LIKE.strong(1e7, 1, rows), 1.0);
            assert_eq!(LIKE.weak(1e7, 1, rows), 1.0);
        }
        let of = |machines| LIKE.strong(1e7, machines, true);
        assert!(of(2) < 1.0 && of(16) < of(2) && of(256) < of(16));
        // By hand: 10⁷ elements on 64 machines take 1.016e-4 s of work a step; 12 messages 24 µs, 200·156250^(2/3) B 58 µs, sums 3 µs.
        let step = LIKE.step(1e7, 64);
        assert!((step.work - 1.015_625e-4).abs() < 1e-12);
        let sent = 200.0 * 156_250.0_f64.powf(2.0 / 3.0) / 1e10;
        assert!((step.messages - (24e-6 + sent + 2.0 * 6.0 * 2e-6 / 8.0)).abs() < 1e-12);
    }

    #[test]
    fn what_the_first_rank_does_alone_bounds_the_rest() {
        let rows = Machines { first: 0.05, ..LIKE };
        let speed = |machines: u32| f64::from(machines) * rows.strong(1e9, machines, true);
        // Amdahl: no faster than 1.05 / 0.05 times.
        assert!(speed(4096) < 21.0 && speed(256) > 15.0);
    }
}
