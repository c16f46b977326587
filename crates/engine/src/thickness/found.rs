//! Layered elements, the ways through them, and what these and neighbours tell of their thickness.

use crate::body::Body;
use crate::error::ModelError;
use crate::hexahedra::{hex, hex_nodes};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use tremolite_laws::shapes::hex8::{BadShape, CORNERS, Hex8};
use tremolite_mesh::topology::face_key;
use tremolite_mesh::{Face, Mesh, Shape};

/// A way that an interface crosses counts as if it were this much as long: an assumption, by which pieces of lining as short as
/// they are thick have their thickness across the rock.
const ACROSS_INTERFACE: f64 = 0.5;
/// How much longer the other ways are where an element tells its thickness by itself.
const CLEARLY: f64 = 1.5;
/// Relative difference that rounding makes: numbers of nodes and elements decide nothing.
const ROUNDING: f64 = 1e-6;

/// Layered elements, and what is known of them so far.
pub(super) struct Found<'a> {
    pub mesh: &'a Mesh,
    pub bounds: ([f64; 3], [f64; 3]),
    /// Whether the sides normal to x and to y are cuts through what goes on.
    pub cut: [bool; 2],
    pub held: HashMap<u32, [bool; 3]>,
    pub body_of: BTreeMap<u32, &'a Body>,
    /// Along the natural axes \[m\]; those of a wedge's triangles are none.
    pub lengths: BTreeMap<u32, [f64; 3]>,
    /// The faces that each key has, of one element or two.
    pub sharing: BTreeMap<[u32; 4], Vec<Face>>,
    /// The elements beside each, with the keys of the faces they share.
    pub neighbours: BTreeMap<u32, Vec<([u32; 4], u32)>>,
    pub axis: BTreeMap<u32, usize>,
}

/// From face to opposite face until the layered elements end.
struct Way {
    /// \[m\], less where an interface lies at an end; infinite of a way that counts for nothing.
    length: f64,
    passed: Vec<u32>,
}

impl Way {
    const ENDLESS: Way = Way { length: f64::INFINITY, passed: Vec::new() };
}

impl<'a> Found<'a> {
    pub fn add(&mut self, element: u32, body: &'a Body) -> Result<(), ModelError> {
        let shape = self.mesh.elements[element as usize].shape;
        self.body_of.insert(element, body);
        let lengths = usable(self.mesh, element, body)?.half_lengths.map(|half| 2.0 * half);
        let lengths = match shape {
            Shape::Hex8 => lengths,
            // Its triangles are the lining's surfaces.
            Shape::Wedge6 => [f64::INFINITY, f64::INFINITY, lengths[2]],
            Shape::Pyramid5 | Shape::Tet4 => {
                return Err(self.refusal(element, format!("a {} has none", shape.name())));
            }
        };
        self.lengths.insert(element, lengths);
        for side in 0..shape.faces().len() as u8 {
            let face = Face { element, side };
            self.sharing.entry(face_key(self.mesh, face)).or_default().push(face);
        }
        Ok(())
    }

    /// The axis across a face and its end of it; none across the quadrilaterals of a wedge.
    fn across(&self, face: Face) -> Option<usize> {
        match self.mesh.elements[face.element as usize].shape {
            Shape::Hex8 => Some(face.side as usize / 2),
            _ if face.side < 2 => Some(2),
            _ => None,
        }
    }

    /// The way through an element along an axis.
    fn way(&self, element: u32, axis: usize, beside: &BTreeSet<Face>, cuts: bool) -> Way {
        let mut length = self.lengths[&element][axis];
        if length.is_infinite() {
            return Way::ENDLESS;
        }
        let first =
            if self.mesh.elements[element as usize].shape == Shape::Hex8 { 2 * axis as u8 } else { 0 };
        let (mut passed, mut met) = (vec![element], false);
        for side in [first, first + 1] {
            let mut face = Face { element, side };
            loop {
                let others = &self.sharing[&face_key(self.mesh, face)];
                let Some(&entered) = others.iter().find(|other| other.element != face.element) else { break };
                let Some(along) = self.across(entered).filter(|_| !passed.contains(&entered.element)) else {
                    return Way::ENDLESS;
                };
                passed.push(entered.element);
                length += self.lengths[&entered.element][along];
                face = Face { element: entered.element, side: entered.side ^ 1 };
            }
            met |= beside.contains(&face);
            if cuts && self.is_cut(face) {
                return Way::ENDLESS;
            }
        }
        Way { length: if met { ACROSS_INTERFACE * length } else { length }, passed }
    }

    /// Whether a face lies on one of the model's vertical sides that are cuts, or on one that is held across it.
    fn is_cut(&self, face: Face) -> bool {
        let (low, high) = self.bounds;
        let across = |i: usize| {
            self.mesh.face_nodes(face).all(|n| self.held.get(&n).is_some_and(|components| components[i]))
        };
        let is_cut = |i: usize| self.cut.get(i) == Some(&true) || across(i);
        (0..3).filter(|&i| is_cut(i)).any(|i| {
            let near = 1e-6 * (high[i] - low[i]);
            [low[i], high[i]].iter().any(|plane| {
                self.mesh.face_nodes(face).all(|n| (self.mesh.nodes[n as usize][i] - plane).abs() <= near)
            })
        })
    }

    pub fn meet(&mut self) {
        for (key, faces) in &self.sharing {
            for (a, b) in faces.iter().flat_map(|a| faces.iter().map(move |b| (a.element, b.element))) {
                if a != b {
                    self.neighbours.entry(a).or_default().push((*key, b));
                }
            }
        }
    }

    /// Gives elements that have no axis that of their shortest way, where it is clear, and compares those that lie side by side.
    pub fn tell(&mut self, beside: &BTreeSet<Face>, cuts: bool) -> Result<(), ModelError> {
        let untold = self.lengths.keys().filter(|element| !self.axis.contains_key(element));
        let sorted = untold.map(|&element| {
            let mut ways = [0, 1, 2].map(|k| (k, self.way(element, k, beside, cuts)));
            ways.sort_by(|a, b| a.1.length.total_cmp(&b.1.length));
            (element, ways)
        });
        let ways: BTreeMap<u32, [(usize, Way); 3]> = sorted.collect();
        let shortest = |element: &u32| ways.get(element).map_or(f64::INFINITY, |ways| ways[0].1.length);
        // From a slab's corner the way along the slab is far shorter than that up the wall and over the crown.
        let tells = |[(_, way), (_, next), _]: &[(usize, Way); 3]| {
            clearly_shorter(way.length, next.length)
                && !way.passed.iter().any(|passed| clearly_shorter(shortest(passed), way.length))
        };
        let mut told: BTreeMap<u32, usize> = ways
            .iter()
            .filter(|(_, ways)| tells(ways))
            .map(|(&element, ways)| (element, ways[0].0))
            .collect();
        let mut across = Vec::new();
        for (&element, &axis) in &told {
            for (key, other) in self.neighbours.get(&element).into_iter().flatten() {
                let lies_across =
                    |&theirs: &usize| self.edges(*other, theirs, key) != self.edges(element, axis, key);
                if told.get(other).is_some_and(lies_across) {
                    across.push([element, *other]);
                }
            }
        }
        // Where walls meet in a slice with free ends, the way along the cavern is the shortest, and longer than through the walls.
        for [element, other] in &across {
            if clearly_shorter(shortest(other), shortest(element)) {
                told.remove(element);
            }
        }
        if let Some([element, other]) = across.iter().find(|pair| pair.iter().all(|e| told.contains_key(e))) {
            let other = self.mesh.element_id(*other as usize);
            return Err(self.refusal(*element, format!("it lies across that of element {other} beside it")));
        }
        self.axis.extend(told);
        Ok(())
    }

    /// Gives elements that have no axis that of a neighbour, those nearest to one that has first.
    pub fn ask_neighbours(&mut self) {
        let mut front: Vec<u32> = self.axis.keys().copied().collect();
        while !front.is_empty() {
            let mut proposed: BTreeMap<u32, BTreeSet<usize>> = BTreeMap::new();
            for element in front {
                for (key, other) in self.neighbours.get(&element).into_iter().flatten() {
                    if !self.axis.contains_key(other) {
                        let wanted = self.edges(element, self.axis[&element], key);
                        let fits = (0..3).find(|&axis| self.edges(*other, axis, key) == wanted);
                        proposed.entry(*other).or_default().extend(fits);
                    }
                }
            }
            let chosen =
                proposed.iter().filter_map(|(&element, axes)| Some((element, self.choose(element, axes)?)));
            let chosen: Vec<(u32, usize)> = chosen.collect();
            front = chosen.iter().map(|(element, _)| *element).collect();
            self.axis.extend(chosen);
        }
    }

    /// Of an element's axes that along which it is shortest, of equal ones the nearest to the vertical, then to x: by its shape
    /// alone, whatever the numbers. Where these say nothing either, two axes differ in where they lean.
    fn choose(&self, element: u32, axes: &BTreeSet<usize>) -> Option<usize> {
        let (directions, lengths) =
            (hex(self.mesh, element as usize).ok()?.directions, self.lengths[&element]);
        let least = lengths.into_iter().fold(f64::INFINITY, f64::min);
        let merits = |k: usize| {
            let [x, y, z] = directions[k];
            [-lengths[k] / least, z.abs(), x.abs(), x * z, y * z, x * y]
        };
        let mut left: Vec<usize> = axes.iter().copied().collect();
        for i in 0..6 {
            let most = left.iter().map(|&k| merits(k)[i]).fold(f64::NEG_INFINITY, f64::max);
            left.retain(|&k| merits(k)[i] >= most - ROUNDING);
        }
        left.first().copied()
    }

    /// The edges along an axis of an element that lie on a face, as pairs of nodes in ascending order.
    fn edges(&self, element: u32, axis: usize, face: &[u32; 4]) -> Vec<[u32; 2]> {
        let nodes = hex_nodes(self.mesh, element as usize);
        let opposite = |k: usize| {
            let mut place = CORNERS[k];
            place[axis] = 1.0;
            CORNERS.iter().position(|corner| *corner == place).unwrap_or(k)
        };
        let mut edges: Vec<[u32; 2]> = (0..8)
            .filter(|&k| CORNERS[k][axis] < 0.0)
            .map(|k| [nodes[k], nodes[opposite(k)]])
            .filter(|edge| edge.iter().all(|node| face.contains(node)))
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    pub fn refusal(&self, element: u32, reason: String) -> ModelError {
        ModelError::Thickness {
            element: self.mesh.element_id(element as usize),
            body: self.body_of.get(&element).map_or(String::new(), |body| body.name.clone()),
            reason,
        }
    }
}

pub(super) fn bad(mesh: &Mesh, element: u32, body: &Body, reason: BadShape) -> ModelError {
    ModelError::BadElement { element: mesh.element_id(element as usize), body: body.name.clone(), reason }
}

pub(super) fn usable(mesh: &Mesh, element: u32, body: &Body) -> Result<Hex8, ModelError> {
    hex(mesh, element as usize).map_err(|reason| bad(mesh, element, body, reason))
}

fn clearly_shorter(a: f64, b: f64) -> bool {
    CLEARLY * a < (1.0 - ROUNDING) * b
}
