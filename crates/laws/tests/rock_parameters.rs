//! What the rock laws refuse, warn of and fill in.

mod common;

use common::rock::*;
use tremolite_laws::materials::{DruckerPrager, HoekBrown, MATERIALS, MohrCoulomb};
use tremolite_laws::{Material, Need, Values};

fn faults<M: Material>(values: &Values) -> Vec<&'static str> {
    match M::new(values) {
        Ok(_) => Vec::new(),
        Err(faults) => faults.iter().map(|fault| fault.name).collect(),
    }
}

#[test]
fn the_three_laws_are_registered_under_their_names() {
    for name in ["mohr-coulomb", "drucker-prager", "hoek-brown"] {
        let law = MATERIALS.iter().find(|law| law.name == name).unwrap();
        let columns: Vec<_> = law.history.iter().take(3).map(|column| column.name).collect();
        assert_eq!(columns, ["plastic_shear_strain", "plastic_tension_strain", "state"]);
        let default = law.parameters.iter().find(|p| p.name == "dilation_angle").map(|p| p.need);
        assert_eq!(default, Some(Need::Number(0.0)));
    }
}

#[test]
fn every_fault_is_named_at_once() {
    let bad = rock(&[
        ("poisson", 0.5),
        ("cohesion", -1.0),
        ("friction_angle", 42.0),
        ("tensile_strength", f64::NAN),
    ]);
    assert_eq!(faults::<MohrCoulomb>(&bad), ["poisson", "cohesion", "friction_angle", "tensile_strength"]);
    let none = Values::default();
    assert_eq!(faults::<MohrCoulomb>(&none), ["young", "poisson", "cohesion", "friction_angle"]);
    assert_eq!(faults::<HoekBrown>(&none), ["young", "poisson", "ucs", "gsi", "m_i"]);
    assert_eq!(faults::<DruckerPrager>(&none), ["young", "poisson", "cohesion", "friction_angle"]);
}

#[test]
fn dilation_beyond_friction_and_rock_without_strength_are_refused() {
    assert_eq!(faults::<MohrCoulomb>(&mohr_coulomb(1e6, 30.0, 31.0, 0.0)), ["dilation_angle"]);
    assert_eq!(faults::<MohrCoulomb>(&mohr_coulomb(0.0, 0.0, 0.0, 0.0)), ["cohesion"]);
    assert!(faults::<MohrCoulomb>(&mohr_coulomb(0.0, 30.0, 0.0, 0.0)).is_empty());
    assert!(faults::<MohrCoulomb>(&mohr_coulomb(1e6, 0.0, 0.0, 0.0)).is_empty());
}

#[test]
fn softening_needs_its_strain_and_falls_only() {
    let peak = mohr_coulomb(1e6, 30.0, 0.0, 1e5);
    let with = |pairs: &[(&str, f64)]| pairs.iter().fold(peak.clone(), |v, (key, x)| v.with(key, *x));
    assert_eq!(faults::<MohrCoulomb>(&with(&[("residual_cohesion", 5e5)])), ["softening_strain"]);
    assert_eq!(faults::<MohrCoulomb>(&with(&[("softening_strain", 0.01)])), ["softening_strain"]);
    assert_eq!(
        faults::<MohrCoulomb>(&with(&[("softening_tension_strain", 0.01)])),
        ["softening_tension_strain"]
    );
    let rising = with(&[("residual_cohesion", 2e6), ("softening_strain", 0.01)]);
    assert_eq!(faults::<MohrCoulomb>(&rising), ["residual_cohesion"]);
    let gone =
        with(&[("residual_cohesion", 0.0), ("residual_friction_angle", 0.0), ("softening_strain", 0.01)]);
    assert_eq!(faults::<MohrCoulomb>(&gone), ["residual_cohesion"]);
    assert!(
        faults::<MohrCoulomb>(&with(&[("residual_cohesion", 0.0), ("softening_strain", 0.01)])).is_empty()
    );
}

#[test]
fn drucker_prager_keeps_fit_and_direct_constants_apart() {
    let fitted = mohr_coulomb(1e6, 30.0, 0.0, 0.0);
    assert_eq!(faults::<DruckerPrager>(&fitted.clone().with("q_phi", 0.5)), ["q_phi"]);
    assert_eq!(faults::<DruckerPrager>(&with_word(fitted.clone(), "fit", "middle")), ["fit"]);
    let both = with_word(fitted.with("q_phi", 0.5).with("k_phi", 1e6), "fit", "direct");
    assert_eq!(faults::<DruckerPrager>(&both), ["cohesion", "friction_angle"]);
    let direct = rock(&[("q_phi", 0.5), ("k_phi", 1e6), ("q_psi", 0.6)]);
    assert_eq!(faults::<DruckerPrager>(&with_word(direct, "fit", "direct")), ["q_psi"]);
}

#[test]
fn hoek_brown_ranges() {
    let good = [("ucs", 50e6), ("gsi", 50.0), ("m_i", 10.0)];
    for (key, bad) in [
        ("ucs", 0.0),
        ("gsi", 101.0),
        ("gsi", -1.0),
        ("m_i", 0.0),
        ("disturbance", 1.1),
        ("tensile_strength", -1.0),
    ] {
        assert_eq!(faults::<HoekBrown>(&rock(&good).with(key, bad)), [key]);
    }
    assert!(HoekBrown::new(&rock(&good)).unwrap().warnings().is_empty());
    let beyond = HoekBrown::new(&rock(&good).with("tensile_strength", 5e6)).unwrap();
    assert_eq!(beyond.warnings().len(), 1);
}
