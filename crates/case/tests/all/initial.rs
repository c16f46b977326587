//! Initial stress and the search for equilibrium: what is read, what is left out, what is refused.

use std::path::Path;

use tremolite_case::{Case, InitialStress, Report};
use tremolite_laws::materials::MATERIALS;

use crate::problems::{Bad, bad};

const GOOD: &str = include_str!("../cases/every-key.toml");
const FIRST_SHAKE: &str = include_str!("../../../../cases/first-shake/case.toml");
const LATERAL: &str = "lateral = { x = 0.8, y = 1.2 }";

/// The first case shaken at once: without what comes before its earthquake.
fn at_once() -> String {
    let (head, rest) = FIRST_SHAKE.split_once("[initial]").expect("initial stress");
    let (_, tail) = rest.split_once("[motion]").expect("a motion");
    format!("{head}[motion]{tail}").replace("before   = \"rock\"", "")
}

fn parse(source: &str) -> Result<Case, Report> {
    Case::parse(Path::new("case.toml"), source, MATERIALS)
}

fn read(source: &str) -> Case {
    parse(source).unwrap_or_else(|e| panic!("{e}"))
}

/// The good case with another initial stress.
fn with(stress: &str) -> String {
    assert!(GOOD.contains(LATERAL));
    GOOD.replace(LATERAL, stress)
}

/// The one problem of a case: its message, its remedy, and the text that it marks.
fn refused(source: &str) -> (String, String, String) {
    let report = parse(source).expect_err(source);
    let [problem] = &report.problems[..] else { panic!("{report}") };
    (problem.message.clone(), problem.remedy.clone(), source[problem.span.clone()].to_owned())
}

#[test]
fn lateral_stress_is_a_table_or_one_number_for_both() {
    let initial = read(GOOD).initial;
    assert_eq!((initial.gravity.value, initial.overburden.map(|p| p.value)), (10.0, Some(5.4e6)));
    assert_eq!((initial.release_cycles.value, initial.max_cycles.value), (100, 5000));
    assert_eq!(initial.tolerance.value, 1e-4);
    for (written, ratios) in [
        (LATERAL, [0.8, 1.2]),
        ("lateral = 0.8", [0.8, 0.8]),
        ("lateral = 1", [1.0, 1.0]),
        ("lateral = \"80 %\"", [0.8, 0.8]),
        ("lateral = 0", [0.0, 0.0]),
    ] {
        let case = read(&with(written));
        let stress = case.initial.stress.expect("initial stress");
        assert_eq!(&case.source[stress.span()], written.split_once(" = ").expect("a value").1);
        let InitialStress::Lateral { x, y, .. } = stress else { panic!("{written}") };
        assert_eq!([x.value, y.value], ratios, "{written}");
    }
}

#[test]
fn a_field_of_stress_is_zero_where_it_says_nothing() {
    let field = "stress = { at = [\"1 m\", \"2 m\", \"-0.2 km\"], xx = \"-5 MPa\", zz = \"-6 MPa\", yz = \"10 kPa\", \
                 gradient = { xx = \"20 kN/m3\", zz = \"27 kN/m3\" } }";
    let case = read(&with(field));
    let Some(InitialStress::Field(stress)) = &case.initial.stress else { panic!("a field") };
    assert_eq!(stress.at, [1.0, 2.0, -200.0]);
    assert_eq!(stress.stress, [-5e6, 0.0, -6e6, 0.0, 10e3, 0.0]);
    assert_eq!(stress.gradient, [20e3, 0.0, 27e3, 0.0, 0.0, 0.0]);
    assert_eq!(&case.source[stress.span.clone()], field.split_once(" = ").expect("a value").1);
    let listed = |key: &str| case.defaulted.iter().find(|d| d.key == key).map(|d| d.value.as_str());
    assert_eq!(listed("initial.stress.yy"), Some("0 Pa"));
    assert_eq!(listed("initial.stress.gradient.zx"), Some("0 N/m3"));
    assert_eq!((listed("initial.stress.zz"), listed("initial.stress.at")), (None, None));

    let case = read(&with("stress = { zz = \"-1 MPa\" }"));
    let Some(InitialStress::Field(stress)) = &case.initial.stress else { panic!("a field") };
    assert_eq!((stress.at, stress.gradient), ([0.0; 3], [0.0; 6]));
    let listed = |key: &str| case.defaulted.iter().find(|d| d.key == key).map(|d| d.value.as_str());
    assert_eq!(listed("initial.stress.gradient"), Some("the stress is the same at every height"));
    assert_eq!(listed("initial.stress.at"), Some("[\"0 m\", \"0 m\", \"0 m\"]"));
}

const TENSOR: &str = "{ at = [\"1 m\", \"2 m\", \"-3 m\"], xx = \"-1 MPa\", yy = \"-2 MPa\", zz = \"-3 MPa\", xy = \"4 kPa\", yz = \
                      \"5 kPa\", zx = \"6 kPa\" }";

#[test]
fn measured_tensors_arrive_in_their_order() {
    let written = format!("[{TENSOR}, {}]", TENSOR.replace("-3 m", "-30 m"));
    let case = read(&with(&format!("measured = {written}")));
    let Some(stress @ InitialStress::Measured(all)) = &case.initial.stress else { panic!("measured") };
    let [first, second] = &all[..] else { panic!("two tensors") };
    assert_eq!((first.at, second.at), ([1.0, 2.0, -3.0], [1.0, 2.0, -30.0]));
    assert_eq!(first.stress, [-1e6, -2e6, -3e6, 4e3, 5e3, 6e3]);
    assert_eq!(&case.source[first.span.clone()], TENSOR);
    assert_eq!(&case.source[stress.span()], written.trim_matches(['[', ']']));

    let many = |n: usize| with(&format!("measured = [{}]", vec![TENSOR; n].join(", ")));
    assert!(parse(&many(1000)).is_ok());
    let (says, remedy, marks) = refused(&many(1001));
    assert!(says.contains("1001 measured stresses") && remedy.contains("at most 1000"), "{says}; {remedy}");
    assert_eq!(marks, TENSOR);
}

#[test]
fn the_search_for_equilibrium_has_defaults_that_are_listed_where_there_is_one() {
    let keys = |source: &str| {
        let case = read(source);
        let of_initial =
            case.defaulted.iter().filter_map(|d| Some((d.key.strip_prefix("initial.")?, &*d.value)));
        of_initial.map(|(key, value)| format!("{key} = {value}")).collect::<Vec<_>>()
    };
    let gravity = "gravity = 9.81 m/s2";
    let plain = at_once();
    assert_eq!(keys(&plain), [gravity]);
    let all = [
        gravity,
        "sides = roller",
        "base = fixed",
        "release_cycles = 200",
        "max_cycles = 20000",
        "tolerance = 1e-5",
    ];
    assert_eq!(keys(&format!("{plain}\n[initial]\nlateral = 0.8\n")), all);
    assert_eq!(keys(&format!("{plain}\n[[stage]]\nname = \"a\"\n"))[..], all);
    let case = read(&plain);
    assert!(!case.seeks_equilibrium() && read(GOOD).seeks_equilibrium());
    assert_eq!((case.initial.stress, case.initial.overburden), (None, None));
    assert_eq!((case.initial.release_cycles.value, case.initial.max_cycles.value), (200, 20_000));
    assert_eq!(case.initial.tolerance.value, 1e-5);
}

#[rustfmt::skip]
const BAD: &[Bad] = &[
    // Which of them
    bad(LATERAL, "lateral = 0.8\nstress = { zz = \"1 Pa\" }", "stress", "`stress` cannot stand beside `lateral`", "at most one of `lateral`, `stress`, `measured`"),
    bad(LATERAL, "lateral = 0.8\nmeasured = [{ at = [0, 0, 0], xx = \"1 Pa\", yy = \"1 Pa\", zz = \"1 Pa\", xy = \"1 Pa\", yz = \"1 Pa\", zx = \"1 Pa\" }]", "measured", "`measured` cannot stand beside `lateral`", "at most one"),
    bad("lateral = { x = 0.8, y = 1.2 }\n", "", "overburden", "only beside one of `lateral`, `stress`, `measured`", "leave it out"),
    bad(LATERAL, "lateral = 0.8\nlaterl = 1", "laterl", "no key of `initial`", "did you mean `lateral`?"),
    // Values
    bad("gravity = \"10 m/s2\"", "gravity = \"-10 m/s2\"", "\"-10 m/s2\"", "must be 0 or more", "0 or more"),
    bad("gravity = \"10 m/s2\"", "gravity = nan", "nan", "not a finite number", "finite"),
    bad(LATERAL, "lateral = { x = 0.8 }", "{ x", "`y` is missing in `initial.lateral`", "add y"),
    bad(LATERAL, "lateral = { x = -0.8, y = 1 }", "-0.8", "`x` must be 0 or more", "0 or more"),
    bad(LATERAL, "lateral = -0.8", "-0.8", "must be 0 or more", "0 or more"),
    bad(LATERAL, "lateral = inf", "inf", "not a finite number", "finite"),
    bad(LATERAL, "lateral = \"0.8 m\"", "\"0.8 m\"", "is a length (`m`), a pure number is expected", "0.25"),
    bad(LATERAL, "lateral = [0.8, 0.8]", "[0.8", "should be a table or a pure number, not a list", "lateral = …"),
    bad(LATERAL, "lateral = true", "true", "should be a table or a pure number, not true or false", "lateral = …"),
    bad("overburden = \"5.4 MPa\"", "overburden = \"5.4 m\"", "\"5.4 m\"", "is a length (`m`), a stress", "such as"),
    bad("overburden = \"5.4 MPa\"", "overburden = \"-5.4 MPa\"", "\"-5.4 MPa\"", "must be above 0", "above 0"),
    bad("release_cycles = 100", "release_cycles = 0", "0", "a whole number from 1 to 1000000, not 0", "release_cycles"),
    bad("max_cycles = 5000", "max_cycles = 1.5", "1.5", "a whole number from 1 to", "max_cycles"),
    bad("max_cycles = 5000", "max_cycles = 100", "100", "100 cycles at most end before 100 have let go", "`max_cycles` above `release_cycles`"),
    bad("release_cycles = 100\nmax_cycles = 5000", "release_cycles = 20000", "20000", "20000 cycles at most end before 20000", "`max_cycles` above"),
    bad("tolerance = 1e-4", "tolerance = 0", "0", "must be above 0 and at most 0.01", "at most 0.01"),
    bad("tolerance = 1e-4", "tolerance = 0.011", "0.011", "must be above 0 and at most 0.01", "at most 0.01"),
    bad("tolerance = 1e-4", "tolerance = nan", "nan", "not a finite number", "finite"),
    // Fields
    bad(LATERAL, "stress = \"5 MPa\"", "\"5 MPa\"", "should be a table, not a text", "stress = { … }"),
    bad(LATERAL, "stress = { xz = 1 }", "xz", "no key of `initial.stress`", "keys here: at, xx, yy, zz, xy, yz, zx, gradient"),
    bad(LATERAL, "stress = { xx = \"5 kN/m3\" }", "\"5 kN/m3\"", "a stress or modulus is expected", "such as"),
    bad(LATERAL, "stress = { xx = nan }", "nan", "not a finite number", "finite"),
    bad(LATERAL, "stress = { at = [0, 0] }", "[0, 0]", "a list of 3, each a length", "at = ["),
    bad(LATERAL, "stress = { gradient = { zz = \"27 kPa\" } }", "\"27 kPa\"", "is a stress or modulus (`kPa`), a unit weight is expected", "27 kN/m3"),
    bad(LATERAL, "stress = { gradient = 27e3 }", "27e3", "should be a table", "gradient = {"),
    // Measured
    bad(LATERAL, "measured = []", "[]", "should be a list of tables, not a list of 0", "[[initial.measured]]"),
    bad(LATERAL, "measured = { at = [0, 0, 0] }", "{ at", "should be a list of tables, not a table", "[[initial.measured]]"),
    bad(LATERAL, "measured = [{ at = [0, 0, 0], xx = \"1 Pa\", yy = \"1 Pa\", zz = \"1 Pa\", xy = \"1 Pa\", yz = \"1 Pa\" }]", "{ at", "`zx` is missing in `initial.measured[0]`", "zx = \"… MPa\""),
    bad(LATERAL, "measured = [{ xx = \"1 Pa\", yy = \"1 Pa\", zz = \"1 Pa\", xy = \"1 Pa\", yz = \"1 Pa\", zx = \"1 Pa\" }]", "{ xx", "`at` is missing in `initial.measured[0]`", "where it was measured"),
];

#[test]
fn each_mistake_in_what_is_there_initially_is_reported_once_at_its_place_with_a_way_out() {
    let failures: Vec<String> = BAD.iter().filter_map(Bad::failure).collect();
    assert!(failures.is_empty(), "{} of {}:\n{}", failures.len(), BAD.len(), failures.join("\n\n"));
}

#[test]
fn there_is_no_weight_without_gravity_where_densities_are_given() {
    let rock = ("unit_weight = \"27 kN/m3\"", "density = \"2700 kg/m3\"");
    let soil = ("unit_weight = \"19 kN/m3\"", "density = \"1900 kg/m3\"");
    let weightless = |gravity: &str| GOOD.replace("gravity = \"10 m/s2\"", &format!("gravity = {gravity}"));
    // The least of these would make an infinite density.
    for gravity in ["0", "\"1e-320 m/s2\""] {
        for (known, mark) in [(soil, "\"27 kN/m3\""), (rock, "\"19 kN/m3\"")] {
            let (says, remedy, marks) = refused(&weightless(gravity).replace(known.0, known.1));
            assert!(says.contains("turns no unit weight into a density"), "{says}");
            assert!(remedy.contains("give density"), "{remedy}");
            assert_eq!(marks, mark);
        }
    }
    let case = read(&weightless("0").replace(rock.0, rock.1).replace(soil.0, soil.1));
    assert_eq!((case.initial.gravity.value, case.materials[0].density.value), (0.0, 2700.0));
}

#[test]
fn moduli_over_a_band_say_their_frequency_where_equilibrium_is_sought() {
    const RAYLEIGH: &str = "{ rayleigh = { mass = \"0.3 1/s\", stiffness = \"0.1 ms\" } }";
    let band = |reference: &str| {
        let given = format!("{{ ratio = 0.03, band = [\"0.5 Hz\", \"20 Hz\"]{reference} }}");
        GOOD.replace(RAYLEIGH, &given)
    };
    for given in [", reference = \"0 Hz\"", ", reference = \"5 Hz\""] {
        assert!(read(&band(given)).dynamic.band.is_some_and(|b| b.reference.is_some()), "{given}");
    }
    let (says, remedy, marks) = refused(&band(""));
    assert!(
        says.contains("`reference` is missing") && remedy.contains("reference = \"0 Hz\""),
        "{says}; {remedy}"
    );
    assert_eq!(marks, "[\"0.5 Hz\", \"20 Hz\"]");
    let (says, ..) = refused(&band(", reference = \"-1 Hz\""));
    assert!(says.contains("must be 0 or more"), "{says}");
    // Shaken at once, the motion's central frequency is as good.
    let damping = "damping = { ratio = 0.03, band = [\"0.5 Hz\", \"20 Hz\"] }";
    let shaken = at_once().replace("[dynamic]", &format!("[dynamic]\n{damping}"));
    let shaken: String = shaken
        .lines()
        .filter(|line| !line.starts_with("damping") || *line == damping)
        .map(|line| format!("{line}\n"))
        .collect();
    assert!(parse(&shaken).is_ok(), "{shaken}");
    let (says, ..) = refused(&format!("{shaken}[initial]\nlateral = 1\n"));
    assert!(says.contains("`reference` is missing"), "{says}");
}
