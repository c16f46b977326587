//! The figures and figures in numbers of docs/laws.md are what the program gives.

#[path = "../../examples/law_figures.rs"]
#[allow(dead_code)]
mod example;

use std::fs;
use std::path::Path;
use tremolite_verify::{Effort, PROBLEMS, select};

fn docs() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs")
}

#[test]
fn the_figures_are_those_that_the_example_draws() {
    let page = fs::read_to_string(docs().join("laws.md")).unwrap();
    for (name, svg) in example::figures() {
        let path = docs().join("laws").join(name);
        let found = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        assert!(
            found == svg,
            "{name} is not what the laws give; run cargo run --release -p tremolite-cli --example law_figures"
        );
        assert!(svg.len() < 100_000, "{name}: {} bytes", svg.len());
        assert!(page.contains(&format!("(laws/{name})")), "{name} is not on the page");
    }
}

#[test]
fn every_problem_that_the_page_names_is_there() {
    let page = fs::read_to_string(docs().join("laws.md")).unwrap();
    let named: Vec<&str> = page
        .split('`')
        .skip(1)
        .step_by(2)
        .filter_map(|code| code.strip_prefix("tremolite verify "))
        .flat_map(str::split_whitespace)
        .collect();
    assert!(!named.is_empty());
    for name in named {
        assert!(PROBLEMS.iter().any(|p| p.name == name), "{name}");
    }
}

#[test]
fn every_test_of_the_page_on_tests_is_a_problem_and_every_figure_is_there() {
    let page = fs::read_to_string(docs().join("tests.md")).unwrap();
    let rows = page.lines().filter(|line| line.starts_with("| ")).filter_map(|line| line.split('|').nth(2));
    let named: Vec<&str> = rows.filter_map(|cell| cell.trim().strip_prefix('`')?.strip_suffix('`')).collect();
    let tests = named.iter().filter(|name| **name != "verify");
    assert_eq!(tests.clone().count(), 9, "{named:?}");
    for name in tests {
        assert!(PROBLEMS.iter().any(|p| p.name == *name), "{name}");
    }
    for figure in page.split("](laws/").skip(1).filter_map(|rest| rest.split(')').next()) {
        assert!(docs().join("laws").join(figure).exists(), "{figure}");
    }
}

/// Rows 'quantity | law | test | difference' of the table beside tests.
#[test]
fn the_table_beside_tests_is_what_verify_prints() {
    let page = fs::read_to_string(docs().join("laws.md")).unwrap();
    let mut rows = 0;
    let [problem] = select(&["concrete_biaxial"]).unwrap()[..] else { panic!("one problem") };
    for check in problem.verify(Effort::Test).checks.iter().filter(|check| check.tolerance.is_none()) {
        let (quantity, who) = check.quantity.rsplit_once(", beside ").unwrap();
        let difference = format!("{:+.0} %", 100.0 * (check.value / check.reference - 1.0));
        let row = format!(
            "| {quantity} | {:.2} | {:.2} ({who}) | {} |",
            check.value,
            check.reference,
            difference.replace('-', "−")
        );
        assert!(page.contains(&row), "missing on the page:\n{row}");
        rows += 1;
    }
    assert!(rows > 10);
}
