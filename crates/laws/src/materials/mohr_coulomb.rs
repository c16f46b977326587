//! Mohr–Coulomb with a tension cut-off: elastic, perfectly plastic or softening, not associated.
//!
//! **The law.** With principal stresses σ₁ ≥ σ₂ ≥ σ₃ (tension positive), k = (1 + sin φ)/(1 − sin φ) and
//! f_c = 2c√k, shear yields where k σ₁ − σ₃ = f_c and flows along M σ₁ − σ₃, M = (1 + sin ψ)/(1 − sin ψ); tension
//! yields where σ₁ = f_t and flows normal to that. f_t is cut at the apex c/tan φ. The return to face, edges, apex
//! and cut-off is exact for a given strain (clausen2007 for the geometry in principal stresses): every surface is a
//! plane and ψ is constant in a step, so one linear solution holds, and which one follows from the trial stress (see
//! `plastic/flow.rs` and `plastic/tension.rs`). No iteration.
//!
//! **Softening.** The table `softening` gives c, φ, ψ and f_t against the accumulated slip across the element, with
//! straight lines between its rows, φ and ψ as angles; the last row stays. Strength may also rise, as friction does
//! while cohesion is lost in brittle rock. With a column of openings f_t goes by whichever displacement has come further
//! down the table. ψ is never above φ. A step uses the strength that the steps before left: the error is of first order in
//! the step of slip, which explicit steps keep tiny.
//!
//! The slip is 2hΓ with the element's extent h across the band (`plastic/slip.rs`): a band dissipates the same energy per
//! area in elements of any size. Larger elements than [`Material::size_limit`] would give out energy as they soften: with
//! sides that are free, the axial stress falls at 2h√((M² + M + 1)/3) times its slope over the slip, and by that no faster
//! than E. The slope is that at a confinement of 0 or of f_c at the peak, whichever falls faster; the second is an assumption
//! (loss of friction counts by the pressure). A table over the plastic shear strain itself has no length: what it
//! dissipates per area grows with the element, and results depend on the mesh, unless a relaxation time gives bands a width
//! (`plastic/relaxation.rs`).
//!
//! **Measures.** `plastic_shear_strain` accumulates √J₂ of the plastic strain of each face that flows; under pure
//! shear with ψ = 0 that is half the engineering shear strain. `plastic_tension_strain` accumulates the lengthening
//! that the cut-off adds; in a step, a billionth of the elastic strain is no opening. `state` sums 1 (shear now), 2 (tension now), 4 (shear in an earlier step), 8 (tension
//! earlier).
//!
//! **Energy.** Flow never gives out energy: σ:dε_p is Γ(Mσ₁ − σ₃) ≥ Γ f_c (M − 1)/(k − 1) on the envelope, f_t times
//! the opening on the cut-off.
//!
//! **Not modelled.** The intermediate principal stress in strength, closing of tension cracks (a tension strain
//! stays), pore pressure, rate but for the relaxation time, creep, joints with a direction.

mod parameters;
mod softening;

use super::elastic::soft_for_its_strength;
use super::plastic::flow::Flow;
use super::plastic::relaxation::{self, Relaxation};
use super::plastic::slip::{self, LONG_COLUMNS, LongMemory, Measure};
use super::plastic::tension::CutOff;
use super::plastic::{Elasticity, blur, mean_and_radius, unyielding};
use crate::lane::Lane;
use crate::material::{Facts, Material, Moduli, Point, Softens, Sym, complementary_energy};
use crate::parameter::{BadParameter, Column, Derived, Parameter, Values};
use crate::sym3::Spectrum;
use softening::Softening;

/// The law for one rock; see the [module](self).
#[derive(Clone, Debug)]
pub struct MohrCoulomb {
    elasticity: Elasticity,
    /// As given; the apex may cut it.
    tensile: f64,
    peak: Strength<f64>,
    softening: Option<Softening>,
    /// \[m\]
    size_limit: f64,
    relaxation: Option<Relaxation>,
}

/// The yield surface in numbers.
#[derive(Clone, Copy, Debug)]
struct Strength<L> {
    /// k = (1 + sin φ)/(1 − sin φ)
    slope: L,
    /// f_c = 2c√k \[Pa\]
    fc: L,
    /// f_t, cut at the apex \[Pa\]
    ft: L,
    /// 2√(k² + k + 1), the largest that kσ₁ − σ₃ can be for a deviator of radius 1
    reach: L,
    /// M, not above k
    flow: L,
}

impl<L: Lane> Strength<L> {
    #[inline(always)]
    fn new(slope: L, cohesion: L, ft: L, flow: L) -> Self {
        let one = L::splat(1.0);
        let fc = L::splat(2.0) * cohesion * slope.sqrt();
        // Without friction there is no apex: the division gives no number or infinity, and f_t stays.
        let apex = fc / (slope - one);
        Strength {
            slope,
            fc,
            ft: apex.smaller(ft),
            reach: L::splat(2.0) * (slope + one).mul_add(slope, one).sqrt(),
            flow: flow.smaller(slope),
        }
    }

    /// kσ₁ − σ₃ − f_c
    #[inline(always)]
    fn excess(&self, first: L, third: L) -> L {
        self.slope.mul_add(first, -(third + self.fc))
    }
}

impl MohrCoulomb {
    /// c \[Pa\], φ \[rad\] and f_t \[Pa\] in use after plastic strains of shear and tension, or a slip and an opening \[m\] where the
    /// table is over displacement; f_t not beyond c/tan φ.
    pub fn strength(&self, shear: f64, tension: f64) -> [f64; 3] {
        let memory = self.measure().memory(shear, tension);
        let Strength { slope, fc, ft, .. } = self.surface(&memory);
        [0.5 * fc / slope.sqrt(), ((slope - 1.0) / (slope + 1.0)).asin(), ft]
    }

    fn measure(&self) -> Measure {
        self.softening.as_ref().map_or(Measure::Strain, |softening| softening.measure)
    }

    /// Whether strength goes by displacements, which the history then keeps.
    #[inline(always)]
    fn slips(&self) -> bool {
        matches!(&self.softening, Some(softening) if softening.measure == Measure::Displacement)
    }

    /// See [`Relaxation::growth_time`].
    fn growth_time(&self) -> Option<f64> {
        let softening = self.softening.as_ref().filter(|softening| softening.falls())?;
        let relaxation = self.relaxation.as_ref()?;
        Some(relaxation.growth_time(self.elasticity.mu, softening.stages().into_iter()))
    }

    /// The surface as lanes see it after what they went through.
    #[inline(always)]
    fn surface<L: Lane>(&self, old: &LongMemory<L>) -> Strength<L> {
        match &self.softening {
            None => Strength {
                slope: L::splat(self.peak.slope),
                fc: L::splat(self.peak.fc),
                ft: L::splat(self.peak.ft),
                reach: L::splat(self.peak.reach),
                flow: L::splat(self.peak.flow),
            },
            Some(softening) => {
                let [shear, tension] = softening.measure.of(old);
                let left = softening.left(shear, tension);
                Strength::new(left.slope, left.cohesion, left.tensile, left.flow)
            }
        }
    }
}

impl Material for MohrCoulomb {
    const NAME: &'static str = "mohr-coulomb";
    const SUMMARY: &'static str = "rock, Mohr–Coulomb with tension cut-off, dilation and softening";
    const SOURCE: &'static str = "clausen2007, returns in principal stresses; tension cut-off added";
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

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        parameters::read(values)
    }

    fn moduli(&self) -> Moduli {
        self.elasticity.moduli()
    }

    fn scaled(&self, factor: f64) -> Self {
        let elasticity = Elasticity::new(self.moduli().scaled(factor));
        MohrCoulomb { elasticity, size_limit: factor * self.size_limit, ..self.clone() }
    }

    fn asks_size(&self) -> bool {
        self.slips()
    }

    fn size_limit(&self) -> f64 {
        self.size_limit
    }

    fn softens(&self) -> Softens {
        match &self.softening {
            Some(softening) if softening.falls() => match (softening.measure, self.growth_time()) {
                (Measure::Displacement, _) => Softens::OverDisplacement,
                (Measure::Strain, None) => Softens::OverStrain,
                (Measure::Strain, Some(time)) => Softens::Relaxing(time),
            },
            _ => Softens::Never,
        }
    }

    fn derived(&self, _: [f64; 2]) -> Vec<Derived> {
        let peak = &self.peak;
        let mut all = vec![
            Derived::new(
                "compressive_strength",
                peak.fc,
                "Pa",
                "2c cos φ/(1 − sin φ), uniaxial, at the peak",
            ),
            Derived::new("slope", peak.slope, "1", "k = (1 + sin φ)/(1 − sin φ)"),
        ];
        if peak.slope > 1.0 {
            let doc = "c/tan φ, all-round tension that the envelope allows";
            all.push(Derived::new("apex", peak.fc / (peak.slope - 1.0), "Pa", doc));
        }
        all.push(Derived::new("tensile_strength", peak.ft, "Pa", "f_t in use, not beyond the apex"));
        all.extend(slip::derived(self.size_limit));
        all.extend(relaxation::derived(self.growth_time()));
        all
    }

    fn warnings(&self) -> Vec<String> {
        let mut warnings = Vec::from_iter(soft_for_its_strength(&self.moduli(), self.peak.fc));
        if self.tensile > self.peak.ft {
            warnings.push(format!(
                "tensile_strength {:.3e} Pa lies beyond the apex c/tan φ = {:.3e} Pa, which is used instead",
                self.tensile, self.peak.ft
            ));
        }
        if self.softens() == Softens::OverStrain {
            warnings.push(slip::without_length("softening"));
        }
        warnings
    }

    #[inline(always)]
    fn stored_energy<L: Lane>(&self, _: &Sym<L>, stress: &Sym<L>, _: &LongMemory<L>) -> L {
        complementary_energy(self.moduli(), stress)
    }

    #[inline(always)]
    fn hourglass_share<L: Lane>(&self, history: &LongMemory<L>) -> L {
        super::plastic::hourglass_share(self.peak.fc / 3f64.sqrt(), self.elasticity.mu, &slip::short(history))
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
        let strength = self.surface(&before);
        let (slope, ft) = (strength.slope, strength.ft);
        let round_off = L::splat(self.elasticity.round_off);

        // Inside the cone around the pyramid and below the cut-off for every direction of the deviator.
        let (mean, radius) = mean_and_radius(&trial);
        let cone = (slope - one).mul_add(mean, strength.reach.mul_add(radius, -strength.fc));
        let largest = mean + (radius + radius) - ft;
        if !L::any(L::either(round_off.less(cone), round_off.less(largest))) {
            let (stress, new) = unyielding(trial, old);
            return (stress, slip::kept(&new, &before));
        }
        let spectrum = Spectrum::of(&trial);
        let [first, _, third] = spectrum.values();
        let margin = blur(&spectrum);
        let near_shear = round_off.less(strength.excess(first, third) + margin * (slope + one));
        if !L::any(L::either(near_shear, round_off.less(first - ft + margin))) {
            let (stress, new) = unyielding(trial, old);
            return (stress, slip::kept(&new, &before));
        }

        let eigen = spectrum.eigen();
        let s = &eigen.values;
        let excess = strength.excess(s[0], s[2]);
        let yielding = L::either(round_off.less(excess), round_off.less(s[0] - ft));
        let flow = Flow::new(&self.elasticity, strength.flow);
        let face = flow.on_face(s);
        let (reach, is_12) = flow.first_edge(s);
        let on_edge = (reach * slope.mul_add(face.a1, -face.a3)).less(excess);
        let way = flow.on_edge(s, on_edge, is_12);
        let gamma = strength.excess(way.first, way.third) / slope.mul_add(way.a1, -way.a3);
        let gamma = zero.larger(gamma);
        let sheared =
            way.end(way.a1.neg_mul_add(gamma, way.first), way.a3.neg_mul_add(gamma, way.third), gamma);
        let cut_off = CutOff { strength: ft, low: ft.smaller(slope.mul_add(ft, -strength.fc)) };
        let mut returned = cut_off.complete(&self.elasticity, s, sheared, ft.less(sheared[0]));
        if let Some(relaxation) = &self.relaxation {
            relaxation.relax(s, &mut returned, point.dt);
        }
        let (stress, new) = flow.book(&self.elasticity, &trial, &eigen, &returned, yielding, &old);
        if self.slips() {
            (stress, slip::advanced(point, &eigen.vectors[0], &new, &before))
        } else {
            (stress, slip::kept(&new, &before))
        }
    }
}
