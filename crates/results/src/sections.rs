//! sections.csv: thrust, moment and shear of linings, by station.

use crate::stages::write_rows;
use crate::{Error, number, replace_file};
use std::path::Path;

/// What ends the name of a lining with pores where its forces are those of effective stress.
pub const EFFECTIVE: &str = ", effective";

/// Section forces of a station of a lining at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionRow {
    /// The group of elements; with [`EFFECTIVE`] where forces are of effective stress.
    pub lining: String,
    /// Number of the station, going round the section.
    pub station: u32,
    /// Middle of the thickness (m).
    pub place: [f64; 3],
    /// A stage's name, or `min` or `max` of the shaking.
    pub when: String,
    /// Time in the shaking (s), of the extreme; not a number for stages. Of `min` and `max` there is one for each of the three
    /// forces.
    pub time: [f64; 3],
    /// N (N/m, tension positive), M (N m/m, positive with tension at the intrados), Q (N/m).
    pub forces: [f64; 3],
    /// Thrust (N/m) at the same time as M: the two are a state that the section was in.
    pub thrust_at_moment: f64,
    /// Moment (N m/m) at the same time as N, another such state.
    pub moment_at_thrust: f64,
    /// Of the section (m), not a number in files of older versions.
    pub thickness: f64,
}

const HEADERS: [&str; 15] = [
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
    "time_M [s]",
    "time_Q [s]",
    "N_at_M [N/m]",
    "thickness [m]",
    "M_at_N [N]",
];

/// Writes the file whole.
///
/// # Errors
/// [`Error::Io`].
pub fn write_sections(path: &Path, rows: &[SectionRow]) -> Result<(), Error> {
    let mut out = csv::Writer::from_writer(Vec::new());
    let text = |x: f64| {
        let mut text = String::new();
        number::push(&mut text, x);
        text
    };
    let head = std::iter::once(HEADERS.map(str::to_owned).to_vec());
    let body = rows.iter().map(|row| {
        let [x, y, z] = row.place.map(text);
        let [n, m, q] = row.forces.map(text);
        let [of_n, of_m, of_q] = row.time.map(text);
        vec![
            row.lining.clone(),
            row.station.to_string(),
            x,
            y,
            z,
            row.when.clone(),
            of_n,
            n,
            m,
            q,
            of_m,
            of_q,
            text(row.thrust_at_moment),
            text(row.thickness),
            text(row.moment_at_thrust),
        ]
    });
    write_rows(&mut out, head.chain(body));
    replace_file(path, &out.into_inner().unwrap_or_default())
}

/// Reads the file.
///
/// # Errors
/// [`Error::Io`]; [`Error::Format`] with the line where a row is not of this form.
pub fn read_sections(path: &Path) -> Result<Vec<SectionRow>, Error> {
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
        // Files of older versions end before these.
        let later = |i: usize| if record.len() > i { value(i) } else { Ok(f64::NAN) };
        rows.push(SectionRow {
            lining: field(0)?.to_owned(),
            station: field(1)?.parse().map_err(|_| fault("'station' is not a number".into()))?,
            place: [value(2)?, value(3)?, value(4)?],
            when: field(5)?.to_owned(),
            time: [value(6)?, value(10)?, value(11)?],
            forces: [value(7)?, value(8)?, value(9)?],
            thrust_at_moment: later(12)?,
            thickness: later(13)?,
            moment_at_thrust: later(14)?,
        });
    }
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_come_back_as_they_were_written_whatever_their_names() {
        let row = SectionRow {
            lining: "hall, \"east\".lining".into(),
            station: 3,
            place: [1.0, 2.5, -200.25],
            when: "bench 1, lower".into(),
            time: [f64::NAN; 3],
            forces: [-1.25e6, 3.0e4, 12.0],
            thrust_at_moment: -1.25e6,
            moment_at_thrust: 3.0e4,
            thickness: 0.5,
        };
        let extreme = SectionRow { when: "max".into(), time: [1.5, 2.5, 3.5], ..row.clone() };
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("sections.csv");
        write_sections(&path, &[row.clone(), extreme.clone()]).unwrap();
        let read = read_sections(&path).unwrap();
        assert_eq!(read[1], extreme);
        assert_eq!((&read[0].lining, &read[0].when, read[0].forces), (&row.lining, &row.when, row.forces));
        assert!(read[0].time.iter().all(|t| t.is_nan()));
    }

    #[test]
    fn files_without_the_later_columns_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("sections.csv");
        let head = HEADERS[..12].join(",");
        std::fs::write(&path, format!("{head}\nhall,1,0,0,0,lining,NaN,-2,3,4,NaN,NaN\n")).unwrap();
        let [row] = &read_sections(&path).unwrap()[..] else { panic!("one row") };
        assert!(row.forces == [-2.0, 3.0, 4.0] && row.thickness.is_nan() && row.thrust_at_moment.is_nan());
    }
}
