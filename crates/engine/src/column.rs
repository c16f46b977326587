//! Columns: the ground as it is far from the caverns, one element a layer, moving as one at each level.
//!
//! Their bottoms move as u_ff, the free field at the level of the base, on which the springs of the base act. They feel the same
//! incident wave through dashpots alone. Where all four sides are free field they stand at the ends of the
//! [slabs](crate::model::Outside::slabs); else the model has reference columns of the ground along its vertical edges, beside it.
//! Models whose base has no springs have them as well, to be compared with.

use crate::body::Body;
use crate::error::ModelError;
use crate::hexahedra::hex_nodes;
use crate::interface::Interface;
use crate::life::Life;
use crate::outer_faces::near;
use crate::sheet::Sheet;
use crate::traction::Traction;
use std::ops::Range;
use tremolite_laws::shapes::hex8::Hex8;
use tremolite_mesh::{Element, Face, Mesh, Shape};

/// Side of a reference column's square section \[m\]; its width cancels.
pub const WIDTH: f64 = 1.0;

/// A column of ground.
#[derive(Clone, Debug)]
pub struct Column {
    /// `reference` where one serves all corners, else by all corners that it serves: `reference-xmin-ymin+xmin-ymax`; at the end
    /// of a slab by the slab's side and the end.
    pub name: String,
    /// The corners of the model that it stands for: bit 0 for the high end of x, bit 1 for that of y.
    pub corners: Vec<usize>,
    /// A node of its top and of its bottom, in the mesh's numbering.
    pub top: u32,
    pub bottom: u32,
    /// Upwards.
    pub layers: Vec<Layer>,
    /// Its bodies, of the model's.
    pub bodies: Range<usize>,
    /// Whether an interface runs through it.
    pub parted: bool,
    /// The four nodes of each level of a reference column, which move as one; upwards.
    pub rings: Vec<[u32; 4]>,
    /// Its elements outside those of a slab, at whose end it stands.
    pub sheet: Option<Sheet>,
}

/// A layer of a column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// m
    pub bottom: f64,
    pub top: f64,
    /// Of the model's bodies.
    pub body: usize,
    /// An element of it, in the mesh.
    pub element: u32,
}

/// The planes across x and y, low and high.
pub const SIDES: [[&str; 2]; 2] = [["xmin", "xmax"], ["ymin", "ymax"]];

/// The corner at two ends of x and y.
pub fn corner_at(ends: [usize; 2]) -> usize {
    ends[0] + 2 * ends[1]
}

/// The ends of x and y at a corner.
pub fn ends_at(corner: usize) -> [usize; 2] {
    [corner & 1, corner >> 1]
}

/// The name of a corner, `xmin-ymax`.
pub fn corner_name(corner: usize) -> String {
    let [x, y] = ends_at(corner);
    format!("{}-{}", SIDES[0][x], SIDES[1][y])
}

/// Why springs of the base cannot be had.
pub fn refusal(reason: &str) -> ModelError {
    ModelError::Column(format!(
        "the springs of the base act on what differs from the free field of columns of the ground along the model's vertical \
         edges, but {reason}; use base = \"viscous\" instead"
    ))
}

/// A layer of ground along a vertical edge of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Stratum {
    bottom: f64,
    top: f64,
    body: usize,
    element: u32,
}

/// The ground along the vertical edge at a corner of the model, upwards.
#[derive(Clone, Debug)]
pub struct Ground {
    layers: Vec<Stratum>,
}

impl Ground {
    /// Its layers, upwards, an element each; bodies are those that [`grounds`] was given.
    pub fn layers(&self) -> impl DoubleEndedIterator<Item = Layer> {
        self.layers.iter().map(|&Stratum { bottom, top, body, element }| Layer { bottom, top, body, element })
    }
}

/// The ground along the four vertical edges of the model, by corner.
///
/// # Errors
/// Why there is no such ground, in words that may stand behind 'but'.
pub fn grounds(
    mesh: &Mesh,
    bodies: &[Body],
    body_of: &[Option<usize>],
    interfaces: &[Interface],
    lives: &[Life],
) -> Result<[Ground; 4], String> {
    let (low, high) = mesh.bounds();
    let ground = |corner: usize| -> Result<Ground, String> {
        let ends = ends_at(corner);
        let at = [0, 1].map(|i| [low[i], high[i]][ends[i]]);
        changes(mesh, lives, at)?;
        let layers = along(mesh, bodies, body_of, at)?;
        crossed(interfaces, &layers, at)?;
        Ok(Ground { layers })
    };
    Ok([ground(0)?, ground(1)?, ground(2)?, ground(3)?])
}

/// Whether two edges have the same ground.
fn alike(a: &Ground, b: &Ground, bodies: &[Body], near: f64) -> bool {
    a.layers.len() == b.layers.len()
        && a.layers.iter().zip(&b.layers).all(|(a, b)| {
            (a.bottom - b.bottom).abs() < near
                && (a.top - b.top).abs() < near
                && same(&bodies[a.body], &bodies[b.body])
        })
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
) -> Result<Vec<Stratum>, String> {
    let near = near(mesh.bounds());
    let (low, _) = mesh.bounds();
    let place = format!("at the corner ({:.1}, {:.1}) m", corner[0], corner[1]);
    let on_edge = |n: u32| {
        let x = mesh.nodes[n as usize];
        (x[0] - corner[0]).abs() < near && (x[1] - corner[1]).abs() < near
    };
    let mut layers: Vec<Stratum> = Vec::new();
    for (e, body) in body_of.iter().enumerate() {
        let Some(body) = *body else { continue };
        let nodes = hex_nodes(mesh, e);
        let mut levels: Vec<f64> =
            nodes.iter().filter(|&&n| on_edge(n)).map(|&n| mesh.nodes[n as usize][2]).collect();
        levels.sort_by(f64::total_cmp);
        levels.dedup_by(|a, b| (*a - *b).abs() < near);
        if let [bottom, top] = levels[..] {
            layers.push(Stratum { bottom, top, body, element: e as u32 });
        }
    }
    layers.sort_by(|a, b| a.bottom.total_cmp(&b.bottom));
    let doubled = |pair: &[Stratum]| (pair[0].bottom - pair[1].bottom).abs() < near;
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

/// Refuses ground along the vertical edge at a corner that comes or goes: a reference column is the same in all stages.
fn changes(mesh: &Mesh, lives: &[Life], [x, y]: [f64; 2]) -> Result<(), String> {
    let near = near(mesh.bounds());
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
fn crossed(interfaces: &[Interface], layers: &[Stratum], [x, y]: [f64; 2]) -> Result<(), String> {
    let side = |interface: &Interface, layer: &Stratum| {
        interface.sides.iter().position(|elements| elements.contains(&layer.element))
    };
    for interface in interfaces {
        let apart = |pair: &[Stratum]| matches!([side(interface, &pair[0]), side(interface, &pair[1])], [Some(a), Some(b)] if a != b);
        if layers.windows(2).any(apart) {
            return Err(format!(
                "the interface '{}' crosses the vertical edge at ({x:.1}, {y:.1}) m",
                interface.name
            ));
        }
    }
    Ok(())
}

/// Puts on the top of each reference column what presses on the top face of the element beside it. `like` are the elements beside
/// theirs, column by column, and `surface` is the level of the model's top \[m\].
pub fn press(mesh: &Mesh, tractions: &mut [Traction], columns: &[Column], surface: f64, like: &[u32]) {
    let near = 1e-6 * (surface.abs() + WIDTH);
    let on_top = |face: Face| mesh.face_nodes(face).all(|n| mesh.nodes[n as usize][2] > surface - near);
    let mut element = mesh.elements.len() as u32 - like.len() as u32;
    let mut beside = like.iter();
    for column in columns {
        element += column.layers.len() as u32;
        let Some(&beside) = beside.by_ref().take(column.layers.len()).last() else { continue };
        let top = Face { element: element - 1, side: TOP };
        for traction in &mut *tractions {
            let above = traction.faces.iter().find(|(face, _)| face.element == beside && on_top(*face));
            if let Some(&(_, stress)) = above {
                traction.faces.push((top, stress));
            }
        }
    }
}

/// The upper face of a brick, by [`Shape::faces`].
const TOP: u8 = 5;

/// What was added beside the mesh.
pub struct Reference {
    pub columns: Vec<Column>,
    /// Of each element that was added, that of the model beside it.
    pub like: Vec<u32>,
}

/// Adds the reference columns beside the mesh: one for each ground that is found along the vertical edges.
pub fn build(
    mesh: &mut Mesh,
    bodies: &mut Vec<Body>,
    grounds: [Ground; 4],
    bounds: ([f64; 3], [f64; 3]),
) -> Reference {
    let ((low, high), near) = (bounds, near(bounds));
    let mut kinds: Vec<(Vec<usize>, &Ground)> = Vec::new();
    for (corner, ground) in grounds.iter().enumerate() {
        match kinds.iter_mut().find(|(_, known)| alike(known, ground, bodies, near)) {
            Some((corners, _)) => corners.push(corner),
            None => kinds.push((vec![corner], ground)),
        }
    }
    let one_for_all = kinds.len() == 1;
    let mut all = Reference { columns: Vec::new(), like: Vec::new() };
    for (corners, ground) in kinds {
        let corner = corners[0];
        let name = match one_for_all {
            true => "reference".to_owned(),
            false => {
                let served: Vec<String> = corners.iter().map(|&corner| corner_name(corner)).collect();
                format!("reference-{}", served.join("+"))
            }
        };
        // Beside the mesh, each at its own place, so that a picture with them shows them apart.
        let place = [low[0] - (high[0] - low[0]) - WIDTH, low[1] + corner as f64 * 2.0 * WIDTH];
        let column = one(mesh, bodies, ground, name, corners, place);
        all.like.extend(ground.layers.iter().map(|layer| layer.element));
        all.columns.push(column);
    }
    all
}

fn one(
    mesh: &mut Mesh,
    bodies: &mut Vec<Body>,
    ground: &Ground,
    name: String,
    corners: Vec<usize>,
    [x0, y0]: [f64; 2],
) -> Column {
    let first = bodies.len();
    let ring = |mesh: &mut Mesh, z: f64| -> [u32; 4] {
        let start = mesh.nodes.len() as u32;
        for (dx, dy) in [(0.0, 0.0), (WIDTH, 0.0), (WIDTH, WIDTH), (0.0, WIDTH)] {
            mesh.nodes.push([x0 + dx, y0 + dy, z]);
        }
        [start, start + 1, start + 2, start + 3]
    };
    let mut below = ring(mesh, ground.layers[0].bottom);
    let mut rings = vec![below];
    let mut layers = Vec::new();
    for &Stratum { bottom, top, body, .. } in &ground.layers {
        let above = ring(mesh, top);
        let element = mesh.elements.len() as u32;
        mesh.elements.push(Element::new(
            Shape::Hex8,
            &[below[0], below[1], below[2], below[3], above[0], above[1], above[2], above[3]],
        ));
        let body = own_body(bodies, first, body, &format!("column {name}"));
        bodies[body].elements.push(element);
        layers.push(Layer { bottom, top, body, element });
        below = above;
        rings.push(above);
    }
    Column {
        name,
        corners,
        top: below[0],
        bottom: rings[0][0],
        layers,
        bodies: first..bodies.len(),
        parted: false,
        rings,
        sheet: None,
    }
}

/// Width over thickness of [`widened`]: waves across it then add 0.4 % to the frequency of those along it.
const WIDE: f64 = 16.0;

/// An element of a reference column with a section so wide that its highest frequency is that of waves along the column. Nodes of a
/// level move as one, so the section of the column itself sets no frequency.
pub fn widened(own: &Hex8) -> Option<Hex8> {
    let [x0, y0, bottom] = own.corners[0];
    let factor = WIDE * (own.corners[4][2] - bottom) / WIDTH;
    Hex8::new(own.corners.map(|[x, y, z]| [x0 + factor * (x - x0), y0 + factor * (y - y0), z])).ok()
}

/// Among the bodies from `first` on that of the same stuff as another in elements of the same kind, which is added where there is
/// none: such ground is one body, whatever groups it lies in.
pub fn own_body(bodies: &mut Vec<Body>, first: usize, of: usize, name: &str) -> usize {
    let like = &bodies[of];
    let alike = |b: &Body| same(b, like) && b.quadrature == like.quadrature && b.viscosity == like.viscosity;
    if let Some(k) = bodies[first..].iter().position(alike) {
        return first + k;
    }
    let name = format!("{name} ({})", bodies[of].name);
    let body = Body { name, elements: Vec::new(), ..bodies[of].clone() };
    bodies.push(body);
    bodies.len() - 1
}
