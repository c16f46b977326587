//! A step of a point: what its strain says before damage is asked for, and damage where it may grow or is.

use super::{
    CRACK_SIZE, Concrete, D_B, D_B_MAX, D_SHEAR, D_TENSION, FACTOR_SHEAR, FACTOR_TENSION, MEMORY,
    SMOOTHED_SHEAR, SMOOTHED_TENSION, Split,
};
use crate::lane::Lane;
use crate::material::{Point, Sym};
use crate::sym3::{Spectrum, Spread};

/// The strain with tensor shear, its components kept below 1e100: beyond any strain that means something, squares
/// would overflow and leave no number behind.
#[inline(always)]
pub(super) fn bounded<L: Lane>(strain: Sym<L>) -> Sym<L> {
    let half = L::splat(0.5);
    let mut tensor = [strain[0], strain[1], strain[2], half * strain[3], half * strain[4], half * strain[5]];
    let limit = L::splat(1e100);
    let mut largest = L::splat(0.0);
    let mut k = 0;
    while k < 6 {
        largest = largest + tensor[k].abs();
        k += 1;
    }
    if L::any(limit.less(largest)) {
        let mut k = 0;
        while k < 6 {
            tensor[k] = (-limit).larger(limit.smaller(tensor[k]));
            k += 1;
        }
    }
    tensor
}

/// What a strain says of a point before its damage is asked for.
pub(super) struct Seen<L: Lane> {
    /// Undamaged stress \[Pa\].
    pub stress: Sym<L>,
    /// Without damage, and none can start: nothing but the smoothed strains changes.
    pub quiet: L::Mask,
    /// Smoothed strains in tension and in shear, before the step and after.
    pub before: [L; 2],
    pub smoothed: [L; 2],
    spread: Spread<L>,
}

impl Concrete {
    /// Looks at a strain, for D⁺ and D⁻ and smoothed strains before the step. Principal values are found where they are asked for:
    /// when smoothed strains are brought on, and where bounds do not tell that a sound point stays sound.
    #[inline(always)]
    pub(super) fn seen<L: Lane>(
        &self,
        point: &Point<L>,
        strain: Sym<L>,
        [tension, shear]: [L; 2],
        before: [L; 2],
    ) -> Seen<L> {
        let tensor = bounded(strain);
        let stress = self.hooke(&tensor);
        let spread = Spread::of(&tensor);
        let virgin = L::not(L::splat(0.0).less(tension + shear));
        let mut quiet = L::both(virgin, self.far_from_damage(spread.mean, spread.radius));
        let mut smoothed = before;
        let brings = point.brings && self.rate.is_some();
        if brings || L::any(L::both(virgin, L::not(quiet))) {
            let values = Spectrum::from(&spread).values();
            let undamaged = self.undamaged(&values);
            let equivalent = self.equivalent_strain(&values, &undamaged);
            let below = self.below_damage(spread.radius, equivalent, &undamaged);
            quiet = L::either(quiet, L::both(virgin, below));
            if brings && let Some(law) = &self.rate {
                smoothed = law.brought_on(before, [equivalent, -values[2]], point.since);
            }
        }
        Seen { stress, quiet, before, smoothed, spread }
    }

    /// Stress, history and what damage has left of a point that is not quiet; lanes that are keep what they have.
    #[inline(always)]
    pub(super) fn damaged<L: Lane>(
        &self,
        point: &Point<L>,
        seen: &Seen<L>,
        old: [L; MEMORY],
    ) -> (Sym<L>, [L; MEMORY], Sym<L>) {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let quiet = seen.quiet;
        let mut stress = seen.stress;
        let mut new = old;
        [new[SMOOTHED_TENSION], new[SMOOTHED_SHEAR]] = seen.smoothed;
        let spectrum = Spectrum::from(&seen.spread);
        let axes = spectrum.axes();
        let undamaged = self.undamaged(&axes.values);
        let equivalent = self.equivalent_strain(&axes.values, &undamaged);
        let frozen = zero.less(old[FACTOR_TENSION]);
        // No factor is below 1: it is asked for where the static threshold is reached.
        let calm = L::either(frozen, equivalent.less(L::splat(self.threshold())));
        let mut factor = L::select(frozen, old[FACTOR_TENSION], one);
        if let Some(law) = &self.rate
            && L::any(L::not(calm))
        {
            // Of the strain that is smoothed.
            let values = spectrum.values();
            let equivalent = self.equivalent_strain(&values, &self.undamaged(&values));
            let rate = law.rate(equivalent, seen.before[0], point.since);
            factor = L::select(frozen, factor, law.tension.factor(rate));
        }
        let cracking = L::not(equivalent.less(factor * L::splat(self.threshold())));
        let starts = L::both(cracking, L::not(frozen));
        let mut size = old[CRACK_SIZE];
        if L::any(starts) {
            size = L::select(starts, point.extent(&spectrum.eigen().vectors[0]), size);
            new[FACTOR_TENSION] = L::select(starts, factor, old[FACTOR_TENSION]);
            new[CRACK_SIZE] = size;
        }
        let mut tension = old[D_TENSION];
        if L::any(cracking) {
            tension = L::select(cracking, self.softened(equivalent, factor, size), zero).larger(tension);
        }
        new[D_TENSION] = tension;

        // The effective split tests shear on the effective stress, the compliance split on the damaged one.
        let tested = match self.split {
            Split::Effective => undamaged,
            Split::Compliance => self.principal_stress(axes.values, undamaged, tension, old[D_SHEAR]),
        };
        let frozen = zero.less(old[FACTOR_SHEAR]);
        let compressive = -axes.values[2];
        let pressed = L::both(zero.less(compressive), L::splat(1e-6 * self.fc).less(-tested[2]));
        let mut shear = old[D_SHEAR];
        // As in tension, and a frozen factor is not below 1 either.
        let at_rest = self.shear_threshold(&tested, tension, one);
        if L::any(L::both(pressed, L::not(compressive.less(at_rest)))) {
            let mut factor = L::select(frozen, old[FACTOR_SHEAR], one);
            if let Some(law) = &self.rate
                && L::any(L::not(frozen))
            {
                let rate = law.rate(-spectrum.values()[2], seen.before[1], point.since);
                factor = L::select(frozen, factor, law.shear.factor(rate));
            }
            let threshold = self.shear_threshold(&tested, tension, factor);
            let failing = L::both(pressed, L::not(compressive.less(threshold)));
            let candidate = (one - L::splat(self.beta) * threshold / compressive).smaller(one);
            shear = L::select(failing, candidate, zero).larger(shear);
            new[FACTOR_SHEAR] = L::select(L::both(failing, L::not(frozen)), factor, old[FACTOR_SHEAR]);
        }
        new[D_SHEAR] = shear;

        let round = L::splat(-1e-6 * self.ft);
        let mut sum = zero;
        let mut i = 0;
        while i < 3 {
            sum = sum + L::select(undamaged[i].less(round), shear, tension);
            i += 1;
        }
        new[D_B] = sum * L::splat(1.0 / 3.0);
        new[D_B_MAX] = new[D_B].larger(old[D_B_MAX]);

        // The tested stress is that of the damage in shear before.
        let mut principal = tested;
        if self.split == Split::Effective || L::any(old[D_SHEAR].less(shear)) {
            principal = self.principal_stress(axes.values, undamaged, tension, shear);
        }
        self.book(&axes.values, &principal, quiet, &old, &mut new);
        if point.looked_at {
            self.open(point, &spectrum.eigen(), &principal, &mut new);
        }
        let damaged = axes.compose(principal);
        let mut k = 0;
        while k < 6 {
            stress[k] = L::select(quiet, stress[k], damaged[k]);
            k += 1;
        }
        let left = self.left_along(&axes, &undamaged, &new);
        (stress, new, left)
    }
}
