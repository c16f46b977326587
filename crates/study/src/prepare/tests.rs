use super::*;
use std::fs;
use tremolite_laws::interfaces::INTERFACES;
use tremolite_laws::materials::MATERIALS;

const CASE: &str = r#"title = "t"
[mesh.box]
group = "rock"
x = { from = 0, to = "1 m", elements = 1 }
y = { from = 0, to = "1 m", elements = 1 }
z = { from = 0, to = "1 m", elements = 1 }
[material.rock]
law = "elastic"
young = "2 GPa" # soft
poisson = 0.25
density = "2500 kg/m3"
[[region]]
groups = ["rock"]
material = "rock"
element = "reduced-integration"
[motion]
kind = "incident"
processing = ["detrend linear"]
[motion.east]
file = "own.txt"
[dynamic]
base = "viscous"
sides = "periodic"
"#;

fn laws() -> Laws<'static> {
    static INFOS: std::sync::OnceLock<(Vec<tremolite_laws::LawInfo>, Vec<tremolite_laws::LawInfo>)> =
        std::sync::OnceLock::new();
    let (materials, interfaces) = INFOS.get_or_init(|| (MATERIALS.to_vec(), INTERFACES.to_vec()));
    Laws { materials, interfaces }
}

/// A folder with a case in `cases`, records in `records`, and the study in `studies`.
fn study(text: &str) -> (tempfile::TempDir, StudyFile) {
    let folder = tempfile::tempdir().unwrap();
    for sub in ["cases", "records", "studies"] {
        fs::create_dir(folder.path().join(sub)).unwrap();
    }
    fs::write(folder.path().join("cases/case.toml"), CASE).unwrap();
    fs::write(folder.path().join("cases/own.txt"), "").unwrap();
    fs::write(folder.path().join("records/a.txt"), "").unwrap();
    let path = folder.path().join("studies/study.toml");
    fs::write(&path, format!("title = \"t\"\ncase = \"../cases/case.toml\"\n{text}")).unwrap();
    let study = StudyFile::read(&path).unwrap_or_else(|e| panic!("{e}"));
    (folder, study)
}

#[test]
fn a_record_takes_the_place_of_the_cases_and_all_is_scaled_once() {
    let (_folder, study) = study(
        "[[record]]\nname = \"a\"\neast = { file = \"../records/a.txt\", units = \"g\" }\n[scale]\nmeasure = \"PGA\"\nlevels = [\"1 g\"]\n",
    );
    let base = base(&study, laws()).unwrap_or_else(|e| panic!("{e}"));
    let case = with_motion(&study, &base, Some(0), Some(0.5), laws()).unwrap_or_else(|e| panic!("{e}"));
    let motion: Vec<(String, String)> = case.entries("motion");
    let pair = |a: &str, b: &str| (a.to_owned(), b.to_owned());
    assert_eq!(
        motion,
        [
            pair("east", "{ file = \"../records/a.txt\", units = \"g\" }"),
            pair("kind", "\"incident\""),
            pair("processing", "[\"detrend linear\", \"scale 0.5\"]"),
        ]
    );
    // What is kept of it is text, with all else of the file as it was.
    assert!(
        case.source.contains("young = \"2 GPa\" # soft") && !case.source.contains("own.txt"),
        "{}",
        case.source
    );
    // Without a record the case's own stays.
    let own = with_motion(&study, &base, None, Some(2.0), laws()).unwrap_or_else(|e| panic!("{e}"));
    assert!(own.bare(&[]).contains("east = { file = \"own.txt\" }"), "{}", own.source);
    assert_eq!(own.bare(&["motion"]), base.bare(&["motion"]));
    assert!(own.placed().contains("/cases/own.txt"));
}

#[test]
fn a_value_that_the_case_refuses_is_told_at_its_line_of_the_study() {
    for (text, line, says) in [
        ("[set]\n\"material.rock.yuong\" = \"3 GPa\"\n", 4, "did you mean `young`?"),
        ("[set]\n\"material.rock.young\" = \"3 m\"\n", 4, "`young`"),
        ("[set]\n\"stage[*].release\" = 0.5\n", 4, "no list `stage`"),
    ] {
        let (_folder, study) = study(text);
        let told = base(&study, laws()).expect_err(text).to_string();
        assert!(told.contains(&format!("study.toml:{line}")) && told.contains(says), "{told}");
    }
    let (_folder, study) = study(
        "[vary]\n\"material.rock.poisson\" = { values = [0.2, 0.6] }\n[sample]\nkind = \"one-at-a-time\"\n",
    );
    let plan = Plan::of(&study, None).unwrap();
    let base = base(&study, laws()).unwrap();
    assert!(sample(&study, &plan, &base, 1, laws()).is_ok());
    let told = sample(&study, &plan, &base, 2, laws()).expect_err("0.6").to_string();
    assert!(told.contains("study.toml:4") && told.contains("material.rock.poisson = 0.6"), "{told}");
}

/// Where a change makes a line of the case wrong that it does not touch, it is named, and not the first that the study has.
#[test]
fn what_a_change_makes_wrong_elsewhere_is_told_at_the_change() {
    let (_folder, study) = study(
        "[set]\n\"material.rock.density\" = \"2600 kg/m3\"\n\"material.rock.law\" = \"mohr-coulomb\"\n\"material.rock.young\" = \"3 GPa\"\n",
    );
    let told = base(&study, laws()).expect_err("without cohesion").to_string();
    assert!(told.contains("study.toml:5:") && told.contains("in line 7 of"), "{told}");
    assert!(told.contains("with `material.rock.law = \"mohr-coulomb\"`"), "{told}");
    assert!(!told.contains("study.toml:4:"), "{told}");
}

#[test]
fn files_that_are_not_there_are_told() {
    let (_folder, gone) = study("[[record]]\nname = \"a\"\neast = { file = \"../records/b.txt\" }\n");
    let base_of = base(&gone, laws()).unwrap();
    let told = with_motion(&gone, &base_of, Some(0), None, laws()).expect_err("gone").to_string();
    assert!(told.contains("study.toml:4") && told.contains("b.txt"), "{told}");
    let (folder, gone) = study("");
    fs::remove_file(folder.path().join("cases/case.toml")).unwrap();
    let told = base(&gone, laws()).expect_err("gone").to_string();
    assert!(told.contains("study.toml:2") && told.contains("there is no file"), "{told}");
}
