//! A step of the bodies of a point.

use super::{BODIES, BODY, DISSIPATED};
use crate::lane::{Lane, Octet};
use crate::material::{Moduli, Sym};

/// Constants of one step.
#[derive(Clone, Copy, Debug)]
pub struct BandStep {
    pub(crate) weights: [f64; BODIES],
    /// R_j = NΔt/2τ_j
    pub(crate) halves: [f64; BODIES],
    pub(crate) moduli: Moduli,
    /// Whether time stands still.
    pub(crate) relaxed: bool,
    /// Whether it goes on from here: nothing has moved yet, and whoever evaluates this again must find the same.
    pub(crate) begins: bool,
    /// Whether the memory is brought on in this step, and whether in the next.
    pub(crate) brings: bool,
    pub(crate) keeps: bool,
}

impl BandStep {
    /// Σ a_j x of a number, added up as that of the bodies' own is: of relaxed bodies nothing is left of the difference.
    #[inline(always)]
    pub(crate) fn weighted<L: Lane>(&self, x: [L; BODIES]) -> L {
        let [a, b, c] = self.weights;
        L::splat(c).mul_add(x[2], L::splat(b).mul_add(x[1], L::splat(a) * x[0]))
    }

    /// e_j after the step from e_j before and the mean of the strain over the step.
    #[inline(always)]
    pub(crate) fn brought_on<L: Lane>(&self, j: usize, e: L, mean: L) -> L {
        L::splat(2.0 * self.halves[j] / (1.0 + self.halves[j])).mul_add(mean - e, e)
    }

    /// What flows in a body takes over the energy of its Δe_j.
    #[inline(always)]
    pub(crate) fn flow(&self, j: usize) -> f64 {
        self.weights[j] / self.halves[j]
    }

    /// Whether a step in which the share falls from `before` to `now` in some lane asks how far the strain has moved.
    #[inline(always)]
    pub fn asks<L: Lane>(&self, before: L, now: L) -> bool {
        !self.brings && !self.relaxed && L::any(now.less(before))
    }

    /// Stress \[Pa\] of the bodies at a strain, of which the share `now` is left after `before`; their memory and their
    /// book are brought on. While time stands still they carry nothing and follow the strain. `moved` is how far the strain has moved in
    /// the step, where that is [asked](Self::asks) for.
    #[inline(always)]
    pub fn stress<L: Lane>(
        &self,
        strain: &Sym<L>,
        before: L,
        now: L,
        moved: &Sym<L>,
        memory: &mut [Octet],
        at: usize,
    ) -> Sym<L> {
        let zero = L::splat(0.0);
        if self.relaxed {
            let mut c = 0;
            while c < 6 {
                let mut k = 0;
                while k <= BODIES {
                    strain[c].store(&mut memory[BODY * k + c], at);
                    k += 1;
                }
                c += 1;
            }
            return [zero; 6];
        }
        let mut sum = [zero; 6];
        if self.brings {
            self.bring_on(strain, before, now, memory, at, &mut sum);
        } else {
            let mut c = 0;
            while c < 6 {
                if self.begins {
                    let first = L::load(&memory[BODY + c], at);
                    let second = L::load(&memory[2 * BODY + c], at);
                    let third = L::load(&memory[3 * BODY + c], at);
                    self.weighted([first, second, third]).store(&mut memory[c], at);
                }
                sum[c] = self.weighted([strain[c]; BODIES]) - L::load(&memory[c], at);
                c += 1;
            }
            if L::any(now.less(before)) {
                self.book_loss(strain, before, now, moved, memory, at);
            }
        }
        if self.keeps {
            let mut c = 0;
            while c < 6 {
                strain[c].store(&mut memory[c], at);
                c += 1;
            }
        }
        let mut stress = self.moduli.stress(&sum);
        let mut c = 0;
        while c < 6 {
            stress[c] = now * stress[c];
            c += 1;
        }
        stress
    }

    /// Brings the memory on, books what that takes, and leaves Σ a_j q_j.
    #[inline(always)]
    fn bring_on<L: Lane>(
        &self,
        strain: &Sym<L>,
        before: L,
        now: L,
        memory: &mut [Octet],
        at: usize,
        sum: &mut Sym<L>,
    ) {
        let (zero, half) = (L::splat(0.0), L::splat(0.5));
        let mut last = [zero; 6];
        let mut mean = [zero; 6];
        let mut flown = zero;
        let mut lags = [[zero; 6]; BODIES];
        let mut c = 0;
        while c < 6 {
            last[c] = L::load(&memory[c], at);
            mean[c] = half * (last[c] + strain[c]);
            c += 1;
        }
        let weakens = L::any(now.less(before));
        let mut held = zero;
        let mut j = 0;
        while j < BODIES {
            let (mut turned, mut old) = ([zero; 6], [zero; 6]);
            let mut c = 0;
            while c < 6 {
                let e = &mut memory[BODY * (j + 1) + c];
                old[c] = L::load(e, at);
                lags[j][c] = self.brought_on(j, old[c], mean[c]);
                turned[c] = lags[j][c] - old[c];
                lags[j][c].store(e, at);
                c += 1;
            }
            flown = L::splat(self.flow(j)).mul_add(self.moduli.energy(&turned), flown);
            if weakens {
                held = self.lost(j, held, (strain, &lags[j]), (&last, &old));
            }
            j += 1;
        }
        let mut c = 0;
        while c < 6 {
            let offset = self.weighted([lags[0][c], lags[1][c], lags[2][c]]);
            offset.store(&mut memory[c], at);
            sum[c] = self.weighted([strain[c]; BODIES]) - offset;
            c += 1;
        }
        let lost = (before - now) * held.larger(zero);
        self.book((half * (before + now)).mul_add(flown, lost), memory, at);
    }

    /// Adds ψ̄_j − ¼ a_j Δq_j:C:Δε of a body to `sum`, from strain and e_j after a step and before.
    #[inline(always)]
    pub(crate) fn lost<L: Lane>(
        &self,
        j: usize,
        sum: L,
        (strain, lag): (&Sym<L>, &Sym<L>),
        (last, old): (&Sym<L>, &Sym<L>),
    ) -> L {
        let zero = L::splat(0.0);
        let (mut from, mut to) = ([zero; 6], [zero; 6]);
        let (mut turned, mut moved) = ([zero; 6], [zero; 6]);
        let mut c = 0;
        while c < 6 {
            from[c] = last[c] - old[c];
            to[c] = strain[c] - lag[c];
            turned[c] = to[c] - from[c];
            moved[c] = strain[c] - last[c];
            c += 1;
        }
        let both = self.moduli.energy(&from) + self.moduli.energy(&to);
        let sum = L::splat(0.5 * self.weights[j]).mul_add(both, sum);
        L::splat(-0.25 * self.weights[j]).mul_add(self.moduli.product(&turned, &moved), sum)
    }

    /// Books what a falling share takes where the memory stays.
    #[inline(always)]
    fn book_loss<L: Lane>(
        &self,
        strain: &Sym<L>,
        before: L,
        now: L,
        moved: &Sym<L>,
        memory: &mut [Octet],
        at: usize,
    ) {
        let zero = L::splat(0.0);
        let mut last = [zero; 6];
        let mut c = 0;
        while c < 6 {
            last[c] = strain[c] - moved[c];
            c += 1;
        }
        let mut held = zero;
        let mut j = 0;
        while j < BODIES {
            let lag = self.lag(j, memory, at);
            held = self.lost(j, held, (strain, &lag), (&last, &lag));
            j += 1;
        }
        self.book((before - now) * held.larger(zero), memory, at);
    }

    /// e_j of the memory.
    #[inline(always)]
    fn lag<L: Lane>(&self, j: usize, memory: &[Octet], at: usize) -> Sym<L> {
        let mut lag = [L::splat(0.0); 6];
        let mut c = 0;
        while c < 6 {
            lag[c] = L::load(&memory[BODY * (j + 1) + c], at);
            c += 1;
        }
        lag
    }

    #[inline(always)]
    fn book<L: Lane>(&self, taken: L, memory: &mut [Octet], at: usize) {
        let book = &mut memory[DISSIPATED];
        // A strain that is no number must not enter the book.
        let known = L::splat(-1.0).less(taken);
        let booked = L::load(book, at);
        L::select(known, booked + taken, booked).store(book, at);
    }

    /// What the bodies hold \[J/m³\] at a strain after [`Self::stress`], where the share `now` is left of them.
    #[inline(always)]
    pub fn held<L: Lane>(&self, strain: &Sym<L>, now: L, memory: &[Octet], at: usize) -> L {
        let mut sum = L::splat(0.0);
        let mut j = 0;
        while j < BODIES {
            let mut stretch = self.lag(j, memory, at);
            let mut c = 0;
            while c < 6 {
                stretch[c] = strain[c] - stretch[c];
                c += 1;
            }
            sum = L::splat(self.weights[j]).mul_add(self.moduli.energy(&stretch), sum);
            j += 1;
        }
        now * sum
    }

    /// What they have dissipated so far \[J/m³\].
    #[inline(always)]
    pub fn dissipated<L: Lane>(memory: &[Octet], at: usize) -> L {
        L::load(&memory[DISSIPATED], at)
    }
}
