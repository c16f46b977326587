//! What every interface law keeps at a point: its energy is that of its pressure, its inverse is one, nothing is stiffer
//! than it says, and its declared defaults are those it uses.

use crate::common::Random;
use crate::common::pair::{Pair, each_sample, on_every_interface, wandering};
use crate::common::samples::samples;
use tremolite_laws::interfaces::INTERFACES;
use tremolite_laws::{Interface, Need, PairState, Value};

/// Gaps from deep in compression up to where the law's bond breaks, each with a pair that has gone there at once.
fn bonded_gaps<I: Interface>(law: &I) -> impl Iterator<Item = Pair<'_, I>> {
    let deep = law.start(40e6, [0.0; 2]).0;
    let wide = -0.3 * deep;
    let gaps = (0..=400).map(move |k| deep + (wide - deep) * k as f64 / 400.0);
    gaps.map(move |gap| {
        let mut pair = Pair::new(law);
        pair.to(gap, [0.0; 2]);
        pair
    })
}

fn pressure_is_the_slope_of_energy<I: Interface>() {
    each_sample::<I>(|law, sample| {
        let deep = -law.start(40e6, [0.0; 2]).0;
        for pair in bonded_gaps(law).filter(|pair| pair.state() != PairState::Open) {
            let h = 1e-4 * deep;
            let energy = |gap: f64| law.stored_energy(gap, [0.0; 2], &pair.history);
            let slope = (energy(pair.gap - h) - energy(pair.gap + h)) / (2.0 * h);
            // h²/6 p'' with p'' up to 2 p/(φT)² beside round-off of U over h.
            let near = 1e-6 * pair.pressure.abs() + 1e-6 * 40e6;
            assert!((slope - pair.pressure).abs() < near, "{} {}: {slope}", I::NAME, sample.variant);
        }
    });
}

fn start_answers_with_what_it_was_given<I: Interface>() {
    let mut random = Random::new(3);
    each_sample::<I>(|law, sample| {
        let values = sample.values();
        let cohesion = values.optional("cohesion").unwrap_or(0.0);
        let bond = values.optional("tensile_strength").unwrap_or(cohesion);
        let friction = values.optional("friction_coefficient").unwrap();
        for _ in 0..200 {
            let pressure = -0.99 * bond + 30e6 * random.unit().powi(3);
            let most = 0.99 * (friction * pressure.max(0.0) + cohesion);
            let (size, angle) = (most * random.unit(), 6.3 * random.unit());
            let shear = [size * angle.cos(), size * angle.sin()];
            let (gap, history) = law.start(pressure, shear);
            let (p, t, new) = law.update(gap, [0.0; 2], history);
            // One unit of the gap is worth 1/φ of the pressure's.
            assert!((p - pressure).abs() <= 2e-15 / 0.25 * 30e6, "{} {}", I::NAME, sample.variant);
            for i in 0..2 {
                assert!((t[i] - shear[i]).abs() <= 1e-15 * size, "{} {}", I::NAME, sample.variant);
            }
            let books = [I::SLID, I::OPENED, I::DISSIPATION].map(|k| new.as_ref()[k]);
            assert_eq!(books, [0.0; 3], "{} {}: {pressure} {shear:?}", I::NAME, sample.variant);
            let far = law.start(pressure, shear).0;
            assert!((law.stiffness(pressure)[0] > 0.0) && far == gap);
        }
        // Beyond the bond nothing is left of it, whatever the tension.
        for tension in [1.001 * bond + 1.0, 5e6, 10e6, 11e6, 1e9] {
            let (gap, history) = law.start(-tension, [1e5, 0.0]);
            let (p, t, new) = law.update(gap, [0.0; 2], history);
            assert_eq!((p, t), (0.0, [0.0; 2]), "{} {}", I::NAME, sample.variant);
            assert!((0.0..1e-2).contains(&gap) && new.as_ref()[I::OPENED] == 1.0, "{gap}");
            assert_eq!(law.stored_energy(gap, t, &new), 0.0);
        }
    });
}

fn no_state_is_stiffer_than_the_stiffest<I: Interface>() {
    each_sample::<I>(|law, sample| {
        let which = format!("{} {}", I::NAME, sample.variant);
        let [across, along] = law.stiffest();
        let mut found = [0.0_f64; 2];
        for pair in bonded_gaps(law).filter(|pair| pair.state() != PairState::Open) {
            let h = -1e-6 * law.start(40e6, [0.0; 2]).0;
            let (mut nearer, mut aside) = (pair, pair);
            nearer.to(pair.gap - h, [0.0; 2]);
            found[0] = found[0].max((nearer.pressure - pair.pressure) / h);
            // Little enough for friction to hold.
            let slip = [1e-5 * pair.pressure.max(1e3) / along, 0.0];
            aside.to(pair.gap, slip);
            found[1] = found[1].max(-aside.shear[0] / slip[0]);
            let at = law.stiffness(pair.pressure);
            let slope = (nearer.pressure - pair.pressure) / h;
            assert!((slope / at[0] - 1.0).abs() < 1e-4, "{which}: {slope} {at:?}");
            if pair.pressure > 1e4 {
                assert!((-aside.shear[0] / slip[0] / at[1] - 1.0).abs() < 1e-8, "{which}");
            }
        }
        for (found, stiffest) in found.into_iter().zip([across, along]) {
            assert!(found <= stiffest * (1.0 + 1e-8), "{which}: {found} {stiffest}");
            assert!(found >= stiffest * (1.0 - 1e-3), "{which}: {found} never reaches {stiffest}");
        }
    });
}

fn zeros_are_at_rest<I: Interface>() {
    each_sample::<I>(|law, sample| {
        let mut pair = Pair::new(law);
        pair.to(0.0, [0.0; 2]);
        assert_eq!((pair.pressure, pair.shear), (0.0, [0.0; 2]), "{} {}", I::NAME, sample.variant);
        assert_eq!([pair.friction(), pair.created(), pair.stored()[0]], [0.0; 3]);
        assert!(!pair.slid() && !pair.opened());
        assert!([PairState::Bonded, PairState::Stuck].contains(&pair.state()));
    });
}

fn declared_defaults_are_used<I: Interface>() {
    for sample in samples(I::NAME) {
        let (values, mut filled) = (sample.values(), sample.values());
        for parameter in I::PARAMETERS {
            let value = match parameter.need {
                Need::Number(x) => Value::Number(x),
                Need::Word(word) => Value::Word(word.to_owned()),
                _ => continue,
            };
            filled.0.entry(parameter.name.to_owned()).or_insert(value);
        }
        let laws = [values, filled].map(|values| I::new(&values).unwrap());
        let path = wandering(&laws[0], &mut Random::new(8), 300);
        let [a, b] = laws.each_ref().map(|law| {
            let mut pair = Pair::new(law);
            let bits = path.iter().map(|(gap, slip)| {
                pair.to(*gap, *slip);
                (pair.pressure.to_bits(), pair.shear.map(f64::to_bits))
            });
            bits.collect::<Vec<_>>()
        });
        assert!(a == b, "{} {}", I::NAME, sample.variant);
        assert!(I::new(&sample.values().with("friction_coefficient", -0.1)).is_err());
    }
}

#[test]
fn pressure_is_minus_the_slope_of_the_stored_energy() {
    on_every_interface!($ pressure_is_the_slope_of_energy);
}

#[test]
fn a_pair_that_begins_with_a_traction_answers_with_it_within_its_strength() {
    on_every_interface!($ start_answers_with_what_it_was_given);
}

#[test]
fn no_state_is_stiffer_than_the_law_says() {
    on_every_interface!($ no_state_is_stiffer_than_the_stiffest);
}

#[test]
fn a_history_of_zeros_is_at_rest() {
    on_every_interface!($ zeros_are_at_rest);
}

#[test]
fn the_defaults_that_are_declared_are_those_used() {
    on_every_interface!($ declared_defaults_are_used);
}

#[test]
fn every_interface_law_is_listed_once_with_its_books_in_joules_per_area() {
    for (k, law) in INTERFACES.iter().enumerate() {
        assert!(INTERFACES[k + 1..].iter().all(|other| other.name != law.name));
        assert_eq!((law.history[0].name, law.pressure_dependent, law.damages), ("state", false, false));
        let books = law.history.iter().filter(|column| column.unit == "J/m2").count();
        assert_eq!(books, 2, "{}", law.name);
    }
}
