//! Softening over displacement: one energy per area in elements of any extent, and the limit of that extent.

use crate::common::Random;
use crate::common::rock::*;
use tremolite_laws::materials::{HoekBrown, MohrCoulomb};
use tremolite_laws::path::{Control, Path, PathError, Response, drive};
use tremolite_laws::{Material, Point, Values, virgin};

const C: f64 = 2e6;
const PHI: f64 = 35.0;
const SLIP: f64 = 10e-3;

/// Mohr–Coulomb that loses four fifths of its cohesion over [`SLIP`].
fn softening(psi: f64) -> MohrCoulomb {
    let columns: [(&str, &[f64]); 2] =
        [("plastic_shear_displacement", &[0.0, SLIP]), ("cohesion", &[C, 0.2 * C])];
    MohrCoulomb::new(&mohr_coulomb(C, PHI, psi, 0.0).with_table("softening", &columns)).unwrap()
}

fn uniaxial(cohesion: f64) -> f64 {
    2.0 * cohesion * slope(PHI.to_radians()).sqrt()
}

/// √((M² + M + 1)/3): plastic shear strain of a unit shortening.
fn root(psi: f64) -> f64 {
    let m = slope(psi.to_radians());
    ((m * m + m + 1.0) / 3.0).sqrt()
}

/// Shortened along z to a strain in so many rows, its sides free, in an element of this extent.
fn shortened(law: &impl Material, extent: f64, end: f64, rows: usize) -> Response {
    let control = [
        Control::Stress,
        Control::Stress,
        Control::Strain,
        Control::Strain,
        Control::Strain,
        Control::Strain,
    ];
    let values = (0..=rows).map(|k| [0.0, 0.0, end * k as f64 / rows as f64, 0.0, 0.0, 0.0]).collect();
    drive(law, &Path { time: vec![0.0; rows + 1], values, control, size: Some(extent) }).unwrap()
}

#[test]
fn a_band_dissipates_one_energy_per_area_in_elements_of_any_extent() {
    for psi in [0.0, 12.0] {
        let law = softening(psi);
        // Shortening of the element at which the slip is done, with some left for the residual strength.
        let done = SLIP / (2.0 * root(psi));
        for extent in [0.1, 0.4, 1.6] {
            let end = -1.3 * done / extent - uniaxial(C) / YOUNG;
            let path = shortened(&law, extent, end, 8000);
            let last = |name: &str| *path.column(name).unwrap().last().unwrap();
            let shortening = last("plastic_shear_displacement") / (2.0 * root(psi));
            assert!(shortening > done, "{extent} m: {shortening} {done}");
            let exact =
                0.5 * (uniaxial(C) + uniaxial(0.2 * C)) * done + uniaxial(0.2 * C) * (shortening - done);
            let found = extent * last("energy_dissipated");
            // Strength lags behind by a step: of first order in it, with 6000 steps over the softening a quarter of their number.
            assert!((found / exact - 1.0).abs() < 1e-3, "{psi} deg, {extent} m: {found} {exact}");
        }
    }
}

#[test]
fn an_element_of_half_the_limit_softens_as_steeply_as_it_is_stiff() {
    for psi in [0.0, 12.0] {
        let law = softening(psi);
        let lost = uniaxial(C) - uniaxial(0.2 * C);
        let limit = YOUNG * SLIP / (2.0 * root(psi) * lost);
        assert!((law.size_limit() / limit - 1.0).abs() < 1e-12, "{} {limit}", law.size_limit());
        let rows = 4000;
        let path = shortened(&law, 0.5 * limit, -1.6 * uniaxial(C) / YOUNG, rows);
        let at = |share: f64| {
            let k = (share * rows as f64) as usize;
            [path.strain[k][2], path.stress[k][2]]
        };
        let ([e0, s0], [e1, s1]) = (at(0.75), at(0.95));
        assert!(((s1 - s0) / (e1 - e0) / -YOUNG - 1.0).abs() < 1e-3, "{}", (s1 - s0) / (e1 - e0));
        // Larger ones are refused on a path, and none may be left out.
        let refused = |size| {
            let mut path = Path::strains(vec![0.0], vec![[0.0; 6]]);
            path.size = size;
            drive(&law, &path).unwrap_err()
        };
        assert!(matches!(refused(Some(1.01 * limit)), PathError::Size { .. }));
        assert!(matches!(refused(None), PathError::SizeMissing));
        // Damping over a band leaves less of E.
        assert!((law.scaled(0.7).size_limit() / limit - 0.7).abs() < 1e-12);
    }
}

#[test]
fn friction_that_falls_counts_by_the_peaks_uniaxial_strength() {
    let phi = [PHI.to_radians(), 25f64.to_radians()];
    let columns: [(&str, &[f64]); 2] =
        [("plastic_shear_displacement", &[0.0, SLIP]), ("friction_angle", &phi)];
    let law = MohrCoulomb::new(&mohr_coulomb(C, PHI, 0.0, 0.0).with_table("softening", &columns)).unwrap();
    let [k0, k1] = phi.map(slope);
    let (peak, confined) = (2.0 * C * k0.sqrt(), 2.0 * C * k0.sqrt());
    let lost = peak + k0 * confined - 2.0 * C * k1.sqrt() - k1 * confined;
    assert!((law.size_limit() / (YOUNG * SLIP / (2.0 * lost)) - 1.0).abs() < 1e-12);
}

#[test]
fn tension_that_falls_with_the_opening_limits_the_element_as_well() {
    let table: [(&str, &[f64]); 3] = [
        ("plastic_shear_displacement", &[0.0, SLIP]),
        ("plastic_tension_displacement", &[0.0, 50e-6]),
        ("tensile_strength", &[1e6, 0.0]),
    ];
    let law = MohrCoulomb::new(&mohr_coulomb(C, PHI, 0.0, 1e6).with_table("softening", &table)).unwrap();
    assert!((law.size_limit() / (YOUNG * 50e-6 / 1e6) - 1.0).abs() < 1e-12, "{}", law.size_limit());
    // Pulled apart: half of f_t is left at half the opening, whatever the extent.
    for extent in [0.05, 0.2] {
        let path = shortened(&law, extent, 25e-6 / extent + 0.5e6 / YOUNG, 4000);
        assert!((path.stress[4000][2] / 0.5e6 - 1.0).abs() < 2e-3, "{}", path.stress[4000][2]);
        let opening = path.column("plastic_tension_displacement").unwrap()[4000];
        assert!((opening / 25e-6 - 1.0).abs() < 2e-3, "{opening}");
    }
}

/// A point of a brick with these edges \[m\] whose displacement has this gradient.
fn point(edges: [f64; 3], gradient: [[f64; 3]; 3]) -> Point<f64> {
    let [x, y, z] = edges.map(|edge| edge * edge);
    Point { size: [x, y, z, 0.0, 0.0, 0.0], gradient, ..Point::new(0.0) }
}

#[test]
fn the_extent_is_that_across_the_band_and_not_along_its_slip() {
    let edges = [2.0, 1.0, 0.5];
    for along in 0..3 {
        for across in (0..3).filter(|&k| k != along) {
            let mut gradient = [[0.0; 3]; 3];
            gradient[along][across] = -3e-3;
            let found = point(edges, gradient).extent_across_band();
            assert!((found - edges[across]).abs() < 1e-15, "{along}{across}: {found}");
        }
        let mut gradient = [[0.0; 3]; 3];
        gradient[along][along] = 1e-5;
        assert!((point(edges, gradient).extent_across_band() - edges[along]).abs() < 1e-15);
    }
    // Any band in a cube has its edge, and what has not moved the mean square.
    let mut random = Random::new(5);
    for _ in 0..100 {
        let gradient = [0; 3].map(|_| [0; 3].map(|_| random.symmetric()));
        assert!((point([0.3; 3], gradient).extent_across_band() - 0.3).abs() < 1e-15);
    }
    let mean = (edges.map(|edge| edge * edge).iter().sum::<f64>() / 3.0).sqrt();
    assert!((point(edges, [[0.0; 3]; 3]).extent_across_band() - mean).abs() < 1e-15);
}

#[test]
fn a_sheared_layer_slips_by_its_height_times_the_plastic_strain_back_and_forth() {
    let law = softening(0.0);
    let edges = [2.0, 2.0, 0.5];
    let mut history = virgin::<MohrCoulomb>();
    let slipped = law.columns().iter().position(|c| c.name == "plastic_shear_displacement").unwrap();
    for gamma in [2e-3, 4e-3, 3e-3, 1e-5, -2e-3, -4e-3, 1e-3] {
        let mut gradient = [[0.0; 3]; 3];
        gradient[0][2] = gamma;
        let at = point(edges, gradient);
        history = law.update(&at, [0.0, 0.0, 0.0, 0.0, 0.0, gamma], history).1;
        assert!((history[slipped] - 2.0 * 0.5 * history[0]).abs() < 1e-15, "{gamma}: {history:?}");
    }
    assert!(history[slipped] > 2e-3);
}

fn hoek_brown() -> Values {
    rock(&[("compressive_strength", 80e6), ("gsi", 70.0), ("m_i", 15.0)])
}

fn residual(values: Values, rest: &[(&str, &[f64])]) -> Values {
    values.with_table("residual", rest)
}

#[test]
fn hoek_brown_ends_as_the_rock_mass_of_its_residual_state() {
    let end = HoekBrown::new(&rock(&[
        ("compressive_strength", 80e6),
        ("gsi", 30.0),
        ("m_i", 15.0),
        ("disturbance", 0.5),
    ]))
    .unwrap();
    let law = HoekBrown::new(&residual(
        hoek_brown(),
        &[("gsi", &[30.0]), ("disturbance", &[0.5]), ("plastic_shear_displacement", &[SLIP])],
    ))
    .unwrap();
    let peak = HoekBrown::new(&hoek_brown()).unwrap();
    let ([m0, s0, a0], [m1, s1, a1]) = (peak.constants(), end.constants());
    for (slip, share) in [(0.0, 0.0), (0.25 * SLIP, 0.25), (SLIP, 1.0), (3.0 * SLIP, 1.0)] {
        let [m, s, a, ft] = law.strength(slip);
        for (found, from, to) in [(m, m0, m1), (s, s0, s1), (a, a0, a1)] {
            assert!((found / (from + share * (to - from)) - 1.0).abs() < 1e-12, "{slip}: {found}");
        }
        assert!((ft / (s * 80e6 / m) - 1.0).abs() < 1e-12, "{ft}");
    }
    // The stress falls along with it: uniaxial strength of the peak, then of the residual state.
    for extent in [0.1, 0.3] {
        let path = shortened(&law, extent, -SLIP / extent, 4000);
        let strength = |law: &HoekBrown| 80e6 * law.constants()[1].powf(law.constants()[2]);
        let highest = path.stress.iter().map(|s| -s[2]).fold(0.0, f64::max);
        assert!((highest / strength(&peak) - 1.0).abs() < 1e-3, "{highest}");
        let last = -path.stress[4000][2];
        assert!((last / strength(&end) - 1.0).abs() < 1e-9, "{last} {}", strength(&end));
    }
    assert!(law.size_limit() > 0.3 && law.size_limit() < 3.0, "{}", law.size_limit());
    assert_eq!(peak.size_limit(), f64::INFINITY);
}

#[test]
fn residual_states_that_cannot_be_reached_are_refused_by_key() {
    let faults = |rest: &[(&str, &[f64])]| match HoekBrown::new(&residual(hoek_brown(), rest)) {
        Ok(_) => Vec::new(),
        Err(faults) => faults.iter().map(|fault| fault.name).collect(),
    };
    let slip: (&str, &[f64]) = ("plastic_shear_displacement", &[SLIP]);
    assert!(faults(&[("gsi", &[30.0]), slip]).is_empty());
    assert_eq!(faults(&[slip]), ["residual"]);
    assert_eq!(faults(&[("gsi", &[71.0]), slip]), ["residual.gsi"]);
    assert_eq!(faults(&[("gsi", &[4.0]), slip]), ["residual.gsi"]);
    assert_eq!(faults(&[("gsi", &[30.0]), ("disturbance", &[1.1]), slip]), ["residual.disturbance"]);
    assert_eq!(faults(&[("gsi", &[30.0])]), ["residual"]);
    assert_eq!(
        faults(&[("gsi", &[30.0]), ("plastic_shear_displacement", &[0.0])]),
        ["residual.plastic_shear_displacement"]
    );
    assert_eq!(faults(&[("gsi", &[30.0]), slip, ("plastic_shear_strain", &[0.01])]), ["residual"]);
}

#[test]
fn softening_over_strain_is_warned_of_and_over_displacement_is_not() {
    let of = |measure: &'static str, cohesion: &[f64]| {
        let columns: [(&str, &[f64]); 2] = [(measure, &[0.0, 0.01]), ("cohesion", cohesion)];
        MohrCoulomb::new(&mohr_coulomb(C, PHI, 0.0, 0.0).with_table("softening", &columns))
            .unwrap()
            .warnings()
    };
    let warned = of("plastic_shear_strain", &[C, 0.1 * C]);
    assert!(warned.len() == 1 && warned[0].contains("plastic_shear_displacement"), "{warned:?}");
    assert!(of("plastic_shear_displacement", &[C, 0.1 * C]).is_empty());
    // What hardens does not localise.
    assert!(of("plastic_shear_strain", &[C, 1.1 * C]).is_empty());
    let by_strain =
        HoekBrown::new(&residual(hoek_brown(), &[("gsi", &[30.0]), ("plastic_shear_strain", &[0.01])]))
            .unwrap();
    assert_eq!(by_strain.warnings().len(), 1);
    assert_eq!(by_strain.size_limit(), f64::INFINITY);
}

#[test]
fn histories_keep_displacements_where_strength_depends_on_them_alone() {
    let short = MohrCoulomb::new(&mohr_coulomb(C, PHI, 0.0, 0.0)).unwrap();
    assert_eq!((short.columns().len(), short.facts().columns, short.facts().needs_size), (10, 10, false));
    let long = softening(0.0);
    assert_eq!((long.columns().len(), long.facts().columns, long.facts().needs_size), (12, 12, true));
}
