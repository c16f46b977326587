//! Extremes of the monitors' motion over all steps: rows hold one step in many.

use super::histories::{elastic_change, first_stress, interpolate};
use super::{Observer, Schedule, Setting, Stepped, View};
use crate::error::RunError;
use crate::plan::Plan;
use crate::quantities::MONITOR;
use tremolite_engine::state::Memory;
use tremolite_laws::Row;
use tremolite_laws::sym3::principal_values;

/// Key of what this observer remembers, monitor by monitor: the velocity of the last step, then for each component of
/// displacement, velocity and acceleration, and for s1_elastic, its largest and smallest value.
const MEMORY: &str = "steps and stresses";
/// Components of motion, the first of [`MONITOR`].
const MOTION: usize = 9;
/// Behind them the stress that follows from the strain alone.
const ELASTIC: &str = "s1_elastic";
/// Numbers a monitor.
const EACH: usize = 3 + 2 * MOTION + 2;

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
            // At rest so far, under the stress of the first row.
            let at_rest = |k: usize| {
                let s1 = first_stress(memory, plan, k).map_or(0.0, |stress| principal_values(&stress)[0]);
                [vec![0.0; EACH - 2], vec![s1; 2]].concat()
            };
            let all = (0..plan.monitors.len()).flat_map(at_rest).collect();
            memory.insert(MEMORY.into(), all);
        }
        let first: Vec<_> = (0..plan.monitors.len()).map(|k| first_stress(memory, plan, k)).collect();
        let Some(kept) = memory.get_mut(MEMORY) else { return };
        let zero = |node: usize| datum.get(node).map_or([0.0; 3], Row::xyz);
        for ((monitor, first), kept) in plan.monitors.iter().zip(first).zip(kept.chunks_exact_mut(EACH)) {
            let strained = elastic_change(model, monitor, |node| {
                let (u, zero) = (u[node].xyz(), zero(node));
                [0, 1, 2].map(|i| u[i] - zero[i])
            });
            let first = first.unwrap_or([f64::NAN; 6]);
            let s1 = principal_values(&[0, 1, 2, 3, 4, 5].map(|c| first[c] + strained[c]))[0];
            let mut u = interpolate(model, monitor, u);
            if !datum.is_empty() {
                let zero = interpolate(model, monitor, datum);
                (0..3).for_each(|i| u[i] -= zero[i]);
            }
            let v = interpolate(model, monitor, du).map(|d| d / dt);
            let (last, extremes) = kept.split_at_mut(3);
            let a = [0, 1, 2].map(|i| (v[i] - last[i]) / dt);
            last.copy_from_slice(&v);
            for (value, pair) in u.into_iter().chain(v).chain(a).chain([s1]).zip(extremes.chunks_exact_mut(2))
            {
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
        let q = match quantity {
            ELASTIC => MOTION,
            _ => MONITOR[..MOTION].iter().position(|q| q.name == quantity)?,
        };
        let at = EACH * m + 3 + 2 * q;
        match memory.get(MEMORY)?.get(at..at + 2)? {
            &[max, min] => Some(Extremes { max, min }),
            _ => None,
        }
    }
}
