//! Principal values and directions over lanes, without branches or iterations.
//!
//! With mean q and radius p = √(‖A − qI‖²/6) the tensor B = (A − qI)/p has the characteristic equation
//! x³ − 3x = 2r, r = ½ det B, |r| ≤ 1 (Smith 1961). Its root of largest magnitude lies in \[√3, 2\] (after a change
//! of sign where r < 0), is a smooth function of r and stands at least √3 off both others, however close those are
//! to each other. So that root and its direction (a column of the adjugate of B − xI) are well conditioned always,
//! and the plane across it is left to one exact rotation of a 2×2 matrix, which is as accurate for equal values as
//! for any (the order of Eberly 2014, 'A robust eigensolver for 3×3 symmetric matrices'; no arccosine is needed).
//! Residual and orthogonality are at round-off of the largest value for every tensor (7 ε and 4 ε at worst in the
//! tests), at a third of the cost of the four sweeps that Jacobi's rotations take for it; the directions themselves
//! turn, as they must, where two values nearly agree.

use crate::lane::Lane;

/// Principal values, largest first, and unit directions, one a row.
#[derive(Clone, Copy, Debug)]
pub struct Eigen<L> {
    pub values: [L; 3],
    /// `vectors[i]` belongs to `values[i]`; x, y, z. Mutually orthogonal; handedness is not defined.
    pub vectors: [[L; 3]; 3],
}

impl<L: Lane> Eigen<L> {
    /// Σ f_i p_i⊗p_i: the tensor with other principal values in the same directions (xx, yy, zz, xy, yz, zx).
    #[inline(always)]
    pub fn recompose(&self, values: [L; 3]) -> [L; 6] {
        let [a, b, c] = &self.vectors;
        let fa = [values[0] * a[0], values[0] * a[1], values[0] * a[2]];
        let fb = [values[1] * b[0], values[1] * b[1], values[1] * b[2]];
        let fc = [values[2] * c[0], values[2] * c[1], values[2] * c[2]];
        const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)];
        let mut t = [values[0]; 6];
        let mut k = 0;
        while k < 6 {
            let (i, j) = PAIRS[k];
            t[k] = fc[i].mul_add(c[j], fb[i].mul_add(b[j], fa[i] * a[j]));
            k += 1;
        }
        t
    }
}

/// Mean and size of a tensor: what bounds its principal values before they are known.
#[derive(Clone, Copy, Debug)]
pub struct Spread<L> {
    /// Mean q of the principal values.
    pub mean: L,
    /// Radius p: the largest principal deviator is at most 2p in magnitude; 0 for a multiple of the unit tensor.
    pub radius: L,
    deviator: [L; 6],
    /// p² and p, 1 where they round to 0.
    square: L,
    divisor: L,
}

impl<L: Lane> Spread<L> {
    /// Of a tensor with components xx, yy, zz, xy, yz, zx (tensor shear), up to 1e100 in magnitude; a radius below 1e-90 counts as 0.
    #[inline(always)]
    pub fn of(t: &[L; 6]) -> Self {
        let third = L::splat(1.0 / 3.0);
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        // From differences, the deviator has its digits and no trace even beside a large mean.
        let (xy, yz, zx) = (t[0] - t[1], t[1] - t[2], t[2] - t[0]);
        let (x, y, z) = ((xy - zx) * third, (yz - xy) * third, (zx - yz) * third);
        let [xy, yz, zx] = [t[3], t[4], t[5]];
        let shear = xy.mul_add(xy, yz.mul_add(yz, zx * zx));
        let normal = x.mul_add(x, y.mul_add(y, z * z));
        let square = (normal + (shear + shear)) * L::splat(1.0 / 6.0);
        let round = square.less(L::splat(1e-180));
        let square = L::select(round, one, square);
        let divisor = square.sqrt();
        Spread {
            mean: (t[0] + t[1] + t[2]) * third,
            radius: L::select(round, zero, divisor),
            deviator: [x, y, z, xy, yz, zx],
            square,
            divisor,
        }
    }
}

/// Two values that differ by less than twice this share of the radius count as equal: their directions are round-off.
const EQUAL: f64 = 1e-14;

/// Principal values, largest first, and the tensors of which all others with the same directions are made.
///
/// With P the eigenprojection on the direction of the root that stands alone and Q the deviator in the plane across it, over its radius, Σ f_i p_i⊗p_i is
/// m(I − P) + f P + dQ with f the value that stands alone, m the mean of the others and d half their difference. Where those two agree Q is
/// round-off over round-off; it counts as 0, and what is made is wrong by no more than their difference.
#[derive(Clone, Copy, Debug)]
pub struct Axes<L> {
    pub values: [L; 3],
    /// −1 where the smallest value stands alone, else 1.
    sign: L,
    alone: [L; 6],
    across: [L; 6],
}

impl<L: Lane> Axes<L> {
    /// As [`Eigen::recompose`].
    #[inline(always)]
    pub fn compose(&self, values: [L; 3]) -> [L; 6] {
        let (zero, half) = (L::splat(0.0), L::splat(0.5));
        let negative = self.sign.less(zero);
        let alone = L::select(negative, values[2], values[0]);
        let high = L::select(negative, values[0], values[1]);
        let low = L::select(negative, values[1], values[2]);
        let (mean, apart) = ((high + low) * half, (high - low) * half);
        let alone = alone - mean;
        let mut t = [mean, mean, mean, zero, zero, zero];
        let mut k = 0;
        while k < 6 {
            t[k] = apart.mul_add(self.across[k], alone.mul_add(self.alone[k], t[k]));
            k += 1;
        }
        t
    }
}

/// What the principal values and the directions both start from.
#[derive(Clone, Copy, Debug)]
pub struct Spectrum<L> {
    /// As of [`Spread`].
    pub mean: L,
    pub radius: L,
    deviator: [L; 6],
    /// What brings the deviator to radius 1 and its isolated root to the positive side: `sign` over p.
    scale: L,
    /// −1 where the isolated root is the smallest, else 1.
    sign: L,
    /// The isolated root x, √3 to 2.
    root: L,
}

impl<L: Lane> Spectrum<L> {
    /// Of a tensor as [`Spread::of`] takes it. [`eigen`] serves every finite tensor.
    #[inline(always)]
    pub fn of(t: &[L; 6]) -> Self {
        Self::from(&Spread::of(t))
    }

    /// Of a tensor whose mean and size are known.
    #[inline(always)]
    pub fn from(spread: &Spread<L>) -> Self {
        let zero = L::splat(0.0);
        let one = L::splat(1.0);
        let &Spread { mean, radius, deviator, square, divisor } = spread;
        let [x, y, z, xy, yz, zx] = deviator;
        let minor = yz.neg_mul_add(yz, y * z);
        let minor_y = yz.neg_mul_add(zx, xy * z);
        let minor_z = zx.neg_mul_add(y, xy * yz);
        let determinant = zx.mul_add(minor_z, xy.neg_mul_add(minor_y, x * minor));
        let sign = L::select(determinant.less(zero), -one, one);
        let twice_r = determinant.abs() / (square * divisor);
        // Interpolation at Chebyshev's nodes over r in [0, 1], within 3.6e-9; one Newton step squares that.
        const C: [f64; 9] = [
            1.732_050_811_199_130_4,
            0.333_332_742_288_997_34,
            -0.096_208_882_905_866_96,
            0.049_208_593_584_658_21,
            -0.030_214_550_322_433_507,
            0.018_766_661_141_410_217,
            -0.009_859_382_344_859_493,
            0.003_529_713_746_233_796_4,
            -0.000_605_708_402_901_725_3,
        ];
        let r = twice_r * L::splat(0.5);
        let (r2, c) = (r * r, C);
        let r4 = r2 * r2;
        let low =
            L::splat(c[3]).mul_add(r, L::splat(c[2])).mul_add(r2, L::splat(c[1]).mul_add(r, L::splat(c[0])));
        let high =
            L::splat(c[7]).mul_add(r, L::splat(c[6])).mul_add(r2, L::splat(c[5]).mul_add(r, L::splat(c[4])));
        let root = L::splat(c[8]).mul_add(r4, high).mul_add(r4, low);
        let root_square = root * root;
        let three = L::splat(3.0);
        let value = root.mul_add(root_square - three, -twice_r);
        let root = root - value / three.mul_add(root_square, -three);
        Spectrum { mean, radius, deviator, scale: sign / divisor, sign, root }
    }

    /// Principal values, largest first, without the directions.
    ///
    /// Two that differ by less than 1e-8 of the radius may come out that much wrong; [`Spectrum::eigen`] has them to
    /// round-off.
    #[inline(always)]
    pub fn values(&self) -> [L; 3] {
        let half = self.root * L::splat(0.5);
        let square = half.neg_mul_add(half * L::splat(3.0), L::splat(3.0));
        let zero = L::splat(0.0);
        let spread = L::select(zero.less(square), square, zero).sqrt();
        self.ordered(spread - half, -(spread + half))
    }

    /// Principal values from the two other roots.
    #[inline(always)]
    fn ordered(&self, second: L, third: L) -> [L; 3] {
        let negative = self.sign.less(L::splat(0.0));
        let low = L::select(negative, -self.root, third);
        let middle = L::select(negative, -second, second);
        let high = L::select(negative, -third, self.root);
        [
            self.radius.mul_add(high, self.mean),
            self.radius.mul_add(middle, self.mean),
            self.radius.mul_add(low, self.mean),
        ]
    }

    /// Principal values, and what makes other tensors of the same directions, in fewer operations than the directions themselves take.
    #[inline(always)]
    pub fn axes(&self) -> Axes<L> {
        let (zero, one, half) = (L::splat(0.0), L::splat(1.0), L::splat(0.5));
        let scale = self.scale * self.sign;
        let root = self.root * self.sign;
        let [x, y, z, xy, yz, zx] = self.deviator;
        let (x, y, z) = (x * scale, y * scale, z * scale);
        let (xy, yz, zx) = (xy * scale, yz * scale, zx * scale);
        let (cx, cy, cz) = (x - root, y - root, z - root);
        let mut alone = [
            yz.neg_mul_add(yz, cy * cz),
            zx.neg_mul_add(zx, cx * cz),
            xy.neg_mul_add(xy, cx * cy),
            xy.neg_mul_add(cz, zx * yz),
            yz.neg_mul_add(cx, xy * zx),
            zx.neg_mul_add(cy, xy * yz),
        ];
        let inverse = one / (alone[0] + alone[1] + alone[2]);
        let (middle, turned) = (root * half, root * L::splat(1.5));
        let mut across = [x + middle, y + middle, z + middle, xy, yz, zx];
        let mut k = 0;
        while k < 6 {
            alone[k] = alone[k] * inverse;
            across[k] = turned.neg_mul_add(alone[k], across[k]);
            k += 1;
        }
        let [x, y, z, xy, yz, zx] = across;
        let shear = xy.mul_add(xy, yz.mul_add(yz, zx * zx));
        let normal = x.mul_add(x, y.mul_add(y, z * z));
        let spread = normal.mul_add(half, shear).sqrt();
        let equal = spread.less(L::splat(EQUAL));
        let inverse = L::select(equal, zero, one / L::select(equal, one, spread));
        let mut k = 0;
        while k < 6 {
            across[k] = across[k] * inverse;
            k += 1;
        }
        let low = L::select(self.sign.less(zero), root, -middle - spread);
        let second = L::select(self.sign.less(zero), -middle - spread, -middle + spread);
        let high = L::select(self.sign.less(zero), -middle + spread, root);
        let values = [
            self.radius.mul_add(high, self.mean),
            self.radius.mul_add(second, self.mean),
            self.radius.mul_add(low, self.mean),
        ];
        Axes { values, sign: self.sign, alone, across }
    }

    /// Principal values and directions.
    #[inline(always)]
    pub fn eigen(&self) -> Eigen<L> {
        let zero = L::splat(0.0);
        let one = L::splat(1.0);
        let [x, y, z, xy, yz, zx] = self.deviator;
        let (x, y, z) = (x * self.scale, y * self.scale, z * self.scale);
        let (xy, yz, zx) = (xy * self.scale, yz * self.scale, zx * self.scale);
        let (cx, cy, cz) = (x - self.root, y - self.root, z - self.root);
        // The adjugate of B − xI is (x − x₂)(x − x₃) v⊗v with a trace of 3x² − 3 ≥ 6: its largest column is safe.
        let ax = yz.neg_mul_add(yz, cy * cz);
        let ay = zx.neg_mul_add(zx, cx * cz);
        let az = xy.neg_mul_add(xy, cx * cy);
        let axy = xy.neg_mul_add(cz, zx * yz);
        let ayz = yz.neg_mul_add(cx, xy * zx);
        let azx = zx.neg_mul_add(cy, xy * yz);
        let y_over_x = ax.less(ay);
        let best = L::select(y_over_x, ay, ax);
        let mut v =
            [L::select(y_over_x, axy, ax), L::select(y_over_x, ay, axy), L::select(y_over_x, ayz, azx)];
        let z_best = best.less(az);
        v = [L::select(z_best, azx, v[0]), L::select(z_best, ayz, v[1]), L::select(z_best, az, v[2])];
        let length = v[2].mul_add(v[2], v[1].mul_add(v[1], v[0] * v[0])).sqrt();
        let inverse = one / length;
        let v = [v[0] * inverse, v[1] * inverse, v[2] * inverse];

        // Two axes across v (Duff et al. 2017, 'Building an orthonormal basis, revisited').
        let side = L::select(v[2].less(zero), -one, one);
        let a = -(one / (side + v[2]));
        let b = v[0] * v[1] * a;
        let u = [(side * v[0] * v[0]).mul_add(a, one), side * b, -(side * v[0])];
        let w = [b, (v[1] * v[1]).mul_add(a, side), -v[1]];

        let bu = [
            zx.mul_add(u[2], xy.mul_add(u[1], x * u[0])),
            yz.mul_add(u[2], y.mul_add(u[1], xy * u[0])),
            z.mul_add(u[2], yz.mul_add(u[1], zx * u[0])),
        ];
        let bw = [
            zx.mul_add(w[2], xy.mul_add(w[1], x * w[0])),
            yz.mul_add(w[2], y.mul_add(w[1], xy * w[0])),
            z.mul_add(w[2], yz.mul_add(w[1], zx * w[0])),
        ];
        let m_uu = u[2].mul_add(bu[2], u[1].mul_add(bu[1], u[0] * bu[0]));
        let m_uw = w[2].mul_add(bu[2], w[1].mul_add(bu[1], w[0] * bu[0]));
        let m_ww = w[2].mul_add(bw[2], w[1].mul_add(bw[1], w[0] * bw[0]));
        let half = L::splat(0.5);
        let centre = (m_uu + m_ww) * half;
        let difference = (m_uu - m_ww) * half;
        let spread = difference.mul_add(difference, m_uw * m_uw).sqrt();
        // The larger of two parallel vectors, (d + ρ, o) and (o, ρ − d), is free of cancellation.
        let along = difference.abs() + spread;
        let flipped = difference.less(zero);
        let (c, s) = (L::select(flipped, m_uw, along), L::select(flipped, along, m_uw));
        let square = c.mul_add(c, s * s);
        let equal = square.less(L::splat(1e-200));
        let inverse = one / L::select(equal, one, square).sqrt();
        let c = L::select(equal, one, c * inverse);
        let s = L::select(equal, zero, s * inverse);
        let second = [c.mul_add(u[0], s * w[0]), c.mul_add(u[1], s * w[1]), c.mul_add(u[2], s * w[2])];
        let third =
            [c.mul_add(w[0], -(s * u[0])), c.mul_add(w[1], -(s * u[1])), c.mul_add(w[2], -(s * u[2]))];
        let negative = self.sign.less(zero);
        let mut vectors = [v, second, third];
        let mut i = 0;
        while i < 3 {
            vectors[0][i] = L::select(negative, third[i], v[i]);
            vectors[2][i] = L::select(negative, v[i], third[i]);
            i += 1;
        }
        Eigen { values: self.ordered(centre + spread, centre - spread), vectors }
    }
}

/// Principal values, largest first, and directions of any finite tensor (xx, yy, zz, xy, yz, zx; tensor shear).
///
/// The tensor is scaled by a power of two first, so neither tiny nor huge ones lose digits.
#[inline(always)]
pub fn eigen<L: Lane>(t: &[L; 6]) -> Eigen<L> {
    let mut largest = t[0].abs();
    let mut k = 1;
    while k < 6 {
        largest = t[k].abs().larger(largest);
        k += 1;
    }
    let limit = L::splat(1022.0);
    let exponent = (-limit).larger(largest.exponent()).smaller(limit);
    let (down, up) = ((-exponent).power_of_two(), exponent.power_of_two());
    let scaled = [t[0] * down, t[1] * down, t[2] * down, t[3] * down, t[4] * down, t[5] * down];
    let mut eigen = Spectrum::of(&scaled).eigen();
    eigen.values = [eigen.values[0] * up, eigen.values[1] * up, eigen.values[2] * up];
    eigen
}
