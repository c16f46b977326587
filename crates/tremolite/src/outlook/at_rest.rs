//! What the initial stress is to the ground that it is in, before anything moves.

use crate::history::History;
use rayon::prelude::*;
use std::sync::Arc;
use tremolite_engine::engine::Engine;
use tremolite_engine::hexahedra::{centroid, hex};
use tremolite_engine::water::with_pressure;
use tremolite_engine::{Assembly, Model, Phase};
use tremolite_laws::Role;
use tremolite_laws::sym3::principal_values;

/// Tension \[Pa\] that is more than round-off of a stress that is none.
const TENSION: f64 = 1.0;

/// What the initial stress is to the ground.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AtRest {
    /// What stands at first, and of it what is in tension and what lies beyond yield \[m³\].
    pub volume: f64,
    pub tension: f64,
    pub beyond: f64,
    /// The largest tension, and where its element has its centre.
    pub largest: Option<(f64, [f64; 3])>,
    /// Where the walls of what is taken out are loaded most for their strength.
    pub wall: Option<Wall>,
}

/// An opening's wall before its rock yields.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall {
    /// The centre of an element that is taken out there \[m\].
    pub at: [f64; 3],
    /// 3σ₁ − σ₃ of the initial stress in the section, compression positive: the largest stress round a circular opening (`kirsch1898`)
    /// \[Pa\]. Of a mesh whose axis nobody knows the least of the two upright sections.
    pub load: f64,
    /// The material's uniaxial compressive strength \[Pa\].
    pub strength: f64,
}

/// What the initial stress is to what stands at first; nothing where there is none. Parts are evaluated once, without motion.
/// `along_y`: the openings are known to go along y.
pub fn at_rest(
    model: &Arc<Model>,
    assembly: &Arc<Assembly>,
    first: &Arc<Phase>,
    along_y: bool,
) -> Option<AtRest> {
    if model.elements.initial.is_empty() {
        return None;
    }
    let seen = Engine::new(model, assembly, first).look(&assembly.rest());
    let history = History::new(assembly, &seen.history);
    let strengths: Vec<Option<f64>> = model.bodies.iter().map(strength).collect();
    let mut found = AtRest::default();
    let volume = |e: usize| hex(&model.mesh, e).ok().map(|shape| shape.volume);
    let volumes: Vec<Option<f64>> = (0..model.user.elements).into_par_iter().map(volume).collect();
    for ((e, slot), volume) in first.element_slot.iter().enumerate().zip(volumes) {
        let (Some(slot), Some(volume)) = (slot, volume) else { continue };
        let total = model.elements.initial[e];
        // Rock bears by effective stress.
        let stress = &with_pressure(total, model.water.pressure(e, first.stage));
        let [high, ..] = principal_values(stress);
        found.volume += volume;
        if high > TENSION {
            found.tension += volume;
            if found.largest.is_none_or(|(most, _)| high > most) {
                found.largest = Some((high, centroid(&model.mesh, e as u32)));
            }
        }
        let yields = history.with_role(slot, Role::PlasticShear);
        if yields.is_some_and(|column| history.values(slot, column).any(|shear| shear > 0.0)) {
            found.beyond += volume;
        }
        let strength = model.elements.body_of[e].and_then(|body| strengths[body]);
        if let (Some(strength), Some(_)) = (strength, model.elements.lives[e].gone) {
            let [xx, yy, zz, _, yz, zx] = *stress;
            let across = round(xx, zz, zx);
            let load = if along_y { across } else { across.min(round(yy, zz, yz)) };
            if found.wall.as_ref().is_none_or(|wall| load / strength > wall.load / wall.strength) {
                found.wall = Some(Wall { at: centroid(&model.mesh, e as u32), load, strength });
            }
        }
    }
    Some(found)
}

/// 3σ₁ − σ₃, compression positive, of a stress in a plane, tension positive \[Pa\].
fn round(a: f64, b: f64, shear: f64) -> f64 {
    let (middle, radius) = (0.5 * (a + b), (0.25 * (a - b).powi(2) + shear * shear).sqrt());
    (middle + radius) - 3.0 * (middle - radius)
}

/// The uniaxial compressive strength of what yields.
fn strength(body: &tremolite_engine::Body) -> Option<f64> {
    let yields = body.material.info().history.iter().any(|column| column.role == Role::PlasticShear);
    let constants = if yields { body.material.derived([1.0; 2]) } else { Vec::new() };
    constants.iter().find(|c| c.name == "compressive_strength").map(|c| c.range[0]).filter(|x| *x > 0.0)
}
