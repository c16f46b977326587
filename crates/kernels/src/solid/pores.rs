//! Pores of a patch of elements in which water changes its pressure as the ground shakes, with what they remember in the state.

use crate::part::ElementEnergy;
use tremolite_laws::shapes::hex8::{HELD, Held, Hex8, Pores, Undrained};
use tremolite_laws::{Moduli, Octet};

/// Pores of an element as the shaking finds them; `PoresOf::default()` where no water is in them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PoresOf {
    /// Biot's coefficient α.
    pub biot: f64,
    /// Biot's modulus M \[Pa\]; 0: the pressure stays.
    pub modulus: f64,
    /// The least change of pressure \[Pa\], 0 or less.
    pub least: f64,
}

/// Pores of a patch.
pub(super) struct Porous {
    pores: Vec<Pores>,
    /// The same without a floor.
    linear: Vec<Pores>,
}

/// Numbers an octet of elements.
const OF_OCTET: usize = 8 * HELD;
/// The first number: whether the next evaluation is the first of the shaking.
const FLAG: usize = 1;

impl Porous {
    /// Bytes that it takes.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.pores[..]) + size_of_val(&self.linear[..])
    }

    /// Of elements with these shapes and the law's own moduli; none where the water of none changes its pressure.
    pub fn of(pores: &[PoresOf], geometry: &[Hex8], law: Moduli) -> Option<Self> {
        if pores.iter().all(|of| of.modulus == 0.0) {
            return None;
        }
        let bulk = law.lambda + 2.0 / 3.0 * law.mu;
        let mut all = vec![Pores::default(); pores.len().div_ceil(8)];
        for (e, (of, hex)) in pores.iter().zip(geometry).enumerate().filter(|(_, (of, _))| of.modulus > 0.0) {
            let (own, lane) = (&mut all[e / 8], e % 8);
            own.stiffness.0[lane] = of.biot * of.modulus;
            own.least.0[lane] = of.least;
            own.grains.0[lane] = (1.0 - of.biot) / (3.0 * bulk);
            own.volume.0[lane] = hex.volume;
        }
        let linear = |own: &Pores| Pores { least: Octet([f64::NEG_INFINITY; 8]), ..*own };
        Some(Porous { linear: all.iter().map(linear).collect(), pores: all })
    }

    /// How many numbers are remembered.
    pub fn numbers(&self) -> usize {
        FLAG + OF_OCTET * self.pores.len()
    }

    /// The next evaluation is the first of the shaking.
    pub fn begin(&self, numbers: &mut [f64]) {
        numbers[0] = 1.0;
    }

    /// What a pass needs, with what is remembered in `numbers` brought to `held`.
    pub fn remembered<'a>(&'a self, numbers: &[f64], held: &'a mut Vec<Held>) -> Undrained<'a> {
        held.resize_with(self.pores.len(), Held::default);
        for (held, own) in held.iter().zip(numbers[FLAG..].chunks_exact(OF_OCTET)) {
            for (cell, eight) in held.numbers.iter().zip(own.chunks_exact(8)) {
                cell.set(Octet(std::array::from_fn(|lane| eight[lane])));
            }
        }
        Undrained { pores: &self.pores, held: &held[..self.pores.len()], begins: numbers[0] != 0.0 }
    }

    /// Brings what a pass left to be remembered back; the work \[J\] that the water took.
    pub fn remember(&self, held: &[Held], numbers: &mut [f64]) -> f64 {
        numbers[0] = 0.0;
        let mut work = 0.0;
        for (held, own) in held.iter().zip(numbers[FLAG..].chunks_exact_mut(OF_OCTET)) {
            for (cell, eight) in held.numbers.iter().zip(own.chunks_exact_mut(8)) {
                eight.copy_from_slice(&cell.get().0);
            }
            work += held.work.get().0.iter().sum::<f64>();
        }
        work
    }

    /// What a product with the stiffness needs.
    pub fn linear<'a>(&'a self, held: &'a mut Vec<Held>) -> Undrained<'a> {
        held.clear();
        held.resize_with(self.pores.len(), Held::default);
        Undrained { pores: &self.linear, held, begins: false }
    }

    /// Adds ½α²Mθ²V \[J\] to what elastic elements hold after a pass with the linear pores.
    pub fn add_energy(&self, held: &[Held], energy: &mut [ElementEnergy]) {
        for (e, energy) in energy.iter_mut().enumerate() {
            let (own, pores, lane) = (&held[e / 8], &self.linear[e / 8], e % 8);
            let [dilatation, change, mean] = [1, 2, 4].map(|k: usize| own.numbers[k].get().0[lane]);
            let of_grains = 3.0 * pores.grains.0[lane] * mean * change;
            energy.strain -= 0.5 * (of_grains + change * dilatation * pores.volume.0[lane]);
        }
    }

    /// Adds the change of pressure \[Pa\] of each element since the shaking began.
    pub fn pressures(&self, numbers: &[f64], change: &mut [f64]) {
        for (e, change) in change.iter_mut().enumerate() {
            *change += numbers[FLAG + OF_OCTET * (e / 8) + 16 + e % 8];
        }
    }
}
