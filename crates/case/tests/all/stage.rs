//! Stages before the earthquake, and cases without one: what is read, what is left out, what is refused.

use std::path::Path;

use tremolite_case::{Base, Case, Fill, Report, Side, Spanned};
use tremolite_laws::materials::MATERIALS;

use crate::problems::{Bad, bad};

const GOOD: &str = include_str!("../cases/every-key.toml");

fn parse(source: &str) -> Result<Case, Report> {
    Case::parse(Path::new("case.toml"), source, MATERIALS)
}

fn read(source: &str) -> Case {
    parse(source).unwrap_or_else(|e| panic!("{e}"))
}

fn texts(texts: &[Spanned<String>]) -> Vec<&str> {
    texts.iter().map(|t| t.value.as_str()).collect()
}

#[test]
fn every_value_of_a_stage_arrives_in_the_order_of_the_file() {
    let case = read(GOOD);
    let [bench, filled] = &case.stages[..] else { panic!("two stages") };
    assert_eq!((bench.name.value.as_str(), bench.release.value), ("bench 1, with its lining", 0.6));
    assert_eq!(
        (texts(&bench.excavate), texts(&bench.install)),
        (vec!["transformer.bench*"], vec!["*.lining"])
    );
    assert!(bench.materials.is_empty() && bench.pressures.is_empty());
    assert_eq!((filled.name.value.as_str(), filled.release.value), ("tunnel filled", 1.0));
    assert!(filled.excavate.is_empty() && filled.install.is_empty());
    let materials: Vec<(&str, usize)> =
        filled.materials.iter().map(|(pattern, m)| (pattern.value.as_str(), m.value)).collect();
    assert_eq!(materials, [("transformer.lining", 1), ("rock*", 0)]);
    let (pattern, material) = &filled.materials[1];
    assert_eq!(
        (&case.source[pattern.span.clone()], &case.source[material.span.clone()]),
        ("\"rock*\"", "\"rock\"")
    );
    let pressures: Vec<(&str, f64)> =
        filled.pressures.iter().map(|(pattern, p)| (pattern.value.as_str(), p.value)).collect();
    assert_eq!(pressures, [("*.lining", 0.2e6), ("top", 1000.0)]);
    assert_eq!(&case.source[bench.span.clone()], "[[stage]]");

    let before: Vec<Option<usize>> = case
        .regions
        .iter()
        .map(|region| match &region.fill {
            Fill::Solid { before, .. } => before.as_ref().map(|b| b.value),
            Fill::Void => None,
        })
        .collect();
    assert_eq!(before, [None, Some(0), None]);
}

#[test]
fn tables_with_free_keys_may_have_headers_of_their_own() {
    let inline = "pressure = { \"*.lining\" = \"0.2 MPa\", top = \"1 kPa\" }";
    let case = read(&GOOD.replace(inline, "[stage.pressure]\n\"*.lining\" = \"0.2 MPa\"\ntop = \"1 kPa\""));
    assert_eq!(case.stages[1].pressures.len(), 2);
}

#[test]
fn a_stage_may_do_nothing_but_let_go_of_what_is_held() {
    let case = read(&GOOD.replace("[motion]", "[[stage]]\nname = \"wait\"\n[motion]"));
    let wait = &case.stages[2];
    assert!(wait.excavate.is_empty() && wait.install.is_empty() && wait.materials.is_empty());
    assert_eq!(wait.release.value, 1.0);
    let listed = case.defaulted.iter().find(|d| d.key == "stage[wait].release");
    assert_eq!(listed.map(|d| d.value.as_str()), Some("1"));
}

/// The good case without its earthquake, and with what stands in place of `[dynamic]`.
fn still(dynamic: &str) -> String {
    let (head, rest) = GOOD.split_once("[motion]").expect("a motion");
    let (_, tail) = rest.split_once("[[monitor]]").expect("a monitor");
    format!("{head}{dynamic}[[monitor]]{tail}")
}

#[test]
fn a_case_without_an_earthquake_needs_no_dynamic_run() {
    let case = read(&still(""));
    assert_eq!((case.motion, case.stages.len(), case.monitors.len()), (None, 2, 4));
    let listed = |key: &str| case.defaulted.iter().find(|d| d.key == key).map(|d| d.value.as_str());
    assert_eq!(listed("motion"), Some("no earthquake: the case ends with what comes before it"));
    assert!(case.defaulted.iter().all(|d| !d.key.starts_with("dynamic")), "{:?}", case.defaulted);
    assert!(case.dynamic.base.value == Base::Viscous);
    assert_eq!(case.dynamic.sides.each_ref().map(|s| s.value), [Side::Roller, Side::Roller]);
    assert_eq!((case.dynamic.duration, case.dynamic.band, case.dynamic.safety.value), (None, None, 0.9));

    let case = read(&still("[dynamic]\nsides = \"periodic\"\nbase = \"free\"\n"));
    assert_eq!(case.dynamic.sides.each_ref().map(|s| s.value), [Side::Periodic, Side::Periodic]);
    assert_eq!(case.warnings, [], "no motion is to enter");

    // Intervals of the shaking are not among what is left out.
    let (head, _) = GOOD.split_once("[output]").expect("the output");
    let (before, rest) = head.split_once("[motion]").expect("a motion");
    let (_, tail) = rest.split_once("[[monitor]]").expect("a monitor");
    let keys = |source: &str| {
        read(source)
            .defaulted
            .into_iter()
            .map(|d| d.key)
            .filter(|k| k.starts_with("output"))
            .collect::<Vec<_>>()
    };
    assert_eq!(keys(&format!("{before}[[monitor]]{tail}")), ["output.fields", "output.checkpoint"]);
    assert_eq!(keys(head).len(), 4);
}

#[test]
fn initial_stress_alone_is_something_to_compute_and_nothing_at_all_is_not() {
    let at_a_bolt = "[[monitor]]\nname = \"anchor\"\nat = [0, \"1 m\", \"-205 m\"]\nbolt = \"spot\"\n";
    let source = still("").replace("before = \"rock\"\n", "").replace(at_a_bolt, "");
    let (head, rest) = source.split_once("[[stage]]").expect("stages");
    let (_, tail) = rest.split_once("[[monitor]]").expect("a monitor");
    assert!(read(&format!("{head}[[monitor]]{tail}")).seeks_equilibrium());
    let (head, _) = head.split_once("lateral").expect("initial stress");
    let nothing = format!("{head}[[monitor]]{tail}");
    let report = parse(&nothing).expect_err("nothing to compute");
    let [problem] = &report.problems[..] else { panic!("{report}") };
    assert!(problem.message.contains("nothing to compute"), "{report}");
    assert!(problem.remedy.contains("[motion]") && problem.remedy.contains("[[stage]]"), "{report}");
    // What was meant is there, and refused.
    for written in ["motion = 3\n", "stage = []\n", "initial = 3\n"] {
        let source = format!("{written}{}", nothing.replace("[initial]\ngravity = \"10 m/s2\"\n", ""));
        let report = parse(&source).expect_err(written);
        assert!(report.problems.iter().all(|p| !p.message.contains("nothing to compute")), "{report}");
    }
}

#[test]
fn an_earthquake_needs_its_dynamic_run() {
    let (head, rest) = GOOD.split_once("[dynamic]").expect("a dynamic run");
    let (_, tail) = rest.split_once("[[monitor]]").expect("a monitor");
    let report = parse(&format!("{head}[[monitor]]{tail}")).expect_err("no [dynamic]");
    let [problem] = &report.problems[..] else { panic!("{report}") };
    assert_eq!(problem.message, "`dynamic` is missing in the case");
    assert_eq!(problem.remedy, "add [dynamic] (the dynamic run)");
}

const MATERIAL: &str = "{ \"transformer.lining\" = \"concrete\", \"rock*\" = \"rock\" }";
const PRESSURE: &str = "{ \"*.lining\" = \"0.2 MPa\", top = \"1 kPa\" }";

#[rustfmt::skip]
const BAD: &[Bad] = &[
    // Keys
    bad("name = \"tunnel filled\"\n", "", "[[stage]]", "`name` is missing in `stage[1]`", "add name"),
    bad("name = \"tunnel filled\"", "name = \" \"", "\" \"", "an empty text", "name"),
    bad("name = \"tunnel filled\"", "name = \"bench 1, with its lining\"", "\"bench 1", "stage `bench 1, with its lining` is named twice", "its own name"),
    bad("release = 0.6", "relase = 0.6\nrelease = 0.6", "relase", "no key of `stage[bench 1, with its lining]`", "did you mean `release`?"),
    bad("safety = 0.8", "safety = 0.8\nexcavate = [\"a\"]", "excavate", "no key of `dynamic`", "`excavate` belongs to [stage]"),
    // Values
    bad("release = 0.6", "release = 1.01", "1.01", "must be from 0 to 1", "from 0 to 1"),
    bad("release = 0.6", "release = -0.1", "-0.1", "must be from 0 to 1", "from 0 to 1"),
    bad("release = 0.6", "release = nan", "nan", "not a finite number", "finite"),
    bad("release = 0.6", "release = \"1 s\"", "\"1 s\"", "a pure number is expected", "0.25"),
    bad("excavate = [\"transformer.bench*\"]", "excavate = []", "[]", "a list, each a text, not a list of 0", "excavate = [\"…\"]"),
    bad("excavate = [\"transformer.bench*\"]", "excavate = \"rock\"", "\"rock\"", "should be a list", "excavate = [\"…\"]"),
    bad("install = [\"*.lining\"]", "install = [\"\"]", "\"\"", "an empty text", "install"),
    bad("install = [\"*.lining\"]", "install = [\"*.lining\", \"*.lining\"]", "\"*.lining\"]", "group `*.lining` is named twice", "once in a list"),
    bad("excavate = [\"transformer.bench*\"]", "excavate = [\"transformer.bench*\", \"transformer.bench*\"]", "\"transformer.bench*\"]", "group `transformer.bench*` is named twice", "once in a list"),
    // Tables with free keys
    bad(MATERIAL, "{}", "{}", "should be a table, each value a text", "material = { \"powerhouse.lining*\" = \"…\" }"),
    bad(MATERIAL, "\"rock\"", "\"rock\"", "should be a table, each value a text, not a text", "= { \""),
    bad(MATERIAL, "{ \"a.b\" = 3 }", "3", "`\"a.b\"` should be a text, not a whole number", "\"a.b\" = \"…\""),
    bad(MATERIAL, "{ \"\" = \"rock\" }", "\"\"", "a key of `material` is empty", "name what it is for"),
    bad(MATERIAL, "{ transformer.lining = \"rock\" }", "transformer", "`transformer` should be a text, not a table", "in quotes: \"transformer.lining\" = …"),
    bad(MATERIAL, "{ rock = \"rok\" }", "\"rok\"", "there is no material `rok`", "did you mean \"rock\"?"),
    bad(MATERIAL, "{ rock = \"marble\" }", "\"marble\"", "there is no material `marble`", "add [material.marble]"),
    bad(MATERIAL, "{ rock = \"void\" }", "\"void\"", "makes nothing of no material", "`excavate`"),
    bad(PRESSURE, "{}", "{}", "should be a table", "pressure = { \"powerhouse.lining*\" = \"… MPa\" }"),
    bad(PRESSURE, "\"0.2 MPa\"", "\"0.2 MPa\"", "should be a table", "pressure = {"),
    bad(PRESSURE, "{ top = \"0.2 m\" }", "\"0.2 m\"", "`\"top\"` is a length (`m`), a stress", "such as"),
    bad(PRESSURE, "{ top = nan }", "nan", "`\"top\"` is not a finite number", "finite"),
    bad(PRESSURE, "{ top = { a = 1 } }", "top", "`top` should be a stress or modulus, not a table", "\"top.a\" = …"),
    // What stands there before
    bad("before = \"rock\"", "before = \"rok\"", "\"rok\"", "there is no material `rok`", "did you mean \"rock\"?"),
    bad("before = \"rock\"", "before = \"marble\"", "\"marble\"", "there is no material `marble`", "add [material.marble]"),
    bad("before = \"rock\"", "before = \"void\"", "\"void\"", "is a material", "`excavate`"),
    bad("before = \"rock\"", "before = 3", "3", "should be a text", "before"),
    bad("material = \"void\"", "material = \"void\"\nbefore = \"rock\"", "before", "only where `material` is not \"void\"", "leave it out"),
];

#[test]
fn each_mistake_in_a_stage_is_reported_once_at_its_place_with_a_way_out() {
    let failures: Vec<String> = BAD.iter().filter_map(Bad::failure).collect();
    assert!(failures.is_empty(), "{} of {}:\n{}", failures.len(), BAD.len(), failures.join("\n\n"));
}

#[test]
fn what_stands_before_an_installation_needs_one() {
    let source = GOOD.replace("install = [\"*.lining\"]\n", "");
    let report = parse(&source).expect_err("nothing is installed");
    let [problem] = &report.problems[..] else { panic!("{report}") };
    assert_eq!(&source[problem.span.clone()], "\"rock\"");
    assert!(problem.message.contains("no stage installs anything"), "{report}");
    assert!(
        problem.remedy.contains("leave `before` out") && problem.remedy.contains("install ="),
        "{report}"
    );
    // One that is refused was meant to install.
    let report = parse(&GOOD.replace("install = [\"*.lining\"]", "install = []")).expect_err("an empty list");
    assert_eq!(report.problems.len(), 1, "{report}");
}

#[test]
fn a_group_may_go_and_begin_in_one_stage() {
    let both = "install = [\"*.lining\", \"transformer.bench*\"]";
    let case = read(&GOOD.replace("install = [\"*.lining\"]", both));
    let stage = case.stages.iter().find(|stage| stage.install.len() == 2).expect("the stage");
    assert_eq!(stage.install[1].value, stage.excavate[0].value);
}

#[test]
fn a_material_that_a_stage_brings_is_used() {
    let spare = "[material.spare]\nlaw = \"elastic\"\nyoung = \"10 GPa\"\npoisson = 0\ndensity = \"1 kg/m3\"\n[initial]";
    let source = GOOD.replace("[initial]", spare);
    assert_eq!(read(&source).warnings.len(), 1);
    assert_eq!(read(&source.replace("\"rock*\" = \"rock\"", "\"rock*\" = \"spare\"")).warnings, []);
    assert_eq!(read(&source.replace("before = \"rock\"", "before = \"spare\"")).warnings, []);
}

#[test]
fn ten_thousand_stages_are_read_and_more_are_refused() {
    let many = |n: usize| {
        let stages: String = (0..n).map(|i| format!("[[stage]]\nname = \"s{i}\"\n")).collect();
        GOOD.replace("[motion]", &format!("{stages}[motion]"))
    };
    assert_eq!(read(&many(9_998)).stages.len(), 10_000);
    let report = parse(&many(9_999)).expect_err("too many");
    let [problem] = &report.problems[..] else { panic!("{} problems", report.problems.len()) };
    assert!(
        problem.message.contains("10001 stages") && problem.remedy.contains("at most 10000"),
        "{problem:?}"
    );
}
