//! Columns of the ground along the model's vertical edges.

use crate::block::{block, pulse};
use tremolite::column::corner_name;
use tremolite::{Base, Body, Incident, Model, Problem, Quadrature, Side, elastic};
use tremolite_laws::Moduli;
use tremolite_mesh::boxes::BoxSpec;

const SPRINGS: Base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(20.0) };

/// A box of two rocks; `soft` says by centroid which.
fn two_rocks(base: Base, soft: impl Fn([f64; 3]) -> bool) -> Problem {
    let mesh = BoxSpec::uniform([0.0; 3], [8.0, 6.0, 4.0], [4, 3, 4]).mesh().unwrap();
    let of = |want: bool, young: f64| Body {
        name: if want { "soft" } else { "hard" }.into(),
        elements: (0..mesh.elements.len() as u32)
            .filter(|&e| soft(tremolite::hexahedra::centroid(&mesh, e)) == want)
            .collect(),
        material: elastic(Moduli::from_young_poisson(young, 0.25)),
        density: 2500.0,
        quadrature: Quadrature::OnePoint,
        viscosity: 0.0,
    };
    let bodies = vec![of(true, 1e9), of(false, 4e9)];
    let mut problem = Problem::new(mesh.clone(), bodies);
    (problem.base, problem.sides) = (base, [Side::Periodic; 2]);
    problem.incident = Some(Incident { motion: pulse(), factor: 0.5 });
    problem
}

/// A model and its mirror image once had different springs: theirs hung on the column of one corner.
#[test]
fn corners_that_differ_have_a_column_each_and_the_base_lies_between_them() {
    let left = |x: [f64; 3]| x[0] < 4.0;
    let right = |x: [f64; 3]| x[0] > 4.0;
    let behind = |x: [f64; 3]| x[1] > 4.0;
    let all = [
        (&left as &dyn Fn([f64; 3]) -> bool, [0, 2], "reference-xmin-ymin+xmin-ymax"),
        (&right, [0, 2], "reference-xmin-ymin+xmin-ymax"),
        (&behind, [0, 1], "reference-xmin-ymin+xmax-ymin"),
    ];
    for base in [SPRINGS, Base::Viscous] {
        for (soft, first, name) in &all {
            let model = Model::new(two_rocks(base, soft)).unwrap();
            let corners: Vec<&[usize]> =
                model.outside.columns.iter().map(|column| column.corners.as_slice()).collect();
            assert_eq!((corners.len(), corners[0]), (2, first.as_slice()));
            assert_eq!(model.outside.columns[0].name, *name);
            // Who reads free_field.csv goes by the names alone.
            for column in &model.outside.columns {
                let named = tremolite_results::Station { name: column.name.clone(), ..Default::default() };
                let served: Vec<usize> = (0..4).filter(|&k| named.serves(&corner_name(k))).collect();
                assert_eq!(served, column.corners, "{}", column.name);
            }
        }
    }
    // Layers are the same everywhere.
    let model = Model::new(two_rocks(SPRINGS, |x| x[2] > 2.0)).unwrap();
    let [column] = model.outside.columns.as_slice() else {
        panic!("{} columns", model.outside.columns.len())
    };
    assert_eq!((column.name.as_str(), column.rings.len(), column.layers.len()), ("reference", 5, 4));
}

/// Two rocks that meet in the corner's own edge: one of them was taken, whichever came first.
#[test]
fn materials_that_meet_along_a_corner_edge_are_no_ground_of_one_column() {
    let mesh = BoxSpec::uniform([0.0; 3], [2.0, 2.0, 2.0], [1, 1, 2]).mesh().unwrap();
    let mut problem = two_rocks(SPRINGS, |_| true);
    let halves =
        tremolite_mesh::Mesh { elements: mesh.elements.iter().flat_map(wedges).collect(), ..mesh.clone() };
    let count = halves.elements.len() as u32;
    let body = |name: &str, odd: u32, young| Body {
        name: name.into(),
        elements: (0..count).filter(|e| e % 2 == odd).collect(),
        material: elastic(Moduli::from_young_poisson(young, 0.25)),
        density: 2500.0,
        quadrature: Quadrature::OnePoint,
        viscosity: 0.0,
    };
    problem.bodies = vec![body("soft", 0, 1e9), body("hard", 1, 4e9)];
    problem.mesh = halves;
    problem.sides = [Side::Viscous; 2];
    let refused = Model::new(problem).err().unwrap().to_string();
    assert!(refused.contains("two materials meet along the vertical edge"), "{refused}");
}

/// The two wedges of a brick, cut through the corners 0 and 2.
fn wedges(brick: &tremolite_mesh::Element) -> Vec<tremolite_mesh::Element> {
    let n = brick.nodes();
    let wedge = |k: [usize; 6]| tremolite_mesh::Element::new(tremolite_mesh::Shape::Wedge6, &k.map(|k| n[k]));
    vec![wedge([0, 1, 2, 4, 5, 6]), wedge([0, 2, 3, 4, 6, 7])]
}

#[test]
fn the_block_of_the_other_tests_has_a_column_with_and_without_springs() {
    for base in [SPRINGS, Base::Viscous] {
        let mut problem = block([4, 4, 5]);
        problem.base = base;
        assert!(Model::new(problem).unwrap().outside.columns.len() == 1);
    }
}
