//! What absorbs at the nodes of boundaries, beside their areas.

use crate::ready::{DENSITY, Ready, moduli, whole};
use std::collections::BTreeMap;
use tremolite_engine::{Assembly, Base, Domain, Model, ModelError, Phase, Problem, Side, Stage, Top};
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::{Element, Mesh, Shape};

const LOW: [f64; 3] = [7.0, -4.0, 30.0];
const HIGH: [f64; 3] = [10.0, -2.0, 34.0];

fn block(sides: Side, base: Base, top: Top) -> Ready {
    let mut problem = whole(BoxSpec::uniform(LOW, HIGH, [3, 4, 2]).mesh().unwrap());
    (problem.sides, problem.base, problem.top) = ([sides; 2], base, top);
    Ready::new(problem)
}

/// ρ c A of a node of the block on some of its planes, with its share of the areas.
fn exact(at: [f64; 3], planes: &[(usize, usize)]) -> [f64; 3] {
    let ends = [0, 1, 2].map(|i| [(at[i] - LOW[i]).abs() < 1e-9, (at[i] - HIGH[i]).abs() < 1e-9]);
    let edges = [1.0, 0.5, 2.0];
    let shares = [0, 1, 2].map(|i| if ends[i] == [false; 2] { edges[i] } else { 0.5 * edges[i] });
    let (p, s) = moduli().wave_speeds(DENSITY);
    let mut sum = [0.0; 3];
    for &(axis, _) in planes.iter().filter(|&&(axis, end)| ends[axis][end]) {
        let area = shares[(axis + 1) % 3] * shares[(axis + 2) % 3];
        (0..3).for_each(|i| sum[i] += DENSITY * area * if i == axis { p } else { s });
    }
    sum
}

fn compare(found: &[f64; 6], exact: [f64; 3], at: [f64; 3]) {
    let scale = 1e-9 * (1.0 + exact[0] + exact[1] + exact[2]);
    let exact = [exact[0], exact[1], exact[2], 0.0, 0.0, 0.0];
    let near = found.iter().zip(exact).all(|(f, e)| (f - e).abs() < scale);
    assert!(near, "{at:?}: {found:?} {exact:?}");
}

/// The model's own nodes.
fn own(ready: &Ready) -> impl Iterator<Item = u32> {
    let domain = &ready.model.nodes.domain;
    (0..domain.len() as u32).filter(|&n| domain[n as usize] == Domain::Model)
}

const SIDES: [(usize, usize); 4] = [(0, 0), (0, 1), (1, 0), (1, 1)];

/// ρ c_p A across each plane and ρ c_s A along it, by its area at each node, and where planes meet the sum (`lysmer1969`).
#[test]
fn nodes_of_absorbing_planes_have_the_impedance_of_their_areas() {
    let ready = block(Side::Viscous, Base::Viscous, Top::Viscous);
    let known: BTreeMap<u32, _> = ready.phase.dashpots.iter().map(|(n, dashpot)| (*n, dashpot)).collect();
    let mut several = 0;
    for n in own(&ready) {
        let (at, own) = (ready.place(n), known.get(&n).map(|&own| own.clone()).unwrap_or_default());
        let above = exact(at, &[(2, 1)]);
        let sides = exact(at, &SIDES);
        compare(&own.base, exact(at, &[(2, 0)]), at);
        compare(&own.sides, [0, 1, 2].map(|i| sides[i] + above[i]), at);
        let all = [&SIDES[..], &[(2, 0), (2, 1)]].concat();
        compare(&own.whole, exact(at, &all), at);
        several += usize::from(own.whole != [0.0; 6]);
    }
    assert_eq!(several, 4 * 5 * 3 - 2 * 3, "all but those inside");
}

/// The same between the nodes of a free-field side and those that lead them.
#[test]
fn nodes_of_free_field_sides_follow_by_the_impedance_of_their_areas() {
    let ready = block(Side::FreeField, Base::Fixed, Top::Free);
    let known: BTreeMap<u32, _> = ready.phase.dashpots.iter().map(|(n, dashpot)| (*n, dashpot)).collect();
    let mut following = 0;
    for n in own(&ready) {
        let at = ready.place(n);
        let mut sum = [0.0; 6];
        let follows = known.get(&n).map_or(&[][..], |own| &own.follows[..]);
        follows.iter().for_each(|follow| (0..6).for_each(|k| sum[k] += follow.matrix[k]));
        compare(&sum, exact(at, &SIDES), at);
        following += usize::from(!follows.is_empty());
    }
    assert_eq!(following, 3 * (4 * 5 - 2 * 3));
}

/// Of a wedge one side has a face and the one across it none.
#[test]
fn a_periodic_side_that_nothing_lies_across_is_named() {
    let mesh = Mesh {
        nodes: [0.0, 1.0].into_iter().flat_map(|z| [[0.0, 0.0, z], [2.0, 1.0, z], [0.0, 2.0, z]]).collect(),
        elements: vec![Element::new(Shape::Wedge6, &[0, 1, 2, 3, 4, 5])],
        ..Mesh::default()
    };
    for (turned, name) in [(1.0, "xmax"), (-1.0, "xmin")] {
        let mut mesh = mesh.clone();
        mesh.nodes.iter_mut().for_each(|x| (x[0], x[1]) = (turned * x[0], turned * x[1]));
        let mut problem: Problem = whole(mesh);
        problem.sides = [Side::Periodic, Side::Free];
        let model = Model::new(problem).unwrap();
        let assembly = Assembly::new(&model).unwrap();
        let refused = Phase::of(&model, &assembly, Stage::Shaking).err();
        assert!(matches!(refused, Some(ModelError::NoFaces(side)) if side == name), "{refused:?}");
    }
}
