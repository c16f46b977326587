//! Checks of what comes in and how the ground carries it.

use crate::evidence::Evidence;
use crate::observers::FreeFieldSeen;
use tremolite_engine::Side;
use tremolite_results::TrustLine;

/// Elements a wavelength below which a wave's amplitude and speed suffer (Kuhlemeyer & Lysmer 1973).
const PER_WAVELENGTH: f64 = 8.0;
/// Difference of the column's velocity from theory, over its peak.
const THEORY: f64 = 0.05;
/// Difference of the model's velocity at its corners from the column's, over its peak: what sides and caverns make of the
/// free field there.
const CORNERS: f64 = 0.1;
/// Displacement of the input at its end over its peak.
pub(crate) const DRIFT: f64 = 0.1;

pub(super) fn per_wavelength(evidence: &Evidence) -> TrustLine {
    const ID: &str = "elements_per_wavelength";
    const NAME: &str = "elements per shortest wavelength";
    let Evidence { model, survey, .. } = evidence;
    let (Some(coarsest), Some(motion)) = (survey.coarsest(), evidence.motion) else {
        return TrustLine::not_applicable(ID, NAME, "no wave comes in");
    };
    TrustLine::at_least(ID, NAME, coarsest.per_wavelength, PER_WAVELENGTH, "")
        .with("frequency", motion.highest_frequency)
        .with("element", model.mesh.element_id(coarsest.coarsest as usize) as f64)
        .with_note(format!(
            "shear waves of {:.1} Hz (99.9 % of the input's energy lies below) along the longest edge of {}",
            motion.highest_frequency,
            model.element_name(coarsest.coarsest as usize)
        ))
}

pub(super) fn drift(evidence: &Evidence) -> TrustLine {
    const ID: &str = "input_drift";
    const NAME: &str = "input displacement at its end over its peak";
    let Some(incident) = &evidence.model.incident else {
        return TrustLine::not_applicable(ID, NAME, "no wave comes in");
    };
    TrustLine::at_most(ID, NAME, incident.motion.drift(), DRIFT, "").with_note(
        "a large value is drift of the record, which the model follows: put \"baseline\" last in motion.process, behind \
         filter and taper",
    )
}

/// The reference column against theory, and the model's corners against the column.
pub(super) fn free_field(evidence: &Evidence) -> Vec<TrustLine> {
    const ID: &str = "free_field_theory";
    const NAME: &str = "free field against theory";
    const MODEL_ID: &str = "model_against_free_field";
    const MODEL_NAME: &str = "model's corners against free field";
    let both = |why: &str| {
        vec![TrustLine::not_applicable(ID, NAME, why), TrustLine::not_applicable(MODEL_ID, MODEL_NAME, why)]
    };
    let Evidence { model, outcome, .. } = evidence;
    if model.incident.is_none() {
        return both("no wave comes in");
    }
    if model.columns.is_empty() {
        let why = format!("there is no reference column: {}", model.no_column);
        let mut lines = both(&why);
        // Periodic sides leave uniform motion alone. What others make of it cannot be told here, and that is no pass.
        if model.sides.iter().any(|side| !matches!(side, Side::Periodic | Side::FreeField)) {
            lines[1] = TrustLine::at_most(MODEL_ID, MODEL_NAME, f64::NAN, CORNERS, "").with_note(format!(
                "cannot be checked, since {why}; and such sides may spoil the free field altogether"
            ));
        }
        return lines;
    }
    let Some(seen) = FreeFieldSeen::of(&outcome.state.observers) else {
        return both("no row was written");
    };
    let theory = match seen.theory {
        None => TrustLine::not_applicable(ID, NAME, "theory is that of homogeneous ground, and this is layered"),
        Some(_) if seen.damaged => {
            let why = "the rock of the reference column yields or cracks, and theory is elastic";
            TrustLine::not_applicable(ID, NAME, why)
        }
        Some(theory) if theory.seen < 0.5 * theory.peak => {
            TrustLine::not_applicable(ID, NAME, "the rows of the histories are too few to show the wave")
        }
        Some(theory) => TrustLine::at_most(ID, NAME, theory.difference / theory.peak, THEORY, "")
            .with("difference", theory.difference)
            .with("peak", theory.peak)
            .with_note("velocity at the top of the reference column against one-dimensional theory, damping included"),
    };
    let [surface, base] = seen.corners;
    let model = if seen.peak == 0.0 {
        TrustLine::not_applicable(MODEL_ID, MODEL_NAME, "nothing has reached the reference column")
    } else {
        TrustLine::at_most(MODEL_ID, MODEL_NAME, surface.max(base) / seen.peak, CORNERS, "")
            .with("surface", surface)
            .with("base", base)
            .with("peak", seen.peak)
            .with_note(
                "velocity of the model's own surface and base at its four corners against the reference column's, over that \
                 one's peak: sides that hold or drain the free field, or caverns too near to them: make `sides` wider",
            )
    };
    vec![theory, model]
}
