//! From principal strains and damage to principal stresses: the two splits.

use crate::lane::Lane;

/// Damage of each principal direction: D⁺ where `sign` is not negative, else D⁻.
#[inline(always)]
fn of_sign<L: Lane>(tension: L, shear: L, sign: L) -> L {
    L::select(sign.less(L::splat(0.0)), shear, tension)
}

/// The paper's (7): σ_i = (1 − D_i) σ̂_i.
#[inline(always)]
pub fn effective<L: Lane>(undamaged: [L; 3], tension: L, shear: L) -> [L; 3] {
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
pub fn compliance<L: Lane>(
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
