//! Shear by hand.

use super::{en_design, layer, rule};
use tremolite_sections::{Code, Rule};

/// EN 1992-1-1 6.2.2 with d = 540 mm, ρ = 1570/540000 = 0.29 %, f_ck = 30 MPa, γ_c = 1.5: k = 1.6086; 0.12 · 1.6086 · (8.722)^⅓ = 0.3973,
/// v_min = 0.035 · 1.6086^1.5 · 30^½ = 0.3911 MPa; V = 214.6 kN/m. With 1 MN/m of thrust 0.15 · 1.667 MPa more: 349.6 kN/m.
#[test]
fn concrete_with_steel() {
    let capacity = en_design().capacity(0.6, &[layer(1.57e-3, 0.24), layer(1.57e-3, -0.24)], 1.0);
    let close = |found: f64, wanted: f64| assert!((found / wanted - 1.0).abs() < 1e-3, "{found} {wanted}");
    close(capacity.shear([0.0, 1.0], 214.6e3), 1.0);
    close(capacity.shear([-1e6, -1.0], -349.6e3), 1.0);
    // Tension takes as much as pressure gives.
    close(capacity.shear([0.5e6, 1.0], 214.6e3 - 67.5e3), 1.0);
}

/// EN 1992-1-1 12.6.3 with f_cd = 16 and f_ctd = 1.2 MPa: without thrust V = 1.2 · 500/1.5 = 400 kN/m; at 2 MPa, below the limit of
/// 16 − 2 (1.2 · 17.2)^½ = 6.914 MPa, (1.44 + 2.4)^½ = 1.9596 MPa; at 8 MPa (1.44 + 9.6 − 0.543²)^½ = 3.278 MPa.
#[test]
fn plain_concrete() {
    let capacity = Rule {
        compression_factor: 0.8,
        tension_factor: 0.8,
        concrete_factor: 1.25,
        ..rule(Code::En, "C25/30")
    };
    let capacity = capacity.capacity(0.5, &[], 1.0);
    let close = |found: f64, wanted: f64| assert!((found / wanted - 1.0).abs() < 1e-3, "{found} {wanted}");
    // f_cd = 16, f_ctd = 1.152 MPa.
    close(capacity.shear([0.0, 0.0], 1.152e6 * 0.5 / 1.5), 1.0);
    close(capacity.shear([-1e6, 0.0], (1.152f64.powi(2) + 2.0 * 1.152).sqrt() * 1e6 * 0.5 / 1.5), 1.0);
    let limit = 16.0 - 2.0 * (1.152 * (16.0 + 1.152_f64)).sqrt();
    let square = 1.152f64.powi(2) + 8.0 * 1.152 - ((8.0 - limit) / 2.0).powi(2);
    close(capacity.shear([-4e6, 0.0], square.sqrt() * 1e6 * 0.5 / 1.5), 1.0);
    // M/N of 0.08 m lies in the core of 0.5/6 m; with 0.15 m 0.2 m are pressed, at 5 MPa: (1.152² + 5 · 1.152)^½ = 2.662 MPa.
    close(capacity.shear([-1e6, 0.08e6], 635.2e3), 1.0);
    close(capacity.shear([-1e6, -0.15e6], 355.0e3), 1.0);
    // Beyond the face nothing is pressed.
    assert_eq!(capacity.shear([-1e6, 0.3e6], 1e3), f64::INFINITY);
}

/// Bars at one face count where they are pulled; where they are not, the clauses for sections with bars give no number.
#[test]
fn bars_at_one_face() {
    for code in [Code::En, Code::Gb] {
        let design = rule(code, if code == Code::En { "C30/37" } else { "C30" });
        let one = design.capacity(0.6, &[layer(1.57e-3, 0.24)], 1.0);
        let both = design.capacity(0.6, &[layer(1.57e-3, 0.24), layer(1.57e-3, -0.24)], 1.0);
        assert_eq!(one.shear([-1e6, 1.0], 1e5), both.shear([-1e6, 1.0], 1e5));
        assert!(one.shear([-1e6, -1.0], 1e5).is_nan());
    }
}

/// GB 50010-2010 6.3.3: h_0 = 1000 mm, β_h = (800/1000)^¼ = 0.9457; f_t = 2.01/1.4 = 1.4357 MPa: 0.7 · 0.9457 · 1.4357 · 1000 = 950.5 kN/m.
#[test]
fn slabs_by_gb() {
    let design = Rule { concrete_factor: 1.4, ..rule(Code::Gb, "C30") };
    let capacity = design.capacity(1.06, &[layer(2e-3, 0.47), layer(2e-3, -0.47)], 1.0);
    assert!((capacity.shear([-1e6, 1.0], 950.5e3) - 1.0).abs() < 1e-3);
    assert!((capacity.shear([1e6, 1.0], 750.5e3) - 1.0).abs() < 1e-3);
    assert!(design.capacity(1.06, &[], 1.0).shear([0.0, 0.0], 1.0).is_nan());
}
