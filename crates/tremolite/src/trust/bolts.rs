//! Checks of bolts.

use crate::evidence::Evidence;
use crate::support::{look, seen};
use tremolite_engine::bolts::BoltSet;
use tremolite_engine::hexahedra::hex;
use tremolite_results::{TrustLine, snake};

/// Slip over the size of the element beside it: a bolt's direction and the elements it lies in do not change.
const SLIP: f64 = 0.1;
const NAME: &str = "largest slip of bolts over element size";
const ID: &str = "bolt_slip";
/// Out of balance along a bolt over its largest force: a thousandth of what an engineer reads off, far above round-off.
const BALANCED: f64 = 1e-6;
const BALANCE_NAME: &str = "force along bolts without a law over their largest";
const BALANCE_ID: &str = "bolt_balance";

pub(super) fn lines(evidence: &Evidence) -> Vec<TrustLine> {
    let Evidence { model, assembly, outcome, .. } = evidence;
    let bonded = model.bolts.iter().enumerate().filter(|(_, set)| set.kind.bond.is_some());
    let Some(stage) = outcome.stage() else { return Vec::new() };
    let seen = seen(&model.bolts, stage, &look(assembly, &outcome.state.numbers));
    let line = |(s, set): (usize, &BoltSet)| {
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
    let mut lines: Vec<TrustLine> = bonded.clone().map(line).collect();
    if lines.is_empty() {
        let none = |id, name| TrustLine::not_applicable(id, name, "no bolts with a bond");
        return vec![none(ID, NAME), none(BALANCE_ID, BALANCE_NAME)];
    }
    lines.extend(bonded.map(|(s, set)| balance(evidence, s, set)));
    lines
}

/// What of a bolt's force no law answers for, where its sliders did not settle.
fn balance(evidence: &Evidence, s: usize, set: &BoltSet) -> TrustLine {
    let Evidence { assembly, outcome, .. } = evidence;
    let (bolting, numbers) = (&assembly.bolts[s], &outcome.state.numbers);
    let (mut rest, mut passes, mut force) = ((0.0_f64, 0), 0, 0.0_f64);
    for (b, bolt) in set.bolts.iter().enumerate() {
        let (of_bolt, most) = bolting.unsettled(numbers, b);
        if of_bolt > rest.0 || of_bolt.is_nan() {
            rest = (of_bolt, bolt.bar + 1);
        }
        passes = passes.max(most);
        let forces =
            bolting.seen(numbers, b).into_iter().map(|seen| seen.largest_force.max(seen.force.abs()));
        force = forces.fold(force, f64::max);
    }
    let share = if rest.0 == 0.0 { 0.0 } else { rest.0 / force };
    let line = TrustLine::at_most(
        format!("{BALANCE_ID}_{}", snake(&set.kind.name)),
        &format!("{BALANCE_NAME}, {}", set.kind.name),
        share,
        BALANCED,
        "",
    );
    let at = if rest.1 > 0 { format!("most at bolt {}; ", rest.1) } else { String::new() };
    line.with("force", rest.0).with("passes", f64::from(passes)).with_note(format!(
        "{at}what sliders carry beyond their strength where {passes} passes did not settle them, in any step since they were \
         placed, over the largest force of the group; smaller steps, or a lower release a stage, settle them"
    ))
}
