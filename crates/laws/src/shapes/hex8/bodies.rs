//! Damping over a band in an element of many points: the Maxwell bodies by the coefficients of its strain.
//!
//! The bodies of [`crate::band`] are linear in the strain, and the strain of all points has seven coefficients a component. So
//! their stretches have as many, which obey the same equation, and a point's are read off as its strain is; what damage has left
//! of the bodies' stress, and what they dissipate, goes by the point. The memory is that of seven points, however many there are.

use super::layer::{at_point, in_layer};
use crate::band::{BODIES, BandStep};
use crate::lane::{Lane, Octet};
use crate::material::Sym;

/// Coefficients of the strain by component.
const MODES: usize = 7;
/// Octets of a field by its coefficients.
const FIELD: usize = 6 * MODES;

/// Octets that an element's bodies keep: the coefficients of the last strain and of the stretches, and what was dissipated \[J\].
pub const MODAL_MEMORY: usize = FIELD * (1 + BODIES) + 1;

const DISSIPATED: usize = MODAL_MEMORY - 1;

/// A step of an element's bodies.
pub(super) struct Bodies<L> {
    /// Σ a_j q_j after the step.
    sum: [[L; 8]; 6],
    /// The sum of each stretch before and after.
    means: [[[L; 8]; 6]; BODIES],
    moved: [[L; 8]; 6],
}

/// The same in a layer, at its four points.
pub(super) struct InLayer<L> {
    sum: [[L; 4]; 6],
    means: [[[L; 4]; 6]; BODIES],
}

/// A field that the memory keeps.
#[inline(always)]
fn kept<L: Lane>(memory: &[Octet], field: usize, at: usize) -> [[L; 8]; 6] {
    let mut e = [[L::splat(0.0); 8]; 6];
    let mut c = 0;
    while c < 6 {
        let mut m = 0;
        while m < MODES {
            e[c][m] = L::load(&memory[FIELD * field + MODES * c + m], at);
            m += 1;
        }
        c += 1;
    }
    e
}

impl<L: Lane> Bodies<L> {
    /// Brings the memory on by one step, to a strain. While time stands still the bodies are relaxed.
    #[inline(always)]
    pub fn advance(step: &BandStep, strain: &[[L; 8]; 6], memory: &mut [Octet], at: usize) -> Self {
        let zero = L::splat(0.0);
        let mut moved = [[zero; 8]; 6];
        let mut sum = [[zero; 8]; 6];
        let mut means = [[[zero; 8]; 6]; BODIES];
        let mut c = 0;
        while c < 6 {
            let mut m = 0;
            while m < MODES {
                let last = &mut memory[MODES * c + m];
                moved[c][m] = strain[c][m] - L::load(last, at);
                strain[c][m].store(last, at);
                let mut j = 0;
                while j < BODIES {
                    let q = &mut memory[FIELD * (1 + j) + MODES * c + m];
                    let old = L::load(q, at);
                    let inverse = L::splat(1.0 / (1.0 + step.halves[j]));
                    let mut new = L::splat(1.0 - step.halves[j]).mul_add(old, moved[c][m]) * inverse;
                    if step.relaxed {
                        new = zero;
                    }
                    new.store(q, at);
                    means[j][c][m] = old + new;
                    sum[c][m] = L::splat(step.weights[j]).mul_add(new, sum[c][m]);
                    j += 1;
                }
                m += 1;
            }
            c += 1;
        }
        Bodies { sum, means, moved }
    }

    #[inline(always)]
    pub fn in_layer(&self, zeta: f64) -> InLayer<L> {
        InLayer {
            sum: in_layer(&self.sum, zeta),
            means: [
                in_layer(&self.means[0], zeta),
                in_layer(&self.means[1], zeta),
                in_layer(&self.means[2], zeta),
            ],
        }
    }

    /// What a point took in the step \[J/m³\], of whose bodies the share `now` is left after `before`; as
    /// [`BandStep::stress`] books it.
    #[inline(always)]
    pub fn taken(
        &self,
        step: &BandStep,
        seen: &InLayer<L>,
        memory: &[Octet],
        (zeta, q): (f64, usize),
        before: L,
        now: L,
        at: usize,
    ) -> L {
        let zero = L::splat(0.0);
        let mut flown = zero;
        let mut j = 0;
        while j < BODIES {
            let mean = of_point(&seen.means[j], q);
            flown = L::splat(step.halves[j] * step.weights[j]).mul_add(step.moduli.energy(&mean), flown);
            j += 1;
        }
        let mut held = zero;
        if L::any(now.less(before)) {
            let moved = at_point(&self.moved, zeta, q);
            let mut j = 0;
            while j < BODIES {
                let (mean, new) =
                    (of_point(&seen.means[j], q), at_point(&kept::<L>(memory, 1 + j, at), zeta, q));
                let (mut old, mut turned) = ([zero; 6], [zero; 6]);
                let mut c = 0;
                while c < 6 {
                    old[c] = mean[c] - new[c];
                    turned[c] = new[c] - old[c];
                    c += 1;
                }
                let weight = step.weights[j];
                let both = step.moduli.energy(&old) + step.moduli.energy(&new);
                held = L::splat(0.5 * weight).mul_add(both, held);
                held = L::splat(-0.25 * weight).mul_add(step.moduli.product(&turned, &moved), held);
                j += 1;
            }
        }
        let lost = (before - now) * held.larger(zero);
        (L::splat(0.5) * (before + now)).mul_add(flown, lost)
    }
}

impl<L: Lane> InLayer<L> {
    /// Stress \[Pa\] of the bodies at a point, of which the share `now` is left.
    #[inline(always)]
    pub fn stress(&self, step: &BandStep, q: usize, now: L) -> Sym<L> {
        let mut stress = step.moduli.stress(&of_point(&self.sum, q));
        let mut c = 0;
        while c < 6 {
            stress[c] = now * stress[c];
            c += 1;
        }
        stress
    }
}

#[inline(always)]
fn of_point<L: Lane>(v: &[[L; 4]; 6], q: usize) -> Sym<L> {
    [v[0][q], v[1][q], v[2][q], v[3][q], v[4][q], v[5][q]]
}

/// What the bodies of a point hold \[J/m³\] after a step.
#[inline(always)]
pub(super) fn held<L: Lane>(step: &BandStep, memory: &[Octet], zeta: f64, q: usize, now: L, at: usize) -> L {
    let mut sum = L::splat(0.0);
    let mut j = 0;
    while j < BODIES {
        let stretch = at_point(&kept::<L>(memory, 1 + j, at), zeta, q);
        sum = L::splat(step.weights[j]).mul_add(step.moduli.energy(&stretch), sum);
        j += 1;
    }
    now * sum
}

/// Adds to the book what all points took in a step \[J\].
#[inline(always)]
pub(super) fn book<L: Lane>(step: &BandStep, taken: L, memory: &mut [Octet], at: usize) {
    let book = &mut memory[DISSIPATED];
    // A strain that is no number must not enter the book.
    let known = L::splat(-1.0).less(taken);
    let booked = L::load(book, at);
    if !step.relaxed {
        L::select(known, booked + taken, booked).store(book, at);
    }
}

/// What all points have dissipated so far \[J\].
#[inline(always)]
pub(super) fn dissipated<L: Lane>(memory: &[Octet], at: usize) -> L {
    L::load(&memory[DISSIPATED], at)
}
