//! Stages that are refused, and checks of stages that fail.

use crate::stage_case::{LATERAL, SHAKING, STAGES, bytes, case, change, check, code, errors, run, tremolite};
use serde_json::Value;

#[test]
fn stages_that_do_not_fit_are_refused_at_their_lines() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let refused = [
        ("excavate = [\"core\"]", "excavate = [\"cor\"]", "no group of the mesh fits 'cor'", "excavate"),
        ("install = [\"shell\"]", "install = [\"shel\"]", "no group of the mesh fits 'shel'", "install"),
        ("{ shell = \"20 kPa\" }", "{ shel = \"20 kPa\" }", "no group of the mesh fits 'shel'", "pressure"),
        ("excavate = [\"core\"]\n", "", "but the rock in its place", "\"shell\"\ninstall"),
        (
            "install = [\"shell\"]",
            "excavate = [\"core\"]",
            "is gone since 'bench'",
            "excavate = [\"core\"]\n[[stage]]\nname = \"water\"",
        ),
        (
            "pressure = { shell",
            "install = [\"shell\"]\npressure = { shell",
            "is installed in 'shell' already",
            "install = [\"shell\"]\npressure",
        ),
        (
            "pressure = { shell",
            "material = { rock = \"concrete\" }\npressure = { shell",
            "keeps plastic shear strain, which 'concrete' does not know: it would heal",
            "material =",
        ),
        (
            "excavate = [\"core\"]",
            "excavate = [\"core\"]\nmaterial = { shell = \"rock\" }",
            "does not stand through 'bench'",
            "material =",
        ),
        (
            "groups = [\"shell\"]\nmaterial = \"concrete\"\nelement = \"full-integration\"",
            "groups = [\"shell\"]\nmaterial = \"void\"",
            "is void: nothing can be installed",
            "install",
        ),
        (
            "viscosity = 0.02",
            "viscosity = 0.02\n[[region]]\ngroups = [\"core\"]\nmaterial = \"void\"",
            "is void from the start",
            "excavate",
        ),
        (
            "element = \"full-integration\"",
            "element = \"full-integration\"\nbefore = \"spare\"",
            "no region is made of 'spare'",
            "before",
        ),
    ];
    for (from, to, words, line) in refused {
        case(folder, LATERAL, STAGES, "");
        change(folder, from, to);
        if to.contains("material = \"void\"") && to.contains("core") {
            change(folder, "groups = [\"rock\", \"core\"]", "groups = [\"rock\"]");
        }
        if to.contains("spare") {
            change(
                folder,
                "[[region]]",
                "[material.spare]\nlaw = \"elastic\"\nyoung = \"1 GPa\"\npoisson = 0.2\ndensity = \"2000 kg/m3\"\n[[region]]",
            );
        }
        let text = std::fs::read_to_string(folder.join("case.toml")).unwrap();
        let at = 1 + text[..text.rfind(line).unwrap_or_else(|| panic!("{line}"))].matches('\n').count();
        let output = tremolite(folder, &["run", "case.toml", "--out", "out"]);
        assert_eq!(code(&output), 2, "{to}: {}", errors(&output));
        let said = errors(&output);
        assert!(
            said.contains(words) && said.contains(&format!("case.toml:{at}:")),
            "{to}, line {at}:\n{said}"
        );
        assert!(!folder.join("out").exists(), "{to}");
    }
    // What stays held is allowed, and warned of.
    case(folder, LATERAL, STAGES, "");
    change(folder, "pressure = {", "release = 0.5\npressure = {");
    let (.., warned) = check(folder);
    assert!(warned.contains("50 % of what is held is never let go"), "{warned}");
}

/// Of each check of what came before, the run that fails it; and where it does not apply, that it says so.
#[test]
fn checks_of_what_came_before_fail_where_they_should() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let found = |initial: &str, stages: &str| -> Vec<(String, Option<bool>)> {
        case(folder, initial, stages, "");
        let run = run(folder, "out", &["--overwrite"]);
        assert_eq!(code(&run), 0, "{}", errors(&run));
        let summary: Value = serde_json::from_slice(&bytes(folder, "out", "summary.json")).unwrap();
        let line = |id: &str| {
            let lines = summary["checks"].as_array().unwrap();
            let line = lines.iter().find(|line| line["id"] == id).unwrap();
            let judged = line["not_applicable"] != Value::Bool(true);
            (id.to_owned(), judged.then(|| line["pass"].as_bool().unwrap()))
        };
        ["unreleased_force", "initial_motion", "initial_stress_change"].map(line).to_vec()
    };
    let verdicts = |found: Vec<(String, Option<bool>)>| -> Vec<Option<bool>> {
        found.into_iter().map(|(_, pass)| pass).collect()
    };
    let good = verdicts(found(LATERAL, STAGES));
    assert_eq!(good, [Some(true); 3]);
    let held = STAGES.replace("pressure = { shell = \"20 kPa\" }", "release = 0.3");
    let held = held
        .replace("release = 0.6", "release = 0.1")
        .replace("install = [\"shell\"]", "install = [\"shell\"]\nrelease = 0.1");
    assert_eq!(verdicts(found(LATERAL, &held))[0], Some(false));
    // A stress that is the same at every height has no weight in it.
    let level = "stress = { xx = \"-0.1 MPa\", yy = \"-0.1 MPa\", zz = \"-0.2 MPa\" }\nrelease_cycles = 50\ntolerance = 1e-4\n";
    let wrong = verdicts(found(level, STAGES));
    assert_eq!((wrong[1], wrong[2]), (Some(false), Some(false)));
    // Without a stage the stress alone is judged.
    let alone = verdicts(found(level, ""));
    assert_eq!((alone[1], alone[2]), (None, Some(false)));
}

/// A stress that is the same at every height has no weight in it: `check` says so by one evaluation of the forces, a run once the initial
/// equilibrium is found, and a strict run ends there.
#[test]
fn an_initial_stress_out_of_balance_is_told_before_the_earthquake_and_ends_a_strict_run() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let level = "stress = { xx = \"-0.1 MPa\", yy = \"-0.1 MPa\", zz = \"-0.2 MPa\" }\nrelease_cycles = 50\ntolerance = 1e-4\n";
    let words = "vertical forces out of balance under the initial stress";
    case(folder, LATERAL, STAGES, SHAKING);
    assert!(!check(folder).2.contains(words));
    let sound = run(folder, "sound", &["--overwrite"]);
    assert_eq!(code(&sound), 0, "{}", errors(&sound));
    case(folder, level, STAGES, SHAKING);
    let warned = check(folder).2;
    assert!(warned.contains(words) && warned.contains("(limit 25 %)"), "{warned}");
    let strict = run(folder, "strict", &["--overwrite", "--strict"]);
    assert_eq!(code(&strict), 1);
    let said = String::from_utf8_lossy(&strict.stdout).into_owned() + &errors(&strict);
    let look = "LOOK change of the initial stress by the initial equilibrium, relative";
    assert!(said.contains(look) && said.contains("--strict: a check of the stages fails"), "{said}");
    let summary: Value = serde_json::from_slice(&bytes(folder, "strict", "summary.json")).unwrap();
    assert_eq!(summary["stages"].as_array().unwrap().len(), 1, "it ends with the initial equilibrium");
    // Without the word it goes on, and has said it all the same.
    let plain = run(folder, "plain", &["--overwrite"]);
    assert_eq!(code(&plain), 0);
    let said = String::from_utf8_lossy(&plain.stdout).into_owned() + &errors(&plain);
    assert!(said.matches(look).count() == 2, "{said}");
    // A strict run goes on from there once it need not be strict.
    let resumed = run(folder, "strict", &["--resume"]);
    assert_eq!(code(&resumed), 0, "{}", errors(&resumed));
}

/// A bench that is left out of a list of them leaves the lining beside solid rock.
#[test]
fn a_bench_that_no_stage_takes_out_is_warned_of() {
    let folder = tempfile::tempdir().unwrap();
    assert!(tremolite(folder.path(), &["new", "study"]).status.success());
    let warned = |benches: &str| {
        let (three, taken) = ("mesh.caverns.cavern[0].benches=3", format!("stage[0].excavate={benches}"));
        let output = tremolite(folder.path(), &["check", "study/case.toml", "--set", three, "--set", &taken]);
        assert_eq!(code(&output), 0, "{}", errors(&output));
        errors(&output)
    };
    let words = "no stage takes out hall.bench2, though other benches of the cavern go";
    assert!(warned(r#"["hall.bench1", "hall.bench3"]"#).contains(words));
    assert!(!warned(r#"["hall.bench*"]"#).contains("no stage takes out"));
}
