//! Linings cast against the walls of empty holes.
//!
//! A node of the wall goes into the hole by the vector that lies the thickness off all of its wall faces, so that walls stay parallel to
//! their linings up to and into corners; on a side or the base of the mesh it stays there. Between a wall face and where its nodes went
//! stand hexahedra or wedges, which share the wall's nodes.

use std::collections::BTreeMap;
use std::fmt;

use crate::locate::Locator;
use crate::places::Place;
use crate::topology::{cross, dot, exterior_faces, minus, norm, root};
use crate::{Element, Face, Mesh, Shape, quality};

/// A lining to be cast. Lengths in metres.
#[derive(Clone, Debug, PartialEq)]
pub struct HoleLining {
    /// Its group, which no other has.
    pub name: String,
    /// Where the middles of the wall's faces lie; nothing: all holes, which are what bounds the mesh but its sides, its base and its ground.
    pub place: Option<Place>,
    /// At right angles to the wall.
    pub thickness: f64,
    /// Elements through the thickness.
    pub layers: usize,
}

/// What was cast.
#[derive(Clone, Debug, PartialEq)]
pub struct Cast {
    /// The faces that it was cast against, of elements of the mesh before.
    pub wall: Vec<Face>,
    /// Volume of the lining \[m³\].
    pub volume: f64,
}

/// Why a lining was not cast. Places in metres.
#[derive(Clone, Debug, PartialEq)]
pub enum CastError {
    /// The mesh has a group of that name.
    Known { name: String },
    /// It has no layer, or no thickness.
    Thin { name: String },
    /// No face of a hole lies there.
    NoWall { name: String, placed: bool },
    /// An element of it would be too poor: the scaled Jacobian there.
    Poor { name: String, at: [f64; 3], jacobian: f64 },
    /// It would lie in what is there already, or in itself.
    Overlap { name: String, at: [f64; 3] },
}

/// Least scaled Jacobian, as of elements that a plane cuts.
const JACOBIAN: f64 = 0.15;
/// Farther from the bounding planes, over the size of the mesh, a node is not on them.
const ON_PLANE: f64 = 1e-9;
/// What keeps directions in which a wall says nothing at rest, over the sum of the squares of its normals: small against what it says,
/// and large against round-off when the two meet in a determinant. An iteration leaves as small a share of the error.
const REST: f64 = 1e-6;
const ITERATIONS: usize = 3;
/// From so many faces of what hangs together is looked whether something of the mesh lies before them, from so far off, over a face's size.
const LOOKED_FROM: usize = 256;
const BEFORE: f64 = 1e-3;

impl fmt::Display for CastError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let at = |x: &[f64; 3]| format!("({:.2}, {:.2}, {:.2}) m", x[0], x[1], x[2]);
        match self {
            Self::Known { name } => write!(f, "the mesh has a group '{name}'; give the lining another name"),
            Self::Thin { name } => {
                write!(
                    f,
                    "'{name}' has no thickness or no layer; give a thickness above 0 and a layer at least"
                )
            }
            Self::NoWall { name, placed: true } => write!(
                f,
                "no face of a hole has its middle in the box of '{name}'; faces on the mesh's sides and base do not count; \
                 move the box"
            ),
            Self::NoWall { name, placed: false } => write!(
                f,
                "the mesh has no hole that '{name}' could line: all that bounds it are its sides, its base, what looks outwards as they do, and its \
                 ground with what hangs together with that; give a `box` round the walls of a hole that reaches the ground"
            ),
            Self::Poor { name, at: x, jacobian } => write!(
                f,
                "an element of '{name}' at {} would have a scaled Jacobian of {jacobian:.2}, below {JACOBIAN}: the wall is bent too \
                 sharply there for this thickness; give a lesser `thickness`, or mesh the lining",
                at(x)
            ),
            Self::Overlap { name, at: x } => write!(
                f,
                "'{name}' would lie in other elements, or in itself, at {}; give a lesser `thickness`, or a `box` that leaves out what \
                 is no wall of the hole",
                at(x)
            ),
        }
    }
}

impl std::error::Error for CastError {}

/// Casts a lining against the walls of holes. Its elements and nodes come after those that are there.
///
/// # Errors
/// Where there is no wall, or the lining finds no room. Then the mesh is as it was.
pub fn cast(mesh: &mut Mesh, lining: &HoleLining) -> Result<Cast, CastError> {
    let name = || lining.name.clone();
    if mesh.groups.contains_key(&lining.name) {
        return Err(CastError::Known { name: name() });
    }
    if !(lining.thickness > 0.0 && lining.thickness.is_finite()) || lining.layers == 0 {
        return Err(CastError::Thin { name: name() });
    }
    let planes = Bounds::of(mesh);
    let wall = wall(mesh, &planes, lining.place.as_ref());
    if wall.is_empty() {
        return Err(CastError::NoWall { name: name(), placed: lining.place.is_some() });
    }
    let ways = ways(mesh, &planes, &wall, lining.thickness);
    let (nodes, elements) = (mesh.nodes.len(), mesh.elements.len());
    grow(mesh, &wall, &ways, lining.layers);
    let new = elements as u32..mesh.elements.len() as u32;
    let fault = poor(mesh, new.clone(), lining).or_else(|| overlap(mesh, &wall, &ways, lining));
    if let Some(fault) = fault {
        mesh.nodes.truncate(nodes);
        mesh.elements.truncate(elements);
        return Err(fault);
    }
    let numbered = |ids: &mut Vec<u64>, count: usize| {
        if let Some(&last) = ids.iter().max() {
            let more = (count - ids.len()) as u64;
            ids.extend((1..=more).map(|k| last + k));
        }
    };
    numbered(&mut mesh.node_ids, mesh.nodes.len());
    numbered(&mut mesh.element_ids, mesh.elements.len());
    let volume = quality::summary_of(mesh, new.clone()).volume;
    mesh.groups.insert(name(), new.collect());
    Ok(Cast { wall, volume })
}

/// The planes that bound a mesh sideways and below.
struct Bounds {
    low: [f64; 3],
    high: [f64; 3],
    tolerance: f64,
}

impl Bounds {
    fn of(mesh: &Mesh) -> Self {
        let (low, high) = mesh.bounds();
        Bounds { low, high, tolerance: ON_PLANE * norm(minus(high, low)) }
    }

    /// The axes whose bounding planes a point lies on; the ground is none.
    fn held(&self, x: [f64; 3]) -> [bool; 3] {
        std::array::from_fn(|i| {
            (x[i] - self.low[i]).abs() <= self.tolerance
                || i < 2 && (x[i] - self.high[i]).abs() <= self.tolerance
        })
    }
}

/// The outer faces of a mesh that are walls of holes, ascending: not on its sides or its base, not its ground's surface or what hangs
/// together with that, and not what looks out of the mesh elsewhere.
pub fn walls(mesh: &Mesh) -> Vec<Face> {
    wall(mesh, &Bounds::of(mesh), None)
}

/// The faces of walls of holes, ascending.
fn wall(mesh: &Mesh, planes: &Bounds, place: Option<&Place>) -> Vec<Face> {
    let mut faces = exterior_faces(mesh, None);
    faces.retain(|&face| {
        let held = mesh.face_nodes(face).map(|n| planes.held(mesh.nodes[n as usize]));
        !held.fold([true; 3], |a, b| std::array::from_fn(|i| a[i] && b[i])).contains(&true)
    });
    match place {
        Some(place) => faces.retain(|&face| place.holds(middle(mesh, face))),
        None => leave_out_the_open(mesh, &mut faces),
    }
    faces
}

fn middle(mesh: &Mesh, face: Face) -> [f64; 3] {
    let count = mesh.face_nodes(face).count() as f64;
    std::array::from_fn(|i| mesh.face_nodes(face).map(|n| mesh.nodes[n as usize][i]).sum::<f64>() / count)
}

/// Drops the faces that hang together with the highest one, which is the ground, and those which hang together and look out of the mesh
/// rather than at one another, as where a corner of the block is cut off.
fn leave_out_the_open(mesh: &Mesh, faces: &mut Vec<Face>) {
    let mut parent: Vec<u32> = (0..mesh.nodes.len() as u32).collect();
    let first = |face: Face| mesh.face_nodes(face).next().unwrap_or_default();
    for &face in faces.iter() {
        for node in mesh.face_nodes(face).skip(1) {
            let (a, b) = (root(&mut parent, first(face)), root(&mut parent, node));
            parent[a.max(b) as usize] = a.min(b);
        }
    }
    let height = |face: &Face| {
        mesh.face_nodes(*face).map(|n| mesh.nodes[n as usize][2]).fold(f64::NEG_INFINITY, f64::max)
    };
    let Some(&highest) = faces.iter().max_by(|a, b| height(a).total_cmp(&height(b))) else { return };
    let ground = root(&mut parent, first(highest));
    let mut parts: BTreeMap<u32, Vec<Face>> = BTreeMap::new();
    for &face in faces.iter() {
        parts.entry(root(&mut parent, first(face))).or_default().push(face);
    }
    parts.remove(&ground);
    if parts.is_empty() {
        faces.clear();
        return;
    }
    let locator = Locator::new(mesh, None);
    *faces = parts.into_values().filter(|part| looks_inwards(mesh, &locator, part)).flatten().collect();
    faces.sort_unstable();
}

/// Whether half of the area of some faces has something of the mesh before it: then they are walls of a hole.
fn looks_inwards(mesh: &Mesh, locator: &Locator, faces: &[Face]) -> bool {
    let (low, high) = mesh.bounds();
    let far = norm(minus(high, low));
    let (mut all, mut inwards) = (0.0, 0.0);
    for &face in faces.iter().step_by(1 + faces.len() / LOOKED_FROM) {
        let x: Vec<[f64; 3]> = mesh.face_nodes(face).map(|n| mesh.nodes[n as usize]).collect();
        let twice = cross(minus(x[2], x[0]), minus(x[x.len() - 1], x[1]));
        let area = norm(twice);
        let off = |distance: f64| std::array::from_fn(|i| middle(mesh, face)[i] + distance / area * twice[i]);
        let near = BEFORE * area.sqrt();
        all += area;
        if !locator.stretches(off(near), off(far)).is_empty() {
            inwards += area;
        }
    }
    inwards > 0.5 * all
}

/// Where each node of the wall goes to \[m\]: least squares of n·d = thickness over the corners of its faces, and nothing across planes
/// that it lies on.
fn ways(mesh: &Mesh, planes: &Bounds, wall: &[Face], thickness: f64) -> BTreeMap<u32, [f64; 3]> {
    let mut normals: BTreeMap<u32, Vec<[f64; 3]>> = BTreeMap::new();
    for &face in wall {
        let nodes: Vec<u32> = mesh.face_nodes(face).collect();
        let x: Vec<[f64; 3]> = nodes.iter().map(|&n| mesh.nodes[n as usize]).collect();
        for k in 0..nodes.len() {
            let (next, last) = ((k + 1) % nodes.len(), (k + nodes.len() - 1) % nodes.len());
            let normal = cross(minus(x[next], x[k]), minus(x[last], x[k]));
            let size = norm(normal);
            normals.entry(nodes[k]).or_default().push(normal.map(|n| n / size));
        }
    }
    normals
        .into_iter()
        .map(|(node, normals)| {
            let held = planes.held(mesh.nodes[node as usize]);
            let (mut matrix, mut right) = ([[0.0; 3]; 3], [0.0; 3]);
            for normal in normals {
                let n: [f64; 3] = std::array::from_fn(|i| if held[i] { 0.0 } else { normal[i] });
                for i in 0..3 {
                    right[i] += thickness * n[i];
                    (0..3).for_each(|j| matrix[i][j] += n[i] * n[j]);
                }
            }
            let rest = REST * (0..3).map(|i| matrix[i][i]).sum::<f64>();
            (0..3).for_each(|i| matrix[i][i] += rest);
            let mut way = [0.0; 3];
            for _ in 0..ITERATIONS {
                let left: [f64; 3] = std::array::from_fn(|i| right[i] + rest * way[i]);
                way = solved(matrix, left);
            }
            (node, way)
        })
        .collect()
}

/// Cramer's rule; of a positive definite matrix.
fn solved(m: [[f64; 3]; 3], b: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = m;
    let determinant = dot(x, cross(y, z));
    let columns = [cross(y, z), cross(z, x), cross(x, y)];
    std::array::from_fn(|i| (0..3).map(|k| b[k] * columns[k][i]).sum::<f64>() / determinant)
}

/// Appends the nodes and the elements.
fn grow(mesh: &mut Mesh, wall: &[Face], ways: &BTreeMap<u32, [f64; 3]>, layers: usize) {
    let mut stack: BTreeMap<u32, Vec<u32>> = ways.keys().map(|&node| (node, vec![node])).collect();
    for layer in 1..=layers {
        let share = layer as f64 / layers as f64;
        for (node, way) in ways {
            let x = mesh.nodes[*node as usize];
            mesh.nodes.push(std::array::from_fn(|i| x[i] + share * way[i]));
            if let Some(nodes) = stack.get_mut(node) {
                nodes.push(mesh.nodes.len() as u32 - 1);
            }
        }
    }
    for layer in 0..layers {
        for &face in wall {
            let [low, high] =
                [layer, layer + 1].map(|k| mesh.face_nodes(face).map(|n| stack[&n][k]).collect::<Vec<u32>>());
            let shape = if low.len() == 4 { Shape::Hex8 } else { Shape::Wedge6 };
            mesh.elements.push(Element::new(shape, &[low, high].concat()));
        }
    }
}

/// The poorest of the new elements, where it is too poor.
fn poor(mesh: &Mesh, new: std::ops::Range<u32>, lining: &HoleLining) -> Option<CastError> {
    let jacobian = |e: u32| quality::of(mesh, e as usize).scaled_jacobian;
    let worst = new.min_by(|&a, &b| jacobian(a).total_cmp(&jacobian(b)))?;
    let least = jacobian(worst);
    // It is not a number where an edge has no length.
    (least.is_nan() || least < JACOBIAN).then(|| CastError::Poor {
        name: lining.name.clone(),
        at: crate::places::middle(mesh, worst),
        jacobian: least,
    })
}

/// Where a hundredth of the thickness before the new surface something lies already.
fn overlap(
    mesh: &Mesh,
    wall: &[Face],
    ways: &BTreeMap<u32, [f64; 3]>,
    lining: &HoleLining,
) -> Option<CastError> {
    let before = |node: u32, share: f64| -> [f64; 3] {
        std::array::from_fn(|i| mesh.nodes[node as usize][i] + share * ways[&node][i])
    };
    let faces = wall.iter().map(|&face| {
        let points: Vec<[f64; 3]> = mesh.face_nodes(face).map(|n| before(n, 1.01)).collect();
        std::array::from_fn(|i| points.iter().map(|x| x[i]).sum::<f64>() / points.len() as f64)
    });
    let nodes = ways.keys().map(|&node| before(node, 1.01));
    let locator = Locator::new(mesh, None);
    let inside = faces.chain(nodes).find(|&x| locator.locate(x, 0.0).is_some());
    inside.map(|at| CastError::Overlap { name: lining.name.clone(), at })
}

#[cfg(test)]
mod tests;
