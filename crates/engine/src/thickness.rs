//! The natural axis of layered elements that leads through the lining's thickness.

use crate::body::Body;
use crate::error::ModelError;
use crate::hexahedra::{hex, hex_nodes};
use crate::interface::Seam;
use std::collections::{BTreeMap, HashMap};
use tremolite_kernels::{Points, Quadrature};
use tremolite_laws::shapes::hex8::{BadShape, CORNERS, Hex8};
use tremolite_mesh::topology::face_key;
use tremolite_mesh::{Face, Mesh, Shape};

/// An axis across which an interface lies counts as if the element were this much as long along it: an assumption, by which
/// linings in elements as short as they are thick, and not much shorter, have their thickness across the rock.
const ACROSS_INTERFACE: f64 = 0.5;
/// How much longer the other axes are where an element tells its thickness by itself.
const CLEARLY: f64 = 1.25;

/// Of each element the axis through its thickness, where its body is layered; else 2.
///
/// An element goes by the interfaces on its faces and by its shape; where these leave it open by its neighbours. Those that share
/// a face must agree. Elements that take over from others, and those outside sides, have the axis of what they were made of.
///
/// # Errors
/// The first element whose thickness is not to be told, or is not that of its neighbour.
pub fn axes(
    mesh: &Mesh,
    bodies: &[Body],
    user_elements: usize,
    parents: &[u32],
    successors: &HashMap<u32, u32>,
    seams: &[Seam],
) -> Result<Vec<u8>, ModelError> {
    let mut axes = vec![2; mesh.elements.len()];
    let layered = || bodies.iter().filter(|body| matches!(body.quadrature, Quadrature::Layered(_)));
    if layered().next().is_none() {
        return Ok(axes);
    }
    let mut found = Found { mesh, body_of: BTreeMap::new(), axis: BTreeMap::new() };
    for body in layered() {
        let own = body.elements.iter().filter(|&e| (*e as usize) < user_elements && !successors.contains_key(e));
        found.body_of.extend(own.map(|&e| (e, body)));
    }
    let mut beside: HashMap<u32, [bool; 3]> = HashMap::new();
    for face in seams.iter().filter(|seam| seam.of.is_none()).flat_map(|seam| seam.faces.iter().flatten()) {
        if let Some(axis) = across(mesh, *face) {
            beside.entry(face.element).or_default()[axis] = true;
        }
    }
    for (&element, body) in &found.body_of {
        let shape = mesh.elements[element as usize].shape;
        let lengths = usable(mesh, element, body)?.half_lengths;
        match shape {
            Shape::Hex8 => {
                let seen = beside.get(&element).copied().unwrap_or_default();
                if let Some(axis) = by_itself(lengths, seen) {
                    found.axis.insert(element, axis);
                }
            }
            // Its triangles are the lining's surfaces.
            Shape::Wedge6 => {
                found.axis.insert(element, 2);
            }
            Shape::Pyramid5 | Shape::Tet4 => {
                let reason = format!("a {} has no thickness", shape.name());
                return Err(found.refusal(element, reason));
            }
        }
    }
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

/// The natural axis across a face of a hexahedron, or of a wedge's triangles.
fn across(mesh: &Mesh, face: Face) -> Option<usize> {
    match mesh.elements[face.element as usize].shape {
        Shape::Hex8 => Some(face.side as usize / 2),
        Shape::Wedge6 if face.side < 2 => Some(2),
        _ => None,
    }
}

/// The axis that an element tells by its half-lengths and by the axes across which it has interfaces.
fn by_itself(lengths: [f64; 3], beside: [bool; 3]) -> Option<usize> {
    let seen = |axis: usize| lengths[axis] * if beside[axis] { ACROSS_INTERFACE } else { 1.0 };
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| seen(a).total_cmp(&seen(b)));
    (CLEARLY * seen(order[0]) < seen(order[1])).then_some(order[0])
}

/// The axis of an element that lies along that of another.
fn alike(mesh: &Mesh, other: u32, axis: u8, element: u32) -> usize {
    let (Ok(other), Ok(own)) = (hex(mesh, other as usize), hex(mesh, element as usize)) else { return 2 };
    let along = |k: usize| -> f64 {
        (0..3).map(|i| own.directions[k][i] * other.directions[axis as usize][i]).sum::<f64>().abs()
    };
    (0..3).max_by(|&a, &b| along(a).total_cmp(&along(b))).unwrap_or(2)
}

/// What is known so far.
struct Found<'a> {
    mesh: &'a Mesh,
    body_of: BTreeMap<u32, &'a Body>,
    axis: BTreeMap<u32, usize>,
}

impl Found<'_> {
    /// Gives elements that are not clear the axis of a neighbour, and compares those that share a face.
    fn ask_neighbours(&mut self) -> Result<(), ModelError> {
        let mut sharing: BTreeMap<[u32; 4], Vec<u32>> = BTreeMap::new();
        for &element in self.body_of.keys() {
            for side in 0..self.mesh.elements[element as usize].shape.faces().len() as u8 {
                sharing.entry(face_key(self.mesh, Face { element, side })).or_default().push(element);
            }
        }
        let mut neighbours: BTreeMap<u32, Vec<([u32; 4], u32)>> = BTreeMap::new();
        for (key, elements) in &sharing {
            for (a, b) in elements.iter().flat_map(|a| elements.iter().map(move |b| (a, b))) {
                if a != b {
                    neighbours.entry(*a).or_default().push((*key, *b));
                }
            }
        }
        let mut front: Vec<u32> = self.axis.keys().copied().collect();
        while !front.is_empty() {
            let mut next = Vec::new();
            for element in front {
                for (key, other) in neighbours.get(&element).into_iter().flatten() {
                    let wanted = self.edges(element, self.axis[&element], key);
                    match self.axis.get(other) {
                        Some(&axis) if self.edges(*other, axis, key) == wanted => {}
                        Some(_) => {
                            let other = self.mesh.element_id(*other as usize);
                            let reason = format!(
                                "it lies across that of element {other} beside it, as where walls meet"
                            );
                            return Err(self.refusal(element, reason));
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
        let open = self.body_of.keys().find(|e| !self.axis.contains_key(e));
        match open {
            Some(&element) => {
                let reason = "its edges are about equally long, and neither an interface nor a neighbour tells";
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
