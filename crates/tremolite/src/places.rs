//! Places of a model as people are told of them.

use tremolite_engine::Seam;
use tremolite_engine::hexahedra::centroid;
use tremolite_engine::model::Model;
use tremolite_mesh::{Face, Mesh};
use tremolite_results::{Said, said};

/// A point \[m\] to the decimetre, the same in all languages.
pub fn point(at: [f64; 3]) -> String {
    coordinates(at, 1)
}

/// With a minus rather than a hyphen, as tables of the page have it.
fn coordinates(at: [f64; 3], digits: usize) -> String {
    let [x, y, z] = at.map(|c| format!("{c:.digits$}").replace('-', "−"));
    format!("({x}, {y}, {z}) m")
}

/// An element by its number in the user's file, and the smallest group that holds it; one of a slab or column by that of which
/// it was made.
pub fn element(model: &Model, element: usize) -> Said {
    let parent = model.elements.parents[element] as usize;
    if parent != element {
        let in_slab =
            model.outside.slabs.iter().any(|slab| slab.sheet.elements().any(|e| e as usize == element));
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
    let place = coordinates(centroid(&model.mesh, element), 2);
    said!("{what} at {place}", what = self::element(model, element as usize), place = place)
}

/// An element with its centre, and an interface that has one of its nodes.
pub fn element_beside(model: &Model, element: u32) -> Said {
    let of =
        |e: u32| model.mesh.elements[e as usize].nodes().iter().map(|&n| model.parted.places[n as usize]);
    let own: Vec<u32> = of(element).collect();
    let touches = |face: &Face| of(face.element).any(|place| own.contains(&place));
    let beside = model.user_seams().iter().find(|seam| seam.faces.iter().flatten().any(touches));
    let at = element_at(model, element);
    match beside {
        Some(seam) => said!("{what}, beside interface '{name}'", what = at, name = &seam.name),
        None => at,
    }
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
        "springs of the sides" => said!("springs of the sides"),
        "sides of the free field" => said!("sides of the free field"),
        // A group of bolts, a body, a part of another program's.
        name => said!("{name}", name = name),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_have_a_minus() {
        assert_eq!(point([-30.04, 0.0, -237.16]), "(−30.0, 0.0, −237.2) m");
        assert_eq!(coordinates([1.0, -2.5, 3.126], 2), "(1.00, −2.50, 3.13) m");
    }
}
