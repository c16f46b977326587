//! utilisation.csv: how much of its strength each section of a lining uses, by station.

use crate::stages::write_rows;
use crate::{Error, number, replace_file};
use std::path::Path;

/// The section forces of a station at one time, and what they use of its strength.
#[derive(Clone, Debug, PartialEq)]
pub struct UtilisationRow {
    /// The group of elements.
    pub lining: String,
    /// Number of the station, as in sections.csv.
    pub station: u32,
    /// Middle of the thickness (m).
    pub place: [f64; 3],
    /// A stage's name; of the shaking `max`, where thrust and moment use most, and `max_shear`, where shear does.
    pub when: String,
    /// Time in the shaking (s); not a number for stages.
    pub time: f64,
    /// N (N/m, tension positive), M (N m/m, positive with tension at the intrados), Q (N/m), all of that time.
    pub forces: [f64; 3],
    /// Of thrust and moment, by proportional loading: 1 at the limit, infinite where no share of them is borne.
    pub bending: f64,
    /// Of shear; not a number where the code has no clause.
    pub shear: f64,
    /// V_Rd (N/m) beside N and M of that time; not a number where the code has no clause, and in files of older versions.
    pub resistance: f64,
}

const HEADERS: [&str; 13] = [
    "lining",
    "station",
    "x [m]",
    "y [m]",
    "z [m]",
    "when",
    "time [s]",
    "N [N/m]",
    "M [N]",
    "Q [N/m]",
    "utilisation [1]",
    "shear_utilisation [1]",
    "V_Rd [N/m]",
];

/// Writes the file whole.
///
/// # Errors
/// [`Error::Io`].
pub fn write_utilisation(path: &Path, rows: &[UtilisationRow]) -> Result<(), Error> {
    let mut out = csv::Writer::from_writer(Vec::new());
    let text = |x: f64| {
        let mut text = String::new();
        number::push(&mut text, x);
        text
    };
    let head = std::iter::once(HEADERS.map(str::to_owned).to_vec());
    let body = rows.iter().map(|row| {
        let mut cells = vec![row.lining.clone(), row.station.to_string()];
        cells.extend(row.place.map(text));
        cells.extend([row.when.clone(), text(row.time)]);
        cells.extend(row.forces.map(text));
        cells.extend([row.bending, row.shear, row.resistance].map(text));
        cells
    });
    write_rows(&mut out, head.chain(body));
    replace_file(path, &out.into_inner().unwrap_or_default())
}

/// Reads the file.
///
/// # Errors
/// [`Error::Io`]; [`Error::Format`] with the line where a row is not of this form.
pub fn read_utilisation(path: &Path) -> Result<Vec<UtilisationRow>, Error> {
    let bytes = std::fs::read(path).map_err(Error::io(path, "read this file"))?;
    let mut reader = csv::Reader::from_reader(bytes.as_slice());
    let mut rows = Vec::new();
    for (k, record) in reader.records().enumerate() {
        let fault = |what: String| Error::format(path, Some(k + 2), what);
        let record = record.map_err(|e| fault(e.to_string()))?;
        let field = |i: usize| record.get(i).ok_or_else(|| fault(format!("'{}' is missing", HEADERS[i])));
        let value = |i: usize| -> Result<f64, Error> {
            field(i)?.parse().map_err(|_| fault(format!("'{}' is not a number", HEADERS[i])))
        };
        rows.push(UtilisationRow {
            lining: field(0)?.to_owned(),
            station: field(1)?.parse().map_err(|_| fault("'station' is not a number".into()))?,
            place: [value(2)?, value(3)?, value(4)?],
            when: field(5)?.to_owned(),
            time: value(6)?,
            forces: [value(7)?, value(8)?, value(9)?],
            bending: value(10)?,
            shear: value(11)?,
            // Files of older versions end before it.
            resistance: if record.len() < HEADERS.len() { f64::NAN } else { value(12)? },
        });
    }
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_come_back_as_they_were_written() {
        let row = UtilisationRow {
            lining: "hall, \"east\".lining".into(),
            station: 3,
            place: [1.0, 2.5, -200.25],
            when: "max".into(),
            time: 1.25,
            forces: [-1.25e6, 3.0e4, 12.0],
            bending: f64::INFINITY,
            shear: 0.25,
            resistance: 48.0,
        };
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("utilisation.csv");
        write_utilisation(&path, std::slice::from_ref(&row)).unwrap();
        assert_eq!(read_utilisation(&path).unwrap(), [row]);
        // A file of an older version has no resistance.
        let text = std::fs::read_to_string(&path).unwrap();
        let older: Vec<&str> = text.lines().map(|line| line.rsplit_once(',').unwrap().0).collect();
        std::fs::write(&path, older.join("\n")).unwrap();
        let read = read_utilisation(&path).unwrap();
        assert!(read[0].resistance.is_nan() && read[0].shear == 0.25);
        std::fs::write(&path, "lining,station\nhall,x\n").unwrap();
        assert!(read_utilisation(&path).unwrap_err().to_string().contains("station"));
    }
}
