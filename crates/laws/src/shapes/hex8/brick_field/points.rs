//! Bricks of 2×2×2 points and of layers: what whole material carries, in closed form.

use super::super::full::FullShape;
use super::super::layer::LayeredShape;
use super::super::quadrature::Through;
use super::super::{Hex8, Stabilisation};
use super::{BrickField, SHEAR};
use crate::lane::Lane;
use crate::material::{Moduli, Sym};

impl FullShape for BrickField {
    type Field = Self;
    const EMPTY: Self = Self::EMPTY;

    fn set(&mut self, lane: usize, hex: &Hex8, elastic: &Stabilisation) {
        self.put(lane, hex, elastic);
    }

    #[inline(always)]
    fn field(&self) -> &Self {
        self
    }

    #[inline(always)]
    fn weight<L: Lane>(&self, _: usize, at: usize) -> L {
        L::load(&self.weight, at)
    }
}

impl BrickField {
    /// Resultants of a whole elastic material of a strain with these coefficients, at 2×2×2 points.
    #[inline(always)]
    pub(super) fn elastic_resultants<L: Lane>(
        &self,
        moduli: &Moduli,
        e: &[[L; 8]; 6],
        at: usize,
    ) -> [[L; 8]; 6] {
        let volume = L::splat(8.0) * L::load(&self.weight, at);
        let mut sums = [[L::splat(0.0); 8]; 6];
        let mut mode = 0;
        while mode < 7 {
            let stress = moduli.stress(&of_mode(e, mode));
            let mut c = 0;
            while c < 3 {
                sums[c][mode] = volume * stress[c];
                c += 1;
            }
            mode += 1;
        }
        let shear = L::splat(moduli.mu) * volume;
        let mut s = 0;
        while s < 3 {
            sums[3 + s][0] = shear * e[3 + s][0];
            sums[3 + s][SHEAR[s]] = shear * e[3 + s][SHEAR[s]];
            s += 1;
        }
        sums
    }

    /// ∫ 1 and ζ² by a rule through the thickness, of a quarter of the element.
    #[inline(always)]
    fn moments<L: Lane>(&self, through: &Through, at: usize) -> [L; 2] {
        let weight = L::load(&self.weight, at);
        [weight + weight, L::splat(through.square) * weight]
    }
}

impl LayeredShape for BrickField {
    type Field = Self;
    const EMPTY: Self = Self::EMPTY;

    fn set(&mut self, lane: usize, hex: &Hex8, elastic: &Stabilisation, _: &Through) {
        self.put(lane, hex, elastic);
    }

    #[inline(always)]
    fn field(&self) -> &Self {
        self
    }

    #[inline(always)]
    fn weight<L: Lane>(&self, through: &Through, layer: usize, _: usize, at: usize) -> L {
        L::splat(through.weight[layer]) * L::load(&self.weight, at)
    }

    #[inline(always)]
    fn add_elastic<L: Lane>(
        &self,
        through: &Through,
        sums: &mut [[L; 8]; 6],
        moduli: &Moduli,
        e: &[[L; 8]; 6],
        at: usize,
    ) {
        let four = L::splat(4.0);
        let [one, square] = self.moments::<L>(through, at);
        let (one, square) = (four * one, four * square);
        let mut mode = 0;
        while mode < 7 {
            let stress = moduli.stress(&of_mode(e, mode));
            let weight = if mode < 4 { one } else { square };
            let mut c = 0;
            while c < 6 {
                sums[c][mode] = weight.mul_add(stress[c], sums[c][mode]);
                c += 1;
            }
            mode += 1;
        }
    }

    #[inline(always)]
    fn elastic_energy<L: Lane>(&self, through: &Through, moduli: &Moduli, e: &[[L; 8]; 6], at: usize) -> L {
        let [one, square] = self.moments::<L>(through, at);
        let mut sums = [L::splat(0.0); 2];
        let mut mode = 0;
        while mode < 7 {
            let sum = &mut sums[mode / 4];
            *sum = *sum + moduli.energy(&of_mode(e, mode));
            mode += 1;
        }
        L::splat(4.0) * square.mul_add(sums[1], one * sums[0])
    }
}

/// The coefficients of a mode.
#[inline(always)]
fn of_mode<L: Lane>(e: &[[L; 8]; 6], mode: usize) -> Sym<L> {
    [e[0][mode], e[1][mode], e[2][mode], e[3][mode], e[4][mode], e[5][mode]]
}
