//! Stress of some elements, wherever they are evaluated: what parts ask for where a stage begins.

use super::Engine;
use super::evaluation::Probed;
use crate::parts::Kept;
use crate::state::State;
use std::collections::{BTreeSet, HashMap};

impl Engine {
    /// Mean total stress \[Pa\] of some elements of the mesh at a state, which is left as it is; the same elements are asked for on all ranks.
    pub(super) fn mean_stresses(&mut self, state: &State, asked: &BTreeSet<u32>) -> HashMap<u32, [f64; 6]> {
        let mut probed = Probed::default();
        let (history, numbers) = self.evaluate_copies(state, Some(&mut probed));
        let kept = Kept { history: &history, numbers: &numbers, ..state.kept() };
        self.soak(&mut probed.stress, &kept);
        let Engine { model, assembly, ranks, .. } = &*self;
        let (mut found, mut of, mut own) = (Vec::new(), Vec::new(), Vec::new());
        for (patch, &m) in model.patches.iter().zip(&assembly.of_patch) {
            let m = m as usize;
            let points = assembly.members[m].part.elements().1;
            let shares = model.bodies[patch.body].quadrature.shares();
            for (i, &e) in patch.elements.iter().enumerate().filter(|(_, e)| asked.contains(e)) {
                found.push(e);
                of.push(ranks.as_ref().map_or(0, |ranks| ranks.division.of_member[m]));
                if self.has(m) {
                    let first = assembly.held[m].points.start + i * points;
                    let mut mean = [0.0; 6];
                    for (point, share) in probed.stress[first..first + points].iter().zip(shares) {
                        (0..6).for_each(|c| mean[c] += share * point[c]);
                    }
                    own.push(mean);
                }
            }
        }
        let means = ranks.as_ref().map_or_else(|| own.clone(), |ranks| ranks.rows(&of, &own, 6));
        found.into_iter().zip(means).collect()
    }
}
