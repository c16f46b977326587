//! Places of a model as people are told of them.

use tremolite_engine::Seam;
use tremolite_engine::hexahedra::centroid;
use tremolite_engine::model::Model;
use tremolite_mesh::Mesh;
use tremolite_results::{Said, said};

/// A point \[m\], the same in all languages.
pub fn point([x, y, z]: [f64; 3]) -> String {
    format!("({x:.1}, {y:.1}, {z:.1}) m")
}

/// An element by its number in the user's file, and the smallest group that holds it; one of a slab or column by that of which
/// it was made.
pub fn element(model: &Model, element: usize) -> Said {
    let parent = model.parents[element] as usize;
    if parent != element {
        let in_slab = model.slabs.iter().any(|slab| slab.sheet.elements().any(|e| e as usize == element));
        let of = self::element(model, parent);
        return match in_slab {
            true => said!("{element}, as it goes on outside the side", element = of),
            false => said!("{element}, as it goes on in a column", element = of),
        };
    }
    let holds = |elements: &[u32]| elements.contains(&(element as u32));
    let groups = model.mesh.groups.iter().filter(|(_, elements)| holds(elements));
    let smallest = groups.min_by_key(|(_, elements)| elements.len()).map(|(name, _)| name);
    let name = smallest.or_else(|| model.bodies.iter().find(|b| holds(&b.elements)).map(|b| &b.name));
    let number = model.mesh.element_id(element).to_string();
    match name {
        Some(name) => said!("element {number} of '{group}'", number = number, group = name),
        None => said!("element {number}", number = number),
    }
}

/// An element with its centre, to the centimetre.
pub fn element_at(model: &Model, element: u32) -> Said {
    let [x, y, z] = centroid(&model.mesh, element);
    let place = format!("({x:.2}, {y:.2}, {z:.2}) m");
    said!("{what} at {place}", what = self::element(model, element as usize), place = place)
}

/// A pair: its interface, the number of its node, and where that is.
pub fn pair(mesh: &Mesh, seam: &Seam, pair: usize) -> Said {
    let node = mesh.node_id(seam.pairs[pair].nodes[1] as usize).to_string();
    let place = point(seam.place(mesh, pair));
    said!("interface '{name}' at node {node} at {place}", name = &seam.name, node = node, place = place)
}

/// A part that sets the step, by its name.
pub fn part(name: &str) -> Said {
    if let Some(name) = name.strip_prefix("interface '").and_then(|rest| rest.strip_suffix('\'')) {
        return said!("interface '{name}'", name = name);
    }
    match name {
        "springs of the base" => said!("springs of the base"),
        "base of the free field" => said!("base of the free field"),
        // A group of bolts, a body, a part of another program's.
        name => said!("{name}", name = name),
    }
}
