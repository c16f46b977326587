//! What a wrongly entered quantity fails.

use super::*;
use std::collections::BTreeSet;

/// Units of results, SI.
const UNITS: [&str; 11] = ["", "1", "m", "m2", "m3", "m/s", "m/s2", "1/s", "Pa", "N", "J"];

fn check<V>(list: &str, all: &[Quantity<V>]) {
    let mut names = BTreeSet::new();
    for Quantity { name, unit, doc, .. } in all {
        let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
        assert!(
            !name.is_empty() && name.chars().all(plain),
            "{list}: '{name}' has other than a to z, 0 to 9 and _"
        );
        assert!(
            UNITS.contains(unit),
            "{list}: '{unit}' of {name} is no unit of results, which are in SI: {UNITS:?}"
        );
        assert!(!doc.trim().is_empty(), "{list}: {name} has no meaning");
        assert!(names.insert(name), "{list}: {name} stands there twice");
    }
}

#[test]
fn names_are_plain_and_said_once_units_are_si_and_every_quantity_has_its_meaning() {
    check("MONITOR", MONITOR);
    check("RELATIVE", RELATIVE);
    check("WET", WET);
    check("PAIR", PAIR);
    check("BOLT", BOLT);
    check("INTERFACE", INTERFACE);
    check("BOLT_LINES", &BOLT_LINES);
}

/// What is seen, with stresses, displacements, velocities and accelerations larger by these factors.
fn monitor([stress, u, v, a]: [f64; 4]) -> MonitorSeen {
    MonitorSeen {
        moved: Moved {
            u: [1.1, -2.3, 0.7].map(|x| u * x),
            v: [0.3, 1.9, -1.2].map(|x| v * x),
            a: [-0.4, 2.6, 1.3].map(|x| a * x),
            s1_elastic: stress * 2.2,
        },
        stress: [1.2, -0.9, 0.4, 0.6, -0.3, 0.8].map(|x| stress * x),
        principal: [1.65, 0.42, -1.37].map(|x| stress * x),
        pore: stress * 0.3,
    }
}

#[test]
fn values_of_monitors_grow_with_what_has_their_unit_and_with_nothing_else() {
    let grown = ["Pa", "m", "m/s", "m/s2"];
    for Quantity { name, unit, value, .. } in MONITOR.iter().chain(WET) {
        let own = value.at(&monitor([1.0; 4]));
        assert!(own.is_finite(), "{name}");
        for (k, of) in grown.iter().enumerate() {
            let mut factors = [1.0; 4];
            factors[k] = 2.0;
            let (found, wanted) = (value.at(&monitor(factors)), if unit == of { 2.0 * own } else { own });
            assert!(
                (found - wanted).abs() <= 1e-12 * own.abs(),
                "{name} in '{unit}': with twice of what is in {of} it is {found}, not {wanted}"
            );
        }
    }
}
