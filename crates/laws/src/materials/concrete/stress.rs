//! From principal strains and damage to principal stresses: the two splits.

use super::{Concrete, Split};
use crate::lane::Lane;
use crate::material::Sym;

impl Concrete {
    /// Effective stress \[Pa\] of a strain with tensor shear.
    #[inline(always)]
    pub(super) fn hooke<L: Lane>(&self, e: &Sym<L>) -> Sym<L> {
        let mu2 = L::splat(2.0 * self.moduli.mu);
        let [x, y, z] = self.undamaged(&[e[0], e[1], e[2]]);
        [x, y, z, mu2 * e[3], mu2 * e[4], mu2 * e[5]]
    }

    /// Principal effective stresses \[Pa\].
    #[inline(always)]
    pub(super) fn undamaged<L: Lane>(&self, strain: &[L; 3]) -> [L; 3] {
        let mu2 = L::splat(2.0 * self.moduli.mu);
        let pressure = L::splat(self.moduli.lambda) * (strain[0] + strain[1] + strain[2]);
        [mu2.mul_add(strain[0], pressure), mu2.mul_add(strain[1], pressure), mu2.mul_add(strain[2], pressure)]
    }

    /// Principal stresses \[Pa\] for damage.
    #[inline(always)]
    pub(super) fn principal_stress<L: Lane>(
        &self,
        strain: [L; 3],
        undamaged: [L; 3],
        tension: L,
        shear: L,
    ) -> [L; 3] {
        match self.split {
            Split::Effective => effective(undamaged, tension, shear),
            Split::Compliance => compliance(self.young, self.poisson, strain, undamaged, tension, shear),
        }
    }
}

/// Damage of each principal direction: D⁺ where `sign` is not negative, else D⁻.
#[inline(always)]
fn of_sign<L: Lane>(tension: L, shear: L, sign: L) -> L {
    L::select(sign.less(L::splat(0.0)), shear, tension)
}

/// The paper's (7): σ_i = (1 − D_i) σ̂_i.
#[inline(always)]
fn effective<L: Lane>(undamaged: [L; 3], tension: L, shear: L) -> [L; 3] {
    let one = L::splat(1.0);
    let (plus, minus) = (one - tension, one - shear);
    [
        of_sign(plus, minus, undamaged[0]) * undamaged[0],
        of_sign(plus, minus, undamaged[1]) * undamaged[1],
        of_sign(plus, minus, undamaged[2]) * undamaged[2],
    ]
}

/// Damage in the compliance (Ladevèze & Lemaitre 1984; La Borderie 1991):
/// ε_i = σ_i/(E(1 − D_i)) − (ν/E) Σ_{j≠i} σ_j.
///
/// With a_i = E(1 − D_i)/(1 + ν(1 − D_i)) the trace is Σ a_i ε_i/(1 − (ν/E) Σ a_i) and σ_i = a_i x_i with
/// x_i = ε_i + (ν/E) tr σ, whose sign chooses D_i (σ_i has none at D_i = 1). Signs start from the undamaged stress;
/// three corrections were the most that 120,000 random draws needed.
#[inline(always)]
fn compliance<L: Lane>(
    young: f64,
    poisson: f64,
    strain: [L; 3],
    undamaged: [L; 3],
    tension: L,
    shear: L,
) -> [L; 3] {
    let (zero, one) = (L::splat(0.0), L::splat(1.0));
    let nu = L::splat(poisson);
    let ratio = L::splat(poisson / young);
    let (left, right) = (one - tension, one - shear);
    let plus = L::splat(young) * left / nu.mul_add(left, one);
    let minus = L::splat(young) * right / nu.mul_add(right, one);
    let mut sign = undamaged;
    let mut stress = undamaged;
    let mut round = 0;
    while round < 4 {
        let a = [of_sign(plus, minus, sign[0]), of_sign(plus, minus, sign[1]), of_sign(plus, minus, sign[2])];
        let sum = a[2].mul_add(strain[2], a[1].mul_add(strain[1], a[0] * strain[0]));
        let pressure = ratio * (sum / ratio.neg_mul_add(a[0] + a[1] + a[2], one));
        let x = [strain[0] + pressure, strain[1] + pressure, strain[2] + pressure];
        stress = [a[0] * x[0], a[1] * x[1], a[2] * x[2]];
        // A product below zero: the sign turned.
        let turned = L::either(
            L::either((x[0] * sign[0]).less(zero), (x[1] * sign[1]).less(zero)),
            (x[2] * sign[2]).less(zero),
        );
        sign = x;
        if !L::any(turned) {
            break;
        }
        round += 1;
    }
    stress
}

#[cfg(test)]
mod tests {
    use super::compliance;

    /// The closed form solves ε_i = σ_i/(E(1 − D_i)) − (ν/E) Σ_{j≠i} σ_j with the signs of its own result.
    #[test]
    fn compliance_split_satisfies_its_own_equation() {
        let mut seed = 1u64;
        let mut unit = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64
        };
        for draw in 0..120_000 {
            let nu = 0.45 * unit();
            let strain = [0; 3].map(|_| 2.0 * unit() - 1.0);
            // Every third draw has one damage complete: then the stress of those directions is zero.
            let [tension, shear] = match draw % 3 {
                0 => [1.0, unit()],
                1 => [unit(), 1.0],
                _ => [unit(), unit()],
            };
            let lambda = nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
            let trace: f64 = strain.iter().sum();
            let undamaged = strain.map(|e| lambda * trace + e / (1.0 + nu));
            let stress = compliance(1.0, nu, strain, undamaged, tension, shear);
            let sum: f64 = stress.iter().sum();
            for i in 0..3 {
                let x = strain[i] + nu * sum;
                let left = 1.0 - if x < 0.0 { shear } else { tension };
                // ε_i + ν tr σ = σ_i (1/(1 − D_i) + ν), without dividing by 1 − D_i.
                let defect = left * x - stress[i] * (1.0 + nu * left);
                assert!(defect.abs() <= 1e-14, "{strain:?} ν {nu} D {tension} {shear}: {stress:?}");
            }
        }
    }
}
