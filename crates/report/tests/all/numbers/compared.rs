//! The comparison's numbers are those of the summaries, and its differences theirs.

use std::fs;

use tremolite_report::{Language, compare};
use tremolite_results::Summary;

use super::super::{interface_results, report};
use super::known::{Kind, Known};
use super::scaled::scaled;
use super::tokens::{Token, factor_of, tokens};

#[test]
fn both_runs_numbers_are_their_own_and_differences_are_of_the_two() {
    let temp = tempfile::tempdir().unwrap();
    for (kind, number) in [("shaken", 10), ("joint", 7)] {
        let root = temp.path().join(kind);
        if kind == "shaken" {
            let folder = report::results(&root, &["A", "B"]);
            let mut summary = Summary::read(&folder.summary()).unwrap();
            summary.parts.damage.insert("hall.lining".into(), report::cracked());
            summary.soundness.energy = [("input".to_owned(), 2e5), ("error".to_owned(), -300.0)].into();
            summary.write(&folder.summary()).unwrap();
        } else {
            interface_results::results(&root);
        }
        let at = [0, 1].map(|copy| temp.path().join(format!("{kind}-{copy}")));
        let known = [0, 1].map(|copy| scaled(&root, &at[copy as usize], copy).known);
        let page = temp.path().join("comparison.html");
        compare(&at, &page, Some(Language::English)).unwrap();
        let page = fs::read_to_string(page).unwrap();
        let (_, part) = page.split_once("<section id=\"numbers\">").unwrap();
        let (part, _) = part.split_once("Histories: largest difference").unwrap_or((part, ""));
        // Runs are compared by rows: the first's number, the second's, the difference.
        let mut rows = 0;
        for table in part.split("<table").skip(1) {
            let (_, unit) =
                table.split_once("<th>(").map_or(("", ""), |(a, rest)| (a, rest.split(')').next().unwrap()));
            let factor = factor_of(&unit.replace("&#x2f;", "/")).unwrap_or(1.0);
            for row in table.split("<tr>").skip(2) {
                let (label, cells) = row.split_once("</td>").unwrap();
                let found = tokens(&format!("<main>{cells}</main>"), &[]);
                let [first, second, apart] = &found[..] else {
                    // Equal small counts.
                    assert!(
                        found.len() == 2 && found[0].value == found[1].value && cells.contains(">=<"),
                        "{label}: {cells}"
                    );
                    continue;
                };
                check(&known, factor, unit == "%", [first, second, apart])
                    .unwrap_or_else(|| panic!("{label}: {cells}"));
                rows += 1;
            }
        }
        assert!(rows >= number, "{kind}: {rows}");
    }
}

/// Nothing where no one number, or share of two, of the summaries is shown, each run's own.
fn check(known: &[Vec<Known>; 2], factor: f64, share: bool, shown: [&Token; 3]) -> Option<()> {
    let near = |token: &Token, value: f64| (token.value - value).abs() <= 1.000_001 * token.half;
    let fits = |a: f64, b: f64| {
        let percent = 100.0 * (b.abs() - a.abs()) / a.abs();
        near(shown[0], factor * a) && near(shown[1], factor * b) && near(shown[2], percent)
    };
    let leaves: Vec<(f64, f64)> = known[0]
        .iter()
        .zip(&known[1])
        .filter(|(a, _)| a.kind <= Kind::Extreme && a.value != 0.0)
        .map(|(a, b)| (a.value, b.value))
        .collect();
    let of_one = leaves.iter().any(|(a, b)| fits(*a, *b));
    let of_two = || leaves.iter().any(|(a, b)| leaves.iter().any(|(x, y)| fits(a / x, b / y)));
    (of_one || (share && of_two())).then_some(())
}
