//! Mohr–Coulomb and Hoek–Brown beside an implicit integrator that knows no order, faces or corners.

use crate::common::Random;
use crate::common::rock::*;
use tremolite_laws::materials::{HoekBrown, MohrCoulomb};
use tremolite_laws::{History, Material, Point};

fn linear(c: f64, phi: f64, psi: f64, ft: f64) -> (MohrCoulomb, Reference) {
    let law = MohrCoulomb::new(&mohr_coulomb(c, phi, psi, ft)).unwrap();
    let surface = Surface::mohr_coulomb(c, phi);
    (law, Reference { surface, flow: slope(psi.to_radians()), ft: ft.min(surface.apex()) })
}

fn curved([sci, gsi, m_i, psi]: [f64; 4], ft: Option<f64>) -> (HoekBrown, Reference) {
    let psi = psi.to_radians();
    let mut values =
        rock(&[("compressive_strength", sci), ("gsi", gsi), ("m_i", m_i), ("dilation_angle", psi)]);
    if let Some(ft) = ft {
        values = values.with("tensile_strength", ft);
    }
    let law = HoekBrown::new(&values).unwrap();
    let [mb, s, a] = law.constants();
    let surface = Surface::Curved { sci, mb, s, a };
    (law, Reference { surface, flow: slope(psi), ft: ft.unwrap_or(f64::MAX).min(surface.apex()) })
}

/// One large step along the axes from rest, to every region: same stress as the reference.
fn assert_steps_agree<M: Material>(law: &M, reference: &Reference, seed: u64, count: usize) {
    let mut random = Random::new(seed);
    let mut compared = 0;
    for _ in 0..count {
        let size = 10f64.powf(5.5 + 2.5 * random.unit());
        let shift = 2.0 * size * (random.unit() - 0.6);
        let mut trial = [0; 3].map(|_| shift + size * random.symmetric());
        if random.unit() < 0.15 {
            trial[1] = trial[0];
        }
        let Some(exact) = reference.step(trial) else { continue };
        // Where the envelope is flatter than the dilation the law reduces that; the reference does not.
        let flattest = |s: &[f64; 3]| reference.surface.slope(s.iter().fold(f64::MIN, |m, x| m.max(*x)));
        if flattest(&trial).min(flattest(&exact)) < reference.flow {
            continue;
        }
        compared += 1;
        let zero = <M::History<f64> as History<f64>>::zero();
        let (found, _) = law.update(&Point::new(0.0), elastic_strain(trial), zero);
        let scale = largest(&trial).max(1e5);
        for i in 0..3 {
            assert!(
                (found[i] - exact[i]).abs() <= 1e-9 * scale,
                "{trial:?}: {found:?} {exact:?} {reference:?}"
            );
        }
    }
    assert!(2 * compared >= count, "{compared}");
}

#[test]
fn one_step_of_mohr_coulomb_from_anywhere() {
    for (seed, (c, phi, psi, ft)) in [
        (2.18e6, 42.0, 10.0, 3e6),
        (2.18e6, 42.0, 0.0, 0.5e6),
        (1e6, 35.0, 35.0, 0.0),
        (1e6, 30.0, 0.0, 1e9),
        (5e6, 0.0, 0.0, 2e6),
        (0.2e6, 20.0, 15.0, 1e9),
    ]
    .into_iter()
    .enumerate()
    {
        let (law, reference) = linear(c, phi, psi, ft);
        assert_steps_agree(&law, &reference, seed as u64, 150);
    }
}

#[test]
fn one_step_of_hoek_brown_from_anywhere() {
    let masses = [
        ([60e6, 60.0, 12.0, 0.0], None),
        ([60e6, 60.0, 12.0, 0.0], Some(0.05e6)),
        ([150e6, 100.0, 25.0, 0.0], Some(2e6)),
        ([20e6, 15.0, 8.0, 0.0], Some(0.0)),
        ([60e6, 60.0, 12.0, 12.0], Some(0.1e6)),
        ([150e6, 100.0, 25.0, 30.0], None),
    ];
    for (seed, (constants, ft)) in masses.into_iter().enumerate() {
        let (law, reference) = curved(constants, ft);
        assert_steps_agree(&law, &reference, 40 + seed as u64, 100);
    }
}

/// Paths with turning axes: in step with the sub-stepped reference, and a tenth of its steps close to it.
fn assert_paths_agree<M: Material>(law: &M, reference: &Reference, seed: u64) {
    let mut random = Random::new(seed);
    for _ in 0..6 {
        let corners = [0; 3].map(|_| random_strain(&mut random, 1.5e-3));
        let exact = reference.follow(&corners, 100);
        let (fine, _) = follow(law, &corners, 100);
        let (coarse, _) = follow(law, &corners, 10);
        let size = corners.iter().fold(0.0f64, |m, e| m.max(largest(&elastic_stress(e))));
        let off = |s: &[f64; 6]| (0..6).map(|c| (s[c] - exact[c]).abs()).fold(0.0, f64::max) / size;
        assert!(off(&fine) <= 1e-9, "{corners:?}: {fine:?} {exact:?}");
        assert!(off(&coarse) <= 0.05, "{corners:?}: {coarse:?} {exact:?}");
    }
}

#[test]
fn paths_with_turning_axes_follow_the_sub_stepped_reference() {
    let (law, reference) = linear(2.18e6, 42.0, 10.0, 1e6);
    assert_paths_agree(&law, &reference, 7);
    let (law, reference) = linear(1e6, 30.0, 0.0, 0.0);
    assert_paths_agree(&law, &reference, 8);
    let (law, reference) = curved([60e6, 60.0, 12.0, 0.0], Some(0.2e6));
    assert_paths_agree(&law, &reference, 9);
}
