//! Linings on a section, drawn thicker than they are: half a metre of concrete in a hall forty metres high is a line.

use std::collections::{BTreeMap, HashMap};

use tremolite_results::CutCell;

use crate::drawing::window::Window;
use crate::section_maps::section_view::{CellSide, edges, key};

/// Factors by which a lining may be drawn thicker.
const FACTORS: [f64; 3] = [4.0, 3.0, 2.0];
/// How much of the smaller extent of its lining a wall may take when drawn.
const ROOM: f64 = 0.35;

type PointKey = [i64; 2];

/// How points of linings move inwards when drawn.
#[derive(Debug)]
pub struct Thick {
    /// How many times as thick linings are drawn.
    pub factor: f64,
    moves: HashMap<PointKey, [f64; 2]>,
}

impl Thick {
    /// For the cells of which `inside` is true: those that are one behind the other from the open to other ground.
    pub fn of(cells: &[CutCell], inside: &[bool]) -> Thick {
        let all = edges(cells);
        // By cell and corner: which edge it is.
        let mut edge_of: HashMap<(usize, usize), usize> = HashMap::new();
        for (k, sides) in all.iter().enumerate() {
            sides.iter().for_each(|side| {
                edge_of.insert((side.cell, side.corner), k);
            });
        }
        let room = ROOM * smallest(cells, inside);
        let mut thickest = 0.0_f64;
        let mut ends: BTreeMap<PointKey, ([f64; 2], Vec<[f64; 2]>)> = BTreeMap::new();
        for sides in all.iter().filter(|sides| sides.len() == 1 && inside[sides[0].cell]) {
            for way in through(cells, inside, &all, &edge_of, sides[0]) {
                let Some((end, way)) = way.split_last() else { continue };
                let Some(first) = way.first() else { continue };
                // From a wall's free end the way goes along it, not through it.
                let length = (first[0] - end[0]).hypot(first[1] - end[1]);
                if 2.0 * length > room {
                    continue;
                }
                thickest = thickest.max(length);
                for point in way {
                    let (_, known) = ends.entry(key(point)).or_insert((*point, Vec::new()));
                    if !known.iter().any(|other| key(other) == key(end)) {
                        known.push(*end);
                    }
                }
            }
        }
        // At a corner inwards from both walls.
        let inwards = |(point, ends): &([f64; 2], Vec<[f64; 2]>)| {
            [0, 1].map(|i| ends.iter().map(|end| point[i] - end[i]).sum::<f64>())
        };
        let moves: HashMap<PointKey, [f64; 2]> = ends.iter().map(|(k, found)| (*k, inwards(found))).collect();
        let factor = FACTORS.into_iter().find(|factor| factor * thickest <= room);
        let factor = if moves.is_empty() { 1.0 } else { factor.unwrap_or(1.0) };
        Thick { factor, moves }
    }

    /// Where a point is drawn.
    pub fn point(&self, point: [f64; 2]) -> [f64; 2] {
        let moved = self.moves.get(&key(&point)).copied().unwrap_or_default();
        [0, 1].map(|i| point[i] + (self.factor - 1.0) * moved[i])
    }

    /// Where an outline is drawn.
    pub fn outline(&self, outline: &[[f64; 2]]) -> Vec<[f64; 2]> {
        outline.iter().map(|point| self.point(*point)).collect()
    }
}

/// The two ways from the ends of an open edge through to other ground; none if they do not come there, or through what has
/// no opposite edges.
fn through(
    cells: &[CutCell],
    inside: &[bool],
    all: &[Vec<CellSide>],
    edge_of: &HashMap<(usize, usize), usize>,
    from: CellSide,
) -> Vec<Vec<[f64; 2]>> {
    /// No lining has so many elements through its thickness.
    const DEEPEST: usize = 64;
    let mut ways = [vec![from.edge[0]], vec![from.edge[1]]];
    let mut side = from;
    for _ in 0..DEEPEST {
        let outline = &cells[side.cell].outline;
        if outline.len() != 4 {
            return Vec::new();
        }
        let corner = |k: usize| outline[(side.corner + k) % 4];
        // The edge goes from corner 0 to 1; across from them are 3 and 2. Ways may hold the ends the other way round.
        let turned = key(&ways[0][ways[0].len() - 1]) != key(&corner(0));
        ways[usize::from(turned)].push(corner(3));
        ways[usize::from(!turned)].push(corner(2));
        let Some(&edge) = edge_of.get(&(side.cell, (side.corner + 2) % 4)) else { return Vec::new() };
        match all[edge].iter().find(|other| other.cell != side.cell) {
            Some(next) if inside[next.cell] => side = *next,
            Some(_) => return ways.into(),
            None => return Vec::new(),
        }
    }
    Vec::new()
}

/// The smaller extent of the smallest part that hangs together.
fn smallest(cells: &[CutCell], inside: &[bool]) -> f64 {
    let own: Vec<usize> = (0..cells.len()).filter(|&k| inside[k]).collect();
    let mut at: HashMap<PointKey, Vec<usize>> = HashMap::new();
    for &k in &own {
        cells[k].outline.iter().for_each(|point| at.entry(key(point)).or_default().push(k));
    }
    let mut left = inside.to_vec();
    let mut smallest = f64::INFINITY;
    for first in own {
        if !std::mem::take(&mut left[first]) {
            continue;
        }
        let mut part = vec![first];
        let mut k = 0;
        while let Some(&cell) = part.get(k) {
            k += 1;
            for &next in cells[cell].outline.iter().flat_map(|point| &at[&key(point)]) {
                if std::mem::take(&mut left[next]) {
                    part.push(next);
                }
            }
        }
        let [width, height] =
            Window::around(part.iter().flat_map(|&k| cells[k].outline.iter().copied())).size();
        smallest = smallest.min(width).min(height);
    }
    smallest
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cell(x: [f64; 2], z: [f64; 2], group: i64) -> CutCell {
        CutCell { outline: vec![[x[0], z[0]], [x[1], z[0]], [x[1], z[1]], [x[0], z[1]]], value: 0.0, group }
    }

    /// An angle of two walls one metre thick, of one element each with a corner block, outside at x < 0 and z < 0.
    fn angle() -> Vec<CutCell> {
        vec![
            cell([0.0, 1.0], [0.0, 1.0], 1),
            cell([0.0, 1.0], [1.0, 21.0], 1),
            cell([1.0, 21.0], [0.0, 1.0], 1),
            cell([-5.0, 0.0], [1.0, 21.0], 0),
            cell([-5.0, 0.0], [0.0, 1.0], 0),
            cell([1.0, 21.0], [-5.0, 0.0], 0),
            cell([0.0, 1.0], [-5.0, 0.0], 0),
        ]
    }

    #[test]
    fn walls_grow_inwards_alone_and_a_corner_with_both() {
        let cells = angle();
        let inside: Vec<bool> = cells.iter().map(|cell| cell.group == 1).collect();
        let thick = Thick::of(&cells, &inside);
        assert_eq!(thick.factor, 4.0);
        for (at, drawn) in [
            ([0.0, 21.0], [0.0, 21.0]),
            ([1.0, 21.0], [4.0, 21.0]),
            ([21.0, 1.0], [21.0, 4.0]),
            ([1.0, 1.0], [4.0, 4.0]),
            ([0.0, 0.0], [0.0, 0.0]),
        ] {
            assert_eq!(thick.point(at), drawn, "{at:?}");
        }
        assert_eq!(thick.outline(&cells[3].outline), cells[3].outline);
    }

    #[test]
    fn what_is_no_lining_stays_as_it_is() {
        let cells = angle();
        let thick = Thick::of(&cells, &[false; 7]);
        assert_eq!((thick.factor, thick.point([1.0, 1.0])), (1.0, [1.0, 1.0]));
    }
}
