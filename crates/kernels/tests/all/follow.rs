//! Laws by their names, along paths, with every instruction set.

#[path = "../../../laws/tests/all/common/samples.rs"]
#[allow(dead_code)]
mod samples;

use samples::samples;
use tremolite_kernels::follow::{follow_interface, interface_warnings};
use tremolite_laws::interface_path::{Across, InterfacePath};
use tremolite_laws::interfaces::INTERFACES;
use tremolite_laws::{Isa, Values};

/// Closing, sliding and opening; or pressures that slide.
fn path(across: Across) -> InterfacePath {
    let values = |k: usize| {
        let x = 0.05 * k as f64;
        let across = match across {
            Across::Gap => 1e-4 * ((1.3 * x).sin() - 0.6),
            Across::Pressure => 2e6 * (1.0 - (0.7 * x).cos()),
        };
        [across, 2e-4 * x.sin(), 1e-4 * (0.4 * x).sin()]
    };
    InterfacePath { time: (0..400).map(f64::from).collect(), values: (0..400).map(values).collect(), across }
}

#[test]
fn every_interface_law_has_the_same_bits_with_every_instruction_set() {
    for law in INTERFACES {
        for sample in samples(law.name) {
            for across in [Across::Gap, Across::Pressure] {
                let of = |isa| {
                    let found = follow_interface(law.name, &sample.values(), &path(across), isa).unwrap();
                    let bits: Vec<u64> = (found.pressure.iter().chain(&found.gap))
                        .chain(found.shear.iter().chain(&found.slip).flatten())
                        .chain(found.history.iter().flatten())
                        .map(|x| x.to_bits())
                        .collect();
                    assert!(found.pressure.iter().all(|p| p.is_finite()));
                    bits
                };
                for isa in Isa::ALL {
                    assert_eq!(of(isa), of(Isa::Scalar), "{} {}, {isa:?}", law.name, sample.variant);
                }
            }
        }
    }
}

#[test]
fn an_unknown_interface_law_is_refused_with_those_that_are_known() {
    let refused = follow_interface("bands", &Values::default(), &path(Across::Gap), Isa::best()).unwrap_err();
    assert!(refused.to_string().contains("bandis, coulomb"), "{refused}");
    assert!(interface_warnings("bands", &Values::default()).is_empty());
}

#[test]
fn unusual_parameters_of_interfaces_are_warned_of() {
    let usual = Values::default()
        .with("normal_stiffness", 20e9)
        .with("max_closure", 5e-4)
        .with("friction_coefficient", 0.7);
    for law in ["bandis", "coulomb"] {
        assert!(interface_warnings(law, &usual).is_empty());
        let angle = interface_warnings(law, &usual.clone().with("friction_coefficient", 35.0));
        assert!(angle.len() == 1 && angle[0].contains("friction_angle"), "{angle:?}");
        let bond = interface_warnings(law, &usual.clone().with("tensile_strength", 1e6));
        assert!(bond.len() == 1 && bond[0].contains("first slip"), "{bond:?}");
    }
}
