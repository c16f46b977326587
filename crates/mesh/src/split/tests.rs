use super::*;
use crate::sample::{distorted_box, elements_where, grid};
use crate::topology::{components, exterior_faces, vector_areas};
use crate::{Element, Shape};
use std::collections::HashSet;

mod refusals;
mod search;
mod sides;

fn all(mesh: &Mesh) -> Vec<bool> {
    vec![true; mesh.elements.len()]
}

fn cut<'a>(name: &'a str, first: &'a [u32], second: &'a [u32]) -> Cut<'a> {
    Cut { name, sides: [first, second] }
}

/// Splits a copy of the mesh and checks what must hold whatever the cuts.
fn checked(before: &Mesh, cuts: &[Cut], there: &[bool]) -> (Mesh, Split) {
    let times: Vec<Range<u32>> = there.iter().map(|there| 0..u32::from(*there)).collect();
    let mut mesh = before.clone();
    let split = split(&mut mesh, cuts, &times).expect("it splits");
    assert_eq!(split.origin.len(), mesh.nodes.len());
    assert!(split.origin[..before.nodes.len()].iter().copied().eq(0..before.nodes.len() as u32));
    for (copy, &node) in split.origin.iter().enumerate() {
        assert_eq!(mesh.nodes[copy], before.nodes[node as usize]);
        assert_eq!(mesh.node_id(copy), before.node_id(node as usize));
    }
    assert_eq!((&mesh.groups, &mesh.faces), (&before.groups, &before.faces));
    for (e, (new, old)) in mesh.elements.iter().zip(&before.elements).enumerate() {
        // With the same places, so the same volume and faces; the tail that repeats the last node included.
        assert_eq!(new.nodes.map(|n| split.origin[n as usize]), old.nodes);
        assert_eq!(new.shape, old.shape);
        assert!(there[e] || new == old, "element {e} is not there and keeps its nodes");
    }
    // All copies are in use.
    let used: HashSet<u32> = mesh.elements.iter().flat_map(|e| e.nodes).collect();
    assert!((before.nodes.len()..mesh.nodes.len()).all(|n| used.contains(&(n as u32))));
    for (faces, cut) in split.faces.iter().zip(cuts) {
        assert!(faces.is_sorted());
        for pair in faces {
            for (face, side) in pair.iter().zip(cut.sides) {
                assert!(side.contains(&face.element) && there[face.element as usize]);
            }
            let areas = pair.map(|face| {
                let areas = vector_areas(&mesh, &[face]);
                areas.values().fold([0.0; 3], |s, a| [0, 1, 2].map(|i| s[i] + a[i]))
            });
            assert!((0..3).all(|i| (areas[0][i] + areas[1][i]).abs() < 1e-12), "{areas:?}");
        }
    }
    (mesh, split)
}

#[test]
fn a_plane_parts_a_box_in_two_bodies_of_which_the_second_keeps_its_nodes() {
    let before = distorted_box(4);
    let [left, right] = [true, false].map(|left| elements_where(&before, |c| (c[0] < 2.0) == left));
    let (mesh, split) = checked(&before, &[cut("plane", &left, &right)], &all(&before));
    assert_eq!((mesh.nodes.len(), split.faces[0].len()), (125 + 25, 16));
    assert_eq!(components(&mesh, None), [left.clone(), right.clone()]);
    assert_eq!(exterior_faces(&mesh, None).len(), 6 * 16 + 2 * 16);
    assert!(right.iter().all(|&e| mesh.elements[e as usize] == before.elements[e as usize]));
    assert_eq!((split.ends, &split.places), (vec![vec![]], &split.origin));
    assert_eq!(mesh.node_ids.len(), 150);

    let firsts: Vec<Face> = split.faces[0].iter().map(|pair| pair[0]).collect();
    let total = vector_areas(&mesh, &firsts).values().fold(0.0, |sum, a| sum + a[0]);
    assert!((total - 16.0).abs() < 1e-12, "{total}");
}

#[test]
fn a_fault_that_ends_inside_ends_closed() {
    let before = grid([4, 2, 4]);
    let [left, right] =
        [true, false].map(|left| elements_where(&before, |c| (c[0] < 2.0) == left && c[2] > 2.0));
    let (mesh, split) = checked(&before, &[cut("fault", &left, &right)], &all(&before));
    assert_eq!((mesh.nodes.len(), split.faces[0].len()), (75 + 6, 4));
    let ends: Vec<[f64; 3]> = split.ends[0].iter().map(|&n| mesh.nodes[n as usize]).collect();
    assert_eq!(ends, [0.0, 1.0, 2.0].map(|y| [2.0, y, 2.0]));
    assert_eq!(components(&mesh, None).len(), 1);
}

#[test]
fn where_faults_cross_each_quarter_has_its_node() {
    let before = grid([2, 2, 2]);
    let side = |axis: usize, low: bool| elements_where(&before, |c| (c[axis] < 1.0) == low);
    let [left, right, below, above] = [side(0, true), side(0, false), side(2, true), side(2, false)];
    let cuts = [cut("steep", &left, &right), cut("flat", &below, &above)];
    let (mesh, split) = checked(&before, &cuts, &all(&before));
    // Four bodies of 2 × 3 × 2 nodes, parted along the whole crossing.
    assert_eq!(mesh.nodes.len(), 48);
    assert_eq!(components(&mesh, None).len(), 4);
    assert_eq!(split.ends, [vec![], vec![]]);
    let crossing = before.nodes.iter().position(|x| *x == [1.0; 3]).expect("the middle") as u32;
    assert_eq!(split.origin.iter().filter(|&&n| n == crossing).count(), 4);
    let kept = mesh.elements.iter().position(|e| e.nodes.contains(&crossing)).expect("one keeps it") as u32;
    assert!(right.contains(&kept) && above.contains(&kept), "on no first side");
}

#[test]
fn three_bodies_that_meet_have_a_node_each() {
    let before = grid([4, 2, 4]);
    let left = elements_where(&before, |c| c[0] < 2.0);
    let low = elements_where(&before, |c| c[0] > 2.0 && c[2] < 2.0);
    let high = elements_where(&before, |c| c[0] > 2.0 && c[2] > 2.0);
    let cuts = [cut("left-low", &left, &low), cut("left-high", &left, &high), cut("low-high", &low, &high)];
    let (mesh, split) = checked(&before, &cuts, &all(&before));
    assert_eq!(components(&mesh, None), [left, low, high.clone()]);
    assert_eq!(mesh.nodes.len(), 3 * 3 * 5 + 2 * 3 * 3 * 3);
    assert_eq!(split.faces.iter().map(Vec::len).collect::<Vec<_>>(), [4, 4, 4]);
    assert!(high.iter().all(|&e| mesh.elements[e as usize] == before.elements[e as usize]));
}

#[test]
fn a_fault_that_ends_on_another_one_is_open_to_there() {
    let before = grid([4, 1, 4]);
    let below = elements_where(&before, |c| c[2] < 2.0);
    let above = elements_where(&before, |c| c[2] > 2.0);
    let [left, right] =
        [1.0, -1.0].map(|s| elements_where(&before, |c| c[2] > 2.0 && s * (c[0] - 2.0) < 0.0));
    let cuts = [cut("flat", &below, &above), cut("steep", &left, &right)];
    let (mesh, split) = checked(&before, &cuts, &all(&before));
    assert_eq!(components(&mesh, None).len(), 3);
    assert_eq!(split.ends, [vec![], vec![]]);
}

#[test]
fn elements_that_are_not_there_keep_the_nodes_of_the_file() {
    // An opening with a wall on its left: the wall's feet touch the void, and so does the rock beside them.
    let before = grid([6, 1, 6]);
    let opening = |c: [f64; 3]| (2.0..4.0).contains(&c[0]) && (2.0..4.0).contains(&c[2]);
    let wall = elements_where(&before, |c| opening(c) && c[0] < 3.0);
    let rock = elements_where(&before, |c| !opening(c));
    let void = elements_where(&before, |c| opening(c) && c[0] > 3.0);
    let there: Vec<bool> = (0..before.elements.len() as u32).map(|e| !void.contains(&e)).collect();
    for (first, second) in [(&wall, &rock), (&rock, &wall)] {
        let (mesh, split) = checked(&before, &[cut("wall", first, second)], &there);
        // Three sides of the wall, its two feet included.
        assert_eq!((split.faces[0].len(), mesh.nodes.len()), (4, before.nodes.len() + 2 * 5));
        assert_eq!(split.ends, [vec![]]);
        assert!(second.iter().all(|&e| mesh.elements[e as usize] == before.elements[e as usize]));
    }
    // With the void there the rock's faces go on around the feet, and the wall holds to it there.
    let (mesh, split) = checked(&before, &[cut("wall", &wall, &rock)], &all(&before));
    assert_eq!(split.ends[0].len(), 2 * 2);
    assert_eq!(mesh.nodes.len(), before.nodes.len() + 2 * 3);
}

#[test]
fn wedges_are_parted_at_triangles_and_quadrilaterals() {
    let bricks = grid([2, 2, 2]);
    let halves = bricks.elements.iter().flat_map(|e| {
        [[0, 1, 2, 4, 5, 6], [0, 2, 3, 4, 6, 7]].map(|k| Element::new(Shape::Wedge6, &k.map(|k| e.nodes[k])))
    });
    let before = Mesh { elements: halves.collect(), ..bricks.clone() };
    for (axis, faces) in [(0, 4), (2, 8)] {
        let [low, high] = [true, false].map(|low| elements_where(&before, |c| (c[axis] < 1.0) == low));
        let (mesh, split) = checked(&before, &[cut("plane", &low, &high)], &all(&before));
        assert_eq!((split.faces[0].len(), mesh.nodes.len()), (faces, 27 + 9));
        assert_eq!(components(&mesh, None).len(), 2);
    }
}

#[test]
fn a_mesh_that_comes_split_is_taken_as_it_is() {
    let before = grid([4, 2, 4]);
    let [left, right] = [true, false].map(|left| elements_where(&before, |c| (c[0] < 2.0) == left));
    let [up_left, up_right] =
        [true, false].map(|left| elements_where(&before, |c| (c[0] < 2.0) == left && c[2] > 2.0));
    let cuts = [cut("fault", &left, &right)];
    let (whole, split_once) = checked(&before, &cuts, &all(&before));
    let mut shifted = whole.clone();
    for x in &mut shifted.nodes[before.nodes.len()..] {
        x[1] += 3e-7;
    }
    let (again, split) = checked(&shifted, &cuts, &all(&before));
    assert_eq!((&again, &split.faces), (&shifted, &split_once.faces));
    assert_eq!((split.ends, split.places), (vec![vec![]], split_once.origin.clone()));

    // Its upper half came split: the rest follows, and the result is the same but for the order of copies.
    let (upper, _) = checked(&before, &[cut("fault", &up_left, &up_right)], &all(&before));
    assert_eq!(upper.nodes.len(), before.nodes.len() + 6);
    let (both, split) = checked(&upper, &cuts, &all(&before));
    assert_eq!(split.faces, split_once.faces);
    assert_eq!((both.nodes.len(), components(&both, None).len()), (whole.nodes.len(), 2));
    assert_eq!(split.ends, [vec![]]);
}
