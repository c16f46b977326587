//! Extremes of the monitors' motion over all steps: rows hold one step in many.

use super::histories::{elastic_change, first_stress, interpolate};
use super::observer::{Event, Observer, Setting, Stepped, Wants, Which};
use crate::error::RunError;
use crate::plan::Plan;
use crate::quantities::{MONITOR, Moved, Of, OfMonitor};
use tremolite_engine::state::Memory;
use tremolite_laws::Row;
use tremolite_laws::sym3::principal_values;

/// Key of what this observer remembers, monitor by monitor: the velocity of the last step, then of each quantity that is followed
/// its largest and smallest value.
const MEMORY: &str = "steps and stresses";

/// The quantities of [`MONITOR`] that follow from motion, by name.
fn followed() -> impl Iterator<Item = (&'static str, Of<Moved>)> {
    MONITOR.iter().filter_map(|q| match q.value {
        OfMonitor::Moved(value) => Some((q.name, value)),
        OfMonitor::Seen(_) => None,
    })
}

/// Numbers a monitor.
fn each() -> usize {
    3 + 2 * followed().count()
}

/// Follows the monitors through every step of theirs, that of the slowest corner of the element. The velocity is that between two
/// steps, the acceleration its change.
pub struct StepPeaks {
    nodes: Which,
}

impl StepPeaks {
    pub fn new(setting: &Setting) -> Self {
        let elements = setting.plan.monitors.iter().map(|monitor| monitor.location.element);
        StepPeaks { nodes: Which::corners(setting.model, elements) }
    }
}

impl Observer for StepPeaks {
    fn wants(&self) -> Wants {
        Wants { steps: self.nodes.clone(), ..Wants::default() }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Step(step) => {
                self.stepped(step, memory);
                Ok(())
            }
            _ => Ok(()),
        }
    }
}

impl StepPeaks {
    fn stepped(&mut self, step: &Stepped, memory: &mut Memory) {
        let Stepped { model, plan, u, datum, du, dt, .. } = *step;
        if !memory.contains_key(MEMORY) {
            // At rest so far, under the stress of the first row.
            let at_rest = |k: usize| {
                let s1_elastic =
                    first_stress(memory, plan, k).map_or(0.0, |stress| principal_values(&stress)[0]);
                let still = Moved { u: [0.0; 3], v: [0.0; 3], a: [0.0; 3], s1_elastic };
                [0.0; 3].into_iter().chain(followed().flat_map(move |(_, value)| [value(&still); 2]))
            };
            let all = (0..plan.monitors.len()).flat_map(at_rest).collect();
            memory.insert(MEMORY.into(), all);
        }
        let first: Vec<_> = (0..plan.monitors.len()).map(|k| first_stress(memory, plan, k)).collect();
        let Some(kept) = memory.get_mut(MEMORY) else { return };
        let zero = |node: usize| datum.get(node).map_or([0.0; 3], Row::xyz);
        for ((monitor, first), kept) in plan.monitors.iter().zip(first).zip(kept.chunks_exact_mut(each())) {
            let corners = model.mesh.elements[monitor.location.element as usize].nodes();
            let corners = corners.iter().map(|&n| model.engine_node[n as usize] as usize);
            let Some(own) = step.own(corners) else { continue };
            let strained = elastic_change(model, monitor, |node| {
                let (u, zero) = (u[node].xyz(), zero(node));
                [0, 1, 2].map(|i| u[i] - zero[i])
            });
            let first = first.unwrap_or([f64::NAN; 6]);
            let s1_elastic = principal_values(&[0, 1, 2, 3, 4, 5].map(|c| first[c] + strained[c]))[0];
            let mut u = interpolate(model, monitor, u);
            if !datum.is_empty() {
                let zero = interpolate(model, monitor, datum);
                (0..3).for_each(|i| u[i] -= zero[i]);
            }
            let v = interpolate(model, monitor, du).map(|d| d / dt);
            let (last, extremes) = kept.split_at_mut(3);
            let a = [0, 1, 2].map(|i| (v[i] - last[i]) / own);
            last.copy_from_slice(&v);
            let moved = Moved { u, v, a, s1_elastic };
            for ((_, value), pair) in followed().zip(extremes.chunks_exact_mut(2)) {
                let value = value(&moved);
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
        let q = followed().position(|(name, _)| name == quantity)?;
        let at = each() * m + 3 + 2 * q;
        match memory.get(MEMORY)?.get(at..at + 2)? {
            &[max, min] => Some(Extremes { max, min }),
            _ => None,
        }
    }
}
