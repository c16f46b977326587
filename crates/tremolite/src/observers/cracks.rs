//! How far cracks have opened.

use super::{Observer, Schedule, View};
use crate::history;
use crate::material::{AnyMaterial, Instance};
use crate::model::{Model, ModelError};
use crate::parts::solid::Strain;
use crate::parts::{Motion, Own, Part, ProbeOut, Scratch, Tick};
use crate::phase::{Phase, part_of};
use crate::run::RunError;
use crate::state::State;
use std::sync::Arc;
use tremolite_laws::Row;
use tremolite_laws::sym3::principal_values;

/// Keeps by element (in the order of parts) the widest crack seen at one of its points \[m\], and when \[s\], under
/// [`Cracks::OPENING`] and [`Cracks::TIME`] in the state.
///
/// The opening is D⁺ ε₁ h with the largest principal strain ε₁ and the extent h across the crack at first damage: of
/// the stretch ε₁ h of a smeared crack, what the stress that is left, (1 − D⁺)Eε₁, does not explain. Where several
/// cracks cross an element it is their sum, and of an element that has come loose it means nothing.
pub struct Cracks {
    schedule: Schedule,
    /// Patches whose law cracks, with a part that reads their strains.
    parts: Vec<(usize, Box<dyn Part>)>,
    scratch: Scratch,
    forces: Vec<Row>,
    energy: Vec<[f64; 2]>,
    strain: Vec<[f64; 6]>,
}

impl Cracks {
    pub const OPENING: &'static str = "crack_opening";
    pub const TIME: &'static str = "crack_opening time";

    /// The observer, if a law of the model can crack.
    ///
    /// # Errors
    /// If an element's geometry cannot be used; [`Model::new`] has checked that.
    pub fn new(model: &Model, schedule: Schedule) -> Result<Option<Self>, ModelError> {
        let mut parts = Vec::new();
        for (p, patch) in model.patches[..model.user_patches].iter().enumerate() {
            let law = &model.bodies[patch.body].material;
            if law.info().history.iter().any(|c| c.name == "crack_size") {
                let strain: Arc<dyn AnyMaterial> = Arc::new(Instance(Arc::new(Strain(law.moduli()))));
                parts.push((p, part_of(model, patch, &*strain)?.0));
            }
        }
        let (scratch, forces, energy, strain) = Default::default();
        let made = Cracks { schedule, parts, scratch, forces, energy, strain };
        Ok((!made.parts.is_empty()).then_some(made))
    }

    /// Strains of the points of a part at the state's displacements.
    fn read(&mut self, part: usize, phase: &Phase, state: &State) {
        let (patch, part) = &self.parts[part];
        self.forces.resize(part.nodes().len(), Row::ZERO);
        self.energy.resize(phase.slices[*patch].elements.len(), [0.0; 2]);
        self.strain.resize(phase.slices[*patch].points.len(), [0.0; 6]);
        let own = Own { history: &mut [], overstress: &mut [], numbers: &mut [] };
        let out = ProbeOut { stress: &mut self.strain, energy: &mut self.energy };
        let motion = Motion { u: &state.u, du: &state.du };
        part.probe(&Tick { time: 0.0, dt: 0.0 }, &motion, own, &mut self.forces, out, &mut self.scratch);
    }
}

impl Observer for Cracks {
    fn schedule(&self) -> Schedule {
        self.schedule
    }

    fn see(&mut self, view: &View, state: &mut State) -> Result<(), RunError> {
        let View { model, phase, .. } = *view;
        let elements = view.snapshot.energy.len();
        let mut take = |name: &str| state.observers.remove(name).unwrap_or_else(|| vec![0.0; elements]);
        let (mut widest, mut when) = (take(Self::OPENING), take(Self::TIME));
        for part in 0..self.parts.len() {
            let patch = self.parts[part].0;
            let mut read = false;
            for &element in &model.patches[patch].elements {
                let Some(slot) = phase.element_slot[element as usize] else { continue };
                let column = |name: &str| history::position(model, &slot, name);
                let (Some(damage), Some(size)) = (column("d_tension"), column("crack_size")) else {
                    continue;
                };
                let damage = history::values(model, phase, state, &slot, damage);
                let size = history::values(model, phase, state, &slot, size);
                for (p, (damage, size)) in damage.zip(size).enumerate() {
                    if damage == 0.0 {
                        continue;
                    }
                    if !read {
                        self.read(part, phase, state);
                        read = true;
                    }
                    let e = self.strain[slot.point as usize - phase.slices[patch].points.start + p];
                    let tensor = [e[0], e[1], e[2], 0.5 * e[3], 0.5 * e[4], 0.5 * e[5]];
                    let opening = damage * size * principal_values(&tensor)[0];
                    let at = slot.element as usize;
                    if opening > widest[at] {
                        (widest[at], when[at]) = (opening, state.time());
                    }
                }
            }
        }
        state.observers.insert(Self::OPENING.into(), widest);
        state.observers.insert(Self::TIME.into(), when);
        Ok(())
    }
}
