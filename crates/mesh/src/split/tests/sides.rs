//! Periodic partners on a split mesh.

use super::*;
use crate::cavern::CavernSpec;
use crate::topology::{Unmatched, match_faces, plane_faces};

fn nodes_of(mesh: &Mesh, faces: &[Face]) -> Vec<u32> {
    let mut nodes: Vec<u32> = faces.iter().flat_map(|&f| mesh.face_nodes(f).collect::<Vec<_>>()).collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes
}

fn ties(mesh: &Mesh, origin: &[u32]) -> Result<Vec<(u32, u32)>, UnmatchedSplit> {
    let planes = plane_faces(mesh, 1e-9);
    match_split(mesh, origin, &planes["ymin"], &planes["ymax"], 1, 1e-6)
}

/// Elements on both sides of a tied pair of nodes are the same, seen along y.
fn assert_alike(mesh: &Mesh, pairs: &[(u32, u32)], a_layer: usize, last: usize) {
    for &(a, b) in pairs {
        assert_eq!(mesh.nodes[a as usize][0], mesh.nodes[b as usize][0]);
        assert_eq!(mesh.nodes[a as usize][2], mesh.nodes[b as usize][2]);
        // With x fastest, then y, the elements of a row in y are `a_layer` apart.
        let around = |n: u32, shift: usize| -> Vec<usize> {
            let own = mesh.elements.iter().enumerate().filter(|(_, e)| e.nodes().contains(&n));
            own.map(|(e, _)| e - shift * a_layer).collect()
        };
        assert_eq!(around(a, 0), around(b, last));
    }
}

#[test]
fn without_copies_the_partners_are_those_of_all_nodes() {
    let mesh = distorted_box(4);
    let planes = plane_faces(&mesh, 1e-9);
    let [low, high] = ["ymin", "ymax"].map(|name| nodes_of(&mesh, &planes[name]));
    let origin: Vec<u32> = (0..mesh.nodes.len() as u32).collect();
    assert_eq!(ties(&mesh, &origin), Ok(match_faces(&mesh, &low, &high, 1, 1e-6).expect("they match")));
}

#[test]
fn a_tunnel_through_both_sides_is_tied_lining_to_lining() {
    let before = grid([6, 3, 6]);
    let within = |c: [f64; 3], half: f64| (c[0] - 3.0).abs().max((c[2] - 3.0).abs()) < half;
    let lining = elements_where(&before, |c| within(c, 2.0) && !within(c, 1.0));
    let rock = elements_where(&before, |c| !within(c, 2.0));
    let [left, right] = [1.0, -1.0]
        .map(|s| rock.iter().copied().filter(|&e| s * (f64::from(e % 6) - 2.5) < 0.0).collect::<Vec<u32>>());
    let core = elements_where(&before, |c| within(c, 1.0));
    let there: Vec<bool> = (0..before.elements.len() as u32).map(|e| !core.contains(&e)).collect();
    // A fault meets the lining as well: copies of three bodies.
    let cuts = [cut("lining", &rock, &lining), cut("fault", &left, &right)];
    let (mesh, split) = checked(&before, &cuts, &there);
    let planes = plane_faces(&mesh, 1e-9);
    let solid = |name: &str| -> Vec<Face> {
        planes[name].iter().copied().filter(|f| there[f.element as usize]).collect()
    };
    let (low, high) = (solid("ymin"), solid("ymax"));
    let pairs = match_split(&mesh, &split.origin, &low, &high, 1, 1e-6).expect("they match");
    assert_eq!(pairs.len(), nodes_of(&mesh, &low).len());
    assert!(pairs.is_sorted());
    assert_alike(&mesh, &pairs, 6, 2);
}

#[test]
fn a_mesh_that_comes_split_is_tied_by_places() {
    let before = grid([4, 3, 4]);
    let [left, right] = [true, false].map(|left| elements_where(&before, |c| (c[0] < 2.0) == left));
    let cuts = [cut("fault", &left, &right)];
    let (once, _) = checked(&before, &cuts, &all(&before));
    let (mesh, split) = checked(&once, &cuts, &all(&before));
    let error = ties(&mesh, &split.origin).expect_err("twins");
    assert!(matches!(error, UnmatchedSplit::Sides(Unmatched::Doubled { .. })), "{error}");
    let pairs = ties(&mesh, &split.places).expect("they match");
    assert_eq!(pairs.len(), 30);
    assert_alike(&mesh, &pairs, 4, 2);
}

#[test]
fn an_interface_that_reaches_one_side_only_is_refused() {
    let before = grid([4, 3, 4]);
    let side =
        |left: bool, short: bool| elements_where(&before, |c| (c[0] < 2.0) == left && (c[1] < 1.5 || !short));
    for mirrored in [false, true] {
        let [left, right] = [true, false].map(|left| side(left, true));
        let (mesh, split) = checked(&before, &[cut("fault", &left, &right)], &all(&before));
        let planes = plane_faces(&mesh, 1e-9);
        let (low, high) = if mirrored { ("ymax", "ymin") } else { ("ymin", "ymax") };
        let error = match_split(&mesh, &split.origin, &planes[low], &planes[high], 1, 1e-6);
        let Err(UnmatchedSplit::Copies { node }) = error else { panic!("{error:?}") };
        assert_eq!(before.nodes[node as usize - 1][0], 2.0);
    }
    let (mesh, split) =
        checked(&before, &[cut("fault", &side(true, false), &side(false, false))], &all(&before));
    let planes = plane_faces(&mesh, 1e-9);
    let error = match_split(&mesh, &split.origin, &planes["ymin"], &[], 1, 1e-6).expect_err("no other side");
    assert!(matches!(error, UnmatchedSplit::Sides(Unmatched::Apart { .. })), "{error}");
}

/// Walls without a floor end at the opening, whose elements are not there.
#[test]
fn generated_linings_are_parted_at_their_extrados_and_tied() {
    let through = CavernSpec::yingxiuwan();
    // Shorter than the block, their own ends butt against rock, and are of the extrados.
    let mut ending = CavernSpec { length: 110.0, ..through.clone() };
    ending.caverns.iter_mut().zip([52.8, 59.4]).for_each(|(cavern, length)| cavern.length = Some(length));
    for spec in [through, ending] {
        parted_at_the_extrados(&spec);
    }
}

fn parted_at_the_extrados(spec: &CavernSpec) {
    let before = spec.mesh().expect("a description that can be meshed");
    let excavated = ["powerhouse.excavation", "transformer.excavation"].map(|name| &before.groups[name]);
    let linings =
        ["powerhouse.lining", "transformer.lining"].map(|name| before.groups[name].clone()).concat();
    let mut there = all(&before);
    for &e in excavated.into_iter().flatten() {
        there[e as usize] = false;
    }
    let (mesh, split) = checked(&before, &[cut("lining", &linings, &before.groups["rock"])], &there);
    let own: Vec<Face> = split.faces[0].iter().map(|pair| pair[0]).collect();
    let mut extrados =
        ["powerhouse.extrados", "transformer.extrados"].map(|n| before.faces[n].clone()).concat();
    extrados.sort_unstable();
    assert_eq!((own, &split.ends), (extrados, &vec![vec![]]));

    let solid = |name: &str| -> Vec<Face> {
        before.faces[name].iter().copied().filter(|f| there[f.element as usize]).collect()
    };
    let (low, high) = (solid("ymin"), solid("ymax"));
    let ties = match_split(&mesh, &split.origin, &low, &high, 1, 1e-6).expect("they match");
    assert_eq!(ties.len(), nodes_of(&mesh, &low).len());
    // Copies are tied to copies: the lining is the first side, the rock keeps the nodes of the file.
    assert!(
        ties.iter().all(|&(a, b)| (a as usize >= before.nodes.len()) == (b as usize >= before.nodes.len()))
    );
}
