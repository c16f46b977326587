//! Planes of a case cut its generated mesh.

use super::places::plane;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use tremolite_case::{self as case, Diagnostic};
use tremolite_engine::hexahedra::hex;
use tremolite_engine::{Assembly, Body, Model, Phase, Problem, Stage, stable_step};
use tremolite_kernels::{Quadrature, elastic};
use tremolite_laws::shapes::hex8::element_frequencies;
use tremolite_laws::{Dimension, Moduli};
use tremolite_mesh::cut::{Bounds, Cut, CutError, cut};
use tremolite_mesh::{Element, Mesh};

/// Smallest share that a cut may leave of the step of single elements of the mesh without planes: less is a sliver. The mesh as a whole
/// keeps more, for nodes have the mass of all around them: half a brick alone has 0.45 of the brick's step, in a mesh of bricks 0.95 of the
/// mesh's; pieces that alone have 0.07 to 0.17 leave it 0.42 to 0.46.
const LEAST_STEP: f64 = 0.05;
/// Smallest share of the step of the mesh without planes that they may leave.
const LEAST_LEFT: f64 = 0.4;
/// Share of single elements from which on that is not asked: among others an element has its step or a longer one, the smallest without
/// planes up to a tenth longer than alone.
const ALONE: f64 = 0.5;
const WAY_OUT: &str = "move `through` by half an element, lower `near`, or mesh the ground with the planes in Gmsh and read it as [mesh.file] \
                       (docs/meshes.md)";
const CROSSING: &str = "here it crosses another plane: end one of them before the other by `extent`, or mesh the ground with both in Gmsh and \
                        read it as [mesh.file] (docs/meshes.md)";
/// Distance from a plane, in mean elements, within which an element is at its crossing with another.
const NEAR_CROSSING: f64 = 2.0;
/// Shares of the step and scaled Jacobians below which a cut is warned of.
const POOR_STEP: f64 = 0.1;
const POOR_JACOBIAN: f64 = 0.2;

/// Thickness of a seam over the extent of the elements beside it across it, from which on it is to be meshed.
const THICKEST: f64 = 0.5;

/// The groups that a plane makes.
pub fn groups_of(plane: &case::CutPlane) -> [String; 2] {
    ["above", "below"].map(|side| format!("{}.{side}", plane.name.value))
}

/// Cuts a mesh by the planes of a case; what is not possible is among the problems. Elements that it leaves poor are told of. Sides that are
/// `free` need not match one another.
pub fn cut_by(
    source: &case::Mesh,
    planes: &[case::CutPlane],
    free: [bool; 2],
    mesh: &mut Mesh,
    problems: &mut Vec<Diagnostic>,
) -> Option<Diagnostic> {
    let first = planes.first()?;
    let cuts: Vec<Cut> = planes
        .iter()
        .map(|p| Cut {
            name: p.name.value.clone(),
            plane: plane(&p.plane),
            extent: p.extent.as_ref().map(|extent| extent.value),
        })
        .collect();
    let (whole, soft) = bounds(source, mesh);
    let before = smallest(mesh, 0..mesh.elements.len() as u32);
    let uncut = step_of(mesh, &beside(mesh, &[before.1]));
    match cut(mesh, &cuts, &Bounds { whole: &whole, soft: &soft, free }) {
        Ok(done) => {
            problems.extend(planes.iter().filter_map(|plane| too_thick(plane, mesh)));
            let (after, at) = smallest(mesh, done.changed.iter().copied());
            let share = after / before.0;
            if share < LEAST_STEP {
                let [x, _, z] = tremolite_mesh::places::middle(mesh, at);
                problems.push(Diagnostic::new(
                    first.span.clone(),
                    format!(
                        "the planes would leave an element at x = {x:.1} m, z = {z:.1} m whose own stable step is {share:.2} of the smallest \
                         without them"
                    ),
                    WAY_OUT,
                ));
                return None;
            }
            let together = if share < ALONE { step_of(mesh, &done.changed) / uncut } else { 1.0 };
            if together < LEAST_LEFT {
                problems.push(Diagnostic::new(
                    first.span.clone(),
                    format!(
                        "the planes would leave {together:.2} of the stable step without them, less than {LEAST_LEFT}, by small pieces of elements"
                    ),
                    WAY_OUT,
                ));
                return None;
            }
            if share >= POOR_STEP && done.jacobian >= POOR_JACOBIAN {
                return None;
            }
            let said = format!(
                "planes moved nodes by up to {:.2} m: {} elements changed, of scaled Jacobians of {:.2} or more and stable steps, each alone, of \
                 {:.2} or more of the smallest without planes",
                done.moved,
                done.changed.len(),
                done.jacobian,
                share.min(1.0)
            );
            Some(Diagnostic::new(
                first.span.clone(),
                said,
                "move a plane by half an element if that is too poor",
            ))
        }
        Err(e) => {
            let at = planes.iter().find(|p| p.name.value == e.plane()).unwrap_or(first);
            let text = e.to_string();
            let (what, remedy) = text.split_once("; ").unwrap_or((&text, "change the plane"));
            let remedy = if crosses_there(&e, &cuts, mesh) { CROSSING } else { remedy };
            problems.push(Diagnostic::new(at.span.clone(), what, remedy));
            None
        }
    }
}

/// Whether an element is too poor where two planes cross.
fn crosses_there(error: &CutError, cuts: &[Cut], mesh: &Mesh) -> bool {
    let CutError::Poor { name, at, .. } = error else { return false };
    let Some(own) = cuts.iter().find(|cut| cut.name == *name) else { return false };
    let (low, high) = mesh.bounds();
    let volume: f64 = (0..3).map(|i| high[i] - low[i]).product();
    let element = (volume / mesh.elements.len().max(1) as f64).cbrt();
    let parallel = |a: [f64; 3], b: [f64; 3]| (0..3).map(|i| a[i] * b[i]).sum::<f64>().abs() > 0.99;
    cuts.iter().any(|other| {
        other.name != *name
            && !parallel(other.plane.normal, own.plane.normal)
            && other.plane.distance(*at).abs() < NEAR_CROSSING * element
    })
}

/// A seam is no interface where its plane's elements are small enough to mesh it.
fn too_thick(plane: &case::CutPlane, mesh: &Mesh) -> Option<Diagnostic> {
    let seam = plane.seam.as_ref()?;
    let at = super::places::plane(&plane.plane);
    let nodes = groups_of(plane).map(|group| -> BTreeSet<u32> {
        let elements = mesh.groups.get(&group).into_iter().flatten();
        elements.flat_map(|&e| mesh.elements[e as usize].nodes().to_vec()).collect()
    });
    let mut across: Vec<f64> = Vec::new();
    for &e in groups_of(plane).iter().filter_map(|group| mesh.groups.get(group)).flatten() {
        let of = mesh.elements[e as usize].nodes();
        if of.iter().any(|n| nodes.iter().all(|side| side.contains(n))) {
            let off = of.iter().map(|&n| at.distance(mesh.nodes[n as usize]));
            let ends = off.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), d| (a.min(d), b.max(d)));
            across.push(ends.1 - ends.0);
        }
    }
    across.sort_by(f64::total_cmp);
    let median = *across.get(across.len() / 2)?;
    let length = |x: f64| case::units::format(x, Dimension::LENGTH);
    (seam.thickness.value > THICKEST * median).then(|| {
        Diagnostic::at(
            &seam.thickness,
            format!(
                "the seam '{}' is {} thick, more than half of the elements beside it ({median:.2} m across it): it is rock to be meshed",
                plane.name.value,
                length(seam.thickness.value)
            ),
            "give its two walls as planes without `seam`, and its material by a [[region]] of the group between them \
             (docs/meshes.md#thin-seams)",
        )
    })
}

/// Elements that stay whole, linings and shotcrete of generated caverns, and groups whose borders may move: layers of rock, which are stairs
/// anyhow where they dip, and floors of benches inside a cavern.
fn bounds(source: &case::Mesh, mesh: &Mesh) -> (Vec<u32>, Vec<String>) {
    let case::Mesh::Caverns(made) = source else { return (Vec::new(), Vec::new()) };
    let mut whole: Vec<u32> = Vec::new();
    for (name, elements) in &mesh.groups {
        let Some((cavern, part)) = name.split_once('.') else { continue };
        let lined = made.caverns.iter().any(|c| c.name.value == cavern)
            && (part.starts_with("lining") || part.starts_with("shotcrete"));
        let opened = made.galleries.iter().any(|g| g.name.value == cavern) && part == "opening";
        if lined || opened {
            whole.extend(elements);
        }
    }
    whole.sort_unstable();
    whole.dedup();
    let bench = |name: &str| {
        let parts = name.split_once('.');
        parts.is_some_and(|(c, part)| {
            part.starts_with("bench") && made.caverns.iter().any(|cavern| cavern.name.value == c)
        })
    };
    let soft = mesh.groups.keys().filter(|name| name.starts_with("rock.") || bench(name));
    (whole, soft.cloned().collect())
}

/// A rock of all elements alike \[Pa, kg/m³\]: steps are compared.
fn rock() -> Moduli {
    Moduli::from_young_poisson(10e9, 0.25)
}

const DENSITY: f64 = 2700.0;

/// The smallest stable step of single elements, all of one rock \[s\], and the element.
fn smallest(mesh: &Mesh, elements: impl Iterator<Item = u32>) -> (f64, u32) {
    let elements: Vec<u32> = elements.collect();
    let steps = elements.par_chunks(64).map(|chunk| {
        let usable = chunk.iter().filter_map(|&e| Some((e, hex(mesh, e as usize).ok()?)));
        let (elements, shapes): (Vec<u32>, Vec<_>) = usable.unzip();
        let omegas = element_frequencies(&shapes, rock(), DENSITY, Quadrature::OnePoint);
        let steps = omegas.into_iter().zip(elements).map(|(omega, e)| (2.0 / omega, e));
        steps.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((f64::INFINITY, u32::MAX))
    });
    steps.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))).unwrap_or((f64::INFINITY, u32::MAX))
}

/// Some elements and those that share a node with them.
fn beside(mesh: &Mesh, elements: &[u32]) -> Vec<u32> {
    let nodes: BTreeSet<u32> = elements
        .iter()
        .filter_map(|&e| mesh.elements.get(e as usize))
        .flat_map(|e| e.nodes().to_vec())
        .collect();
    let touches = |e: &u32| mesh.elements[*e as usize].nodes().iter().any(|n| nodes.contains(n));
    (0..mesh.elements.len() as u32).filter(touches).collect()
}

/// The stable step \[s\] of some elements and those beside them together, all of one rock; infinite where they are no model.
fn step_of(mesh: &Mesh, elements: &[u32]) -> f64 {
    let mut number: BTreeMap<u32, u32> = BTreeMap::new();
    let mut part = Mesh::default();
    for element in beside(mesh, elements).into_iter().map(|e| mesh.elements[e as usize]) {
        let mut add = |&n: &u32| {
            *number.entry(n).or_insert_with(|| {
                part.nodes.push(mesh.nodes[n as usize]);
                part.nodes.len() as u32 - 1
            })
        };
        let own: Vec<u32> = element.nodes().iter().map(&mut add).collect();
        part.elements.push(Element::new(element.shape, &own));
    }
    let body = Body {
        name: "rock".into(),
        elements: (0..part.elements.len() as u32).collect(),
        material: elastic(rock()),
        density: DENSITY,
        quadrature: Quadrature::OnePoint,
        viscosity: 0.0,
    };
    let step = || {
        let model = Model::new(Problem::new(part, vec![body])).ok()?;
        let assembly = Assembly::new(&model).ok()?;
        let phase = Phase::of(&model, &assembly, Stage::Shaking).ok()?;
        Some(stable_step(&model, &assembly, &phase).dt)
    };
    step().unwrap_or(f64::INFINITY)
}
