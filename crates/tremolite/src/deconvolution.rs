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
//! What fades in frequency rings in time, before its cause as after it; so where something fades out the lead has room for that as
//! well, or the wave would begin with a velocity and drift.
//!
//! As in [`LayeredColumn`], frequencies lie beside the imaginary axis, so that an undamped column that rings on does not come
//! round again.

use crate::layered_column::LayeredColumn;
use std::f64::consts::{PI, TAU};
use tremolite_motion::{Complex64, transferred};

/// The least share of its static value at which a transfer is inverted.
pub const LEAST: f64 = 0.05;
/// Parts of the frequency where the transfer falls below [`LEAST`] at which what is above the band begins to fade out, at the lowest
/// and at the highest: a band that reaches higher is refused, since nothing can be faded out in no room.
const FADE: [f64; 2] = [0.8, 0.95];
/// Room for what rings before its cause, over one by the width of the fade, and at most \[s\]. The fade's ringing falls with the
/// third power of time.
const ROOM: f64 = 2.0;
const MOST_ROOM: f64 = 5.0;
/// Times the record's length that is transformed, and what is left at their end of what rings.
const SPANS: usize = 8;
const LEFT: f64 = 1e-4;
/// Steps by which the place of a dip is narrowed down, each by 0.62.
const GOLDEN: u32 = 60;
/// What is less than this part of its neighbours is lower.
const FLAT: f64 = 1.0 - 1e-9;
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

/// The wave that a record makes at the base, and how.
#[derive(Clone, Debug)]
pub struct Deconvolved {
    /// Acceleration of the incident wave along x, y, z \[m/s²\]: as long as the record and the lead.
    pub incident: [Vec<f64>; 3],
    /// By how many samples the record is put off.
    pub lead: usize,
    /// Up to which frequency the wave is the record's \[Hz\]; infinite where nothing was left out.
    pub reach: f64,
    /// The largest share of ∫a² dt of a component that was left out above.
    pub left_out: f64,
}

/// What is let through of a record in frequency \[Hz\]: all up to `reach`, nothing from `end` on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// Infinite where all is let through, as is the other.
    pub reach: f64,
    pub end: f64,
}

impl Cut {
    /// All is let through.
    pub const NONE: Cut = Cut { reach: f64::INFINITY, end: f64::INFINITY };

    /// The share of a frequency \[Hz\] that is let through.
    pub fn kept(self, hertz: f64) -> f64 {
        match hertz {
            _ if hertz <= self.reach => 1.0,
            _ if hertz >= self.end => 0.0,
            _ => (0.5 * PI * (hertz - self.reach) / (self.end - self.reach)).cos().powi(2),
        }
    }

    /// Time that its ringing takes \[s\].
    fn room(self) -> f64 {
        if self.end.is_finite() { (ROOM / (self.end - self.reach)).min(MOST_ROOM) } else { 0.0 }
    }
}

impl Place {
    /// The record's motion over that of the incident wave, at a frequency \[Hz\].
    pub fn transfer(&self, axis: usize, hertz: f64) -> Complex64 {
        self.columns[axis].factor_at(Complex64::new(0.0, TAU * hertz), self.height)
    }

    /// The same at low frequency: 2 below a free surface, but for damping of the mass.
    pub fn at_rest(&self, axis: usize) -> f64 {
        self.transfer(axis, 1e-6).norm()
    }

    /// The longest way of a wave to the record \[s\].
    pub fn travel(&self) -> f64 {
        self.columns.iter().map(|column| column.travel(self.height)).fold(0.0, f64::max)
    }

    /// Frequencies \[Hz\] that show a transfer up to one of them, but for the depth of its dips.
    pub fn frequencies(&self, axis: usize, most: f64) -> Vec<f64> {
        let column = &self.columns[axis];
        let step = 0.25 / column.travel(column.height()).max(1e-3) / LOOKS;
        let count = (most / step).ceil().clamp(1.0, 1e6) as usize;
        (1..=count).map(|k| k as f64 / count as f64 * most).collect()
    }

    /// The transfer over its static value where it is looked at up to a frequency, and whether that is the bottom of a dip: at the
    /// frequencies that show it, and at its dips, which may lie sharp between two of them (a soft layer's foot on hard rock moves
    /// but for a band as narrow as the ratio of impedances).
    pub fn shares(&self, axis: usize, most: f64) -> Vec<(f64, f64, bool)> {
        let rest = self.at_rest(axis);
        let share = |hertz: f64| self.transfer(axis, hertz).norm() / rest;
        let coarse: Vec<(f64, f64)> =
            self.frequencies(axis, most).into_iter().map(|f| (f, share(f))).collect();
        let mut all = Vec::with_capacity(coarse.len());
        for (k, &(hertz, own)) in coarse.iter().enumerate() {
            let before = if k == 0 { (0.0, 1.0) } else { coarse[k - 1] };
            // What falls towards the last of them may have its bottom before that.
            let last = k + 1 == coarse.len();
            let after = if last { (hertz, own) } else { coarse[k + 1] };
            all.push((hertz, own, false));
            // The bottom of what falls from the left and rises to the right, and is more than round-off.
            if own <= before.1 && own <= after.1 && own < FLAT * before.1.max(after.1) {
                let bottom = lowest(&share, before.0, after.0);
                let depth = share(bottom);
                if !last || depth < FLAT * own {
                    let place = all.len() - usize::from(bottom < hertz);
                    all.insert(place, (bottom, depth, true));
                }
            }
        }
        all
    }

    /// Where the transfer along an axis first falls below [`LEAST`] of its static value, up to a frequency \[Hz\].
    pub fn notch(&self, axis: usize, most: f64) -> Option<Notch> {
        let rest = self.at_rest(axis);
        let share = |hertz: f64| self.transfer(axis, hertz).norm() / rest;
        let low = |share: f64| share < LEAST || share.is_nan();
        let shares = self.shares(axis, most);
        let first = shares.iter().position(|&(_, share, _)| low(share))?;
        let (mut above, mut from) = (if first == 0 { 0.0 } else { shares[first - 1].0 }, shares[first].0);
        for _ in 0..60 {
            let middle = 0.5 * (above + from);
            if low(share(middle)) { from = middle } else { above = middle }
        }
        // What is damped away does not come back.
        let dip = shares[first..].iter().take_while(|(_, share, _)| low(*share)).find(|(.., bottom)| *bottom);
        let at = dip.map_or(from, |(hertz, ..)| *hertz);
        Some(Notch { from, at, share: share(at) })
    }

    /// What is let through along an axis of a record that is wanted up to `band` \[Hz\] and sampled every `dt` \[s\].
    ///
    /// # Errors
    /// The notch, where the transfer cannot be inverted within the band.
    pub fn cut(&self, axis: usize, dt: f64, band: f64) -> Result<Cut, Notch> {
        match self.notch(axis, 0.5 / dt) {
            None => Ok(Cut::NONE),
            Some(notch) if band > FADE[1] * notch.from => Err(notch),
            Some(Notch { from, .. }) => Ok(Cut { reach: band.max(FADE[0] * from), end: from }),
        }
    }

    /// The incident wave of a record along x, y, z that is sampled every `dt` \[s\] and put off by a lead. `band` is the frequency
    /// up to which the record is wanted \[Hz\].
    ///
    /// Exact for the samples to about 10⁻⁴ of what an undamped column has left of its ringing after eight times the record, and to
    /// round-off besides, where nothing is left out.
    ///
    /// # Errors
    /// The axis and the notch, where the transfer cannot be inverted within the band along an axis that moves.
    pub fn deconvolved(
        &self,
        acceleration: &[Vec<f64>; 3],
        dt: f64,
        band: f64,
    ) -> Result<Deconvolved, (usize, Notch)> {
        let mut cuts = [Cut::NONE; 3];
        for (axis, cut) in cuts.iter_mut().enumerate() {
            if acceleration[axis].iter().any(|a| *a != 0.0) {
                *cut = self.cut(axis, dt, band).map_err(|notch| (axis, notch))?;
            }
        }
        let room = cuts.iter().map(|cut| cut.room()).fold(0.0, f64::max);
        let lead = ((self.travel() + room) / dt - 1e-6).ceil().max(0.0) as usize;
        let mut left_out = 0.0_f64;
        let mut incident: [Vec<f64>; 3] = Default::default();
        for (axis, wave) in incident.iter_mut().enumerate() {
            let lost;
            (*wave, lost) = self.along(axis, &acceleration[axis], dt, lead, cuts[axis]);
            left_out = left_out.max(lost);
        }
        let reach = cuts.iter().map(|cut| cut.reach).fold(f64::INFINITY, f64::min);
        Ok(Deconvolved { incident, lead, reach, left_out })
    }

    /// The wave along one axis, and the share of the record that is left out.
    fn along(&self, axis: usize, acceleration: &[f64], dt: f64, lead: usize, cut: Cut) -> (Vec<f64>, f64) {
        let wanted = lead + acceleration.len();
        if acceleration.iter().all(|a| *a == 0.0) {
            return (vec![0.0; wanted], 0.0);
        }
        let mut late = vec![0.0; lead];
        late.extend(acceleration);
        late.resize((SPANS * wanted).next_power_of_two(), 0.0);
        let left_out = if cut == Cut::NONE {
            0.0
        } else {
            let through = transferred(&late, dt, &|omega| cut.kept(omega / TAU).into());
            let lost: f64 = late.iter().zip(&through).map(|(a, b)| (a - b).powi(2)).sum();
            lost / late.iter().map(|a| a * a).sum::<f64>()
        };
        let eta = -LEFT.ln() / (late.len() as f64 * dt);
        let growth = |k: usize| (eta * k as f64 * dt).exp();
        late.iter_mut().enumerate().for_each(|(k, a)| *a /= growth(k));
        let column = &self.columns[axis];
        let mut incident = transferred(&late, dt, &|omega| match cut.kept(omega / TAU) {
            0.0 => Complex64::default(),
            kept => kept / column.factor_at(Complex64::new(eta, omega), self.height),
        });
        incident.truncate(wanted);
        incident.iter_mut().enumerate().for_each(|(k, a)| *a *= growth(k));
        (incident, left_out)
    }
}

/// Where a function of frequency that falls and rises between two is lowest, by golden sections.
fn lowest(value: &dyn Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let part = 0.5 * (5.0_f64.sqrt() - 1.0);
    for _ in 0..GOLDEN {
        let (a, b) = (high - part * (high - low), low + part * (high - low));
        if value(a) < value(b) { high = b } else { low = a }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests;
