//! Soft ground: the equivalent-linear column of a script's layers.

use crate::away::{Desk, away, pool};
use crate::errors::unusable;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::atomic::AtomicBool;
use tremolite::equivalent_linear::{CurveTable, Curves, Darendeli, Given, Reached, Rock, Search, Soil, fit};

/// A layer's curves as Python gives them: what they are called, and their numbers.
#[derive(FromPyObject)]
enum Law {
    Damping(f64),
    Table(Vec<[f64; 3]>),
}

/// Strain, G/Gmax and damping ratio of layers (thickness \[m\], density \[kg/m³\], velocity \[m/s\], the kind of its curves and these) from the
/// surface down on a rock (density, velocity), under an acceleration \[m/s²\] every `dt` \[s\]; and the rounds it took.
#[pyfunction]
fn equivalent_linear(
    py: Python<'_>,
    layers: Vec<(f64, f64, f64, String, Bound<'_, PyAny>)>,
    rock: (f64, f64),
    acceleration: Vec<f64>,
    dt: f64,
    at_surface: bool,
    share: f64,
) -> PyResult<(Vec<[f64; 3]>, usize)> {
    let positive = |x: f64, what: &str| match x.is_finite() && x > 0.0 {
        true => Ok(x),
        false => Err(unusable(format!("{what} is above 0, and {x} is not"))),
    };
    let mut soils = Vec::new();
    for (k, (thickness, density, speed, kind, law)) in layers.into_iter().enumerate() {
        let of = |what: &str| format!("{what} of layer {}", k + 1);
        soils.push(Soil {
            thickness: positive(thickness, &of("the thickness"))?,
            density: positive(density, &of("the density"))?,
            speed: positive(speed, &of("the velocity"))?,
            curves: curves(&kind, &law)
                .map_err(|why| unusable(format!("layer {}: {}", k + 1, why.value(py))))?,
        });
    }
    let rock = Rock {
        density: positive(rock.0, "the density of the rock")?,
        speed: positive(rock.1, "its velocity")?,
    };
    positive(dt, "dt")?;
    if !(share > 0.0 && share <= 1.0) {
        return Err(unusable(format!("share is from 0 to 1, and {share} is not; 0.65 is usual")));
    }
    if !acceleration.iter().all(|a| a.is_finite()) {
        return Err(unusable("the motion has samples that are no numbers"));
    }
    let given = if at_surface { Given::Surface } else { Given::Outcrop };
    let search = Search { share, ..Search::default() };
    let pool = pool(None)?;
    let work = || fit(&soils, rock, &acceleration, dt, given, search);
    let back = away(py, &pool, &Desk::default(), &AtomicBool::new(false), work)?;
    if let Some(interrupt) = back.interrupt {
        return Err(interrupt);
    }
    let fitted = back.result.map_err(unusable)?;
    let row = |reached: &Reached| [reached.strain, reached.modulus, reached.damping];
    Ok((fitted.layers.iter().map(row).collect(), fitted.rounds))
}

fn curves(kind: &str, law: &Bound<'_, PyAny>) -> PyResult<Curves> {
    let number = |from: &Bound<'_, PyDict>, key: &str, usual: Option<f64>| -> PyResult<f64> {
        let given: Option<f64> = from.get_item(key)?.map(|x| x.extract()).transpose()?;
        given
            .or(usual)
            .filter(|x| x.is_finite() && *x >= 0.0)
            .ok_or_else(|| unusable(format!("darendeli wants {key}, a number")))
    };
    if kind == "darendeli" {
        let from = law
            .cast::<PyDict>()
            .map_err(|_| unusable("darendeli is a dict with plasticity_index, stress and perhaps ocr"))?;
        let made = Darendeli {
            plasticity_index: number(from, "plasticity_index", None)?,
            ocr: number(from, "ocr", Some(1.0))?,
            stress: number(from, "stress", None)?,
            frequency: number(from, "frequency", Some(1.0))?,
            cycles: number(from, "cycles", Some(10.0))?,
        };
        let known = ["plasticity_index", "ocr", "stress", "frequency", "cycles"];
        for key in from.keys() {
            let key: String = key.extract()?;
            if !known.contains(&key.as_str()) {
                return Err(unusable(format!("darendeli has no {key:?}; there are {}", known.join(", "))));
            }
        }
        if made.ocr < 1.0
            || made.stress <= 0.0
            || made.frequency <= 0.0
            || made.cycles < 1.0
            || made.least_damping() < 0.0
        {
            return Err(unusable(
                "darendeli: ocr and cycles are 1 at least, stress [Pa] and frequency [Hz] above 0 (and not so low that damping is negative)",
            ));
        }
        return Ok(Curves::Darendeli(made));
    }
    match (kind, law.extract::<Law>()?) {
        ("vucetic_dobry", Law::Damping(index)) => Curves::vucetic_dobry(index).ok_or_else(|| {
            unusable(format!("vucetic_dobry is a plasticity index from 0 to 200, and {index} is not"))
        }),
        ("damping", Law::Damping(damping)) if (0.0..0.5).contains(&damping) => Ok(Curves::Linear(damping)),
        ("damping", _) => Err(unusable("damping is a ratio from 0 to 0.5")),
        ("table", Law::Table(rows)) => CurveTable::new(rows).map(Curves::Table).map_err(unusable),
        _ => Err(unusable(format!("{kind}: a table is rows of (shear strain, G/Gmax, damping ratio)"))),
    }
}

pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(equivalent_linear, module)?)
}
