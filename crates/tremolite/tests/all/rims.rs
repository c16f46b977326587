//! Interfaces that meet rock which is excavated later, or a lining that is placed later.

use crate::contact::between;
use tremolite::engine::Release;
use tremolite::hexahedra::centroid;
use tremolite::stages::{PlannedStage, settle};
use tremolite::{Assembly, Base, Body, Engine, Life, Model, Phase, Problem, Quadrature, Side, Stage, State, elastic};
use tremolite_laws::Moduli;
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::split::{Cut, split};

const DENSITY: f64 = 2600.0;
const GRAVITY: f64 = 9.81;
const DEPTH: f64 = 16.0;
const LATERAL: f64 = 0.6;
/// The stage from which on the hall is there.
const OPENED: Stage = Stage::Before(1);

/// A fault through the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Fault {
    /// Half-way up the hall, or along its roof.
    Level,
    Roof,
    /// Through the hall's middle.
    Vertical,
    /// None.
    Without,
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
fn ground(fault: Fault, how: How, order: bool, stiffness: Option<f64>) -> Problem {
    let mut mesh = BoxSpec::uniform([0.0; 3], [24.0, 2.0, DEPTH], [12, 1, 8]).mesh().unwrap();
    let all: Vec<u32> = (0..mesh.elements.len() as u32).collect();
    let at: Vec<[f64; 3]> = all.iter().map(|&e| centroid(&mesh, e)).collect();
    let first = |e: &u32| {
        let x = at[*e as usize];
        match fault {
            Fault::Level => x[2] < 8.0,
            Fault::Roof => x[2] < 12.0,
            Fault::Vertical => x[0] < 12.0,
            Fault::Without => false,
        }
    };
    let named = |e: &u32| how != How::Around || !hall(at[*e as usize]);
    let [one, two] = [true, false].map(|side| -> Vec<u32> {
        all.iter().copied().filter(|e| named(e) && first(e) == side).collect()
    });
    if how == How::ByHand && fault != Fault::Without {
        let times = vec![0..1; all.len()];
        split(&mut mesh, &[Cut { name: "fault", sides: [&one, &two] }], &times).unwrap();
    }
    let until = |&e: &u32| if hall(at[e as usize]) { Some(OPENED) } else { None };
    let lives = all.iter().map(|e| Life { born: Stage::Before(0), gone: until(e) }).collect();
    let initial = at.iter().map(|x| {
        let s = -DENSITY * GRAVITY * (DEPTH - x[2]);
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
        let mut numbers = vec![("cohesion", 1e9), ("friction", 0.6)];
        numbers.extend(stiffness.map(|k| ("normal_stiffness", k)));
        let mut interface = between(&problem, [0, 0], "coulomb", &numbers);
        interface.sides = if order { [one, two] } else { [two, one] };
        problem.interfaces = vec![interface];
    }
    problem
}

fn close() -> PlannedStage {
    let release = Release { tolerance: [1e-11, 1e-9], most: 100_000, ..Release::default() };
    PlannedStage { release, ..PlannedStage::new("stage") }
}

struct Rested {
    model: Model,
    assembly: Assembly,
    state: State,
}

impl Rested {
    fn new(problem: Problem, stages: usize) -> Rested {
        let model = Model::new(problem).unwrap();
        let assembly = Assembly::new(&model).unwrap();
        let (state, _) = settle(&model, &assembly, &vec![close(); stages]).unwrap();
        Rested { model, assembly, state }
    }

    /// Displacement \[m\] since the initial equilibrium of the corners of all elements that stand in the end.
    fn corners(&self) -> Vec<f64> {
        let lasting = (0..self.model.user_elements).filter(|&e| self.model.stands(e, Stage::Shaking));
        let node = |n: &u32| self.state.shown(self.model.engine_node[*n as usize] as usize).xyz();
        lasting.flat_map(|e| self.model.mesh.elements[e].nodes().iter().flat_map(node).collect::<Vec<_>>()).collect()
    }
}

fn apart(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
}

fn most(of: &[f64]) -> f64 {
    of.iter().fold(0.0, |most: f64, x| most.max(x.abs()))
}

const FAULTS: [Fault; 3] = [Fault::Level, Fault::Roof, Fault::Vertical];
const HOWS: [How; 3] = [How::Around, How::Through, How::ByHand];

#[test]
fn a_fault_through_an_opening_that_is_not_yet_dug_is_at_rest_as_the_ground_without_it() {
    let settlement = most(&Rested::new(ground(Fault::Without, How::Around, true, None), 2).corners());
    assert!(settlement > 1e-5, "{settlement}");
    for fault in FAULTS {
        for how in HOWS {
            for (order, stiffness) in [(true, Some(1e8)), (false, Some(1e11)), (true, None), (false, None)] {
                let rested = Rested::new(ground(fault, how, order, stiffness), 1);
                let moved = rested.state.u.iter().flat_map(|u| u.xyz()).fold(0.0, |m: f64, x| m.max(x.abs()));
                println!("{fault:?} {how:?} {order} {stiffness:?}: {moved:e} of {settlement:e}");
                assert!(moved < 1e-12 * settlement, "{fault:?} {how:?} {order} {stiffness:?}: {moved}");
            }
        }
    }
}

/// All of it is elastic and goes in one stage, so it does not matter whether the rock of the hall was parted.
#[test]
fn behind_the_excavation_both_orders_and_a_mesh_split_by_hand_agree() {
    for fault in FAULTS {
        for stiffness in [1e9, 5e10] {
            let of = |how, order| Rested::new(ground(fault, how, order, Some(stiffness)), 2).corners();
            let reference = of(How::ByHand, true);
            for how in HOWS {
                for order in [true, false] {
                    let share = apart(&of(how, order), &reference) / most(&reference);
                    println!("{fault:?} {how:?} {order} {stiffness:e}: {share:e}");
                    assert!(share < 1e-6, "{fault:?} {how:?} {order} {stiffness:e}: {share}");
                }
            }
            // And the fault is felt.
            let without = Rested::new(ground(Fault::Without, How::Around, true, None), 2).corners();
            let felt = apart(&without, &reference) / most(&reference);
            assert!(felt > 1e-4, "{fault:?} {felt}");
        }
    }
}
