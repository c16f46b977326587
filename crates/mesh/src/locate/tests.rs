use super::*;
use crate::isoparametric::corners;
use crate::sample::{Random, distorted_box, one_of_each};

#[test]
fn points_of_distorted_elements_are_found_with_their_natural_coordinates() {
    let mesh = distorted_box(6);
    let locator = Locator::new(&mesh, None);
    let mut random = Random(7);
    for (index, element) in mesh.elements.iter().enumerate() {
        let nodes: Vec<_> = element.nodes().iter().map(|&n| mesh.nodes[n as usize]).collect();
        let natural = [0; 3].map(|_| 1.9 * random.next() - 0.95);
        let at = point(&nodes, &weights(element.shape, natural));
        let found = locator.locate(at, 0.0).expect("the point is inside");
        assert_eq!((found.element, found.distance), (index as u32, 0.0));
        for i in 0..3 {
            // Round-off of the map, through a Jacobian of condition number below 10.
            assert!((found.natural[i] - natural[i]).abs() < 1e-12, "{found:?} {natural:?}");
        }
        assert!((found.weights.iter().sum::<f64>() - 1.0).abs() < 1e-14);
    }
}

#[test]
fn coordinates_of_a_national_grid_do_no_harm() {
    let mut mesh = distorted_box(3);
    for node in &mut mesh.nodes {
        *node = [node[0] + 4.0e6, node[1] + 3.5e7, node[2] - 200.0];
    }
    let found = Locator::new(&mesh, None).locate([4.0e6 + 1.4, 3.5e7 + 1.6, -198.5], 0.0);
    let found = found.expect("inside the middle element");
    let x = point(&mesh.elements[13].nodes.map(|n| mesh.nodes[n as usize]), &found.weights);
    assert_eq!(found.element, 13);
    // Spacing of numbers near 3.5e7.
    assert!((x[0] - 4.0e6 - 1.4).abs() < 1e-8 && (x[1] - 3.5e7 - 1.6).abs() < 1e-8);
}

#[test]
fn every_shape_is_mapped_back() {
    let mesh = one_of_each();
    let locator = Locator::new(&mesh, None);
    let mut random = Random(1);
    for (index, element) in mesh.elements.iter().enumerate() {
        let nodes: Vec<_> = element.nodes().iter().map(|&n| mesh.nodes[n as usize]).collect();
        for _ in 0..50 {
            // A random mean of the corners lies inside.
            let mut share = [0; 8].map(|_| random.next());
            share[element.shape.nodes()..].fill(0.0);
            let sum: f64 = share.iter().sum();
            let natural = point(corners(element.shape), &share.map(|s| s / sum));
            let at = point(&nodes, &weights(element.shape, natural));
            let found = locator.locate(at, 0.0).expect("the point is inside");
            assert_eq!(found.element, index as u32);
            for i in 0..3 {
                assert!((found.natural[i] - natural[i]).abs() < 1e-12, "{found:?} {natural:?}");
            }
        }
    }
}

#[test]
fn every_node_is_found_with_weight_one() {
    for mesh in [distorted_box(4), one_of_each()] {
        let locator = Locator::new(&mesh, None);
        for (node, &at) in mesh.nodes.iter().enumerate() {
            let found = locator.locate(at, 0.0).expect("a node is in an element");
            let nodes = &mesh.elements[found.element as usize].nodes();
            let own = nodes.iter().position(|&n| n as usize == node).expect("of that element");
            // A pyramid's apex is kept off by 1e-12.
            assert!((found.weights[own] - 1.0).abs() < 1e-10, "{node} {found:?}");
        }
    }
}

#[test]
fn a_linear_field_is_exact_everywhere() {
    let mesh = distorted_box(4);
    let locator = Locator::new(&mesh, None);
    let field = |x: [f64; 3]| 2.0 + x[0] - 3.0 * x[1] + 0.5 * x[2];
    let mut random = Random(3);
    for _ in 0..300 {
        // The outer nodes of the box are not displaced, so it is [0, 4]³.
        let at = [0; 3].map(|_| 4.0 * random.next());
        let found = locator.locate(at, 0.0).expect("inside the box");
        let nodes = &mesh.elements[found.element as usize].nodes;
        let value: f64 =
            nodes.iter().zip(found.weights).map(|(&n, w)| w * field(mesh.nodes[n as usize])).sum();
        assert!((value - field(at)).abs() < 1e-11);
    }
}

#[test]
fn a_point_just_outside_belongs_to_the_nearest_element() {
    let mesh = distorted_box(4);
    let locator = Locator::new(&mesh, None);
    let at = [-0.3, 1.6, 2.6];
    assert_eq!(locator.locate(at, 0.2999), None);
    let found = locator.locate(at, 0.3001).expect("within the tolerance");
    assert!((found.distance - 0.3).abs() < 1e-12);
    // Off an edge, and far away with a tolerance that reaches.
    let found = locator.locate([4.3, 4.4, 1.1], 1.0).expect("within the tolerance");
    assert!((found.distance - 0.5).abs() < 1e-12);
    let found = locator.locate([-100.0, -100.0, -100.0], 1e3).expect("within the tolerance");
    assert!((found.distance - 100.0 * 3.0_f64.sqrt()).abs() < 1e-9);
    assert_eq!((found.element, found.weights[0]), (0, 1.0));
}

#[test]
fn only_the_given_elements_are_found() {
    let mesh = distorted_box(4);
    let inner = locate_centre(&mesh, &Locator::new(&mesh, None), 21);
    assert_eq!(inner, Some(21));
    let others: Vec<u32> = (0..64).filter(|&e| e != 21).collect();
    let locator = Locator::new(&mesh, Some(&others));
    assert_eq!(locate_centre(&mesh, &locator, 21), None);
    assert_eq!(locate_centre(&mesh, &locator, 22), Some(22));
}

fn locate_centre(mesh: &Mesh, locator: &Locator, element: usize) -> Option<u32> {
    let nodes: Vec<_> = mesh.elements[element].nodes().iter().map(|&n| mesh.nodes[n as usize]).collect();
    locator.locate(point(&nodes, &[0.125; 8]), 0.0).map(|found| found.element)
}

#[test]
fn nothing_is_found_in_an_empty_mesh_or_at_no_number() {
    let empty = Mesh::default();
    assert_eq!(Locator::new(&empty, None).locate([0.0; 3], 1.0), None);
    let mesh = distorted_box(2);
    let locator = Locator::new(&mesh, None);
    assert_eq!(locator.locate([f64::NAN, 0.5, 0.5], 1.0), None);
    assert_eq!(locator.locate([f64::INFINITY, 0.5, 0.5], 1.0), None);
    assert_eq!(locator.locate([0.5, 0.5, 9.0], f64::NAN), None);
}

/// Lines at random through warped elements: stretches follow one another without gaps, each in its element, and shape functions at
/// their ends give a linear field.
#[test]
fn a_line_is_cut_where_it_leaves_an_element() {
    let mesh = distorted_box(4);
    let locator = Locator::new(&mesh, None);
    let field = |x: [f64; 3]| 2.0 + x[0] - 3.0 * x[1] + 0.5 * x[2];
    let mut random = Random(5);
    let mut many = 0;
    for _ in 0..200 {
        let from = [0; 3].map(|_| 4.0 * random.next());
        let to = [0; 3].map(|_| 4.0 * random.next());
        let length = (0..3).map(|i| (to[i] - from[i]).powi(2)).sum::<f64>().sqrt();
        let at = |s: f64| [0, 1, 2].map(|i| from[i] + s / length * (to[i] - from[i]));
        let stretches = locator.stretches(from, to);
        let mut last = 0.0;
        for stretch in &stretches {
            assert!((stretch.from - last).abs() < 1e-6 * length, "{stretches:?}");
            last = stretch.to;
            for k in 1..10 {
                let within = at(stretch.from + 0.1 * f64::from(k) * (stretch.to - stretch.from));
                assert!(locator.weights_in(stretch.element, within, 0.0).is_some(), "{stretch:?}");
            }
            for end in [stretch.from, stretch.to] {
                let (weights, place) = locator.weights_in(stretch.element, at(end), 0.0).expect("at its end");
                let nodes = &mesh.elements[stretch.element as usize].nodes;
                let value: f64 =
                    nodes.iter().zip(weights).map(|(&n, w)| w * field(mesh.nodes[n as usize])).sum();
                assert!((value - field(at(end))).abs() < 1e-9);
                assert!((value - field(place)).abs() < 1e-13);
            }
        }
        assert!((last - length).abs() < 1e-6 * length);
        many = many.max(stretches.len());
    }
    assert!(many >= 6, "no line ran through more than {many} elements");
}

#[test]
fn a_line_along_edges_and_one_through_a_hole_have_the_stretches_that_one_sees() {
    let mesh = crate::boxes::BoxSpec::uniform([0.0; 3], [4.0; 3], [4; 3]).mesh().expect("a box");
    let locator = Locator::new(&mesh, None);
    // Along an inner edge, in a face, and askew through corners.
    for (from, to) in [
        ([2.0, 2.0, -1.0], [2.0, 2.0, 5.0]),
        ([2.0, 0.3, 0.5], [2.0, 3.7, 0.5]),
        ([0.0, 0.0, 0.0], [4.0, 4.0, 4.0]),
    ] {
        let stretches = locator.stretches(from, to);
        assert_eq!(stretches.len(), 4, "{stretches:?}");
        let inside = if from[2] < 0.0 { 1.0 } else { 0.0 };
        assert!((stretches[0].from - inside).abs() < 1e-9);
        assert!(stretches.windows(2).all(|w| w[0].to == w[1].from));
    }
    let others: Vec<u32> = (0..64).filter(|e| *e != 21).collect();
    let holed = Locator::new(&mesh, Some(&others));
    let stretches = holed.stretches([-1.0, 1.4, 1.6], [5.0, 1.4, 1.6]);
    let ends: Vec<[f64; 2]> = stretches.iter().map(|s| [s.from, s.to]).collect();
    assert_eq!(ends, [[1.0, 2.0], [3.0, 4.0], [4.0, 5.0]]);
    // A point on a face has nodes of the face alone.
    let (weights, _) = locator.weights_in(21, [1.0, 1.25, 1.5], 0.0).expect("on its face");
    assert_eq!(weights.iter().filter(|w| **w != 0.0).count(), 4);
    assert!(locator.stretches([1.0; 3], [1.0; 3]).is_empty());
    assert!(locator.stretches([1.0; 3], [f64::NAN; 3]).is_empty());
}

/// The same mesh with elements and nodes in another order, and each brick's nodes begun at another corner.
fn renumbered(mesh: &Mesh) -> (Mesh, Vec<u32>) {
    // A stride that shares no divisor with either count leaves none out.
    let order = |count: usize| -> Vec<u32> { (0..count).map(|k| ((k * 101 + 17) % count) as u32).collect() };
    let (nodes, elements) = (order(mesh.nodes.len()), order(mesh.elements.len()));
    let mut other = mesh.clone();
    for (old, &new) in nodes.iter().enumerate() {
        other.nodes[new as usize] = mesh.nodes[old];
    }
    for (old, &new) in elements.iter().enumerate() {
        let mut element = mesh.elements[old];
        element.nodes = element.nodes.map(|n| nodes[n as usize]);
        element.nodes[..4].rotate_left(old % 4);
        element.nodes[4..].rotate_left(old % 4);
        other.elements[new as usize] = element;
    }
    (other, elements)
}

#[test]
fn what_lies_on_a_border_is_found_by_place_and_not_by_number() {
    let mut mesh = distorted_box(4);
    let (low, high) = mesh.bounds();
    let check = |mesh: &Mesh, at: [f64; 3]| {
        let (other, elements) = renumbered(mesh);
        let [found, again] = [mesh, &other].map(|m| Locator::new(m, None).locate(at, 0.1).expect("near"));
        assert_eq!(again.element, elements[found.element as usize], "{at:?}");
        found
    };
    // Corners, middles of edges, and a point outside beside an edge that two elements share.
    for e in 0..mesh.elements.len() {
        let n = mesh.elements[e].nodes;
        let [a, b] = [n[0], n[1]].map(|n| mesh.nodes[n as usize]);
        check(&mesh, a);
        check(&mesh, [0, 1, 2].map(|i| 0.5 * (a[i] + b[i])));
        check(&mesh, [a[0], a[1], low[2] - 0.05]);
    }
    // Bricks of one size, whose middles are all equally far: the first along x, y and z; where they differ, the smallest.
    mesh = crate::boxes::BoxSpec::uniform([0.0; 3], [4.0; 3], [4; 3]).mesh().unwrap();
    assert_eq!(check(&mesh, [2.0; 3]).element, 1 + 4 + 16);
    mesh.nodes.iter_mut().filter(|x| x[0] > 2.5).for_each(|x| x[0] = 2.5 + (x[0] - 2.5) / 3.0);
    let found = check(&mesh, [2.0; 3]);
    let x: f64 = mesh.elements[found.element as usize].nodes.iter().map(|&n| mesh.nodes[n as usize][0]).sum();
    assert!(x / 8.0 > 2.0 && high[0] == 4.0, "the narrow one");
    // A moved origin has other round-off.
    mesh.nodes.iter_mut().for_each(|x| *x = [x[0] + 4e6, x[1] + 3.5e7, x[2] - 200.3]);
    assert_eq!(check(&mesh, [4e6 + 2.0, 3.5e7 + 2.0, -198.3]).element, found.element);
}
