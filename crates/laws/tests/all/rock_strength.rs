//! Rock laws against closed forms on triaxial, extension, plane-strain, oedometric and tension paths.

use crate::common::Random;
use crate::common::rock::*;
use tremolite_laws::Material;
use tremolite_laws::materials::{DruckerPrager, HoekBrown, MohrCoulomb};
use tremolite_laws::path::{Control, Path, Response, drive};

/// Lateral pressure along x, strain along z; along y the same pressure, or no strain where `plane`.
fn axial<M: Material>(law: &M, pressure: f64, plane: bool, end: f64, rows: usize) -> Response {
    let mut control = [
        Control::Stress,
        Control::Stress,
        Control::Strain,
        Control::Strain,
        Control::Strain,
        Control::Strain,
    ];
    let mut side = -pressure;
    if plane {
        control[1] = Control::Strain;
        side = 0.0;
    }
    let values = (0..=rows).map(|k| [-pressure, side, end * k as f64 / rows as f64, 0.0, 0.0, 0.0]).collect();
    drive(law, &Path { time: vec![0.0; rows + 1], values, control, size: None }).unwrap()
}

fn assert_close(found: f64, exact: f64, relative: f64) {
    assert!((found - exact).abs() <= relative * exact.abs(), "{found:e} {exact:e}");
}

const C: f64 = 2.18e6;
const PHI: f64 = 42.0;

fn fc() -> f64 {
    let phi = PHI.to_radians();
    2.0 * C * phi.cos() / (1.0 - phi.sin())
}

#[test]
fn mohr_coulomb_triaxial_compression_strength_and_dilation() {
    for psi in [0.0, 10.0, 42.0] {
        let law = MohrCoulomb::new(&mohr_coulomb(C, PHI, psi, 1e6)).unwrap();
        for pressure in [0.0, 1e6, 10e6, 40e6] {
            let path = axial(&law, pressure, false, -0.08, 40);
            assert_close(path.stress[40][2], -(slope(PHI.to_radians()) * pressure + fc()), 1e-9);
            // All change of strain is plastic now: volume grows by M − 1 for a shortening of 1.
            let volume = |row: usize| path.strain[row][..3].iter().sum::<f64>();
            let growth = (volume(40) - volume(30)) / (path.strain[40][2] - path.strain[30][2]);
            assert!((growth + slope(f64::to_radians(psi)) - 1.0).abs() < 1e-6, "{growth}");
        }
    }
}

#[test]
fn mohr_coulomb_triaxial_extension_strength() {
    let law = MohrCoulomb::new(&mohr_coulomb(C, PHI, 10.0, 1e6)).unwrap();
    for pressure in [15e6, 40e6] {
        let path = axial(&law, pressure, false, 0.05, 40);
        assert_close(path.stress[40][2], (fc() - pressure) / slope(PHI.to_radians()), 1e-9);
    }
    // Below f_c − k f_t of pressure the cut-off comes first.
    assert_close(axial(&law, 4e6, false, 0.02, 40).stress[40][2], 1e6, 1e-9);
}

#[test]
fn mohr_coulomb_plane_strain_strength_and_out_of_plane_stress() {
    for psi in [0.0, 10.0] {
        let law = MohrCoulomb::new(&mohr_coulomb(C, PHI, psi, 1e6)).unwrap();
        for pressure in [1e6, 5e6] {
            let [x, y, z, ..] = axial(&law, pressure, true, -0.03, 30).stress[30];
            assert_close(z, -(slope(PHI.to_radians()) * pressure + fc()), 1e-9);
            // A face does not flow along y: the stress there stays elastic.
            assert_close(y, POISSON * (x + z), 1e-9);
        }
    }
}

#[test]
fn mohr_coulomb_oedometer() {
    let (c, phi, psi) = (0.5e6, 25.0, 8.0);
    let law = MohrCoulomb::new(&mohr_coulomb(c, phi, psi, 0.0)).unwrap();
    let (k, m) = (slope(f64::to_radians(phi)), slope(f64::to_radians(psi)));
    let fc = 2.0 * c * k.sqrt();
    let k0 = POISSON / (1.0 - POISSON);
    let elastic = YOUNG * (1.0 - POISSON) / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON));
    let at_yield = -fc / (1.0 - k * k0);
    let plastic = k * YOUNG / (k - 2.0 * POISSON + 2.0 / m * (1.0 - POISSON - POISSON * k));
    for end in [-1e-4, -1e-3, -1e-2] {
        for steps in [1, 50] {
            let (stress, _) = follow(&law, &[[0.0, 0.0, end, 0.0, 0.0, 0.0]], steps);
            let exact = if elastic * end > at_yield {
                elastic * end
            } else {
                at_yield + plastic * (end - at_yield / elastic)
            };
            assert_close(stress[2], exact, 1e-10);
            assert_close(stress[0], if exact > at_yield { k0 * exact } else { (fc + exact) / k }, 1e-10);
        }
    }
}

#[test]
fn tension_stops_at_the_cut_off_in_one_two_and_three_directions() {
    let ft = 1e6;
    let law = MohrCoulomb::new(&mohr_coulomb(C, PHI, 10.0, ft)).unwrap();
    assert_close(axial(&law, 0.0, false, 1e-3, 20).stress[20][2], ft, 1e-9);
    let (stress, history) = follow(&law, &[[1e-3, 1e-3, 0.0, 0.0, 0.0, 0.0]], 7);
    assert_close(stress[0], ft, 1e-12);
    assert_close(stress[1], ft, 1e-12);
    assert_eq!(history[2], 10.0);
    let (stress, history) = follow(&law, &[[1e-3, 1e-3, 1e-3, 0.0, 0.0, 0.0]], 3);
    for s in &stress[..3] {
        assert_close(*s, ft, 1e-12);
    }
    // All that is beyond ε = f_t (1 − 2ν)/E opens.
    assert_close(history[1], 3.0 * (1e-3 - ft * (1.0 - 2.0 * POISSON) / YOUNG), 1e-10);
    assert_eq!(history[0], 0.0);
}

#[test]
fn the_apex_caps_the_cut_off() {
    let law = MohrCoulomb::new(&mohr_coulomb(C, PHI, 10.0, 1e9)).unwrap();
    let apex = C / PHI.to_radians().tan();
    assert!(law.warnings().iter().any(|w| w.contains("apex")));
    for strain in [[1e-2, 1e-2, 1e-2, 0.0, 0.0, 0.0], [2e-2, 1e-2, 3e-2, 1e-3, 0.0, -2e-3]] {
        let (stress, _) = follow(&law, &[strain], 1);
        for (k, s) in stress.iter().enumerate() {
            let exact = if k < 3 { apex } else { 0.0 };
            assert!((s - exact).abs() <= 1e-9 * apex, "{stress:?}");
        }
    }
}

#[test]
fn state_tells_shear_from_tension_and_now_from_past() {
    let law = MohrCoulomb::new(&mohr_coulomb(C, PHI, 0.0, 1e6)).unwrap();
    let pushed = [1e-3, 0.0, -4e-3, 0.0, 0.0, 0.0];
    let pulled = [5e-3, 5e-3, 2e-2, 0.0, 0.0, 0.0];
    let mut history = tremolite_laws::virgin::<MohrCoulomb>();
    let mut seen = Vec::new();
    // Twice the same strain: the second time nothing flows.
    for strain in [[0.0; 6], pushed, pushed, pulled, pulled] {
        history = law.update(&tremolite_laws::Point::new(0.0), strain, history).1;
        seen.push(history[2]);
    }
    assert_eq!(seen, [0.0, 1.0, 4.0, 6.0, 12.0]);
}

#[test]
fn plastic_shear_strain_is_half_the_engineering_strain_without_dilation() {
    let law = MohrCoulomb::new(&mohr_coulomb(1e6, 0.0, 0.0, 5e6)).unwrap();
    let gamma = 4e-3;
    let (stress, history) = follow(&law, &[[0.0, 0.0, 0.0, gamma, 0.0, 0.0]], 10);
    assert_close(stress[3], 1e6, 1e-10);
    let shear_modulus = YOUNG / (2.0 * (1.0 + POISSON));
    assert_close(history[0], 0.5 * (gamma - 1e6 / shear_modulus), 1e-10);
    assert_close(history[6], gamma - 1e6 / shear_modulus, 1e-10);
}

/// On every face, edge and corner, together or by turns. Were a multiplier negative, the sum could not hold.
#[test]
fn plastic_volume_is_what_shear_dilates_and_tension_opens() {
    let mut random = Random::new(17);
    let mut met = [0; 4];
    for psi in [0.0, 10.0, PHI] {
        let law = MohrCoulomb::new(&mohr_coulomb(C, PHI, psi, 1e6)).unwrap();
        let m = slope(f64::to_radians(psi));
        for _ in 0..1000 {
            let corners = [0; 4].map(|_| random_strain(&mut random, 2e-3));
            let (_, history) = follow(&law, &corners, 3);
            met[history[2] as usize % 4] += 1;
            let gamma = history[0] / ((m * m + m + 1.0) / 3.0).sqrt();
            let volume = history[3] + history[4] + history[5];
            assert!((volume - (m - 1.0) * gamma - history[1]).abs() < 1e-15, "{history:?}");
        }
    }
    assert!(met.iter().all(|count| *count > 50), "{met:?}");
}

/// Straight lines through a table's rows, the last of them beyond its end.
fn through(strains: &[f64], values: &[f64], at: f64) -> f64 {
    match strains.iter().rposition(|x| *x <= at) {
        Some(row) if row + 1 < strains.len() => {
            let share = (at - strains[row]) / (strains[row + 1] - strains[row]);
            values[row] + share * (values[row + 1] - values[row])
        }
        _ => values[values.len() - 1],
    }
}

/// Cohesion is lost while friction is found (brittle rock), then both fall; dilation fades.
#[test]
fn softening_follows_its_table_in_triaxial_compression() {
    let strains = [0.0, 0.005, 0.02, 0.03];
    let cohesion = [C, 0.8e6, 0.5e6, 0.4e6];
    let friction = [PHI, 48.0, 35.0, 30.0].map(f64::to_radians);
    let dilation = [10.0, 4.0, 2.0, 0.0].map(f64::to_radians);
    let columns = [
        ("plastic_shear_strain", &strains[..]),
        ("cohesion", &cohesion),
        ("friction_angle", &friction),
        ("dilation_angle", &dilation),
    ];
    let law = MohrCoulomb::new(&mohr_coulomb(C, PHI, 10.0, 1e6).with_table("softening", &columns)).unwrap();
    let pressure = 5e6;
    let path = axial(&law, pressure, false, -0.12, 2400);
    let strain = path.column("plastic_shear_strain").unwrap();
    let volume = ["plastic_exx", "plastic_eyy", "plastic_ezz"].map(|name| path.column(name).unwrap());
    let volume = |row: usize| volume[0][row] + volume[1][row] + volume[2][row];
    let strength = |at: f64| {
        let (c, phi) = (through(&strains, &cohesion, at), through(&strains, &friction, at));
        slope(phi) * pressure + 2.0 * c * slope(phi).sqrt()
    };
    assert_close(-path.stress[2400][2], strength(1.0), 1e-9);
    let mut met = [false; 3];
    for row in (1..2400).filter(|&row| strain[row - 1] > 0.0) {
        // A step goes by the strain before it.
        assert_close(-path.stress[row][2], strength(strain[row - 1]), 1e-8);
        let m = slope(through(&strains, &dilation, strain[row - 1]));
        let gamma = (strain[row] - strain[row - 1]) / ((m * m + m + 1.0) / 3.0).sqrt();
        // Plastic strains are a difference of a strain and an elastic one of up to 0.1.
        assert!((volume(row) - volume(row - 1) - (m - 1.0) * gamma).abs() < 1e-14, "{row}");
        met[strains[1..3].iter().filter(|x| **x < strain[row]).count()] = true;
    }
    assert_eq!(met, [true; 3]);
}

#[test]
fn tensile_strength_goes_by_the_strain_that_has_come_further() {
    let (shear, tension) = ([0.0, 0.01, 0.04], [0.0, 0.001, 0.002]);
    let tensile = [1e6, 0.4e6, 0.0];
    let columns = [("plastic_shear_strain", &shear[..]), ("tensile_strength", &tensile)];
    let peak = mohr_coulomb(C, PHI, 0.0, 1e6);
    let by_shear = MohrCoulomb::new(&peak.clone().with_table("softening", &columns)).unwrap();
    let both = [columns[0], columns[1], ("plastic_tension_strain", &tension[..])];
    let by_both = MohrCoulomb::new(&peak.with_table("softening", &both)).unwrap();
    for (sheared, opened) in [(0.0, 0.0), (0.02, 0.0), (0.0, 1.5e-3), (0.005, 1e-3), (0.03, 1e-4), (1.0, 1.0)]
    {
        let expected = through(&shear, &tensile, sheared);
        assert!((by_shear.strength(sheared, opened)[2] - expected).abs() < 1e-9);
        let expected = expected.min(through(&tension, &tensile, opened));
        assert!((by_both.strength(sheared, opened)[2] - expected).abs() < 1e-9);
    }
}

fn mass(gsi: f64, psi: f64) -> HoekBrown {
    let values = [
        ("compressive_strength", 80e6),
        ("gsi", gsi),
        ("m_i", 12.0),
        ("dilation_angle", f64::to_radians(psi)),
    ];
    HoekBrown::new(&rock(&values)).unwrap()
}

/// Hoek & Brown (1997), typical properties of very good and of average rock masses.
#[test]
fn hoek_brown_constants_of_published_rock_masses() {
    for (gsi, m_i, mb, s) in [(75.0, 25.0, 10.25, 0.062), (50.0, 12.0, 2.01, 0.004)] {
        let law =
            HoekBrown::new(&rock(&[("compressive_strength", 80e6), ("gsi", gsi), ("m_i", m_i)])).unwrap();
        assert!((law.constants()[0] - mb).abs() < 0.02 && (law.constants()[1] - s).abs() < 5e-4, "{law:?}");
    }
    let intact = mass(100.0, 0.0).constants();
    assert_eq!([intact[0], intact[1], intact[2]], [12.0, 1.0, 0.5]);
}

#[test]
fn hoek_brown_triaxial_compression_extension_and_plane_strain() {
    for (gsi, psi) in [(100.0, 0.0), (55.0, 0.0), (55.0, 8.0), (20.0, 5.0)] {
        let law = mass(gsi, psi);
        let [mb, s, a] = law.constants();
        let curve = |least: f64| least + 80e6 * (mb * least / 80e6 + s).powf(a);
        for pressure in [0.0, 1e6, 10e6, 50e6] {
            let path = axial(&law, pressure, false, -0.1, 50);
            assert_close(-path.stress[50][2], curve(pressure), 1e-8);
        }
        for pressure in [20e6, 60e6] {
            let least = -axial(&law, pressure, false, 0.1, 50).stress[50][2];
            if pressure > curve(0.0) {
                assert!(least > 0.0);
                assert_close(curve(least), pressure, 1e-8);
            } else {
                assert!(least <= 0.0);
            }
        }
        let [x, y, z, ..] = axial(&law, 2e6, true, -0.05, 50).stress[50];
        assert_close(-z, curve(2e6), 1e-8);
        if -POISSON * (x + z) > 2e6 {
            assert_close(y, POISSON * (x + z), 1e-8);
        }
    }
}

#[test]
fn hoek_brown_dilates_as_asked_until_the_envelope_is_flatter() {
    let growth = |law: &HoekBrown, pressure: f64, rows: usize| {
        let path = axial(law, pressure, false, -0.1, rows);
        let volume = |row: usize| path.strain[row][..3].iter().sum::<f64>();
        let last = rows - rows / 10;
        (volume(last) - volume(rows)) / (path.strain[rows][2] - path.strain[last][2])
    };
    let law = mass(55.0, 8.0);
    let asked = slope(8f64.to_radians()) - 1.0;
    for pressure in [0.0, 1e6, 10e6] {
        assert_close(growth(&law, pressure, 50), asked, 1e-6);
    }
    let law = mass(20.0, 30.0);
    let [mb, s, a] = law.constants();
    for pressure in [10e6, 50e6] {
        let flat = a * mb * (s + mb * pressure / 80e6).powf(a - 1.0);
        assert!(flat < 0.7 * (slope(30f64.to_radians()) - 1.0));
        // The limit goes by where a step would end with more dilation: of first order in the step, and below.
        let [coarse, fine] = [1000, 4000].map(|rows| 1.0 - growth(&law, pressure, rows) / flat);
        assert!((0.0..0.01).contains(&fine) && fine < 0.3 * coarse, "{coarse} {fine}");
    }
}

#[test]
fn hoek_brown_tension_ends_at_the_apex_or_the_cut_off() {
    let law = mass(60.0, 0.0);
    let [mb, s, _] = law.constants();
    let apex = s * 80e6 / mb;
    assert_close(law.tensile_strength(), apex, 1e-15);
    let (stress, _) = follow(&law, &[[3e-3, 2e-3, 1e-2, 1e-3, 0.0, 0.0]], 5);
    for x in &stress[..3] {
        assert_close(*x, apex, 1e-9);
    }
    let values =
        rock(&[("compressive_strength", 80e6), ("gsi", 60.0), ("m_i", 12.0), ("tensile_strength", 0.1e6)]);
    let cut = HoekBrown::new(&values).unwrap();
    assert_close(axial(&cut, 0.0, false, 1e-3, 20).stress[20][2], 0.1e6, 1e-9);
}

#[test]
fn drucker_prager_meets_mohr_coulomb_where_its_fit_says() {
    let pyramid = |psi| mohr_coulomb(C, PHI, psi, 1e6);
    let k = slope(PHI.to_radians());
    let pressure = 20e6;
    let law = |fit, psi| DruckerPrager::new(&with_word(pyramid(psi), "fit", fit)).unwrap();
    let compressed = axial(&law("outer", 5.0), pressure, false, -0.15, 50);
    assert_close(compressed.stress[50][2], -(k * pressure + fc()), 1e-9);
    let extended = axial(&law("inner", 5.0), pressure, false, 0.1, 50);
    assert_close(extended.stress[50][2], (fc() - pressure) / k, 1e-9);
    for psi in [0.0, 10.0, 42.0] {
        let path = axial(&law("plane-strain", psi), pressure, true, -0.4, 400);
        assert_close(path.stress[400][2], -(k * pressure + fc()), 1e-6);
        // Volume over shear in the plane, all of it plastic by then.
        let change: Vec<f64> = (0..3).map(|c| path.strain[400][c] - path.strain[390][c]).collect();
        assert!(
            ((change[0] + change[2]) / (change[0] - change[2]) - f64::to_radians(psi).sin()).abs() < 1e-5
        );
    }
    let direct = with_word(rock(&[("q_phi", 0.5), ("k_phi", 1e6)]), "fit", "direct");
    assert_eq!(DruckerPrager::new(&direct).unwrap().cone(), [0.5, 1e6, 0.0]);
}

/// In pure shear √J₂ of the plastic strain is half of what is beyond k_φ/μ, and to and fro it adds up.
#[test]
fn drucker_prager_accumulates_the_plastic_shear_of_its_cone() {
    let direct = with_word(rock(&[("q_phi", 0.5), ("k_phi", 1e6)]), "fit", "direct");
    let law = DruckerPrager::new(&direct).unwrap();
    let (elastic, shear) = (1e6 / law.moduli().mu, 3e-3);
    let there = [0.0, 0.0, 0.0, shear, 0.0, 0.0];
    let (_, first) = follow(&law, &[there], 7);
    assert_close(first[0], 0.5 * (shear - elastic), 1e-12);
    let (stress, both) = follow(&law, &[there, there.map(|x| -x)], 7);
    assert_close(both[0], 0.5 * (shear - elastic) + (shear - elastic), 1e-12);
    assert_close(stress[3], -1e6, 1e-12);
}
