//! A changed material begins at the stress of what it replaces.
//!
//! With r = E/E' the displacements count so that their strain and hourglass amplitudes are r times those before: at the same ν the
//! stresses of elements are then the same at every point, whatever damage has left. What remains, C'⁻¹Cε_e + ε_p − rBu with ε_e
//! the elastic strain so far, is the strain that the element begins with; it is constant in an element, as far as ν changes or
//! the points of a 2×2×2 element have yielded differently.

use super::Engine;
use super::lent::Lent;
use crate::hexahedra::{hex, hex_nodes};
use crate::member::Member;
use crate::state::State;
use std::collections::{HashMap, HashSet};
use tremolite_laws::{Column, Role, Row};

/// Where an element lies among the members.
#[derive(Clone, Copy)]
struct Place {
    member: usize,
    patch: usize,
    index: usize,
}

/// Columns of two histories that mean the same: (of the old, of the new). All, where the laws are one.
fn alike(old: &[Column], new: &[Column]) -> Vec<(usize, usize)> {
    if old == new {
        return (0..old.len()).map(|c| (c, c)).collect();
    }
    let nth = |columns: &[Column], role: Role, n: usize| {
        columns.iter().enumerate().filter(|(_, c)| c.role == role).map(|(k, _)| k).nth(n)
    };
    let mut pairs = Vec::new();
    for (to, column) in new.iter().enumerate().filter(|(_, c)| c.role != Role::Own) {
        let before = new[..to].iter().filter(|c| c.role == column.role).count();
        if let Some(from) = nth(old, column.role, before) {
            pairs.push((from, to));
        }
    }
    pairs
}

impl Engine {
    /// Gives the elements of a member that take over what those before them have come to, which other ranks have `lent`.
    pub(super) fn take_over(&self, member: usize, state: &mut State, lent: &Lent) {
        let (model, assembly) = (&self.model, &self.assembly);
        let Member { kind, reads, .. } = &assembly.members[member];
        let Some(patch) = kind.patch() else { return };
        let named: HashSet<u32> = reads.elements.iter().copied().collect();
        let mut places: HashMap<u32, Place> = HashMap::new();
        for (patch, of) in model.patches.iter().enumerate() {
            let member = assembly.of_patch[patch] as usize;
            for (index, &e) in of.elements.iter().enumerate().filter(|(_, e)| named.contains(e)) {
                places.insert(e, Place { member, patch, index });
            }
        }
        for (index, &e) in model.patches[patch].elements.iter().enumerate() {
            let Some(earlier) = model.elements.successors.get(&e) else { continue };
            match places.get(earlier) {
                Some(&earlier) => {
                    self.take_over_element(Place { member, patch, index }, earlier, e, state, lent);
                }
                // What the member did not name it cannot know.
                None => state.reference[assembly.held[member].reference.clone()].fill(Row([f64::NAN; 4])),
            }
        }
    }

    fn take_over_element(&self, new: Place, old: Place, element: u32, state: &mut State, lent: &Lent) {
        let (model, assembly) = (&self.model, &self.assembly);
        // `Assembly::new` has checked every element.
        let Ok(hex) = hex(&model.mesh, element as usize) else { return };
        let corners = hex_nodes(&model.mesh, element as usize);
        let [old_part, new_part] = [old, new].map(|place| &assembly.members[place.member].part);
        let new_slices = &assembly.held[new.member];
        let (old_slices, history, references, initial) = match lent.slices.get(&old.member) {
            Some(slices) => (slices, &lent.history, &lent.reference, &lent.initial),
            None => (&assembly.held[old.member], &state.history, &state.reference, &state.initial),
        };
        let history = history[old_slices.history.clone()].to_vec();
        let references = references[old_slices.reference.clone()].to_vec();
        let initial = initial[old_slices.initial.clone()].to_vec();
        let moduli = [old, new].map(|p| model.bodies[model.patches[p.patch].body].material.relaxed());
        let ratio = moduli[0].young() / moduli[1].young();

        let mut moved = [[0.0; 3]; 8];
        for (k, node) in corners.iter().enumerate() {
            let node = model.engine_node[*node as usize];
            let zero = if references.is_empty() {
                Row::ZERO
            } else if model.patches[old.patch].takes_over {
                references[8 * old.index + k]
            } else {
                let place = old_part.nodes().iter().position(|n| *n == node);
                place.map_or(Row::ZERO, |place| references[place])
            };
            let u = state.u[node as usize];
            moved[k] = [0, 1, 2].map(|i| u.0[i] - zero.0[i]);
            let now = &mut state.reference[new_slices.reference.start + 8 * new.index + k];
            *now = Row::new([0, 1, 2].map(|i| u.0[i] - ratio * moved[k][i]));
        }

        // Columns of equal meaning go on, point by point.
        let (columns, old_columns) = (new_part.columns(), old_part.columns());
        let points = new_part.elements().1;
        let shares = model.bodies[model.patches[new.patch].body].quadrature.shares();
        let at = |start: usize, index: usize, count: usize, point: usize| {
            start + (index / 8 * points + point) * count
        };
        let mut plastic = [0.0; 6];
        for point in 0..points {
            let from = at(0, old.index, old_columns.len(), point);
            let to = at(new_slices.history.start, new.index, columns.len(), point);
            for (a, b) in alike(old_columns, columns) {
                state.history[to + b].0[new.index % 8] = history[from + a].0[old.index % 8];
            }
            let strains = old_columns.iter().enumerate().filter(|(_, c)| c.role == Role::PlasticStrain);
            for ((c, _), sum) in strains.zip(&mut plastic) {
                *sum += shares[point] * history[from + c].0[old.index % 8];
            }
        }

        let of_displacements = hex.mean_strain(&moved);
        let began =
            |c: usize| initial.get(6 * (old.index / 8) + c).map_or(0.0, |octet| octet.0[old.index % 8]);
        let elastic = [0, 1, 2, 3, 4, 5].map(|c| of_displacements[c] + began(c) - plastic[c]);
        let elastic = moduli[1].strain(&moduli[0].stress(&elastic));
        for c in 0..6 {
            let begins = elastic[c] + plastic[c] - ratio * of_displacements[c];
            state.initial[new_slices.initial.start + 6 * (new.index / 8) + c].0[new.index % 8] = begins;
        }
    }
}
