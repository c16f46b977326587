//! How wide cracks are that have opened along one edge of an element after another.

use crate::common::Random;
use crate::common::concrete::*;
use tremolite_laws::materials::Concrete;
use tremolite_laws::parameter::position;
use tremolite_laws::sym3::eigen;
use tremolite_laws::{Material, Point, Role, virgin};

/// Edges \[m\] along the ring, along the cavern and through the thickness of a lining.
const EDGES: [f64; 3] = [2.0, 1.0, 0.5];

fn width(history: &<Concrete as Material>::History<f64>) -> f64 {
    history[position(Concrete::HISTORY, Role::CrackWidth).unwrap()]
}

fn cracking(words: &[(&str, &str)]) -> Concrete {
    let values = values().with("fracture_energy", 130.0);
    Concrete::new(&with_words(values, words)).unwrap()
}

/// What the corners of the element move apart along each edge \[m\] beyond what C⁻¹:σ explains, at the end of straight ways
/// from one such set of stretches \[m\] to the next, and the width that the law gives, in axes turned by `r`.
fn pulled(law: &Concrete, ways: &[[f64; 3]], r: &[[f64; 3]; 3]) -> ([f64; 3], f64) {
    let squares = EDGES.map(|edge| edge * edge);
    let size = turn(&[squares[0], squares[1], squares[2], 0.0, 0.0, 0.0], r);
    let point = Point { size, ..Point::new(0.0) };
    let mut history = virgin::<Concrete>();
    let (mut from, mut beyond) = ([0.0; 3], [0.0; 3]);
    for to in ways {
        for step in 1..=200 {
            let share = f64::from(step) / 200.0;
            let strain: [f64; 3] = std::array::from_fn(|k| (from[k] + share * (to[k] - from[k])) / EDGES[k]);
            let [x, y, z] = strain;
            let (stress, new) = law.update(&point, turn_strain(&[x, y, z, 0.0, 0.0, 0.0], r), history);
            history = new;
            let back: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|k| r[k][i]));
            let s = turn(&stress, &back);
            let trace = s[0] + s[1] + s[2];
            beyond = std::array::from_fn(|k| {
                EDGES[k] * (strain[k] - ((1.0 + POISSON) * s[k] - POISSON * trace) / YOUNG)
            });
        }
        from = *to;
    }
    (beyond, width(&history))
}

/// A piece of a lining, 2 m long and 0.5 m thick, is pulled apart along its ring and then through its thickness, and the other way
/// round: the crack is as wide as the faces went apart, less what the stress explains.
#[test]
fn a_crack_is_as_wide_as_its_faces_went_apart_whichever_edge_cracked_first() {
    let mut random = Random::new(5);
    for evolution in ["exponential", "residual"] {
        for split in ["compliance", "effective"] {
            let law = cracking(&[("evolution", evolution), ("split", split)]);
            for (first, then) in [(0, 2), (2, 0), (0, 0), (2, 2)] {
                let r = random.rotation();
                let (mut one, mut two) = ([0.0; 3], [0.0; 3]);
                one[first] = 1e-3;
                two[first] = 1e-3;
                two[then] = 12e-3;
                let (beyond, found) = pulled(&law, &[one, two], &r);
                assert!((found - beyond[then]).abs() < 1e-9 * found, "{first} {then}: {found} {beyond:?}");
                // What is left of f_t explains less than f_t/E of the way.
                let elastic = THRESHOLD * EDGES[then];
                assert!((found - 12e-3).abs() < elastic, "{evolution}, {split}, {first} {then}: {found}");
            }
        }
    }
}

/// The wider of two open cracks is told, also where the strain across the other is larger.
#[test]
fn of_two_cracks_the_wider_counts_and_not_the_one_with_more_strain() {
    let law = cracking(&[("evolution", "exponential"), ("split", "compliance")]);
    let r = Random::new(6).rotation();
    for order in [[[4e-3, 0.0, 0.0], [4e-3, 0.0, 3e-3]], [[0.0, 0.0, 3e-3], [4e-3, 0.0, 3e-3]]] {
        let (beyond, found) = pulled(&law, &order, &r);
        assert!(beyond[2] / EDGES[2] > 2.0 * beyond[0] / EDGES[0], "more strain through the thickness");
        assert!((found - beyond[0]).abs() < 1e-9 * found && beyond[0] > 3.9e-3, "{found} {beyond:?}");
    }
    // Equal strains have no directions of their own: whatever axes are taken, the longer edge opens most.
    for turned in 0..100 {
        let r = if turned == 0 { r } else { Random::new(turned).rotation() };
        let (beyond, found) = pulled(&law, &[[4e-3, 0.0, 1e-3 * (1.0 + 1e-12 * turned as f64)]], &r);
        assert!((found - beyond[0]).abs() < 1e-7 * found, "{turned}: {found} {beyond:?}");
    }
}

/// A crack that closes has no width, and the strain across pressed concrete is none of a crack.
#[test]
fn what_the_stress_explains_is_no_crack() {
    let law = cracking(&[("evolution", "exponential"), ("split", "compliance")]);
    let r = Random::new(7).rotation();
    let (_, open) = pulled(&law, &[[1e-3, 0.0, 0.0]], &r);
    let (_, closed) = pulled(&law, &[[1e-3, 0.0, 0.0], [-1e-4, 0.0, 0.0]], &r);
    assert!(open > 0.9e-3 && closed == 0.0, "{open} {closed}");
    // Free to widen under 0.8 f_c, which the law counts as damage in tension.
    let strain = -0.8 * fc() / YOUNG;
    let across = -POISSON * strain;
    let size = EDGES.map(|edge| edge * edge);
    let point = Point { size: [size[0], size[1], size[2], 0.0, 0.0, 0.0], ..Point::new(0.0) };
    let (_, history) = law.update(&point, [strain, across, across, 0.0, 0.0, 0.0], virgin::<Concrete>());
    assert!(history[0] > 0.1, "damaged: {}", history[0]);
    assert_eq!([history[1], width(&history)], [0.0; 2]);
}

/// Openings \[m\], falling, and the normals of the cracks.
fn openings(history: &<Concrete as Material>::History<f64>) -> ([f64; 3], [[f64; 3]; 3]) {
    let first = position(Concrete::HISTORY, Role::CrackOpenings).unwrap();
    let squares: [f64; 6] = std::array::from_fn(|k| history[first + k]);
    let found = eigen(&squares);
    (found.values.map(|w| w.max(0.0).sqrt()), found.vectors)
}

/// A crack lies across the way in which its faces went apart, whichever edge that is of a brick turned at will; of two each has its own
/// width and normal, the widest is that of the width.
#[test]
fn normals_of_cracks_are_the_ways_in_which_their_faces_went_apart() {
    let law = cracking(&[("evolution", "exponential"), ("split", "compliance")]);
    let mut random = Random::new(8);
    for _ in 0..20 {
        let r = random.rotation();
        let squares = EDGES.map(|edge| edge * edge);
        let size = turn(&[squares[0], squares[1], squares[2], 0.0, 0.0, 0.0], &r);
        let point = Point { size, ..Point::new(0.0) };
        let edge = |k: usize| -> [f64; 3] { std::array::from_fn(|i| r[i][k]) };
        let along = |n: &[f64; 3], k: usize| (0..3).map(|i| n[i] * edge(k)[i]).sum::<f64>().abs();
        for k in 0..3 {
            let mut strain = [0.0; 6];
            strain[k] = 1e-3 / EDGES[k];
            let (_, history) = law.update(&point, turn_strain(&strain, &r), virgin::<Concrete>());
            let (found, normals) = openings(&history);
            let wide = width(&history);
            assert!((found[0] - wide).abs() < 1e-12 * wide && wide > 0.5e-3, "{k}: {found:?} {wide}");
            // Across it no more opens than what is left of f_t makes of its lateral strain.
            assert!(found[1] < THRESHOLD * EDGES[0], "one crack: {found:?}");
            assert!(along(&normals[0], k) > 1.0 - 1e-12, "{k}: {normals:?}");
        }
        // Through the thickness the wider one, along the axis another.
        let strain = [0.0, 1e-3 / EDGES[1], 3e-3 / EDGES[2], 0.0, 0.0, 0.0];
        let (_, history) = law.update(&point, turn_strain(&strain, &r), virgin::<Concrete>());
        let (found, normals) = openings(&history);
        assert!((found[0] - width(&history)).abs() < 1e-12 * found[0]);
        assert!(along(&normals[0], 2) > 1.0 - 1e-9 && along(&normals[1], 1) > 1.0 - 1e-9, "{normals:?}");
        assert!((found[0] - 3e-3).abs() < THRESHOLD * EDGES[2], "{found:?}");
        assert!(
            (found[1] - 1e-3).abs() < THRESHOLD * EDGES[1] && found[2] < THRESHOLD * EDGES[0],
            "{found:?}"
        );
    }
}

/// Where nobody looks the width stays what it was, and all openings; all else is as if somebody did.
#[test]
fn the_width_alone_waits_until_somebody_looks() {
    let mut random = Random::new(11);
    let law = cracking(&[("evolution", "exponential")]);
    let column = position(Concrete::HISTORY, Role::CrackWidth).unwrap();
    let [x, y, z] = EDGES.map(|edge| edge * edge);
    let seen = Point { size: [x, y, z, 0.0, 0.0, 0.0], ..Point::new(0.0) };
    let unseen = Point { looked_at: false, ..seen };
    let (mut with, mut without) = (virgin::<Concrete>(), virgin::<Concrete>());
    let mut moved = 0;
    for step in 0..200 {
        let strain = std::array::from_fn(|_| 1e-3 * random.symmetric());
        let last: Vec<f64> = without[column..].to_vec();
        let (stress, new) = law.update(&seen, strain, with);
        let (same, now) = law.update(&unseen, strain, without);
        assert_eq!(now[column..], last);
        (with, without) = (new, now);
        moved += usize::from(with[column] != without[column]);
        without[column..].copy_from_slice(&with[column..]);
        assert_eq!((stress, with), (same, without), "step {step}");
    }
    assert!(moved > 100, "{moved} widths of 200 changed");
}
