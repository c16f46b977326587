//! The outer faces of parts, and what lies behind each.

use std::collections::HashMap;

use tremolite_results::hexahedron::FACES;

use super::mesh::Mesh;

/// What an outer face looks upon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Behind {
    /// The end of the model: nothing of it lies in that direction.
    Side = 0,
    /// Another part, or the other wall of a fault in the same.
    Part = 1,
    /// An opening: nothing at the face, and the model again beyond.
    Opening = 2,
}

/// An outer face as cell × 6 + face, with what lies behind it.
pub type Outer = (u32, Behind);

/// A face that nothing touches, as it stands in space.
struct Bare {
    part: usize,
    index: usize,
    low: [f64; 3],
    high: [f64; 3],
    centre: [f64; 3],
    /// Outward, of any length; and the axis along which it looks before all.
    normal: [f64; 3],
    axis: usize,
}

/// The outer faces of each part, ascending: those at which one cell of the part stands. Parts touch where corners lie at the
/// same place to the last bit, as those of interfaces do.
pub fn outer(parts: &[&Mesh]) -> Vec<Vec<Outer>> {
    let places = weld(parts);
    let alone: Vec<Vec<(u32, [u32; 4])>> = parts.iter().map(|mesh| alone(mesh)).collect();
    let key = |part: usize, corners: &[u32; 4]| sorted(corners.map(|c| places[part][c as usize]));
    let mut number: HashMap<[u32; 4], u32> = HashMap::new();
    for (part, faces) in alone.iter().enumerate() {
        faces.iter().for_each(|(_, corners)| *number.entry(key(part, corners)).or_insert(0) += 1);
    }
    let mut bare: Vec<Bare> = Vec::new();
    let mut outer: Vec<Vec<Outer>> = Vec::new();
    for (part, faces) in alone.iter().enumerate() {
        let behind = |(index, (face, corners)): (usize, &(u32, [u32; 4]))| {
            if number[&key(part, corners)] > 1 {
                return (*face, Behind::Part);
            }
            bare.push(Bare::of(part, index, corners.map(|c| parts[part].points[c as usize])));
            (*face, Behind::Side)
        };
        outer.push(faces.iter().enumerate().map(behind).collect());
    }
    for face in openings(&bare) {
        outer[face.part][face.index].1 = Behind::Opening;
    }
    outer
}

/// For each part and point a number that points at one place share.
fn weld(parts: &[&Mesh]) -> Vec<Vec<u32>> {
    let mut known: HashMap<[u64; 3], u32> = HashMap::new();
    let mut number = |point: &[f64; 3]| {
        let next = known.len() as u32;
        // −0 and 0 are one place.
        *known.entry(point.map(|x| (x + 0.0).to_bits())).or_insert(next)
    };
    parts.iter().map(|mesh| mesh.points.iter().map(&mut number).collect()).collect()
}

fn sorted(mut corners: [u32; 4]) -> [u32; 4] {
    corners.sort_unstable();
    // Triangles repeat one corner; which one must not matter.
    if let Some(k) = (1..4).find(|&k| corners[k] == corners[k - 1]) {
        corners[k..].rotate_left(1);
        corners[3] = u32::MAX;
    }
    corners
}

/// Faces of one cell, ascending, with their corners; those without area are none.
fn alone(mesh: &Mesh) -> Vec<(u32, [u32; 4])> {
    let mut seen: HashMap<[u32; 4], (u32, [u32; 4], bool)> = HashMap::new();
    for cell in 0..mesh.elements.len() {
        let own = mesh.cell(cell);
        for (k, face) in FACES.iter().enumerate() {
            let corners = face.map(|c| own[c]);
            let key = sorted(corners);
            if key[0] == key[1] || key[1] == key[2] || key[2] == key[3] {
                continue;
            }
            let index = (cell * 6 + k) as u32;
            seen.entry(key).and_modify(|(.., single)| *single = false).or_insert((index, corners, true));
        }
    }
    let mut faces: Vec<(u32, [u32; 4])> = seen
        .into_values()
        .filter(|(.., single)| *single)
        .map(|(index, corners, _)| (index, corners))
        .collect();
    faces.sort_unstable();
    faces
}

impl Bare {
    fn of(part: usize, index: usize, corners: [[f64; 3]; 4]) -> Self {
        let across = |a: usize, b: usize| [0, 1, 2].map(|i| corners[b][i] - corners[a][i]);
        let (p, q) = (across(0, 2), across(1, 3));
        let normal = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
        let axis = (0..3).max_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs())).unwrap_or(0);
        Bare {
            part,
            index,
            low: [0, 1, 2].map(|i| corners.iter().map(|c| c[i]).fold(f64::INFINITY, f64::min)),
            high: [0, 1, 2].map(|i| corners.iter().map(|c| c[i]).fold(f64::NEG_INFINITY, f64::max)),
            centre: [0, 1, 2].map(|i| corners.iter().map(|c| c[i]).sum::<f64>() / 4.0),
            normal,
            axis,
        }
    }
}

/// Fields into which a plane is cut, along each of its axes, to find faces by their place.
const CUTS: usize = 64;

/// Bare faces that see another beyond, in the direction in which they look before all: walls of caverns see the other wall,
/// while sides, slopes and the ground's surface see nothing. Faces are taken as the boxes around them.
fn openings(bare: &[Bare]) -> Vec<&Bare> {
    let mut found = Vec::new();
    for axis in 0..3 {
        let plane = [(axis + 1) % 3, (axis + 2) % 3];
        let ends = plane.map(|i| {
            let low = bare.iter().map(|face| face.low[i]).fold(f64::INFINITY, f64::min);
            (low, bare.iter().map(|face| face.high[i]).fold(low, f64::max))
        });
        let field = |side: usize, x: f64| {
            let (low, high) = ends[side];
            (((x - low) / (high - low) * CUTS as f64) as usize).min(CUTS - 1)
        };
        let mut fields: Vec<Vec<&Bare>> = vec![Vec::new(); CUTS * CUTS];
        // A floor beside a wall sees the steep springing of the crown, which looks sideways before all.
        let looks_along = |face: &&Bare| face.normal[axis].abs() > 1e-6 * face.normal[face.axis].abs();
        for face in bare.iter().filter(looks_along) {
            for a in field(0, face.low[plane[0]])..=field(0, face.high[plane[0]]) {
                for b in field(1, face.low[plane[1]])..=field(1, face.high[plane[1]]) {
                    fields[a * CUTS + b].push(face);
                }
            }
        }
        let sees = |face: &&Bare| {
            let [a, b] = [0, 1].map(|side| field(side, face.centre[plane[side]]));
            fields[a * CUTS + b].iter().any(|other| {
                let beyond = other.centre[axis] - face.centre[axis];
                other.normal[axis] * face.normal[axis] < 0.0
                    && beyond * face.normal[axis] > 0.0
                    && plane.iter().all(|&i| (other.low[i]..=other.high[i]).contains(&face.centre[i]))
            })
        };
        found.extend(bare.iter().filter(|face| face.axis == axis).filter(sees));
    }
    found
}

/// The faces of an interface, which are its cells.
pub fn of_interface(mesh: &Mesh) -> Vec<Outer> {
    (0..mesh.elements.len() as u32).map(|cell| (cell * 6, Behind::Part)).collect()
}
