//! From interfaces to seams: nodes split, faces paired, in the model and in what stands outside its sides.

use crate::error::ModelError;
use crate::interface::{Interface, Seam};
use crate::life::{Life, Stage};
use crate::rims::{Joint, Rims};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::ops::Range;
use tremolite_mesh::pairs::pairs;
use tremolite_mesh::split::{Cut, Split, SplitError, split};
use tremolite_mesh::{Element, Face, Mesh};

/// What became of a problem's interfaces.
pub struct Seams {
    pub seams: Vec<Seam>,
    /// The node that each node was before; empty without interfaces.
    pub origin: Vec<u32>,
    pub places: Vec<u32>,
    /// Copies that move as one for a time.
    pub joints: Vec<Joint>,
}

/// What interfaces are made from besides the mesh.
#[derive(Clone, Copy)]
pub struct Standing<'a> {
    /// Whether an element is made of something.
    pub solid: &'a dyn Fn(u32) -> bool,
    /// Those that pairs go by ([`place_lives`]).
    pub lives: &'a [Life],
    pub successors: &'a HashMap<u32, u32>,
    /// Stress \[Pa\] of each element before anything moves; empty for none.
    pub initial: &'a [[f64; 6]],
}

impl Standing<'_> {
    /// When each of some elements is there, for the split: of those that take over from one another the last stands for all.
    fn times(&self, elements: impl Iterator<Item = u32>) -> Vec<Range<u32>> {
        let earlier: BTreeSet<u32> = self.successors.values().copied().collect();
        let there = |e: &u32| (self.solid)(*e) && !earlier.contains(e);
        elements.map(|e| if there(&e) { self.lives[e as usize].times() } else { 0..0 }).collect()
    }

    /// Copies that move as one for a time, with that time.
    fn joints(&self, of: &[tremolite_mesh::split::Joint]) -> Vec<Joint> {
        of.iter()
            .map(|joint| {
                let [a, b] = joint.elements.map(|e| self.lives[e as usize]);
                Joint { nodes: joint.nodes, life: a.and(&b) }
            })
            .collect()
    }
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
    standing: Standing,
) -> Result<Seams, ModelError> {
    if interfaces.is_empty() {
        let places = (0..mesh.nodes.len() as u32).collect();
        return Ok(Seams { seams: Vec::new(), origin: Vec::new(), places, joints: Vec::new() });
    }
    let times = standing.times(0..mesh.elements.len() as u32);
    let cuts: Vec<Cut> = interfaces
        .iter()
        .map(|interface| Cut { name: &interface.name, sides: interface.sides.each_ref().map(Vec::as_slice) })
        .collect();
    let Split { faces, origin, places, ends, joints } = split(mesh, &cuts, &times)?;
    let joints = standing.joints(&joints);
    let rims = Rims::of(&joints);
    let seams = interfaces
        .into_iter()
        .zip(faces)
        .zip(ends)
        .map(|((interface, faces), ends)| {
            let bare = Seam {
                of: None,
                corner: interface.corner,
                pairs: Vec::new(),
                lives: Vec::new(),
                freed: Vec::new(),
                standing: Vec::new(),
                tractions: Vec::new(),
                name: interface.name,
                law: interface.law,
                values: interface.values,
                pressure: interface.pressure,
                damping: interface.damping,
                limit: interface.limit,
                viscosity: interface.viscosity,
                water: interface.water,
                faces,
                ends,
            };
            with_pairs(bare, mesh, &rims, standing)
        })
        .collect();
    Ok(Seams { seams, origin, places, joints })
}

/// An interface with the pairs of its faces, where nothing holds their nodes together: those of one time behind those of another.
fn with_pairs(mut seam: Seam, mesh: &Mesh, rims: &Rims, standing: Standing) -> Seam {
    let lives = standing.lives;
    seam.standing = seam
        .faces
        .iter()
        .map(|sides| {
            let [a, b] = sides.map(|face| lives[face.element as usize]);
            a.and(&b)
        })
        .collect();
    // Rock that is excavated may have closed the interface where nothing does any more.
    let lasting = seam.faces.iter().zip(&seam.standing).filter(|(_, life)| life.holds(Stage::Shaking));
    let closed: BTreeSet<u32> = lasting
        .flat_map(|([first, second], _)| {
            let other: Vec<u32> = mesh.face_nodes(*second).collect();
            mesh.face_nodes(*first).filter(|n| other.contains(n)).collect::<Vec<_>>()
        })
        .collect();
    seam.ends.retain(|n| closed.contains(n));
    let mut of_life: BTreeMap<Life, Vec<u32>> = BTreeMap::new();
    for (f, &life) in (0u32..).zip(&seam.standing) {
        of_life.entry(life).or_default().push(f);
    }
    for (life, own) in of_life {
        let faces: Vec<[Face; 2]> = own.iter().map(|&f| seam.faces[f as usize]).collect();
        for mut pair in pairs(mesh, &faces, seam.corner) {
            let spell = rims.spell(life, pair.nodes);
            if life.holds(Stage::Shaking) && !spell.is_some_and(|spell| spell.life.holds(Stage::Shaking)) {
                seam.ends.push(pair.nodes[1]);
            }
            let Some(spell) = spell else { continue };
            for (face, _) in &mut pair.corners {
                *face = own[*face as usize];
            }
            seam.pairs.push(pair);
            seam.lives.push(spell.life);
            seam.freed.push(spell.freed);
        }
    }
    seam.ends.sort_unstable();
    seam.ends.dedup();
    seam.load(standing.initial);
    seam
}

/// Splits elements that stand outside a side where interfaces run through them, as those of the model that they were made of.
/// `origin` says of every node of the mesh which was one with it before anything was split, and `sides` are those of the
/// interfaces, ascending.
///
/// # Errors
/// If more than two elements have the same face.
pub fn outside(
    mesh: &mut Mesh,
    origin: &mut Vec<u32>,
    elements: &[u32],
    parents: &[u32],
    sides: &[[Vec<u32>; 2]],
    seams: &[Seam],
    standing: Standing,
) -> Result<(Vec<Seam>, Vec<Joint>), ModelError> {
    let mut local = Part::of(mesh, origin, elements);
    let times = standing.times(elements.iter().copied());
    let own = |of: &[u32]| -> Vec<u32> {
        let is_of = |k: u32, e: &u32| {
            !times[k as usize].is_empty() && of.binary_search(&parents[*e as usize]).is_ok()
        };
        (0u32..).zip(elements).filter(|(k, e)| is_of(*k, e)).map(|(k, _)| k).collect()
    };
    let both: Vec<[Vec<u32>; 2]> = sides.iter().map(|sides| sides.each_ref().map(|side| own(side))).collect();
    let mut wanted: BTreeSet<usize> =
        (0..sides.len()).filter(|&i| both[i].iter().all(|side| !side.is_empty())).collect();
    let (faces, joints) = loop {
        let cut = |&i: &usize| Cut { name: &seams[i].name, sides: both[i].each_ref().map(Vec::as_slice) };
        let cuts: Vec<Cut> = wanted.iter().map(cut).collect();
        match split(&mut local.mesh, &cuts, &times) {
            Ok(Split { faces, joints, .. }) => break (faces, joints),
            // The two sides may stand out here without touching.
            Err(SplitError::Apart { name, .. }) => wanted.retain(|&i| seams[i].name != name),
            Err(error) => return Err(error.into()),
        }
    };
    local.put_back(mesh, origin, elements);
    let joints: Vec<_> = joints
        .iter()
        .map(|joint| tremolite_mesh::split::Joint {
            nodes: joint.nodes.map(|n| local.nodes[n as usize]),
            elements: joint.elements.map(|e| elements[e as usize]),
        })
        .collect();
    let joints = standing.joints(&joints);
    let rims = Rims::of(&joints);
    let seam = |(i, faces): (usize, Vec<[Face; 2]>)| {
        let whole = |face: Face| Face { element: elements[face.element as usize], ..face };
        let faces: Vec<[Face; 2]> = faces.into_iter().map(|sides| sides.map(whole)).collect();
        let of = &seams[i];
        let bare = Seam {
            of: Some(i),
            name: format!("{} (free field)", of.name),
            pairs: Vec::new(),
            lives: Vec::new(),
            freed: Vec::new(),
            tractions: Vec::new(),
            faces,
            ends: Vec::new(),
            ..of.clone()
        };
        with_pairs(bare, mesh, &rims, standing)
    };
    Ok((wanted.into_iter().zip(faces).map(seam).collect(), joints))
}

/// Some elements of a mesh as a mesh, in which nothing is split.
struct Part {
    mesh: Mesh,
    /// Node of the part -> node of the mesh.
    nodes: Vec<u32>,
}

impl Part {
    fn of(mesh: &Mesh, origin: &[u32], elements: &[u32]) -> Self {
        let mut part = Part { mesh: Mesh::default(), nodes: Vec::new() };
        let mut known: HashMap<u32, u32> = HashMap::new();
        for &e in elements {
            let element = &mesh.elements[e as usize];
            let nodes: Vec<u32> = element
                .nodes()
                .iter()
                .map(|&n| {
                    *known.entry(origin[n as usize]).or_insert_with(|| {
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

    /// Takes over what was split: each node of the part is one that its elements had, as long as there are any, and else a new
    /// one behind those of the mesh.
    fn put_back(&mut self, mesh: &mut Mesh, origin: &mut Vec<u32>, elements: &[u32]) {
        let mut given: Vec<Option<u32>> = vec![None; self.mesh.nodes.len()];
        let mut taken: BTreeSet<u32> = BTreeSet::new();
        for (element, &e) in self.mesh.elements.iter().zip(elements) {
            for (&own, &known) in element.nodes.iter().zip(&mesh.elements[e as usize].nodes) {
                let given = &mut given[own as usize];
                if given.is_none() && taken.insert(known) {
                    *given = Some(known);
                }
            }
        }
        let at = |own: usize| self.mesh.nodes[own];
        let whole = |(own, given): (usize, Option<u32>)| {
            given.unwrap_or_else(|| {
                mesh.nodes.push(at(own));
                mesh.nodes.len() as u32 - 1
            })
        };
        self.nodes = given.into_iter().enumerate().map(whole).collect();
        for (element, &e) in self.mesh.elements.iter().zip(elements) {
            let before = mesh.elements[e as usize].nodes;
            let now = element.nodes.map(|n| self.nodes[n as usize]);
            origin.resize(mesh.nodes.len(), u32::MAX);
            before.iter().zip(now).for_each(|(&before, now)| origin[now as usize] = origin[before as usize]);
            mesh.elements[e as usize].nodes = now;
        }
    }
}
