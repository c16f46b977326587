//! A round opening in an elastic plane under two principal stresses, bare or lined, in closed form (Michell's solution).
//!
//! Plane strain, tension positive, θ from the axis of the first principal stress. What is even around is
//! σ_r = A − B/r², σ_θ = A + B/r², 2G u_r = (1 − 2ν)A r + B/r; what goes with 2θ comes of the stress function
//! (a r² + b r⁴ + c r⁻² + d) cos 2θ. The rock has the stress from far away and B, c, d, which alone move it; a lining that stands
//! unstressed when the opening is made has all. At its inner edge it is free; at the outer one pressures are equal, and it either
//! moves as the rock or slides freely, with a joint that closes by −σ_r/k. Without a lining this is `kirsch1898`, and with one that
//! is thin beside its radius `einstein1979`.

use crate::models::Solid;

/// A lining: solid, inner radius \[m\], and for one that slides freely the stiffness k \[Pa/m\] of its joint.
#[derive(Clone, Copy, Debug)]
pub struct Lining {
    pub solid: Solid,
    pub inner: f64,
    pub joint: Option<f64>,
}

/// A round opening, compression negative.
#[derive(Clone, Copy, Debug)]
pub struct Opening {
    pub rock: Solid,
    /// \[m\], outside of a lining.
    pub radius: f64,
    /// Principal stresses \[Pa\] far away: along θ = 0 and across.
    pub far: [f64; 2],
    pub lining: Option<Lining>,
}

/// A, B of what is even and a, b, c, d of what goes with 2θ.
type Constants = [f64; 6];

/// Stress and motion at a point: σ_r, σ_θ, τ_rθ \[Pa\]; u_r, u_θ \[m\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct At {
    pub stress: [f64; 3],
    pub motion: [f64; 2],
}

/// What each constant does at a radius: the even and then the 2θ parts of σ_r, σ_θ, u_r; and of τ, u_θ.
fn terms(solid: Solid, r: f64) -> [[f64; 5]; 6] {
    let (nu, shear) = (solid.poisson, 2.0 * solid.moduli().mu);
    let (r2, r4) = (r * r, r * r * r * r);
    [
        [1.0, 1.0, 0.0, (1.0 - 2.0 * nu) * r / shear, 0.0],
        [-1.0 / r2, 1.0 / r2, 0.0, 1.0 / r / shear, 0.0],
        [-2.0, 2.0, 2.0, -2.0 * r / shear, 2.0 * r / shear],
        [0.0, 12.0 * r2, 6.0 * r2, -4.0 * nu * r2 * r / shear, (6.0 - 4.0 * nu) * r2 * r / shear],
        [-6.0 / r4, 6.0 / r4, -6.0 / r4, 2.0 / (r2 * r) / shear, 2.0 / (r2 * r) / shear],
        [-4.0 / r2, 0.0, -2.0 / r2, 4.0 * (1.0 - nu) / r / shear, -2.0 * (1.0 - 2.0 * nu) / r / shear],
    ]
}

/// The solution for an opening.
pub struct Solved {
    opening: Opening,
    rock: Constants,
    lining: Constants,
}

impl Opening {
    /// Solves for the constants; lengths are counted in radii, so that the equations are of one size.
    pub fn solve(&self) -> Solved {
        let mean = 0.5 * (self.far[0] + self.far[1]);
        let half = 0.5 * (self.far[0] - self.far[1]);
        let b = self.radius;
        let rock = terms(self.rock, b);
        // Far stress: σ_r, σ_θ, τ.
        let (even, odd) = (mean, [half, -half, -half]);
        let Some(lining) = self.lining else {
            let (c, d) = {
                let ([c, d], [s, t]) = ([rock[4], rock[5]], [odd[0], odd[2]]);
                let det = c[0] * d[2] - d[0] * c[2];
                ((-s * d[2] + t * d[0]) / det, (-c[0] * t + c[2] * s) / det)
            };
            return Solved { opening: *self, rock: [0.0, mean * b * b, 0.0, 0.0, c, d], lining: [0.0; 6] };
        };
        let (inside, outside) = (terms(lining.solid, lining.inner), terms(lining.solid, b));
        let compliance = lining.joint.map_or(0.0, |k| 1.0 / k);
        // Unknowns: A, B of the lining, B of the rock.
        let even = linear(vec![
            vec![inside[0][0], inside[1][0], 0.0, 0.0],
            vec![outside[0][0], outside[1][0], -rock[1][0], even],
            // u_rock − u_lining = σ_r/k
            vec![
                outside[0][3] + compliance * outside[0][0],
                outside[1][3] + compliance * outside[1][0],
                -rock[1][3],
                0.0,
            ],
        ]);
        // Unknowns: a to d of the lining, c and d of the rock.
        let row = |of: usize, at: &[[f64; 5]; 6]| [at[2][of], at[3][of], at[4][of], at[5][of], 0.0, 0.0, 0.0];
        let minus = |mut row: [f64; 7], of: usize, right: f64| {
            (row[4], row[5], row[6]) = (-rock[4][of], -rock[5][of], right);
            row.to_vec()
        };
        let mut rows =
            vec![row(0, &inside).to_vec(), row(2, &inside).to_vec(), minus(row(0, &outside), 0, odd[0])];
        let mut close = row(3, &outside);
        let pressed = row(0, &outside);
        (0..4).for_each(|i| close[i] += compliance * pressed[i]);
        rows.push(minus(close, 3, 0.0));
        if lining.joint.is_some() {
            rows.push(row(2, &outside).to_vec());
            let mut free = [0.0; 7];
            (free[4], free[5], free[6]) = (rock[4][2], rock[5][2], -odd[2]);
            rows.push(free.to_vec());
        } else {
            rows.push(minus(row(2, &outside), 2, odd[2]));
            rows.push(minus(row(4, &outside), 4, 0.0));
        }
        let odd = linear(rows);
        Solved {
            opening: *self,
            rock: [0.0, even[2], 0.0, 0.0, odd[4], odd[5]],
            lining: [even[0], even[1], odd[0], odd[1], odd[2], odd[3]],
        }
    }
}

impl Solved {
    /// At a radius \[m\] and an angle \[rad\]; the motion is that since the opening was made.
    pub fn at(&self, r: f64, angle: f64) -> At {
        let Opening { rock, radius, far, .. } = self.opening;
        let inside = r < radius;
        let (solid, constants) = match self.opening.lining {
            Some(lining) if inside => (lining.solid, &self.lining),
            _ => (rock, &self.rock),
        };
        let (sine, cosine) = (2.0 * angle).sin_cos();
        let mut out = At::default();
        for (k, (term, x)) in terms(solid, r).iter().zip(constants).enumerate() {
            let with = if k < 2 { [1.0, 0.0] } else { [cosine, sine] };
            out.stress[0] += x * term[0] * with[0];
            out.stress[1] += x * term[1] * with[0];
            out.stress[2] += x * term[2] * with[1];
            out.motion[0] += x * term[3] * with[0];
            out.motion[1] += x * term[4] * with[1];
        }
        if !inside {
            let (mean, half) = (0.5 * (far[0] + far[1]), 0.5 * (far[0] - far[1]));
            out.stress[0] += mean + half * cosine;
            out.stress[1] += mean - half * cosine;
            out.stress[2] -= half * sine;
        }
        out
    }

    /// The stress \[Pa\] at a point, less that from far away, in x, y, z and the order of Voigt, y being the axis.
    pub fn change(&self, r: f64, angle: f64) -> [f64; 6] {
        let [radial, hoop, shear] = self.at(r, angle).stress;
        let (d, c) = angle.sin_cos();
        let (xx, zz) = (
            radial * c * c + hoop * d * d - 2.0 * shear * c * d,
            radial * d * d + hoop * c * c + 2.0 * shear * c * d,
        );
        let zx = (radial - hoop) * c * d + shear * (c * c - d * d);
        [xx - self.opening.far[0], 0.0, zz - self.opening.far[1], 0.0, 0.0, zx]
    }

    /// Thrust \[N/m\], compression positive, and moment \[N\], tension outside positive, of the lining at an angle, by the two-point rule
    /// of Gauss in 200 layers.
    pub fn section(&self, angle: f64) -> [f64; 2] {
        let Some(lining) = self.opening.lining else { return [0.0; 2] };
        let (a, b) = (lining.inner, self.opening.radius);
        let middle = 0.5 * (a + b);
        let layers = 200;
        let thick = (b - a) / f64::from(layers);
        let mut out = [0.0; 2];
        for layer in 0..layers {
            for g in [-1.0, 1.0] {
                let r = a + thick * (f64::from(layer) + 0.5 + 0.5 * g / 3f64.sqrt());
                let hoop = self.at(r, angle).stress[1];
                out[0] -= 0.5 * thick * hoop;
                out[1] += 0.5 * thick * hoop * (r - middle);
            }
        }
        out
    }
}

/// Solves linear equations, each row with its right side last, by elimination with pivots, rows and columns brought to one
/// size.
fn linear(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    let mut sizes = vec![0.0_f64; n];
    for column in 0..n {
        sizes[column] = rows.iter().fold(0.0, |most: f64, row| most.max(row[column].abs()));
    }
    for row in &mut rows {
        row[..n].iter_mut().zip(&sizes).for_each(|(x, size)| *x /= size);
        let size = row[..n].iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        row.iter_mut().for_each(|x| *x /= size);
    }
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| rows[i][k].abs().total_cmp(&rows[j][k].abs())).unwrap_or(k);
        rows.swap(k, pivot);
        for i in 0..n {
            if i == k {
                continue;
            }
            let factor = rows[i][k] / rows[k][k];
            for j in k..=n {
                rows[i][j] -= factor * rows[k][j];
            }
        }
    }
    (0..n).map(|k| rows[k][n] / rows[k][k] / sizes[k]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

    fn near(found: f64, expected: f64) {
        assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
    }

    #[test]
    fn a_bare_opening_is_kirsch_s() {
        let rock = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
        let solved = Opening { rock, radius: 5.0, far: [-4.32e6, -5.4e6], lining: None }.solve();
        let wall = [0.0, FRAC_PI_2].map(|angle| solved.at(5.0, angle));
        near(wall[0].stress[1], -11.88e6);
        near(wall[1].stress[1], -7.56e6);
        near(wall[0].motion[0], -2.3625e-3);
        near(wall[1].motion[0], -3.7125e-3);
        let inside = solved.at(7.5, FRAC_PI_4);
        for (found, expected) in inside.stress.into_iter().zip([-2.7e6, -7.02e6, -0.7e6]) {
            near(found, expected);
        }
        near(inside.motion[0], -2.025e-3);
        near(inside.motion[1], -0.325e-3);
    }

    /// Thrust and moment of thick rings from an independent solution, P = 1.
    #[test]
    fn lined_openings_are_those_of_a_separate_solution() {
        let rock = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
        let lining = Solid { young: 25e9, poisson: 0.17, density: 2500.0 };
        let lining = Lining { solid: lining, inner: 8.25, joint: None };
        let solved = Opening { rock, radius: 8.75, far: [-0.5, -1.0], lining: Some(lining) }.solve();
        let section = [0.0, FRAC_PI_2].map(|angle| solved.section(angle));
        near(section[0][0] / 8.5, 0.1944328254829863);
        near(section[1][0] / 8.5, 0.05366978030323909);
        near(section[0][1] / 72.25, 0.00010619287629642623);
        near(section[1][1] / 72.25, -3.6744448493370594e-05);

        let rock = Solid { young: 1e9, poisson: 0.3, density: 2700.0 };
        let lining = Solid { young: 25e9, poisson: 0.2, density: 2500.0 };
        let lining = Lining { solid: lining, inner: 4.975, joint: Some(f64::INFINITY) };
        let solved = Opening { rock, radius: 5.025, far: [-0.5, -1.0], lining: Some(lining) }.solve();
        let section = [0.0, FRAC_PI_2].map(|angle| solved.section(angle));
        near(section[0][0] / 5.0, 0.19099413305732102);
        near(section[1][0] / 5.0, 0.19098647856385903);
        near(section[0][1] / 25.0, 5.410882601649827e-06);
        near(section[1][1] / 25.0, -2.2436108605082215e-06);
    }
}
