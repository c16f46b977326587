//! What laws say of the constants they derive is what they compute with.

use crate::common::concrete::{concrete, fc, slope, uniaxial, values, with_words};
use tremolite_laws::materials::{Concrete, DruckerPrager, HoekBrown, MohrCoulomb};
use tremolite_laws::{Material, Values};

fn range(law: &impl Material, extents: [f64; 2], name: &str) -> [f64; 2] {
    law.derived(extents).iter().find(|d| d.name == name).unwrap_or_else(|| panic!("{name}")).range
}

fn near(found: [f64; 2], exact: [f64; 2]) {
    for (found, exact) in found.into_iter().zip(exact) {
        assert!((found / exact - 1.0).abs() < 1e-9, "{found:e} for {exact:e}");
    }
}

#[test]
fn concrete_lists_strengths_slope_rates_and_the_softening_of_its_elements() {
    let law = concrete(&[("rate", "ceb")]);
    let extents = [0.2, 0.8];
    near(range(&law, extents, "compressive_strength"), [fc(); 2]);
    near(range(&law, extents, "slope"), [slope(); 2]);
    near(range(&law, extents, "threshold_strain"), [1.2e6 / 25e9; 2]);
    near(range(&law, extents, "ultimate_strain"), [10.0 * 1.2e6 / 25e9; 2]);
    near(range(&law, extents, "fracture_energy"), extents.map(|h| law.crack_energy(h).unwrap()));
    near(range(&law, extents, "reference_rate"), [3e-6, 3e-5]);
    near(range(&law, extents, "rate_exponent_tension"), [0.020; 2]);
    near(range(&law, extents, "rate_exponent_shear"), [1.026 / (5.0 + 0.75 * fc() / 1e6); 2]);
    let law = concrete(&[("rate", "mc90")]);
    near(range(&law, extents, "reference_rate"), [3e-6, 3e-5]);
}

#[test]
fn the_ultimate_strain_listed_is_where_an_element_of_that_extent_breaks() {
    let law = Concrete::new(&values().with("fracture_energy", 130.0)).unwrap();
    let extents = [0.3, 0.9];
    let [least, most] = range(&law, extents, "ultimate_strain");
    for (strain, extent) in [(most, 0.3), (least, 0.9)] {
        let damage = |strain: f64| {
            let path = uniaxial(&law, &[0.0, strain], Some(extent));
            path.history[0][1]
        };
        assert!(damage(0.999 * strain) < 1.0 && damage(1.001 * strain) == 1.0, "{extent} m");
    }
    assert_eq!(range(&law, extents, "size_limit"), [law.size_limit(); 2]);
    let words = with_words(values().with("fracture_energy", 130.0), &[("evolution", "exponential")]);
    let law = Concrete::new(&words).unwrap();
    near(
        range(&law, extents, "softening_strain"),
        [0.9, 0.3].map(|h| 130.0 / (1.2e6 * h) - 0.5 * 1.2e6 / 25e9),
    );
}

#[test]
fn rock_lists_apex_uniaxial_strength_and_the_constants_of_its_envelope() {
    let elastic = || Values::default().with("young", 10e9).with("poisson", 0.25);
    let none = [0.0; 2];
    // Hoek, Carranza-Torres & Corkum 2002 for GSI 40, m_i 10, D 0.
    let law =
        HoekBrown::new(&elastic().with("compressive_strength", 60e6).with("gsi", 40.0).with("m_i", 10.0))
            .unwrap();
    let [mb, s, a] = [10.0 * (-60.0f64 / 28.0).exp(), (-60.0f64 / 9.0).exp(), 0.511_368_5];
    near(range(&law, none, "m_b"), [mb; 2]);
    near(range(&law, none, "s"), [s; 2]);
    assert!((range(&law, none, "a")[0] - a).abs() < 1e-6);
    near(range(&law, none, "apex"), [s * 60e6 / mb; 2]);
    near(range(&law, none, "tensile_strength"), [s * 60e6 / mb; 2]);

    let phi = 42f64.to_radians();
    let envelope = || elastic().with("cohesion", 2e6).with("friction_angle", phi);
    let law = MohrCoulomb::new(&envelope().with("tensile_strength", 3e6)).unwrap();
    near(range(&law, none, "apex"), [2e6 / phi.tan(); 2]);
    near(range(&law, none, "tensile_strength"), [2e6 / phi.tan(); 2]);
    near(range(&law, none, "compressive_strength"), [4e6 * phi.cos() / (1.0 - phi.sin()); 2]);
    let law = DruckerPrager::new(&envelope()).unwrap();
    let [q, k, _] = law.cone();
    near(range(&law, none, "apex"), [k / q; 2]);
}
