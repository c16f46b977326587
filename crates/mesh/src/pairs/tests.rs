use super::*;
use crate::sample::{Random, distorted_box, elements_where, grid, tube};
use crate::split::{Cut, Split, split};
use crate::topology::dot;
use crate::topology::vector_areas;
use crate::{Element, Shape};

/// The mesh split between two sets of elements.
fn opened(mut mesh: Mesh, first: &[u32], second: &[u32]) -> (Mesh, Split) {
    let mut times = vec![0..0; mesh.elements.len()];
    for &e in first.iter().chain(second) {
        times[e as usize] = 0..1;
    }
    let split =
        split(&mut mesh, &[Cut { name: "interface", sides: [first, second] }], &times).expect("it splits");
    (mesh, split)
}

/// Checks that pairs pass on the forces of uniform stress that their faces have at each node, and the areas.
fn assert_complete(mesh: &Mesh, split: &Split, cut: usize, pairs: &[PairShape]) {
    let firsts: Vec<Face> = split.faces[cut].iter().map(|pair| pair[0]).collect();
    let wanted = vector_areas(mesh, &firsts);
    for (k, (i, j)) in [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)].into_iter().enumerate() {
        let mut stress = [[0.0; 3]; 3];
        stress[i][j] = 1.0 + k as f64;
        stress[j][i] = stress[i][j];
        let traction = |n: [f64; 3], area: f64| stress.map(|row| dot(row, n) * area);
        let mut forces: BTreeMap<u32, [f64; 3]> = BTreeMap::new();
        for pair in pairs {
            let own = traction(pair.normal, pair.normal_area);
            let force = forces.entry(pair.nodes[0]).or_default();
            *force = [0, 1, 2].map(|i| force[i] + own[i]);
        }
        for (node, &area) in wanted.iter().filter(|(node, _)| !split.ends[cut].contains(node)) {
            let wanted = traction(area, 1.0);
            assert!((0..3).all(|i| (forces[node][i] - wanted[i]).abs() < 1e-12), "node {node}");
        }
    }
    let corners: usize = pairs.iter().map(|p| p.corners.len()).sum();
    let all =
        firsts.iter().flat_map(|&f| mesh.face_nodes(f)).filter(|n| !split.ends[cut].contains(n)).count();
    assert_eq!(corners, all, "each corner in one pair");
    for pair in pairs {
        assert!((norm(pair.normal) - 1.0).abs() < 1e-15);
        assert!(pair.area > pair.normal_area - 1e-15);
        assert!(mesh.nodes[pair.nodes[0] as usize] == mesh.nodes[pair.nodes[1] as usize]);
        assert!(pair.corners.is_sorted());
    }
    assert!(pairs.is_sorted_by_key(|p| (p.nodes, p.corners[0])));
}

/// How many nodes of the first side have one pair, two, three …
fn counts(pairs: &[PairShape]) -> Vec<usize> {
    let mut by_node: BTreeMap<u32, usize> = BTreeMap::new();
    for pair in pairs {
        *by_node.entry(pair.nodes[0]).or_default() += 1;
    }
    let most = by_node.values().copied().max().unwrap_or(0);
    (1..=most).map(|n| by_node.values().filter(|&&count| count == n).count()).collect()
}

#[test]
fn a_plane_has_a_pair_a_node_whether_flat_or_warped() {
    for (mesh, flat) in [(grid([4, 4, 4]), true), (distorted_box(4), false)] {
        let [left, right] = [true, false].map(|left| elements_where(&mesh, |c| (c[0] < 2.0) == left));
        let (mesh, split) = opened(mesh, &left, &right);
        let pairs = pairs(&mesh, &split.faces[0], CORNER);
        assert_complete(&mesh, &split, 0, &pairs);
        assert_eq!(counts(&pairs), [25]);
        let total: f64 = pairs.iter().map(|p| p.normal[0] * p.normal_area).sum();
        assert!((total - 16.0).abs() < 1e-12, "{total}");
        let area: f64 = pairs.iter().map(|p| p.area).sum();
        assert_eq!((area - 16.0).abs() < 1e-12, flat, "{area}");
    }
}

#[test]
fn the_end_of_an_interface_has_no_pair() {
    let mesh = grid([4, 2, 4]);
    let upper = |left: bool| elements_where(&mesh, |c| (c[0] < 2.0) == left && c[2] > 2.0);
    let (left, right) = (upper(true), upper(false));
    let mut mesh = mesh.clone();
    let cut = Cut { name: "fault", sides: [&left, &right] };
    let split = split(&mut mesh, &[cut], &vec![0..1; 32]).expect("it splits");
    let pairs = pairs(&mesh, &split.faces[0], CORNER);
    assert_complete(&mesh, &split, 0, &pairs);
    assert_eq!(counts(&pairs), [6]);
}

#[test]
fn a_box_in_a_box_has_two_pairs_along_its_edges_and_three_at_its_corners() {
    let mesh = grid([6, 6, 6]);
    let inner = |c: [f64; 3]| c.iter().all(|x| (x - 3.0).abs() < 1.0);
    let (own, rest) = (elements_where(&mesh, inner), elements_where(&mesh, |c| !inner(c)));
    for (first, second, outward) in [(&own, &rest, 1.0), (&rest, &own, -1.0)] {
        let (mesh, split) = opened(mesh.clone(), first, second);
        let pairs = pairs(&mesh, &split.faces[0], CORNER);
        assert_complete(&mesh, &split, 0, &pairs);
        // 6 in the middle of faces, 12 on edges, 8 corners.
        assert_eq!(counts(&pairs), [6, 12, 8]);
        for pair in &pairs {
            let x = mesh.nodes[pair.nodes[0] as usize];
            let axis = (0..3).find(|&i| pair.normal[i].abs() > 0.5).expect("a direction");
            let wanted = [0, 1, 2].map(|i| if i == axis { outward * (x[i] - 3.0) } else { 0.0 });
            assert!((0..3).all(|i| (pair.normal[i] - wanted[i]).abs() < 1e-15), "{:?}", pair.normal);
            assert!((pair.area - 0.25 * pair.corners.len() as f64).abs() < 1e-15);
        }
    }
}

#[test]
fn the_lining_of_a_square_opening_has_two_pairs_along_its_edges() {
    let mesh = grid([6, 2, 6]);
    let within = |c: [f64; 3], half: f64| (c[0] - 3.0).abs().max((c[2] - 3.0).abs()) < half;
    let lining = elements_where(&mesh, |c| within(c, 2.0) && !within(c, 1.0));
    let rock = elements_where(&mesh, |c| !within(c, 2.0));
    let (mesh, split) = opened(mesh, &lining, &rock);
    let pairs = pairs(&mesh, &split.faces[0], CORNER);
    assert_complete(&mesh, &split, 0, &pairs);
    assert_eq!(counts(&pairs), [12 * 3, 4 * 3]);
}

/// Lining and rock of a round tunnel of three layers, with the pairs between them.
fn tunnel(facets: u32, corner: f64) -> (Mesh, Split, Vec<PairShape>) {
    let mesh = tube(facets, &[4.0, 5.0, 6.0, 8.0], 3);
    let [lining, rock] = [true, false].map(|own| elements_where(&mesh, |c| (c[0].hypot(c[2]) < 5.0) == own));
    let (mesh, split) = opened(mesh, &lining, &rock);
    let pairs = pairs(&mesh, &split.faces[0], corner);
    assert_complete(&mesh, &split, 0, &pairs);
    (mesh, split, pairs)
}

#[test]
fn a_fine_cylinder_has_a_radial_pair_a_node() {
    let (mesh, _, pairs) = tunnel(24, CORNER);
    assert_eq!(counts(&pairs), [24 * 4]);
    let half = std::f64::consts::PI / 24.0;
    for pair in &pairs {
        let [x, y, z] = mesh.nodes[pair.nodes[0] as usize];
        let wanted = [x / 5.0, 0.0, z / 5.0];
        assert!((0..3).all(|i| (pair.normal[i] - wanted[i]).abs() < 1e-14));
        let depth = if y == 0.0 || y == 3.0 { 0.5 } else { 1.0 };
        assert!((pair.area - 10.0 * half.sin() * depth).abs() < 1e-13);
        assert!((pair.normal_area - pair.area * half.cos()).abs() < 1e-13);
    }
}

/// 360° / 8 is the limit itself: sharp, on all eight edges alike.
#[test]
fn the_edges_of_an_octagon_are_corners_at_45_degrees_and_none_at_46() {
    assert_eq!(counts(&tunnel(8, CORNER).2), [0, 8 * 4]);
    assert_eq!(counts(&tunnel(8, 46_f64.to_radians()).2), [8 * 4]);
    // 72° are below 80°, but no pair spans more than 60°.
    assert_eq!(counts(&tunnel(5, 80_f64.to_radians()).2), [0, 5 * 4]);
    assert_eq!(counts(&tunnel(6, 80_f64.to_radians()).2), [6 * 4]);
}

/// Three triangles around a node, the middle one level, on tetrahedra; the others dip by the angles \[°\].
fn fan(left: f64, right: f64) -> (Mesh, Vec<[Face; 2]>) {
    let (a, b) = (left.to_radians(), right.to_radians());
    let own =
        [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-a.cos(), 0.0, -a.sin()], [0.0, -b.cos(), -b.sin()]];
    let mut mesh = Mesh { nodes: own.to_vec(), ..Mesh::default() };
    mesh.nodes.extend(own);
    mesh.nodes.extend([[0.0, 0.0, -3.0], [0.0, 0.0, 3.0]]);
    let mut faces = Vec::new();
    for [i, j, k] in [[0, 2, 3], [0, 1, 2], [0, 4, 1]] {
        let element = mesh.elements.len() as u32;
        mesh.elements.push(Element::new(Shape::Tet4, &[i, k, j, 10]));
        mesh.elements.push(Element::new(Shape::Tet4, &[i + 5, j + 5, k + 5, 11]));
        faces.push([Face { element, side: 0 }, Face { element: element + 1, side: 0 }]);
    }
    (mesh, faces)
}

#[test]
fn faces_hang_together_through_others_up_to_60_degrees() {
    let at_middle = |left: f64, right: f64, corner: f64| {
        let (mesh, faces) = fan(left, right);
        let pairs = pairs(&mesh, &faces, corner.to_radians());
        let middle = pairs.into_iter().filter(|p| p.nodes == [0, 5]);
        middle.map(|p| p.corners.iter().map(|c| c.0).collect::<Vec<_>>()).collect::<Vec<_>>()
    };
    // The outer two are 52° apart, more than the corner, and have no edge in common.
    assert_eq!(at_middle(45.0, 30.0, 50.0), [[0, 1, 2]]);
    // 63° apart: cut at the sharper edge.
    assert_eq!(at_middle(50.0, 45.0, 55.0), [vec![0], vec![1, 2]]);
    assert_eq!(at_middle(45.0, 50.0, 55.0), [vec![0, 1], vec![2]]);
    // 66° apart over equally sharp edges: cut at both, so that what is symmetric stays so.
    assert_eq!(at_middle(50.0, 50.0, 55.0), [[0], [1], [2]]);
    // A corner proper.
    assert_eq!(at_middle(50.0, 30.0, 45.0), [vec![0], vec![1, 2]]);

    // 39° apart, but without the face between them they meet at a node only.
    let (mesh, faces) = fan(30.0, 25.0);
    let outer = pairs(&mesh, &[faces[0], faces[2]], CORNER);
    assert_eq!(outer.iter().filter(|p| p.nodes == [0, 5]).count(), 2);

    let (mesh, faces) = fan(45.0, 30.0);
    let pairs = pairs(&mesh, &faces, 1.0);
    let thirds: f64 = pairs.iter().map(|p| p.area).sum();
    assert!((thirds - 1.5).abs() < 1e-14, "three triangles of half a square metre");
}

#[test]
fn bodies_mixed_at_random_have_pairs_that_pass_on_all() {
    let mut random = Random(5);
    let mesh = distorted_box(5);
    let body: Vec<usize> = mesh.elements.iter().map(|_| random.below(4)).collect();
    let of = |k: usize| (0..125).filter(|&e| body[e as usize] == k).collect::<Vec<u32>>();
    let bodies = [of(0), of(1), of(2)];
    let times: Vec<_> = body.iter().map(|&k| 0..u32::from(k < 3)).collect();
    let cuts = [(0, 1), (1, 2), (2, 0)].map(|(a, b)| Cut { name: "joint", sides: [&bodies[a], &bodies[b]] });
    let mut mesh = mesh;
    let split = split(&mut mesh, &cuts, &times).expect("it splits");
    assert!(split.ends.iter().all(Vec::is_empty));
    for (cut, faces) in split.faces.iter().enumerate() {
        assert_complete(&mesh, &split, cut, &pairs(&mesh, faces, CORNER));
    }
}

#[test]
fn a_face_without_area_makes_no_pair() {
    let (mut mesh, faces) = fan(45.0, 30.0);
    for node in [3, 8] {
        mesh.nodes[node] = [0.0, 0.5, 0.0];
    }
    let pairs = pairs(&mesh, &faces, CORNER);
    assert!(pairs.iter().all(|p| p.corners.iter().all(|c| c.0 != 0)));
    assert!(pairs.iter().all(|p| p.normal.iter().all(|n| n.is_finite())));
}

#[test]
fn tangents_make_a_right_handed_frame_with_the_first_one_level() {
    let slight = [1e-7, -2e-7, 1.0];
    let steep = [0.6, 0.0, 0.8];
    let skew = [2.0 / 3.0, -1.0 / 3.0, -2.0 / 3.0];
    for m in [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0], slight, steep, skew] {
        let m = m.map(|c| c / norm(m));
        let [e1, e2] = tangents(m);
        let third = cross(e1, e2);
        assert!((0..3).all(|i| (third[i] - m[i]).abs() < 1e-15), "{m:?}");
        assert!(dot(e1, m).abs() < 1e-15 && (norm(e1) - 1.0).abs() < 1e-15);
        assert!(e1[2].abs() < 1e-6 && e2[2] >= -1e-6);
    }
    assert_eq!(tangents([0.0, 0.0, -1.0]), [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0]]);
    assert_eq!(tangents([1.0, 0.0, 0.0]), [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
}
