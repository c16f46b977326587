//! Water that cannot leave the pores of rock, as P waves feel it.

use tremolite_engine::{Body, Water};
use tremolite_motion::Complex64;

/// What water adds to the modulus of P waves: αM(1 − (1 − α)m), m the modulus of the rock over that of its law at rest; without damping over a
/// band α²M.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoreWater {
    /// αM \[Pa\]
    whole: f64,
    /// 1 − α, times the material's own modulus over that of the law.
    grains: f64,
    /// α²M \[Pa\], by which dashpots go.
    pub stiffening: f64,
}

impl PoreWater {
    /// In an element of a body; none where pressures stay.
    pub fn of(water: &Water, element: u32, body: &Body) -> Option<Self> {
        let pores = water.undrained(element as usize)?;
        let relaxed = body.material.relaxed().young() / body.material.moduli().young();
        let whole = pores.biot * pores.modulus;
        Some(PoreWater { whole, grains: (1.0 - pores.biot) / relaxed, stiffening: pores.biot * whole })
    }

    /// The same in rock that damps nothing.
    pub fn undamped(self) -> Self {
        PoreWater { grains: 1.0 - self.stiffening / self.whole, ..self }
    }

    /// What it adds \[Pa\] to rock of which the band's bodies make so many times the own modulus.
    pub fn modulus(&self, elastic: Complex64) -> Complex64 {
        (1.0 - self.grains * elastic) * self.whole
    }
}
