//! Checks of a run that can fail: each is shown the model that fails it.

use std::path::Path;
use std::process::{Command, Output};
use tremolite_results::{Summary, TrustLine};

pub fn tremolite(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tremolite")).current_dir(folder).args(args).output().unwrap()
}

pub fn errors(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// A homogeneous block of 80 × 80 × 40 m under a shear wave of 2 Hz along x, with this base and these sides.
pub fn block(folder: &Path, dynamic: &str) {
    let pulse: String = (0..200)
        .map(|k| {
            let x = (std::f64::consts::PI * 2.0 * (0.01 * f64::from(k) - 0.7)).powi(2);
            format!("{:.6}\n", (1.0 - 2.0 * x) * (-x).exp())
        })
        .collect();
    std::fs::write(folder.join("pulse.txt"), pulse).unwrap();
    let case = format!(
        r#"title = "block"
[mesh.box]
x = {{ to = "80 m", elements = 8 }}
y = {{ to = "80 m", elements = 8 }}
z = {{ to = "40 m", elements = 8 }}
[material.rock]
law = "elastic"
young = "2 GPa"
poisson = 0.25
density = "2500 kg/m3"
[[region]]
groups = ["rock"]
material = "rock"
element = "reduced-integration"
[motion]
kind = "incident"
east = {{ file = "pulse.txt", units = "m/s2", dt = "0.01 s" }}
processing = ["baseline"]
[dynamic]
{dynamic}
[[monitor]]
name = "top"
at = ["40 m", "40 m", "40 m"]
[output]
histories = "0.01 s"
"#
    );
    std::fs::write(folder.join("case.toml"), case).unwrap();
}

fn summary_of(folder: &Path) -> Summary {
    let run = tremolite(folder, &["run", "case.toml", "--out", "results", "--overwrite"]);
    assert!(run.status.success(), "{}", errors(&run));
    Summary::read(&folder.join("results/summary.json")).unwrap()
}

fn line<'s>(summary: &'s Summary, id: &str) -> &'s TrustLine {
    summary
        .soundness
        .checks
        .iter()
        .find(|line| line.id == id)
        .unwrap_or_else(|| panic!("{id}: {:?}", summary.soundness.checks))
}

/// Ground that is the same everywhere must move everywhere as its reference column: periodic sides let it, others do not,
/// though column and theory agree in all of them.
#[test]
fn sides_that_spoil_the_free_field_warn_before_and_fail_the_check_after() {
    for (dynamic, good) in [
        ("sides = \"periodic\"", true),
        ("sides = \"free-field\"", true),
        ("base = \"viscous\"\nsides = { x = \"free-field\", y = \"periodic\" }", true),
        ("base = \"viscous\"\nsides = \"periodic\"", true),
        // A shear wave along x does not press on rollers across y.
        ("sides = { x = \"periodic\", y = \"roller\" }", true),
        ("sides = { x = \"periodic\", y = \"symmetry\" }", true),
        ("sides = \"viscous\"", false),
        ("base = \"viscous\"\nsides = \"viscous\"", false),
        ("sides = \"free\"", false),
    ] {
        let folder = tempfile::tempdir().unwrap();
        block(folder.path(), dynamic);
        let summary = summary_of(folder.path());
        let model = line(&summary, "free_field_at_model_edges");
        assert_eq!(model.pass, good, "{dynamic}: {model:?}");
        assert!(!model.not_applicable && model.numbers["peak"] > 0.0, "{dynamic}: {model:?}");
        if good {
            assert!(model.value < 1e-9, "{dynamic}: {model:?}");
        }
        assert!(line(&summary, "free_field_theory").pass, "{dynamic}: the column itself is right");

        let check = tremolite(folder.path(), &["check", "case.toml"]);
        assert_eq!(errors(&check).contains("80 to 130 % of the surface's peak"), !good, "{dynamic}");
        assert!(check.status.success());
        for command in [&["check"][..], &["run", "--out", "strict"]] {
            let mut args = command.to_vec();
            args.extend(["case.toml", "--strict"]);
            let strict = tremolite(folder.path(), &args);
            assert_eq!(
                strict.status.code(),
                Some(i32::from(!good)),
                "{dynamic}, {command:?}: {}",
                errors(&strict)
            );
        }
    }
}

#[test]
fn every_check_has_an_id_of_its_own_and_those_that_do_not_apply_say_why() {
    let folder = tempfile::tempdir().unwrap();
    block(folder.path(), "sides = \"periodic\"");
    let summary = summary_of(folder.path());
    let ids: Vec<&str> = summary.soundness.checks.iter().map(|line| line.id.as_str()).collect();
    for id in [
        "elements_per_wavelength",
        "input_drift",
        "free_field_theory",
        "free_field_at_model_edges",
        "energy_error",
        "body_energy_error",
        "energy_created_by_laws",
        "hourglass_energy",
        "yielding_rock_without_initial_stress",
        "monitors_on_broken_elements",
        "implied_fracture_energy",
        "law_warnings",
    ] {
        assert_eq!(ids.iter().filter(|other| **other == id).count(), 1, "{id}: {ids:?}");
    }
    for line in &summary.soundness.checks {
        assert!(
            line.id.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_'),
            "{}",
            line.id
        );
        assert!(!line.not_applicable || !line.note.is_empty(), "{} says not why", line.id);
    }
    let energy = line(&summary, "energy_error");
    assert!(energy.pass && energy.numbers["held"] > 0.0, "{energy:?}");
    assert!(
        summary.case.facts.iter().any(|fact| fact.id == "time_step_over_stable_step" && fact.value < 1.0)
    );
    assert_eq!(summary.case.version, env!("CARGO_PKG_VERSION"));
}

/// The case of a result folder finds its record from there, and says when that is another.
#[test]
fn the_case_of_a_result_folder_runs_again_and_names_what_has_changed() {
    let folder = tempfile::tempdir().unwrap();
    block(folder.path(), "sides = \"periodic\"");
    let summary = summary_of(folder.path());
    let names: Vec<&str> = summary.case.inputs.iter().map(|input| input.name.as_str()).collect();
    assert_eq!(names, ["case", "pulse.txt"]);
    assert!(summary.case.inputs.iter().all(|input| input.hash.len() == 64), "{:?}", summary.case.inputs);

    let again = tremolite(folder.path(), &["run", "results/case.toml", "--out", "again"]);
    assert!(again.status.success(), "{}", errors(&again));
    assert!(!errors(&again).contains("is not what that run read"));
    let [first, second] =
        ["results", "again"].map(|run| std::fs::read(folder.path().join(run).join("monitors.csv")));
    assert_eq!(first.unwrap(), second.unwrap());

    let pulse = folder.path().join("pulse.txt");
    let text = std::fs::read_to_string(&pulse).unwrap();
    std::fs::write(&pulse, text.replacen("0.0", "0.1", 1)).unwrap();
    let other = tremolite(folder.path(), &["check", "results/case.toml"]);
    assert!(
        errors(&other).contains("pulse.txt") && errors(&other).contains("is not what that run read"),
        "{}",
        errors(&other)
    );
}

#[test]
fn motion_beyond_any_earthquake_is_refused_with_the_way_out() {
    let folder = tempfile::tempdir().unwrap();
    for change in ["\"baseline\", \"scale 60\"", "\"scale 60\", \"baseline\""] {
        block(folder.path(), "sides = \"periodic\"");
        let case = folder.path().join("case.toml");
        let text = std::fs::read_to_string(&case).unwrap().replace("\"baseline\"", change);
        std::fs::write(&case, text).unwrap();
        let refused = tremolite(folder.path(), &["check", "case.toml"]);
        assert_eq!(refused.status.code(), Some(2));
        assert!(errors(&refused).contains("more than any earthquake"), "{}", errors(&refused));
    }
}

/// A block whose ground dips, so that its corners differ: each has a column of its own, by name, and theory for it. The model's
/// corners follow theirs with free-field sides and do not with viscous ones.
#[test]
fn ground_that_differs_between_corners_has_a_column_at_each() {
    let folder = tempfile::tempdir().unwrap();
    assert!(tremolite(folder.path(), &["new", "study"]).status.success());
    let folder = folder.path().join("study");
    let case = folder.join("case.toml");
    let text = std::fs::read_to_string(&case).unwrap();
    let layers = r#"[[mesh.caverns.layer]]
name = "soft"
depth = 0
[[mesh.caverns.layer]]
name = "sound"
depth = "30 m"
dip = "20 deg"
dip_azimuth = "0 deg"
[material.soft]
law = "elastic"
young = "2 GPa"
poisson = 0.25
unit_weight = "25 kN/m3"

[material.rock]"#;
    let region = "[[region]]\ngroups = [\"rock.soft\"]\nmaterial = \"soft\"\nelement = \"reduced-integration\"\n\n[[region]]";
    let text = text
        .replacen("[material.rock]", layers, 1)
        .replacen("[[region]]", region, 1)
        .replacen("groups   = [\"rock\",", "groups = [\"rock.sound\",", 1)
        .replace("duration = \"1.5 s\"", "duration = \"0.2 s\"")
        // Elements at which the layers' border is not at one level at both ends.
        .replace("size_near  = \"0.8 m\"", "size_near = \"2 m\"")
        .replace("{ x = \"free-field\", y = \"periodic\" }", "\"free-field\"");
    std::fs::write(&case, &text).unwrap();
    let summary = summary_of(&folder);
    assert!(line(&summary, "free_field_theory").pass);
    let model = line(&summary, "free_field_at_model_edges");
    assert!(model.pass && model.note.contains("of column '"), "{model:?}");
    let header = std::fs::read_to_string(folder.join("results/free_field.csv")).unwrap();
    for name in ["xmin-ymin.top.vx [m/s]", "ymax-xmax.base.vz_theory [m/s]", "model.surface.vx [m/s]"] {
        assert!(header.lines().next().unwrap().contains(name), "{name}: {header:.200}");
    }

    // Springs of the base act on what differs from columns at the corners.
    let text = text
        .replace("sides    = \"free-field\"", "sides    = \"viscous\"")
        .replace("base     = \"viscous\"", "base     = \"viscous-spring\"");
    std::fs::write(&case, &text).unwrap();
    let summary = summary_of(&folder);
    let model = line(&summary, "free_field_at_model_edges");
    assert!(!model.pass && model.note.contains("reference-x"), "{model:?}");
    assert!(
        summary.case.warnings.iter().any(|said| said.contains("drain the wave")),
        "{:?}",
        summary.case.warnings
    );
}

/// The most frequent mistake in the field: the half of an outcrop's motion taken twice.
#[test]
fn an_outcrop_that_is_scaled_by_about_a_half_is_warned_of() {
    let folder = tempfile::tempdir().unwrap();
    assert!(tremolite(folder.path(), &["new", "study"]).status.success());
    let case = folder.path().join("study/case.toml");
    let text = std::fs::read_to_string(&case).unwrap();
    for (kind, process, warned) in [
        ("outcrop", "\"detrend linear\", \"scale 0.5\"", true),
        ("outcrop", "\"scale -0.4\"", true),
        ("outcrop", "\"scale 0.75\", \"scale 0.75\"", true),
        ("outcrop", "\"scale 0.35\"", false),
        ("incident", "\"scale 0.5\"", false),
    ] {
        let changed = text
            .replace("kind    = \"incident\"", &format!("kind    = \"{kind}\""))
            .replace("processing = [\"detrend linear\"]", &format!("processing = [{process}]"));
        assert_ne!(changed, text);
        std::fs::write(&case, changed).unwrap();
        let check = tremolite(folder.path(), &["check", "study/case.toml"]);
        assert!(check.status.success(), "{}", errors(&check));
        assert_eq!(errors(&check).contains("enters anyway"), warned, "{kind} {process}: {}", errors(&check));
    }
}
