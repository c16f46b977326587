//! The constants of the concrete law that its parameters do not show.

use super::{Concrete, Evolution};
use crate::parameter::Derived;

impl Concrete {
    /// See [`crate::Material::derived`]; static values, rates multiply them.
    pub(super) fn constants(&self, extents: [f64; 2]) -> Vec<Derived> {
        let threshold = self.ft / self.young;
        let mut all = vec![
            Derived::new("compressive_strength", self.fc, "Pa", "f_c, static"),
            Derived::new("tensile_strength", self.ft, "Pa", "f_t, static"),
            Derived::new("slope", self.slope, "1", "N = (1 + sin φ)/(1 − sin φ)"),
            Derived::new("threshold_strain", threshold, "1", "ε_ts = f_t/E, at which tension cracks"),
            Derived::between(
                "fracture_energy",
                extents.map(|h| self.fracture_energy(h)),
                "N/m",
                if self.energy_of_strength {
                    "G_f of Model Code 2010 by f_c, 73 f_c^0.18 with f_c in MPa, since none is given"
                } else {
                    "G_f of a crack across the shortest to longest extent of the elements"
                },
            ),
        ];
        match self.evolution {
            Evolution::Ratio { ratio } => all.extend([
                Derived::new("ultimate_strain_ratio", ratio, "1", "ε_us/ε_ts"),
                Derived::new(
                    "ultimate_strain",
                    ratio * threshold,
                    "1",
                    "ε_us, beyond which nothing is carried",
                ),
            ]),
            Evolution::Energy { energy } => {
                let ultimate = extents
                    .map(|h| threshold + (energy / h - 0.5 * self.ft * threshold) / (self.alpha * self.ft));
                let ratio = ultimate.map(|strain| strain / threshold);
                all.extend([
                    Derived::between(
                        "ultimate_strain_ratio",
                        ratio,
                        "1",
                        "ε_us/ε_ts, by the element's extent",
                    ),
                    Derived::between(
                        "ultimate_strain",
                        ultimate,
                        "1",
                        "ε_us, beyond which nothing is carried, by the element's extent",
                    ),
                ]);
            }
            Evolution::Exponential { energy } => {
                let falling = extents.map(|h| energy / (self.ft * h) - 0.5 * threshold);
                let doc = "ε_f, over which strength falls to 1/e, by the element's extent";
                all.push(Derived::between("softening_strain", falling, "1", doc));
            }
        }
        let limit = match self.evolution {
            Evolution::Ratio { .. } => None,
            Evolution::Energy { energy } | Evolution::Exponential { energy } => {
                Some(2.0 * energy / (self.ft * threshold))
            }
        };
        all.extend(limit.map(|h| {
            Derived::new("size_limit", h, "m", "2 G_f E/f_t², extent that elements must stay below")
        }));
        if let Some(rate) = &self.rate {
            let references = [rate.tension.reference, rate.shear.reference];
            all.extend([
                Derived::between("reference_rate", references, "1/s", "ε̇_s, in tension and in shear"),
                Derived::new("rate_exponent_tension", rate.tension.exponent, "1", "of f_t over ε̇/ε̇_s"),
                Derived::new("rate_exponent_shear", rate.shear.exponent, "1", "of f_c over ε̇/ε̇_s"),
            ]);
        }
        all
    }
}
