//! Records on the command line and in a case.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

pub(crate) fn tremolite(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tremolite")).current_dir(folder).args(args).output().unwrap()
}

pub(crate) fn code(output: &Output) -> i32 {
    output.status.code().unwrap()
}

pub(crate) fn errors(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// The standard output of a command that must succeed.
pub(crate) fn told(folder: &Path, args: &[&str]) -> String {
    let output = tremolite(folder, args);
    assert_eq!(code(&output), 0, "{args:?}: {}", errors(&output));
    String::from_utf8(output.stdout).unwrap()
}

pub(crate) fn json(folder: &Path, args: &[&str]) -> serde_json::Value {
    serde_json::from_str(&told(folder, args)).unwrap()
}

pub(crate) fn shipped(name: &str) -> String {
    let path: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/records").join(name);
    path.display().to_string()
}

/// A burst of `peak`, sampled every `dt`, as text with its own units.
pub(crate) fn burst(path: &Path, units: &str, dt: f64, start: f64, peak: f64) {
    let wave = |t: f64| peak * (12.0 * (t - 2.0)).sin() * (-((t - 2.0) / 0.5).powi(2)).exp();
    let lines =
        (0..(4.0 / dt) as usize).map(|i| start + i as f64 * dt).map(|t| format!("{t:.5} {:.9}\n", wave(t)));
    std::fs::write(path, format!("# units = \"{units}\"\n{}", lines.collect::<String>())).unwrap();
}

#[test]
fn counts_are_told_as_counts_until_a_sensitivity_is_given() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    burst(&at.join("raw.txt"), "counts", 0.01, 0.0, 427336.0);
    let info = json(at, &["motion", "info", "raw.txt", "--json"]);
    let channel = &info["channels"][0];
    assert_eq!(
        (channel["units"].as_str(), channel["format"].as_str()),
        (Some("counts"), Some("text columns"))
    );
    let counts = channel["pga"].as_f64().unwrap();
    assert!((3e5..4.3e5).contains(&counts));
    for key in ["pgv", "pgd", "arias", "cav", "orientation"] {
        assert!(channel.get(key).is_some_and(serde_json::Value::is_null), "{key}: {}", channel[key]);
    }
    burst(&at.join("weak.txt"), "m/s2", 0.01, 0.0, 1.2345e-4);
    let weak = told(at, &["motion", "info", "weak.txt"]);
    assert!(
        weak.contains("PGA 0.000") && !weak.contains("0.0000 m/s") && !weak.contains("PGD 0.0000 "),
        "{weak}"
    );
    let text = told(at, &["motion", "info", "raw.txt"]);
    for word in [
        "[counts]",
        "0 s to 3.99 s",
        "format text columns, direction not stated",
        "counts, D5-95",
        "--sensitivity",
    ] {
        assert!(text.contains(word), "'{word}' is not in\n{text}");
    }
    let refused = tremolite(at, &["motion", "spectrum", "raw.txt"]);
    assert_eq!(code(&refused), 2);
    assert!(errors(&refused).contains("--sensitivity \"427336 counts/(m/s2)\""), "{}", errors(&refused));

    let given = ["--sensitivity", "427336 counts/(m/s2)"];
    let known = json(at, &[&["motion", "info", "raw.txt", "--json"], &given[..]].concat());
    let channel = &known["channels"][0];
    assert!((channel["pga"].as_f64().unwrap() * 427336.0 / counts - 1.0).abs() < 1e-12);
    assert!(channel["pgv"].as_f64().unwrap() > 0.0 && channel["units"] == "counts");
    told(at, &[&["motion", "spectrum", "raw.txt"], &given[..]].concat());
    let wrong = tremolite(at, &["motion", "info", "raw.txt", "--sensitivity", "427336"]);
    assert!(code(&wrong) == 2 && errors(&wrong).contains("is not a sensitivity"), "{}", errors(&wrong));
}

#[test]
fn faults_are_told_of_all_files_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    burst(&at.join("good.txt"), "g", 0.01, 0.0, 1.0);
    std::fs::write(at.join("words.txt"), "no numbers\n").unwrap();
    let refused = tremolite(at, &["motion", "info", "words.txt", "good.txt", "nowhere.txt", "--json"]);
    let words = errors(&refused);
    assert_eq!(code(&refused), 2);
    let printed: serde_json::Value = serde_json::from_slice(&refused.stdout).unwrap();
    assert!(printed.get("refused").is_some() && printed.get("channels").is_none(), "{printed}");
    assert!(words.contains("error: words.txt, line 1") && words.contains("error: nowhere.txt"), "{words}");
}

#[test]
fn processing_writes_text_and_figures_and_keeps_the_ratio_of_components() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    burst(&at.join("a.txt"), "m/s2", 0.01, 0.0, 2.0);
    burst(&at.join("b.txt"), "cm/s2", 0.01, 0.0, 100.0);
    let steps = ["--step", "pre-event 0.5 s", "--step", "pga 0.3 g", "--out", "out"];
    let all = [&["motion", "process", "a.txt", "b.txt", "--json"], &steps[..]].concat();
    let made = json(at, &all);
    assert_eq!(made["written"].as_array().unwrap().len(), 2);
    let info = json(at, &["motion", "info", "out/a_1.txt", "out/b_2.txt", "--json"]);
    let peaks = [0, 1].map(|i| info["channels"][i]["pga"].as_f64().unwrap());
    // Info detrends, which is far less than a thousandth here.
    assert!((peaks[0] - 0.3 * 9.80665).abs() < 1e-3 && (peaks[0] / peaks[1] - 2.0).abs() < 1e-3, "{peaks:?}");
    let figure = std::fs::read_to_string(at.join("out/a_1.svg")).unwrap();
    for word in [
        "acceleration (m/s²)",
        "velocity",
        "displacement",
        "spectral acceleration, 5 % damping",
        "pga 0.3 g",
        "before",
    ] {
        assert!(figure.contains(word), "{word}");
    }
    std::fs::remove_dir_all(at.join("out")).unwrap();
    let made = json(at, &[&all[..], &["--no-plot"]].concat());
    assert!(made["figures"].as_array().unwrap().is_empty() && !at.join("out/a_1.svg").exists());

    burst(&at.join("late.txt"), "m/s2", 0.01, 100.0, 2.0);
    let late = tremolite(at, &["motion", "process", "a.txt", "late.txt", "--step", "baseline"]);
    assert!(code(&late) == 2 && errors(&late).contains("not components of one record"), "{}", errors(&late));
    burst(&at.join("raw.txt"), "counts", 0.01, 0.0, 1e4);
    let raw = tremolite(at, &["motion", "process", "raw.txt", "--step", "pga 0.3 g"]);
    assert!(code(&raw) == 2 && errors(&raw).contains("sensitivity"), "{}", errors(&raw));
    told(at, &["motion", "process", "raw.txt", "--step", "highpass 0.5 Hz"]);
    assert!(std::fs::read_to_string(at.join("raw_1.svg")).unwrap().contains("(counts)"));
}

#[test]
fn a_case_in_counts_is_refused_until_it_has_a_sensitivity() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    told(at, &["new", "study"]);
    burst(&at.join("study/raw.txt"), "counts", 0.01, 0.0, 1e5);
    let case = at.join("study/case.toml");
    let text = std::fs::read_to_string(&case).unwrap();
    let with = |east: &str| {
        std::fs::write(&case, text.replace("east    = { file = \"pulse.txt\" }", east)).unwrap();
        tremolite(at, &["check", "study/case.toml"])
    };
    let refused = with("east = { file = \"raw.txt\" }");
    let words = errors(&refused);
    assert_eq!(code(&refused), 2);
    assert!(
        words.contains("'raw' is in counts")
            && words.contains("write, beside file")
            && words.contains("sensitivity = \"427336 counts/(m/s2)\""),
        "{words}"
    );
    let wrong = with("east = { file = \"raw.txt\", sensitivity = \"427336\" }");
    assert!(code(&wrong) == 2 && errors(&wrong).contains("is not a sensitivity"), "{}", errors(&wrong));
    let known = with("east = { file = \"raw.txt\", sensitivity = \"427336 counts/(m/s2)\" }");
    assert_eq!(code(&known), 0, "{}", errors(&known));
}

#[test]
fn what_reading_changed_and_directions_that_do_not_fit_are_warned_of() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    told(at, &["new", "study"]);
    burst(&at.join("study/fine.txt"), "m/s2", 0.005, 0.0, 0.2);
    burst(&at.join("study/coarse.txt"), "m/s2", 0.01, 0.003, 0.2);
    let case = at.join("study/case.toml");
    let text = std::fs::read_to_string(&case).unwrap();
    let with = |parts: &str| {
        std::fs::write(&case, text.replace("east    = { file = \"pulse.txt\" }", parts)).unwrap();
        tremolite(at, &["check", "study/case.toml"])
    };
    let both = with(
        "east = { file = \"fine.txt\" }\nnorth = { file = \"coarse.txt\" }\nup = { from = \"north\", factor = 0.1 }",
    );
    let words = errors(&both);
    assert_eq!(code(&both), 0, "{words}");
    assert!(
        words.contains("the samples of 'coarse' were interpolated from an interval of 0.01 s"),
        "{words}"
    );
    assert!(!words.contains("the samples of 'fine'"), "{words}");

    let file = shipped("20161113_110259_WTMC_20.V2A").replace('\\', "/");
    // N28W is 28 degrees from north, S62W 152 from east.
    for (axis, channel, fits) in
        [("north", "N28W", true), ("east", "S62W", false), ("up", "Up", true), ("north", "Up", false)]
    {
        let record =
            format!("{axis} = {{ file = \"{file}\", channel = \"20161113_110259_WTMC_20 {channel}\" }}");
        let words = errors(&with(&record));
        assert!(!words.contains("is not clear"), "{words}");
        assert_eq!(!words.contains("states its direction as"), fits, "{axis} {channel}: {words}");
    }
}

/// Pictures and steps of docs/records.md are what the program makes of the shipped record.
#[test]
fn the_page_of_records_shows_what_its_command_draws() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let page = std::fs::read_to_string(docs.join("records.md")).unwrap().replace("\\\n", " ");
    let command = page.lines().find(|l| l.contains("motion process cases/records")).unwrap();
    // Words in quotes are one.
    let parts = command.split('"').enumerate().flat_map(|(i, part)| match i % 2 {
        0 => part.split_whitespace().collect::<Vec<_>>(),
        _ => vec![part],
    });
    let mut words: Vec<&str> = parts.skip(1).collect();
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().display().to_string();
    let last = words.len() - 1;
    assert_eq!((words[last - 1], words[last]), ("--out", "processed"));
    words[last] = &out;
    told(&docs.join(".."), &words);
    let drawn = std::fs::read_to_string(folder.path().join("51WCW_EW_20s_40s_gal_int_1.svg")).unwrap();
    let shown = std::fs::read_to_string(docs.join("records/wolong.svg")).unwrap();
    assert!(drawn == shown, "docs/records/wolong.svg is not what its command on the page draws");
    assert!(page.contains("(records/wolong.svg)") && drawn.len() < 100_000);
    // The numbers of the page are those that the figure names.
    for word in ["before 9.58\u{a0}m/s²", "after 9.40\u{a0}m/s²", "after −59.4\u{a0}mm", "before 832\u{a0}mm"]
    {
        assert!(drawn.contains(word), "{word}");
    }
    // Steps of the table are steps that are read.
    let rows =
        page.lines().skip_while(|l| !l.starts_with("| step |")).skip(2).take_while(|l| l.starts_with('|'));
    assert!(rows.clone().count() > 8);
    for line in rows {
        let steps = line.split('|').nth(1).unwrap().split('`').skip(1).step_by(2);
        for step in steps {
            let mut values = ["3", "20"].iter();
            let text = step.split(' ').map(|w| match w {
                "N" | "S" | "X" => "3",
                "F" | "T" => values.next().unwrap(),
                other => other,
            });
            let text = text.collect::<Vec<_>>().join(" ");
            tremolite_motion::Process::parse(&text).unwrap_or_else(|e| panic!("{e}"));
        }
    }
}
