//! bolts.csv: what each bolt carries and how it stands, at the end of stages and in the shaking.

use std::fs;
use std::path::Path;

use crate::growing_file::GrowingFile;
use crate::stages::write_rows;
use crate::{Column, Error, Extent, number};

/// What stands in the column `stage` in the shaking.
pub const EARTHQUAKE: &str = "earthquake";

/// A bolt at one time: the whole of it, but for what was cut off it by an excavation.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BoltRow {
    /// Its number in its group, from 1, in the order in which they were given.
    pub bolt: u32,
    /// Of the group.
    pub name: String,
    /// Time in the shaking (s); not a number at the end of a stage.
    pub time: f64,
    /// Its force of largest size (N), tension positive, and the size of that over what it yields at, at most along the bolt;
    /// 0 where it never yields.
    pub max_force: f64,
    pub force_over_yield: f64,
    /// Largest size of its slip (m) in any step so far.
    pub max_slip: f64,
    /// `elastic`, `slid`, `yielded`, `broken`: the worst of what is left of it; `cut-off` where nothing is.
    pub state: String,
    /// The stage's name, or [`EARTHQUAKE`].
    pub stage: String,
    /// Where the force is largest (m).
    pub place: [f64; 3],
    /// Largest size of the force (N) in any step since the stage, or the shaking, began.
    pub largest_force: f64,
    /// Length of it (m) that excavations have cut off.
    pub cut_off: f64,
}

/// A column of the file.
#[derive(Clone, Copy, Debug)]
pub struct BoltColumn {
    pub name: &'static str,
    pub unit: &'static str,
    pub doc: &'static str,
    text: fn(&BoltRow) -> String,
    /// Nothing where the text is not of its form.
    read: fn(&mut BoltRow, &str) -> Option<()>,
}

/// A column of numbers.
macro_rules! number {
    ($name:literal, $unit:literal, $doc:literal, |$row:ident| $place:expr) => {
        BoltColumn {
            name: $name,
            unit: $unit,
            doc: $doc,
            text: |$row| {
                let mut text = String::new();
                number::push(&mut text, $place);
                text
            },
            read: |$row, text| {
                $place = text.parse().ok()?;
                Some(())
            },
        }
    };
}

/// A column of words.
macro_rules! words {
    ($name:literal, $doc:literal, $field:ident) => {
        BoltColumn {
            name: $name,
            unit: "",
            doc: $doc,
            text: |row| row.$field.clone(),
            read: |row, text| {
                row.$field = text.to_owned();
                Some(())
            },
        }
    };
}

/// The columns of the file, in its order.
pub const BOLT_COLUMNS: &[BoltColumn] = &[
    BoltColumn {
        name: "bolt",
        unit: "",
        doc: "its number in the group, from 1",
        text: |row| row.bolt.to_string(),
        read: |row, text| {
            row.bolt = text.parse().ok()?;
            Some(())
        },
    },
    words!("name", "the group's", name),
    number!(
        "time",
        "s",
        "in the earthquake, when field files are written; NaN at the end of a stage",
        |row| row.time
    ),
    number!("max_force", "N", "force of largest size along the bolt, tension positive", |row| row.max_force),
    number!(
        "force_over_yield",
        "1",
        "size of the force over what its segment yields at, at most along the bolt; 0 where it never does",
        |row| row.force_over_yield
    ),
    number!(
        "max_slip",
        "m",
        "largest size of the slip along the bolt in any step since it was placed",
        |row| row.max_slip
    ),
    words!(
        "state",
        "elastic, slid, yielded or broken: the worst of what is left of the bolt; cut-off where an excavation left nothing",
        state
    ),
    words!("stage", "the stage at whose end it is so, or earthquake", stage),
    number!("x", "m", "where max_force is: the middle of its segment", |row| row.place[0]),
    number!("y", "m", "the same along y", |row| row.place[1]),
    number!("z", "m", "the same along z", |row| row.place[2]),
    number!(
        "largest_force",
        "N",
        "largest size of the force along the bolt in any step since the stage, or the earthquake, began",
        |row| row.largest_force
    ),
    number!(
        "cut_off",
        "m",
        "length of the bolt that excavations have taken; it counts in no other column",
        |row| row.cut_off
    ),
];

fn lines(rows: impl IntoIterator<Item = Vec<String>>) -> Vec<u8> {
    let mut out = csv::Writer::from_writer(Vec::new());
    write_rows(&mut out, rows);
    out.into_inner().unwrap_or_default()
}

fn line(row: &BoltRow) -> Vec<String> {
    BOLT_COLUMNS.iter().map(|column| (column.text)(row)).collect()
}

fn header() -> Vec<u8> {
    lines([BOLT_COLUMNS.iter().map(|column| Column::new(column.name, column.unit).header()).collect()])
}

/// Writes the file; it grows while the ground shakes.
#[derive(Debug)]
pub struct BoltWriter {
    file: GrowingFile,
}

impl BoltWriter {
    /// Starts the file with what is known so far, replacing one of that name.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn create(path: &Path, rows: &[BoltRow]) -> Result<Self, Error> {
        let mut writer = BoltWriter { file: GrowingFile::create(path)? };
        writer.file.put(&header())?;
        writer.write(rows)?;
        Ok(writer)
    }

    /// Opens it to go on behind what [`BoltWriter::extent`] told at a checkpoint. What was written later is cut off.
    ///
    /// # Errors
    /// As [`crate::TableWriter::resume`].
    pub fn resume(path: &Path, extent: Extent) -> Result<Self, Error> {
        let file = GrowingFile::resume(path, &String::from_utf8_lossy(&header()), extent)?;
        Ok(BoltWriter { file })
    }

    /// Adds rows.
    ///
    /// # Errors
    /// [`Error::Io`], a full disk for one.
    pub fn write(&mut self, rows: &[BoltRow]) -> Result<(), Error> {
        self.file.put(&lines(rows.iter().map(line)))
    }

    /// What is in the file so far.
    pub fn extent(&self) -> Extent {
        self.file.extent()
    }
}

/// Reads the file. A last line without its line end is left out: it is being written, or was cut.
///
/// # Errors
/// [`Error::Io`]; [`Error::Format`] with the line where a row is not of this form.
pub fn read_bolts(path: &Path) -> Result<Vec<BoltRow>, Error> {
    let bytes = fs::read(path).map_err(Error::io(path, "read this file"))?;
    let whole = bytes.iter().rposition(|b| *b == b'\n').map_or(0, |end| end + 1);
    let mut reader = csv::Reader::from_reader(&bytes[..whole]);
    let mut rows = Vec::new();
    for (k, record) in reader.records().enumerate() {
        let fault = |what: String| Error::format(path, Some(k + 2), what);
        let record = record.map_err(|e| fault(e.to_string()))?;
        let mut row = BoltRow::default();
        for (k, column) in BOLT_COLUMNS.iter().enumerate() {
            let text = record.get(k).ok_or_else(|| fault(format!("'{}' is missing", column.name)))?;
            (column.read)(&mut row, text)
                .ok_or_else(|| fault(format!("'{}' is not a number", column.name)))?;
        }
        rows.push(row);
    }
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(bolt: u32) -> BoltRow {
        BoltRow {
            bolt,
            name: "crown, \"north\"".into(),
            time: 0.5,
            max_force: -1.25e5,
            force_over_yield: 0.0,
            max_slip: 2.5e-7,
            state: "cut-off".into(),
            stage: "bench 1, lower".into(),
            place: [1.0, 2.5, -200.25],
            largest_force: 1.5e5,
            cut_off: 0.75,
        }
    }

    #[test]
    fn rows_come_back_as_they_were_written_whatever_their_names() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("bolts.csv");
        let mut writer = BoltWriter::create(&path, &[row(1)]).unwrap();
        writer.write(&[row(2), row(3)]).unwrap();
        assert_eq!(read_bolts(&path).unwrap(), [row(1), row(2), row(3)]);
        let text = fs::read_to_string(&path).unwrap();
        // The first columns are a contract with scripts.
        assert!(text.starts_with(
            "bolt,name,time [s],max_force [N],force_over_yield [1],max_slip [m],state,stage,x [m],"
        ));
    }

    #[test]
    fn a_resumed_file_is_cut_at_the_checkpoint_and_a_foreign_one_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("bolts.csv");
        let mut writer = BoltWriter::create(&path, &[row(1)]).unwrap();
        let at = writer.extent();
        writer.write(&[row(2)]).unwrap();
        let whole = fs::read(&path).unwrap();
        // A line that was being written when the run was killed is not read, and is cut off.
        fs::write(&path, [&whole[..], b"3,cro"].concat()).unwrap();
        assert_eq!(read_bolts(&path).unwrap(), [row(1), row(2)]);
        let mut writer = BoltWriter::resume(&path, at).unwrap();
        assert_eq!(read_bolts(&path).unwrap(), [row(1)]);
        writer.write(&[row(2)]).unwrap();
        assert_eq!(fs::read(&path).unwrap(), whole);
        assert_eq!(writer.extent().bytes, whole.len() as u64);

        for bytes in [at.bytes - 1, whole.len() as u64 + 1, 3] {
            assert!(BoltWriter::resume(&path, Extent { bytes, ..at }).is_err(), "{bytes}");
        }
        assert!(BoltWriter::resume(&path, Extent { crc: !at.crc, ..at }).is_err(), "other rows");
        fs::write(&path, "time [s]\n".repeat(100)).unwrap();
        assert!(BoltWriter::resume(&path, Extent { bytes: 180, ..at }).is_err(), "another table");
    }

    #[test]
    fn no_bolts_leave_a_file_without_rows() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("bolts.csv");
        BoltWriter::create(&path, &[]).unwrap();
        assert_eq!(read_bolts(&path).unwrap(), []);
    }
}
