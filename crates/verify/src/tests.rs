//! Every problem that takes 2 s at most as a test.

use super::*;

/// Thirty times what a problem of the tests may take \[s\]: a busy machine passes, a problem in the wrong place does not.
const FAR_TOO_LONG: f64 = 60.0;

fn passes(name: &str) {
    for problem in select(&[name]).unwrap() {
        let verified = problem.verify(Effort::Test);
        let said: Vec<String> = verified.checks.iter().map(|c| format!("{c} ({})", c.note)).collect();
        println!("{}\n{:.2} s", said.join("\n"), verified.seconds);
        assert!(!said.is_empty());
        assert_eq!(verified.missed(), 0, "{}", said.join("\n"));
        assert!(
            verified.seconds < FAR_TOO_LONG,
            "{:.1} s: let it begin with Effort::Verify",
            verified.seconds
        );
    }
}

macro_rules! problems {
    ($($name:ident),* $(,)?) => {
        $(#[test]
        fn $name() {
            passes(stringify!($name));
        })*

        #[test]
        fn every_problem_is_a_test_or_says_that_it_takes_longer() {
            let tests = [$(stringify!($name)),*];
            assert!(PROBLEMS.iter().filter(|p| p.from == Effort::Test).map(|p| p.name).eq(tests));
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
    strip_footing,
);

#[test]
fn all_problems_are_taken_in_by_plain_verify() {
    assert!(PROBLEMS.iter().all(|p| p.from <= Effort::default()));
    assert_eq!(select(&[]).unwrap().len(), PROBLEMS.len());
}

#[test]
fn an_unknown_name_selects_nothing_and_lists_the_known_ones() {
    let error = select(&["lamb", "lamp"]).unwrap_err();
    assert_eq!(error.name, "lamp");
    assert!(error.to_string().contains("bar_step_wave"));
}
