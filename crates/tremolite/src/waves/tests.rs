//! What several tests of waves share: ground, a wave, a box.

mod field;
mod ground;
mod prepared;

use super::field::{Entering, Frame};
use super::ground::LayeredGround;
use super::heading::{Heading, WaveType};
use super::rock::{Rock, Stratum};
use std::sync::Arc;
use tremolite_engine::Top;
use tremolite_engine::problem::Rayleigh;
use tremolite_laws::band::Band;
use tremolite_motion::{Complex64, Motion, Sample};

/// ν = 0.3: at 0.25 several angles are special.
fn rock(density: f64, s: f64) -> Rock {
    Rock { density, s, p: s * 3.5_f64.sqrt(), band: None, rayleigh: Rayleigh::default(), water: None }
}

fn stratum(thickness: f64, density: f64, s: f64) -> Stratum {
    Stratum { thickness, rock: rock(density, s) }
}

fn uniform(top: Top) -> LayeredGround {
    LayeredGround::new([stratum(60.0, 2600.0, 2000.0)], top).unwrap()
}

/// Three layers with all kinds of damping.
fn layered() -> Vec<Stratum> {
    let rayleigh = Rayleigh { mass: 0.4, stiffness: 2e-4 };
    let band = Band::fit(0.02, [0.5, 20.0], 3.0).ok();
    let damped = |mut stratum: Stratum, band| {
        stratum.rock = Rock { rayleigh, band, ..stratum.rock };
        stratum
    };
    vec![
        damped(stratum(40.0, 2700.0, 2400.0), band),
        damped(stratum(25.0, 2500.0, 1500.0), None),
        damped(stratum(12.0, 2100.0, 600.0), band),
    ]
}

const EVERY: [(WaveType, f64); 10] = [
    (WaveType::P, 0.0),
    (WaveType::P, 20.0),
    (WaveType::P, 50.0),
    (WaveType::Sv, 0.0),
    (WaveType::Sv, 15.0),
    (WaveType::Sv, 25.0),
    (WaveType::Sv, 40.0),
    (WaveType::Sv, 55.0),
    (WaveType::Sh, 30.0),
    (WaveType::Sh, 60.0),
];

const START: f64 = 0.3;
const RISE: f64 = 0.2;

/// u rises from 0 to 1 m over [`RISE`], once it has [started](START).
fn step_up() -> Motion {
    Motion::sampled(0.002, 2.0, |t| {
        let x = ((t - START) / RISE).clamp(0.0, 1.0);
        let u = x.powi(4) * (35.0 - 84.0 * x + 70.0 * x * x - 20.0 * x * x * x);
        let v = 140.0 * (x * (1.0 - x)).powi(3) / RISE;
        let a = 420.0 * (x * (1.0 - x)).powi(2) * (1.0 - 2.0 * x) / (RISE * RISE);
        Sample { a: [a; 3], v: [v; 3], u: [u; 3] }
    })
    .unwrap()
}

const SIZE: [f64; 3] = [80.0, 50.0, 60.0];

fn frame(ground: LayeredGround) -> Frame {
    let low = [10.0, -20.0, -100.0];
    let high = [0, 1, 2].map(|i| low[i] + SIZE[i]);
    Frame {
        ground,
        bounds: [low, high],
        at: [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])],
        frequency: 25.0,
        duration: Some(2.0),
    }
}

fn entering(heading: Heading, motion: Motion) -> Entering {
    Entering::of(heading, Arc::new(motion), 0, Complex64::from(1.0))
}
