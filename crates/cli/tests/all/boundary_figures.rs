//! The figures and figures in numbers of docs/boundaries.md are what the engine's boundaries give.

#[path = "../../examples/boundary_figures.rs"]
#[allow(dead_code)]
mod example;

use std::fs;
use std::path::Path;
use tremolite_verify::PROBLEMS;

fn docs() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs")
}

fn page() -> String {
    fs::read_to_string(docs().join("boundaries.md")).unwrap()
}

#[test]
fn the_figures_of_boundaries_are_those_that_the_example_draws() {
    for (name, svg) in example::figures() {
        let path = docs().join("boundaries").join(name);
        let found = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        assert!(
            found == svg,
            "{name} is not what boundaries give; run cargo run --release -p tremolite-cli --example boundary_figures"
        );
        assert!(svg.len() < 100_000, "{name}: {} bytes", svg.len());
        assert!(page().contains(&format!("(boundaries/{name})")), "{name} is not on the page");
    }
}

/// Their runs take too long for a test; `tremolite verify box_size` compares the numbers.
#[test]
fn the_figure_of_boxes_is_on_the_page() {
    assert!(docs().join("boundaries").join(example::BOXES).is_file());
    assert!(page().contains(&format!("(boundaries/{})", example::BOXES)));
}

#[test]
fn the_table_of_energy_sent_back_is_what_boundaries_give() {
    let rows = example::rows();
    assert!(rows.len() > 5);
    for row in rows {
        assert!(page().lines().any(|line| line == row), "missing on the page:\n{row}");
    }
}

#[test]
fn every_problem_that_the_page_of_boundaries_names_is_there() {
    let page = page();
    let code = page.split('`').skip(1).step_by(2);
    let named: Vec<&str> = code
        .filter_map(|code| code.strip_prefix("tremolite verify "))
        .flat_map(str::split_whitespace)
        .collect();
    assert!(!named.is_empty());
    for name in named {
        assert!(PROBLEMS.iter().any(|p| p.name == name), "{name}");
    }
}
