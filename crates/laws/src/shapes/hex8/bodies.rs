//! Damping over a band in an element of many points: the Maxwell bodies by the coefficients of its strain.
//!
//! The bodies of [`crate::band`] are linear in the strain, and the strain of all points has seven coefficients a component. So
//! their stretches have as many, which obey the same equation, and a point's are read off as its strain is; what damage has left
//! of the bodies' stress, and what they dissipate, goes by the point. The memory is that of seven points, however many there are.
//! What whole bodies carry and take is integrated in closed form; points that damage has weakened take theirs off it.

use super::layer::{add_elastic, at_point, elastic_energy, in_layer, of_point};
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

    /// Adds what whole bodies carry to the resultants; what they take in the step \[J\], as [`BandStep::stress`] books it.
    #[inline(always)]
    pub fn add_whole(&self, step: &BandStep, sums: &mut [[L; 8]; 6], moments: &[[L; 3]; 4]) -> L {
        add_elastic(sums, &step.moduli, &self.sum, moments);
        let mut taken = L::splat(0.0);
        let mut j = 0;
        while j < BODIES {
            let energy = elastic_energy(&step.moduli, &self.means[j], moments);
            taken = L::splat(step.halves[j] * step.weights[j]).mul_add(energy, taken);
            j += 1;
        }
        taken
    }

    /// Stress \[Pa\] of whole bodies at a point.
    #[inline(always)]
    pub fn stress(&self, step: &BandStep, zeta: f64, q: usize) -> Sym<L> {
        step.moduli.stress(&at_point(&self.sum, zeta, q))
    }

    /// Takes off the weighted stresses of a layer what its bodies no longer carry, of which the shares `now` are left after
    /// `before`; what they take beyond whole ones \[J\].
    #[inline(always)]
    pub fn lessen(
        &self,
        step: &BandStep,
        memory: &[Octet],
        zeta: f64,
        weight: &[L; 4],
        [before, now]: [&[L; 4]; 2],
        values: &mut [[L; 4]; 6],
        at: usize,
    ) -> L {
        let (zero, one, half) = (L::splat(0.0), L::splat(1.0), L::splat(0.5));
        let sum = in_layer(&self.sum, zeta);
        let mut q = 0;
        while q < 4 {
            let stress = step.moduli.stress(&of_point(&sum, q));
            let lost = weight[q] * (one - now[q]);
            let mut c = 0;
            while c < 6 {
                values[c][q] = lost.neg_mul_add(stress[c], values[c][q]);
                c += 1;
            }
            q += 1;
        }
        let mut flown = [zero; 4];
        let mut held = [zero; 4];
        let weakens = L::either(
            L::either(now[0].less(before[0]), now[1].less(before[1])),
            L::either(now[2].less(before[2]), now[3].less(before[3])),
        );
        let weakens = L::any(weakens);
        let mut j = 0;
        while j < BODIES {
            let share = L::splat(step.halves[j] * step.weights[j]);
            let means = in_layer(&self.means[j], zeta);
            let mut q = 0;
            while q < 4 {
                flown[q] = share.mul_add(step.moduli.energy(&of_point(&means, q)), flown[q]);
                q += 1;
            }
            if weakens {
                let moved = in_layer(&self.moved, zeta);
                let ends = in_layer(&kept::<L>(memory, 1 + j, at), zeta);
                let weight = step.weights[j];
                let mut q = 0;
                while q < 4 {
                    let (mean, new) = (of_point(&means, q), of_point(&ends, q));
                    let (mut old, mut turned) = ([zero; 6], [zero; 6]);
                    let mut c = 0;
                    while c < 6 {
                        old[c] = mean[c] - new[c];
                        turned[c] = new[c] - old[c];
                        c += 1;
                    }
                    let both = step.moduli.energy(&old) + step.moduli.energy(&new);
                    held[q] = L::splat(0.5 * weight).mul_add(both, held[q]);
                    let across = step.moduli.product(&turned, &of_point(&moved, q));
                    held[q] = L::splat(-0.25 * weight).mul_add(across, held[q]);
                    q += 1;
                }
            }
            j += 1;
        }
        let mut taken = zero;
        let mut q = 0;
        while q < 4 {
            let lost = (before[q] - now[q]) * held[q].larger(zero);
            let beyond = half.mul_add(before[q] + now[q], -one).mul_add(flown[q], lost);
            taken = weight[q].mul_add(beyond, taken);
            q += 1;
        }
        taken
    }
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
