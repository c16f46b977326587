//! Interfaces that meet rock which is excavated later: at rest, and behind the excavation.

use crate::contact::between;
use std::sync::Arc;
use tremolite::engine::Release;
use tremolite::hexahedra::centroid;
use tremolite::stages::{PlannedStage, settle};
use tremolite::{Assembly, Base, Body, Life, Model, Problem, Quadrature, Side, Stage, State, elastic};
use tremolite_laws::Moduli;
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::split::{Cut, split};

pub const DENSITY: f64 = 2600.0;
pub const GRAVITY: f64 = 9.81;
pub const DEPTH: f64 = 16.0;
pub const LATERAL: f64 = 0.6;
/// Size of the ground \[m\].
pub const SIZE: [f64; 3] = [24.0, 2.0, 16.0];
/// The stage from which on the hall is there.
const OPENED: Stage = Stage::Before(1);

/// A fault through the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Fault {
    /// Half-way up the hall, or along its roof.
    Level,
    Roof,
    /// Through the hall's middle, upright or at 70 degrees.
    Vertical,
    Dipping,
    /// None.
    Without,
}

/// The surface of the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Surface {
    Even,
    /// It rises by a quarter, and planes lean to 70 degrees in the middle: the initial stress is not in equilibrium.
    Sloping,
}

/// How a fault is brought into a model.
#[derive(Clone, Copy, Debug, PartialEq)]
enum How {
    /// Between groups of rock that stays alone; what is excavated is one piece across it.
    Around,
    /// Through what is excavated as well.
    Through,
    /// The same, in a mesh that comes split.
    ByHand,
}

fn hall(x: [f64; 3]) -> bool {
    (8.0..16.0).contains(&x[0]) && (4.0..12.0).contains(&x[2])
}

/// Ground of 24 × 2 × 16 m with a hall of 8 × 8 m that goes with stage 1, and a fault of this normal stiffness \[Pa/m\].
fn ground(surface: Surface, fault: Fault, how: How, order: bool, stiffness: Option<f64>) -> Problem {
    let mut mesh = BoxSpec::uniform([0.0; 3], [24.0, 2.0, DEPTH], [12, 1, 8]).mesh().unwrap();
    let even = mesh.clone();
    let all: Vec<u32> = (0..mesh.elements.len() as u32).collect();
    // Where elements are before anything leans or slopes.
    let at: Vec<[f64; 3]> = all.iter().map(|&e| centroid(&even, e)).collect();
    let leans = fault == Fault::Dipping || surface == Surface::Sloping;
    let rise = if surface == Surface::Sloping { 0.25 } else { 0.0 };
    for x in &mut mesh.nodes {
        if leans {
            lean(x);
        }
        x[2] *= 1.0 + rise * (x[0] - 12.0) / 12.0;
    }
    let first = |e: &u32| {
        let x = at[*e as usize];
        match fault {
            Fault::Level => x[2] < 8.0,
            Fault::Roof => x[2] < 12.0,
            Fault::Vertical | Fault::Dipping => x[0] < 12.0,
            Fault::Without => false,
        }
    };
    let named = |e: &u32| how != How::Around || !hall(at[*e as usize]);
    let [one, two] = [true, false]
        .map(|side| -> Vec<u32> { all.iter().copied().filter(|e| named(e) && first(e) == side).collect() });
    if how == How::ByHand && fault != Fault::Without {
        let times = vec![0..1; all.len()];
        split(&mut mesh, &[Cut { name: "fault", sides: [&one, &two] }], &times).unwrap();
    }
    let until = |&e: &u32| if hall(at[e as usize]) { Some(OPENED) } else { None };
    let lives = all.iter().map(|e| Life { born: Stage::Before(0), gone: until(e) }).collect();
    let initial = all.iter().map(|&e| {
        let [x, _, z] = centroid(&mesh, e);
        let s = -DENSITY * GRAVITY * (DEPTH * (1.0 + rise * (x - 12.0) / 12.0) - z);
        [LATERAL * s, LATERAL * s, s, 0.0, 0.0, 0.0]
    });
    let initial = initial.collect();
    let rock = Body {
        name: "rock".into(),
        elements: all,
        material: elastic(Moduli::from_young_poisson(2e9, 0.25)),
        density: DENSITY,
        quadrature: Quadrature::Full,
        viscosity: 0.0,
    };
    let mut problem = Problem::new(mesh, vec![rock]);
    problem.lives = lives;
    problem.initial = initial;
    problem.gravity = GRAVITY;
    problem.sides = [Side::Roller; 2];
    problem.base = Base::Fixed;
    if fault != Fault::Without {
        let mut numbers = vec![("cohesion", 1e9), ("friction_coefficient", 0.6)];
        numbers.extend(stiffness.map(|k| ("normal_stiffness", k)));
        let mut interface = between(&problem, [0, 0], "coulomb", &numbers);
        interface.sides = if order { [one, two] } else { [two, one] };
        problem.interfaces = vec![interface];
    }
    problem
}

/// Upright planes lean to 70 degrees in the middle, and stay at the sides.
pub fn lean(x: &mut [f64; 3]) {
    let middle = 0.5 * SIZE[0];
    let share = 1.0 - (x[0] - middle).abs() / middle;
    x[0] += share * (x[2] - 8.0) / 70f64.to_radians().tan();
}

pub fn close(tolerance: f64) -> PlannedStage {
    let release = Release { tolerance: [tolerance, 100.0 * tolerance], most: 100_000, ..Release::default() };
    PlannedStage { release, ..PlannedStage::new("stage") }
}

struct Rested {
    model: Arc<Model>,
    state: State,
}

impl Rested {
    fn new(problem: Problem, stages: usize, tolerance: f64) -> Rested {
        let model = Model::new(problem).unwrap();
        let assembly = Assembly::new(&model).unwrap();
        let (state, _) = settle(&model, &assembly, &vec![close(tolerance); stages]).unwrap();
        Rested { model, state }
    }

    /// Displacement \[m\] of the corners of all elements that stand in the end, since the initial equilibrium or since the start.
    fn corners(&self, since_start: bool) -> Vec<f64> {
        let lasting = (0..self.model.user.elements).filter(|&e| self.model.stands(e, Stage::Shaking));
        let of = |node: u32| {
            let node = self.model.engine_node[node as usize] as usize;
            if since_start { self.state.u[node].xyz() } else { self.state.shown(node).xyz() }
        };
        lasting
            .flat_map(|e| self.model.mesh.elements[e].nodes().iter().flat_map(|&n| of(n)).collect::<Vec<_>>())
            .collect()
    }
}

pub fn apart(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
}

fn most(of: &[f64]) -> f64 {
    of.iter().fold(0.0, |most: f64, x| most.max(x.abs()))
}

const FAULTS: [(Surface, Fault); 7] = [
    (Surface::Even, Fault::Level),
    (Surface::Even, Fault::Roof),
    (Surface::Even, Fault::Vertical),
    (Surface::Even, Fault::Dipping),
    (Surface::Sloping, Fault::Level),
    (Surface::Sloping, Fault::Roof),
    (Surface::Sloping, Fault::Dipping),
];
const HOWS: [How; 3] = [How::Around, How::Through, How::ByHand];

/// The same ground without the fault, as it leans for it.
fn whole(surface: Surface, fault: Fault) -> Problem {
    Problem { interfaces: Vec::new(), ..ground(surface, fault, How::Around, true, None) }
}

#[test]
fn a_fault_through_an_opening_that_is_not_yet_dug_is_at_rest_as_the_ground_without_it() {
    for (surface, fault) in FAULTS {
        let settlement = most(&Rested::new(whole(surface, fault), 2, 1e-13).corners(false));
        let rest = Rested::new(whole(surface, fault), 1, 1e-13).corners(true);
        assert!(settlement > 5e-4, "{settlement}");
        for how in HOWS {
            for (order, stiffness) in [(true, Some(1e8)), (false, Some(1e11)), (how == How::Around, None)] {
                let faulted =
                    Rested::new(ground(surface, fault, how, order, stiffness), 1, 1e-13).corners(true);
                let share = apart(&faulted, &rest) / settlement;
                assert!(share < 1e-12, "{surface:?} {fault:?} {how:?} {order} {stiffness:?}: {share}");
            }
        }
    }
}

/// All of it is elastic and goes in one stage, so on even ground, where the stress beside a rim is that at the rim, it does not matter
/// whether the rock of the hall was parted.
#[test]
fn behind_the_excavation_both_orders_and_a_mesh_split_by_hand_agree() {
    for (surface, fault) in FAULTS {
        let upright = surface == Surface::Even && fault != Fault::Dipping;
        for stiffness in [1e9, 5e10] {
            let of = |how, order| {
                Rested::new(ground(surface, fault, how, order, Some(stiffness)), 2, 1e-11).corners(false)
            };
            let reference = of(How::ByHand, true);
            let share = |a: &[f64], b: &[f64]| apart(a, b) / most(&reference);
            for how in HOWS {
                let [one, other] = [true, false].map(|order| of(how, order));
                let (orders, by_hand) = (share(&one, &other), share(&one, &reference));
                assert!(orders < 1e-6, "{surface:?} {fault:?} {how:?} {stiffness:e}: {orders}");
                let limit = if how != How::Around || upright { 1e-6 } else { 0.01 };
                assert!(by_hand < limit, "{surface:?} {fault:?} {how:?} {stiffness:e}: {by_hand}");
            }
            // And the fault is felt.
            let without = Rested::new(whole(surface, fault), 2, 1e-11).corners(false);
            let felt = share(&without, &reference);
            assert!(felt > 1e-4, "{surface:?} {fault:?} {felt}");
        }
    }
}
