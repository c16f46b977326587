//! What water that cannot leave its pores comes to: where it boils, and where it would open the rock.

use super::observer::{Event, Observer, Schedule, Setting, View, Wants, Which};
use crate::error::RunError;
use crate::point_stress::mean;
use tremolite_engine::hexahedra::hex;
use tremolite_engine::model::Model;
use tremolite_engine::state::Memory;
use tremolite_engine::water::{FLOOR, with_pressure};
use tremolite_laws::sym3::principal_values;

/// Key of what this observer remembers: see [`Extreme::of`].
const MEMORY: &str = "pore_water";

/// Shares of the volume of the ground whose pressure follows its deformation, the largest of all rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoreWaterSeen {
    /// At the least pressure.
    pub floor: Extreme,
    /// With an effective principal stress in tension: the pressure exceeds the least total pressure.
    pub open: Extreme,
    /// Least and largest pressure of any element \[Pa\].
    pub pressures: [f64; 2],
}

/// A largest share, and when it was \[s\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    pub share: f64,
    pub time: f64,
}

impl PoreWaterSeen {
    /// What was seen; nothing where no pressure follows deformation.
    pub fn recall(memory: &Memory) -> Option<Self> {
        let &[floor, at_floor, open, at_open, least, most] = memory.get(MEMORY)?.as_slice() else {
            return None;
        };
        Some(PoreWaterSeen {
            floor: Extreme { share: floor, time: at_floor },
            open: Extreme { share: open, time: at_open },
            pressures: [least, most],
        })
    }
}

/// Looks at the pressure in pores.
pub struct PoreWater {
    schedule: Schedule,
    /// Elements, each with its share of the volume.
    elements: Vec<(u32, f64)>,
}

impl PoreWater {
    /// Nothing where no pressure follows deformation.
    pub fn new(setting: &Setting) -> Option<Self> {
        let model = setting.model;
        let volume = |e: &u32| hex(&model.mesh, *e as usize).map_or(0.0, |hex| hex.volume);
        let of: Vec<(u32, f64)> = undrained(model).map(|e| (e, volume(&e))).collect();
        let whole: f64 = of.iter().map(|(_, volume)| volume).sum();
        let elements: Vec<(u32, f64)> = of.into_iter().map(|(e, volume)| (e, volume / whole)).collect();
        (!elements.is_empty()).then_some(PoreWater { schedule: setting.rows(), elements })
    }
}

/// The user's elements in the shaking whose pressure follows their deformation.
pub fn undrained(model: &Model) -> impl Iterator<Item = u32> + '_ {
    let of = |&e: &usize| model.water.undrained(e).is_some();
    let stands = |&e: &usize| model.stands(e, tremolite_engine::Stage::Shaking);
    (0..model.user.elements).filter(of).filter(stands).map(|e| e as u32)
}

impl Observer for PoreWater {
    fn wants(&self) -> Wants {
        let elements = Which::some(self.elements.iter().map(|(e, _)| *e as usize));
        Wants { elements, ..Wants::looks(self.schedule) }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        if let Event::Look(view) = event {
            self.see(view, memory);
        }
        Ok(())
    }
}

impl PoreWater {
    fn see(&self, view: &View, memory: &mut Memory) {
        let View { phase, snapshot, .. } = *view;
        let (mut floor, mut open, mut least, mut most) = (0.0, 0.0, f64::INFINITY, f64::NEG_INFINITY);
        for &(e, share) in &self.elements {
            let Some(slot) = &phase.element_slot[e as usize] else { continue };
            let p = snapshot.pore[slot.element as usize];
            (least, most) = (p.min(least), p.max(most));
            // The floor is what is left of a difference.
            if p <= FLOOR + 1.0 {
                floor += share;
            }
            let points = &snapshot.stress[slot.point as usize..][..usize::from(slot.points)];
            let [largest, ..] = principal_values(&with_pressure(mean(&slot.places, points), p));
            if largest > 0.0 {
                open += share;
            }
        }
        let now = [floor, snapshot.time, open, snapshot.time, least, most];
        let kept = memory.entry(MEMORY.into()).or_insert_with(|| now.to_vec());
        for k in [0, 2] {
            if now[k] > kept[k] {
                kept[k..k + 2].copy_from_slice(&now[k..k + 2]);
            }
        }
        (kept[4], kept[5]) = (kept[4].min(least), kept[5].max(most));
    }
}
