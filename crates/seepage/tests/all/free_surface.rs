//! Flow with a free surface, which is found.

use crate::common::{K, Made, even, grid};
use tremolite_seepage::{Holds, Place};

/// Rectangular dam, H₁ 10 m, H₂ 2 m, L 5 m, `n` elements along its length; turned about z by an angle.
fn dam(n: usize, angle: f64) -> (Made, [Place; 2]) {
    let mut made = grid(&even(0.0, 5.0, n), &[0.0, 1.0], &even(0.0, 10.0, 2 * n));
    let up = made.place("up", Holds::Head(10.0), |x| x[0] == 0.0);
    let down = made.place("down", Holds::Open(Some(2.0)), |x| x[0] == 5.0);
    for x in &mut made.nodes {
        *x = [angle.cos() * x[0] - angle.sin() * x[1], angle.sin() * x[0] + angle.cos() * x[1], x[2]];
    }
    (made, [up, down])
}

/// q = k (H₁² − H₂²)/2L holds though the water leaves by a seepage face as well (`charny1951`, `harr1962`). What flows above the free surface makes an
/// error of order 1 in the height of elements.
#[test]
fn dupuit_charny_dam() {
    let exact = K * (100.0 - 4.0) / 10.0;
    let errors = [10, 20, 40].map(|n| {
        let (made, places) = dam(n, 0.0);
        let flow = made.solve(&places).unwrap();
        assert!(flow.mass_error < 1e-6, "{}", flow.mass_error);
        flow.outflows[1] / exact - 1.0
    });
    for (error, most) in errors.iter().zip([0.018, 0.010, 0.005]) {
        assert!(*error > 0.0 && *error < most, "{errors:?}");
    }
    let order = (errors[1] / errors[2]).log2();
    assert!((order - 1.0).abs() < 0.2, "order {order}: {errors:?}");
}

/// The free surface meets the wall above the water outside, falls all the way, and all above it sucks.
#[test]
fn seepage_face() {
    let face = |n: usize| {
        let (made, places) = dam(n, 0.0);
        let flow = made.solve(&places).unwrap();
        let pressure_head = |n: usize| flow.heads[n] - made.nodes[n][2];
        let top = |x: f64| {
            let wet = (0..made.nodes.len()).filter(|&n| made.nodes[n][0] == x && pressure_head(n) >= -1e-9);
            wet.map(|n| made.nodes[n][2]).fold(0.0, f64::max)
        };
        let tops: Vec<f64> = even(0.0, 5.0, n).into_iter().map(top).collect();
        assert!(tops.is_sorted_by(|a, b| a >= b), "{tops:?}");
        assert_eq!(tops[0], 10.0);
        for n in (0..made.nodes.len()).filter(|&n| made.nodes[n][0] == 5.0) {
            assert!(pressure_head(n) <= 1e-8 || made.nodes[n][2] <= 2.0, "no pressure on an open wall");
        }
        tops[n]
    };
    let [coarse, fine] = [20, 40].map(face);
    assert!(coarse > 2.5 && (coarse - fine).abs() <= 0.25, "within an element: {coarse} {fine}");
}

#[test]
fn turned_about_the_vertical() {
    let flow = |angle| {
        let (made, places) = dam(10, angle);
        made.solve(&places).unwrap()
    };
    let (straight, turned) = (flow(0.0), flow(0.7));
    assert!((turned.outflows[1] / straight.outflows[1] - 1.0).abs() < 1e-8);
}

/// Four times the conductivity is four times the flow under the same heads (a power of four, so to the last bit).
#[test]
fn conductivity_scales_the_flow() {
    let (mut made, places) = dam(10, 0.0);
    let once = made.solve(&places).unwrap();
    made.conductivity.iter_mut().for_each(|k| *k *= 4.0);
    let more = made.solve(&places).unwrap();
    assert_eq!(more.heads, once.heads);
    assert_eq!(more.outflows[1], 4.0 * once.outflows[1]);
}

/// Elements of wedges conduct the same whichever corners of the hexahedron fall together.
#[test]
fn wedges_know_no_order_of_corners() {
    let heads = [0, 1, 2].map(|turns| {
        let (mut made, places) = dam(10, 0.0);
        let turned = |n: [u32; 3], m: [u32; 3]| {
            let at = |ring: [u32; 3], k: usize| ring[(k + turns) % 3];
            [at(n, 0), at(n, 1), at(n, 2), at(n, 2), at(m, 0), at(m, 1), at(m, 2), at(m, 2)]
        };
        // Parted across y, so that the free surface goes through corners that fall together.
        let parted = |n: &[u32; 8]| {
            [turned([n[0], n[4], n[5]], [n[3], n[7], n[6]]), turned([n[0], n[5], n[1]], [n[3], n[6], n[2]])]
        };
        made.elements = made.elements.iter().flat_map(parted).collect();
        made.conductivity = vec![K; made.elements.len()];
        made.solve(&places).unwrap().heads
    });
    let apart = |a: &[f64]| a.iter().zip(&heads[0]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(
        apart(&heads[1]) < 1e-6 * 8.0 && apart(&heads[2]) < 1e-6 * 8.0,
        "{} {}",
        apart(&heads[1]),
        apart(&heads[2])
    );
}
