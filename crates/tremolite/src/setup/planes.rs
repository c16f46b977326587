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
use tremolite_mesh::cut::{Bounds, Cut, CutError, Done, cut};
use tremolite_mesh::topology::{all_faces, exterior_faces, face_key};
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
const WAY_OUT: &str = "move `through` by half an element, lower `size_near`, or mesh the ground with the planes in Gmsh and read it as [mesh.file] \
                       (docs/meshes.md)";
const CROSSING: &str = "here it crosses another plane: end one of them before the other by `extent`, or mesh the ground with both in Gmsh and \
                        read it as [mesh.file] (docs/meshes.md)";
/// Distance from a plane, in mean elements, within which an element is at its crossing with another.
const NEAR_CROSSING: f64 = 2.0;
/// Shares of the step and scaled Jacobians below which a cut is warned of.
const POOR_STEP: f64 = 0.1;
const POOR_JACOBIAN: f64 = 0.2;
/// Share of the elements at a node by which a plane may miss it before that is warned of.
const BEND: f64 = 0.02;

/// Thickness of a seam over the extent of the elements beside it across it, from which on it is to be meshed.
const THICKEST: f64 = 0.5;

/// The groups that a plane makes.
pub fn groups_of(plane: &case::CutPlane) -> [String; 2] {
    ["above", "below"].map(|side| format!("{}.{side}", plane.name.value))
}

/// Cuts a mesh by the planes of a case; what is not possible is among the problems. Elements that it leaves poor are told of, and planes
/// that bend. Linings stay whole, and shotcrete that `interfaces` separate from the rock. Sides that are `free` need not match one another.
pub fn cut_by(
    source: &case::Mesh,
    planes: &[case::CutPlane],
    interfaces: &[case::Interface],
    free: [bool; 2],
    mesh: &mut Mesh,
    problems: &mut Vec<Diagnostic>,
) -> Vec<Diagnostic> {
    let Some(first) = planes.first() else { return Vec::new() };
    let thin = Thin::of(source, interfaces, mesh);
    let cuts: Vec<Cut> = planes
        .iter()
        .map(|p| Cut {
            name: p.name.value.clone(),
            plane: plane(&p.plane),
            extent: p.extent.as_ref().map(|extent| extent.value),
            whole: if p.whole || !opens(p, interfaces) { thin.linings.clone() } else { thin.behind.clone() },
        })
        .collect();
    let soft = soft(source, mesh);
    let before = smallest(mesh, 0..mesh.elements.len() as u32);
    let uncut = step_of(mesh, &beside(mesh, &[before.1]));
    match cut(mesh, &cuts, &Bounds { thin: &thin.all, soft: &soft, free }) {
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
                return Vec::new();
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
                return Vec::new();
            }
            let mut warnings: Vec<Diagnostic> = bends(planes, &done, mesh).into_iter().collect();
            if share >= POOR_STEP && done.jacobian >= POOR_JACOBIAN {
                return warnings;
            }
            let said = format!(
                "planes moved nodes by up to {:.2} m: {} elements changed, of scaled Jacobians of {:.2} or more and stable steps, each alone, of \
                 {:.2} or more of the smallest without planes",
                done.moved,
                done.changed.len(),
                done.jacobian,
                share.min(1.0)
            );
            warnings.push(Diagnostic::new(
                first.span.clone(),
                said,
                "move a plane by half an element if that is too poor",
            ));
            warnings
        }
        Err(e) => {
            let at = planes.iter().find(|p| p.name.value == e.plane()).unwrap_or(first);
            let text = e.to_string();
            let (what, remedy) = text.split_once("; ").unwrap_or((&text, "change the plane"));
            let remedy = if crosses_there(&e, &cuts, mesh) { CROSSING } else { remedy };
            let what = format!("{what}{}", flat_there(&e, &thin, mesh).unwrap_or_default());
            problems.push(Diagnostic::new(at.span.clone(), what, remedy));
            Vec::new()
        }
    }
}

/// Flat elements of a lining or of shotcrete where a plane cannot be meshed, as the end of a sentence.
fn flat_there(error: &CutError, thin: &Thin, mesh: &Mesh) -> Option<String> {
    let CutError::Poor { at, .. } = error else { return None };
    let from = |e: u32| {
        let x = tremolite_mesh::places::middle(mesh, e);
        (0..3).map(|i| (x[i] - at[i]).powi(2)).sum::<f64>()
    };
    let nearest = (0..mesh.elements.len() as u32).min_by(|&a, &b| from(a).total_cmp(&from(b)))?;
    thin.all.binary_search(&nearest).ok()?;
    let groups = mesh.groups.iter().filter(|(_, elements)| elements.binary_search(&nearest).is_ok());
    let (group, _) = groups.min_by_key(|(_, elements)| elements.len())?;
    let nodes = mesh.elements[nearest as usize].nodes();
    let edge = |&[a, b]: &[u32; 2]| {
        let [a, b] = [a, b].map(|n| mesh.nodes[n as usize]);
        (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
    };
    let pairs = (0..nodes.len()).flat_map(|i| (0..i).map(move |j| [nodes[i], nodes[j]]));
    let lengths: Vec<f64> = pairs.map(|pair| edge(&pair)).filter(|&length| length > 0.0).collect();
    let [shortest, longest] =
        [lengths.iter().copied().reduce(f64::min)?, lengths.iter().copied().reduce(f64::max)?];
    Some(format!(". That element of '{group}' is {shortest:.2} m thin, with a diagonal of {longest:.1} m"))
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

/// Whether an interface lies between the sides of a plane.
fn opens(plane: &case::CutPlane, interfaces: &[case::Interface]) -> bool {
    let [above, below] = groups_of(plane);
    let names = |side: &[case::Spanned<String>], group: &str| {
        side.iter().any(|name| case::pattern::matches(&name.value, group))
    };
    let between = |interface: &case::Interface| {
        let [one, two] = &interface.between;
        interface.contact.is_some()
            && ((names(one, &above) && names(two, &below)) || (names(one, &below) && names(two, &above)))
    };
    plane.seam.is_some() || interfaces.iter().any(between)
}

/// The plane that bends most, where that is by more than a share of the elements there.
fn bends(planes: &[case::CutPlane], done: &Done, mesh: &Mesh) -> Option<Diagnostic> {
    let (plane, off, at) = done.bent?;
    let plane = &planes[plane];
    let near = |e: &Element| e.nodes().iter().any(|&n| mesh.nodes[n as usize] == at);
    let size = |e: &Element| {
        let of = e.nodes().iter().map(|&n| mesh.nodes[n as usize]);
        let ends = of.fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |[low, high], x| {
            [std::array::from_fn(|i| low[i].min(x[i])), std::array::from_fn(|i| high[i].max(x[i]))]
        });
        (0..3).map(|i| ends[1][i] - ends[0][i]).fold(0.0, f64::max)
    };
    let largest = mesh.elements.iter().filter(|e| near(e)).map(size).fold(0.0, f64::max);
    (off > BEND * largest).then(|| {
        let [x, y, z] = at;
        Diagnostic::new(
            plane.span.clone(),
            format!(
                "plane '{}' bends: {off:.2} m off its place at ({x:.1}, {y:.1}, {z:.1}) m, a corner whose node cannot move",
                plane.name.value
            ),
            "move `through` by half an element, or lower `size_near`",
        )
    })
}

/// Elements of linings and of shotcrete in generated caverns, ascending.
struct Thin {
    /// With those of the rock that a gallery takes out of them.
    all: Vec<u32>,
    linings: Vec<u32>,
    /// Linings, and shotcrete that an interface separates from the rock.
    behind: Vec<u32>,
}

impl Thin {
    fn of(source: &case::Mesh, interfaces: &[case::Interface], mesh: &Mesh) -> Thin {
        let mut thin = Thin { all: Vec::new(), linings: Vec::new(), behind: Vec::new() };
        let case::Mesh::Caverns(made) = source else { return thin };
        let collect = |takes: &dyn Fn(&str) -> bool| -> BTreeSet<u32> {
            let groups = mesh.groups.iter().filter(|(name, _)| takes(name));
            groups.flat_map(|(_, elements)| elements.iter().copied()).collect()
        };
        let openings = collect(&|name| {
            made.galleries.iter().any(|gallery| name == format!("{}.opening", gallery.name.value))
        });
        let benches = collect(&|name| is_bench(made, name));
        let of_kind = |cavern: &str, kind: &str| {
            collect(&|name| {
                name.split_once('.').is_some_and(|(c, part)| c == cavern && part.starts_with(kind))
            })
        };
        let joint = Separated::by(interfaces, mesh);
        let mut linings = BTreeSet::new();
        let mut behind = BTreeSet::new();
        for cavern in &made.caverns {
            let [sprayed, lining] = ["shotcrete", "lining"].map(|kind| of_kind(&cavern.name.value, kind));
            // What lies inside the shotcrete does not count.
            let (mut shared, mut separated) = (0, 0);
            for [e, other] in joint.neighbours(mesh, &sprayed) {
                if !benches.contains(&other) && !lining.contains(&other) {
                    *(if joint.apart([e, other]) { &mut separated } else { &mut shared }) += 1;
                }
            }
            if separated > shared {
                behind.extend(&sprayed);
            }
            behind.extend(&lining);
            linings.extend(sprayed.into_iter().chain(lining));
        }
        thin.all = linings.union(&openings).copied().collect();
        thin.linings = linings.into_iter().collect();
        thin.behind = behind.into_iter().collect();
        thin
    }
}

/// The sides of interfaces, as elements of the mesh before planes cut it.
struct Separated {
    sides: Vec<[BTreeSet<u32>; 2]>,
}

impl Separated {
    fn by(interfaces: &[case::Interface], mesh: &Mesh) -> Separated {
        let side = |names: &[case::Spanned<String>]| -> BTreeSet<u32> {
            let named = |group: &str| names.iter().any(|name| case::pattern::matches(&name.value, group));
            mesh.groups.iter().filter(|(group, _)| named(group)).flat_map(|(_, list)| list.clone()).collect()
        };
        let open = interfaces.iter().filter(|interface| interface.contact.is_some());
        Separated {
            sides: open.map(|interface| interface.between.each_ref().map(|names| side(names))).collect(),
        }
    }

    /// Whether an interface lies between two elements.
    fn apart(&self, [a, b]: [u32; 2]) -> bool {
        let between = |[one, two]: &[BTreeSet<u32>; 2]| {
            (one.contains(&a) && two.contains(&b)) || (one.contains(&b) && two.contains(&a))
        };
        self.sides.iter().any(between)
    }

    /// Elements of a body with each that has a face in common with them and is not of the body.
    fn neighbours(&self, mesh: &Mesh, own: &BTreeSet<u32>) -> Vec<[u32; 2]> {
        let own_list: Vec<u32> = own.iter().copied().collect();
        let outer = exterior_faces(mesh, Some(&own_list));
        let keys: BTreeMap<[u32; 4], u32> =
            outer.into_iter().map(|face| (face_key(mesh, face), face.element)).collect();
        let others = all_faces(mesh, None).filter(|face| !own.contains(&face.element));
        others.filter_map(|face| Some([*keys.get(&face_key(mesh, face))?, face.element])).collect()
    }
}

fn is_bench(made: &case::Caverns, name: &str) -> bool {
    name.split_once('.').is_some_and(|(c, part)| {
        part.starts_with("bench") && made.caverns.iter().any(|cavern| cavern.name.value == c)
    })
}

/// Groups whose borders may move: layers of rock, which are stairs anyhow where they dip, floors of benches inside a cavern, and borders
/// of linings and shotcrete between benches.
fn soft(source: &case::Mesh, mesh: &Mesh) -> Vec<String> {
    let case::Mesh::Caverns(made) = source else { return Vec::new() };
    let numbered = |name: &str| {
        name.split_once('.').is_some_and(|(c, part)| {
            let number = ["lining", "shotcrete"].iter().find_map(|kind| part.strip_prefix(kind));
            number.is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()))
                && made.caverns.iter().any(|cavern| cavern.name.value == c)
        })
    };
    let may = |name: &&String| name.starts_with("rock.") || is_bench(made, name) || numbered(name);
    mesh.groups.keys().filter(may).cloned().collect()
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
