//! Columns of the ground beside a model.

use crate::ready::{Ready, body, whole};
use tremolite_engine::column::WIDTH;
use tremolite_engine::life::Life;
use tremolite_engine::{Base, Domain, Problem, Side, Traction};
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

/// Where the model's top is pressed, so is all that stands outside its sides, up to the corners, and nothing else of it.
#[test]
fn slabs_are_pressed_where_the_ground_beside_them_is() {
    let (low, high) = ([4.0, 0.0, -2.0], [7.0, 2.0, 1.0]);
    let mut problem = whole(BoxSpec::uniform(low, high, [3, 2, 3]).mesh().unwrap());
    problem.sides = [Side::FreeField; 2];
    let stress = [-3e5, -2e5, -1e5, 0.0, 0.0, 0.0];
    let faces = (12..18).map(|element| (Face { element, side: TOP }, stress)).collect();
    problem.tractions = vec![Traction { name: "overburden".into(), faces, life: Life::ALWAYS }];
    let ready = Ready::new(problem);
    let mesh = &ready.model.mesh;
    let on_top = |n: u32| (mesh.nodes[n as usize][2] - high[2]).abs() < 1e-9;
    let outer = ready.model.outside.sheets().flat_map(|sheet| sheet.elements());
    let mut above: Vec<u32> =
        outer.filter(|&e| mesh.elements[e as usize].nodes().iter().any(|&n| on_top(n))).collect();
    above.sort_unstable();
    let columns = ready.model.outside.columns.iter().filter(|column| column.sheet.is_none());
    let columns: Vec<u32> = columns.map(|column| column.layers.last().unwrap().element).collect();
    let mut pressed: Vec<u32> = Vec::new();
    for (face, own) in &ready.model.loading.tractions[0].faces {
        assert!(mesh.face_nodes(*face).all(on_top) && *own == stress, "{face:?}");
        if face.element as usize >= ready.model.user.elements && !columns.contains(&face.element) {
            pressed.push(face.element);
        }
    }
    pressed.sort_unstable();
    assert!(above.len() >= 2 * (3 + 2), "{}", above.len());
    assert_eq!(pressed, above);
}

/// What stands outside one pair of sides ends at the other pair as the model does there.
#[test]
fn slabs_are_held_where_they_end_as_the_model_is_there() {
    let (low, high) = ([4.0, 0.0, -2.0], [7.0, 2.0, 1.0]);
    let mut problem = whole(BoxSpec::uniform(low, high, [3, 4, 3]).mesh().unwrap());
    problem.sides = [Side::FreeField, Side::Roller];
    let ready = Ready::new(problem);
    let mut ends = [0, 0];
    for n in (0..ready.model.mesh_node.len()).filter(|&n| ready.model.nodes.domain[n] == Domain::Slab) {
        let [_, y, _] = ready.place(n as u32);
        let moves = ready.phase.inverse_mass[ready.phase.master[n] as usize].0;
        let end = (y - low[1]).abs() < 1e-9 || (y - high[1]).abs() < 1e-9;
        assert_eq!([0, 1, 2].map(|i| moves[i] > 0.0), [true, !end, true], "y = {y}");
        ends[usize::from(end)] += 1;
    }
    assert!(ends[0] > 0 && ends[1] > 0);
}
