//! The base: from where its springs count, how far they reach, and which nodes one part has.

use crate::ready::{Ready, body, whole};
use std::sync::Arc;
use tremolite_engine::free_field::GivenField;
use tremolite_engine::parts::{Motion, Own, Scratch, Tick};
use tremolite_engine::{Base, Kind, Problem, Side};
use tremolite_laws::Row;
use tremolite_mesh::boxes::BoxSpec;

/// A block whose four quarters are ground of their own, so that the columns at its edges differ.
fn quarters(sides: [Side; 2]) -> Problem {
    let (low, high) = ([-3.0, 20.0, 5.0], [5.0, 26.0, 9.0]);
    let mesh = BoxSpec::uniform(low, high, [8, 6, 2]).mesh().unwrap();
    let quarter = |e: u32| (usize::from(e % 8 >= 4), usize::from(e / 8 % 6 >= 3));
    let bodies = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|of| {
        let elements = (0..mesh.elements.len() as u32).filter(|&e| quarter(e) == of).collect();
        let mut body = body("ground", elements);
        body.density += 100.0 * of.0 as f64 + 200.0 * of.1 as f64;
        body
    });
    let mut problem = Problem::new(mesh, bodies.into());
    problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(20.0) };
    problem.sides = sides;
    problem
}

/// 1 + 2ξ + 3η + 5ξη along x, with ξ and η from 0 to 1 along the block and what it is at its ends beyond; twice that along y.
fn bilinear(low: [f64; 3], high: [f64; 3], at: [f64; 3]) -> [f64; 3] {
    let [x, y] = [0, 1].map(|i| ((at[i] - low[i]) / (high[i] - low[i])).clamp(0.0, 1.0));
    let u = 1.0 + 2.0 * x + 3.0 * y + 5.0 * x * y;
    [u, 2.0 * u, -u]
}

/// The free field at the base is bilinear between the columns, and at the base of a slab linear between those at its ends, whatever stands
/// there: what moves so is not held.
#[test]
fn springs_hold_nothing_that_moves_as_the_columns_do() {
    let every = [
        [Side::FreeField; 2],
        [Side::FreeField, Side::Roller],
        [Side::Viscous, Side::FreeField],
        [Side::Viscous; 2],
    ];
    for sides in every {
        let mut problem = quarters(sides);
        problem.side_springs = sides.contains(&Side::FreeField);
        let ready = Ready::new(problem);
        let (low, high) = ready.model.faces.bounds;
        let own = ready.model.user.nodes as u32;
        let columns = &ready.model.outside.columns;
        let mut u: Vec<Row> = (0..ready.model.mesh_node.len() as u32)
            .map(|n| Row::new(bilinear(low, high, ready.place(n))))
            .collect();
        let mut corners = [0; 4];
        for column in columns {
            assert!(column.bottom >= own && column.corners.len() == 1, "{sides:?}: {}", column.name);
            let [x, y] = [column.corners[0] & 1, column.corners[0] >> 1];
            corners[column.corners[0]] += 1;
            let at = [[low[0], high[0]][x], [low[1], high[1]][y], low[2]];
            u[ready.model.engine_node[column.bottom as usize] as usize] = Row::new(bilinear(low, high, at));
        }
        assert!(corners.iter().all(|&count| count > 0), "{sides:?}: {corners:?}");
        let still = vec![Row::ZERO; u.len()];
        let largest = |u: &[Row], counted: bool| -> f64 {
            let members = ready.assembly.members.iter();
            let forces = members.filter(|m| m.kind == Kind::Boundary && m.counted == counted).map(|m| {
                let mut out = vec![Row::ZERO; m.part.nodes().len()];
                let mut numbers = vec![0.0; m.part.state_sizes().numbers];
                let own = Own {
                    history: &mut [],
                    overstress: &mut [],
                    numbers: &mut numbers,
                    reference: &mut [],
                    initial: &[],
                };
                let tick = Tick { time: 0.0, dt: 1e-3, step: 0 };
                m.part.forces(&tick, &Motion::new(u, &still), own, &mut out, &mut Scratch::default());
                out.iter().flat_map(|row| row.xyz()).fold(0.0, |most: f64, f| most.max(f.abs()))
            });
            forces.fold(0.0, f64::max)
        };
        let outside = sides.contains(&Side::FreeField);
        for counted in if outside { &[true, false][..] } else { &[true] } {
            // Only the columns have moved.
            let alone: Vec<Row> =
                (0..).zip(&u).map(|(n, &u)| if is_column(&ready, n) { u } else { Row::ZERO }).collect();
            let (held, alone) = (largest(&u, *counted), largest(&alone, *counted));
            assert!(alone > 1e6 && held < 1e-13 * alone, "{sides:?}, {counted}: {held:e} of {alone:e}");
        }
    }
}

/// Where the model alone moves by a unit, sides across x hold it along x with Σ A α_N G/R and sides across y with Σ A α_T G/R, R the distance
/// from the centre of the model to each.
#[test]
fn springs_of_free_field_sides_have_the_stiffness_of_their_faces() {
    let mesh = BoxSpec::uniform([0.0; 3], [8.0, 6.0, 4.0], [4, 3, 2]).mesh().unwrap();
    let elements = (0..mesh.elements.len() as u32).collect();
    let body = body("rock", elements);
    let shear = body.material.moduli().mu;
    let mut problem = Problem::new(mesh, vec![body]);
    problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(20.0) };
    problem.sides = [Side::FreeField; 2];
    let along_x = |side_springs: bool| {
        let mut problem = problem.clone();
        problem.side_springs = side_springs;
        let ready = Ready::new(problem);
        let unit = |n: u32| ready.model.nodes.domain[n as usize] == tremolite_engine::Domain::Model;
        let u: Vec<Row> = (0..ready.model.mesh_node.len() as u32)
            .map(|n| Row::new([f64::from(u8::from(unit(n))), 0.0, 0.0]))
            .collect();
        let springs = ready.assembly.members.iter().filter(|m| m.kind == Kind::Boundary && m.counted);
        let forces = springs.map(|m| {
            let mut out = vec![Row::ZERO; m.part.nodes().len()];
            m.part.stiffness_times(&u, &mut out, &mut Scratch::default());
            out.iter().map(|row| row.0[0]).sum::<f64>()
        });
        forces.sum::<f64>() / shear
    };
    let base = 48.0 * 0.67 / 20.0;
    assert!((along_x(false) - base).abs() < 1e-12 * base);
    let whole = base + 2.0 * 24.0 * 1.33 / 4.0 + 2.0 * 32.0 * 0.67 / 3.0;
    assert!((along_x(true) - whole).abs() < 1e-12 * whole, "{} {whole}", along_x(true));
}

fn is_column(ready: &Ready, node: u32) -> bool {
    ready.model.nodes.domain[node as usize] == tremolite_engine::Domain::Column
}

/// From the centre of what is excavated down to the base, wherever the model lies; of all where nothing is.
#[test]
fn springs_reach_from_what_is_excavated_down_to_the_base() {
    for (void, distance) in [(&[13, 22][..], 2.0), (&[], 3.0)] {
        let mesh = BoxSpec::uniform([10.0, 0.0, 400.0], [13.0, 3.0, 406.0], [3, 3, 6]).mesh().unwrap();
        let elements = (0..mesh.elements.len() as u32).filter(|e| !void.contains(e)).collect();
        let mut problem = Problem::new(mesh, vec![body("rock", elements)]);
        problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: None };
        let found = Ready::new(problem).assembly.spring_distance.unwrap();
        assert!((found - distance).abs() < 1e-9, "{void:?}: {found}");
    }
}

/// Rest, of which boundaries do not know that it is.
struct Given;

impl GivenField for Given {
    fn displacement(&self, _: [f64; 3], _: f64) -> [f64; 3] {
        [0.0; 3]
    }

    fn stress(&self, _: [f64; 3], _: f64) -> [f64; 6] {
        [0.0; 6]
    }

    fn peak_velocity(&self) -> f64 {
        0.0
    }
}

/// Of a base that is longest along x a part has the nodes that come first along x and, of those with the same x, along y: their faces have
/// few points that another part has to ask for as well. The mesh is turned by half a turn, so that its own order is another.
#[test]
fn parts_of_a_given_field_have_nodes_that_lie_together() {
    let mut mesh = BoxSpec::uniform([0.0; 3], [24.0, 23.0, 1.0], [24, 23, 1]).mesh().unwrap();
    mesh.nodes.iter_mut().for_each(|x| (x[0], x[1]) = (-x[0], -x[1]));
    let mut problem = whole(mesh);
    problem.base = Base::Viscous;
    problem.free_field = Some(Arc::new(Given));
    let ready = Ready::new(problem);
    let places = |nodes: &[u32]| {
        let mut places: Vec<[i64; 2]> =
            nodes.iter().map(|&n| [0, 1].map(|i| ready.place(n)[i].round() as i64)).collect();
        places.sort_unstable();
        places
    };
    let parts: Vec<_> = ready
        .assembly
        .members
        .iter()
        .filter(|member| member.kind == Kind::Boundary)
        .map(|member| places(member.part.nodes()))
        .collect();
    let all = places(&parts_nodes(&ready));
    assert_eq!((all.len(), parts.len()), (25 * 24, 3));
    assert!(parts.iter().any(|part| part[..] == all[..256]), "a part with the first");
}

fn parts_nodes(ready: &Ready) -> Vec<u32> {
    let own = ready.assembly.members.iter().filter(|member| member.kind == Kind::Boundary);
    own.flat_map(|member| member.part.nodes()).copied().collect()
}
