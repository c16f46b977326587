//! The command as a user meets it: exit status, files, messages.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;
use tremolite_results::{Status, Summary, Table};

fn tremolite(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tremolite")).current_dir(folder).args(args).output().unwrap()
}

fn code(output: &Output) -> i32 {
    output.status.code().unwrap()
}

fn errors(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// A new case, shorter and coarser so that a run takes a moment.
fn new_case() -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(code(&tremolite(folder.path(), &["new", "study"])), 0);
    let case = folder.path().join("study/case.toml");
    change(&case, "duration = \"1.5 s\"", "duration = \"0.3 s\"");
    change(&case, "size_near  = \"0.8 m\"", "size_near  = \"2 m\"");
    (folder, case)
}

fn change(case: &Path, from: &str, to: &str) {
    let text = std::fs::read_to_string(case).unwrap();
    assert!(text.contains(from), "the case has no '{from}'");
    std::fs::write(case, text.replacen(from, to, 1)).unwrap();
}

#[test]
fn a_new_case_checks_runs_and_reports() {
    let (folder, _) = new_case();
    let check = tremolite(folder.path(), &["check", "--verbose", "study/case.toml"]);
    assert_eq!(code(&check), 0, "{}", errors(&check));
    let text = String::from_utf8(check.stdout).unwrap();
    for word in
        ["hall.lining", "incident wave is 1 times", "stable, set by element", "million element updates"]
    {
        assert!(text.contains(word), "check does not say '{word}':\n{text}");
    }
    assert!(!folder.path().join("results").exists(), "check computes nothing");

    let run = tremolite(folder.path(), &["run", "study/case.toml"]);
    assert_eq!(code(&run), 0, "{}", errors(&run));
    assert!(run.stdout.is_empty(), "messages go to standard error");
    let results = folder.path().join("results/study");
    for file in
        ["case.toml", "summary.json", "monitors.csv", "energy.csv", "fields.pvd", "report.html", "log.txt"]
    {
        assert!(results.join(file).is_file(), "{file}");
    }
    let summary = Summary::read(&results.join("summary.json")).unwrap();
    assert_eq!(summary.conclusion.status, Status::Done);
    assert!(summary.computed.element_updates_per_second > 0.0);
    assert!(summary.monitors.peaks["crown"]["ux"].largest().1.abs() > 1e-6);
    assert!(summary.monitors.relative["crown-wall"]["u"].max > 0.0);
    // What was shortened is seen, and no other check fails.
    let failed: Vec<&str> =
        summary.soundness.checks.iter().filter(|t| !t.pass).map(|t| t.id.as_str()).collect();
    assert_eq!(failed, ["truncated_motion"], "{:?}", summary.soundness.checks);
    assert!(summary.case.defaults_used.iter().any(|d| d.key == "dynamic.safety"));

    // A second run gets a folder of its own; a taken --out is refused, and replaced when asked.
    assert_eq!(code(&tremolite(folder.path(), &["run", "study/case.toml"])), 0);
    assert!(folder.path().join("results/study-2/summary.json").is_file());
    let taken = tremolite(folder.path(), &["run", "study/case.toml", "--out", "results/study"]);
    assert_eq!(code(&taken), 2);
    assert!(errors(&taken).contains("--overwrite"), "{}", errors(&taken));
    let again =
        tremolite(folder.path(), &["run", "study/case.toml", "--out", "results/study", "--overwrite"]);
    assert_eq!(code(&again), 0);

    std::fs::remove_file(results.join("report.html")).unwrap();
    assert_eq!(code(&tremolite(folder.path(), &["report", "results/study"])), 0);
    let page = || std::fs::read_to_string(results.join("report.html")).unwrap();
    assert!(page().contains("A first cavern") && page().contains("<html lang=\"en\">"));
    assert_eq!(code(&tremolite(folder.path(), &["report", "results/study", "--language", "zh"])), 0);
    assert!(page().contains("<html lang=\"zh-CN\">"));
    assert_eq!(code(&tremolite(folder.path(), &["report", "results/study", "--language", "fr"])), 2);

    // Two runs of one case: the same numbers beside one another.
    let compare = ["report", "--compare", "results/study", "results/study-2", "--out", "both.html"];
    assert_eq!(code(&tremolite(folder.path(), &compare)), 0);
    let both = std::fs::read_to_string(folder.path().join("both.html")).unwrap();
    assert!(both.contains("study-2") && both.contains("both folders hold the same case"), "{both}");
    assert_eq!(code(&tremolite(folder.path(), &["report", "--compare", "results/study"])), 2);
    assert_eq!(code(&tremolite(folder.path(), &["report"])), 2);
}

#[test]
fn a_second_run_into_one_folder_is_refused_while_the_first_goes_on() {
    let (folder, case) = new_case();
    change(&case, "duration = \"0.3 s\"", "duration = \"1000 s\"");
    let results = folder.path().join("mine");
    let mut first = Command::new(env!("CARGO_BIN_EXE_tremolite"))
        .current_dir(folder.path())
        .args(["run", "study/case.toml", "--out", "mine"])
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    while !results.join("energy.csv").exists() {
        assert!(first.try_wait().unwrap().is_none(), "the first run has ended");
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    let again = ["run", "study/case.toml", "--out", "mine", "--overwrite"];
    let second = tremolite(folder.path(), &again);
    assert!(first.try_wait().unwrap().is_none() && results.join("energy.csv").exists());
    // Nobody has to clean up behind a run that was killed.
    first.kill().unwrap();
    first.wait().unwrap();
    assert_eq!(code(&second), 2, "{}", errors(&second));
    let said = errors(&second);
    assert!(said.contains("mine: another run is writing into this folder"), "{said}");
    change(&case, "duration = \"1000 s\"", "duration = \"0.3 s\"");
    assert_eq!(code(&tremolite(folder.path(), &again)), 0);
}

#[test]
fn bad_cases_are_refused_at_once_with_all_their_problems_and_nothing_computed() {
    let (folder, case) = new_case();
    change(&case, "poisson     = 0.25", "poisson     = 0.5");
    change(&case, "young       = \"25 GPa\"", "young       = \"25 m\"");
    change(&case, "histories =", "historys =");
    let run = tremolite(folder.path(), &["run", "study/case.toml"]);
    assert_eq!(code(&run), 2);
    let text = errors(&run);
    for word in ["case.toml:26:", "below 0.5", "25 m", "historys", "histories"] {
        assert!(text.contains(word), "'{word}' is missing:\n{text}");
    }
    assert!(!folder.path().join("results").exists());
}

#[test]
fn what_does_not_fit_the_mesh_is_refused_at_its_place() {
    let cases: [(&str, &str, &[&str]); 7] = [
        ("at   = \"hall.crown\"", "at   = [0, 0, \"-300 m\"]", &["monitor crown at", "its body spans"]),
        ("at   = \"hall.crown\"", "at   = \"hall.roof\"", &["no point 'hall.roof'", "hall.crown"]),
        (
            "\"rock\", \"hall.bench*\"]",
            "\"rock\", \"hall.pit*\"]",
            &["no group of the mesh fits", "belong to no region"],
        ),
        (
            "excavate = [\"hall.bench*\"]",
            "excavate = [\"hall.pit*\"]",
            &["no group of the mesh fits", "hall.bench1"],
        ),
        (
            "groups   = [\"rock\",",
            "groups   = [\"rock\", \"hall.lin*\",",
            &["are in the region of", "one region only"],
        ),
        ("base     = \"viscous\"", "base     = \"fixed\"", &["cannot enter through this base"]),
        ("\"displacement\", ", "\"temperature\", ", &["no field 'temperature'", "known are displacement"]),
    ];
    for (from, to, words) in cases {
        let (folder, case) = new_case();
        change(&case, from, to);
        let run = tremolite(folder.path(), &["run", "study/case.toml"]);
        assert_eq!(code(&run), 2, "{to}");
        let text = errors(&run);
        assert!(text.contains("case.toml:"), "{text}");
        for word in words {
            assert!(text.contains(word), "{to}: '{word}' is missing:\n{text}");
        }
        assert!(!folder.path().join("results").exists(), "{to}");
    }
}

#[test]
fn an_unstable_run_is_warned_of_ends_with_status_1_and_names_the_element() {
    for step in ["0.3 ms", "1 s"] {
        let (folder, case) = new_case();
        change(
            &case,
            "sides    = { x = \"free-field\", y = \"periodic\" }",
            &format!("sides    = {{ x = \"free-field\", y = \"periodic\" }}\ntime_step = \"{step}\""),
        );
        let check = tremolite(folder.path(), &["check", "study/case.toml"]);
        assert_eq!(code(&check), 0, "{}", errors(&check));
        let run = tremolite(folder.path(), &["run", "study/case.toml"]);
        assert_eq!(code(&run), 1, "{}", errors(&run));
        for output in [&check, &run] {
            let text = errors(output);
            assert!(text.contains("case.toml:") && text.contains("above the stable step of"), "{text}");
        }
        let text = errors(&run);
        assert!(text.contains("became unstable") && text.contains("element "), "{text}");
        let results = folder.path().join("results/study");
        assert_eq!(Summary::read(&results.join("summary.json")).unwrap().conclusion.status, Status::Failed);
        assert!(Table::read(&results.join("monitors.csv")).unwrap().rows() > 0);
    }
}

#[test]
fn rows_further_apart_than_the_run_is_long_are_refused() {
    let (folder, case) = new_case();
    change(&case, "histories = \"0.005 s\"", "histories = \"5 s\"");
    let check = tremolite(folder.path(), &["check", "study/case.toml"]);
    assert_eq!(code(&check), 2);
    assert!(errors(&check).contains("leave none within the run of 0.300 s"), "{}", errors(&check));
}

#[test]
fn what_was_left_out_is_listed_with_values_and_materials_with_what_their_laws_derive() {
    let (folder, case) = new_case();
    let concrete = "law         = \"concrete-damage\"\ntensile_strength = \"1.2 MPa\"\ncohesion = \"2 MPa\"\n\
                    friction_angle = \"46 deg\"\nyoung       = \"25 GPa\"";
    change(&case, "law         = \"elastic\"\nyoung       = \"25 GPa\"", concrete);
    let check = tremolite(folder.path(), &["check", "--verbose", "study/case.toml"]);
    assert_eq!(code(&check), 0, "{}", errors(&check));
    let text = String::from_utf8(check.stdout).unwrap();
    // 2·2 MPa·cos 46°/(1 − sin 46°) = 9.900 MPa
    for words in [
        "material.concrete.compressive_strength = 9.9 MPa (from the cohesion, else from the grade)",
        "material.concrete.reference_rate = 3e-6 1/s to 3e-5 1/s (that of the rate law)",
        "material.concrete.grade = none (",
        "material.concrete.evolution = exponential",
        "material.concrete.split = compliance",
        // 73·9.900^0.18
        "material.concrete.fracture_energy = 110",
        "threshold_strain 4.8e-5",
        "damping: 2.00 % over 0.5 to 20 Hz",
    ] {
        assert!(text.contains(words), "{words}:\n{text}");
    }
    let run = tremolite(folder.path(), &["run", "study/case.toml"]);
    assert_eq!(code(&run), 0, "{}", errors(&run));
    let results = folder.path().join("results/study");
    let summary = Summary::read(&results.join("summary.json")).unwrap();
    let value = |key: &str| summary.case.defaults_used.iter().find(|d| d.key == key).unwrap().value.clone();
    assert!(value("material.concrete.compressive_strength").starts_with("9.9 MPa ("));
    assert!(value("dynamic.time_step").contains(" µs (") || value("dynamic.time_step").contains(" ms ("));
    let facts = &summary.computed.materials["concrete"];
    assert_eq!((facts.law.as_str(), facts.groups[0].element.as_str()), ("concrete-damage", "layered"));
    let energy = facts.values.iter().find(|v| v.name == "fracture_energy").unwrap();
    assert!((energy.value - 73.0 * 9.9f64.powf(0.18)).abs() < 0.01, "{energy:?}");
    assert!(results.join("damage.csv").is_file());
    assert!(
        std::fs::read_to_string(results.join("report.html")).unwrap().contains("What the law makes of them")
    );
}

#[test]
fn a_new_case_runs_to_its_end_with_concrete_that_cracks() {
    let weak = ("tensile_strength = \"1.2 MPa\"", "tensile_strength = \"0.12 MPa\"");
    let strong = ("[\"detrend linear\"]", "[\"detrend linear\", \"scale 10\"]");
    for (from, to) in [weak, strong] {
        let (folder, case) = new_case();
        change(&case, "duration = \"0.3 s\"", "duration = \"0.8 s\"");
        change(&case, from, to);
        change(&case, "\"elastic\"\nyoung       = \"25 GPa\"", "\"concrete-damage\"\nyoung = \"25 GPa\"");
        for key in ["tensile_strength", "fracture_energy", "cohesion", "friction_angle"] {
            change(&case, &format!("# {key} "), &format!("{key} "));
        }
        let run = tremolite(folder.path(), &["run", "study/case.toml", "--out", "out"]);
        assert_eq!(code(&run), 0, "{to}: {}", errors(&run));
        let summary = Summary::read(&folder.path().join("out/summary.json")).unwrap();
        assert_eq!(summary.conclusion.status, Status::Done, "{to}");
        assert!(summary.parts.damage["hall.lining"].measures["d_tension"].largest > 0.9, "{to}");
        for line in summary.soundness.checks.iter().filter(|line| line.name.contains("energy")) {
            assert!(line.pass, "{to}: {line:?}");
        }
        assert!(
            summary
                .soundness
                .checks
                .iter()
                .any(|line| line.id == "plateau_corner_strength" && line.not_applicable)
        );
    }
}

/// A terminal that is lost sends SIGHUP: the run stops in order. One that ignores it from the start, as under nohup, goes on.
#[cfg(target_os = "linux")]
#[test]
fn a_lost_terminal_stops_with_a_checkpoint_unless_it_is_ignored() {
    let (folder, case) = new_case();
    change(&case, "duration = \"0.3 s\"", "duration = \"0.6 s\"");
    change(
        &case,
        "sides    = { x = \"free-field\", y = \"periodic\" }",
        "sides    = { x = \"free-field\", y = \"periodic\" }\ntime_step = \"0.1 ms\"",
    );
    // Whoever runs the tests may ignore it.
    for (trap, status) in [("exec env --default-signal=HUP ", 3), ("trap '' HUP; exec ", 0)] {
        let program = env!("CARGO_BIN_EXE_tremolite");
        let out = format!("out{status}");
        let script = format!("{trap}{program} run study/case.toml --out {out} --threads 1");
        let mut child = Command::new("sh")
            .current_dir(folder.path())
            .args(["-c", &script])
            .stderr(std::process::Stdio::null())
            .spawn()
            .unwrap();
        let monitors = folder.path().join(&out).join("monitors.csv");
        for _ in 0..2000 {
            if std::fs::metadata(&monitors).map_or(0, |m| m.len()) > 10_000 {
                break;
            }
            std::thread::sleep(std::time::Duration::from_millis(5));
        }
        Command::new("kill").args(["-HUP", &child.id().to_string()]).status().unwrap();
        assert_eq!(child.wait().unwrap().code(), Some(status), "{trap}");
    }
    assert!(folder.path().join("out3/checkpoint/state.bin").is_file());
    let resumed = tremolite(folder.path(), &["run", "study/case.toml", "--out", "out3", "--resume"]);
    assert_eq!(code(&resumed), 0, "{}", errors(&resumed));
    let bytes = |run: &str| std::fs::read(folder.path().join(run).join("monitors.csv")).unwrap();
    assert!(bytes("out3") == bytes("out0"));
}

#[cfg(unix)]
#[test]
fn a_signal_stops_with_a_checkpoint_and_resume_gives_the_same_histories() {
    let (folder, case) = new_case();
    change(&case, "duration = \"0.3 s\"", "duration = \"1.5 s\"");
    // A small step makes the run long enough to be stopped on the way.
    change(
        &case,
        "sides    = { x = \"free-field\", y = \"periodic\" }",
        "sides    = { x = \"free-field\", y = \"periodic\" }\ntime_step = \"0.05 ms\"",
    );
    let mut child = Command::new(env!("CARGO_BIN_EXE_tremolite"))
        .current_dir(folder.path())
        .args(["run", "study/case.toml", "--out", "stopped", "--threads", "1"])
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    let monitors = folder.path().join("stopped/monitors.csv");
    let rows = || std::fs::metadata(&monitors).map_or(0, |m| m.len());
    for _ in 0..2000 {
        // Results can be read while the run goes on.
        if rows() > 20_000 {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    assert!(rows() > 0, "the run wrote nothing in ten seconds");
    Command::new("kill").args(["-TERM", &child.id().to_string()]).status().unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(3));
    let resumed = ["run", "study/case.toml", "--out", "stopped", "--resume", "--threads", "3"];
    // Not with another case: a law's parameter would change on the way.
    change(&case, "young       = \"10 GPa\"", "young       = \"11 GPa\"");
    let other = tremolite(folder.path(), &resumed);
    assert_eq!(code(&other), 2);
    assert!(errors(&other).contains("from which the run was started"), "{}", errors(&other));
    change(&case, "young       = \"11 GPa\"", "young       = \"10 GPa\"");
    // Nor with a table that was changed meanwhile; what tells it from what the run wrote stays.
    let (sound, sums) = (std::fs::read(&monitors).unwrap(), folder.path().join("stopped/SHA256SUMS"));
    let mut other = sound.clone();
    other[15_000] ^= 1;
    std::fs::write(&monitors, &other).unwrap();
    let refused = tremolite(folder.path(), &resumed);
    assert_eq!(code(&refused), 2, "{}", errors(&refused));
    assert!(errors(&refused).contains("monitors.csv: changed since the checkpoint"), "{}", errors(&refused));
    assert!(std::fs::read(&monitors).unwrap() == other && sums.exists());
    std::fs::write(&monitors, sound).unwrap();
    let resumed = tremolite(folder.path(), &resumed);
    assert_eq!(code(&resumed), 0, "{}", errors(&resumed));
    assert_eq!(code(&tremolite(folder.path(), &["run", "study/case.toml", "--out", "whole"])), 0);
    let bytes = |run: &str| std::fs::read(folder.path().join(run).join("monitors.csv")).unwrap();
    assert!(bytes("stopped") == bytes("whole"));
    let summary = Summary::read(&folder.path().join("stopped/summary.json")).unwrap();
    assert_eq!((summary.conclusion.status, summary.computed.run.resumed), (Status::Done, 1));
}

#[test]
fn data_commands_print_json_with_the_promised_keys() {
    let (folder, _) = new_case();
    let json = |args: &[&str]| -> serde_json::Value {
        let output = tremolite(folder.path(), args);
        assert_eq!(code(&output), 0, "{args:?}: {}", errors(&output));
        serde_json::from_slice(&output.stdout).unwrap()
    };
    let levels = json(&["bench", "levels", "--elements", "4096", "--steps", "8", "--repeat", "1", "--json"]);
    let share = levels["updates_per_element_and_step"].as_f64().unwrap();
    assert!((0.25..0.5).contains(&share) && levels["steps"] == 8, "{levels}");
    let bench = json(&["bench", "--elements", "512", "--steps", "5", "--repeat", "1", "--json"]);
    for key in ["elements", "steps", "threads", "kind", "seconds", "element_updates_per_second", "peak_bytes"]
    {
        assert!(bench.get(key).is_some(), "{key}");
    }
    let info = json(&["motion", "info", "study/pulse.txt", "--json"]);
    for key in ["name", "file", "dt", "npts", "units", "pga", "pgv", "pgd", "arias", "d5_95", "cav"] {
        assert!(info["channels"][0].get(key).is_some(), "{key}");
    }
    assert!((info["channels"][0]["pgv"].as_f64().unwrap() - 0.2).abs() < 1e-3);
    let spectrum = json(&["motion", "spectrum", "study/pulse.txt", "--json"]);
    let lengths = ["periods", "psa"].map(|k| spectrum["channels"][0][k].as_array().unwrap().len());
    assert!(lengths[0] == lengths[1] && lengths[0] > 10);
    let schema = json(&["schema"]);
    assert!(schema["properties"]["material"].is_object());
    let checks = json(&["verify", "scheme_literal", "--json"]);
    for key in ["name", "quantity", "value", "reference", "tolerance", "pass", "order"] {
        assert!(checks[0].get(key).is_some(), "{key}");
    }
}

#[test]
fn lists_name_what_a_case_may_say() {
    let folder = tempfile::tempdir().unwrap();
    for (what, word) in [
        ("materials", "young"),
        ("interfaces", "max_closure"),
        ("bolts", "spacing"),
        ("boundaries", "viscous-spring"),
        ("quantities", "s1"),
        ("formats", "Gmsh"),
    ] {
        let output = tremolite(folder.path(), &["list", what]);
        assert_eq!(code(&output), 0);
        assert!(String::from_utf8(output.stdout).unwrap().contains(word), "{what}");
    }
    let quantities = String::from_utf8(tremolite(folder.path(), &["list", "quantities"]).stdout).unwrap();
    for line in [
        "d_tension              m3/m3  share of the group's volume in which d_tension is above 0.5\n",
        "plastic_shear_strain   m3/m3  share of the group's volume in which plastic_shear_strain is above 1e-6\n",
        "crack_opening          m      widest crack",
    ] {
        assert!(quantities.contains(line), "{line}:\n{quantities}");
    }
    assert_eq!(code(&tremolite(folder.path(), &["list", "colours"])), 2);
    assert_eq!(code(&tremolite(folder.path(), &["run", "absent.toml"])), 2);
    assert_eq!(code(&tremolite(folder.path(), &["report", "."])), 2);
    assert_eq!(code(&tremolite(folder.path(), &["verify", "no_such_problem"])), 2);
}

#[test]
fn moduli_and_energies_of_the_wrong_size_are_pointed_at() {
    let (folder, case) = new_case();
    change(&case, "young       = \"10 GPa\"", "young       = \"10 MPa\"");
    let check = tremolite(folder.path(), &["check", "study/case.toml"]);
    assert_eq!(code(&check), 0, "{}", errors(&check));
    assert!(errors(&check).contains("P waves would travel at 6"), "{}", errors(&check));

    let (folder, case) = new_case();
    let concrete = "law = \"concrete-damage\"\nfracture_energy = \"130 N/m\"\ntensile_strength = \"1.2 MPa\"\n\
                    cohesion = \"2 MPa\"\nfriction_angle = \"46 deg\"\nyoung = \"25 MPa\"";
    change(&case, "law         = \"elastic\"\nyoung       = \"25 GPa\"", concrete);
    let check = tremolite(folder.path(), &["check", "study/case.toml"]);
    assert_eq!(code(&check), 2);
    for words in ["elements must stay below 4.5e-3 m", "E or G_f looks too low"] {
        assert!(errors(&check).contains(words), "{}", errors(&check));
    }
}
