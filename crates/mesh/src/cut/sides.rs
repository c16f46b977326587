//! The elements on either side of a plane.

use std::collections::{HashMap, HashSet, VecDeque};

use super::Cut;
use super::curve::minus;
use super::section::{Section, key};
use crate::Mesh;
use crate::places::middle;

/// The elements above and below a plane, whose way is given by pairs of nodes at the first y, ascending; none that are `whole`. Of a plane
/// with an extent those that have a face on it; else what hangs together with these, not through the plane or what is whole, and of
/// what is left those whose middles lie on the side. So a way that bends into a corner parts what it parts. Cells that are whole in a
/// part of their length alone, as rock beyond the end of a lining, go by their middles there.
pub(super) fn of(
    section: &Section,
    mesh: &Mesh,
    cut: &Cut,
    whole: &[bool],
    way: &[[u32; 2]],
) -> [Vec<u32>; 2] {
    let point: HashMap<u32, u32> =
        section.columns.iter().zip(0..).map(|(column, p)| (column[0], p)).collect();
    let steps: Vec<[u32; 2]> =
        way.iter().filter_map(|[a, b]| Some([*point.get(a)?, *point.get(b)?])).collect();
    let walls: HashSet<[u32; 2]> = steps.iter().map(|&[a, b]| key(a, b)).collect();
    let mut side: Vec<Option<usize>> = vec![None; section.cells.len()];
    let mut queue = VecDeque::new();
    for &[a, b] in &steps {
        let [from, to] = [a, b].map(|p| section.points[p as usize]);
        let along = minus(to, from);
        for &c in section.edges.get(&key(a, b)).into_iter().flatten() {
            let corners = &section.cells[c as usize].corners;
            let off: f64 = corners
                .iter()
                .map(|&p| minus(section.points[p as usize], from))
                .map(|q| along[0] * q[1] - along[1] * q[0])
                .sum();
            // Above lies to the left of the way.
            side[c as usize] = Some(usize::from(off < 0.0));
            queue.push_back(c);
        }
    }
    while let (Some(c), None) = (queue.pop_front(), cut.extent) {
        let corners = &section.cells[c as usize].corners;
        for (k, &a) in corners.iter().enumerate() {
            let edge = key(a, corners[(k + 1) % corners.len()]);
            if walls.contains(&edge) {
                continue;
            }
            for &other in section.edges.get(&edge).into_iter().flatten() {
                if side[other as usize].is_none() && !section.cells[other as usize].whole {
                    side[other as usize] = side[c as usize];
                    queue.push_back(other);
                }
            }
        }
    }
    let mut lists = [Vec::new(), Vec::new()];
    for (cell, side) in section.cells.iter().zip(side) {
        let side = match (side, cut.extent) {
            (Some(side), _) => side,
            (None, Some(_)) => continue,
            (None, None) => usize::from(cut.plane.distance(middle(mesh, cell.elements[0])) < 0.0),
        };
        lists[side].extend(cell.elements.iter().filter(|e| !whole[**e as usize]));
    }
    lists.iter_mut().for_each(|list| list.sort_unstable());
    lists
}
