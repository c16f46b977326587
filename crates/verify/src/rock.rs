//! One point of rock along a path of triaxial or plane-strain tests.

use crate::VerifyError;
use tremolite_laws::path::{Control, Path, Response, drive_named};
use tremolite_laws::{Value, Values};

/// E \[Pa\] and ν of the points.
pub const YOUNG: f64 = 10e9;
pub const POISSON: f64 = 0.25;

/// (1 + sin x)/(1 − sin x) for an angle in degrees: k of friction, M of dilation.
pub fn slope(degrees: f64) -> f64 {
    let sine = degrees.to_radians().sin();
    (1.0 + sine) / (1.0 - sine)
}

/// A law of the list and its parameters.
pub struct Rock {
    law: &'static str,
    values: Values,
}

/// The law with these numbers on top of the moduli, and a word.
pub fn rock(law: &'static str, numbers: &[(&str, f64)], words: &[(&str, &str)]) -> Rock {
    let mut values = Values::default().with("young", YOUNG).with("poisson", POISSON);
    for (key, number) in numbers {
        values = values.with(key, *number);
    }
    for (key, word) in words {
        values.0.insert((*key).to_owned(), Value::Word((*word).to_owned()));
    }
    Rock { law, values }
}

/// What the point has across y.
#[derive(Clone, Copy, PartialEq)]
pub enum Across {
    /// The pressure of x.
    Pressed,
    /// No strain.
    Plane,
}

/// Pressure \[Pa\] along x, strain along z up to `end` in `rows` steps.
///
/// # Errors
/// If the law refuses its parameters, or no strain gives the pressure.
pub fn axial(
    rock: &Rock,
    pressure: f64,
    across: Across,
    end: f64,
    rows: usize,
) -> Result<Response, VerifyError> {
    let mut control = [Control::Strain; 6];
    control[0] = Control::Stress;
    let mut side = 0.0;
    if across == Across::Pressed {
        control[1] = Control::Stress;
        side = -pressure;
    }
    let values = (0..=rows).map(|k| [-pressure, side, end * k as f64 / rows as f64, 0.0, 0.0, 0.0]).collect();
    let path = Path { time: vec![0.0; rows + 1], values, control, size: None };
    drive_named(rock.law, &rock.values, &path).map_err(|e| VerifyError::Setup(e.to_string()))
}
