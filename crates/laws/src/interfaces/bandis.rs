//! A joint whose closure is Bandis' hyperbola: rock on concrete, faults, joints.
//!
//! **Normal** (`wang2018` (32), (34), corrected; `bandis1983`). The stiffness per area k_n(g) = k_n0/(1 + g/T)² is integrated
//! from g = 0 to p = −k_n0 g/(1 + g/T), with the largest closure T. The print has (32) push the bodies apart further and (34)
//! as an increment's; the sign here restores, and the form is total, so that nothing drifts. Where 1 + g/T falls below φ the
//! curve goes straight on with k_n0/φ², φ the larger of `closure_floor` and 1/(1 + p*/(k_n0 T)) with p* of
//! `pressure_for_step`: no state is stiffer, and the time step counts just that.
//!
//! **Tangential** (33), (35): k_t = k_n/(2(1 + ν)). `following`, the paper's: t ← t − k_t Δs with k_t at the present closure.
//! Slipping out at one closure and back at a lesser one gives out energy; that is booked as created. `constant`:
//! t = −k_t0 (s − s_a) with k_t0 from k_n0 and an anchor s_a that follows when the pair slides.
//!
//! Bond, friction and books: [`super::joint`].
//!
//! **Not modelled.** Dilation, asperities that wear, hysteresis of closure, rates, water.

use super::hyperbola::Hyperbola;
use super::joint::{self, Joint, Tangential, WIDTH};
use super::strength::{
    COHESION, FRICTION, FRICTION_ANGLE, Strength, TENSILE_STRENGTH, positive, positive_if_given, unusual,
};
use crate::interface::Interface;
use crate::lane::Lane;
use crate::parameter::{BadParameter, Choice, Column, Dimension, Kind, Need, Parameter, Reading, Values};

/// The law for one interface; see the [module](self).
#[derive(Clone, Copy, Debug)]
pub struct Bandis {
    joint: Joint<Hyperbola>,
}

const STIFFNESS: &str = "normal_stiffness";
const PRESSURE_FOR_STEP: &str = "pressure_for_step";
/// Smallest part of the closure at which the curve goes straight, by default: p = 3 k_n0 T there.
const FLOOR: f64 = 0.25;
/// The least that may be asked for, p = 999 k_n0 T: an assumption, so that no digits are lost.
const LEAST_FLOOR: f64 = 0.001;

impl Interface for Bandis {
    const NAME: &'static str = "bandis";
    const SUMMARY: &'static str = "joint with a hyperbolic closure, bond and Coulomb friction; the paper's interface of rock and lining";
    const SOURCE: &'static str = "wang2018 (28)–(39) with corrections; bandis1983";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter {
            name: STIFFNESS,
            kind: Kind::Number(Dimension::STIFFNESS),
            need: Need::Chosen(
                "as stiff as impacts leave the time step alone, and no softer than ten times the elements beside it",
            ),
            doc: "normal stiffness per area k_n0 of the closed, unloaded joint",
        },
        Parameter {
            name: "max_closure",
            kind: Kind::Number(Dimension::LENGTH),
            need: Need::Required,
            doc: "largest closure T, at which the hyperbola ends",
        },
        Parameter {
            name: "poisson",
            kind: Kind::Number(Dimension::NONE),
            need: Need::Number(0.25),
            doc: "ν of k_t = k_n/(2(1 + ν))",
        },
        COHESION,
        TENSILE_STRENGTH,
        FRICTION,
        FRICTION_ANGLE,
        Parameter {
            name: "tangential",
            kind: Kind::Word(&["following", "constant"]),
            need: Need::Word("following"),
            doc: "k_t from k_n at the present closure (the paper), or from k_n0",
        },
        Parameter {
            name: "closure_floor",
            kind: Kind::Number(Dimension::NONE),
            need: Need::Number(FLOOR),
            doc: "share 1 + g/T of the closure that is left where the curve goes straight, at p = k_n0 T (1/φ − 1)",
        },
        Parameter {
            name: PRESSURE_FOR_STEP,
            kind: Kind::Number(Dimension::PRESSURE),
            need: Need::Optional(
                "in a case the strength of what cracks beside it, else 10 MPa; alone the closure's floor decides",
            ),
            doc: "pressure p* from which on the curve goes straight, so that no state is stiffer than the time step counts",
        },
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
        let closure = positive(&mut reading, "max_closure", "joints close by 0.1 mm to a few mm");
        let poisson =
            reading.number("poisson", |x| x > -1.0 && x <= 0.5, "between -1 and 0.5", "0.25 is usual");
        let floor = reading.number(
            "closure_floor",
            |x| (LEAST_FLOOR..=1.0).contains(&x),
            "from 0.001 to 1",
            "0.25 is usual; 1 makes the closure linear",
        );
        let limit = positive_if_given(&mut reading, PRESSURE_FOR_STEP, "the strength of the lining is usual");
        let tangential = reading.word("tangential");
        let strength = Strength::read(&mut reading);
        let (Some(stiffness), Some(closure), Some(strength)) = (stiffness, closure, strength) else {
            return Err(reading.faults);
        };
        if strength.bond >= stiffness * closure {
            let given = values.optional(TENSILE_STRENGTH.name).is_some();
            reading.fault(
                if given { TENSILE_STRENGTH.name } else { COHESION.name },
                format!(
                    "gives a bond of {:.4e} Pa that the joint can never reach: its tension stays below \
                     normal_stiffness × max_closure, {:.4e} Pa",
                    strength.bond,
                    stiffness * closure
                ),
                "give a smaller tensile_strength, or a larger normal_stiffness or max_closure",
            );
        }
        let (Some(poisson), Some(floor), Some(limit), Some(tangential), true) =
            (poisson, floor, limit, tangential, reading.faults.is_empty())
        else {
            return Err(reading.faults);
        };
        let share = 0.5 / (1.0 + poisson);
        let tangential = if tangential == "constant" {
            Tangential::Constant(share * stiffness)
        } else {
            Tangential::Following(share)
        };
        let floor = floor.max(limit.map_or(0.0, |limit| 1.0 / (1.0 + limit / (stiffness * closure))));
        let normal = Hyperbola { stiffness, closure, floor };
        Ok(Bandis { joint: Joint { normal, tangential, strength } })
    }

    /// With p* the larger root k_n0 of k_n0 (1 + p*/(k_n0 T))² = L, the stiffness of the choice; that has its least value 4p*/T
    /// at p*/T. Where L is below it, k_n0 = ¼L and p* = ¼LT, but for a p* that is given: then k_n0 = p*/T, and the stiffest state
    /// is stiffer than the choice. The closure's floor bounds it as well. A k_n0 below the least is raised to it, and p* then is as
    /// much of its own value as costs no more: k_n0 T at most, where the stiffest state is the least for that p*.
    fn chosen(values: &Values, choice: &Choice) -> Values {
        let given = values.optional(PRESSURE_FOR_STEP);
        let limit = given.unwrap_or(choice.pressure);
        let with_limit = |limit: f64| values.clone().with(PRESSURE_FOR_STEP, limit);
        if values.optional(STIFFNESS).is_some() {
            return with_limit(limit);
        }
        let closure = values.optional("max_closure").unwrap_or(f64::NAN);
        let floor = values.optional("closure_floor").unwrap_or(FLOOR);
        let (most, least) = (choice.stiffness, limit / closure);
        let by_floor = most * floor * floor;
        if most >= 4.0 * least {
            let root = 0.5 * ((most - 2.0 * least) + (most * (most - 4.0 * least)).sqrt());
            return with_limit(limit).with(STIFFNESS, by_floor.max(root).max(choice.least));
        }
        match given {
            Some(_) => with_limit(limit).with(STIFFNESS, by_floor.max(least).max(choice.least)),
            None => {
                let own = (0.25 * most).max(choice.least);
                with_limit(limit.min(own * closure)).with(STIFFNESS, by_floor.max(own))
            }
        }
    }

    fn stiffness(&self, pressure: f64) -> [f64; 2] {
        self.joint.stiffness(pressure)
    }

    fn stiffest(&self) -> [f64; 2] {
        let Hyperbola { stiffness, floor, .. } = self.joint.normal;
        let normal = stiffness / (floor * floor);
        match self.joint.tangential {
            Tangential::Following(share) => [normal, share * normal],
            Tangential::Constant(tangential) => [normal, tangential],
        }
    }

    fn straight_from(&self) -> Option<f64> {
        Some(self.joint.normal.straight_from())
    }

    fn closure_limit(&self) -> Option<f64> {
        Some(self.joint.normal.closure)
    }

    fn warnings(&self) -> Vec<String> {
        let own = &self.joint.normal;
        [self.joint.strength.warnings(), unusual(own.stiffness, Some(own.closure))].concat()
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
