//! What the concrete law takes, derives and refuses.

use crate::common::concrete::*;
use tremolite_laws::materials::Concrete;
use tremolite_laws::materials::concrete::Grade;
use tremolite_laws::path::{Path, drive};
use tremolite_laws::{Material, Need, Values};

fn refused(values: &Values) -> Vec<&'static str> {
    Concrete::new(values).unwrap_err().iter().map(|fault| fault.name).collect()
}

fn without(name: &str) -> Values {
    let mut values = values();
    values.0.remove(name);
    values
}

#[test]
fn compressive_strength_is_derived_from_cohesion_or_given() {
    let [ft, derived] = concrete(&[]).strengths();
    assert!(ft == FT && (derived / 1e6 - 9.901).abs() < 1e-3 && (derived - fc()).abs() < 1e-9 * fc());
    let given = Concrete::new(&without("cohesion").with("compressive_strength", 25e6)).unwrap();
    assert_eq!(given.strengths()[1], 25e6);
}

#[test]
fn a_grade_stands_in_for_what_is_not_given() {
    let mut values = with_words(Values::default(), &[("grade", "C30/37")]).with("friction_angle", 0.7);
    let grade = Grade::named("C30/37").unwrap();
    let law = Concrete::new(&values).unwrap();
    assert_eq!(law.strengths(), [grade.tensile_strength, grade.compressive_strength]);
    assert!((law.moduli().young() / grade.young - 1.0).abs() < 1e-14);
    assert_eq!(law.fracture_energy(0.3), grade.fracture_energy);
    assert!(law.rate().is_some(), "ceb is the default");

    values = values.with("young", 20e9).with("cohesion", 3e6).with("ultimate_strain_ratio", 8.0);
    assert_eq!(refused(&values), ["ultimate_strain_ratio"], "the default has none");
    values = with_words(values, &[("evolution", "residual")]);
    let law = Concrete::new(&values).unwrap();
    assert!((law.moduli().young() / 20e9 - 1.0).abs() < 1e-14);
    assert!((law.strengths()[1] - 2.0 * 3e6 * 0.7f64.cos() / (1.0 - 0.7f64.sin())).abs() < 1.0);
    assert_eq!(law.size_limit(), f64::INFINITY);
}

#[test]
fn wrong_or_missing_values_are_named_and_all_at_once() {
    for name in ["young", "poisson", "tensile_strength", "friction_angle"] {
        assert_eq!(refused(&without(name)), [name]);
        for bad in [f64::NAN, f64::INFINITY, -1.0] {
            assert_eq!(refused(&values().with(name, bad)), [name], "{bad}");
        }
    }
    assert_eq!(refused(&without("cohesion")), ["compressive_strength"]);
    for (name, bad) in [
        ("residual_tension", 0.0),
        ("residual_tension", 1.1),
        ("residual_shear", -0.1),
        ("rate_filter_time", -1.0),
        ("reference_rate", 0.0),
        ("fracture_energy", 0.0),
        ("ultimate_strain_ratio", 1.0),
        ("friction_angle", 1.58),
    ] {
        assert_eq!(refused(&values().with(name, bad)), [name], "{bad}");
    }
    for name in ["rate", "driver", "split", "shear_tension", "evolution", "grade"] {
        assert_eq!(refused(&with_words(values(), &[(name, "nonsense")])), [name]);
    }
    assert_eq!(
        refused(&values().with("ultimate_strain_ratio", 10.0).with("fracture_energy", 130.0)),
        ["ultimate_strain_ratio"]
    );
    let ratio = values().with("ultimate_strain_ratio", 10.0);
    assert_eq!(
        refused(&with_words(ratio, &[("evolution", "exponential")])),
        ["ultimate_strain_ratio"],
        "a crack band goes by G_f alone"
    );
    let mut all =
        refused(&values().with("young", -1.0).with("tensile_strength", 0.0).with("residual_shear", 2.0));
    all.sort_unstable();
    assert_eq!(all, ["residual_shear", "tensile_strength", "young"]);
}

/// What a case gets that says neither how concrete softens nor what a crack takes: Model Code 2010's G_F = 73 f_cm^0.18 (5.1-9).
#[test]
fn a_crack_band_without_an_energy_takes_that_of_model_code_by_fc_and_lists_it() {
    let mut plain = values();
    plain.0.remove("evolution");
    plain.0.remove("split");
    let law = Concrete::new(&plain).unwrap();
    let code = 73.0 * (fc() / 1e6).powf(0.18);
    // f_c is 9.90 MPa, which gives 110 N/m.
    assert!((code - 110.3).abs() < 0.1, "{code}");
    for h in [0.1, 1.0] {
        assert!((law.fracture_energy(h) / code - 1.0).abs() < 1e-14);
    }
    assert!((law.size_limit() / (2.0 * code * YOUNG / (FT * FT)) - 1.0).abs() < 1e-14);
    let listed =
        |law: &Concrete| law.derived([0.2, 0.8]).into_iter().find(|d| d.name == "fracture_energy").unwrap();
    assert!((listed(&law).range[0] / code - 1.0).abs() < 1e-14 && listed(&law).doc.contains("none is given"));
    // Given, it is used; with the plateau ε_us = 10 ε_ts stands in, as it did.
    let given = Concrete::new(&plain.clone().with("fracture_energy", 130.0)).unwrap();
    assert!(given.fracture_energy(0.5) == 130.0 && !listed(&given).doc.contains("none is given"));
    let plateau = Concrete::new(&with_words(plain, &[("evolution", "residual")])).unwrap();
    assert_eq!(plateau.size_limit(), f64::INFINITY);
}

/// The L-shaped panel of `winkler2001`, measured peak 7,219 N, as it was computed with this law (2×2×2 points, static rates).
#[test]
fn the_strength_left_at_a_corner_is_not_above_that_of_the_l_panel() {
    let panel = |evolution: &str| {
        let values = Values::default()
            .with("young", 25.85e9)
            .with("poisson", 0.18)
            .with("tensile_strength", 2.7e6)
            .with("compressive_strength", 31e6)
            .with("friction_angle", 37f64.to_radians())
            .with("fracture_energy", 65.0);
        Concrete::new(&with_words(values, &[("evolution", evolution), ("rate", "none")])).unwrap()
    };
    let residual = panel("residual");
    // Peaks of the verification problem `l_panel`.
    for (size, peak) in [(25e-3, 4307.0), (10e-3, 2974.0), (5e-3, 2213.0)] {
        let (found, left) = (residual.corner_strength(size).unwrap(), peak / 7219.0);
        // The estimate is that of a crack's end, where stress grows with r^-0.5; at the panel's corner it grows with r^-0.46, so more is
        // left, by a quarter at most.
        assert!(found < left && found > 0.75 * left, "{size} {found} {left}");
    }
    // From 2 l_ch/π on nothing is lost, and the crack band has no such loss.
    let length = 25.85e9 * 65.0 / (2.7e6 * 2.7e6);
    assert_eq!(residual.corner_strength(0.64 * length), Some(1.0));
    assert!(residual.corner_strength(0.63 * length).unwrap() < 1.0);
    assert_eq!(panel("exponential").corner_strength(5e-3), None);
    // A plateau at f_t is plastic, and right at any size; ε_us alone is measured by Model Code's energy.
    let whole =
        Concrete::new(&values().with("fracture_energy", 130.0).with("residual_tension", 1.0)).unwrap();
    assert_eq!(whole.corner_strength(1e-3), Some(1.0));
    let code = 73.0 * (fc() / 1e6).powf(0.18);
    assert_eq!(
        concrete(&[]).corner_strength(0.2),
        Concrete::new(&values().with("fracture_energy", code)).unwrap().corner_strength(0.2)
    );
}

/// Tension below f_t with a trace of pressure across it, and the same beyond a crack.
#[test]
fn tension_that_counts_as_shear_failure_is_warned_of_and_happens_as_said() {
    assert!(concrete(&[]).warnings().is_empty());
    let damage = |law: &Concrete, tension: f64| {
        let strain = elastic_strain([tension, -1e3, -1e3]);
        let path = Path::strains(vec![0.0; 2], vec![[0.0; 6], strain]);
        let response = drive(law, &path).unwrap();
        [response.column("d_tension").unwrap()[1], response.column("d_shear").unwrap()[1]]
    };
    let limit = fc() / slope();
    for (words, on_crack) in [
        (vec![("shear_tension", "nominal")], 0.0),
        (vec![("shear_tension", "effective")], 1.0),
        (vec![("split", "compliance")], 0.0),
    ] {
        let values = with_words(values().with("tensile_strength", 2e6), &words);
        let odd = Concrete::new(&values).unwrap();
        let warnings = odd.warnings();
        assert_eq!(warnings.len(), 1);
        assert!(warnings[0].contains("1.616 MPa"), "{limit} {}", warnings[0]);
        assert_eq!(warnings[0].contains("and so does any such pressure"), on_crack == 1.0);
        assert_eq!(damage(&odd, 0.99 * limit)[1], 0.0);
        let [tension, shear] = damage(&odd, 1.01 * limit);
        assert_eq!(tension, 0.0);
        assert!(shear >= 1.0 - BETA, "{words:?} {shear}");
        let [tension, shear] = damage(&odd, 2.5e6);
        assert!(tension > 0.5);
        assert_eq!(shear > 0.0, on_crack > 0.0, "{words:?}");
    }
}

#[test]
fn keys_without_an_effect_are_warned_of_by_name() {
    let warned = |values: &Values| -> Vec<String> {
        let warnings = Concrete::new(values).unwrap().warnings();
        warnings.iter().filter_map(|w| Some(w.split_once(" has no effect")?.0.to_owned())).collect()
    };
    let exponential = with_words(values().with("fracture_energy", 130.0), &[("evolution", "exponential")]);
    assert!(warned(&exponential).is_empty(), "α at its default");
    assert_eq!(warned(&exponential.with("residual_tension", 0.2)), ["residual_tension"]);
    assert_eq!(warned(&values().with("reference_rate", 0.3)), ["reference_rate"]);
    assert!(warned(&values().with("reference_rate", 3e-5)).is_empty(), "the Model Code's");
    assert_eq!(warned(&values().with("rate_filter_time", 1e-2)), ["rate_filter_time"]);
    assert!(warned(&values().with("rate_filter_time", 5e-3)).is_empty());
    let compliance = with_words(values(), &[("split", "compliance")]);
    assert!(warned(&with_words(compliance.clone(), &[("shear_tension", "nominal")])).is_empty());
    assert_eq!(warned(&with_words(compliance, &[("shear_tension", "effective")])), ["shear_tension"]);
    let both = values().with("compressive_strength", 25e6);
    assert_eq!(warned(&both), ["cohesion"]);
    assert_eq!(Concrete::new(&both).unwrap().strengths()[1], 25e6);
}

#[test]
fn a_cohesion_beside_a_grade_and_a_modulus_of_the_wrong_size_are_warned_of() {
    let grade =
        with_words(Values::default(), &[("grade", "C30/37")]).with("friction_angle", 46f64.to_radians());
    assert!(Concrete::new(&grade).unwrap().warnings().is_empty());
    // So little beside the grade's tensile strength that the other warning comes too.
    let both = Concrete::new(&grade.with("cohesion", 2e6)).unwrap().warnings();
    assert!(both.len() == 2 && both[0].contains("9.90 MPa") && both[0].contains("38.00 MPa"), "{both:?}");
    let soft = Concrete::new(&values().with("young", 25e6)).unwrap().warnings();
    assert!(soft.len() == 1 && soft[0].contains("young"), "{soft:?}");
}

/// The declared defaults are the ones in force: filling them in changes nothing.
#[test]
fn declared_defaults_are_those_used() {
    let mut plain = values();
    plain.0.remove("rate");
    plain.0.remove("residual_tension");
    plain.0.remove("residual_shear");
    plain.0.remove("evolution");
    plain.0.remove("split");
    let mut filled = plain.clone();
    for parameter in Concrete::PARAMETERS {
        match parameter.need {
            Need::Number(x) => filled = filled.with(parameter.name, x),
            Need::Word(word) => filled = with_words(filled, &[(parameter.name, word)]),
            Need::Required | Need::Optional(_) | Need::Chosen(_) => {}
        }
    }
    let [plain, filled] = [plain, filled].map(|v| format!("{:?}", Concrete::new(&v).unwrap()));
    assert_eq!(plain, filled);
}
