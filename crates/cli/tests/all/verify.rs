//! `tremolite verify` as its reader meets it.

use serde_json::Value;
use std::collections::BTreeSet;
use std::process::{Command, Output};
use tremolite_verify::{Effort, PROBLEMS};

fn verify(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tremolite")).arg("verify").args(args).output().unwrap()
}

/// Two that take milliseconds and end no row with a mark.
const QUICK: [&str; 2] = ["concrete_triaxial", "rock_strength"];

#[test]
fn the_seconds_of_each_problem_stand_in_its_first_row_and_their_sum_at_the_end() {
    let output = verify(&QUICK);
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.lines().next().unwrap().ends_with(" seconds"));
    let mut sum = 0.0;
    for name in QUICK {
        let first = text.lines().find(|line| line.starts_with(name)).unwrap();
        sum += first.split_whitespace().last().unwrap().parse::<f64>().unwrap_or_else(|_| panic!("{first}"));
    }
    let last = text.lines().last().unwrap();
    let total = last.rsplit_once("2 problems in ").and_then(|(_, rest)| rest.strip_suffix(" s")).unwrap();
    // Each is rounded to a hundredth, the sum to a tenth.
    assert!((total.parse::<f64>().unwrap() - sum).abs() < 0.061, "{last}: {sum}");
}

#[test]
fn the_list_for_programs_has_the_id_and_the_seconds_with_each_figure() {
    let output = verify(&["--json", QUICK[0], QUICK[1]]);
    let figures: Vec<Value> = serde_json::from_slice(&output.stdout).unwrap();
    let mut ids = BTreeSet::new();
    for figure in &figures {
        let (id, name) = (figure["id"].as_str().unwrap(), figure["name"].as_str().unwrap());
        assert!(QUICK.contains(&name) && id.starts_with(&format!("{name}_")));
        assert!(id.chars().all(|c| matches!(c, 'a'..='z' | '0'..='9' | '_')), "{id}");
        assert!(ids.insert(id), "twice: {id}");
        assert!(figure["problem_seconds"].as_f64().unwrap() > 0.0);
    }
    assert!(ids.contains("rock_strength_mohr_coulomb_psi_0_strength_in_compression_at_1_mpa"));
}

#[test]
fn what_the_tests_leave_out_is_asked_for_alone() {
    assert!(PROBLEMS.iter().any(|p| p.from > Effort::Test), "there is something beyond the tests");
    for other in ["--full", QUICK[0]] {
        let output = verify(&["--beyond-tests", other]);
        assert_eq!(output.status.code(), Some(2));
        assert!(String::from_utf8(output.stderr).unwrap().contains("--beyond-tests"));
    }
}
