//! Tables that a user's program adds to a run, `own/NAME.csv`: a row of numbers now and then, behind the time.
//!
//! They are opened for each row, which comes with a look at the whole model and so costs nothing beside it: nobody holds them open, and several
//! observers may write to one. What is in each at a checkpoint is in the state, so that a resumed run cuts off what came later.

use std::fs;
use std::io::{self, BufRead};
use std::path::{Path, PathBuf};

use crate::growing_file::GrowingFile;
use crate::{Column, Error, Extent, TableWriter};

/// How the headers of all of them begin.
const TIME: &str = "time [s]";

/// A row of numbers for the table `table`. The time \[s\] is the first of its columns.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnRow {
    pub table: String,
    pub columns: Vec<Column>,
    pub values: Vec<f64>,
}

/// Whether a table of one's own may have this name: letters, digits, `_`, `-` and dots within, so that it is a file's on every system.
pub fn is_file_name(name: &str) -> bool {
    let fits = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-' | '.');
    !name.is_empty() && !name.starts_with('.') && !name.ends_with('.') && name.chars().all(fits)
}

/// The column of a header as a user writes it, `ux [m]`; nothing where it cannot head one.
pub fn column(head: &str) -> Option<Column> {
    let (name, unit) = match head.trim().split_once('[') {
        Some((name, rest)) => (name.trim(), rest.strip_suffix(']')?.trim()),
        None => (head.trim(), ""),
    };
    let fits = |c: char| !matches!(c, ',' | '"' | '[' | ']') && !c.is_control();
    (crate::table::is_name(name) && unit.chars().all(fits)).then(|| Column::new(name, unit))
}

/// Where a table lies among the results in `root`.
pub fn path(root: &Path, table: &str) -> PathBuf {
    root.join("own").join(format!("{table}.csv"))
}

/// Adds a row behind what was written last; without that begins the table. Returns what is in it then.
///
/// # Errors
/// [`Error::Format`] for other columns than the table has, or for columns that it cannot have; [`Error::Io`].
pub fn add(root: &Path, row: &OwnRow, last: Option<Extent>) -> Result<Extent, Error> {
    let path = path(root, &row.table);
    let mut writer = match last {
        Some(last) => {
            let header = header(&path)?;
            let wanted = row.columns.iter().map(Column::header).collect::<Vec<_>>().join(",");
            if header != wanted {
                let what = format!("has the columns {header}; record the same each time, not {wanted}");
                return Err(Error::format(&path, None, what));
            }
            TableWriter::go_on(&path, &row.columns, last)?
        }
        None => {
            let folder = root.join("own");
            tremolite_files::make_folder(&folder).map_err(Error::io(&folder, "make this folder"))?;
            TableWriter::create(&path, &row.columns)?
        }
    };
    writer.write(&row.values)?;
    Ok(writer.extent())
}

/// Cuts all such tables in `root` back to what a state knows of them; removes those that it does not know.
///
/// # Errors
/// [`Error::Format`] for a table that is shorter than it was or was changed: it is not the one of that state; [`Error::Io`].
pub fn cut_back(root: &Path, kept: &[(&str, Extent)]) -> Result<(), Error> {
    for (table, extent) in kept {
        let path = path(root, table);
        drop(GrowingFile::resume(&path, &format!("{}\n", header(&path)?), *extent)?);
    }
    let unknown = |other: &PathBuf| kept.iter().all(|(table, _)| path(root, table) != *other);
    // A file of the user's own that happens to lie there does not begin so.
    let ours = |other: &PathBuf| header(other).is_ok_and(|header| header.starts_with(TIME));
    for other in all(root).into_iter().filter(|other| unknown(other) && ours(other)) {
        tremolite_files::remove(&other)
            .map_err(Error::io(&other, "remove what came after the checkpoint"))?;
    }
    Ok(())
}

/// All such tables in `root`, by their names.
pub fn all(root: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(root.join("own")).into_iter().flatten().flatten();
    let mut all: Vec<PathBuf> = entries
        .map(|entry| entry.path())
        .filter(|path| path.extension().is_some_and(|x| x == "csv"))
        .collect();
    all.sort();
    all
}

/// The first line of a table.
fn header(path: &Path) -> Result<String, Error> {
    let mut line = String::new();
    let file = fs::File::open(path).map_err(Error::io(path, "open this file to go on with it"))?;
    io::BufReader::new(file).read_line(&mut line).map_err(Error::io(path, "read this file"))?;
    Ok(line.trim_end_matches('\n').to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Table;

    fn row(table: &str, head: &str, values: [f64; 2]) -> OwnRow {
        OwnRow {
            table: table.into(),
            columns: vec![Column::new("time", "s"), column(head).unwrap()],
            values: values.into(),
        }
    }

    #[test]
    fn rows_behind_a_checkpoint_go_and_none_comes_twice() {
        let root = tempfile::tempdir().unwrap();
        let root = root.path();
        let first = add(root, &row("roof", "u [m]", [0.0, 1.0]), None).unwrap();
        let second = add(root, &row("roof", "u [m]", [1.0, 2.0]), Some(first)).unwrap();
        add(root, &row("roof", "u [m]", [2.0, 3.0]), Some(second)).unwrap();
        add(root, &row("late", "n", [2.0, 3.0]), None).unwrap();
        cut_back(root, &[("roof", second)]).unwrap();
        assert_eq!(all(root), [path(root, "roof")]);
        add(root, &row("roof", "u [m]", [2.0, 4.0]), Some(second)).unwrap();
        let table = Table::read(&path(root, "roof")).unwrap();
        assert_eq!(table.values, [[0.0, 1.0, 2.0], [1.0, 2.0, 4.0]]);
        assert_eq!(table.unit("u"), Some("m"));

        let other = add(root, &row("roof", "v [m]", [3.0, 4.0]), Some(second)).unwrap_err().to_string();
        assert!(other.contains("record the same each time"), "{other}");
        let longer = Extent { bytes: 10_000, ..second };
        let shorter = cut_back(root, &[("roof", longer)]).unwrap_err().to_string();
        assert!(shorter.contains("the checkpoint was made at 10000"), "{shorter}");
    }

    #[test]
    fn names_are_those_of_files_and_heads_those_of_columns() {
        for (name, fits) in [
            ("roof", true),
            ("a-b_2.5", true),
            ("顶", true),
            ("", false),
            ("a/b", false),
            ("..", false),
            ("a b", false),
        ] {
            assert_eq!(is_file_name(name), fits, "{name}");
        }
        assert_eq!(column("ux [m]"), Some(Column::new("ux", "m")));
        assert_eq!(column("n"), Some(Column::new("n", "")));
        for head in ["", "a b", "a,b", "u [m", "u [m,s]", "u [m] x"] {
            assert_eq!(column(head), None, "{head}");
        }
    }
}
