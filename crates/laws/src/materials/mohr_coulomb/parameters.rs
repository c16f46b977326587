//! The Mohr–Coulomb law's parameters: what a case may say, and how it becomes numbers.

use super::softening::Softening;
use super::{MohrCoulomb, Strength};
use crate::materials::elastic::{POISSON, YOUNG};
use crate::materials::plastic::Elasticity;
use crate::materials::plastic::parameters::{
    COHESION, DILATION_ANGLE, FRICTION_ANGLE, Reading, number, slope,
};
use crate::parameter::{BadParameter, Dimension, Need, Parameter, Values};

pub(super) const PARAMETERS: &[Parameter] = &[
    YOUNG,
    POISSON,
    COHESION,
    FRICTION_ANGLE,
    DILATION_ANGLE,
    number(
        "tensile_strength",
        Dimension::PRESSURE,
        Need::Number(0.0),
        "tension cut-off f_t, zero or more; cut at the apex c/tan φ",
    ),
    number(
        "residual_cohesion",
        Dimension::PRESSURE,
        Need::Optional("the cohesion stays"),
        "cohesion once softened, from 0 up to c",
    ),
    number(
        "residual_friction_angle",
        Dimension::ANGLE,
        Need::Optional("the friction angle stays"),
        "friction angle once softened, from 0 up to φ",
    ),
    number(
        "residual_tensile_strength",
        Dimension::PRESSURE,
        Need::Optional("the tensile strength stays"),
        "tension cut-off once softened, from 0 up to f_t",
    ),
    number(
        "softening_strain",
        Dimension::NONE,
        Need::Optional("strength stays"),
        "plastic shear strain at which the residual values are reached, in straight lines from the peak",
    ),
    number(
        "softening_tension_strain",
        Dimension::NONE,
        Need::Optional("f_t falls with the plastic shear strain alone"),
        "plastic tension strain at which f_t also reaches its residual value",
    ),
];

/// The three residual values, where any key of softening is given.
fn read_softening(reading: &mut Reading, peak: [f64; 3]) -> Option<Option<Softening>> {
    const KEYS: [&str; 3] = ["residual_cohesion", "residual_friction_angle", "residual_tensile_strength"];
    let mut pairs = [[0.0; 2]; 3];
    let mut given = false;
    for ((pair, key), peak) in pairs.iter_mut().zip(KEYS).zip(peak) {
        let residual = reading.optional(
            key,
            |x| (0.0..=peak).contains(&x),
            "from 0 up to the peak value",
            "strength can fall, not rise; leave the key out where it stays",
        )?;
        given |= residual.is_some();
        *pair = [peak, residual.unwrap_or(peak)];
    }
    let mut strain = |key| reading.optional(key, |x| x > 0.0, "positive", "1e-3 to 0.1 is usual");
    let (shear, tension) = (strain("softening_strain")?, strain("softening_tension_strain")?);
    let [cohesion, friction, tensile] = pairs;
    if cohesion[1] == 0.0 && friction[1] == 0.0 {
        reading.fault(
            "residual_cohesion",
            "leaves neither cohesion nor friction",
            "give a small residual cohesion or a residual friction angle",
        );
        return None;
    }
    match (given, shear) {
        (false, None) if tension.is_none() => Some(None),
        (true, Some(shear)) => Some(Some(Softening {
            cohesion,
            friction,
            tensile,
            per_shear: 1.0 / shear,
            per_tension: tension.map_or(0.0, |strain| 1.0 / strain),
        })),
        (true, None) => {
            reading.fault(
                "softening_strain",
                "is missing, though a residual strength is given",
                "give the plastic shear strain at which the residual strength is reached",
            );
            None
        }
        (false, _) => {
            let key = if shear.is_some() { "softening_strain" } else { "softening_tension_strain" };
            reading.fault(
                key,
                "is given without any residual strength",
                "give residual_cohesion, residual_friction_angle or residual_tensile_strength, or leave it out",
            );
            None
        }
    }
}

pub(super) fn read(values: &Values) -> Result<MohrCoulomb, Vec<BadParameter>> {
    let mut reading = Reading::new(values, PARAMETERS);
    let moduli = reading.moduli();
    let envelope = reading.envelope();
    let tensile = reading.number(
        "tensile_strength",
        |x| x >= 0.0,
        "zero or positive",
        "tension is positive; 0 means that the rock carries none",
    );
    let mut build = || {
        let ([cohesion, friction, dilation], tensile) = (envelope?, tensile?);
        let softening = read_softening(&mut reading, [cohesion, friction, tensile])?;
        let flow = slope(dilation);
        Some(MohrCoulomb {
            elasticity: Elasticity::new(moduli?),
            flow,
            tensile,
            peak: Strength::new(slope(friction), cohesion, tensile, flow),
            softening,
        })
    };
    let law = build();
    match law {
        Some(law) if reading.faults.is_empty() => Ok(law),
        _ => Err(reading.faults),
    }
}
