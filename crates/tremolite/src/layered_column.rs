//! A layered column under a vertical wave, exact in frequency.
//!
//! With everything going as e^(st) a layer of density ρ and speed c carries waves e^(∓γz), γ = (s/c) √(I/M), and a wave that goes
//! up has the stress −Z v with the impedance Z = ρc √(I M). M is the modulus over the material's own, M_band(s) + sξ M_∞ (ξ acts
//! on the unrelaxed stiffness), and I = 1 + ω_R/s the inertia with Rayleigh's ω_R. Below lies the dashpot ρc of the bottom
//! layer's own moduli, through which the wave enters, τ = ρc v − 2ρc v_i: a half-space of that impedance. Above lies another, of
//! no impedance where the top is free. Ground outside a model may have a damping ratio D that is the same at all frequencies; its
//! modulus is 1 + 2iD (`kramer1996`, section 5.5.1).
//!
//! Velocities follow by reflection coefficients, from the top down the share that comes back at the bottom of each layer and
//! from the base up the wave that goes up (`kramer1996`, section 7.2.1, states the same by amplitudes from the top, which grow
//! beyond all numbers in thick damped layers). Only e^(−γh) appears, never larger than 1, and no denominator can vanish, since
//! layers only take energy.
//!
//! **Ringing.** A discrete transform repeats its span, and an undamped column on hard rock rings longer than any span. So
//! frequencies lie beside the imaginary axis, s = η + iω, which is the transform of v e^(−ηt): what comes round again is smaller
//! by e^(−ηT), whatever the damping (`kausel1992`).

mod slope;

use crate::waves::PoreWater;
use rayon::prelude::*;
use std::f64::consts::PI;
use tremolite_engine::problem::Rayleigh;
use tremolite_engine::{Body, Top, Water};
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
    /// D, the same at all frequencies.
    pub damping: f64,
    /// Water that cannot leave the pores, of which only a wave of compression knows; its part of the speed is in `speed`.
    pub water: Option<PoreWater>,
}

impl Layer {
    /// Of an element of a body as a wave sees it that moves along an axis: of compression along z, else of shear.
    pub fn of(
        body: &Body,
        element: u32,
        water: &Water,
        thickness: f64,
        axis: usize,
        rayleigh: Rayleigh,
    ) -> Layer {
        let (p, s) = water.stiffened(element as usize, body.material.moduli()).wave_speeds(body.density);
        let (speed, water) = if axis == 2 { (p, PoreWater::of(water, element, body)) } else { (s, None) };
        let band = body.material.band();
        Layer { thickness, density: body.density, speed, band, rayleigh, damping: 0.0, water }
    }

    /// ρc \[Pa s/m\], of a dashpot.
    fn dashpot(&self) -> f64 {
        self.density * self.speed
    }

    /// Impedance Z \[Pa s/m\], and γh, at a complex frequency \[1/s\].
    fn waves(&self, s: Complex64) -> (Complex64, Complex64) {
        let (elastic, unrelaxed) = match &self.band {
            Some(band) => {
                let [re, im] = band.complex_modulus([s.re, s.im]);
                (Complex64::new(re, im), band.unrelaxed())
            }
            None => (Complex64::new(1.0, 0.0), 1.0),
        };
        let of_rock =
            (elastic + s * self.rayleigh.stiffness * unrelaxed) * Complex64::new(1.0, 2.0 * self.damping);
        let modulus = match &self.water {
            None => of_rock,
            Some(water) => {
                let whole = self.density * self.speed * self.speed;
                of_rock * (1.0 - water.stiffening / whole) + water.modulus(elastic) / whole
            }
        };
        let inertia = 1.0 + self.rayleigh.mass / s;
        let way = s * (inertia / modulus).sqrt() * (self.thickness / self.speed);
        (self.dashpot() * (inertia * modulus).sqrt(), way)
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

    /// The waves of each layer and of what lies above, over the incident one at the base, at a complex frequency \[1/s\]; upwards.
    fn waves(&self, s: Complex64) -> Vec<Waves> {
        let count = self.layers.len();
        let (below, highest) = (self.layers[0].dashpot(), self.layers[count - 1].dashpot());
        let above = if self.top == Top::Viscous { highest } else { 0.0 };
        let of: Vec<_> = self.layers.iter().map(|layer| layer.waves(s)).collect();
        let impedance = |k: usize| match k {
            0 => Complex64::from(below),
            _ => of.get(k - 1).map_or(above.into(), |(z, _)| *z),
        };
        let way = |k: usize| of.get(k - 1).map_or(Complex64::default(), |(_, way)| *way);
        let decay = |k: usize| (-way(k)).exp();
        // For each layer and what lies above, from the half-space below on: what its top sends back of a wave, and at its bottom
        // the wave that comes back over the one that goes up.
        let (mut mirror, mut back) =
            (vec![Complex64::default(); count + 2], vec![Complex64::default(); count + 2]);
        for k in (1..=count).rev() {
            let (own, across, decay) = (impedance(k), impedance(k + 1), decay(k));
            let [held, pushed] = [own * (1.0 + back[k + 1]), across * (1.0 - back[k + 1])];
            mirror[k] = (held - pushed) / (held + pushed);
            back[k] = mirror[k] * decay * decay;
        }
        let mut up = Complex64::from(1.0);
        let mut waves = Vec::with_capacity(count + 1);
        for k in 1..=count + 1 {
            let (from, to) = (impedance(k - 1), impedance(k));
            up *= 2.0 * from / (from * (1.0 + back[k]) + to * (1.0 - back[k]));
            waves.push(Waves { up, back: back[k], mirror: mirror[k], way: way(k) });
            up *= decay(k);
        }
        waves
    }

    /// Velocity over that of the incident wave at the base, at a complex frequency \[1/s\]: at the base and at the top of each
    /// layer, upwards.
    fn factors(&self, s: Complex64) -> Vec<Complex64> {
        self.waves(s).iter().map(|waves| waves.up * (1.0 + waves.back)).collect()
    }

    /// The same at a height \[m\] above the base, between that and the top.
    pub fn factor_at(&self, s: Complex64, height: f64) -> Complex64 {
        let (mut bottom, last) = (0.0, self.layers.len() - 1);
        let inside = |(k, layer): &(usize, &Layer)| {
            let here = height <= bottom + layer.thickness || *k == last;
            if !here {
                bottom += layer.thickness;
            }
            here
        };
        let Some((k, layer)) = self.layers.iter().enumerate().find(inside) else {
            return Complex64::default();
        };
        let Waves { up, mirror, way, .. } = self.waves(s)[k];
        let share = if layer.thickness > 0.0 { (height - bottom) / layer.thickness } else { 0.0 };
        up * ((-way * share).exp() + mirror * (-way * (2.0 - share)).exp())
    }

    /// Whether the layers are of the same stuff and as thick to a millionth of the column.
    pub fn close_to(&self, other: &LayeredColumn) -> bool {
        let near = 1e-6 * self.height();
        let same = |(a, b): (&Layer, &Layer)| a.same(b) && (a.thickness - b.thickness).abs() <= near;
        self.top == other.top
            && self.layers.len() == other.layers.len()
            && self.layers.iter().zip(&other.layers).all(same)
    }

    /// From the base to the top \[m\].
    pub fn height(&self) -> f64 {
        self.layers.iter().map(|layer| layer.thickness).sum()
    }

    /// The time that a wave takes from the base to a height \[m\] by the materials' own moduli \[s\].
    pub fn travel(&self, height: f64) -> f64 {
        let mut bottom = 0.0;
        let across = |layer: &Layer| {
            let way = (height - bottom).clamp(0.0, layer.thickness);
            bottom += layer.thickness;
            way / layer.speed
        };
        self.layers.iter().map(across).sum()
    }

    /// Velocity \[m/s\] of the column's top and of its base every `dt` \[s\] from 0 to `duration` \[s\], at rest before, under a
    /// wave whose velocity at the base is `incident` \[m/s\]; empty for a wave that is zero.
    ///
    /// Exact for what the samples of the wave carry, to about 10⁻⁸ of the largest velocity.
    pub fn velocities(&self, incident: impl Fn(f64) -> f64, dt: f64, duration: f64) -> [Vec<f64>; 2] {
        let train = Train::of(incident, dt, duration);
        [self.layers.len(), 0].map(|level| train.through(&|s| self.factors(s)[level]))
    }

    /// The same at some heights \[m\] above the base.
    pub fn velocities_at(
        &self,
        heights: &[f64],
        incident: impl Fn(f64) -> f64,
        dt: f64,
        duration: f64,
    ) -> Vec<Vec<f64>> {
        let train = Train::of(incident, dt, duration);
        heights.par_iter().map(|&height| train.through(&|s| self.factor_at(s, height))).collect()
    }
}

/// The waves of one layer over the incident one.
struct Waves {
    /// What goes up at its bottom, and there over it what comes back.
    up: Complex64,
    back: Complex64,
    /// What the layer's top sends back, at the top, and γh.
    mirror: Complex64,
    way: Complex64,
}

/// An incident wave that is faded out behind a run and damped by e^(−ηt).
pub(crate) struct Train {
    wave: Vec<f64>,
    dt: f64,
    eta: f64,
    /// Samples that are wanted of it.
    wanted: usize,
}

impl Train {
    pub(crate) fn of(incident: impl Fn(f64) -> f64, dt: f64, duration: f64) -> Train {
        let wanted = (duration / dt).ceil() as usize + 2;
        let count = (2 * wanted).next_power_of_two();
        let span = count as f64 * dt;
        // What comes later changes nothing before; faded out, it rings nowhere.
        let fade = |t: f64| {
            if t <= duration { 1.0 } else { 0.5 + 0.5 * (PI * (t - duration) / (span - duration)).cos() }
        };
        let eta = -LEFT.ln() / span;
        let times = (0..count).map(|k| k as f64 * dt);
        Train { wave: times.map(|t| fade(t) * incident(t) * (-eta * t).exp()).collect(), dt, eta, wanted }
    }

    /// What a transfer function of a complex frequency \[1/s\] makes of it; empty for a wave that is zero.
    pub(crate) fn through(&self, factor: &dyn Fn(Complex64) -> Complex64) -> Vec<f64> {
        let Train { wave, dt, eta, wanted } = self;
        if wave.iter().all(|v| *v == 0.0) {
            return Vec::new();
        }
        let mut found = transferred(wave, *dt, &|omega| factor(Complex64::new(*eta, omega)));
        found.truncate(*wanted);
        found.iter_mut().enumerate().for_each(|(k, v)| *v *= (eta * k as f64 * dt).exp());
        found
    }
}

#[cfg(test)]
mod tests;
