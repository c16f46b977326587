//! The residual state of a rock mass: m_b, s and a that fall with slip along straight lines.

use super::envelope::Envelope;
use crate::lane::Lane;
use crate::materials::plastic::slip::{self, Fall, LongMemory, Measure};

/// Where the constants end, and after how much.
#[derive(Clone, Copy, Debug)]
pub(super) struct Residual {
    pub measure: Measure,
    /// Slip \[m\] or plastic shear strain.
    pub over: f64,
    /// m_b, s and a.
    pub end: [f64; 3],
}

impl Residual {
    /// Share of the way to the end, from 0 to 1.
    #[inline(always)]
    pub fn done<L: Lane>(&self, memory: &LongMemory<L>) -> L {
        let [shear, _] = self.measure.of(memory);
        L::splat(1.0).smaller((shear * L::splat(1.0 / self.over)).larger(L::splat(0.0)))
    }

    /// m_b, s and a after that share of the way.
    #[inline(always)]
    pub fn constants<L: Lane>(&self, peak: &Envelope<f64>, done: L) -> [L; 3] {
        let [mb, s, a] = self.end;
        [
            done.mul_add(L::splat(mb - peak.mb), L::splat(peak.mb)),
            done.mul_add(L::splat(s - peak.s), L::splat(peak.s)),
            done.mul_add(L::splat(a - peak.a), L::splat(peak.a)),
        ]
    }

    /// See [`slip::size_limit`]; infinite where the way has no length. Strength is compared at a confinement of 0 and of the peak's
    /// uniaxial strength (an assumption).
    pub fn size_limit(&self, young: f64, peak: &Envelope<f64>, flow: f64) -> f64 {
        match self.measure {
            Measure::Strain => f64::INFINITY,
            Measure::Displacement => slip::size_limit(young, std::iter::once(self.stage(peak, flow))),
        }
    }

    /// What strength loses on the way; `flow` is the M of the dilation angle.
    pub fn stage(&self, peak: &Envelope<f64>, flow: f64) -> Fall {
        let end = Envelope::new(peak.sci, self.end);
        let lost = |confinement: f64| peak.strength(confinement) - end.strength(confinement);
        let shear = lost(0.0).max(lost(peak.uniaxial()));
        let slope = peak.slope(0.0, -peak.uniaxial(), 0.0);
        Fall { shear, slope, slip: self.over, flow, tension: None }
    }
}
