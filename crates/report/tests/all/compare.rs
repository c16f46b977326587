//! Runs beside one another: what is equal, what is larger, and what only one of them has.

use std::fs;
use std::path::{Path, PathBuf};

use tremolite_report::{Language, compare};
use tremolite_results::{
    Column, Conclusion, MonitorFacts, ResultFolder, Status, Summary, Table, TableWriter, peaks_by_monitor,
};

/// A run whose monitor A swings with this size \[m\], with rows at this interval \[s\].
fn run(root: &Path, size: f64, interval: f64, case: &str) -> PathBuf {
    let folder = ResultFolder::create(Some(root), "case", false).unwrap();
    let columns = [Column::new("time", "s"), Column::new("A.ux", "m"), Column::new("A.s1", "Pa")];
    let mut table = TableWriter::create(&folder.monitors(), &columns).unwrap();
    for k in 0..=200 {
        let t = interval * f64::from(k);
        table.write(&[t, size * (1.5 * t).sin(), 1e6]).unwrap();
    }
    let [monitors, _] = peaks_by_monitor(&Table::read(&folder.monitors()).unwrap());
    let summary = Summary {
        title: "A run".into(),
        conclusion: Conclusion { status: Status::Done, ..Conclusion::default() },
        monitors: MonitorFacts { peaks: monitors, ..MonitorFacts::default() },
        ..Summary::default()
    };
    summary.write(&folder.summary()).unwrap();
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
        text.replace(" <span class=\"note\">", " | ").replace("</span>", "").replace('\u{a0}', " ")
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

#[test]
fn a_run_that_is_not_done_says_so_and_is_compared_as_far_as_it_came() {
    let temp = tempfile::tempdir().unwrap();
    let [done, stopped, failed, gone] =
        ["done", "stopped", "failed", "gone"].map(|name| run(&temp.path().join(name), 0.04, 0.01, "a"));
    let both = [done.clone(), done.clone()];
    assert!(!page(&both, temp.path()).contains("Not run to the end"));
    for (folder, status) in [(&stopped, Status::Stopped), (&failed, Status::Failed)] {
        let mut summary = Summary::read(&folder.join("summary.json")).unwrap();
        summary.conclusion.status = status;
        summary.write(&folder.join("summary.json")).unwrap();
    }
    fs::remove_file(gone.join("summary.json")).unwrap();
    // Of 201 rows 51 are left, and the motion was to last 2 s.
    let rows = fs::read_to_string(stopped.join("monitors.csv")).unwrap();
    let rows: Vec<&str> = rows.lines().take(52).collect();
    fs::write(stopped.join("monitors.csv"), rows.join("\n") + "\n").unwrap();
    fs::write(stopped.join("motion.csv"), "time [s],given.ax [m/s2]\n0,0\n2,0\n").unwrap();
    let folders = [done, stopped, failed, gone];
    let page = page(&folders, temp.path());
    assert!(page.contains("Not run to the end: stopped, failed, gone."));
    let ended = page.split("<td>how it ended</td>").nth(1).unwrap().split("</tr>").next().unwrap();
    for text in [">done<", ">stopped <span class=\"note\">at 0.5 of 2\u{a0}s<", ">failed <", ">no summary <"]
    {
        assert!(ended.contains(text), "{text} in {ended}");
    }
    assert_eq!(row(&page, "Histories: largest difference", "A ux"), ["= | up to 0.5 s", "=", "="]);
    let chinese = temp.path().join("zh.html");
    compare(&folders, &chinese, Some(Language::Chinese)).unwrap();
    let chinese = fs::read_to_string(chinese).unwrap();
    for text in
        ["未计算到终点：stopped, failed, gone。", "已停止", "共 2\u{a0}s", "失败", "无摘要", "至 0.5\u{a0}s<"]
    {
        assert!(chinese.contains(text), "{text}");
    }
}

/// A section without resistance uses infinitely much, which is not the same as no result.
#[test]
fn an_infinite_utilisation_is_told_and_is_no_dash() {
    let temp = tempfile::tempdir().unwrap();
    let all = [f64::INFINITY, 0.75].map(|value| {
        let root = run(&temp.path().join(format!("to-{value}")), 0.04, 0.01, "a");
        let at = root.join("summary.json");
        let mut summary = Summary::read(&at).unwrap();
        summary.parts.sections.insert("hall.lining".into(), super::sheets::judged(value));
        summary.write(&at).unwrap();
        root
    });
    let page = page(&all, temp.path());
    assert_eq!(
        row(&page, "Utilisation of sections", "hall.<wbr>lining: thrust and moment"),
        ["∞", "0.750 | –"]
    );
    assert_eq!(row(&page, "Utilisation of sections", "hall.<wbr>lining: shear"), ["0.432", "0.432 | ="]);
}
