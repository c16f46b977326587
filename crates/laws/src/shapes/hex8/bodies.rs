//! Damping over a band in an element of many points: the Maxwell bodies by the coefficients of its strain.
//!
//! The bodies of [`crate::band`] are linear in the strain, and the strain of all points has seven coefficients a component. So
//! their strains e_j have as many, which obey the same equation, and a point's are read off as its strain is; what damage has left
//! of the bodies' stress, and what they dissipate, goes by the point. The memory is that of seven points, however many there are.
//! What whole bodies carry and take is integrated in closed form; points that damage has weakened take theirs off it.

use super::layer::{LayeredShape, at_point, in_layer, of_point};
use super::quadrature::Through;
use crate::band::{BODIES, BandStep};
use crate::lane::{Lane, Octet};
use crate::material::Sym;

/// Coefficients of the strain by component.
const MODES: usize = 7;
/// Octets of a field by its coefficients.
const FIELD: usize = 6 * MODES;

/// Octets that an element's bodies keep, by the coefficients of the strain: Σ a_j e_j, or the strain where it is wanted in the next
/// step, e_j, and what was dissipated \[J\].
pub const MODAL_MEMORY: usize = FIELD * (1 + BODIES) + 1;

const DISSIPATED: usize = MODAL_MEMORY - 1;

/// A step of an element's bodies.
pub(super) struct Bodies<L> {
    /// Σ a_j q_j after the step.
    sum: [[L; 8]; 6],
    /// How far the strain has moved in the step; nothing where that is not known.
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

/// Puts a field into the memory.
#[inline(always)]
fn keep<L: Lane>(e: &[[L; 8]; 6], memory: &mut [Octet], field: usize, at: usize) {
    let mut c = 0;
    while c < 6 {
        let mut m = 0;
        while m < MODES {
            e[c][m].store(&mut memory[FIELD * field + MODES * c + m], at);
            m += 1;
        }
        c += 1;
    }
}

/// a − b.
#[inline(always)]
fn less<L: Lane>(a: &[[L; 8]; 6], b: &[[L; 8]; 6]) -> [[L; 8]; 6] {
    let mut e = *a;
    let mut c = 0;
    while c < 6 {
        let mut m = 0;
        while m < MODES {
            e[c][m] = a[c][m] - b[c][m];
            m += 1;
        }
        c += 1;
    }
    e
}

impl<L: Lane> Bodies<L> {
    /// Brings the memory on where it is the step for it, and adds to `taken` what whole bodies take \[J\]. While time stands still the
    /// bodies are relaxed.
    #[inline(always)]
    pub fn advance<G: LayeredShape>(
        step: &BandStep,
        strain: &[[L; 8]; 6],
        memory: &mut [Octet],
        (through, geometry): (&Through, &G),
        taken: &mut L,
        at: usize,
    ) -> Self {
        let zero = L::splat(0.0);
        let mut bodies = Bodies { sum: [[zero; 8]; 6], moved: [[zero; 8]; 6] };
        if step.relaxed {
            let mut field = 0;
            while field <= BODIES {
                keep(strain, memory, field, at);
                field += 1;
            }
            return bodies;
        }
        if step.brings {
            bodies.bring_on(step, strain, memory, (through, geometry), taken, at);
        } else {
            let mut c = 0;
            while c < 6 {
                let mut m = 0;
                while m < MODES {
                    if step.begins {
                        let first = L::load(&memory[FIELD + MODES * c + m], at);
                        let second = L::load(&memory[2 * FIELD + MODES * c + m], at);
                        let third = L::load(&memory[3 * FIELD + MODES * c + m], at);
                        step.weighted([first, second, third]).store(&mut memory[MODES * c + m], at);
                    }
                    let offset = L::load(&memory[MODES * c + m], at);
                    bodies.sum[c][m] = step.weighted([strain[c][m]; BODIES]) - offset;
                    m += 1;
                }
                c += 1;
            }
        }
        if step.keeps {
            keep(strain, memory, 0, at);
        }
        bodies
    }

    #[inline(always)]
    fn bring_on<G: LayeredShape>(
        &mut self,
        step: &BandStep,
        strain: &[[L; 8]; 6],
        memory: &mut [Octet],
        (through, geometry): (&Through, &G),
        taken: &mut L,
        at: usize,
    ) {
        let zero = L::splat(0.0);
        let last = kept::<L>(memory, 0, at);
        self.moved = less(strain, &last);
        let mut offset = [[zero; 8]; 6];
        let mut j = 0;
        while j < BODIES {
            let old = kept::<L>(memory, 1 + j, at);
            let mut turned = [[zero; 8]; 6];
            let mut c = 0;
            while c < 6 {
                let mut m = 0;
                while m < MODES {
                    let mean = L::splat(0.5) * (last[c][m] + strain[c][m]);
                    let new = step.brought_on(j, old[c][m], mean);
                    turned[c][m] = new - old[c][m];
                    new.store(&mut memory[FIELD * (1 + j) + MODES * c + m], at);
                    // In the order of [`BandStep::weighted`].
                    let weight = L::splat(step.weights[j]);
                    offset[c][m] = if j == 0 { weight * new } else { weight.mul_add(new, offset[c][m]) };
                    m += 1;
                }
                c += 1;
            }
            let energy = geometry.elastic_energy(through, &step.moduli, &turned, at);
            *taken = L::splat(step.flow(j)).mul_add(energy, *taken);
            j += 1;
        }
        let mut c = 0;
        while c < 6 {
            let mut m = 0;
            while m < MODES {
                self.sum[c][m] = step.weighted([strain[c][m]; BODIES]) - offset[c][m];
                m += 1;
            }
            c += 1;
        }
        keep(&offset, memory, 0, at);
    }

    /// Adds what whole bodies carry to the resultants.
    #[inline(always)]
    pub fn add_whole<G: LayeredShape>(
        &self,
        step: &BandStep,
        sums: &mut [[L; 8]; 6],
        (through, geometry): (&Through, &G),
        at: usize,
    ) {
        geometry.add_elastic(through, sums, &step.moduli, &self.sum, at);
    }

    /// Stress \[Pa\] of whole bodies at a point.
    #[inline(always)]
    pub fn stress(&self, step: &BandStep, zeta: f64, q: usize) -> Sym<L> {
        step.moduli.stress(&at_point(&self.sum, zeta, q))
    }

    /// Says how far the strain has moved, where that is [asked](BandStep::asks) for.
    #[inline(always)]
    pub fn has_moved(&mut self, moved: [[L; 8]; 6]) {
        self.moved = moved;
    }

    /// Takes off the weighted stresses of a layer what its bodies no longer carry, of which the shares `now` are left after
    /// `before`; what they take beyond whole ones \[J\].
    #[inline(always)]
    pub fn lessen(
        &self,
        step: &BandStep,
        strain: &[[L; 8]; 6],
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
        let weakens = L::either(
            L::either(now[0].less(before[0]), now[1].less(before[1])),
            L::either(now[2].less(before[2]), now[3].less(before[3])),
        );
        let weakens = L::any(weakens);
        if !(step.brings || weakens) {
            return zero;
        }
        let mut flown = [zero; 4];
        let mut held = [zero; 4];
        let (to, moved) = (in_layer(strain, zeta), in_layer(&self.moved, zeta));
        let mut j = 0;
        while j < BODIES {
            let ends = in_layer(&kept::<L>(memory, 1 + j, at), zeta);
            // Δe_j = 2R/(1 − R) (ε̄ − e_j) of e_j after the step.
            let turns = L::splat(2.0 * step.halves[j] / (1.0 - step.halves[j]));
            let flow = L::splat(step.flow(j));
            let mut q = 0;
            while q < 4 {
                let (to, lag) = (of_point(&to, q), of_point(&ends, q));
                let (mut last, mut old, mut turned) = (to, lag, [zero; 6]);
                let mut c = 0;
                while c < 6 {
                    last[c] = to[c] - moved[c][q];
                    if step.brings {
                        turned[c] = turns * (half * (last[c] + to[c]) - lag[c]);
                        old[c] = lag[c] - turned[c];
                    }
                    c += 1;
                }
                if step.brings {
                    flown[q] = flow.mul_add(step.moduli.energy(&turned), flown[q]);
                }
                if weakens {
                    held[q] = step.lost(j, held[q], (&to, &lag), (&last, &old));
                }
                q += 1;
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

/// What the bodies of a point hold \[J/m³\] at its strain after a step.
#[inline(always)]
pub(super) fn held<L: Lane>(
    step: &BandStep,
    strain: &Sym<L>,
    memory: &[Octet],
    zeta: f64,
    q: usize,
    now: L,
    at: usize,
) -> L {
    let mut sum = L::splat(0.0);
    let mut j = 0;
    while j < BODIES {
        let mut stretch = at_point(&kept::<L>(memory, 1 + j, at), zeta, q);
        let mut c = 0;
        while c < 6 {
            stretch[c] = strain[c] - stretch[c];
            c += 1;
        }
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
