//! From the section to the mesh: extrusion along y, groups, face sets, named points.

use std::collections::HashMap;

use super::section::{Part, Section};
use super::{CavernError, CavernSpec};
use crate::boxes::MOST_ELEMENTS;
use crate::mesh::{Element, Face, Mesh, Shape};

/// Side of the hexahedron (in the order of [`Shape::faces`]) over each edge of its quadrilateral.
const SIDES: [u8; 4] = [4, 1, 5, 0];
const YMIN: u8 = 2;
const YMAX: u8 = 3;

pub(super) fn extrude(spec: &CavernSpec, section: &Section) -> Result<Mesh, CavernError> {
    let layers = section.y.len() - 1;
    let elements = section.quads.len() as u64 * layers as u64;
    if elements > MOST_ELEMENTS {
        return Err(CavernError::TooMany { elements: elements as f64 });
    }
    let mut mesh = Mesh::default();
    mesh.nodes.reserve(section.points.len() * section.y.len());
    for &y in &section.y {
        mesh.nodes.extend(section.points.iter().map(|p| [p[0], y, p[1]]));
    }
    let plane = section.points.len() as u32;
    mesh.elements.reserve(elements as usize);
    for layer in 0..layers as u32 {
        for &quad in &section.quads {
            let [a, b, c, d] = quad.map(|n| n + layer * plane);
            let nodes = [a, b, b + plane, a + plane, d, c, c + plane, d + plane];
            mesh.elements.push(Element { shape: Shape::Hex8, nodes });
        }
    }
    group(spec, section, layers, &mut mesh);
    faces(spec, section, layers, &mut mesh);
    points(spec, &mut mesh);
    Ok(mesh)
}

fn group(spec: &CavernSpec, section: &Section, layers: usize, mesh: &mut Mesh) {
    let quads = section.quads.len() as u32;
    for layer in 0..layers as u32 {
        for (q, part) in (layer * quads..).zip(&section.parts) {
            let mut add = |name: String| mesh.groups.entry(name).or_default().push(q);
            let name = |k: u32| &spec.caverns[k as usize].name;
            match *part {
                Part::Rock => add("rock".to_owned()),
                Part::Crown(k) => add(format!("{}.lining.crown", name(k))),
                Part::Walls(k) => add(format!("{}.lining.walls", name(k))),
                Part::Floor(k) => add(format!("{}.lining.floor", name(k))),
                Part::Bench(k, bench) => add(format!("{}.bench{bench}", name(k))),
            }
            if let Some(k) = part.lining() {
                add(format!("{}.lining", name(k)));
            }
            if let Some(k) = part.opening() {
                add(format!("{}.excavation", name(k)));
            }
        }
    }
}

fn faces(spec: &CavernSpec, section: &Section, layers: usize, mesh: &mut Mesh) {
    let quads = section.quads.len() as u32;
    for name in ["xmin", "xmax", "base", "top"] {
        mesh.faces.insert(name.to_owned(), Vec::new());
    }
    for (name, side, layer) in [("ymin", YMIN, 0), ("ymax", YMAX, layers as u32 - 1)] {
        let set = (0..quads).map(|q| Face { element: q + layer * quads, side }).collect();
        mesh.faces.insert(name.to_owned(), set);
    }
    let mut add = |name: String, q: usize, side: u8| {
        let set = mesh.faces.entry(name).or_default();
        set.extend((0..layers as u32).map(|layer| Face { element: q as u32 + layer * quads, side }));
    };
    // Each edge's other quadrilateral.
    let mut owners: HashMap<[u32; 2], [Option<usize>; 2]> = HashMap::with_capacity(2 * section.quads.len());
    let key = |a: u32, b: u32| [a.min(b), a.max(b)];
    for (q, quad) in section.quads.iter().enumerate() {
        for i in 0..4 {
            let owner = owners.entry(key(quad[i], quad[(i + 1) % 4])).or_default();
            let second = usize::from(owner[0].is_some());
            owner[second] = Some(q);
        }
    }
    for (q, quad) in section.quads.iter().enumerate() {
        for i in 0..4 {
            let (a, b) = (quad[i], quad[(i + 1) % 4]);
            let both = owners[&key(a, b)];
            let other = if both[0] == Some(q) { both[1] } else { both[0] };
            let Some(other) = other else {
                let (p, r) = (section.points[a as usize], section.points[b as usize]);
                let on = |axis: usize, side: usize| {
                    let plane = section.block[axis][side];
                    p[axis] == plane && r[axis] == plane
                };
                for (name, axis, side) in [("xmin", 0, 0), ("xmax", 0, 1), ("base", 1, 0), ("top", 1, 1)] {
                    if on(axis, side) {
                        add(name.to_owned(), q, SIDES[i]);
                    }
                }
                continue;
            };
            let (mine, theirs) = (section.parts[q], section.parts[other]);
            let unlined = |k: u32| spec.caverns[k as usize].lining.is_none();
            match (mine.lining(), theirs) {
                (Some(k), Part::Bench(..)) => {
                    add(format!("{}.intrados", spec.caverns[k as usize].name), q, SIDES[i])
                }
                (Some(k), Part::Rock) => {
                    add(format!("{}.extrados", spec.caverns[k as usize].name), q, SIDES[i])
                }
                (None, Part::Bench(k, _)) if mine == Part::Rock && unlined(k) => {
                    add(format!("{}.intrados", spec.caverns[k as usize].name), q, SIDES[i]);
                }
                _ => {}
            }
        }
    }
    for set in mesh.faces.values_mut() {
        set.sort_unstable();
    }
}

fn points(spec: &CavernSpec, mesh: &mut Mesh) {
    let first = &spec.caverns[0];
    for cavern in &spec.caverns {
        let x = cavern.at[0] - first.at[0];
        let z = cavern.at[1] - first.at[1] - spec.overburden - first.height;
        let arc = super::profile::Profile::new(cavern).inner;
        // Half the height lies on the wall, unless the arch takes more than half: then its springing.
        let wall = (cavern.height / 2.0).min(arc.springing);
        let mut add = |name: &str, at: [f64; 2]| {
            mesh.points.insert(format!("{}.{name}", cavern.name), [x + at[0], 0.0, z + at[1]]);
        };
        add("crown", [0.0, cavern.height]);
        add("floor", [0.0, 0.0]);
        add("wall.left", [-arc.half, wall]);
        add("wall.right", [arc.half, wall]);
    }
}
