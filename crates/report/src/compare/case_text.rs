//! What the runs' cases say otherwise, line by line.

use std::fs;

use serde::Serialize;
use similar::{ChangeTag, TextDiff};

use super::Run;

/// Lines around a change that are shown with it.
const AROUND: usize = 2;

/// How a run's case differs from the first's.
#[derive(Serialize)]
pub struct Changes {
    pub run: String,
    /// Nothing where the two are the same.
    pub lines: Vec<CaseLine>,
}

/// A line of the comparison.
#[derive(Serialize)]
pub struct CaseLine {
    /// `gone` from the first run's case, `new` in this one's, `same` in both, `left` for what is passed over.
    pub class: &'static str,
    pub text: String,
}

/// Of every run but the first; nothing for a run whose folder holds no case.
pub fn changes(runs: &[Run]) -> Vec<Changes> {
    let case = |run: &Run| fs::read_to_string(run.source.folder.root().join("case.toml")).ok();
    let Some(first) = runs.first().and_then(case) else { return Vec::new() };
    let others = runs.iter().skip(1).filter_map(|run| Some((run, case(run)?)));
    others.map(|(run, text)| Changes { run: run.name.clone(), lines: lines(&first, &text) }).collect()
}

fn lines(first: &str, other: &str) -> Vec<CaseLine> {
    let difference = TextDiff::from_lines(first, other);
    let mut lines = Vec::new();
    for group in difference.grouped_ops(AROUND) {
        if !lines.is_empty() {
            lines.push(CaseLine { class: "left", text: "…".into() });
        }
        for change in group.iter().flat_map(|op| difference.iter_changes(op)) {
            let class = match change.tag() {
                ChangeTag::Delete => "gone",
                ChangeTag::Insert => "new",
                ChangeTag::Equal => "same",
            };
            lines.push(CaseLine { class, text: change.value().trim_end().to_owned() });
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_changed_line_is_shown_with_its_neighbours() {
        let first = "a\nb\nc\nd\ne\nf\n";
        let shown = lines(first, &first.replace('d', "D"));
        let text: Vec<(&str, &str)> = shown.iter().map(|l| (l.class, l.text.as_str())).collect();
        assert_eq!(
            text,
            [("same", "b"), ("same", "c"), ("gone", "d"), ("new", "D"), ("same", "e"), ("same", "f")]
        );
        assert!(lines(first, first).is_empty());
    }
}
