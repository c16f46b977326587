//! The paper's concrete (`wang2018`, table 1) at one point: its constants, its closed forms, and paths through it.

use crate::VerifyError;
use tremolite_laws::materials::Concrete;
use tremolite_laws::{Material, Point, Value, Values, virgin};

/// E \[Pa\]
pub const YOUNG: f64 = 25e9;
/// ν
pub const POISSON: f64 = 0.17;
/// f_t \[Pa\]
pub const FT: f64 = 1.2e6;
/// ε_ts
pub const THRESHOLD: f64 = FT / YOUNG;
/// α and β, the plateaus of tension and shear
pub const ALPHA: f64 = 0.1;
pub const BETA: f64 = 0.2;
/// c \[Pa\]
const COHESION: f64 = 2e6;
/// φ \[rad\]
const FRICTION: f64 = 46.0 * std::f64::consts::PI / 180.0;

/// Columns of the law's history.
pub const D_TENSION: usize = 0;
pub const D_SHEAR: usize = 1;
pub const FACTOR_TENSION: usize = 6;
pub const FACTOR_SHEAR: usize = 7;

/// The two splits.
pub const SPLITS: [&str; 2] = ["effective", "compliance"];

/// f_c = 2c cos φ/(1 − sin φ) \[Pa\]
pub fn fc() -> f64 {
    2.0 * COHESION * FRICTION.cos() / (1.0 - FRICTION.sin())
}

/// N = (1 + sin φ)/(1 − sin φ)
pub fn slope() -> f64 {
    (1.0 + FRICTION.sin()) / (1.0 - FRICTION.sin())
}

/// Its parameters with some numbers and words changed: the paper's plateau and split, and no rates, unless a word asks for others.
pub fn values(numbers: &[(&str, f64)], words: &[(&str, &str)]) -> Values {
    let own = [
        ("young", YOUNG),
        ("poisson", POISSON),
        ("tensile_strength", FT),
        ("cohesion", COHESION),
        ("friction_angle", FRICTION),
        ("residual_tension", ALPHA),
        ("residual_shear", BETA),
    ];
    let mut values = Values::default();
    for (name, value) in own.iter().chain(numbers) {
        values = values.with(name, *value);
    }
    let own = [("rate", "none"), ("evolution", "residual"), ("split", "effective")];
    for (name, word) in own.iter().chain(words) {
        values.0.insert((*name).to_owned(), Value::Word((*word).to_owned()));
    }
    values
}

/// The law with some numbers and words changed.
///
/// # Errors
/// If the law refuses them.
pub fn concrete(numbers: &[(&str, f64)], words: &[(&str, &str)]) -> Result<Concrete, VerifyError> {
    Concrete::new(&values(numbers, words)).map_err(|faults| VerifyError::Setup(format!("{faults:?}")))
}

/// Stress along x, and the largest stress across it, at strains along x with the lateral strain that belongs to the
/// exact stress \[Pa\] there: −νε in the effective split, −νσ/E in the compliance split. Solving for the lateral strain
/// would find one of many, since a point cracked through has no lateral stiffness. Time stands still.
pub fn uniaxial(law: &Concrete, split: &str, rows: &[(f64, f64)]) -> Vec<[f64; 2]> {
    let mut history = virgin::<Concrete>();
    let stress = rows.iter().map(|&(e, s)| {
        let lateral = -POISSON * if split == "compliance" { s / YOUNG } else { e };
        let stress;
        (stress, history) = law.update(&Point::new(0.0), [e, lateral, lateral, 0.0, 0.0, 0.0], history);
        [stress[0], stress[1].abs().max(stress[2].abs())]
    });
    stress.collect()
}

/// Strain of an undamaged point under these principal stresses along the axes.
pub fn elastic_strain(s: [f64; 3]) -> [f64; 6] {
    let trace = s[0] + s[1] + s[2];
    let e = s.map(|x| ((1.0 + POISSON) * x - POISSON * trace) / YOUNG);
    [e[0], e[1], e[2], 0.0, 0.0, 0.0]
}

/// Damage D⁺ and D⁻ that a virgin point takes in one step to the strain of these elastic stresses.
pub fn damage(law: &Concrete, stress: [f64; 3]) -> [f64; 2] {
    let (_, history) = law.update(&cube(0.0, 0.5), elastic_strain(stress), virgin::<Concrete>());
    [history[D_TENSION], history[D_SHEAR]]
}

/// The largest multiple of a direction of stress \[Pa\] up to `most` that leaves a virgin point whole, to round-off.
pub fn strength(law: &Concrete, most: f64, stress: impl Fn(f64) -> [f64; 3]) -> f64 {
    let (mut low, mut high) = (0.0, most);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if damage(law, stress(middle)) == [0.0; 2] { low = middle } else { high = middle }
    }
    low
}

/// A point of a cube of edge h \[m\] at a time step \[s\].
pub fn cube(dt: f64, h: f64) -> Point<f64> {
    Point { size: [h * h, h * h, h * h, 0.0, 0.0, 0.0], ..Point::new(dt) }
}

/// n + 1 values from a to b.
pub fn ramp(a: f64, b: f64, n: usize) -> Vec<f64> {
    (0..=n).map(|i| a + (b - a) * i as f64 / n as f64).collect()
}

/// Xorshift: the same numbers between −1 and 1 on every machine.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    pub fn symmetric(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        2.0 * ((self.0 >> 11) as f64 / (1u64 << 53) as f64) - 1.0
    }

    /// A strain whose components reach `size`.
    pub fn strain(&mut self, size: f64) -> [f64; 6] {
        [0; 6].map(|_| size * self.symmetric())
    }
}
