//! The paper's concrete (table 1), with its plateau and its split, and a point of it.

use super::Random;
use tremolite_laws::materials::Concrete;
use tremolite_laws::path::{Control, Path, Response, drive};
use tremolite_laws::{Material, Point, Value, Values};

pub const YOUNG: f64 = 25e9;
pub const POISSON: f64 = 0.17;
pub const FT: f64 = 1.2e6;
/// ε_ts
pub const THRESHOLD: f64 = FT / YOUNG;
pub const ALPHA: f64 = 0.1;
pub const BETA: f64 = 0.2;

/// f_c = 2 c cos φ/(1 − sin φ)
pub fn fc() -> f64 {
    let phi = 46f64.to_radians();
    2.0 * 2e6 * phi.cos() / (1.0 - phi.sin())
}

/// N = (1 + sin φ)/(1 − sin φ)
pub fn slope() -> f64 {
    let phi = 46f64.to_radians();
    (1.0 + phi.sin()) / (1.0 - phi.sin())
}

pub fn values() -> Values {
    let mut values = Values::default();
    for (name, value) in [
        ("young", YOUNG),
        ("poisson", POISSON),
        ("tensile_strength", FT),
        ("cohesion", 2e6),
        ("friction_angle", 46f64.to_radians()),
        ("residual_tension", ALPHA),
        ("residual_shear", BETA),
    ] {
        values = values.with(name, value);
    }
    with_words(values, &[("rate", "none"), ("evolution", "residual"), ("split", "effective")])
}

pub fn with_words(mut values: Values, words: &[(&str, &str)]) -> Values {
    for (name, word) in words {
        values.0.insert((*name).to_owned(), Value::Word((*word).to_owned()));
    }
    values
}

/// The paper's concrete with some words changed.
pub fn concrete(words: &[(&str, &str)]) -> Concrete {
    Concrete::new(&with_words(values(), words)).unwrap()
}

/// Every combination of the words that change the law, 36 of them, rate `none` or `ceb`, with and without a fracture energy.
pub fn all_variants() -> Vec<Concrete> {
    let mut laws = Vec::new();
    for split in ["effective", "compliance"] {
        for driver in ["strain", "stress"] {
            for shear_tension in ["nominal", "effective"] {
                if split == "compliance" && shear_tension == "effective" {
                    continue;
                }
                for rate in ["none", "ceb"] {
                    let words = [
                        ("split", split),
                        ("driver", driver),
                        ("shear_tension", shear_tension),
                        ("rate", rate),
                    ];
                    laws.push(concrete(&words));
                    let energy = with_words(values().with("fracture_energy", 130.0), &words);
                    laws.push(Concrete::new(&energy).unwrap());
                    let band = with_words(energy, &[("evolution", "exponential")]);
                    laws.push(Concrete::new(&band).unwrap());
                }
            }
        }
    }
    laws
}

/// Uniaxial stress along x: the strain there is prescribed, all other stresses are zero.
pub fn uniaxial(law: &Concrete, strain: &[f64], size: Option<f64>) -> Response {
    let mut control = [Control::Stress; 6];
    control[0] = Control::Strain;
    let values = strain.iter().map(|&e| [e, 0.0, 0.0, 0.0, 0.0, 0.0]).collect();
    drive(law, &Path { time: vec![0.0; strain.len()], values, control, size }).unwrap()
}

/// n + 1 values from a to b.
pub fn ramp(a: f64, b: f64, n: usize) -> Vec<f64> {
    (0..=n).map(|i| a + (b - a) * i as f64 / n as f64).collect()
}

/// Strain of given principal stresses in an undamaged point, along the axes.
pub fn elastic_strain(s: [f64; 3]) -> [f64; 6] {
    let trace = s[0] + s[1] + s[2];
    let e = s.map(|x| ((1.0 + POISSON) * x - POISSON * trace) / YOUNG);
    [e[0], e[1], e[2], 0.0, 0.0, 0.0]
}

/// A tensor with engineering shear turned by a rotation (rows are the new axes).
pub fn turn_strain(e: &[f64; 6], r: &[[f64; 3]; 3]) -> [f64; 6] {
    let t = turn(&[e[0], e[1], e[2], 0.5 * e[3], 0.5 * e[4], 0.5 * e[5]], r);
    [t[0], t[1], t[2], 2.0 * t[3], 2.0 * t[4], 2.0 * t[5]]
}

/// A symmetric tensor turned by a rotation: R T Rᵀ.
pub fn turn(t: &[f64; 6], r: &[[f64; 3]; 3]) -> [f64; 6] {
    let full = [[t[0], t[3], t[5]], [t[3], t[1], t[4]], [t[5], t[4], t[2]]];
    [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)].map(|(i, j)| {
        let mut sum = 0.0;
        for a in 0..3 {
            for b in 0..3 {
                sum += r[i][a] * full[a][b] * r[j][b];
            }
        }
        sum
    })
}

/// A cube of edge h at a time step.
pub fn point(dt: f64, h: f64) -> Point<f64> {
    Point { size: [h * h, h * h, h * h, 0.0, 0.0, 0.0], ..Point::new(dt) }
}

/// σ : ε
pub fn contract(stress: &[f64; 6], strain: &[f64; 6]) -> f64 {
    stress.iter().zip(strain).map(|(s, e)| s * e).sum()
}

/// A random strain whose components reach `size`.
pub fn random_strain(random: &mut Random, size: f64) -> [f64; 6] {
    [0; 6].map(|_| size * random.symmetric())
}
