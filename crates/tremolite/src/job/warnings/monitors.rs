//! Monitors that lie far from what they are to follow, and bolts that are not whole.

use crate::plan::Plan;
use crate::support;
use tremolite_case::{Case, Diagnostic};
use tremolite_engine::{Model, Stage};
use tremolite_results::BoltPlace;

/// Distance \[m\] of a monitor from its pair or its segment that goes without saying: less than a lining's thickness or an element. Pairs
/// that lie further apart than that may be as far away as they are apart, for a point on the interface lies between them.
const FAR: f64 = 1.0;

/// Of monitors on interfaces that lie far from them.
pub fn of_pairs(case: &Case, model: &Model, plan: &Plan) -> Vec<Diagnostic> {
    let written = case.monitors.iter().filter(|monitor| monitor.interface.is_some());
    written
        .zip(&plan.pairs)
        .filter_map(|(written, monitor)| {
            let seam = &model.seams[monitor.interface];
            let pair = seam.nearest(&model.mesh, monitor.point);
            let at = seam.place(&model.mesh, pair);
            let away = (0..3).map(|i| (at[i] - monitor.point[i]).powi(2)).sum::<f64>().sqrt();
            let [x, y, z] = at;
            let apart = seam.pairs[pair].area.sqrt();
            (away > FAR.max(apart)).then(|| {
                let name = &monitor.name;
                Diagnostic::at(
                    &written.at,
                    format!("monitor {name} is {away:.1} m from '{}': it takes the pair at ({x:.1}, {y:.1}, {z:.1}) m", seam.name),
                    "give a point on the interface, if another is meant",
                )
            })
        })
        .collect()
}

/// Of groups of bolts that are not whole, and of monitors that lie far from their bolt.
pub fn of_bolts(case: &Case, model: &Model, plan: &Plan) -> Vec<Diagnostic> {
    // A group is placed by a stage; the first of the model's is the initial equilibrium.
    let stage = |name: &str| {
        let set = model.bolts.iter().find(|set| set.kind.name == name)?;
        match set.kind.born {
            Stage::Before(k) => {
                case.stages.get(usize::from(k).checked_sub(1)?).map(|stage| stage.span.clone())
            }
            Stage::Shaking => None,
        }
    };
    let span = |name: &str| stage(name).unwrap_or_else(|| case.title.span.clone());
    let groups = support::bolts(&model.bolts, plan, None, &|_, _| Vec::new(), &[]);
    let warnings = support::warnings(&groups).into_iter();
    let mut problems: Vec<Diagnostic> =
        warnings.map(|(name, message, remedy)| Diagnostic::new(span(&name), message, remedy)).collect();
    let places = support::monitors(&model.bolts, plan);
    for monitor in &plan.bolts {
        let Some(written) = case.monitors.iter().find(|written| written.name.value == monitor.name) else {
            continue;
        };
        let (message, remedy) = match places.get(&monitor.name) {
            None => (
                format!(
                    "monitor {} has no bolt: there is none in '{}'",
                    monitor.name, model.bolts[monitor.set].kind.name
                ),
                "leave it out, or see why there is none",
            ),
            Some(BoltPlace { bolt, group, at: [x, y, z], .. }) => {
                let away = model.bolts[monitor.set].distance(monitor.point);
                if away <= FAR {
                    continue;
                }
                (
                    format!(
                        "monitor {} is {away:.1} m from '{group}': it takes bolt {bolt} at ({x:.1}, {y:.1}, {z:.1}) m",
                        monitor.name
                    ),
                    "give a point on the bolt, if another is meant",
                )
            }
        };
        problems.push(Diagnostic::at(&written.at, message, remedy));
    }
    problems
}
