//! A pair on its way along a path of gap and slip, with what goes into it.

use super::Random;
use super::samples::{Sample, samples};
use tremolite_laws::{History, Interface, PairState};

pub struct Pair<'a, I: Interface> {
    pub law: &'a I,
    pub gap: f64,
    pub slip: [f64; 2],
    pub pressure: f64,
    pub shear: [f64; 2],
    pub history: I::History<f64>,
}

// Derived, it would ask the law to be `Copy`.
impl<I: Interface> Clone for Pair<'_, I> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<I: Interface> Copy for Pair<'_, I> {}

/// Work \[J/m²\] that a step puts into the pair, by the trapezoidal rule.
#[derive(Clone, Copy, Debug)]
pub struct Work {
    pub across: f64,
    pub along: f64,
}

impl<'a, I: Interface> Pair<'a, I> {
    pub fn new(law: &'a I) -> Self {
        let history = <I::History<f64> as History<f64>>::zero();
        Pair { law, gap: 0.0, slip: [0.0; 2], pressure: 0.0, shear: [0.0; 2], history }
    }

    /// One that begins with a traction.
    pub fn started(law: &'a I, pressure: f64, shear: [f64; 2]) -> Self {
        let (gap, history) = law.start(pressure, shear);
        let mut pair = Pair { gap, pressure, shear, history, ..Pair::new(law) };
        pair.to(gap, [0.0; 2]);
        pair
    }

    pub fn to(&mut self, gap: f64, slip: [f64; 2]) -> Work {
        let (pressure, shear, history) = self.law.update(gap, slip, self.history);
        let work = Work {
            across: -0.5 * (self.pressure + pressure) * (gap - self.gap),
            along: (0..2).map(|i| -0.5 * (self.shear[i] + shear[i]) * (slip[i] - self.slip[i])).sum(),
        };
        *self = Pair { law: self.law, gap, slip, pressure, shear, history };
        work
    }

    pub fn column(&self, k: usize) -> f64 {
        self.history.as_ref()[k]
    }

    pub fn state(&self) -> PairState {
        PairState::ALL.into_iter().find(|s| s.number() == self.column(I::STATE)).expect("a state")
    }

    pub fn slid(&self) -> bool {
        self.column(I::SLID) == 1.0
    }

    pub fn opened(&self) -> bool {
        self.column(I::OPENED) == 1.0
    }

    pub fn friction(&self) -> f64 {
        self.column(I::DISSIPATION)
    }

    pub fn created(&self) -> f64 {
        self.column(I::CREATION)
    }

    /// All that is stored, and what of it is along the tangents.
    pub fn stored(&self) -> [f64; 2] {
        let whole = self.law.stored_energy(self.gap, self.shear, &self.history);
        [whole, whole - self.law.stored_energy(self.gap, [0.0; 2], &self.history)]
    }

    pub fn size(&self) -> f64 {
        self.shear[0].hypot(self.shear[1])
    }
}

/// Calls back with every sample of a law.
pub fn each_sample<I: Interface>(mut check: impl FnMut(&I, &Sample)) {
    for sample in samples(I::NAME) {
        check(&I::new(&sample.values()).unwrap(), sample);
    }
}

/// A resolved path of gap and slip: sums of sines that close to some MPa, slide and open now and then.
pub fn wandering<I: Interface>(law: &I, random: &mut Random, steps: usize) -> Vec<(f64, [f64; 2])> {
    let deep = -law.start(6e6, [0.0; 2]).0;
    let far = 3e6 / law.stiffness(0.0)[1];
    let mut sines = |size: f64| [0; 4].map(|_| (size * random.symmetric(), 20.0 * random.unit()));
    let [across, first, second] = [sines(0.6 * deep), sines(2.0 * far), sines(2.0 * far)];
    let at = |of: &[(f64, f64)], x: f64| of.iter().map(|(a, w)| a * (w * x).sin()).sum::<f64>();
    let row = |k: usize| {
        let x = k as f64 / steps as f64;
        // From rest at zero.
        (at(&across, x) - 0.4 * deep * (1.0 - (-20.0 * x).exp()), [at(&first, x), at(&second, x)])
    };
    (0..=steps).map(row).collect()
}

/// Runs a check of one law on every law: `on_every_interface!($ check)`, since a macro cannot write a `$` of its own.
#[rustfmt::skip]
macro_rules! on_every_interface {
    ($d:tt $check:ident) => {{
        macro_rules! each {
            ($d($d law:ty,)*) => { $d($check::<$d law>();)* };
        }
        tremolite_laws::for_each_interface!(each);
    }};
}
pub(crate) use on_every_interface;
