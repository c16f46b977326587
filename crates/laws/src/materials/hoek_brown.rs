//! Generalised Hoek–Brown with a tension cut-off: elastic, perfectly plastic, not associated.
//!
//! **The law.** With principal stresses σ₁ ≥ σ₂ ≥ σ₃ (tension positive), shear yields where
//! σ₁ − σ₃ = σ_ci u^a, u = s − m_b σ₁/σ_ci, with m_b = m_i exp\[(GSI − 100)/(28 − 14D)\],
//! s = exp\[(GSI − 100)/(9 − 3D)\], a = ½ + (e^(−GSI/15) − e^(−20/3))/6 (hoek2002). Tension yields where σ₁ = f_t,
//! by default the apex s σ_ci/m_b (the tensile strength there), and flows normal to that.
//!
//! **Flow.** Along Mσ₁ − σ₃, M = (1 + sin ψ)/(1 − sin ψ). The envelope flattens under confinement, so a constant ψ
//! would give out energy there: M is kept below the envelope's slope 1 + a m_b u^(a−1) at the trial stress, and a
//! step that ends where the slope is less is done again with that one. Less dilation ends less confined, so
//! M stays below the slope at the end and σ:dε_p = Γ(Mσ₁ − σ₃) ≥ 0.
//!
//! **Return.** Geometry as for Mohr–Coulomb; along face or edge the multiplier solves one equation, which becomes
//! x + C x^(1/a) = 1 for the scaled root of the envelope (`hoek_brown/envelope.rs`): monotone and convex, so a fixed
//! number of Newton's steps reaches round-off for every C. At the apex, where the envelope's slope is vertical, the
//! equation stays smooth; beyond it the cut-off answers.
//!
//! **Measures.** History as with Mohr–Coulomb; `state` sums 1 (shear now), 2 (tension now), 4 (shear in an earlier
//! step), 8 (tension earlier).
//!
//! **Not modelled.** Softening (fall of GSI), the intermediate principal stress in strength, the change from brittle
//! to ductile at high confinement, directions of jointing, pore pressure, rate.

mod envelope;
mod parameters;

use super::elastic::soft_for_its_strength;
use super::plastic::flow::{Flow, Way};
use super::plastic::tension::{CutOff, Returned};
use super::plastic::{COLUMNS, Elasticity, blur, mean_and_radius, unyielding};
use crate::lane::Lane;
use crate::material::{Material, Moduli, Point, Sym, complementary_energy};
use crate::parameter::{BadParameter, Column, Derived, Parameter, Values};
use crate::sym3::Spectrum;
use envelope::Envelope;

/// The law for one rock mass; see the [module](self).
#[derive(Clone, Copy, Debug)]
pub struct HoekBrown {
    elasticity: Elasticity,
    envelope: Envelope,
    /// M of the dilation angle given.
    flow: f64,
    /// f_t, cut at the apex \[Pa\], and σ₃ of the envelope there.
    cut_off: [f64; 2],
    /// f_t as given.
    tensile: f64,
}

impl HoekBrown {
    /// m_b, s and a of the rock mass.
    pub fn constants(&self) -> [f64; 3] {
        [self.envelope.mb, self.envelope.s, self.envelope.a]
    }

    /// σ_ci \[Pa\].
    pub fn intact_strength(&self) -> f64 {
        self.envelope.sci
    }

    /// f_t \[Pa\] in use, not beyond the apex s σ_ci/m_b.
    pub fn tensile_strength(&self) -> f64 {
        self.cut_off[0]
    }

    /// Return to the envelope alone, then the cut-off, for flow with slope M. `excess` is that of the trial.
    #[inline(always)]
    fn returned<L: Lane>(&self, s: &[L; 3], excess: L, flow: &Flow<L>) -> Returned<L> {
        let zero = L::splat(0.0);
        let face = flow.on_face(s);
        let (reach, is_12) = flow.first_edge(s);
        let there = [face.a1.neg_mul_add(reach, face.first), face.a3.neg_mul_add(reach, face.third)];
        let on_edge = zero.less(self.envelope.excess(there[0], there[1]));
        let way: Way<L> = flow.on_edge(s, on_edge, is_12);
        let [first, third, none] = self.envelope.meet(&way);
        let sheared = way.end(first, third, (way.first - first) / way.a1);
        let failing = zero.less(excess);
        let sheared = [
            L::select(failing, sheared[0], s[0]),
            L::select(failing, sheared[1], s[1]),
            L::select(failing, sheared[2], s[2]),
        ];
        let [strength, low] = self.cut_off;
        let cut_off = CutOff { strength: L::splat(strength), low: L::splat(low) };
        let no_answer = L::both(failing, zero.less(none));
        let beyond = L::either(no_answer, cut_off.strength.less(sheared[0]));
        cut_off.complete(&self.elasticity, s, sheared, beyond)
    }
}

impl Material for HoekBrown {
    const NAME: &'static str = "hoek-brown";
    const SUMMARY: &'static str = "rock mass, generalised Hoek–Brown (2002) with tension cut-off";
    const SOURCE: &'static str = "hoek2002, generalised criterion with m_b, s, a and the tensile strength";
    const PARAMETERS: &'static [Parameter] = parameters::PARAMETERS;
    const HISTORY: &'static [Column] = &COLUMNS;
    const FLOWS: bool = true;
    const PRESSURE_DEPENDENT: bool = true;
    type History<L: Lane> = [L; 10];

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        parameters::read(values)
    }

    fn moduli(&self) -> Moduli {
        self.elasticity.moduli()
    }

    fn scaled(&self, factor: f64) -> Self {
        let elasticity = Elasticity::new(self.moduli().scaled(factor));
        HoekBrown { elasticity, ..*self }
    }

    fn derived(&self, _: [f64; 2]) -> Vec<Derived> {
        let [mb, s, a] = self.constants();
        vec![
            Derived::new("m_b", mb, "1", "m_i exp[(GSI − 100)/(28 − 14D)]"),
            Derived::new("s", s, "1", "exp[(GSI − 100)/(9 − 3D)]"),
            Derived::new("a", a, "1", "½ + (e^(−GSI/15) − e^(−20/3))/6"),
            Derived::new(
                "compressive_strength",
                self.envelope.uniaxial(),
                "Pa",
                "σ_ci s^a, of the rock mass",
            ),
            Derived::new(
                "apex",
                self.envelope.apex(),
                "Pa",
                "s σ_ci/m_b, all-round tension that the envelope allows",
            ),
            Derived::new("tensile_strength", self.cut_off[0], "Pa", "f_t in use, not beyond the apex"),
        ]
    }

    fn warnings(&self) -> Vec<String> {
        let mut warnings = Vec::from_iter(soft_for_its_strength(&self.moduli(), self.envelope.uniaxial()));
        if self.tensile > self.cut_off[0] {
            warnings.push(format!(
                "tensile_strength {:.3e} Pa lies beyond the apex s σ_ci/m_b = {:.3e} Pa, which is used instead",
                self.tensile, self.cut_off[0]
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
        super::plastic::hourglass_share(self.envelope.uniaxial() / 3f64.sqrt(), self.elasticity.mu, history)
    }

    #[inline(always)]
    fn update<L: Lane>(&self, _: &Point<L>, strain: Sym<L>, old: [L; 10]) -> (Sym<L>, [L; 10]) {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let trial = self.elasticity.trial(&strain, &old);
        let ft = L::splat(self.cut_off[0]);
        let round_off = L::splat(self.elasticity.round_off);

        // σ₁ ≤ p + 2r and σ₁ − σ₃ ≤ 2√3 r, and a lower bound of the envelope that needs no power.
        let (mean, radius) = mean_and_radius(&trial);
        let largest = mean + (radius + radius);
        let spread = radius * L::splat(2.0 * 3f64.sqrt());
        if !L::any(L::not(L::both(largest.less(zero), spread.less(self.envelope.floor(largest))))) {
            return unyielding(trial, old);
        }
        let spectrum = Spectrum::of(&trial);
        let [first, _, third] = spectrum.values();
        let margin = blur(&spectrum);
        // The envelope grows with pressure, so that σ₁ a little higher is on the safe side.
        let near = round_off.less(self.envelope.excess(first + margin, third - margin));
        if !L::any(L::either(near, round_off.less(first - ft + margin))) {
            return unyielding(trial, old);
        }

        let eigen = spectrum.eigen();
        let s = &eigen.values;
        let excess = self.envelope.excess(s[0], s[2]);
        let yielding = L::either(round_off.less(excess), round_off.less(s[0] - ft));
        if self.flow > 1.0 {
            let ratio = L::splat(self.flow).smaller(self.envelope.slope(s[0], s[2], excess));
            let flow = Flow::new(&self.elasticity, ratio);
            let mut returned = self.returned(s, excess, &flow);
            let end = &returned.stress;
            let limit = self.envelope.slope(end[0], end[2], zero);
            let steep = L::both(L::both(yielding, L::not(returned.tension)), limit.less(ratio));
            let flow = Flow::new(&self.elasticity, L::select(steep, limit, ratio));
            if L::any(steep) {
                returned = self.returned(s, excess, &flow);
            }
            flow.book(&self.elasticity, &trial, &eigen, &returned, yielding, &old)
        } else {
            let flow = Flow::new(&self.elasticity, one);
            let returned = self.returned(s, excess, &flow);
            flow.book(&self.elasticity, &trial, &eigen, &returned, yielding, &old)
        }
    }
}
