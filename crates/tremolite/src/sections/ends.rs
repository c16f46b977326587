//! Which end of a stack is the intrados.

use super::ordered::{Ordered, centre, dot, minus};
use tremolite_mesh::Mesh;

/// Two faces at one place: their middles are closer than this share of the thickness.
const SAME: f64 = 1e-3;

/// The stacks, each with its intrados last.
pub(super) fn intrados_first(
    mesh: &Mesh,
    stacks: Vec<Ordered>,
    standing: &[bool],
    middle: [f64; 3],
) -> Vec<Ordered> {
    let held = held(mesh, &stacks, standing);
    let turn = |(stack, held): (Ordered, [bool; 2])| {
        let [first, last] = stack.ends().map(centre);
        let inwards = match held {
            [true, false] => true,
            [false, true] => false,
            _ => looks_at(middle, first, last),
        };
        if inwards { stack } else { stack.turned() }
    };
    stacks.into_iter().zip(held).map(turn).collect()
}

/// Whether the way from one end to the other leads towards a place; level with it, as in a flat slab, whether it leads up.
fn looks_at(place: [f64; 3], first: [f64; 3], last: [f64; 3]) -> bool {
    let way = minus(last, first);
    let towards = dot(way, minus(place, first)) - 0.5 * dot(way, way);
    if towards.abs() > SAME * dot(way, way) { towards > 0.0 } else { way[2] >= 0.0 }
}

/// For both ends of each stack whether an element stands beyond.
fn held(mesh: &Mesh, stacks: &[Ordered], standing: &[bool]) -> Vec<[bool; 2]> {
    // Middles of the ends' faces by x, with the stack, the end, the element there, and how far off is the same place.
    let mut ends: Vec<([f64; 3], usize, usize, u32, f64)> = Vec::with_capacity(2 * stacks.len());
    for (k, stack) in stacks.iter().enumerate() {
        let places = stack.ends().map(centre);
        let through = minus(places[1], places[0]);
        let near = SAME * dot(through, through).sqrt();
        let elements = [stack.elements.first(), stack.elements.last()];
        for (end, (place, element)) in places.into_iter().zip(elements).enumerate() {
            ends.extend(element.map(|&(element, _)| (place, k, end, element, near)));
        }
    }
    ends.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]));
    let farthest = ends.iter().fold(0.0, |most: f64, end| most.max(end.4));
    let mut held = vec![[false; 2]; stacks.len()];
    for element in (0..mesh.elements.len() as u32).filter(|&e| standing[e as usize]) {
        let e = &mesh.elements[element as usize];
        for corners in e.shape.faces().iter().filter(|corners| corners.len() == 4) {
            let middle = centre(&std::array::from_fn(|k| mesh.nodes[e.nodes[corners[k]] as usize]));
            let from = ends.partition_point(|end| end.0[0] < middle[0] - farthest);
            for (place, stack, end, own, near) in &ends[from..] {
                if place[0] > middle[0] + farthest {
                    break;
                }
                let off = minus(*place, middle);
                if *own != element && dot(off, off) <= near * near {
                    held[*stack][*end] = true;
                }
            }
        }
    }
    held
}
