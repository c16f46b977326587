//! What presses in a stage: on the top, between the void and what stands, and shear that rollers cannot carry.

use super::faces::Faces;
use super::fitting;
use std::collections::{BTreeMap, HashSet};
use tremolite_case::{Case, Problem, pattern};
use tremolite_engine::outer_faces::OuterFaces;
use tremolite_engine::{Life, Side};
use tremolite_mesh::topology::{exterior_faces, face_key};
use tremolite_mesh::{Face, Mesh};

/// Pressures that act in a stage: on the top plane, and between the void and groups on either side.
pub(super) fn loads(
    case: &Case,
    stage: usize,
    mesh: &Mesh,
    standing: &[u32],
    shown: &[u32],
    walls: &Faces,
    outer: &OuterFaces,
) -> Vec<(Face, [f64; 6])> {
    let tensor = |p: f64| [-p, -p, -p, 0.0, 0.0, 0.0];
    let mut acting = Vec::new();
    let top = &outer.planes[2][1];
    let overburden = case.initial.overburden.as_ref().map_or(0.0, |p| p.value);
    // The last word of each pattern so far.
    let mut pressures: BTreeMap<&str, f64> = BTreeMap::new();
    for written in case.stages.iter().take(stage) {
        written.pressures.iter().for_each(|(pattern, p)| {
            pressures.insert(pattern.value.as_str(), p.value);
        });
    }
    let on_top = overburden + pressures.remove(TOP).unwrap_or(0.0);
    if on_top > 0.0 {
        acting.extend(top.iter().map(|&face| (face, tensor(on_top))));
    }
    if pressures.is_empty() {
        return acting;
    }
    let on_side: HashSet<Face> = outer.planes.iter().flatten().flatten().copied().collect();
    for (pattern, p) in pressures {
        let mut inside = vec![false; mesh.elements.len()];
        mesh.groups
            .iter()
            .filter(|(name, _)| pattern::matches(pattern, name))
            .flat_map(|(_, elements)| elements)
            .for_each(|&e| inside[e as usize] = true);
        for face in exterior_faces(mesh, Some(standing)) {
            let own = shown[face.element as usize];
            let key = face_key(mesh, face);
            let beside = || walls.get(&key).into_iter().flatten().filter(|&&e| e != own);
            if !on_side.contains(&face) && (inside[own as usize] || beside().any(|&e| inside[e as usize])) {
                acting.push((face, tensor(p)));
            }
        }
    }
    acting
}

/// The word for the top plane where groups stand.
const TOP: &str = "top";

/// Shear of the initial stress on side planes that rollers will hold, which these cannot carry.
pub(super) fn sides(
    initial: &[[f64; 6]],
    sides: [Side; 2],
    places: &[Life],
    shown: &[u32],
    outer: &OuterFaces,
) -> Vec<(Face, [f64; 6])> {
    let mut acting = Vec::new();
    if initial.is_empty() {
        return acting;
    }
    for axis in 0..2 {
        if matches!(sides[axis], Side::Periodic | Side::Fixed) {
            continue;
        }
        for &face in outer.planes[axis].iter().flatten() {
            // What is installed later is free of stress; what stood there before is not.
            let of = shown[face.element as usize];
            if of == face.element && places[of as usize].is_later() {
                continue;
            }
            let [.., xy, yz, zx] = initial[face.element as usize];
            let shear = if axis == 0 { [0.0, 0.0, 0.0, xy, 0.0, zx] } else { [0.0, 0.0, 0.0, xy, yz, 0.0] };
            if shear.iter().any(|s| *s != 0.0) {
                acting.push((face, shear));
            }
        }
    }
    acting
}

/// The patterns of pressures that no group fits.
pub fn check_pressures(case: &Case, mesh: &Mesh, problems: &mut Vec<Problem>) {
    let written = case.stages.iter().flat_map(|stage| &stage.pressures);
    for (pattern, _) in written.filter(|(pattern, _)| pattern.value != TOP) {
        let _ = fitting(pattern, mesh, problems);
    }
}
