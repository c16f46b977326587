use super::*;
use serde_json::Value;
use std::f64::consts::TAU;
use tremolite_motion::transferred;

/// What pyStrata finds for three profiles; `make_stored.py` beside it made it.
fn stored() -> Value {
    serde_json::from_str(include_str!("stored.json")).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

/// The motion of the script: two groups of waves, then quiet until what rings has gone.
fn motion(of: &Value) -> (Vec<f64>, f64) {
    let [dt, count, peak] = ["dt", "count", "peak"].map(|key| of[key].as_f64().unwrap());
    let group = |t: f64, at: f64, width: f64, hertz: f64| {
        (-((t - at) / width).powi(2)).exp() * (TAU * hertz * (t - at)).sin()
    };
    let sample = |t: f64| peak * (group(t, 9.0, 1.5, 1.7) + 0.6 * group(t, 12.0, 2.0, 4.3));
    ((0..count as usize).map(|k| sample(k as f64 * dt)).collect(), dt)
}

fn curves(of: &Value) -> Curves {
    let number = |key: &str| of[key].as_f64().unwrap();
    match of["curves"].as_str().unwrap() {
        "linear" => Curves::Linear(number("damping")),
        "vucetic-dobry" => Curves::vucetic_dobry(number("plasticity_index")).unwrap(),
        "darendeli" => Curves::Darendeli(Darendeli {
            frequency: number("frequency"),
            cycles: number("cycles"),
            ..Darendeli::new(number("plasticity_index"), number("ocr"), number("stress"))
        }),
        _ => Curves::Table(
            CurveTable::new(
                of["table"]
                    .as_array()
                    .unwrap()
                    .iter()
                    .map(|row| {
                        let row = numbers(row);
                        [row[0], row[1], row[2]]
                    })
                    .collect(),
            )
            .unwrap(),
        ),
    }
}

fn profile(of: &Value) -> (Vec<Soil>, Rock, Given) {
    let soil = |layer: &Value| {
        let number = |key: &str| layer[key].as_f64().unwrap();
        Soil {
            thickness: number("thickness"),
            density: number("density"),
            speed: number("speed"),
            curves: curves(layer),
        }
    };
    let rock = Rock {
        density: of["rock"]["density"].as_f64().unwrap(),
        speed: of["rock"]["speed"].as_f64().unwrap(),
    };
    let given = if of["given"] == "surface" { Given::Surface } else { Given::Outcrop };
    (of["layers"].as_array().unwrap().iter().map(soil).collect(), rock, given)
}

/// Largest pseudo-acceleration \[m/s²\] of oscillators (Hz) of 5 %, in frequency, at the samples.
fn spectrum(acceleration: &[f64], dt: f64, oscillators: &[f64]) -> Vec<f64> {
    let of = |&own: &f64| {
        let answer = |omega: f64| {
            let f = omega / TAU;
            Complex64::from(own * own) / Complex64::new(own * own - f * f, 0.1 * own * f)
        };
        transferred(acceleration, dt, &answer).iter().fold(0.0, |most: f64, a| most.max(a.abs()))
    };
    oscillators.iter().map(of).collect()
}

fn worst(found: &[f64], known: &[f64]) -> f64 {
    assert_eq!(found.len(), known.len());
    found.iter().zip(known).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max)
}

#[test]
fn columns_are_those_of_pystrata() {
    let stored = stored();
    let mut seen = Vec::new();
    for of in stored["profiles"].as_array().unwrap() {
        let (acceleration, dt) = motion(&of["motion"]);
        let (soils, rock, given) = profile(of);
        let exact = Search { tolerance: 1e-12, ..Search::default() };
        let fitted = fit(&soils, rock, &acceleration, dt, given, exact).unwrap();
        let strain: Vec<f64> = fitted.layers.iter().map(|layer| layer.strain).collect();
        let modulus: Vec<f64> = fitted.layers.iter().map(|layer| layer.modulus).collect();
        let damping: Vec<f64> = fitted.layers.iter().map(|layer| layer.damping).collect();
        let name = &of["name"];
        for (found, key) in [(&strain, "strain"), (&modulus, "modulus"), (&damping, "damping")] {
            let error = worst(found, &numbers(&of[key]));
            assert!(error < 1e-6, "{name}: {key} {error:e}");
        }
        // Some of it is soft, or the test would be of a linear column.
        assert!(modulus.iter().any(|m| *m < 0.8), "{name}: {modulus:?}");
        let oscillators = numbers(&stored["oscillators"]);
        let surface = match given {
            Given::Outcrop => at_surface(&fitted, &acceleration, dt, given),
            // What comes up from the rock, as at its surface.
            Given::Surface => at_outcrop(&fitted, &acceleration, dt),
        };
        let error = worst(&spectrum(&surface, dt, &oscillators), &numbers(&of["spectrum"]));
        assert!(error < 1e-6, "{name}: spectrum {error:e}");
        seen.push(error);
        // The linear column of small strains is another: the test can fail.
        let stiff: Vec<Soil> = soils
            .iter()
            .map(|soil| Soil { curves: Curves::Linear(soil.curves.at(0.0)[1]), ..soil.clone() })
            .collect();
        let linear = fit(&stiff, rock, &acceleration, dt, given, exact);
        if let Ok(linear) = linear {
            let surface = match given {
                Given::Outcrop => at_surface(&linear, &acceleration, dt, given),
                Given::Surface => at_outcrop(&linear, &acceleration, dt),
            };
            assert!(worst(&spectrum(&surface, dt, &oscillators), &numbers(&of["spectrum"])) > 0.05, "{name}");
        }
    }
    assert_eq!(seen.len(), 3);
}

#[test]
fn curves_are_those_of_pystrata() {
    let stored = stored();
    for of in stored["curves"].as_array().unwrap() {
        let curves = curves(of);
        for row in of["points"].as_array().unwrap() {
            let row = numbers(row);
            let [modulus, damping] = curves.at(row[0]);
            assert!(
                (modulus / row[1] - 1.0).abs() < 1e-9 && (damping / row[2] - 1.0).abs() < 1e-9,
                "{of}: {row:?} {modulus} {damping}"
            );
        }
    }
    // Small strains are gone through without a step where the series ends.
    let soil = Darendeli::new(15.0, 1.0, 1e5);
    let at = |x: f64| soil.at(x * soil.reference_strain())[1];
    let (below, above) = (at(0.999_999e-3), at(1.000_001e-3));
    assert!((above - below).abs() < 1e-8, "{below} {above}");
    assert_eq!(soil.at(0.0), [1.0, soil.least_damping()]);
    assert!(Curves::vucetic_dobry(201.0).is_none() && Curves::vucetic_dobry(-1.0).is_none());
    for (rows, words) in [
        (vec![[0.0, 1.0, 0.01]], "rise"),
        (vec![[1e-5, 1.0, 0.01], [1e-5, 0.9, 0.02]], "rise"),
        (vec![[1e-5, 0.9, 0.01], [1e-4, 0.95, 0.02]], "falls"),
        (vec![[1e-5, 1.0, 0.6]], "damping"),
        (vec![], "a row"),
    ] {
        let told = CurveTable::new(rows).unwrap_err();
        assert!(told.contains(words), "{told}");
    }
}

#[test]
fn a_surface_record_goes_down_and_comes_up_again_with_its_strains() {
    let stored = stored();
    let of = &stored["profiles"][0];
    let (acceleration, dt) = motion(&of["motion"]);
    let (soils, rock, _) = profile(of);
    let search = Search { tolerance: 1e-10, ..Search::default() };
    let up = fit(&soils, rock, &acceleration, dt, Given::Outcrop, search).unwrap();
    let surface = at_surface(&up, &acceleration, dt, Given::Outcrop);
    let down = fit(&soils, rock, &surface, dt, Given::Surface, search).unwrap();
    for (a, b) in up.layers.iter().zip(&down.layers) {
        assert!((a.strain / b.strain - 1.0).abs() < 1e-6, "{a:?} {b:?}");
    }
}

#[test]
fn what_is_too_soft_or_finds_no_rest_is_refused() {
    let stored = stored();
    let of = &stored["profiles"][0];
    let (acceleration, dt) = motion(&of["motion"]);
    let (soils, rock, given) = profile(of);
    let strong: Vec<f64> = acceleration.iter().map(|a| 20.0 * a).collect();
    let Err(Unfit::Strained { layer, strain }) = fit(&soils, rock, &strong, dt, given, Search::default())
    else {
        panic!()
    };
    assert!(layer < soils.len() && strain > MOST_STRAIN);
    let Err(Unfit::Restless { change }) =
        fit(&soils, rock, &acceleration, dt, given, Search { most_rounds: 2, ..Search::default() })
    else {
        panic!()
    };
    assert!(change > 1e-4);
    assert_eq!(fit(&[], rock, &acceleration, dt, given, Search::default()).unwrap_err(), Unfit::Nothing);
    assert_eq!(fit(&soils, rock, &[0.0; 8], dt, given, Search::default()).unwrap_err(), Unfit::Nothing);
}

/// Halving the layers changes little: strain in the middle of a layer stands for all of it.
#[test]
fn a_layer_is_the_mean_of_its_halves() {
    let soil = |thickness: f64| Soil {
        thickness,
        density: 1900.0,
        speed: 220.0,
        curves: Curves::vucetic_dobry(15.0).unwrap(),
    };
    let rock = Rock { density: 2300.0, speed: 1200.0 };
    let (acceleration, dt) = motion(&stored()["profiles"][0]["motion"]);
    let spectra: Vec<Vec<f64>> = [10, 20, 40]
        .map(|count| {
            let soils = vec![soil(20.0 / f64::from(count)); count as usize];
            let fitted = fit(&soils, rock, &acceleration, dt, Given::Outcrop, Search::default()).unwrap();
            spectrum(&at_surface(&fitted, &acceleration, dt, Given::Outcrop), dt, &[0.5, 1.0, 2.0, 4.0, 8.0])
        })
        .into();
    let (coarse, fine) = (worst(&spectra[0], &spectra[2]), worst(&spectra[1], &spectra[2]));
    assert!(coarse < 0.02 && fine < 0.5 * coarse, "{coarse} {fine}");
}
