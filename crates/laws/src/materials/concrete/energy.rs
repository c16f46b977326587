//! The books of a damaged point: what growing damage takes, and what the effective split gives out.
//!
//! **Dissipated.** Damage that grows from D to D′ in a step takes ½(σ(εⁿ, D) − σ(εⁿ, D′)):εⁿ⁺¹, in principal values: with
//! what follows, just the part of the trapezoidal rule's work that is not stored. The first damaged step, whose εⁿ is not
//! known, takes εⁿ⁺¹ for it. For the compliance split, whose ½σ:ε is its potential at fixed damage, that is all.
//!
//! **Created.** At fixed damage the work of the effective split beyond the change of ½σ:ε is the form
//! σ:dε − d(½σ:ε) = ½(σ:dε − dσ:ε), which has no potential. A step adds −½(σⁿ:εⁿ⁺¹ − σⁿ⁺¹:εⁿ), in principal values and
//! with the step's new damage in both stresses; the trapezoidal rule of the equations of motion gives the same but for
//! terms of third order in the step. A way there and back adds nothing; what stays is what closed loops gave out (less
//! what they took, where it is negative).

use super::{Concrete, D_SHEAR, D_TENSION, ENERGY_CREATED, ENERGY_DISSIPATED, LAST_STRAIN, MEMORY, Split};
use crate::lane::Lane;

/// a·b of principal values.
#[inline(always)]
fn dot<L: Lane>(a: &[L; 3], b: &[L; 3]) -> L {
    a[2].mul_add(b[2], a[1].mul_add(b[1], a[0] * b[0]))
}

impl Concrete {
    /// Brings the books on, for principal strains and their damaged stresses \[Pa\] with the damage in `new`. Lanes that
    /// are quiet have no damage and no books.
    #[inline(always)]
    pub(super) fn book<L: Lane>(
        &self,
        strain: &[L; 3],
        stress: &[L; 3],
        quiet: L::Mask,
        old: &[L; MEMORY],
        new: &mut [L; MEMORY],
    ) {
        let (zero, half) = (L::splat(0.0), L::splat(0.5));
        let (tension, shear) = (old[D_TENSION], old[D_SHEAR]);
        let damaged = zero.less(tension + shear);
        let last = [old[LAST_STRAIN], old[LAST_STRAIN + 1], old[LAST_STRAIN + 2]];
        let grows = L::either(tension.less(new[D_TENSION]), shear.less(new[D_SHEAR]));
        if L::any(grows) {
            // Of the first damaged step only the strain at its end is known.
            let from = [
                L::select(damaged, last[0], strain[0]),
                L::select(damaged, last[1], strain[1]),
                L::select(damaged, last[2], strain[2]),
            ];
            let then = self.undamaged(&from);
            let less = self.principal_stress(from, then, new[D_TENSION], new[D_SHEAR]);
            let more = self.principal_stress(from, then, tension, shear);
            let fall = [more[0] - less[0], more[1] - less[1], more[2] - less[2]];
            let taken = half.mul_add(dot(&fall, strain), old[ENERGY_DISSIPATED]);
            new[ENERGY_DISSIPATED] = L::select(grows, taken, old[ENERGY_DISSIPATED]);
        }
        // A strain that is no number must not enter the memory.
        let known = L::both(L::not(quiet), L::splat(f64::MIN).less(strain[0] + strain[1] + strain[2]));
        let mut i = 0;
        while i < 3 {
            new[LAST_STRAIN + i] = L::select(known, strain[i], last[i]);
            i += 1;
        }
        if self.split == Split::Effective {
            let then = self.principal_stress(last, self.undamaged(&last), new[D_TENSION], new[D_SHEAR]);
            let twice = dot(stress, &last) - dot(&then, strain);
            // The first damaged step has nothing to go on from.
            let booked = L::both(known, damaged);
            let created = half.mul_add(twice, old[ENERGY_CREATED]);
            new[ENERGY_CREATED] = L::select(booked, created, old[ENERGY_CREATED]);
        }
    }
}
