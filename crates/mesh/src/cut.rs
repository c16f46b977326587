//! Planes that cut a mesh: nodes move onto the plane, and elements part along it.
//!
//! What is extruded along y is cut in its section by planes that strike along y. The plane is a line there, and a way of edges and
//! diagonals of the elements near it is looked for (`path.rs`): its nodes go onto the line, and a quadrilateral that it crosses becomes
//! two triangles. No node is added and no edge parted, so an element that the line passes by keeps its shape, and neighbours match by
//! themselves. What stays whole, a lining behind an interface, is passed: the way ends at its outer face and goes on from its inner one,
//! whose nodes slide along their outline.
//! Other planes and other meshes are cut in space (`solid.rs`), where what stays whole is divided as the rest but belongs to neither side.

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

use std::collections::{BTreeMap, BTreeSet};

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
    /// Elements that belong to neither side of it, ascending. A plane that strikes along y in a mesh that is the same all along it passes
    /// them by.
    pub whole: Vec<u32>,
}

impl Cut {
    /// A plane through all the mesh, which cuts all elements.
    pub fn through(name: &str, plane: Plane) -> Cut {
        Cut { name: name.to_owned(), plane, extent: None, whole: Vec::new() }
    }
}

/// Groups that planes go by.
#[derive(Clone, Debug, Default)]
pub struct Bounds<'a> {
    /// Linings and shotcrete: a plane in space takes the nodes through their thickness together.
    pub thin: &'a [u32],
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
    /// Of the plane that bends most: its place among the planes, the greatest distance \[m\] of its nodes from it, and where.
    pub bent: Option<(usize, f64, [f64; 3])>,
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
    let flags = |list: &[u32]| {
        let mut flags = vec![false; mesh.elements.len()];
        list.iter().for_each(|&e| flags[e as usize] = true);
        flags
    };
    // Of each plane, and of all what is thin: by the elements as they are divided.
    let mut whole: Vec<Vec<bool>> = cuts.iter().map(|cut| flags(&cut.whole)).collect();
    let mut thin = flags(bounds.thin);
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
    let extruded = Section::of(&work, &thin, bounds.soft, &[], false).is_ok();
    let mut others: Vec<usize> = Vec::new();
    let mut flat: Vec<(usize, Vec<[u32; 2]>)> = Vec::new();
    for (k, cut) in cuts.iter().enumerate() {
        if !extruded || cut.plane.normal[1].abs() > 1e-9 {
            others.push(k);
            continue;
        }
        let ways: Vec<Vec<[u32; 2]>> = flat.iter().map(|(_, way)| way.clone()).collect();
        match straightest(&work, cut, &whole[k], bounds.soft, &ways) {
            Ok(Trial { mesh, applied, way, .. }) => {
                let pieces: Vec<u32> = (work.elements.len()..mesh.elements.len())
                    .map(|piece| applied.origin(piece as u32))
                    .collect();
                for flags in whole.iter_mut().chain([&mut thin]) {
                    let own: Vec<bool> = pieces.iter().map(|&e| flags[e as usize]).collect();
                    flags.extend(own);
                }
                done.moved = done.moved.max(applied.moved);
                done.changed.extend(applied.changed);
                flat.push((k, way));
                work = mesh;
            }
            Err(CutError::NoWay { .. } | CutError::Poor { .. }) => others.push(k),
            Err(other) => return Err(other),
        }
    }
    if !flat.is_empty() {
        let ways: Vec<Vec<[u32; 2]>> = flat.iter().map(|(_, way)| way.clone()).collect();
        for (k, way) in &flat {
            let section = Section::of(&work, &whole[*k], bounds.soft, &ways, false);
            let section = section.map_err(|()| CutError::Section { name: cuts[*k].name.clone() })?;
            let sides = sides::of(&section, &work, &cuts[*k], &whole[*k], way);
            name(&mut work, &cuts[*k], sides)?;
        }
    }
    // The groups of a plane that ends have borders that are none.
    let ends = cuts.iter().filter(|cut| cut.extent.is_some());
    let ending: Vec<String> =
        ends.flat_map(|cut| ["above", "below"].map(|side| format!("{}.{side}", cut.name))).collect();
    let mut earlier: Vec<Plane> = flat.iter().map(|(k, _)| cuts[*k].plane).collect();
    for k in others {
        let made = in_space(&work, &cuts[k], &thin, bounds, &ending, &earlier)?;
        for flags in whole.iter_mut().chain([&mut thin]) {
            *flags = made.origin.iter().map(|&e| flags[e as usize]).collect();
        }
        done.moved = done.moved.max(made.moved);
        done.changed.extend(made.changed);
        work = made.mesh;
        let sides = made.sides.map(|list| list.into_iter().filter(|&e| !whole[k][e as usize]).collect());
        name(&mut work, &cuts[k], sides)?;
        earlier.push(cuts[k].plane);
    }
    let bends = cuts.iter().enumerate().filter_map(|(k, cut)| {
        let (off, at) = bend(&work, cut)?;
        Some((k, off, at))
    });
    done.bent = bends.max_by(|a, b| a.1.total_cmp(&b.1));
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
    thin: &[bool],
    bounds: &Bounds<'_>,
    ending: &[String],
    earlier: &[Plane],
) -> Result<solid::Made, CutError> {
    match solid::cut(work, cut, thin, &parts(work, ending), earlier, bounds.free) {
        Err(CutError::NoWay { .. } | CutError::Poor { .. }) if !bounds.soft.is_empty() => {
            solid::cut(work, cut, thin, &parts(work, &[bounds.soft, ending].concat()), earlier, bounds.free)
        }
        made => made,
    }
}

/// The greatest distance \[m\] from a plane of the nodes that both its sides have, and where; nothing if they have none.
fn bend(mesh: &Mesh, cut: &Cut) -> Option<(f64, [f64; 3])> {
    let [above, below] = ["above", "below"].map(|side| {
        let list = mesh.groups.get(&format!("{}.{side}", cut.name));
        let elements = list.into_iter().flatten();
        elements.flat_map(|&e| mesh.elements[e as usize].nodes().to_vec()).collect::<BTreeSet<u32>>()
    });
    let on = above.intersection(&below).map(|&n| mesh.nodes[n as usize]);
    on.map(|x| (cut.plane.distance(x).abs(), x)).max_by(|a, b| a.0.total_cmp(&b.0))
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

/// A mesh cut by one plane.
struct Trial {
    mesh: Mesh,
    applied: apply::Applied,
    /// The plane's way by nodes at the first y.
    way: Vec<[u32; 2]>,
    /// Greatest distance of its nodes from the plane \[m\].
    bend: f64,
}

/// A mesh cut by one plane. Soft borders stay where that leaves a way that keeps to the plane.
fn straightest(
    work: &Mesh,
    cut: &Cut,
    whole: &[bool],
    soft: &[String],
    ways: &[Vec<[u32; 2]>],
) -> Result<Trial, CutError> {
    let (low, high) = work.bounds();
    let straight = 1e-9 * (high[0] - low[0]).hypot(high[2] - low[2]);
    let stiff = one(work, cut, whole, soft, ways, false);
    match stiff {
        Ok(trial) if trial.bend <= straight => Ok(trial),
        Ok(trial) => Ok(match one(work, cut, whole, soft, ways, true) {
            Ok(loose) if loose.bend < trial.bend => loose,
            _ => trial,
        }),
        Err(CutError::NoWay { .. } | CutError::Poor { .. }) => one(work, cut, whole, soft, ways, true),
        Err(other) => Err(other),
    }
}

/// A mesh cut by one plane; `loose` lets soft borders move.
fn one(
    work: &Mesh,
    cut: &Cut,
    whole: &[bool],
    soft: &[String],
    ways: &[Vec<[u32; 2]>],
    loose: bool,
) -> Result<Trial, CutError> {
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
    let off = |[x, z]: &[f64; 2]| cut.plane.distance([*x, 0.0, *z]).abs();
    let bend = way.targets.values().map(off).fold(0.0, f64::max);
    Ok(Trial { mesh: trial, applied, way: way.nodes(&section), bend })
}
