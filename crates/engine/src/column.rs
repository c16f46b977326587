//! The reference column: one hexahedron a layer, its sides tied, as the ground far from the caverns.
//!
//! Its bottom moves as u_ff, the free field at the level of the base, on which the springs of the base act.
//! It feels the same incident wave through dashpots alone.

use crate::body::Body;
use crate::error::ModelError;
use crate::hexahedra::hex_nodes;
use tremolite_kernels::Quadrature;
use tremolite_mesh::{Element, Mesh, Shape};

/// Side of the column's square section \[m\]; its width cancels.
pub const WIDTH: f64 = 1.0;

/// Where the column's nodes are.
#[derive(Clone, Debug)]
pub struct Column {
    /// The four nodes of each level, in the mesh's numbering, which move as one; upwards.
    pub rings: Vec<[u32; 4]>,
    /// Index of the body whose material the bottom has.
    pub bottom_body: usize,
}

impl Column {
    /// The four nodes of the bottom.
    pub fn bottom(&self) -> [u32; 4] {
        self.rings[0]
    }
}

fn refusal(reason: &str) -> ModelError {
    ModelError::Column(format!(
        "the springs of the base need the free field of a column at a corner of the model, but {reason}; \
         use base = \"viscous\" instead"
    ))
}

/// Adds the column beside the mesh: layers and materials as along the vertical edge at (x min, y min).
///
/// # Errors
/// If the mesh has no such edge made of element edges.
pub fn build(
    mesh: &mut Mesh,
    bodies: &mut Vec<Body>,
    body_of: &[Option<usize>],
) -> Result<Column, ModelError> {
    let (low, high) = mesh.bounds();
    let near = 1e-6 * (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
    let on_edge = |n: u32| {
        let x = mesh.nodes[n as usize];
        (x[0] - low[0]).abs() < near && (x[1] - low[1]).abs() < near
    };
    let mut layers: Vec<(f64, f64, usize)> = Vec::new();
    for (e, body) in body_of.iter().enumerate() {
        let Some(body) = body else { continue };
        let nodes = hex_nodes(mesh, e);
        let mut levels: Vec<f64> =
            nodes.iter().filter(|&&n| on_edge(n)).map(|&n| mesh.nodes[n as usize][2]).collect();
        levels.sort_by(f64::total_cmp);
        levels.dedup_by(|a, b| (*a - *b).abs() < near);
        if let [bottom, top] = levels[..] {
            layers.push((bottom, top, *body));
        }
    }
    layers.sort_by(|a, b| a.0.total_cmp(&b.0));
    layers.dedup_by(|a, b| (a.0 - b.0).abs() < near);
    let Some(first) = layers.first() else {
        return Err(refusal("no element has a vertical edge at the corner (x min, y min)"));
    };
    if (first.0 - low[2]).abs() > near {
        return Err(refusal("the elements there do not reach down to the base"));
    }
    if layers.windows(2).any(|pair| (pair[0].1 - pair[1].0).abs() > near) {
        return Err(refusal("the elements there leave a gap"));
    }

    // Beside the mesh, so that a picture with it shows two things.
    let x0 = low[0] - (high[0] - low[0]) - WIDTH;
    let y0 = low[1];
    let ring = |mesh: &mut Mesh, z: f64| -> [u32; 4] {
        let start = mesh.nodes.len() as u32;
        for (dx, dy) in [(0.0, 0.0), (WIDTH, 0.0), (WIDTH, WIDTH), (0.0, WIDTH)] {
            mesh.nodes.push([x0 + dx, y0 + dy, z]);
        }
        [start, start + 1, start + 2, start + 3]
    };
    let bottom_body = first.2;
    let mut below = ring(mesh, first.0);
    let mut rings = vec![below];
    for (_, top, body) in layers {
        let above = ring(mesh, top);
        let element = mesh.elements.len() as u32;
        mesh.elements.push(Element::new(
            Shape::Hex8,
            &[below[0], below[1], below[2], below[3], above[0], above[1], above[2], above[3]],
        ));
        let name = format!("reference column ({})", bodies[body].name);
        match bodies.iter_mut().find(|b| b.name == name) {
            Some(column) => column.elements.push(element),
            None => {
                let like = &bodies[body];
                let column = Body {
                    name,
                    elements: vec![element],
                    material: like.material.clone(),
                    density: like.density,
                    quadrature: Quadrature::OnePoint,
                    viscosity: like.viscosity,
                };
                bodies.push(column);
            }
        }
        below = above;
        rings.push(above);
    }
    Ok(Column { rings, bottom_body })
}
