//! From row to row: whole steps where they can be solved, else smaller ones, and past a law's jumps.

use super::solve::{Missed, Mixed, Reach, Reached};
use super::{Between, Control};
use crate::material::{History, Material, Point};

/// A step is halved so often at most.
const HALVINGS: i32 = 12;

/// Searches for a row that may fail before it counts as one that the material cannot carry.
const FAILURES: usize = 120;

/// Trials whose history may be kept on the way to one row.
const JUMPS: usize = 24;

/// A material point on its way along a path.
pub(super) struct Walk<'a, M: Material> {
    law: &'a M,
    size: [f64; 6],
    mixed: Mixed,
    pub reached: Reached,
    pub history: M::History<f64>,
    /// Values of the row before.
    from: [f64; 6],
}

impl<'a, M: Material> Walk<'a, M> {
    /// From virgin material; `size` as in [`Point::size`].
    pub fn new(law: &'a M, size: [f64; 6], control: [Control; 6]) -> Self {
        Walk {
            law,
            size,
            mixed: Mixed::new(law.moduli(), control),
            reached: Reached { strain: [0.0; 6], stress: [0.0; 6] },
            history: History::zero(),
            from: [0.0; 6],
        }
    }

    /// Takes the point to a row's values in the time `dt` \[s\]; steps that it takes before the last go to `between`.
    ///
    /// # Errors
    /// What is missing of the prescribed stress at the closest strain \[Pa\], if none is close enough.
    pub fn row(
        &mut self,
        row: usize,
        dt: f64,
        values: &[f64; 6],
        between: &mut Vec<Between>,
    ) -> Result<(), f64> {
        let from = std::mem::replace(&mut self.from, *values);
        if !self.mixed.seeks() {
            self.take(dt, *values);
            return Ok(());
        }
        let least = 2f64.powi(-HALVINGS);
        // Share of the row that is done, the next step's share, and the time left.
        let (mut done, mut part, mut left) = (0.0, 1.0, dt);
        let mut jump = Jump { base: self.reached.strain, way: None, taken: 0 };
        let mut failures = 0;
        while done < 1.0 {
            let to: f64 = done + part;
            let last = to >= 1.0;
            let target: [f64; 6] =
                std::array::from_fn(
                    |k| {
                        if last { values[k] } else { to.mul_add(values[k] - from[k], from[k]) }
                    },
                );
            let time = if last { left } else { dt * part };
            let reach = match jump.taken {
                0 if part > least => Reach::Near,
                0 => Reach::Unlimited,
                _ => Reach::Elsewhere,
            };
            match self.search(time, &target, reach) {
                Ok(strain) => {
                    jump.solved(&strain, part);
                    self.take(time, strain);
                    if !last {
                        between.push(Between { row, dt: time, strain, jump: false });
                        left = (left - time).max(0.0);
                    }
                    done = to;
                    part = (2.0 * part).min(1.0 - done);
                }
                Err(missed) => {
                    failures += 1;
                    if failures > FAILURES || jump.taken == JUMPS {
                        return Err(missed.miss);
                    }
                    if part > least {
                        part *= 0.5;
                        continue;
                    }
                    let strain = self.mixed.prescribed(jump.trial(part, &missed), &target);
                    // A part of the step's time, so that none is counted twice.
                    let time = 0.5 * dt * part / JUMPS as f64;
                    self.take(time, strain);
                    between.push(Between { row, dt: time, strain, jump: true });
                    left = (left - time).max(0.0);
                }
            }
        }
        Ok(())
    }

    /// The strain that meets the target in a step of this time \[s\], as [`Mixed::strain`] finds it.
    fn search(&mut self, dt: f64, target: &[f64; 6], reach: Reach) -> Result<[f64; 6], Missed> {
        let point = Point { size: self.size, ..Point::new(dt) };
        let (law, history) = (self.law, self.history);
        self.mixed.strain(target, &self.reached, reach, |strain| law.update(&point, *strain, history).0)
    }

    fn take(&mut self, dt: f64, strain: [f64; 6]) {
        let (stress, history) =
            self.law.update(&Point { size: self.size, ..Point::new(dt) }, strain, self.history);
        self.mixed.reach(&strain);
        self.reached = Reached { strain, stress };
        self.history = history;
    }
}

/// Trials whose history is kept where no strain meets the target.
struct Jump {
    /// The last strain that met its target.
    base: [f64; 6],
    /// Its change over the step to it for all of a row.
    way: Option<[f64; 6]>,
    /// Trials so far.
    taken: usize,
}

impl Jump {
    /// Remembers a strain that meets its target after a step of this share of the row.
    fn solved(&mut self, strain: &[f64; 6], part: f64) {
        let way = std::array::from_fn(|k| (strain[k] - self.base[k]) / part);
        // What the sides did in a jump says nothing of how they go on.
        self.way = (self.taken == 0).then_some(way);
        (self.base, self.taken) = (*strain, 0);
    }

    /// The strain whose history is kept: first where the way so far leads to, which is past the point of failure but
    /// for round-off; then in turn the closest strain, and the way farther on.
    fn trial(&mut self, part: f64, missed: &Missed) -> [f64; 6] {
        let reach = 2f64.powi(self.taken as i32 / 2);
        let on_way = self.taken.is_multiple_of(2);
        self.taken += 1;
        match self.way {
            Some(way) if on_way => std::array::from_fn(|k| (reach * part).mul_add(way[k], self.base[k])),
            _ => missed.strain,
        }
    }
}
