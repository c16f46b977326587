//! Salençon's opening in closed form.

use super::{COHESION, FAR, FRICTION, INSIDE, ROCK, WALL};
use crate::models::Solid;

/// What surrounds an opening of radius 1 m, and what presses on it.
#[derive(Clone, Copy, Debug)]
pub struct Surroundings {
    pub solid: Solid,
    /// p₀ and p_i \[Pa\]
    pub far: f64,
    pub inside: f64,
    /// c \[Pa\], φ \[°\]
    pub cohesion: f64,
    pub friction: f64,
}

/// Those of the problem.
pub const SURROUNDINGS: Surroundings =
    Surroundings { solid: ROCK, far: FAR, inside: INSIDE, cohesion: COHESION, friction: FRICTION };

/// The closed form for a dilation angle \[°\].
pub struct Exact {
    surroundings: Surroundings,
    k: f64,
    m: f64,
    /// s \[Pa\]
    shift: f64,
    /// R \[m\]
    pub plastic: f64,
    /// σ_e \[Pa\]
    edge: f64,
}

impl Exact {
    pub fn new(dilation: f64) -> Self {
        Exact::of(SURROUNDINGS, dilation)
    }

    /// In other surroundings.
    pub fn of(surroundings: Surroundings, dilation: f64) -> Self {
        let slope = |x: f64| (1.0 + x.to_radians().sin()) / (1.0 - x.to_radians().sin());
        let (k, m) = (slope(surroundings.friction), slope(dilation));
        let q = 2.0 * surroundings.cohesion * k.sqrt();
        let shift = q / (k - 1.0);
        let ratio = 2.0 / (k + 1.0) * (surroundings.far + shift) / (surroundings.inside + shift);
        let plastic = WALL * ratio.powf(1.0 / (k - 1.0));
        Exact { surroundings, k, m, shift, plastic, edge: (2.0 * surroundings.far - q) / (k + 1.0) }
    }

    /// σ_r and σ_θ \[Pa\], compression positive.
    pub fn stress(&self, r: f64) -> [f64; 2] {
        let far = self.surroundings.far;
        if r > self.plastic {
            let change = (far - self.edge) * (self.plastic / r).powi(2);
            return [far - change, far + change];
        }
        let radial = (self.surroundings.inside + self.shift) * (r / WALL).powf(self.k - 1.0) - self.shift;
        [radial, self.k * (radial + self.shift) - self.shift]
    }

    /// Displacement inwards \[m\].
    pub fn inwards(&self, r: f64) -> f64 {
        let Surroundings { solid, far, inside, .. } = self.surroundings;
        let shear = 2.0 * solid.moduli().mu;
        if r > self.plastic {
            return (far - self.edge) * self.plastic * self.plastic / (r * shear);
        }
        let (k, m, nu) = (self.k, self.m, solid.poisson);
        let left = inside + self.shift;
        let flow = (1.0 - nu) * (k * k - 1.0) / (k + m)
            * left
            * (self.plastic / WALL).powf(k - 1.0)
            * (self.plastic / r).powf(m + 1.0);
        let elastic = ((1.0 - nu) * (k * m + 1.0) / (k + m) - nu) * left * (r / WALL).powf(k - 1.0);
        r * ((2.0 * nu - 1.0) * (far + self.shift) + flow + elastic) / shear
    }
}

#[cfg(test)]
mod tests {
    use super::super::DILATIONS;
    use super::*;

    /// Equilibrium, yield, continuity at R, no stress beyond yield along the axis, and the flow rule
    /// ε_r + M ε_θ = its elastic part, by differences.
    #[test]
    fn the_closed_form_solves_its_equations() {
        for dilation in DILATIONS {
            let exact = Exact::new(dilation);
            let (mu, nu) = (ROCK.moduli().mu, ROCK.poisson);
            for r in [1.01, 1.2, 1.4, 1.6, 1.62, 2.0, 4.0] {
                let h = 1e-5;
                let [radial, hoop] = exact.stress(r);
                let slope = (exact.stress(r + h)[0] - exact.stress(r - h)[0]) / (2.0 * h);
                assert!((slope - (hoop - radial) / r).abs() < 1e-8 * FAR);
                if r < exact.plastic {
                    let axial = FAR + nu * (radial + hoop - 2.0 * FAR);
                    assert!(radial < axial && axial < hoop, "{r}: {radial} {axial} {hoop}");
                    // Compression positive: shortening along the radius is the fall of what moves inwards.
                    let radial_strain = (exact.inwards(r + h) - exact.inwards(r - h)) / (2.0 * h);
                    let sum = -exact.m * exact.inwards(r) / r - radial_strain;
                    let elastic = |a: f64, b: f64| ((1.0 - nu) * (a - FAR) - nu * (b - FAR)) / (2.0 * mu);
                    let exactly = -(elastic(radial, hoop) + exact.m * elastic(hoop, radial));
                    assert!((sum - exactly).abs() < 1e-6, "{dilation} {r}: {sum} {exactly}");
                }
            }
            let [below, above] = [-1e-9, 1e-9].map(|d| exact.inwards(exact.plastic + d));
            assert!((below / above - 1.0).abs() < 1e-7);
        }
    }
}
