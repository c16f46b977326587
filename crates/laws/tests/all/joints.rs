//! Bandis' joint and the linear one against their own formulas: closure, bond, sliding, loops.

use crate::common::Random;
use crate::common::pair::Pair;
use tremolite_laws::interfaces::{Bandis, Coulomb};
use tremolite_laws::{Choice, Interface, PairState, Value, Values};

const K: f64 = 20e9;
const T: f64 = 0.5e-3;
const MU: f64 = 0.7;

fn values(numbers: &[(&str, f64)]) -> Values {
    let values =
        Values::default().with("normal_stiffness", K).with("max_closure", T).with("friction_coefficient", MU);
    numbers.iter().fold(values, |values, (name, x)| values.with(name, *x))
}

fn constant(mut values: Values) -> Values {
    values.0.insert("tangential".to_owned(), Value::Word("constant".to_owned()));
    values
}

fn bandis(numbers: &[(&str, f64)]) -> Bandis {
    Bandis::new(&values(numbers)).unwrap()
}

fn faults<I: Interface>(values: &Values) -> Vec<&'static str> {
    I::new(values).err().unwrap_or_default().iter().map(|fault| fault.name).collect()
}

#[test]
fn closure_follows_the_hyperbola_through_loading_and_unloading_and_then_goes_straight() {
    for (numbers, floor) in [
        (&[][..], 0.25),
        (&[("closure_floor", 0.6)], 0.6),
        (&[("pressure_for_step", 8e6)], 1.0 / (1.0 + 8e6 / (K * T))),
        (&[("pressure_for_step", 90e6)], 0.25),
    ] {
        let law = bandis(numbers);
        let most = K * T * (1.0 / floor - 1.0);
        assert!((law.straight_from().unwrap() / most - 1.0).abs() < 1e-14);
        assert_eq!(law.closure_limit(), Some(T));
        let mut pair = Pair::new(&law);
        // Load, unload, reload; any history leads to the same curve.
        let legs = [0.0, 0.95, 0.1, 1.4, 0.0, 0.5];
        for k in 0..=1000 {
            let x = 5.0 * k as f64 / 1000.0;
            let leg = (x as usize).min(4);
            let closure = T * (legs[leg] + (legs[leg + 1] - legs[leg]) * (x - leg as f64));
            pair.to(-closure, [0.0; 2]);
            let share = 1.0 - closure / T;
            let exact = if share >= floor {
                K * closure / share
            } else {
                most + K / (floor * floor) * (closure - (1.0 - floor) * T)
            };
            // The share is a difference that loses what its size is below 1.
            let near = 4.0 * f64::EPSILON / floor * exact;
            assert!((pair.pressure - exact).abs() <= near, "{closure}: {} {exact}", pair.pressure);
        }
        assert_eq!((pair.friction(), pair.created()), (0.0, 0.0));
    }
}

#[test]
fn shear_breaks_the_bond_at_cohesion_and_friction_and_slides_at_friction() {
    for values in [values(&[("cohesion", 1e6)]), constant(values(&[("cohesion", 1e6)]))] {
        let law = Bandis::new(&values).unwrap();
        for pressure in [0.0, 2e6, 12e6] {
            let mut pair = Pair::started(&law, pressure, [0.0; 2]);
            let stiffness = law.stiffest()[1].min(law.stiffness(pressure)[1]);
            let most = 1e6 + MU * pressure;
            let gap = pair.gap;
            pair.to(gap, [0.6 * 0.999 * most / stiffness, -0.8 * 0.999 * most / stiffness]);
            assert_eq!((pair.state(), pair.friction()), (PairState::Bonded, 0.0));
            assert!((pair.size() / (0.999 * most) - 1.0).abs() < 1e-9);
            let before = pair.stored()[0];
            let work = pair.to(gap, [0.6 * 1.001 * most / stiffness, -0.8 * 1.001 * most / stiffness]);
            assert_eq!(pair.state(), PairState::Sliding);
            assert!((pair.size() - MU * pressure).abs() < 1e-9 * most);
            assert!(pair.shear[0] <= 0.0 && pair.shear[1] >= 0.0, "against the slip");
            let freed = before - pair.stored()[0] + work.along;
            assert!((pair.friction() - freed).abs() < 1e-12 * freed && freed > 0.0);
            // On at μp; back it sticks first.
            pair.to(gap, [0.01, 0.0]);
            assert!((pair.size() - MU * pressure).abs() < 1e-9 * most);
            if pressure > 0.0 {
                pair.to(gap, [0.01 - MU * pressure / stiffness, 0.0]);
                assert_eq!(pair.state(), PairState::Stuck);
            }
            assert!(pair.slid() && !pair.opened());
        }
    }
}

#[test]
fn a_bond_that_breaks_in_shear_while_apart_opens_and_says_both() {
    for values in [values(&[("cohesion", 1e6)]), constant(values(&[("cohesion", 1e6)]))] {
        let law = Bandis::new(&values).unwrap();
        let mut pair = Pair::started(&law, -0.5e6, [0.0; 2]);
        assert_eq!(pair.state(), PairState::Bonded);
        let stiffness = law.stiffness(-0.5e6)[1];
        pair.to(pair.gap, [0.99e6 / stiffness, 0.0]);
        let [stored, _] = pair.stored();
        assert_eq!((pair.state(), pair.slid()), (PairState::Bonded, false));
        let work = pair.to(pair.gap, [1.01e6 / stiffness, 0.0]);
        assert_eq!((pair.state(), pair.slid(), pair.opened()), (PairState::Open, true, true));
        assert_eq!((pair.pressure, pair.shear), (0.0, [0.0; 2]));
        assert!((pair.friction() / (stored + work.along) - 1.0).abs() < 1e-12);
        // An open pair that slides on says no more, and closes without a bond.
        pair.to(0.1 * T, [1.0, 0.0]);
        assert_eq!(pair.state(), PairState::Open);
        pair.to(-1e-9 * T, [1.0, 0.0]);
        assert_eq!(pair.state(), PairState::Stuck);
    }
}

#[test]
fn tension_breaks_at_its_own_strength_and_is_gone_for_good() {
    for strength in [0.3e6, 1e6, 5e6] {
        let law = bandis(&[("cohesion", 2e6), ("tensile_strength", strength)]);
        let widest = law.start(-strength, [0.0; 2]).0;
        let mut pair = Pair::new(&law);
        pair.to(widest * (1.0 - 1e-12), [0.0; 2]);
        assert_eq!((pair.state(), pair.opened()), (PairState::Bonded, false));
        let [stored, _] = pair.stored();
        let work = pair.to(widest * (1.0 + 1e-9), [0.0; 2]);
        assert_eq!((pair.state(), pair.slid(), pair.opened()), (PairState::Open, false, true));
        assert!((pair.friction() / (stored + work.across) - 1.0).abs() < 1e-12);
        let taken = pair.friction();
        for gap in [-0.1 * T, 0.1 * widest, 2.0 * widest] {
            pair.to(gap, [0.0; 2]);
            assert_eq!(pair.pressure > 0.0, gap < 0.0);
            assert!(pair.pressure >= 0.0);
        }
        assert_eq!(pair.friction(), taken);
    }
    // Without tension the pair opens at once though it has cohesion.
    let law = bandis(&[("cohesion", 2e6), ("tensile_strength", 0.0)]);
    let mut pair = Pair::new(&law);
    pair.to(1e-12, [0.0; 2]);
    assert_eq!(pair.state(), PairState::Open);
}

#[test]
fn an_open_pair_begins_its_shear_anew_where_it_closes() {
    let [following, held] = [values(&[]), constant(values(&[]))].map(|v| Bandis::new(&v).unwrap());
    for (law, share) in [(&following, 1.0), (&held, 0.0)] {
        let mut pair = Pair::new(law);
        pair.to(-0.3 * T, [1e-5, 0.0]);
        assert!(pair.shear[0] < 0.0);
        pair.to(0.1 * T, [2e-3, 1e-3]);
        assert_eq!((pair.state(), pair.shear), (PairState::Open, [0.0; 2]));
        let taken = pair.friction();
        let touch = -0.5 * T;
        let step = 1e-6;
        pair.to(touch, [2e-3 + step, 1e-3]);
        let exact = -share * law.stiffness(pair.pressure)[1] * step;
        assert!((pair.shear[0] - exact).abs() <= 1e-9 * exact.abs() && pair.shear[1] == 0.0);
        assert_eq!(pair.friction(), taken);
        pair.to(touch, [2e-3 + 2.0 * step, 1e-3]);
        let exact = -(1.0 + share) * law.stiffness(pair.pressure)[1] * step;
        assert!((pair.shear[0] / exact - 1.0).abs() < 1e-9);
    }
}

#[test]
fn loops_give_back_all_with_a_constant_stiffness_and_what_is_booked_with_one_that_follows() {
    let bonded = values(&[("cohesion", 1e9), ("tensile_strength", 1e6)]);
    let mut random = Random::new(4);
    for (values, follows) in [(bonded.clone(), true), (constant(bonded), false)] {
        let law = Bandis::new(&values).unwrap();
        for _ in 0..50 {
            let mut pair = Pair::new(&law);
            let mut work = 0.0;
            for _ in 0..5 {
                let slip = [0; 2].map(|_| 1e-3 * random.symmetric());
                work += pair.to(T * (-0.8 + 0.82 * random.unit()), slip).along;
            }
            work += pair.to(0.0, [0.0; 2]).along;
            let [_, left] = pair.stored();
            assert_eq!((pair.state(), pair.friction()), (PairState::Bonded, 0.0));
            let size = 0.5 * law.stiffest()[1] * 1e-6;
            assert!((left - work - pair.created()).abs() < 1e-13 * size);
            if follows {
                assert!(pair.created().abs() > 1e-3 * size);
            } else {
                assert!(pair.size() < 1e-9 * law.stiffest()[1] * 1e-3 && work.abs() < 1e-9 * size);
                assert_eq!(pair.created(), 0.0);
            }
        }
    }
    // Out at k_t2, back at k_t1: ½(k_t2 − k_t1)s² is given out.
    let law = bandis(&[("cohesion", 1e9), ("tensile_strength", 1e6)]);
    let [first, second] = [0.5, 0.1].map(|x: f64| 0.4 * K / (1.0 - x).powi(2));
    let mut pair = Pair::new(&law);
    let steps = [(0.5, 0.0), (0.5, 1e-3), (0.1, 1e-3), (0.1, 0.0)];
    let work: f64 = steps.iter().map(|(closure, slip)| pair.to(-closure * T, [*slip, 0.0]).along).sum();
    let [_, left] = pair.stored();
    let square = (first - second).powi(2) / (2.0 * second) * 1e-6;
    assert!((left / square - 1.0).abs() < 1e-9);
    assert!((work + pair.created() - left).abs() < 1e-9 * left && pair.created() > 0.0);
}

#[test]
fn the_chosen_stiffness_is_the_largest_that_no_state_exceeds() {
    let mut random = Random::new(6);
    for _ in 0..500 {
        let stiffness = 10f64.powf(8.0 + 4.0 * random.unit());
        let closure = 10f64.powf(-4.0 + 2.0 * random.unit());
        let mut given = Values::default().with("friction_coefficient", MU).with("max_closure", closure);
        if random.unit() < 0.5 {
            given = given.with("closure_floor", 0.05 + 0.95 * random.unit());
        }
        let choice = Choice { stiffness, least: 0.0, pressure: 10f64.powf(5.5 + 2.5 * random.unit()) };
        let chosen = Bandis::chosen(&given, &choice);
        let law = Bandis::new(&chosen).unwrap();
        let found = law.stiffest()[0] / stiffness;
        assert!((found - 1.0).abs() < 1e-12, "{found}: {given:?}");
        // Any stiffer joint would exceed it.
        let own = chosen.optional("normal_stiffness").unwrap();
        let more = Bandis::new(&chosen.clone().with("normal_stiffness", 1.001 * own)).unwrap();
        assert!(more.stiffest()[0] > stiffness * (1.0 - 1e-12), "{given:?}");
        assert_eq!(Bandis::chosen(&chosen, &Choice { stiffness: 1.0, ..choice }), chosen);
        let linear = Coulomb::new(&Coulomb::chosen(&given, &choice)).unwrap();
        assert_eq!(linear.stiffest()[0], stiffness);
    }
    // Continuous where the root vanishes, at 4p*/T.
    let at = |share: f64| {
        let open = |k: &str| k != "normal_stiffness" && k != "pressure_for_step";
        let given = Values(values(&[]).0.into_iter().filter(|(k, _)| open(k)).collect());
        let chosen =
            Bandis::chosen(&given, &Choice { stiffness: share * 4.0 * 5e6 / T, least: 0.0, pressure: 5e6 });
        ["normal_stiffness", "pressure_for_step"].map(|k| chosen.optional(k).unwrap())
    };
    for (below, above) in at(1.0 - 1e-12).into_iter().zip(at(1.0 + 1e-12)) {
        // The root leaves p*/T with 2√(10⁻¹²) of it, the pressure with 10⁻¹².
        assert!((above / below - 1.0).abs() < 4e-6, "{below} {above}");
    }
    let [root, _] = at(1.0);
    assert!((root / (5e6 / T) - 1.0).abs() < 1e-7);
    // A pressure that is given stays, though the stiffest state is then stiffer than asked for.
    let open = |k: &str| k != "normal_stiffness";
    let given = values(&[("pressure_for_step", 5e6)]);
    let given = Values(given.0.into_iter().filter(|(k, _)| open(k)).collect());
    let chosen = Bandis::chosen(&given, &Choice { stiffness: 5e6 / T, least: 0.0, pressure: 1e6 });
    assert_eq!(chosen.optional("pressure_for_step"), Some(5e6));
    let stiffest = Bandis::new(&chosen).unwrap().stiffest()[0];
    assert!((stiffest / (4.0 * 5e6 / T) - 1.0).abs() < 1e-12, "the least that this pressure allows");
    // The least stiffness of the unloaded joint goes before the stiffness that no state should exceed; the pressure stays, or is as
    // large as the joint's own most favourable one.
    let open = Values(given.0.into_iter().filter(|(k, _)| k != "pressure_for_step").collect());
    for (least, pressure) in [(0.5, 2.5e6), (1.0, 5e6), (3.0, 5e6)] {
        let least = least * 5e6 / T;
        for stiffness in [0.1 * least, least] {
            let chosen = Bandis::chosen(&open, &Choice { stiffness, least, pressure: 5e6 });
            assert_eq!(chosen.optional("normal_stiffness"), Some(least));
            let found = chosen.optional("pressure_for_step").unwrap();
            assert!((found / pressure - 1.0).abs() < 1e-12, "{found} {pressure}");
        }
        let linear = Coulomb::chosen(&open, &Choice { stiffness: 0.1 * least, least, pressure: 5e6 });
        assert_eq!(linear.optional("normal_stiffness"), Some(least));
    }
}

#[test]
fn what_cannot_be_a_joint_is_refused_by_name() {
    assert_eq!(
        faults::<Bandis>(&Values::default()),
        ["normal_stiffness", "max_closure", "friction_coefficient"]
    );
    assert_eq!(faults::<Coulomb>(&Values::default()), ["normal_stiffness", "friction_coefficient"]);
    for (name, bad) in [
        ("normal_stiffness", 0.0),
        ("normal_stiffness", f64::NAN),
        ("max_closure", -1e-3),
        ("poisson", 0.51),
        ("poisson", -1.0),
        ("cohesion", -1.0),
        ("tensile_strength", -1.0),
        ("tensile_strength", f64::INFINITY),
        ("friction_coefficient", -0.1),
        ("closure_floor", 0.0),
        ("closure_floor", 1.1),
        ("pressure_for_step", 0.0),
        // The joint's tension stays below k_n0 T, 10 MPa.
        ("cohesion", K * T),
        ("tensile_strength", 11e6),
    ] {
        assert_eq!(faults::<Bandis>(&values(&[(name, bad)])), [name], "{bad}");
    }
    assert!(faults::<Bandis>(&values(&[("cohesion", 11e6), ("tensile_strength", 9e6)])).is_empty());
    assert_eq!(faults::<Coulomb>(&values(&[("shear_stiffness", 0.0)])), ["shear_stiffness"]);
    let mut word = values(&[]);
    word.0.insert("tangential".to_owned(), Value::Word("fixed".to_owned()));
    assert_eq!(faults::<Bandis>(&word), ["tangential"]);
}

#[test]
fn an_angle_of_friction_stands_for_its_tangent() {
    let angle = 35_f64.to_radians();
    let of = |numbers: &[(&str, f64)]| {
        let given = numbers.iter().chain(&[("normal_stiffness", K), ("max_closure", 1e-3)]);
        given.fold(Values::default(), |values, (name, x)| values.with(name, *x))
    };
    let shear = |values: &Values| {
        let law = Bandis::new(values).unwrap();
        let mut pair = Pair::new(&law);
        pair.to(-5e-4, [1e-2, 0.0]);
        pair.shear[0]
    };
    let by_angle = shear(&of(&[("friction_angle", angle)]));
    assert!(by_angle != 0.0);
    assert_eq!(by_angle, shear(&of(&[("friction_coefficient", angle.tan())])));
    assert_eq!(
        faults::<Bandis>(&of(&[("friction_angle", angle), ("friction_coefficient", 0.7)])),
        ["friction_angle"]
    );
    assert_eq!(faults::<Bandis>(&of(&[("friction_angle", std::f64::consts::FRAC_PI_2)])), ["friction_angle"]);
}

#[test]
fn the_linear_joint_is_linear() {
    let law = Coulomb::new(&values(&[("shear_stiffness", 6e9), ("cohesion", 1e6)])).unwrap();
    let mut pair = Pair::new(&law);
    pair.to(-1e-3, [1e-4, -2e-4]);
    assert_eq!((pair.pressure, pair.shear), (K * 1e-3, [-6e9 * 1e-4, 6e9 * 2e-4]));
    assert_eq!(law.stiffness(1e6), [K, 6e9]);
    let half = Coulomb::new(&values(&[])).unwrap();
    assert_eq!(half.stiffest(), [K, 0.4 * K]);
    assert_eq!((half.straight_from(), half.closure_limit()), (None, None));
}

#[test]
fn shear_that_is_not_given_is_four_tenths_of_the_stiffness_that_is_chosen() {
    let choice = Choice { stiffness: 3e9, least: 0.0, pressure: 5e6 };
    let chosen = Coulomb::chosen(&Values::default().with("friction_coefficient", MU), &choice);
    assert_eq!(chosen.optional("normal_stiffness"), Some(3e9));
    assert_eq!(chosen.optional("shear_stiffness"), Some(0.4 * 3e9));
}

#[test]
fn what_is_unusual_of_a_joint_is_warned_of_and_nothing_at_the_limit() {
    let told = |numbers: &[(&str, f64)], what: &str| {
        bandis(numbers).warnings().iter().any(|warning| warning.starts_with(what))
    };
    // 1 MPa closes 1e8 Pa/m by a centimetre.
    assert!(!told(&[("normal_stiffness", 1e8), ("max_closure", 0.01)], ""));
    assert!(told(&[("normal_stiffness", 0.99e8)], "normal_stiffness"));
    assert!(told(&[("max_closure", 0.0101)], "max_closure"));
    assert!(told(&[("tensile_strength", 1e5), ("cohesion", 0.0)], "the bond holds"));
    assert!(!told(&[("tensile_strength", 1e5), ("cohesion", 1.0)], ""));
    assert!(!told(&[("tensile_strength", 0.0), ("cohesion", 0.0)], ""));
}
