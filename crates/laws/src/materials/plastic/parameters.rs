//! Parameters that the elastic–plastic laws share, and the reading of them.

use crate::material::Moduli;
use crate::materials::elastic::read_moduli;
use crate::parameter::{Dimension, Kind, Need, Parameter, Reading};

pub(in crate::materials) const fn number(
    name: &'static str,
    dimension: Dimension,
    need: Need,
    doc: &'static str,
) -> Parameter {
    Parameter { name, kind: Kind::Number(dimension), need, doc }
}

pub(in crate::materials) const COHESION: Parameter =
    number("cohesion", Dimension::PRESSURE, Need::Required, "cohesion c, zero or more");

pub(in crate::materials) const FRICTION_ANGLE: Parameter =
    number("friction_angle", Dimension::ANGLE, Need::Required, "friction angle φ, from 0 up to 89.9°");

pub(in crate::materials) const DILATION_ANGLE: Parameter =
    number("dilation_angle", Dimension::ANGLE, Need::Number(0.0), "dilation angle ψ, from 0 up to φ");

/// M = (1 + sin x)/(1 − sin x), the slope in σ₁ over σ₃ of an angle.
pub(in crate::materials) fn slope(angle: f64) -> f64 {
    (1.0 + angle.sin()) / (1.0 - angle.sin())
}

impl Reading<'_> {
    pub fn moduli(&mut self) -> Option<Moduli> {
        read_moduli(self.values).map_err(|faults| self.faults.extend(faults)).ok()
    }

    /// c, φ and ψ of a Mohr–Coulomb envelope.
    pub fn envelope(&mut self) -> Option<[f64; 3]> {
        let cohesion =
            self.number("cohesion", |c| c >= 0.0, "zero or positive", "for rock 0.1 to 50 MPa is usual");
        let friction = self.number(
            "friction_angle",
            is_angle,
            ANGLES,
            "for rock 20 to 60 deg is usual; write the unit, as in \"42 deg\"",
        );
        let most = friction.unwrap_or(LARGEST_ANGLE);
        let dilation = self.number(
            "dilation_angle",
            |psi| (0.0..=most).contains(&psi),
            "from 0 up to the friction angle",
            "beyond it flow would give out energy; 0 to a quarter of it is usual",
        );
        if cohesion == Some(0.0) && friction == Some(0.0) {
            self.fault("cohesion", "is 0 and so is the friction angle", "give at least one of them");
            return None;
        }
        Some([cohesion?, friction?, dilation?])
    }
}

/// 89.9°: slopes stay below 1.4·10⁶.
pub(in crate::materials) const LARGEST_ANGLE: f64 = 89.9 * std::f64::consts::PI / 180.0;

/// What an angle must be.
pub(in crate::materials) const ANGLES: &str = "from 0 to 89.9 deg";

/// An angle that a slope can be made of.
pub(in crate::materials) fn is_angle(angle: f64) -> bool {
    (0.0..=LARGEST_ANGLE).contains(&angle)
}
