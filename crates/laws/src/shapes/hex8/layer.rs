//! A field that is linear through the thickness, and bilinear with it in the plane: its values in a layer of four points.

use crate::lane::Lane;
use crate::material::Sym;

/// Values at the four points of a layer, from coefficients by component: `[component][point]`. The coefficients in the plane are
/// those of ±1 at the points.
#[inline(always)]
pub(super) fn in_layer<L: Lane>(e: &[[L; 8]; 6], zeta: f64) -> [[L; 4]; 6] {
    let zeta = L::splat(zeta);
    let mut values = [[zeta; 4]; 6];
    let mut c = 0;
    while c < 6 {
        let f0 = zeta.mul_add(e[c][4], e[c][0]);
        let f1 = zeta.mul_add(e[c][5], e[c][1]);
        let f2 = zeta.mul_add(e[c][6], e[c][2]);
        let f3 = e[c][3];
        let (low, high) = (f0 - f2, f0 + f2);
        let (left, right) = (f1 - f3, f1 + f3);
        values[c] = [low - left, low + left, high - right, high + right];
        c += 1;
    }
    values
}

/// The same at one of the points.
#[inline(always)]
pub(super) fn at_point<L: Lane>(e: &[[L; 8]; 6], zeta: f64, q: usize) -> Sym<L> {
    let v = in_layer(e, zeta);
    [v[0][q], v[1][q], v[2][q], v[3][q], v[4][q], v[5][q]]
}

/// Adds weighted stresses of a layer to the resultants of the coefficients: the transpose of [`in_layer`].
#[inline(always)]
pub(super) fn add_layer<L: Lane>(sums: &mut [[L; 8]; 6], stress: &[[L; 4]; 6], zeta: f64) {
    let zeta = L::splat(zeta);
    let mut c = 0;
    while c < 6 {
        let v = &stress[c];
        let (low, high) = (v[0] + v[1], v[2] + v[3]);
        let (left, right) = (v[1] - v[0], v[3] - v[2]);
        let (f0, f1, f2, f3) = (low + high, left + right, high - low, right - left);
        let s = &mut sums[c];
        s[0] = s[0] + f0;
        s[1] = s[1] + f1;
        s[2] = s[2] + f2;
        s[3] = s[3] + f3;
        s[4] = zeta.mul_add(f0, s[4]);
        s[5] = zeta.mul_add(f1, s[5]);
        s[6] = zeta.mul_add(f2, s[6]);
        c += 1;
    }
}
