//! What each level of the ground does in time under one wave.
//!
//! Displacement and stress are kept as series at levels at most 1/20 of the shortest shear wave apart and 1/20 of the shortest
//! period, with their slopes in both directions, and found between them by cubics in both (Hermite): at 20 points a wave those err
//! by (2π/20)⁴/384 = 3·10⁻⁵ of it.
//!
//! **Nothing arrives.** Where all waves of all layers travel, the field is at rest before the wave comes, and frequencies lie
//! beside the imaginary axis as in [`crate::layered_column`], so that however long the ground rings nothing of it comes round
//! again. Beyond a critical angle the field has no beginning: what runs along faster than p came from far away. Then the frequencies are
//! real, the span is doubled until hardly anything is left at its ends, and the series are faded in where no level moves faster
//! than 10⁻⁴ of the largest velocity, or later and slowly.

use super::answered::{Answered, KEPT, Kept, Signal, Stretch, components};
use super::grid::{FINE, Grid, hermite};
use super::ground::LayeredGround;
use super::heading::{Heading, WaveType};

/// Smallest e^(−ηT), as in [`crate::layered_column`].
const LEFT: f64 = 1e-8;
/// Velocity over the largest below which nothing counts as moving, where nothing arrives.
const STILL: f64 = 1e-4;
/// Samples of a span at most.
const LONGEST: usize = 1 << 22;
/// p c from which a wave of speed c counts as beyond critical, a little before it is.
const CRITICAL: f64 = 0.9999;

/// Series of one wave at all levels.
pub struct Series {
    grid: Grid,
    /// Between samples, and of the first one \[s\].
    dt: f64,
    pub start: f64,
    samples: usize,
    /// Components of displacement and of stress.
    moved: Vec<f32>,
    pulled: Vec<f32>,
    /// Largest velocity at any level \[m/s\].
    pub peak: f64,
}

/// Why there are no series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rings {
    /// Velocity at the ends of the span \[s\] over the largest.
    pub left: f64,
    pub span: f64,
}

/// Bytes of series at so many levels for so long \[s\].
pub fn bytes(kind: WaveType, levels: usize, until: f64, frequency: f64) -> f64 {
    let [moved, pulled] = components(kind);
    (levels * (moved + pulled) * KEPT * 4) as f64 * until * FINE * frequency
}

/// Whether all waves travel in all layers, so that nothing moves before the wave comes.
pub fn arrives(ground: &LayeredGround, heading: &Heading) -> bool {
    let p = heading.slowness(&ground.below());
    let pressure = heading.kind != WaveType::Sh;
    let below = ground.below();
    let rocks = ground.strata().iter().map(|stratum| stratum.rock).chain([below]);
    rocks.map(|rock| p * rock.fastest(pressure)).fold(0.0, f64::max) < CRITICAL
}

impl Series {
    /// Of a wave in ground.
    ///
    /// # Errors
    /// If nothing arrives, and the ground rings longer than any span.
    pub fn of(ground: &LayeredGround, heading: &Heading, signal: &Signal) -> Result<Series, Rings> {
        let grid = Grid::new(ground, signal.frequency);
        let dt = 1.0 / (FINE * signal.frequency);
        let wanted = (signal.until / dt).ceil() as usize + 2;
        let mut count = (2 * wanted).next_power_of_two();
        // What is turned in phase begins before its cause, as what runs ahead does.
        if arrives(ground, heading) && signal.turned.is_none() {
            let eta = -LEFT.ln() / (count as f64 * dt);
            let answers = Answered::of(ground, heading, signal, dt, count, 0, eta);
            let scan = answers.scan(&grid);
            let peak = scan.velocity[..wanted].iter().copied().fold(0.0, f64::max);
            let stretch = Stretch { first: 0, wanted, fade: 0 };
            return Ok(Series::new(answers.keep(&grid, &stretch), grid, dt, wanted, peak));
        }
        loop {
            count *= 2;
            let zero = count / 2;
            let answers = Answered::of(ground, heading, signal, dt, count, zero, 0.0);
            let scan = answers.scan(&grid);
            let end = zero + wanted;
            let peak = scan.velocity[..end].iter().copied().fold(0.0, f64::max);
            let still =
                |from: usize, to: usize| scan.velocity[from..to].iter().copied().fold(0.0, f64::max) / peak;
            let left = still(0, count / 16).max(still(count - count / 16, count));
            // In which a shear wave goes through the ground \[s\].
            let across = ground.strata().iter().map(|l| l.thickness / l.rock.s).sum();
            if left < STILL
                && let Some((start, fade)) = scan.beginning(end, dt, across)
            {
                let first = start - fade;
                let stretch = Stretch { first, wanted: end - first, fade };
                return Ok(Series::new(answers.keep(&grid, &stretch), grid, dt, end - first, peak));
            }
            if count >= LONGEST {
                return Err(Rings { left, span: count as f64 * dt });
            }
        }
    }

    fn new(kept: Kept, grid: Grid, dt: f64, samples: usize, peak: f64) -> Series {
        let Kept { moved, pulled, start } = kept;
        Series { grid, dt, start, samples, moved, pulled, peak }
    }

    /// The sample before a place, and how far behind it that is; none before the first.
    fn sample(&self, place: f64) -> Option<(usize, f64)> {
        if place.is_nan() || place <= 0.0 {
            return None;
        }
        let index = (place as usize).min(self.samples - 2);
        Some((index, (place - index as f64).min(1.0)))
    }

    /// Components of displacement \[m\] at a height \[m\] above the base, `place` samples after the first: (u_h, u_z), or u_t alone; the rest
    /// is nothing.
    pub fn displacement_of(&self, height: f64, place: f64) -> [f64; 4] {
        self.between(&self.moved, height, place)
    }

    /// Components of stress \[Pa\]: (σ_hh, σ_tt, σ_zz, σ_hz), or (σ_ht, σ_tz); the rest is nothing.
    pub fn stress_of(&self, height: f64, place: f64) -> [f64; 4] {
        self.between(&self.pulled, height, place)
    }

    fn between(&self, kept: &[f32], height: f64, place: f64) -> [f64; 4] {
        let mut out = [0.0; 4];
        let Some((sample, x)) = self.sample(place) else { return out };
        let (level, cell, y) = self.grid.cell(height);
        let [t0, t1] = hermite(x);
        let [z0, z1] = hermite(y).map(|[value, slope]| [value, slope * cell]);
        let row = kept.len() / (self.grid.count() * self.samples);
        for (level, z) in [(level, z0), (level + 1, z1)] {
            let [value, slope] = z;
            let at = (level * self.samples + sample) * row;
            for (t, kept) in [(t0, &kept[at..at + row]), (t1, &kept[at + row..at + 2 * row])] {
                for (out, k) in out.iter_mut().zip(kept.chunks_exact(KEPT)) {
                    let [f, ft, fz, ftz] = [0, 1, 2, 3].map(|i| f64::from(k[i]));
                    *out += t[0] * (value * f + slope * fz) + t[1] * (value * ft + slope * ftz);
                }
            }
        }
        out
    }

    /// Between samples \[s\].
    pub fn dt(&self) -> f64 {
        self.dt
    }

    /// How many there are.
    pub fn samples(&self) -> usize {
        self.samples
    }

    /// Adds to a sum, sample by sample, the components of displacement, or of stress, at a height \[m\] above the base, times what one of each
    /// makes of a vector; and then their slopes in time times the interval.
    pub fn add(&self, height: f64, stresses: bool, of: &[[f64; 4]; 4], sum: &mut [[[f64; 4]; 2]]) {
        let kept = if stresses { &self.pulled } else { &self.moved };
        let (level, cell, y) = self.grid.cell(height);
        let [z0, z1] = hermite(y).map(|[value, slope]| [value, slope * cell]);
        let row = kept.len() / (self.grid.count() * self.samples);
        let at = |level: usize| {
            kept[level * self.samples * row..(level + 1) * self.samples * row].chunks_exact(row)
        };
        for ((sum, below), above) in sum.iter_mut().zip(at(level)).zip(at(level + 1)) {
            for ((below, above), of) in below.chunks_exact(KEPT).zip(above.chunks_exact(KEPT)).zip(of) {
                let (a, b) = (|i: usize| f64::from(below[i]), |i: usize| f64::from(above[i]));
                for i in 0..2 {
                    let x = z0[0] * a(i) + z0[1] * a(i + 2) + z1[0] * b(i) + z1[1] * b(i + 2);
                    for c in 0..4 {
                        sum[i][c] += x * of[c];
                    }
                }
            }
        }
    }

    /// What it takes of memory.
    pub fn bytes(&self) -> usize {
        4 * (self.moved.len() + self.pulled.len())
    }
}
