use super::*;

#[track_caller]
fn reads(text: &str, dimension: Dimension, value: f64) {
    assert_eq!(parse(text, dimension), Ok(value), "{text}");
}

#[test]
fn the_units_of_the_field_read_as_their_si_values() {
    reads("25 GPa", Dimension::PRESSURE, 25e9);
    reads("1.20 MPa", Dimension::PRESSURE, 1.2e6);
    reads("27 kN/m3", Dimension::UNIT_WEIGHT, 27e3);
    reads("27 kN/m^3", Dimension::UNIT_WEIGHT, 27e3);
    reads("27 kN/m³", Dimension::UNIT_WEIGHT, 27e3);
    reads("27 kN*m-3", Dimension::UNIT_WEIGHT, 27e3);
    reads("27 kN·m⁻³", Dimension::UNIT_WEIGHT, 27e3);
    reads("20 GPa/m", Dimension::STIFFNESS, 20e9);
    reads("2.7 t/m3", Dimension::DENSITY, 2700.0);
    reads("2.7 g/cm3", Dimension::DENSITY, 2700.0);
    reads("2700kg/m3", Dimension::DENSITY, 2700.0);
    reads("130 N/m", Dimension::FRACTURE_ENERGY, 130.0);
    reads("0.13 kJ/m2", Dimension::FRACTURE_ENERGY, 130.0);
    reads("0.3 1/s", Dimension::RATE, 0.3);
    reads("1e-3 1/s", Dimension::RATE, 1e-3);
    reads("20 Hz", Dimension::RATE, 20.0);
    reads("10 min", Dimension::TIME, 600.0);
    reads("5 ms", Dimension::TIME, 5e-3);
    reads("5 µs", Dimension::TIME, 5e-6);
    reads("7 cm", Dimension::LENGTH, 0.07);
    reads(" -210 m ", Dimension::LENGTH, -210.0);
    reads("+.5 m", Dimension::LENGTH, 0.5);
    reads("5. m", Dimension::LENGTH, 5.0);
    reads("9.81 m/s2", Dimension::ACCELERATION, 9.81);
    reads("9.81 m/s/s", Dimension::ACCELERATION, 9.81);
    reads("980.665 cm / s^2", Dimension::ACCELERATION, 9.80665);
    reads("980.665 gal", Dimension::ACCELERATION, 9.80665);
    reads("1 g", Dimension::ACCELERATION, 9.80665);
    reads("180 deg", Dimension::ANGLE, std::f64::consts::PI);
    reads("90°", Dimension::ANGLE, std::f64::consts::FRAC_PI_2);
    reads("0.5 rad", Dimension::ANGLE, 0.5);
    reads("0.25", Dimension::NONE, 0.25);
    reads("3 %", Dimension::NONE, 0.03);
}

#[test]
fn a_unit_alone_reads_as_its_si_value() {
    assert_eq!(parse_unit("cm/s2", Dimension::ACCELERATION), Ok(0.01));
    assert_eq!(parse_unit("g", Dimension::ACCELERATION), Ok(STANDARD_GRAVITY));
    assert!(parse_unit("9 m/s2", Dimension::ACCELERATION).is_err());
    assert!(parse_unit("", Dimension::ACCELERATION).is_err());
}

#[test]
fn another_dimension_is_named_with_what_is_expected_and_an_example() {
    let error = parse("17 GPa", Dimension::LENGTH).unwrap_err();
    assert_eq!(error.to_string(), "is a stress or modulus (`GPa`), a length is expected");
    assert_eq!(error.remedy(""), "write a length such as \"0.5 m\"");
    assert!(matches!(parse("1 g", Dimension::LENGTH), Err(UnitError::WrongDimension { .. })));
    assert!(matches!(parse("42 deg", Dimension::NONE), Err(UnitError::WrongDimension { .. })));
}

#[test]
fn letters_in_the_wrong_case_are_recognised() {
    for (text, meant) in [("10 Gpa", "GPa"), ("10 mPa", "MPa"), ("10 KPA", "kPa"), ("10 mpa", "MPa")] {
        let error = parse(text, Dimension::PRESSURE).unwrap_err();
        assert_eq!(error.remedy(""), format!("did you mean `{meant}`?"), "{text}");
    }
}

#[test]
fn nothing_but_a_number_and_a_unit_is_accepted() {
    let length = Dimension::LENGTH;
    let bad = [
        "",
        " ",
        "m",
        "nan m",
        "inf m",
        "-inf m",
        "NaN",
        "1e400 m",
        "1e99999999999999999999 m",
        "- 5 m",
        "--5 m",
        "5",
        "5 m x",
        "5 m m",
        "5 m /",
        "5 /m",
        "5 m*",
        "5 m^",
        "5 m^-",
        "5 m^12",
        "5 m-",
        "5 m 3",
        "5 m,",
        "0,5 m",
        "1.2.3 m",
        "5 m/1",
        "5 m*1",
        "5 1",
        "5 m\0",
        "5 (m)",
        "5 м",
        "5 m¹²",
        "0x10 m",
        "1_000 m",
        "5 e m",
    ];
    for text in bad {
        assert!(parse(text, length).is_err(), "{text:?} must be refused");
    }
    assert!(parse(&format!("1 {}", "m*".repeat(100_000)), length).is_err());
    assert!(parse(&format!("1 {}m", "m9*".repeat(30)), length).is_err());
}

#[test]
fn an_exponent_is_part_of_the_number_only_where_digits_follow() {
    reads("1e3 m", Dimension::LENGTH, 1000.0);
    reads("1E-2m", Dimension::LENGTH, 0.01);
    reads("1e-99999999999999999999 m", Dimension::LENGTH, 0.0);
    assert!(parse("1e m", Dimension::LENGTH).is_err());
}

/// Every unit with every prefix, alone, squared and inverted, must agree with its definition.
#[test]
fn prefixes_scale_every_unit_and_powers_apply_to_the_prefix_too() {
    for symbol in SYMBOLS.iter().filter(|s| s.name != "1") {
        let d = symbol.dimension;
        let times = |n: i8| Dimension {
            length: n * d.length,
            mass: n * d.mass,
            time: n * d.time,
            angle: n * d.angle,
        };
        let prefixes =
            symbol.prefixes.chars().map(|p| (p.to_string(), look_up_prefix(p))).chain([(String::new(), 0)]);
        for (prefix, tens) in prefixes {
            let unit = format!("{prefix}{}", symbol.name);
            let size = symbol.factor * 10_f64.powi(symbol.tens + tens);
            for power in [-3, -1, 1, 2] {
                let value = parse(&format!("2.5 {unit}^{power}"), times(power)).expect(&unit);
                let exact = 2.5 * size.powi(i32::from(power));
                assert!((value / exact - 1.0).abs() < 1e-14, "{unit}^{power}: {value} {exact}");
            }
        }
    }
}

fn look_up_prefix(prefix: char) -> i32 {
    PREFIXES.iter().find(|(c, _)| *c == prefix).expect("a known prefix").1
}

#[test]
fn what_is_written_reads_back_to_six_digits() {
    let odd = Dimension { length: 2, mass: 1, time: -3, angle: 0 };
    let dimensions = NAMED.iter().map(|n| n.dimension).chain([odd]);
    for dimension in dimensions {
        for exponent in -12..=15 {
            for mantissa in [1.0, -2.345678912, 9.99999949, 5.0] {
                let value = mantissa * 10_f64.powi(exponent);
                let text = format(value, dimension);
                let back = parse(&text, dimension).unwrap_or_else(|e| panic!("{text}: {e}"));
                // Half a unit of the sixth digit.
                assert!((back / value - 1.0).abs() <= 5.1e-6, "{value} {text} {back}");
            }
        }
        assert_eq!(parse(&format(0.0, dimension), dimension), Ok(0.0));
    }
}

#[test]
fn values_are_written_in_the_units_of_the_field() {
    assert_eq!(format(2.5e10, Dimension::PRESSURE), "25 GPa");
    assert_eq!(format(1.2e6, Dimension::PRESSURE), "1.2 MPa");
    assert_eq!(format(2.7e4, Dimension::UNIT_WEIGHT), "27 kN/m3");
    assert_eq!(format(0.5, Dimension::LENGTH), "0.5 m");
    assert_eq!(format(0.002, Dimension::LENGTH), "2 mm");
    assert_eq!(format(42_f64.to_radians(), Dimension::ANGLE), "42 deg");
    assert_eq!(format(0.25, Dimension::NONE), "0.25");
    assert_eq!(format(3e-5, Dimension::RATE), "3e-5 1/s");
}

#[test]
fn every_example_reads_in_its_own_dimension() {
    for n in NAMED {
        assert!(parse(n.example, n.dimension).is_ok(), "{}", n.example);
    }
}

#[test]
fn a_stiffness_is_no_unit_weight_where_the_key_says_so() {
    let wrong = parse("20 MPa", Dimension::STIFFNESS).unwrap_err();
    assert!(wrong.message("normal_stiffness").ends_with("a stiffness per area is expected"));
    assert_eq!(wrong.remedy("normal_stiffness"), "write a stiffness per area such as \"20 GPa/m\"");
    assert_eq!(wrong.remedy("unit_weight"), "write a unit weight such as \"27 kN/m3\"");
    assert!(wrong.to_string().ends_with("a unit weight or a stiffness per area is expected"));
}

#[test]
fn a_bare_number_is_guessed_by_its_key_and_size() {
    for (key, value, dimension, meant) in [
        ("cohesion", 2.18, Dimension::PRESSURE, "2.18 MPa"),
        ("compressive_strength", 80.0, Dimension::PRESSURE, "80 MPa"),
        ("cohesion", 500.0, Dimension::PRESSURE, "500 kPa"),
        ("cohesion", 2.18e6, Dimension::PRESSURE, "2.18 MPa"),
        ("young", 25.0, Dimension::PRESSURE, "25 GPa"),
        ("young", 25e3, Dimension::PRESSURE, "25000 MPa"),
        ("young", 25e9, Dimension::PRESSURE, "25 GPa"),
        ("normal_stiffness", 20.0, Dimension::STIFFNESS, "20 GPa/m"),
        ("unit_weight", 27.0, Dimension::UNIT_WEIGHT, "27 kN/m3"),
        ("unit_weight", 27e3, Dimension::UNIT_WEIGHT, "27 kN/m3"),
        ("density", 2.7, Dimension::DENSITY, "2.7 t/m3"),
        ("density", 2700.0, Dimension::DENSITY, "2700 kg/m3"),
        ("pretension", 100.0, Dimension::FORCE, "100 kN"),
        ("pretension", 1e5, Dimension::FORCE, "100 kN"),
        ("fracture_energy", 130.0, Dimension::FRACTURE_ENERGY, "130 N/m"),
        ("strength", 300.0, Dimension::FRACTURE_ENERGY, "300 kN/m"),
        ("diameter", 25.0, Dimension::LENGTH, "25 mm"),
        ("bar_diameter", 20.0, Dimension::LENGTH, "20 mm"),
        ("crack_width", 0.3, Dimension::LENGTH, "0.3 mm"),
        ("relative_displacement", 20.0, Dimension::LENGTH, "20 mm"),
        ("relative_displacement", 0.02, Dimension::LENGTH, "0.02 m"),
        ("crack_width", 0.0003, Dimension::LENGTH, "0.0003 m"),
        ("max_closure", 1.0, Dimension::LENGTH, "1 mm"),
        ("yield", 400.0, Dimension::PRESSURE, "400 MPa"),
        ("yield", 400e6, Dimension::PRESSURE, "400 MPa"),
        ("diameter", 0.025, Dimension::LENGTH, "0.025 m"),
        ("area", 1570.0, Dimension::LENGTH, "1570 mm2/m"),
        ("area", 0.00157, Dimension::LENGTH, "0.00157 m2/m"),
        ("overburden", 1000.0, Dimension::LENGTH, "1000 m"),
        ("duration", 20.0, Dimension::TIME, "20 s"),
        ("reference", 5.0, Dimension::RATE, "5 Hz"),
        ("reference_rate", 3e-5, Dimension::RATE, "3e-5 1/s"),
        ("friction_angle", 42.0, Dimension::ANGLE, "42 deg"),
        ("friction_angle", 0.7, Dimension::ANGLE, "0.7 rad"),
        ("friction_angle", 0.0, Dimension::ANGLE, "0 deg"),
        ("zz", -5.4, Dimension::PRESSURE, "-5.4 MPa"),
    ] {
        assert_eq!(likely(key, value, dimension), meant, "{key} = {value}");
        assert!(parse(meant, dimension).is_ok(), "{meant}");
    }
}
