//! What holds for concrete on every path: ten thousand random ones each.

use crate::common::Random;
use crate::common::concrete::*;
use proptest::prelude::*;
use std::sync::OnceLock;
use tremolite_laws::materials::Concrete;
use tremolite_laws::{Material, Point};

/// The variants, built once.
fn laws() -> &'static [Concrete] {
    static LAWS: OnceLock<Vec<Concrete>> = OnceLock::new();
    LAWS.get_or_init(all_variants)
}

type State = ([f64; 6], [f64; 21]);

/// Follows straight lines between the corners, `steps` a side, and shows every state.
fn follow(
    law: &Concrete,
    corners: &[[f64; 6]],
    steps: usize,
    point: &Point<f64>,
    mut see: impl FnMut(&[f64; 6], &State),
) {
    let mut history = tremolite_laws::virgin::<Concrete>();
    let mut from = [0.0; 6];
    for to in corners {
        for step in 1..=steps {
            let s = step as f64 / steps as f64;
            let strain = std::array::from_fn(|k| from[k] + s * (to[k] - from[k]));
            let (stress, new) = law.update(point, strain, history);
            history = new;
            see(&strain, &(stress, history));
        }
        from = *to;
    }
}

/// One to six corners of strain, from far below the thresholds to far beyond, and a variant of the law.
fn paths() -> impl Strategy<Value = (usize, Vec<[f64; 6]>)> {
    let corner = prop::array::uniform6(-1.0..1.0f64);
    (0..36usize, -5.0..-2.0f64, prop::collection::vec(corner, 1..6)).prop_map(|(law, size, corners)| {
        (law, corners.into_iter().map(|c| c.map(|x| x * 10f64.powf(size))).collect())
    })
}

fn config() -> ProptestConfig {
    ProptestConfig { cases: 10_000, failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn damage_never_falls_and_stays_between_0_and_1((law, corners) in paths()) {
        let law = &laws()[law];
        let mut last = [0.0; 21];
        let mut wrong = None;
        follow(law, &corners, 10, &point(1e-5, 0.4), |strain, (stress, history)| {
            for k in [0, 1, 3, 6, 7, 8] {
                if history[k] < last[k] || history[k].is_nan() {
                    wrong = Some(format!("column {k} falls from {} to {} at {strain:?}", last[k], history[k]));
                }
            }
            if !history[..4].iter().all(|d| (0.0..=1.0).contains(d)) || history[2] > history[3] {
                wrong = Some(format!("damage {:?} at {strain:?}", &history[..4]));
            }
            if !stress.iter().all(|s| s.is_finite()) {
                wrong = Some(format!("stress {stress:?} at {strain:?}"));
            }
            last = *history;
        });
        prop_assert!(wrong.is_none(), "{}", wrong.unwrap_or_default());
    }

    /// No finite strain, of any size, gives anything that is not a number, whatever comes after it.
    #[test]
    fn no_finite_strain_gives_nan(
        law in 0..36usize,
        corners in prop::collection::vec(prop::array::uniform6(any::<f64>()), 1..6),
        dt in prop::sample::select(vec![0.0, 1e-300, 1e-5, 1e300]),
        h in prop::sample::select(vec![0.0, 1e-9, 0.4, 1e3]),
    ) {
        let law = &laws()[law];
        let mut history = tremolite_laws::virgin::<Concrete>();
        let small = [1e-5, -2e-5, 3e-5, 0.0, 1e-5, 0.0];
        for strain in corners.into_iter().map(|c| c.map(|x| if x.is_finite() { x } else { f64::MAX })).chain([small, [0.0; 6]]) {
            let (stress, new) = law.update(&point(dt, h), strain, history);
            history = new;
            prop_assert!(stress.iter().chain(&history).all(|x| !x.is_nan()), "{strain:?} {stress:?} {history:?}");
        }
    }

    #[test]
    fn turning_the_axes_turns_the_stress_and_nothing_else((law, corners) in paths(), seed in any::<u64>()) {
        let law = &laws()[law];
        let r = Random::new(seed).rotation();
        let size = [0.09, 0.16, 0.25, 0.01, -0.02, 0.03];
        let mut plain = Vec::new();
        follow(law, &corners, 10, &Point { size, ..Point::new(1e-5) }, |e, state| plain.push((*e, *state)));
        let turned: Vec<[f64; 6]> = corners.iter().map(|e| turn_strain(e, &r)).collect();
        let mut i = 0;
        let mut wrong = None;
        let size = turn(&size, &r);
        follow(law, &turned, 10, &Point { size, ..Point::new(1e-5) }, |_, (stress, history)| {
            let (strain, (reference, before)) = &plain[i];
            i += 1;
            let level = strain.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            let stress_error = turn(reference, &r).iter().zip(stress).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
            let damage_error = (history[0] - before[0]).abs().max((history[1] - before[1]).abs());
            if stress_error > 1e-11 * YOUNG * level || damage_error > 1e-11 {
                wrong = Some(format!("{strain:?}: stress {stress_error:.1e} Pa, damage {damage_error:.1e}"));
            }
        });
        prop_assert!(wrong.is_none(), "{}", wrong.unwrap_or_default());
    }

    /// Along a straight line ε̄ is convex, so D⁺ (without rates) depends on the corners alone, whatever the step.
    #[test]
    fn tensile_damage_does_not_depend_on_the_step((law, corners) in paths()) {
        let law = &concrete(&[("driver", if law % 2 == 0 { "strain" } else { "stress" })]);
        let mut found = [0.0; 2];
        for (k, steps) in [1, 17].into_iter().enumerate() {
            follow(law, &corners, steps, &point(0.0, 0.4), |_, (_, history)| found[k] = history[0]);
        }
        prop_assert!((found[0] - found[1]).abs() <= 1e-13, "{found:?}");
    }
}

/// D⁻ feels its path: its error falls with the step, first order where a corner or a jump of D⁺ falls inside one.
#[test]
fn shear_damage_converges_with_the_step() {
    for split in ["effective", "compliance"] {
        let law = concrete(&[("split", split)]);
        let mut random = Random::new(11);
        let mut mean = [0.0; 3];
        for _ in 0..1_000 {
            let corners: Vec<[f64; 6]> = (0..3).map(|_| random_strain(&mut random, 1.5e-3)).collect();
            let at = |steps| {
                let mut damage = 0.0;
                follow(&law, &corners, steps, &point(0.0, 0.4), |_, (_, history)| damage = history[1]);
                damage
            };
            let exact = at(1024);
            for (k, steps) in [8, 32, 128].into_iter().enumerate() {
                mean[k] += (at(steps) - exact).abs() / 1_000.0;
            }
        }
        println!(
            "{split}: mean error of D⁻ with 8, 32, 128 steps a side: {:.1e} {:.1e} {:.1e}",
            mean[0], mean[1], mean[2]
        );
        assert!(mean[1] < 0.5 * mean[0] && mean[2] < 0.5 * mean[1] && mean[2] < 2e-3, "{split} {mean:?}");
    }
}

/// With rates the whole response converges with the time step, to first order.
#[test]
fn rates_converge_with_the_time_step() {
    let law =
        Concrete::new(&with_words(values().with("fracture_energy", 130.0), &[("rate", "ceb")])).unwrap();
    let mut random = Random::new(12);
    let mut mean = [0.0; 3];
    let paths = 300;
    for _ in 0..paths {
        let corners: Vec<[f64; 6]> = (0..3).map(|_| random_strain(&mut random, 3e-4)).collect();
        let at = |steps: usize| {
            let mut end = [0.0; 6];
            let point = point(0.02 / steps as f64, 0.4);
            follow(&law, &corners, steps, &point, |_, (stress, _)| end = *stress);
            end
        };
        let exact = at(4096);
        for (k, steps) in [16, 64, 256].into_iter().enumerate() {
            let error = at(steps).iter().zip(&exact).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
            mean[k] += error / FT / paths as f64;
        }
    }
    println!(
        "mean error of stress over f_t with 16, 64, 256 steps a side: {:.1e} {:.1e} {:.1e}",
        mean[0], mean[1], mean[2]
    );
    assert!(mean[1] < 0.5 * mean[0] && mean[2] < 0.5 * mean[1], "{mean:?}");
}
