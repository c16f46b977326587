//! Interfaces as the engine makes them of what is asked for.

use crate::ready::{Ready, body, joint};
use tremolite_engine::{Base, Model, ModelError, Problem, Side};
use tremolite_mesh::boxes::BoxSpec;

fn layers() -> Problem {
    let mesh = BoxSpec::uniform([0.0; 3], [3.0, 3.0, 4.0], [3, 3, 4]).mesh().unwrap();
    let mut problem =
        Problem::new(mesh, vec![body("below", (0..18).collect()), body("above", (18..36).collect())]);
    problem.interfaces = vec![joint(&problem, [0, 1], 1e11)];
    problem
}

/// The joint goes on through what stands outside, as stiff as in the model: the model's own is named.
#[test]
fn the_joint_of_the_model_is_named_and_not_what_of_it_runs_through_slabs() {
    let mut problem = layers();
    problem.sides = [Side::FreeField; 2];
    problem.base = Base::Viscous;
    let ready = Ready::new(problem);
    let contact = ready.stable().contact.unwrap();
    assert!(ready.model.seams.len() > 1 && ready.model.user_seams().len() == 1);
    assert_eq!(contact.interface, 0);
    let seam = &ready.model.seams[0];
    assert!((contact.dt * ready.assembly.contacts[0].frequency / seam.limit - 1.0).abs() < 1e-14);
}

/// Whoever reads a case finds the interface by its name.
#[test]
fn faults_of_an_interface_name_it_and_others_none() {
    let refused = |problem: Problem| Model::new(problem).err().unwrap();
    let mut apart = layers();
    apart.interfaces[0].sides = [vec![0], vec![35]];
    assert_eq!(refused(apart).interface(), Some("joint"));
    let mut heavy = layers();
    heavy.bodies[0].density = -1.0;
    let error = refused(heavy);
    assert!(matches!(error, ModelError::Density { .. }) && error.interface().is_none());
}

/// Under 40 MPa across the joint it has room for half as much again, and where it is expected to bear more than that for that.
#[test]
fn a_joint_under_initial_stress_has_room_for_half_as_much_again() {
    for (expected, room) in [(10e6, 60e6), (80e6, 80e6)] {
        let mut problem = layers();
        problem.interfaces[0].pressure = expected;
        problem.initial = vec![[-9e6, -8e6, -40e6, 0.0, 0.0, 0.0]; 36];
        let seam = &Ready::new(problem).model.seams[0];
        assert!((seam.pressure / room - 1.0).abs() < 1e-12, "{}", seam.pressure);
        assert!(seam.tractions.iter().all(|[p, a, b]| (p / 40e6 - 1.0).abs() < 1e-12 && a.hypot(*b) < 1.0));
    }
}
