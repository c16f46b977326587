//! Butterworth filters of fourth order, run forwards and backwards.
//!
//! Design (analogue prototype, band transformation, bilinear transformation with pre-warped corners) and
//! application (second-order sections, odd extension at both ends, steady-state initial values) follow the
//! textbook route that SciPy's `butter(4, …, output="sos")` and `sosfiltfilt` take, so the two agree to
//! round-off. Forwards and backwards, the phase is zero and the gain is the square of the filter's: a half at
//! the corners. A band-pass of this order has eight poles.

use std::f64::consts::PI;

use realfft::num_complex::Complex64;

/// What a filter lets through; corners (Hz).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Band {
    /// Everything above the corner.
    High(f64),
    /// Everything below the corner.
    Low(f64),
    /// Everything between two corners.
    Pass(f64, f64),
}

/// A second-order section, H(z) = (b0 + b1 z⁻¹ + b2 z⁻²)/(1 + a1 z⁻¹ + a2 z⁻²).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    pub b: [f64; 3],
    /// a1, a2; a0 is 1.
    pub a: [f64; 2],
}

/// A fourth-order Butterworth filter for one sampling interval.
#[derive(Debug, Clone, PartialEq)]
pub struct Filter {
    sections: Vec<Section>,
}

/// Order of the low-pass prototype.
const ORDER: usize = 4;

impl Filter {
    /// Designs the filter for samples `dt` (s) apart.
    ///
    /// # Errors
    /// A sentence (problem and way out) if a corner is not above 0, not below the Nyquist frequency 1/(2 dt),
    /// or the lower corner is not below the upper one.
    pub fn design(band: Band, dt: f64) -> Result<Filter, [String; 2]> {
        let nyquist = 0.5 / dt;
        let (low, high) = match band {
            Band::High(f) | Band::Low(f) => (f, f),
            Band::Pass(low, high) => (low, high),
        };
        // Negated comparisons, so that NaN is refused as well.
        if !(low > 0.0) {
            return Err([format!("the corner {low} Hz is not above 0"), "give a positive frequency".into()]);
        }
        if !(high < nyquist) {
            return Err([
                format!(
                    "the corner {high} Hz is not below the Nyquist frequency {nyquist} Hz of this record"
                ),
                "lower the corner, or leave the filter out: the record holds nothing above".into(),
            ]);
        }
        if matches!(band, Band::Pass(..)) && !(low < high) {
            return Err([
                format!("the lower corner {low} Hz is not below the upper one, {high} Hz"),
                "give the lower corner first".into(),
            ]);
        }

        // With the sampling rate scaled to 2 the bilinear transformation is z = (4 + s)/(4 − s).
        let warp = |f: f64| 4.0 * (PI * f * dt).tan();
        let (w_low, w_high) = (warp(low), warp(high));
        // Poles of the prototype in the upper left quarter; their conjugates are implied throughout.
        let prototype = (0..ORDER / 2)
            .map(|k| Complex64::from_polar(1.0, PI * (0.5 + (2 * k + 1) as f64 / (2 * ORDER) as f64)));
        // Each pole in s, and the zeros of the section it becomes: −1 (at the Nyquist frequency) and +1 (at 0).
        let mut poles: Vec<Complex64> = Vec::new();
        for p in prototype {
            match band {
                Band::Low(_) => poles.push(p * w_low),
                Band::High(_) => poles.push(w_low / p),
                Band::Pass(..) => {
                    let middle = p * (0.5 * (w_high - w_low));
                    let root = (middle * middle - w_low * w_high).sqrt();
                    poles.extend([middle + root, middle - root]);
                }
            }
        }
        let mut poles: Vec<Complex64> = poles
            .into_iter()
            .map(|s| {
                let z = (4.0 + s) / (4.0 - s);
                if z.im < 0.0 { z.conj() } else { z }
            })
            .collect();
        // Poles farthest from the unit circle come first, as the partial results then stay small.
        poles.sort_by(|p, q| p.norm().total_cmp(&q.norm()));

        let count = poles.len();
        let mut sections: Vec<Section> = poles
            .iter()
            .enumerate()
            .map(|(i, p)| {
                let at_zero_frequency = match band {
                    Band::Low(_) => false,
                    Band::High(_) => true,
                    // The poles nearest the unit circle belong to the lower corner of a wide band.
                    Band::Pass(..) => i >= count / 2,
                };
                let b1 = if at_zero_frequency { -2.0 } else { 2.0 };
                Section { b: [1.0, b1, 1.0], a: [-2.0 * p.re, p.norm_sqr()] }
            })
            .collect();
        // Unit gain in the pass band: at frequency 0, at Nyquist, or at the (warped) geometric centre.
        let probe = match band {
            Band::Low(_) => 0.0,
            Band::High(_) => PI,
            Band::Pass(..) => 2.0 * ((w_low * w_high).sqrt() / 4.0).atan(),
        };
        let gain = gain(&sections, probe);
        for b in &mut sections[0].b {
            *b /= gain;
        }
        Ok(Filter { sections })
    }

    /// The sections, in the order they are applied.
    pub fn sections(&self) -> &[Section] {
        &self.sections
    }

    /// How many samples are added at each end before filtering; a record must be longer than this.
    ///
    /// SciPy's default for sections without zeros or poles at the origin: 3 (2 n + 1).
    pub fn padding(&self) -> usize {
        3 * (2 * self.sections.len() + 1)
    }

    /// The gain of one pass at `frequency` (Hz) for samples `dt` (s) apart. [`Filter::zero_phase`] has its
    /// square.
    pub fn gain(&self, frequency: f64, dt: f64) -> f64 {
        gain(&self.sections, 2.0 * PI * frequency * dt)
    }

    /// Filters forwards and backwards. `None` if there are not more samples than [`Filter::padding`].
    pub fn zero_phase(&self, samples: &[f64]) -> Option<Vec<f64>> {
        let pad = self.padding();
        let (&first, &last) = (samples.first()?, samples.last()?);
        if samples.len() <= pad {
            return None;
        }
        // The ends turned by 180° about the end samples: value and slope go on.
        let before = samples[1..=pad].iter().rev().map(|x| 2.0 * first - x);
        let after = samples[samples.len() - 1 - pad..samples.len() - 1].iter().rev().map(|x| 2.0 * last - x);
        let mut signal: Vec<f64> = before.chain(samples.iter().copied()).chain(after).collect();
        for _ in 0..2 {
            self.pass(&mut signal);
            signal.reverse();
        }
        signal.truncate(pad + samples.len());
        signal.drain(..pad);
        Some(signal)
    }

    /// One pass in place, starting as if the first sample had lasted for ever.
    fn pass(&self, signal: &mut [f64]) {
        let mut level = signal.first().copied().unwrap_or(0.0);
        for Section { b, a } in &self.sections {
            let steady = (b[0] + b[1] + b[2]) / (1.0 + a[0] + a[1]) * level;
            let mut z2 = b[2] * level - a[1] * steady;
            let mut z1 = b[1] * level - a[0] * steady + z2;
            level = steady;
            for x in signal.iter_mut() {
                let y = b[0] * *x + z1;
                z1 = b[1] * *x - a[0] * y + z2;
                z2 = b[2] * *x - a[1] * y;
                *x = y;
            }
        }
    }
}

/// |H| at the angle `omega` (rad per sample).
fn gain(sections: &[Section], omega: f64) -> f64 {
    let z1 = Complex64::from_polar(1.0, -omega);
    sections
        .iter()
        .map(|Section { b, a }| ((b[0] + z1 * (b[1] + z1 * b[2])) / (1.0 + z1 * (a[0] + z1 * a[1]))).norm())
        .product()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sections printed by SciPy 1.17.1, `butter(4, [low, high], "bandpass", fs=1/dt, output="sos")`.
    #[test]
    fn scipy_bandpass_sections() {
        let tables: [(f64, f64, [[f64; 6]; 4]); 2] = [
            (
                0.005,
                25.0,
                [
                    [
                        0.010074711563580625,
                        0.02014942312716125,
                        0.010074711563580625,
                        1.0,
                        -0.8612601865766453,
                        0.2124576241490435,
                    ],
                    [1.0, 2.0, 1.0, 1.0, -1.1156144461140851, 0.5764944733903803],
                    [1.0, -2.0, 1.0, 1.0, -1.9941708664173785, 0.9941808360892663],
                    [1.0, -2.0, 1.0, 1.0, -1.9976014532622373, 0.9976113327346235],
                ],
            ),
            (
                0.02,
                22.5,
                [
                    [
                        0.651071596394192,
                        1.302143192788384,
                        0.651071596394192,
                        1.0,
                        1.4789858168048484,
                        0.5553637499583566,
                    ],
                    [1.0, 2.0, 1.0, 1.0, 1.7011706858832476, 0.7887689155065556],
                    [1.0, -2.0, 1.0, 1.0, -1.976858864519787, 0.9770154932017843],
                    [1.0, -2.0, 1.0, 1.0, -1.9902845693111495, 0.9904418175840579],
                ],
            ),
        ];
        for (dt, high, table) in tables {
            let filter = Filter::design(Band::Pass(0.1, high), dt).unwrap();
            assert_eq!(filter.padding(), 27);
            for (section, row) in filter.sections().iter().zip(table) {
                let ours = [section.b[0], section.b[1], section.b[2], 1.0, section.a[0], section.a[1]];
                for (x, y) in ours.iter().zip(row) {
                    // Round-off of the poles, which lie as near as 0.001 to the unit circle.
                    assert!((x - y).abs() < 2e-12, "{ours:?} against {row:?}");
                }
            }
        }
    }

    #[test]
    fn gain_is_one_in_the_band_and_one_over_root_two_at_the_corners() {
        let dt = 0.01;
        let root = std::f64::consts::FRAC_1_SQRT_2;
        for (band, corners, inside) in [
            (Band::Low(10.0), vec![10.0], 0.0),
            (Band::High(2.0), vec![2.0], 50.0),
            (Band::Pass(2.0, 10.0), vec![2.0, 10.0], 4.0),
            (Band::Pass(0.05, 45.0), vec![0.05, 45.0], 4.0),
        ] {
            let filter = Filter::design(band, dt).unwrap();
            for corner in corners {
                assert!((filter.gain(corner, dt) - root).abs() < 1e-10, "{band:?} at {corner}");
            }
            assert!((filter.gain(inside, dt) - 1.0).abs() < 5e-3, "{band:?} inside");
        }
        // Maximally flat: |H|² = 1/(1 + (w/wc)^8) in the warped frequency w = tan(π f dt).
        let filter = Filter::design(Band::Low(10.0), dt).unwrap();
        let ratio = (PI * 20.0 * dt).tan() / (PI * 10.0 * dt).tan();
        assert!((filter.gain(20.0, dt) - (1.0 + ratio.powi(8)).sqrt().recip()).abs() < 1e-13);
    }

    #[test]
    fn a_constant_passes_a_lowpass_unchanged_and_a_highpass_not_at_all() {
        let samples = vec![3.0; 100];
        let low = Filter::design(Band::Low(5.0), 0.01).unwrap();
        assert_eq!(low.padding(), 15);
        let low = low.zero_phase(&samples).unwrap();
        let high = Filter::design(Band::High(5.0), 0.01).unwrap().zero_phase(&samples).unwrap();
        assert!(low.iter().all(|y| (y - 3.0).abs() < 1e-11));
        assert!(high.iter().all(|y| y.abs() < 1e-11));
    }

    #[test]
    fn zero_phase_keeps_a_symmetric_pulse_symmetric_in_its_place() {
        let samples: Vec<f64> = (0..2001).map(|i| (-(f64::from(i) - 1000.0).powi(2) / 200.0).exp()).collect();
        let out = Filter::design(Band::Pass(2.0, 10.0), 0.01).unwrap().zero_phase(&samples).unwrap();
        // The slowest pole decays with 2π · 2 Hz · cos 67.5° = 4.8 per s: nothing of the ends is left 10 s away.
        for k in 1..=300 {
            assert!((out[1000 - k] - out[1000 + k]).abs() < 1e-12 * out[1000], "{k}");
        }
    }

    #[test]
    fn corners_out_of_range_and_short_records_are_refused() {
        for band in [
            Band::Low(50.0),
            Band::High(0.0),
            Band::High(-1.0),
            Band::Pass(5.0, 5.0),
            Band::Pass(6.0, 5.0),
            Band::Pass(0.1, 60.0),
            Band::Low(f64::NAN),
            Band::Pass(f64::NAN, 5.0),
        ] {
            assert!(Filter::design(band, 0.01).is_err(), "{band:?}");
        }
        let filter = Filter::design(Band::Pass(0.1, 5.0), 0.01).unwrap();
        assert!(filter.zero_phase(&[1.0; 27]).is_none() && filter.zero_phase(&[]).is_none());
        assert!(filter.zero_phase(&[1.0; 28]).is_some());
    }
}
