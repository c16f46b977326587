//! What bolts lift of pieces that nothing else holds up.

use std::collections::BTreeSet;
use tremolite_engine::Stage;
use tremolite_engine::bolts::{Bolt, BoltSet, Segment};

/// What a bolt lifts of a piece at its strength \[N\].
pub(super) struct Pull {
    pub hangs: u32,
    pub upwards: f64,
}

/// What a bolt lifts of each piece that is not held up, from those that are: the strength of its weakest part between the two, and of
/// its bond in the held one, times how steeply it goes up there.
pub(super) fn pulls_of(
    set: &BoltSet,
    bolt: &Bolt,
    stage: Stage,
    held: &BTreeSet<u32>,
    mut piece_of: impl FnMut(u32) -> u32,
) -> Vec<Pull> {
    let lies: Vec<u32> = bolt.points.iter().map(|point| piece_of(point.host)).collect();
    let there = |segment: &&Segment| segment.gone.is_none_or(|gone| gone > stage);
    let area = bolt.segments.iter().filter(there).map(|segment| segment.area).fold(f64::INFINITY, f64::min);
    let bonded = |wanted: &dyn Fn(u32) -> bool| -> f64 {
        let of =
            |segment: &&Segment| !segment.free && segment.points.iter().all(|&p| wanted(lies[p as usize]));
        bolt.segments.iter().filter(there).filter(of).map(|segment| segment.length).sum()
    };
    // A plate at an end in the piece holds that end without a bond.
    let plated = |wanted: &dyn Fn(u32) -> bool| {
        let ends = [lies.first(), lies.last()];
        ends.iter().zip(set.kind.plates).any(|(end, plate)| plate && end.is_some_and(|end| wanted(*end)))
    };
    let strength = |wanted: &dyn Fn(u32) -> bool| match set.kind.bond {
        Some(bond) if !plated(wanted) => bond.strength * bonded(wanted),
        _ => f64::INFINITY,
    };
    let hanging: BTreeSet<u32> = lies.iter().copied().filter(|piece| !held.contains(piece)).collect();
    let middle = |wanted: &dyn Fn(u32) -> bool| {
        let places: Vec<[f64; 3]> = bolt
            .points
            .iter()
            .zip(&lies)
            .filter(|(_, piece)| wanted(**piece))
            .map(|(p, _)| p.place)
            .collect();
        [0, 1, 2].map(|i| places.iter().map(|x| x[i]).sum::<f64>() / places.len() as f64)
    };
    let is_held = |piece: u32| held.contains(&piece);
    if !lies.iter().any(|piece| is_held(*piece)) {
        return Vec::new();
    }
    let to = middle(&is_held);
    hanging
        .into_iter()
        .map(|hangs| {
            let own = |piece: u32| piece == hangs;
            let from = middle(&own);
            let way = [0, 1, 2].map(|i| to[i] - from[i]);
            let length = way.iter().map(|x| x * x).sum::<f64>().sqrt();
            let force = (set.kind.yields * area).min(strength(&own)).min(strength(&is_held));
            // Nothing of an infinite strength is lifted sideways.
            let upwards = if way[2] > 0.0 { force * way[2] / length } else { 0.0 };
            Pull { hangs, upwards }
        })
        .collect()
}
