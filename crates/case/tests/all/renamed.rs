//! Keys and words of before are refused with their new names; a permeability is read in three units.

use std::path::Path;
use tremolite_case::{Case, MaterialWater, Report};
use tremolite_laws::materials::MATERIALS;

const EVERY_KEY: &str = include_str!("../cases/every-key.toml");

fn refused(source: &str) -> Report {
    match Case::parse(Path::new("case.toml"), source, MATERIALS) {
        Ok(_) => panic!("must be refused:\n{source}"),
        Err(report) => report,
    }
}

#[test]
fn keys_of_before_are_refused_with_their_new_names() {
    for (new, old, remedy) in [
        ("size_near =", "near =", "write `size_near`"),
        ("size_along =", "along =", "write `size_along`"),
        ("processing =", "process =", "write `processing`"),
        ("dynamic_factor ", "dynamic ", "write `dynamic_factor`"),
        ("[[monitor_pair]]", "[[relative]]", "write `monitor_pair`"),
        ("friction_coefficient =", "friction =", "write `friction_coefficient`"),
        ("\"reduced-integration\"", "\"one-point\"", "write \"reduced-integration\""),
    ] {
        let source = EVERY_KEY.replacen(new, old, 1);
        assert!(source != EVERY_KEY, "{new}");
        let report = refused(&source);
        let [problem] = &report.problems[..] else { panic!("{report}") };
        assert!(problem.remedy.contains(remedy), "{remedy}\n{report}");
    }
    let moved = EVERY_KEY
        .replace("model_x_azimuth = \"30 deg\"\n", "")
        .replace("[motion]\n", "[motion]\nmodel_x_azimuth = \"30 deg\"\n");
    let report = refused(&moved);
    assert!(report.to_string().contains("write `model_x_azimuth` above all tables"), "{report}");
}

/// With x at 30 deg: a layer that fell 90 deg from x towards y, and a plane that fell 90 deg clockwise from y.
#[test]
fn a_dip_direction_of_before_is_refused_with_the_azimuth_that_it_is() {
    for (new, old, azimuth) in [
        ("dip_azimuth = \"300 deg\"", "dip_direction = \"90 deg\"", "300 deg"),
        ("dip_azimuth = \"30 deg\"", "dip_direction = \"90 deg\"", "30 deg"),
    ] {
        let (head, tail) = EVERY_KEY.split_at(match azimuth {
            "300 deg" => EVERY_KEY.find("dip_azimuth = \"300 deg\"\n").unwrap(),
            _ => EVERY_KEY.find("[[mesh.plane]]").unwrap(),
        });
        let source = format!("{head}{}", tail.replacen(new, old, 1));
        let report = refused(&source).to_string();
        assert!(report.contains(&format!("write dip_azimuth = \"{azimuth}\"")), "{report}");
    }
}

#[test]
fn a_permeability_is_read_in_m2_and_in_m2_over_pa_s() {
    let with = |water: &str| {
        EVERY_KEY.replace(
            "[material.rock]\n",
            &format!("[water]\nlevel = \"3 m\"\n[material.rock]\nwater = {{ {water} }}\n"),
        )
    };
    let conductivity = |water: &str| {
        let case =
            Case::parse(Path::new("case.toml"), &with(water), MATERIALS).unwrap_or_else(|e| panic!("{e}"));
        let pores = case.materials.iter().find_map(|material| match &material.water {
            Some(MaterialWater::Pores(pores)) => Some(pores),
            _ => None,
        });
        let pores = pores.expect("pores");
        pores.hydraulic_conductivity.as_ref().expect("a conductivity").value
    };
    assert_eq!(conductivity("hydraulic_conductivity = \"1e-7 m/s\""), 1e-7);
    for text in ["1e-14 m2", "1e-11 m2/(Pa s)", "1e-11 m2/Pa/s"] {
        let found = conductivity(&format!("permeability = \"{text}\""));
        assert!((found / 9.81e-8 - 1.0).abs() < 1e-12, "{text}: {found}");
    }
    for (water, says) in [
        ("permeability = \"1e-7 m/s\"", "write hydraulic_conductivity = \"1e-7 m/s\""),
        ("permeability = \"1e-7 GPa\"", "is not a permeability"),
        ("permeability = \"-1e-14 m2\"", "must be above 0"),
        ("permeability = \"1e-14 m2\", hydraulic_conductivity = \"1e-7 m/s\"", "only"),
    ] {
        let report = refused(&with(water)).to_string();
        assert!(report.contains(says), "{water}\n{report}");
    }
}
