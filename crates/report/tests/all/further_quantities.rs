//! What monitors record beyond the quantities that the page knows by name is drawn too.

use std::fs;

use tremolite_report::write;
use tremolite_results::{Column, ResultFolder, TableWriter};

/// The columns of a monitor today, with their units.
const TODAY: [(&str, &str); 18] = [
    ("ux", "m"),
    ("uy", "m"),
    ("uz", "m"),
    ("vx", "m/s"),
    ("vy", "m/s"),
    ("vz", "m/s"),
    ("ax", "m/s2"),
    ("ay", "m/s2"),
    ("az", "m/s2"),
    ("sxx", "Pa"),
    ("syy", "Pa"),
    ("szz", "Pa"),
    ("sxy", "Pa"),
    ("syz", "Pa"),
    ("szx", "Pa"),
    ("s1", "Pa"),
    ("s2", "Pa"),
    ("s3", "Pa"),
];

/// Results of two monitors and their pair, with these columns of each monitor.
fn results(folder: &ResultFolder, quantities: &[(&str, &str)]) {
    let mut columns = vec![Column::new("time", "s")];
    for monitor in ["A", "B"] {
        columns.extend(quantities.iter().map(|(q, unit)| Column::new(format!("{monitor}.{q}"), *unit)));
    }
    columns.extend(["ux", "u"].map(|q| Column::new(format!("A-B.{q}"), "m")));
    let mut table = TableWriter::create(&folder.monitors(), &columns).unwrap();
    for step in 0..=100 {
        let t = f64::from(step) / 100.0;
        let row: Vec<f64> = (0..columns.len()).map(|k| if k == 0 { t } else { k as f64 * t }).collect();
        table.write(&row).unwrap();
    }
}

/// The headings of the page's figures of histories, and the files of further quantities with their content.
fn drawn(quantities: &[(&str, &str)]) -> (Vec<String>, Vec<(String, String)>) {
    let temp = tempfile::tempdir().unwrap();
    let folder = ResultFolder::create(Some(temp.path()), "case", false).unwrap();
    results(&folder, quantities);
    let page = fs::read_to_string(write(folder.root()).unwrap()).unwrap();
    let headings = page.split("<h2>").skip(1).filter_map(|rest| rest.split_once("</h2>"));
    let headings = headings.map(|(heading, _)| heading.to_owned()).collect();
    let mut files: Vec<(String, String)> = fs::read_dir(folder.figures())
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), path))
        .filter(|(name, _)| name.starts_with("further-"))
        .map(|(name, path)| (name, fs::read_to_string(path).unwrap()))
        .collect();
    files.sort();
    (headings, files)
}

#[test]
fn a_new_quantity_gets_a_figure_of_its_own_behind_those_of_today() {
    let (before, today) = drawn(&TODAY);
    assert_eq!(today.len(), 3, "components of the stress, three and three, and s2");
    for (names, (_, svg)) in [&["sxx", "syy", "szz"][..], &["sxy", "syz", "szx"], &["s2"]].iter().zip(&today)
    {
        assert!(names.iter().all(|name| svg.contains(&format!(">{name} (Pa)</text>"))), "{names:?}");
    }

    // In the middle of the table, at its end, without a unit, and with a name that is none of a file.
    let mut more = TODAY.to_vec();
    more.insert(9, ("temperature", "K"));
    more.extend([("p/w", "Pa"), ("saturation", "")]);
    let (after, all) = drawn(&more);
    assert_eq!(all.len(), 6);
    let names = |files: &[(String, String)]| files.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>();
    assert_eq!(names(&all[..3]), names(&today), "what is drawn today keeps its files");
    for (label, (name, svg)) in ["temperature (K)", "p/w (Pa)", "saturation"].iter().zip(&all[3..]) {
        assert!(svg.contains(&format!(">{label}</text>")), "{name}: {label}");
        assert!(svg.contains(">A</text>") && svg.contains(">B</text>"), "{name}: a line for each monitor");
        assert!(!svg.contains("A-B"), "{name}: pairs are drawn with displacement alone");
        assert_eq!(svg.matches("font-weight").count(), today[2].1.matches("font-weight").count(), "{name}");
    }
    let new: Vec<&String> = after.iter().filter(|heading| !before.contains(heading)).collect();
    assert_eq!(new, ["temperature", "p&#x2f;w", "saturation"]);
    assert!(before.iter().all(|heading| after.contains(heading)));
}
