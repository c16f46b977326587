//! A reinforced strip of concrete in tension: where it cracks, and how much stiffer it is than its bars.
//!
//! 1.2 m long, 0.2 × 0.2 m, C30/37 with Model Code's G_f, 1.5 % of steel along its axis that moves with the concrete, as
//! `[[reinforcement]]` does; the exponential law with the compliance split. Pulled at its ends to a mean strain of 2·10⁻³.
//!
//! **Exact.** The first crack opens at N_cr = A_c f_t (1 + nρ), n = E_s/E, without concrete taken out for the steel. Once all elements
//! have cracked each stretches alike, and the strip carries E_s A_s ε + A_c σ(ε), σ the law's stress with the length h of an element:
//! f_t exp\[−(ε − ε_t)/ε_f\], ε_f = G_f/(f_t h) − ½ε_t. Before, they crack one after the other where h is
//! long, and the force is a saw; concrete nowhere pushes.
//!
//! **Beside codes.** With k_t = 0.6 under short loads EN 1992-1-1 (`en1992`, 7.3.4) leaves 0.6 N_cr beyond the bare bars, Model Code 1990
//! (`mc1990`, 3.2) 0.4 f_t A_c for cracks that are all there: what bond brings into the concrete between cracks. Here nothing slips, and
//! each row of elements is one crack: what concrete carries is its own softening and goes by h alone, the less the longer the element.
//! Neither spacing nor stiffening is a result.

use crate::bolted::{STEEL, bolts};
use crate::models::QUADRATURES;
use crate::specimen::plate::Plate;
use crate::specimen::{BAND, Grip, Mix, Specimen, Tested, steps};
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::Quadrature;
use tremolite_laws::materials::concrete::Grade;

const NAME: &str = "tension_stiffening";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a reinforced strip in tension: force of the first crack, and what concrete carries beside the bars, by mesh",
    source: "bars and concrete in parallel; `en1992`, 7.3.4; `mc1990`, 3.2",
    from: Effort::Verify,
    run,
};

/// Length and side \[m\], share of steel.
const LENGTH: f64 = 1.2;
const SIDE: f64 = 0.2;
const STEEL_SHARE: f64 = 0.015;
/// Lengths of elements \[m\].
const SIZES: [f64; 3] = [0.2, 0.1, 0.05];
/// Mean strains at which forces are compared.
const STRAINS: [f64; 3] = [0.5e-3, 1e-3, 2e-3];

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let Some(grade) = Grade::named("C30/37") else { return Err(VerifyError::Setup("no C30/37".into())) };
    let mix = Mix {
        young: grade.young,
        poisson: grade.poisson,
        tension: grade.tensile_strength,
        energy: grade.fracture_energy,
        compression: grade.compressive_strength,
    };
    let area = SIDE * SIDE;
    let first = area * mix.tension * (1.0 + STEEL / mix.young * STEEL_SHARE);
    for size in SIZES {
        for (quadrature, kind) in QUADRATURES {
            let tested = strip(&mix, size, quadrature)?;
            let word = format!("{size} m, {kind}");
            let found = tested.readings.windows(2).find(|pair| pair[1].taken > 0.0).map_or(f64::NAN, |pair| pair[0].force);
            let note = "1.5 %: steps of the machine of 1 %, and a ramp's own";
            checks.push(Check::new(NAME, format!("force of the first crack, {word}"), found, first, 0.015 * first, "N", note));
            let share = |force: f64, strain: f64| (force - STEEL * STEEL_SHARE * area * strain) / (area * mix.tension);
            let least = tested.readings.iter().map(|r| share(r.force, r.way / LENGTH)).fold(f64::INFINITY, f64::min);
            let note = "1e-3: at rest to 1e-4 of all contributions";
            checks.push(Check::new(NAME, format!("largest pressure in concrete over f_t, {word}"), (-least).max(0.0), 0.0, 1e-3, "1", note));
            for strain in STRAINS {
                let found = share(tested.force_at_way(strain * LENGTH), strain);
                let quantity = format!("what concrete carries over f_t at a strain of {strain}, {word}");
                let own = softened(&mix, size, strain);
                checks.push(if quadrature == Quadrature::OnePoint && strain > 0.9e-3 {
                    let note = "0.02: all elements have cracked, and are alike";
                    Check::new(NAME, &*quantity, found, own, 0.02, "1", note)
                } else {
                    let note = "for information: not all points have cracked alike";
                    Check::beside(NAME, &*quantity, found, own, "1", note)
                });
                let note = "for information: Model Code 1990; EN 1992-1-1 has about half as much again";
                checks.push(Check::beside(NAME, format!("{quantity}, beside Model Code"), found, 0.4, "1", note));
            }
        }
    }
    for strain in [1e-3, 2e-3] {
        // exp[−(ε − ε_t)/ε_f] = 0.4.
        let threshold = mix.tension / mix.young;
        let softens = (strain - threshold) / -(0.4f64.ln());
        let size = mix.energy / (mix.tension * (softens + 0.5 * threshold));
        let note = "for information: the law's stress is 0.4 f_t there";
        let quantity = format!("element that stiffens as Model Code has it at a strain of {strain}, beside 0.1 m");
        checks.push(Check::beside(NAME, quantity, size, 0.1, "m", note));
    }
    Ok(checks)
}

/// The law's stress over f_t in an element of this length \[m\].
fn softened(mix: &Mix, size: f64, strain: f64) -> f64 {
    let threshold = mix.tension / mix.young;
    let softens = mix.energy / (mix.tension * size) - 0.5 * threshold;
    (-(strain - threshold) / softens).exp()
}

fn strip(mix: &Mix, size: f64, quadrature: Quadrature) -> Result<Tested, VerifyError> {
    let many = (LENGTH / size).round() as u32;
    let up: Vec<f64> = (0..=many).map(|i| LENGTH * f64::from(i) / f64::from(many)).collect();
    let plate = Plate::bricks([&[0.0, SIDE], &up], SIDE, |_| true);
    let middle = 0.5 * SIDE;
    let bar = [[middle, middle, 0.0], [middle, middle, LENGTH]];
    let threshold = mix.tension / mix.young;
    let way = |strain: f64| strain * LENGTH;
    Specimen {
        plate: &plate,
        mix: *mix,
        words: BAND,
        quadrature,
        sound: &|_| false,
        grips: vec![
            Grip { nodes: &|x| x[1] > LENGTH - 1e-9, share: [None, None, Some(1.0)] },
            Grip { nodes: &|x| x[1] < 1e-9, share: [None, None, Some(0.0)] },
        ],
        bolts: vec![bolts(&[bar], STEEL_SHARE * SIDE * SIDE)],
        gauge: None,
        ramp: 1000,
        ways: steps(&[
            (way(0.9 * threshold), way(0.9 * threshold)),
            (way(1.1 * threshold), way(0.01 * threshold)),
            (way(3.0 * threshold), way(0.1 * threshold)),
            (way(0.5e-3), way(0.05e-3)),
            (way(2e-3), way(0.25e-3)),
        ]),
    }
    .run()
}
