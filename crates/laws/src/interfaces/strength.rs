//! The strength of a joint: its parameters, and what is unusual about them.

use std::f64::consts::FRAC_PI_2;

use crate::parameter::{Dimension, Kind, Need, Parameter, Reading};

pub(super) const COHESION: Parameter = Parameter {
    name: "cohesion",
    kind: Kind::Number(Dimension::PRESSURE),
    need: Need::Number(0.0),
    doc: "cohesion c of the bond; gone once it breaks",
};
pub(super) const TENSILE_STRENGTH: Parameter = Parameter {
    name: "tensile_strength",
    kind: Kind::Number(Dimension::PRESSURE),
    need: Need::Optional("the cohesion"),
    doc: "tension f_bond at which the bond breaks",
};
pub(super) const FRICTION: Parameter = Parameter {
    name: "friction_coefficient",
    kind: Kind::Number(Dimension::NONE),
    need: Need::Optional(""),
    doc: "coefficient of friction μ; or give `friction_angle`",
};
pub(super) const FRICTION_ANGLE: Parameter = Parameter {
    name: "friction_angle",
    kind: Kind::Number(Dimension::ANGLE),
    need: Need::Optional(""),
    doc: "angle of friction φ, in place of the coefficient μ = tan φ",
};

/// The coefficient of friction: one of [`FRICTION`] and [`FRICTION_ANGLE`] is given.
fn friction(reading: &mut Reading) -> Option<f64> {
    let coefficient = reading.optional(FRICTION.name, |x| x >= 0.0, "zero or positive", "give zero or more");
    let angle = reading.optional(
        FRICTION_ANGLE.name,
        |x| (0.0..FRAC_PI_2).contains(&x),
        "from 0 to below 90 deg",
        "for rock joints 25 to 45 deg is usual",
    );
    match (coefficient?, angle?) {
        (Some(coefficient), None) => Some(coefficient),
        (None, Some(angle)) => Some(angle.tan()),
        (Some(_), Some(_)) => {
            reading.fault(
                FRICTION_ANGLE.name,
                "cannot stand beside `friction_coefficient`",
                "give one of them",
            );
            None
        }
        (None, None) => {
            reading.fault(FRICTION.name, "is missing", "give it, or `friction_angle`");
            None
        }
    }
}

/// A number above zero.
pub(super) fn positive(reading: &mut Reading, name: &'static str, usual: &str) -> Option<f64> {
    reading.number(name, |x| x > 0.0, "positive", usual)
}

/// A number above zero that may be left out; see [`Reading::optional`].
pub(super) fn positive_if_given(
    reading: &mut Reading,
    name: &'static str,
    usual: &str,
) -> Option<Option<f64>> {
    reading.optional(name, |x| x > 0.0, "positive", usual)
}

/// What a joint carries before it breaks or slides.
#[derive(Clone, Copy, Debug)]
pub struct Strength {
    /// μ
    pub friction: f64,
    /// c \[Pa\]
    pub cohesion: f64,
    /// f_bond \[Pa\]
    pub bond: f64,
}

/// Coefficient of friction from which on one is warned, 63°: an assumption. Most who exceed it gave an angle.
const STEEP: f64 = 2.0;

/// Closure \[m\] at 1 MPa beyond which a joint is softer than soil: an assumption, as the next.
const SOFT: f64 = 0.01;
/// Largest closure \[m\] of joints.
const WIDE: f64 = 0.01;

/// What is unusual about a stiffness \[Pa/m\] and a largest closure \[m\].
pub(super) fn unusual(stiffness: f64, closure: Option<f64>) -> Vec<String> {
    let mut found = Vec::new();
    if 1e6 / stiffness > SOFT {
        found.push(format!(
            "normal_stiffness = {stiffness:.3e} Pa/m closes by {:.0} mm at 1 MPa, where joints close by less than a millimetre",
            1e9 / stiffness
        ));
    }
    if let Some(closure) = closure.filter(|closure| *closure > WIDE) {
        found.push(format!(
            "max_closure = {:.0} mm is more than joints close, 0.1 mm to a few mm",
            1e3 * closure
        ));
    }
    found
}

impl Strength {
    /// From a law's parameters, [`COHESION`], [`TENSILE_STRENGTH`] and [`FRICTION`] among them.
    pub(super) fn read(reading: &mut Reading) -> Option<Self> {
        let mut take = |name| reading.number(name, |x| x >= 0.0, "zero or positive", "give zero or more");
        let cohesion = take(COHESION.name);
        let friction = friction(reading);
        let bond =
            reading.optional(TENSILE_STRENGTH.name, |x| x >= 0.0, "zero or positive", "give zero or more");
        let (cohesion, bond) = (cohesion?, bond?);
        Some(Strength { friction: friction?, cohesion, bond: bond.unwrap_or(cohesion) })
    }

    /// See [`crate::Interface::warnings`].
    pub(super) fn warnings(&self) -> Vec<String> {
        let mut found = Vec::new();
        let Strength { friction, cohesion, bond } = *self;
        if friction > STEEP {
            let angle = friction.atan().to_degrees();
            found.push(format!(
                "friction_coefficient = {friction} is an angle of {angle:.0}°; give an angle as `friction_angle`"
            ));
        }
        if bond > 0.0 && cohesion == 0.0 {
            found.push(format!(
                "the bond holds a tension of {bond:.3e} Pa but no shear beyond friction: the first slip breaks it"
            ));
        }
        found
    }
}
