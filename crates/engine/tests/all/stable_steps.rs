//! What the stable step says of itself.

use crate::ready::{Ready, body, joint, whole};
use tremolite_engine::{Base, Model, ModelError, Problem, Rayleigh, Side};
use tremolite_mesh::boxes::BoxSpec;

fn layers() -> Problem {
    let mesh = BoxSpec::uniform([0.0; 3], [3.0, 3.0, 4.0], [3, 3, 4]).mesh().unwrap();
    let mut problem =
        Problem::new(mesh, vec![body("below", (0..18).collect()), body("above", (18..36).collect())]);
    problem.interfaces = vec![joint(&problem, [0, 1], 1e11)];
    problem
}

/// Without artificial viscosity the step is that of the stiffness to the last bit, and λ(M⁻¹C) = ω + ξλ(M⁻¹K).
#[test]
fn nothing_but_stiffness_and_damping_sets_the_step_where_nothing_is_viscous() {
    let problem = |rayleigh: Rayleigh| {
        let mut problem = whole(BoxSpec::uniform([0.0; 3], [3.0, 2.0, 2.0], [3, 2, 2]).mesh().unwrap());
        problem.rayleigh = rayleigh;
        Ready::new(problem).stable()
    };
    let elastic = problem(Rayleigh::default());
    assert_eq!(elastic.dt, elastic.undamped);
    assert_eq!(elastic.damping_rate, 0.0);
    let Rayleigh { mass, stiffness } = Rayleigh { mass: 3.0, stiffness: 1e-3 };
    let damped = problem(Rayleigh { mass, stiffness });
    let rate = mass + stiffness * damped.frequency.powi(2);
    assert!((damped.damping_rate / rate - 1.0).abs() < 1e-14);
    assert!((damped.dt * rate / 2.0 - 1.0).abs() < 1e-14 && damped.dt < damped.undamped);
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
