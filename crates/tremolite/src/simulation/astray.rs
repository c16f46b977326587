//! What ends a run although its energy balances: motion and closure for which neither method nor laws are made.

use crate::places;
use tremolite_engine::assembly::Assembly;
use tremolite_engine::model::Model;
use tremolite_engine::phase::Phase;
use tremolite_engine::state::State;
use tremolite_results::{Said, said};

/// Why a simulation whose state is finite cannot go on from it, with the element or pair; none if it can. A node has moved further, since the
/// earthquake began, than the whole model is long, beside displacements that are to be small; or a joint has closed by more than the largest
/// closure of its law, where that goes on as a straight line which nobody measured.
pub(super) fn astray(model: &Model, assembly: &Assembly, phase: &Phase, state: &State) -> Option<Said> {
    ran_away(model, phase, state).or_else(|| closed_beyond(model, assembly, state))
}

fn ran_away(model: &Model, phase: &Phase, state: &State) -> Option<Said> {
    let (low, high) = model.mesh.bounds();
    let most = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
    let moved = |n: usize| {
        let from = state.datum.get(n).map_or([0.0; 3], |row| row.xyz());
        let u = state.u[n].xyz();
        (0..3).map(|k| (u[k] - from[k]).powi(2)).sum::<f64>().sqrt()
    };
    // Nodes of elements that stand alone: others have no motion of their own.
    if !(0..state.u.len()).any(|n| phase.mass[n] > 0.0 && moved(n) > most) {
        return None;
    }
    let mut furthest = (most, None);
    for (element, _) in (0..).zip(&phase.element_slot).filter(|(_, slot)| slot.is_some()) {
        for &corner in model.mesh.elements[element as usize].nodes() {
            let far = moved(model.engine_node[corner as usize] as usize);
            if far > furthest.0 {
                furthest = (far, Some(element));
            }
        }
    }
    let (far, element) = furthest;
    Some(said!(
        "{place} has moved by {far} m, further than the model is long, {most} m: it is loose, or the record carries the model off (correct its baseline)",
        place = places::element_at(model, element?),
        far = format!("{far:.3e}"),
        most = format!("{most:.3e}"),
    ))
}

fn closed_beyond(model: &Model, assembly: &Assembly, state: &State) -> Option<Said> {
    for (seam, contacts) in model.seams.iter().zip(&assembly.contacts) {
        let Some(limit) = contacts.law.closure_limit() else { continue };
        let worst =
            seam.lasting().map(|k| (contacts.seen(&state.history, k), k)).find(|(seen, _)| -seen.gap > limit);
        if let Some((seen, k)) = worst {
            return Some(said!(
                "{pair} has closed by {closure} m under {pressure} Pa, beyond the largest closure of its law, {limit} m: give a larger max_closure, or a stiffer joint",
                pair = places::pair(&model.mesh, seam, k),
                closure = format!("{:.3e}", -seen.gap),
                pressure = format!("{:.3e}", seen.pressure),
                limit = format!("{limit:.3e}"),
            ));
        }
    }
    None
}
