//! What the rock laws refuse, warn of and fill in.

use crate::common::rock::*;
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
    assert_eq!(faults::<HoekBrown>(&none), ["young", "poisson", "compressive_strength", "gsi", "m_i"]);
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
fn softening_tables_that_cannot_be_followed_are_refused_by_column() {
    let peak = mohr_coulomb(1e6, 30.0, 5.0, 1e5);
    let phi = 30f64.to_radians();
    let strain = ("plastic_shear_strain", &[0.0, 0.01][..]);
    let faults =
        |columns: &[(&str, &[f64])]| faults::<MohrCoulomb>(&peak.clone().with_table("softening", columns));
    assert!(faults(&[strain, ("cohesion", &[1e6, 0.0])]).is_empty());
    assert!(faults(&[strain, ("cohesion", &[1e6, 2e5]), ("friction_angle", &[phi, 0.7])]).is_empty());
    assert_eq!(faults(&[]), ["softening"]);
    assert_eq!(faults(&[strain]), ["softening"]);
    assert_eq!(faults(&[("cohesion", &[1e6, 5e5])]), ["softening"]);
    assert_eq!(faults(&[strain, ("cohesion", &[1e6, 5e5, 1e5])]), ["softening"]);
    assert_eq!(faults(&[strain, ("cohesion", &[1e6, f64::NAN])]), ["softening"]);
    let short: (&str, &[f64]) = ("plastic_shear_strain", &[0.0]);
    assert_eq!(faults(&[short, ("cohesion", &[1e6])]), ["softening.plastic_shear_strain"]);
    for strains in [[0.001, 0.01], [0.0, 0.0], [0.0, -1.0]] {
        let columns = [("plastic_shear_strain", &strains[..]), ("cohesion", &[1e6, 5e5])];
        assert_eq!(faults(&columns), ["softening.plastic_shear_strain"]);
        let columns = [strain, ("plastic_tension_strain", &strains[..]), ("tensile_strength", &[1e5, 0.0])];
        assert_eq!(faults(&columns), ["softening.plastic_tension_strain"]);
    }
    let slip = ("plastic_shear_displacement", &[0.0, 0.01][..]);
    let cohesion = ("cohesion", &[1e6, 5e5][..]);
    assert!(faults(&[slip, cohesion]).is_empty());
    assert_eq!(faults(&[slip, strain, cohesion]), ["softening"]);
    assert_eq!(faults(&[slip, ("plastic_tension_strain", &[0.0, 0.01]), cohesion]), ["softening"]);
    assert_eq!(faults(&[("plastic_tension_displacement", &[0.0, 0.01]), cohesion]), ["softening"]);
    assert_eq!(
        faults(&[("plastic_shear_displacement", &[0.0, -0.01]), cohesion]),
        ["softening.plastic_shear_displacement"]
    );
    assert_eq!(faults(&[strain, ("cohesion", &[9e5, 5e5])]), ["softening.cohesion"]);
    assert_eq!(faults(&[strain, ("cohesion", &[1e6, -1.0])]), ["softening.cohesion"]);
    assert_eq!(faults(&[strain, ("friction_angle", &[phi, 1.58])]), ["softening.friction_angle"]);
    assert_eq!(faults(&[strain, ("tensile_strength", &[1e5, -1e3])]), ["softening.tensile_strength"]);
    assert_eq!(faults(&[strain, ("friction_angle", &[phi, 0.01])]), ["softening.dilation_angle"]);
    assert_eq!(faults(&[strain, ("cohesion", &[1e6, 0.0]), ("friction_angle", &[phi, 0.0])]), ["softening"]);
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
    let good = [("compressive_strength", 50e6), ("gsi", 50.0), ("m_i", 10.0)];
    for (key, bad) in [
        ("compressive_strength", 0.0),
        ("gsi", 101.0),
        ("gsi", 4.9),
        ("gsi", 0.55),
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
