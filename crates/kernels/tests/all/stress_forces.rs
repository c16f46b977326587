//! Forces of given stresses, in elements of any shape and in bricks, whose kernels have axes of their own.

use tremolite_kernels::{Motion, Own, ProbeOut, Scratch, Tick, elastic};
use tremolite_laws::shapes::hex8::{CORNERS, Hex8, Layers, Quadrature};
use tremolite_laws::{Isa, Moduli, Octet, Row};

/// The stresses that elastic elements have at their points give the forces that they resist with.
#[test]
fn the_stresses_of_elements_give_their_forces() {
    // A turn about x + 2y + 3z of nearly a right angle.
    let (c, s) = (0.1_f64.cos() - 0.9, 0.8_f64);
    let raw = [[c, -s, 0.3], [s, c, -0.2], [0.1, 0.4, 1.0]];
    let unit = |v: [f64; 3]| {
        let n = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        v.map(|x| x / n)
    };
    let less = |v: [f64; 3], u: [f64; 3]| {
        let dot: f64 = (0..3).map(|i| v[i] * u[i]).sum();
        [0, 1, 2].map(|i| v[i] - dot * u[i])
    };
    let x = unit(raw[0]);
    let y = unit(less(raw[1], x));
    let z = unit(less(less(raw[2], x), y));
    let axes = [x, y, z];
    for skew in [0.0, 0.05] {
        let corners = CORNERS.map(|c| {
            let place = |i: usize| (0..3).map(|k| 0.5 * c[k] * [1.0, 0.6, 0.3][k] * axes[k][i]).sum::<f64>();
            [place(0) + skew * c[0] * c[1], place(1) + skew * c[1] * c[2], place(2)]
        });
        let hex = Hex8::new(corners).unwrap();
        assert_eq!(hex.is_brick(), skew == 0.0);
        for quadrature in [Quadrature::Full, Quadrature::Layered(Layers::Seven)] {
            let material = elastic(Moduli::from_young_poisson(25e9, 0.2));
            let corners = [[0, 1, 2, 3, 4, 5, 6, 7]];
            let hexes = [hex.clone()];
            let part =
                material.patch(quadrature, (0..8).collect(), &corners, &hexes, &[], &[], &[], Isa::best());
            let u: Vec<Row> = (0..8)
                .map(|k| Row::new([0, 1, 2].map(|i| 1e-4 * (1.7 * f64::from(3 * k + i)).sin())))
                .collect();
            let mut stress = vec![[0.0; 6]; quadrature.points()];
            let mut energy = [Default::default()];
            let mut scratch = Scratch::default();
            let (mut forces, mut given) = (vec![Row::ZERO; 8], vec![Row::ZERO; 8]);
            let own = Own {
                history: &mut [],
                overstress: &mut [],
                numbers: &mut [],
                reference: &mut [],
                initial: &[] as &[Octet],
            };
            let tick = Tick { time: 0.0, dt: 0.0, step: 0 };
            let probe = ProbeOut { stress: &mut stress, energy: &mut energy };
            part.probe(&tick, &Motion::new(&u, &u), own, &mut forces, probe, &mut scratch);
            part.stress_forces(&stress, &mut given, &mut scratch);
            let largest = forces.iter().flat_map(Row::xyz).fold(0.0_f64, |most, f| most.max(f.abs()));
            for (a, b) in forces.iter().zip(&given) {
                for i in 0..3 {
                    assert!((a.0[i] - b.0[i]).abs() < 1e-12 * largest, "{quadrature:?}: {a:?} and {b:?}");
                }
            }
        }
    }
}
