//! Interfaces of a case: what is read, what is chosen later, what is refused.

use std::path::Path;

use tremolite_case::{Case, Contact, Interface, LawFile, LawKind, Laws};
use tremolite_laws::interfaces::INTERFACES;
use tremolite_laws::materials::MATERIALS;
use tremolite_laws::parameter::{BadParameter, Dimension, Kind, LawInfo, Need, Parameter};

use crate::problems::{Bad, bad};

const GOOD: &str = include_str!("../cases/every-key.toml");
const FIRST_SHAKE: &str = include_str!("../../../../cases/first-shake/case.toml");
const KIRSCH_HOLE: &str = include_str!("../../../../cases/kirsch-hole/case.toml");

const SKETCH: &str = r#"
[[interface]]
name = "lining-rock"
between = [["*.lining"], "rock"]
law = "bandis"
max_closure = "2 mm"
cohesion = "0.5 MPa"
friction_coefficient = 0.7
"#;

fn read(source: &str) -> Case {
    Case::parse(Path::new("case.toml"), source, MATERIALS).unwrap_or_else(|e| panic!("{e}"))
}

fn contact(interface: &Interface) -> &Contact {
    interface.contact.as_ref().expect("not tied")
}

#[test]
fn every_value_of_an_interface_arrives_in_si() {
    let case = read(GOOD);
    let [joint, bench] = &case.interfaces[..] else { panic!("two interfaces") };
    let texts = |i: &Interface| {
        i.between.each_ref().map(|side| side.iter().map(|p| p.value.clone()).collect::<Vec<_>>())
    };
    assert_eq!((joint.name.value.as_str(), bench.name.value.as_str()), ("lining-rock", "bench"));
    assert_eq!(texts(joint), [vec!["*.lining"], vec!["rock", "*.gallery"]]);
    assert_eq!(texts(bench), [vec!["transformer.bench*"], vec!["rock"]], "brackets may be left out");
    assert_eq!(joint.sides_of("powerhouse.lining"), [true, false]);
    assert_eq!(joint.sides_of("busbar.gallery"), [false, true]);
    assert_eq!(bench.contact, None, "tied");
    let joint = contact(joint);
    assert_eq!(joint.law.value, "bandis");
    assert_eq!(joint.parameters.number("normal_stiffness"), Ok(20e9));
    assert_eq!(joint.parameters.number("max_closure"), Ok(0.002));
    assert_eq!(joint.parameters.word("tangential"), Some("constant"));
    assert_eq!(
        (joint.corner.value, joint.damping.value, joint.limit.value),
        (60_f64.to_radians(), 0.02, 0.9)
    );

    let monitor = &case.monitors[2];
    let looked_at = monitor.interface.as_ref().expect("an interface");
    assert_eq!((looked_at.value, &case.source[looked_at.span.clone()]), (0, "\"lining-rock\""));
    assert_eq!((&monitor.body, &case.monitors[0].interface), (&None, &None));
    assert!(case.defaulted.iter().all(|d| d.key != "monitor[joint].body"), "{:?}", case.defaulted);
}

#[test]
fn what_an_interface_leaves_out_is_listed_and_what_is_chosen_has_no_value() {
    let case = read(&format!("{}{SKETCH}", FIRST_SHAKE.split("[output]").next().expect("a case")));
    let joint = contact(&case.interfaces[0]);
    let listed = |key: &str| case.defaulted.iter().find(|d| d.key == key).map(|d| d.value.as_str());
    for (key, value) in [
        ("poisson", "0.25"),
        ("tangential", "following"),
        ("tensile_strength", "the cohesion"),
        (
            "normal_stiffness",
            "as stiff as impacts leave the time step alone, and no softer than ten times the elements beside it",
        ),
        ("corner", "45 deg"),
        ("contact_damping", "0.01"),
        ("contact_limit", "0.8"),
        ("viscosity", "0.06"),
    ] {
        assert_eq!(listed(&format!("interface[lining-rock].{key}")), Some(value), "{key}");
    }
    assert_eq!(joint.parameters.optional("normal_stiffness"), None);
    assert_eq!(joint.parameters.number("poisson"), Ok(0.25));
    assert_eq!(
        (joint.corner.value, joint.damping.value, joint.limit.value, joint.viscosity.value),
        (45_f64.to_radians(), 0.01, 0.8, 0.06)
    );

    let tied = read(&format!(
        "{FIRST_SHAKE}\n[[interface]]\nname = \"a\"\nbetween = [\"*.lining\", \"rock\"]\nlaw = \"tied\"\n"
    ));
    assert!(tied.defaulted.iter().all(|d| !d.key.starts_with("interface")), "{:?}", tied.defaulted);
    let none = read(FIRST_SHAKE);
    let listed = none.defaulted.iter().find(|d| d.key == "interface");
    assert_eq!(listed.map(|d| d.value.as_str()), Some("bodies that touch are tied"));
}

#[test]
fn fields_that_are_left_out_hold_those_of_cracks_and_interfaces_where_there_are_any() {
    let (before, rest) = FIRST_SHAKE.split_once("[output]").expect("the output");
    let fields = |source: &str| {
        let case = read(source);
        let said = case.defaulted.iter().find(|d| d.key == "output.fields").map(|d| d.value.clone());
        (case.output.fields.iter().map(|f| f.value.clone()).collect::<Vec<_>>(), said)
    };
    // Its concrete cracks; of a hole in elastic rock nothing does.
    assert_eq!(fields(KIRSCH_HOLE).0, ["displacement", "velocity", "stress"]);
    let usual = ["displacement", "velocity", "stress", "damage"];
    let said = |fields: &str| Some(format!("[{fields}]"));
    let words = r#""displacement", "velocity", "stress", "damage""#;
    assert_eq!(fields(before), (usual.map(String::from).to_vec(), said(words)));
    let with = ["displacement", "velocity", "stress", "damage", "interface"].map(String::from).to_vec();
    let expected = (with, said(&format!("{words}, \"interface\"")));
    assert_eq!(fields(&format!("{before}{SKETCH}")), expected);
    assert_eq!(fields(&format!("{before}[output]\nhistories = \"0.02 s\"\n{SKETCH}")), expected);
    let tied = "[[interface]]\nname = \"a\"\nbetween = [\"a\", \"b\"]\nlaw = \"tied\"\n";
    assert_eq!(fields(&format!("{before}{tied}")).0, usual);
    let given = format!("{before}[output]\nfields = [\"stress\"]\n{SKETCH}");
    assert_eq!(fields(&given), (vec!["stress".to_owned()], None));
    assert!(!rest.is_empty());
}

#[rustfmt::skip]
const BAD: &[Bad] = &[
    // Keys
    bad("name = \"lining-rock\"\n", "", "[[interface]]", "`name` is missing in `interface[0]`", "add name"),
    bad("between = [[\"*.lining\"], [\"rock\", \"*.gallery\"]]\n", "", "[[interface]]", "`between` is missing in `interface[lining-rock]`", "groups on the first side"),
    bad("law = \"tied\"\n", "", "[[interface]]\nname = \"bench\"", "`law` is missing in `interface[bench]`", "\"tied\""),
    bad("max_closure = \"2 mm\"\n", "", "[[interface]]", "`max_closure` is missing in `interface[lining-rock]`", "max_closure = \"… m\""),
    bad("contact_limit = 0.9", "contact_limt = 0.9\ncontact_limit = 0.9", "contact_limt", "no key of `interface[lining-rock]`", "did you mean `contact_limit`?"),
    bad("contact_limit = 0.9", "contact_limit = 0.9\nsize = \"1 m\"", "size", "no key of `interface[lining-rock]`", "keys here: name, between, law"),
    bad("safety = 0.8", "safety = 0.8\ncontact_limit = 0.8", "contact_limit", "no key of `dynamic`", "`contact_limit` belongs to [interface]"),
    bad("law = \"tied\"", "law = \"tied\"\nfriction_coefficient = 0.7", "friction", "only where `law` is not \"tied\"", "leave it out"),
    bad("law = \"tied\"", "law = \"tied\"\nshear_stiffness = \"1 GPa/m\"", "shear_stiffness", "only where `law` is not \"tied\"", "leave it out"),
    bad("law = \"tied\"", "law = \"tied\"\ncorner = \"45 deg\"", "corner", "only where `law` is not \"tied\"", "leave it out"),
    bad("law = \"tied\"", "law = \"tied\"\nsize = 3", "size", "no key of `interface[bench]`", "keys here: name, between, law"),
    bad("[initial]", "[initial]\ninterface = 3", "interface", "no key of `initial`", "[[interface]] is a table of its own"),
    // Values
    bad("law = \"bandis\"", "law = \"bandi\"", "\"bandi\"", "`law` cannot be \"bandi\"", "did you mean \"bandis\"?"),
    bad("law = \"tied\"", "law = \"glued\"", "\"glued\"", "`law` cannot be \"glued\"", "write one of \"bandis\", \"coulomb\", \"tied\""),
    bad("law = \"tied\"", "law = \"tide\"", "\"tide\"", "`law` cannot be \"tide\"", "did you mean \"tied\"?"),
    bad("law = \"tied\"", "law = \"elastic\"", "\"elastic\"", "`law` cannot be \"elastic\"", "\"tied\""),
    bad("corner = \"60 deg\"", "corner = \"61 deg\"", "\"61 deg\"", "must be above 0 and at most 60 deg", "at most 60 deg"),
    bad("corner = \"60 deg\"", "corner = \"0 deg\"", "\"0 deg\"", "must be above 0 and at most 60 deg", "above 0"),
    bad("corner = \"60 deg\"", "corner = 45", "45", "has no unit", "deg"),
    bad("contact_damping = 0.02", "contact_damping = 0.3", "0.3", "must be from 0 to 0.2", "from 0 to 0.2"),
    bad("contact_damping = 0.02", "contact_damping = -0.1", "-0.1", "must be from 0 to 0.2", "from 0 to 0.2"),
    bad("contact_limit = 0.9", "contact_limit = 1.1", "1.1", "must be above 0 and at most 1", "at most 1"),
    bad("contact_limit = 0.9", "contact_limit = 0", "0", "must be above 0 and at most 1", "above 0"),
    bad("viscosity = 0.04", "viscosity = 0.6", "0.6", "must be from 0 to 0.5", "from 0 to 0.5"),
    bad("normal_stiffness = \"20 GPa/m\"", "normal_stiffness = \"20 GPa\"", "\"20 GPa\"", "a stiffness per area is expected", "GPa/m"),
    bad("normal_stiffness = \"20 GPa/m\"", "normal_stiffness = 20", "20", "`normal_stiffness` has no unit: a stiffness per area is expected", "\"20 GPa/m\""),
    bad("normal_stiffness = \"20 GPa/m\"", "normal_stiffness = 5e3", "5e3", "has no unit", "\"5000 MPa/m\""),
    bad("normal_stiffness = \"20 GPa/m\"", "normal_stiffness = \"-20 GPa/m\"", "\"-20 GPa/m\"", "must be positive", "20 GPa/m is usual"),
    bad("friction_coefficient = 0.7", "friction_coefficient = -0.7", "-0.7", "must be zero or positive", "zero or"),
    bad("normal_stiffness = \"20 GPa/m\"\nmax_closure = \"2 mm\"\npoisson = 0.2", "max_closure = \"2 mm\"\npoisson = 0.7", "0.7", "must be between -1 and 0.5", "0.25"),
    bad("tangential = \"constant\"", "tangential = \"folowing\"", "\"folowing\"", "`tangential` cannot be", "did you mean \"following\"?"),
    bad("tensile_strength = \"0.4 MPa\"", "tensile_strength = \"50 MPa\"", "\"50 MPa\"", "the joint can never reach", "smaller tensile_strength"),
    // Sides
    bad("between = [\"transformer.bench*\", \"rock\"]", "between = [\"rock\"]", "[\"rock\"]", "should be a list of 2, each a text or a list, each a text, not a list of 1", "between = [\"…\", \"…\"]"),
    bad("between = [\"transformer.bench*\", \"rock\"]", "between = \"rock\"", "\"rock\"", "should be a list of 2", "between = ["),
    bad("between = [\"transformer.bench*\", \"rock\"]", "between = [\"rock\", []]", "[]", "not a list of 0", "between = "),
    bad("between = [\"transformer.bench*\", \"rock\"]", "between = [\"rock\", 3]", "3", "a text or a list, each a text, not a whole number", "between = "),
    bad("between = [\"transformer.bench*\", \"rock\"]", "between = [\"rock\", [\"a\", \"rock\"]]", "\"rock\"]]", "group `rock` is on both sides", "what lies on each side"),
    bad("[\"rock\", \"*.gallery\"]", "[\"rock\", \"rock\"]", "\"rock\"]", "group `rock` is named twice", "once"),
    bad("between = [\"transformer.bench*\", \"rock\"]", "between = [[\"*.gallery\", \"rock\"], \"*.lining\"]", "[[\"*.gallery\"", "interface `bench` is between the groups of interface `lining-rock`", "keep one"),
    bad("name = \"bench\"", "name = \"lining-rock\"", "\"lining-rock\"", "interface `lining-rock` is named twice", "its own name"),
    bad("name = \"bench\"", "name = \"b c\"", "\"b c\"", "cannot be used as a name", "no blanks"),
    // Monitors
    bad("interface = \"lining-rock\"", "interface = \"lining-rok\"", "\"lining-rok\"", "there is no interface `lining-rok`", "did you mean \"lining-rock\"?"),
    bad("interface = \"lining-rock\"", "interface = \"fault\"", "\"fault\"", "there is no interface `fault`", "known interfaces: lining-rock, bench"),
    bad("interface = \"lining-rock\"", "interface = \"bench\"", "\"bench\"", "interface `bench` is tied", "with a law"),
    bad("interface = \"lining-rock\"", "body = \"rock\"\ninterface = \"lining-rock\"", "body", "`body` has a meaning only without `interface`", "leave it out"),
    bad("between = [\"free\", \"A\"]", "between = [\"free\", \"joint\"]", "\"joint\"", "monitor `joint` keeps gap and slip of an interface", "without `interface`"),
];

#[test]
fn each_mistake_in_an_interface_is_reported_once_at_its_place_with_a_way_out() {
    let failures: Vec<String> = BAD.iter().filter_map(Bad::failure).collect();
    assert!(failures.is_empty(), "{} of {}:\n{}", failures.len(), BAD.len(), failures.join("\n\n"));
}

#[test]
fn a_list_of_interfaces_is_written_with_two_brackets() {
    let source = format!("{FIRST_SHAKE}\n{}", SKETCH.replace("[[interface]]", "[interface]"));
    let report = Case::parse(Path::new("case.toml"), &source, MATERIALS).expect_err("one bracket");
    let [problem] = &report.problems[..] else { panic!("{report}") };
    assert_eq!(problem.message, "`interface` should be a list of tables, not a table");
    assert_eq!(problem.remedy, "write [[interface]]");
}

const GLUE: LawInfo = LawInfo {
    name: "glue",
    summary: "sticks",
    source: "",
    parameters: &[
        Parameter {
            name: "stickiness",
            kind: Kind::Number(Dimension::PRESSURE),
            need: Need::Required,
            doc: "what it holds",
        },
        Parameter {
            name: "spring",
            kind: Kind::Number(Dimension::STIFFNESS),
            need: Need::Chosen("as the step goes"),
            doc: "stiffness per area",
        },
    ],
    history: &[],
    pressure_dependent: false,
    damages: false,
    check: |values| match (values.number("spring"), values.number("stickiness")) {
        (Err(missing), _) => Err(vec![missing]),
        (_, Ok(x)) if x > 1e6 => Err(vec![BadParameter::new("stickiness", "is too sticky", "thin it")]),
        _ => Ok(()),
    },
    chosen: |values, choice| values.clone().with("spring", choice.stiffness),
};

#[test]
fn a_law_from_outside_the_list_may_stand_at_an_interface() {
    let glued = [INTERFACES[0], GLUE];
    let laws = Laws { materials: MATERIALS, interfaces: &glued };
    let interface =
        "\n[[interface]]\nname = \"a\"\nbetween = [\"b\", \"c\"]\nlaw = \"glue\"\nstickiness = \"7 kPa\"\n";
    let source = format!("{FIRST_SHAKE}{interface}");
    let case = Case::parse(Path::new("case.toml"), &source, laws).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(contact(&case.interfaces[0]).parameters.number("stickiness"), Ok(7000.0));
    let said = case.defaulted.iter().find(|d| d.key == "interface[a].spring");
    assert_eq!(said.map(|d| d.value.as_str()), Some("as the step goes"));
    assert!(Case::parse(Path::new("case.toml"), &source, MATERIALS).is_err(), "glue is no law of the house");
    let sticky = source.replace("7 kPa", "7 GPa");
    let report = Case::parse(Path::new("case.toml"), &sticky, laws).expect_err("too sticky");
    assert_eq!(report.problems[0].message, "`stickiness` is too sticky");
    let schema = tremolite_case::schema(laws).to_string();
    assert!(schema.contains("\"const\":\"glue\"") && schema.contains("stickiness"));

    let alone = "[interface]\nlaw = \"glue\"\nstickiness = \"7 kPa\"\nspring = \"1 GPa/m\"\n";
    assert!(LawFile::parse(Path::new("law.toml"), alone, laws).is_ok_and(|f| f.kind == LawKind::Interface));
}
