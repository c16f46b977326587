//! A layered column under a vertical wave, exact in frequency.
//!
//! With everything going as e^(st) a layer of density ρ and speed c carries waves e^(∓γz), γ = (s/c) √(I/M), and a wave that goes
//! up has the stress −Z v with the impedance Z = ρc √(I M). M is the modulus over the material's own, M_band(s) + sξ M_∞ (ξ acts
//! on the unrelaxed stiffness), and I = 1 + ω_R/s the inertia with Rayleigh's ω_R. Below lies the dashpot ρc of the bottom
//! layer's own moduli, through which the wave enters, τ = ρc v − 2ρc v_i: a half-space of that impedance. Above lies another, of
//! no impedance where the top is free.
//!
//! Velocities follow by reflection coefficients, from the top down the share that comes back at the bottom of each layer and
//! from the base up the wave that goes up (`kramer1996`, section 7.2.1, states the same by amplitudes from the top, which grow
//! beyond all numbers in thick damped layers). Only e^(−γh) appears, never larger than 1, and no denominator can vanish, since
//! layers only take energy.
//!
//! **Ringing.** A discrete transform repeats its span, and an undamped column on hard rock rings longer than any span. So
//! frequencies lie beside the imaginary axis, s = η + iω, which is the transform of v e^(−ηt): what comes round again is smaller
//! by e^(−ηT), whatever the damping (`kausel1992`).

use std::f64::consts::PI;
use tremolite_engine::Top;
use tremolite_engine::problem::Rayleigh;
use tremolite_laws::band::Band;
use tremolite_motion::{Complex64, transferred};

/// A layer of one material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// h \[m\]
    pub thickness: f64,
    /// ρ \[kg/m³\]
    pub density: f64,
    /// c \[m/s\] by the material's own moduli, which dashpots go by as well.
    pub speed: f64,
    pub band: Option<Band>,
    pub rayleigh: Rayleigh,
}

impl Layer {
    /// ρc \[Pa s/m\], of a dashpot.
    fn dashpot(&self) -> f64 {
        self.density * self.speed
    }

    /// Impedance Z \[Pa s/m\], and e^(−γh), at a complex frequency \[1/s\].
    fn waves(&self, s: Complex64) -> (Complex64, Complex64) {
        let (elastic, unrelaxed) = match &self.band {
            Some(band) => {
                let [re, im] = band.complex_modulus([s.re, s.im]);
                (Complex64::new(re, im), band.unrelaxed())
            }
            None => (Complex64::new(1.0, 0.0), 1.0),
        };
        let modulus = elastic + s * self.rayleigh.stiffness * unrelaxed;
        let inertia = 1.0 + self.rayleigh.mass / s;
        let decay = s * (inertia / modulus).sqrt() * (self.thickness / self.speed);
        (self.dashpot() * (inertia * modulus).sqrt(), (-decay).exp())
    }

    /// Whether the stuff is the same, whatever the thickness.
    fn same(&self, other: &Layer) -> bool {
        Layer { thickness: other.thickness, ..*self } == *other
    }
}

/// Layers on a half-space that is as stiff as the lowest of them and undamped.
#[derive(Clone, Debug, PartialEq)]
pub struct LayeredColumn {
    /// Upwards, neighbours unlike.
    layers: Vec<Layer>,
    top: Top,
}

/// Smallest e^(−ηT): what is left of a motion one span earlier. Half the span is used, where round-off grows by its root.
const LEFT: f64 = 1e-8;

impl LayeredColumn {
    /// The column of these layers, given upwards; neighbours of the same stuff are one. None without layers.
    pub fn new(layers: impl IntoIterator<Item = Layer>, top: Top) -> Option<Self> {
        let mut merged: Vec<Layer> = Vec::new();
        for layer in layers {
            match merged.last_mut() {
                Some(last) if last.same(&layer) => last.thickness += layer.thickness,
                _ => merged.push(layer),
            }
        }
        (!merged.is_empty()).then_some(LayeredColumn { layers: merged, top })
    }

    /// Velocity over that of the incident wave at the base, at a complex frequency \[1/s\]: at the base and at the top of each
    /// layer, upwards.
    fn factors(&self, s: Complex64) -> Vec<Complex64> {
        let count = self.layers.len();
        let (below, highest) = (self.layers[0].dashpot(), self.layers[count - 1].dashpot());
        let above = if self.top == Top::Viscous { highest } else { 0.0 };
        let waves: Vec<_> = self.layers.iter().map(|layer| layer.waves(s)).collect();
        let impedance = |k: usize| match k {
            0 => Complex64::from(below),
            _ => waves.get(k - 1).map_or(above.into(), |(z, _)| *z),
        };
        // For the half-space below, each layer and what lies above: at its bottom, the wave that comes back over the one
        // that goes up.
        let mut back = vec![Complex64::default(); count + 2];
        for k in (1..=count).rev() {
            let (own, across, decay) = (impedance(k), impedance(k + 1), waves[k - 1].1);
            let [held, pushed] = [own * (1.0 + back[k + 1]), across * (1.0 - back[k + 1])];
            back[k] = (held - pushed) / (held + pushed) * decay * decay;
        }
        let mut up = Complex64::from(1.0);
        let mut factors = Vec::with_capacity(count + 1);
        for k in 1..=count + 1 {
            let (from, to) = (impedance(k - 1), impedance(k));
            up *= 2.0 * from / (from * (1.0 + back[k]) + to * (1.0 - back[k]));
            factors.push(up * (1.0 + back[k]));
            up *= waves.get(k - 1).map_or(1.0.into(), |(_, decay)| *decay);
        }
        factors
    }

    /// Velocity \[m/s\] of the column's top and of its base every `dt` \[s\] from 0 to `duration` \[s\], at rest before, under a
    /// wave whose velocity at the base is `incident` \[m/s\]; empty for a wave that is zero.
    ///
    /// Exact for what the samples of the wave carry, to about 10⁻⁸ of the largest velocity.
    pub fn velocities(&self, incident: impl Fn(f64) -> f64, dt: f64, duration: f64) -> [Vec<f64>; 2] {
        let wanted = (duration / dt).ceil() as usize + 2;
        let count = (2 * wanted).next_power_of_two();
        let span = count as f64 * dt;
        // What comes later changes nothing before; faded out, it rings nowhere.
        let fade = |t: f64| {
            if t <= duration { 1.0 } else { 0.5 + 0.5 * (PI * (t - duration) / (span - duration)).cos() }
        };
        let eta = -LEFT.ln() / span;
        let times = (0..count).map(|k| k as f64 * dt);
        let wave: Vec<f64> = times.map(|t| fade(t) * incident(t) * (-eta * t).exp()).collect();
        if wave.iter().all(|v| *v == 0.0) {
            return Default::default();
        }
        [self.layers.len(), 0].map(|level| {
            let mut found = transferred(&wave, dt, &|omega| self.factors(Complex64::new(eta, omega))[level]);
            found.truncate(wanted);
            found.iter_mut().enumerate().for_each(|(k, v)| *v *= (eta * k as f64 * dt).exp());
            found
        })
    }
}

#[cfg(test)]
mod tests;
