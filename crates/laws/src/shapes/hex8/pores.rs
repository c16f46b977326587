//! Water in the pores of eight elements that it cannot leave: its pressure goes by their mean dilatation.
//!
//! With θ the mean dilatation of an element, one value for all its points (else several of them would lock), and h where this begins,
//! p = p_h − αM(θ − θ_h), but no less than a floor. The law sees effective stress (`terzaghi1943`), and as strain (1 − α)(p − p_h)/3K more, by
//! which grains give way (`biot1941`); what acts on nodes is its stress less (p − p_h)I. p_h itself is whoever's that holds it.
//!
//! **Books.** ½(δp + δp⁺)ΔθV and (1 − α)½(σ'_m + σ'_m⁺)δp/K V by the trapezoidal rule of the scheme, with δp and σ'_m counted from where it begins, so
//! that what is held there is in no line. As a function of the state the two are known only for α = 1 above the floor.
//!
//! **Floor.** There the stiffness falls, and what swings at the mesh's own frequencies crosses that kink with a step as long as its swing: by
//! p = max(…) alone the trapezoidal rule gives out energy on the way down, (p_h + p_floor)/2 where the path has less, and a few hundred swings at 0.9 of the
//! stable step may multiply it by a thousand, as bouncing contacts do. So in the one step that comes down to the floor p is what makes
//! ½(p + p⁺)Δθ the work along the path, which lies as far below the floor as p was above it, times the share of the step beyond; on the way up the
//! rule takes more than the path has. Motion of 60 steps a swing loses a thousandth a swing, and that of a wave nothing that is seen.
//!
//! It does not model flow, and K is the law's own, relaxed and elastic.

use crate::lane::{Lane, Octet};
use core::cell::Cell;

/// What is known of the pores of eight elements; zeros of one that has none, or no water in them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pores {
    /// αM \[Pa\], which pressure a unit of dilatation takes off.
    pub stiffness: Octet,
    /// The least change of pressure \[Pa\], 0 or less: from where it begins down to the floor.
    pub least: Octet,
    /// (1 − α)/3K \[1/Pa\].
    pub grains: Octet,
    /// m³
    pub volume: Octet,
}

/// Numbers that pores remember of an element.
pub const HELD: usize = 5;

/// What the pores of eight elements remember, and what they booked.
#[derive(Clone, Debug, Default)]
pub struct Held {
    /// θ_h; θ − θ_h; p − p_h \[Pa\]; ∫σ'_m dV \[N m\] where it begins, and since.
    pub numbers: [Cell<Octet>; HELD],
    /// Work \[J\] that the water took in the last step.
    pub work: Cell<Octet>,
}

/// Pores of elements, an octet of elements each, with what they remember.
#[derive(Clone, Copy)]
pub struct Undrained<'a> {
    pub pores: &'a [Pores],
    pub held: &'a [Held],
    /// Whether it begins here: dilatation and stress count from what they are now.
    pub begins: bool,
}

/// What water does to an element's law and to its forces.
#[derive(Clone, Copy)]
pub(super) struct Pressed<L> {
    /// p − p_h \[Pa\].
    change: L,
    /// θ − θ_h.
    dilatation: L,
    dilatation_at_start: L,
    /// What it adds to each normal strain.
    pub strain: L,
}

impl<L: Lane> Pressed<L> {
    #[inline(always)]
    pub fn none() -> Self {
        let zero = L::splat(0.0);
        Pressed { change: zero, dilatation: zero, dilatation_at_start: zero, strain: zero }
    }
}

impl<'a> Undrained<'a> {
    /// That of the octet `i` of elements.
    pub(super) fn of(&self, i: usize) -> Undrained<'a> {
        Undrained { pores: &self.pores[i..=i], held: &self.held[i..=i], begins: self.begins }
    }

    #[inline(always)]
    fn number<L: Lane>(&self, k: usize, at: usize) -> L {
        L::load(&self.held[0].numbers[k].get(), at)
    }

    /// The pressure that goes with a mean dilatation.
    #[inline(always)]
    pub(super) fn press<L: Lane>(&self, dilatation: L, at: usize) -> Pressed<L> {
        if self.begins {
            return Pressed { dilatation_at_start: dilatation, ..Pressed::none() };
        }
        let pores = &self.pores[0];
        let dilatation_at_start = self.number(0, at);
        let since: L = dilatation - dilatation_at_start;
        let (wanted, least) = (-(L::load(&pores.stiffness, at) * since), L::load(&pores.least, at));
        let (below, before): (_, L) = (wanted.less(least), self.number(2, at));
        // In the step that comes down to the floor as far below it as the last pressure was above, by the share of the step that lies beyond.
        let (above, beyond) = (before - least, least - wanted);
        let overshoot = above * beyond / (above + beyond);
        let floor = L::select(least.less(before), least - overshoot, least);
        let change = L::select(below, floor, wanted);
        let strain = L::load(&pores.grains, at) * change;
        Pressed { change, dilatation: since, dilatation_at_start, strain }
    }

    /// Remembers and books a step in which ∫ tr σ' dV \[N m\] came to be; (p − p_h) V \[N m\], which is to be taken off each normal resultant.
    #[inline(always)]
    pub(super) fn book<L: Lane>(&self, traces: L, pressed: &Pressed<L>, at: usize) -> L {
        let (pores, held) = (&self.pores[0], &self.held[0]);
        let volume = L::load(&pores.volume, at);
        let mean = L::splat(1.0 / 3.0) * traces;
        let mean_at_start = if self.begins { mean } else { self.number(3, at) };
        let since = mean - mean_at_start;
        let mut work = L::splat(0.0);
        if !self.begins {
            let (dilatation, change, before) =
                (self.number::<L>(1, at), self.number::<L>(2, at), self.number::<L>(4, at));
            let half = L::splat(0.5);
            let of_pores = half * (change + pressed.change) * (pressed.dilatation - dilatation) * volume;
            let of_grains = half
                * (before + since)
                * (pressed.change - change)
                * (L::splat(3.0) * L::load(&pores.grains, at));
            work = -(of_pores + of_grains);
        }
        let numbers = [pressed.dilatation_at_start, pressed.dilatation, pressed.change, mean_at_start, since];
        let mut k = 0;
        while k < HELD {
            keep(numbers[k], &held.numbers[k], at);
            k += 1;
        }
        keep(work, &held.work, at);
        volume * pressed.change
    }

    /// Energy \[J\] that what the law held at the start gave to the strain of its grains: it is in no line.
    #[inline(always)]
    pub(super) fn given<L: Lane>(&self, pressed: &Pressed<L>, at: usize) -> L {
        if self.begins {
            return L::splat(0.0);
        }
        L::splat(3.0) * pressed.strain * self.number(3, at)
    }
}

#[inline(always)]
fn keep<L: Lane>(value: L, to: &Cell<Octet>, at: usize) {
    let mut octet = to.get();
    value.store(&mut octet, at);
    to.set(octet);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In the step that comes down to the floor the trapezoidal rule takes the work along the path, −½M(θ*² − θ²) − f(θ⁺ − θ*), θ* where the floor
    /// f is met; in the next it stays at the floor.
    #[test]
    fn the_step_down_to_the_floor_takes_the_work_along_the_path() {
        let octet = |x: f64| Octet([x; 8]);
        let (stiffness, floor) = (2e9, 3e5);
        let pores = [Pores { stiffness: octet(stiffness), least: octet(-floor), ..Pores::default() }];
        let met = floor / stiffness;
        for (from, to) in [(0.3, 1.7), (-2.0, 1.1), (0.9, 4.0)].map(|(a, b)| (a * met, b * met)) {
            let held = [Held::default()];
            let number = |k: usize, x: f64| held[0].numbers[k].set(octet(x));
            number(0, 1e-3);
            number(2, -stiffness * from);
            let undrained = Undrained { pores: &pores, held: &held, begins: false };
            let step = undrained.press::<f64>(1e-3 + to, 0);
            let along = -0.5 * stiffness * (met * met - from * from) - floor * (to - met);
            let taken = 0.5 * (step.change - stiffness * from) * (to - from);
            assert!((taken / along - 1.0).abs() < 1e-9, "{from} {to}: {taken} {along}");
            number(2, step.change);
            assert_eq!(undrained.press::<f64>(1e-3 + 1.2 * to, 0).change, -floor);
        }
    }
}
