//! The equivalent-linear column beside ground that yields.

use crate::free_field_file::{ground, outcome, soil};
use std::f64::consts::FRAC_2_PI;
use tremolite::equivalent_linear::{Curves, of_law};
use tremolite::observers::{NoColumn, YieldingSeen};
use tremolite::{Problem, Rayleigh};
use tremolite_laws::Values;
use tremolite_laws::band::Band;
use tremolite_results::Table;

/// Soil of E 1 GPa, ν ¼ that yields at a cohesion \[Pa\] and an angle of friction.
fn values(cohesion: f64, friction: f64) -> Values {
    Values::default()
        .with("young", 1e9)
        .with("poisson", 0.25)
        .with("cohesion", cohesion)
        .with("friction_angle", friction)
        .with("dilation_angle", 0.0)
        .with("tensile_strength", cohesion)
}

const SHEAR: f64 = 0.4e9;

#[test]
fn a_body_that_yields_at_one_stress_has_the_curves_of_its_loops() {
    // Without friction a level plane under equal pressure on all sides yields at the cohesion.
    let cohesion = 5e4;
    let law = soil("mohr-coulomb", &values(cohesion, 0.0), None);
    let curves = of_law(law.as_ref(), [-1e6, -1e6, -1e6, 0.0, 0.0, 0.0], 1.0).unwrap();
    let yields = cohesion / SHEAR;
    // At its points, sixteen a decade from 0.5 % down; rows of the loop miss the corner by a part of a row.
    for k in [0, 5, 10, 16, 20] {
        let strain = 0.005 * 10f64.powf(-f64::from(k) / 16.0);
        let [modulus, damping] = curves.at(strain);
        let exact = [yields / strain, FRAC_2_PI * (1.0 - yields / strain)];
        assert!(
            (modulus / exact[0] - 1.0).abs() < 1e-6 && (damping - exact[1]).abs() < 2e-3,
            "{strain}: {modulus} {damping} for {exact:?}"
        );
    }
    assert_eq!(curves.at(0.5 * yields), [1.0, 0.0]);
    // What never yields is linear, elastic or not.
    let stress = [-1e5, -1e5, -2e5, 0.0, 0.0, 0.0];
    for law in [soil("mohr-coulomb", &values(1e9, 0.3), None), soil("elastic", &values(1e9, 0.3), None)] {
        assert_eq!(of_law(law.as_ref(), stress, 1.0), Some(Curves::Linear(0.0)));
    }
    // Friction bears more under more weight.
    let rough = soil("mohr-coulomb", &values(1e4, 0.6), None);
    let at = |pressure: f64| {
        of_law(rough.as_ref(), [-pressure, -pressure, -pressure, 0.0, 0.0, 0.0], 1.0).unwrap().at(1e-3)
    };
    assert!(at(4e5)[0] > 2.0 * at(1e5)[0] && at(4e5)[1] < at(1e5)[1], "{:?} {:?}", at(4e5), at(1e5));
}

/// What free_field.csv holds of a problem with such soil, and what was seen.
fn run(mut problem: Problem, cohesion: f64, band: Option<Band>) -> (Table, YieldingSeen) {
    problem.bodies[1].material = soil("mohr-coulomb", &values(cohesion, 0.0), band);
    let folder = tempfile::tempdir().unwrap();
    let (results, _, memory) = outcome(problem, folder.path());
    (Table::read(&results.free_field()).unwrap(), YieldingSeen::of(&memory).unwrap())
}

fn column<'t>(table: &'t Table, axis: &str, behind: &str) -> &'t [f64] {
    table.column(&format!("reference.top.v{axis}{behind}")).unwrap()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, v| v.abs().max(most))
}

fn apart(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn beside_ground_that_does_not_yield_the_equivalent_linear_column_is_the_linear_one() {
    let damped = |mut problem: Problem| {
        problem.rayleigh = Rayleigh { mass: 0.5, stiffness: 3e-4 };
        problem
    };
    let band = || Some(Band::fit(0.03, [0.5, 20.0], 3.0).unwrap());
    let weak = |mut problem: Problem| {
        problem.incident.as_mut().unwrap().factor *= 1e-3;
        problem
    };
    for (word, problem, cohesion, band) in [
        ("strong", ground(10), 1e9, None),
        ("damped", damped(ground(10)), 1e9, band()),
        ("weakly shaken", weak(ground(10)), 2e4, None),
    ] {
        let (table, seen) = run(problem, cohesion, band);
        for axis in ["x", "y"] {
            let [theory, own] = ["_theory", "_equivalent"].map(|behind| column(&table, axis, behind));
            let (off, peak) = (apart(theory, own), largest(theory));
            assert!(peak > 0.0 && off < 1e-9 * peak, "{word}, {axis}: {off:e} of {peak:e}");
        }
        assert!(seen.found.is_ok(), "{word}: {seen:?}");
    }
}

#[test]
fn beside_ground_that_yields_it_departs_from_linear_theory_towards_the_run() {
    let (linear, _) = run(ground(50), 1e9, None);
    let (table, seen) = run(ground(50), 1.2e5, None);
    let strain = seen.found.unwrap();
    let theory = column(&linear, "x", "_theory");
    let [run_, own] = ["", "_equivalent"].map(|behind| column(&table, "x", behind));
    let square = |a: &[f64]| a.iter().zip(run_).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    let [by_linear, by_own] = [theory, own].map(square);
    let peaks = [theory, run_, own].map(largest);
    eprintln!("strain {strain:.2e}, linear, run, equivalent {peaks:.4?}, misfits {by_linear:.4} {by_own:.4}");
    assert!(strain > 1.2e5 / SHEAR, "{strain}");
    // One pulse that yields at once is no place to be good in: 0.81 of the linear misfit.
    assert!(by_own < 0.9 * by_linear, "{by_own} {by_linear}");
    assert!(peaks[2] < 0.95 * peaks[0], "{peaks:?}");
    assert!((seen.peaks[0] - peaks[1]).abs() < 1e-12 && (seen.peaks[1] - peaks[2]).abs() < 1e-12, "{seen:?}");
}

#[test]
fn beyond_half_a_per_cent_there_is_none_and_the_file_has_no_column_of_it() {
    let mut strong = ground(10);
    strong.incident.as_mut().unwrap().factor *= 30.0;
    let (table, seen) = run(strong, 2e4, None);
    assert!(matches!(seen.found, Err(NoColumn::Strained(strain)) if strain > 0.005), "{seen:?}");
    assert!(table.columns.iter().all(|column| !column.name.contains("equivalent")));
}
