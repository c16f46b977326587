//! Elements outside a side: every face on its plane extruded outwards, with nodes of their own.

use std::collections::BTreeMap;
use tremolite_mesh::{Element, Face, Mesh, Shape};

/// A layer of elements one element thick, outside a vertical plane.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Normal of the plane, 0 for x and 1 for y, and whether the sheet lies at its low (0) or at its high end (1).
    pub axis: usize,
    pub end: usize,
    /// m
    pub thickness: f64,
    /// Faces on the plane, each with the element outside it.
    pub twins: Vec<(Face, u32)>,
}

/// A corner of an extruded face, on nodes of the mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Corner {
    /// The node of the face; at its place the front of the sheet, and the back behind that.
    pub source: u32,
    pub front: u32,
    pub back: u32,
}

impl Sheet {
    /// Extrudes faces on a plane by the median thickness of the elements behind them; none without faces.
    pub fn beside(mesh: &mut Mesh, faces: Vec<Face>, axis: usize, end: usize) -> Option<Sheet> {
        let thickness = median_extent(mesh, &faces, axis)?;
        let outwards = if end == 0 { -thickness } else { thickness };
        let mut pairs: BTreeMap<u32, [u32; 2]> = BTreeMap::new();
        let mut twins = Vec::with_capacity(faces.len());
        for face in faces {
            let corners: Vec<u32> = mesh.face_nodes(face).collect();
            let own: Vec<[u32; 2]> = corners
                .iter()
                .map(|&source| {
                    *pairs.entry(source).or_insert_with(|| {
                        let front = mesh.nodes.len() as u32;
                        let mut at = mesh.nodes[source as usize];
                        mesh.nodes.push(at);
                        at[axis] += outwards;
                        mesh.nodes.push(at);
                        [front, front + 1]
                    })
                })
                .collect();
            // The face looks outwards, so it is the bottom of what is extruded from it.
            let nodes: Vec<u32> =
                [0, 1].into_iter().flat_map(|k| own.iter().map(move |pair| pair[k])).collect();
            let shape = if corners.len() == 3 { Shape::Wedge6 } else { Shape::Hex8 };
            twins.push((face, mesh.elements.len() as u32));
            mesh.elements.push(Element::new(shape, &nodes));
        }
        Some(Sheet { axis, end, thickness, twins })
    }

    /// The elements of the sheet.
    pub fn elements(&self) -> impl Iterator<Item = u32> + '_ {
        self.twins.iter().map(|(_, twin)| *twin)
    }
}

/// Corners of an extruded face, in its order.
pub fn corners(mesh: &Mesh, (face, twin): (Face, u32)) -> impl Iterator<Item = Corner> + '_ {
    let nodes = mesh.elements[twin as usize].nodes();
    let (fronts, backs) = nodes.split_at(nodes.len() / 2);
    mesh.face_nodes(face).zip(fronts.iter().zip(backs)).map(|(source, (&front, &back))| Corner {
        source,
        front,
        back,
    })
}

/// Faces of some elements on the plane at `level` \[m\] of an axis, in the elements' order; `near` \[m\] is as good as on it.
pub fn faces_on(
    mesh: &Mesh,
    elements: impl IntoIterator<Item = u32>,
    axis: usize,
    level: f64,
    near: f64,
) -> Vec<Face> {
    let on =
        |face: &Face| mesh.face_nodes(*face).all(|n| (mesh.nodes[n as usize][axis] - level).abs() <= near);
    let faces = |element: u32| {
        let sides = mesh.elements[element as usize].shape.faces().len() as u8;
        (0..sides).map(move |side| Face { element, side })
    };
    elements.into_iter().flat_map(faces).filter(on).collect()
}

/// Median extent \[m\] along an axis of the elements behind some faces.
fn median_extent(mesh: &Mesh, faces: &[Face], axis: usize) -> Option<f64> {
    let extent = |face: &Face| {
        let nodes = mesh.elements[face.element as usize].nodes();
        let at = nodes.iter().map(|&n| mesh.nodes[n as usize][axis]);
        let (low, high) = at.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        high - low
    };
    let mut extents: Vec<f64> = faces.iter().map(extent).collect();
    extents.sort_by(f64::total_cmp);
    extents.get(extents.len() / 2).copied()
}
