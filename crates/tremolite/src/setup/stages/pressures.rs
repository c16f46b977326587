//! What presses in a stage: on the top, between the void and what stands, and shear that rollers cannot carry.

use super::faces::Faces;
use super::fitting;
use std::collections::{BTreeMap, HashSet};
use tremolite_case::{Case, Diagnostic, Spanned, pattern};
use tremolite_engine::outer_faces::OuterFaces;
use tremolite_engine::{Life, Side, Stage};
use tremolite_mesh::topology::{exterior_faces, face_points};
use tremolite_mesh::{Face, Mesh};

/// What stands in a stage.
pub(super) struct Around<'a> {
    pub mesh: &'a Mesh,
    pub standing: &'a [u32],
    /// Each element as the one that the mesh was read with.
    pub shown: &'a [u32],
    /// When something of its own stands in the place of each of those.
    pub places: &'a [Life],
    pub walls: &'a Faces,
}

/// Pressures that act in a stage: on the top plane, and between the void and groups on either side. A group on the side that
/// stands is itself there, and no stand-in; one on the other is gone, or what stood in its place was excavated.
pub(super) fn loads(
    case: &Case,
    stage: usize,
    around: &Around,
    outer: &OuterFaces,
    warnings: &mut Vec<Diagnostic>,
) -> Vec<(Face, [f64; 6])> {
    let Around { mesh, standing, shown, places, walls } = *around;
    let tensor = |p: f64| [-p, -p, -p, 0.0, 0.0, 0.0];
    let mut acting = Vec::new();
    let top = &outer.planes[2][1];
    let overburden = case.initial.overburden.as_ref().map_or(0.0, |p| p.value);
    let weight = case.water.as_ref().map_or(0.0, |water| water.unit_weight.value);
    // Each name's last word so far, in the order in which they came, and whether it is this stage's.
    let mut pressures: Vec<(&str, Press, Option<&Spanned<String>>)> = Vec::new();
    for (k, written) in case.stages.iter().take(stage).enumerate() {
        let even = written.pressures.iter().map(|(pattern, p)| (pattern, Press::Even(p.value)));
        let filled = written.water.filled.iter();
        let filled = filled.map(|(pattern, level)| (pattern, Press::Water { level: level.value, weight }));
        for (pattern, press) in even.chain(filled) {
            let here = |(name, _, now): &(&str, Press, Option<&Spanned<String>>)| {
                *name == pattern.value && now.is_some()
            };
            if k + 1 == stage && pressures.iter().any(here) {
                warnings.push(Diagnostic::at(
                    pattern,
                    format!(
                        "'{}' is pressed on and full of water in one stage: the water alone counts",
                        pattern.value
                    ),
                    "give one of the two; water presses as it is deep",
                ));
            }
            pressures.retain(|(name, ..)| *name != pattern.value);
            pressures.push((pattern.value.as_str(), press, (k + 1 == stage).then_some(pattern)));
        }
    }
    let above = pressures.iter().find(|(name, ..)| *name == TOP).map_or(Press::Even(0.0), |(_, p, _)| *p);
    pressures.retain(|(name, ..)| *name != TOP);
    let on_top = |face: Face| overburden + above.on(mesh, face);
    let on_top = top.iter().map(|&face| (face, on_top(face))).filter(|(_, p)| *p != 0.0);
    acting.extend(on_top.map(|(face, p)| (face, tensor(p))));
    if pressures.is_empty() {
        return acting;
    }
    let on_side: HashSet<Face> = outer.planes.iter().flatten().flatten().copied().collect();
    let walls_here: Vec<Face> =
        exterior_faces(mesh, Some(standing)).into_iter().filter(|face| !on_side.contains(face)).collect();
    // The last word counts.
    let mut pressed: BTreeMap<Face, (&str, Press)> = BTreeMap::new();
    let mut told: HashSet<[&str; 2]> = HashSet::new();
    let mut excavated = vec![false; mesh.elements.len()];
    let patterns = case.stages.iter().take(stage).flat_map(|written| &written.excavate);
    patterns.flat_map(|pattern| in_groups(mesh, pattern)).for_each(|e| excavated[e as usize] = true);
    for (pattern, p, now) in pressures {
        let mut inside = vec![false; mesh.elements.len()];
        in_groups(mesh, pattern).for_each(|e| inside[e as usize] = true);
        let is_pressed = |face: &Face| {
            let own = shown[face.element as usize];
            let mut beside = walls.elements(mesh, *face).filter(|&e| e != own);
            let gone =
                |e: u32| places[e as usize].born <= Stage::Before(stage as u16) || excavated[e as usize];
            (own == face.element && inside[own as usize]) || beside.any(|e| inside[e as usize] && gone(e))
        };
        let faces: Vec<Face> = walls_here.iter().copied().filter(is_pressed).collect();
        if let (true, Some(written)) = (faces.is_empty() && p != Press::Even(0.0), now) {
            warnings.push(Diagnostic::at(
                written,
                format!("'{pattern}' bounds no void in this stage, so nothing is pressed"),
                "give the pressure in the stage from which on the group stands beside the void, or name what was excavated",
            ));
        }
        for face in faces {
            let Some((other, before)) = pressed.insert(face, (pattern, p)) else { continue };
            if let Some(at) = now
                && before != p
                && written_in(case, stage, other)
                && told.insert([other, pattern])
            {
                warnings.push(Diagnostic::at(
                    at,
                    format!("faces of '{pattern}' are pressed as '{other}' as well: the last word counts"),
                    "give the pressure of a face under one name",
                ));
            }
        }
    }
    acting.extend(pressed.into_iter().map(|(face, (_, p))| (face, tensor(p.on(mesh, face)))));
    acting
}

/// The elements of all groups that a pattern names.
fn in_groups<'m>(mesh: &'m Mesh, pattern: &str) -> impl Iterator<Item = u32> + use<'m> {
    let fitting: Vec<&Vec<u32>> = mesh
        .groups
        .iter()
        .filter(|(name, _)| pattern::matches(pattern, name))
        .map(|(_, elements)| elements)
        .collect();
    fitting.into_iter().flatten().copied()
}

/// What presses on faces.
#[derive(Clone, Copy, PartialEq)]
enum Press {
    /// As much everywhere \[Pa\].
    Even(f64),
    /// Water up to a level \[m\], of a weight per volume \[N/m³\].
    Water { level: f64, weight: f64 },
}

impl Press {
    /// The mean pressure \[Pa\] on a face, of its points by their areas.
    fn on(self, mesh: &Mesh, face: Face) -> f64 {
        match self {
            Press::Even(p) => p,
            Press::Water { level, weight } => {
                let (_, points) = face_points(mesh, face);
                let areas = points.iter().map(|point| {
                    let area = point.area.iter().map(|a| a * a).sum::<f64>().sqrt();
                    [area, area * weight * (level - point.at[2]).max(0.0)]
                });
                let [area, force] = areas.fold([0.0; 2], |sum, one| [sum[0] + one[0], sum[1] + one[1]]);
                force / area
            }
        }
    }
}

/// Whether a stage itself gives a pressure under this name.
fn written_in(case: &Case, stage: usize, pattern: &str) -> bool {
    let own = stage.checked_sub(1).map(|k| &case.stages[k]);
    let names = own.into_iter().flat_map(|stage| stage.pressures.iter().chain(&stage.water.filled));
    names.map(|(name, _)| name).any(|name| name.value == pattern)
}

/// The word for the top plane where groups stand.
const TOP: &str = "top";

/// Shear of the initial stress on side planes that rollers will hold, which these cannot carry.
pub(super) fn sides(
    initial: &[[f64; 6]],
    sides: [Side; 2],
    rollers: [bool; 2],
    places: &[Life],
    shown: &[u32],
    outer: &OuterFaces,
) -> Vec<(Face, [f64; 6])> {
    let mut acting = Vec::new();
    if initial.is_empty() {
        return acting;
    }
    for axis in 0..2 {
        if matches!(sides[axis], Side::Periodic | Side::Fixed) || !rollers[axis] {
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
pub fn check_pressures(case: &Case, mesh: &Mesh, problems: &mut Vec<Diagnostic>) {
    let written = case.stages.iter().flat_map(|stage| stage.pressures.iter().chain(&stage.water.filled));
    for (pattern, _) in written.filter(|(pattern, _)| pattern.value != TOP) {
        let _ = fitting(pattern, mesh, problems);
    }
}
