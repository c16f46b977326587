//! A joint of constant stiffness with Coulomb friction, as other programs have it: p = −k_n g, t = −k_t (s − s_a).
//!
//! Cohesion and tensile strength vanish where the bond breaks. Bond, friction and books: [`super::joint`].
//!
//! **Not modelled.** Dilation, hardening, rates, water.

use super::joint::{self, Joint, Normal, Tangential, WIDTH};
use super::strength::{
    COHESION, FRICTION, FRICTION_ANGLE, Strength, TENSILE_STRENGTH, positive, positive_if_given, unusual,
};
use crate::interface::Interface;
use crate::lane::Lane;
use crate::parameter::{BadParameter, Choice, Column, Dimension, Kind, Need, Parameter, Reading, Values};

/// p = −k_n g.
#[derive(Clone, Copy, Debug)]
pub struct Linear {
    /// k_n \[Pa/m\]
    stiffness: f64,
}

impl Normal for Linear {
    #[inline(always)]
    fn pressure<L: Lane>(&self, gap: L) -> L {
        -(L::splat(self.stiffness) * gap)
    }

    #[inline(always)]
    fn stiffness<L: Lane>(&self, _: L) -> L {
        L::splat(self.stiffness)
    }

    #[inline(always)]
    fn energy<L: Lane>(&self, gap: L) -> L {
        L::splat(0.5 * self.stiffness) * gap * gap
    }

    fn gap(&self, pressure: f64) -> f64 {
        -pressure / self.stiffness
    }
}

/// The law for one interface; see the [module](self).
#[derive(Clone, Copy, Debug)]
pub struct Coulomb {
    joint: Joint<Linear>,
}

/// k_t/k_n where the shear stiffness is left out: 1/(2(1 + ν)) with ν = 0.25.
const SHARE: f64 = 0.4;

impl Interface for Coulomb {
    const NAME: &'static str = "coulomb";
    const SUMMARY: &'static str = "joint of constant stiffness with bond and Coulomb friction";
    const SOURCE: &'static str = "goodman1968; wang2018 (38), (39)";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter {
            name: "normal_stiffness",
            kind: Kind::Number(Dimension::STIFFNESS),
            need: Need::Chosen(
                "as stiff as impacts leave the time step alone, and no softer than ten times the elements beside it",
            ),
            doc: "normal stiffness per area k_n",
        },
        Parameter {
            name: "shear_stiffness",
            kind: Kind::Number(Dimension::STIFFNESS),
            need: Need::Optional("0.4 of the normal stiffness"),
            doc: "shear stiffness per area k_t",
        },
        COHESION,
        TENSILE_STRENGTH,
        FRICTION,
        FRICTION_ANGLE,
    ];
    const HISTORY: &'static [Column] = joint::COLUMNS;
    const STATE: usize = joint::STATE;
    const SLID: usize = joint::SLID;
    const OPENED: usize = joint::OPENED;
    const DISSIPATION: usize = joint::FRICTION;
    const CREATION: usize = joint::CREATED;
    type History<L: Lane> = [L; WIDTH];

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        let mut reading = Reading::new(values, Self::PARAMETERS);
        let stiffness = positive(&mut reading, "normal_stiffness", "20 GPa/m is usual for rock and lining");
        let shear = positive_if_given(&mut reading, "shear_stiffness", "a half of the normal one is usual");
        let strength = Strength::read(&mut reading);
        let (Some(stiffness), Some(shear), Some(strength)) = (stiffness, shear, strength) else {
            return Err(reading.faults);
        };
        let shear = shear.unwrap_or(SHARE * stiffness);
        let (normal, tangential) = (Linear { stiffness }, Tangential::Constant(shear));
        Ok(Coulomb { joint: Joint { normal, tangential, strength } })
    }

    fn chosen(values: &Values, choice: &Choice) -> Values {
        let stiffness = values.optional("normal_stiffness").unwrap_or(choice.stiffness.max(choice.least));
        let shear = values.optional("shear_stiffness").unwrap_or(SHARE * stiffness);
        values.clone().with("normal_stiffness", stiffness).with("shear_stiffness", shear)
    }

    fn stiffness(&self, pressure: f64) -> [f64; 2] {
        self.joint.stiffness(pressure)
    }

    fn stiffest(&self) -> [f64; 2] {
        self.joint.stiffness(0.0)
    }

    fn warnings(&self) -> Vec<String> {
        [self.joint.strength.warnings(), unusual(self.joint.normal.stiffness, None)].concat()
    }

    fn start(&self, pressure: f64, shear: [f64; 2]) -> (f64, [f64; WIDTH]) {
        self.joint.start(pressure, shear)
    }

    #[inline(always)]
    fn update<L: Lane>(&self, gap: L, slip: [L; 2], history: [L; WIDTH]) -> (L, [L; 2], [L; WIDTH]) {
        self.joint.update(gap, slip, history)
    }

    #[inline(always)]
    fn stored_energy<L: Lane>(&self, gap: L, shear: [L; 2], history: &[L; WIDTH]) -> L {
        self.joint.stored_energy(gap, shear, history)
    }
}
