//! How a run would be shared out to several ranks.

use crate::terminal::{bytes, print, sent};
use tremolite::Division;
use tremolite::job::Job;

/// Rows of a table at most; beyond, the extremes say enough.
const ROWS: usize = 16;

pub fn print_lines(job: &Job, ranks: u32) {
    let Job { model, assembly, phase, survey, .. } = job;
    let division = Division::along_a_curve(model, assembly, ranks);
    let traffic = phase.traffic(model, assembly, &division);
    let whole: f64 = division.weights.iter().sum();
    print(&format!("ranks {ranks}"));
    let imbalance = 100.0 * (division.imbalance() - 1.0);
    print(&format!(
        "  the one with most work has {imbalance:.1} % more than the mean; parts that crack shift it"
    ));
    let moved: usize = traffic.iter().map(|one| one.nodes).sum();
    let again = 100.0 * (moved as f64 / model.nodes.len() as f64 - 1.0);
    print(&format!("  {again:.1} % of the nodes are moved by one rank more"));
    let [most, mean] = [
        traffic.iter().map(|one| one.bytes).fold(0.0, f64::max),
        traffic.iter().map(|one| one.bytes).sum::<f64>() / f64::from(ranks),
    ];
    print(&format!("  sent in a step: {} by a rank in the mean, {} at most", sent(mean), sent(most)));
    print(&format!("  each rank holds the whole model and room for its state, {}", bytes(survey.bytes)));
    let empty = division.weights.iter().filter(|weight| **weight == 0.0).count();
    if empty > 0 {
        print(&format!("  {empty} ranks have no elements: there are {} patches", model.patches.len()));
    }
    if traffic.len() <= ROWS {
        print("  rank   work    nodes  neighbours  sent in a step");
        for (rank, (one, weight)) in traffic.iter().zip(&division.weights).enumerate() {
            print(&format!(
                "  {rank:4}  {:4.1} %  {:7}  {:10}  {:>14}",
                100.0 * weight / whole,
                one.nodes,
                one.neighbours,
                sent(one.bytes)
            ));
        }
    }
}
