//! Flow below its free surface everywhere: heads and flow have closed forms.

use crate::common::{K, Made, even, farthest, grid, middle};
use tremolite_seepage::{Holds, Place};

/// A quarter of a ring about y, a 5 m, b 50 m, `n` elements around and 4n across. (Each as long as it is wide, nodal heads would be exact.)
fn ring(n: usize) -> Made {
    let mut made = grid(&even(0.0, 1.0, 4 * n), &[0.0, 1.0], &even(0.0, 1.0, n));
    for x in &mut made.nodes {
        let (r, angle) = (5.0 + 45.0 * x[0], x[2] * std::f64::consts::FRAC_PI_2);
        *x = [r * angle.cos(), x[1], r * angle.sin()];
    }
    made
}

/// h = h_a + (h_b − h_a) ln(r/a)/ln(b/a), q = (π/2) k (h_b − h_a)/ln(b/a) a metre of the quarter.
#[test]
fn radial_flow() {
    let exact = |x: [f64; 3]| 100.0 + 200.0 * (x[0].hypot(x[2]) / 5.0).ln() / 10.0_f64.ln();
    let inflow = std::f64::consts::FRAC_PI_2 * K * 200.0 / 10.0_f64.ln();
    let mut errors = Vec::new();
    for n in [8, 16, 32] {
        let made = ring(n);
        let at = |radius: f64| move |x: [f64; 3]| (x[0].hypot(x[2]) - radius).abs() < 1e-9;
        let places = [
            made.place("outer", Holds::Head(300.0), at(50.0)),
            made.place("wall", Holds::Head(100.0), at(5.0)),
        ];
        let flow = made.solve(&places).unwrap();
        assert!((flow.outflows[0] + flow.outflows[1]).abs() < 1e-8 * inflow && flow.mass_error < 1e-8);
        assert!((flow.inflow - flow.outflows[1]).abs() < 1e-8 * inflow);
        let middle: Vec<f64> = (0..made.elements.len())
            .map(|e| {
                let (x, q) = (middle(&made, e), flow.velocities[e]);
                let r = x[0].hypot(x[2]);
                ((q[0] * x[0] + q[2] * x[2]) / r * r + K * 200.0 / 10.0_f64.ln()).abs()
                    / (K * 200.0 / 10.0_f64.ln())
            })
            .collect();
        let discharge = middle.iter().copied().fold(0.0, f64::max);
        errors.push([flow.outflows[1] / inflow - 1.0, farthest(&made, &flow, exact) / 200.0, discharge]);
    }
    let order = |k: usize| (errors[1][k] / errors[2][k]).abs().log2();
    assert!(errors[2][0].abs() < 1e-3 && errors[2][1] < 1e-3, "0.1 %: {errors:?}");
    for k in 0..3 {
        assert!((order(k) - 2.0).abs() < 0.2, "order {}: {errors:?}", order(k));
    }
}

/// Layers across a column: each takes its share of the head, t/k over the sum.
#[test]
fn tight_layer() {
    let mut made = grid(&even(0.0, 2.0, 2), &even(0.0, 3.0, 2), &[0.0, 2.0, 3.0, 7.0, 7.5, 9.0]);
    let of = |z: f64| if (3.0..7.0).contains(&z) { 1e-12 } else { 1e-6 };
    made.conductivity = (0..made.elements.len()).map(|e| of(middle(&made, e)[2])).collect();
    let places = [
        made.place("base", Holds::Head(60.0), |x| x[2] == 0.0),
        made.place("top", Holds::Head(40.0), |x| x[2] == 9.0),
    ];
    let flow = made.solve(&places).unwrap();
    let resistance = 4.0 / 1e-12 + 5.0 / 1e-6;
    let q = 20.0 / resistance;
    let exact = |x: [f64; 3]| {
        let below = x[2].min(3.0) + (x[2] - 7.0).max(0.0);
        60.0 - q * (below / 1e-6 + (x[2] - 3.0).clamp(0.0, 4.0) / 1e-12)
    };
    assert!(farthest(&made, &flow, exact) < 1e-8, "{}", farthest(&made, &flow, exact));
    assert!((flow.outflows[1] / (6.0 * q) - 1.0).abs() < 1e-6, "{:?}", flow.outflows);
    assert!((flow.outflows[0] + flow.outflows[1]).abs() < 1e-6 * flow.outflows[1]);
}

/// Ground under one head has that head everywhere, above the free surface too, and nothing flows: to the last bit.
#[test]
fn still_water() {
    let made = grid(&even(0.0, 7.0, 5), &even(0.0, 9.0, 4), &even(-200.0, 0.0, 9));
    let sides = made.place("sides", Holds::Head(-53.7), |x| x[0] == 0.0 || x[0] == 7.0);
    let flow = made.solve(&[sides]).unwrap();
    assert_eq!(farthest(&made, &flow, |_| -53.7), 0.0);
    assert_eq!((flow.inflow, flow.mass_error), (0.0, 0.0));
    assert!(flow.velocities.iter().all(|q| *q == [0.0; 3]));
}

/// The mirror image of ground has the mirror image of its flow.
#[test]
fn mirror_image() {
    let x = [-6.0, -5.0, -3.0, -1.0, 0.0, 1.0, 3.0, 5.0, 6.0];
    let made = grid(&x, &even(0.0, 2.0, 2), &even(0.0, 8.0, 8));
    let sides = made.place("sides", Holds::Head(7.3), |x| x[0].abs() == 6.0);
    let drain: Vec<(u32, f64)> = (0..made.nodes.len() as u32)
        .filter(|&n| made.nodes[n as usize][0] == 0.0 && made.nodes[n as usize][2] == 3.0)
        .map(|n| (n, 1.0))
        .collect();
    let drain = Place { name: "drain".into(), holds: Holds::Open(None), nodes: drain };
    let flow = made.solve(&[sides, drain]).unwrap();
    let count = x.len();
    let other = |n: usize| n - n % count + (count - 1 - n % count);
    let apart =
        (0..made.nodes.len()).map(|n| (flow.heads[n] - flow.heads[other(n)]).abs()).fold(0.0, f64::max);
    assert!(apart < 1e-6 * 4.3, "a tenth of what is at rest: {apart}");
    assert!(flow.inflow > 0.0 && flow.heads.iter().any(|h| *h < 7.0));
}

/// Flow goes by ratios of permeabilities: that of k = 10⁻¹⁶⁰ m/s has the heads of k = 2·10⁻⁶ m/s, and closes as well.
#[test]
fn very_small_permeabilities() {
    let mut made = ring(8);
    let solve = |made: &Made| {
        let at = |radius: f64| move |x: [f64; 3]| (x[0].hypot(x[2]) - radius).abs() < 1e-9;
        let outer = made.place("outer", Holds::Head(300.0), at(50.0));
        made.solve(&[outer, made.place("wall", Holds::Open(None), at(5.0))]).unwrap()
    };
    let usual = solve(&made);
    for k in [1e-160, 3e-290] {
        made.conductivity.fill(k);
        let small = solve(&made);
        let apart = small.heads.iter().zip(&usual.heads).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-9 && small.mass_error < 1e-9, "{k}: {apart} m, {}", small.mass_error);
        assert!((small.outflows[1] / k * K / usual.outflows[1] - 1.0).abs() < 1e-9, "{k}");
    }
}

/// A wall that takes nothing takes +0.
#[test]
fn nothing_has_no_sign() {
    let made = grid(&even(0.0, 2.0, 2), &even(0.0, 2.0, 2), &even(0.0, 2.0, 2));
    let places = [
        made.place("left", Holds::Head(5.0), |x| x[0] == 0.0),
        made.place("right", Holds::Head(5.0), |x| x[0] == 2.0),
        made.place("nowhere", Holds::Open(None), |_| false),
    ];
    let flow = made.solve(&places).unwrap();
    assert!(
        flow.outflows.iter().chain([&flow.inflow]).all(|q| *q == 0.0 && q.is_sign_positive()),
        "{:?}",
        flow.outflows
    );
}
