//! What every interface law keeps along paths: books, strength, states, and no tangent before the other.

use crate::common::Random;
use crate::common::pair::{Pair, each_sample, on_every_interface, wandering};
use tremolite_laws::{Interface, PairState};

/// A pair in its first state, and a path for it.
fn on_its_way<'a, I: Interface>(law: &'a I, random: &mut Random) -> (Pair<'a, I>, Vec<(f64, [f64; 2])>) {
    let path = wandering(law, random, 3000);
    let mut pair = Pair::new(law);
    pair.to(0.0, [0.0; 2]);
    (pair, path)
}

fn books_close<I: Interface>() {
    let mut random = Random::new(11);
    each_sample::<I>(|law, sample| {
        let (mut broke, mut grew) = (false, 0);
        for _ in 0..8 {
            let (mut pair, path) = on_its_way(law, &mut random);
            for (row, (gap, slip)) in path.into_iter().enumerate() {
                let which = format!("{} {}, row {row}", I::NAME, sample.variant);
                let old = pair;
                let work = pair.to(gap, slip);
                let (friction, created) = (pair.friction() - old.friction(), pair.created() - old.created());
                let [[was, was_along], [is, is_along]] = [old.stored(), pair.stored()];
                let breaks = old.state() == PairState::Bonded && pair.state() != PairState::Bonded;
                broke |= breaks;
                let left = if breaks {
                    (is - was) - (work.across + work.along - friction + created)
                } else {
                    (is_along - was_along) - (work.along - friction + created)
                };
                let size = [was, is, work.along.abs(), pair.friction(), pair.created().abs()];
                let size = size.into_iter().fold(1e-3, f64::max);
                assert!(left.abs() <= 1e-13 * size, "{which}: {left:e} of {size:e}");
                // Steps that do not turn the shear round. Beyond, the trapezoidal rule may give out what it then takes.
                let small = law.stiffest()[1] * (slip[0] - old.slip[0]).hypot(slip[1] - old.slip[1]);
                if small <= old.size() {
                    assert!(friction >= 0.0, "{which}: {friction:e}");
                    grew += usize::from(friction > 0.0);
                }
            }
        }
        assert!(grew > 100, "{} {}: {grew}", I::NAME, sample.variant);
        let values = sample.values();
        let bond = ["cohesion", "tensile_strength"].iter().any(|k| values.optional(k).unwrap_or(0.0) > 0.0);
        assert_eq!(broke, bond, "{} {}", I::NAME, sample.variant);
    });
}

fn strength_holds<I: Interface>() {
    let mut random = Random::new(12);
    each_sample::<I>(|law, sample| {
        let values = sample.values();
        let cohesion = values.optional("cohesion").unwrap_or(0.0);
        let bond = values.optional("tensile_strength").unwrap_or(cohesion);
        let friction = values.optional("friction_coefficient").unwrap();
        let mut seen = [0; 4];
        for _ in 0..12 {
            let (mut pair, path) = on_its_way(law, &mut random);
            for (row, (gap, slip)) in path.into_iter().enumerate() {
                let which = format!("{} {}, row {row}", I::NAME, sample.variant);
                let old = pair;
                pair.to(gap, slip);
                let state = pair.state();
                seen[state as usize] += 1;
                let hold = friction * pair.pressure.max(0.0);
                let most = hold + if state == PairState::Bonded { cohesion } else { 0.0 };
                assert!(pair.size() <= most * (1.0 + 1e-14), "{which}: {} {most}", pair.size());
                match state {
                    PairState::Bonded => assert!(-pair.pressure <= bond, "{which}"),
                    PairState::Stuck => assert!(gap <= 0.0 && pair.pressure >= 0.0, "{which}"),
                    PairState::Sliding => {
                        assert!(gap <= 0.0 && pair.slid(), "{which}");
                        assert!((pair.size() - hold).abs() <= 1e-14 * hold, "{which}");
                    }
                    PairState::Open => {
                        assert!(gap > 0.0 && pair.opened(), "{which}");
                        assert_eq!(
                            (pair.pressure, pair.shear, pair.stored()[0]),
                            (0.0, [0.0; 2], 0.0),
                            "{which}"
                        );
                    }
                }
                if old.state() != PairState::Bonded {
                    assert!(state != PairState::Bonded, "{which}: the bond is back");
                }
                assert!((pair.slid() || !old.slid()) && (pair.opened() || !old.opened()), "{which}");
            }
        }
        let [bonded, stuck, sliding, open] = seen;
        let has_bond = cohesion.max(bond) > 0.0;
        assert!((bonded > 0) == has_bond && stuck > 50 && sliding > 50 && open > 50, "{seen:?}");
    });
}

fn no_tangent_comes_first<I: Interface>() {
    let mut random = Random::new(13);
    each_sample::<I>(|law, sample| {
        let (mut pair, path) = on_its_way(law, &mut random);
        let mut turned = pair;
        let (sin, cos) = (6.3 * random.unit()).sin_cos();
        let turn = |v: [f64; 2]| [cos * v[0] - sin * v[1], sin * v[0] + cos * v[1]];
        for (row, (gap, slip)) in path.into_iter().enumerate() {
            let which = format!("{} {}, row {row}", I::NAME, sample.variant);
            pair.to(gap, slip);
            turned.to(gap, turn(slip));
            let there = turn(pair.shear);
            for i in 0..2 {
                assert!((turned.shear[i] - there[i]).abs() <= 1e-9 * (pair.size() + 1.0), "{which}");
            }
            assert_eq!((turned.pressure, turned.state()), (pair.pressure, pair.state()), "{which}");
            let [a, b] = [&pair, &turned].map(|p| [p.friction(), p.created(), p.stored()[0]]);
            for (a, b) in a.into_iter().zip(b) {
                assert!((a - b).abs() <= 1e-9 * (a.abs() + 1.0), "{which}: {a} {b}");
            }
        }
    });
}

#[test]
fn stored_energy_is_work_less_friction_plus_what_is_created() {
    on_every_interface!($ books_close);
}

#[test]
fn strength_is_never_exceeded_an_open_pair_carries_nothing_and_a_bond_never_comes_back() {
    on_every_interface!($ strength_holds);
}

#[test]
fn turning_both_tangents_turns_the_shear_and_changes_nothing_else() {
    on_every_interface!($ no_tangent_comes_first);
}
