//! From which step on a node may take one of twice the length, found by asking for the levels of one step after another.

use crate::ready::{DENSITY, Ready, body, joint, moduli, whole};
use tremolite_engine::{Base, Body, Problem, Quadrature, Side, find_levels, finer_levels};
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::{Element, Mesh, Shape};

/// The longest step \[s\] that the bounds allow a node of the mesh.
fn allowed(ready: &Ready, node: u32) -> f64 {
    let Ready { model, assembly, phase } = ready;
    let coarser = |dt: f64| find_levels(model, assembly, phase, dt, 2).unwrap().of_node(node) > 0;
    let (mut low, mut high) = (1e-9, 1.0);
    assert!(coarser(low) && !coarser(high));
    while high > (1.0 + 1e-12) * low {
        let middle = (low * high).sqrt();
        *if coarser(middle) { &mut low } else { &mut high } = middle;
    }
    2.0 * low
}

/// ω² \[1/s²\] of a bound: eight tenths of 2/ω.
fn square(allowed: f64) -> f64 {
    (1.6 / allowed).powi(2)
}

fn cube() -> Problem {
    whole(BoxSpec::uniform([0.0; 3], [1.0; 3], [1; 3]).mesh().unwrap())
}

/// By its own highest frequency, viscosity and damping, and by the springs at its nodes: to ω² comes Σk/m.
#[test]
fn an_element_may_take_eight_tenths_of_its_bound_with_the_springs_at_its_nodes() {
    let free = Ready::new(cube());
    let own = allowed(&free, 0);
    assert!((own / (0.8 * free.stable().dt) - 1.0).abs() < 1e-5, "the search for λ ends at 10⁻⁵: {own}");

    for distance in [2.0, 0.02] {
        let mut problem = cube();
        problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(distance) };
        let springs = (1.33 + 2.0 * 0.67) * moduli().mu / distance * 0.25;
        let found = square(allowed(&Ready::new(problem), 0)) - square(own);
        let exact = springs / (DENSITY / 8.0);
        assert!((found / exact - 1.0).abs() < 1e-8, "{distance}: {found} {exact}");
    }

    let mut problem = cube();
    problem.bodies[0].viscosity = 0.3;
    let share = 1.09_f64.sqrt() - 0.3;
    assert!((allowed(&Ready::new(problem), 0) / (share * own) - 1.0).abs() < 1e-9);

    let mut problem = cube();
    problem.rayleigh.mass = 4.0 / own;
    assert!((allowed(&Ready::new(problem), 0) / (0.4 * own) - 1.0).abs() < 1e-9, "0.8·2/ω");
}

/// Of two cubes one on the other, 1/m at either node of a pair and k a quarter of the face's.
#[test]
fn pairs_allow_what_their_impacts_do_and_are_springs_of_twice_their_stiffness_at_elements() {
    let cubes = |limit: f64| {
        let mesh = BoxSpec::uniform([0.0; 3], [1.0, 1.0, 2.0], [1, 1, 2]).mesh().unwrap();
        let mut problem = Problem::new(mesh, vec![body("below", vec![0]), body("above", vec![1])]);
        let mut joint = joint(&problem, [0, 1], 1e12);
        (joint.damping, joint.viscosity, joint.limit) = (0.0, 0.0, limit);
        problem.interfaces = vec![joint];
        Ready::new(problem)
    };
    let (own, mass) = (square(allowed(&Ready::new(cube()), 0)), DENSITY / 8.0);
    // Impacts alone: (ω Δt) at most 0.8, ω² = k(1/m + 1/m).
    let impacts = cubes(0.8);
    let exact = 0.8 / (0.25e12 * 2.0 / mass).sqrt();
    let found = allowed(&impacts, 4);
    assert!((found / exact - 1.0).abs() < 1e-9, "{found} {exact}");
    let contact = impacts.stable().contact.unwrap();
    assert!((found / contact.dt - 1.0).abs() < 1e-9, "the same as is told of impacts");
    // Impacts that may do what they will: 2k at each node, as heavy as all that the pair moves.
    let found = square(allowed(&cubes(1e6), 4)) - own;
    let exact = 2.0 * 0.25e12 / mass;
    assert!((found / exact - 1.0).abs() < 1e-8, "{found} {exact}");
}

/// A bar of cubes, of which patches of four have one level.
fn bar(wished: impl Fn([f64; 3]) -> u8) -> Ready {
    let mesh = BoxSpec::uniform([0.0; 3], [24.0, 1.0, 1.0], [24, 1, 1]).mesh().unwrap();
    let mut problem = whole(mesh);
    problem.bodies = vec![Body { quadrature: Quadrature::OnePoint, ..problem.bodies.remove(0) }];
    problem.sides = [Side::Free; 2];
    problem.patch_elements = Some(8);
    Ready::new(problem).levelled(wished)
}

/// Where a member pushes coarser nodes these become as fine as it is; one that does not becomes finer itself.
#[test]
fn levels_become_finer_at_members_by_a_layer_where_there_is_a_border_and_else_by_a_level() {
    let ready = bar(|[x, ..]| if x < 8.5 { 1 } else { 2 });
    let mut cases = [0, 0];
    for &m in &ready.phase.active {
        let member = &ready.assembly.members[m as usize];
        let level = |n: u32| ready.model.nodes.level[n as usize];
        let nodes = member.part.nodes();
        let border = nodes.iter().any(|&n| level(n) == member.level + 1);
        let levels = finer_levels(&ready.model, &ready.assembly, &ready.phase, &[m]);
        let wished = if border { member.level } else { member.level - 1 };
        for &n in nodes {
            assert_eq!(levels.of_node(ready.model.mesh_node[n as usize]), wished, "{:?}", ready.place(n));
        }
        cases[usize::from(border)] += 1;
        // What is two elements away from it stays as it was.
        let near = |at: [f64; 3]| nodes.iter().any(|&n| (ready.place(n)[0] - at[0]).abs() < 1.5);
        for n in (0..ready.model.mesh_node.len() as u32).filter(|&n| !near(ready.place(n))) {
            let found = levels.of_node(ready.model.mesh_node[n as usize]);
            assert_eq!(found, level(n), "{:?}", ready.place(n));
        }
    }
    assert!(cases[0] > 1 && cases[1] == 1, "{cases:?}");
}

/// Through a plate of two layers of wedges, which are thick from triangle to triangle, nodes have one level; along it they need not.
#[test]
fn nodes_step_together_through_a_thin_plate_of_wedges() {
    let bricks = BoxSpec::uniform([0.0; 3], [6.0, 6.0, 2.0], [6, 6, 2]).mesh().unwrap();
    let halves = bricks.elements.iter().flat_map(|brick| {
        let n = brick.nodes();
        [[0, 1, 2], [0, 2, 3]]
            .map(|[a, b, c]| Element::new(Shape::Wedge6, &[n[a], n[b], n[c], n[4 + a], n[4 + b], n[4 + c]]))
    });
    let mesh = Mesh { elements: halves.collect(), ..bricks.clone() };
    let differ = |wished: fn([f64; 3]) -> u8| {
        let ready = Ready::new(whole(mesh.clone())).levelled(wished);
        ready.model.nodes.level.iter().any(|level| *level != ready.model.nodes.level[0])
    };
    assert!(!differ(|[.., z]| u8::from(z > 0.5)) && differ(|[x, ..]| u8::from(x > 3.5)));
}
