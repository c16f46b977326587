//! Tables survive being read while they grow, being cut, and being resumed.

use std::fs;
use std::path::PathBuf;
use std::time::Instant;

use tremolite_results::{Column, Error, Extent, Table, TableWriter};

fn columns() -> Vec<Column> {
    vec![Column::new("time", "s"), Column::new("A.ux", "m"), Column::new("A.d_b", "")]
}

fn file(content: &[u8]) -> (tempfile::TempDir, PathBuf) {
    let temp = tempfile::tempdir().unwrap();
    let path = temp.path().join("t.csv");
    fs::write(&path, content).unwrap();
    (temp, path)
}

#[test]
fn the_file_is_what_the_contract_says_and_readable_after_every_batch() {
    let (_temp, path) = file(b"");
    let mut writer = TableWriter::create(&path, &columns()).unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), "time [s],A.ux [m],A.d_b\n");
    writer.write(&[0.0, -1.25e-5, f64::NAN]).unwrap();
    writer.write(&[0.1, 0.048, 0.5, 0.2, 1e-320, f64::INFINITY]).unwrap();
    assert_eq!(
        fs::read_to_string(&path).unwrap(),
        "time [s],A.ux [m],A.d_b\n0,-1.25e-5,NaN\n0.1,0.048,0.5\n0.2,1e-320,inf\n"
    );
    assert_eq!(writer.extent().bytes, fs::metadata(&path).unwrap().len());
    let table = Table::read(&path).unwrap();
    assert_eq!(table.columns, columns());
    assert_eq!(table.column("time"), Some(&[0.0, 0.1, 0.2][..]));
    assert_eq!(table.column("A.ux"), Some(&[-1.25e-5, 0.048, 1e-320][..]));
    assert_eq!(table.unit("A.ux"), Some("m"));
    assert!(table.column("A.d_b").unwrap()[0].is_nan());
    assert_eq!((table.column("B.ux"), table.rows(), table.cut), (None, 3, false));
}

#[test]
fn a_line_that_is_being_written_is_left_out() {
    // Even where the cut number still parses: 12 may have been 125.
    for tail in ["0.2,12", "0.2", "0.2,", "0", "0.2,12,0.5"] {
        let (_temp, path) = file(format!("time [s],A.ux [m],A.d_b\n0.1,1,2\n{tail}").as_bytes());
        let table = Table::read(&path).unwrap();
        assert_eq!((table.rows(), table.cut), (1, true));
    }
}

#[test]
fn resuming_gives_the_bytes_of_the_uninterrupted_run() {
    let (_temp, path) = file(b"");
    let mut writer = TableWriter::create(&path, &columns()).unwrap();
    writer.write(&[0.0, 1.0, 2.0]).unwrap();
    let checkpoint = writer.extent();
    writer.sync().unwrap();
    writer.write(&[0.1, 1.1, 2.2]).unwrap();
    let whole = fs::read(&path).unwrap();
    // The killed run had written further, and in the middle of a line.
    fs::write(&path, [&whole[..], b"0.2,1."].concat()).unwrap();
    let mut writer = TableWriter::resume(&path, &columns(), checkpoint).unwrap();
    writer.write(&[0.1, 1.1, 2.2]).unwrap();
    assert_eq!(fs::read(&path).unwrap(), whole);
    assert_eq!(writer.extent().bytes, whole.len() as u64);
}

#[test]
fn resuming_refuses_a_file_that_is_not_the_checkpoints_and_leaves_it_alone() {
    let (_temp, path) = file(b"");
    let mut writer = TableWriter::create(&path, &columns()).unwrap();
    writer.write(&[0.0, 1.0, 2.0]).unwrap();
    let known = writer.extent();
    let content = fs::read(&path).unwrap();
    let told =
        |columns: &[Column], extent| TableWriter::resume(&path, columns, extent).unwrap_err().to_string();
    let of_bytes = |bytes| told(&columns(), Extent { bytes, ..known });
    let shorter = of_bytes(known.bytes + 1);
    assert!(shorter.contains("30 bytes long, but the checkpoint was made at 31"), "{shorter}");
    assert!(of_bytes(known.bytes - 1).contains("not the table of the run"), "inside a row");
    assert!(of_bytes(0).contains("not the table of the run"), "before the headers");
    assert!(told(&columns()[..2], known).contains("not the table of the run"), "other columns");
    let changed = told(&columns(), Extent { crc: !known.crc, ..known });
    assert!(changed.contains("changed since the checkpoint was made"), "{changed}");
    assert_eq!(fs::read(&path).unwrap(), content);
}

#[test]
fn damaged_tables_are_refused_with_their_line() {
    for (content, line) in [
        (&b""[..], 1),
        (b"time [s]", 1),
        (b"\n1\n", 1),
        (b"time [s],a\n1,2\n1\n", 3),
        (b"time [s],a\n1,2\n1,2,3\n", 3),
        (b"time [s],a\n\n1,two\n", 3),
        (b"time [s]\n1\n\xff\xfe\n", 3),
    ] {
        let (_temp, path) = file(content);
        match Table::read(&path) {
            Err(Error::Format { line: Some(found), .. }) => assert_eq!(found, line, "{content:?}"),
            other => panic!("{content:?} gave {other:?}"),
        }
    }
    assert!(matches!(Table::read("nowhere/t.csv".as_ref()), Err(Error::Io { .. })));
}

#[test]
fn headers_of_other_programs_are_understood() {
    let (_temp, path) = file("\u{feff}time [s], 拱顶.ux [m] ,plain\r\n1, 2 ,3\r\n".as_bytes());
    let table = Table::read(&path).unwrap();
    assert_eq!(table.columns[1], Column::new("拱顶.ux", "m"));
    assert_eq!(table.columns[2], Column::new("plain", ""));
    assert_eq!(table.column("拱顶.ux"), Some(&[2.0][..]));
}

#[test]
fn names_that_would_break_the_file_are_refused_before_it_is_touched() {
    let (_temp, path) = file(b"keep");
    for name in ["", "a b", "a,b", "a\nb", "a\"b", "a[b", "\u{7}"] {
        let error = TableWriter::create(&path, &[Column::new(name, "m")]).unwrap_err();
        assert!(matches!(error, Error::Format { .. }), "{name:?}");
    }
    assert!(TableWriter::create(&path, &[Column::new("a", "m,\n")]).is_err());
    assert!(TableWriter::create(&path, &[Column::new("a", "m"), Column::new("a", "s")]).is_err());
    assert!(TableWriter::create(&path, &[]).is_err());
    assert_eq!(fs::read(&path).unwrap(), b"keep");
}

/// Ten thousand monitors have 190,000 columns, each of which is asked for: that takes no longer than to read them.
#[test]
fn all_of_many_columns_are_found_in_the_time_that_it_takes_to_read_them() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("many.csv");
    let names: Vec<String> = (0..50_000).map(|k| format!("monitor_{k}_velocity")).collect();
    let numbers: Vec<String> = (0..names.len()).map(|k| k.to_string()).collect();
    std::fs::write(&path, format!("{},monitor_7_velocity\n{},-1\n", names.join(","), numbers.join(",")))
        .unwrap();
    let begin = Instant::now();
    let table = Table::read(&path).unwrap();
    let read = begin.elapsed();
    let begin = Instant::now();
    for (k, name) in names.iter().enumerate() {
        assert_eq!(table.column(name).unwrap(), [k as f64], "the first of a name");
        assert!(table.column(&format!("{name}_of_nobody")).is_none());
    }
    // One by one they take a hundred times as long.
    assert!(begin.elapsed() < 10 * read, "{:?} to read, {:?} to find", read, begin.elapsed());
}
