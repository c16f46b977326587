//! Names of monitors may hold dots and hyphens: whose a column is, its file tells.

use std::fs;

use tremolite_results::{
    Column, Error, ResultFolder, Subject, Table, TableWriter, columns, peaks_by_monitor,
};

fn all() -> Vec<Column> {
    let [first, second] = ["a.b-c", "d-e.ux"].map(str::to_owned);
    vec![
        Column::new("time", "s"),
        Column::of(Subject::Monitor(first.clone()), "ux", "m"),
        Column::of(Subject::Monitor(second.clone()), "ux", "m"),
        Column::of(Subject::Relative([first, second]), "u", "m"),
        Column::of(Subject::Pair("j".into()), "state", "1"),
        Column::of(Subject::Bolt("k".into()), "force", "N"),
        Column::of(Subject::Interface("f-g.h".into()), "open", "m2"),
        Column::of(Subject::Group("hall.lining".into()), "d_tension", "m3/m3"),
        Column::of(Subject::Column("reference".into()), "top.vx_theory", "m/s"),
        Column::of(Subject::Model, "surface.vx", "m/s"),
        Column::of(Subject::Edge("xmin-ymin".into()), "base.vx", "m/s"),
        Column::of(Subject::Moved("plate".into()), "reaction_x", "N"),
    ]
}

#[test]
fn whose_columns_are_comes_back_as_it_was_written_whatever_the_names() {
    let temp = tempfile::tempdir().unwrap();
    let folder = ResultFolder::create(Some(&temp.path().join("out")), "x", false).unwrap();
    let mut writer = TableWriter::create(&folder.monitors(), &all()).unwrap();
    writer.write(&[0.5; 12]).unwrap();
    assert!(fs::read_to_string(folder.monitors()).unwrap().starts_with(
        "time [s],a.b-c.ux [m],d-e.ux.ux [m],a.b-c-d-e.ux.u [m],j.state [1],k.force [N],f-g.h.open [m2],"
    ));
    let table = Table::read(&folder.monitors()).unwrap();
    assert_eq!(table.columns, all());
    let [monitors, relative] = peaks_by_monitor(&table);
    assert_eq!(monitors.keys().take(3).collect::<Vec<_>>(), ["a.b-c", "d-e.ux", "j"]);
    assert_eq!(relative["a.b-c-d-e.ux"].keys().collect::<Vec<_>>(), ["u"]);
    let text = fs::read_to_string(folder.root().join("monitors.columns.json")).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[1], r#"{"name":"time","subject":"none","quantity":"time","unit":"s"},"#);
    assert_eq!(
        lines[4],
        r#"{"name":"a.b-c-d-e.ux.u","subject":"pair of monitors","of":["a.b-c","d-e.ux"],"quantity":"u","unit":"m"},"#
    );
    drop(folder);

    // A run that replaces this one may have no such table.
    let folder = ResultFolder::create(Some(&temp.path().join("out")), "x", true).unwrap();
    assert!(!columns::beside(&folder.monitors()).exists());
}

#[test]
fn a_table_of_nobodys_columns_has_no_such_file_and_leaves_none_behind() {
    let temp = tempfile::tempdir().unwrap();
    let path = temp.path().join("energy.csv");
    TableWriter::create(&path, &all()).unwrap();
    assert!(columns::beside(&path).exists());
    TableWriter::create(&path, &all()[..1]).unwrap();
    assert!(!columns::beside(&path).exists());
    assert_eq!(Table::read(&path).unwrap().columns, all()[..1]);
}

#[test]
fn a_file_of_other_columns_is_refused() {
    let temp = tempfile::tempdir().unwrap();
    let path = temp.path().join("monitors.csv");
    TableWriter::create(&path, &all()).unwrap();
    for text in ["", "[{\"name\": 3}]", "[]", "[{\"name\":\"time\",\"subject\":\"ghost\"}]"] {
        fs::write(columns::beside(&path), text).unwrap();
        let error = Table::read(&path).unwrap_err();
        assert!(
            matches!(&error, Error::Format { path, .. } if path.ends_with("monitors.columns.json")),
            "{text}: {error}"
        );
    }
}

#[test]
fn tables_of_older_versions_go_by_their_names() {
    let of = |table: &str, headers: &str| {
        let temp = tempfile::tempdir().unwrap();
        let path = temp.path().join(table);
        fs::write(&path, format!("time [s],{headers}\n")).unwrap();
        let columns = Table::read(&path).unwrap().columns;
        columns.into_iter().skip(1).map(|column| (column.subject, column.quantity)).collect::<Vec<_>>()
    };
    let monitor = |name: &str| Subject::Monitor(name.to_owned());
    let pair = Subject::Relative(["a-b".into(), "c.d".into()]);
    assert_eq!(
        of("monitors.csv", "a-b.ux [m],c.d.ux [m],a-b-c.d.u [m],J.gap [m],J.pressure [Pa],J.shear1 [Pa]")
            [..4],
        [
            (monitor("a-b"), "ux".to_owned()),
            (monitor("c.d"), "ux".to_owned()),
            (pair, "u".to_owned()),
            (Subject::Pair("J".into()), "gap".to_owned())
        ]
    );
    assert_eq!(
        of("monitors.csv", "K.force [N],K.force_over_yield [1]")[0],
        (Subject::Bolt("K".into()), "force".to_owned())
    );
    assert_eq!(
        of("interfaces.csv", "j.1.open [m2]"),
        [(Subject::Interface("j.1".into()), "open".to_owned())]
    );
    assert_eq!(
        of("spectra.csv", "given.ax [m/s2],A.ax [m/s2],A.free_field.ax [m/s2]"),
        [
            (Subject::None, "given.ax".to_owned()),
            (monitor("A"), "ax".to_owned()),
            (monitor("A"), "free_field.ax".to_owned())
        ]
    );
    assert_eq!(of("energy.csv", "input [J]"), [(Subject::None, "input".to_owned())]);
}
