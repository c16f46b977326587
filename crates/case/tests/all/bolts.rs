//! Bolts that stages place: what is read, what is left out, what is refused.

use std::path::Path;

use tremolite_case::{BoltPlace, BoltedFaces, Bolts, Case, Plate, Report};
use tremolite_laws::materials::MATERIALS;

use crate::problems::{Bad, bad};

const GOOD: &str = include_str!("../cases/every-key.toml");

fn parse(source: &str) -> Result<Case, Report> {
    Case::parse(Path::new("study/case.toml"), source, MATERIALS)
}

fn read(source: &str) -> Case {
    parse(source).unwrap_or_else(|e| panic!("{e}"))
}

/// The good case with these lines as the bolts of its first stage, and no monitor on any.
fn with(bolts: &str) -> String {
    let (head, rest) = GOOD.split_once("[[stage.bolts]]").expect("bolts");
    let (_, tail) = rest.split_once("[[stage]]").expect("a second stage");
    let (stages, rest) = tail.split_once("[[monitor]]\nname = \"anchor\"").expect("a monitor on bolts");
    let (_, end) = rest.split_once("[[monitor_pair]]").expect("what comes next");
    format!("{head}{bolts}\n[[stage]]{stages}[[monitor_pair]]{end}")
}

fn only(case: &Case) -> &Bolts {
    let [bolts] = &case.stages[0].bolts[..] else { panic!("{} entries", case.stages[0].bolts.len()) };
    bolts
}

#[test]
fn every_value_of_bolts_arrives_in_si() {
    let case = read(GOOD);
    let all: Vec<(usize, &str)> =
        case.bolts().map(|(stage, bolts)| (stage, bolts.name.value.as_str())).collect();
    assert_eq!(all, [(0, "spot"), (0, "systematic 1")]);
    let [spot, pattern] = &case.stages[0].bolts[..] else { panic!("two entries") };
    let BoltPlace::Points(points) = &spot.place else { panic!("points") };
    assert_eq!(
        points.iter().map(|p| p.value).collect::<Vec<_>>(),
        [[[0.0, 1.0, -210.0], [0.0, 1.0, -204.5]]]
    );
    let value = |x: &Option<tremolite_case::Spanned<f64>>| x.as_ref().map(|x| x.value);
    assert_eq!((spot.diameter.value, spot.young.value, value(&spot.yields)), (0.04, 195e9, Some(835e6)));
    assert_eq!((value(&spot.breaking_strain), value(&spot.pretension)), (Some(0.07), Some(300e3)));
    assert_eq!((value(&spot.free_length), spot.plate.value), (Some(2.0), Plate::Both));
    assert_eq!(spot.plate.value.ends(), [true, true]);
    let bond = spot.bond.as_ref().expect("a bond");
    assert_eq!((bond.stiffness.value, bond.strength.value), (10e9, 300e3));
    assert_eq!((bond.friction_angle.value, value(&bond.segment)), (25_f64.to_radians(), Some(0.2)));
    assert!((spot.area() - 1.256_637_061e-3).abs() < 1e-12, "π/4 · (40 mm)²");

    let BoltPlace::Pattern(p) = &pattern.place else { panic!("a pattern") };
    assert_eq!((p.faces.value, p.spacing.value, p.length.value), (BoltedFaces::Systematic, [1.5, 1.2], 6.0));
    assert_eq!(p.on.iter().map(|g| g.value.as_str()).collect::<Vec<_>>(), ["transformer.bench*"]);
    let direction = p.direction.as_ref().expect("a direction").value;
    assert!(direction.iter().zip([0.0, 0.6, 0.8]).all(|(a, b)| (a - b).abs() < 1e-15), "{direction:?}");
    assert_eq!((pattern.plate.value, pattern.plate.value.ends()), (Plate::Head, [true, false]));

    let monitor = case.monitors.iter().find(|m| m.name.value == "anchor").expect("the monitor");
    assert_eq!(monitor.bolt.as_ref().map(|b| b.value), Some(0));
    assert!(!monitor.is_in_element() && monitor.interface.is_none());
    assert_eq!(case.monitors.iter().filter(|m| m.is_in_element()).count(), 2);
}

#[test]
fn one_entry_in_braces_has_the_defaults_that_are_listed() {
    let source =
        with("bolts = { pattern = \"crown\", spacing = \"1.5 m\", length = \"6 m\", diameter = \"25 mm\" }");
    let case = read(&source);
    let bolts = only(&case);
    assert_eq!(bolts.name.value, "crown of bench 1, with its lining");
    let BoltPlace::Pattern(pattern) = &bolts.place else { panic!("a pattern") };
    assert_eq!((pattern.faces.value, pattern.spacing.value), (BoltedFaces::Crown, [1.5, 1.5]));
    assert_eq!((&pattern.direction, pattern.on.len()), (&None, 0));
    assert_eq!((bolts.young.value, &bolts.yields, &bolts.bond), (200e9, &None, &None));
    assert_eq!((bolts.plate.value, &bolts.pretension, &bolts.free_length), (Plate::None, &None, &None));
    let listed: Vec<(&str, &str)> = case
        .defaulted
        .iter()
        .filter_map(|d| {
            Some((d.key.strip_prefix("stage[bench 1, with its lining].bolts.")?, d.value.as_str()))
        })
        .collect();
    assert_eq!(
        listed,
        [
            ("name", "its pattern (or \"bolts\") and the stage, as in \"crown of bench 1\""),
            ("on", "all faces that the stage exposes"),
            ("direction", "normal"),
            ("young", "200 GPa"),
            ("yield", "never: the steel stays elastic whatever its force"),
            ("breaking_strain", "never: however far it is drawn, it does not break"),
            ("pretension", "none"),
            ("free_length", "none: bonded from the head on"),
            ("plate", "none"),
            ("bond", "none: they move with the rock"),
        ]
    );
    // What the sketch of a case writes, and a header for one entry.
    for head in ["[stage.bolts]", "[[stage.bolts]]"] {
        let table = format!(
            "{head}\npattern = \"walls\"\nspacing = \"2 m\"\nlength = \"6 m\"\ndiameter = \"0.025 m\"\nplate = false"
        );
        assert_eq!(only(&read(&with(&table))).plate.value, Plate::None);
    }
}

#[test]
fn bolts_of_a_file_name_it_among_the_files_of_the_case() {
    let case = read(&with("bolts = { file = \"b/bolts.csv\", diameter = \"25 mm\" }"));
    assert_eq!(only(&case).name.value, "bolts of bench 1, with its lining");
    assert!(case.files().iter().any(|f| f.value.as_path() == Path::new("b/bolts.csv")));
    assert!(
        case.defaulted.iter().all(|d| !d.key.ends_with("bolts.direction") && !d.key.ends_with("bolts.on"))
    );
}

#[test]
fn a_rod_of_glass_fibre_breaks_without_yielding_and_an_anchor_may_be_free_all_along() {
    read(&with("bolts = { file = \"a.csv\", diameter = \"25 mm\", breaking_strain = 0.02 }"));
    let free =
        "pattern = \"walls\", spacing = \"2 m\", length = \"6 m\", free_length = \"6 m\", plate = \"both\"";
    read(&with(&format!("bolts = {{ {free}, diameter = \"25 mm\", pretension = \"100 kN\" }}")));
    // Without a bond a pretension needs no free length.
    read(&with("bolts = { file = \"a.csv\", diameter = \"25 mm\", pretension = \"100 kN\" }"));
}

const SPOT: &str = "points = [[[\"0 m\", \"1 m\", \"-210 m\"], [0, \"1 m\", \"-204.5 m\"]]]";
const BOND: &str = "bond = { stiffness = \"10 GPa\", strength = \"300 kN/m\", friction_angle = \"0 deg\", segment = \"1 m\" }";

#[rustfmt::skip]
const BAD: &[Bad] = &[
    // Where they are
    bad("pattern = \"systematic\"", "pattern = \"systematic\"\nfile = \"a.csv\"", "file", "`file` cannot stand beside `pattern`", "exactly one of `pattern`, `points`, `file`"),
    bad(SPOT, "# nowhere", "[[stage.bolts]]", "needs one of `pattern`, `points`, `file`", "give one of"),
    bad(SPOT, "pattern = \"ring\"\nspacing = \"1 m\"\nlength = \"6 m\"", "\"ring\"", "`pattern` cannot be \"ring\"", "\"systematic\", \"crown\", \"walls\""),
    bad("spacing = [\"1.5 m\", \"1.2 m\"]\n", "", "[[stage.bolts]]", "`spacing` is missing", "around it in a row"),
    bad("length = \"6 m\"\n", "", "[[stage.bolts]]", "`length` is missing", "length = \"… m\""),
    bad(SPOT, "points = [[[0, 0, 0], [0, 0, \"1 m\"]]]\nspacing = \"1 m\"", "spacing", "`spacing` has a meaning only beside `pattern`", "leave it out"),
    bad(SPOT, "points = [[[0, 0, 0], [0, 0, \"3 m\"]]]\nlength = \"1 m\"", "length", "`length` has a meaning only beside `pattern`", "leave it out"),
    bad(SPOT, "points = [[[0, 0, 0], [0, 0, \"3 m\"]]]\non = [\"rock\"]", "on", "`on` has a meaning only beside `pattern`", "leave it out"),
    bad(SPOT, "file = \"a.csv\"\ndirection = [0, 0, 1]", "direction", "`direction` has a meaning only beside `pattern`", "leave it out"),
    bad("spacing = [\"1.5 m\", \"1.2 m\"]", "spacing = [\"1.5 m\", \"0 m\"]", "\"0 m\"", "`spacing` must be above 0", "above 0"),
    bad("spacing = [\"1.5 m\", \"1.2 m\"]", "spacing = [1, 1, 1]", "[1, 1, 1]", "a list of 2, each a length, not a list of 3", "[\"… m\", \"… m\"]"),
    bad("spacing = [\"1.5 m\", \"1.2 m\"]", "spacing = \"1.5 kN\"", "\"1.5 kN\"", "is a force (`kN`), a length is expected", "0.5 m"),
    bad("length = \"6 m\"", "length = \"-6 m\"", "\"-6 m\"", "`length` must be above 0", "above 0"),
    bad("direction = [0, 3, 4]", "direction = [0, 0, 0]", "[0, 0, 0]", "`direction` has no length", "[0, 0, 1]"),
    bad("direction = [0, 3, 4]", "direction = \"up\"", "\"up\"", "`direction` cannot be \"up\"", "\"normal\""),
    bad("direction = [0, 3, 4]", "direction = [0, 1]", "[0, 1]", "a list of 3", "[…, …, …]"),
    bad("on = [\"transformer.bench*\"]\nspacing", "on = []\nspacing", "[]", "a list, each a text", "on = [\"…\"]"),
    bad(SPOT, "points = []", "[]", "`points` should be a list", "points = [[["),
    bad(SPOT, "points = [[[0, 0, 0], [0, 0]]]", "[0, 0]]", "a list of 3, each a length, not a list of 2", "points"),
    bad(SPOT, "points = [[[0, 0, 0], [0, 0, \"3 m\"]], [[\"1 m\", \"2 m\", \"3 m\"], [\"1 m\", \"2 m\", \"3 m\"]]]", "[[\"1 m\", \"2 m\", \"3 m\"], [\"1 m\"", "the two points of bolt 2 are one place", "its other end"),
    bad("[[stage]]\nname = \"bench 1", "[[stage]]\nname = \"early\"\nbolts = { pattern = \"crown\", spacing = \"1 m\", length = \"3 m\", diameter = \"25 mm\" }\n[[stage]]\nname = \"bench 1", "\"crown\"", "no stage up to 'early' excavates anything", "give the bolts as `points`"),
    bad("name = \"systematic 1\"", "name = \"spot\"", "\"spot\"", "bolts `spot` is named twice", "its own name"),
    // Steel
    bad("diameter = \"25 mm\"\n", "", "[[stage.bolts]]", "`diameter` is missing", "diameter = \"… mm\""),
    bad("diameter = \"25 mm\"", "diameter = \"25 m\"", "\"25 m\"", "must be above 0 and at most 1 m", "at most 1 m"),
    bad("diameter = \"25 mm\"", "diameter = \"25 nm\"", "\"25 nm\"", "thick is none", "25 mm"),
    bad("diameter = \"40 mm\"", "diameter = \"40 MPa\"", "\"40 MPa\"", "is a stress or modulus (`MPa`), a length is expected", "25 mm"),
    bad("young = \"200 GPa\"", "young = 0", "0", "`young` must be above 0", "above 0"),
    bad("yield = \"400 MPa\"", "yield = \"400 kN\"", "\"400 kN\"", "is a force (`kN`), a stress or modulus is expected", "400 MPa"),
    bad("breaking_strain = 0.1", "breaking_strain = 10", "10", "must be above 0 and at most 1", "at most 1"),
    bad("breaking_strain = 0.1", "breaking_strain = 0.001", "0.001", "would break before it yields", "leave `yield` out"),
    bad("pretension = \"50 kN\"", "pretension = \"50 MPa\"", "\"50 MPa\"", "a force is expected", "150 kN"),
    bad("pretension = \"50 kN\"", "pretension = \"200 kN\"", "\"200 kN\"", "yields the steel, which holds 196.35 kN", "70 %"),
    bad("yield = \"400 MPa\"\nbreaking_strain = 0.1\npretension = \"50 kN\"", "breaking_strain = 0.001\npretension = \"100 kN\"", "\"100 kN\"", "breaks the steel, which holds 98.1748 kN", "give less"),
    // Free length and plates
    bad("free_length = \"1 m\"\nplate = true", "free_length = \"1 m\"\nplate = false", "\"1 m\"", "nothing holds the head of a free length", "add plate = \"head\""),
    bad("free_length = \"2 m\"\nplate = \"both\"", "free_length = \"2 m\"\nplate = \"none\"", "\"2 m\"", "nothing holds the head of a free length", "leave `free_length` out"),
    bad("plate = true", "plate = \"tail\"", "\"tail\"", "`plate` cannot be \"tail\"", "\"head\", \"both\", \"none\""),
    bad("plate = true", "plate = 1", "1", "should be one of \"head\", \"both\", \"none\" or true or false", "plate = \"head\""),
    bad("free_length = \"1 m\"", "free_length = \"6.5 m\"", "\"6.5 m\"", "the free length is longer than the bolt, 6 m", "shorter"),
    bad("free_length = \"1 m\"", "free_length = \"6 m\"", "\"6 m\"", "nothing holds the other end", "plate = \"both\""),
    bad("pretension = \"50 kN\"\nfree_length = \"1 m\"", "pretension = \"50 kN\"", "\"50 kN\"", "nothing to be drawn against", "add free_length = \"… m\""),
    // Bond
    bad(BOND, "bond = { stiffness = \"10 GPa\" }", "{ stiffness", "`strength` is missing", "strength = \"… kN/m\""),
    bad(BOND, "bond = { strength = \"100 kN/m\" }", "{ strength", "`stiffness` is missing", "stiffness = \"… GPa\""),
    bad(BOND, "bond = { stiffness = \"10 GPa\", strength = \"300 kN\" }", "\"300 kN\"", "is a force (`kN`), a force per length is expected", "300 kN/m"),
    bad(BOND, "bond = { stiffness = \"10 GPa/m\", strength = \"300 kN/m\" }", "\"10 GPa/m\"", "a stress or modulus is expected", "GPa"),
    bad(BOND, "bond = { stiffness = 0, strength = \"300 kN/m\" }", "0,", "`stiffness` must be above 0", "above 0"),
    bad(BOND, "bond = { stiffness = \"10 GPa\", strength = \"300 kN/m\", friction_angle = 25 }", "25", "has no unit", "deg"),
    bad(BOND, "bond = { stiffness = \"10 GPa\", strength = \"300 kN/m\", friction_angle = \"85 deg\" }", "\"85 deg\"", "from 0 to 80 deg", "80 deg"),
    bad(BOND, "bond = { stiffness = \"10 GPa\", strength = \"300 kN/m\", segment = 0 }", "0 }", "`segment` must be above 0", "above 0"),
    bad(BOND, "bond = { stiffnes = 1e10, stiffness = \"10 GPa\", strength = \"300 kN/m\" }", "stiffnes", "no key of", "did you mean `stiffness`?"),
    bad(BOND, "bond = true", "true", "`bond` should be a table", "bond = { stiffness"),
    // Monitors
    bad("bolt = \"spot\"", "bolt = \"sopt\"", "\"sopt\"", "there are no bolts `sopt`", "did you mean \"spot\"?"),
    bad("bolt = \"spot\"", "bolt = \"anything\"", "\"anything\"", "there are no bolts `anything`", "known bolts: spot, systematic 1"),
    bad("bolt = \"spot\"", "bolt = \"spot\"\ninterface = \"lining-rock\"", "bolt", "`bolt` has a meaning only without `interface`", "leave it out"),
    bad("bolt = \"spot\"", "bolt = \"spot\"\nbody = \"rock\"", "body", "`body` has a meaning only without `interface` and `bolt`", "leave it out"),
    bad("between = [\"free\", \"A\"]", "between = [\"free\", \"anchor\"]", "\"anchor\"", "keeps the force of a bolt", "without `bolt`"),
];

#[test]
fn each_mistake_in_bolts_is_reported_once_at_its_place_with_a_way_out() {
    let failures: Vec<String> = BAD.iter().filter_map(Bad::failure).collect();
    assert!(failures.is_empty(), "{} of {}:\n{}", failures.len(), BAD.len(), failures.join("\n\n"));
}

#[test]
fn a_monitor_on_bolts_that_were_refused_is_no_second_problem() {
    let refused = GOOD.replace("name = \"spot\"", "name = 3");
    let report = parse(&refused).expect_err("no name");
    // They are then called after the stage, so the monitor's name is not known: the first problem says why.
    assert!(report.problems.iter().any(|p| p.message.contains("`name` should be a text")), "{report}");
    let (head, rest) = GOOD.split_once("[[stage.bolts]]").expect("bolts");
    let (_, tail) = rest.split_once("[[stage]]").expect("a second stage");
    let report = parse(&format!("{head}bolts = 3\n[[stage]]{tail}")).expect_err("no bolts");
    let [problem] = &report.problems[..] else { panic!("{report}") };
    assert!(problem.message.contains("`bolts` should be a list of tables or a table"), "{report}");
}
