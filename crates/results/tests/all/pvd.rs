//! The collection of field files is complete at any moment and can be resumed.

use std::fs;

use tremolite_results::{Error, Pvd, Snapshot};

#[test]
fn snapshots_are_written_at_once_and_the_later_ones_leave_on_resume() {
    let temp = tempfile::tempdir().unwrap();
    let path = temp.path().join("fields.pvd");
    let mut pvd = Pvd::create(&path).unwrap();
    assert!(Pvd::read(&path).unwrap().snapshots().is_empty());
    for (i, time) in [0.0, 0.1 + 0.2, 0.5].into_iter().enumerate() {
        pvd.add(time, &format!("fields/{i:04}.vtu")).unwrap();
    }
    assert_eq!(
        fs::read_to_string(&path).unwrap(),
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n\
         <DataSet timestep=\"0\" part=\"0\" file=\"fields/0000.vtu\"/>\n\
         <DataSet timestep=\"0.30000000000000004\" part=\"0\" file=\"fields/0001.vtu\"/>\n\
         <DataSet timestep=\"0.5\" part=\"0\" file=\"fields/0002.vtu\"/>\n</Collection>\n</VTKFile>\n"
    );
    assert_eq!(Pvd::read(&path).unwrap(), pvd);
    // A snapshot at the very time of the checkpoint stays: times keep their bits.
    let resumed = Pvd::resume(&path, 0.1 + 0.2).unwrap();
    assert_eq!(resumed.snapshots().len(), 2);
    assert_eq!(Pvd::read(&path).unwrap(), resumed);
    assert_eq!(resumed.locate(&resumed.snapshots()[1]), temp.path().join("fields/0001.vtu"));
}

#[test]
fn collections_of_other_programs_and_odd_names_are_read() {
    let temp = tempfile::tempdir().unwrap();
    let path = temp.path().join("x.pvd");
    let mut pvd = Pvd::create(&path).unwrap();
    pvd.add(1.0, "fields/a&b\"<c>.vtu").unwrap();
    assert_eq!(Pvd::read(&path).unwrap(), pvd);
    fs::write(
        &path,
        "<VTKFile><Collection><DataSet file='a.vtu' group='' timestep=' 2.5e-1 '/></Collection></VTKFile>",
    )
    .unwrap();
    let read = Pvd::read(&path).unwrap();
    assert_eq!(read.snapshots(), [Snapshot { time: 0.25, file: "a.vtu".into() }]);
}

#[test]
fn damaged_collections_are_refused_with_the_line() {
    let temp = tempfile::tempdir().unwrap();
    let path = temp.path().join("x.pvd");
    for (content, at) in [
        ("", 1),
        ("<VTKFile>\n<Collection>\n</VTKFile>", 3),
        ("<VTKFile>\n\n<DataSet file='a'/></VTKFile>", 3),
        ("<VTKFile>\n<DataSet timestep='soon' file='a'/></VTKFile>", 2),
        ("<VTKFile>\n<DataSet timestep='nan' file='a'/></VTKFile>", 2),
        ("<VTKFile>\n<DataSet timestep='0' file='../a'/></VTKFile>", 2),
        ("<VTKFile>\n<DataSet timestep='0' file='/dev/zero'/></VTKFile>", 2),
    ] {
        fs::write(&path, content).unwrap();
        match Pvd::read(&path) {
            Err(Error::Format { line: Some(line), .. }) => assert_eq!(line, at, "{content}"),
            other => panic!("{content} gave {other:?}"),
        }
    }
}
