//! Whatever the text, it is read or refused; nothing panics, and every report can be shown.

use std::path::Path;

use tremolite_case::{Case, LawFile, units};
use tremolite_laws::materials::MATERIALS;
use tremolite_laws::parameter::Dimension;

const GOOD: &str = include_str!("../cases/every-key.toml");

/// SplitMix64 (Steele, Lea, Flood 2014): a fixed sequence, so that a failure can be repeated.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % n as u64) as usize
    }
}

fn survive(source: &str) {
    if let Err(report) = Case::parse(Path::new("case.toml"), source, MATERIALS) {
        assert!(!report.problems.is_empty(), "a refusal says why");
        for problem in &report.problems {
            assert!(problem.span.start <= problem.span.end && problem.span.end <= source.len());
            assert!(!problem.message.is_empty() && !problem.remedy.is_empty());
            report.position(problem);
        }
        let shown = report.render(false);
        assert!(!shown.contains(|c: char| c.is_control() && c != '\n'), "{shown:?}");
    }
}

/// A terminal takes them for commands. The remedy named a key that was not in quotes as it stood.
#[test]
fn control_characters_of_a_case_are_not_shown() {
    for text in ["a = \u{1d}", "\u{1b}[31m = 1", "title = \"\u{7}\"", "\u{9b}x = 1", "[\u{1b}]"] {
        survive(text);
    }
}

const SCRAPS: &[&str] = &[
    "\"",
    "'",
    "[",
    "]",
    "[[",
    "]]",
    "{",
    "}",
    "=",
    ".",
    ",",
    "#",
    "\n",
    "\r\n",
    "\r",
    "\t",
    "\0",
    "é",
    "°",
    "\u{feff}",
    "1",
    "-",
    "nan",
    "inf",
    "1e999",
    "0x7fffffffffffffffffff",
    "true",
    "1979-05-27",
    "\"\"\"",
    "'''",
    "\\",
    "\\u0000",
    "name",
    "at = ",
    "[motion]\n",
    "[[monitor]]\n",
    "[[interface]]\n",
    "[[stage]]\n",
    "[initial]\n",
    "measured = [{}]\n",
    "lateral = nan\n",
    "law = \"tied\"\n",
    "interface = ",
    "material.",
    "\u{202e}",
    "[material.rock]\n",
    "= \"10 GPa\"\n",
];

#[test]
fn random_changes_of_a_good_case_never_panic() {
    let mut random = Random(20161113);
    let chars: Vec<char> = GOOD.chars().collect();
    for _ in 0..1500 {
        let mut text = chars.clone();
        for _ in 0..=random.below(4) {
            let at = random.below(text.len() + 1);
            let length = random.below(12).min(text.len() - at);
            match random.below(4) {
                0 => drop(text.drain(at..at + length)),
                1 => {
                    let scrap: Vec<char> = SCRAPS[random.below(SCRAPS.len())].chars().collect();
                    text.splice(at..at + length, scrap);
                }
                2 => {
                    let copy: Vec<char> = text[at..at + length].to_vec();
                    let to = random.below(text.len() + 1);
                    text.splice(to..to, copy);
                }
                _ => text.truncate(at),
            }
        }
        survive(&text.into_iter().collect::<String>());
    }
}

#[test]
fn every_beginning_of_a_good_case_is_read_or_refused() {
    for end in (0..=GOOD.len()).filter(|i| GOOD.is_char_boundary(*i)).step_by(7) {
        survive(&GOOD[..end]);
    }
}

#[test]
fn every_key_survives_a_value_of_every_kind() {
    let values = [
        "1", "-1", "0.5", "nan", "\"\"", "\"x\"", "\"5 m\"", "true", "[]", "[1]", "{}", "[[]]", "07:32:00",
        "[{}]",
    ];
    for (at, _) in GOOD.match_indices(" = ") {
        let start = at + 3;
        let end = GOOD[start..].find('\n').map_or(GOOD.len(), |i| start + i);
        for value in values {
            survive(&format!("{}{value}{}", &GOOD[..start], &GOOD[end..]));
        }
    }
}

/// A law file, by turns with each table.
const LAW: &str = "size = \"1 m\"\n[material]\nlaw = \"elastic\"\nyoung = \"10 GPa\"\npoisson = 0.25\n\
                   [interface]\nlaw = \"coulomb\"\nnormal_stiffness = \"20 GPa/m\"\nfriction_coefficient = 0.7\n";

#[test]
fn every_beginning_and_end_of_a_law_file_is_read_or_refused() {
    let survive = |source: &str| {
        if let Err(report) = LawFile::parse(Path::new("law.toml"), source, MATERIALS) {
            assert!(!report.problems.is_empty(), "a refusal says why");
            assert!(report.problems.iter().all(|p| !p.message.is_empty() && !p.remedy.is_empty()));
            report.render(false);
        }
    };
    for cut in 0..=LAW.len() {
        survive(&LAW[..cut]);
        survive(&LAW[cut..]);
    }
    for value in ["1", "nan", "\"\"", "[]", "[{}]", "{}", "{ a = {} }", "true", "07:32:00"] {
        for key in ["material", "interface", "interface.law", "interface.name", "material.size", "size"] {
            survive(&format!("{key} = {value}\n"));
        }
    }
}

#[test]
fn deep_nesting_is_refused() {
    let deep = 100_000;
    for text in [
        format!("title = {}", "[".repeat(deep)),
        format!("title = {}1{}", "[".repeat(deep), "]".repeat(deep)),
        format!("title = {}", "{a=".repeat(deep)),
        format!("{}b = 1", "a.".repeat(deep)),
        format!("[{}b]", "a.".repeat(deep)),
    ] {
        let report = Case::parse(Path::new("case.toml"), &text, MATERIALS).expect_err("too deep");
        assert!(
            report.problems.iter().any(|p| p.message.contains("nested too deeply")),
            "{:?}",
            report.problems[0]
        );
        assert!(report.problems.len() < 10, "{} problems", report.problems.len());
    }
}

#[test]
fn odd_texts_are_refused() {
    for text in [
        "",
        "\n",
        "\u{feff}",
        "garbage",
        "\0\0\0",
        "<xml/>",
        "{\"title\": 1}",
        "title",
        "=",
        "[",
        "\"\"\"",
        "title = '",
    ] {
        assert!(Case::parse(Path::new("case.toml"), text, MATERIALS).is_err(), "{text:?}");
        survive(text);
    }
}

#[test]
fn thousands_of_problems_are_all_kept_and_the_first_are_shown() {
    let wrong: String = (0..5000).map(|i| format!("wrong{i} = {i}\n")).collect();
    let source = format!("{wrong}{GOOD}");
    let report = Case::parse(Path::new("case.toml"), &source, MATERIALS).expect_err("unknown keys");
    assert_eq!(report.problems.len(), 5000);
    let text = report.render(false);
    assert!(
        text.contains("wrong39")
            && !text.contains("wrong41")
            && text.ends_with("5000 errors, the first 40 shown")
    );
}

#[test]
fn random_units_never_panic() {
    let parts = [
        "1", "-", "e", "5", ".", " ", "m", "k", "N", "/", "*", "^", "³", "⁻", "²", "s", "µ", "°", "%", "g",
        "9", "é", ",",
    ];
    let mut random = Random(7);
    for _ in 0..20_000 {
        let text: String = (0..random.below(9)).map(|_| parts[random.below(parts.len())]).collect();
        for dimension in [Dimension::LENGTH, Dimension::NONE, Dimension::UNIT_WEIGHT] {
            match units::parse(&text, dimension) {
                Ok(x) => assert!(x.is_finite(), "{text}"),
                Err(e) => assert!(!e.to_string().is_empty() && !e.remedy("").is_empty()),
            }
        }
    }
}
