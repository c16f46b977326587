//! Which of several sets of elements is nearest, counted in steps through shared faces.

use crate::Mesh;
use crate::topology::{all_faces, face_key};

/// For each of `targets` (indices into [`Mesh::elements`]) the set in `seeds` that is nearest: the fewest steps through
/// shared faces, where the way leads through targets alone. Of two sets as near the earlier one; none where no way
/// leads.
///
/// An element that shares a face with one of a set is at one step from it, one that is in the set itself at none. What
/// shares no nodes is no neighbour, so this is for the mesh before its interfaces are split. The order of elements in
/// `targets` or within a set changes nothing.
///
/// # Panics
/// If an element is not in the mesh.
pub fn nearest_through_faces(mesh: &Mesh, targets: &[u32], seeds: &[Vec<u32>]) -> Vec<Option<usize>> {
    nearest_with_holes(mesh, targets, seeds, &[])
}

/// As [`nearest_through_faces`], where the first set has members that are no elements, as a hole in the mesh has: `beside` are the
/// targets that share a face with one of these.
///
/// # Panics
/// If an element is not in the mesh.
pub fn nearest_with_holes(
    mesh: &Mesh,
    targets: &[u32],
    seeds: &[Vec<u32>],
    beside: &[u32],
) -> Vec<Option<usize>> {
    let mut nearest: Vec<Option<usize>> = vec![None; mesh.elements.len()];
    for (set, elements) in seeds.iter().enumerate().rev() {
        elements.iter().for_each(|&e| nearest[e as usize] = Some(set));
    }
    let mut waits = vec![false; mesh.elements.len()];
    targets.iter().for_each(|&e| waits[e as usize] = nearest[e as usize].is_none());
    let neighbours = neighbours(mesh, &waits, &nearest);

    let mut front: Vec<u32> =
        (0..mesh.elements.len() as u32).filter(|&e| nearest[e as usize].is_some()).collect();
    let mut reached: Vec<(u32, Option<usize>)> =
        beside.iter().filter(|&&e| waits[e as usize]).map(|&e| (e, Some(0))).collect();
    while !front.is_empty() || !reached.is_empty() {
        for &e in &front {
            let from = neighbours.partition_point(|pair| pair.0 < e);
            let beside = neighbours[from..].iter().take_while(|pair| pair.0 == e).map(|pair| pair.1);
            reached.extend(beside.filter(|&o| waits[o as usize]).map(|o| (o, nearest[e as usize])));
        }
        // The first of each element has the earliest set.
        reached.sort_unstable();
        reached.dedup_by_key(|(e, _)| *e);
        for &(e, set) in &reached {
            nearest[e as usize] = set;
            waits[e as usize] = false;
        }
        front = reached.drain(..).map(|(e, _)| e).collect();
    }
    targets.iter().map(|&e| nearest[e as usize]).collect()
}

/// Pairs of elements that share a face, both ways round and ascending: those that wait, and those that are in a set.
fn neighbours(mesh: &Mesh, waits: &[bool], nearest: &[Option<usize>]) -> Vec<(u32, u32)> {
    let counts = |e: &u32| waits[*e as usize] || nearest[*e as usize].is_some();
    let elements: Vec<u32> = (0..mesh.elements.len() as u32).filter(counts).collect();
    let mut keyed: Vec<([u32; 4], u32)> =
        all_faces(mesh, Some(&elements)).map(|face| (face_key(mesh, face), face.element)).collect();
    keyed.sort_unstable();
    let mut pairs = Vec::new();
    for same in keyed.chunk_by(|a, b| a.0 == b.0) {
        for (_, a) in same {
            pairs.extend(same.iter().filter(|(_, b)| a != b).map(|(_, b)| (*a, *b)));
        }
    }
    pairs.sort_unstable();
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cavern::CavernSpec;
    use crate::sample::{grid, one_of_each};

    #[test]
    fn the_nearest_set_wins_and_the_earlier_of_two_as_near() {
        // A row of nine: seeds at both ends, and one that is in the way of none.
        let mesh = grid([9, 1, 1]);
        let targets = [1, 2, 3, 4, 5, 6, 7];
        let found = nearest_through_faces(&mesh, &targets, &[vec![8], vec![0]]);
        assert_eq!(found, [1, 1, 1, 0, 0, 0, 0].map(Some));
        let found = nearest_through_faces(&mesh, &targets, &[vec![0], vec![8], vec![0, 8]]);
        assert_eq!(found, [0, 0, 0, 0, 1, 1, 1].map(Some));
    }

    #[test]
    fn a_hole_is_a_step_away_from_what_is_beside_it() {
        // A row of nine with a hole at its end, and a seed at the other, or in the middle.
        let mesh = grid([9, 1, 1]);
        let found = nearest_with_holes(&mesh, &[0, 1, 2, 3, 4, 5, 6, 7], &[vec![], vec![8]], &[0]);
        assert_eq!(found, [0, 0, 0, 0, 1, 1, 1, 1].map(Some));
        let found = nearest_with_holes(&mesh, &[0, 1, 2], &[vec![], vec![3]], &[0]);
        assert_eq!(found, [0, 0, 1].map(Some));
        assert_eq!(nearest_with_holes(&mesh, &[0, 1, 3], &[vec![]], &[0]), [Some(0), Some(0), None]);
    }

    #[test]
    fn a_way_leads_through_targets_alone_and_through_faces_alone() {
        // 3 × 3: from the seed in a corner, round what is no target in the middle of the first column.
        let mesh = grid([3, 3, 1]);
        let found = nearest_through_faces(&mesh, &[1, 2, 5, 8, 7, 6], &[vec![], vec![0], vec![3]]);
        assert_eq!(found, [1, 1, 1, 2, 2, 2].map(Some), "6 touches 3, and 8 is two steps from it");
        // Across an edge or a node there is no step; what is apart is not reached.
        assert_eq!(nearest_through_faces(&mesh, &[4, 8], &[vec![0]]), [None, None]);
        assert_eq!(nearest_through_faces(&mesh, &[4], &[]), [None]);
        assert_eq!(nearest_through_faces(&one_of_each(), &[2, 3, 1], &[vec![0]]), [Some(0), None, Some(0)]);
    }

    #[test]
    fn a_target_in_a_set_is_the_set_s_own_and_order_changes_nothing() {
        let mesh = grid([4, 4, 4]);
        let seeds = vec![vec![0, 5, 21], vec![63, 62, 21], vec![40, 3]];
        let targets: Vec<u32> = (0..64).collect();
        let found = nearest_through_faces(&mesh, &targets, &seeds);
        assert_eq!((found[21], found[62], found[40]), (Some(0), Some(1), Some(2)));
        let turned: Vec<Vec<u32>> = seeds.iter().map(|s| s.iter().rev().copied().collect()).collect();
        let back: Vec<u32> = targets.iter().rev().copied().collect();
        let again = nearest_through_faces(&mesh, &back, &turned);
        assert!(found.iter().eq(again.iter().rev()));
    }

    #[test]
    fn a_cavern_s_lining_goes_with_the_bench_beside_it() {
        let mesh = CavernSpec::yingxiuwan().mesh().expect("a legal spec");
        for (cavern, benches) in [("powerhouse", 6), ("transformer", 4)] {
            let groups: Vec<Vec<u32>> =
                (1..=benches).map(|k| mesh.groups[&format!("{cavern}.bench{k}")].clone()).collect();
            let lining = &mesh.groups[&format!("{cavern}.lining")];
            for (e, set) in lining.iter().zip(nearest_through_faces(&mesh, lining, &groups)) {
                let own = &mesh.groups[&format!("{cavern}.lining{}", set.expect("a set") + 1)];
                assert!(own.contains(e), "{e}");
            }
        }
    }
}
