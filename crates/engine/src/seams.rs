//! From interfaces to seams: nodes split, faces paired, in the model and in what stands outside its sides.

use crate::error::ModelError;
use crate::interface::{Interface, Seam};
use crate::life::{Life, Stage};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use tremolite_mesh::pairs::{PairShape, pairs};
use tremolite_mesh::split::{Cut, Split, SplitError, split};
use tremolite_mesh::{Element, Face, Mesh};

/// What became of a problem's interfaces.
pub struct Seams {
    pub seams: Vec<Seam>,
    /// The node that each node was before; empty without interfaces.
    pub origin: Vec<u32>,
    pub places: Vec<u32>,
}

/// Lives of elements and of those that they took over from: a pair of an interface does not begin anew with a material.
pub fn place_lives(lives: &[Life], successors: &HashMap<u32, u32>) -> Vec<Life> {
    let first = |e: usize| {
        let mut e = e;
        // Each takes over from another that was born before it.
        while let Some(&earlier) =
            successors.get(&(e as u32)).filter(|&&other| lives[other as usize] < lives[e])
        {
            e = earlier as usize;
        }
        e
    };
    lives.iter().enumerate().map(|(e, life)| Life { born: lives[first(e)].born, gone: life.gone }).collect()
}

/// Gives elements that others take over from the nodes of those: what is split goes by what stands in the end, and what an element
/// was before its material changed lies on the same side of an interface.
pub fn keep_sides(mesh: &mut Mesh, successors: &HashMap<u32, u32>) {
    let earlier: BTreeSet<u32> = successors.values().copied().collect();
    for last in successors.keys().filter(|later| !earlier.contains(later)) {
        let nodes = mesh.elements[*last as usize].nodes;
        let chain = std::iter::successors(Some(*last), |e| successors.get(e).copied());
        // No chain is longer than all of them, whatever a program states.
        chain.skip(1).take(successors.len()).for_each(|e| mesh.elements[e as usize].nodes = nodes);
    }
}

/// Splits the nodes of interfaces and makes their pairs.
pub fn of_problem(
    mesh: &mut Mesh,
    interfaces: Vec<Interface>,
    body_of: &[Option<usize>],
    lives: &[Life],
    initial: &[[f64; 6]],
) -> Result<Seams, ModelError> {
    if interfaces.is_empty() {
        let places = (0..mesh.nodes.len() as u32).collect();
        return Ok(Seams { seams: Vec::new(), origin: Vec::new(), places });
    }
    let there: Vec<bool> = body_of.iter().map(Option::is_some).collect();
    let cuts: Vec<Cut> = interfaces
        .iter()
        .map(|interface| Cut { name: &interface.name, sides: interface.sides.each_ref().map(Vec::as_slice) })
        .collect();
    let Split { faces, origin, places, ends } = split(mesh, &cuts, &there)?;
    let seams = interfaces
        .into_iter()
        .zip(faces)
        .zip(ends)
        .map(|((interface, faces), ends)| {
            let (pairs, lives) = pairs_by_life(mesh, &faces, interface.corner, lives);
            let mut seam = Seam {
                of: None,
                corner: interface.corner,
                pairs,
                lives,
                tractions: Vec::new(),
                name: interface.name,
                law: interface.law,
                values: interface.values,
                pressure: interface.pressure,
                damping: interface.damping,
                limit: interface.limit,
                viscosity: interface.viscosity,
                faces,
                ends,
            };
            seam.load(initial);
            seam
        })
        .collect();
    Ok(Seams { seams, origin, places })
}

/// Pairs of faces that are there at the same time, with their lives: the pairs of one life behind those of another.
fn pairs_by_life(
    mesh: &Mesh,
    faces: &[[Face; 2]],
    corner: f64,
    lives: &[Life],
) -> (Vec<PairShape>, Vec<Life>) {
    let mut of_life: BTreeMap<Life, Vec<u32>> = BTreeMap::new();
    for (f, sides) in (0u32..).zip(faces) {
        let [a, b] = sides.map(|face| lives[face.element as usize]);
        of_life.entry(a.and(&b)).or_default().push(f);
    }
    let (mut all, mut all_lives) = (Vec::new(), Vec::new());
    for (life, own) in of_life {
        let faces: Vec<[Face; 2]> = own.iter().map(|&f| faces[f as usize]).collect();
        let mut found = pairs(mesh, &faces, corner);
        for (face, _) in found.iter_mut().flat_map(|pair| &mut pair.corners) {
            *face = own[*face as usize];
        }
        all_lives.extend(vec![life; found.len()]);
        all.extend(found);
    }
    (all, all_lives)
}

/// Splits elements that stand outside a side where interfaces run through them, as those of the model that they were made of.
/// Most of their nodes are split already, since the model's were. `sides` are those of the interfaces, ascending, and `lives` those
/// that pairs go by.
///
/// # Errors
/// If more than two elements have the same face.
pub fn outside(
    mesh: &mut Mesh,
    elements: &[u32],
    parents: &[u32],
    sides: &[[Vec<u32>; 2]],
    seams: &[Seam],
    lives: &[Life],
    initial: &[[f64; 6]],
) -> Result<Vec<Seam>, ModelError> {
    let mut local = Part::of(mesh, elements);
    let there: Vec<bool> = elements.iter().map(|&e| lives[e as usize].holds(Stage::Shaking)).collect();
    let own = |of: &[u32]| -> Vec<u32> {
        let is_of = |e: &u32| of.binary_search(&parents[*e as usize]).is_ok();
        (0u32..).zip(elements).filter(|(_, e)| is_of(e)).map(|(k, _)| k).collect()
    };
    let both: Vec<[Vec<u32>; 2]> = sides.iter().map(|sides| sides.each_ref().map(|side| own(side))).collect();
    let mut wanted: BTreeSet<usize> =
        (0..sides.len()).filter(|&i| both[i].iter().all(|side| !side.is_empty())).collect();
    let faces = loop {
        let cut = |&i: &usize| Cut { name: &seams[i].name, sides: both[i].each_ref().map(Vec::as_slice) };
        let cuts: Vec<Cut> = wanted.iter().map(cut).collect();
        match split(&mut local.mesh, &cuts, &there) {
            Ok(Split { faces, .. }) => break faces,
            // The two sides may stand out here without touching.
            Err(SplitError::Apart { name, .. }) => wanted.retain(|&i| seams[i].name != name),
            Err(error) => return Err(error.into()),
        }
    };
    local.put_back(mesh, elements);
    let seam = |(i, faces): (usize, Vec<[Face; 2]>)| {
        let whole = |face: Face| Face { element: elements[face.element as usize], ..face };
        let faces: Vec<[Face; 2]> = faces.into_iter().map(|sides| sides.map(whole)).collect();
        let of = &seams[i];
        let (pairs, lives) = pairs_by_life(mesh, &faces, of.corner, lives);
        let mut seam = Seam {
            of: Some(i),
            name: format!("{} (free field)", of.name),
            pairs,
            lives,
            tractions: Vec::new(),
            faces,
            ends: Vec::new(),
            ..of.clone()
        };
        seam.load(initial);
        seam
    };
    Ok(wanted.into_iter().zip(faces).map(seam).collect())
}

/// Some elements of a mesh as a mesh.
struct Part {
    mesh: Mesh,
    /// Node of the part -> node of the mesh.
    nodes: Vec<u32>,
}

impl Part {
    fn of(mesh: &Mesh, elements: &[u32]) -> Self {
        let mut part = Part { mesh: Mesh::default(), nodes: Vec::new() };
        let mut known: HashMap<u32, u32> = HashMap::new();
        for &e in elements {
            let element = &mesh.elements[e as usize];
            let nodes: Vec<u32> = element
                .nodes()
                .iter()
                .map(|&n| {
                    *known.entry(n).or_insert_with(|| {
                        part.nodes.push(n);
                        part.mesh.nodes.push(mesh.nodes[n as usize]);
                        part.nodes.len() as u32 - 1
                    })
                })
                .collect();
            part.mesh.elements.push(Element::new(element.shape, &nodes));
        }
        part
    }

    /// Takes over what was split: new nodes go behind those of the mesh.
    fn put_back(&mut self, mesh: &mut Mesh, elements: &[u32]) {
        for &at in &self.mesh.nodes[self.nodes.len()..] {
            self.nodes.push(mesh.nodes.len() as u32);
            mesh.nodes.push(at);
        }
        for (element, &e) in self.mesh.elements.iter().zip(elements) {
            mesh.elements[e as usize].nodes = element.nodes.map(|n| self.nodes[n as usize]);
        }
    }
}
