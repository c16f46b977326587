//! What the stable step says of itself.

use crate::ready::{Ready, whole};
use tremolite_engine::Rayleigh;
use tremolite_mesh::boxes::BoxSpec;

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

/// The search ends where λ changes by less than 10⁻⁵ of itself, however large it is, and not only where it has to.
#[test]
fn the_search_ends_by_the_relative_change_of_what_it_finds() {
    let mesh = BoxSpec::uniform([0.0; 3], [6.0, 5.0, 4.0], [6, 5, 4]).mesh().unwrap();
    let found = |scale: f64| {
        let mut mesh = mesh.clone();
        mesh.nodes.iter_mut().for_each(|x| *x = x.map(|x| scale * x));
        Ready::new(whole(mesh)).stable()
    };
    // A power of two leaves the same bits but for the exponent.
    let [small, large] = [0.25, 64.0].map(found);
    assert!(small.change < 1e-5 && (4..200).contains(&small.iterations), "{small:?}");
    assert_eq!((small.iterations, small.change), (large.iterations, large.change));
}
