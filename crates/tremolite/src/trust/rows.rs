//! The check of rows that lie too far apart to show the peaks.

use crate::evidence::Evidence;
use crate::observers::Extremes;
use crate::trust::on_broken_elements;
use std::collections::HashMap;
use tremolite_kernels::Line;
use tremolite_results::{Said, TrustLine, said};

/// Part of a peak that rows may miss: in a hall under a pulse of 4 Hz rows 0.02 s apart miss 5 % of the largest stress of its monitors,
/// and rows 0.1 s apart nearly all of it.
pub(crate) const MISSED: f64 = 0.05;
const ID: &str = "output_sampling";
/// What is judged: accelerations of single steps ring where something cracks or knocks, and so does stress; that of the strain counts
/// where nothing was dissipated.
const JUDGED: [&[&str]; 2] = [&["vx", "vy", "vz"], &["s1_elastic"]];

pub(super) fn line(evidence: &Evidence) -> TrustLine {
    let name = said!("largest share of a peak that the rows of the histories miss");
    let Evidence { plan, outcome, histories, .. } = evidence;
    let (_, loose) = on_broken_elements(evidence);
    // By name, as there may be ten thousand monitors; of equal names the first.
    let columns = histories.columns.iter().zip(&histories.values).rev();
    let columns: HashMap<&str, &[f64]> =
        columns.map(|(column, values)| (column.name.as_str(), &values[..])).collect();
    let mut worst: Option<(f64, String, f64, f64)> = None;
    let dissipated = evidence.energy.column(Line::Dissipated.name()).and_then(|column| column.last());
    let elastic = dissipated.is_none_or(|joule| *joule == 0.0);
    for monitor in plan.monitors.iter().filter(|monitor| !loose.contains(&monitor.name.as_str())) {
        for quantities in &JUDGED[..if elastic { 2 } else { 1 }] {
            let sizes = quantities.iter().filter_map(|quantity| {
                let of_steps = Extremes::of(&outcome.state.observers, plan, &monitor.name, quantity)?;
                let column = columns.get(&*format!("{}.{quantity}", monitor.name))?;
                // Of s1_elastic tension counts.
                let size = |x: f64| if *quantity == "s1_elastic" { x } else { x.abs() };
                let peak = |first: usize, every: usize| {
                    let rows = column.iter().skip(first).step_by(every).filter(|x| x.is_finite());
                    rows.map(|x| size(*x)).fold(0.0, f64::max)
                };
                // Half the rows miss at least as much again of what more of them would show; of the spike of a step, nothing.
                let thinned = peak(0, 1) - peak(0, 2).min(peak(1, 2));
                let of_steps = of_steps.max.max(size(of_steps.min));
                Some((*quantity, peak(0, 1), of_steps, thinned.min(of_steps - peak(0, 1))))
            });
            let sizes: Vec<(&str, f64, f64, f64)> = sizes.collect();
            // A component that hardly moves beside the others tells nothing.
            let largest = sizes.iter().map(|size| size.2).fold(0.0, f64::max);
            for (quantity, rows, steps, missed) in sizes {
                let missed = missed / largest;
                if largest > 0.0 && worst.as_ref().is_none_or(|worst| missed > worst.0 || missed.is_nan()) {
                    worst = Some((missed, format!("{}.{quantity}", monitor.name), rows, steps));
                }
            }
        }
    }
    let none = |why: Said| TrustLine::not_applicable(ID, name.clone(), why);
    let Some((missed, history, rows, steps)) = worst else {
        return none(said!("all monitors that move are on broken elements"));
    };
    TrustLine::at_most(ID, name, missed.max(0.0), MISSED, "")
        .with("rows", rows)
        .with("steps", steps)
        .with("interval", outcome.steps.histories as f64 * outcome.dt)
        .with_note(said!(
            "{history}: rows {interval} s apart show {rows} where a step has {steps}, in SI; largest stresses, section forces and crack \
             widths are taken from rows as well: give a shorter `output.histories`",
            history = history,
            interval = format!("{:.3e}", outcome.steps.histories as f64 * outcome.dt),
            rows = format!("{rows:.3e}"),
            steps = format!("{steps:.3e}"),
        ))
}
