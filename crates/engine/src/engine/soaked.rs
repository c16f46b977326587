//! Water in the pores of a state's elements: what it does to the strains that laws see, and to the stresses that are shown.

use super::Engine;
use crate::parts::Kept;
use crate::state::State;
use crate::water::{earlier, with_pressure};

impl Engine {
    /// Makes stresses of points, as laws left them, total ones; the pressure \[Pa\] in the pores of every element by what parts remember,
    /// nothing in a model without water.
    pub(super) fn soak(&self, stress: &mut [[f64; 6]], kept: &Kept) -> Vec<f64> {
        let Engine { model, assembly, phase, .. } = self;
        if model.water.spells.is_empty() {
            return Vec::new();
        }
        let mut pore = vec![0.0; assembly.held_totals().elements.end];
        for &m in phase.members() {
            let (member, slices) = (&assembly.members[m as usize], &assembly.held[m as usize]);
            let Some(patch) = member.kind.patch().map(|patch| &model.patches[patch]) else { continue };
            let points = member.part.elements().1;
            let own = &mut pore[slices.elements.clone()];
            for (p, &e) in own.iter_mut().zip(&patch.elements) {
                *p = model.water.pressure(e as usize, phase.stage);
            }
            member.part.pressures(slices.kept(kept), own);
            for (i, &mut p) in own.iter_mut().enumerate() {
                if p != 0.0 {
                    let first = slices.points.start + i * points;
                    stress[first..first + points].iter_mut().for_each(|s| *s = with_pressure(*s, -p));
                }
            }
        }
        pore
    }

    /// Moves what laws see as strain by what the change of pressure that comes with the phase's stage does to the grains; what begins with
    /// the stage knows of it already, unless it takes over.
    pub(super) fn give_way(&self, state: &mut State) {
        let Engine { model, assembly, phase, .. } = self;
        let Some(before) = earlier(phase.stage).filter(|_| !model.water.spells.is_empty()) else { return };
        for &m in phase.members() {
            let (member, slices) = (&assembly.members[m as usize], &assembly.held[m as usize]);
            let Some(patch) = member.kind.patch().map(|patch| &model.patches[patch]) else { continue };
            if !member.initial || (patch.life.born == phase.stage && !patch.takes_over) {
                continue;
            }
            let moduli = model.bodies[patch.body].material.relaxed();
            let own = &mut state.initial[slices.initial.clone()];
            for (i, &e) in patch.elements.iter().enumerate() {
                let [p, last] = [phase.stage, before].map(|s| model.water.pressure(e as usize, s));
                if p != last {
                    let moved = model.water.offset(e as usize, p - last, moduli);
                    own[6 * (i / 8)..][..3].iter_mut().for_each(|octet| octet.0[i % 8] += moved);
                }
            }
        }
    }
}
