use super::*;
use crate::sample::{distorted_box, one_of_each};
use crate::{Element, Shape};

fn sum<'a>(areas: impl IntoIterator<Item = &'a [f64; 3]>) -> [f64; 3] {
    areas.into_iter().fold([0.0; 3], |s, a| [s[0] + a[0], s[1] + a[1], s[2] + a[2]])
}

#[test]
fn a_box_has_exterior_faces_on_its_six_planes_only() {
    let mesh = distorted_box(5);
    assert_eq!(exterior_faces(&mesh, None).len(), 6 * 25);
    let planes = plane_faces(&mesh, 1e-9);
    let names: Vec<&str> = planes.keys().map(String::as_str).collect();
    assert_eq!(names, ["base", "top", "xmax", "xmin", "ymax", "ymin"]);
    for (name, outward) in [
        ("xmin", [-25.0, 0.0, 0.0]),
        ("xmax", [25.0, 0.0, 0.0]),
        ("ymin", [0.0, -25.0, 0.0]),
        ("ymax", [0.0, 25.0, 0.0]),
        ("base", [0.0, 0.0, -25.0]),
        ("top", [0.0, 0.0, 25.0]),
    ] {
        assert_eq!(planes[name].len(), 25);
        let total = sum(vector_areas(&mesh, &planes[name]).values());
        assert!((0..3).all(|i| (total[i] - outward[i]).abs() < 1e-12), "{name} {total:?}");
    }
}

#[test]
fn a_subset_has_faces_against_the_rest() {
    let mesh = distorted_box(3);
    // The middle element of 27.
    let faces = exterior_faces(&mesh, Some(&[13]));
    assert_eq!(faces, (0..6).map(|side| Face { element: 13, side }).collect::<Vec<_>>());
}

#[test]
fn the_areas_of_a_closed_warped_surface_vanish() {
    for mesh in [distorted_box(4), one_of_each()] {
        for element in 0..mesh.elements.len() as u32 {
            let faces = exterior_faces(&mesh, Some(&[element]));
            assert_eq!(faces.len(), mesh.elements[element as usize].shape.faces().len());
            let areas = vector_areas(&mesh, &faces);
            assert!(norm(sum(areas.values())) < 1e-14);
            // The divergence theorem: ∑ x·A = ∫ x·n dA = 3 V > 0, so all faces look outwards.
            let volume: f64 = areas
                .iter()
                .map(|(&n, a)| (0..3).map(|i| mesh.nodes[n as usize][i] * a[i]).sum::<f64>() / 3.0)
                .sum();
            assert!(volume > 0.1, "element {element}: {volume}");
        }
    }
}

#[test]
fn nodal_areas_of_a_trapezium_are_exact() {
    // Parallel sides 2 and 1, height 1: ∫ N_i dA by hand, with dA = (3 - s)/8 dr ds.
    let mut mesh = Mesh {
        nodes: vec![[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, 1.0, 0.0], [-0.5, 1.0, 0.0]],
        ..Mesh::default()
    };
    mesh.nodes.extend(mesh.nodes.clone().iter().map(|x| [x[0], x[1], 1.0]));
    mesh.elements = vec![Element::new(Shape::Hex8, &[0, 1, 2, 3, 4, 5, 6, 7])];
    let areas = vector_areas(&mesh, &[Face { element: 0, side: 5 }]);
    for (node, wanted) in [(4, 5.0 / 12.0), (5, 5.0 / 12.0), (6, 1.0 / 3.0), (7, 1.0 / 3.0)] {
        let [x, y, z] = areas[&node];
        assert!(x.abs() < 1e-15 && y.abs() < 1e-15 && (z - wanted).abs() < 1e-15, "{node} {z}");
    }
}

#[test]
fn a_shared_face_is_inside_whatever_the_shapes() {
    let mesh = one_of_each();
    // 6 + 5 + 5 + 4 faces, two pairs of them shared.
    assert_eq!(exterior_faces(&mesh, None).len(), 16);
    assert_eq!(components(&mesh, None), [vec![0, 1, 2], vec![3]]);
    assert_eq!(components(&mesh, Some(&[2, 1, 3])), [vec![1, 2], vec![3]]);
}

#[test]
fn an_element_that_is_there_twice_crowds_the_faces_between_it_and_others() {
    let mut mesh = distorted_box(2);
    assert_eq!(crowded_faces(&mesh), []);
    mesh.elements.push(mesh.elements[0]);
    // Of its six faces three are shared with a neighbour.
    assert_eq!(crowded_faces(&mesh).iter().map(|f| f.element).collect::<Vec<_>>(), [0; 3]);
}

/// Nodes of the planes y = 0 and y = n of a box.
fn sides(mesh: &Mesh, n: f64) -> (Vec<u32>, Vec<u32>) {
    let at = |level: f64| {
        let on = move |&node: &u32| mesh.nodes[node as usize][1] == level;
        (0..mesh.nodes.len() as u32).filter(on).collect()
    };
    (at(0.0), at(n))
}

#[test]
fn opposite_sides_are_paired_within_the_tolerance() {
    let mut mesh = distorted_box(4);
    let (front, mut back) = sides(&mesh, 4.0);
    for (k, &node) in back.iter().enumerate() {
        mesh.nodes[node as usize][0] += if k % 2 == 0 { 4e-4 } else { -4e-4 };
    }
    back.reverse();
    let pairs = match_faces(&mesh, &front, &back, 1, 1e-3).expect("they match");
    assert_eq!(pairs.iter().map(|p| p.0).collect::<Vec<_>>(), front);
    for (a, b) in pairs {
        // Node numbers of a box: 5 a row along x, then y.
        assert_eq!(b, a + 20);
    }
    let Err(Unmatched::Apart { count, largest, .. }) = match_faces(&mesh, &front, &back, 1, 1e-4) else {
        panic!("nothing is that near");
    };
    assert_eq!(count, 50);
    assert!((largest - 4e-4).abs() < 1e-12);
}

#[test]
fn the_worst_unmatched_node_is_named() {
    let mut mesh = distorted_box(4);
    let (front, back) = sides(&mesh, 4.0);
    mesh.nodes[back[12] as usize][2] += 0.25;
    let error = match_faces(&mesh, &front, &back, 1, 1e-6).expect_err("one node moved");
    let Unmatched::Apart { count: 2, node, largest } = error else { panic!("{error}") };
    assert_eq!(node, mesh.node_id(front[12] as usize));
    assert!((largest - 0.25).abs() < 1e-12);

    let error = match_faces(&mesh, &front, &[], 1, 1.0).expect_err("no other side");
    assert!(matches!(error, Unmatched::Apart { count: 25, largest: f64::INFINITY, .. }), "{error}");
}

#[test]
fn two_nodes_at_one_place_have_no_partner_of_their_own() {
    let mut mesh = distorted_box(2);
    let (mut front, back) = sides(&mesh, 2.0);
    let twin = mesh.nodes.len() as u32;
    mesh.nodes.push(mesh.nodes[front[4] as usize]);
    front.push(twin);
    let error = match_faces(&mesh, &front, &back, 1, 1e-6).expect_err("a twin");
    assert!(matches!(error, Unmatched::Doubled { .. }), "{error}");
}
