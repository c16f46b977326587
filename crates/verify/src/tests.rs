//! What is tested of a problem that takes 2 s at most, and of the list.

use super::*;

/// Thirty times what a problem of the tests may take \[s\]: a busy machine passes, a problem in the wrong place does not.
const FAR_TOO_LONG: f64 = 60.0;

pub(crate) fn passes(name: &str) {
    for problem in select(&[name]).unwrap() {
        let verified = problem.verify(Effort::Test);
        let said: Vec<String> = verified.checks.iter().map(Check::to_string).collect();
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

#[test]
fn ids_are_snake_case_and_those_of_one_problem_cannot_be_those_of_another() {
    for problem in PROBLEMS {
        assert_eq!(problem.name, id::snake_case(problem.name));
        let begin = format!("{}_", problem.name);
        assert!(
            PROBLEMS
                .iter()
                .all(|other| !format!("{}_", other.name).starts_with(&begin) || other.name == problem.name)
        );
    }
}

#[test]
fn two_figures_of_one_id_are_a_miss_that_names_it() {
    let run =
        |_| Ok(["load, ψ = 0", "load ψ 0"].map(|q| Check::new("x", q, 1.0, 1.0, 0.1, "m", "")).to_vec());
    let problem = Verification { name: "x", summary: "", source: "", from: Effort::Test, run };
    let verified = problem.verify(Effort::Test);
    assert_eq!(verified.missed(), 1);
    assert!(verified.checks[2].to_string().contains("x_load_psi_0"), "{}", verified.checks[2]);
}
