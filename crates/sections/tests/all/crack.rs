//! Widths of cracks: by hand, against a published example, and what turns with the section.

use super::layer;
use tremolite_sections::{Concrete, CrackRule, Layer, Section};

fn section(thickness: f64, layers: &[Layer]) -> Section {
    Section { thickness, concrete: Concrete::en(20e6), layers: layers.to_vec() }
}

/// A slab of 0.5 m, C30/37 (f_ctm 2.896 MPa, E_cm 32.837 GPa), 16 mm each 125 mm (1608 mm²/m) with the axis 58 mm from the face, under 150 kN m/m:
/// by hand x² + 2 α_e A_s (x − d) = 0 with α_e = 6.0907 and d = 0.442 m gives x = 83.78 mm, z = d − x/3 = 414.07 mm, σ_s = M/(A_s z) = 225.21 MPa;
/// h_c,ef = min(145, 138.74, 250) mm, ρ = 0.011594; ε_sm − ε_cm = (225.21 − 0.4 · 2.896/0.011594 · 1.0706)/200,000 = 5.911·10⁻⁴ below
/// 0.6 σ_s/E_s = 6.756·10⁻⁴, which counts; s_r,max = 3.4 · 50 + 0.17 · 16/0.011594 = 404.61 mm; w_k = 0.27337 mm.
#[test]
fn a_bent_slab_is_that_of_the_hand_calculation() {
    let slab = section(0.5, &[layer(1.6085e-3, 0.25 - 0.058)]);
    let crack = CrackRule::en(30e6, 0.016).crack(&slab, [0.0, 150e3]).unwrap();
    let near = |found: f64, by_hand: f64| {
        assert!((found / by_hand - 1.0).abs() < 1e-4, "{found} {by_hand}: {crack:?}");
    };
    near(crack.compressed, 0.08378);
    near(crack.stress, 225.21e6);
    near(crack.spacing, 0.40461);
    near(crack.width, 0.27337e-3);
}

/// Example 7.3 of the worked examples of the European Concrete Platform, as the verification tests of the program `xc` have it: 400 × 600 mm,
/// C30/37, six bars of 24 mm (2712 mm²) with a cover of 40 mm, 452 mm² at the other face, 300 kN m: h_c,ef 130 mm, ρ 0.05215, s_r,max 214.23 mm.
#[test]
fn the_spacing_of_a_published_beam_is_the_printed_one() {
    let beam = section(0.6, &[layer(2712e-6 / 0.4, 0.3 - 0.052), layer(452e-6 / 0.4, 0.046 - 0.3)]);
    let crack = CrackRule::en(30e6, 0.024).crack(&beam, [0.0, 300e3 / 0.4]).unwrap();
    assert!((crack.spacing / 0.214230088 - 1.0).abs() < 1e-6, "{crack:?}");
}

/// Pulled evenly all force is in the bars: σ_s = N/A_s, k_2 = 1, h_c,ef = min(2.5 · 60, 200) mm. By hand with 20 mm each 150 mm (2094.4 mm²/m): N = 800 kN/m
/// gives 190.99 MPa, ρ = 0.013963, 0.6 σ_s/E_s = 5.730·10⁻⁴, s_r,max = 3.4 · 50 + 0.34 · 20/0.013963 = 657.0 mm, w_k = 0.3764 mm.
#[test]
fn a_pulled_wall_is_that_of_the_hand_calculation() {
    let wall = section(0.4, &[layer(2094.4e-6, 0.14), layer(2094.4e-6, -0.14)]);
    let crack = CrackRule::en(25e6, 0.020).crack(&wall, [800e3, 0.0]).unwrap();
    assert!((crack.stress / 190.99e6 - 1.0).abs() < 1e-4 && crack.compressed == 0.0, "{crack:?}");
    assert!((crack.spacing / 0.6570 - 1.0).abs() < 1e-4, "{crack:?}");
    assert!((crack.width / 0.3764e-3 - 1.0).abs() < 2e-4, "{crack:?}");
}

/// The same wall pulled by 300 kN/m off its middle by 10 kN m/m, all of it cracked: 185.71 and 114.29 kN/m in the bars, 88.672 and 54.568 MPa, strains of the
/// faces as 95.98 to 47.26, k_2 = 0.7462 at both, s_r,max = 3.4 · 50 + 0.8 · 0.7462 · 0.425 · 20/0.013963 = 533.4 mm, w_k = 533.4 mm · 0.6 · 88.672/200,000 = 0.14189 mm.
/// With the lesser strain below in k_2 the face that opens less had the wider crack, 0.1486 mm.
#[test]
fn a_wall_pulled_off_its_middle_is_that_of_the_hand_calculation() {
    let wall = section(0.4, &[layer(2094.4e-6, 0.14), layer(2094.4e-6, -0.14)]);
    let rule = CrackRule::en(25e6, 0.020);
    for m in [10e3, -10e3] {
        let crack = rule.crack(&wall, [300e3, m]).unwrap();
        assert!((crack.stress / 88.672e6 - 1.0).abs() < 1e-4 && crack.compressed == 0.0, "{crack:?}");
        assert!((crack.spacing / 0.5334 - 1.0).abs() < 1e-4, "{crack:?}");
        assert!((crack.width / 0.14189e-3 - 1.0).abs() < 2e-4, "{crack:?}");
    }
    // No spacing is beyond that of even tension.
    let even = rule.crack(&wall, [300e3, 0.0]).unwrap().spacing;
    for m in (0..=41).map(|k| 1e3 * f64::from(k)) {
        let crack = rule.crack(&wall, [300e3, m]).unwrap();
        assert!(crack.spacing <= even * (1.0 + 1e-9), "{m}: {crack:?}");
    }
}

/// Equilibrium by summing strips of the strain that the crack tells of, over thrusts and moments of either sign; turned over the section has the
/// same crack.
#[test]
fn the_cracked_section_is_in_equilibrium_and_turns_with_its_moment() {
    let (h, rule) = (0.5, CrackRule::en(30e6, 0.016));
    let layers = [layer(1.2e-3, 0.19), layer(0.7e-3, -0.2)];
    let turned = layers.map(|l| Layer { depth: -l.depth, ..l });
    for n in [-800e3, -100e3, 0.0, 50e3] {
        for m in [-120e3, -50e3, 50e3, 120e3] {
            let crack = rule.crack(&section(h, &layers), [n, m]).unwrap();
            let other = rule.crack(&section(h, &turned), [n, -m]).unwrap();
            assert!((crack.width - other.width).abs() <= 1e-9 * crack.width, "{n} {m}");
            if crack.stress == 0.0 || crack.compressed == 0.0 {
                continue;
            }
            // The plane through zero at the border of what is compressed and σ_s/E_s at the bars.
            let side = m.signum();
            let depth = if side > 0.0 { 0.19 } else { -0.2 };
            let zero = side * (-0.5 * h + crack.compressed);
            let slope = crack.stress / 200e9 / (depth - zero);
            let strain = |y: f64| slope * (y - zero);
            const STRIPS: i32 = 20_000;
            let mut sums = layers.iter().fold([0.0; 2], |s, l| {
                let force = l.area * 200e9 * strain(l.depth);
                [s[0] + force, s[1] + force * l.depth]
            });
            for k in 0..STRIPS {
                let y = (f64::from(k) + 0.5) / f64::from(STRIPS) * h - 0.5 * h;
                let force = rule.young * strain(y).min(0.0) * h / f64::from(STRIPS);
                sums = [sums[0] + force, sums[1] + force * y];
            }
            let size = n.abs().max(m.abs() / h);
            assert!(
                (sums[0] - n).abs() < 1e-5 * size && (sums[1] - m).abs() < 1e-5 * size * h,
                "{n} {m} {sums:?}"
            );
        }
    }
}

#[test]
fn what_is_compressed_has_no_crack_and_what_yields_no_width() {
    let rule = CrackRule::en(30e6, 0.016);
    let both = section(0.5, &[layer(1e-3, 0.19), layer(1e-3, -0.19)]);
    assert_eq!(rule.crack(&both, [-2e6, 10e3]).unwrap().width, 0.0);
    assert_eq!(rule.crack(&both, [0.0, 400e3]).unwrap().width, f64::INFINITY);
    assert_eq!(rule.crack(&section(0.5, &[]), [0.0, 10e3]), None);
    // One row of bars cannot be pulled off its own line.
    assert_eq!(rule.crack(&section(0.5, &[layer(1e-3, 0.19)]), [100e3, -100e3]), None);
    // Nor has a face that opens without bars a width.
    assert_eq!(rule.crack(&section(0.5, &[layer(1e-3, 0.19)]), [-1e6, -120e3]), None);
}
