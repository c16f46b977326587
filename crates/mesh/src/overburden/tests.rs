use super::weight_above;
use crate::boxes::{Axis, BoxSpec, Distortion};
use crate::locate::Locator;
use crate::sample::{Random, elements_where, one_of_each};
use crate::split::{Cut, split};
use crate::{Element, Mesh, Shape};

const ROCK: f64 = 26_000.0;

fn centroids(mesh: &Mesh) -> Vec<[f64; 3]> {
    let mean = |e: &Element, i: usize| {
        let nodes = e.nodes();
        nodes.iter().map(|&n| mesh.nodes[n as usize][i]).sum::<f64>() / nodes.len() as f64
    };
    mesh.elements.iter().map(|e| [0, 1, 2].map(|i| mean(e, i))).collect()
}

/// Round-off of a few terms of the size of the whole weight.
fn assert_equal(got: &[f64], exact: &[f64]) {
    let most = exact.iter().fold(0.0, |most: f64, p| most.max(p.abs()));
    for (k, (got, exact)) in got.iter().zip(exact).enumerate() {
        assert!((got - exact).abs() <= 1e-14 * most, "{k}: {got} {exact}");
    }
}

fn layered() -> Mesh {
    let z = Axis::Coordinates(vec![-40.0, -31.0, -20.0, -12.0, -5.0, 3.0]);
    BoxSpec { z, ..BoxSpec::uniform([-7.0, 2.0, 0.0], [14.0, 9.0, 0.0], [6, 5, 1]) }
        .mesh()
        .expect("a legal box")
}

fn distorted(cells: [u32; 3], seed: u64) -> Mesh {
    let distortion = Some(Distortion { fraction: 0.15, seed, periodic: [false; 2] });
    let size = cells.map(|n| 2.0 * f64::from(n));
    BoxSpec { distortion, ..BoxSpec::uniform([0.0; 3], size, cells) }.mesh().expect("a legal box")
}

/// Each hexahedron cut into six tetrahedra round a diagonal, face to face with those of its neighbours.
fn tetrahedra(mesh: &Mesh) -> Mesh {
    const TETS: [[usize; 4]; 6] =
        [[0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6], [0, 5, 1, 6]];
    let cut = |e: &Element| TETS.map(|t| Element::new(Shape::Tet4, &t.map(|k| e.nodes[k])));
    let elements = mesh.elements.iter().flat_map(cut).collect();
    Mesh { nodes: mesh.nodes.clone(), elements, ..Mesh::default() }
}

#[test]
fn in_layers_the_weight_is_exact_at_centroids_nodes_and_on_outer_sides() {
    let mesh = layered();
    let layer = |z: f64| {
        if z < -20.0 {
            27_000.0
        } else if z < -5.0 {
            25_000.0
        } else {
            19_000.0
        }
    };
    let middles = centroids(&mesh);
    let weights: Vec<f64> = middles.iter().map(|x| layer(x[2])).collect();
    let exact = |x: &[f64; 3]| {
        let in_layer = |from: f64, to: f64, weight: f64| weight * (to - x[2].clamp(from, to));
        in_layer(-40.0, -20.0, 27_000.0) + in_layer(-20.0, -5.0, 25_000.0) + in_layer(-5.0, 3.0, 19_000.0)
    };
    for points in [&middles, &mesh.nodes] {
        let exact: Vec<f64> = points.iter().map(exact).collect();
        assert_equal(&weight_above(&mesh, &weights, points), &exact);
    }
    // Above the ground and beside the model there is nothing, below it is all.
    let whole = exact(&[0.0, 3.0, -40.0]);
    let out = [[0.0, 3.0, 4.0], [-7.1, 3.0, -10.0], [0.0, 9.1, -10.0], [0.0, 3.0, -45.0]];
    assert_equal(&weight_above(&mesh, &weights, &out), &[0.0, 0.0, 0.0, whole]);
    assert!(weight_above(&mesh, &weights, &[[f64::NAN, 3.0, 0.0]])[0].is_nan());
}

#[test]
fn in_a_distorted_mesh_under_level_ground_depth_alone_counts() {
    let mesh = distorted([6, 5, 7], 3);
    let points: Vec<[f64; 3]> = centroids(&mesh).into_iter().chain(mesh.nodes.iter().copied()).collect();
    let exact: Vec<f64> = points.iter().map(|x| ROCK * (14.0 - x[2])).collect();
    assert_equal(&weight_above(&mesh, &vec![ROCK; mesh.elements.len()], &points), &exact);
}

#[test]
fn under_a_slope_the_weight_is_that_up_to_the_slope() {
    let mut mesh = distorted([5, 6, 4], 8);
    let top = |x: f64, y: f64| 8.0 + 0.4 * x - 0.3 * y;
    mesh.nodes.iter_mut().for_each(|x| x[2] *= top(x[0], x[1]) / 8.0);
    let points: Vec<[f64; 3]> = centroids(&mesh).into_iter().chain(mesh.nodes.iter().copied()).collect();
    let exact: Vec<f64> = points.iter().map(|x| ROCK * (top(x[0], x[1]) - x[2])).collect();
    assert_equal(&weight_above(&mesh, &vec![ROCK; mesh.elements.len()], &points), &exact);
}

#[test]
fn a_void_weighs_nothing() {
    let mesh = layered();
    let void = elements_where(&mesh, |x| (-20.0..-12.0).contains(&x[2]) && x[0] > 0.0 && x[0] < 7.0);
    let mut weights = vec![ROCK; mesh.elements.len()];
    void.iter().for_each(|&e| weights[e as usize] = 0.0);
    let points = centroids(&mesh);
    let exact: Vec<f64> = points
        .iter()
        .map(|x| {
            let hollow = if x[0] > 0.0 && x[0] < 7.0 { -12.0 - x[2].clamp(-20.0, -12.0) } else { 0.0 };
            ROCK * (3.0 - x[2] - hollow)
        })
        .collect();
    assert!(void.len() > 1);
    assert_equal(&weight_above(&mesh, &weights, &points), &exact);
    // Elements that are not there at all leave the same.
    let gone = |e: &usize| weights[*e] > 0.0;
    let elements: Vec<Element> = (0..mesh.elements.len()).filter(gone).map(|e| mesh.elements[e]).collect();
    let rest = Mesh { nodes: mesh.nodes.clone(), elements, ..Mesh::default() };
    assert_equal(&weight_above(&rest, &vec![ROCK; rest.elements.len()], &points), &exact);
}

#[test]
fn where_each_element_has_its_own_weight_the_integral_along_the_vertical_comes_out() {
    let mesh = tetrahedra(&distorted([3, 3, 3], 5));
    let mut random = Random(11);
    let weights: Vec<f64> = mesh.elements.iter().map(|_| ROCK * (0.5 + random.next())).collect();
    let locator = Locator::new(&mesh, None);
    let steps = 2000;
    for _ in 0..40 {
        let x = [0, 1, 2].map(|_| 0.3 + 5.4 * random.next());
        let step = (6.0 - x[2]) / f64::from(steps);
        let at = |k: i32| [x[0], x[1], x[2] + (f64::from(k) + 0.5) * step];
        let sum: f64 = (0..steps)
            .map(|k| weights[locator.locate(at(k), 1e-6).expect("inside").element as usize] * step)
            .sum();
        // The midpoint rule errs by half a step at a face, of which a vertical meets 30 at most, by less than ROCK.
        let got = weight_above(&mesh, &weights, &[x])[0];
        assert!((got - sum).abs() < 15.0 * step * ROCK && got > 0.0, "{got} {sum}");
    }
}

#[test]
fn every_shape_has_the_weight_of_its_own_height() {
    // Beneath the apex of the pyramid over the hexahedron: 2 m down to its base, then the hexahedron.
    let mesh = one_of_each();
    let weights = [ROCK; 4];
    let x = [0.5, 0.4, 0.5];
    let locator = Locator::new(&mesh, None);
    let inside = |z: f64| locator.locate([x[0], x[1], z], 0.0).is_some();
    let steps = 10_000;
    let step = 2.0 / f64::from(steps);
    let heights = (0..steps).map(|k| (f64::from(k) + 0.5) * step).filter(|z| *z > x[2] && inside(*z));
    let exact = ROCK * step * heights.count() as f64;
    let got = weight_above(&mesh, &weights, &[x])[0];
    // A step at either end, and what a warped base is off its triangles is in both elements at once.
    assert!((got - exact).abs() < 2.0 * step * ROCK, "{got} {exact}");
}

#[test]
fn the_order_of_elements_changes_no_bit() {
    let mesh = distorted([4, 4, 5], 9);
    let mut random = Random(3);
    let weights: Vec<f64> =
        mesh.elements.iter().map(|_| ROCK * [0.0, 0.7, 1.0, random.next()][random.below(4)]).collect();
    let points = [centroids(&mesh), mesh.nodes.clone()].concat();
    let before = weight_above(&mesh, &weights, &points);
    for _ in 0..5 {
        let mut order: Vec<usize> = (0..mesh.elements.len()).collect();
        (1..order.len()).rev().for_each(|k| order.swap(k, random.below(k + 1)));
        let elements = order.iter().map(|&e| mesh.elements[e]).collect();
        let shuffled = Mesh { nodes: mesh.nodes.clone(), elements, ..Mesh::default() };
        let own: Vec<f64> = order.iter().map(|&e| weights[e]).collect();
        let after = weight_above(&shuffled, &own, &points);
        assert!(before.iter().zip(&after).all(|(a, b)| a.to_bits() == b.to_bits()));
    }
}

#[test]
fn an_interface_that_is_split_weighs_nothing() {
    let mut mesh = distorted([4, 4, 4], 2);
    let [low, high] = [true, false].map(|low| elements_where(&mesh, |x| (x[2] < 4.0) == low));
    let mut weights = vec![ROCK; mesh.elements.len()];
    high.iter().step_by(2).for_each(|&e| weights[e as usize] = 0.9 * ROCK);
    let points = centroids(&mesh);
    let before = weight_above(&mesh, &weights, &points);
    let times = vec![0..1; mesh.elements.len()];
    split(&mut mesh, &[Cut { name: "level", sides: [&low, &high] }], &times).expect("it splits");
    assert_equal(&weight_above(&mesh, &weights, &points), &before);
}
