//! The natural axis of layered elements that leads through the lining's thickness.

use crate::body::Body;
use crate::boundary::Side;
use crate::error::ModelError;
use crate::hexahedra::{hex, hex_nodes};
use crate::interface::Seam;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use tremolite_kernels::{Points, Quadrature};
use tremolite_laws::shapes::hex8::{BadShape, CORNERS, Hex8};
use tremolite_mesh::topology::face_key;
use tremolite_mesh::{Face, Mesh, Shape};

/// A way that an interface crosses counts as if it were this much as long: an assumption, by which pieces of lining as short as
/// they are thick have their thickness across the rock.
const ACROSS_INTERFACE: f64 = 0.5;
/// How much longer the other ways are where an element tells its thickness by itself.
const CLEARLY: f64 = 1.5;

/// Of each element the axis through its thickness, where its body is layered; else 2.
///
/// From each element ways lead along its natural axes, from face to opposite face, until the layered elements end; the shortest is
/// through the thickness, and interfaces at its ends speak for it. Ways that come back, or end at a side of the model that is a cut
/// and no free surface, count for nothing unless all do. Where no way is clearly the shortest, as where walls meet, an element has the axis of a
/// neighbour: any is as good there, and integrates elastic stress exactly. Elements that take over from others, and those outside
/// sides, have the axis of what they were made of.
///
/// # Errors
/// The first element whose thickness is not to be told, or lies across that of its neighbour.
pub fn axes(
    mesh: &Mesh,
    bodies: &[Body],
    user_elements: usize,
    parents: &[u32],
    successors: &HashMap<u32, u32>,
    seams: &[Seam],
    sides: [Side; 2],
    held: &[(u32, [bool; 3])],
) -> Result<Vec<u8>, ModelError> {
    let mut axes = vec![2; mesh.elements.len()];
    let layered = || bodies.iter().filter(|body| matches!(body.quadrature, Quadrature::Layered(_)));
    if layered().next().is_none() {
        return Ok(axes);
    }
    let mut found = Found {
        mesh,
        bounds: mesh.bounds(),
        cut: sides.map(|side| side != Side::Free),
        held: held.iter().copied().collect(),
        body_of: BTreeMap::new(),
        lengths: BTreeMap::new(),
        sharing: BTreeMap::new(),
        axis: BTreeMap::new(),
    };
    for body in layered() {
        let own = |e: &u32| (*e as usize) < user_elements && !successors.contains_key(e);
        for &element in body.elements.iter().filter(|e| own(e)) {
            found.add(element, body)?;
        }
    }
    let beside: BTreeSet<Face> = seams
        .iter()
        .filter(|seam| seam.of.is_none())
        .flat_map(|seam| seam.faces.iter().flatten().copied())
        .collect();
    let told = found.lengths.keys().filter_map(|&element| {
        let ways = |cuts| [0, 1, 2].map(|k| found.way(element, k, &beside, cuts));
        let all = ways(true);
        // A piece between cuts alone, such as an element on its own between supports.
        let seen = if all.iter().all(|way| way.is_infinite()) { ways(false) } else { all };
        Some((element, by_itself(seen)?))
    });
    let told: Vec<(u32, usize)> = told.collect();
    found.axis.extend(told);
    found.ask_neighbours()?;
    for (element, axis) in &found.axis {
        axes[*element as usize] = *axis as u8;
    }
    for body in layered() {
        for &e in &body.elements {
            let mut first = e;
            while let Some(&earlier) = successors.get(&first) {
                first = earlier;
            }
            let axis = match (first as usize) < user_elements {
                true => axes[first as usize] as usize,
                false => alike(mesh, parents[first as usize], axes[parents[first as usize] as usize], e),
            };
            axes[e as usize] = axis as u8;
            // Points at the faces of an element may lie where those of 2×2×2 points do not.
            let points = Points { quadrature: body.quadrature, axis };
            let hex = usable(mesh, e, body)?;
            let least = points.weights(&hex).into_iter().fold(f64::INFINITY, f64::min);
            if least < -1e-12 * hex.volume {
                return Err(bad(mesh, e, body, BadShape::Inverted { determinant: least }));
            }
        }
    }
    Ok(axes)
}

fn bad(mesh: &Mesh, element: u32, body: &Body, reason: BadShape) -> ModelError {
    ModelError::BadElement { element: mesh.element_id(element as usize), body: body.name.clone(), reason }
}

fn usable(mesh: &Mesh, element: u32, body: &Body) -> Result<Hex8, ModelError> {
    hex(mesh, element as usize).map_err(|reason| bad(mesh, element, body, reason))
}

/// The axis of the way that is clearly the shortest.
fn by_itself(ways: [f64; 3]) -> Option<usize> {
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| ways[a].total_cmp(&ways[b]));
    (CLEARLY * ways[order[0]] < ways[order[1]]).then_some(order[0])
}

/// The axis of an element that lies along that of another.
fn alike(mesh: &Mesh, other: u32, axis: u8, element: u32) -> usize {
    let (Ok(other), Ok(own)) = (hex(mesh, other as usize), hex(mesh, element as usize)) else { return 2 };
    let along = |k: usize| -> f64 {
        (0..3).map(|i| own.directions[k][i] * other.directions[axis as usize][i]).sum::<f64>().abs()
    };
    (0..3).max_by(|&a, &b| along(a).total_cmp(&along(b))).unwrap_or(2)
}

/// Layered elements, and what is known of them so far.
struct Found<'a> {
    mesh: &'a Mesh,
    bounds: ([f64; 3], [f64; 3]),
    /// Whether the sides normal to x and to y are cuts through what goes on.
    cut: [bool; 2],
    held: HashMap<u32, [bool; 3]>,
    body_of: BTreeMap<u32, &'a Body>,
    /// Along the natural axes \[m\]; those of a wedge's triangles are none.
    lengths: BTreeMap<u32, [f64; 3]>,
    /// The faces that each key has, of one element or two.
    sharing: BTreeMap<[u32; 4], Vec<Face>>,
    axis: BTreeMap<u32, usize>,
}

impl<'a> Found<'a> {
    fn add(&mut self, element: u32, body: &'a Body) -> Result<(), ModelError> {
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

    /// Length \[m\] of the way through an element along an axis, less where an interface lies at its end; none is endless.
    fn way(&self, element: u32, axis: usize, beside: &BTreeSet<Face>, cuts: bool) -> f64 {
        let mut length = self.lengths[&element][axis];
        if length.is_infinite() {
            return length;
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
                    return f64::INFINITY;
                };
                passed.push(entered.element);
                length += self.lengths[&entered.element][along];
                face = Face { element: entered.element, side: entered.side ^ 1 };
            }
            met |= beside.contains(&face);
            if cuts && self.is_cut(face) {
                return f64::INFINITY;
            }
        }
        if met { ACROSS_INTERFACE * length } else { length }
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

    /// Gives elements that are not clear the axis of a neighbour, and compares those that are.
    fn ask_neighbours(&mut self) -> Result<(), ModelError> {
        let mut neighbours: BTreeMap<u32, Vec<([u32; 4], u32)>> = BTreeMap::new();
        for (key, faces) in &self.sharing {
            for (a, b) in faces.iter().flat_map(|a| faces.iter().map(move |b| (a.element, b.element))) {
                if a != b {
                    neighbours.entry(a).or_default().push((*key, b));
                }
            }
        }
        let clear: BTreeSet<u32> = self.axis.keys().copied().collect();
        let mut front: Vec<u32> = clear.iter().copied().collect();
        while !front.is_empty() {
            let mut next = Vec::new();
            for element in front {
                for (key, other) in neighbours.get(&element).into_iter().flatten() {
                    let wanted = self.edges(element, self.axis[&element], key);
                    match self.axis.get(other) {
                        Some(&axis) => {
                            let both = clear.contains(&element) && clear.contains(other);
                            if both && self.edges(*other, axis, key) != wanted {
                                let other = self.mesh.element_id(*other as usize);
                                let reason = format!("it lies across that of element {other} beside it");
                                return Err(self.refusal(element, reason));
                            }
                        }
                        None => {
                            let fits = |axis: &usize| self.edges(*other, *axis, key) == wanted;
                            if let Some(axis) = (0..3).find(fits) {
                                self.axis.insert(*other, axis);
                                next.push(*other);
                            }
                        }
                    }
                }
            }
            front = next;
        }
        match self.body_of.keys().find(|e| !self.axis.contains_key(e)) {
            Some(&element) => {
                let reason = "the ways through it are about equally long, and neither an interface nor a neighbour tells";
                Err(self.refusal(element, reason.to_owned()))
            }
            None => Ok(()),
        }
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

    fn refusal(&self, element: u32, reason: String) -> ModelError {
        ModelError::Thickness {
            element: self.mesh.element_id(element as usize),
            body: self.body_of.get(&element).map_or(String::new(), |body| body.name.clone()),
            reason,
        }
    }
}
