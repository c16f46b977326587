//! A field that is linear through the thickness, and bilinear with it in the plane: its values in a layer of four points.

use super::field::FieldShape;
use super::quadrature::Through;
use super::{Hex8, Stabilisation};
use crate::lane::{Lane, Octet};
use crate::material::{Moduli, Sym};

/// Geometry of eight elements of several layers, whatever of it their shape needs.
pub trait LayeredShape: Copy + Send + Sync + 'static {
    type Field: FieldShape;
    /// Without extent: forces from it are zero. Pads the last octet of a patch.
    const EMPTY: Self;
    /// Puts an element, numbered so that ζ is its thickness, into a lane.
    fn set(&mut self, lane: usize, hex: &Hex8, elastic: &Stabilisation, through: &Through);
    fn field(&self) -> &Self::Field;
    /// Volume of a point in a layer \[m³\].
    fn weight<L: Lane>(&self, through: &Through, layer: usize, q: usize, at: usize) -> L;
    /// Adds to the resultants what a whole elastic material would of a strain with these coefficients, at all points at once.
    fn add_elastic<L: Lane>(
        &self,
        through: &Through,
        sums: &mut [[L; 8]; 6],
        moduli: &Moduli,
        e: &[[L; 8]; 6],
        at: usize,
    );
    /// ∫ ½e:C:e \[J\] of a strain with these coefficients, over all points.
    fn elastic_energy<L: Lane>(&self, through: &Through, moduli: &Moduli, e: &[[L; 8]; 6], at: usize) -> L;
}

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

/// ∫ 1, ζ and ζ² over the points that lie behind each other, weighted by det J (`depth`, its coefficients of 1, ζ and ζ²).
#[inline(always)]
pub(super) fn moments<L: Lane>(through: &Through, depth: &[[Octet; 3]; 4], at: usize) -> [[L; 3]; 4] {
    let (square, fourth) = (L::splat(through.square), L::splat(through.fourth));
    let mut moments = [[square; 3]; 4];
    let mut q = 0;
    while q < 4 {
        let [d0, d1, d2] = [L::load(&depth[q][0], at), L::load(&depth[q][1], at), L::load(&depth[q][2], at)];
        moments[q] = [square.mul_add(d2, d0 + d0), square * d1, fourth.mul_add(d2, square * d0)];
        q += 1;
    }
    moments
}

/// Values at ζ = 0 of the four points in the plane, and how they grow with ζ.
#[inline(always)]
fn straight<L: Lane>(e: &[[L; 8]; 6]) -> ([[L; 4]; 6], [[L; 4]; 6]) {
    let zero = L::splat(0.0);
    let (mut middle, mut growth) = ([[zero; 4]; 6], [[zero; 4]; 6]);
    let mut c = 0;
    while c < 6 {
        let e = &e[c];
        let (low, high) = (e[0] - e[2], e[0] + e[2]);
        let (left, right) = (e[1] - e[3], e[1] + e[3]);
        middle[c] = [low - left, low + left, high - right, high + right];
        let (low, high) = (e[4] - e[6], e[4] + e[6]);
        growth[c] = [low - e[5], low + e[5], high - e[5], high + e[5]];
        c += 1;
    }
    (middle, growth)
}

#[inline(always)]
pub(super) fn of_point<L: Lane>(v: &[[L; 4]; 6], q: usize) -> Sym<L> {
    [v[0][q], v[1][q], v[2][q], v[3][q], v[4][q], v[5][q]]
}

/// Adds to the resultants what a whole elastic material would of a strain with these coefficients, at all points at once.
#[inline(always)]
pub(super) fn add_elastic<L: Lane>(
    sums: &mut [[L; 8]; 6],
    moduli: &Moduli,
    e: &[[L; 8]; 6],
    moments: &[[L; 3]; 4],
) {
    let (mut middle, mut growth) = straight(e);
    let mut q = 0;
    while q < 4 {
        let (a, b) = (moduli.stress(&of_point(&middle, q)), moduli.stress(&of_point(&growth, q)));
        let [m0, m1, m2] = moments[q];
        let mut c = 0;
        while c < 6 {
            middle[c][q] = m1.mul_add(b[c], m0 * a[c]);
            growth[c][q] = m2.mul_add(b[c], m1 * a[c]);
            c += 1;
        }
        q += 1;
    }
    let mut c = 0;
    while c < 6 {
        let v = &middle[c];
        let (low, high) = (v[0] + v[1], v[2] + v[3]);
        let (left, right) = (v[1] - v[0], v[3] - v[2]);
        let s = &mut sums[c];
        s[0] = s[0] + (low + high);
        s[1] = s[1] + (left + right);
        s[2] = s[2] + (high - low);
        s[3] = s[3] + (right - left);
        let v = &growth[c];
        let (low, high) = (v[0] + v[1], v[2] + v[3]);
        s[4] = s[4] + (low + high);
        s[5] = s[5] + ((v[1] - v[0]) + (v[3] - v[2]));
        s[6] = s[6] + (high - low);
        c += 1;
    }
}

/// ∫ ½e:C:e \[J\] of a strain with these coefficients, over all points.
#[inline(always)]
pub(super) fn elastic_energy<L: Lane>(moduli: &Moduli, e: &[[L; 8]; 6], moments: &[[L; 3]; 4]) -> L {
    let (middle, growth) = straight(e);
    let mut sum = L::splat(0.0);
    let mut q = 0;
    while q < 4 {
        let (a, b) = (of_point(&middle, q), of_point(&growth, q));
        let [m0, m1, m2] = moments[q];
        sum = m0.mul_add(moduli.energy(&a), sum);
        sum = m1.mul_add(moduli.product(&a, &b), sum);
        sum = m2.mul_add(moduli.energy(&b), sum);
        q += 1;
    }
    sum
}
