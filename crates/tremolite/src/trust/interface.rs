//! Checks of interfaces.

use super::seam;
use crate::evidence::Evidence;
use tremolite_kernels::Line;
use tremolite_results::{Said, TrustLine, said};

/// Energy that interface laws may create, over what friction took.
const CREATED: f64 = 0.05;
/// Where nothing slid: over all that was supplied, the limit of the balance's own error.
const UNSEEN: f64 = 5e-4;

fn unstressed_name() -> Said {
    said!("interfaces without initial stress")
}

fn created_name() -> Said {
    said!("energy created by interface laws over energy dissipated by friction")
}

/// Checks of the shaking alone.
const OF_SHAKING: [&str; 4] =
    ["energy_created_by_interfaces", "contact_energy_error", "contact_frequency_step", "interface_ringing"];

pub(super) fn lines(evidence: &Evidence) -> Vec<TrustLine> {
    let mut lines = all(evidence);
    let of_shaking = |line: &TrustLine| OF_SHAKING.iter().any(|id| line.id.starts_with(id));
    lines.retain(|line| evidence.outcome.shaken || !of_shaking(line));
    lines
}

fn all(evidence: &Evidence) -> Vec<TrustLine> {
    let Evidence { model, .. } = evidence;
    if model.user_seams().is_empty() {
        let line = |(id, name)| TrustLine::not_applicable(id, name, said!("no interface"));
        return [
            ("interface_without_initial_stress", unstressed_name()),
            ("energy_created_by_interfaces", created_name()),
            ("interface_closure", said!("largest closure of the interface over its limit")),
            ("interface_slip", said!("largest slip over element size")),
            ("interface_gap", said!("largest gap over element size")),
            (
                "contact_above_pressure_limit",
                said!("interface pairs under more pressure than pressure_for_step"),
            ),
            ("contact_energy_error", said!("energy error of impacts over energy supplied")),
            ("contact_frequency_step", said!("time step × frequency of the stiffest contact pair")),
            ("interface_ringing", seam::ringing_name()),
            (
                "contact_penalty_compliance",
                said!("compliance of the interface over that of the adjacent elements"),
            ),
        ]
        .map(line)
        .into();
    }
    let mut lines = vec![unstressed(evidence), created(evidence)];
    lines.extend((0..model.user_seams().len()).flat_map(|number| seam::of(evidence, number)));
    lines
}

/// Friction, and whether a joint is closed at all, go by the pressure that is there before.
fn unstressed(evidence: &Evidence) -> TrustLine {
    const ID: &str = "interface_without_initial_stress";
    if !evidence.model.elements.initial.is_empty() {
        return TrustLine::not_applicable(
            ID,
            unstressed_name(),
            said!("the ground begins with initial stress"),
        );
    }
    let names: Vec<&str> = evidence.model.user_seams().iter().map(|seam| seam.name.as_str()).collect();
    let line = TrustLine::at_most(ID, unstressed_name(), names.len() as f64, 0.0, "");
    line.with_note(said!(
        "{names}: no initial stress presses the two sides together, so they part and slide earlier and further than they would in the ground; an interface without a bond opens with the first motion",
        names = names.join("; "),
    ))
}

fn created(evidence: &Evidence) -> TrustLine {
    let column = |line: Line| evidence.energy.column(line.name()).unwrap_or(&[]);
    let mut least = 0.0_f64;
    // Its largest rise: what was taken before does not pay for what is given out later.
    let created = column(Line::CreatedByInterface).iter().fold(0.0_f64, |most, &now| {
        least = least.min(now);
        most.max(now - least)
    });
    let friction = column(Line::Friction).iter().copied().fold(0.0, f64::max);
    const ID: &str = "energy_created_by_interfaces";
    if created == 0.0 && friction == 0.0 {
        return TrustLine::not_applicable(ID, created_name(), said!("nothing slid or opened"));
    }
    let supplied = evidence.outcome.state.ledger.supplied;
    if friction == 0.0 && created <= UNSEEN * supplied {
        let share = created / supplied;
        let why = said!(
            "nothing slid, and pairs gave out {share} of all energy supplied",
            share = format!("{share:.0e}"),
        );
        let line = TrustLine::not_applicable(ID, created_name(), why);
        return line.with("created", created).with("supplied", supplied);
    }
    TrustLine::at_most(ID, created_name(), created / friction, CREATED, "")
        .with("created", created)
        .with("friction_coefficient", friction)
        .with_note(said!(
            "largest rise of what pairs gave out whose shear stiffness goes by the closure; tangential = \"constant\" cannot"
        ))
}
