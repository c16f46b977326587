//! The check of a run that ends before its motion.

use crate::evidence::Evidence;
use tremolite_motion::Motion;
use tremolite_results::{TrustLine, said};

/// Share of ∫a² dt that may stay behind where a run ends before its motion.
pub(crate) const NOT_RUN: f64 = 0.01;

/// The share of a motion's ∫a² dt that comes after a time \[s\].
pub(crate) fn left_after(motion: &Motion, time: f64) -> f64 {
    let rows = (time / motion.dt).floor().max(0.0) as usize;
    let energy = |from: usize| -> f64 {
        // A sum of nothing is −0.
        motion.acceleration.iter().flat_map(|a| a.iter().skip(from)).fold(0.0, |sum, a| sum + a * a)
    };
    let all = energy(0);
    // A motion that is zero everywhere leaves nothing behind.
    if all > 0.0 { energy(rows.saturating_add(1)) / all } else { 0.0 }
}

pub(super) fn line(evidence: &Evidence) -> TrustLine {
    const ID: &str = "truncated_motion";
    let name = said!("share of the motion after the end of the run");
    let Some(motion) = evidence.plan.shaken_by(evidence.model) else {
        return TrustLine::not_applicable(ID, name, said!("no wave comes in"));
    };
    // A step may end just before the time that was asked for.
    let time = evidence.outcome.taken as f64 * evidence.outcome.dt;
    let time = time.max(if time >= evidence.plan.duration - evidence.outcome.dt {
        evidence.plan.duration
    } else {
        0.0
    });
    TrustLine::at_most(ID, name, left_after(motion, time - evidence.plan.late()), NOT_RUN, "")
        .with("end", time)
        .with("motion", motion.duration())
        .with_note(said!(
            "of ∫a² dt, behind {end} s of {whole} s: the run ends before this motion comes, and the largest values may come with it",
            end = format!("{time:.2}"),
            whole = format!("{:.2}", motion.duration()),
        ))
}

#[cfg(test)]
mod tests {
    use super::left_after;
    use tremolite_motion::Motion;

    #[test]
    fn of_even_shaking_half_is_left_at_half_time() {
        let motion =
            Motion::from_acceleration(0.01, [vec![1.0; 1001], vec![0.0; 1001], vec![0.0; 1001]]).unwrap();
        assert!((left_after(&motion, 5.0) - 0.5).abs() < 2e-3);
        assert_eq!((left_after(&motion, 10.0), left_after(&motion, 1e9)), (0.0, 0.0));
        assert!(left_after(&motion, 0.0) > 0.99);
    }
}
