//! Every problem as a test, at quick effort.

use super::*;

fn passes(name: &str) {
    let mut said = Vec::new();
    let missed = run(&[name], Effort::Quick, &mut |check| {
        println!("{check}");
        said.push(format!("{check} ({})", check.note));
    })
    .unwrap();
    assert!(!said.is_empty());
    assert_eq!(missed, 0, "{}", said.join("\n"));
}

macro_rules! problems {
    ($($name:ident),* $(,)?) => {
        $(#[test]
        fn $name() {
            passes(stringify!($name));
        })*

        #[test]
        fn every_problem_is_a_test() {
            let tests = [$(stringify!($name)),*];
            assert!(PROBLEMS.iter().map(|p| p.name).eq(tests));
        }
    };
}

problems!(
    scheme_literal,
    time_order,
    discrete_energy,
    damping_ratio,
    band_damping,
    dispersion,
    bar_step_wave,
    incident_pulse,
    layered_column,
    lamb,
    macneal_harder_beam,
    cantilever_thin,
    thick_cylinder,
    concrete_uniaxial,
    concrete_triaxial,
    concrete_rates,
    concrete_biaxial,
    concrete_loops,
    concrete_fracture_energy,
    rock_strength,
    circular_opening,
    strip_footing,
);

#[test]
fn an_unknown_name_runs_nothing_and_lists_the_known_ones() {
    let error = run(&["lamb", "lamp"], Effort::Quick, &mut |_| panic!("nothing may run")).unwrap_err();
    assert_eq!(error.name, "lamp");
    assert!(error.to_string().contains("bar_step_wave"));
}
