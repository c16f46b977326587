//! From the section to the mesh: extrusion along y, groups, face sets, named points.

use std::collections::HashMap;

use super::along::SAME;
use super::profile::Outline;
use super::section::{Part, Section};
use super::{CavernError, CavernSpec, ground, strata};
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
        return Err(CavernError::TooMany { elements: elements as f64, near: spec.near, along: spec.step() });
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
    let parts = parts(spec, section);
    group(spec, &parts, &mut mesh);
    faces(spec, section, &parts, &mut mesh);
    points(spec, &mut mesh);
    ground::lift(&spec.ground, [section.cover(), section.block[1][1]], spec.near, &mut mesh)?;
    strata::group(&spec.layers, &mut mesh);
    Ok(mesh)
}

/// What each element belongs to, layer by layer along y: the section's parts, but for the galleries, and rock beyond the
/// ends of caverns.
fn parts(spec: &CavernSpec, section: &Section) -> Vec<Part> {
    let layers = section.y.len() - 1;
    let mut parts = section.parts.repeat(layers);
    let within = |layer: usize, [from, to]: [f64; 2]| {
        section.y[layer] > from - SAME && section.y[layer + 1] < to + SAME
    };
    let ends: Vec<[f64; 2]> = spec.caverns.iter().map(|c| spec.ends(c)).collect();
    for (layer, parts) in parts.chunks_mut(section.quads.len()).enumerate() {
        for part in parts {
            if part.cavern().is_some_and(|k| !within(layer, ends[k as usize])) {
                *part = Part::Rock;
            }
        }
    }
    for (g, (gallery, passage)) in (0..).zip(spec.galleries.iter().zip(&section.passages)) {
        let along: Vec<usize> = (0..layers).filter(|&l| within(l, gallery.walls())).collect();
        for (q, quad) in section.quads.iter().enumerate() {
            let middle =
                [0, 1].map(|c| quad.iter().map(|&n| section.points[n as usize][c]).sum::<f64>() / 4.0);
            let inside = |range: [f64; 2], at: f64| at > range[0] && at < range[1];
            if !inside(passage.z, middle[1]) {
                continue;
            }
            let part = match section.parts[q] {
                Part::Rock if inside(passage.x, middle[0]) => Part::Gallery(g),
                // The wall on the side of the other cavern: from the outside in by no more than half the opening.
                Part::Walls(k, _) | Part::Shotcrete(k, _) => {
                    let [left, right] = passage.caverns;
                    let near = |edge: f64| (middle[0] - edge).abs() < 0.5 * spec.caverns[k as usize].width;
                    let facing =
                        k as usize == left && near(passage.x[0]) || k as usize == right && near(passage.x[1]);
                    if !facing {
                        continue;
                    }
                    Part::Opening(g)
                }
                _ => continue,
            };
            for &layer in &along {
                parts[layer * section.quads.len() + q] = part;
            }
        }
    }
    parts
}

fn group(spec: &CavernSpec, parts: &[Part], mesh: &mut Mesh) {
    for (q, part) in (0..).zip(parts) {
        let mut add = |name: String| mesh.groups.entry(name).or_default().push(q);
        let name = |k: u32| &spec.caverns[k as usize].name;
        match *part {
            Part::Rock => add("rock".to_owned()),
            Part::Crown(k, _) => add(format!("{}.lining.crown", name(k))),
            Part::Walls(k, _) => add(format!("{}.lining.walls", name(k))),
            Part::Floor(k, _) => add(format!("{}.lining.floor", name(k))),
            Part::Shotcrete(k, bench) => {
                add(format!("{}.shotcrete", name(k)));
                add(format!("{}.shotcrete{bench}", name(k)));
            }
            Part::Bench(k, bench) => add(format!("{}.bench{bench}", name(k))),
            Part::Gallery(g) => add(format!("{}.gallery", spec.galleries[g as usize].name)),
            Part::Opening(g) => add(format!("{}.opening", spec.galleries[g as usize].name)),
        }
        if let Some(k) = part.lining() {
            add(format!("{}.lining", name(k)));
            if let Some(bench) = part.bench() {
                add(format!("{}.lining{bench}", name(k)));
            }
        }
        if let Some(k) = part.opening() {
            add(format!("{}.excavation", name(k)));
        }
    }
}

fn faces(spec: &CavernSpec, section: &Section, parts: &[Part], mesh: &mut Mesh) {
    let quads = section.quads.len() as u32;
    let layers = section.y.len() - 1;
    for name in ["xmin", "xmax", "base", "top"] {
        mesh.faces.insert(name.to_owned(), Vec::new());
    }
    for (name, side, layer) in [("ymin", YMIN, 0), ("ymax", YMAX, layers as u32 - 1)] {
        let set = (0..quads).map(|q| Face { element: q + layer * quads, side }).collect();
        mesh.faces.insert(name.to_owned(), set);
    }
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
                        let along = (0..layers as u32).map(|layer| q as u32 + layer * quads);
                        let faces = along.map(|element| Face { element, side: SIDES[i] });
                        mesh.faces.entry(name.to_owned()).or_default().extend(faces);
                    }
                }
                continue;
            };
            for layer in 0..layers {
                let at = layer * section.quads.len();
                if let Some(name) = surface(spec, parts[at + q], parts[at + other]) {
                    let face = Face { element: (at + q) as u32, side: SIDES[i] };
                    mesh.faces.entry(name).or_default().push(face);
                }
            }
        }
    }
    // Galleries and caverns end between two layers.
    for (e, pair) in parts.iter().zip(parts.iter().skip(section.quads.len())).enumerate() {
        for (mine, theirs, element, side) in
            [(*pair.0, *pair.1, e, YMAX), (*pair.1, *pair.0, e + section.quads.len(), YMIN)]
        {
            let end = theirs.opening().filter(|_| mine == Part::Rock);
            let end = end.map(|k| format!("{}.ends", spec.caverns[k as usize].name));
            if let Some(name) = end.or_else(|| surface(spec, mine, theirs)) {
                let face = Face { element: element as u32, side };
                mesh.faces.entry(name).or_default().push(face);
            }
        }
    }
    for set in mesh.faces.values_mut() {
        set.sort_unstable();
    }
}

/// The face set of an element's face towards another element.
fn surface(spec: &CavernSpec, mine: Part, theirs: Part) -> Option<String> {
    let cavern = |k: u32| &spec.caverns[k as usize];
    // Shotcrete alone has the faces of a lining.
    let alone = |k: &u32| cavern(*k).lining.is_none();
    let beyond = theirs == Part::Rock || mine.lining().is_some() && theirs.shotcrete().is_some();
    match (mine.lining().or(mine.shotcrete().filter(alone)), theirs) {
        (Some(k), Part::Bench(..)) => Some(format!("{}.intrados", cavern(k).name)),
        (Some(k), _) if beyond => Some(format!("{}.extrados", cavern(k).name)),
        (None, Part::Bench(k, _)) if mine == Part::Rock && alone(&k) && cavern(k).shotcrete.is_none() => {
            Some(format!("{}.intrados", cavern(k).name))
        }
        (_, Part::Gallery(g) | Part::Opening(g)) if mine.gallery().is_none() && mine.opening().is_none() => {
            Some(format!("{}.surface", spec.galleries[g as usize].name))
        }
        _ => None,
    }
}

fn points(spec: &CavernSpec, mesh: &mut Mesh) {
    let first = &spec.caverns[0];
    for cavern in &spec.caverns {
        let x = cavern.at[0] - first.at[0];
        let y = if cavern.length.is_some() { cavern.middle } else { 0.0 };
        let z = cavern.at[1] - first.at[1] - spec.overburden - first.height;
        // Half the height lies on the wall, unless the arch takes more than half: then its springing.
        let (half, wall) = match Outline::new(cavern) {
            Outline::Walls(profile) => {
                (profile.inner.half, (cavern.height / 2.0).min(profile.inner.springing))
            }
            Outline::Closed(tube) => (tube.half_width(cavern.height / 2.0), cavern.height / 2.0),
        };
        let mut add = |name: &str, at: [f64; 2]| {
            mesh.points.insert(format!("{}.{name}", cavern.name), [x + at[0], y, z + at[1]]);
        };
        add("crown", [0.0, cavern.height]);
        add("floor", [0.0, 0.0]);
        add("wall.left", [-half, wall]);
        add("wall.right", [half, wall]);
    }
}
