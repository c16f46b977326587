//! A run of a lining that cracks: the lines that it ends with, and the paths of summary.json that documents name.

use crate::chinese_run::CONCRETE;
use crate::stage_case::{LATERAL, SHAKING, STAGES, case, change, errors, run};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::sync::OnceLock;
use tremolite_results::Summary;

/// The folder of the run, and what it wrote to standard error.
fn ended() -> &'static (tempfile::TempDir, String) {
    static RUN: OnceLock<(tempfile::TempDir, String)> = OnceLock::new();
    RUN.get_or_init(|| {
        let temp = tempfile::tempdir().unwrap();
        case(temp.path(), LATERAL, STAGES, SHAKING);
        change(temp.path(), "law = \"elastic\"\nyoung = \"20 GPa\"", CONCRETE);
        let output = run(temp.path(), "out", &[]);
        assert!(output.status.success(), "{}", errors(&output));
        (temp, errors(&output))
    })
}

#[test]
fn a_run_ends_with_its_state_and_its_reliance() {
    let (temp, said) = ended();
    let summary = Summary::read(&temp.path().join("out/summary.json")).unwrap();
    let lines: Vec<&str> = said.lines().collect();
    let state = lines.iter().position(|line| line.contains("State: damaged. shell: ")).expect(said);
    // The sides stand near, and a third of the pulse is not run.
    assert!(lines[state + 1].contains("Reliance: not to be used. "), "{said}");
    assert!(lines[state + 2].contains("Results are in "), "{said}");
    let told = summary.conclusion.verdict;
    assert!(told.contains("State: damaged. Reliance: not to be used. "), "{told}");
    let page = fs::read_to_string(temp.path().join("out/report.html")).unwrap();
    assert!(page.contains("State: <strong>damaged</strong>"));
}

/// Paths of summary.json in a document: tokens with dots in paragraphs that name the file, numbers of studies, attributes in Python.
fn paths(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let plain = |token: &str| {
        let mut parts = token.split('.');
        let word = |part: &str| {
            part == "*" || (!part.is_empty() && part.chars().all(|c| c.is_ascii_lowercase() || c == '_'))
        };
        token.contains('.') && parts.all(word)
    };
    // Names of files and folders.
    let is_file = |token: &str| {
        let ends = ["csv", "json", "html", "toml", "vtu", "pvd", "svg", "txt", "md", "py", "rs", "old"];
        token.rsplit('.').next().is_some_and(|end| ends.contains(&end))
    };
    for paragraph in text.replace("\n- ", "\n\n").split("\n\n").filter(|p| p.contains("summary.json")) {
        let tokens = paragraph.split('`').skip(1).step_by(2);
        found.extend(tokens.filter(|token| plain(token) && !is_file(token)).map(str::to_owned));
    }
    for (before, end) in [("summary = '", '\''), ("unless = '", '\'')] {
        let quoted = text.split(before).skip(1).filter_map(|rest| rest.split_once(end));
        found.extend(quoted.map(|(path, _)| path.to_owned()));
    }
    let attributes = text.split("result.summary.").skip(1);
    found.extend(attributes.map(|rest| {
        let end =
            rest.find(|c: char| !(c.is_ascii_lowercase() || matches!(c, '_' | '.'))).unwrap_or(rest.len());
        rest[..end].trim_end_matches('.').to_owned()
    }));
    found
}

/// The parts of a path; `*` for what a user names, in quotes or brackets.
fn parts(path: &str) -> Vec<String> {
    let mut parts = vec![String::new()];
    let mut rest = path;
    while let Some(c) = rest.chars().next() {
        let closed = match c {
            '"' => Some('"'),
            '[' => Some(']'),
            _ => None,
        };
        if let Some(close) = closed {
            if c == '[' {
                parts.push(String::new());
            }
            *parts.last_mut().unwrap() = "*".into();
            rest = rest[1..].split_once(close).map_or("", |(_, behind)| behind);
            continue;
        }
        match c {
            '.' => parts.push(String::new()),
            c => parts.last_mut().unwrap().push(c),
        }
        rest = &rest[c.len_utf8()..];
    }
    parts
}

fn holds(value: &Value, parts: &[String]) -> bool {
    let Some((first, rest)) = parts.split_first() else { return true };
    match (value, first.as_str()) {
        (Value::Object(fields), "*") => fields.values().any(|value| holds(value, rest)),
        (Value::Array(entries), "*") => entries.iter().any(|value| holds(value, rest)),
        (Value::Object(fields), name) => fields.get(name).is_some_and(|value| holds(value, rest)),
        _ => false,
    }
}

#[test]
fn documents_name_paths_that_summary_json_has() {
    let (temp, _) = ended();
    let text = fs::read(temp.path().join("out/summary.json")).unwrap();
    let summary: Value = serde_json::from_slice(&text).unwrap();
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let mut seen = 0;
    for entry in fs::read_dir(docs).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|end| end != "md") {
            continue;
        }
        for named in paths(&fs::read_to_string(&path).unwrap()) {
            let found = parts(&named);
            // The slots of a note are there where the check has found something.
            let known =
                found.iter().position(|part| part == "note_message").map_or(&found[..], |end| &found[..=end]);
            assert!(holds(&summary, known), "{}: summary.json has no `{named}`", path.display());
            seen += 1;
        }
    }
    assert!(seen >= 9, "{seen} paths were found");
    assert!(!holds(&summary, &parts("parts.damage.*.cracks.directions")));
    assert_eq!(parts("damage.\"a.b\".volume"), ["damage", "*", "volume"]);
    assert_eq!(parts("checks[some.id].note"), ["checks", "*", "note"]);
}

/// An elastic lining is judged by its section alone, and tension beyond the section's strength is a finding.
#[test]
fn an_elastic_lining_is_not_judged_without_a_section_and_damaged_by_tension_beyond_its_strength() {
    let temp = tempfile::tempdir().unwrap();
    let folder = temp.path();
    case(folder, LATERAL, STAGES, SHAKING);
    let output = run(folder, "bare", &[]);
    assert!(output.status.success(), "{}", errors(&output));
    let said = errors(&output);
    assert!(said.contains("State: not judged. "), "{said}");
    assert!(said.contains("No strength is known for shell (law elastic). Add a [[section]]"), "{said}");
    let section = "[[section]]\non = [\"shell\"]\ncode = \"EN 1992-1-1\"\ncompressive_strength = \"40 MPa\"\ntensile_strength = \"1 kPa\"\n[initial]";
    change(folder, "[initial]", section);
    let output = run(folder, "judged", &[]);
    assert!(output.status.success(), "{}", errors(&output));
    let summary = Summary::read(&folder.join("judged/summary.json")).unwrap();
    let tension = summary.conclusion.findings.iter().find(|finding| finding.id == "tension_shell").unwrap();
    assert_eq!(tension.numbers["strength"], 1e3);
    assert_eq!(tension.numbers["tension"], summary.parts.stress["shell"].s1.value);
    let items: Vec<&str> = summary.conclusion.state.reasons.iter().map(|reason| &*reason.item).collect();
    assert!(items.contains(&"tension_beyond_strength") && !items.contains(&"mode_not_judged"), "{items:?}");
}

/// A stage in ground without stress moves nothing: a share of nothing in nothing is no failure.
#[test]
fn a_stage_in_ground_without_stress_raises_no_false_alarm() {
    let temp = tempfile::tempdir().unwrap();
    let folder = temp.path();
    case(folder, "", "[[stage]]\nname = \"line\"\nexcavate = [\"core\"]\ninstall = [\"shell\"]\n", "");
    change(folder, "[initial]\n", "");
    let output = run(folder, "out", &[]);
    assert!(output.status.success(), "{}", errors(&output));
    let summary = Summary::read(&folder.join("out/summary.json")).unwrap();
    for id in ["initial_motion", "initial_motion_local"] {
        let line = summary.soundness.checks.iter().find(|line| line.id == id).unwrap();
        assert!(line.not_applicable && line.note.contains("nothing moved"), "{line:?}");
    }
}
