//! The eight-node hexahedron with one assumed-strain field at three quadratures.
//!
//! Belytschko & Bindeman (1993), ASQBI: the mean strain from the mean gradients (Flanagan & Belytschko 1981), and a
//! hourglass strain, linear and bilinear in natural coordinates, that bends without shear and without locking at
//! ν → ½. [`one_point`] integrates the hourglass part in closed form with the law's elastic moduli and evaluates the
//! law once; [`full`] evaluates the law at 2×2×2 points of the same field, [`layered`] at 2×2 points in several layers.
//!
//! **Modal form.** The eight ±1 patterns of the nodes — constant, three linear, four hourglass — turn nodal into
//! modal values by 24 additions a component ([`to_modes`]). With U_m = Σ_I s_mI u_I the mean gradient is
//! g_ij = Σ_m b_mj U_mi over the seven patterns m ≠ constant, and the hourglass amplitudes
//! q_αi = γ_α·u_i = ⅛ (U_αi − Σ_j X_αj g_ij) vanish for every linear field.
//!
//! **Hourglass strain.** Along the natural axes, with half-lengths ℓ_k and unit vectors t_k at the centre,
//! s_kα = t_k·q_α/ℓ_k, and α = 1, 2, 3, 4 for ηζ, ξζ, ξη, ξηζ. Across each natural axis lies a surface that bends as a
//! plate does: the strain along it is linear in that axis, the stress across it vanishes. Each bilinear mode
//! stretches the fibres along one axis in uniaxial stress. With axes x, y, z for t_1, t_2, t_3:
//!
//! | times | strain in the surface | stress |
//! |---|---|---|
//! | ξ | s_y3, s_z2, γ_yz = s_y2 ℓ_y/ℓ_z + s_z3 ℓ_z/ℓ_y | plane, across x |
//! | η | s_z1, s_x3, γ_zx = s_z3 ℓ_z/ℓ_x + s_x1 ℓ_x/ℓ_z | plane, across y |
//! | ζ | s_x2, s_y1, γ_xy = s_x1 ℓ_x/ℓ_y + s_y2 ℓ_y/ℓ_x | plane, across z |
//! | ηζ, ξζ, ξη | s_x4, s_y4, s_z4 | uniaxial, along x, y, z |
//!
//! For a brick these are Belytschko & Bindeman's ASQBI strains. Here the t_k need not be square to each other: they
//! are covariant components, so that a parallelepiped bends exactly as well as a brick ([`Surface`]; the same idea as
//! the stress modes of `pian1984`). Where a plan is no parallelogram the products ηζ, ξζ and ξη do work under a constant moment;
//! points of several count them from the means of ξ, η and ζ, and the closed form of one point leaves that work out. A wedge has a strain of
//! its own (`wedge.rs`). Limits: small displacements; elements that are trapezoids through the thickness bend too stiffly, as they must in
//! an element that passes the patch test (`macneal1987`).

mod bodies;
mod brick;
mod brick_field;
mod elastic;
mod field;
mod frequency;
mod full;
mod geometry;
mod layer;
mod layered;
mod modal;
mod one_point;
mod pores;
mod quadrature;
mod size;
mod unit_strains;
mod wedge;
mod wedge_sides;

pub use bodies::MODAL_MEMORY;
pub use brick::BrickGeometry;
pub use brick_field::{BrickField, bricks_left};
pub use elastic::{ElasticPoints, elastic_stress};
pub use field::FieldShape;
pub use frequency::element_frequencies;
pub use full::{FullGeometry, FullShape, full};
pub use geometry::{BadShape, CORNERS, Hex8, gauss_point, shape_values};
pub use layer::LayeredShape;
pub use layered::{LayeredGeometry, layered, layered_left};
pub use one_point::{OnePointGeometry, OnePointShape, Resistance, one_point};
pub use pores::{HELD, Held, Pores, Undrained};
pub use quadrature::{Layers, MOST_POINTS, Points, Quadrature, Through, turned};

use crate::Material;
use crate::lane::{Lane, Octet, Row};
use crate::material::{Moduli, Point, Sym};

/// Position of corner k in the binary order that the modal form uses (bit 0 is ξ, bit 1 η, bit 2 ζ).
pub const BINARY: [usize; 8] = [0, 1, 3, 2, 4, 5, 7, 6];

/// Modes ξ, η, ζ.
pub const LINEAR: [usize; 3] = [1, 2, 4];

/// Modes ηζ, ξζ, ξη, ξηζ: α = 1, 2, 3, 4 of Belytschko & Bindeman.
pub const HOURGLASS: [usize; 4] = [6, 5, 3, 7];

/// Nodal (binary order) to modal values.
#[inline(always)]
pub fn to_modes<L: Lane>(x: &mut [L; 8]) {
    let mut stride = 1;
    while stride < 8 {
        let mut i = 0;
        while i < 8 {
            if i & stride == 0 {
                let (minus, plus) = (x[i], x[i | stride]);
                x[i] = minus + plus;
                x[i | stride] = plus - minus;
            }
            i += 1;
        }
        stride *= 2;
    }
}

/// The transpose of [`to_modes`]: modal to nodal forces.
#[inline(always)]
pub fn to_nodes<L: Lane>(f: &mut [L; 8]) {
    let mut stride = 1;
    while stride < 8 {
        let mut i = 0;
        while i < 8 {
            if i & stride == 0 {
                let (even, odd) = (f[i], f[i | stride]);
                f[i] = even - odd;
                f[i | stride] = even + odd;
            }
            i += 1;
        }
        stride *= 2;
    }
}

/// Elastic constants of the hourglass part, the same for all elements of a block.
#[derive(Clone, Copy, Debug)]
pub struct Stabilisation {
    /// Shear modulus μ \[Pa\].
    pub mu: f64,
    /// Young's modulus E \[Pa\].
    pub young: f64,
    /// E/(1 − ν²) \[Pa\].
    pub plane_stress: f64,
    /// ν
    pub poisson: f64,
    /// ν/(1 − ν)
    pub poisson_plane: f64,
}

impl Stabilisation {
    pub fn new(moduli: Moduli) -> Self {
        let (young, nu) = (moduli.young(), moduli.poisson());
        Stabilisation {
            mu: moduli.mu,
            young,
            plane_stress: young / (1.0 - nu * nu),
            poisson: nu,
            poisson_plane: nu / (1.0 - nu),
        }
    }

    /// The same with a hourglass strain that keeps the volume, for 2×2×2 points of a material that flows.
    ///
    /// The elastic strain (e, −ne), n = ν/(1 − ν), does second-order work of the sign of (1 − nM)(1 − nK) in plane flow
    /// of a Mohr–Coulomb material, with the slopes M and K of ψ and φ: with little dilation and much friction it is
    /// negative, and the element wrinkles. With n = 1 it is positive for every 0 ≤ ψ ≤ φ. The price is bending: 0.76 of
    /// the deflection of a thin elastic cantilever (ν = 0.3).
    pub fn flowing(moduli: Moduli) -> Self {
        Stabilisation { poisson: 0.5, poisson_plane: 1.0, ..Self::new(moduli) }
    }
}

/// The surface spanned by two natural axes b and c, across the third.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    /// ℓ_b/ℓ_c
    pub aspect: f64,
    /// t_b·t_c
    pub cosine: f64,
    /// 1/(1 − cosine²)
    pub stretch: f64,
}

impl Surface {
    /// The surface across natural axis `k`, b and c being the axes that follow it in turn.
    pub fn across(hex: &Hex8, k: usize) -> Self {
        let (b, c) = ((k + 1) % 3, (k + 2) % 3);
        let cosine: f64 = (0..3).map(|i| hex.directions[b][i] * hex.directions[c][i]).sum();
        Surface {
            aspect: hex.half_lengths[b] / hex.half_lengths[c],
            cosine,
            stretch: 1.0 / (1.0 - cosine * cosine),
        }
    }
}

/// What a probing pass brings home beside forces, per octet of elements.
#[derive(Clone, Copy)]
pub struct Probe {
    /// Stress \[Pa\] of each point in global axes: `[point][component]`; only point 0 with one-point quadrature.
    pub stress: [[Octet; 6]; MOST_POINTS],
    /// Recoverable energy \[J\] of the mean part, Σ w ½ σ:ε.
    pub strain_energy: Octet,
    /// Energy \[J\] of the hourglass stabilisation; zero for full quadrature, where it is strain energy.
    pub hourglass_energy: Octet,
    /// Energy \[J\] that the law has booked as dissipated so far, and as created.
    pub dissipated: Octet,
    pub created: Octet,
    /// Energy \[J\] that damping over a band has taken so far.
    pub of_band: Octet,
    /// Whether this pass is to bring it: an instance that can probe serves passes that do not as well.
    pub wanted: bool,
}

impl Probe {
    pub const ZERO: Probe = Probe {
        stress: [[Octet::ZERO; 6]; MOST_POINTS],
        strain_energy: Octet::ZERO,
        hourglass_energy: Octet::ZERO,
        dissipated: Octet::ZERO,
        created: Octet::ZERO,
        of_band: Octet::ZERO,
        wanted: true,
    };
}

/// Octets a point of what damage has left of stresses that go by the rate: V ([`Material::integrity`]), the share against
/// hourglass modes of elements of one point, and one for whoever uses them.
pub const LEFT: usize = 8;

/// Modal displacements of the lanes `at ..` of an octet: `[component][mode]`.
///
/// # Safety
/// All indices must be below `rows.len()`.
#[inline(always)]
unsafe fn gather_modes<L: Lane>(rows: &[Row], index: &[[u16; 8]; 8], at: usize) -> [[L; 8]; 3] {
    let zero = L::splat(0.0);
    let mut modes = [[zero; 8]; 3];
    let mut corner = 0;
    while corner < 8 {
        // SAFETY: passed on to the caller.
        let [x, y, z] = unsafe { L::gather(rows, &index[corner], at) };
        modes[0][BINARY[corner]] = x;
        modes[1][BINARY[corner]] = y;
        modes[2][BINARY[corner]] = z;
        corner += 1;
    }
    to_modes(&mut modes[0]);
    to_modes(&mut modes[1]);
    to_modes(&mut modes[2]);
    modes
}

/// Modal forces to nodal ones, kept until all lanes of the octet are there.
#[inline(always)]
fn store_nodal<L: Lane>(modes: &mut [[L; 8]; 3], nodal: &mut [[Octet; 3]; 8], at: usize) {
    store_component(&mut modes[0], nodal, 0, at);
    store_component(&mut modes[1], nodal, 1, at);
    store_component(&mut modes[2], nodal, 2, at);
}

#[inline(always)]
fn store_component<L: Lane>(modes: &mut [L; 8], nodal: &mut [[Octet; 3]; 8], i: usize, at: usize) {
    to_nodes(modes);
    let mut corner = 0;
    while corner < 8 {
        modes[BINARY[corner]].store(&mut nodal[corner][i], at);
        corner += 1;
    }
}

/// Adds the nodal forces of an octet to the rows, corner by corner and lane by lane.
///
/// # Safety
/// All indices must be below `out.len()`.
#[inline(always)]
unsafe fn scatter_nodal<L: Lane>(out: &mut [Row], index: &[[u16; 8]; 8], nodal: &[[Octet; 3]; 8]) {
    let mut corner = 0;
    while corner < 8 {
        // SAFETY: passed on to the caller.
        unsafe { L::scatter_add(out, &index[corner], &nodal[corner]) };
        corner += 1;
    }
}

/// Share of the bodies of a band that the state has left.
#[inline(always)]
fn unbroken<L: Lane, M: Material>(material: &M, history: &M::History<L>) -> L {
    if material.facts().damages { material.unbroken(history) } else { L::splat(1.0) }
}

/// The law's answer; what is left of stresses that go by the rate is put into `left`, if there is room for it.
#[inline(always)]
fn answer<L: Lane, M: Material>(
    material: &M,
    point: &Point<L>,
    strain: Sym<L>,
    old: M::History<L>,
    left: &mut [Octet],
    at: usize,
) -> (Sym<L>, M::History<L>) {
    if !material.facts().damages {
        return material.update(point, strain, old);
    }
    let (stress, new, integrity) = material.update_left(point, strain, old);
    if !left.is_empty() {
        keep_left(&integrity, left, at);
        material.hourglass_share(&new).store(&mut left[6], at);
    }
    (stress, new)
}

/// Puts V of a point into its room.
#[inline(always)]
fn keep_left<L: Lane>(integrity: &Sym<L>, left: &mut [Octet], at: usize) {
    let mut c = 0;
    while c < 6 {
        integrity[c].store(&mut left[c], at);
        c += 1;
    }
}

/// A column of the history that may not be.
#[inline(always)]
fn booked<L: Lane>(history: &impl AsRef<[L]>, column: Option<usize>) -> L {
    match column {
        Some(k) => history.as_ref()[k],
        None => L::splat(0.0),
    }
}

/// What elements have beside their geometry; empty where they have nothing of the kind. Tensors are six octets an octet of elements.
#[derive(Clone, Copy, Default)]
pub struct Given<'a> {
    /// Strain that they begin with.
    pub strain: &'a [Octet],
    /// The size tensor that the law is to see in place of their own.
    pub size: &'a [Octet],
    /// Increments of the nodes' displacements over the step \[m\], in the order of their rows: where damage grows, damping over a band
    /// books by them. Empty: they did not move.
    pub moved: &'a [Row],
    /// Water that cannot leave their pores.
    pub water: Option<Undrained<'a>>,
}

impl<'a> Given<'a> {
    /// Nothing.
    pub const NONE: Given<'static> = Given { strain: &[], size: &[], moved: &[], water: None };

    /// What the octet `i` of elements has.
    pub fn of(&self, i: usize) -> Given<'a> {
        let own = |all: &'a [Octet]| all.get(6 * i..6 * (i + 1)).unwrap_or(&[]);
        let water = self.water.map(|water| water.of(i));
        Given { strain: own(self.strain), size: own(self.size), moved: self.moved, water }
    }
}

/// The size tensor that a law sees: the given one, or that of the geometry.
#[inline(always)]
fn seen_size<L: Lane>(
    given: &Given,
    gradient: &[[Octet; 7]; 3],
    hourglass: &[[Octet; 3]; 4],
    at: usize,
) -> Sym<L> {
    if given.size.len() < 6 {
        return size::size_tensor(gradient, hourglass, at);
    }
    load_tensor(given.size, at)
}

/// A symmetric tensor from its octets.
#[inline(always)]
fn load_tensor<L: Lane>(octets: &[Octet], at: usize) -> Sym<L> {
    [
        L::load(&octets[0], at),
        L::load(&octets[1], at),
        L::load(&octets[2], at),
        L::load(&octets[3], at),
        L::load(&octets[4], at),
        L::load(&octets[5], at),
    ]
}

/// Adds the strain that elements begin with, if they do.
#[inline(always)]
fn add_initial<L: Lane>(strain: &mut Sym<L>, initial: &[Octet], at: usize) {
    if initial.len() < 6 {
        return;
    }
    let mut c = 0;
    while c < 6 {
        strain[c] = strain[c] + L::load(&initial[c], at);
        c += 1;
    }
}

/// Sum of two stresses.
#[inline(always)]
fn plus<L: Lane>(a: Sym<L>, b: Sym<L>) -> Sym<L> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3], a[4] + b[4], a[5] + b[5]]
}

/// The dilatation that elements begin with.
#[inline(always)]
fn dilatation<L: Lane>(initial: &[Octet], at: usize) -> L {
    if initial.len() < 6 {
        return L::splat(0.0);
    }
    L::load(&initial[0], at) + L::load(&initial[1], at) + L::load(&initial[2], at)
}

/// Adds to the normal strains, by their coefficients, what water does to the grains.
#[inline(always)]
fn widen<L: Lane>(e: &mut [[L; 8]; 6], pressed: &pores::Pressed<L>) {
    let mut c = 0;
    while c < 3 {
        e[c][0] = e[c][0] + pressed.strain;
        c += 1;
    }
}
