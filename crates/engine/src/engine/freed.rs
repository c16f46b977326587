//! Pairs whose nodes something held together until now begin with the traction that passes there. The force between two copies
//! cannot be told from what the rock or the lining carried that is gone now, so the stress beside them says it.

use super::Engine;
use crate::contacts::LoadedPair;
use crate::state::State;
use tremolite_mesh::Face;

impl Engine {
    /// Gives pairs that the phase's stage frees the traction of the stress beside them, from where their nodes are. Of a side that
    /// came later than the other its own stress alone counts: what stood before it is stressed by more than what passes between
    /// them.
    pub(super) fn free_pairs(&mut self, state: &mut State) {
        let (model, assembly, phase) = (self.model.clone(), self.assembly.clone(), self.phase.clone());
        let freed: Vec<(usize, usize)> = (0..)
            .zip(&model.seams)
            .flat_map(|(s, seam)| (0..seam.pairs.len()).map(move |k| (s, k)))
            .filter(|&(s, k)| model.seams[s].freed[k] && model.seams[s].lives[k].born == phase.stage)
            .collect();
        if freed.is_empty() {
            return;
        }
        // What stands in the place of an element now, and from when on its place is filled.
        let now = |mut element: u32| {
            while !model.elements.lives[element as usize].holds(phase.stage) {
                element = *model.elements.successors.get(&element)?;
            }
            Some(element)
        };
        let born = |mut element: u32| {
            while let Some(&earlier) = model.elements.successors.get(&element) {
                element = earlier;
            }
            model.elements.lives[element as usize].born
        };
        let beside = |s: usize, k: usize| {
            let seam = &model.seams[s];
            seam.pairs[k].corners.iter().flat_map(|(f, _)| seam.faces[*f as usize])
        };
        let asked =
            freed.iter().flat_map(|&(s, k)| beside(s, k)).filter_map(|face| now(face.element)).collect();
        let stresses = self.mean_stresses(state, &asked);
        for (s, k) in freed {
            let (seam, contacts) = (&model.seams[s], &assembly.contacts[s]);
            if !self.has(contacts.member_of(k)) {
                continue;
            }
            let latest = beside(s, k).map(|face| born(face.element)).max();
            let reads = &assembly.members[contacts.member_of(k)].reads.elements;
            let stress = |face: Face| {
                // What the pair's member did not name it cannot know.
                if reads.binary_search(&face.element).is_err() {
                    return Some([f64::NAN; 6]);
                }
                let counts = Some(born(face.element)) == latest;
                stresses.get(&now(face.element)?).copied().filter(|_| counts)
            };
            let mut traction = seam.traction(k, stress);
            traction[0] -= model.water.in_pair(seam, k, phase.stage);
            let [a, b] = seam.pairs[k].nodes.map(|n| state.u[model.engine_node[n as usize] as usize]);
            let d = [0, 1, 2].map(|i| b.0[i] - a.0[i]);
            let loaded = LoadedPair { pair: k as u32, normal: seam.pairs[k].normal, traction };
            contacts.load(&mut state.history, &loaded, d);
        }
    }
}
