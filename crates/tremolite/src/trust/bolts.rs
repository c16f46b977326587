//! Checks of bolts.

use crate::evidence::Evidence;
use crate::support::{look, seen};
use tremolite_engine::hexahedra::hex;
use tremolite_results::{TrustLine, snake};

/// Slip over the size of the element beside it: a bolt's direction and the elements it lies in do not change.
const SLIP: f64 = 0.1;
const NAME: &str = "largest slip of bolts over element size";
const ID: &str = "bolt_slip";

pub(super) fn lines(evidence: &Evidence) -> Vec<TrustLine> {
    let Evidence { model, assembly, outcome, .. } = evidence;
    let bonded = model.bolts.iter().enumerate().filter(|(_, set)| set.kind.bond.is_some());
    let Some(stage) = outcome.stage() else { return Vec::new() };
    let seen = seen(&model.bolts, stage, &look(assembly, &outcome.state.numbers));
    let line = |(s, set): (usize, &tremolite_engine::bolts::BoltSet)| {
        let mut worst = (0.0_f64, 0.0_f64, 0);
        for (bolt, seen) in set.bolts.iter().zip(&seen[s]) {
            let hosts = bolt.points.iter().filter_map(|point| hex(&model.mesh, point.host as usize).ok());
            let size = hosts.map(|hex| hex.volume.cbrt()).fold(f64::INFINITY, f64::min);
            let share = seen.slip / size;
            if share > worst.0 || share.is_nan() {
                worst = (share, seen.slip, bolt.bar + 1);
            }
        }
        let (share, slip, bolt) = worst;
        let line = TrustLine::at_most(
            format!("{ID}_{}", snake(&set.kind.name)),
            &format!("{NAME}, {}", set.kind.name),
            share,
            SLIP,
            "",
        );
        let note =
            "a bolt stays in the elements it was cut by and keeps its direction, so slip must stay small";
        let at =
            if bolt > 0 { format!("smallest element that bolt {bolt} lies in; ") } else { String::new() };
        line.with("slip", slip).with_note(format!("{at}{note}"))
    };
    let lines: Vec<TrustLine> = bonded.map(line).collect();
    if lines.is_empty() {
        return vec![TrustLine::not_applicable(ID, NAME, "no bolts with a bond")];
    }
    lines
}
