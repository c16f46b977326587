//! Deconvolution: from a motion that was recorded on or within layered ground to the wave that comes up into the layers.
//!
//! A vertical wave v_i at the base of a column moves the place of the record by H v_i, H the column's transfer function there
//! ([`LayeredColumn::factor_at`]); so v_i is the record over H, at each frequency (`kramer1996`, section 7.2.1; the layers are
//! linear). The record is late by the way of a wave from the base to its place, so it is put off by a **lead** of at least that
//! way, and the incident wave begins at 0.
//!
//! Within the ground H has notches, where the wave that comes back from the surface meets the one that goes up in opposite phase:
//! nothing moves there however strong the wave is, and a record says nothing of it. Damping makes H small at high frequencies as
//! well. Where H falls below [`LEAST`] of its static value nothing is deconvolved: a record with such frequencies in its band is
//! refused, and what it has above its band fades out before the first of them.
//!
//! As in [`LayeredColumn`], frequencies lie beside the imaginary axis, so that an undamped column that rings on does not come
//! round again.

use crate::layered_column::LayeredColumn;
use std::f64::consts::{PI, TAU};
use tremolite_motion::{Complex64, transferred};

/// The least share of its static value at which a transfer is inverted.
pub const LEAST: f64 = 0.05;
/// Parts of the frequency where the transfer falls below [`LEAST`] between which what is above the band fades out, at the lowest
/// and at the highest.
const FADE: [f64; 2] = [0.8, 0.9];
/// Times the record's length that is transformed, and what is left at their end of what rings.
const SPANS: usize = 4;
const LEFT: f64 = 1e-6;
/// Steps in which a transfer is looked at over the lowest frequency of the column, c/4h.
const LOOKS: f64 = 40.0;

/// A place in layered ground as waves along x, y and z see it.
#[derive(Clone, Debug)]
pub struct Place {
    pub columns: [LayeredColumn; 3],
    /// Above the base of the columns \[m\].
    pub height: f64,
}

/// Where a transfer is too small to be inverted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Notch {
    /// The lowest frequency at which it is below [`LEAST`] \[Hz\].
    pub from: f64,
    /// The frequency of its least value near there \[Hz\], and that as a share of the static value.
    pub at: f64,
    pub share: f64,
}

/// The motion that a record makes at the base, and how.
#[derive(Clone, Debug, Default)]
pub struct Deconvolved {
    /// Acceleration of the incident wave \[m/s²\].
    pub incident: Vec<f64>,
    /// Up to which frequency it is the record's \[Hz\]; infinite where nothing was left out.
    pub reach: f64,
    /// The share of ∫a² dt of the record that was left out above.
    pub left_out: f64,
}

impl Place {
    /// The record's motion over that of the incident wave, at a frequency \[Hz\].
    pub fn transfer(&self, axis: usize, hertz: f64) -> Complex64 {
        self.columns[axis].factor_at(Complex64::new(0.0, TAU * hertz), self.height)
    }

    /// At rest, where undamped ground moves with its base.
    pub fn at_rest(&self, axis: usize) -> f64 {
        self.transfer(axis, 1e-6).norm()
    }

    /// By how much a record is put off \[s\]: the longest way of a wave to it, in whole steps.
    pub fn lead(&self, dt: f64) -> usize {
        let longest = self.columns.iter().map(|column| column.travel(self.height)).fold(0.0, f64::max);
        (longest / dt - 1e-6).ceil().max(0.0) as usize
    }

    /// Frequencies \[Hz\] that show all of a transfer up to one of them.
    pub fn frequencies(&self, axis: usize, most: f64) -> Vec<f64> {
        let column = &self.columns[axis];
        let step = 0.25 / column.travel(column.height()).max(1e-3) / LOOKS;
        let count = (most / step).ceil().clamp(1.0, 1e6) as usize;
        (1..=count).map(|k| k as f64 / count as f64 * most).collect()
    }

    /// Where the transfer along an axis first falls below [`LEAST`] of its static value, up to a frequency \[Hz\].
    pub fn notch(&self, axis: usize, most: f64) -> Option<Notch> {
        let rest = self.at_rest(axis);
        let share = |hertz: f64| self.transfer(axis, hertz).norm() / rest;
        let frequencies = self.frequencies(axis, most);
        let low = |hertz: &f64| {
            let share = share(*hertz);
            share < LEAST || share.is_nan()
        };
        let first = frequencies.iter().position(low)?;
        // The edge and the least value, finer than the looks.
        let (mut above, mut below) =
            (if first == 0 { 0.0 } else { frequencies[first - 1] }, frequencies[first]);
        for _ in 0..40 {
            let middle = 0.5 * (above + below);
            if low(&middle) { below = middle } else { above = middle }
        }
        let dip: Vec<f64> = frequencies[first..].iter().copied().take_while(low).collect();
        let coarse = dip.iter().copied().min_by(|a, b| share(*a).total_cmp(&share(*b))).unwrap_or(below);
        let step = frequencies[0];
        let near =
            (-50..=50).map(|k| coarse + f64::from(k) / 50.0 * step).filter(|f| *f >= below && *f <= most);
        let at = near.min_by(|a, b| share(*a).total_cmp(&share(*b))).unwrap_or(below);
        Some(Notch { from: below, at, share: share(at) })
    }

    /// The incident wave along an axis of a record that is sampled every `dt` \[s\], put off by [`Place::lead`]: as long as that
    /// and the record. `band` is the frequency up to which the record is wanted \[Hz\].
    ///
    /// Exact for the samples to about 10⁻⁶ of the peak where nothing is left out.
    ///
    /// # Errors
    /// The notch, where the transfer cannot be inverted within the band.
    pub fn deconvolved(
        &self,
        axis: usize,
        acceleration: &[f64],
        dt: f64,
        band: f64,
    ) -> Result<Deconvolved, Notch> {
        let lead = self.lead(dt);
        let wanted = lead + acceleration.len();
        if acceleration.iter().all(|a| *a == 0.0) {
            return Ok(Deconvolved { incident: vec![0.0; wanted], reach: f64::INFINITY, left_out: 0.0 });
        }
        let notch = self.notch(axis, 0.5 / dt);
        if let Some(notch) = notch.filter(|notch| notch.from <= band) {
            return Err(notch);
        }
        // What is let through of a frequency.
        let [reach, end] = notch.map_or([f64::INFINITY; 2], |notch| {
            [band.clamp(FADE[0] * notch.from, FADE[1] * notch.from), notch.from]
        });
        let kept = |hertz: f64| match hertz {
            _ if hertz <= reach => 1.0,
            _ if hertz >= end => 0.0,
            _ => (0.5 * PI * (hertz - reach) / (end - reach)).cos().powi(2),
        };
        let mut late = vec![0.0; lead];
        late.extend(acceleration);
        late.resize((SPANS * wanted).next_power_of_two(), 0.0);
        let left_out = if notch.is_none() {
            0.0
        } else {
            let through = transferred(&late, dt, &|omega| kept(omega / TAU).into());
            let lost: f64 = late.iter().zip(&through).map(|(a, b)| (a - b).powi(2)).sum();
            lost / late.iter().map(|a| a * a).sum::<f64>()
        };
        let eta = -LEFT.ln() / (late.len() as f64 * dt);
        let growth = |k: usize| (eta * k as f64 * dt).exp();
        late.iter_mut().enumerate().for_each(|(k, a)| *a /= growth(k));
        let column = &self.columns[axis];
        let mut incident = transferred(&late, dt, &|omega| match kept(omega / TAU) {
            0.0 => Complex64::default(),
            kept => kept / column.factor_at(Complex64::new(eta, omega), self.height),
        });
        incident.truncate(wanted);
        incident.iter_mut().enumerate().for_each(|(k, a)| *a *= growth(k));
        Ok(Deconvolved { incident, reach, left_out })
    }
}

#[cfg(test)]
mod tests;
