//! Soft ground, equivalent-linear: each layer has the modulus and the damping of the strain that it came to (`schnabel1972`; `kramer1996`, section
//! 7.2.1.3).
//!
//! A layer's effective strain is a share of the largest in its middle, 0.65 by custom. The layers are gone through with the moduli of the strains
//! found before, until no modulus and no damping ratio changes any more. It is the linear column that fits in the end, [`LayeredColumn`] with
//! complex moduli G(1 + 2iD), so all that this does can be done with it: go up from the rock, or down from a record at the surface. Where strains
//! are large this is wrong in kind: a linear column of the mean modulus damps away what is high in frequency, and does not yield. So beyond
//! [`MOST_STRAIN`] it is refused.

mod curves;
mod darendeli;
mod of_law;
mod table;
mod vucetic_dobry;

pub use curves::Curves;
pub use darendeli::Darendeli;
pub use of_law::of_law;
pub use table::CurveTable;

use crate::layered_column::{Layer, LayeredColumn, Train};
use rayon::prelude::*;
use std::f64::consts::TAU;
use std::fmt;
use tremolite_engine::Top;
use tremolite_engine::problem::Rayleigh;
use tremolite_motion::Complex64;

/// Largest shear strain at which ground is still taken so.
pub const MOST_STRAIN: f64 = 0.005;

/// A layer of soil.
#[derive(Clone, Debug, PartialEq)]
pub struct Soil {
    /// \[m\]
    pub thickness: f64,
    /// \[kg/m³\]
    pub density: f64,
    /// Of shear waves at small strains \[m/s\].
    pub speed: f64,
    pub curves: Curves,
}

/// The half-space below, undamped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rock {
    /// \[kg/m³\]
    pub density: f64,
    /// Of shear waves \[m/s\].
    pub speed: f64,
}

/// Where a motion is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Given {
    /// At the surface of the bare rock: twice the wave that comes up.
    Outcrop,
    /// At the surface of the soil.
    Surface,
}

/// How it is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Search {
    /// The effective strain over the largest.
    pub share: f64,
    /// No modulus and no damping ratio changes by more, as a share of itself.
    pub tolerance: f64,
    pub most_rounds: usize,
}

impl Default for Search {
    fn default() -> Self {
        Search { share: 0.65, tolerance: 1e-4, most_rounds: 100 }
    }
}

/// What a layer came to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached {
    /// Largest shear strain in its middle.
    pub strain: f64,
    /// G/G_max and damping ratio.
    pub modulus: f64,
    pub damping: f64,
}

/// The column that fits its own strains.
#[derive(Clone, Debug)]
pub struct Fitted {
    /// The rock, without a thickness, and the soil above it.
    pub column: LayeredColumn,
    /// Of the layers, from the surface down.
    pub layers: Vec<Reached>,
    /// Times that they were gone through.
    pub rounds: usize,
}

/// Why there is no such column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unfit {
    /// A layer, from the surface down from 0, is strained by more than [`MOST_STRAIN`].
    Strained { layer: usize, strain: f64 },
    /// Moduli still changed after all rounds, by this share in the last.
    Restless { change: f64 },
    /// There are no layers, or no motion.
    Nothing,
}

impl fmt::Display for Unfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unfit::Strained { layer, strain } => write!(
                f,
                "layer {} from the surface shears by {:.2} %, and ground is no linear column beyond {:.1} %: model it with a law that yields, or look \
                 whether the record or the velocity is meant so",
                layer + 1,
                100.0 * strain,
                100.0 * MOST_STRAIN
            ),
            Unfit::Restless { change } => write!(
                f,
                "no moduli fit their own strains: in the last round they still changed by {:.2} %; divide thick layers, or give more rounds",
                100.0 * change
            ),
            Unfit::Nothing => write!(f, "there are no layers, or nothing shakes them"),
        }
    }
}

/// Finds the column for layers from the surface down on a rock, under an acceleration \[m/s²\] every `dt` \[s\], at rest before.
///
/// # Errors
/// [`Unfit`].
pub fn fit(
    soils: &[Soil],
    rock: Rock,
    acceleration: &[f64],
    dt: f64,
    given: Given,
    search: Search,
) -> Result<Fitted, Unfit> {
    fit_together(soils, rock, &[acceleration], dt, given, search, &|_| 1.0)
}

/// The same under components that are given at once, along directions at right angles: the strain of a layer is the largest of what they
/// make together, whichever way the directions point. Of each frequency \[Hz\] the share `kept` counts.
///
/// # Errors
/// [`Unfit`].
pub fn fit_together(
    soils: &[Soil],
    rock: Rock,
    accelerations: &[&[f64]],
    dt: f64,
    given: Given,
    search: Search,
    kept: &(dyn Fn(f64) -> f64 + Sync),
) -> Result<Fitted, Unfit> {
    let plain = |thickness, density, speed| Layer {
        thickness,
        density,
        speed,
        band: None,
        rayleigh: Rayleigh::default(),
        damping: 0.0,
        water: None,
    };
    let ground = Ground {
        layers: soils.iter().map(|soil| plain(soil.thickness, soil.density, soil.speed)).collect(),
        curves: soils.iter().map(|soil| soil.curves.clone()).collect(),
        rock: plain(0.0, rock.density, rock.speed),
    };
    fit_ground(&ground, accelerations, dt, given, search, kept)
}

/// Layers with what else than their curves damps them.
#[derive(Clone, Debug)]
pub(crate) struct Ground {
    /// Of small strains, from the surface down.
    pub layers: Vec<Layer>,
    /// As many.
    pub curves: Vec<Curves>,
    /// The half-space below, of no thickness.
    pub rock: Layer,
}

/// The same for such layers.
///
/// # Errors
/// [`Unfit`].
pub(crate) fn fit_ground(
    ground: &Ground,
    accelerations: &[&[f64]],
    dt: f64,
    given: Given,
    search: Search,
    kept: &(dyn Fn(f64) -> f64 + Sync),
) -> Result<Fitted, Unfit> {
    let moving = accelerations.iter().filter(|along| along.iter().any(|a| *a != 0.0));
    let trains: Vec<Train> = moving
        .map(|along| {
            let sample = |t: f64| along.get((t / dt).round() as usize).copied().unwrap_or(0.0);
            Train::of(sample, dt, along.len() as f64 * dt)
        })
        .collect();
    let count = ground.layers.len();
    if count == 0 || trains.is_empty() {
        return Err(Unfit::Nothing);
    }
    let mut used: Vec<[f64; 2]> = ground.curves.iter().map(|curves| curves.at(0.0)).collect();
    for round in 1..=search.most_rounds {
        let column = ground.column(&used);
        let strains = strains(count, &column, &trains, given, kept);
        let next: Vec<[f64; 2]> = ground
            .curves
            .iter()
            .zip(&strains)
            .map(|(curves, strain)| curves.at(search.share * strain))
            .collect();
        let share = |(new, old): (&f64, &f64)| if new == old { 0.0 } else { (new - old).abs() / new.abs() };
        let change = next.iter().flatten().zip(used.iter().flatten()).map(share).fold(0.0, f64::max);
        if change <= search.tolerance {
            let of = |(strain, [modulus, damping]): (&f64, &[f64; 2])| Reached {
                strain: *strain,
                modulus: *modulus,
                damping: *damping,
            };
            let layers: Vec<Reached> = strains.iter().zip(&used).map(of).collect();
            let worst = layers.iter().enumerate().max_by(|a, b| a.1.strain.total_cmp(&b.1.strain));
            return match worst {
                Some((layer, reached)) if reached.strain.is_nan() || reached.strain > MOST_STRAIN => {
                    Err(Unfit::Strained { layer, strain: reached.strain })
                }
                _ => Ok(Fitted { column, layers, rounds: round }),
            };
        }
        if round == search.most_rounds {
            return Err(Unfit::Restless { change });
        }
        used = next;
    }
    Err(Unfit::Restless { change: f64::INFINITY })
}

impl Ground {
    /// The column with moduli and damping ratios. Rayleigh's damping goes by the modulus of small strains, as it does in a model.
    fn column(&self, used: &[[f64; 2]]) -> LayeredColumn {
        let soft = |(layer, [modulus, damping]): (&Layer, &[f64; 2])| Layer {
            speed: layer.speed * modulus.sqrt(),
            damping: *damping,
            rayleigh: Rayleigh { stiffness: layer.rayleigh.stiffness / modulus, ..layer.rayleigh },
            ..*layer
        };
        let layers = std::iter::once(self.rock).chain(self.layers.iter().zip(used).rev().map(soft)).collect();
        LayeredColumn::of_all(layers, Top::Free)
    }
}

/// The largest shear strain in the middle of each layer, from the surface down.
fn strains(
    soils: usize,
    column: &LayeredColumn,
    trains: &[Train],
    given: Given,
    kept: &(dyn Fn(f64) -> f64 + Sync),
) -> Vec<f64> {
    // The waves of a frequency serve all layers. Trains are as long as each other.
    let all = trains[0].frequencies(|s| {
        let share = kept(s.im / TAU);
        if share == 0.0 {
            return vec![Complex64::default(); soils];
        }
        let [factors, slopes] = column.factors_and_slopes(s);
        let given = match given {
            Given::Outcrop => Complex64::from(2.0),
            Given::Surface => factors[soils + 1],
        };
        let of = |layer: usize| share * slopes[layer] / (given * s * s);
        (1..=soils).rev().map(of).collect::<Vec<Complex64>>()
    });
    let largest = |layer: usize| {
        let strains: Vec<Vec<f64>> =
            trains.iter().map(|train| train.through_each(|k| all[k][layer])).collect();
        let square = |k: usize| strains.iter().map(|strain| strain[k] * strain[k]).sum::<f64>();
        (0..strains[0].len()).map(square).fold(0.0, f64::max).sqrt()
    };
    (0..soils).into_par_iter().map(largest).collect()
}

/// The acceleration \[m/s²\] at the surface under one that is given, as long as that and a sample or two.
pub fn at_surface(fitted: &Fitted, acceleration: &[f64], dt: f64, given: Given) -> Vec<f64> {
    let sample = |t: f64| acceleration.get((t / dt).round() as usize).copied().unwrap_or(0.0);
    let train = Train::of(sample, dt, acceleration.len() as f64 * dt);
    match given {
        Given::Surface => acceleration.to_vec(),
        Given::Outcrop => {
            let top = fitted.layers.len() + 1;
            train.through(&|s| 0.5 * fitted.column.factors_and_slopes(s)[0][top])
        }
    }
}

/// The acceleration \[m/s²\] at the surface of the bare rock, where one is given at the surface of the soil.
pub fn at_outcrop(fitted: &Fitted, acceleration: &[f64], dt: f64) -> Vec<f64> {
    let sample = |t: f64| acceleration.get((t / dt).round() as usize).copied().unwrap_or(0.0);
    let train = Train::of(sample, dt, acceleration.len() as f64 * dt);
    let top = fitted.layers.len() + 1;
    train.through(&|s| 2.0 / fitted.column.factors_and_slopes(s)[0][top])
}

#[cfg(test)]
mod tests;
