//! Rock as waves of one frequency see it.

use super::pore_water::PoreWater;
use tremolite_engine::problem::Rayleigh;
use tremolite_engine::{Body, Water};
use tremolite_laws::band::Band;
use tremolite_motion::Complex64;

/// Rock without a size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rock {
    /// ρ \[kg/m³\]
    pub density: f64,
    /// c_p and c_s \[m/s\] by the material's own moduli, which dashpots go by as well.
    pub p: f64,
    pub s: f64,
    pub band: Option<Band>,
    pub rayleigh: Rayleigh,
    /// Water that cannot leave the pores; its part of c_p is in `p`.
    pub water: Option<PoreWater>,
}

/// A horizontal layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stratum {
    /// h \[m\]
    pub thickness: f64,
    pub rock: Rock,
}

/// Rock at one frequency: inertia and moduli with their damping.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// ρ I \[kg/m³\], I = 1 + ω_R/s.
    pub inertia: Complex64,
    /// G and λ + 2G \[Pa\], both by the same factor M_band(s) + sξ M_∞ over the material's own, with what water adds to the second.
    pub shear: Complex64,
    pub pressure: Complex64,
}

impl Rock {
    /// Of a body's material, without water.
    pub fn of(body: &Body, rayleigh: Rayleigh) -> Rock {
        let (p, s) = body.material.moduli().wave_speeds(body.density);
        Rock { density: body.density, p, s, band: body.material.band(), rayleigh, water: None }
    }

    /// Of an element of a body, with the water in its pores.
    pub fn in_water(body: &Body, element: u32, water: &Water, rayleigh: Rayleigh) -> Rock {
        let (p, _) = water.stiffened(element as usize, body.material.moduli()).wave_speeds(body.density);
        Rock { p, water: PoreWater::of(water, element, body), ..Rock::of(body, rayleigh) }
    }

    /// The same without damping.
    pub fn undamped(self) -> Rock {
        let water = self.water.map(PoreWater::undamped);
        Rock { band: None, rayleigh: Rayleigh::default(), water, ..self }
    }

    /// At a complex frequency s \[1/s\] of positive imaginary part. Inertia and modulus are those of
    /// [`crate::layered_column`].
    pub fn at(&self, s: Complex64) -> Seen {
        let (elastic, unrelaxed) = match &self.band {
            Some(band) => {
                let [re, im] = band.complex_modulus([s.re, s.im]);
                (Complex64::new(re, im), band.unrelaxed())
            }
            None => (Complex64::from(1.0), 1.0),
        };
        let factor = elastic + s * self.rayleigh.stiffness * unrelaxed;
        let modulus = |speed: f64| factor * (self.density * speed * speed);
        Seen {
            inertia: (1.0 + self.rayleigh.mass / s) * self.density,
            shear: modulus(self.s),
            pressure: match &self.water {
                None => modulus(self.p),
                Some(water) => {
                    let drained = self.density * self.p * self.p - water.stiffening;
                    factor * drained + water.modulus(elastic)
                }
            },
        }
    }

    /// The largest speed of a wave in it \[m/s\], of pressure or of shear: with damping over a band that of the highest
    /// frequencies.
    pub fn fastest(&self, pressure: bool) -> f64 {
        let own = if pressure { self.p } else { self.s };
        own * self.band.map_or(1.0, |band| band.unrelaxed()).sqrt()
    }
}

impl Seen {
    /// λ \[Pa\].
    pub fn lame(&self) -> Complex64 {
        self.pressure - 2.0 * self.shear
    }
}
