//! Runs beside one another: what is equal, what is larger, and what only one of them has.

use std::fs;
use std::path::{Path, PathBuf};

use tremolite_report::compare;
use tremolite_results::{Column, ResultFolder, Summary, Table, TableWriter, peaks_by_monitor};

/// A run whose monitor A swings with this size \[m\], with rows at this interval \[s\].
fn run(root: &Path, size: f64, interval: f64, case: &str) -> PathBuf {
    let folder = ResultFolder::create(Some(root), "case", false).unwrap();
    let columns = [Column::new("time", "s"), Column::new("A.ux", "m"), Column::new("A.s1", "Pa")];
    let mut table = TableWriter::create(&folder.monitors(), &columns).unwrap();
    for k in 0..=200 {
        let t = interval * f64::from(k);
        table.write(&[t, size * (1.5 * t).sin(), 1e6]).unwrap();
    }
    let monitors = peaks_by_monitor(&Table::read(&folder.monitors()).unwrap());
    Summary { title: "A run".into(), monitors, ..Summary::default() }.write(&folder.summary()).unwrap();
    fs::write(folder.root().join("case.toml"), case).unwrap();
    folder.root().to_owned()
}

fn page(folders: &[PathBuf], at: &Path) -> String {
    let page = at.join("comparison.html");
    compare(folders, &page, None).unwrap();
    fs::read_to_string(page).unwrap()
}

/// The texts of the row that begins with `label`, tags taken away, in the table under `heading`.
fn row(page: &str, heading: &str, label: &str) -> Vec<String> {
    let part = page.split(&format!("<h3>{heading}")).nth(1).unwrap_or_else(|| panic!("no {heading}"));
    let part = part.split("</table>").next().unwrap();
    let row = part.split("<tr>").find(|row| row.contains(&format!("<td>{label}</td>"))).expect("the row");
    let cells = row.split("<td").skip(2);
    let text = |cell: &str| {
        let (_, text) = cell.split_once('>').unwrap();
        let (text, _) = text.split_once("</td>").unwrap();
        text.replace("<span class=\"note\">", " | ").replace("</span>", "").replace('\u{a0}', " ")
    };
    cells.map(text).collect()
}

#[test]
fn sizes_differ_by_so_many_percent_and_what_is_equal_says_so() {
    let temp = tempfile::tempdir().unwrap();
    let case = "title = 'a'\n[material.rock]\nyoung = '10 GPa'\n";
    let soft = run(&temp.path().join("soft"), 0.04, 0.01, case);
    let stiff = run(&temp.path().join("stiff"), -0.05, 0.01, &case.replace("10", "20"));
    let same = run(&temp.path().join("same"), 0.04, 0.01, case);
    let late = run(&temp.path().join("late"), 0.04, 0.02, case);
    let page = page(&[soft, stiff, same, late], temp.path());
    let found = row(&page, "Largest displacement of monitors", "A ux");
    assert_eq!(found[..3], ["40.0", "−50.0 | ⇄ +25 %", "40.0 | ="], "{found:?}");
    // The history turned round and a quarter larger is 2.25 of the first's size away; other times are not compared.
    let apart = row(&page, "Histories: largest difference", "A ux");
    assert_eq!(apart, ["225 %", "=", "–"]);
    assert!(
        page.contains("<span class=\"gone\">young = &#x27;10 GPa&#x27;")
            && page.contains("<span class=\"new\">young")
    );
    assert!(page.contains("Nothing: both folders hold the same case."));
}

#[test]
fn what_only_one_run_has_is_a_dash_and_no_fault() {
    let temp = tempfile::tempdir().unwrap();
    let whole = run(&temp.path().join("whole"), 0.04, 0.01, "a");
    let bare = run(&temp.path().join("bare"), 0.04, 0.01, "a");
    fs::remove_file(bare.join("monitors.csv")).unwrap();
    Summary::default().write(&bare.join("summary.json")).unwrap();
    let page = page(&[whole, bare], temp.path());
    assert_eq!(row(&page, "Largest displacement of monitors", "A ux"), ["40.0", "–"]);
    assert!(page.contains("bare: There is no monitors.csv"));
    assert!(!page.contains("<figure>"), "one run alone has nothing to lie over");
    assert!(compare(&[temp.path().join("none")], &temp.path().join("x.html"), None).is_err());
}
