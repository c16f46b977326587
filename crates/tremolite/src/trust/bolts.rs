//! Checks of bolts that slide, each of all groups together.

use crate::evidence::Evidence;
use crate::observers::BoltForces;
use crate::phrases::clauses;
use crate::support::{look, seen};
use tremolite_engine::hexahedra::hex;
use tremolite_results::{Said, TrustLine, said};

/// Slip over the size of the element beside it: a bolt's direction and the elements it lies in do not change.
const SLIP: f64 = 0.1;
const SLIP_ID: &str = "bolt_slip";
/// Out of balance along a bolt over its group's largest force: a thousandth of what an engineer reads off, far above round-off.
const BALANCED: f64 = 1e-6;
const BALANCE_ID: &str = "bond_equilibrium_error";
/// A largest force \[N\] below which none is meant.
const LEAST: f64 = 1.0;

pub(super) fn lines(evidence: &Evidence) -> Vec<TrustLine> {
    let bonded = evidence.model.bolts.iter().any(|set| set.kind.bond.is_some() && !set.bolts.is_empty());
    if !bonded {
        let none = |id, name| TrustLine::not_applicable(id, name, said!("no bolts with a bond"));
        return vec![none(SLIP_ID, slip_name()), none(BALANCE_ID, balance_name())];
    }
    vec![slip(evidence), balance(evidence)]
}

fn slip_name() -> Said {
    said!("largest slip of bolts over element size")
}

fn balance_name() -> Said {
    said!("bond force beyond strength over the largest bolt force")
}

/// The largest of some shares, with what else is to be said of it and the bolt: group and number.
#[derive(Default)]
struct Worst {
    share: f64,
    value: f64,
    bolt: Option<(String, u32)>,
}

impl Worst {
    fn take(&mut self, share: f64, value: f64, group: &str, bar: u32) {
        // A share that is no number is the worst.
        if share > self.share || share.is_nan() {
            *self = Worst { share, value, bolt: Some((group.to_owned(), bar + 1)) };
        }
    }

    /// A check with the bolt that it is of, before what is to be said.
    fn told(&self, line: TrustLine, what: Said) -> TrustLine {
        let Some((group, bolt)) = &self.bolt else { return line.with_note(what) };
        let at = said!("bolt {bolt} of {group}", bolt = bolt.to_string(), group = group);
        line.with("bolt", f64::from(*bolt)).with_note(clauses([at, what]))
    }
}

fn slip(evidence: &Evidence) -> TrustLine {
    let Evidence { model, assembly, outcome, .. } = evidence;
    let mut worst = Worst::default();
    let stage = outcome.stage();
    let seen = stage.map(|stage| seen(&model.bolts, stage, &look(assembly, &outcome.state.numbers)));
    for (s, set) in model.bolts.iter().enumerate().filter(|(_, set)| set.kind.bond.is_some()) {
        for (bolt, seen) in set.bolts.iter().zip(seen.iter().flat_map(|seen| &seen[s])) {
            let hosts = bolt.points.iter().filter_map(|point| hex(&model.mesh, point.host as usize).ok());
            let size = hosts.map(|hex| hex.volume.cbrt()).fold(f64::INFINITY, f64::min);
            worst.take(seen.slip / size, seen.slip, &set.kind.name, bolt.bar);
        }
    }
    let line = TrustLine::at_most(SLIP_ID, slip_name(), worst.share, SLIP, "").with("slip", worst.value);
    worst.told(
        line,
        said!(
            "of any step, over the smallest element that the bolt lies in: a bolt keeps its direction and stays in the elements that it first crossed, so slip must stay small"
        ),
    )
}

/// What of bolts' forces no law answers for: there was no balance along the bolt.
fn balance(evidence: &Evidence) -> TrustLine {
    let Evidence { model, assembly, plan, outcome, .. } = evidence;
    let numbers = &outcome.state.numbers;
    let peaks = BoltForces::peaks(&model.bolts, plan, &outcome.state.observers);
    let mut worst = Worst::default();
    let sets = model.bolts.iter().zip(&assembly.bolts).zip(&peaks);
    for ((set, bolting), (peak, _)) in sets.filter(|((set, _), _)| set.kind.bond.is_some()) {
        let force = peak.force.abs().max(LEAST);
        for (b, bolt) in set.bolts.iter().enumerate() {
            let (rest, _) = bolting.unsettled(numbers, b);
            worst.take(rest / force, rest, &set.kind.name, bolt.bar);
        }
    }
    let line =
        TrustLine::at_most(BALANCE_ID, balance_name(), worst.share, BALANCED, "").with("force", worst.value);
    worst.told(
        line,
        said!(
            "force of bonds beyond their strength, in any step since the bolt was placed, over the largest force of its group: above round-off a bolt found no equilibrium, as one that is pulled out"
        ),
    )
}
