//! Concrete with rate-dependent damage, separate in tension and in shear.
//!
//! Wang, Chen, Xiao & Deng (2018), equations (1)–(16). Strain ε is counted since the concrete was placed, σ̂_i and
//! p_i are principal values and directions of the effective stress C : ε.
//!
//! - (2)–(7) σ = Σ (1 − D_i) σ̂_i p_i⊗p_i, D_i = D⁺ where σ̂_i ≥ 0, else D⁻: a crack that closes carries pressure again.
//! - (8)–(12) tension: ε̄ = √Σ⟨ε_i⟩²; D⁺ = 0 below ε_t = f_ε f_t/E, then 1 − α ε_t/ε̄, and 1 beyond ε_u = f_ε ε_us.
//! - (13)–(16) shear, compression positive, c1 ≥ c2 ≥ c3: D⁻ = 1 − β ε_c/e1 from e1 = ε_c on,
//!   ε_c = \[f_c + N c3′ − ν(c2 + c3)\]/E, N = (1 + sin φ)/(1 − sin φ), e1 the largest compressive strain.
//!   As e1 = \[c1 − ν(c2 + c3)\]/E this is Mohr–Coulomb's c1 ≥ f_c + N c3′.
//! - Both are running maxima. Rates are those of strains smoothed over τ, so that noise of the mesh is none (smoothed
//!   every few steps, `concrete/rate.rs`); factors are frozen at first damage, since the rate of a localised crack is an
//!   artefact of the mesh.
//!
//! **Where the print is corrected.** (14) prints the stresses without 1/E and ν(σ1 + σ2): units, and the strain in
//! the direction of c1 has ν(c2 + c3). (12) prints ε̇_s = 0.3 s⁻¹, which no earthquake reaches. Its exponent
//! is that of Model Code 1990 for the strain at the largest stress, whose references are 3·10⁻⁶ s⁻¹ in tension (12) and 3·10⁻⁵ s⁻¹
//! in compression (16); `reference_rate = 0.3` brings the print back. (13) with effective tension fails any
//! cracked point under a trace of compression: c3′ = (1 − D⁺) c3 in tension (`shear_tension = "effective"` is the
//! print). In (7) the effective split has no potential where ν ≠ 0 and D⁺ ≠ D⁻: a closed loop of strain at fixed
//! damage can give out work, 0.3 to 0.4 of its peak energy (the worst of 300 random loops of principal strain at
//! D⁺ = 0.9, D⁻ = 0); `split = "compliance"`, the default, cannot, and its dissipation is never negative. What
//! either split takes and the effective one gives out is booked (`concrete/energy.rs`).
//!
//! **Beyond the paper.** `evolution = "exponential"`, the default, is the crack band (Bažant & Oh 1983),
//! D⁺ = 1 − (ε_t/ε̄) exp\[−(ε̄ − ε_t)/ε_f\], ε_f = f_ε\[G_f/(f_t h) − ½ε_ts\], with the element's extent h across the
//! crack. `evolution = "residual"` is the paper's plateau, to which the stress drops at once: strength at corners
//! falls with the element size (`concrete/corner.rs`). There `fracture_energy` sets
//! ε_us = ε_ts + (G_f/h − ½f_t ε_ts)/(α f_t). `driver = "stress"` takes ε̄ = √Σ⟨σ̂_i⟩²/E.
//!
//! **Not modelled.** Plastic strain (a crack closes fully), the intermediate principal stress in shear, crushing
//! energy and with it objectivity in compression (the β plateau does not soften), creep, shrinkage, temperature,
//! reinforcement. Uniaxial compression raises D⁺ through Poisson's expansion when strain drives it; the pressure
//! does not feel it, a later reversal does. Strength under biaxial tension, triaxial tension and pure shear is
//! 0.85, 0.87 and 0.85 f_t (ν = 0.17), driven by stress 0.71, 0.58 and 1 f_t; under biaxial compression f_c, where
//! Kupfer (1969) measured 1.16 f_c. In tension–compression it lies 7 % below Kupfer & Gerstle (1973) at σ_c = 0.1 f_c, 31 % at
//! 0.3 f_c and cracks under pressure alone near 0.5 f_c; driven by stress 9 to 24 % above.

mod corner;
mod damping;
mod derived;
mod energy;
mod faults;
mod grade;
mod opening;
mod parameters;
mod rate;
mod read;
mod step;
mod stress;
mod thresholds;
mod unusual;

pub use grade::{GRADES, Grade};
pub use rate::{Power, Rate};

use crate::lane::{Lane, Octet};
use crate::material::{InPlace, Material, Moduli, Point, Sym, load, store};
use crate::parameter::{BadParameter, Column, Derived, Parameter, Role, Values};

#[derive(Clone, Copy, Debug, PartialEq)]
enum Driver {
    Strain,
    Stress,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Split {
    Effective,
    Compliance,
}

/// Softening in tension.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Evolution {
    /// Plateau up to ε_us = `ratio` ε_ts.
    Ratio { ratio: f64 },
    /// Plateau, ε_us from G_f \[N/m\] and the element's extent.
    Energy { energy: f64 },
    /// Crack band from G_f \[N/m\].
    Exponential { energy: f64 },
}

/// The law for one concrete; see the [module](self).
#[derive(Clone, Copy, Debug)]
pub struct Concrete {
    moduli: Moduli,
    young: f64,
    poisson: f64,
    ft: f64,
    fc: f64,
    /// N
    slope: f64,
    alpha: f64,
    beta: f64,
    evolution: Evolution,
    rate: Option<Rate>,
    driver: Driver,
    split: Split,
    /// Whether c3′ is what a crack carries.
    nominal: bool,
    /// f_c \[Pa\] of the grade where a cohesion stands for it.
    replaced: Option<f64>,
    /// Whether G_f is Model Code's by f_c, since nothing gives it.
    energy_of_strength: bool,
    idle: unusual::Idle,
}

// Positions in the history, in the order of `COLUMNS`.
const D_TENSION: usize = 0;
const D_SHEAR: usize = 1;
const D_B: usize = 2;
const D_B_MAX: usize = 3;
const SMOOTHED_TENSION: usize = 4;
const SMOOTHED_SHEAR: usize = 5;
const FACTOR_TENSION: usize = 6;
const FACTOR_SHEAR: usize = 7;
const CRACK_SIZE: usize = 8;
const ENERGY_DISSIPATED: usize = 9;
const ENERGY_CREATED: usize = 10;
/// Three principal strains, falling.
const LAST_STRAIN: usize = 11;
const CRACK_WIDTH: usize = 14;
/// Six components of e⁺·G·e⁺ \[m²\].
const OPENINGS: usize = 15;
const MEMORY: usize = 21;
/// What steps read and write; the rest is found where somebody looks.
const IN_STEPS: usize = CRACK_WIDTH;

const fn openings(name: &'static str, role: Role) -> Column {
    Column::with_role(
        name,
        "m2",
        role,
        "component of e⁺·G·e⁺: principal values are the squares of how far cracks are open, directions their normals",
    )
}

const fn last_strain(name: &'static str) -> Column {
    Column::new(name, "1", "principal strain of the last step, once damaged")
}

const COLUMNS: [Column; MEMORY] = [
    Column::with_role("d_tension", "1", Role::TensionDamage, "D⁺, damage in tension"),
    Column::with_role("d_shear", "1", Role::ShearDamage, "D⁻, damage in shear"),
    Column::with_role("d_b", "1", Role::MeanDamage, "D_b, mean principal damage as the stress now feels it"),
    Column::with_role("d_b_max", "1", Role::MeanDamagePeak, "largest D_b so far"),
    Column::new("smoothed_tension", "1", "equivalent tensile strain, smoothed over the filter time"),
    Column::new("smoothed_shear", "1", "largest compressive strain, smoothed over the filter time"),
    Column::with_role(
        "factor_tension",
        "1",
        Role::TensionRateFactor,
        "rate factor f_ε at first damage in tension; 0 before",
    ),
    Column::with_role(
        "factor_shear",
        "1",
        Role::ShearRateFactor,
        "rate factor of f_c at first damage in shear; 0 before",
    ),
    Column::with_role(
        "crack_size",
        "m",
        Role::CrackExtent,
        "element's extent across the crack at first damage; 0 before",
    ),
    Column::with_role(
        "energy_dissipated",
        "J/m3",
        Role::Dissipated,
        "taken by growing damage: what ½σ:ε fell by at the strains at which it grew",
    ),
    Column::with_role(
        "energy_created",
        "J/m3",
        Role::Created,
        "work that the effective split gave out beyond what it took, since it has no potential",
    ),
    last_strain("last_e1"),
    last_strain("last_e2"),
    last_strain("last_e3"),
    Column::with_role(
        "crack_width",
        "m",
        Role::CrackWidth,
        "how far the widest crack is open: strain that the stress does not explain, over the element's extent along it",
    ),
    openings("openings_xx", Role::CrackOpenings),
    openings("openings_yy", Role::Own),
    openings("openings_zz", Role::Own),
    openings("openings_xy", Role::Own),
    openings("openings_yz", Role::Own),
    openings("openings_zx", Role::Own),
];

impl Concrete {
    /// Uniaxial tensile and compressive strength f_t, f_c \[Pa\], static.
    pub fn strengths(&self) -> [f64; 2] {
        [self.ft, self.fc]
    }

    /// The rate law, if there is one.
    pub fn rate(&self) -> Option<&Rate> {
        self.rate.as_ref()
    }

    /// Energy per area of a crack \[N/m\] that an element of extent `h` \[m\] across it dissipates, static rates.
    pub fn fracture_energy(&self, h: f64) -> f64 {
        match self.evolution {
            Evolution::Energy { energy } | Evolution::Exponential { energy } => energy,
            Evolution::Ratio { ratio } => {
                h * self.ft * self.ft / self.young * (0.5 + self.alpha * (ratio - 1.0))
            }
        }
    }
}

impl Material for Concrete {
    const NAME: &'static str = "concrete-damage";
    const SUMMARY: &'static str = "concrete, rate-dependent damage separate in tension and shear";
    const SOURCE: &'static str = "wang2018, (1)-(16)";
    const PARAMETERS: &'static [Parameter] = parameters::PARAMETERS;
    const HISTORY: &'static [Column] = &COLUMNS;
    const NEEDS_SIZE: bool = true;
    const DAMAGES: bool = true;
    const PRESSURE_DEPENDENT: bool = true;
    type History<L: Lane> = [L; MEMORY];

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        read::read(values)
    }

    fn moduli(&self) -> Moduli {
        self.moduli
    }

    fn scaled(&self, factor: f64) -> Self {
        let moduli = self.moduli.scaled(factor);
        Concrete { moduli, young: moduli.young(), ..*self }
    }

    fn slow_steps(&self, dt: f64) -> u64 {
        self.rate.map_or(1, |rate| rate.steps(dt))
    }

    /// 2 G_f E/f_t²: a larger element stores more than a crack dissipates.
    fn size_limit(&self) -> f64 {
        match self.evolution {
            Evolution::Ratio { .. } => f64::INFINITY,
            Evolution::Energy { energy } | Evolution::Exponential { energy } => {
                2.0 * energy * self.young / (self.ft * self.ft)
            }
        }
    }

    fn compressive_strength(&self) -> Option<f64> {
        Some(self.fc)
    }

    fn crack_energy(&self, extent: f64) -> Option<f64> {
        Some(self.fracture_energy(extent))
    }

    fn corner_strength(&self, extent: f64) -> Option<f64> {
        self.strength_at_a_corner(extent)
    }

    fn tension_use(&self, stress: &Sym<f64>, beside: &Sym<f64>, history: &[f64; MEMORY]) -> Option<f64> {
        Some(self.used(stress, beside, history))
    }

    fn uses_at_most(&self, stress: &Sym<f64>, share: f64) -> bool {
        self.surely_used_at_most(stress, share)
    }

    fn derived(&self, extents: [f64; 2]) -> Vec<Derived> {
        self.constants(extents)
    }

    fn warnings(&self) -> Vec<String> {
        self.unusual()
    }

    #[inline(always)]
    fn integrity<L: Lane>(&self, strain: &Sym<L>, history: &[L; MEMORY]) -> Sym<L> {
        self.left(strain, history)
    }

    /// 1 − max(D⁺, D⁻)
    #[inline(always)]
    fn unbroken<L: Lane>(&self, history: &[L; MEMORY]) -> L {
        L::splat(1.0) - history[D_TENSION].larger(history[D_SHEAR])
    }

    #[inline(always)]
    fn hourglass_share<L: Lane>(&self, history: &[L; MEMORY]) -> L {
        Self::bending_share(history)
    }

    #[inline(always)]
    fn update<L: Lane>(&self, point: &Point<L>, strain: Sym<L>, old: [L; MEMORY]) -> (Sym<L>, [L; MEMORY]) {
        let (stress, new, _) = self.update_left(point, strain, old);
        (stress, new)
    }

    #[inline(always)]
    fn update_left<L: Lane>(
        &self,
        point: &Point<L>,
        strain: Sym<L>,
        old: [L; MEMORY],
    ) -> (Sym<L>, [L; MEMORY], Sym<L>) {
        let damage = [old[D_TENSION], old[D_SHEAR]];
        let seen = self.seen(point, strain, damage, [old[SMOOTHED_TENSION], old[SMOOTHED_SHEAR]]);
        if !L::any(L::not(seen.quiet)) {
            let mut new = old;
            [new[SMOOTHED_TENSION], new[SMOOTHED_SHEAR]] = seen.smoothed;
            return (seen.stress, new, damping::whole());
        }
        self.damaged(point, &seen, old)
    }

    /// Of points that are quiet nothing but the smoothed strains is read and written.
    #[inline(always)]
    fn update_in_place<L: Lane>(
        &self,
        point: &Point<L>,
        strain: Sym<L>,
        history: &mut [Octet],
        at: usize,
    ) -> InPlace<L> {
        let damage = [L::load(&history[D_TENSION], at), L::load(&history[D_SHEAR], at)];
        let smoothed = [L::load(&history[SMOOTHED_TENSION], at), L::load(&history[SMOOTHED_SHEAR], at)];
        let seen = self.seen(point, strain, damage, smoothed);
        if !L::any(L::not(seen.quiet)) {
            if point.brings && self.rate.is_some() {
                seen.smoothed[0].store(&mut history[SMOOTHED_TENSION], at);
                seen.smoothed[1].store(&mut history[SMOOTHED_SHEAR], at);
            }
            let one = L::splat(1.0);
            return InPlace { stress: seen.stress, left: damping::whole(), before: one, now: one };
        }
        let mut old = [L::splat(0.0); MEMORY];
        if point.looked_at {
            old = load(history, at);
        } else {
            let kept: [L; IN_STEPS] = load(history, at);
            old[..IN_STEPS].copy_from_slice(&kept);
        }
        let (stress, new, left) = self.damaged(point, &seen, old);
        if point.looked_at {
            store(&new, history, at);
        } else {
            let mut kept = [L::splat(0.0); IN_STEPS];
            kept.copy_from_slice(&new[..IN_STEPS]);
            store(&kept, history, at);
        }
        InPlace { stress, left, before: self.unbroken(&old), now: self.unbroken(&new) }
    }
}
