//! Soil of `motion.site.layers` that softens: the moduli and damping that go with the strain of the record.

use super::facts::SoilFacts;
use crate::deconvolution::{Cut, Place};
use crate::equivalent_linear::{
    CurveTable, Curves, Darendeli, Given, Rock, Search, Soil, Unfit, fit_together,
};
use crate::layered_column::Layer;
use tremolite_case::{self as case, Diagnostic, SiteLayer, Softening};
use tremolite_motion::Motion;

/// Times that moduli are found anew because the band that the record is let through changed with them.
const ROUNDS: usize = 5;

/// Whether any of the layers softens.
pub fn softens(layers: &[SiteLayer]) -> bool {
    layers.iter().any(|layer| !layer.softening.is_none())
}

/// What of a record is deconvolved: its samples and up to which frequency it is wanted \[Hz\].
pub struct Recorded<'a> {
    pub motion: &'a Motion,
    pub band: f64,
}

/// Layers from the surface down with the velocity and the damping that fit the strain that a record of their surface strains them by, and
/// what they came to. `place` makes the place of the record of such layers; `rock` is what lies below.
///
/// The strain is that of both horizontal components together, so it does not depend on the axes. It counts what is let through when
/// the record is deconvolved, no more, since what a surface shows above that is not known to come from below.
///
/// # Errors
/// Curves that are none, and ground for which there is no such column, at their places in the case.
pub fn fitted(
    motion: &case::Motion,
    layers: &[SiteLayer],
    rock: &Layer,
    recorded: &Recorded,
    place: &dyn Fn(&[SoilFacts]) -> Option<Place>,
) -> Result<Vec<SoilFacts>, Diagnostic> {
    let soils: Vec<Soil> = layers
        .iter()
        .map(|layer| {
            Ok(Soil {
                thickness: layer.thickness.value,
                density: layer.density.value,
                speed: layer.shear_wave_velocity.value,
                curves: curves(layer)?,
            })
        })
        .collect::<Result<_, _>>()?;
    let rock = Rock { density: rock.density, speed: rock.speed };
    let across = [&recorded.motion.acceleration[0][..], &recorded.motion.acceleration[1][..]];
    let dt = recorded.motion.dt;
    let mut cut = Cut::NONE;
    let mut found = Vec::new();
    for _ in 0..ROUNDS {
        let kept = |hertz: f64| cut.kept(hertz);
        let fitted = fit_together(&soils, rock, &across, dt, Given::Surface, Search::default(), &kept)
            .map_err(|unfit| refused(motion, layers, &unfit))?;
        found = fitted
            .layers
            .iter()
            .zip(layers)
            .map(|(reached, layer)| SoilFacts {
                thickness: layer.thickness.value,
                speed: layer.shear_wave_velocity.value * reached.modulus.sqrt(),
                strain: reached.strain,
                modulus: reached.modulus,
                damping: reached.damping,
            })
            .collect();
        let Some(place) = place(&found) else { break };
        // What cannot be inverted is refused where the record is deconvolved, with the frequency.
        let Ok(now) = place.cut(0, dt, recorded.band) else { break };
        let near = |a: f64, b: f64| a == b || (a - b).abs() <= 1e-3 * a.abs().max(b.abs());
        if near(now.end, cut.end) && near(now.reach, cut.reach) {
            break;
        }
        cut = now;
    }
    Ok(found)
}

fn refused(motion: &case::Motion, layers: &[SiteLayer], unfit: &Unfit) -> Diagnostic {
    match unfit {
        Unfit::Strained { layer, strain } => Diagnostic::at(
            &layers[*layer].shear_wave_velocity,
            format!(
                "the record shears this layer by {:.2} %, and soil is no linear column beyond {:.1} %",
                100.0 * strain,
                100.0 * crate::equivalent_linear::MOST_STRAIN
            ),
            "look whether the record's unit and scale and this velocity are meant so; else give a record of rock (\"outcrop\") and the \
             soil as a part of the model, with a law that yields",
        ),
        Unfit::Restless { change } => Diagnostic::new(
            motion.span.clone(),
            format!(
                "no moduli of the layers of motion.site go with the strain of the record: in the last round they still changed by {:.2} %",
                100.0 * change
            ),
            "divide thick layers, or give velocities and damping ratios that stay",
        ),
        Unfit::Nothing => Diagnostic::new(
            motion.span.clone(),
            "layers of motion.site soften by the strain of shear waves, and the motion has no horizontal component",
            "give one, or layers with `damping` in place of curves",
        ),
    }
}

fn curves(layer: &SiteLayer) -> Result<Curves, Diagnostic> {
    let place = &layer.thickness;
    Ok(match &layer.softening {
        Softening::None(damping) => Curves::Linear(damping.value),
        Softening::Darendeli { plasticity_index, stress, overconsolidation, frequency, cycles } => {
            let curves = Darendeli {
                frequency: *frequency,
                cycles: *cycles,
                ..Darendeli::new(*plasticity_index, *overconsolidation, *stress)
            };
            // The formula's logarithm of frequency makes it negative for very slow shaking.
            if curves.least_damping() <= 0.0 {
                return Err(Diagnostic::at(
                    place,
                    format!("shaking of {frequency} Hz would not be damped at all by these curves, which were fitted between 0.03 and 100 Hz or so"),
                    "leave `frequency` out: it is 1 Hz then",
                ));
            }
            Curves::Darendeli(curves)
        }
        Softening::VuceticDobry(index) => Curves::vucetic_dobry(*index).ok_or_else(|| {
            Diagnostic::at(place, format!("there are no curves for a plasticity index of {index} %"), "give one from 0 to 200")
        })?,
        Softening::Table { rows, span } => CurveTable::new(rows.clone()).map(Curves::Table).map_err(|wrong| {
            Diagnostic::new(
                span.clone(),
                format!("these are no curves: {wrong}"),
                "give as many numbers in `strain`, `modulus` and `damping`: strains that rise, moduli that fall from 1 at most, damping \
                 ratios below 0.5",
            )
        })?,
    })
}
