//! The mesh: nodes, elements, and names for sets of elements, faces and points.

use std::collections::BTreeMap;

/// Shape of an element; node order is that of VTK (and of Abaqus for hexahedra).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Shape {
    /// Eight-node hexahedron: bottom face counter-clockwise seen from above, then the top face.
    Hex8,
    /// Six-node wedge: one triangle, then the opposite one.
    Wedge6,
    /// Five-node pyramid: base counter-clockwise seen from the apex, then the apex.
    Pyramid5,
    /// Four-node tetrahedron.
    Tet4,
}

impl Shape {
    /// Number of nodes.
    pub const fn nodes(self) -> usize {
        match self {
            Shape::Hex8 => 8,
            Shape::Wedge6 => 6,
            Shape::Pyramid5 => 5,
            Shape::Tet4 => 4,
        }
    }

    /// Name as in `tremolite mesh info --json`.
    pub const fn name(self) -> &'static str {
        match self {
            Shape::Hex8 => "hex8",
            Shape::Wedge6 => "wedge6",
            Shape::Pyramid5 => "pyramid5",
            Shape::Tet4 => "tet4",
        }
    }

    /// Local node numbers of each face, outward normal by the right-hand rule.
    pub const fn faces(self) -> &'static [&'static [usize]] {
        match self {
            // x-, x+, y-, y+, z-, z+ of a brick in natural coordinates
            Shape::Hex8 => {
                &[&[0, 4, 7, 3], &[1, 2, 6, 5], &[0, 1, 5, 4], &[3, 7, 6, 2], &[0, 3, 2, 1], &[4, 5, 6, 7]]
            }
            Shape::Wedge6 => &[&[0, 2, 1], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[0, 3, 5, 2]],
            Shape::Pyramid5 => &[&[0, 3, 2, 1], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]],
            Shape::Tet4 => &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]],
        }
    }
}

/// One element: its shape and its nodes (indices into [`Mesh::nodes`]; the unused tail repeats the last node).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Element {
    pub shape: Shape,
    pub nodes: [u32; 8],
}

impl Element {
    /// An element from exactly `shape.nodes()` node indices.
    ///
    /// # Panics
    /// If the number of nodes is not that of the shape.
    pub fn new(shape: Shape, nodes: &[u32]) -> Self {
        assert_eq!(nodes.len(), shape.nodes(), "a {} has {} nodes", shape.name(), shape.nodes());
        let mut all = [nodes[nodes.len() - 1]; 8];
        all[..nodes.len()].copy_from_slice(nodes);
        Element { shape, nodes: all }
    }

    /// The nodes that count.
    pub fn nodes(&self) -> &[u32] {
        &self.nodes[..self.shape.nodes()]
    }
}

/// One face of one element, by the numbering of [`Shape::faces`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Face {
    pub element: u32,
    pub side: u8,
}

/// A mesh of solid elements. Lengths in metres, z up. Groups may overlap.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    pub nodes: Vec<[f64; 3]>,
    pub elements: Vec<Element>,
    /// Named sets of elements (indices into `elements`, ascending).
    pub groups: BTreeMap<String, Vec<u32>>,
    /// Named sets of faces.
    pub faces: BTreeMap<String, Vec<Face>>,
    /// Named points (monitors may refer to them).
    pub points: BTreeMap<String, [f64; 3]>,
    /// Node numbers of the file the mesh came from; empty if they are 1, 2, 3 …
    pub node_ids: Vec<u64>,
    /// Element numbers of the file the mesh came from; empty if they are 1, 2, 3 …
    pub element_ids: Vec<u64>,
}

impl Mesh {
    /// The number by which the user knows element `e`.
    pub fn element_id(&self, e: usize) -> u64 {
        self.element_ids.get(e).copied().unwrap_or(e as u64 + 1)
    }

    /// The number by which the user knows node `n`.
    pub fn node_id(&self, n: usize) -> u64 {
        self.node_ids.get(n).copied().unwrap_or(n as u64 + 1)
    }

    /// Coordinates of the nodes of a face.
    pub fn face_nodes(&self, face: Face) -> impl Iterator<Item = u32> + '_ {
        let element = &self.elements[face.element as usize];
        element.shape.faces()[face.side as usize].iter().map(|&k| element.nodes[k])
    }

    /// Smallest and largest coordinates over all nodes.
    pub fn bounds(&self) -> ([f64; 3], [f64; 3]) {
        let mut low = [f64::INFINITY; 3];
        let mut high = [f64::NEG_INFINITY; 3];
        for node in &self.nodes {
            for i in 0..3 {
                low[i] = low[i].min(node[i]);
                high[i] = high[i].max(node[i]);
            }
        }
        (low, high)
    }
}
