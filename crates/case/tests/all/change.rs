//! Cases changed by the paths of their keys.

use std::path::Path;

use tremolite_case::{Case, Change, Report, Severity};
use tremolite_laws::materials::MATERIALS;

const GOOD: &str = include_str!("../cases/every-key.toml");

fn read(source: &str, changes: &[(&str, &str)]) -> Result<Case, Report> {
    let changes: Vec<Change> = changes.iter().map(|(key, value)| Change::new(*key, *value)).collect();
    Case::parse_changed(Path::new("case.toml"), source, &changes, MATERIALS)
}

/// The changed text of a good case.
fn changed(source: &str, changes: &[(&str, &str)]) -> String {
    let case = read(source, changes).unwrap_or_else(|report| panic!("{changes:?}\n{report}"));
    // It is a case on its own.
    let alone =
        Case::parse(Path::new("case.toml"), &case.source, MATERIALS).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(format!("{:?}", alone.stages), format!("{:?}", case.stages));
    assert_eq!((alone.materials, alone.defaulted), (case.materials, case.defaulted));
    case.source
}

#[test]
fn values_are_written_at_their_keys_and_nothing_else_changes() {
    let stage = "bench 1, with its lining";
    let by_name = format!("stage[{stage}].release");
    for (key, value, from, to) in [
        ("material.rock.young", "25 GPa", "young = \"10 GPa\"", "young = \"25 GPa\""),
        ("material.rock.young", "\"25 GPa\"", "young = \"10 GPa\"", "young = \"25 GPa\""),
        ("material.concrete.young", "\"26 GPa\"", "young = \"25 GPa\"", "young = \"26 GPa\""),
        ("stage[0].release", "0.4", "release = 0.6", "release = 0.4"),
        (&by_name, "40 %", "release = 0.6", "release = \"40 %\""),
        (
            "interface[lining-rock].friction_coefficient",
            "0.5",
            "friction_coefficient = 0.7",
            "friction_coefficient = 0.5",
        ),
        ("initial.lateral.x", "0.5", "{ x = 0.8, y = 1.2 }", "{ x = 0.5, y = 1.2 }"),
        ("initial.lateral", "0.5", "{ x = 0.8, y = 1.2 }", "0.5"),
        ("initial.lateral", "{ x = 0.8, y = 0.8 }", "{ x = 0.8, y = 1.2 }", "{ x = 0.8, y = 0.8 }"),
        ("stage[0].bolts[spot].bond.segment", "30 cm", "segment = \"20 cm\"", "segment = \"30 cm\""),
        ("stage[1].pressure.\"*.lining\"", "1 kPa", "\"*.lining\" = \"0.2 MPa\"", "\"*.lining\" = \"1 kPa\""),
        ("mesh.caverns.gallery[busbar].at[1]", "15 m", "[\"5 m\", \"14 m\"]", "[\"5 m\", \"15 m\"]"),
        (
            "stage[0].install",
            "[\"*.lining\", \"rock\"]",
            "install = [\"*.lining\"]",
            "install = [\"*.lining\", \"rock\"]",
        ),
    ] {
        assert_eq!(GOOD.matches(from).count(), 1, "{from}");
        assert_eq!(changed(GOOD, &[(key, value)]), GOOD.replace(from, to), "{key}={value}");
    }
    let given = SHORT.replace("name = \"rest\"\n", "name = \"rest\"\nrelease = 0.1 # little\n")
        + "release = \"20 %\"";
    let all = given.replace("0.1", "0.5").replace("\"20 %\"", "0.5");
    assert_eq!(changed(&given, &[("stage[*].release", "0.5")]), all);
    // One after the other.
    let last = all.replacen("release = 0.5", "release = 1.0", 1);
    assert_eq!(changed(&given, &[("stage[*].release", "0.5"), ("stage[0].release", "1.0")]), last);
    assert_eq!(changed(GOOD, &[]), GOOD);
}

const SHORT: &str = r#"# A study of one block.
title = "short" # of a kind

[mesh.box]
x = { from = 0, to = "4 m", elements = 2 }
y = { from = 0, to = "4 m", elements = 2 }
z = { from = 0, to = "4 m", elements = 2 }

[material.rock]
law = "elastic"
young = "10 GPa" # of the core
poisson = 0.25
unit_weight = "27 kN/m3"

[[region]]
groups = ["rock"]
material = "rock"

# Nothing is taken out.
[[stage]]
name = "rest"
[[stage]]
name = "again"
"#;

#[test]
fn keys_that_the_file_leaves_out_are_added_with_their_tables() {
    let title = "title = \"short\" # of a kind\n";
    let behind_title = |line: &str| SHORT.replace(title, &format!("{title}{line}\n"));
    assert_eq!(changed(SHORT, &[("initial.lateral", "0.5")]), behind_title("initial.lateral = 0.5"));
    assert_eq!(
        changed(
            SHORT,
            &[("initial.lateral", "0.5"), ("initial.overburden", "1 MPa"), ("dynamic.sides", "roller")]
        ),
        behind_title("initial.lateral = 0.5\ninitial.overburden = \"1 MPa\"\ndynamic.sides = \"roller\"")
    );
    // A table that is known by the headers of those in it.
    let second = r#"{ law = "elastic", young = "1 GPa", poisson = 0.2, density = "2000 kg/m3" }"#;
    assert_eq!(
        changed(SHORT, &[("material.\"soft.clay\"", second)]),
        behind_title(&format!("material.\"soft.clay\" = {second}"))
    );
    assert_eq!(
        changed(SHORT, &[("stage[*].release", "0.5")]),
        SHORT
            .replace("name = \"rest\"\n", "name = \"rest\"\nrelease = 0.5\n")
            .replace("name = \"again\"\n", "name = \"again\"\nrelease = 0.5\n")
    );
    for braces in ["{}", "{ }"] {
        assert_eq!(
            changed(&behind_title(&format!("initial = {braces}")), &[("initial.lateral", "0.5")]),
            behind_title("initial = { lateral = 0.5 }")
        );
    }
    assert_eq!(
        changed(SHORT, &[("mesh.box.x.growth", "1.1")]),
        SHORT.replacen("elements = 2 }", "elements = 2, growth = 1.1 }", 1)
    );
    // The last line may lack its end, and lines may end as on Windows.
    assert_eq!(changed(SHORT.trim_end(), &[("stage[1].release", "0.5")]), format!("{SHORT}release = 0.5"));
    let windows = |text: &str| text.replace('\n', "\r\n");
    let changes = [("region[0].viscosity", "0.1"), ("initial.lateral", "0.5")];
    assert_eq!(changed(&windows(SHORT), &changes), windows(&changed(SHORT, &changes)));
}

#[test]
fn tables_with_headers_and_lists_of_them_are_replaced_as_a_whole() {
    let stages = r#"[{ name = "one" }]"#;
    let (before, after) = SHORT.split_once("[[stage]]").expect("stages");
    assert!(after.starts_with("\nname"));
    let title = "title = \"short\" # of a kind\n";
    assert_eq!(
        changed(SHORT, &[("stage", stages)]),
        before.replace(title, &format!("{title}stage = {stages}\n"))
    );
    assert_eq!(
        changed(SHORT, &[("stage", stages), ("stage[one].release", "0.5")]),
        before.replace(title, &format!("{title}stage = [{{ name = \"one\", release = 0.5 }}]\n"))
    );
    let lateral = SHORT
        .replace("[[region]]", "[initial]\nlateral.x = 1\nlateral.y = 2\ngravity = \"10 m/s2\"\n[[region]]");
    assert_eq!(
        changed(&lateral, &[("initial.lateral", "0.5")]),
        lateral.replace(
            "lateral.x = 1\nlateral.y = 2\ngravity = \"10 m/s2\"\n",
            "gravity = \"10 m/s2\"\nlateral = 0.5\n"
        )
    );
    let header = SHORT.replace("[[region]]", "[initial.lateral]\nx = 1\ny = 2\n[[region]]");
    let replaced = changed(&header, &[("initial.lateral", "0.5")]);
    assert_eq!(replaced, SHORT.replace(title, &format!("{title}initial.lateral = 0.5\n")));
}

/// The one problem of a changed case.
fn refused(source: &str, key: &str, value: &str) -> (String, String, String, Option<Box<str>>) {
    let Err(report) = read(source, &[(key, value)]) else { panic!("{key}={value} must be refused") };
    let [problem] = &report.problems[..] else { panic!("{key}={value}\n{report}") };
    let text = report.to_string();
    if let Some(set) = &problem.set {
        assert!(text.contains(&format!("--> {set}\n")), "{text}");
    }
    (problem.key.clone(), problem.message.clone(), problem.remedy.clone(), problem.set.clone())
}

#[test]
fn a_bad_value_gets_the_message_of_the_file() {
    for (key, value, from, to) in [
        ("material.rock.yong", "1e9", "young = \"10 GPa\" # of the core", "young = \"10 GPa\"\nyong = 1e9"),
        ("material.rock.young", "25 kN", "\"10 GPa\"", "\"25 kN\""),
        ("material.rock.young", "25 GPx", "\"10 GPa\"", "\"25 GPx\""),
        ("material.rock.young", "true", "\"10 GPa\"", "true"),
        ("material.rock.young", "10", "\"10 GPa\"", "10"),
        ("material.rock.poisson", "0.7", "poisson = 0.25", "poisson = 0.7"),
        ("material.rock.law", "elastik", "\"elastic\"", "\"elastik\""),
        ("stage[0].release", "1.5", "name = \"rest\"", "name = \"rest\"\nrelease = 1.5"),
        ("stage[*].release", "1.5", "name = \"rest\"", "name = \"rest\"\nrelease = 1.5"),
        ("initail.lateral", "1", "# of a kind", "\ninitail.lateral = 1"),
        ("stage[1].name", "rest", "\"again\"", "\"rest\""),
    ] {
        let source = SHORT.replacen(from, to, 1);
        let (key_path, message, remedy, set) = refused(SHORT, key, value);
        assert_eq!(set, Some(format!("{key}={value}").into()));
        let report = Case::parse(Path::new("case.toml"), &source, MATERIALS).expect_err(&source);
        let [problem] = &report.problems[..] else { panic!("{source}\n{report}") };
        assert_eq!((&message, &remedy), (&problem.message, &problem.remedy));
        assert_eq!((&key_path, None), (&problem.key, problem.set.as_ref()), "{message}");
    }
}

#[test]
fn a_path_that_leads_nowhere_is_told_with_those_that_do() {
    for (key, message, remedy) in [
        ("stage[bench 9].release", "there is no stage `bench 9`", "known are: rest, again"),
        ("stage[agian].release", "there is no stage `agian`", "did you mean \"again\"?"),
        ("stage[2].release", "there is no `stage[2]`: the list has 2", "from 0 to 1"),
        (
            "stage.release",
            "`stage` is a list of 2",
            "stage[*].release, one by its number, stage[0].release, or one by its name, stage[rest].release",
        ),
        ("stage[0]", "`stage[0]` is a table with a header", "one by one"),
        ("title.short", "`title` is a text, not a table", "`title` itself"),
        ("material.rock.young.value", "`material.rock.young` is a text, not a table", "set"),
        ("material.rok.young", "there is no material `rok`", "did you mean \"rock\"? Known are: rock"),
        ("material[0].young", "`material` is no list", "leave the brackets out"),
        ("interface[0].friction_coefficient", "there is no list `interface`", "add it"),
        ("stage[0].bolts[a].length", "there is no list `stage[0].bolts`", "add it"),
        ("region[rock].material", "there is no region `rock`", "none has a name"),
        ("stage[0", "`stage[0` is no path of a key: a bracket is not closed", "stage[0].release"),
        ("", "is no path of a key", "dots"),
    ] {
        let (key_path, says, way_out, set) = refused(SHORT, key, "1");
        assert!(says.contains(message) && way_out.contains(remedy), "{key}: {says}; {way_out}");
        assert_eq!((key_path.as_str(), set), (key, Some(format!("{key}=1").into())));
    }
    let braces = SHORT.replace("title =", "initial = { lateral.x = 1, lateral.y = 1 }\ntitle =");
    let (_, says, ..) = refused(&braces, "initial.lateral", "1");
    assert!(says.contains("stands in braces as several keys"), "{says}");
}

#[test]
fn problems_of_changes_and_of_the_file_are_told_at_once_each_at_its_place() {
    // A line is added above that of the file's problem.
    let source = SHORT.replace("poisson = 0.25", "poison = 0.25");
    let changes = [("initial.lateral", "a"), ("stage[7].release", "1"), ("material.rock.young", "10 N")];
    let report = read(&source, &changes).expect_err("bad");
    let told: Vec<(Option<&str>, &str, usize)> = report
        .problems
        .iter()
        .map(|p| (p.set.as_deref(), p.key.as_str(), report.position(p).0))
        .filter(|(set, key, _)| set.is_some() || key.ends_with("poison"))
        .collect();
    let line = source.lines().position(|line| line.starts_with("poison")).expect("a line") + 1;
    assert!(told.contains(&(None, "material.rock.poison", line)), "{told:?}\n{report}");
    for (key, value) in changes {
        let given = format!("{key}={value}");
        assert!(told.iter().any(|(set, path, _)| *set == Some(given.as_str()) && *path == key), "{told:?}");
    }
    assert!(report.to_string().contains("poison = 0.25\n"), "the file's line is shown\n{report}");
}

#[test]
fn a_changed_case_can_be_changed_again() {
    let case = read(SHORT, &[("stage[0].release", "0.5")]).unwrap_or_else(|e| panic!("{e}"));
    let again =
        case.with(&[Change::new("stage[1].release", "0.25")], MATERIALS).unwrap_or_else(|e| panic!("{e}"));
    let releases: Vec<f64> = again.stages.iter().map(|stage| stage.release.value).collect();
    assert_eq!(releases, [0.5, 0.25]);
    let report = again.with(&[Change::new("stage[1].relaese", "1")], MATERIALS).expect_err("no such key");
    assert!(report.to_string().contains("did you mean `release`?"), "{report}");
}

#[test]
fn faults_carry_the_paths_of_their_keys() {
    for (from, to, key) in [
        ("young = \"10 GPa\"", "young = \"10 N\"", "material.rock.young"),
        ("young = \"10 GPa\" # of the core\n", "", "material.rock.young"),
        ("name = \"again\"\n", "", "stage[1].name"),
        ("name = \"again\"", "name = \"rest\"", "stage[1].name"),
        ("name = \"again\"", "name = \"again\"\nrelease = 2", "stage[1].release"),
        ("groups = [\"rock\"]", "groups = [\"rock\", \"rock\"]", "region[0].groups[1]"),
        ("name = \"again\"", "name = \"again\"\nmaterial = { rock = \"clay\" }", "stage[1].material.rock"),
        ("elements = 2 }\ny", "element = 2 }\ny", "mesh.box.x.element"),
        ("[material.rock]", "[material.\"rock.a\"]", "region[0].material"),
        ("title = \"short\"", "", "title"),
    ] {
        let source = SHORT.replacen(from, to, 1);
        assert_ne!(source, SHORT);
        let report = Case::parse(Path::new("case.toml"), &source, MATERIALS).expect_err(&source);
        assert!(report.problems.iter().any(|problem| problem.key == key), "{key}: {:?}", report.problems);
        assert_eq!(report.severity, Severity::Error);
    }
    // Warnings as well.
    let unused = SHORT.replace(
        "[[region]]",
        "[material.\"a.b\"]\nlaw = \"elastic\"\nyoung = \"1 GPa\"\npoisson = 0.2\ndensity = \"2000 kg/m3\"\n[[region]]",
    );
    let case = read(&unused, &[]).unwrap_or_else(|e| panic!("{e}"));
    let keys: Vec<&str> = case.warnings.iter().map(|warning| warning.key.as_str()).collect();
    assert_eq!(keys, ["material.\"a.b\""]);
}

/// Every change to a case either gives a case that stands alone or is refused with words.
#[test]
fn hostile_changes_are_refused_with_words() {
    let keys = [
        "",
        "a",
        "stage",
        "stage[*]",
        "stage[0].a.b.c",
        "material",
        "material.rock",
        "mesh",
        "title.\"\u{1}\"",
        "mesh.box",
        "\u{feff}",
    ];
    let values = [
        "",
        "{",
        "[[[[",
        "{ a = 1, a = 2 }",
        "\"\"\"\n\"\"\"",
        "[\n1, # one\n2 ]",
        "1 2",
        "=",
        "\u{0}",
        "nan",
        "1979-05-27",
    ];
    for source in [SHORT, GOOD, "", "title = ", "\u{feff}title = \"a\""] {
        for key in keys {
            for value in values {
                if let Err(report) = read(source, &[(key, value), (key, "{ b = 1 }")]) {
                    assert!(report.problems.iter().all(|p| !p.message.is_empty()), "{key}={value}");
                    assert!(!report.to_string().is_empty());
                }
            }
        }
    }
}
