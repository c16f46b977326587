//! A stack with its elements in order, and what little geometry its sections need.

use crate::stacks::Stack;
use tremolite_laws::shapes::hex8::CORNERS;
use tremolite_mesh::Mesh;

/// A face's corners, going round it.
pub(super) type Quad = [[f64; 3]; 4];

/// A stack from one end to the other, with its faces there, whose corners lie opposite each other.
pub(super) struct Ordered {
    pub elements: Stack,
    ends: [Quad; 2],
}

/// Corners of a hexahedron's face across natural axis `axis`, at its lower end (0) or upper end (1), going round; those
/// of the two ends lie opposite each other.
fn corners(axis: usize, end: usize) -> [usize; 4] {
    const ROUND: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    ROUND.map(|[b, c]| {
        let mut natural = [0.0; 3];
        natural[axis] = [-1.0, 1.0][end];
        natural[(axis + 1) % 3] = b;
        natural[(axis + 2) % 3] = c;
        CORNERS.iter().position(|corner| *corner == natural).unwrap_or(0)
    })
}

/// The same as places \[m\].
pub(super) fn face(mesh: &Mesh, element: u32, axis: usize, end: usize) -> Quad {
    let nodes = mesh.elements[element as usize].nodes;
    corners(axis, end).map(|corner| mesh.nodes[nodes[corner] as usize])
}

/// Mean of the corners.
pub(super) fn centre(quad: &Quad) -> [f64; 3] {
    [0, 1, 2].map(|i| quad.iter().map(|x| x[i]).sum::<f64>() / 4.0)
}

impl Ordered {
    /// Puts a stack's elements in order; none if they do not follow one another.
    pub fn new(mesh: &Mesh, stack: &Stack) -> Option<Ordered> {
        let nodes = |(element, axis): (u32, usize), end: usize| {
            corners(axis, end).map(|corner| mesh.elements[element as usize].nodes[corner])
        };
        let sorted = |mut nodes: [u32; 4]| {
            nodes.sort_unstable();
            nodes
        };
        let mut faces: Vec<([u32; 4], (u32, usize), usize)> = Vec::with_capacity(2 * stack.len());
        for &member in stack {
            faces.extend([0, 1].map(|end| (sorted(nodes(member, end)), member, end)));
        }
        // An end's face is that of one element alone.
        let single =
            |face: &&([u32; 4], (u32, usize), usize)| faces.iter().filter(|f| f.0 == face.0).count() == 1;
        let &(_, mut member, mut end) = faces.iter().find(single)?;
        let mut ordered = Vec::with_capacity(stack.len());
        let first = nodes(member, end);
        let mut round = first;
        loop {
            // From each corner along the axis to the opposite one.
            let (entered, left) = (nodes(member, end), nodes(member, 1 - end));
            for node in &mut round {
                *node = left[entered.iter().position(|n| n == node)?];
            }
            ordered.push(member);
            let key = sorted(round);
            let Some(next) = faces.iter().find(|(nodes, other, _)| *nodes == key && *other != member) else {
                break;
            };
            (member, end) = (next.1, next.2);
            if ordered.len() > stack.len() {
                return None;
            }
        }
        let places = |nodes: [u32; 4]| nodes.map(|n| mesh.nodes[n as usize]);
        (ordered.len() == stack.len())
            .then(|| Ordered { elements: ordered, ends: [places(first), places(round)] })
    }

    /// The faces at both ends, in the order of the elements.
    pub fn ends(&self) -> [&Quad; 2] {
        let [first, last] = &self.ends;
        [first, last]
    }

    /// The other way round.
    pub fn turned(mut self) -> Ordered {
        self.elements.reverse();
        self.ends.reverse();
        self
    }
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn scaled(a: [f64; 3], by: f64) -> [f64; 3] {
    a.map(|v| v * by)
}

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
