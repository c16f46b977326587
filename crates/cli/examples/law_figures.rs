//! Draws the figures of docs/laws.md: `cargo run --release -p tremolite-cli --example law_figures`.
//!
//! All curves are driven through the laws themselves; [`figures`] has them, and a test compares them with the files.

#[path = "law_figures/interfaces.rs"]
mod interfaces;

use std::borrow::Cow;
use std::path::Path as File;
use tremolite_laws::materials::{Concrete, DruckerPrager, HoekBrown, MohrCoulomb};
use tremolite_laws::path::{Control, Path, Response, drive};
use tremolite_laws::{Material, Point, Value, Values};
use tremolite_report::loops::{Curve, Loops, Named, Plane, Quantity};

fn main() -> std::io::Result<()> {
    let folder = File::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/laws");
    for (name, svg) in figures() {
        std::fs::write(folder.join(name), svg)?;
    }
    Ok(())
}

/// Every figure with the name of its file.
pub fn figures() -> Vec<(&'static str, String)> {
    vec![
        ("concrete-uniaxial.svg", concrete_uniaxial()),
        ("concrete-biaxial.svg", concrete_biaxial()),
        ("concrete-rates.svg", concrete_rates()),
        ("rock-envelopes.svg", rock_envelopes()),
        ("rock-triaxial.svg", rock_triaxial()),
        ("interfaces.svg", interfaces::figure()),
    ]
}

/// A law from its numbers and words, which are those of this file.
fn values(numbers: &[(&str, f64)], words: &[(&str, &str)]) -> Values {
    let mut values = Values::default();
    for (key, number) in numbers {
        values = values.with(key, *number);
    }
    for (key, word) in words {
        values.0.insert((*key).to_owned(), Value::Word((*word).to_owned()));
    }
    values
}

fn built<M: Material>(values: &Values) -> M {
    M::new(values).unwrap_or_else(|faults| panic!("{}: {faults:?}", M::NAME))
}

fn law<M: Material>(numbers: &[(&str, f64)], words: &[(&str, &str)]) -> M {
    built(&values(numbers, words))
}

/// The concrete of `wang2018`, table 1.
const CONCRETE: [(&str, f64); 5] = [
    ("young", 25e9),
    ("poisson", 0.17),
    ("tensile_strength", FT),
    ("cohesion", 2e6),
    ("friction_angle", 46.0 * std::f64::consts::PI / 180.0),
];
const YOUNG: f64 = 25e9;
const FT: f64 = 1.2e6;
const THRESHOLD: f64 = FT / YOUNG;

/// That concrete with more numbers and words, static.
fn concrete(numbers: &[(&str, f64)], words: &[(&str, &str)]) -> Concrete {
    let own = [("rate", "none"), ("evolution", "residual"), ("split", "effective")];
    let static_words: Vec<_> = own.iter().chain(words).copied().collect();
    law(&[&CONCRETE, numbers].concat(), &static_words)
}

/// n + 1 values from a to b.
fn ramp(a: f64, b: f64, n: usize) -> impl Iterator<Item = f64> {
    (0..=n).map(move |i| a + (b - a) * i as f64 / n as f64)
}

fn curve<'a>(name: &str, colour: usize, points: impl IntoIterator<Item = [f64; 2]>) -> Curve<'a> {
    let (across, up): (Vec<f64>, Vec<f64>) = points.into_iter().map(|[x, y]| (x, y)).unzip();
    Curve { name: name.into(), colour, across: across.into(), up: Cow::from(up), points: false }
}

fn plane<'a>(across: Quantity, up: Quantity, curves: Vec<Curve<'a>>) -> Plane<'a> {
    Plane { across, up, curves, named: Named::Nothing }
}

fn draw(title: &str, planes: Vec<Plane<'_>>) -> String {
    Loops {
        title: title.into(),
        along: Quantity::new("", ""),
        time: &[],
        planes,
        tracks: vec![],
        states: None,
    }
    .draw()
}

fn stress(name: &str) -> Quantity {
    Quantity::new(name, "Pa")
}

/// Stress over strain under uniaxial stress, effective split: the lateral strain is −νε.
fn uniaxial(law: &Concrete, strain: impl Iterator<Item = f64>, size: f64) -> Vec<[f64; 2]> {
    let strain: Vec<[f64; 6]> = strain.map(|e| [e, -0.17 * e, -0.17 * e, 0.0, 0.0, 0.0]).collect();
    let path = Path { size: Some(size), ..Path::strains(vec![0.0; strain.len()], strain) };
    let response = drive(law, &path).unwrap_or_else(|e| panic!("{e}"));
    response.strain.iter().zip(&response.stress).map(|(e, s)| [e[0], s[0]]).collect()
}

fn concrete_uniaxial() -> String {
    let law = concrete(&[], &[]);
    let legs = [0.0, 4.0, -4.0, 14.0, -10.0, 6.0].map(|x| x * THRESHOLD);
    let cycle = legs.windows(2).flat_map(|leg| ramp(leg[0], leg[1], 600));
    let cycle = plane(
        Quantity::new("strain", ""),
        stress("stress"),
        vec![curve("cycle", 0, uniaxial(&law, cycle, 0.5))],
    );
    let softening = [
        ("residual", 0.25, "0.25 m"),
        ("residual", 1.0, "1 m"),
        ("exponential", 0.25, "band 0.25"),
        ("exponential", 1.0, "band 1"),
    ];
    let curves = softening.iter().enumerate().map(|(k, &(evolution, h, name))| {
        let law = concrete(&[("fracture_energy", 130.0)], &[("evolution", evolution)]);
        // Opening of an element of that size, up to 1.2 mm.
        let path = uniaxial(&law, ramp(0.0, 1.2e-3 / h, 1500), h);
        curve(name, k, path.into_iter().map(|[e, s]| [e * h, s]))
    });
    let softening =
        plane(Quantity::new("lengthening of the element", "m"), stress("stress"), curves.collect());
    draw("Concrete under uniaxial stress: a cycle, and softening with G_f = 130 N/m", vec![cycle, softening])
}

/// The largest multiple of a direction of principal stress that leaves a virgin point whole.
fn strength(law: &Concrete, direction: [f64; 2]) -> [f64; 2] {
    let whole = |x: f64| {
        let [a, b] = direction.map(|c| c * x);
        let e = [(a - 0.17 * b) / YOUNG, (b - 0.17 * a) / YOUNG, -0.17 * (a + b) / YOUNG, 0.0, 0.0, 0.0];
        let (_, history) = law.update(&Point::<f64>::new(0.0), e, tremolite_laws::virgin::<Concrete>());
        history[0] == 0.0 && history[1] == 0.0
    };
    let (mut low, mut high) = (0.0, 20.0 * law.strengths()[1]);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if whole(middle) { low = middle } else { high = middle }
    }
    direction.map(|c| c * low)
}

fn concrete_biaxial() -> String {
    let drivers = ["strain", "stress"].map(|driver| (driver, concrete(&[], &[("driver", driver)])));
    let [ft, fc] = drivers[0].1.strengths();
    let envelope = |law: &Concrete| -> Vec<[f64; 2]> {
        ramp(0.25, 1.25, 1440)
            .map(|turn| (turn * std::f64::consts::TAU).sin_cos())
            .map(|(sine, cosine)| strength(law, [sine, cosine]).map(|s| s / fc))
            .collect()
    };
    let mut curves: Vec<Curve> =
        drivers.iter().enumerate().map(|(k, (driver, law))| curve(driver, k, envelope(law))).collect();
    // Kupfer & Gerstle (1973), their fits; tension over f_t, pressure over f_c.
    let pressed = ramp(0.0, 1.0, 40).map(|a| {
        let c = (1.0 + 3.65 * a) / ((1.0 + a) * (1.0 + a));
        [-a * c, -c]
    });
    let mixed = ramp(0.0, 1.0, 40).map(|c| [ft / fc * (1.0 - 0.8 * c), -c]);
    let half: Vec<[f64; 2]> = mixed.collect::<Vec<_>>().into_iter().chain(pressed).collect();
    let whole: Vec<[f64; 2]> = [[ft / fc, ft / fc]]
        .into_iter()
        .chain(half.iter().copied())
        .chain([[f64::NAN; 2], [ft / fc, ft / fc]])
        .chain(half.iter().map(|[x, y]| [*y, *x]))
        .collect();
    curves.push(curve("fit to tests", 3, whole));
    // Kupfer, Hilsdorf & Rüsch (1969): 16 % more under equal pressures, as much under equal tensions.
    let mut tests = curve("tests", 4, [[-1.16, -1.16], [ft / fc, ft / fc], [-1.0, 0.0], [0.0, -1.0]]);
    tests.points = true;
    curves.push(tests);
    let quantity = |name: &str| Quantity::new(name, "");
    let near = curves
        .iter()
        .map(|c| {
            let inside = c.across.iter().zip(c.up.iter()).map(|(&x, &y)| match x > -0.14 && y > -0.62 {
                true => [x, y],
                false => [f64::NAN; 2],
            });
            Curve { points: c.points, ..curve(&c.name, c.colour, inside) }
        })
        .collect();
    let all = plane(quantity("σ₁ over f_c"), quantity("σ₂ over f_c"), curves);
    let mut near = plane(quantity("σ₁ over f_c"), quantity("the tension side"), near);
    near.curves.iter_mut().for_each(|c| c.name = "the tension side".into());
    draw("Concrete under biaxial stress: where damage starts, beside tests", vec![all, near])
}

fn concrete_rates() -> String {
    let rates: Vec<f64> = ramp(-6.5, 2.0, 120).collect();
    let factors = |column: usize| -> Vec<Curve<'static>> {
        let fc = concrete(&[], &[]).strengths()[1];
        let codes = ["ceb", "mc90", "mc2010"].iter().enumerate();
        codes
            .map(|(k, code)| {
                let law = concrete(&[("rate_filter_time", 0.0)], &[("rate", code)]);
                let factor = |rate: f64| {
                    let most = if column == 6 { THRESHOLD } else { fc / YOUNG };
                    let (mut history, mut strain) = (tremolite_laws::virgin::<Concrete>(), 0.0);
                    while history[column] == 0.0 && strain < 10.0 * most {
                        strain += 1e-2 * most;
                        let e = if column == 6 { strain } else { -strain };
                        let e = [e, -0.17 * e, -0.17 * e, 0.0, 0.0, 0.0];
                        (_, history) = law.update(&Point::new(1e-2 * most / rate), e, history);
                    }
                    history[column]
                };
                curve(code, k, rates.iter().map(|&x| [x, factor(10f64.powf(x))]))
            })
            .collect()
    };
    let across = || Quantity::new("log₁₀ of the rate of strain in 1/s", "");
    let planes = vec![
        plane(across(), Quantity::new("factor of f_t", ""), factors(6)),
        plane(across(), Quantity::new("factor of f_c", ""), factors(7)),
    ];
    draw("Strength of the paper's concrete (f_c = 9.9 MPa) over its static strength", planes)
}

/// Moduli of the rocks, and the paper's rock with a cut-off of 1 MPa.
const MODULI: [(&str, f64); 2] = [("young", 10e9), ("poisson", 0.25)];
const ROCK: [(&str, f64); 3] = [
    ("cohesion", 2.18e6),
    ("friction_angle", 42.0 * std::f64::consts::PI / 180.0),
    ("tensile_strength", 1e6),
];

/// Pressure along x and y, strain along z.
fn triaxial<M: Material>(law: &M, pressure: f64, end: f64, rows: usize) -> Response {
    let mut control = [Control::Strain; 6];
    control[0] = Control::Stress;
    control[1] = Control::Stress;
    let values = ramp(0.0, end, rows).map(|e| [-pressure, -pressure, e, 0.0, 0.0, 0.0]).collect();
    drive(law, &Path { time: vec![0.0; rows + 1], values, control, size: None })
        .unwrap_or_else(|e| panic!("{e}"))
}

fn rock_envelopes() -> String {
    let mc: MohrCoulomb = law(&[&MODULI[..], &ROCK].concat(), &[]);
    let mass = |gsi: f64, d: f64| -> HoekBrown {
        law(
            &[
                &MODULI[..],
                &[("compressive_strength", 80e6), ("gsi", gsi), ("m_i", 12.0), ("disturbance", d)],
            ]
            .concat(),
            &[],
        )
    };
    let cone = |fit: &str| -> DruckerPrager { law(&[&MODULI[..], &ROCK].concat(), &[("fit", fit)]) };
    fn strongest<M: Material>(law: &M, pressure: f64) -> [f64; 2] {
        [pressure, -triaxial(law, pressure, -0.12, 60).stress[60][2]]
    }
    let pressures: Vec<f64> = ramp(0.0, 20e6, 40).collect();
    let over = |name: &str, colour: usize, strongest: &dyn Fn(f64) -> [f64; 2]| {
        curve(name, colour, pressures.iter().map(|&p| strongest(p)))
    };
    let (outer, inner) = (cone("outer"), cone("inner"));
    let masses = [(100.0, 0.0, "GSI 100"), (75.0, 0.0, "75"), (50.0, 0.0, "50"), (50.0, 1.0, "50 and D = 1")];
    let planes = vec![
        plane(
            stress("pressure around, σ₃"),
            stress("σ₁"),
            vec![
                over("Mohr–Coulomb", 0, &|p| strongest(&mc, p)),
                over("DP outer", 1, &|p| strongest(&outer, p)),
                over("DP inner", 2, &|p| strongest(&inner, p)),
            ],
        ),
        plane(
            stress("pressure around, σ₃"),
            stress("σ₁"),
            masses
                .iter()
                .enumerate()
                .map(|(k, &(gsi, d, name))| {
                    let law = mass(gsi, d);
                    over(name, k, &|p| strongest(&law, p))
                })
                .collect(),
        ),
    ];
    draw("Rock in triaxial compression: c = 2.18 MPa, φ = 42°; Hoek–Brown, σ_ci = 80 MPa, m_i = 12", planes)
}

fn rock_triaxial() -> String {
    let rock = |numbers: &[(&str, f64)]| -> MohrCoulomb { law(&[&MODULI[..], &ROCK, numbers].concat(), &[]) };
    let dilatant = [&MODULI[..], &ROCK, &[("dilation_angle", 10f64.to_radians())]].concat();
    let softening = [
        ("plastic_shear_strain", &[0.0, 0.01][..]),
        ("cohesion", &[2.18e6, 0.5e6]),
        ("friction_angle", &[42f64.to_radians(), 32f64.to_radians()]),
    ];
    let softening = values(&dilatant, &[]).with_table("softening", &softening);
    let laws =
        [("ψ = 0°", rock(&[])), ("ψ = 10°", law(&dilatant, &[])), ("ψ = 10°, softening", built(&softening))];
    let runs: Vec<(&str, Response)> =
        laws.iter().map(|(name, law)| (*name, triaxial(law, 5e6, -0.03, 600))).collect();
    // Strain since the confinement was on, compression positive.
    let rows = |response: &Response, value: &dyn Fn(usize) -> f64| -> Vec<[f64; 2]> {
        (0..response.strain.len()).map(|row| [-response.strain[row][2], value(row)]).collect()
    };
    let strengths =
        runs.iter().enumerate().map(|(k, (name, r))| curve(name, k, rows(r, &|row| -r.stress[row][2])));
    let volumes = runs.iter().enumerate().map(|(k, (_, r))| {
        curve("growth of volume", k, rows(r, &|row| r.strain[row][..3].iter().sum::<f64>()))
    });
    let across = || Quantity::new("shortening", "");
    let planes = vec![
        plane(across(), stress("stress"), strengths.collect()),
        plane(across(), Quantity::new("growth of volume", ""), volumes.collect()),
    ];
    draw("Mohr–Coulomb rock in triaxial compression at 5 MPa", planes)
}
