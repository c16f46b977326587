//! Through the thickness: elements of a group stacked from one of its surfaces to the other.

use std::collections::{BTreeSet, HashMap};
use tremolite_mesh::{Mesh, Shape};

use tremolite_engine::hexahedra::hex;

/// Hexahedra from one surface of a group to the opposite one, each with the natural axis (0, 1, 2) along which it is
/// passed, in ascending order of elements.
pub type Stack = Vec<(u32, usize)>;

/// Faces of the group's hexahedra, by their nodes: the one or two elements that have it, each with the side.
type Faces = HashMap<[u32; 4], Vec<(u32, u8)>>;

fn key(mesh: &Mesh, element: u32, side: u8) -> [u32; 4] {
    let e = &mesh.elements[element as usize];
    let mut key = [0; 4];
    for (place, &corner) in key.iter_mut().zip(e.shape.faces()[side as usize]) {
        *place = e.nodes[corner];
    }
    key.sort_unstable();
    key
}

/// The stacks of a group of elements. From each hexahedron ways lead along its three natural axes, from face to
/// opposite face, until the group ends; one that is less than half as long as the others is through the thickness, unless it
/// leads through elements that have a shorter one.
/// Ways that come back, or end at a side of the model, which is a cut and no surface, are none. Where walls meet, and
/// in other shapes, nothing is a thickness.
pub fn stacks(mesh: &Mesh, elements: &[u32]) -> Vec<Stack> {
    let mut group = Group { mesh, faces: HashMap::new(), lengths: HashMap::new(), bounds: mesh.bounds() };
    for &e in elements.iter().filter(|&&e| mesh.elements[e as usize].shape == Shape::Hex8) {
        let Ok(hex) = hex(mesh, e as usize) else { continue };
        group.lengths.insert(e, hex.half_lengths.map(|h| 2.0 * h));
        for side in 0..6 {
            group.faces.entry(key(mesh, e, side)).or_default().push((e, side));
        }
    }
    let mut found = Vec::new();
    let mut shortest: HashMap<u32, f64> = HashMap::new();
    for &e in elements.iter().filter(|e| group.lengths.contains_key(e)) {
        let mut ways: Vec<(f64, Stack)> = (0..3).filter_map(|axis| group.way(e, axis)).collect();
        ways.sort_by(|a, b| a.0.total_cmp(&b.0));
        let next = ways.get(1).map_or(f64::INFINITY, |way| way.0);
        if let Some((length, stack)) = ways.into_iter().next()
            && length < 0.5 * next
        {
            for (e, _) in &stack {
                let least = shortest.entry(*e).or_insert(length);
                *least = least.min(length);
            }
            found.push((stack, length));
        }
    }
    // From a slab's corner the way along the slab is far shorter than that up the wall and over the crown.
    let through = |(stack, length): &(Stack, f64)| stack.iter().all(|(e, _)| *length < 1.5 * shortest[e]);
    found
        .into_iter()
        .filter(through)
        .map(|(stack, _)| stack)
        .collect::<BTreeSet<Stack>>()
        .into_iter()
        .collect()
}

/// The hexahedra of a group.
struct Group<'m> {
    mesh: &'m Mesh,
    faces: Faces,
    /// Lengths along the natural axes \[m\].
    lengths: HashMap<u32, [f64; 3]>,
    bounds: ([f64; 3], [f64; 3]),
}

impl Group<'_> {
    /// Whether a face lies on one of the model's vertical sides.
    fn is_cut(&self, element: u32, side: u8) -> bool {
        let (low, high) = self.bounds;
        let nodes = key(self.mesh, element, side).map(|n| self.mesh.nodes[n as usize]);
        (0..2).any(|i| {
            let near = 1e-6 * (high[i] - low[i]);
            [low[i], high[i]].iter().any(|plane| nodes.iter().all(|x| (x[i] - plane).abs() <= near))
        })
    }

    /// The way through an element along an axis, and its length \[m\].
    fn way(&self, element: u32, axis: usize) -> Option<(f64, Stack)> {
        let mut stack = vec![(element, axis)];
        let mut length = self.lengths[&element][axis];
        for start in [2 * axis as u8, 2 * axis as u8 + 1] {
            let (mut at, mut side) = (element, start);
            loop {
                let sharing = &self.faces[&key(self.mesh, at, side)];
                let Some(&(next, entered)) = sharing.iter().find(|(other, _)| *other != at) else { break };
                if stack.iter().any(|(e, _)| *e == next) {
                    return None;
                }
                stack.push((next, entered as usize / 2));
                length += self.lengths[&next][entered as usize / 2];
                (at, side) = (next, entered ^ 1);
            }
            if self.is_cut(at, side) {
                return None;
            }
        }
        stack.sort_unstable();
        Some((length, stack))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tremolite_mesh::boxes::BoxSpec;

    #[test]
    fn a_plate_of_two_layers_has_a_stack_of_two_elements_at_each_of_its_places() {
        let mesh = BoxSpec::uniform([0.0; 3], [4.0, 3.0, 0.5], [4, 3, 2]).mesh().unwrap();
        let all: Vec<u32> = (0..mesh.elements.len() as u32).collect();
        let found = stacks(&mesh, &all);
        assert_eq!(found.len(), 12);
        assert!(found.iter().all(|stack| stack.len() == 2 && stack.iter().all(|(_, axis)| *axis == 2)));
    }

    #[test]
    fn a_ring_is_passed_through_its_wall_and_neither_around_nor_along_the_cavern() {
        let mut mesh = BoxSpec::uniform([0.0; 3], [6.0, 0.1, 6.0], [6, 1, 6]).mesh().unwrap();
        let far = |x: f64| (x - 3.0).abs();
        let ring = |mesh: &Mesh| -> Vec<u32> {
            let far = |e: &u32| {
                let [x, _, z] = tremolite_engine::hexahedra::centroid(mesh, *e);
                far(x).max(far(z))
            };
            (0..36).filter(|e| (1.0..2.0).contains(&far(e))).collect()
        };
        for _ in 0..2 {
            let ring = ring(&mesh);
            assert_eq!(ring.len(), 12);
            let found = stacks(&mesh, &ring);
            // Two elements of each wall; where walls meet there is no thickness.
            assert!(found.len() == 8 && found.iter().all(|stack| stack.len() == 1), "{found:?}");
            assert!(found.iter().all(|stack| stack[0].1 != 1));
            mesh.nodes.iter_mut().for_each(|x| x[1] *= 300.0);
        }
    }
}
