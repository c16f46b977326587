//! One-point quadrature with the hourglass part integrated in closed form.

use super::modal::{MODES, along_axis, mean_gradient, mean_gradients, modal_forces};
use super::pores::Pressed;
use super::wedge::turn_square;
use super::{Given, Hex8, Probe, Stabilisation, Surface, gather_modes, scatter_nodal, store_nodal};
use crate::band::{BandStep, MEMORY};
use crate::lane::{Lane, Octet, Row};
use crate::material::{Material, Point, Sym, load, store};

/// Elastic constants against the hourglass modes, in what the law has left.
#[derive(Clone, Copy)]
pub struct Resistance<L> {
    /// E/(1 − ν²) V/3 \[N m\].
    pub bend: L,
    /// E V/9 \[N m\].
    pub twist: L,
    /// 1 − ν
    pub less: L,
}

/// Geometry of eight elements, whatever of it a shape of elements needs.
///
/// The amplitudes of the hourglass modes are those in which the shape is simplest, `[axis][mode]`; the forces against them are
/// conjugate to these.
pub trait OnePointShape: Copy + Send + Sync + 'static {
    /// Without extent: forces from it are zero. Pads the last octet of a patch.
    const EMPTY: Self;

    /// Puts an element into a lane.
    fn set(&mut self, lane: usize, hex: &Hex8);

    /// \[m³\]
    fn volume<L: Lane>(&self, at: usize) -> L;

    /// The size tensor that a law sees ([`Point::size`]).
    fn size<L: Lane>(&self, given: &Given, at: usize) -> Sym<L>;

    /// Mean displacement gradient ([`Point::gradient`]).
    fn gradient<L: Lane>(&self, modes: &[[L; 8]; 3], at: usize) -> [[L; 3]; 3];

    /// Mean strain and hourglass amplitudes.
    fn strain<L: Lane>(&self, modes: &[[L; 8]; 3], at: usize) -> (Sym<L>, [[L; 4]; 3]);

    /// Forces against the amplitudes.
    fn resist<L: Lane>(&self, elastic: Resistance<L>, amplitudes: &[[L; 4]; 3], at: usize) -> [[L; 4]; 3];

    /// Modal forces of one component `I`, from stress resultants ∫σ dV and the forces against the amplitudes.
    fn forces<L: Lane, const I: usize>(
        &self,
        resultants: &Sym<L>,
        against: &[[L; 4]; 3],
        at: usize,
    ) -> [L; 8];
}

/// Geometry of eight elements of any shape; 55 octets, that is 440 bytes an element. Amplitudes are s_kα along the natural axes.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct OnePointGeometry {
    /// Mean gradient b_mj: `[j][k]`, k over the modes ξ, η, ζ and then the four hourglass ones.
    gradient: [[Octet; 7]; 3],
    /// X_αj: `[α][j]`.
    hourglass: [[Octet; 3]; 4],
    /// Directions over half-lengths, with the ⅛ of γ: t_ki/(8 ℓ_k).
    axes: [[Octet; 3]; 3],
    /// Of the surface across each natural axis, see [`Surface`]: aspect, its inverse, cosine, stretch. Of the one across ξ of a wedge 0, 0, and
    /// the mean square of the shear of its turn in place of the cosine; 0 and 0 of the one across η.
    surfaces: [[Octet; 4]; 3],
    volume: Octet,
}

impl OnePointShape for OnePointGeometry {
    const EMPTY: Self = OnePointGeometry {
        gradient: [[Octet::ZERO; 7]; 3],
        hourglass: [[Octet::ZERO; 3]; 4],
        axes: [[Octet::ZERO; 3]; 3],
        surfaces: [[Octet::ZERO; 4]; 3],
        volume: Octet::ZERO,
    };

    fn set(&mut self, lane: usize, hex: &Hex8) {
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
            let surface = Surface::across(hex, k);
            let values = [surface.aspect, 1.0 / surface.aspect, surface.cosine, surface.stretch];
            for (octet, value) in self.surfaces[k].iter_mut().zip(values) {
                octet.0[lane] = value;
            }
        }
        if hex.is_wedge {
            for octet in self.surfaces[..2].iter_mut().flat_map(|surface| &mut surface[..2]) {
                octet.0[lane] = 0.0;
            }
            self.surfaces[0][2].0[lane] = turn_square(hex);
        }
        self.volume.0[lane] = hex.volume;
    }

    #[inline(always)]
    fn volume<L: Lane>(&self, at: usize) -> L {
        L::load(&self.volume, at)
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
    fn strain<L: Lane>(&self, modes: &[[L; 8]; 3], at: usize) -> (Sym<L>, [[L; 4]; 3]) {
        // Spelt out by component: a loop over them would keep the arrays out of registers.
        let (g0, q0) = mean_gradient::<L>(&self.gradient, &self.hourglass, &modes[0], at);
        let (g1, q1) = mean_gradient::<L>(&self.gradient, &self.hourglass, &modes[1], at);
        let (g2, q2) = mean_gradient::<L>(&self.gradient, &self.hourglass, &modes[2], at);
        let strain = [g0[0], g1[1], g2[2], g0[1] + g1[0], g1[2] + g2[1], g0[2] + g2[0]];
        let amplitudes = [
            along_axis::<L>(&self.axes[0], &q0, &q1, &q2, at),
            along_axis::<L>(&self.axes[1], &q0, &q1, &q2, at),
            along_axis::<L>(&self.axes[2], &q0, &q1, &q2, at),
        ];
        (strain, amplitudes)
    }

    #[inline(always)]
    fn resist<L: Lane>(&self, elastic: Resistance<L>, s: &[[L; 4]; 3], at: usize) -> [[L; 4]; 3] {
        let Resistance { bend, twist, less } = elastic;
        let mut p = [[L::splat(0.0); 4]; 3];
        p[0][3] = twist * s[0][3];
        p[1][3] = twist * s[1][3];
        p[2][3] = twist * s[2][3];
        bend_surface::<L, 0, 1, 2>(&self.surfaces[0], bend, less, s, &mut p, at);
        bend_surface::<L, 1, 2, 0>(&self.surfaces[1], bend, less, s, &mut p, at);
        bend_surface::<L, 2, 0, 1>(&self.surfaces[2], bend, less, s, &mut p, at);
        let wedges = L::not(L::splat(0.0).less(L::load(&self.surfaces[0][0], at)));
        if L::any(wedges) {
            self.resist_wedges(wedges, elastic, s, &mut p, at);
        }
        p
    }

    #[inline(always)]
    fn forces<L: Lane, const I: usize>(&self, resultants: &Sym<L>, p: &[[L; 4]; 3], at: usize) -> [L; 8] {
        modal_forces::<L, I>(&self.gradient, &self.hourglass, &self.axes, resultants, p, at)
    }
}

impl OnePointGeometry {
    /// Gives lanes of wedges the forces of their own strain ([`super::wedge`]) in place of a hexahedron's, but for those of the mode ζ, as
    /// if they were prisms: means of (ξ − ξη)² and of (η − η̄)² over a triangle are ⅔ and 2/9.
    #[inline(always)]
    fn resist_wedges<L: Lane>(
        &self,
        wedges: L::Mask,
        elastic: Resistance<L>,
        s: &[[L; 4]; 3],
        p: &mut [[L; 4]; 3],
        at: usize,
    ) {
        let zero = L::splat(0.0);
        let Resistance { bend, twist, less } = elastic;
        let aspects = &self.surfaces[2];
        let (aspect, inverse) = (L::load(&aspects[0], at), L::load(&aspects[1], at));
        // μV = 3/2 (1 − ν) E/(1 − ν²) V/3.
        let shear = L::splat(1.5) * (bend * less) * L::load(&self.surfaces[0][2], at);
        let turn = shear * aspect.neg_mul_add(s[0][0], inverse * s[1][1]);
        let own = [
            [aspect.neg_mul_add(turn, p[0][0]), p[0][1], zero, zero],
            [p[1][0], inverse.mul_add(turn, p[1][1]), zero, zero],
            [L::splat(2.0) * (twist * s[2][0]), L::splat(6.0) * (twist * s[2][1]), zero, zero],
        ];
        let mut k = 0;
        while k < 3 {
            let mut alpha = 0;
            while alpha < 4 {
                p[k][alpha] = L::select(wedges, own[k][alpha], p[k][alpha]);
                alpha += 1;
            }
            k += 1;
        }
    }
}

/// Internal forces of eight elements, added to `out`; history is updated in place.
///
/// `index[corner][lane]` points into `rows` (displacements \[m\]) and `out` (forces \[N\], the sign of ∫Bᵀσ).
/// With a band its bodies' stress is added, in what the law says is left; `overstress` is their memory, [`MEMORY`] octets a
/// point. `given` is what the elements have beside their geometry. Of a law that damages, what is left goes to `left`, [`LEFT`](super::LEFT) octets a point, unless that is empty. With
/// `PROBE` the stresses and energies go to `probe` as well.
///
/// # Safety
/// All indices must be below `rows.len()` and `out.len()`, and the lane's instruction set must be enabled.
#[inline(always)]
pub unsafe fn one_point<L: Lane, G: OnePointShape, M: Material, const PROBE: bool>(
    material: &M,
    elastic: &Stabilisation,
    point: &Point<f64>,
    geometry: &G,
    index: &[[u16; 8]; 8],
    history: &mut [Octet],
    band: Option<&BandStep>,
    overstress: &mut [Octet],
    given: Given,
    left: &mut [Octet],
    rows: &[Row],
    out: &mut [Row],
    probe: &mut Probe,
) {
    let facts = material.facts();
    let mut nodal = [[Octet::ZERO; 3]; 8];
    let mut at = 0;
    while at < 8 {
        // SAFETY: passed on to the caller.
        let mut modes = unsafe { gather_modes::<L>(rows, index, at) };

        let (mut strain, s) = geometry.strain::<L>(&modes, at);
        let mut pressed = Pressed::<L>::none();
        if let Some(water) = &given.water {
            pressed = water.press(strain[0] + strain[1] + strain[2], at);
            strain[0] = strain[0] + pressed.strain;
            strain[1] = strain[1] + pressed.strain;
            strain[2] = strain[2] + pressed.strain;
        }
        super::add_initial(&mut strain, given.strain, at);
        let mut lane_point = Point::<L>::splat(point);
        if facts.needs_size {
            lane_point.size = geometry.size(&given, at);
            lane_point.gradient = geometry.gradient(&modes, at);
        }
        let old: M::History<L> = load(history, at);
        let (of_law, mut new) = super::answer(material, &lane_point, strain, old, left, at);
        let mut stress = of_law;
        let mut held = L::splat(0.0);
        if let Some(band) = band {
            let (before, now) = (super::unbroken(material, &old), super::unbroken(material, &new));
            let memory = &mut overstress[..MEMORY];
            let mut moved = [L::splat(0.0); 6];
            if facts.damages && band.asks(before, now) && !given.moved.is_empty() {
                // SAFETY: passed on to the caller.
                let modes = unsafe { gather_modes::<L>(given.moved, index, at) };
                (moved, _) = geometry.strain::<L>(&modes, at);
            }
            stress = super::plus(stress, band.stress(&strain, before, now, &moved, memory, at));
            if PROBE && probe.wanted {
                held = band.held(&strain, now, memory, at);
                (geometry.volume::<L>(at) * BandStep::dissipated::<L>(memory, at))
                    .store(&mut probe.of_band, at);
            }
        }

        let volume = geometry.volume::<L>(at);
        let share = material.hourglass_share(&new);
        let resisting = volume * share;
        let resistance = Resistance {
            bend: resisting * L::splat(1.0 / 3.0) * L::splat(elastic.plane_stress),
            twist: resisting * L::splat(elastic.young / 9.0),
            less: L::splat(1.0 - elastic.poisson),
        };
        let p = geometry.resist(resistance, &s, at);

        // What the hourglass modes lose of their energy with their stiffness is dissipated.
        let before = material.hourglass_share(&old);
        if let Some(k) = facts.dissipation
            && L::any(share.less(before))
        {
            let lost = hourglass_energy(&p, &s) * (before / share - L::splat(1.0)) / volume;
            let book = &mut new.as_mut()[k];
            *book = L::select(share.less(before), *book + lost, *book);
        }
        store(&new, history, at);

        if PROBE && probe.wanted {
            let mut i = 0;
            while i < 6 {
                stress[i].store(&mut probe.stress[0][i], at);
                i += 1;
            }
            let stored = material.stored_energy(&strain, &of_law, &new) + held;
            let mut energy = volume * stored;
            if let Some(water) = &given.water {
                energy = energy - water.given(&pressed, at);
            }
            energy.store(&mut probe.strain_energy, at);
            hourglass_energy(&p, &s).store(&mut probe.hourglass_energy, at);
            (volume * super::booked(&new, facts.dissipation)).store(&mut probe.dissipated, at);
            (volume * super::booked(&new, facts.creation)).store(&mut probe.created, at);
        }

        // A closure would be a function of its own wherever it is not inlined.
        let mut resultants = stress;
        let mut i = 0;
        while i < 6 {
            resultants[i] = volume * stress[i];
            i += 1;
        }
        if let Some(water) = &given.water {
            let less = water.book(resultants[0] + resultants[1] + resultants[2], &pressed, at);
            resultants[0] = resultants[0] - less;
            resultants[1] = resultants[1] - less;
            resultants[2] = resultants[2] - less;
        }
        modes[0] = geometry.forces::<L, 0>(&resultants, &p, at);
        modes[1] = geometry.forces::<L, 1>(&resultants, &p, at);
        modes[2] = geometry.forces::<L, 2>(&resultants, &p, at);
        store_nodal(&mut modes, &mut nodal, at);
        at += L::WIDTH;
    }
    // SAFETY: passed on to the caller.
    unsafe { scatter_nodal::<L>(out, index, &nodal) };
}

/// ½ Σ p s \[J\].
#[inline(always)]
fn hourglass_energy<L: Lane>(p: &[[L; 4]; 3], s: &[[L; 4]; 3]) -> L {
    let mut twice = L::splat(0.0);
    let mut k = 0;
    while k < 3 {
        let mut alpha = 0;
        while alpha < 4 {
            twice = p[k][alpha].mul_add(s[k][alpha], twice);
            alpha += 1;
        }
        k += 1;
    }
    L::splat(0.5) * twice
}

/// Forces conjugate to the amplitudes that bend the surface across axis `K`: ∂/∂s of ½ E/(1 − ν²) V/3 (tr² − 2(1 − ν) det)
/// with tr and det of the strain in the surface.
#[inline(always)]
fn bend_surface<L: Lane, const K: usize, const B: usize, const C: usize>(
    surface: &[Octet; 4],
    bend: L,
    less: L,
    s: &[[L; 4]; 3],
    p: &mut [[L; 4]; 3],
    at: usize,
) {
    let (aspect, inverse) = (L::load(&surface[0], at), L::load(&surface[1], at));
    let (cosine, stretch) = (L::load(&surface[2], at), L::load(&surface[3], at));
    let (a, b) = (s[B][C], s[C][B]);
    let gamma = aspect.mul_add(s[B][B], inverse * s[C][C]);
    let trace = stretch * cosine.neg_mul_add(gamma, a + b);
    let scale = bend * stretch;
    p[B][C] = scale * less.neg_mul_add(b, trace);
    p[C][B] = scale * less.neg_mul_add(a, trace);
    let shear = scale * (L::splat(0.5) * less).mul_add(gamma, -(cosine * trace));
    p[B][B] = aspect.mul_add(shear, p[B][B]);
    p[C][C] = inverse.mul_add(shear, p[C][C]);
}
