//! Rock laws under test, and an integrator of plastic flow that shares nothing with them.

use super::Random;
use tremolite_laws::{History, Material, Point, Value, Values};

pub const YOUNG: f64 = 10e9;
pub const POISSON: f64 = 0.25;

/// Numbers by key on top of the moduli above.
pub fn rock(numbers: &[(&str, f64)]) -> Values {
    let start = Values::default().with("young", YOUNG).with("poisson", POISSON);
    numbers.iter().fold(start, |values, (key, x)| values.with(key, *x))
}

pub fn with_word(mut values: Values, key: &str, word: &str) -> Values {
    values.0.insert(key.to_owned(), Value::Word(word.to_owned()));
    values
}

pub fn slope(angle: f64) -> f64 {
    (1.0 + angle.sin()) / (1.0 - angle.sin())
}

/// Cohesion, friction, dilation and tensile strength, angles in degrees.
pub fn mohr_coulomb(c: f64, phi: f64, psi: f64, ft: f64) -> Values {
    rock(&[
        ("cohesion", c),
        ("friction_angle", phi.to_radians()),
        ("dilation_angle", psi.to_radians()),
        ("tensile_strength", ft),
    ])
}

/// The yield surface in unordered principal stresses, for any of the laws.
#[derive(Clone, Copy, Debug)]
pub enum Surface {
    Linear { k: f64, fc: f64 },
    Curved { sci: f64, mb: f64, s: f64, a: f64 },
}

impl Surface {
    pub fn mohr_coulomb(c: f64, phi: f64) -> Self {
        let phi = phi.to_radians();
        Surface::Linear { k: slope(phi), fc: 2.0 * c * phi.cos() / (1.0 - phi.sin()) }
    }

    /// Excess of the plane in which `high` is the least and `low` the most compressed.
    pub fn excess(&self, high: f64, low: f64) -> f64 {
        match *self {
            Surface::Linear { k, fc } => k * high - low - fc,
            Surface::Curved { sci, mb, s, a } => high - low - sci * (s - mb * high / sci).max(0.0).powf(a),
        }
    }

    /// ∂σ₃/∂σ₁ along the surface, at its least compressed stress.
    pub fn slope(&self, high: f64) -> f64 {
        match *self {
            Surface::Linear { k, .. } => k,
            Surface::Curved { sci, mb, s, a } => 1.0 + a * mb * (s - mb * high / sci).max(0.0).powf(a - 1.0),
        }
    }

    pub fn apex(&self) -> f64 {
        match *self {
            Surface::Linear { k, fc } => fc / (k - 1.0),
            Surface::Curved { sci, mb, s, .. } => s * sci / mb,
        }
    }
}

/// Plastic flow by Koiter's rule on all nine surfaces at once: six of shear, three of tension, no order among the
/// principal stresses and no regions.
#[derive(Clone, Copy, Debug)]
pub struct Reference {
    pub surface: Surface,
    /// M of the dilation angle.
    pub flow: f64,
    pub ft: f64,
}

impl Reference {
    fn flow_of(&self, p: usize) -> [f64; 3] {
        const PAIRS: [(usize, usize); 6] = [(0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1)];
        let mut g = [0.0; 3];
        if p < 6 {
            g[PAIRS[p].0] = self.flow;
            g[PAIRS[p].1] = -1.0;
        } else {
            g[p - 6] = 1.0;
        }
        g
    }

    fn excess_of(&self, p: usize, s: &[f64; 3]) -> f64 {
        let g = self.flow_of(p);
        let high = (0..3).find(|&i| g[i] > 0.0).unwrap();
        match (0..3).find(|&i| g[i] < 0.0) {
            Some(low) => self.surface.excess(s[high], s[low]),
            None => s[high] - self.ft,
        }
    }

    /// Principal stresses after an implicit step from trial stresses: multipliers by sweeps over the surfaces, each
    /// set so that its own surface holds, or to zero. None where 5,000 sweeps leave more than 1e-11 of the largest
    /// stress, by the rate at which they converge: that is the neighbourhood of a vertical apex.
    pub fn step(&self, trial: [f64; 3]) -> Option<[f64; 3]> {
        let lambda = YOUNG * POISSON / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON));
        let mu2 = YOUNG / (1.0 + POISSON);
        let answers: [[f64; 3]; 9] = std::array::from_fn(|p| {
            let g = self.flow_of(p);
            g.map(|x| lambda * (g[0] + g[1] + g[2]) + mu2 * x)
        });
        let mut gamma = [0.0f64; 9];
        let at = |gamma: &[f64; 9]| {
            let mut s = trial;
            for (g, answer) in gamma.iter().zip(&answers) {
                for i in 0..3 {
                    s[i] -= g * answer[i];
                }
            }
            s
        };
        let scale = trial.iter().fold(1e5f64, |m, x| m.max(x.abs()));
        let mut before = f64::INFINITY;
        for _ in 0..5_000 {
            let mut moved = 0.0f64;
            for p in 0..9 {
                let old = gamma[p];
                let mut excess = |x: f64| {
                    gamma[p] = x;
                    self.excess_of(p, &at(&gamma))
                };
                let least = excess(0.0);
                let new = if least <= 0.0 { 0.0 } else { root(&mut excess, least, (2.0 * old).max(1e-12)) };
                gamma[p] = new;
                moved = moved.max((new - old).abs());
            }
            let left = moved / (1.0 - moved / before);
            if moved == 0.0 || (moved < before && left * mu2 <= 1e-11 * scale) {
                return Some(at(&gamma));
            }
            before = moved;
        }
        None
    }

    /// Stress at the end of straight legs between strains, `steps` implicit steps each, in full tensors.
    pub fn follow(&self, corners: &[[f64; 6]], steps: usize) -> [f64; 6] {
        let lambda = YOUNG * POISSON / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON));
        let mu = YOUNG / (2.0 * (1.0 + POISSON));
        let mut stress = [0.0; 6];
        let mut last = [0.0; 6];
        for corner in corners {
            let leg: [f64; 6] = std::array::from_fn(|c| (corner[c] - last[c]) / steps as f64);
            for _ in 0..steps {
                let volume = leg[0] + leg[1] + leg[2];
                for c in 0..3 {
                    stress[c] += lambda * volume + 2.0 * mu * leg[c];
                    stress[3 + c] += mu * leg[3 + c];
                }
                let (values, axes) = jacobi(&stress);
                let returned = self.step(values).expect("the reference converges");
                stress = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)]
                    .map(|(i, j)| (0..3).map(|a| returned[a] * axes[a][i] * axes[a][j]).sum());
            }
            last = *corner;
        }
        stress
    }
}

/// Where a decreasing function that is linear or nearly so vanishes, from its value at 0 and a first guess beyond:
/// false position with halving of the end that stays (Illinois).
fn root(f: &mut impl FnMut(f64) -> f64, at_zero: f64, guess: f64) -> f64 {
    let (mut low, mut f_low, mut high) = (0.0, at_zero, guess);
    let mut f_high = f(high);
    while f_high > 0.0 {
        (low, f_low, high) = (high, f_high, 2.0 * high);
        f_high = f(high);
    }
    let mut middle = high;
    for _ in 0..200 {
        middle = (high - f_high * (high - low) / (f_high - f_low)).clamp(low, high);
        let value = f(middle);
        if middle == low || middle == high || value == 0.0 {
            break;
        }
        if value > 0.0 {
            (low, f_low, f_high) = (middle, value, 0.5 * f_high);
        } else {
            (high, f_high, f_low) = (middle, value, 0.5 * f_low);
        }
    }
    middle
}

/// Principal values in no order and their axes, a row each, by Jacobi's rotations.
pub fn jacobi(t: &[f64; 6]) -> ([f64; 3], [[f64; 3]; 3]) {
    let mut a = [[t[0], t[3], t[5]], [t[3], t[1], t[4]], [t[5], t[4], t[2]]];
    let mut axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for _ in 0..12 {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if a[p][q] == 0.0 {
                continue;
            }
            let angle = 0.5 * f64::atan2(2.0 * a[p][q], a[p][p] - a[q][q]);
            let (s, c) = angle.sin_cos();
            let turn = |x: f64, y: f64| (c * x + s * y, c * y - s * x);
            for row in &mut a {
                (row[p], row[q]) = turn(row[p], row[q]);
            }
            for k in 0..3 {
                (a[p][k], a[q][k]) = turn(a[p][k], a[q][k]);
                (axes[p][k], axes[q][k]) = turn(axes[p][k], axes[q][k]);
            }
        }
    }
    ([a[0][0], a[1][1], a[2][2]], axes)
}

/// A law's stress and history at the end of straight legs, `steps` each.
pub fn follow<M: Material>(law: &M, corners: &[[f64; 6]], steps: usize) -> ([f64; 6], M::History<f64>) {
    let mut history = <M::History<f64> as History<f64>>::zero();
    let mut stress = [0.0; 6];
    let mut last = [0.0; 6];
    for corner in corners {
        for step in 1..=steps {
            let share = step as f64 / steps as f64;
            let strain = std::array::from_fn(|c| last[c] + (corner[c] - last[c]) * share);
            (stress, history) = law.update(&Point::new(0.0), strain, history);
        }
        last = *corner;
    }
    (stress, history)
}

/// Elastic strain of stresses along the axes.
pub fn elastic_strain(s: [f64; 3]) -> [f64; 6] {
    let trace = s[0] + s[1] + s[2];
    let e = s.map(|x| ((1.0 + POISSON) * x - POISSON * trace) / YOUNG);
    [e[0], e[1], e[2], 0.0, 0.0, 0.0]
}

/// Elastic stress of a strain.
pub fn elastic_stress(e: &[f64; 6]) -> [f64; 6] {
    let lambda = YOUNG * POISSON / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON));
    let mu = YOUNG / (2.0 * (1.0 + POISSON));
    let pressure = lambda * (e[0] + e[1] + e[2]);
    std::array::from_fn(|c| if c < 3 { pressure + 2.0 * mu * e[c] } else { mu * e[c] })
}

/// A random strain, compressed on the whole more often than not.
pub fn random_strain(random: &mut Random, size: f64) -> [f64; 6] {
    let shift = 1.5 * size * (random.unit() - 0.7);
    std::array::from_fn(|c| size * random.symmetric() + if c < 3 { shift } else { 0.0 })
}

pub fn largest(t: &[f64]) -> f64 {
    t.iter().fold(0.0f64, |m, x| m.max(x.abs()))
}
