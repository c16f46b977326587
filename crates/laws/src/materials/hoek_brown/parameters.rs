//! The Hoek–Brown law's parameters: what a case may say, and how it becomes numbers.

use super::HoekBrown;
use super::envelope::Envelope;
use crate::materials::elastic::{POISSON, YOUNG};
use crate::materials::plastic::Elasticity;
use crate::materials::plastic::parameters::{ANGLES, is_angle, number, slope};
use crate::parameter::{BadParameter, Dimension, Need, Parameter, Reading, Values};

pub(super) const PARAMETERS: &[Parameter] = &[
    YOUNG,
    POISSON,
    number(
        "ucs",
        Dimension::PRESSURE,
        Need::Required,
        "σ_ci, uniaxial compressive strength of the intact rock",
    ),
    number(
        "gsi",
        Dimension::NONE,
        Need::Required,
        "GSI, geological strength index, from 5 to 100 (intact), e.g. 55",
    ),
    number("m_i", Dimension::NONE, Need::Required, "m_i of the intact rock, positive"),
    number(
        "disturbance",
        Dimension::NONE,
        Need::Number(0.0),
        "D, from 0 (undisturbed) to 1 (heavy blasting or stress relief)",
    ),
    number(
        "dilation_angle",
        Dimension::ANGLE,
        Need::Number(0.0),
        "dilation angle ψ, from 0 up to 89.9°; kept below the envelope's slope",
    ),
    number(
        "tensile_strength",
        Dimension::PRESSURE,
        Need::Optional("the apex s σ_ci/m_b"),
        "tension cut-off f_t, zero or more; cut at the apex",
    ),
];

/// m_b, s and a (hoek2002).
pub(super) fn constants(gsi: f64, m_i: f64, disturbance: f64) -> [f64; 3] {
    [
        m_i * ((gsi - 100.0) / (28.0 - 14.0 * disturbance)).exp(),
        ((gsi - 100.0) / (9.0 - 3.0 * disturbance)).exp(),
        0.5 + ((-gsi / 15.0).exp() - (-20.0f64 / 3.0).exp()) / 6.0,
    ]
}

pub(super) fn read(values: &Values) -> Result<HoekBrown, Vec<BadParameter>> {
    let mut reading = Reading::new(values, PARAMETERS);
    let moduli = reading.moduli();
    let ucs = reading.number("ucs", |x| x > 0.0, "positive", "for intact rock 5 to 300 MPa is usual");
    let gsi = reading.number(
        "gsi",
        |x| (5.0..=100.0).contains(&x),
        "from 5 to 100",
        "GSI runs from 5 to 100, e.g. 55 (not 0.55); 100 is intact rock",
    );
    let m_i = reading.number("m_i", |x| x > 0.0 && x <= 100.0, "above 0 and at most 100", "4 to 35 is usual");
    let disturbance = reading.number(
        "disturbance",
        |x| (0.0..=1.0).contains(&x),
        "from 0 to 1",
        "0 for careful excavation, 1 for heavy blasting",
    );
    let dilation = reading.number("dilation_angle", is_angle, ANGLES, "0 to 15 deg is usual");
    let tensile = reading.optional(
        "tensile_strength",
        |x| x >= 0.0,
        "zero or positive",
        "tension is positive; leave it out for the apex s σ_ci/m_b",
    );
    let build = || {
        let [mb, s, a] = constants(gsi?, m_i?, disturbance?);
        let envelope = Envelope::new(ucs?, [mb, s, a]);
        let apex = envelope.apex();
        let tensile = tensile?.unwrap_or(apex);
        let ft = tensile.min(apex);
        // At the apex u is zero by definition; round-off would leave some of its root.
        let left = if ft < apex { (s - mb * ft / envelope.sci).max(0.0) } else { 0.0 };
        Some(HoekBrown {
            elasticity: Elasticity::new(moduli?),
            envelope,
            flow: slope(dilation?),
            cut_off: [ft, ft - envelope.sci * left.powf(a)],
            tensile,
        })
    };
    match build() {
        Some(law) if reading.faults.is_empty() => Ok(law),
        _ => Err(reading.faults),
    }
}
