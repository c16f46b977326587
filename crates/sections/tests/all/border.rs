//! The border of sections with steel: integrals, symmetry, shape.

use super::{en_design, layer, rule};
use tremolite_sections::{Code, Concrete, Diagram, Layer, Section};

fn section(layers: Vec<Layer>) -> Section {
    Section { thickness: 0.6, concrete: Concrete::en(20e6), layers }
}

/// Sums over 200,000 strips, whose error falls with the square of their thickness, against the closed form.
#[test]
fn forces_of_plane_strains_are_those_of_strips() {
    let section = section(vec![layer(1.57e-3, 0.24), layer(0.8e-3, -0.25)]);
    let strips = 200_000;
    for (middle, curvature) in [
        (-1e-3, 0.0),
        (-1.2e-3, 3e-3),
        (0.8e-3, -9e-3),
        (2e-3, 1e-2),
        (1e-3, 0.0),
        (-2.5e-3, 1e-3),
        (0.0, 5e-2),
    ] {
        let thin = section.thickness / f64::from(strips);
        let mut sums = [0.0; 2];
        for k in 0..strips {
            let y = (f64::from(k) + 0.5) * thin - 0.5 * section.thickness;
            let strain: f64 = middle + curvature * y;
            // The law in its own words, strain positive in compression.
            let e = -strain;
            let stress = match e {
                e if e <= 0.0 => 0.0,
                e if e < 2e-3 => -20e6 * (1.0 - (1.0 - e / 2e-3).powi(2)),
                _ => -20e6,
            };
            sums = [sums[0] + stress * thin, sums[1] + stress * thin * y];
        }
        for l in &section.layers {
            let stress = (200e9 * (middle + curvature * l.depth)).clamp(-500e6, 500e6);
            sums = [sums[0] + stress * l.area, sums[1] + stress * l.area * l.depth];
        }
        let found = section.forces(middle, curvature);
        assert!((found[0] - sums[0]).abs() < 1.0 && (found[1] - sums[1]).abs() < 1.0, "{found:?} {sums:?}");
    }
}

#[test]
fn a_section_turned_over_bears_the_opposite_moment_and_a_symmetric_one_both() {
    let turned = |layers: &[Layer]| layers.iter().map(|l| Layer { depth: -l.depth, ..*l }).collect();
    let layers = vec![layer(1.57e-3, 0.24), layer(0.8e-3, -0.25)];
    let (one, other) = (Diagram::of(&section(layers.clone())), Diagram::of(&section(turned(&layers))));
    for k in 0..360 {
        let (sin, cos) = f64::from(k).to_radians().sin_cos();
        let (n, m) = (1e6 * cos, 1e5 * sin);
        let (a, b) = (one.utilisation([n, m]), other.utilisation([n, -m]));
        assert!((a / b - 1.0).abs() < 1e-9, "{k}: {a} {b}");
    }
    let same = Diagram::of(&section(vec![layer(1e-3, 0.25), layer(1e-3, -0.25)]));
    assert!((same.utilisation([-1e6, 3e5]) / same.utilisation([-1e6, -3e5]) - 1.0).abs() < 1e-9);
}

/// What yields without a limit would make a convex set. Limits of strain leave dents: a symmetric section whose steel has yielded at
/// ε_c2 turns back by less than 10⁻³ (N over 14 MN/m, M over 1.2 MN), an unlike one by more near pure compression, where codes turn
/// strains about a pivot. But each ray from N = M = 0 meets either border once.
#[test]
fn the_border_is_closed_and_convex_or_met_once_by_each_ray() {
    let symmetric = vec![layer(1.57e-3, 0.24), layer(1.57e-3, -0.24)];
    for (k, layers) in [symmetric, vec![layer(4e-3, 0.2), layer(1e-3, -0.25)]].into_iter().enumerate() {
        let layers: Vec<Layer> = layers.into_iter().map(|l| Layer { yields: 400e6, ..l }).collect();
        let diagram = Diagram::of(&section(layers));
        let points = diagram.points();
        let (first, last) = (points[0], points[points.len() - 1]);
        assert!((0..2).all(|i| (first[i] - last[i]).abs() < 1e-3), "{first:?} {last:?}");
        // Clockwise, seen with N to the right and M upwards, to round-off of forces of 14 MN/m and 1.2 MN.
        let round_off = 1e-12 * 14e6 * 1.2e6;
        for pair in points.windows(2) {
            let [[a, b], [c, d]] = [pair[0], pair[1]];
            assert!(a * d - b * c < round_off, "{pair:?}");
        }
        for triple in points.windows(3).filter(|_| k == 0) {
            let [a, b, c] = [triple[0], triple[1], triple[2]];
            let way = |from: [f64; 2], to: [f64; 2]| [(to[0] - from[0]) / 14e6, (to[1] - from[1]) / 1.2e6];
            let (p, q) = (way(a, b), way(b, c));
            let lengths = p[0].hypot(p[1]) * q[0].hypot(q[1]);
            assert!(lengths < 1e-20 || (p[0] * q[1] - p[1] * q[0]) / lengths < 1e-3, "{triple:?}");
        }
    }
}

#[test]
fn utilisation_grows_in_proportion_and_is_one_on_the_border() {
    let capacity = en_design().capacity(0.6, &[layer(1.57e-3, 0.24), layer(1.57e-3, -0.24)], 1.0);
    for [n, m] in capacity.border() {
        assert!((capacity.utilisation([n, m]) - 1.0).abs() < 1e-9);
        assert!((capacity.utilisation([0.3 * n, 0.3 * m]) - 0.3).abs() < 1e-9);
    }
    assert_eq!(capacity.utilisation([0.0, 0.0]), 0.0);
    assert!(capacity.utilisation([f64::NAN, 1.0]).is_nan());
    // A structural factor divides what is borne.
    let less = tremolite_sections::Rule { resistance_factor: 1.2, ..en_design() };
    let less = less.capacity(0.6, &[layer(1.57e-3, 0.24), layer(1.57e-3, -0.24)], 1.0);
    assert!((less.utilisation([-2e6, 4e5]) / capacity.utilisation([-2e6, 4e5]) - 1.2).abs() < 1e-12);
}

/// With more points chords would be nearer still: the states between them are off by less than 10⁻⁴.
#[test]
fn chords_are_near_the_states_between_them() {
    let section = section(vec![layer(1.57e-3, 0.24), layer(1.57e-3, -0.24)]);
    let diagram = Diagram::of(&section);
    for share in [0.013, 0.11, 0.333, 0.517, 0.811, 0.97] {
        let state = section.forces(-3.5e-3 + 3.5e-3 / share * 0.5, 3.5e-3 / (share * 0.6));
        let off = diagram.utilisation(state) - 1.0;
        assert!((-1e-9..1e-4).contains(&off), "{share}: {off}");
    }
}

/// So they are where steel that is pulled is at its limit of 1 %, whatever the face's strain, beside corners where the other steel yields.
#[test]
fn chords_are_near_the_states_at_the_steel_s_limit() {
    for (h, pulled, pressed) in [(0.6, 1.57e-3, 1.57e-3), (0.8, 3e-3, 1e-3), (0.8, 1e-3, 3e-3)] {
        let deep = 0.5 * h - 0.06;
        let layers = [layer(pulled, deep), layer(pressed, -deep)];
        let capacity = rule(Code::Gb, "C30").capacity(h, &layers, 1.0);
        let with_limit = layers.map(|l| Layer { breaks: 0.01, ..l }).to_vec();
        let section = Section { thickness: h, concrete: Concrete::gb(20.1e6), layers: with_limit };
        for k in 0..1000 {
            let face = -3.3e-3 + 13.3e-3 * (f64::from(k) + 0.37) / 1000.0;
            let slope = (0.01 - face) / (h - 0.06);
            let off = capacity.utilisation(section.forces(face + 0.5 * slope * h, slope)) - 1.0;
            assert!(off.abs() < 1e-4, "{h} {pulled} {face}: {off}");
        }
    }
}

/// GB 50010 stops at 1 % of strain in the steel: the section bears the same tension and compression, and nowhere more than without.
#[test]
fn a_limit_of_strain_in_the_steel_takes_from_the_border_alone() {
    let layers = [layer(1.57e-3, 0.24), layer(1.57e-3, -0.24)];
    let with = rule(Code::Gb, "C30").capacity(0.6, &layers, 1.0);
    let free = Section { thickness: 0.6, concrete: Concrete::gb(20.1e6), layers: layers.to_vec() };
    let free = Diagram::of(&free);
    let ratio = |k: i32| {
        let (sin, cos) = f64::from(k).to_radians().sin_cos();
        let state = [1e6 * cos, 1e5 * sin];
        with.utilisation(state) / free.utilisation(state)
    };
    let all: Vec<f64> = (0..360).map(ratio).collect();
    // Chords of either line are off by 10⁻⁴.
    assert!(all.iter().all(|r| *r > 1.0 - 2e-4), "{all:?}");
    assert!((all[0] - 1.0).abs() < 1e-9 && (all[180] - 1.0).abs() < 1e-9);
    assert!(all.iter().any(|r| *r > 1.01));
    assert!((with.utilisation([2.0 * 1.57e-3 * 500e6, 0.0]) - 1.0).abs() < 1e-9);
}
