//! Where forces of linings are told: their stations, and the bars that lie in these.

use crate::groups::all_groups;
use crate::sections::{Station, Steel, is_lining, stations};
use std::collections::HashMap;
use tremolite_engine::{Model, Stage};

/// The stations of whole groups that are linings, each with the name of its group: those that damage, that begin with a stage, whose
/// elements are layered, or that the generator calls so.
pub(in crate::observers) fn lined(model: &Model) -> Vec<(String, Station)> {
    let mut standing = vec![false; model.mesh.elements.len()];
    model.standing(Stage::Shaking).iter().for_each(|&e| standing[e as usize] = true);
    let mut all = Vec::new();
    for group in all_groups(model) {
        let later = group.elements.iter().any(|&e| model.elements.lives[e as usize].is_later());
        if group.whole && (later || group.body.material.info().damages || is_lining(group.body, group.name)) {
            let found = stations(&model.mesh, &group.elements, &standing);
            all.extend(found.into_iter().map(|station| (group.name.to_owned(), station)));
        }
    }
    all
}

/// Segments of bars that move with what they lie in, by the station they lie in.
pub(super) fn steel(model: &Model, stations: &[(String, Station)]) -> Vec<Vec<Steel>> {
    let mut found = vec![Vec::new(); stations.len()];
    let mut station_of: HashMap<u32, usize> = HashMap::new();
    for (k, (_, station)) in stations.iter().enumerate() {
        for &(e, _) in &station.stack {
            // What the element was before its material changed is in its place.
            let same = std::iter::successors(Some(e), |e| model.elements.successors.get(e).copied());
            station_of.extend(same.map(|e| (e, k)));
        }
    }
    for (s, set) in model.bolts.iter().enumerate().filter(|(_, set)| set.kind.bond.is_none()) {
        for (b, bolt) in set.bolts.iter().enumerate() {
            for (i, segment) in bolt.segments.iter().enumerate().filter(|(_, segment)| !segment.free) {
                let ends = segment.points.map(|p| &bolt.points[p as usize]);
                // A point between two elements may be counted to either: the segment is in the one around its middle.
                let middle = bolt.middle(i);
                let off = |k: &usize| {
                    let station = &stations[*k].1;
                    let off = |c: usize| (middle[c] - station.place[c]) * station.along[c];
                    (off(0) + off(1) + off(2)).abs()
                };
                let near = ends.iter().filter_map(|end| station_of.get(&end.host));
                if let Some(&k) = near.min_by(|a, b| off(a).total_cmp(&off(b))) {
                    let shares = Steel::shares(&stations[k].1, ends.map(|end| end.place));
                    found[k].push(Steel { segment: [s, b, i], shares });
                }
            }
        }
    }
    found
}
