//! Concrete under uniaxial stress: tension, compression, a cycle that closes a crack, and the step.
//!
//! Under uniaxial stress ε̄ = ε and e1 = −ε, so (2)–(16) of `wang2018` have closed forms. Tension: σ = Eε up to f_t, the
//! plateau α f_t up to ε_us = 10 ε_ts, then nothing. Compression: σ = Eε up to f_c, then β f_c. A crack opened far
//! beyond ε_us and closed again carries σ = Eε up to f_c: D⁺ is 1 for good, but acts on tension alone. Both splits have
//! these curves.
//!
//! In the effective split these curves do not depend on the step: damage is a running maximum of a function of the
//! strain. The compliance split tests shear with damaged stresses, those of the D⁻ before, so its plateau β f_c errs with
//! order 1 in the step. On a path that turns D⁻ also goes by where in the step D⁺ grew; both splits are of order 1 there,
//! measured on random paths.

use crate::concrete::{
    ALPHA, BETA, D_SHEAR, FT, Random, SPLITS, THRESHOLD, YOUNG, concrete, cube, fc, ramp, uniaxial,
};
use crate::convergence::order;
use crate::{Check, Effort, Verification, VerifyError};
use tremolite_laws::Material;
use tremolite_laws::materials::Concrete;

const NAME: &str = "concrete_uniaxial";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "concrete in tension, compression and a cycle that closes a crack; step-size convergence",
    source: "closed forms of `wang2018` (2)-(16) under uniaxial stress",
    from: Effort::Test,
    run,
};

const EXACT: &str =
    "1e-13: round-off of the principal values; the lateral stress, which is none, counts as well";

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for split in SPLITS {
        let law = concrete(&[], &[("split", split)])?;
        tension(&law, split, &mut checks)?;
        compression(&law, split, &mut checks)?;
        cycle(&law, split, &mut checks)?;
        steps(&law, split, effort, &mut checks);
    }
    Ok(checks)
}

fn check(split: &str, what: &str, value: f64, reference: f64, tolerance: f64, note: &str) -> Check {
    Check::new(NAME, format!("{what}, {split} split"), value, reference, tolerance, "1", note)
}

/// Largest |σ − exact| over `scale` along rows of strain and exact stress, lateral stresses included.
fn largest_error(law: &Concrete, split: &str, rows: &[(f64, f64)], scale: f64) -> Result<f64, VerifyError> {
    let found = uniaxial(law, split, rows);
    let errors =
        found.iter().zip(rows).map(|([along, across], (_, exact))| (along - exact).abs().max(*across));
    Ok(errors.fold(0.0, f64::max) / scale)
}

/// Strains with the stress that belongs to them.
fn rows(strain: Vec<f64>, stress: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    strain.into_iter().map(|e| (e, stress(e))).collect()
}

fn tension(law: &Concrete, split: &str, checks: &mut Vec<Check>) -> Result<(), VerifyError> {
    let at = |x: f64| x * THRESHOLD;
    let mut path = rows(ramp(0.0, at(1.0 - 1e-9), 100), |e| YOUNG * e);
    let peak = uniaxial(law, split, &path)[100][0] / FT;
    let near = "1e-9 below ε_ts, beyond which the stress falls";
    checks.push(check(split, "highest stress in tension over f_t", peak, 1.0, 2e-9, near));
    path.extend(rows(ramp(at(1.0 + 1e-9), at(10.0 - 1e-9), 900), |_| ALPHA * FT));
    path.extend(rows(ramp(at(10.0 + 1e-9), at(30.0), 100), |_| 0.0));
    let worst = largest_error(law, split, &path, FT)?;
    let what = "largest error over f_t in tension: linear, plateau α f_t, nothing past ε_u";
    checks.push(check(split, what, worst, 0.0, 1e-13, EXACT));
    Ok(())
}

/// Rows to f_c and beyond, n steps each, and the row that breaks the point while its lateral strain is still elastic.
fn crushing(n: usize) -> (Vec<(f64, f64)>, usize) {
    let end = fc() / YOUNG;
    let mut path = rows(ramp(0.0, -(1.0 - 1e-9) * end, n), |e| YOUNG * e);
    path.push((-(1.0 + 1e-9) * end, -(1.0 + 1e-9) * fc()));
    path.extend(rows(ramp(-(1.0 + 2e-9) * end, -5.0 * end, n), |_| -BETA * fc()));
    (path, n + 1)
}

fn compression(law: &Concrete, split: &str, checks: &mut Vec<Check>) -> Result<(), VerifyError> {
    let error = |n: usize| -> Result<[f64; 2], VerifyError> {
        let (path, breaks) = crushing(n);
        let found = uniaxial(law, split, &path);
        let error = found
            .iter()
            .zip(&path)
            .enumerate()
            .filter(|(row, _)| *row != breaks)
            .fold(0.0f64, |most, (_, ([along, across], (_, exact)))| {
                most.max((along - exact).abs()).max(*across)
            });
        Ok([-found[n][0] / fc(), error / fc()])
    };
    let [peak, coarse] = error(500)?;
    let near = "1e-9 below f_c/E, beyond which the stress falls";
    checks.push(check(split, "highest stress in compression over f_c", peak, 1.0, 2e-9, near));
    let what = "largest error over f_c in compression: linear, plateau β f_c";
    if split == "effective" {
        checks.push(check(split, what, coarse, 0.0, 1e-13, EXACT));
        return Ok(());
    }
    // D⁻ by the stresses of the step before.
    let [_, fine] = error(1000)?;
    let p = order(coarse, fine, 2.0);
    let note = "8e-4: a step grows the strain by 0.4 % of f_c/E, and the plateau is 0.2 f_c";
    checks.push(check(split, what, fine, 0.0, 8e-4, note).with_order(p));
    let note = "order 1: this split tests shear with the damage of the step before";
    checks.push(check(split, "order in the step of the plateau β f_c", p.value(), 1.0, 0.1, note).with_order(p));
    Ok(())
}

/// Opened to 50 ε_ts, five times ε_us; closed up to f_c; opened; closed.
fn cycle(law: &Concrete, split: &str, checks: &mut Vec<Check>) -> Result<(), VerifyError> {
    let closed = -(1.0 - 1e-9) * fc() / YOUNG;
    let legs = [50.0 * THRESHOLD, closed, 20.0 * THRESHOLD, closed];
    let mut path = rows(ramp((10.0 + 1e-9) * THRESHOLD, legs[0], 100), |_| 0.0);
    for leg in legs.windows(2) {
        path.extend(rows(ramp(leg[0], leg[1], 400), |e| if e < 0.0 { YOUNG * e } else { 0.0 }));
    }
    let carried = -uniaxial(law, split, &path)[path.len() - 1][0] / fc();
    let what = "pressure over f_c of a crack opened to 5 ε_u and closed";
    checks.push(check(split, what, carried, 1.0, 2e-9, "1e-9 below f_c/E"));
    let what = "largest error over f_c in a cycle: open, closed, open, closed";
    checks.push(check(split, what, largest_error(law, split, &path, fc())?, 0.0, 1e-13, EXACT));
    Ok(())
}

fn steps(law: &Concrete, split: &str, effort: Effort, checks: &mut Vec<Check>) {
    let paths = if effort == Effort::Full { 3000 } else { 100 };
    let counts = [32, 128, 512];
    let mut mean = [0.0; 3];
    let mut random = Random::new(11);
    for _ in 0..paths {
        let corners = [0; 3].map(|_| random.strain(1.5e-3));
        let exact = shear_damage(law, &corners, 4096);
        for (mean, steps) in mean.iter_mut().zip(counts) {
            *mean += (shear_damage(law, &corners, steps) - exact).abs() / f64::from(paths);
        }
    }
    let p = order(mean[0], mean[2], 16.0);
    let note = format!(
        "order 1: D⁻ goes by the D⁺ of its own step; mean error {:.1e} with 32 steps a side, {:.1e} with 512, beside 4096",
        mean[0], mean[2]
    );
    checks.push(
        check(split, &format!("order in the step of D⁻ on {paths} random paths"), p.value(), 1.0, 0.3, &note)
            .with_order(p),
    );
}

/// D⁻ after straight lines between corners of strain.
fn shear_damage(law: &Concrete, corners: &[[f64; 6]], steps: usize) -> f64 {
    let mut history = tremolite_laws::virgin::<Concrete>();
    let mut from = [0.0; 6];
    for to in corners {
        for step in 1..=steps {
            let s = step as f64 / steps as f64;
            let strain = std::array::from_fn(|k| from[k] + s * (to[k] - from[k]));
            (_, history) = law.update(&cube(0.0, 0.5), strain, history);
        }
        from = *to;
    }
    history[D_SHEAR]
}
