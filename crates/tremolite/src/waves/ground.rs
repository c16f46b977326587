//! Horizontal layers on a half-space under one plane wave, at one frequency.
//!
//! From the top down the matrix R of what comes back of the waves that go up is carried through the layers, then from the base up
//! the waves themselves. Only e^(−sqh), never larger than 1, appears, so that layers may be thin or thick and waves evanescent
//! (`kennett1983`; the same as [`crate::layered_column`] has with one wave). The half-space is as stiff as the lowest
//! layer and undamped; above a top that is not free lies another, of the highest layer's stuff, undamped as well.

use super::modes::{Modes, Square, p_sv, sh, solve};
use super::rock::{Rock, Stratum};
use tremolite_engine::Top;
use tremolite_motion::Complex64;

/// The ground.
#[derive(Clone, Debug, PartialEq)]
pub struct LayeredGround {
    /// Upwards, neighbours unlike; at least one.
    strata: Vec<Stratum>,
    top: Top,
}

/// The waves of all layers at one frequency and slowness.
pub struct Waves<const N: usize> {
    s: Complex64,
    p: f64,
    layers: Vec<InLayer<N>>,
}

struct InLayer<const N: usize> {
    modes: Modes<N>,
    thickness: f64,
    /// Amplitudes of what goes up at the bottom, and of what comes down at the top.
    up: [Complex64; N],
    down: [Complex64; N],
    shear: Complex64,
    pressure: Complex64,
}

/// What moves and pulls at a level, over the wave's own displacement, and its change upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level<const V: usize> {
    pub value: [Complex64; V],
    pub slope: [Complex64; V],
}

/// Of P and SV: u_h, u_z, σ_hh, σ_tt, σ_zz, σ_hz. Of SH: u_t, σ_ht, σ_tz.
pub const IN_PLANE: usize = 6;
pub const ACROSS: usize = 3;

impl LayeredGround {
    /// Of layers given upwards; neighbours of the same stuff are one. None without layers that have a thickness.
    pub fn new(strata: impl IntoIterator<Item = Stratum>, top: Top) -> Option<Self> {
        let mut merged: Vec<Stratum> = Vec::new();
        for stratum in strata.into_iter().filter(|stratum| stratum.thickness > 0.0) {
            match merged.last_mut() {
                Some(last) if last.rock == stratum.rock => last.thickness += stratum.thickness,
                _ => merged.push(stratum),
            }
        }
        (!merged.is_empty()).then_some(LayeredGround { strata: merged, top })
    }

    /// Upwards.
    pub fn strata(&self) -> &[Stratum] {
        &self.strata
    }

    pub fn top(&self) -> Top {
        self.top
    }

    /// The rock below.
    pub fn below(&self) -> Rock {
        self.strata[0].rock.undamped()
    }

    /// From the base to the top \[m\].
    pub fn height(&self) -> f64 {
        self.strata.iter().map(|stratum| stratum.thickness).sum()
    }

    /// Whether the layers are of the same stuff and as thick to a millionth of the whole.
    pub fn close_to(&self, other: &LayeredGround) -> bool {
        let near = 1e-6 * self.height();
        let same =
            |(a, b): (&Stratum, &Stratum)| a.rock == b.rock && (a.thickness - b.thickness).abs() <= near;
        self.top == other.top
            && self.strata.len() == other.strata.len()
            && self.strata.iter().zip(&other.strata).all(same)
    }

    /// The layer at a height \[m\] above the base, and how far that lies above the layer's bottom: the lower one of two.
    pub fn stratum_at(&self, height: f64) -> (usize, f64) {
        let mut bottom = 0.0;
        for (k, stratum) in self.strata.iter().enumerate() {
            if height <= bottom + stratum.thickness || k + 1 == self.strata.len() {
                return (k, (height - bottom).clamp(0.0, stratum.thickness));
            }
            bottom += stratum.thickness;
        }
        (0, 0.0)
    }

    /// P and SV under incident amplitudes of the two at the base.
    pub fn p_sv(&self, s: Complex64, p: f64, incident: [Complex64; 2]) -> Waves<2> {
        self.waves(s, p, incident, |rock| p_sv(&rock.at(s), [rock.p, rock.s], p, s))
    }

    /// SH under an incident one of length 1.
    pub fn sh(&self, s: Complex64, p: f64) -> Waves<1> {
        self.waves(s, p, [Complex64::from(1.0)], |rock| sh(&rock.at(s), p, s))
    }

    fn waves<const N: usize>(
        &self,
        s: Complex64,
        p: f64,
        incident: [Complex64; N],
        modes: impl Fn(&Rock) -> Modes<N>,
    ) -> Waves<N> {
        let of: Vec<Modes<N>> = self.strata.iter().map(|stratum| modes(&stratum.rock)).collect();
        let count = of.len();
        let decay = |k: usize| of[k].slowness.map(|q| (-s * q * self.strata[k].thickness).exp());
        // What the top of each layer sends back, and what it lets through; of the half-space below last.
        let mut mirrors = vec![[[Complex64::default(); N]; N]; count];
        let mut passes = mirrors.clone();
        mirrors[count - 1] = match self.top {
            Top::Free => free(&of[count - 1]),
            Top::Viscous => {
                let above = modes(&self.strata[count - 1].rock.undamped());
                interface(&of[count - 1], &above.moved[0], &above.pulled[0]).0
            }
        };
        let below = modes(&self.below());
        for k in (0..count).rev() {
            let decay = decay(k);
            // At the bottom of the layer, of waves that go up with 1 there.
            let back = |i: usize, j: usize| decay[i] * mirrors[k][i][j] * decay[j];
            let total = |set: &[Square<N>; 2]| {
                let mut total = set[0];
                for (row, down) in total.iter_mut().zip(&set[1]) {
                    for (j, sum) in row.iter_mut().enumerate() {
                        *sum += (0..N).map(|i| down[i] * back(i, j)).sum::<Complex64>();
                    }
                }
                total
            };
            let (moved, pulled) = (total(&of[k].moved), total(&of[k].pulled));
            let under = if k == 0 { &below } else { &of[k - 1] };
            let (mirror, pass) = interface(under, &moved, &pulled);
            passes[k] = pass;
            if k > 0 {
                mirrors[k - 1] = mirror;
            }
        }
        let mut arriving = incident;
        let mut layers = Vec::with_capacity(count);
        for k in 0..count {
            let up = times(&passes[k], &arriving);
            let decay = decay(k);
            let at_top: [Complex64; N] = std::array::from_fn(|j| decay[j] * up[j]);
            let seen = self.strata[k].rock.at(s);
            layers.push(InLayer {
                modes: of[k],
                thickness: self.strata[k].thickness,
                up,
                down: times(&mirrors[k], &at_top),
                shear: seen.shear,
                pressure: seen.pressure,
            });
            arriving = at_top;
        }
        Waves { s, p, layers }
    }
}

fn times<const N: usize>(matrix: &Square<N>, vector: &[Complex64; N]) -> [Complex64; N] {
    std::array::from_fn(|i| (0..N).map(|j| matrix[i][j] * vector[j]).sum())
}

/// What comes back from a surface without traction.
fn free<const N: usize>(modes: &Modes<N>) -> Square<N> {
    let mut rows = [[Complex64::default(); 4]; N];
    let mut right = modes.pulled[0].map(|row| row.map(|x| -x));
    for (row, pulled) in rows.iter_mut().zip(&modes.pulled[1]) {
        row[..N].copy_from_slice(pulled);
    }
    solve(&mut rows, &mut right);
    right
}

/// What comes back from, and what goes up through, an interface above which waves of amplitude 1 move and pull so.
fn interface<const N: usize>(
    below: &Modes<N>,
    moved: &Square<N>,
    pulled: &Square<N>,
) -> (Square<N>, Square<N>) {
    let mut rows = [[Complex64::default(); 4]; 4];
    let mut right = [[Complex64::default(); N]; 4];
    let both = [(&below.moved, moved), (&below.pulled, pulled)];
    for (block, (own, above)) in both.into_iter().enumerate() {
        for i in 0..N {
            let row = block * N + i;
            for j in 0..N {
                rows[row][j] = own[1][i][j];
                rows[row][N + j] = -above[i][j];
                right[row][j] = -own[0][i][j];
            }
        }
    }
    solve(&mut rows[..2 * N], &mut right[..2 * N]);
    (std::array::from_fn(|i| right[i]), std::array::from_fn(|i| right[N + i]))
}

impl<const N: usize> Waves<N> {
    /// Displacements, stresses on the level, and the changes of both upwards, in a layer so far \[m\] above its bottom.
    fn level(&self, layer: usize, above: f64) -> [[Complex64; N]; 4] {
        let s = self.s;
        let InLayer { modes, thickness, up, down, .. } = &self.layers[layer];
        let faded = |j: usize, way: f64| (-s * modes.slowness[j] * way).exp();
        let up: [Complex64; N] = std::array::from_fn(|j| up[j] * faded(j, above));
        let down: [Complex64; N] = std::array::from_fn(|j| down[j] * faded(j, thickness - above));
        let steep = |wave: &[Complex64; N], sign: f64| -> [Complex64; N] {
            std::array::from_fn(|j| sign * s * modes.slowness[j] * wave[j])
        };
        let (up_slope, down_slope) = (steep(&up, -1.0), steep(&down, 1.0));
        let sum = |set: &[Square<N>; 2], up: &[Complex64; N], down: &[Complex64; N]| -> [Complex64; N] {
            let (a, b) = (times(&set[0], up), times(&set[1], down));
            std::array::from_fn(|i| a[i] + b[i])
        };
        [
            sum(&modes.moved, &up, &down),
            sum(&modes.pulled, &up, &down).map(|t| -s * t),
            sum(&modes.moved, &up_slope, &down_slope),
            sum(&modes.pulled, &up_slope, &down_slope).map(|t| -s * t),
        ]
    }
}

impl Waves<2> {
    /// In a layer, so far \[m\] above its bottom.
    pub fn at(&self, layer: usize, above: f64) -> Level<IN_PLANE> {
        let InLayer { shear, pressure, .. } = self.layers[layer];
        let lame = pressure - 2.0 * shear;
        let all = |[uh, uz]: [Complex64; 2], [hz, zz]: [Complex64; 2]| {
            let along = -self.s * self.p * uh;
            let rising = (zz - lame * along) / pressure;
            [uh, uz, pressure * along + lame * rising, lame * (along + rising), zz, hz]
        };
        let [moved, pulled, moved_slope, pulled_slope] = self.level(layer, above);
        Level { value: all(moved, pulled), slope: all(moved_slope, pulled_slope) }
    }
}

impl Waves<1> {
    /// In a layer, so far \[m\] above its bottom.
    pub fn at(&self, layer: usize, above: f64) -> Level<ACROSS> {
        let along = -self.s * self.p * self.layers[layer].shear;
        let all = |[u]: [Complex64; 1], [tz]: [Complex64; 1]| [u, along * u, tz];
        let [moved, pulled, moved_slope, pulled_slope] = self.level(layer, above);
        Level { value: all(moved, pulled), slope: all(moved_slope, pulled_slope) }
    }
}
