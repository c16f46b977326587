//! Dynamic factors of concrete under constant rates of strain.
//!
//! The rate laws in closed form, ε̇ up to 30 s⁻¹ and f_c in MPa: `ceb`, the paper's (12) and (16), (ε̇/3·10⁻⁶)^0.020 in
//! tension and (ε̇/3·10⁻⁵)^(1.026 ξ), ξ = 1/(5 + ¾f_c), in compression; `mc90` (`mc1990`), (ε̇/3·10⁻⁶)^(1.016 δ),
//! δ = 1/(10 + 0.6 f_c), and (ε̇/3·10⁻⁵)^(1.026 α), α = 1/(5 + 0.9 f_c); `mc2010` (`mc2010`), (ε̇/10⁻⁶)^0.018 and
//! (ε̇/3·10⁻⁵)^0.014. A point is stretched, or pressed uniaxially, at a constant rate; the factor is what its first damage
//! froze. With the filter of 5 ms the rate starts from 0 and reaches ε̇(1 − e^(−t/τ)): the factor then solves
//! f = ((ε̇/ε̇_s)(1 − e^(−f ε_ts/(ε̇τ))))^k, which the step meets with order 1.

use crate::concrete::{FACTOR_SHEAR, FACTOR_TENSION, POISSON, THRESHOLD, YOUNG, concrete, cube, fc};
use crate::convergence::order;
use crate::{Check, Effort, Verification, VerifyError};
use tremolite_laws::Material;
use tremolite_laws::materials::Concrete;

const NAME: &str = "concrete_rates";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "dynamic factors of concrete at 1e-4 to 30 1/s by three codes, and through the filter",
    source: "`wang2018` (12), (16) after CEB, references of `mc1990`; `mc1990`; `mc2010`",
    from: Effort::Test,
    run,
};

const RATES: [f64; 4] = [1e-4, 1e-2, 1.0, 30.0];

/// Reference rate \[1/s\] and exponent in tension and in compression, for f_c in MPa.
fn laws(fc: f64) -> [(&'static str, [(f64, f64); 2]); 3] {
    [
        ("ceb", [(3e-6, 0.020), (3e-5, 1.026 / (5.0 + 0.75 * fc))]),
        ("mc90", [(3e-6, 1.016 / (10.0 + 0.6 * fc)), (3e-5, 1.026 / (5.0 + 0.9 * fc))]),
        ("mc2010", [(1e-6, 0.018), (3e-5, 0.014)]),
    ]
}

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for (word, powers) in laws(fc() / 1e6) {
        let law = concrete(&[("rate_filter_time", 0.0)], &[("rate", word)])?;
        let ways = [("tension", FACTOR_TENSION), ("compression", FACTOR_SHEAR)];
        for ((way, column), (reference, exponent)) in ways.into_iter().zip(powers) {
            for rate in RATES {
                let exact = (rate / reference).powf(exponent);
                let found = first_damage(&law, rate, column, 1e-3);
                let quantity = format!("{word} factor in {way} at {rate:e} 1/s");
                let note = "1e-11: the rate is a difference of strains over a step of 1e-3 of them, its round-off 1e-13";
                checks.push(Check::new(NAME, quantity, found, exact, 1e-11, "1", note));
            }
        }
    }
    checks.push(filtered(effort)?);
    Ok(checks)
}

/// The factor in `column` that the first damage freezes, in steps of `step` times the static threshold's strain.
fn first_damage(law: &Concrete, rate: f64, column: usize, step: f64) -> f64 {
    let mut history = tremolite_laws::virgin::<Concrete>();
    let most = if column == FACTOR_TENSION { THRESHOLD } else { fc() / YOUNG };
    let mut strain = 0.0;
    // Ten times the static strength: no code's factor reaches it.
    while history[column] == 0.0 && strain < 10.0 * most {
        strain += step * most;
        let e = match column {
            FACTOR_TENSION => [strain, 0.0, 0.0, 0.0, 0.0, 0.0],
            _ => [-strain, POISSON * strain, POISSON * strain, 0.0, 0.0, 0.0],
        };
        (_, history) = law.update(&cube(step * most / rate, 0.5), e, history);
    }
    history[column]
}

/// Order in the step of the factor in tension through the filter, errors averaged over rates so that they do not go by
/// where the grid of steps meets the threshold.
fn filtered(effort: Effort) -> Result<Check, VerifyError> {
    let law = concrete(&[], &[("rate", "ceb")])?;
    let tau = 5e-3;
    let rates = if effort == Effort::Full { 400 } else { 100 };
    let [coarse, fine] = [1e-2, 1e-3].map(|step| {
        let sum: f64 = (0..rates)
            .map(|k| {
                let rate = 1e-3 * 100f64.powf(f64::from(k) / f64::from(rates));
                // A contraction: the derivative of the right side is below the exponent 0.02.
                let exact = (0..50).fold(1.0f64, |f, _| {
                    let seen = rate * -(-f * THRESHOLD / (rate * tau)).exp_m1();
                    (seen / 3e-6).max(1.0).powf(0.02)
                });
                (first_damage(&law, rate, FACTOR_TENSION, step) - exact).abs()
            })
            .sum();
        sum / f64::from(rates)
    });
    let p = order(coarse, fine, 10.0);
    let note = format!("order 1 of the filter's implicit step; mean error {coarse:.1e} and {fine:.1e}");
    Ok(Check::new(NAME, "order in the step of the factor through the 5 ms filter", p, 1.0, 0.15, "1", note)
        .with_order(p))
}
