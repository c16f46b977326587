//! Columns of the ground beside a model.

use crate::ready::{Ready, body, whole};
use tremolite_engine::column::WIDTH;
use tremolite_engine::life::Life;
use tremolite_engine::{Base, Problem, Side, Traction};
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::{Face, Mesh};

fn bounds(places: impl Iterator<Item = [f64; 3]>) -> ([f64; 3], [f64; 3]) {
    places.fold(([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]), |(low, high), x| {
        ([0, 1, 2].map(|i| x[i].min(low[i])), [0, 1, 2].map(|i| x[i].max(high[i])))
    })
}

/// A picture shows each column by itself: they stand as far before the model as it is long, a column's width between them.
#[test]
fn columns_stand_before_the_model_and_apart_from_one_another() {
    let (low, high) = ([30.0, 70.0, -9.0], [36.0, 72.0, -5.0]);
    let mesh = BoxSpec::uniform(low, high, [2, 2, 2]).mesh().unwrap();
    let bodies = [0, 1, 2, 3].map(|of| {
        let mut body = body("ground", vec![of, of + 4]);
        body.density += 100.0 * f64::from(of);
        body
    });
    let mut problem = Problem::new(mesh, bodies.into());
    problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(20.0) };
    problem.sides = [Side::Roller; 2];
    let ready = Ready::new(problem);
    let all: Vec<_> = ready
        .model
        .outside
        .columns
        .iter()
        .map(|column| bounds(column.rings.iter().flatten().map(|&n| ready.model.mesh.nodes[n as usize])))
        .collect();
    assert_eq!(all.len(), 4);
    for (k, &(own_low, own_high)) in all.iter().enumerate() {
        assert!((own_high[0] - (low[0] - (high[0] - low[0]))).abs() < 1e-9, "{own_high:?}");
        assert!((own_low[2] - low[2]).abs() < 1e-9 && (own_high[2] - high[2]).abs() < 1e-9, "as high");
        for &(other_low, other_high) in &all[..k] {
            let gap = (own_low[1] - other_high[1]).max(other_low[1] - own_high[1]);
            assert!(gap > WIDTH - 1e-9, "{gap}");
        }
    }
}

/// The upper face of a brick.
const TOP: u8 = 5;

/// What presses on the top of the model presses on that of its columns, wherever zero is.
#[test]
fn columns_are_pressed_as_the_ground_beside_them() {
    for top in [0.0, 0.4, -7.0, 250.0] {
        let mesh: Mesh = BoxSpec::uniform([0.0, 0.0, top - 2.0], [3.0, 2.0, top], [3, 2, 2]).mesh().unwrap();
        let mut problem = whole(mesh);
        problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(20.0) };
        let stress = [-3e5, -2e5, -1e5, 0.0, 0.0, 0.0];
        let faces = (6..12).map(|element| (Face { element, side: TOP }, stress)).collect();
        problem.tractions = vec![Traction { name: "overburden".into(), faces, life: Life::ALWAYS }];
        let ready = Ready::new(problem);
        let columns = &ready.model.outside.columns;
        let uppermost: Vec<u32> =
            columns.iter().map(|column| column.layers.last().unwrap().element).collect();
        assert!(!uppermost.is_empty());
        let pressed: Vec<u32> = ready.model.loading.tractions[0]
            .faces
            .iter()
            .filter(|(face, _)| face.element as usize >= ready.model.user.elements)
            .inspect(|(face, own)| assert!(face.side == TOP && *own == stress))
            .map(|(face, _)| face.element)
            .collect();
        assert_eq!(pressed, uppermost, "top at {top}");
    }
}
