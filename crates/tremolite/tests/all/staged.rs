//! Whole models through stages: initial stress, excavation, a lining, and the hand-over to the shaking.

use crate::contact::between;
use std::sync::Arc;
use tremolite::engine::Release;
use tremolite::stages::{PlannedStage, settle};
use tremolite::{
    Assembly, Base, Body, Engine, Life, Model, Phase, Problem, Quadrature, Side, Stage, State, elastic,
    stable_step,
};
use tremolite_kernels::Line;
use tremolite_laws::Moduli;
use tremolite_mesh::boxes::BoxSpec;

const DENSITY: f64 = 2700.0;
const GRAVITY: f64 = 9.81;
const DEPTH: f64 = 12.0;

const BANDIS: &[(&str, f64)] = &[
    ("normal_stiffness", 20e9),
    ("max_closure", 2e-3),
    ("cohesion", 0.5e6),
    ("friction_coefficient", 0.7),
    ("pressure_for_step", 10e6),
];

/// The stage from which on the opening is there, and that of the lining.
pub const OPENED: Stage = Stage::Before(1);
pub const LINED: Stage = Stage::Before(2);

fn close() -> PlannedStage {
    let release = Release { tolerance: [1e-9, 1e-6], ..Release::default() };
    PlannedStage { release, ..PlannedStage::new("stage") }
}

fn body(name: &str, elements: Vec<u32>, young: f64, nu: f64, quadrature: Quadrature) -> Body {
    Body {
        name: name.into(),
        elements,
        material: elastic(Moduli::from_young_poisson(young, nu)),
        density: DENSITY,
        quadrature,
        viscosity: 0.0,
    }
}

/// A block of 12 × 4 × 12 m, with an opening of 4 × 4 m along y in its middle whose outer ring of elements becomes a lining.
/// Under its weight with K₀ = 0.5; `parted` puts an interface around the lining.
pub fn lined(parted: bool) -> Problem {
    let mut mesh = BoxSpec::uniform([0.0; 3], [12.0, 4.0, DEPTH], [12, 2, 12]).mesh().unwrap();
    let far = |e: u32| {
        let [x, _, z] = tremolite::hexahedra::centroid(&mesh, e);
        (x - 6.0).abs().max((z - 6.0).abs())
    };
    let all = || 0..mesh.elements.len() as u32;
    let core: Vec<u32> = all().filter(|&e| far(e) < 1.0).collect();
    let ring: Vec<u32> = all().filter(|&e| (1.0..2.0).contains(&far(e))).collect();
    let mut rock: Vec<u32> = all().filter(|&e| far(e) > 2.0).collect();
    let mut lives = vec![Life::ALWAYS; mesh.elements.len()];
    core.iter().for_each(|&e| lives[e as usize] = Life { born: Stage::Before(0), gone: Some(OPENED) });
    ring.iter().for_each(|&e| lives[e as usize] = Life { born: LINED, gone: None });
    let mut stand_ins = Vec::new();
    for &e in &ring {
        let twin = mesh.elements.len() as u32;
        mesh.elements.push(mesh.elements[e as usize]);
        lives.push(Life { born: Stage::Before(0), gone: Some(OPENED) });
        stand_ins.push((twin, e));
        rock.push(twin);
    }
    rock.extend(&core);
    let initial = (0..mesh.elements.len() as u32)
        .map(|e| {
            let depth = DEPTH - tremolite::hexahedra::centroid(&mesh, e)[2];
            let s = -DENSITY * GRAVITY * depth;
            [0.5 * s, 0.5 * s, s, 0.0, 0.0, 0.0]
        })
        .collect();
    let bodies = vec![
        body("rock", rock, 1e9, 0.25, Quadrature::OnePoint),
        body("lining", ring.clone(), 25e9, 0.17, Quadrature::Full),
    ];
    let mut problem = Problem::new(mesh, bodies);
    problem.lives = lives;
    problem.stand_ins = stand_ins;
    problem.initial = initial;
    problem.gravity = GRAVITY;
    problem.sides = [Side::Roller; 2];
    problem.base = Base::Viscous;
    if parted {
        problem.interfaces = vec![between(&problem, [1, 0], "bandis", BANDIS)];
    }
    problem
}

struct Built {
    model: Arc<Model>,
    assembly: Arc<Assembly>,
}

fn built(problem: Problem) -> Built {
    let model = Model::new(problem).unwrap();
    let assembly = Assembly::new(&model).unwrap();
    Built { model, assembly }
}

impl Built {
    fn settled(&self, stages: usize) -> State {
        settle(&self.model, &self.assembly, &vec![close(); stages]).unwrap().0
    }

    /// Displacement \[m\] since the initial equilibrium of the node at a place.
    fn at(&self, state: &State, place: [f64; 3]) -> [f64; 3] {
        let mesh = &self.model.mesh;
        let node =
            (0..self.model.user.nodes).find(|&n| (0..3).all(|i| (mesh.nodes[n][i] - place[i]).abs() < 1e-9));
        state.shown(self.model.engine_node[node.unwrap()] as usize).xyz()
    }
}

#[test]
fn initial_stress_in_equilibrium_moves_nothing() {
    let built = built(lined(false));
    let state = built.settled(1);
    let worst = state.u.iter().flat_map(|u| u.xyz()).fold(0.0, |most: f64, x| most.max(x.abs()));
    assert!(worst < 1e-12, "{worst}");
}

/// What presses on the top presses on the reference column as well.
#[test]
fn ground_below_an_overburden_rests_and_so_does_its_column() {
    let mut problem = lined(false);
    let top = tremolite_mesh::topology::exterior_faces(&problem.mesh, None)
        .into_iter()
        .filter(|&face| {
            problem.mesh.face_nodes(face).all(|n| problem.mesh.nodes[n as usize][2] > DEPTH - 1e-9)
        })
        .map(|face| (face, [-PRESSURE, -PRESSURE, -PRESSURE, 0.0, 0.0, 0.0]))
        .collect();
    let traction = tremolite::Traction { name: "overburden".into(), faces: top, life: Life::BEFORE };
    problem.tractions = vec![traction];
    problem.initial.iter_mut().for_each(|s| (0..3).for_each(|i| s[i] -= PRESSURE));
    let built = built(problem);
    assert!(built.model.outside.columns.len() == 1);
    let state = built.settled(1);
    let worst = state.u.iter().flat_map(|u| u.xyz()).fold(0.0, |most: f64, x| most.max(x.abs()));
    assert!(worst < 1e-12, "{worst}");
}

/// The crown comes down, the floor up, the walls in; a lining that comes afterwards carries nothing but itself.
#[test]
fn an_opening_closes_and_a_lining_that_comes_after_carries_its_own_weight_alone() {
    for parted in [false, true] {
        let built = built(lined(parted));
        let opened = built.settled(2);
        let crown = built.at(&opened, [6.0, 2.0, 8.0]);
        let floor = built.at(&opened, [6.0, 2.0, 4.0]);
        let [left, right] = [4.0, 8.0].map(|x| built.at(&opened, [x, 2.0, 6.0]));
        assert!(crown[2] < -1e-5 && floor[2] > 1e-5, "{crown:?} {floor:?}");
        assert!(left[0] > 0.0 && (left[0] + right[0]).abs() < 1e-6 * left[0], "{left:?} {right:?}");

        let lined = built.settled(3);
        let more = (0..lined.u.len()).map(|n| (lined.u[n].0[2] - opened.u[n].0[2]).abs()).fold(0.0, f64::max);
        // It weighs three quarters of what was taken out.
        assert!(more < crown[2].abs(), "{more} {crown:?}");
        let phase = Phase::of(&built.model, &built.assembly, LINED).unwrap();
        let mut engine = Engine::new(&built.model, &built.assembly, &phase);
        let seen = engine.look(&lined).snapshot;
        let slot = |e: &usize| phase.element_slot[*e];
        let stress =
            (0..built.model.user.elements).filter(|&e| built.model.bodies[1].elements.contains(&(e as u32)));
        let largest = stress
            .filter_map(|e| slot(&e))
            .flat_map(|slot| seen.stress[slot.point as usize..][..slot.points as usize].to_vec())
            .flatten()
            .fold(0.0, |most: f64, s| most.max(s.abs()));
        assert!(largest < 10.0 * DENSITY * GRAVITY && largest > 0.0, "{largest}");
    }
}

/// One stage or two, the same end: everything is elastic.
#[test]
fn a_release_in_two_steps_ends_where_one_does() {
    let built = built(lined(false));
    let whole = built.settled(2);
    let half = PlannedStage { release: Release { share: 0.4, ..close().release }, ..close() };
    let (part, rests) = settle(&built.model, &built.assembly, &[close(), half]).unwrap();
    assert!(rests[1].unreleased > 1e-3, "{rests:?}");
    for (whole, part) in whole.u.iter().zip(&part.u) {
        for i in 0..3 {
            assert!((0.4 * whole.0[i] - part.0[i]).abs() < 1e-9, "{whole:?} {part:?}");
        }
    }
}

/// Nothing moves when the supports go, and every line of the balance is none.
#[test]
fn a_model_at_rest_stays_at_rest_in_the_shaking() {
    for parted in [false, true] {
        let built = built(lined(parted));
        let mut state = built.settled(3);
        let phase = Phase::of(&built.model, &built.assembly, Stage::Shaking).unwrap();
        let dt = 0.9 * stable_step(&built.model, &built.assembly, &phase).dt;
        let mut engine = Engine::new(&built.model, &built.assembly, &phase);
        engine.hand_over(&mut state, dt);
        let drift = engine.quiet_run(&state, 100);
        assert!(drift < 1e-12, "{drift}");
        let seen = engine.look(&state).snapshot;
        assert!(seen.displacement.iter().all(|u| u.0 == [0.0; 4]));
        let stored: f64 = state.ledger.lines[Line::Strain];
        assert!(stored > 1.0);
        for (line, value) in seen.balance.iter() {
            assert!(value.abs() < 1e-9 * stored, "{} {value} of {stored}", line.name());
        }
    }
}

/// A column of rock whose upper half becomes stiffer in stage 1, and which is loaded on top from stage 2 on.
pub fn stiffened(quadrature: Quadrature, poisson: f64) -> Problem {
    let mut spec = BoxSpec::uniform([0.0; 3], [4.0, 4.0, 8.0], [2, 2, 4]);
    spec.distortion =
        Some(tremolite_mesh::boxes::Distortion { fraction: 0.15, seed: 5, periodic: [false; 2] });
    let mut mesh = spec.mesh().unwrap();
    let (lower, upper): (Vec<u32>, Vec<u32>) =
        (0..mesh.elements.len() as u32).partition(|&e| tremolite::hexahedra::centroid(&mesh, e)[2] < 4.0);
    let mut lives = vec![Life::ALWAYS; mesh.elements.len()];
    let (mut soft, mut stand_ins, mut successors) = (lower.clone(), Vec::new(), Vec::new());
    for &e in &upper {
        let earlier = mesh.elements.len() as u32;
        mesh.elements.push(mesh.elements[e as usize]);
        lives[e as usize].born = Stage::Before(1);
        lives.push(Life { born: Stage::Before(0), gone: Some(Stage::Before(1)) });
        soft.push(earlier);
        stand_ins.push((earlier, e));
        successors.push((e, earlier));
    }
    let bodies =
        vec![body("soft", soft, 1e9, 0.25, quadrature), body("stiff", upper, 4e9, poisson, quadrature)];
    let top = tremolite_mesh::topology::exterior_faces(&mesh, Some(&bodies[1].elements))
        .into_iter()
        .filter(|&face| mesh.face_nodes(face).all(|n| mesh.nodes[n as usize][2] > 8.0 - 1e-9))
        .map(|face| (face, [0.0, 0.0, -PRESSURE, 0.0, 0.0, 0.0]))
        .collect();
    let mut problem = Problem::new(mesh, bodies);
    problem.lives = lives;
    problem.stand_ins = stand_ins;
    problem.successors = successors;
    problem.gravity = GRAVITY;
    problem.sides = [Side::Roller; 2];
    let life = Life { born: Stage::Before(2), gone: None };
    problem.tractions = vec![tremolite::Traction { name: "top".into(), faces: top, life }];
    problem
}

const PRESSURE: f64 = 1e6;

/// At the same ν nothing moves when the material changes, but for what the stage before had left (a millionth); at another ν the hourglass modes do a little. What is loaded later
/// gives by the new modulus.
#[test]
fn a_changed_material_begins_at_the_old_stress_and_gives_by_its_own_modulus() {
    for (quadrature, poisson, least) in [
        (Quadrature::OnePoint, 0.25, 1e-6),
        (Quadrature::Full, 0.25, 1e-6),
        (Quadrature::OnePoint, 0.17, 0.02),
        (Quadrature::Full, 0.17, 0.02),
    ] {
        let built = built(stiffened(quadrature, poisson));
        let [settled, changed, loaded] = [1, 2, 3].map(|stages| built.settled(stages));
        let most = |of: &dyn Fn(usize) -> f64| (0..settled.u.len()).map(of).fold(0.0, f64::max);
        let motion =
            most(&|n| (0..3).map(|i| (changed.u[n].0[i] - settled.u[n].0[i]).abs()).fold(0.0, f64::max));
        let weight = most(&|n| settled.u[n].0[2].abs());
        assert!(motion < least * weight, "{quadrature:?} {poisson}: {motion} of {weight}");
        let top = (0..settled.u.len())
            .filter(|&n| built.model.mesh.nodes[built.model.mesh_node[n] as usize][2] > 8.0 - 1e-9)
            .map(|n| changed.u[n].0[2] - loaded.u[n].0[2]);
        let modulus = |young: f64, nu: f64| {
            let m = Moduli::from_young_poisson(young, nu);
            m.lambda + 2.0 * m.mu
        };
        let exact = PRESSURE * (4.0 / modulus(1e9, 0.25) + 4.0 / modulus(4e9, poisson));
        // The meeting of two moduli in a distorted mesh is not level.
        for u in top {
            assert!((u - exact).abs() < 0.02 * exact, "{quadrature:?} {poisson}: {u} {exact}");
        }
    }
}

/// A stage that moves a hundredth of what came before is as near to its end as the others are to theirs: forces of a lining that
/// is placed behind a large excavation go by it.
#[test]
fn a_small_stage_behind_a_large_one_comes_to_its_own_rest() {
    let mut problem = lined(false);
    // Under 400 m of rock the excavation moves far more than the lining's own weight.
    problem.initial.iter_mut().for_each(|s| (0..3).for_each(|i| s[i] -= 10.0 * PRESSURE));
    let top = tremolite_mesh::topology::exterior_faces(&problem.mesh, None)
        .into_iter()
        .filter(|&face| {
            problem.mesh.face_nodes(face).all(|n| problem.mesh.nodes[n as usize][2] > DEPTH - 1e-9)
        })
        .map(|face| (face, [0.0, 0.0, -10.0 * PRESSURE, 0.0, 0.0, 0.0]))
        .collect();
    problem.tractions = vec![tremolite::Traction { name: "top".into(), faces: top, life: Life::BEFORE }];
    let built = built(problem);
    let usual = PlannedStage::new("stage");
    let last = |last: &PlannedStage| {
        let stages = [close(), close(), last.clone()];
        let (state, rests) = settle(&built.model, &built.assembly, &stages).unwrap();
        let opened = built.settled(2);
        (built.at(&state, [6.0, 2.0, 8.0])[2] - built.at(&opened, [6.0, 2.0, 8.0])[2], rests)
    };
    let ((usual, rests), (exact, _)) = (last(&usual), last(&close()));
    assert!(rests[2].motion < 0.05 * rests[1].motion, "{rests:?}");
    assert!((usual - exact).abs() < 0.01 * exact.abs(), "{usual} {exact} {rests:?}");
}

/// Ground that comes or goes at the model's corners is no ground of one column.
#[test]
fn ground_that_changes_at_the_corners_has_no_column() {
    let mut problem = lined(false);
    let corner = (0..problem.mesh.elements.len() as u32)
        .find(|&e| {
            let [x, y, z] = tremolite::hexahedra::centroid(&problem.mesh, e);
            x < 1.0 && y < 2.0 && z > DEPTH - 1.0
        })
        .unwrap();
    problem.lives[corner as usize].gone = Some(OPENED);
    let model = Model::new(problem).unwrap();
    assert!(
        model.outside.columns.is_empty() && model.outside.no_column.contains("changes with the stages"),
        "{}",
        model.outside.no_column
    );
}
