//! The seam for material laws.

use crate::lane::{Lane, Octet};
use crate::parameter::{BadParameter, Column, Derived, LawInfo, Parameter, Role, Values, position};

/// A symmetric tensor: xx, yy, zz, xy, yz, zx. Strains carry engineering shear.
pub type Sym<L> = [L; 6];

/// What a law may know of its point besides strain and history.
#[derive(Clone, Copy)]
pub struct Point<L> {
    /// Time step \[s\]; 0 while time stands still (stages).
    pub dt: L,
    /// Whether memory that changes slowly is brought on in this step ([`Material::slow_steps`]), and the time \[s\] since it last
    /// was, this step included.
    pub brings: bool,
    pub since: L,
    /// Whether somebody looks at this instant: columns that nothing but results reads ([`Role::CrackWidth`])
    /// are found then alone, and keep what they were in other steps.
    pub looked_at: bool,
    /// Size tensor of the element \[m²\], G = ½ Σ (x − x̄)⊗(x − x̄) over its corners, in the axes of the strain
    /// (xx, yy, zz, xy, yz, zx): √(p·G·p) is its extent along p, for a brick the edge along an edge. Element kernels
    /// fill it where [`Facts::needs_size`] says so; else it is zero.
    pub size: Sym<L>,
    /// Mean displacement gradient H of the element since it was placed, ∂u_i/∂x_j as `[i][j]`, in the axes of the strain. Filled as
    /// the size is; zero on a path without an element.
    pub gradient: [[L; 3]; 3],
}

impl<L: Lane> Point<L> {
    /// A point at a time step \[s\], of an element without a size, at which all memory is brought on and somebody looks.
    #[inline(always)]
    pub fn new(dt: L) -> Self {
        let zero = L::splat(0.0);
        Point { dt, brings: true, since: dt, looked_at: true, size: [zero; 6], gradient: [[zero; 3]; 3] }
    }

    /// The same instant for lanes.
    #[inline(always)]
    pub fn splat(point: &Point<f64>) -> Self {
        let Point { brings, looked_at, .. } = *point;
        Point { brings, looked_at, since: L::splat(point.since), ..Point::new(L::splat(point.dt)) }
    }

    /// The element's extent \[m\] along a unit vector p, √(p·G·p).
    #[inline(always)]
    pub fn extent(&self, p: &[L; 3]) -> L {
        let [xx, yy, zz, xy, yz, zx] = self.size;
        let x = zx.mul_add(p[2], xy.mul_add(p[1], xx * p[0]));
        let y = yz.mul_add(p[2], yy.mul_add(p[1], xy * p[0]));
        let z = zz.mul_add(p[2], yz.mul_add(p[1], zx * p[0]));
        z.mul_add(p[2], y.mul_add(p[1], x * p[0])).larger(L::splat(0.0)).sqrt()
    }

    /// The element's extent \[m\] along the direction in which its displacement varies, √(tr(H·G·Hᵀ)/tr(H·Hᵀ)).
    ///
    /// A band with the unit normal n has H = s⊗n, whatever the direction s in which its sides move: the extent is then √(n·G·n). The
    /// strain alone does not tell n from the direction of the slip. √(tr G/3) where nothing has moved.
    #[inline(always)]
    pub fn extent_across_band(&self) -> L {
        let [xx, yy, zz, xy, yz, zx] = self.size;
        let zero = L::splat(0.0);
        let (mut product, mut square) = (zero, zero);
        let mut i = 0;
        while i < 3 {
            let h = &self.gradient[i];
            let x = zx.mul_add(h[2], xy.mul_add(h[1], xx * h[0]));
            let y = yz.mul_add(h[2], yy.mul_add(h[1], xy * h[0]));
            let z = zz.mul_add(h[2], yz.mul_add(h[1], zx * h[0]));
            product = z.mul_add(h[2], y.mul_add(h[1], x.mul_add(h[0], product)));
            square = h[2].mul_add(h[2], h[1].mul_add(h[1], h[0].mul_add(h[0], square)));
            i += 1;
        }
        let moved = zero.less(square);
        let mean = (xx + yy + zz) * L::splat(1.0 / 3.0);
        let along = product / L::select(moved, square, L::splat(1.0));
        L::select(moved, along, mean).larger(zero).sqrt()
    }
}

/// Elastic constants that bound a law from above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moduli {
    /// Lamé's first parameter λ \[Pa\].
    pub lambda: f64,
    /// Shear modulus μ \[Pa\].
    pub mu: f64,
}

impl Moduli {
    /// From Young's modulus \[Pa\] and Poisson's ratio.
    pub fn from_young_poisson(young: f64, poisson: f64) -> Self {
        Moduli {
            lambda: young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson)),
            mu: young / (2.0 * (1.0 + poisson)),
        }
    }

    /// Both moduli times a factor: Poisson's ratio stays.
    pub fn scaled(&self, factor: f64) -> Self {
        Moduli { lambda: factor * self.lambda, mu: factor * self.mu }
    }

    /// C:e \[Pa\] of isotropic elasticity.
    #[inline(always)]
    pub fn stress<L: Lane>(&self, e: &Sym<L>) -> Sym<L> {
        let (mu, mu2) = (L::splat(self.mu), L::splat(2.0 * self.mu));
        let pressure = L::splat(self.lambda) * (e[0] + e[1] + e[2]);
        [
            mu2.mul_add(e[0], pressure),
            mu2.mul_add(e[1], pressure),
            mu2.mul_add(e[2], pressure),
            mu * e[3],
            mu * e[4],
            mu * e[5],
        ]
    }

    /// ½e:C:e \[J/m³\].
    #[inline(always)]
    pub fn energy<L: Lane>(&self, e: &Sym<L>) -> L {
        L::splat(0.5) * self.product(e, e)
    }

    /// a:C:b \[J/m³\].
    #[inline(always)]
    pub fn product<L: Lane>(&self, a: &Sym<L>, b: &Sym<L>) -> L {
        let traces = (a[0] + a[1] + a[2]) * (b[0] + b[1] + b[2]);
        let normal = a[2].mul_add(b[2], a[1].mul_add(b[1], a[0] * b[0]));
        let shear = a[5].mul_add(b[5], a[4].mul_add(b[4], a[3] * b[3]));
        let deviator = L::splat(0.5).mul_add(shear, normal);
        L::splat(2.0 * self.mu).mul_add(deviator, L::splat(self.lambda) * traces)
    }

    /// V·(C:(V·e·V))·V \[Pa\]: what a state with the integrity V ([`Material::integrity`]) carries of an elastic stress.
    /// Its product with e is never negative, so that damping takes energy whatever V is.
    #[inline(always)]
    pub fn stress_left<L: Lane>(&self, e: &Sym<L>, integrity: &Sym<L>) -> Sym<L> {
        let (half, two) = (L::splat(0.5), L::splat(2.0));
        let tensor = [e[0], e[1], e[2], half * e[3], half * e[4], half * e[5]];
        let v = congruence(integrity, &tensor);
        congruence(integrity, &self.stress(&[v[0], v[1], v[2], two * v[3], two * v[4], two * v[5]]))
    }

    /// The strain \[1\] that a stress \[Pa\] belongs to, with engineering shear.
    pub fn strain(&self, s: &[f64; 6]) -> [f64; 6] {
        let (young, poisson) = (self.young(), self.poisson());
        let trace = s[0] + s[1] + s[2];
        let normal = |k: usize| ((1.0 + poisson) * s[k] - poisson * trace) / young;
        [normal(0), normal(1), normal(2), s[3] / self.mu, s[4] / self.mu, s[5] / self.mu]
    }

    /// Young's modulus \[Pa\].
    pub fn young(&self) -> f64 {
        self.mu * (3.0 * self.lambda + 2.0 * self.mu) / (self.lambda + self.mu)
    }

    /// Poisson's ratio.
    pub fn poisson(&self) -> f64 {
        self.lambda / (2.0 * (self.lambda + self.mu))
    }

    /// Speeds of P and S waves \[m/s\] at density ρ \[kg/m³\].
    pub fn wave_speeds(&self, density: f64) -> (f64, f64) {
        (((self.lambda + 2.0 * self.mu) / density).sqrt(), (self.mu / density).sqrt())
    }
}

/// V·S·V of symmetric tensors.
#[inline(always)]
fn congruence<L: Lane>(v: &Sym<L>, s: &Sym<L>) -> Sym<L> {
    const AT: [[usize; 3]; 3] = [[0, 3, 5], [3, 1, 4], [5, 4, 2]];
    let zero = L::splat(0.0);
    let mut half = [[zero; 3]; 3];
    let mut i = 0;
    while i < 3 {
        let mut j = 0;
        while j < 3 {
            let mut k = 0;
            while k < 3 {
                half[i][j] = s[AT[i][k]].mul_add(v[AT[k][j]], half[i][j]);
                k += 1;
            }
            j += 1;
        }
        i += 1;
    }
    let mut whole = [zero; 6];
    let mut i = 0;
    while i < 3 {
        let mut j = i;
        while j < 3 {
            let mut k = 0;
            while k < 3 {
                whole[AT[i][j]] = v[AT[i][k]].mul_add(half[k][j], whole[AT[i][j]]);
                k += 1;
            }
            j += 1;
        }
        i += 1;
    }
    whole
}

/// History of one point of a law, a fixed number of lanes.
pub trait History<L: Lane>: Copy + AsRef<[L]> + AsMut<[L]> {
    /// All zero, the state of virgin material.
    fn zero() -> Self;
}

impl<L: Lane, const N: usize> History<L> for [L; N] {
    #[inline(always)]
    fn zero() -> Self {
        [L::splat(0.0); N]
    }
}

/// The history of a virgin point of law `M`.
pub fn virgin<M: Material>() -> M::History<f64> {
    History::zero()
}

/// Share of the elastic hourglass stiffness that is left at the least, so that the zero-energy modes of broken elements
/// stay bounded: an assumption. A twentieth held a footing up beyond its limit load (verification problem `strip_footing`).
pub(crate) const LEAST_HOURGLASS_SHARE: f64 = 0.001;

/// A material law: stress from the strain since the material was placed, and from history.
///
/// Laws are written in [`Lane`] operations alone, so that one source serves the scalar reference and every register width
/// with the same bits. Data are selected, never branched on, but for [`Lane::any`], which may pass over work that no lane
/// needs. Every law is in total form: what it must remember (plastic strain, damage, the last strain) is in its history, so
/// nothing drifts and a checkpoint holds all of it. Laws are isotropic; tensors in a history live in the axes that the
/// caller passes strains in.
pub trait Material: Send + Sync + Sized {
    /// The word after `law =` in a case.
    const NAME: &'static str;
    /// One line for `tremolite list materials`.
    const SUMMARY: &'static str;
    /// Key of references.bib and equations.
    const SOURCE: &'static str;
    const PARAMETERS: &'static [Parameter];
    const HISTORY: &'static [Column];
    /// Whether the law looks at [`Point::size`] or [`Point::gradient`]; an instance may do without ([`Material::facts`]).
    const NEEDS_SIZE: bool = false;
    /// Whether the material flows plastically: 2×2×2 points then take a hourglass strain that keeps the volume.
    const FLOWS: bool = false;
    /// Whether states can lose stiffness, so that [`Material::integrity`] is to be asked for.
    const DAMAGES: bool = false;
    /// Whether strength grows with pressure: such a law says little without the pressure that is there before.
    const PRESSURE_DEPENDENT: bool = false;
    /// Column in which the law books what it has dissipated \[J/m³\] ([`Role::Dissipated`]). One-point elements add what
    /// their hourglass energy loses by [`Material::hourglass_share`]. A law with history that keeps no such book leaves
    /// the balance without a check.
    const DISSIPATION: Option<usize> = position(Self::HISTORY, Role::Dissipated);
    /// Column in which a law without a potential books what it has given out beyond what it took \[J/m³\]
    /// ([`Role::Created`]).
    const CREATION: Option<usize> = position(Self::HISTORY, Role::Created);
    /// One lane per entry of `HISTORY`.
    type History<L: Lane>: History<L>;

    /// What kernels go by. A law answers with its constants; one that stands for any law ([`Material::History`] as long as the
    /// longest) with those of the law that it stands for.
    #[inline(always)]
    fn facts(&self) -> Facts {
        Facts {
            columns: self.columns().len(),
            needs_size: Self::NEEDS_SIZE,
            damages: Self::DAMAGES,
            dissipation: Self::DISSIPATION,
            creation: Self::CREATION,
        }
    }

    /// The columns that an instance keeps: the first ones of [`Material::HISTORY`], all but for those at its end that its parameters
    /// leave unused.
    #[inline(always)]
    fn columns(&self) -> &'static [Column] {
        Self::HISTORY
    }

    /// A checked instance.
    ///
    /// # Errors
    /// Every value the law refuses.
    fn new(values: &Values) -> Result<Self, Vec<BadParameter>>;

    /// The stiffest elastic moduli the law can show: time step, stabilisation, damping and boundaries go by them.
    fn moduli(&self) -> Moduli;

    /// The same material with its elastic moduli times a factor, its strengths as they are: damping over a band gives
    /// the law what Maxwell bodies leave of the moduli.
    fn scaled(&self, factor: f64) -> Self;

    /// Steps of `dt` \[s\] after which memory that changes slowly is brought on, at once for all of them; a power of two.
    fn slow_steps(&self, _dt: f64) -> u64 {
        1
    }

    /// The extent \[m\] that an element must stay below: a larger one stores more energy than a crack or a band of shear across it
    /// dissipates as it softens. Infinite for a law that does not go by the element's size.
    fn size_limit(&self) -> f64 {
        f64::INFINITY
    }

    /// Whether a path of strains without an element must say the element's extent.
    fn asks_size(&self) -> bool {
        self.size_limit().is_finite()
    }

    /// How strength falls with plastic flow.
    fn softens(&self) -> Softens {
        Softens::Never
    }

    /// Energy per area \[N/m\] that a crack dissipates across an element of this extent \[m\] at static rates; none
    /// for a law without cracks.
    fn crack_energy(&self, _extent: f64) -> Option<f64> {
        None
    }

    /// Share of its strength that a body of elements of this extent \[m\] across the crack keeps where stress concentrates, at
    /// most 1; none for a law without cracks, and for one whose strength there does not go by the elements.
    fn corner_strength(&self, _extent: f64) -> Option<f64> {
        None
    }

    /// Uniaxial compressive strength \[Pa\] at static rates, of a law that has one.
    fn compressive_strength(&self) -> Option<f64> {
        None
    }

    /// How much of its tensile strength an undamaged material uses at a stress \[Pa\], 1 where damage begins, at the rate of the
    /// point beside it that has another stress and this history; none for a law that does not crack.
    fn tension_use(
        &self,
        _stress: &Sym<f64>,
        _beside: &Sym<f64>,
        _history: &Self::History<f64>,
    ) -> Option<f64> {
        None
    }

    /// Whether at a stress \[Pa\] surely no more than `share` of the tensile strength is used ([`Material::tension_use`]), at whatever rate:
    /// a quick test, which may say no where that is so.
    fn uses_at_most(&self, _stress: &Sym<f64>, _share: f64) -> bool {
        false
    }

    /// The constants that the law works with beside its parameters, for people to check; `extents` \[m\] are the
    /// shortest and the longest of the elements.
    fn derived(&self, _extents: [f64; 2]) -> Vec<Derived> {
        Vec::new()
    }

    /// What is unusual about the parameters though the law accepts them, a sentence each.
    fn warnings(&self) -> Vec<String> {
        Vec::new()
    }

    /// V = Σ (1 − D_i)^¼ p_i⊗p_i with the damage D_i along the principal directions p_i that this history has left: a
    /// cracked point must not go on carrying damping stresses ([`Moduli::stress_left`]; along p_i they are 1 − D_i times as
    /// large). For stresses that go by the rate alone; what remembers goes by [`Material::unbroken`]. Asked for only with
    /// [`Material::DAMAGES`].
    #[inline(always)]
    fn integrity<L: Lane>(&self, _strain: &Sym<L>, _history: &Self::History<L>) -> Sym<L> {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        [one, one, one, zero, zero, zero]
    }

    /// Share of the stress of Maxwell bodies ([`crate::band`]) that this history has left: from 1 downwards, never growing
    /// along a path, whatever closes again.
    #[inline(always)]
    fn unbroken<L: Lane>(&self, _history: &Self::History<L>) -> L {
        L::splat(1.0)
    }

    /// Share of the elastic stiffness against hourglass modes that one-point elements keep in this state: above 0, at
    /// most 1, and never growing along a path, so that what it takes away is dissipated. With elastic stiffness a
    /// yielding or cracked element would go on bending elastically.
    #[inline(always)]
    fn hourglass_share<L: Lane>(&self, _history: &Self::History<L>) -> L {
        L::splat(1.0)
    }

    /// Energy \[J/m³\] that a point would give back were it unloaded: ½σ:ε for elastic and for damaged material. Laws
    /// with plastic strain give the elastic part alone, [`complementary_energy`]. The balance calls all else dissipated.
    #[inline(always)]
    fn stored_energy<L: Lane>(&self, strain: &Sym<L>, stress: &Sym<L>, _history: &Self::History<L>) -> L {
        let mut twice = L::splat(0.0);
        let mut i = 0;
        while i < 6 {
            twice = stress[i].mul_add(strain[i], twice);
            i += 1;
        }
        L::splat(0.5) * twice
    }

    /// Stress \[Pa\] and new history for a strain.
    fn update<L: Lane>(
        &self,
        point: &Point<L>,
        strain: Sym<L>,
        history: Self::History<L>,
    ) -> (Sym<L>, Self::History<L>);

    /// The same and V ([`Material::integrity`]) of the new history. A law that damages and has the principal directions at
    /// hand saves their second decomposition here.
    #[inline(always)]
    fn update_left<L: Lane>(
        &self,
        point: &Point<L>,
        strain: Sym<L>,
        history: Self::History<L>,
    ) -> (Sym<L>, Self::History<L>, Sym<L>) {
        let (stress, new) = self.update(point, strain, history);
        let left = self.integrity(&strain, &new);
        (stress, new, left)
    }

    /// The same of a point whose history lies in octets, one a column, and is brought on where it lies. A law that leaves most
    /// columns as they are in most steps does not touch them here: each is a line of the cache.
    #[inline(always)]
    fn update_in_place<L: Lane>(
        &self,
        point: &Point<L>,
        strain: Sym<L>,
        history: &mut [Octet],
        at: usize,
    ) -> InPlace<L> {
        let old: Self::History<L> = load(history, at);
        if !Self::DAMAGES {
            let (stress, new) = self.update(point, strain, old);
            store(&new, history, at);
            let (zero, one) = (L::splat(0.0), L::splat(1.0));
            return InPlace { stress, left: [one, one, one, zero, zero, zero], before: one, now: one };
        }
        let (stress, new, left) = self.update_left(point, strain, old);
        store(&new, history, at);
        InPlace { stress, left, before: self.unbroken(&old), now: self.unbroken(&new) }
    }
}

/// How strength falls with plastic flow, by what gives a band its width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Softens {
    Never,
    /// Over plastic strain: a band is one element wide and dissipates by its volume.
    OverStrain,
    /// Over displacement: a band is one element wide and dissipates by its area.
    OverDisplacement,
    /// Over plastic strain with a relaxation time: a disturbance grows e-fold in this time \[s\] and spreads at V_s meanwhile.
    Relaxing(f64),
}

/// What kernels go by of a law, by its constants of the same names.
#[derive(Clone, Copy, Debug)]
pub struct Facts {
    /// Entries of [`Material::columns`].
    pub columns: usize,
    pub needs_size: bool,
    pub damages: bool,
    pub dissipation: Option<usize>,
    pub creation: Option<usize>,
}

/// Answer of [`Material::update_in_place`].
pub struct InPlace<L> {
    /// \[Pa\]
    pub stress: Sym<L>,
    /// V ([`Material::integrity`]) of the new history.
    pub left: Sym<L>,
    /// [`Material::unbroken`] of the old history and of the new one.
    pub before: L,
    pub now: L,
}

/// History of one point from its octets, one a column; lanes beyond them stay zero.
///
/// The number of lanes is known to the compiler, that of the octets need not be: so counted, the loop is unrolled.
#[inline(always)]
pub(crate) fn load<L: Lane, H: History<L>>(octets: &[Octet], at: usize) -> H {
    let mut history = H::zero();
    let lanes = history.as_mut();
    let mut i = 0;
    while i < lanes.len() {
        if i < octets.len() {
            lanes[i] = L::load(&octets[i], at);
        }
        i += 1;
    }
    history
}

/// The inverse of [`load`].
#[inline(always)]
pub(crate) fn store<L: Lane, H: History<L>>(history: &H, octets: &mut [Octet], at: usize) {
    let lanes = history.as_ref();
    let mut i = 0;
    while i < lanes.len() {
        if i < octets.len() {
            lanes[i].store(&mut octets[i], at);
        }
        i += 1;
    }
}

/// ½σ:C⁻¹:σ \[J/m³\] of isotropic elasticity.
#[inline(always)]
pub fn complementary_energy<L: Lane>(moduli: Moduli, s: &Sym<L>) -> L {
    let (young, nu) = (moduli.young(), L::splat(moduli.poisson()));
    let normal = s[2].mul_add(s[2], s[1].mul_add(s[1], s[0] * s[0]));
    let across = s[2].mul_add(s[0], s[1].mul_add(s[2], s[0] * s[1]));
    let shear = s[5].mul_add(s[5], s[4].mul_add(s[4], s[3] * s[3]));
    let stretched = L::splat(0.5 / young) * (nu * L::splat(-2.0)).mul_add(across, normal);
    L::splat(0.5 / moduli.mu).mul_add(shear, stretched)
}

impl LawInfo {
    /// The description of law `M`.
    pub const fn of<M: Material>() -> Self {
        LawInfo {
            name: M::NAME,
            summary: M::SUMMARY,
            source: M::SOURCE,
            parameters: M::PARAMETERS,
            history: M::HISTORY,
            pressure_dependent: M::PRESSURE_DEPENDENT,
            damages: M::DAMAGES,
            check: |values| M::new(values).map(|_| ()),
            chosen: |values, _| values.clone(),
        }
    }
}
