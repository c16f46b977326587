//! Extremes of the monitors' motion over all steps: rows hold one step in many.

use super::histories::interpolate;
use super::{Observer, Schedule, Setting, Stepped, View};
use crate::error::RunError;
use crate::plan::Plan;
use crate::quantities::MONITOR;
use tremolite_engine::state::Memory;

/// Key of what this observer remembers, monitor by monitor: the velocity of the last step, then for each component of
/// displacement, velocity and acceleration its largest and smallest value.
const MEMORY: &str = "steps";
/// Components of motion, the first of [`MONITOR`].
const MOTION: usize = 9;
/// Numbers a monitor.
const EACH: usize = 3 + 2 * MOTION;

/// Follows the monitors through every step. The velocity is that between two steps, the acceleration its change.
pub struct StepPeaks {
    schedule: Schedule,
}

impl StepPeaks {
    pub fn new(setting: &Setting) -> Self {
        StepPeaks { schedule: setting.rows() }
    }
}

impl Observer for StepPeaks {
    fn schedule(&self) -> Schedule {
        self.schedule
    }

    fn see(&mut self, _: &View, _: &mut Memory) -> Result<(), RunError> {
        Ok(())
    }

    fn stepped(&mut self, step: &Stepped, memory: &mut Memory) {
        let Stepped { model, plan, u, datum, du, dt } = *step;
        if !memory.contains_key(MEMORY) {
            // At rest so far.
            memory.insert(MEMORY.into(), vec![0.0; EACH * plan.monitors.len()]);
        }
        let Some(kept) = memory.get_mut(MEMORY) else { return };
        for (monitor, kept) in plan.monitors.iter().zip(kept.chunks_exact_mut(EACH)) {
            let mut u = interpolate(model, monitor, u);
            if !datum.is_empty() {
                let zero = interpolate(model, monitor, datum);
                (0..3).for_each(|i| u[i] -= zero[i]);
            }
            let v = interpolate(model, monitor, du).map(|d| d / dt);
            let (last, extremes) = kept.split_at_mut(3);
            let a = [0, 1, 2].map(|i| (v[i] - last[i]) / dt);
            last.copy_from_slice(&v);
            for (value, pair) in u.into_iter().chain(v).chain(a).zip(extremes.chunks_exact_mut(2)) {
                pair[0] = pair[0].max(value);
                pair[1] = pair[1].min(value);
            }
        }
    }
}

/// Largest and smallest value of a quantity of a monitor over all steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    pub max: f64,
    pub min: f64,
}

impl Extremes {
    /// What was remembered; none for quantities that are not followed through every step, or before the first.
    pub fn of(memory: &Memory, plan: &Plan, monitor: &str, quantity: &str) -> Option<Self> {
        let m = plan.monitors.iter().position(|m| m.name == monitor)?;
        let q = MONITOR[..MOTION].iter().position(|q| q.name == quantity)?;
        let at = EACH * m + 3 + 2 * q;
        match memory.get(MEMORY)?.get(at..at + 2)? {
            &[max, min] => Some(Extremes { max, min }),
            _ => None,
        }
    }
}
