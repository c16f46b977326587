//! Relaxation of the overstress beyond the yield surface after Duvaut and Lions (`duvaut1976`).
//!
//! The plastic strain grows at C⁻¹:(σ − σ_∞)/τ, where σ_∞ is the return of the stress σ to the surface and τ the relaxation time.
//! A step of backward Euler over Δt ends at σ = σ* + (σ_∞* − σ*)Δt/(τ + Δt), with the trial stress σ* and its return σ_∞*.
//! While time stands still (Δt = 0, stages) the stress lies on the surface.
//!
//! A band of softening ground then has a width of its own (`needleman1988`). In shear the softening slope |H| lets a
//! disturbance grow as exp(t/t_g), t_g = τ μ/|H|, and waves of shear spread it over ℓ = V_s t_g while it does.

use super::slip::Fall;
use super::tension::Returned;
use crate::lane::Lane;
use crate::parameter::{Derived, Dimension, Need, Parameter};

const NAME: &str = "relaxation_time";

pub(in crate::materials) const RELAXATION_TIME: Parameter = super::parameters::number(
    NAME,
    Dimension::TIME,
    Need::Optional("the stress never exceeds the strength"),
    "time in which stress beyond the strength relaxes; gives bands that soften over strain a width, e.g. 1 ms",
);

/// The relaxation time τ \[s\].
#[derive(Clone, Copy, Debug)]
pub(in crate::materials) struct Relaxation(f64);

impl Relaxation {
    /// Returned stresses after a step \[s\] from the trial stresses `s`, both largest first.
    #[inline(always)]
    pub fn relax<L: Lane>(&self, s: &[L; 3], returned: &mut Returned<L>, dt: L) {
        let share = L::select(L::splat(0.0).less(dt), dt / (L::splat(self.0) + dt), L::splat(1.0));
        let mut i = 0;
        while i < 3 {
            let full = returned.stress[i];
            let part = share.mul_add(full - s[i], s[i]);
            // Where time stands still the return itself, to the last digit.
            returned.stress[i] = L::select(share.less(L::splat(1.0)), part, full);
            i += 1;
        }
    }

    /// t_g = τ μ/|H| \[s\] of the steepest fall; infinite where nothing falls.
    ///
    /// At constant mean stress in the plane of shear the shear strength falls by the axial one's fall over k + 1, over the
    /// engineering shear strain 2Γ.
    pub fn growth_time(&self, mu: f64, falls: impl Iterator<Item = Fall>) -> f64 {
        let slope = |fall: Fall| fall.shear / (fall.slope + 1.0) / (2.0 * fall.slip);
        self.0 * mu / falls.map(slope).fold(0.0, f64::max)
    }
}

impl crate::parameter::Reading<'_> {
    /// The relaxation time if it is given; `None` where it is wrong, or beside softening over displacement.
    pub(in crate::materials) fn relaxation(&mut self, over_displacement: bool) -> Option<Option<Relaxation>> {
        let remedy = "give a time, such as 1 ms, or leave it out";
        let time = self.optional(NAME, |tau| tau > 0.0, "positive", remedy)?;
        if time.is_some() && over_displacement {
            let problem = "stands beside softening over displacement: bands would have two widths";
            self.fault(
                NAME,
                problem,
                "give plastic_shear_strain in place of the displacements, or leave the time out",
            );
            return None;
        }
        Some(time.map(Relaxation))
    }
}

/// t_g, where there is one.
pub(in crate::materials) fn derived(growth: Option<f64>) -> Option<Derived> {
    let doc = "τ μ/|H|; elements below a third of V_s times it resolve a band of softening ground";
    growth.map(|time| Derived::new("growth_time", time, "s", doc))
}
