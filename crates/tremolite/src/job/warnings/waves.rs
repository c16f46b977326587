//! Whether the step is stable and the mesh fine enough for what comes in.

use crate::places::element;
use crate::survey::Survey;
use crate::trust::PER_WAVELENGTH;
use tremolite_case::{Case, Diagnostic, Fill, units};
use tremolite_engine::{Model, StableStep};
use tremolite_laws::Dimension;

/// Of a given time step above the stable one: the run will be stopped as soon as energy appears.
pub fn of_step(case: &Case, stable: &StableStep) -> Option<Diagnostic> {
    case.motion.as_ref()?;
    let impacts = stable.contact.map_or(f64::INFINITY, |contact| contact.dt);
    if let Some(given) = &case.dynamic.time_step
        && given.value <= stable.dt
        && given.value > impacts
    {
        return Some(Diagnostic::at(
            given,
            format!(
                "{} is longer than impacts at interfaces allow, {}: they may gain energy",
                units::format(given.value, Dimension::TIME),
                units::format(impacts, Dimension::TIME)
            ),
            "give a shorter one, a softer `normal_stiffness`, or a larger `contact_limit` if that is meant",
        ));
    }
    let given = case.dynamic.time_step.as_ref().filter(|given| given.value > stable.dt)?;
    let step = |t: f64| units::format(t, Dimension::TIME);
    Some(Diagnostic::at(
        given,
        format!(
            "{} is above the stable step of {}: the run will become unstable and be stopped",
            step(given.value),
            step(stable.dt)
        ),
        format!("give {} or less, or leave time_step out", step(0.9 * stable.dt)),
    ))
}

/// Of rows of the histories that are asked for more often than steps are made.
pub fn of_rows(case: &Case, dt: f64) -> Option<Diagnostic> {
    case.motion.as_ref()?;
    let rows = &case.output.histories;
    (rows.value < dt).then(|| {
        let time = |t: f64| units::format(t, Dimension::TIME);
        Diagnostic::at(
            rows,
            format!(
                "rows {} apart are closer than the finest step of {}: every step is a row",
                time(rows.value),
                time(dt)
            ),
            "give a longer interval, such as \"5 ms\": a row at every step makes large tables and leaves one step for all elements",
        )
    })
}

/// Elements a wavelength below which waves are not carried but distorted.
const FEWEST: f64 = 5.0;
/// How much below the limit of the run's check is worth a word: more than its round-off.
const ROUND_OFF: f64 = 1e-6;

/// Of regions too coarse for the motion's waves.
pub fn of_waves(case: &Case, model: &Model, survey: &Survey) -> Vec<Diagnostic> {
    let solid = case.regions.iter().filter(|region| matches!(region.fill, Fill::Solid { .. }));
    solid
        .zip(&survey.bodies)
        .filter(|(_, body)| body.per_wavelength < PER_WAVELENGTH * (1.0 - ROUND_OFF))
        .map(|(region, body)| {
            let then = match body.per_wavelength < FEWEST {
                true => "it will not arrive as it was",
                false => "a check of the run asks for 8 and will fail",
            };
            Diagnostic::new(
                region.span.clone(),
                format!(
                    "a shear wave of the motion's highest frequency has {:.1} elements in {}: {then}",
                    body.per_wavelength,
                    element(model, body.coarsest as usize)
                ),
                "make elements smaller, or take the highest frequencies out with \"lowpass\"; 8 elements and more are good",
            )
        })
        .collect()
}
