//! The figure and the table of docs/clusters.md are what the model of scaling gives.

#[path = "../../examples/scaling_figure.rs"]
#[allow(dead_code)]
mod example;

use std::path::Path;

#[test]
fn the_page_of_clusters_shows_what_the_model_of_scaling_gives() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let page = std::fs::read_to_string(docs.join("clusters.md")).unwrap();
    for row in example::rows() {
        assert!(page.lines().any(|line| line == row), "missing on the page:\n{row}");
    }
    let found = std::fs::read_to_string(docs.join("clusters").join(example::FIGURE)).unwrap();
    assert!(found == example::figure(), "run cargo run --release -p tremolite-cli --example scaling_figure");
    assert!(page.contains(&format!("(clusters/{})", example::FIGURE)));
}
