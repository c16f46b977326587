//! Linings one element thick: which axis is the thickness, equal bits, what they share with 2×2×2 points.

use crate::ready::Ready;
use std::sync::atomic::AtomicBool;
use tremolite::hexahedra::hex;
use tremolite::observers::Fibres;
use tremolite::parts::loads::Load;
use tremolite::plan::Plan;
use tremolite::run::{Control, run};
use tremolite::simulation::{Built, Simulation, Start};
use tremolite::{
    AnyMaterial, Base, Body, Layers, Line, Model, ModelError, Problem, Quadrature, Rayleigh, Side, elastic,
    laws,
};
use tremolite_laws::band::Band;
use tremolite_laws::shapes::hex8::turned;
use tremolite_laws::{Isa, Moduli, Row, Value, Values};
use tremolite_mesh::boxes::{Axis, BoxSpec};
use tremolite_mesh::{Element, Mesh, Shape};
use tremolite_results::ResultFolder;

const LAYERED: Quadrature = Quadrature::Layered(Layers::Nine);

fn body(elements: Vec<u32>, material: std::sync::Arc<dyn AnyMaterial>, quadrature: Quadrature) -> Body {
    Body { name: "lining".into(), elements, material, density: 2500.0, quadrature, viscosity: 0.0 }
}

fn rock() -> std::sync::Arc<dyn AnyMaterial> {
    elastic(Moduli::from_young_poisson(25e9, 0.17))
}

fn concrete(band: bool) -> std::sync::Arc<dyn AnyMaterial> {
    let mut values = Values::default();
    for (key, value) in [
        ("young", 25e9),
        ("poisson", 0.17),
        ("tensile_strength", 1.2e6),
        ("cohesion", 2e6),
        ("friction_angle", 0.8),
        ("fracture_energy", 130.0),
    ] {
        values = values.with(key, value);
    }
    for (key, word) in [("evolution", "exponential"), ("split", "effective")] {
        values.0.insert(key.into(), Value::Word(word.into()));
    }
    let law = laws().into_iter().find(|law| law.info.name == "concrete-damage").unwrap();
    match band {
        true => (law.build_banded)(&values, Band::fit(0.05, [2.0, 100.0], 20.0).unwrap()).unwrap(),
        false => (law.build)(&values).unwrap(),
    }
}

/// A plate of so many elements, leaning over so that its elements are parallelepipeds. `twist` numbers each element from one of
/// its axes in turn, as files of any origin may.
fn plate(elements: [u32; 3], sides: [f64; 3], twist: bool) -> Mesh {
    let mut mesh = BoxSpec::uniform([0.0; 3], sides, elements).mesh().unwrap();
    for x in &mut mesh.nodes {
        *x = [x[0] + 0.2 * x[2], x[1] - 0.1 * x[2] + 0.05 * x[0], x[2]];
    }
    if twist {
        for (e, element) in mesh.elements.iter_mut().enumerate() {
            let nodes = element.nodes;
            *element = Element::new(Shape::Hex8, &turned(e % 3).map(|k| nodes[k]));
        }
    }
    mesh
}

fn free(mesh: Mesh, bodies: Vec<Body>) -> Problem {
    let mut problem = Problem::new(mesh, bodies);
    problem.base = Base::Free;
    problem.sides = [Side::Free; 2];
    problem
}

/// Struck at random, with the velocity growing towards one end: displacements, and lines of the balance.
fn struck(problem: Problem, steps: usize) -> (Vec<Row>, Vec<(Line, f64)>, f64) {
    let ready = Ready::new(problem);
    let mut state = ready.rest(0.8);
    state.dt = 2e-5;
    assert!(state.dt < ready.stable(), "{}", ready.stable());
    let velocity = |node: u32| {
        let [x, y, z] = ready.model.mesh.nodes[node as usize];
        Row::new([0.1 * z, 0.02 * x * y, 0.08 * x * x - 0.03 * y])
    };
    let velocities: Vec<Row> = ready.model.mesh_node.iter().map(|&n| velocity(n)).collect();
    let mut engine = ready.engine();
    let rest = state.u.clone();
    engine.start(&mut state, rest, &velocities);
    for _ in 0..steps {
        engine.step(&mut state);
    }
    let snapshot = engine.look(&state).snapshot;
    let mut u = vec![Row::ZERO; ready.model.mesh.nodes.len()];
    for (row, &node) in state.u.iter().zip(&ready.model.mesh_node) {
        u[node as usize] = *row;
    }
    let lines = snapshot.balance.iter().collect();
    (u, lines, ready.stable())
}

fn size(u: &[Row]) -> f64 {
    u.iter().flat_map(|row| row.0).fold(0.0, |most: f64, x| most.max(x.abs()))
}

/// Whatever the numbering of its elements, and with damping over a band: an elastic plate of parallelepipeds is that of 2×2×2
/// points, its stable step included.
#[test]
fn a_leaning_elastic_plate_moves_as_one_of_2x2x2_points() {
    let values = Values::default().with("young", 25e9).with("poisson", 0.17);
    let law = laws().into_iter().find(|law| law.info.name == "elastic").unwrap();
    let banded = || (law.build_banded)(&values, Band::fit(0.05, [2.0, 100.0], 20.0).unwrap()).unwrap();
    for material in [rock(), banded()] {
        for twist in [false, true] {
            let run = |quadrature| {
                let mesh = plate([6, 4, 1], [4.0, 2.4, 0.3], twist);
                let mut lining = body((0..24).collect(), material.clone(), quadrature);
                lining.viscosity = 0.06;
                struck(free(mesh, vec![lining]), 400)
            };
            let (full, full_lines, full_step) = run(Quadrature::Full);
            for layers in Layers::ALL {
                let (found, lines, step) = run(Quadrature::Layered(layers));
                let differ =
                    full.iter().zip(&found).flat_map(|(a, b)| [0, 1, 2].map(|i| (a.0[i] - b.0[i]).abs()));
                let differ = differ.fold(0.0, f64::max) / size(&full);
                assert!(differ < 1e-12, "{layers:?}, twisted {twist}: {differ:e}");
                assert!((step / full_step - 1.0).abs() < 1e-6, "{step} {full_step}");
                let most = full_lines.iter().fold(0.0, |most: f64, (_, x)| most.max(x.abs()));
                for ((line, a), (_, b)) in full_lines.iter().zip(&lines) {
                    assert!((a - b).abs() < 1e-12 * most, "{}: {a} and {b}", line.name());
                }
            }
        }
    }
}

/// Cracking, damped by the stiffness or over a band, with viscosity: the bits of a run do not depend on the instruction set, nor
/// on the threads.
#[test]
fn bits_of_a_cracking_plate_depend_on_neither_instruction_set_nor_threads() {
    for band in [false, true] {
        let run = |isa, threads| {
            let mut lining = body((0..60).collect(), concrete(band), LAYERED);
            lining.viscosity = 0.06;
            let mut problem = free(plate([10, 6, 1], [5.0, 3.0, 0.3], true), vec![lining]);
            problem.isa = isa;
            problem.patch_elements = Some(8);
            problem.rayleigh = Rayleigh { mass: 0.5, stiffness: if band { 0.0 } else { 1e-6 } };
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| struck(problem, 150))
        };
        let (reference, lines, _) = run(Isa::Scalar, 1);
        let dissipated = lines.iter().find(|(line, _)| *line == Line::Dissipated).unwrap().1;
        assert!(dissipated > 0.0, "the plate cracks");
        let error = lines.iter().find(|(line, _)| *line == Line::Error).unwrap().1;
        assert!(
            error.abs() < 0.02 * lines[0].1.abs().max(dissipated),
            "the balance closes: {error} {lines:?}"
        );
        for isa in Isa::ALL.into_iter().filter(|isa| isa.available()) {
            for threads in [1, 3] {
                let (other, others, _) = run(isa, threads);
                assert!(other == reference && others == lines, "{} {threads}", isa.name());
            }
        }
    }
}

fn thickness_of(mesh: Mesh, elements: Vec<u32>) -> Result<Vec<u8>, ModelError> {
    Ok(Model::new(free(mesh, vec![body(elements, rock(), LAYERED)]))?.elements.thickness.clone())
}

#[test]
fn the_thickness_is_the_shortest_way_through_whatever_the_elements_lengths() {
    // Each element of the plate is numbered from another axis.
    let mesh = plate([5, 4, 1], [4.0, 2.4, 0.3], true);
    let found = thickness_of(mesh.clone(), (0..20).collect()).unwrap();
    for (e, axis) in found.iter().enumerate() {
        let lengths = hex(&mesh, e).unwrap().half_lengths;
        assert!(lengths[*axis as usize] < 0.2, "element {e}: {lengths:?}, {axis}");
    }
    // Elements that are shorter along the lining than through it.
    let along = vec![0.0, 1.0, 2.0, 2.1, 2.3, 3.6];
    let spec =
        BoxSpec { x: Axis::Coordinates(along), ..BoxSpec::uniform([0.0; 3], [1.0, 3.0, 0.3], [1, 3, 1]) };
    let found = thickness_of(spec.mesh().unwrap(), (0..15).collect()).unwrap();
    assert!(found.iter().all(|axis| *axis == 2), "{found:?}");
}

#[test]
fn what_has_no_thickness_is_refused_by_element() {
    let refused = |mesh: Mesh, elements| thickness_of(mesh, elements).unwrap_err().to_string();
    let cubes = BoxSpec::uniform([0.0; 3], [2.0, 2.0, 2.0], [2, 2, 2]).mesh().unwrap();
    let text = refused(cubes, (0..8).collect());
    assert!(text.contains("element 1 of 'lining'") && text.contains("equally"), "{text}");
    assert!(text.contains("full"), "{text}");
    let spec = BoxSpec::uniform([0.0; 3], [2.0, 2.0, 0.5], [2, 2, 1]);
    let mut mesh = spec.mesh().unwrap();
    let nodes = mesh.elements[3].nodes;
    mesh.elements[3] = Element::new(Shape::Pyramid5, &nodes[..5]);
    let text = refused(mesh, vec![3]);
    assert!(text.contains("element 4") && text.contains("pyramid"), "{text}");
}

/// Where a wall stands on a slab no way is a thickness; the elements there have that of a neighbour, and all others their own.
#[test]
fn walls_and_slabs_that_meet_have_their_own_thickness() {
    let edges = vec![0.0, 0.3, 1.3, 2.3];
    let spec = BoxSpec {
        x: Axis::Coordinates(edges.clone()),
        z: Axis::Coordinates(edges),
        ..BoxSpec::uniform([0.0; 3], [1.0, 2.0, 1.0], [1, 2, 1])
    };
    let mut mesh = spec.mesh().unwrap();
    let at = |e: u32| tremolite::hexahedra::centroid(&mesh, e);
    let elements: Vec<u32> =
        (0..mesh.elements.len() as u32).filter(|&e| at(e)[0] < 0.3 || at(e)[2] < 0.3).collect();
    let at: Vec<[f64; 3]> = (0..mesh.elements.len() as u32).map(at).collect();
    mesh.groups.insert("lining".into(), elements.clone());
    let found = thickness_of(mesh, elements.clone()).unwrap();
    for e in elements {
        let [x, _, z] = at[e as usize];
        let axis = found[e as usize];
        match (x < 0.3, z < 0.3) {
            (true, true) => assert!(axis != 1, "the corner has that of the wall or of the slab"),
            (wall, _) => assert_eq!(axis, if wall { 0 } else { 2 }, "{x} {z}"),
        }
    }
}

/// The rock tells where the thickness is of a piece that is as short as it is thick.
#[test]
fn an_interface_tells_the_thickness_of_what_is_nearly_a_cube() {
    let spec = BoxSpec {
        z: Axis::Coordinates(vec![0.0, 1.0, 1.5]),
        ..BoxSpec::uniform([0.0; 3], [0.6, 0.6, 1.0], [1, 1, 1])
    };
    let mesh = spec.mesh().unwrap();
    let high = |e: &u32| tremolite::hexahedra::centroid(&mesh, *e)[2] > 1.0;
    let (lining, ground): (Vec<u32>, Vec<u32>) = (0..2).partition(high);
    let problem = || {
        let bodies = vec![
            body(lining.clone(), rock(), LAYERED),
            Body { name: "rock".into(), ..body(ground.clone(), rock(), Quadrature::OnePoint) },
        ];
        Problem::new(mesh.clone(), bodies)
    };
    assert!(matches!(Model::new(problem()), Err(ModelError::Thickness { .. })));
    let mut parted = problem();
    let law = tremolite::interface_laws().into_iter().find(|law| law.info.name == "coulomb").unwrap();
    let values = Values::default().with("normal_stiffness", 20e9).with("friction_coefficient", 0.7);
    parted.interfaces =
        vec![tremolite::Interface::new("lining-rock", [lining.clone(), ground.clone()], law, values)];
    let model = Model::new(parted).unwrap();
    assert!(lining.iter().all(|&e| model.elements.thickness[e as usize] == 2));
    // Outside a side they have the axis of what they were made of.
    let mut beside = problem();
    beside.interfaces = vec![tremolite::Interface::new(
        "lining-rock",
        [lining.clone(), ground.clone()],
        tremolite::interface_laws().into_iter().find(|law| law.info.name == "coulomb").unwrap(),
        Values::default().with("normal_stiffness", 20e9).with("friction_coefficient", 0.7),
    )];
    beside.sides = [Side::FreeField, Side::Free];
    let model = Model::new(beside).unwrap();
    let outside = (model.user.elements..model.mesh.elements.len())
        .filter(|&e| lining.contains(&model.elements.parents[e]))
        .collect::<Vec<_>>();
    assert!(!outside.is_empty());
    for e in outside {
        let direction = hex(&model.mesh, e).unwrap().directions[model.elements.thickness[e] as usize];
        assert!(direction[2].abs() > 0.999, "element {e}: {direction:?}");
    }
}

/// A cantilever of 4 m, half a metre thick, bent by a load on its end until its root cracks: the largest use of the tensile strength
/// at a fibre of intact elements.
fn most_used(quadrature: Quadrature) -> f64 {
    let mesh = BoxSpec::uniform([0.0; 3], [4.0, 1.0, 0.5], [8, 2, 1]).mesh().unwrap();
    let lining = body((0..16).collect(), concrete(false), quadrature);
    let at = |x: f64| {
        let nodes = (0u32..).zip(&mesh.nodes).filter(move |(_, node)| (node[0] - x).abs() < 1e-9);
        nodes.map(|(n, _)| n).collect::<Vec<u32>>()
    };
    let (held, end) = (at(0.0), at(4.0));
    // Three and a half times the moment of the first crack at the root: Gauss points bear 1/√3 of the fibre's stress.
    let force = 3.5 * 1.2e6 * 0.5 * 0.5 / 6.0 / 4.0 / end.len() as f64;
    let forces = end.into_iter().map(|n| (n, [0.0, 0.0, -force])).collect();
    let mut problem = free(mesh, vec![lining]);
    problem.held = held.into_iter().map(|n| (n, [true; 3])).collect();
    problem.loads = vec![Load { forces, factor: std::sync::Arc::new(|t: f64| (t / 0.3).min(1.0)) }];
    problem.rayleigh = Rayleigh { mass: 50.0, stiffness: 0.0 };
    let ready = Ready::new(problem);
    let plan = Plan {
        page: tremolite_results::PageWish::default(),
        boundaries: Default::default(),
        target: None,
        title: "cantilever".into(),
        stages: Vec::new(),
        duration: 0.2,
        recorded: None,
        waves: None,
        histories: 5e-4,
        snapshots: None,
        fields: Vec::new(),
        field_elements: 250_000,
        checkpoint: None,
        monitors: Vec::new(),
        pairs: Vec::new(),
        bolts: Vec::new(),
        bars: 0,
        water: false,
        relatives: Vec::new(),
        sections: Vec::new(),
    };
    let folder = tempfile::tempdir().unwrap();
    let results = ResultFolder::create(Some(folder.path()), "cantilever", true).unwrap();
    let mut control = Control { stop: &AtomicBool::new(false), progress: &mut |_| {} };
    let outcome = Simulation::new(
        &Built::of(&ready.model, &ready.assembly, &ready.phase),
        &plan,
        &results,
        Start::Rest,
        Vec::new(),
    )
    .and_then(|simulation| run(simulation, &mut control))
    .unwrap();
    let history = outcome.history(&ready.assembly);
    let slots = ready.phase.element_slot.iter().flatten();
    assert!(slots.clone().any(|slot| history.is_damaged(slot)), "{quadrature:?}: it cracks");
    outcome.state.observers[Fibres::MEMORY][0]
}

/// By √3 in pure bending, less what a row of histories and the moment's gradient along the element leave; and at most 1 where
/// points lie at the faces.
#[test]
fn fibres_of_intact_elements_go_beyond_the_strength_at_gauss_points_alone() {
    let [full, layered] = [Quadrature::Full, LAYERED].map(most_used);
    assert!(full > 1.6 && full < 1.75, "{full}");
    assert!(layered > 0.9 && layered < 1.0 + 1e-9, "{layered}");
}
