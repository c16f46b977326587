//! How much stronger concrete was for being strained fast, where it failed.

use crate::groups::Group;
use crate::history::History;
use tremolite_engine::hexahedra::{centroid, hex};
use tremolite_engine::model::Model;
use tremolite_engine::phase::Phase;
use tremolite_laws::Role;
use tremolite_results::{Onset, Place, RateFactor};

/// What laws keep of the rate at first damage in tension and in shear: the factor that the strength had then. It stays, so that the end of a run
/// has all of it, whatever its steps were.
fn factor_of(measure: Role) -> Option<Role> {
    match measure {
        Role::TensionDamage => Some(Role::TensionRateFactor),
        Role::ShearDamage => Some(Role::ShearRateFactor),
        _ => None,
    }
}

/// The rate factors of a group's points that are damaged by a measure, which began at `first`: 1 of a law that is the same at any rate; nothing
/// where no point is damaged, and where the law keeps none.
pub fn rate_factor(
    model: &Model,
    phase: &Phase,
    history: &History,
    group: &Group,
    (measure, first): (Role, Option<Onset>),
) -> Option<RateFactor> {
    let role = factor_of(measure)?;
    let place = |e: u32| Place { element: model.mesh.element_id(e as usize), at: centroid(&model.mesh, e) };
    let (mut found, mut sum, mut volume) = (RateFactor::default(), 0.0, 0.0);
    for &element in &group.elements {
        let (Some(slot), Ok(hex)) =
            (phase.element_slot[element as usize], hex(&model.mesh, element as usize))
        else {
            continue;
        };
        let Some(column) = history.with_role(&slot, role) else { continue };
        let mut most = 0.0_f64;
        for (factor, weight) in history.values(&slot, column).zip(slot.places.weights(&hex)) {
            if factor > 0.0 {
                (sum, volume, most) = (sum + factor * weight, volume + weight, most.max(factor));
            }
        }
        if most > 0.0 && found.largest.max(0.0) < most {
            (found.largest, found.at) = (most, place(element));
        }
        if most > 0.0 && first.is_some_and(|first| first.element == model.mesh.element_id(element as usize)) {
            found.first = most;
        }
    }
    found.mean = sum / volume;
    (volume > 0.0).then_some(found)
}
