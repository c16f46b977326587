use crate::cavern::{Cavern, CavernError, CavernSpec};

#[test]
fn impossible_input_is_refused_with_the_key_and_the_remedy() {
    type Change = fn(&mut CavernSpec);
    let cases: [(&str, Change); 24] = [
        ("overburden is -1", |s| s.overburden = -1.0),
        ("near is 0", |s| s.near = 0.0),
        ("near is NaN", |s| s.near = f64::NAN),
        ("far is inf", |s| s.far = f64::INFINITY),
        ("far is 1", |s| s.far = 1.0),
        ("along is -2", |s| s.along = Some(-2.0)),
        ("0 caverns", |s| s.caverns.clear()),
        ("powerhouse.arch_rise is 9", |s| s.caverns[0].arch_rise = 9.0),
        ("powerhouse.height is 4.6", |s| s.caverns[0].height = 4.6),
        ("transformer.width is NaN", |s| s.caverns[1].width = f64::NAN),
        ("transformer.at is NaN", |s| s.caverns[1].at[1] = f64::NAN),
        ("powerhouse.benches is 0", |s| s.caverns[0].benches = 0),
        ("powerhouse.benches is 4294967295", |s| s.caverns[0].benches = u32::MAX),
        ("powerhouse.lining.walls is 20", |s| s.caverns[0].lining.walls = 20.0),
        ("powerhouse.lining.crown is 0", |s| s.caverns[0].lining.crown = 0.0),
        ("powerhouse.shotcrete is -0.1", |s| s.caverns[0].shotcrete.thickness = -0.1),
        ("powerhouse.shotcrete_layers is 0", |s| s.caverns[0].shotcrete.thickness = 0.1),
        ("powerhouse.lining.layers is 0", |s| s.caverns[0].lining.layers = 0),
        ("the name is used twice", |s| s.caverns[1].name = "powerhouse".to_owned()),
        ("a name is a word", |s| s.caverns[1].name = "a.b".to_owned()),
        ("move them apart by", |s| s.caverns[1].at[0] = 12.0),
        ("raise `sides`", |s| s.sides = 2.0),
        ("raise `overburden`", |s| s.caverns[1].at[1] = 220.0),
        ("near is 0.0001; it must be at least 0.13 m", |s| s.near = 1e-4),
    ];
    for (expected, change) in cases {
        let mut spec = CavernSpec::yingxiuwan();
        change(&mut spec);
        let message = spec.mesh().expect_err(expected).to_string();
        assert!(message.contains(expected), "{expected:?} not in {message:?}");
    }
}

#[test]
fn absurd_counts_are_refused_before_anything_is_built() {
    for change in [
        |s: &mut CavernSpec| s.along = Some(1e-6),
        |s: &mut CavernSpec| (s.near, s.far) = (1e-9, 1e-9),
        |s: &mut CavernSpec| (s.near, s.far) = (0.02, 0.02),
    ] {
        let mut spec = CavernSpec::yingxiuwan();
        change(&mut spec);
        let error = spec.mesh().unwrap_err();
        let size = matches!(&error, CavernError::Value { key, .. } if key == "size_near");
        assert!(
            size || matches!(error, CavernError::TooMany { .. } | CavernError::Grading { .. }),
            "{error}"
        );
    }
}

/// A hall of 12 × 18 m in elements of 4 cm was smoothed for 100 s before it was refused, and then for its shape.
#[test]
fn near_in_the_wrong_unit_is_refused_before_the_section_is_smoothed() {
    let hall = Cavern {
        name: "hall".to_owned(),
        width: 12.0,
        height: 18.0,
        arch_rise: 3.0,
        benches: 1,
        ..Cavern::default()
    };
    let spec = |near: f64| CavernSpec {
        overburden: 60.0,
        below: 40.0,
        sides: 60.0,
        length: 4.0,
        near,
        far: 6.0,
        along: Some(2.0),
        caverns: vec![hall.clone()],
        ..CavernSpec::default()
    };
    let message = spec(0.04).mesh().unwrap_err().to_string();
    assert_eq!(
        message,
        "size_near is 0.04; it must be at least 0.08 m, since the section of cavern \"hall\" would have some 135000 elements and at \
         most 40000 are taken; look at its unit"
    );
    assert!(spec(4.0).mesh().is_ok());
}
