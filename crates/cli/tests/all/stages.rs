//! Stages before the earthquake, as a user meets them: what is foretold, run, stopped and handed over.

use crate::stage_case::{
    JOINT, LATERAL, SHAKING, STAGES, bytes, case, change, check, code, errors, run, same, tremolite,
};
use serde_json::Value;
use std::path::Path;
use std::process::Command;
use tremolite_results::{PairSurface, Status, Summary, Table};

#[test]
fn a_case_without_an_earthquake_runs_its_stages_and_says_nothing_of_shaking() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    case(folder, LATERAL, STAGES, "");
    change(folder, "[initial]", &format!("{JOINT}[initial]"));
    let done = run(folder, "out", &["--isa", "scalar"]);
    assert_eq!(code(&done), 0, "{}", errors(&done));
    let summary = Summary::read(&folder.join("out/summary.json")).unwrap();
    assert_eq!(summary.conclusion.status, Status::Done);
    assert!(
        summary.conclusion.verdict.contains("All 4 stages came to rest"),
        "{}",
        summary.conclusion.verdict
    );
    let names: Vec<&str> = summary.computed.stages.iter().map(|stage| stage.name.as_str()).collect();
    assert_eq!(names, ["initial equilibrium", "bench", "shell", "water"]);
    assert!(
        summary.computed.stages[1].monitors["roof"]["uz"].unwrap() < -1e-6,
        "{:?}",
        summary.computed.stages[1]
    );
    let table = std::fs::read_to_string(folder.join("out/stages.csv")).unwrap();
    let header: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let own =
        ["stage", "name", "cycles", "ratio", "motion_left [m]", "largest_motion [m]", "plastic_volume [m3]"];
    assert_eq!(header[..7], own);
    assert!(header.contains(&"roof.ux [m]") && header.contains(&"wall.s3 [Pa]"), "{header:?}");
    assert_eq!(table.lines().count(), 5);
    for file in ["monitors.csv", "energy.csv", "motion.csv", "free_field.csv", "fields.pvd"] {
        assert!(!folder.join("out").join(file).exists(), "{file}");
    }
    for file in [
        "stages/003.vtu",
        "stages.pvd",
        "report.html",
        "sections.csv",
        "interfaces/stage-003.vtu",
        "interfaces.pvd",
    ] {
        assert!(folder.join("out").join(file).exists(), "{file}");
    }
    // A file of interfaces has the faces that are there.
    let faces = |stage: &str| -> usize {
        let surfaces = PairSurface::read(&folder.join("out/interfaces").join(stage)).unwrap();
        surfaces.iter().map(|surface| surface.faces.len()).sum()
    };
    assert!(faces("stage-001.vtu") == 0 && faces("stage-002.vtu") > 0);
    // What it leaves for earthquakes is nothing to go on from.
    let resumed = run(folder, "out", &["--resume"]);
    assert_eq!(code(&resumed), 0);
    assert!(errors(&resumed).contains("this run is complete"), "{}", errors(&resumed));
    let (found, text, warned) = check(folder);
    assert_eq!((&found["time_step"], &found["motion"]), (&Value::Null, &Value::Null));
    let said = errors(&done);
    for word in
        ["Motion", "Time step", "impacts allow", "stable step", "shear wave", "Rayleigh", "could run", "c_p"]
    {
        for all in [&said, &text, &warned] {
            assert!(!all.contains(word), "'{word}':\n{all}");
        }
    }
    assert!(!said.contains("0.0e0 out of balance"), "{said}");
    assert!(found["estimate"]["stage_cycles"].as_u64().unwrap() >= 4 * 350);
    assert_eq!(found["estimate"]["field_files"], 0);
}

#[test]
fn check_lists_stages_lives_stand_ins_stress_and_bare_walls() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    case(folder, LATERAL, STAGES, SHAKING);
    let (found, text, _) = check(folder);
    let stages = found["stages"].as_array().unwrap();
    let of = |k: usize, key: &str| stages[k][key].clone();
    assert_eq!(of(1, "excavated"), serde_json::json!([{ "groups": "core", "elements": 8 }]));
    assert_eq!(of(2, "installed"), serde_json::json!([{ "groups": "shell", "elements": 24 }]));
    assert_eq!((of(1, "release"), of(1, "gone"), of(2, "begun")), (0.6.into(), 32.into(), 24.into()));
    // Four walls of 8 m along 4 m of the opening; then the shell covers them.
    let bare: Vec<f64> = (0..4).map(|k| of(k, "wall_without_lining").as_f64().unwrap()).collect();
    assert!(bare.iter().zip([0.0, 128.0, 0.0, 0.0]).all(|(a, b)| (a - b).abs() < 1e-9), "{bare:?}");
    let lives = found["comes_and_goes"].as_array().unwrap();
    let life = |group: &str, body: Value| {
        let one = lives.iter().find(|l| l["group"] == group && l["stands_in"] == body);
        let one = one.unwrap_or_else(|| panic!("{group}: {lives:?}"));
        (one["from"].clone(), one["until"].clone(), one["elements"].as_u64().unwrap())
    };
    assert_eq!(life("core", Value::Null), (Value::Null, "bench".into(), 8));
    assert_eq!(life("shell", Value::Null), ("shell".into(), Value::Null, 24));
    assert_eq!(life("shell", "rock".into()), (Value::Null, "bench".into(), 24));
    // At the centre of the base's elements 15 m lie above: 2500·9.81·15 = 0.3679 MPa.
    let base = &found["initial_stress"][2];
    assert!((base["stress"][2].as_f64().unwrap() + 2500.0 * 9.81 * 15.0).abs() < 1.0, "{base}");
    for words in [
        "1  bench: excavates core (8); 60 % of what is held goes",
        "3  water: 20 kPa on shell",
        "in the place of 24 elements of shell stands rock until 'bench'",
        "vertical 367.9 kPa, horizontal 183.9 kPa along x",
        "beyond yield",
        "of them",
        "Time step",
    ] {
        assert!(text.contains(words), "'{words}':\n{text}");
    }
    assert_eq!(found["relaxed_moduli"], serde_json::json!([]));
    let band = "[dynamic]\ndamping = { ratio = 0.03, band = [\"1 Hz\", \"20 Hz\"], reference = \"5 Hz\" }";
    change(folder, "[dynamic]", band);
    let (found, text, _) = check(folder);
    let share = found["relaxed_moduli"][0]["share"].as_f64().unwrap();
    assert!(share > 0.8 && share < 0.95, "{share}");
    assert!(text.contains("beside 2 GPa"), "{text}");
}

/// Time within which every file of this test is there, on a machine under load.
#[cfg(unix)]
pub fn wait_for(path: &Path, child: &mut std::process::Child) {
    for _ in 0..6000 {
        if path.exists() {
            return;
        }
        assert!(child.try_wait().unwrap().is_none(), "the run ended before {} was there", path.display());
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    panic!("no {}", path.display());
}

#[cfg(unix)]
#[test]
fn a_run_stopped_in_a_stage_resumes_to_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    case(folder, &LATERAL.replace("= 50", "= 3000"), STAGES, SHAKING);
    let mut child = Command::new(env!("CARGO_BIN_EXE_tremolite"))
        .current_dir(folder)
        .args(["run", "case.toml", "--out", "parts", "--threads", "1"])
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    wait_for(&folder.join("parts/stages.csv"), &mut child);
    Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(3));
    let summary = Summary::read(&folder.join("parts/summary.json")).unwrap();
    assert_eq!(summary.conclusion.status, Status::Stopped);
    assert!(
        summary.conclusion.verdict.contains("was stopped in the stage '"),
        "{}",
        summary.conclusion.verdict
    );
    assert!(folder.join("parts/report.html").exists() && !folder.join("parts/monitors.csv").exists());

    let resumed = run(folder, "parts", &["--resume", "--threads", "2"]);
    assert_eq!(code(&resumed), 0, "{}", errors(&resumed));
    let whole = run(folder, "whole", &["--threads", "1"]);
    assert_eq!(code(&whole), 0, "{}", errors(&whole));
    let files = ["stages.csv", "monitors.csv", "energy.csv", "relaxation.csv", "sections.csv", "stages.pvd"];
    same(folder, "parts", "whole", &files);
    same(folder, "parts", "whole", &["stages/001.vtu", "stages/003.vtu"]);
}

const HISTORIES: [&str; 4] = ["stages.csv", "monitors.csv", "energy.csv", "sections.csv"];

#[test]
fn results_with_stages_do_not_depend_on_threads_or_instruction_sets() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    case(folder, LATERAL, STAGES, SHAKING);
    for (out, more) in
        [("one", ["--threads", "1"]), ("two", ["--threads", "2"]), ("plain", ["--isa", "scalar"])]
    {
        let done = run(folder, out, &more);
        assert_eq!(code(&done), 0, "{}", errors(&done));
    }
    same(folder, "one", "two", &HISTORIES);
    same(folder, "one", "plain", &HISTORIES);
    let table = Table::read(&folder.join("one/monitors.csv")).unwrap();
    assert!(table.column("roof.ux").unwrap().iter().any(|u| u.abs() > 1e-6));
}

/// What pairs give out while nothing slides is no share of friction.
#[test]
fn a_bonded_joint_under_stress_is_handed_over_and_passes_its_checks() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    case(folder, LATERAL, STAGES, SHAKING);
    change(
        folder,
        "[initial]",
        &format!("{}[initial]", JOINT.replace("max_closure", "normal_stiffness = \"20 GPa/m\"\nmax_closure")),
    );
    for (out, more) in
        [("whole", &["--threads", "1"][..]), ("from", &["--threads", "2", "--start-from", "whole"])]
    {
        let done = run(folder, out, more);
        assert_eq!(code(&done), 0, "{}", errors(&done));
    }
    same(folder, "whole", "from", &HISTORIES);
    same(folder, "whole", "from", &["interfaces.csv"]);
    // The dashpots of pairs are none while time stands still: through the stages or begun behind them is the same.
    change(folder, "friction_coefficient = 0.7", "friction_coefficient = 0.7\ncontact_damping = 0.05");
    for (out, more) in [("damped", &[][..]), ("later", &["--start-from", "whole"])] {
        let done = run(folder, out, more);
        assert_eq!(code(&done), 0, "{}", errors(&done));
    }
    same(folder, "damped", "later", &HISTORIES);
    let summary = Summary::read(&folder.join("whole/summary.json")).unwrap();
    let of_joint = |id: &str| id.starts_with("interface_") || id == "energy_created_by_interfaces";
    for line in summary.soundness.checks.iter().filter(|line| of_joint(&line.id)) {
        assert!(line.pass, "{line:?}");
    }
    let friction = Table::read(&folder.join("whole/energy.csv")).unwrap();
    assert!(friction.column("friction").unwrap().iter().all(|e| *e == 0.0));
    assert!(friction.column("created_by_interface").unwrap().iter().any(|e| *e != 0.0));
}

#[test]
fn another_earthquake_begins_with_a_run_s_rest_and_other_ground_does_not() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    case(folder, LATERAL, STAGES, SHAKING);
    let whole = run(folder, "whole", &[]);
    assert_eq!(code(&whole), 0, "{}", errors(&whole));
    let from = run(folder, "from", &["--start-from", "whole"]);
    assert_eq!(code(&from), 0, "{}", errors(&from));
    same(folder, "whole", "from", &HISTORIES);
    let original = std::fs::read_to_string(folder.join("case.toml")).unwrap();

    // What shakes, how it is damped and what is written may be another.
    for (k, (what, with)) in [
        ("processing = [\"baseline\"]", "processing = [\"baseline\", \"scale 2\"]"),
        (
            "duration = \"0.1 s\"",
            "duration = \"0.05 s\"\ndamping = { rayleigh = { mass = \"1 1/s\", stiffness = \"1e-5 s\" } }",
        ),
        ("histories = \"0.01 s\"", "histories = \"0.02 s\""),
        ("viscosity = 0.02", "viscosity = 0.03"),
    ]
    .into_iter()
    .enumerate()
    {
        change(folder, what, with);
        let other = run(folder, &format!("other{k}"), &["--start-from", "whole"]);
        assert_eq!(code(&other), 0, "{with}: {}", errors(&other));
        same(folder, "whole", &format!("other{k}"), &["stages.csv"]);
        std::fs::write(folder.join("case.toml"), &original).unwrap();
    }
    change(folder, "viscosity = 0.02", "viscosity = 0.03");
    let viscous = run(folder, "viscous", &[]);
    assert_eq!(code(&viscous), 0, "{}", errors(&viscous));
    same(folder, "viscous", "other3", &HISTORIES);
    std::fs::write(folder.join("case.toml"), &original).unwrap();
    // Of a monitor that was not there nothing is known in the stages; of the others what was.
    change(folder, "name = \"wall\"\nat = [\"12.5 m\"", "name = \"wall\"\nat = [\"3.5 m\"");
    let moved = run(folder, "moved", &["--start-from", "whole"]);
    assert_eq!(code(&moved), 0, "{}", errors(&moved));
    let stages = |run: &str| Summary::read(&folder.join(run).join("summary.json")).unwrap().computed.stages;
    assert_eq!(stages("moved")[1].monitors["roof"], stages("whole")[1].monitors["roof"]);
    assert!(stages("whole")[1].monitors["wall"]["ux"].is_some());
    assert_eq!(stages("moved")[1].monitors["wall"]["ux"], None);
    std::fs::write(folder.join("case.toml"), &original).unwrap();

    for (what, with) in [
        ("cohesion = \"1 MPa\"", "cohesion = \"1.1 MPa\""),
        ("release = 0.6", "release = 0.7"),
        ("pressure = { shell = \"20 kPa\" }", "pressure = { shell = \"21 kPa\" }"),
        ("lateral = 0.5", "lateral = 0.6"),
        ("path = \"hall.msh\"", "path = \"hall.msh\"\nunit = \"1.01 m\""),
    ] {
        change(folder, what, with);
        let refused = run(folder, "refused", &["--start-from", "whole"]);
        assert_eq!(code(&refused), 2, "{with}: {}", errors(&refused));
        assert!(errors(&refused).contains("is that of another mesh"), "{}", errors(&refused));
        assert!(!folder.join("refused").exists(), "nothing is computed");
        std::fs::write(folder.join("case.toml"), &original).unwrap();
    }
    // Not over what it begins with.
    let over = run(folder, "whole", &["--start-from", "whole", "--overwrite"]);
    assert_eq!(code(&over), 2);
    assert!(
        folder.join("whole/checkpoint/hand-over.bin").exists() && errors(&over).contains("another --out")
    );

    // Stages that were run alone serve as well, between the same sides.
    std::fs::create_dir(folder.join("still")).unwrap();
    case(folder, LATERAL, STAGES, "[dynamic]\nbase = \"viscous\"\nsides = \"viscous\"\n");
    let still = run(folder, "rest", &[]);
    assert_eq!(code(&still), 0, "{}", errors(&still));
    std::fs::write(folder.join("case.toml"), &original).unwrap();
    let shaken = run(folder, "shaken", &["--start-from", "rest"]);
    assert_eq!(code(&shaken), 0, "{}", errors(&shaken));
    same(folder, "whole", "shaken", &HISTORIES);
}

#[test]
fn what_is_cut_free_is_warned_of_and_comes_down_with_its_stage_and_place_named() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let cut = "[[stage]]\nname = \"cut\"\nexcavate = [\"shell\"]\n[[stage]]\nname = \"on\"\n";
    case(folder, LATERAL, cut, "");
    let (found, _, warned) = check(folder);
    let piece = &found["stages"][1]["without_support"][0];
    assert_eq!((&piece["group"], &piece["elements"]), (&"core".into(), &8.into()), "{found:#}");
    assert!(
        warned.contains("case.toml:")
            && warned.contains("a piece of 'core' (8 elements, 64 m3, 4.0 × 4.0 × 4.0 m)"),
        "{warned}"
    );
    assert!(
        warned.contains("it will come down") && warned.matches("it will come down").count() == 1,
        "{warned}"
    );
    assert_eq!(code(&tremolite(folder, &["check", "case.toml", "--strict"])), 1);

    let fallen = run(folder, "out", &[]);
    assert_eq!(code(&fallen), 1, "{}", errors(&fallen));
    let summary = Summary::read(&folder.join("out/summary.json")).unwrap();
    assert_eq!(summary.conclusion.status, Status::Failed);
    for words in ["The stage 'cut' did not come to rest", "of 'core' at (", "lost its support"] {
        assert!(summary.conclusion.verdict.contains(words), "'{words}': {}", summary.conclusion.verdict);
    }
    assert_eq!(summary.computed.stages.len(), 1);
    for file in ["stages.csv", "stages/000.vtu", "stages/001.vtu", "stages.pvd", "report.html"] {
        assert!(folder.join("out").join(file).exists(), "{file}");
    }
    assert_eq!(String::from_utf8(bytes(folder, "out", "stages.csv")).unwrap().lines().count(), 2);
    // There is no rest to begin with.
    change(folder, "[[monitor]]", &format!("{SHAKING}[[monitor]]"));
    let from = run(folder, "from", &["--start-from", "out"]);
    assert_eq!(code(&from), 2);
    assert!(errors(&from).contains("went through its stages"), "{}", errors(&from));
}

/// The roof of the opening lies on its bond alone: it holds or comes down by its strength.
#[test]
fn a_slab_that_hangs_is_warned_of_and_comes_down_where_its_bond_is_too_weak() {
    let slab = |strength: &str| {
        format!(
            "[[interface]]\nname = \"bond\"\nbetween = [\"shell\", \"rock\"]\nlaw = \"bandis\"\n\
             normal_stiffness = \"20 GPa/m\"\nmax_closure = \"2 mm\"\ncohesion = \"{strength}\"\n\
             tensile_strength = \"{strength}\"\nfriction_coefficient = 0.6\n[initial]"
        )
    };
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    for (strength, holds) in [("2 MPa", true), ("0 Pa", false)] {
        case(folder, LATERAL, "[[stage]]\nname = \"bench\"\nexcavate = [\"core\"]\n", "");
        // The upper half of the shell alone.
        let path = folder.join("hall.msh");
        let mut mesh = tremolite_mesh::read(&path).unwrap();
        let low = |e: &u32| {
            let nodes = mesh.elements[*e as usize].nodes();
            nodes.iter().map(|&n| mesh.nodes[n as usize][2]).sum::<f64>() / 8.0 < 10.0
        };
        let (lower, upper): (Vec<u32>, Vec<u32>) = mesh.groups["shell"].iter().copied().partition(low);
        mesh.groups.insert("shell".into(), upper);
        mesh.groups.get_mut("core").unwrap().extend(lower);
        mesh.groups.get_mut("core").unwrap().sort_unstable();
        tremolite_mesh::write(&path, &mesh).unwrap();
        change(folder, "[initial]", &slab(strength));
        let (found, _, warned) = check(folder);
        assert!(warned.contains("hangs by bond alone"), "{warned}");
        assert_eq!(found["stages"][1]["without_support"][0]["hangs_by"][0], "bond");
        assert_eq!(found["stages"][0]["without_support"], serde_json::json!([]));
        let done = run(folder, "out", &["--overwrite"]);
        assert_eq!(code(&done), i32::from(!holds), "{strength}: {}", errors(&done));
        let verdict = Summary::read(&folder.join("out/summary.json")).unwrap().conclusion.verdict;
        assert!(holds || verdict.contains("'bench' did not come to rest"), "{verdict}");
    }
}

#[test]
fn a_stage_that_ends_before_its_rest_says_how_far_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    case(folder, &format!("{LATERAL}max_cycles = 60"), STAGES, SHAKING);
    let stopped = run(folder, "out", &[]);
    assert_eq!(code(&stopped), 1, "{}", errors(&stopped));
    let verdict = Summary::read(&folder.join("out/summary.json")).unwrap().conclusion.verdict;
    assert!(verdict.contains("after 60 cycles") && verdict.contains("Give more `max_cycles`"), "{verdict}");
    assert!(folder.join("out/report.html").exists() && !folder.join("out/monitors.csv").exists());
}

#[test]
fn a_group_may_go_and_its_lining_begin_in_one_stage() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let both = "[[stage]]\nname = \"both\"\nexcavate = [\"core\", \"shell\"]\ninstall = [\"shell\"]\n";
    case(folder, LATERAL, both, "");
    let done = run(folder, "out", &[]);
    assert_eq!(code(&done), 0, "{}", errors(&done));
    let (found, ..) = check(folder);
    assert_eq!(found["stages"][1]["gone"], 32);
    assert_eq!(found["stages"][1]["begun"], 24);
}

/// A job that is put in the queue again is the same command.
#[test]
fn one_command_begins_goes_on_and_leaves_a_complete_run_as_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    case(folder, LATERAL, STAGES, "");
    let again = || run(folder, "out", &["--resume"]);
    let begun = again();
    assert_eq!(code(&begun), 0, "{}", errors(&begun));
    let whole = [bytes(folder, "out", "stages.csv"), bytes(folder, "out", "summary.json")];
    let complete = again();
    assert_eq!(code(&complete), 0);
    assert!(errors(&complete).contains("this run is complete"), "{}", errors(&complete));
    assert!(whole[1] == bytes(folder, "out", "summary.json"), "it is left as it is");
    // With a checkpoint of its last steps too; and another case has no results here.
    std::fs::write(folder.join("out/checkpoint/state.bin"), "state").unwrap();
    let sums = bytes(folder, "out", "SHA256SUMS");
    assert_eq!(code(&again()), 0);
    assert!(sums == bytes(folder, "out", "SHA256SUMS"), "what it wrote is still told from what it did not");
    let other = run(folder, "out", &["--resume", "--set", "initial.lateral=0.7"]);
    assert_eq!(code(&other), 2, "{}", errors(&other));
    assert!(errors(&other).contains("differs from"), "{}", errors(&other));
    std::fs::remove_file(folder.join("out/checkpoint/state.bin")).unwrap();
    let other = run(folder, "out", &["--resume", "--set", "initial.lateral=0.7"]);
    assert_eq!(code(&other), 2, "{}", errors(&other));
    // Killed as its page was made.
    std::fs::remove_file(folder.join("out/report.html")).unwrap();
    assert_eq!(code(&again()), 0);
    assert!(bytes(folder, "out", "report.html").len() > 10_000);

    // Killed before it had anything to go on from.
    let out = folder.join("out");
    std::fs::remove_dir_all(out.join("checkpoint")).unwrap();
    std::fs::remove_file(out.join("summary.json")).unwrap();
    std::fs::write(out.join("stages.csv"), "half a li").unwrap();
    change(folder, "young = \"2 GPa\"", "young = \"3 GPa\"");
    let other = again();
    assert_eq!(code(&other), 2, "{}", errors(&other));
    case(folder, LATERAL, STAGES, "");
    let cut_short = again();
    assert_eq!(code(&cut_short), 0, "{}", errors(&cut_short));
    assert!(whole[0] == bytes(folder, "out", "stages.csv"));

    // One that failed is nothing to go on with.
    let summary = std::fs::read_to_string(out.join("summary.json")).unwrap();
    let failed = summary.replacen("\"status\": \"done\"", "\"status\": \"failed\"", 1);
    assert!(failed != summary, "{summary}");
    std::fs::write(out.join("summary.json"), failed).unwrap();
    let failed = again();
    assert_eq!(code(&failed), 2, "{}", errors(&failed));
}
