//! Free-field sides: a model of level ground moves as its columns do, whatever its ground does.

use crate::block::pulse;
use crate::ready::Ready;
use std::sync::Arc;
use tremolite::Domain;
use tremolite::extent::size_tensor;
use tremolite::hexahedra::hex;
use tremolite::model::Patch;
use tremolite::{
    AnyMaterial, Base, Body, Incident, Law, Life, Model, Problem, Quadrature, Rayleigh, Side, Stage, elastic,
    laws,
};
use tremolite_laws::band::Band;
use tremolite_laws::{BadParameter, Column, Lane, Material, Moduli, Parameter, Point, Values};
use tremolite_mesh::Mesh;
use tremolite_mesh::boxes::BoxSpec;

/// Level ground of three layers, graded in plan and in height, under a pulse along x, y and z, with free-field sides.
fn ground(material: impl Fn(usize) -> Arc<dyn AnyMaterial>, quadrature: Quadrature) -> Problem {
    let mesh = graded();
    let layer = |e: u32| {
        let z = tremolite::hexahedra::centroid(&mesh, e)[2];
        usize::from(z > 5.0) + usize::from(z > 9.0)
    };
    let body = |k: usize| Body {
        name: format!("layer {k}"),
        elements: (0..mesh.elements.len() as u32).filter(|&e| layer(e) == k).collect(),
        material: material(k),
        density: [2700.0, 2400.0, 2000.0][k],
        quadrature,
        viscosity: 0.0,
    };
    let bodies = (0..3).map(body).collect();
    let mut problem = Problem::new(mesh.clone(), bodies);
    problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(10.0) };
    problem.sides = [Side::FreeField; 2];
    problem.incident = Some(Incident { motion: pulse(), factor: 0.5 });
    problem
}

fn graded() -> Mesh {
    let lines = |length: f64, n: u32, power: f64| -> Vec<f64> {
        (0..=n).map(|i| length * (f64::from(i) / f64::from(n)).powf(power)).collect()
    };
    let mut mesh = BoxSpec::uniform([0.0; 3], [12.0, 10.0, 14.0], [5, 4, 14]).mesh().unwrap();
    let (x, y) = (lines(12.0, 5, 1.2), lines(10.0, 4, 0.85));
    for node in &mut mesh.nodes {
        node[0] = x[(node[0] / 2.4).round() as usize];
        node[1] = y[(node[1] / 2.5).round() as usize];
        node[2] += 0.2 * (node[2] * std::f64::consts::PI / 14.0).sin();
    }
    mesh
}

fn moduli(layer: usize) -> Moduli {
    Moduli::from_young_poisson([2e9, 1e9, 0.4e9][layer], [0.25, 0.3, 0.2][layer])
}

/// Largest difference of any node's velocity from that of its level in the columns, over the peak.
fn against_columns(problem: Problem, steps: u64) -> f64 {
    let ready = Ready::new(problem);
    let model = &ready.model;
    let node = |n: u32| model.mesh.nodes[n as usize];
    let levels: Vec<(usize, usize)> = model
        .nodes
        .of(Domain::Model)
        .map(|n| {
            let z = node(model.mesh_node[n])[2];
            let beside = model
                .nodes
                .of(Domain::Column)
                .find(|&c| (node(model.mesh_node[c])[2] - z).abs() < 1e-9)
                .unwrap();
            (n, beside)
        })
        .collect();
    let mut engine = ready.engine();
    let mut state = ready.rest(0.9);
    let (mut peak, mut worst) = (0.0_f64, 0.0_f64);
    for _ in 0..steps {
        engine.step(&mut state);
        for &(n, c) in &levels {
            for i in 0..3 {
                peak = peak.max(state.du[n].0[i].abs());
                worst = worst.max((state.du[n].0[i] - state.du[c].0[i]).abs());
            }
        }
    }
    worst / peak
}

#[test]
fn level_ground_moves_as_its_columns() {
    let rock = |k: usize| elastic(moduli(k));
    let yielding = |k: usize| {
        let values = Values::default()
            .with("young", moduli(k).young())
            .with("poisson", moduli(k).poisson())
            .with("cohesion", [1e5, 2e4, 1e4][k])
            .with("friction_angle", 0.5)
            .with("tensile_strength", 1e4);
        let law = laws().into_iter().find(|law| law.info.name == "mohr-coulomb").unwrap();
        (law.build)(&values).unwrap()
    };
    let banded = |k: usize| {
        let values = Values::default().with("young", moduli(k).young()).with("poisson", moduli(k).poisson());
        let law = laws().into_iter().find(|law| law.info.name == "elastic").unwrap();
        (law.build_banded)(&values, Band::fit(0.04, [1.0, 40.0], 12.0).unwrap()).unwrap()
    };
    let steps = 500;
    for quadrature in [Quadrature::OnePoint, Quadrature::Full] {
        let elastic = against_columns(ground(rock, quadrature), steps);
        let plastic = against_columns(ground(yielding, quadrature), steps);
        let band = against_columns(ground(banded, quadrature), steps);
        let mut damped = ground(rock, quadrature);
        damped.rayleigh = Rayleigh { mass: 2.0, stiffness: 1e-4 };
        let rayleigh = against_columns(damped, steps);
        eprintln!("{quadrature:?} {elastic:e} {plastic:e} {band:e} {rayleigh:e}");
        for found in [elastic, plastic, band, rayleigh] {
            assert!(found < 1e-10, "{quadrature:?}: {elastic:e} {plastic:e} {band:e} {rayleigh:e}");
        }
    }
}

/// Without caverns a block of rock moves everywhere as theory, at its edges as in its middle, however wide it is: at the surface as
/// twice the wave that came in, a travel time later.
#[test]
fn homogeneous_blocks_of_any_width_move_as_theory_in_their_middle_and_at_their_edges() {
    let (height, speed, density) = (48.0, 800.0, 2500.0);
    for heights in [1, 2, 4] {
        let width = height * f64::from(heights);
        let mesh = BoxSpec::uniform([0.0; 3], [width, 16.0, height], [6 * heights, 2, 32]).mesh().unwrap();
        let young = 2.5 * density * speed * speed;
        let body = Body {
            name: "rock".into(),
            elements: (0..mesh.elements.len() as u32).collect(),
            material: elastic(Moduli::from_young_poisson(young, 0.25)),
            density,
            quadrature: Quadrature::OnePoint,
            viscosity: 0.0,
        };
        let mut problem = Problem::new(mesh, vec![body]);
        problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(20.0) };
        problem.sides = [Side::FreeField; 2];
        let pulse = tremolite_motion::ricker_velocity(8.0, 0.15, 1.0);
        let motion =
            tremolite_motion::Motion::sampled(1e-3, 0.4, |t| pulse(t).along([1.0, 0.0, 0.0])).unwrap();
        problem.incident = Some(Incident { motion, factor: 1.0 });
        let ready = Ready::new(problem);
        let model = &ready.model;
        let at = |x: f64, y: f64| {
            let here = |n: &usize| {
                let p = model.mesh.nodes[model.mesh_node[*n] as usize];
                (p[0] - x).abs() + (p[1] - y).abs() + (p[2] - height).abs() < 1e-6
            };
            model.nodes.of(Domain::Model).find(here).unwrap()
        };
        let places = [at(0.5 * width, 8.0), at(0.0, 8.0), at(width, 0.0)];
        let (mut engine, mut state) = (ready.engine(), ready.rest(0.5));
        let mut worst = [0.0_f64; 3];
        while state.time() < 0.38 {
            engine.step(&mut state);
            // The increment's velocity is that of the middle of the step.
            let exact = 2.0 * pulse(state.time() - 0.5 * state.dt - height / speed).v;
            for (worst, &n) in worst.iter_mut().zip(&places) {
                let [vx, vy, vz] = state.du[n].xyz().map(|d| d / state.dt);
                *worst = worst.max((vx - exact).abs()).max(vy.abs()).max(vz.abs());
            }
        }
        // 25 elements a wave of the peak frequency's double; half the elements leave four times as much.
        assert!(worst.iter().all(|worst| worst / 2.0 < 5e-3), "{heights} heights wide: {worst:?}");
    }
}

/// Ground that is excavated, or missing, along a vertical edge is no column; openings elsewhere on a side are in its slab.
#[test]
fn an_opening_at_a_vertical_edge_is_refused_and_one_in_a_side_is_not() {
    let with_opening = |low: [f64; 2], high: [f64; 2], life: Option<Life>| {
        let mesh = BoxSpec::uniform([0.0; 3], [12.0, 8.0, 8.0], [6, 4, 4]).mesh().unwrap();
        let inside = |e: &u32| {
            let x = tremolite::hexahedra::centroid(&mesh, *e);
            (0..2).all(|i| x[i] > low[i] && x[i] < high[i]) && x[2] > 2.5 && x[2] < 5.5
        };
        let (open, rock): (Vec<u32>, Vec<u32>) = (0..mesh.elements.len() as u32).partition(inside);
        let body = |name: &str, elements| Body {
            name: name.into(),
            elements,
            material: elastic(moduli(0)),
            density: 2500.0,
            quadrature: Quadrature::OnePoint,
            viscosity: 0.0,
        };
        let mut problem = Problem::new(mesh, vec![body("rock", rock)]);
        if let Some(life) = life {
            problem.lives = vec![Life::ALWAYS; problem.mesh.elements.len()];
            open.iter().for_each(|&e| problem.lives[e as usize] = life);
            problem.bodies.push(body("bench", open));
        }
        problem.sides = [Side::FreeField; 2];
        Model::new(problem)
    };
    let excavated = Life { born: Stage::Before(0), gone: Some(Stage::Before(1)) };
    for (life, word) in [(None, "has a gap"), (Some(excavated), "is excavated")] {
        let refused = with_opening([0.0, 0.0], [4.0, 4.0], life).err().unwrap().to_string();
        for word in [word, "where xmin and ymin meet", "keep away from the edge"] {
            assert!(refused.contains(word), "{refused}");
        }
        let model = with_opening([4.0, 0.0], [8.0, 4.0], life).unwrap();
        assert_eq!((model.outside.slabs.len(), model.outside.columns.len()), (4, 8));
        let of_slab = &model.outside.slabs[2].sheet;
        assert_eq!((of_slab.axis, of_slab.end, of_slab.thickness), (1, 0, 2.0));
        assert_eq!(of_slab.twins.len(), if life.is_some() { 24 } else { 20 });
    }
}

/// A slab that an opening cuts in two has an upper part that nothing leads; only columns at its ends would.
#[test]
fn a_slab_that_an_opening_cuts_in_two_is_refused_where_it_has_no_columns() {
    let model = |sides: [Side; 2], across: bool| {
        let mesh = BoxSpec::uniform([0.0; 3], [12.0, 8.0, 8.0], [6, 4, 4]).mesh().unwrap();
        let rock = (0..mesh.elements.len() as u32).filter(|&e| {
            let [x, y, z] = tremolite::hexahedra::centroid(&mesh, e);
            !(x < 4.0 && z > 4.0 && z < 6.0 && (across || (y > 2.0 && y < 6.0)))
        });
        let body = Body {
            name: "rock".into(),
            elements: rock.collect(),
            material: elastic(moduli(0)),
            density: 2500.0,
            quadrature: Quadrature::OnePoint,
            viscosity: 0.0,
        };
        let mut problem = Problem::new(mesh, vec![body]);
        problem.sides = sides;
        Model::new(problem)
    };
    let refused = model([Side::FreeField, Side::Periodic], true).err().unwrap().to_string();
    assert!(refused.contains("outside xmin is cut in two"), "{refused}");
    assert!(model([Side::FreeField, Side::Periodic], false).is_ok());
    assert!(model([Side::FreeField; 2], false).is_ok());
    let refused = model([Side::FreeField; 2], true).err().unwrap().to_string();
    assert!(refused.contains("has a gap"), "{refused}");
}

/// A law whose stress is the size tensor that it is shown.
struct ShowsSize;

impl Material for ShowsSize {
    const NAME: &'static str = "shows-size";
    const SUMMARY: &'static str = "a test's own";
    const SOURCE: &'static str = "";
    const PARAMETERS: &'static [Parameter] = &[];
    const HISTORY: &'static [Column] = &[];
    const NEEDS_SIZE: bool = true;
    type History<L: Lane> = [L; 0];

    fn new(_: &Values) -> Result<Self, Vec<BadParameter>> {
        Ok(ShowsSize)
    }

    fn moduli(&self) -> Moduli {
        Moduli::from_young_poisson(1e9, 0.2)
    }

    fn scaled(&self, _: f64) -> Self {
        ShowsSize
    }

    fn update<L: Lane>(&self, point: &Point<L>, _: [L; 6], _: [L; 0]) -> ([L; 6], [L; 0]) {
        (point.size, [])
    }
}

/// A slab has one thickness, the elements behind its side have several: cracks in it extend as in its parents.
#[test]
fn elements_outside_a_side_show_laws_the_size_of_their_parents() {
    let mut mesh = BoxSpec::uniform([0.0; 3], [12.0, 8.0, 4.0], [6, 4, 2]).mesh().unwrap();
    for node in mesh.nodes.iter_mut().filter(|node| node[1] == 2.0) {
        node[1] += 0.1 * node[0];
    }
    for quadrature in [Quadrature::OnePoint, Quadrature::Full] {
        let body = Body {
            name: "rock".into(),
            elements: (0..mesh.elements.len() as u32).collect(),
            material: (Law::of::<ShowsSize>().build)(&Values::default()).unwrap(),
            density: 2500.0,
            quadrature,
            viscosity: 0.0,
        };
        let mut problem = Problem::new(mesh.clone(), vec![body]);
        problem.sides = [Side::Free, Side::FreeField];
        let ready = Ready::new(problem);
        let stress = ready.engine().look(&ready.rest(0.5)).snapshot.stress;
        let size = |e: u32| size_tensor(&hex(&ready.model.mesh, e as usize).unwrap());
        let mut differ = 0;
        let outside = |(_, patch): &(usize, &Patch)| patch.domain != Domain::Model;
        for (p, patch) in ready.model.patches.iter().enumerate().filter(outside) {
            let p = ready.assembly.of_patch[p] as usize;
            let points = ready.assembly.members[p].part.elements().1;
            for (i, &e) in patch.elements.iter().enumerate() {
                let parent = size(ready.model.elements.parents[e as usize]);
                differ += usize::from((size(e)[1] - parent[1]).abs() > 0.01);
                let first = ready.assembly.slices[p].points.start + i * points;
                for shown in &stress[first..first + points] {
                    assert!(
                        shown.iter().zip(parent).all(|(a, b)| (a - b).abs() < 1e-12),
                        "{shown:?} {parent:?}"
                    );
                }
            }
        }
        assert!(differ > 5, "the slab must be of another thickness than its parents");
    }
}
