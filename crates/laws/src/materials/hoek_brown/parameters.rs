//! The Hoek–Brown law's parameters: what a case may say, and how it becomes numbers.

use super::HoekBrown;
use super::envelope::Envelope;
use super::residual::Residual;
use crate::materials::elastic::{POISSON, YOUNG};
use crate::materials::plastic::Elasticity;
use crate::materials::plastic::parameters::{ANGLES, is_angle, number, slope};
use crate::materials::plastic::relaxation::RELAXATION_TIME;
use crate::materials::plastic::slip::{DISPLACEMENTS, Measure, STRAINS};
use crate::parameter::{BadParameter, Dimension, Kind, Need, Parameter, Reading, Values};

pub(super) const PARAMETERS: &[Parameter] = &[
    YOUNG,
    POISSON,
    number(
        "compressive_strength",
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
    Parameter {
        name: RESIDUAL,
        kind: Kind::Set(RESIDUAL_STATE),
        need: Need::Optional("strength stays"),
        doc: "the rock mass after a slip: m_b, s and a change along straight lines to those of its GSI and D",
    },
    RELAXATION_TIME,
];

const RESIDUAL: &str = "residual";

const RESIDUAL_STATE: &[Parameter] = &[
    number("gsi", Dimension::NONE, Need::Required, "GSI of the residual state, from 5 to the peak's"),
    number(
        "disturbance",
        Dimension::NONE,
        Need::Optional("the peak's"),
        "D of the residual state, from the peak's to 1",
    ),
    number(
        DISPLACEMENTS[0],
        Dimension::LENGTH,
        Need::Optional("plastic_shear_strain must be given"),
        "slip across a band of shear at which it is reached: 2 h times the plastic shear strain, h the element's extent",
    ),
    number(
        STRAINS[0],
        Dimension::NONE,
        Need::Optional("plastic_shear_displacement must be given"),
        "plastic shear strain at which it is reached; beside relaxation_time",
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

/// The residual state where there is one; `Some(None)` where there is none, `None` where it is wrong.
fn read_residual(reading: &mut Reading, gsi: f64, m_i: f64, disturbance: f64) -> Option<Option<Residual>> {
    let Some(columns) = reading.table(RESIDUAL) else { return Some(None) };
    let faults = reading.faults.len();
    let value = |name: &str| columns.get(name).and_then(|one| one.first().copied());
    let end = value("gsi")?;
    if !(5.0..=gsi).contains(&end) {
        let remedy = format!("give 5 to {gsi}, the GSI of the peak");
        reading.fault(
            "residual.gsi",
            format!("is {end}: the residual state is no stronger than the peak"),
            remedy,
        );
    }
    let worse = value("disturbance").unwrap_or(disturbance);
    if !(disturbance..=1.0).contains(&worse) {
        let remedy = format!("give {disturbance}, the D of the peak, to 1, or leave it out");
        reading.fault("residual.disturbance", format!("is {worse}: disturbance does not heal"), remedy);
    }
    let (measure, name, over) = match (value(DISPLACEMENTS[0]), value(STRAINS[0])) {
        (Some(over), None) => (Measure::Displacement, "residual.plastic_shear_displacement", over),
        (None, Some(over)) => (Measure::Strain, "residual.plastic_shear_strain", over),
        (Some(_), Some(_)) => {
            let problem = "depends on displacement and on strain";
            reading.fault(RESIDUAL, problem, "keep plastic_shear_displacement");
            return None;
        }
        (None, None) => {
            let problem = format!("has no {}", DISPLACEMENTS[0]);
            reading.fault(
                RESIDUAL,
                problem,
                "give the slip at which the residual state is reached, e.g. 20 mm",
            );
            return None;
        }
    };
    if over <= 0.0 {
        reading.fault(
            name,
            "must be positive",
            "give the slip at which the residual state is reached, e.g. 20 mm",
        );
    }
    let end = constants(end, m_i, worse);
    (reading.faults.len() == faults).then_some(Some(Residual { measure, over, end }))
}

pub(super) fn read(values: &Values) -> Result<HoekBrown, Vec<BadParameter>> {
    let mut reading = Reading::new(values, PARAMETERS);
    let moduli = reading.moduli();
    let ucs = reading.number(
        "compressive_strength",
        |x| x > 0.0,
        "positive",
        "for intact rock 5 to 300 MPa is usual",
    );
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
    let residual = match (gsi, m_i, disturbance) {
        (Some(gsi), Some(m_i), Some(disturbance)) => read_residual(&mut reading, gsi, m_i, disturbance),
        _ => Some(None),
    };
    let slips = matches!(&residual, Some(Some(residual)) if residual.measure == Measure::Displacement);
    let relaxation = reading.relaxation(slips);
    let build = || {
        let [mb, s, a] = constants(gsi?, m_i?, disturbance?);
        let envelope = Envelope::new(ucs?, [mb, s, a]);
        let apex = envelope.apex();
        let tensile = tensile?.unwrap_or(apex);
        let ft = tensile.min(apex);
        // At the apex u is zero by definition; round-off would leave some of its root.
        let left = if ft < apex { (s - mb * ft / envelope.sci).max(0.0) } else { 0.0 };
        let (moduli, flow) = (moduli?, slope(dilation?));
        let residual = residual?;
        let size_limit = residual
            .as_ref()
            .map_or(f64::INFINITY, |residual| residual.size_limit(moduli.young(), &envelope, flow));
        Some(HoekBrown {
            elasticity: Elasticity::new(moduli),
            envelope,
            flow,
            cut_off: [ft, ft - envelope.sci * left.powf(a)],
            tensile,
            residual,
            size_limit,
            relaxation: relaxation?,
        })
    };
    match build() {
        Some(law) if reading.faults.is_empty() => Ok(law),
        _ => Err(reading.faults),
    }
}
