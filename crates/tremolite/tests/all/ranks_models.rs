//! Boundaries, waves, laws, parts, observers and levels of steps, each on several ranks.

use crate::block::{block, pulse};
use crate::contact::jointed;
use crate::damage::hall_of;
use crate::outside_part::on_springs;
use crate::ranks::{Case, SOME, how, plan, shaken};
use crate::ready::Ready;
use crate::rims_cavern::cavern;
use crate::staged::stiffened;
use crate::waves_at_angles::two_waves;
use std::path::Path;
use std::sync::Arc;
use tremolite::observers::{Event, Observer, Setting, Wants, Which};
use tremolite::simulation::Built;
use tremolite::state::Memory;
use tremolite::strength::JudgedBy;
use tremolite::{Base, Division, Incident, Life, Prescribed, Quadrature, RunError, Side, Stage};
use tremolite_laws::Isa;
use tremolite_sections::{Code, Grade, Rule};

#[test]
fn all_sides_and_bases_give_the_same_on_several_ranks() {
    let springs = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(20.0) };
    for (k, side) in Side::EXAMPLES.into_iter().enumerate() {
        let base = [Base::Free, Base::Fixed, Base::Viscous, springs][(k + 2) % 4];
        for base in [base, springs] {
            let mut problem = shaken(block([4, 4, 5]));
            problem.base = base;
            problem.sides = [side, Side::EXAMPLES[(k + 1) % Side::EXAMPLES.len()]];
            problem.patch_elements = Some(8);
            problem.ties = vec![(3, 40)];
            // With ξ ≠ 0 products with the stiffness are exchanged besides.
            problem.rayleigh.stiffness = if k % 2 == 0 { 1e-5 } else { 0.0 };
            if matches!(base, Base::Free | Base::Fixed) {
                // With the wave that they do not let in the guard leaves as much to noise as such loads do at first.
                problem.loads = vec![tremolite::parts::loads::Load {
                    forces: vec![(7, [1e5, 2e5, -1e5]), (60, [2e5, 0.0, 1e5])],
                    factor: Arc::new(|t: f64| (300.0 * t).cos()),
                }];
            }
            // Ground at the corners is no column where it is held.
            if tremolite::Model::new(problem.clone()).is_err() {
                continue;
            }
            let [first, second, third] = SOME;
            let ways = if k % 2 == 0 { [first, second] } else { [third, second] };
            Case::new(problem, &[], 0.012).holds(&format!("{side:?} {base:?}"), &ways);
        }
    }
}

#[test]
fn waves_at_angles_give_the_same_on_several_ranks_with_levels_or_without() {
    for levels in [false, true] {
        let mut problem = shaken(block([6, 5, 10]));
        let (low, high) = problem.mesh.bounds();
        assert_eq!(low, [0.0; 3]);
        let field = two_waves(high, &problem.bodies[0], problem.top);
        problem.incident = None;
        problem.free_field = Some(Arc::new(field));
        problem.sides = [Side::FreeField; 2];
        problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(20.0) };
        let plan = plan(&problem, &[], 0.012);
        let ready = Ready::new(problem);
        let ready = if levels { ready.levelled(|[_, _, z]| (z / 3.0) as u8) } else { ready };
        Case::of(ready, plan).holds(&format!("waves at angles, {levels}"), &SOME[..2]);
    }
}

#[test]
fn materials_that_change_take_over_from_other_ranks() {
    for quadrature in [Quadrature::OnePoint, Quadrature::Full] {
        let mut problem = stiffened(quadrature, 0.17);
        problem.patch_elements = Some(8);
        problem.base = Base::Viscous;
        problem.incident = Some(Incident { motion: pulse(), factor: 2.0 });
        Case::new(problem, &["start", "stiffer", "loaded"], 0.012).holds("changed material", &SOME);
    }
}

#[test]
fn pairs_freed_at_rims_are_told_the_stress_beside_them_by_other_ranks() {
    let stages = ["start", "first", "second", "third", "fourth", "last"];
    let mut problem = cavern(false);
    problem.patch_elements = Some(16);
    Case::new(problem, &stages, 0.02).holds("cavern with a fault", &[how(3, 1, false), how(2, 2, true)]);
}

#[test]
fn levels_of_steps_exchange_what_their_step_moves() {
    let upwards = |[_, _, z]: [f64; 3]| (z / 3.0) as u8;
    let blobs = |[x, y, z]: [f64; 3]| {
        ((1.3 * x).sin() * (0.9 * y).cos() * 2.0 + (0.7 * z).sin() + 2.5).clamp(0.0, 3.0) as u8
    };
    let wishes: [fn([f64; 3]) -> u8; 2] = [upwards, blobs];
    for (k, wished) in wishes.into_iter().enumerate() {
        for side in [Side::FreeField, Side::Periodic] {
            let mut problem = shaken(block([6, 5, 14]));
            problem.sides = [side; 2];
            problem.rayleigh.mass = 3.0;
            let plan = plan(&problem, &[], 0.012);
            let ready = Ready::new(problem).levelled(wished);
            assert_eq!(ready.phase.beats.len(), 4 - usize::from(k > 1));
            Case::of(ready, plan).holds(&format!("levels {k}, {side:?}"), &SOME);
        }
    }
    let mut problem = shaken(jointed(Isa::best()));
    problem.patch_elements = Some(32);
    let plan = plan(&problem, &[], 0.01);
    Case::of(Ready::new(problem).levelled(upwards), plan).holds("levels through joints", &SOME[..2]);
}

/// Who judges sections glances at every step at linings, whose elements and bars are on several ranks.
#[test]
fn judged_sections_see_in_every_step_what_other_ranks_have() {
    let mut problem = shaken(hall_of(0.6e6, "effective"));
    problem.patch_elements = Some(4);
    let mut case = Case::new(problem, &[], 0.012);
    let elements = case.built.model.mesh.groups["hall.lining"].clone();
    let rule = Rule {
        code: Code::En,
        grade: Grade::of(Code::En, "C30/37").unwrap(),
        concrete_factor: 1.5,
        steel_factor: 1.15,
        compression_factor: 0.8,
        tension_factor: 0.8,
        resistance_factor: 1.0,
        tension: true,
    };
    let (code, grade) = ("en".into(), "C30/37".into());
    case.plan.sections = vec![JudgedBy { elements, code, grade, rule, dynamic: 1.0, bar_diameter: None }];
    assert!(case.alone().0.contains_key(Path::new("utilisation.csv")), "some sections are judged");
    case.holds("judged sections", &SOME);
}

/// Follows two nodes in every step, and remembers the sum of what it is told.
struct Follower(Vec<usize>);

impl Observer for Follower {
    fn wants(&self) -> Wants {
        Wants { steps: Which::some(self.0.iter().copied()), ..Wants::default() }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        if let Event::Step(step) = event {
            let sums = memory.entry("follower".into()).or_insert_with(|| vec![0.0; 2]);
            for &node in &self.0 {
                sums[0] += step.u[node].0[0];
                sums[1] += step.du[node].0[2];
            }
        }
        Ok(())
    }
}

#[test]
fn parts_and_observers_of_a_programs_own_have_a_rank() {
    let mut problem = on_springs(1e8);
    problem.patch_elements = Some(24);
    problem.loads = vec![tremolite::parts::loads::Load {
        forces: vec![(7, [1e5, 2e5, -1e5])],
        factor: Arc::new(|t: f64| (300.0 * t).sin()),
    }];
    let mut case = Case::new(problem, &[], 0.02);
    case.own = || {
        let make = |setting: &Setting| {
            let last = setting.model.nodes.len() - 1;
            Ok(setting.shakes().then(|| Box::new(Follower(vec![3, last])) as Box<dyn Observer>))
        };
        vec![Arc::new(make)]
    };
    case.holds("springs of a program's own", &SOME);
}

#[test]
fn nodes_that_stages_move_tell_all_ranks_their_reaction() {
    let mut problem = block([4, 4, 5]);
    problem.patch_elements = Some(8);
    problem.bed = tremolite::Bed::NONE;
    problem.incident = None;
    let top = |z: f64| -> Vec<(u32, u8)> {
        let elements = (0u32..).zip(&problem.mesh.elements);
        let corners = |element: &tremolite_mesh::Element| -> u8 {
            let corners = element.nodes().iter().enumerate();
            let there = corners.filter(|(_, n)| (problem.mesh.nodes[**n as usize][2] - z).abs() < 1e-9);
            there.map(|(k, _)| 1 << k).sum()
        };
        elements.map(|(e, element)| (e, corners(element))).filter(|(_, corners)| *corners > 0).collect()
    };
    let mut moved = Vec::new();
    for (k, way) in (0u16..).zip([0.0, -1e-4, -2e-4]) {
        let life = Life { born: Stage::Before(k), gone: Some(Stage::Before(k + 1)) };
        let one = |name: &str, z: f64, to| Prescribed { name: name.into(), corners: top(z), to, life };
        moved.push(one("plate", 14.0, [Some(0.0), Some(0.0), Some(way)]));
        moved.push(one("floor", 0.0, [Some(0.0); 3]));
    }
    problem.prescribed = moved;
    problem.sides = [Side::Free; 2];
    Case::new(problem, &["start", "pressed", "more"], 0.0).holds("specimen", &SOME);
}

/// More ranks than patches: some have neither elements nor nodes of their own, and keep step with the others.
#[test]
fn ranks_without_elements_keep_step_with_levels_and_a_free_field() {
    let mut problem = shaken(block([4, 4, 6]));
    problem.sides = [Side::FreeField; 2];
    problem.patch_elements = Some(96);
    let plan = plan(&problem, &[], 0.006);
    let case = Case::of(Ready::new(problem).levelled(|[_, _, z]| (z / 5.0) as u8), plan);
    let Built { model, assembly, .. } = &case.built;
    let idle = Division::even(model, assembly, 24).weights.iter().filter(|weight| **weight == 0.0).count();
    assert!(idle > 2, "{idle} of 24 ranks have nothing, of {} patches", model.patches.len());
    case.holds("idle ranks", &[how(24, 1, false)]);
}
