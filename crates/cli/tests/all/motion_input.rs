//! What a case gives of an earthquake is used, refused or warned of: components, windows, steps of processing, channels.

use crate::motion::{code, errors, json, told, tremolite};
use std::fmt::Write;
use std::path::Path;

const CASE: &str = r#"title = "a column"
[mesh.box]
group = "rock"
x = { from = 0, to = "4 m", elements = 2 }
y = { from = 0, to = "4 m", elements = 2 }
z = { from = "-40 m", to = 0, elements = 10 }
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
kind = "outcrop"
east = { file = "east.txt" }
[dynamic]
base = "viscous"
sides = "periodic"
[[monitor]]
name = "top"
at = ["1 m", "1 m", "-1 m"]
[output]
histories = "0.01 s"
snapshots = "none"
"#;

/// A burst of shaking of some frequencies \[m/s²\] about a time, every 0.005 s from 0 to `end` \[s\].
fn burst(path: &Path, about: f64, end: f64) {
    let mut text = "# units = \"m/s2\"\n".to_owned();
    for k in 0..=(end / 0.005_f64).round() as u32 {
        let t = 0.005 * f64::from(k);
        let within = (-((t - about) / 2.0).powi(2)).exp();
        let sum: f64 = [0.3, 0.9, 2.1, 4.3].iter().map(|f| (6.3 * f * t).sin()).sum();
        let _ = writeln!(text, "{t:.3} {:.7}", within * sum);
    }
    std::fs::write(path, text).unwrap();
}

/// A folder with the case, changed, and its record.
fn folder(changes: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    burst(&folder.path().join("east.txt"), 8.0, 16.0);
    write(folder.path(), changes);
    folder
}

fn write(folder: &Path, changes: &[(&str, &str)]) {
    let change = |text: String, (from, to): &(&str, &str)| {
        assert!(text.contains(from), "the case has no '{from}'");
        text.replacen(from, to, 1)
    };
    let text = changes.iter().fold(CASE.to_owned(), change);
    std::fs::write(folder.join("case.toml"), text).unwrap();
}

/// What `check` warns of, which must not refuse.
fn warned(folder: &Path) -> String {
    let done = tremolite(folder, &["check", "case.toml"]);
    assert_eq!(code(&done), 0, "{}", errors(&done));
    errors(&done)
}

const EAST: &str = "east = { file = \"east.txt\" }";
const UP: &str = "east = { file = \"east.txt\" }\nup = { from = \"east\", factor = 0.5 }";

/// Half of the record along x, a quarter along z, nothing along y; d_g by hand.
#[test]
fn check_prints_what_enters_along_each_axis_and_the_design_displacement() {
    let target = "kind = \"outcrop\"\ntarget = \"EN 1998-1 type 1 ground A 3.2 m/s2\"";
    let folder = folder(&[(EAST, UP), ("kind = \"outcrop\"", target)]);
    let found = json(folder.path(), &["check", "case.toml", "--json"]);
    let number = |pointer: &str| found.pointer(pointer).and_then(serde_json::Value::as_f64).expect(pointer);
    for peak in ["pga", "pgv", "pgd"] {
        let given = number(&format!("/motion/peaks/x/{peak}"));
        let enters = ["x", "y", "z"].map(|axis| number(&format!("/motion/enters/{axis}/{peak}")));
        assert!(given > 0.0 && (enters[0] / given - 0.5).abs() < 1e-3, "{peak}: {enters:?} of {given}");
        assert!(enters[1] == 0.0 && (enters[2] / given - 0.25).abs() < 1e-3, "{peak}: {enters:?} of {given}");
    }
    assert!((number("/motion/design_displacement") / (0.025 * 3.2 * 0.4 * 2.0) - 1.0).abs() < 1e-12);
    let words = told(folder.path(), &["check", "case.toml"]);
    for line in ["enters along x: PGA ", "enters along y: nothing", "enters along z: PGA ", "d_g 0.0640 m"] {
        assert!(words.contains(line), "'{line}' is not in\n{words}");
    }
}

/// Along x an SV wave of 30° has cos 30° of its motion, along z −sin 30°.
#[test]
fn what_enters_by_a_wave_at_an_angle_is_its_motion_along_each_axis() {
    let wave = "\n[[motion.wave]]\ntype = \"SV\"\nangle = \"30 deg\"\nazimuth = \"90 deg\"\ncomponent = \"east\"\n[dynamic]";
    let sides = "sides = { x = \"free-field\", y = \"periodic\" }";
    let folder = folder(&[
        ("kind = \"outcrop\"", "kind = \"incident\""),
        ("\n[dynamic]", wave),
        ("sides = \"periodic\"", sides),
    ]);
    let found = json(folder.path(), &["check", "case.toml", "--json"]);
    let number = |pointer: &str| found.pointer(pointer).and_then(serde_json::Value::as_f64).expect(pointer);
    for peak in ["pga", "pgv", "pgd"] {
        let given = number(&format!("/motion/peaks/x/{peak}"));
        let enters = ["x", "y", "z"].map(|axis| number(&format!("/motion/enters/{axis}/{peak}")) / given);
        let exact = [f64::sqrt(0.75), 0.0, 0.5];
        assert!(enters.iter().zip(exact).all(|(a, b)| (a - b).abs() < 1e-3), "{peak}: {enters:?}");
    }
}

#[test]
fn a_component_that_no_wave_carries_is_refused_or_warned_of() {
    let wave = "\n[[motion.wave]]\ntype = \"SV\"\nangle = \"20 deg\"\nazimuth = \"90 deg\"\ncomponent = \"east\"\n[dynamic]";
    let sides = "sides = { x = \"free-field\", y = \"periodic\" }";
    let changes = [(EAST, UP), ("\n[dynamic]", wave), ("sides = \"periodic\"", sides)];
    let folder = folder(&changes);
    let refused = tremolite(folder.path(), &["check", "case.toml"]);
    assert_eq!(code(&refused), 2);
    let words = errors(&refused);
    assert!(words.contains("no [[motion.wave]] carries `up`") && words.contains("leave `up` out"), "{words}");
    // Both remedies work.
    let both = wave.replace("\n[dynamic]", "\n[[motion.wave]]\ntype = \"P\"\nangle = \"20 deg\"\nazimuth = \"90 deg\"\ncomponent = \"up\"\n[dynamic]");
    for changes in
        [[(EAST, EAST), changes[1], changes[2]], [changes[0], ("\n[dynamic]", both.as_str()), changes[2]]]
    {
        write(folder.path(), &changes);
        assert!(!warned(folder.path()).contains("carries"));
    }
    // One file has all components, and none of them can be left out.
    let shipped = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/records/20161113_110259_WTMC_20.V2A");
    std::fs::copy(shipped, folder.path().join("three.V2A")).unwrap();
    write(
        folder.path(),
        &[(EAST, "file = \"three.V2A\"\nprocessing = [\"taper 1 s\", \"baseline\"]"), changes[1], changes[2]],
    );
    let words = warned(folder.path());
    assert!(words.contains("component 'north'") && words.contains("component 'up'"), "{words}");
    assert!(!words.contains("component 'east'"), "{words}");
}

/// The window is cut where the ground moves; a match brings window and record to rest and to one spectrum.
#[test]
fn the_warning_of_a_cut_window_stays_beside_a_match() {
    let shipped = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/records/20161113_110259_WTMC_20.V2A");
    let process = |steps: &str| {
        format!(
            "east = {{ file = \"w.V2A\", channel = \"N28W\" }}\ntarget = \"EN 1998-1 type 1 ground A 3.14 m/s2\"\nwindow = {{ strongest = \"12 s\" }}\n\
             processing = [\"detrend linear\", \"taper 1 s\", \"bandpass 0.2 Hz 10 Hz\", \"baseline\"{steps}]"
        )
    };
    let (alone, matched) = (process(""), process(", \"match 0.1 s 2 s\""));
    let folder = folder(&[(EAST, &alone)]);
    std::fs::copy(shipped, folder.path().join("w.V2A")).unwrap();
    assert!(warned(folder.path()).contains("the whole record, processed alike"));
    write(folder.path(), &[(EAST, &matched)]);
    let words = warned(folder.path());
    assert!(words.contains("the whole record, processed alike"), "{words}");
}

#[test]
fn windows_and_components_that_lose_something_are_warned_of() {
    let folder = folder(&[(EAST, "east = { file = \"east.txt\" }\nwindow = [\"0 s\", \"30 s\"]")]);
    let words = warned(folder.path());
    assert!(words.contains("window: 0 s to 30 s (14.00 s of it lie outside"), "{words}");
    write(folder.path(), &[(EAST, "east = { file = \"east.txt\" }\nwindow = [\"0 s\", \"16.1 s\"]")]);
    assert!(!warned(folder.path()).contains("lie outside"));
    // A vertical component that ends in the middle of the horizontal one cuts it.
    burst(&folder.path().join("up.txt"), 4.0, 8.0);
    write(folder.path(), &[(EAST, "east = { file = \"east.txt\" }\nup = { file = \"up.txt\" }")]);
    let words = warned(folder.path());
    let record = std::fs::read_to_string(folder.path().join("east.txt")).unwrap();
    let samples = record.lines().skip(1).filter_map(|line| line.split_once(' '));
    let samples = samples.map(|(t, a)| (t.parse::<f64>().unwrap(), a.parse::<f64>().unwrap()));
    let [behind, all] = samples
        .fold([0.0; 2], |[behind, all], (t, a)| [behind + if t > 8.0 { a * a } else { 0.0 }, all + a * a]);
    let share = format!("'east': {:.0} % of its energy", 100.0 * behind / all);
    assert!(behind > 0.4 * all && words.contains(&share), "{share}: {words}");
    assert!(!words.contains("'up': "), "{words}");
}

#[test]
fn steps_that_later_steps_undo_are_warned_of() {
    let steps = |steps: &str| {
        format!("{EAST}\ntarget = \"EN 1998-1 type 1 ground A 2 m/s2\"\nprocessing = [{steps}]")
    };
    let folder = folder(&[]);
    for (process, says) in [
        ("\"scale 2\", \"pga 0.2 g\"", "\"scale 2\": no effect, since \"pga 0.2 g\""),
        ("\"pga 0.3 g\", \"pga 0.2 g\"", "\"pga 0.3 g\": no effect"),
        ("\"pga 0.3 g\", \"match 0.2 s 1.5 s\"", "\"pga 0.3 g\": no effect, since \"match"),
        ("\"match 0.2 s 1.5 s\", \"highpass 1 Hz\"", "after \"highpass 1 Hz\", which stands behind \"match"),
    ] {
        write(folder.path(), &[(EAST, &steps(process))]);
        let words = warned(folder.path());
        assert!(words.contains(says), "{process}: {words}");
    }
    for process in
        ["\"pga 0.2 g\", \"scale 2\"", "\"scale -1\", \"pga 0.2 g\"", "\"match 0.2 s 1.5 s\", \"scale 0.5\""]
    {
        write(folder.path(), &[(EAST, &steps(process))]);
        let words = warned(folder.path());
        assert!(!words.contains("no effect") && !words.contains("misfit"), "{process}: {words}");
    }
}

#[test]
fn a_channel_is_found_by_its_label_after_its_file_was_renamed() {
    let shipped = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/records/20161113_110259_WTMC_20.V2A");
    let named = |file: &str, channel: &str| {
        format!(
            "east = {{ file = \"{file}\", channel = \"{channel}\" }}\nprocessing = [\"taper 1 s\", \"baseline\"]"
        )
    };
    let folder = folder(&[]);
    for file in ["20161113_110259_WTMC_20.V2A", "renamed.V2A"] {
        std::fs::copy(shipped, folder.path().join(file)).unwrap();
        write(folder.path(), &[(EAST, &named(file, "N28W"))]);
        warned(folder.path());
    }
    // By file and label as well, and what is there is listed by the labels.
    write(folder.path(), &[(EAST, &named("renamed.V2A", "renamed N28W"))]);
    warned(folder.path());
    write(folder.path(), &[(EAST, &named("renamed.V2A", "20161113_110259_WTMC_20 N28W"))]);
    let refused = tremolite(folder.path(), &["check", "case.toml"]);
    assert_eq!(code(&refused), 2);
    assert!(errors(&refused).contains("the file has N28W, S62W, Up"), "{}", errors(&refused));
}

/// Shaken with nothing a model stays at rest; every check has something to say or does not apply.
#[test]
fn a_motion_of_zeros_is_run_as_a_test_of_rest() {
    let folder = folder(&[]);
    let zeros: String = (0..100).map(|k| format!("{:.3} 0\n", 0.005 * f64::from(k))).collect();
    std::fs::write(folder.path().join("east.txt"), format!("# units = \"m/s2\"\n{zeros}")).unwrap();
    let words = warned(folder.path());
    assert!(words.contains("motion: 0 m/s2 everywhere") && words.matches("warning:").count() == 1, "{words}");
    let done = tremolite(folder.path(), &["run", "case.toml", "--out", "out"]);
    assert_eq!(code(&done), 0, "{}", errors(&done));
    let text = std::fs::read_to_string(folder.path().join("out/summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&text).unwrap();
    let failed: Vec<&serde_json::Value> =
        summary["checks"].as_array().unwrap().iter().filter(|line| line["pass"] != true).collect();
    assert!(failed.is_empty(), "{failed:#?}");
    let rows = std::fs::read_to_string(folder.path().join("out/monitors.csv")).unwrap();
    let still = |line: &str| line.split(',').skip(1).all(|cell| cell.parse::<f64>().unwrap() == 0.0);
    assert!(rows.lines().count() > 40 && rows.lines().skip(1).all(still), "{rows}");
    // Damping over a band has no central frequency then.
    let band = "sides = \"periodic\"\ndamping = { ratio = 0.03, band = [\"0.5 Hz\", \"20 Hz\"] }";
    write(folder.path(), &[("sides = \"periodic\"", band)]);
    let refused = tremolite(folder.path(), &["check", "case.toml"]);
    assert_eq!(code(&refused), 2);
    assert!(errors(&refused).contains("reference = \"0 Hz\""), "{}", errors(&refused));
}
