//! How a layered column shears, and what all its layers do at one frequency: each wave is found once.

use super::{Layer, LayeredColumn, Train, Waves};
use rayon::prelude::*;
use std::f64::consts::TAU;
use tremolite_engine::Top;
use tremolite_motion::Complex64;

impl LayeredColumn {
    /// The column of all these layers, given upwards, also where neighbours are of the same stuff.
    pub(crate) fn of_all(layers: Vec<Layer>, top: Top) -> Self {
        LayeredColumn { layers, top }
    }

    /// At a complex frequency \[1/s\], over the velocity of the incident wave at the base: the velocity at the base and at the top of each layer,
    /// upwards; and ∂v/∂z in the middle of each layer \[1/m\], upwards, 0 of one without a thickness. Shear strain is that over s.
    pub(crate) fn factors_and_slopes(&self, s: Complex64) -> [Vec<Complex64>; 2] {
        let waves = self.waves(s);
        let slope = |(layer, waves): (&Layer, &Waves)| {
            let Waves { up, mirror, way, .. } = *waves;
            match layer.thickness > 0.0 {
                true => -way / layer.thickness * up * ((-way * 0.5).exp() - mirror * (-way * 1.5).exp()),
                false => Complex64::default(),
            }
        };
        let slopes = self.layers.iter().zip(&waves).map(slope).collect();
        [waves.iter().map(|waves| waves.up * (1.0 + waves.back)).collect(), slopes]
    }
}

impl Train {
    /// Something of each complex frequency \[1/s\] of it, in their order.
    pub(crate) fn frequencies<T: Send>(&self, of: impl Fn(Complex64) -> T + Sync) -> Vec<T> {
        let step = TAU / (self.wave.len() as f64 * self.dt);
        (0..=self.wave.len() / 2)
            .into_par_iter()
            .map(|k| of(Complex64::new(self.eta, k as f64 * step)))
            .collect()
    }

    /// [`Train::through`] by the number of the frequency.
    pub(crate) fn through_each(&self, factor: impl Fn(usize) -> Complex64) -> Vec<f64> {
        let step = TAU / (self.wave.len() as f64 * self.dt);
        self.through(&|s| factor((s.im / step).round() as usize))
    }
}
