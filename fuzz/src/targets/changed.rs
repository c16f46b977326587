//! Changes of sound files line by line: what a fuzzer of bytes would seldom get past the syntax. Four bytes are one change: what is done, at
//! which line, with which other line, and how.

use super::texts::{case_text, study_text};

const CASE: &str = include_str!("../../../crates/case/tests/cases/every-key.toml");
const STUDY: &str = include_str!("../../corpus/study/every.toml");

/// Values that stand in the place of others.
const VALUES: &[&str] = &[
    "0",
    "-1",
    "1",
    "2",
    "1e300",
    "1e-300",
    "nan",
    "inf",
    "9223372036854775807",
    "0.5",
    "true",
    "\"\"",
    "\"0 m\"",
    "\"-3 m\"",
    "\"1e30 m\"",
    "\"1e-30 m\"",
    "\"90 deg\"",
    "\"0 deg\"",
    "\"25 GPa\"",
    "\"0 Pa\"",
    "\"1 furlong\"",
    "\"rock\"",
    "\"*\"",
    "\"none\"",
    "\"../case.toml\"",
    "[]",
    "{}",
    "[\"*\"]",
    "[0, 0, 0]",
    "[\"0 m\", \"0 m\", \"0 m\"]",
    "[[\"1 m\"]]",
    "{ from = 0 }",
    "1979-05-27",
    "'''x'''",
];

/// Changes at most: each costs a reading of the file.
const MOST: usize = 24;

fn changed(sound: &str, bytes: &[u8]) -> String {
    let mut lines: Vec<String> = sound.lines().map(str::to_owned).collect();
    for change in bytes.chunks_exact(4).take(MOST) {
        let [what, at, other, how] = [change[0], change[1], change[2], change[3]].map(usize::from);
        if lines.is_empty() {
            break;
        }
        // Lines are numbered from the top, with `how` for files of more than 256.
        let line = |n: usize| (n + 256 * (how >> 6)) % lines.len();
        let (at, other) = (line(at), line(other));
        match what % 7 {
            0 => drop(lines.remove(at)),
            1 => lines.insert(at, lines[other].clone()),
            2 => lines.swap(at, other),
            3 => lines.truncate(at),
            4 => {
                if let Some((key, _)) = lines[at].split_once('=') {
                    lines[at] = format!("{key}= {}", VALUES[(how & 63) % VALUES.len()]);
                }
            }
            5 => {
                let value = lines[other].split_once('=').map(|(_, value)| value.to_owned());
                if let (Some((key, _)), Some(value)) = (lines[at].split_once('='), value) {
                    lines[at] = format!("{key}={value}");
                }
            }
            _ => {
                let digits: Vec<usize> =
                    lines[at].match_indices(|c: char| c.is_ascii_digit()).map(|(i, _)| i).collect();
                if let Some(&digit) = digits.get((how & 7).min(digits.len().saturating_sub(1))) {
                    lines[at].replace_range(
                        digit..=digit,
                        ["0", "9", "-1", "e9", "e-9", ".", "00", "5"][(how >> 3) & 7],
                    );
                }
            }
        }
    }
    lines.join("\n")
}

pub fn case(bytes: &[u8]) -> bool {
    case_text(&changed(CASE, bytes))
}

pub fn study(bytes: &[u8]) -> bool {
    study_text(&changed(STUDY, bytes))
}
