//! Bricks are the general element, with hardly any geometry.

use crate::common::{Random, samples};
use tremolite_laws::shapes::hex8::{
    BrickGeometry, CORNERS, Given, Hex8, OnePointGeometry, OnePointShape, Probe, Stabilisation, one_point,
    turned,
};
use tremolite_laws::{Material, Octet, Point, Row};

/// What a pass leaves: forces, stress, energies, history.
fn pass<G: OnePointShape, M: Material>(
    law: &M,
    hex: &Hex8,
    u: [[f64; 3]; 8],
    history: &mut [Octet],
) -> Vec<f64> {
    let mut geometry = G::EMPTY;
    geometry.set(0, hex);
    let index: [[u16; 8]; 8] = std::array::from_fn(|k| [k as u16; 8]);
    let (rows, mut out, mut probe) = (u.map(Row::new), [Row::ZERO; 8], Probe::ZERO);
    // SAFETY: eight rows, indices 0 to 7, and the scalar lane needs no instruction set.
    unsafe {
        one_point::<f64, _, _, true>(
            law,
            &Stabilisation::new(law.moduli()),
            &Point::new(1e-4),
            &geometry,
            &index,
            history,
            None,
            &mut [],
            Given::NONE,
            &mut [],
            &rows,
            &mut out,
            &mut probe,
        );
    }
    let energies = [probe.strain_energy, probe.hourglass_energy, probe.dissipated, probe.created];
    let seen = probe.stress[0].into_iter().chain(energies).chain(history.iter().copied());
    out.iter().flat_map(|row| row.xyz()).chain(seen.map(|octet| octet.0[0])).collect()
}

fn brick(sides: [f64; 3]) -> [[f64; 3]; 8] {
    CORNERS.map(|c| [0, 1, 2].map(|i| 7.0 + sides[i] * 0.5 * c[i]))
}

/// Whole paths, with yield and cracks where the law has them: what one remembers the other does.
fn along_a_path<M: Material>(values: &tremolite_laws::Values) {
    let Ok(law) = M::new(values) else { panic!("{}", M::NAME) };
    let mut random = Random::new(5);
    for _ in 0..20 {
        let sides = [0, 1, 2].map(|_| 2.0_f64.powf(2.0 * random.symmetric()));
        let hex = Hex8::new(brick(sides)).unwrap();
        let mut histories = [(); 2].map(|()| vec![Octet::ZERO; M::HISTORY.len()]);
        let way: [[[f64; 3]; 8]; 2] = std::array::from_fn(|_| {
            std::array::from_fn(|_| std::array::from_fn(|_| 3e-4 * random.symmetric()))
        });
        let mut most = vec![0.0_f64; 34 + M::HISTORY.len()];
        for step in 0..40 {
            let at = f64::from(step) / 10.0;
            let u = std::array::from_fn(|c| {
                [0, 1, 2].map(|i| way[0][c][i] * at + way[1][c][i] * (3.0 * at).sin())
            });
            let [one, two] = &mut histories;
            let general = pass::<OnePointGeometry, M>(&law, &hex, u, one);
            let small = pass::<BrickGeometry, M>(&law, &hex, u, two);
            let largest = general[..24].iter().fold(0.0_f64, |most, f| most.max(f.abs()));
            // Forces, stresses and energies by the largest of the path so far, what is remembered by a millionth of that at least.
            for (k, value) in general.iter().enumerate() {
                let group =
                    [0..24, 24..30, 30..34, 34..general.len()].into_iter().find(|group| group.contains(&k));
                let share = if k < 34 { 1.0 } else { 1e-6 };
                group.into_iter().flatten().for_each(|k| most[k] = most[k].max(share * value.abs()));
                most[k] = most[k].max(value.abs());
            }
            for (k, (a, b)) in general.iter().zip(&small).enumerate() {
                assert!((a - b).abs() <= 1e-9 * most[k] + 1e-12, "{} step {step}, {k}: {a:e} {b:e}", M::NAME);
            }
            if M::HISTORY.is_empty() {
                let apart = |(a, b): (&f64, &f64)| (a - b).abs() / largest;
                let worst = general[..24].iter().zip(&small).map(apart).fold(0.0, f64::max);
                // Round-off of coordinates of 7 m in sides of a quarter of one at least.
                assert!(worst < 2e-14, "{worst:e}");
            }
        }
    }
}

#[test]
fn bricks_resist_as_the_general_element_does_whatever_the_law() {
    macro_rules! all {
        ($($law:ty,)*) => { $(
            for sample in samples::samples(<$law>::NAME) {
                along_a_path::<$law>(&sample.values());
            }
        )* };
    }
    tremolite_laws::for_each_material!(all);
}

#[test]
fn whatever_its_numbering_a_brick_is_known_and_turned_upright() {
    let corners = brick([2.0, 0.25, 1.0]);
    let straight = [0, 1, 2, 3, 4, 5, 6, 7];
    assert_eq!(Hex8::new(corners).unwrap().upright(), Some(straight));
    let mut orders = vec![straight];
    for _ in 0..3 {
        let more = orders.iter().flat_map(|order| [0, 1].map(|axis| turned(axis).map(|k| order[k])));
        orders.extend(more.collect::<Vec<_>>());
        // A quarter of a turn about ζ.
        orders.extend(orders.clone().iter().map(|o| [1, 2, 3, 0, 5, 6, 7, 4].map(|k| o[k])));
    }
    orders.sort_unstable();
    orders.dedup();
    assert_eq!(orders.len(), 24);
    for order in orders {
        let hex = Hex8::new(order.map(|k| corners[k])).unwrap();
        let back = hex.upright().unwrap();
        assert_eq!(back.map(|k| hex.corners[k]), corners, "{order:?}");
    }
}

#[test]
fn what_leans_is_no_brick() {
    let mut random = Random::new(8);
    for _ in 0..50 {
        let (corner, axis) =
            ((random.symmetric().abs() * 7.99) as usize, (random.symmetric().abs() * 2.99) as usize);
        let mut corners = brick([2.0, 0.25, 1.0]);
        corners[corner][axis] += 1e-9 * random.symmetric().signum();
        assert_eq!(Hex8::new(corners).unwrap().upright(), None);
    }
    // A wedge: two corners at one place.
    let mut wedge = brick([1.0; 3]);
    (wedge[3], wedge[7]) = (wedge[2], wedge[6]);
    assert_eq!(Hex8::new(wedge).unwrap().upright(), None);
    // Turned by 45 degrees, so that each corner is on an outer plane of its extent.
    let r = 0.5_f64.sqrt();
    let turned = brick([1.0; 3]).map(|[x, y, z]| [r * (x - y), r * (x + y), z]);
    assert_eq!(Hex8::new(turned).unwrap().upright(), None);
}

/// Skew is told by what it moves a corner by, over the shortest edge: as much of it in an element of a millimetre as in one of a kilometre.
#[test]
fn bricks_are_told_apart_by_the_same_skew_at_any_size() {
    for size in [1e-3, 1.0, 1e3] {
        let sheared =
            |skew: f64| brick([size; 3]).map(|[x, y, z]| [x - 7.0 + skew * (z - 7.0), y - 7.0, z - 7.0]);
        assert!(Hex8::new(sheared(0.0)).unwrap().is_brick(), "{size}");
        assert!(!Hex8::new(sheared(1e-10)).unwrap().is_brick(), "{size}");
    }
}
