//! What closed loops of strain give out at fixed damage.
//!
//! At fixed damage an elastic body gives back what it was given. The paper's split (7) has no potential where ν ≠ 0 and
//! D⁺ ≠ D⁻, so a closed loop may create energy; the split in compliance (`ladeveze1984`, `laborderie1991`) derives from
//! one. Loops of three to five random corners of principal strain, D⁺ = 0.9, D⁻ = 0, ν = 0.17: the work of the stress over each,
//! over the largest energy ½σ:ε stored on it. Damage is held by strengths out of reach.
//!
//! The integral is the midpoint rule on n chords a side. The stress has kinks where a principal stress turns its sign; a
//! chord with a kink errs by its length squared, and a side has a few, so the error falls with order 2.
//!
//! The figure of the effective split is for information: what a user of the paper's law must know. An explicit run books
//! the law's work, so the energy balance shows it.

use crate::concrete::{Random, SPLITS, concrete, cube};
use crate::convergence::order;
use crate::{Check, Effort, Verification, VerifyError};
use tremolite_laws::Material;
use tremolite_laws::materials::Concrete;

const NAME: &str = "concrete_loops";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "energy that closed loops at fixed damage create: the paper's split and the compliance split",
    source: "a potential conserves energy exactly; `ladeveze1984`, `laborderie1991` for the split that has one",
    from: Effort::Test,
    run,
};

const DAMAGE: [f64; 2] = [0.9, 0.0];
const LOOPS: usize = 300;

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let chords = if effort == Effort::Full { 1600 } else { 400 };
    let mut checks = Vec::new();
    for split in SPLITS {
        let law = concrete(&[("tensile_strength", 1e30), ("cohesion", 1e33)], &[("split", split)])?;
        for corners in [3, 4, 5] {
            let quantity = format!(
                "energy created over the loop's peak, worst of {LOOPS} with {corners} corners, {split} split"
            );
            let coarse = Created::over_loops(&law, corners, chords / 4)?;
            let fine = Created::over_loops(&law, corners, chords)?;
            if split == "effective" {
                let note = "for information, beside the 0.39 of 300 other loops: there is no potential, and a run books what \
                            loops create";
                checks.push(Check::beside(NAME, quantity.clone(), fine.worst, 0.39, "1", note));
                let note = "0.1 %: the figure is no error of integration";
                let change = (fine.worst - coarse.worst).abs();
                let quantity = format!("{quantity}, change from {} chords to {chords}", chords / 4);
                checks.push(Check::new(NAME, quantity, change, 0.0, 1e-3, "1", note));
                continue;
            }
            let note = "1e-4: the chords' error, a few kinks a side at (1/400)² each";
            checks.push(Check::new(NAME, quantity, fine.worst, 0.0, 1e-4, "1", note));
            let p = order(coarse.mean, fine.mean, 4.0);
            let note = format!(
                "order 2: kinks inside chords; mean {:.1e} with {} chords a side, {:.1e} with {chords}",
                coarse.mean,
                chords / 4,
                fine.mean
            );
            let quantity = format!("order in the chord of what is left, {corners} corners, {split} split");
            checks.push(Check::new(NAME, quantity, p, 2.0, 0.3, "1", note).with_order(p));
        }
    }
    Ok(checks)
}

fn stress(law: &Concrete, strain: [f64; 6]) -> Result<[f64; 6], VerifyError> {
    let mut history = tremolite_laws::virgin::<Concrete>();
    history[..2].copy_from_slice(&DAMAGE);
    let (stress, new) = law.update(&cube(0.0, 0.5), strain, history);
    match new[..2] == DAMAGE {
        true => Ok(stress),
        false => Err(VerifyError::Setup("the damage was to stay, but grew".into())),
    }
}

/// Energy given out by a loop over its peak energy.
struct Created {
    /// The largest over the loops.
    worst: f64,
    /// Mean size.
    mean: f64,
}

impl Created {
    fn over_loops(law: &Concrete, corners: usize, chords: usize) -> Result<Created, VerifyError> {
        let mut random = Random::new(3);
        let mut created = Created { worst: 0.0, mean: 0.0 };
        for _ in 0..LOOPS {
            let corners: Vec<[f64; 6]> = (0..corners)
                .map(|_| {
                    let [x, y, z, ..] = random.strain(1e-4);
                    [x, y, z, 0.0, 0.0, 0.0]
                })
                .collect();
            let (mut work, mut peak) = (0.0, 0.0f64);
            for (k, from) in corners.iter().enumerate() {
                let to = &corners[(k + 1) % corners.len()];
                peak = peak.max(0.5 * contract(&stress(law, *from)?, from));
                let edge: [f64; 6] = std::array::from_fn(|c| (to[c] - from[c]) / chords as f64);
                for chord in 0..chords {
                    let middle = std::array::from_fn(|c| from[c] + edge[c] * (chord as f64 + 0.5));
                    let stress = stress(law, middle)?;
                    work += contract(&stress, &edge);
                    peak = peak.max(0.5 * contract(&stress, &middle));
                }
            }
            created.worst = created.worst.max(-work / peak);
            created.mean += (work / peak).abs() / LOOPS as f64;
        }
        Ok(created)
    }
}

/// σ : ε
fn contract(stress: &[f64; 6], strain: &[f64; 6]) -> f64 {
    stress.iter().zip(strain).map(|(s, e)| s * e).sum()
}
