//! Tables of comma-separated columns: samples, and results.

use tremolite_case::study::Quantity;

/// The name of a row, which may be empty, and its values as TOML.
pub type Row = (String, Vec<Option<String>>);

/// A fault of a table: what is wrong, and the way out.
pub type Fault = (String, String);

/// The samples of a table: a column a key, under its path and perhaps a unit, `material.rock.young [GPa]`; a cell that is empty leaves
/// the case's value. A column `name` has the names of the samples.
///
/// # Errors
/// What is wrong, with the line of the table.
pub fn samples(text: &str) -> Result<(Vec<String>, Vec<Row>), Fault> {
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
    let unreadable = |e: csv::Error| {
        let line = e.position().map_or_else(String::new, |p| format!("line {}: ", p.line()));
        (format!("{line}{e}"), "give each row one cell a column".to_owned())
    };
    let headers: Vec<(String, String)> = reader.headers().map_err(unreadable)?.iter().map(header).collect();
    let named = headers.iter().position(|(path, _)| path == "name");
    let paths: Vec<String> = headers
        .iter()
        .enumerate()
        .filter(|(k, _)| Some(*k) != named)
        .map(|(_, (path, _))| path.clone())
        .collect();
    if paths.is_empty() || paths.iter().any(String::is_empty) {
        return Err((
            "line 1: a column has no path of a key".into(),
            "write the paths of the keys in the first line".into(),
        ));
    }
    let mut rows = Vec::new();
    for row in reader.records() {
        let row = row.map_err(unreadable)?;
        let mut values = Vec::new();
        for (k, cell) in row.iter().enumerate().filter(|(k, _)| Some(*k) != named) {
            values.push(value(cell, &headers[k].1));
        }
        rows.push((named.and_then(|k| row.get(k)).unwrap_or_default().to_owned(), values));
    }
    if rows.is_empty() {
        return Err(("the table has no rows".into(), "write a row a sample under the first line".into()));
    }
    Ok((paths, rows))
}

/// A path and its unit. Paths have brackets of their own, so a unit stands behind a space.
fn header(text: &str) -> (String, String) {
    match text.rsplit_once(" [").and_then(|(path, unit)| Some((path, unit.strip_suffix(']')?))) {
        Some((path, unit)) => (path.trim().to_owned(), unit.trim().to_owned()),
        None => (text.to_owned(), String::new()),
    }
}

/// A cell as TOML; nothing for an empty one.
fn value(cell: &str, unit: &str) -> Option<String> {
    if cell.is_empty() {
        return None;
    }
    Some(match cell.parse::<f64>() {
        Ok(number) if number.is_finite() && !unit.is_empty() => {
            Quantity { number, unit: unit.to_owned() }.toml()
        }
        // What is no value of TOML becomes a text where it is set.
        _ => cell.to_owned(),
    })
}

/// Rows under a line of headers, as a text.
pub fn written(headers: &[String], rows: &[Vec<String>]) -> String {
    let mut writer = csv::WriterBuilder::new().from_writer(Vec::new());
    // Writing to memory does not fail, and all rows are as long as the headers.
    for row in std::iter::once(headers).chain(rows.iter().map(Vec::as_slice)) {
        let _ = writer.write_record(row);
    }
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_has_a_column_a_key_with_its_unit() {
        let text = "name,initial.lateral,material.rock.young [GPa],dynamic.sides,stage[bench 1].release\n\
                    stiff, 0.5,25,roller,1\nsoft,,2.5,,0.4\n";
        let (paths, samples) = samples(text).unwrap();
        assert_eq!(
            paths,
            ["initial.lateral", "material.rock.young", "dynamic.sides", "stage[bench 1].release"]
        );
        let text = |s: &str| Some(s.to_owned());
        assert_eq!(samples[0].1, [text("0.5"), text("\"25 GPa\""), text("roller"), text("1")]);
        assert_eq!(samples[1].1, [None, text("\"2.5 GPa\""), None, text("0.4")]);
        assert_eq!(samples[1].0, "soft");
    }

    #[test]
    fn what_is_no_table_is_told_with_its_line() {
        for (text, says) in [
            ("", "path"),
            ("a,b\n1\n", "line 2"),
            ("a,b\n", "no rows"),
            ("a,,b\n1,2,3\n", "line 1"),
            ("name\nx\n", "line 1"),
        ] {
            let (message, remedy) = samples(text).unwrap_err();
            assert!(message.contains(says) && !remedy.is_empty(), "{text}: {message}");
        }
    }
}
