//! Planes that cut a mesh: nodes move onto the plane, and elements part along it.
//!
//! What is extruded along y is cut in its section by planes that strike along y. The plane is a line there, and a way of edges and
//! diagonals of the elements near it is looked for (`path.rs`): its nodes go onto the line, and a quadrilateral that it crosses becomes
//! two triangles. No node is added and no edge parted, so an element that the line passes by keeps its shape, and neighbours match by
//! themselves. What must stay whole, linings, is passed: the way ends at its outer face and goes on from its inner one, whose nodes slide
//! along their outline.
//! Other planes and other meshes are cut in space (`solid.rs`), where linings are divided as the rest but belong to neither side.

mod apply;
mod curve;
mod error;
mod path;
mod relax;
mod section;
mod sides;
mod solid;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use crate::Mesh;
use crate::places::middle;
use crate::plane::Plane;
use crate::quality;

pub use error::CutError;

use section::Section;

/// Smallest scaled Jacobian that a cut may leave.
pub const LEAST_JACOBIAN: f64 = 0.15;
/// How many rings of elements beside a plane may move with it.
const MOST_RINGS: usize = 3;

/// A plane that cuts a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Cut {
    /// First part of the names of its groups.
    pub name: String,
    pub plane: Plane,
    /// How far it reaches from its point up and down the dip \[m\]; nothing: through all the mesh.
    pub extent: Option<f64>,
}

/// Groups that planes go by.
#[derive(Clone, Debug, Default)]
pub struct Bounds<'a> {
    /// Elements that belong to neither side of a plane, and that none parts which strikes along y in a mesh that is the same all along it.
    pub whole: &'a [u32],
    /// Groups whose borders may move where a plane needs it, such as layers and benches.
    pub soft: &'a [String],
    /// Of the sides normal to x and to y, whether the two need not match: planes that are cut in space keep their place there, where else
    /// they may bend beside a side so that the opposite one fits.
    pub free: [bool; 2],
}

/// What cutting has done.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Done {
    /// Elements whose nodes moved, or that were parted, ascending.
    pub changed: Vec<u32>,
    /// Greatest way of a node \[m\].
    pub moved: f64,
    /// Smallest scaled Jacobian of what changed.
    pub jacobian: f64,
}

/// Cuts a mesh by planes, one after the other, and adds the groups `NAME.above` and `NAME.below` of each: the elements that are not
/// whole, by the side on which they lie; of a plane with an extent those that have a face on it.
///
/// # Errors
/// See [`CutError`]. Then the mesh is as it was.
pub fn cut(mesh: &mut Mesh, cuts: &[Cut], bounds: &Bounds<'_>) -> Result<Done, CutError> {
    if cuts.is_empty() {
        return Ok(Done { jacobian: f64::INFINITY, ..Done::default() });
    }
    let mut whole = vec![false; mesh.elements.len()];
    bounds.whole.iter().for_each(|&e| whole[e as usize] = true);
    for cut in cuts {
        for side in ["above", "below"] {
            let group = format!("{}.{side}", cut.name);
            if mesh.groups.contains_key(&group) {
                return Err(CutError::Known { name: cut.name.clone(), group });
            }
        }
    }
    let mut work = mesh.clone();
    let mut done = Done { jacobian: f64::INFINITY, ..Done::default() };
    let extruded = Section::of(&work, &whole, bounds.soft, &[], false).is_ok();
    let mut others: Vec<&Cut> = Vec::new();
    let mut flat: Vec<(&Cut, Vec<[u32; 2]>)> = Vec::new();
    for cut in cuts {
        if !extruded || cut.plane.normal[1].abs() > 1e-9 {
            others.push(cut);
            continue;
        }
        let ways: Vec<Vec<[u32; 2]>> = flat.iter().map(|(_, way)| way.clone()).collect();
        // Soft borders stay where that leaves a way.
        let made = match one(&work, cut, &whole, bounds.soft, &ways, false) {
            Err(CutError::NoWay { .. } | CutError::Poor { .. }) => {
                one(&work, cut, &whole, bounds.soft, &ways, true)
            }
            made => made,
        };
        match made {
            Ok((trial, applied, way)) => {
                whole.resize(trial.elements.len(), false);
                done.moved = done.moved.max(applied.moved);
                done.changed.extend(applied.changed);
                flat.push((cut, way));
                work = trial;
            }
            Err(CutError::NoWay { .. } | CutError::Poor { .. }) => others.push(cut),
            Err(other) => return Err(other),
        }
    }
    if let Some((first, _)) = flat.first() {
        let ways: Vec<Vec<[u32; 2]>> = flat.iter().map(|(_, way)| way.clone()).collect();
        let section = Section::of(&work, &whole, bounds.soft, &ways, false);
        let section = section.map_err(|()| CutError::Section { name: first.name.clone() })?;
        for (cut, way) in &flat {
            let sides = sides::of(&section, &work, cut, &whole, way);
            name(&mut work, cut, sides)?;
        }
    }
    // The groups of a plane that ends have borders that are none.
    let ends = cuts.iter().filter(|cut| cut.extent.is_some());
    let ending: Vec<String> =
        ends.flat_map(|cut| ["above", "below"].map(|side| format!("{}.{side}", cut.name))).collect();
    let mut earlier: Vec<Plane> = flat.iter().map(|(cut, _)| cut.plane).collect();
    for cut in others {
        let made = in_space(&work, cut, &whole, bounds, &ending, &earlier)?;
        whole = made.origin.iter().map(|&e| whole[e as usize]).collect();
        done.moved = done.moved.max(made.moved);
        done.changed.extend(made.changed);
        work = made.mesh;
        let sides = made.sides.map(|list| list.into_iter().filter(|&e| !whole[e as usize]).collect());
        name(&mut work, cut, sides)?;
        earlier.push(cut.plane);
    }
    done.changed.sort_unstable();
    done.changed.dedup();
    done.jacobian = quality::summary_of(&work, done.changed.iter().copied()).min_scaled_jacobian;
    *mesh = work;
    Ok(done)
}

/// Names the two sides of a plane.
fn name(mesh: &mut Mesh, cut: &Cut, sides: [Vec<u32>; 2]) -> Result<(), CutError> {
    for (side, list) in ["above", "below"].into_iter().zip(sides) {
        if list.is_empty() {
            return Err(CutError::Misses { name: cut.name.clone() });
        }
        mesh.groups.insert(format!("{}.{side}", cut.name), list);
    }
    Ok(())
}

/// A mesh cut by one plane in space; soft borders stay where that serves.
fn in_space(
    work: &Mesh,
    cut: &Cut,
    whole: &[bool],
    bounds: &Bounds<'_>,
    ending: &[String],
    earlier: &[Plane],
) -> Result<solid::Made, CutError> {
    match solid::cut(work, cut, whole, &parts(work, ending), earlier, bounds.free) {
        Err(CutError::NoWay { .. } | CutError::Poor { .. }) if !bounds.soft.is_empty() => {
            solid::cut(work, cut, whole, &parts(work, &[bounds.soft, ending].concat()), earlier, bounds.free)
        }
        made => made,
    }
}

/// What part each element belongs to, by all groups but some.
fn parts(mesh: &Mesh, but: &[String]) -> Vec<u32> {
    let mut names: Vec<Vec<u32>> = vec![Vec::new(); mesh.elements.len()];
    for (g, (_, list)) in (0..).zip(mesh.groups.iter().filter(|(name, _)| !but.contains(name))) {
        list.iter().for_each(|&e| names[e as usize].push(g));
    }
    let mut known: BTreeMap<Vec<u32>, u32> = BTreeMap::new();
    let part = |names: Vec<u32>| {
        let next = known.len() as u32;
        *known.entry(names).or_insert(next)
    };
    names.into_iter().map(part).collect()
}

/// A mesh cut by one plane, with the plane's way by nodes at the first y; `loose` lets soft borders move.
fn one(
    work: &Mesh,
    cut: &Cut,
    whole: &[bool],
    soft: &[String],
    ways: &[Vec<[u32; 2]>],
    loose: bool,
) -> Result<(Mesh, apply::Applied, Vec<[u32; 2]>), CutError> {
    let section = Section::of(work, whole, soft, ways, loose);
    let section = section.map_err(|()| CutError::Section { name: cut.name.clone() })?;
    let way = path::find(&section, cut)?;
    let mut best: Option<(f64, Mesh, apply::Applied)> = None;
    // Elements beside the plane take some of the motion where that serves them.
    for rings in 0..=MOST_RINGS {
        let moves = relax::spread(&section, &way, rings);
        let mut trial = work.clone();
        let applied = apply::apply(&mut trial, &section, &way, &moves);
        let score = apply::score(work, &trial, &applied);
        if best.as_ref().is_none_or(|b| score > 1.02 * b.0) {
            best = Some((score, trial, applied));
        }
    }
    let Some((_, trial, applied)) = best else { return Err(CutError::Misses { name: cut.name.clone() }) };
    let worst = quality::summary_of(&trial, applied.changed.iter().copied());
    if worst.min_scaled_jacobian.is_nan() || worst.min_scaled_jacobian < LEAST_JACOBIAN {
        let at = worst.worst.map_or(cut.plane.through, |e| middle(&trial, e));
        return Err(CutError::Poor { name: cut.name.clone(), jacobian: worst.min_scaled_jacobian, at });
    }
    Ok((trial, applied, way.nodes(&section)))
}
