//! The reference column: one hexahedron a layer, its sides tied, as the ground far from the caverns.
//!
//! Its bottom moves as u_ff, the free field at the level of the base, on which the springs of the base act.
//! It feels the same incident wave through dashpots alone. Models whose base has no springs have one as well, to be
//! compared with.

use crate::body::Body;
use crate::error::ModelError;
use crate::hexahedra::hex_nodes;
use crate::interface::Interface;
use crate::life::Life;
use crate::traction::Traction;
use tremolite_kernels::Quadrature;
use tremolite_mesh::{Element, Face, Mesh, Shape};

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

/// Why springs of the base cannot be had.
pub fn refusal(reason: &str) -> ModelError {
    ModelError::Column(format!(
        "the springs of the base act on what differs from the free field of one column of ground, but {reason}; \
         use base = \"viscous\" instead"
    ))
}

/// A layer of ground along a vertical edge of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Layer {
    bottom: f64,
    top: f64,
    body: usize,
    element: u32,
}

/// The ground along the four vertical edges of the model, upwards, if it is the same at all of them: only then is one
/// column the free field of the whole base.
///
/// # Errors
/// Why there is no such ground, in words that may stand behind 'but'.
pub fn ground(
    mesh: &Mesh,
    bodies: &[Body],
    body_of: &[Option<usize>],
    interfaces: &[Interface],
    lives: &[Life],
) -> Result<Ground, String> {
    let near = near(mesh);
    let (low, high) = mesh.bounds();
    let corner =
        |k: usize| [if k & 1 == 0 { low[0] } else { high[0] }, if k & 2 == 0 { low[1] } else { high[1] }];
    for k in 0..4 {
        changes(mesh, lives, corner(k))?;
    }
    let first = along(mesh, bodies, body_of, corner(0))?;
    crossed(interfaces, &first, corner(0))?;
    for k in 1..4 {
        let other = along(mesh, bodies, body_of, corner(k))?;
        crossed(interfaces, &other, corner(k))?;
        let alike = first.len() == other.len()
            && first.iter().zip(&other).all(|(a, b)| {
                (a.bottom - b.bottom).abs() < near
                    && (a.top - b.top).abs() < near
                    && same(&bodies[a.body], &bodies[b.body])
            });
        if !alike {
            let [x, y] = corner(k);
            return Err(format!(
                "the ground at the corner ({x:.1}, {y:.1}) m differs from that at ({:.1}, {:.1}) m",
                low[0], low[1]
            ));
        }
    }
    Ok(Ground { layers: first })
}

/// The ground at the model's corners.
#[derive(Clone, Debug)]
pub struct Ground {
    layers: Vec<Layer>,
}

fn near(mesh: &Mesh) -> f64 {
    let (low, high) = mesh.bounds();
    1e-6 * (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max)
}

/// Whether two bodies are of the same stuff.
fn same(a: &Body, b: &Body) -> bool {
    a.material.info().name == b.material.info().name
        && a.material.values() == b.material.values()
        && a.material.band() == b.material.band()
        && a.density == b.density
}

/// Layers along the vertical edge at a corner.
fn along(
    mesh: &Mesh,
    bodies: &[Body],
    body_of: &[Option<usize>],
    corner: [f64; 2],
) -> Result<Vec<Layer>, String> {
    let near = near(mesh);
    let (low, _) = mesh.bounds();
    let place = format!("at the corner ({:.1}, {:.1}) m", corner[0], corner[1]);
    let on_edge = |n: u32| {
        let x = mesh.nodes[n as usize];
        (x[0] - corner[0]).abs() < near && (x[1] - corner[1]).abs() < near
    };
    let mut layers: Vec<Layer> = Vec::new();
    for (e, body) in body_of.iter().enumerate() {
        let Some(body) = *body else { continue };
        let nodes = hex_nodes(mesh, e);
        let mut levels: Vec<f64> =
            nodes.iter().filter(|&&n| on_edge(n)).map(|&n| mesh.nodes[n as usize][2]).collect();
        levels.sort_by(f64::total_cmp);
        levels.dedup_by(|a, b| (*a - *b).abs() < near);
        if let [bottom, top] = levels[..] {
            layers.push(Layer { bottom, top, body, element: e as u32 });
        }
    }
    layers.sort_by(|a, b| a.bottom.total_cmp(&b.bottom));
    let doubled = |pair: &[Layer]| (pair[0].bottom - pair[1].bottom).abs() < near;
    if layers.windows(2).any(|pair| doubled(pair) && !same(&bodies[pair[0].body], &bodies[pair[1].body])) {
        return Err(format!("two materials meet along the vertical edge {place}"));
    }
    layers.dedup_by(|a, b| (a.bottom - b.bottom).abs() < near);
    match layers.first() {
        None => Err(format!("no element has a vertical edge {place}")),
        Some(first) if (first.bottom - low[2]).abs() > near => {
            Err(format!("the elements {place} do not reach down to the base"))
        }
        _ if layers.windows(2).any(|pair| (pair[0].top - pair[1].bottom).abs() > near) => {
            Err(format!("the elements {place} leave a gap"))
        }
        _ => Ok(layers),
    }
}

/// Refuses ground along the vertical edge at a corner that comes or goes: the column is the same in all stages.
fn changes(mesh: &Mesh, lives: &[Life], [x, y]: [f64; 2]) -> Result<(), String> {
    let near = near(mesh);
    let on_edge = |n: u32| {
        let at = mesh.nodes[n as usize];
        (at[0] - x).abs() < near && (at[1] - y).abs() < near
    };
    let later = lives.iter().enumerate().filter(|(_, life)| **life != Life::ALWAYS);
    let found =
        later.map(|(e, _)| e).find(|&e| mesh.elements[e].nodes().iter().filter(|&&n| on_edge(n)).count() > 1);
    match found {
        Some(_) => {
            Err(format!("the ground along the vertical edge at ({x:.1}, {y:.1}) m changes with the stages"))
        }
        None => Ok(()),
    }
}

/// Refuses an interface across the vertical edge at a corner: the column is of ground that hangs together.
fn crossed(interfaces: &[Interface], layers: &[Layer], [x, y]: [f64; 2]) -> Result<(), String> {
    let side = |interface: &Interface, layer: &Layer| {
        interface.sides.iter().position(|elements| elements.contains(&layer.element))
    };
    for interface in interfaces {
        let apart = |pair: &[Layer]| matches!([side(interface, &pair[0]), side(interface, &pair[1])], [Some(a), Some(b)] if a != b);
        if layers.windows(2).any(apart) {
            return Err(format!(
                "the interface '{}' crosses the vertical edge at ({x:.1}, {y:.1}) m",
                interface.name
            ));
        }
    }
    Ok(())
}

/// Puts on the column's top, which is the mesh's last element, what presses on the top face of the element beside it.
pub fn press(mesh: &Mesh, tractions: &mut [Traction], beside: u32) {
    let near = near(mesh);
    let (_, high) = mesh.bounds();
    let on_top = |face: Face| mesh.face_nodes(face).all(|n| mesh.nodes[n as usize][2] > high[2] - near);
    let element = mesh.elements.len() as u32 - 1;
    let sides = mesh.elements[element as usize].shape.faces().len() as u8;
    let Some(top) = (0..sides).map(|side| Face { element, side }).find(|&face| on_top(face)) else { return };
    for traction in tractions {
        let above = traction.faces.iter().find(|(face, _)| face.element == beside && on_top(*face));
        if let Some(&(_, stress)) = above {
            traction.faces.push((top, stress));
        }
    }
}

/// Adds the column beside the mesh: layers and materials of the ground. Returns the element beside each of its own as well.
pub fn build(mesh: &mut Mesh, bodies: &mut Vec<Body>, ground: Ground) -> (Column, Vec<u32>) {
    let (low, high) = mesh.bounds();
    let Ground { layers } = ground;
    let like = layers.iter().map(|layer| layer.element).collect();
    let users = bodies.len();
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
    let bottom_body = layers[0].body;
    let mut below = ring(mesh, layers[0].bottom);
    let mut rings = vec![below];
    for Layer { top, body, .. } in layers {
        let above = ring(mesh, top);
        let element = mesh.elements.len() as u32;
        mesh.elements.push(Element::new(
            Shape::Hex8,
            &[below[0], below[1], below[2], below[3], above[0], above[1], above[2], above[3]],
        ));
        let name = format!("reference column ({})", bodies[body].name);
        // Ground of one stuff is one body, whatever groups it lies in: theory goes by it.
        let like = &bodies[body];
        match bodies[users..].iter().position(|column| same(column, like)).map(|k| &mut bodies[users + k]) {
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
    (Column { rings, bottom_body }, like)
}
