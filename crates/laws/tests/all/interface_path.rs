//! Driving interface laws along paths: prescribed pressure, names, refusals.

use crate::common::samples::samples;
use tremolite_laws::interface_path::{
    Across, InterfacePath, InterfaceResponse, drive_interface, drive_interface_named,
};
use tremolite_laws::interfaces::{Bandis, INTERFACES};
use tremolite_laws::path::PathError;
use tremolite_laws::{Interface, PairState, Values};

fn along(across: Across, values: Vec<[f64; 3]>) -> InterfacePath {
    InterfacePath { time: (0..values.len()).map(|k| k as f64).collect(), values, across }
}

fn joint(numbers: &[(&str, f64)]) -> Bandis {
    let values = Values::default()
        .with("normal_stiffness", 20e9)
        .with("max_closure", 0.5e-3)
        .with("friction_coefficient", 0.7);
    Bandis::new(&numbers.iter().fold(values, |values, (name, x)| values.with(name, *x))).unwrap()
}

fn states(response: &InterfaceResponse) -> Vec<f64> {
    response.history[response.state].clone()
}

#[test]
fn a_prescribed_pressure_is_met_with_the_gap_that_gives_it_in_every_law() {
    for law in INTERFACES {
        for sample in samples(law.name) {
            let values: Vec<[f64; 3]> =
                (1..200).map(|k| [1e3 * 1.06f64.powi(k), 1e-6 * k as f64, -2e-6 * k as f64]).collect();
            let down = values.iter().rev().copied();
            let path = along(Across::Pressure, values.iter().copied().chain(down).collect());
            let found = drive_interface_named(law.name, &sample.values(), &path).unwrap();
            for (row, [pressure, ..]) in path.values.iter().enumerate() {
                let which = format!("{} {}, row {row}", law.name, sample.variant);
                assert!((found.pressure[row] / pressure - 1.0).abs() < 1e-13, "{which}");
            }
            // The gaps found, prescribed, are answered with the same bits.
            let rows = found.gap.iter().zip(&found.slip).map(|(gap, [a, b])| [*gap, *a, *b]).collect();
            let again = drive_interface_named(law.name, &sample.values(), &along(Across::Gap, rows)).unwrap();
            assert_eq!(
                (again.pressure, again.shear, again.history),
                (found.pressure, found.shear, found.history)
            );
        }
    }
}

#[test]
fn shear_tests_at_constant_pressure_peak_at_the_bond_and_end_at_friction() {
    let law = joint(&[("cohesion", 1e6)]);
    for pressure in [0.5e6, 3e6] {
        let path = along(Across::Pressure, (0..=2000).map(|k| [pressure, 1e-6 * k as f64, 0.0]).collect());
        let found = drive_interface(&law, &path).unwrap();
        let peak = found.shear.iter().map(|t| t[0]).fold(0.0, f64::max);
        let step = law.stiffness(pressure)[1] * 1e-6;
        let exact = 1e6 + 0.7 * pressure;
        assert!(peak <= exact && peak > exact - step, "{peak} {exact}");
        assert!((found.shear[2000][0] / (0.7 * pressure) - 1.0).abs() < 1e-12);
        assert_eq!(states(&found)[2000], PairState::Sliding.number());
        assert_eq!(found.column("slid").unwrap()[2000], found.history[found.slid][2000]);
        assert!(found.column("no such thing").is_none() && found.history[found.opened][2000] == 0.0);
    }
}

#[test]
fn tension_is_met_as_long_as_the_bond_carries_it_and_refused_with_what_is_missing() {
    let law = joint(&[("cohesion", 1e6), ("tensile_strength", 2e6)]);
    let drive = |values: Vec<[f64; 3]>| drive_interface(&law, &along(Across::Pressure, values));
    let found = drive(vec![[-1e6, 0.0, 0.0], [-1.999e6, 0.0, 0.0], [0.0; 3], [1e6, 0.0, 0.0]]).unwrap();
    assert_eq!(states(&found), [PairState::Bonded.number(); 4]);
    // δ/(1 + δ/T) = p/k_n0.
    assert!((found.gap[0] / (1e6 / (20e9 - 1e6 / 0.5e-3)) - 1.0).abs() < 1e-13 && found.gap[2] == 0.0);
    match drive(vec![[-1e6, 0.0, 0.0], [-2.5e6, 0.0, 0.0]]) {
        Err(PathError::NotConverged { row: 1, miss }) => assert!((miss - 0.5e6).abs() < 1.0, "{miss}"),
        other => panic!("{other:?}"),
    }
    // A slip that breaks the bond: the pair is open at any gap.
    match drive(vec![[-1e6, 0.0, 0.0], [-1e6, 0.1, 0.0]]) {
        Err(PathError::NotConverged { row: 1, miss }) => assert!((miss - 1e6).abs() < 1.0, "{miss}"),
        other => panic!("{other:?}"),
    }
    let broken =
        drive_interface(&joint(&[]), &along(Across::Pressure, vec![[1e6, 0.0, 0.0], [-1.0, 0.0, 0.0]]));
    match broken {
        Err(PathError::NotConverged { row: 1, miss }) => assert!((miss - 1.0).abs() < 1e-9, "{miss}"),
        other => panic!("{other:?}"),
    }
    let said = PathError::NotConverged { row: 1, miss: 1.0 }.to_string();
    assert!(said.contains("gap"), "{said}");
}

#[test]
fn without_pressure_a_closed_pair_just_touches() {
    let law = joint(&[]);
    let rows = vec![[0.0; 3], [0.0, 1e-3, 0.0], [1e6, 1e-3, 0.0], [0.0, 2e-3, 0.0]];
    let found = drive_interface(&law, &along(Across::Pressure, rows)).unwrap();
    assert_eq!([found.gap[0], found.gap[1], found.gap[3]], [0.0; 3]);
    assert_eq!(found.shear[3], [0.0; 2]);
}

#[test]
fn what_cannot_be_followed_is_refused_with_the_row() {
    let law = joint(&[]);
    let refuse = |time: Vec<f64>, values: Vec<[f64; 3]>| {
        drive_interface(&law, &InterfacePath { time, values, across: Across::Gap }).unwrap_err()
    };
    assert_eq!(refuse(vec![0.0], vec![[0.0; 3]; 2]), PathError::Lengths { time: 1, values: 2 });
    let nan = [0.0, f64::NAN, 0.0];
    assert_eq!(refuse(vec![0.0; 2], vec![[0.0; 3], nan]), PathError::NotFinite { row: 1 });
    assert_eq!(refuse(vec![1.0, 0.0], vec![[0.0; 3]; 2]), PathError::Time { row: 1 });
    let empty = along(Across::Gap, vec![]);
    assert!(drive_interface(&law, &empty).unwrap().gap.is_empty());
    let unknown = drive_interface_named("bands", &Values::default(), &empty).unwrap_err();
    assert!(unknown.to_string().contains("bandis"), "{unknown}");
    let bad = drive_interface_named("bandis", &Values::default(), &empty).unwrap_err();
    assert!(matches!(bad, PathError::Parameters(_)) && bad.to_string().contains("max_closure"));
}
