//! The assumed strain of an element that is integrated by several points: from modal displacements to the strain's own
//! coefficients, and back from their resultants to modal forces.

use super::modal::{MODES, along_axis, mean_gradient, mean_gradients, modal_forces};
use super::unit_strains::{fibre_strain, surface_strains};
use super::wedge::WedgeField;
use super::{Given, Hex8, Stabilisation, Surface, to_modes, to_nodes};
use crate::lane::{Lane, Octet};
use crate::material::Sym;

/// What the points of eight elements share; 126 octets, that is 1008 bytes an element.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct Field {
    /// As in the one-point element.
    pub gradient: [[Octet; 7]; 3],
    pub hourglass: [[Octet; 3]; 4],
    axes: [[Octet; 3]; 3],
    /// ℓ_b/ℓ_c of the surface across each natural axis, and its inverse; zero of the surfaces across ξ and η of a wedge.
    aspects: [[Octet; 2]; 3],
    /// Strain (global axes, engineering shear) for unit s_bc, s_cb and γ of each surface, contraction included. Of the surfaces across ξ
    /// and η of a wedge: [`WedgeField`]'s stretch and turn, and its shears in the places of s_bc across ξ and of s_cb across η.
    surfaces: [[[Octet; 6]; 3]; 3],
    /// Strain for unit s_k4, contraction included; of a wedge that of its sides.
    fibres: [[Octet; 6]; 3],
    /// Means of ξ, η, ζ, ηζ, ξζ, ξη, weighted as the points are: removed so that a constant stress does no work on the
    /// hourglass part.
    means: [Octet; 6],
}

/// Modes of the hourglass strain in the order of `means`.
pub(super) const STRAIN_MODES: [usize; 6] = [1, 2, 4, 6, 5, 3];
/// ξ at the points of the 2×2×2 rule.
pub(super) const G: f64 = 0.577_350_269_189_625_8;

/// What the values ±1 of the strain's modes stand for: ξ, η, ζ, and ηζ, ξζ, ξη, at the places of the points.
pub struct Scale {
    pub linear: [f64; 3],
    pub product: [f64; 3],
    /// Along which axes the points tell a moment, so that its modes are freed of the products' share in it.
    pub bends: [bool; 3],
}

/// Means of natural coordinates up to which a plan is a parallelogram: its bits are those of one.
const CENTRED: f64 = 1e-9;

/// Geometry of eight elements of several points as their strain needs it: from modal displacements to the strain's coefficients by
/// component, `[component][mode]`, mode 7 empty, and back from their resultants.
pub trait FieldShape: Copy + Send + Sync + 'static {
    /// The coefficients; `initial` is what the strain begins with ([`super::Given::strain`]).
    fn strain<L: Lane>(
        &self,
        modes: &[[L; 8]; 3],
        scale: &Scale,
        initial: &[Octet],
        at: usize,
    ) -> [[L; 8]; 6];

    /// Modal forces from the resultants of the strain's modes, Σ weight · stress · ±1.
    fn forces<L: Lane>(&self, resultants: [[L; 8]; 6], scale: &Scale, at: usize) -> [[L; 8]; 3];

    /// Mean dilatation over the volume, from the coefficients.
    fn dilatation<L: Lane>(&self, e: &[[L; 8]; 6], scale: &Scale, at: usize) -> L;

    /// Takes a pressure times the volume off the resultants of stresses.
    fn press<L: Lane>(&self, resultants: &mut [[L; 8]; 6], pressure: L, scale: &Scale, at: usize);

    /// The size tensor that a law sees ([`crate::Point::size`]).
    fn size<L: Lane>(&self, given: &Given, at: usize) -> Sym<L>;

    /// Mean displacement gradient ([`crate::Point::gradient`]).
    fn gradient<L: Lane>(&self, modes: &[[L; 8]; 3], at: usize) -> [[L; 3]; 3];

    /// A stress in global axes from one in those of the strain.
    fn global<L: Lane>(&self, stress: &Sym<L>, at: usize) -> Sym<L>;

    /// The inverse of [`FieldShape::global`].
    fn local<L: Lane>(&self, stress: &Sym<L>, at: usize) -> Sym<L>;

    /// From coefficients to values at 2×2×2 points, in place.
    fn to_points<L: Lane>(e: &mut [[L; 8]; 6]);

    /// The transpose: from weighted stresses to resultants.
    fn to_resultants<L: Lane>(e: &mut [[L; 8]; 6]);
}

impl Field {
    pub const EMPTY: Self = Field {
        gradient: [[Octet::ZERO; 7]; 3],
        hourglass: [[Octet::ZERO; 3]; 4],
        axes: [[Octet::ZERO; 3]; 3],
        aspects: [[Octet::ZERO; 2]; 3],
        surfaces: [[[Octet::ZERO; 6]; 3]; 3],
        fibres: [[Octet::ZERO; 6]; 3],
        means: [Octet::ZERO; 6],
    };

    /// Puts an element into a lane; `points` are the natural coordinates of its points, with their weights.
    pub fn set(
        &mut self,
        lane: usize,
        hex: &Hex8,
        elastic: &Stabilisation,
        points: impl Iterator<Item = ([f64; 3], f64)> + Clone,
    ) {
        for j in 0..3 {
            for (k, mode) in MODES.into_iter().enumerate() {
                self.gradient[j][k].0[lane] = hex.gradient[mode][j];
            }
            for alpha in 0..4 {
                self.hourglass[alpha][j].0[lane] = hex.hourglass[alpha][j];
            }
            for k in 0..3 {
                self.axes[k][j].0[lane] = hex.directions[k][j] / (8.0 * hex.half_lengths[k]);
            }
        }
        for k in 0..3 {
            let aspect = Surface::across(hex, k).aspect;
            self.aspects[k][0].0[lane] = aspect;
            self.aspects[k][1].0[lane] = 1.0 / aspect;
            let strains = surface_strains(hex, k, elastic.poisson_plane);
            let fibre = fibre_strain(hex, k, elastic.poisson);
            for c in 0..6 {
                for (octets, strain) in self.surfaces[k].iter_mut().zip(&strains) {
                    octets[c].0[lane] = strain[c];
                }
                self.fibres[k][c].0[lane] = fibre[c];
            }
        }
        if hex.is_wedge {
            self.set_wedge(lane, &WedgeField::of(hex, elastic));
        }
        for (k, mode) in STRAIN_MODES.into_iter().enumerate() {
            let value = |xi: [f64; 3]| -> f64 {
                (0..3).filter(|axis| mode >> axis & 1 == 1).map(|axis| xi[axis]).product()
            };
            let mean: f64 = points.clone().map(|(xi, weight)| weight * value(xi)).sum();
            self.means[k].0[lane] = mean / hex.volume;
        }
    }

    /// Puts a wedge into the places of what it lacks: aspects of the surfaces across ξ and η, by which it is known, their strains, fibres.
    fn set_wedge(&mut self, lane: usize, wedge: &WedgeField) {
        for octet in self.aspects[..2].iter_mut().flatten() {
            octet.0[lane] = 0.0;
        }
        let shears = [0, 1].map(|half| [0, 1, 2, 3, 4, 5].map(|i| wedge.shears.as_flattened()[6 * half + i]));
        for c in 0..6 {
            self.surfaces[0][0][c].0[lane] = shears[0][c];
            self.surfaces[0][1][c].0[lane] = wedge.stretch[c];
            self.surfaces[0][2][c].0[lane] = wedge.turn[0][c];
            self.surfaces[1][0][c].0[lane] = wedge.stretch[c];
            self.surfaces[1][1][c].0[lane] = shears[1][c];
            self.surfaces[1][2][c].0[lane] = wedge.turn[1][c];
            for (side, strain) in self.fibres.iter_mut().zip(&wedge.sides) {
                side[c].0[lane] = strain[c];
            }
        }
    }

    /// Means of ξ, η and ζ over what their values ±1 stand for, zero where the product modes are square to the linear ones anyway; and the lanes
    /// where they are not.
    #[inline(always)]
    fn centres<L: Lane>(&self, wedges: L::Mask, means: &[L; 6]) -> ([L; 3], L::Mask) {
        let zero = L::splat(0.0);
        let (mut centres, mut most) = ([zero; 3], zero);
        let mut k = 0;
        while k < 3 {
            let mean = L::select(wedges, zero, means[k]);
            centres[k] = L::select(L::splat(CENTRED).less(mean.abs()), mean, zero);
            most = most.larger(centres[k].abs());
            k += 1;
        }
        (centres, zero.less(most))
    }

    /// Lanes of wedges and of elements without extent.
    #[inline(always)]
    fn wedges<L: Lane>(&self, at: usize) -> L::Mask {
        L::not(L::splat(0.0).less(L::load(&self.aspects[0][0], at)))
    }

    /// How much the linear shear of a side of a wedge is for unit s_x2, s_y1, s_x1 and s_y2.
    #[inline(always)]
    fn shears<L: Lane>(&self, side: usize, at: usize) -> [L; 4] {
        let mut shears = [L::splat(0.0); 4];
        let mut i = 0;
        while i < 4 {
            let k = 4 * side + i;
            let half = if k < 6 { &self.surfaces[0][0] } else { &self.surfaces[1][1] };
            shears[i] = L::load(&half[k % 6], at);
            i += 1;
        }
        shears
    }

    /// Gives lanes of wedges their strain in place of a hexahedron's: its modes but ζ, and the mean shear that is linked.
    #[inline(always)]
    fn strain_wedges<L: Lane>(
        &self,
        wedges: L::Mask,
        s: &[[L; 4]; 3],
        scale: &Scale,
        mean: &mut Sym<L>,
        e: &mut [[L; 8]; 6],
        at: usize,
    ) {
        let zero = L::splat(0.0);
        let amplitudes = [s[0][1], s[1][0], s[0][0], s[1][1]];
        let mut shears = [zero; 3];
        let mut side = 0;
        while side < 3 {
            let of = self.shears::<L>(side, at);
            let sum = of[1].mul_add(amplitudes[1], of[0] * amplitudes[0]);
            shears[side] = of[3].mul_add(amplitudes[3], of[2].mul_add(amplitudes[2], sum));
            side += 1;
        }
        let aspects = &self.aspects[2];
        let turn = L::load(&aspects[0], at).neg_mul_add(s[0][0], L::load(&aspects[1], at) * s[1][1]);
        let [x, y] = [&self.surfaces[0], &self.surfaces[1]];
        let (linear, product) = (scale.linear, L::splat(-scale.product[2]));
        let mut v = 0;
        while v < 6 {
            let xi = L::load(&x[2][v], at).mul_add(turn, L::load(&x[1][v], at) * s[2][1]);
            let eta = L::load(&y[2][v], at).mul_add(turn, L::load(&y[0][v], at) * s[2][0]);
            e[v][1] = L::select(wedges, xi * L::splat(linear[0]), e[v][1]);
            e[v][2] = L::select(wedges, eta * L::splat(linear[1]), e[v][2]);
            e[v][3] = L::select(wedges, xi * product, e[v][3]);
            e[v][5] = L::select(wedges, zero, e[v][5]);
            e[v][6] = L::select(wedges, zero, e[v][6]);
            let mut sum = L::load(&self.fibres[0][v], at).mul_add(shears[0], mean[v]);
            sum = L::load(&self.fibres[1][v], at).mul_add(shears[1], sum);
            sum = L::load(&self.fibres[2][v], at).mul_add(shears[2], sum);
            mean[v] = L::select(wedges, sum, mean[v]);
            v += 1;
        }
    }

    /// The transpose: forces conjugate to s of lanes of wedges, in place of those of a hexahedron but for the mode ζ.
    #[inline(always)]
    fn forces_wedges<L: Lane>(
        &self,
        wedges: L::Mask,
        e: &[[L; 8]; 6],
        scale: &Scale,
        conjugate: &mut [[L; 4]; 3],
        at: usize,
    ) {
        let zero = L::splat(0.0);
        let [x, y] = [&self.surfaces[0], &self.surfaces[1]];
        let (linear, product) = (scale.linear, L::splat(scale.product[2]));
        let (mut of_xi, mut of_eta, mut turn, mut sides) = (zero, zero, zero, [zero; 3]);
        let mut v = 0;
        while v < 6 {
            let xi = product.neg_mul_add(e[v][3], e[v][1] * L::splat(linear[0]));
            let eta = e[v][2] * L::splat(linear[1]);
            of_xi = L::load(&x[1][v], at).mul_add(xi, of_xi);
            of_eta = L::load(&y[0][v], at).mul_add(eta, of_eta);
            turn = L::load(&x[2][v], at).mul_add(xi, turn);
            turn = L::load(&y[2][v], at).mul_add(eta, turn);
            let mut side = 0;
            while side < 3 {
                sides[side] = L::load(&self.fibres[side][v], at).mul_add(e[v][0], sides[side]);
                side += 1;
            }
            v += 1;
        }
        // The mode ζ alone is a hexahedron's.
        let aspects = &self.aspects[2];
        let mut amplitudes = [
            conjugate[0][1],
            conjugate[1][0],
            L::load(&aspects[0], at).neg_mul_add(turn, conjugate[0][0]),
            L::load(&aspects[1], at).mul_add(turn, conjugate[1][1]),
        ];
        let mut side = 0;
        while side < 3 {
            let of = self.shears::<L>(side, at);
            let mut i = 0;
            while i < 4 {
                amplitudes[i] = of[i].mul_add(sides[side], amplitudes[i]);
                i += 1;
            }
            side += 1;
        }
        let own = [
            [amplitudes[2], amplitudes[0], zero, zero],
            [amplitudes[1], amplitudes[3], zero, zero],
            [of_eta, of_xi, zero, zero],
        ];
        let mut k = 0;
        while k < 3 {
            let mut alpha = 0;
            while alpha < 4 {
                conjugate[k][alpha] = L::select(wedges, own[k][alpha], conjugate[k][alpha]);
                alpha += 1;
            }
            k += 1;
        }
    }

    /// Means of the strain's modes over what their values ±1 stand for.
    #[inline(always)]
    fn means<L: Lane>(&self, scale: &Scale, at: usize) -> [L; 6] {
        [
            L::load(&self.means[0], at) * L::splat(1.0 / scale.linear[0]),
            L::load(&self.means[1], at) * L::splat(1.0 / scale.linear[1]),
            L::load(&self.means[2], at) * L::splat(1.0 / scale.linear[2]),
            L::load(&self.means[3], at) * L::splat(1.0 / scale.product[0]),
            L::load(&self.means[4], at) * L::splat(1.0 / scale.product[1]),
            L::load(&self.means[5], at) * L::splat(1.0 / scale.product[2]),
        ]
    }
}

impl FieldShape for Field {
    #[inline(always)]
    fn strain<L: Lane>(
        &self,
        modes: &[[L; 8]; 3],
        scale: &Scale,
        initial: &[Octet],
        at: usize,
    ) -> [[L; 8]; 6] {
        let means = self.means::<L>(scale, at);
        let (g0, q0) = mean_gradient::<L>(&self.gradient, &self.hourglass, &modes[0], at);
        let (g1, q1) = mean_gradient::<L>(&self.gradient, &self.hourglass, &modes[1], at);
        let (g2, q2) = mean_gradient::<L>(&self.gradient, &self.hourglass, &modes[2], at);
        let g = [g0, g1, g2];
        let s = [
            along_axis::<L>(&self.axes[0], &q0, &q1, &q2, at),
            along_axis::<L>(&self.axes[1], &q0, &q1, &q2, at),
            along_axis::<L>(&self.axes[2], &q0, &q1, &q2, at),
        ];

        // From the table in the module documentation.
        let mut e = [[L::splat(0.0); 8]; 6];
        let mut k = 0;
        while k < 3 {
            let (b, c) = ((k + 1) % 3, (k + 2) % 3);
            let mode = 1 << k;
            let aspects = &self.aspects[k];
            let linear = L::splat(scale.linear[k]);
            let along = s[b][c] * linear;
            let across = s[c][b] * linear;
            let gamma =
                L::load(&aspects[0], at).mul_add(s[b][b], L::load(&aspects[1], at) * s[c][c]) * linear;
            let fibre = s[k][3] * L::splat(scale.product[k]);
            let mut v = 0;
            while v < 6 {
                let t = &self.surfaces[k];
                let sum = L::load(&t[1][v], at).mul_add(across, L::load(&t[0][v], at) * along);
                e[v][mode] = L::load(&t[2][v], at).mul_add(gamma, sum);
                e[v][7 ^ mode] = L::load(&self.fibres[k][v], at) * fibre;
                v += 1;
            }
            k += 1;
        }
        let mut mean: Sym<L> =
            [g[0][0], g[1][1], g[2][2], g[0][1] + g[1][0], g[1][2] + g[2][1], g[0][2] + g[2][0]];
        super::add_initial(&mut mean, initial, at);
        let wedges = self.wedges::<L>(at);
        let (centres, off) = self.centres(wedges, &means);
        let is_off = L::any(off);
        // Products of coordinates count from their means: a constant moment does no work on them.
        let mut c = 0;
        while is_off && c < 6 {
            let mut k = 0;
            while k < 3 {
                if scale.bends[k] {
                    let (a, b) = ((k + 1) % 3, (k + 2) % 3);
                    let sum = centres[a].neg_mul_add(e[c][7 ^ (1 << b)], e[c][1 << k]);
                    let sum = centres[b].neg_mul_add(e[c][7 ^ (1 << a)], sum);
                    e[c][1 << k] = L::select(off, sum, e[c][1 << k]);
                }
                k += 1;
            }
            c += 1;
        }
        if L::any(wedges) {
            self.strain_wedges(wedges, &s, scale, &mut mean, &mut e, at);
        }
        let mut c = 0;
        while c < 6 {
            let mut constant = mean[c];
            let mut k = 0;
            while k < 6 {
                constant = means[k].neg_mul_add(e[c][STRAIN_MODES[k]], constant);
                k += 1;
            }
            e[c][0] = constant;
            c += 1;
        }
        e
    }

    /// Forces conjugate to s, then to q, g and the modes.
    #[inline(always)]
    fn forces<L: Lane>(&self, mut e: [[L; 8]; 6], scale: &Scale, at: usize) -> [[L; 8]; 3] {
        let means = self.means::<L>(scale, at);
        let wedges = self.wedges::<L>(at);
        let (centres, off) = self.centres(wedges, &means);
        let is_off = L::any(off);
        let mut c = 0;
        while c < 6 {
            let constant = e[c][0];
            let mut k = 0;
            while k < 6 {
                let mode = STRAIN_MODES[k];
                e[c][mode] = means[k].neg_mul_add(constant, e[c][mode]);
                k += 1;
            }
            let mut k = 0;
            while is_off && k < 3 {
                if scale.bends[k] {
                    let (a, b) = ((k + 1) % 3, (k + 2) % 3);
                    let moment = e[c][1 << k];
                    let (first, second) = (e[c][7 ^ (1 << b)], e[c][7 ^ (1 << a)]);
                    e[c][7 ^ (1 << b)] = L::select(off, centres[a].neg_mul_add(moment, first), first);
                    e[c][7 ^ (1 << a)] = L::select(off, centres[b].neg_mul_add(moment, second), second);
                }
                k += 1;
            }
            c += 1;
        }
        let mut conjugate = [[L::splat(0.0); 4]; 3];
        let mut k = 0;
        while k < 3 {
            let (b, c) = ((k + 1) % 3, (k + 2) % 3);
            let mode = 1 << k;
            let t = &self.surfaces[k];
            let linear = L::splat(scale.linear[k]);
            let mut sums = [L::splat(0.0); 4];
            let mut v = 0;
            while v < 6 {
                let resultant = e[v][mode];
                sums[0] = L::load(&t[0][v], at).mul_add(resultant, sums[0]);
                sums[1] = L::load(&t[1][v], at).mul_add(resultant, sums[1]);
                sums[2] = L::load(&t[2][v], at).mul_add(resultant, sums[2]);
                sums[3] = L::load(&self.fibres[k][v], at).mul_add(e[v][7 ^ mode], sums[3]);
                v += 1;
            }
            conjugate[b][c] = sums[0] * linear;
            conjugate[c][b] = sums[1] * linear;
            let shear = sums[2] * linear;
            let aspects = &self.aspects[k];
            conjugate[b][b] = L::load(&aspects[0], at).mul_add(shear, conjugate[b][b]);
            conjugate[c][c] = L::load(&aspects[1], at).mul_add(shear, conjugate[c][c]);
            conjugate[k][3] = sums[3] * L::splat(scale.product[k]);
            k += 1;
        }
        if L::any(wedges) {
            self.forces_wedges(wedges, &e, scale, &mut conjugate, at);
        }
        let resultants: Sym<L> = [e[0][0], e[1][0], e[2][0], e[3][0], e[4][0], e[5][0]];
        let (b, x, axes) = (&self.gradient, &self.hourglass, &self.axes);
        [
            modal_forces::<L, 0>(b, x, axes, &resultants, &conjugate, at),
            modal_forces::<L, 1>(b, x, axes, &resultants, &conjugate, at),
            modal_forces::<L, 2>(b, x, axes, &resultants, &conjugate, at),
        ]
    }

    #[inline(always)]
    fn dilatation<L: Lane>(&self, e: &[[L; 8]; 6], scale: &Scale, at: usize) -> L {
        let means = self.means::<L>(scale, at);
        let mut mean = e[0][0] + e[1][0] + e[2][0];
        let mut k = 0;
        while k < 6 {
            let mode = STRAIN_MODES[k];
            mean = means[k].mul_add(e[0][mode] + e[1][mode] + e[2][mode], mean);
            k += 1;
        }
        mean
    }

    #[inline(always)]
    fn press<L: Lane>(&self, resultants: &mut [[L; 8]; 6], pressure: L, scale: &Scale, at: usize) {
        let means = self.means::<L>(scale, at);
        let mut c = 0;
        while c < 3 {
            resultants[c][0] = resultants[c][0] - pressure;
            let mut k = 0;
            while k < 6 {
                let mode = STRAIN_MODES[k];
                resultants[c][mode] = means[k].neg_mul_add(pressure, resultants[c][mode]);
                k += 1;
            }
            c += 1;
        }
    }

    #[inline(always)]
    fn size<L: Lane>(&self, given: &Given, at: usize) -> Sym<L> {
        super::seen_size(given, &self.gradient, &self.hourglass, at)
    }

    #[inline(always)]
    fn gradient<L: Lane>(&self, modes: &[[L; 8]; 3], at: usize) -> [[L; 3]; 3] {
        mean_gradients(&self.gradient, &self.hourglass, modes, at)
    }

    #[inline(always)]
    fn global<L: Lane>(&self, stress: &Sym<L>, _: usize) -> Sym<L> {
        *stress
    }

    #[inline(always)]
    fn local<L: Lane>(&self, stress: &Sym<L>, _: usize) -> Sym<L> {
        *stress
    }

    #[inline(always)]
    fn to_points<L: Lane>(e: &mut [[L; 8]; 6]) {
        let mut c = 0;
        while c < 6 {
            to_nodes(&mut e[c]);
            c += 1;
        }
    }

    #[inline(always)]
    fn to_resultants<L: Lane>(e: &mut [[L; 8]; 6]) {
        let mut c = 0;
        while c < 6 {
            to_modes(&mut e[c]);
            c += 1;
        }
    }
}
