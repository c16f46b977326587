//! Against the library `structuralcodes` of the fib and a published example.

use super::{en_design, layer, rule};
use tremolite_sections::{Capacity, Code, Rule};

/// `structuralcodes` 0.7.2, EN 1992-1-1:2004, a section of 1 m × 0.6 m, parabola and rectangle, B500 elastic and plastic without limit:
/// N \[kN\] and the largest M \[kN m\] beside it. It integrates by Marin's polygons and joins bars of points. Its concrete is not taken
/// out for the steel, as here.
fn compare(capacity: &Capacity, values: &[(f64, f64)], tolerance: f64) {
    for &(n, m) in values {
        let found = capacity.utilisation([n * 1e3, m * 1e3]);
        assert!((found - 1.0).abs() < tolerance, "N {n} M {m}: {found}");
    }
}

#[test]
fn a_symmetric_section_with_factors_is_that_of_structuralcodes() {
    let capacity = en_design().capacity(0.6, &[layer(1.57e-3, 0.24), layer(1.57e-3, -0.24)], 1.0);
    let values = [
        (-6000.0, 1169.4337),
        (-3000.0, 996.4238),
        (-1000.0, 601.6774),
        (0.0, 360.0210),
        (300.0, 285.8811),
        (1365.217391, 0.0),
    ];
    compare(&capacity, &values, 2e-4);
}

#[test]
fn an_unlike_section_without_factors_is_that_of_structuralcodes() {
    let capacity = rule(Code::En, "C30/37").capacity(0.6, &[layer(2e-3, 0.24), layer(0.8e-3, -0.25)], 1.0);
    let values =
        [(-6000.0, 1573.9031), (-3000.0, 1195.9945), (-1000.0, 774.3299), (0.0, 523.9361), (300.0, 446.0799)];
    compare(&capacity, &values, 2e-4);
}

/// A section of 1 m × 0.6 m, C25/30, six bars of 16 mm at 74 mm from one face and six of 4 mm at 68 mm from the other, by an independent
/// program (eurocodeapplied.com, as the verification tests of `xc` have it): 268.71 kN m beside 0.64 kN of thrust.
#[test]
fn a_lightly_reinforced_section_is_that_of_another_program() {
    let concrete = Rule { concrete_factor: 1.5, steel_factor: 1.15, ..rule(Code::En, "C25/30") };
    let bars = |diameter: f64| 6.0 * std::f64::consts::FRAC_PI_4 * diameter * diameter;
    let layers = [layer(bars(0.016), 0.3 - 0.074), layer(bars(0.004), 0.068 - 0.3)];
    compare(&concrete.capacity(0.6, &layers, 1.0), &[(-0.6391, 268.71)], 2e-4);
}

/// Column B2 of the worked examples of the JRC (`jrc2014`): 500 × 500 mm, d_1 = 50 mm, f_cd 20 MPa, f_yd 435 MPa, N = −4384 kN (ν = 0.877),
/// M = 214.82 kN m (μ = 0.086). A design chart, whose lines are 0.1 of ω apart, gives ω = 0.20: what is needed lies between that line
/// and the one before.
#[test]
fn a_published_column_needs_what_its_chart_says() {
    let design = Rule { concrete_factor: 1.5, steel_factor: 500.0 / 435.0, ..rule(Code::En, "C30/37") };
    let utilisation = |omega: f64| {
        // Of each face, a metre wide.
        let area = 0.5 * omega * 0.5 * 20.0 / 435.0;
        let capacity = design.capacity(0.5, &[layer(area, 0.2), layer(area, -0.2)], 1.0);
        capacity.utilisation([2.0 * -4384e3, 2.0 * 214.82e3])
    };
    let found = [0.1, 0.2].map(utilisation);
    assert!(found[0] > 1.0 && found[1] < 1.0, "{found:?}");
}
