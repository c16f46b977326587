//! Generalised Hoek–Brown with a tension cut-off: elastic, perfectly plastic or softening, not associated.
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
//! **Softening.** `residual` gives GSI and D of the residual state and the slip across the element at which it is reached; m_b, s and
//! a change with the slip along straight lines (an assumption), and f_t is cut at the apex that they leave. Slip, extent and limit
//! of size are those of Mohr–Coulomb's softening (`plastic/slip.rs`). A step uses the strength that the steps before left.
//!
//! **Measures.** History as with Mohr–Coulomb; `state` sums 1 (shear now), 2 (tension now), 4 (shear in an earlier
//! step), 8 (tension earlier).
//!
//! **Not modelled.** The intermediate principal stress in strength, the change from brittle
//! to ductile at high confinement, directions of jointing, pore pressure, rate but for the relaxation time.

mod envelope;
mod parameters;
mod residual;

use super::elastic::soft_for_its_strength;
use super::plastic::flow::{Flow, Way};
use super::plastic::relaxation::{self, Relaxation};
use super::plastic::slip::{self, LONG_COLUMNS, LongMemory, Measure};
use super::plastic::tension::{CutOff, Returned};
use super::plastic::{Elasticity, blur, mean_and_radius, unyielding};
use crate::lane::Lane;
use crate::material::{Facts, Material, Moduli, Point, Softens, Sym, complementary_energy};
use crate::parameter::{BadParameter, Column, Derived, Parameter, Values};
use crate::sym3::Spectrum;
use envelope::Envelope;
use residual::Residual;

/// The law for one rock mass; see the [module](self).
#[derive(Clone, Copy, Debug)]
pub struct HoekBrown {
    elasticity: Elasticity,
    envelope: Envelope<f64>,
    /// M of the dilation angle given.
    flow: f64,
    /// f_t, cut at the apex \[Pa\], and σ₃ of the envelope there.
    cut_off: [f64; 2],
    /// f_t as given.
    tensile: f64,
    residual: Option<Residual>,
    /// \[m\]
    size_limit: f64,
    relaxation: Option<Relaxation>,
}

/// The surface as lanes see it.
#[derive(Clone, Copy)]
struct Surface<L> {
    envelope: Envelope<L>,
    cut_off: CutOff<L>,
}

impl HoekBrown {
    /// m_b, s and a of the rock mass at the peak.
    pub fn constants(&self) -> [f64; 3] {
        [self.envelope.mb, self.envelope.s, self.envelope.a]
    }

    /// m_b, s, a and f_t \[Pa\] in use after a plastic shear strain, or a slip \[m\] where the residual state is reached by slip.
    pub fn strength(&self, shear: f64) -> [f64; 4] {
        let measure = self.residual.map_or(Measure::Strain, |residual| residual.measure);
        let Surface { envelope, cut_off } = self.surface(&measure.memory(shear, 0.0));
        [envelope.mb, envelope.s, envelope.a, cut_off.strength]
    }

    /// Whether strength goes by a slip, which the history then keeps.
    #[inline(always)]
    fn slips(&self) -> bool {
        matches!(&self.residual, Some(residual) if residual.measure == Measure::Displacement)
    }

    /// See [`Relaxation::growth_time`].
    fn growth_time(&self) -> Option<f64> {
        let (residual, relaxation) = (self.residual.as_ref()?, self.relaxation.as_ref()?);
        let stage = residual.stage(&self.envelope, self.flow);
        Some(relaxation.growth_time(self.elasticity.mu, std::iter::once(stage)))
    }

    /// The surface as lanes see it after what they went through.
    #[inline(always)]
    fn surface<L: Lane>(&self, old: &LongMemory<L>) -> Surface<L> {
        let envelope = self.envelope.splat();
        let [strength, low] = self.cut_off;
        let peak = Surface { envelope, cut_off: CutOff { strength: L::splat(strength), low: L::splat(low) } };
        let Some(residual) = &self.residual else { return peak };
        let done = residual.done(old);
        let changed = L::splat(0.0).less(done);
        if !L::any(changed) {
            return peak;
        }
        let envelope = envelope.changed(changed, residual.constants(&self.envelope, done));
        let [strength, low] = envelope.cut_off(changed, self.tensile, self.cut_off);
        Surface { envelope, cut_off: CutOff { strength, low } }
    }

    /// σ_ci \[Pa\].
    pub fn intact_strength(&self) -> f64 {
        self.envelope.sci
    }

    /// f_t \[Pa\] in use at the peak, not beyond the apex s σ_ci/m_b.
    pub fn tensile_strength(&self) -> f64 {
        self.cut_off[0]
    }

    /// Return to the envelope alone, then the cut-off, for flow with slope M. `excess` is that of the trial.
    #[inline(always)]
    fn returned<L: Lane>(&self, surface: &Surface<L>, s: &[L; 3], excess: L, flow: &Flow<L>) -> Returned<L> {
        let zero = L::splat(0.0);
        let Surface { envelope, cut_off } = surface;
        let face = flow.on_face(s);
        let (reach, is_12) = flow.first_edge(s);
        let there = [face.a1.neg_mul_add(reach, face.first), face.a3.neg_mul_add(reach, face.third)];
        let on_edge = zero.less(envelope.excess(there[0], there[1]));
        let way: Way<L> = flow.on_edge(s, on_edge, is_12);
        let [first, third, none] = envelope.meet(&way);
        let sheared = way.end(first, third, (way.first - first) / way.a1);
        let failing = zero.less(excess);
        let sheared = [
            L::select(failing, sheared[0], s[0]),
            L::select(failing, sheared[1], s[1]),
            L::select(failing, sheared[2], s[2]),
        ];
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
    const HISTORY: &'static [Column] = &LONG_COLUMNS;
    const NEEDS_SIZE: bool = true;
    const FLOWS: bool = true;
    const PRESSURE_DEPENDENT: bool = true;
    type History<L: Lane> = LongMemory<L>;

    #[inline(always)]
    fn facts(&self) -> Facts {
        slip::facts::<Self>(self.slips())
    }

    #[inline(always)]
    fn columns(&self) -> &'static [Column] {
        slip::columns(self.slips())
    }

    fn asks_size(&self) -> bool {
        self.slips()
    }

    fn size_limit(&self) -> f64 {
        self.size_limit
    }

    fn softens(&self) -> Softens {
        match (&self.residual, self.growth_time()) {
            (None, _) => Softens::Never,
            (Some(Residual { measure: Measure::Displacement, .. }), _) => Softens::OverDisplacement,
            (Some(_), None) => Softens::OverStrain,
            (Some(_), Some(time)) => Softens::Relaxing(time),
        }
    }

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        parameters::read(values)
    }

    fn moduli(&self) -> Moduli {
        self.elasticity.moduli()
    }

    fn scaled(&self, factor: f64) -> Self {
        let elasticity = Elasticity::new(self.moduli().scaled(factor));
        HoekBrown { elasticity, size_limit: factor * self.size_limit, ..*self }
    }

    fn derived(&self, _: [f64; 2]) -> Vec<Derived> {
        let [mb, s, a] = self.constants();
        let mut all = vec![
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
        ];
        if let Some(residual) = &self.residual {
            let [mb, s, a] = residual.end;
            all.extend([
                Derived::new("residual_m_b", mb, "1", "m_b of the residual state"),
                Derived::new("residual_s", s, "1", "s of the residual state"),
                Derived::new("residual_a", a, "1", "a of the residual state"),
            ]);
        }
        all.extend(slip::derived(self.size_limit));
        all.extend(relaxation::derived(self.growth_time()));
        all
    }

    fn warnings(&self) -> Vec<String> {
        let mut warnings = Vec::from_iter(soft_for_its_strength(&self.moduli(), self.envelope.uniaxial()));
        if self.tensile > self.cut_off[0] {
            warnings.push(format!(
                "tensile_strength {:.3e} Pa lies beyond the apex s σ_ci/m_b = {:.3e} Pa, which is used instead",
                self.tensile, self.cut_off[0]
            ));
        }
        if self.softens() == Softens::OverStrain {
            warnings.push(slip::without_length("residual"));
        }
        warnings
    }

    #[inline(always)]
    fn stored_energy<L: Lane>(&self, _: &Sym<L>, stress: &Sym<L>, _: &LongMemory<L>) -> L {
        complementary_energy(self.moduli(), stress)
    }

    #[inline(always)]
    fn hourglass_share<L: Lane>(&self, history: &LongMemory<L>) -> L {
        let strength = self.envelope.uniaxial() / 3f64.sqrt();
        super::plastic::hourglass_share(strength, self.elasticity.mu, &slip::short(history))
    }

    #[inline(always)]
    fn update<L: Lane>(
        &self,
        point: &Point<L>,
        strain: Sym<L>,
        before: LongMemory<L>,
    ) -> (Sym<L>, LongMemory<L>) {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let old = slip::short(&before);
        let trial = self.elasticity.trial(&strain, &old);
        let surface = self.surface(&before);
        let Surface { envelope, cut_off } = &surface;
        let ft = cut_off.strength;
        let round_off = L::splat(self.elasticity.round_off);

        // σ₁ ≤ p + 2r and σ₁ − σ₃ ≤ 2√3 r, and a lower bound of the envelope that needs no power.
        let (mean, radius) = mean_and_radius(&trial);
        let largest = mean + (radius + radius);
        let spread = radius * L::splat(2.0 * 3f64.sqrt());
        if !L::any(L::not(L::both(largest.less(zero), spread.less(envelope.floor(largest))))) {
            let (stress, new) = unyielding(trial, old);
            return (stress, slip::kept(&new, &before));
        }
        let spectrum = Spectrum::of(&trial);
        let [first, _, third] = spectrum.values();
        let margin = blur(&spectrum);
        // The envelope grows with pressure, so that σ₁ a little higher is on the safe side.
        let near = round_off.less(envelope.excess(first + margin, third - margin));
        if !L::any(L::either(near, round_off.less(first - ft + margin))) {
            let (stress, new) = unyielding(trial, old);
            return (stress, slip::kept(&new, &before));
        }

        let eigen = spectrum.eigen();
        let s = &eigen.values;
        let excess = envelope.excess(s[0], s[2]);
        let yielding = L::either(round_off.less(excess), round_off.less(s[0] - ft));
        let (stress, new) = if self.flow > 1.0 {
            let ratio = L::splat(self.flow).smaller(envelope.slope(s[0], s[2], excess));
            let flow = Flow::new(&self.elasticity, ratio);
            let mut returned = self.returned(&surface, s, excess, &flow);
            let end = &returned.stress;
            let limit = envelope.slope(end[0], end[2], zero);
            let steep = L::both(L::both(yielding, L::not(returned.tension)), limit.less(ratio));
            let flow = Flow::new(&self.elasticity, L::select(steep, limit, ratio));
            if L::any(steep) {
                returned = self.returned(&surface, s, excess, &flow);
            }
            if let Some(relaxation) = &self.relaxation {
                relaxation.relax(s, &mut returned, point.dt);
            }
            flow.book(&self.elasticity, &trial, &eigen, &returned, yielding, &old)
        } else {
            let flow = Flow::new(&self.elasticity, one);
            let mut returned = self.returned(&surface, s, excess, &flow);
            if let Some(relaxation) = &self.relaxation {
                relaxation.relax(s, &mut returned, point.dt);
            }
            flow.book(&self.elasticity, &trial, &eigen, &returned, yielding, &old)
        };
        if self.slips() {
            (stress, slip::advanced(point, &eigen.vectors[0], &new, &before))
        } else {
            (stress, slip::kept(&new, &before))
        }
    }
}
