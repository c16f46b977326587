//! `tremolite verify` as its reader meets it.

use serde_json::Value;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
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

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs")
}

/// A folder with the figures on record, changed by `change`, and what the program says as it writes the document from them.
fn written(change: impl Fn(String) -> String) -> (tempfile::TempDir, Output) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("verification")).unwrap();
    let record = std::fs::read_to_string(docs().join("verification/figures.json")).unwrap();
    std::fs::write(folder.path().join("verification/figures.json"), change(record)).unwrap();
    let output = verify(&["--recorded", "--write", folder.path().to_str().unwrap()]);
    (folder, output)
}

#[test]
fn the_document_is_what_the_figures_on_record_give_and_none_is_beyond_its_tolerance() {
    let (folder, output) = written(|record| record);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let anew = "write it anew: tremolite verify --recorded --write docs";
    let read =
        |path: PathBuf| std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let page = read(docs().join("verification.md"));
    assert!(page == read(folder.path().join("verification.md")), "{anew}");
    // GitHub shows no page beyond this.
    assert!(page.len() < 500_000, "{} bytes", page.len());
    let plots = |folder: PathBuf| -> BTreeSet<_> {
        let names =
            std::fs::read_dir(folder).unwrap().map(|file| file.unwrap().file_name().into_string().unwrap());
        names.filter(|name| name.ends_with(".svg")).collect()
    };
    let names = plots(folder.path().join("verification"));
    assert_eq!(names, plots(docs().join("verification")), "plots of docs/verification");
    for name in names {
        assert!(
            read(docs().join("verification").join(&name))
                == read(folder.path().join("verification").join(&name)),
            "{name}: {anew}"
        );
        assert!(page.contains(&format!("(verification/{name})")), "{name} is not on the page");
    }
}

#[test]
fn the_documents_list_of_problems_is_the_programs_and_each_has_figures_or_says_that_it_has_none() {
    let page = std::fs::read_to_string(docs().join("verification.md")).unwrap();
    let sections: Vec<&str> = page.split("\n## ").skip(1).collect();
    let named: Vec<&str> = sections.iter().map(|section| section.lines().next().unwrap()).collect();
    assert_eq!(named, PROBLEMS.iter().map(|problem| problem.name).collect::<Vec<_>>());
    for section in sections {
        assert!(section.contains("**Source**: "), "{section}");
        assert!(section.contains("| quantity | value |") != section.contains("**Not run**"), "{section}");
    }
}

#[test]
fn a_figure_on_record_beyond_its_tolerance_fails_and_is_said_on_the_page() {
    let (folder, output) = written(|record| {
        let mut record: serde_json::Value = serde_json::from_str(&record).unwrap();
        // Of the plain run and of the full one, which is shown where there is one.
        for problem in record["problems"].as_array_mut().unwrap() {
            if problem["name"] == "scheme_literal" {
                problem["figures"][0]["pass"] = false.into();
            }
        }
        record.to_string()
    });
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8(output.stderr).unwrap().contains("scheme_literal"));
    let page = std::fs::read_to_string(folder.path().join("verification.md")).unwrap();
    assert!(page.contains(", beyond**") && page.contains("**1 beyond the tolerance**"));
}

#[test]
fn an_order_below_the_one_on_record_fails() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path().to_str().unwrap();
    let problem = "concrete_rates";
    assert!(verify(&[problem, "--write", at]).status.success());
    let record = folder.path().join("verification/figures.json");
    let against = || verify(&[problem, "--against", record.to_str().unwrap()]);
    let kept = against();
    assert!(kept.status.success());
    let said = String::from_utf8(kept.stderr).unwrap();
    assert!(said.contains("1 orders of convergence beside those on record, 0 lost"), "{said}");
    let text = std::fs::read_to_string(&record).unwrap();
    // 0.9 becomes 10.9.
    let mut places = text.match_indices("\"order\":").map(|(at, key)| at + key.len());
    let at = places.find(|at| !text[*at..].starts_with("null")).unwrap();
    std::fs::write(&record, format!("{}1{}", &text[..at], &text[at..])).unwrap();
    let lost = against();
    assert_eq!(lost.status.code(), Some(1));
    let said = String::from_utf8(lost.stderr).unwrap();
    assert!(said.contains("an order is lost") && said.contains(" 1 lost"), "{said}");
    let none = verify(&[problem, "--against", "no-such-file.json"]);
    assert_eq!(none.status.code(), Some(2));
}
