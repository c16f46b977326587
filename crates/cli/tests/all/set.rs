//! `--set`: other values at keys of a case, as a user gives them.

use crate::stage_case::{LATERAL, SHAKING, STAGES, bytes, case, code, errors, run, same, tremolite};
#[cfg(unix)]
use crate::stages::wait_for;
use serde_json::Value;
use std::path::Path;
#[cfg(unix)]
use std::process::Command;

/// Every field of the summary that is not about the clock or the command line.
fn lasting(folder: &Path, out: &str) -> Value {
    fn forget(value: &mut Value) {
        match value {
            Value::Object(fields) => {
                fields.retain(|key, _| {
                    let clock = key.ends_with("seconds") || key == "element_updates_per_second";
                    !clock && key != "command" && key != "started"
                });
                fields.values_mut().for_each(forget);
            }
            Value::Array(entries) => entries.iter_mut().for_each(forget),
            _ => {}
        }
    }
    let mut summary = serde_json::from_slice(&bytes(folder, out, "summary.json")).unwrap();
    forget(&mut summary);
    summary
}

#[test]
fn a_run_with_other_values_is_that_of_the_edited_file() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    case(folder, LATERAL, STAGES, SHAKING);
    let set = [
        "--set",
        "material.concrete.young=25 GPa",
        "--set",
        "stage[*].release=0.5",
        "--set",
        "stage[water].release=1",
        "--set",
        "initial.lateral={ x = 0.6, y = 0.4 }",
        "--set",
        "motion.north={ from = \"east\", factor = 0.5 }",
    ];
    let done = run(folder, "set", &set);
    assert_eq!(code(&done), 0, "{}", errors(&done));

    let path = folder.join("case.toml");
    let original = std::fs::read_to_string(&path).unwrap();
    let mut edited = original.clone();
    for (from, to) in [
        ("young = \"20 GPa\"", "young = \"25 GPa\""),
        ("release = 0.6", "release = 0.5"),
        ("install = [\"shell\"]\n", "install = [\"shell\"]\nrelease = 0.5\n"),
        ("pressure = { shell = \"20 kPa\" }\n", "pressure = { shell = \"20 kPa\" }\nrelease = 1\n"),
        ("lateral = 0.5", "lateral = { x = 0.6, y = 0.4 }"),
        (
            "processing = [\"baseline\"]\n",
            "processing = [\"baseline\"]\nnorth = { from = \"east\", factor = 0.5 }\n",
        ),
    ] {
        assert_eq!(edited.matches(from).count(), 1, "{from}");
        edited = edited.replace(from, to);
    }
    assert_eq!(String::from_utf8(bytes(folder, "set", "case.toml")).unwrap(), edited);
    std::fs::write(&path, &edited).unwrap();
    let done = run(folder, "edited", &[]);
    assert_eq!(code(&done), 0, "{}", errors(&done));
    let tables = ["monitors.csv", "stages.csv", "energy.csv", "sections.csv", "motion.csv"];
    same(folder, "set", "edited", &tables);
    for fields in ["fields", "stages"] {
        let files = std::fs::read_dir(folder.join("edited").join(fields)).unwrap();
        let names: Vec<String> =
            files.map(|f| format!("{fields}/{}", f.unwrap().file_name().display())).collect();
        assert!(names.len() > 1, "{names:?}");
        same(folder, "set", "edited", &names.iter().map(String::as_str).collect::<Vec<_>>());
    }
    assert_eq!(lasting(folder, "set"), lasting(folder, "edited"));

    std::fs::write(&path, &original).unwrap();
    // And without the values the results are others.
    let plain = run(folder, "plain", &[]);
    assert_eq!(code(&plain), 0, "{}", errors(&plain));
    assert_ne!(bytes(folder, "plain", "stages.csv"), bytes(folder, "set", "stages.csv"));
}

#[cfg(unix)]
#[test]
fn a_run_with_other_values_goes_on_with_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    case(folder, &LATERAL.replace("= 50", "= 3000"), STAGES, SHAKING);
    let set = ["--set", "material.concrete.young=25 GPa"];
    let mut child = Command::new(env!("CARGO_BIN_EXE_tremolite"))
        .current_dir(folder)
        .args(["run", "case.toml", "--out", "parts", "--threads", "1"])
        .args(set)
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    wait_for(&folder.join("parts/stages.csv"), &mut child);
    Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(3));
    for other in [&["--resume"][..], &["--resume", "--set", "material.concrete.young=24 GPa"]] {
        let refused = run(folder, "parts", other);
        assert_eq!(code(&refused), 2);
        assert!(errors(&refused).contains("differs from"), "{}", errors(&refused));
    }
    let resumed = run(folder, "parts", &[&set[..], &["--resume"]].concat());
    assert_eq!(code(&resumed), 0, "{}", errors(&resumed));
    let whole = run(folder, "whole", &set);
    assert_eq!(code(&whole), 0, "{}", errors(&whole));
    same(folder, "parts", "whole", &["case.toml", "stages.csv", "monitors.csv", "energy.csv"]);
}

/// What is said of a case, without the places.
fn said(text: &str) -> Vec<&str> {
    text.lines().filter(|line| line.starts_with("error") || line.starts_with("help")).collect()
}

#[test]
fn a_wrong_value_is_refused_as_in_the_file_and_names_the_option() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    case(folder, LATERAL, STAGES, SHAKING);
    let path = folder.join("case.toml");
    let original = std::fs::read_to_string(&path).unwrap();
    for (set, from, to) in [
        ("material.concrete.yuong=1e9", "young = \"20 GPa\"\n", "young = \"20 GPa\"\nyuong = 1e9\n"),
        ("material.concrete.young=25 kN", "\"20 GPa\"", "\"25 kN\""),
        ("material.concrete.young=false", "\"20 GPa\"", "false"),
        ("stage[bench].release=2", "release = 0.6", "release = 2"),
        ("dynamic.sides=roler", "sides = \"viscous\"", "sides = \"roler\""),
        // Found by the model and by the reader of the record.
        ("region[1].groups=[\"shel\"]", "groups = [\"shell\"]", "groups = [\"shel\"]"),
        ("motion.east.file=puls.txt", "\"pulse.txt\"", "\"puls.txt\""),
    ] {
        for command in ["check", "run"] {
            std::fs::write(&path, &original).unwrap();
            let refused = tremolite(folder, &[command, "case.toml", "--set", set]);
            assert_eq!(code(&refused), 2, "{set}");
            let message = errors(&refused);
            assert!(message.contains(&format!("--> --set {set}\n")), "{message}");
            assert!(refused.stdout.is_empty() && !folder.join("results").exists());
            std::fs::write(&path, original.replacen(from, to, 1)).unwrap();
            let edited = tremolite(folder, &[command, "case.toml"]);
            assert_eq!(code(&edited), 2, "{set}");
            assert_eq!(said(&message), said(&errors(&edited)));
            assert!(errors(&edited).contains("--> case.toml:") && !said(&message).is_empty());
        }
    }
    std::fs::write(&path, &original).unwrap();
    for (set, says) in [
        ("stage[floor].release=1", "known are: bench, shell, water"),
        ("material.concrete.young.x=1", "`material.concrete.young` is a text, not a table"),
        ("young", "write KEY=VALUE"),
    ] {
        let refused = tremolite(folder, &["check", "case.toml", "--set", set]);
        assert!(code(&refused) == 2 && errors(&refused).contains(says), "{}", errors(&refused));
        assert!(errors(&refused).contains(&format!("--set {set}")), "{}", errors(&refused));
    }
}

#[test]
fn findings_carry_keys_and_files_lie_beside_the_case() {
    let folder = tempfile::tempdir().unwrap();
    let inner = folder.path().join("study");
    std::fs::create_dir(&inner).unwrap();
    case(&inner, LATERAL, STAGES, SHAKING);
    std::fs::rename(inner.join("pulse.txt"), inner.join("other.txt")).unwrap();
    let checked = |more: &[&str]| -> Value {
        let set = ["check", "study/case.toml", "--json", "--set", "motion.east.file=other.txt"];
        let output = tremolite(folder.path(), &[&set, more].concat());
        assert_eq!(code(&output), 0, "{}", errors(&output));
        serde_json::from_slice(&output.stdout).unwrap()
    };
    let of_step = |found: &Value| {
        let findings = found["findings"].as_array().unwrap();
        let step = findings.iter().find(|f| f["message"].as_str().unwrap().contains("above the stable step"));
        step.unwrap_or_else(|| panic!("{findings:#?}")).clone()
    };
    let found = of_step(&checked(&["--set", "dynamic.time_step=10 ms"]));
    assert_eq!((found["key"].as_str(), &found["line"]), (Some("dynamic.time_step"), &Value::Null));
    assert_eq!(found["set"].as_str(), Some("--set dynamic.time_step=10 ms"));

    crate::stage_case::change(&inner, "[dynamic]\n", "[dynamic]\ntime_step = \"10 ms\"\n");
    let text = std::fs::read_to_string(inner.join("case.toml")).unwrap();
    let line = text.lines().position(|line| line.starts_with("time_step")).unwrap() + 1;
    // Lines that are added above do not count.
    let found =
        of_step(&checked(&["--set", "output.fields=[\"displacement\"]", "--set", "initial.base=roller"]));
    assert_eq!(
        (found["key"].as_str(), found["line"].as_u64()),
        (Some("dynamic.time_step"), Some(line as u64))
    );
    assert_eq!(found["set"], Value::Null);
}
