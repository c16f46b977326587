//! `tremolite check --json`: the same as its text, for programs; and what it foretells comes true.

use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};

fn tremolite(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tremolite")).current_dir(folder).args(args).output().unwrap()
}

/// A new case whose text was changed, and what check says of it: the object and the messages.
fn check(folder: &Path, changes: &[(&str, &str)]) -> (Value, String) {
    assert!(tremolite(folder, &["new", "study"]).status.success());
    let case = folder.join("study/case.toml");
    let mut text = std::fs::read_to_string(&case).unwrap();
    for (from, to) in changes {
        assert!(text.contains(from), "the case has no '{from}'");
        text = text.replacen(from, to, 1);
    }
    std::fs::write(&case, text).unwrap();
    let output = tremolite(folder, &["check", "study/case.toml", "--json"]);
    let errors = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(0), "{errors}");
    (serde_json::from_slice(&output.stdout).unwrap(), errors)
}

#[test]
fn one_object_holds_all_that_the_text_says_and_messages_stay_on_standard_error() {
    let folder = tempfile::tempdir().unwrap();
    let slow = (
        "sides    = { x = \"free-field\", y = \"periodic\" }",
        "sides    = { x = \"free-field\", y = \"periodic\" }\ntime_step = \"1 ms\"",
    );
    let (found, errors) = check(folder.path(), &[slow]);
    let text = String::from_utf8(tremolite(folder.path(), &["check", "--verbose", "study/case.toml"]).stdout)
        .unwrap();
    let number = |pointer: &str| found.pointer(pointer).and_then(Value::as_f64).expect(pointer);
    let word = |pointer: &str| found.pointer(pointer).and_then(Value::as_str).expect(pointer);
    for line in [
        word("/title").to_owned(),
        format!("{} elements ({} excavated)", number("/elements"), number("/excavated")),
        format!("{} nodes", number("/nodes")),
        format!("{:.4e} s stable, set by {}", number("/time_step/stable"), word("/time_step/set_by")),
        format!("{:.4e} s used, {} steps", number("/time_step/used"), number("/time_step/steps")),
        format!("could run at {:.3e} s", number("/regions/0/could_run_at")),
        format!("the incident wave is {} times", number("/motion/incident_factor")),
        format!("{:.1} elements a shear wave", number("/motion/elements_per_wavelength")),
        format!("fewest in {}", word("/motion/coarsest")),
        format!("{} field files of", number("/estimate/field_files") + number("/estimate/stage_files")),
        format!("{} = {}", word("/defaults_used/0/key"), word("/defaults_used/0/value")),
    ] {
        assert!(text.contains(&line), "'{line}' is missing:\n{text}");
    }
    assert_eq!(number("/materials/rock/density"), 27e3 / 9.81);
    assert!(number("/groups/rock") > 100.0 && number("/estimate/memory_bytes") > 1e6);
    assert!(number("/estimate/seconds") > 0.0 && number("/motion/peaks/x/pgv") > 0.1);
    let findings = found["findings"].as_array().unwrap();
    let step = findings.iter().find(|f| f["message"].as_str().unwrap().contains("above the stable step"));
    let line = step.unwrap()["line"].as_u64().unwrap();
    assert!(errors.contains(&format!("case.toml:{line}:")), "{errors}");
}

#[test]
fn results_take_no_more_than_the_disk_that_was_foretold() {
    let folder = tempfile::tempdir().unwrap();
    let (found, _) = check(folder.path(), &[("duration = \"1.5 s\"", "duration = \"0.3 s\"")]);
    let told = |key: &str| found["estimate"][key].as_u64().unwrap();
    let run = tremolite(folder.path(), &["run", "study/case.toml", "--out", "out"]);
    assert!(run.status.success());
    let size = |name: &str| std::fs::metadata(folder.path().join("out").join(name)).unwrap().len();
    let files = std::fs::read_dir(folder.path().join("out/fields")).unwrap().count() as u64;
    assert_eq!(files, told("field_files"));
    let last = size(&format!("fields/{:06}.vtu", files - 1));
    // The case is the same along its axis, which compresses to less than half.
    assert!(last <= told("field_file_bytes") && last > told("field_file_bytes") / 4, "{last}: {found:#}");
    // Zeros before the wave arrives are short.
    let tables = ["monitors.csv", "energy.csv", "free_field.csv", "spectra.csv", "depth.csv"]
        .map(size)
        .iter()
        .sum::<u64>();
    assert!(tables <= told("histories_bytes") && tables > told("histories_bytes") / 2, "{tables}: {found:#}");
    let total = (told("field_files") + told("stage_files")) * told("field_file_bytes");
    assert_eq!(told("disk_bytes"), total + told("histories_bytes") + told("checkpoint_bytes"));
}

#[test]
fn bolts_of_a_pattern_are_written_so_that_a_case_reads_them() {
    let temp = tempfile::tempdir().unwrap();
    let of = |place: &str, folder: &str| {
        let steel = "diameter = \"25 mm\", plate = true, free_length = \"1 m\", bond = { stiffness = \"1 GPa\", strength = \"100 kN/m\" }";
        let bolts = format!("release = 0.6\nbolts = {{ name = \"b/1\", {place}, {steel} }}");
        let stages = crate::stage_case::STAGES.replace("release = 0.6", &bolts);
        crate::stage_case::case(temp.path(), crate::stage_case::LATERAL, &stages, "");
        let output = crate::stage_case::tremolite(temp.path(), &["check", "case.toml", "--bolts", folder]);
        assert_eq!(crate::stage_case::code(&output), 0, "{}", crate::stage_case::errors(&output));
        std::fs::read_to_string(temp.path().join(folder).join("b_1.csv")).unwrap()
    };
    let pattern = of("pattern = \"walls\", spacing = \"1.5 m\", length = \"3 m\"", "first");
    assert!(pattern.starts_with("x1,y1,z1,x2,y2,z2\n") && pattern.lines().count() > 5, "{pattern}");
    assert_eq!(of("file = \"first/b_1.csv\"", "second"), pattern);
}

/// The walls are drained by the excavation, and stay so behind the lining.
#[test]
fn a_new_case_with_water_tells_what_flows_to_its_hall() {
    let folder = tempfile::tempdir().unwrap();
    assert!(tremolite(folder.path(), &["new", "--water", "wet"]).status.success());
    let output = tremolite(folder.path(), &["check", "wet/case.toml", "--json"]);
    assert!(output.status.success(), "{}", crate::stage_case::errors(&output));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    let flow = |stage: usize, key: &str| found["stages"][stage]["seepage"][key].clone();
    let inflow = flow(1, "inflow").as_f64().unwrap();
    assert!(inflow > 0.0 && flow(1, "mass_error").as_f64().unwrap() < 1e-6, "{}", found["stages"][1]);
    let taken = |stage: usize| flow(stage, "taken").as_object().cloned().unwrap();
    let all: f64 = taken(1).values().map(|q| q.as_f64().unwrap()).sum();
    assert!(taken(1).len() == 3 && (all / inflow - 1.0).abs() < 1e-6);
    // The floor has no lining, and the walls behind it stay drained: all the water still comes in.
    assert_eq!(taken(2).keys().collect::<Vec<_>>(), ["hall.*", "hall.bench*"]);
    assert!((flow(2, "inflow").as_f64().unwrap() / inflow - 1.0).abs() < 0.05);
    let lines = tremolite(folder.path(), &["check", "wet/case.toml"]).stdout;
    let lines = String::from_utf8(lines).unwrap();
    assert!(lines.contains("seepage: hall.bench* ") && lines.contains(" l/s); mass error "), "{lines}");
}

#[test]
fn what_ranks_would_share_is_said_in_lines_and_in_the_object() {
    let folder = tempfile::tempdir().unwrap();
    assert!(tremolite(folder.path(), &["new", "study"]).status.success());
    let said = |ranks: &str| {
        let output = tremolite(folder.path(), &["check", "study/case.toml", "--json", "--ranks", ranks]);
        let found: Value = serde_json::from_slice(&output.stdout).unwrap();
        found["ranks"].clone()
    };
    let number = |of: &Value, pointer: &str| of.pointer(pointer).and_then(Value::as_f64).expect(pointer);
    let alone = said("1");
    assert_eq!(number(&alone, "/efficiency"), 1.0);
    assert_eq!([number(&alone, "/imbalance"), number(&alone, "/seconds/messages")], [1.0, 0.0]);
    let three = said("3");
    let rows = three["of_rank"].as_array().unwrap();
    let work: f64 = rows.iter().map(|row| number(row, "/work")).sum();
    assert!(rows.len() == 3 && (work - 1.0).abs() < 1e-12, "{three}");
    assert!(rows.iter().all(|row| number(row, "/bytes") > 0.0 && number(row, "/neighbours") >= 1.0));
    // Rows are of the first rank alone, so three machines are never used whole.
    assert!((0.0..1.0).contains(&number(&three, "/efficiency")), "{three}");
    assert!(number(&three, "/seconds/messages") > 0.0);
    let lines = tremolite(folder.path(), &["check", "study/case.toml", "--ranks", "3"]).stdout;
    let lines = String::from_utf8(lines).unwrap();
    for words in
        ["ranks 3", "if each rank had a machine like this one to itself", "Not measured", "neighbours"]
    {
        assert!(lines.contains(words), "'{words}' is missing:\n{lines}");
    }
}

/// What is refused has its key, its line and its remedy, and what was found unusual before stands beside it.
#[test]
fn a_refused_case_prints_one_object_with_its_problems() {
    let folder = tempfile::tempdir().unwrap();
    assert!(tremolite(folder.path(), &["new", "study"]).status.success());
    let case = folder.path().join("study/case.toml");
    let text = std::fs::read_to_string(&case).unwrap();
    let object = |args: &[&str]| -> Value {
        let output = tremolite(folder.path(), args);
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        assert!(!output.stderr.is_empty());
        serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{args:?}: {e}"))
    };
    std::fs::write(&case, text.replace("poisson     = 0.25", "poisson     = 0.75")).unwrap();
    let found = object(&["check", "study/case.toml", "--json"]);
    assert_eq!(found["file"], "study/case.toml");
    let [problem] = &found["refused"].as_array().unwrap()[..] else { panic!("{found:#}") };
    assert_eq!(problem["key"], "material.rock.poisson");
    let line = 1 + text.lines().position(|line| line.contains("poisson     = 0.25")).unwrap();
    assert_eq!(problem["line"].as_u64(), Some(line as u64), "{problem:#}");
    assert!(
        !problem["message"].as_str().unwrap().is_empty() && !problem["remedy"].as_str().unwrap().is_empty()
    );

    // From --set there is no line.
    std::fs::write(&case, &text).unwrap();
    let set = ["check", "study/case.toml", "--json", "--set", "material.rock.poisson=0.75"];
    let problem = &object(&set)["refused"][0];
    assert!(problem["line"].is_null() && problem["set"].as_str().unwrap().contains("poisson"), "{problem:#}");

    // A case that is not there, a record that cannot be read, an option that cannot be.
    let gone = object(&["check", "study/gone.toml", "--json"]);
    assert_eq!(gone["refused"].as_array().unwrap().len(), 1, "{gone:#}");
    std::fs::write(folder.path().join("study/pulse.txt"), "no record").unwrap();
    let record = object(&["check", "study/case.toml", "--json"]);
    assert_eq!(record["refused"][0]["key"], "motion.east.file", "{record:#}");
    let option = object(&["check", "study/case.toml", "--json", "--set", "nothing"]);
    assert!(!option["refused"][0]["message"].as_str().unwrap().is_empty(), "{option:#}");
    // As of other commands with --json.
    let mesh = object(&["mesh", "info", "gone.msh", "--json"]);
    assert!(mesh["refused"][0]["message"].as_str().unwrap().contains("gone.msh"), "{mesh:#}");
}
