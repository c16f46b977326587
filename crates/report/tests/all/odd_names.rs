//! Monitors may be called as pairs are, and with dots: the page goes by whose the columns are, not by their names.

use std::fs;

use tremolite_report::write;
use tremolite_results::{
    Column, MonitorFacts, ResultFolder, Subject, Summary, Table, TableWriter, columns, peaks_by_monitor,
};

/// Of four monitors and two pairs, one monitor being called as the pair of two others would be.
fn results(folder: &ResultFolder) {
    let monitor = |name: &str| Subject::Monitor(name.to_owned());
    let of = |subject: Subject| {
        ["ux", "temperature"].map(|quantity| Column::of(subject.clone(), quantity, "m")).to_vec()
    };
    let all = ["hall", "a.1", "hall-a.1", "b.ux"].map(|name| of(monitor(name))).concat();
    let pair = |[first, second]: [&str; 2]| {
        let subject = Subject::Relative([first.into(), second.into()]);
        ["ux", "u"].map(|quantity| Column::of(subject.clone(), quantity, "m"))
    };
    let pairs = [["hall-a.1", "a.1"], ["hall", "b.ux"]].map(pair).concat();
    let columns = [&[Column::new("time", "s")], &all[..], &pairs].concat();
    let mut table = TableWriter::create(&folder.monitors(), &columns).unwrap();
    for step in 0..=10 {
        let t = f64::from(step) / 10.0;
        let row: Vec<f64> = (0..columns.len()).map(|k| if k == 0 { t } else { k as f64 * t }).collect();
        table.write(&row).unwrap();
    }
}

/// What a figure names in its legends, of these names.
fn named<'n>(folder: &ResultFolder, figure: &str, names: &[&'n str]) -> Vec<&'n str> {
    let svg = fs::read_to_string(folder.figures().join(figure)).unwrap();
    names.iter().copied().filter(|name| svg.contains(&format!(">{name}</text>"))).collect()
}

const ALL: [&str; 6] = ["hall", "a.1", "hall-a.1", "b.ux", "hall-a.1-a.1", "hall-b.ux"];

#[test]
fn monitors_and_pairs_are_drawn_as_what_they_are_whatever_they_are_called() {
    let temp = tempfile::tempdir().unwrap();
    let folder = ResultFolder::create(Some(temp.path()), "case", false).unwrap();
    results(&folder);
    write(folder.root()).unwrap();
    assert_eq!(named(&folder, "displacement.svg", &ALL), ALL[..4]);
    assert_eq!(named(&folder, "further-1.svg", &ALL), ALL[..4]);
    assert_eq!(named(&folder, "relative.svg", &ALL), ALL[4..]);

    // By names alone the third would be the pair of the first two.
    fs::remove_file(columns::beside(&folder.monitors())).unwrap();
    write(folder.root()).unwrap();
    assert_eq!(named(&folder, "displacement.svg", &ALL), [ALL[0], ALL[1], ALL[3]]);
}

#[test]
fn a_pair_with_a_loose_monitor_is_found_by_its_monitors_not_by_its_name() {
    let temp = tempfile::tempdir().unwrap();
    let folder = ResultFolder::create(Some(temp.path()), "case", false).unwrap();
    results(&folder);
    let [monitors, relative] = peaks_by_monitor(&Table::read(&folder.monitors()).unwrap());
    let page = |loose: &str| {
        let summary = Summary {
            monitors: MonitorFacts {
                peaks: monitors.clone(),
                relative: relative.clone(),
                on_broken_elements: vec![loose.to_owned()],
                ..MonitorFacts::default()
            },
            ..Summary::default()
        };
        summary.write(&folder.summary()).unwrap();
        fs::read_to_string(write(folder.root()).unwrap()).unwrap()
    };
    let left_out = "Not counted: hall-a.1-a.1";
    assert!(page("hall-a.1").contains(left_out) && page("a.1").contains(left_out));
    let of_others = page("hall");
    assert!(of_others.contains("Not counted: hall-b.ux, of"), "that of hall");
}
