//! Drucker–Prager with a limit on mean tension: elastic, perfectly plastic, not associated.
//!
//! **The law.** With √J₂ of the stress and its mean p (tension positive), shear yields where √J₂ + q_φ p = k_φ and
//! flows along √J₂ + q_ψ p (drucker1952); tension yields where p = f_t and flows normal to that, f_t cut at the apex
//! k_φ/q_φ. The return to cone, cut-off and their common circle is exact for a given strain and keeps the direction
//! of the deviator, so no principal directions are needed.
//!
//! **Constants.** `fit` takes them from c, φ, ψ: `outer` is the cone through the compression edges of Mohr–Coulomb's
//! pyramid, q = 6 sin x/(√3(3 − sin x)), k = 6c cos φ/(√3(3 − sin φ)), and overestimates strength in extension;
//! `inner` goes through the extension edges (3 + sin x below). `plane-strain` has Mohr–Coulomb's strength and
//! dilation where plastic flow is in a plane: q_ψ = 3 tan ψ/√(9 + 12 tan²ψ) and, with
//! d = √(1 − q_ψ²/3) + ⅓ q_ψ sin φ, q_φ = sin φ/d, k_φ = c cos φ/d; for ψ = φ that is the pair of drucker1952.
//! `direct` takes `q_phi`, `k_phi` and `q_psi` as they are.
//!
//! **Measures.** `plastic_shear_strain` accumulates √J₂ of the plastic strain of the cone, `plastic_tension_strain`
//! the volume that the cut-off adds. `state` as with Mohr–Coulomb: 1 shear now, 2 tension now, 4 and 8 in an earlier
//! step.
//!
//! **Energy.** Flow never gives out energy as q_ψ ≤ q_φ.
//!
//! **Not modelled.** The third invariant in strength, softening, a limit on the largest principal stress
//! (`tensile_strength` limits the mean), rate, pore pressure.

use super::elastic::{POISSON, YOUNG};
use super::plastic::parameters::{DILATION_ANGLE, number};
use super::plastic::{COLUMNS, Elasticity, SHEAR, STATE, TENSION, mean_and_radius, state, unyielding};
use crate::lane::Lane;
use crate::material::{Material, Moduli, Point, Sym, complementary_energy};
use crate::parameter::{BadParameter, Column, Derived, Dimension, Kind, Need, Parameter, Reading, Values};

/// The law for one rock; see the [module](self).
#[derive(Clone, Copy, Debug)]
pub struct DruckerPrager {
    elasticity: Elasticity,
    q_phi: f64,
    /// \[Pa\]
    k_phi: f64,
    q_psi: f64,
    /// Limit of the mean \[Pa\], cut at the apex.
    ft: f64,
    /// As given.
    tensile: f64,
}

const PARAMETERS: &[Parameter] = &[
    YOUNG,
    POISSON,
    Parameter {
        name: "fit",
        kind: Kind::Word(&["outer", "inner", "plane-strain", "direct"]),
        need: Need::Word("inner"),
        doc: "where the cone meets Mohr–Coulomb's pyramid, or direct for q_phi and k_phi",
    },
    number("cohesion", Dimension::PRESSURE, Need::Optional("k_phi is given"), "cohesion c, zero or more"),
    number(
        "friction_angle",
        Dimension::ANGLE,
        Need::Optional("q_phi is given"),
        "friction angle φ, from 0 up to 89.9°",
    ),
    DILATION_ANGLE,
    number(
        "q_phi",
        Dimension::NONE,
        Need::Optional("from the friction angle"),
        "q_φ, slope of √J₂ over the mean",
    ),
    number("k_phi", Dimension::PRESSURE, Need::Optional("from the cohesion"), "k_φ, √J₂ at no mean stress"),
    number(
        "q_psi",
        Dimension::NONE,
        Need::Optional("from the dilation angle, else 0"),
        "q_ψ, from 0 up to q_φ",
    ),
    number(
        "tensile_strength",
        Dimension::PRESSURE,
        Need::Number(0.0),
        "largest mean stress f_t, zero or more; cut at the apex k_φ/q_φ",
    ),
];

/// q_φ, k_φ and q_ψ of a fit.
fn fitted(fit: &str, [cohesion, friction, dilation]: [f64; 3]) -> [f64; 3] {
    let root = 3f64.sqrt();
    let (sine, cosine) = friction.sin_cos();
    let flow = dilation.sin();
    let through = |sign: f64| {
        let share = 6.0 / (root * (3.0 - sign * sine));
        [share * sine, share * cohesion * cosine, 6.0 * flow / (root * (3.0 - sign * flow))]
    };
    match fit {
        "outer" => through(1.0),
        "inner" => through(-1.0),
        _ => {
            // 3 tan ψ/√(9 + 12 tan²ψ) without the tangent.
            let q_psi = flow / (1.0 + flow * flow / 3.0).sqrt();
            let d = (1.0 - q_psi * q_psi / 3.0).sqrt() + q_psi * sine / 3.0;
            [sine / d, cohesion * cosine / d, q_psi]
        }
    }
}

fn read(values: &Values) -> Result<DruckerPrager, Vec<BadParameter>> {
    let mut reading = Reading::new(values, PARAMETERS);
    let moduli = reading.moduli();
    let fit = reading.word("fit");
    let cone = match fit {
        Some("direct") => {
            let q = reading.number(
                "q_phi",
                |q| (0.0..3.0).contains(&q),
                "from 0 to below 3",
                "0.3 to 1.5 is usual",
            );
            let k = reading.number("k_phi", |k| k >= 0.0, "zero or positive", "of the size of the cohesion");
            let most = q.unwrap_or(3.0);
            let flow = reading.optional(
                "q_psi",
                |x| (0.0..=most).contains(&x),
                "from 0 up to q_phi",
                "beyond it flow would give out energy",
            );
            for key in ["cohesion", "friction_angle"] {
                if values.optional(key).is_some() {
                    reading.fault(
                        key,
                        "has no meaning with fit = direct",
                        "leave it out, or choose another fit",
                    );
                }
            }
            if values.optional("dilation_angle").is_some_and(|psi| psi != 0.0) {
                reading.fault("dilation_angle", "has no meaning with fit = direct", "give q_psi instead");
            }
            if q == Some(0.0) && k == Some(0.0) {
                reading.fault("k_phi", "is 0 and so is q_phi", "give at least one of them");
            }
            q.zip(k).zip(flow).map(|((q, k), flow)| [q, k, flow.unwrap_or(0.0)])
        }
        _ => {
            for key in ["q_phi", "k_phi", "q_psi"] {
                if values.optional(key).is_some() {
                    reading.fault(
                        key,
                        "is only read with fit = direct",
                        "leave it out, or set fit = \"direct\"",
                    );
                }
            }
            let envelope = reading.envelope();
            fit.zip(envelope).map(|(fit, envelope)| fitted(fit, envelope))
        }
    };
    let tensile = reading.number(
        "tensile_strength",
        |x| x >= 0.0,
        "zero or positive",
        "tension is positive; 0 means that the rock carries no mean tension",
    );
    match (moduli, cone, tensile) {
        (Some(moduli), Some([q_phi, k_phi, q_psi]), Some(tensile)) if reading.faults.is_empty() => {
            let ft = if q_phi > 0.0 { tensile.min(k_phi / q_phi) } else { tensile };
            Ok(DruckerPrager { elasticity: Elasticity::new(moduli), q_phi, k_phi, q_psi, ft, tensile })
        }
        _ => Err(reading.faults),
    }
}

impl DruckerPrager {
    /// q_φ, k_φ \[Pa\] and q_ψ.
    pub fn cone(&self) -> [f64; 3] {
        [self.q_phi, self.k_phi, self.q_psi]
    }

    /// Limit of the mean stress \[Pa\] in use, not beyond the apex.
    pub fn tensile_strength(&self) -> f64 {
        self.ft
    }
}

impl Material for DruckerPrager {
    const NAME: &'static str = "drucker-prager";
    const SUMMARY: &'static str = "rock, Drucker–Prager cone with a limit on mean tension";
    const SOURCE: &'static str = "drucker1952, cone and plane strain; outer and inner cones by geometry";
    const PARAMETERS: &'static [Parameter] = PARAMETERS;
    const HISTORY: &'static [Column] = &COLUMNS;
    const FLOWS: bool = true;
    const PRESSURE_DEPENDENT: bool = true;
    type History<L: Lane> = [L; 10];

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        read(values)
    }

    fn moduli(&self) -> Moduli {
        self.elasticity.moduli()
    }

    fn scaled(&self, factor: f64) -> Self {
        let elasticity = Elasticity::new(self.moduli().scaled(factor));
        DruckerPrager { elasticity, ..*self }
    }

    fn derived(&self, _: [f64; 2]) -> Vec<Derived> {
        let mut all = vec![
            Derived::new("q_phi", self.q_phi, "1", "q_φ, slope of √J₂ over the mean"),
            Derived::new("k_phi", self.k_phi, "Pa", "k_φ, √J₂ at no mean stress"),
            Derived::new("q_psi", self.q_psi, "1", "q_ψ of the flow"),
        ];
        if self.q_phi > 0.0 {
            all.push(Derived::new(
                "apex",
                self.k_phi / self.q_phi,
                "Pa",
                "k_φ/q_φ, mean tension that the cone allows",
            ));
        }
        all.push(Derived::new(
            "tensile_strength",
            self.ft,
            "Pa",
            "f_t in use, limit of the mean, not beyond the apex",
        ));
        all
    }

    fn warnings(&self) -> Vec<String> {
        let mut warnings = Vec::new();
        if self.tensile > self.ft {
            warnings.push(format!(
                "tensile_strength {:.3e} Pa lies beyond the apex k_φ/q_φ = {:.3e} Pa, which is used instead",
                self.tensile, self.ft
            ));
        }
        warnings
    }

    #[inline(always)]
    fn stored_energy<L: Lane>(&self, _: &Sym<L>, stress: &Sym<L>, _: &[L; 10]) -> L {
        complementary_energy(self.moduli(), stress)
    }

    #[inline(always)]
    fn hourglass_share<L: Lane>(&self, history: &[L; 10]) -> L {
        super::plastic::hourglass_share(self.k_phi, self.elasticity.mu, history)
    }

    #[inline(always)]
    fn update<L: Lane>(&self, _: &Point<L>, strain: Sym<L>, old: [L; 10]) -> (Sym<L>, [L; 10]) {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let trial = self.elasticity.trial(&strain, &old);
        let (mean, radius) = mean_and_radius(&trial);
        let q = radius * L::splat(3f64.sqrt());
        let (slope, ft) = (L::splat(self.q_phi), L::splat(self.ft));
        let round_off = L::splat(self.elasticity.round_off);
        let excess = slope.mul_add(mean, q - L::splat(self.k_phi));
        let sheared = round_off.less(excess);
        let yielding = L::either(sheared, round_off.less(mean - ft));
        if !L::any(yielding) {
            return unyielding(trial, old);
        }

        let Elasticity { mu, bulk, .. } = self.elasticity;
        let stiffness = mu + bulk * self.q_phi * self.q_psi;
        let gamma = L::select(sheared, excess * L::splat(1.0 / stiffness), zero);
        let cone_mean = L::splat(bulk * self.q_psi).neg_mul_add(gamma, mean);
        let cone_q = L::splat(mu).neg_mul_add(gamma, q);
        // Beyond f_t on the cone, the cut-off takes the mean, and the cone what is left of √J₂ above its circle.
        let beyond = ft.less(cone_mean);
        let circle = L::splat((self.k_phi - self.q_phi * self.ft).max(0.0));
        let over = circle.less(q);
        let new_mean = L::select(beyond, ft, cone_mean);
        let new_q = L::select(beyond, L::select(over, circle, q), cone_q);
        let ratio = L::select(zero.less(q), new_q / q, one);
        let ratio = L::select(L::either(sheared, beyond), ratio, one);
        let mut stress = trial;
        let mut k = 0;
        while k < 3 {
            stress[k] = ratio.mul_add(trial[k] - mean, new_mean);
            stress[3 + k] = ratio * trial[3 + k];
            k += 1;
        }

        let shear = L::both(yielding, L::either(L::both(sheared, L::not(beyond)), L::both(beyond, over)));
        let tension = L::both(yielding, beyond);
        let sheared_by = (q - new_q) * L::splat(1.0 / mu);
        let grown = (mean - new_mean) * L::splat(1.0 / bulk);
        let opened = zero.larger(L::splat(self.q_psi).neg_mul_add(sheared_by, grown));
        let mut new = old;
        new[SHEAR] = old[SHEAR] + L::select(shear, sheared_by * L::splat(0.5), zero);
        new[TENSION] = old[TENSION] + L::select(tension, opened, zero);
        new[STATE] = state(shear, tension, &old);
        let stress = self.elasticity.settle(&trial, &stress, yielding, &mut new);
        (stress, new)
    }
}
