//! What the elastic–plastic rock laws share: elasticity, history, and the bookkeeping of a return.
//!
//! Laws are in total form: history keeps the plastic strain ε_p, the trial stress is C:(ε − ε_p) and a return that
//! takes Δσ off it adds C⁻¹:Δσ to ε_p. So stress and plastic strain cannot drift apart, whatever the number of steps.

pub(super) mod flow;
pub(super) mod parameters;
pub(super) mod relaxation;
pub(super) mod slip;
pub(super) mod tension;

use crate::lane::Lane;
use crate::material::{LEAST_HOURGLASS_SHARE, Moduli, Sym};
use crate::parameter::{Column, Role};
use crate::sym3::Spectrum;

/// History of a point, in the order of [`COLUMNS`].
pub(super) type Memory<L> = [L; 10];

pub(super) const SHEAR: usize = 0;
pub(super) const TENSION: usize = 1;
pub(super) const STATE: usize = 2;
const STRAIN: usize = 3;
const ENERGY: usize = 9;

/// Flags whose sum is `state`.
const SHEAR_NOW: f64 = 1.0;
const TENSION_NOW: f64 = 2.0;
const SHEAR_PAST: f64 = 4.0;
const TENSION_PAST: f64 = 8.0;

const fn component(name: &'static str) -> Column {
    Column::with_role(name, "1", Role::PlasticStrain, "plastic strain since placement, engineering shear")
}

pub(super) const COLUMNS: [Column; 10] = [
    Column::with_role(
        "plastic_shear_strain",
        "1",
        Role::PlasticShear,
        "accumulated √J₂ of the plastic strain of shear",
    ),
    Column::with_role(
        "plastic_tension_strain",
        "1",
        Role::PlasticTension,
        "accumulated plastic strain of the tension cut-off",
    ),
    Column::with_role(
        "state",
        "1",
        Role::PlasticState,
        "sum of 1 shear yielding now, 2 tension now, 4 shear in an earlier step, 8 tension earlier",
    ),
    component("plastic_exx"),
    component("plastic_eyy"),
    component("plastic_ezz"),
    component("plastic_gxy"),
    component("plastic_gyz"),
    component("plastic_gzx"),
    Column::with_role(
        "energy_dissipated",
        "J/m3",
        Role::Dissipated,
        "σ:dε_p, stress at the end of each step",
    ),
];

/// Strains are kept below this: beyond any that means something, squares of stresses would overflow.
const LARGEST_STRAIN: f64 = 1e60;

/// Isotropic elasticity with what returns need of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Elasticity {
    pub lambda: f64,
    pub mu: f64,
    /// K
    pub bulk: f64,
    pub poisson: f64,
    /// Opening over the largest stress \[1/Pa\] that is not counted as tension: a billionth of the elastic strain.
    pub least_opening: f64,
    /// Excess over a yield surface \[Pa\] that round-off explains: no flow below it.
    pub round_off: f64,
}

impl Elasticity {
    pub fn new(moduli: Moduli) -> Self {
        Elasticity {
            lambda: moduli.lambda,
            mu: moduli.mu,
            bulk: moduli.lambda + 2.0 / 3.0 * moduli.mu,
            poisson: moduli.poisson(),
            least_opening: 1e-9 / moduli.young(),
            round_off: 1e-14 * moduli.young(),
        }
    }

    pub fn moduli(&self) -> Moduli {
        Moduli { lambda: self.lambda, mu: self.mu }
    }

    /// C:(ε − ε_p), the stress \[Pa\] if nothing flows.
    #[inline(always)]
    pub fn trial<L: Lane>(&self, strain: &Sym<L>, old: &Memory<L>) -> Sym<L> {
        let limit = L::splat(LARGEST_STRAIN);
        let mut e = *strain;
        let mut k = 0;
        while k < 6 {
            // A NaN passes through both comparisons and stays visible.
            e[k] = (-limit).larger(limit.smaller(e[k])) - old[STRAIN + k];
            k += 1;
        }
        self.moduli().stress(&e)
    }

    /// C⁻¹:Δσ of principal stresses.
    #[inline(always)]
    pub fn principal_strain<L: Lane>(&self, stress: &[L; 3]) -> [L; 3] {
        let side = L::splat(self.poisson / (1.0 + self.poisson)) * (stress[0] + stress[1] + stress[2]);
        let inverse = L::splat(0.5 / self.mu);
        [(stress[0] - side) * inverse, (stress[1] - side) * inverse, (stress[2] - side) * inverse]
    }

    /// Adds C⁻¹:(trial − stress) to the plastic strain where `yielding`, and takes `stress` there.
    #[inline(always)]
    pub fn settle<L: Lane>(
        &self,
        trial: &Sym<L>,
        stress: &Sym<L>,
        yielding: L::Mask,
        memory: &mut Memory<L>,
    ) -> Sym<L> {
        let zero = L::splat(0.0);
        let mut off = *trial;
        let mut result = *trial;
        let mut k = 0;
        while k < 6 {
            result[k] = L::select(yielding, stress[k], trial[k]);
            // So that a strain that is no number does not enter the memory.
            off[k] = L::select(yielding, trial[k] - stress[k], zero);
            k += 1;
        }
        let side = L::splat(self.poisson / (1.0 + self.poisson)) * (off[0] + off[1] + off[2]);
        let (half, one) = (L::splat(0.5 / self.mu), L::splat(1.0 / self.mu));
        let mut energy = memory[ENERGY];
        let mut k = 0;
        while k < 3 {
            let (normal, shear) = (half * (off[k] - side), one * off[3 + k]);
            memory[STRAIN + k] = memory[STRAIN + k] + normal;
            memory[STRAIN + 3 + k] = memory[STRAIN + 3 + k] + shear;
            energy = stress[3 + k].mul_add(shear, stress[k].mul_add(normal, energy));
            k += 1;
        }
        memory[ENERGY] = L::select(yielding, energy, memory[ENERGY]);
        result
    }
}

/// e_y/(e_y + γ_p + ε_t), the secant over the elastic stiffness in plastic bending, from the plastic strains of shear and
/// tension and the elastic √J₂ of strain at yield without confinement: e_y = `strength`/2μ with √J₂ of stress \[Pa\].
#[inline(always)]
pub(super) fn hourglass_share<L: Lane>(strength: f64, mu: f64, memory: &Memory<L>) -> L {
    let plastic = memory[SHEAR] + memory[TENSION];
    if !L::any(L::splat(0.0).less(plastic)) {
        return L::splat(1.0);
    }
    // Rock without cohesion yields at once; the least strain stands for its confinement.
    let yielded = L::splat((0.5 * strength / mu).max(1e-5));
    let share = yielded / (yielded + plastic);
    L::splat(LEAST_HOURGLASS_SHARE).larger(share)
}

/// Mean and radius √(J₂/3) of a tensor, as a [`Spectrum`] has them, without the rest of it.
#[inline(always)]
pub(super) fn mean_and_radius<L: Lane>(t: &Sym<L>) -> (L, L) {
    let (xy, yz, zx) = (t[0] - t[1], t[1] - t[2], t[2] - t[0]);
    let shear = t[3].mul_add(t[3], t[4].mul_add(t[4], t[5] * t[5]));
    let normal = xy.mul_add(xy, yz.mul_add(yz, zx * zx));
    let square = normal.mul_add(L::splat(1.0 / 18.0), shear * L::splat(1.0 / 3.0));
    ((t[0] + t[1] + t[2]) * L::splat(1.0 / 3.0), square.sqrt())
}

/// What [`Spectrum::values`] may be wrong by where two nearly agree, with a wide margin.
#[inline(always)]
pub(super) fn blur<L: Lane>(spectrum: &Spectrum<L>) -> L {
    spectrum.radius * L::splat(1e-7)
}

/// The state of a point that yields as the masks say, from what had accumulated before.
#[inline(always)]
pub(super) fn state<L: Lane>(shear: L::Mask, tension: L::Mask, old: &Memory<L>) -> L {
    let zero = L::splat(0.0);
    (L::select(shear, L::splat(SHEAR_NOW), zero) + L::select(tension, L::splat(TENSION_NOW), zero))
        + past(old)
}

/// The state of a point that does not yield now.
#[inline(always)]
pub(super) fn past<L: Lane>(old: &Memory<L>) -> L {
    let zero = L::splat(0.0);
    L::select(zero.less(old[SHEAR]), L::splat(SHEAR_PAST), zero)
        + L::select(zero.less(old[TENSION]), L::splat(TENSION_PAST), zero)
}

/// The answer where no lane yields.
#[inline(always)]
pub(super) fn unyielding<L: Lane>(trial: Sym<L>, old: Memory<L>) -> (Sym<L>, Memory<L>) {
    let mut new = old;
    new[STATE] = past(&old);
    (trial, new)
}
