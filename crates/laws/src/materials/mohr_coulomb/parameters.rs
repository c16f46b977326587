//! The Mohr–Coulomb law's parameters: what a case may say, and how it becomes numbers.

use super::softening::{Row, Softening};
use super::{MohrCoulomb, Strength};
use crate::materials::elastic::{POISSON, YOUNG};
use crate::materials::plastic::Elasticity;
use crate::materials::plastic::parameters::{
    COHESION, DILATION_ANGLE, FRICTION_ANGLE, LARGEST_ANGLE, number, slope,
};
use crate::materials::plastic::relaxation::RELAXATION_TIME;
use crate::materials::plastic::slip::{DISPLACEMENTS, Measure, STRAINS};
use crate::parameter::{BadParameter, Dimension, Kind, Need, Parameter, Reading, Values};

const SOFTENING: &str = "softening";

const STRAIN_PLACES: [&str; 2] = ["softening.plastic_shear_strain", "softening.plastic_tension_strain"];
const DISPLACEMENT_PLACES: [&str; 2] =
    ["softening.plastic_shear_displacement", "softening.plastic_tension_displacement"];

const STRENGTHS: [&str; 4] = ["cohesion", "friction_angle", "dilation_angle", "tensile_strength"];

const STAYS: Need = Need::Optional("it stays");

const COLUMNS: &[Parameter] = &[
    number(
        DISPLACEMENTS[0],
        Dimension::LENGTH,
        Need::Optional("plastic_shear_strain must be given"),
        "slip across a band of shear at each row, growing from 0: 2 h times the plastic shear strain, h the element's extent",
    ),
    number(
        DISPLACEMENTS[1],
        Dimension::LENGTH,
        Need::Optional("f_t goes by the slip alone"),
        "opening across a crack at each row, growing from 0: f_t goes by whichever displacement has come further",
    ),
    number(
        STRAINS[0],
        Dimension::NONE,
        Need::Optional("plastic_shear_displacement must be given"),
        "accumulated plastic shear strain at each row, growing from 0; beside relaxation_time",
    ),
    number(
        STRAINS[1],
        Dimension::NONE,
        Need::Optional("f_t goes by the plastic shear strain alone"),
        "plastic tension strain at each row, growing from 0: f_t goes by whichever strain has come further",
    ),
    number("cohesion", Dimension::PRESSURE, STAYS, "c at each row, first the peak's"),
    number("friction_angle", Dimension::ANGLE, STAYS, "φ at each row, first the peak's"),
    number("dilation_angle", Dimension::ANGLE, STAYS, "ψ at each row, first the peak's, not above φ"),
    number("tensile_strength", Dimension::PRESSURE, STAYS, "f_t at each row, first the peak's"),
];

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
    Parameter {
        name: SOFTENING,
        kind: Kind::Table(COLUMNS),
        need: Need::Optional("strength stays"),
        doc: "strength against plastic displacement or strain: columns with a number a row, straight lines between rows",
    },
    RELAXATION_TIME,
];

/// The table of softening where there is one, as rows; `Some(None)` where there is none, `None` where it is wrong.
fn read_softening(reading: &mut Reading, peak: Row) -> Option<Option<Softening>> {
    let Some(columns) = reading.table(SOFTENING) else { return Some(None) };
    let faults = reading.faults.len();
    let column = |name: &str| columns.get(name).map(Vec::as_slice);
    let given = |names: [&str; 2]| names.into_iter().any(|name| column(name).is_some());
    let (measure, names, places) = match (given(DISPLACEMENTS), given(STRAINS)) {
        (true, true) => {
            reading.fault(
                SOFTENING,
                "depends on displacement and on strain",
                "keep plastic_shear_displacement and plastic_tension_displacement",
            );
            return None;
        }
        (false, true) => (Measure::Strain, STRAINS, STRAIN_PLACES),
        _ => (Measure::Displacement, DISPLACEMENTS, DISPLACEMENT_PLACES),
    };
    let Some(shear) = column(names[0]) else {
        reading.fault(
            SOFTENING,
            format!("has no column {}", names[0]),
            "give [0, …]: the peak's, which is 0, and those where strengths change",
        );
        return None;
    };
    if shear.len() < 2 {
        reading.fault(
            places[0],
            "needs two rows or more",
            "give [0, …]: the peak's, which is 0, and those where strengths change",
        );
        return None;
    }
    for (name, place) in names.into_iter().zip(places) {
        if let Some(measures) = column(name)
            && (measures[0] != 0.0 || measures.windows(2).any(|pair| pair[0] >= pair[1]))
        {
            reading.fault(place, "must grow from 0, row by row", "the first row holds the peak strengths");
        }
    }
    for (name, place, peak, most) in [
        ("cohesion", "softening.cohesion", peak.cohesion, f64::INFINITY),
        ("friction_angle", "softening.friction_angle", peak.friction, LARGEST_ANGLE),
        ("dilation_angle", "softening.dilation_angle", peak.dilation, LARGEST_ANGLE),
        ("tensile_strength", "softening.tensile_strength", peak.tensile, f64::INFINITY),
    ] {
        let Some(strengths) = column(name) else { continue };
        if (strengths[0] - peak).abs() > 1e-9 * peak {
            let remedy = format!("begin the column with the value of `{name}` itself");
            reading.fault(place, "does not begin with the peak strength", remedy);
        } else if !strengths.iter().all(|x| (0.0..=most).contains(x)) {
            reading.fault(
                place,
                "must be zero or positive, angles at most 89.9 deg",
                "strength cannot be negative",
            );
        }
    }
    if STRENGTHS.iter().all(|name| column(name).is_none()) {
        let remedy = format!("give one of {}", STRENGTHS.join(", "));
        reading.fault(SOFTENING, "says of no strength how it changes", remedy);
    }
    if reading.faults.len() > faults {
        return None;
    }
    let value = |name: &str, row: usize, peak: f64| column(name).map_or(peak, |c| c[row]);
    let rows: Vec<Row> = (1..shear.len())
        .map(|row| Row {
            shear: shear[row],
            tension: column(names[1]).map(|c| c[row]),
            cohesion: value("cohesion", row, peak.cohesion),
            friction: value("friction_angle", row, peak.friction),
            dilation: value("dilation_angle", row, peak.dilation),
            tensile: value("tensile_strength", row, peak.tensile),
        })
        .collect();
    for row in &rows {
        if row.cohesion == 0.0 && row.friction == 0.0 {
            reading.fault(
                SOFTENING,
                format!("leaves neither cohesion nor friction in the row {} of {}", row.shear, names[0]),
                "keep a small cohesion or some friction in every row",
            );
            return None;
        }
        if row.dilation > row.friction {
            reading.fault(
                "softening.dilation_angle",
                format!("exceeds the friction angle in the row {} of {}", row.shear, names[0]),
                "beyond it flow would give out energy: let dilation fall with the friction angle or before it",
            );
            return None;
        }
    }
    let tension = column(names[1]).map(|_| 0.0);
    Some(Some(Softening::new(measure, Row { tension, ..peak }, &rows)))
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
        let peak = Row { shear: 0.0, tension: None, cohesion, friction, dilation, tensile };
        let softening = read_softening(&mut reading, peak)?;
        let slips = softening.as_ref().is_some_and(|softening| softening.measure == Measure::Displacement);
        let relaxation = reading.relaxation(slips)?;
        let moduli = moduli?;
        let size_limit =
            softening.as_ref().map_or(f64::INFINITY, |softening| softening.size_limit(moduli.young()));
        Some(MohrCoulomb {
            elasticity: Elasticity::new(moduli),
            tensile,
            peak: Strength::new(slope(friction), cohesion, tensile, slope(dilation)),
            softening,
            size_limit,
            relaxation,
        })
    };
    let law = build();
    match law {
        Some(law) if reading.faults.is_empty() => Ok(law),
        _ => Err(reading.faults),
    }
}
