//! How far the motion of a plane's points goes on beside it.

use std::collections::{BTreeMap, BTreeSet};

use super::curve::{Freedom, length, minus};
use super::path::Way;
use super::section::Section;

/// Sweeps of what follows; motion halves with each ring, so few do.
const SWEEPS: usize = 40;
/// How far a point beside the plane may follow along a border, as a share of the way to its neighbour.
const FOLLOWS: f64 = 0.5;

/// Where points go: those of the way onto the plane, those opposite on the sides as far, so that the sides still match, and those
/// inside what is whole and in so many rings of points beside the plane between them.
pub(super) fn spread(section: &Section, way: &Way, rings: usize) -> BTreeMap<u32, [f64; 2]> {
    let mut moves: BTreeMap<u32, [f64; 2]> = BTreeMap::new();
    for (&p, target) in &way.targets {
        moves.insert(p, minus(*target, section.points[p as usize]));
    }
    let sides: Vec<(u32, [f64; 2])> = moves
        .iter()
        .filter_map(|(p, way)| Some((*section.opposite.get(p)?, *way)))
        .filter(|(q, _)| !moves.contains_key(q))
        .collect();
    moves.extend(sides);
    let given: BTreeSet<u32> = moves.keys().copied().collect();
    let mut follow: BTreeSet<u32> = BTreeSet::new();
    let mut front: BTreeSet<u32> = given.clone();
    for _ in 0..rings {
        front = front.iter().flat_map(|&p| section.beside[p as usize].iter().copied()).collect();
        follow.extend(front.iter().copied());
    }
    // Through what is whole motion goes on, else its outer and inner faces would shear it.
    let inside = |p: &u32| section.round[*p as usize].iter().all(|&c| section.cells[c as usize].whole);
    follow.extend((0..section.points.len() as u32).filter(inside));
    let follow: Vec<u32> = follow.into_iter().filter(|p| !given.contains(p)).collect();
    for _ in 0..SWEEPS {
        for &p in &follow {
            let (mut sum, mut weight) = ([0.0; 2], 0.0);
            for &q in &section.beside[p as usize] {
                let near = 1.0 / length(minus(section.points[q as usize], section.points[p as usize]));
                let way = moves.get(&q).copied().unwrap_or_default();
                sum = [sum[0] + near * way[0], sum[1] + near * way[1]];
                weight += near;
            }
            let way = sum.map(|x| x / weight);
            let way = match section.freedom[p as usize] {
                Freedom::Fixed => [0.0; 2],
                Freedom::Free => way,
                Freedom::Along(curve) => curve.way(curve.along(way).clamp(-FOLLOWS, FOLLOWS)),
            };
            // The sides stay alike.
            match section.opposite.get(&p) {
                Some(_) => {}
                None => drop(moves.insert(p, way)),
            }
        }
    }
    moves.retain(|_, way| *way != [0.0; 2]);
    moves
}
