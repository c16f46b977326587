//! The file of a path: what a law is taken through, row by row.

use super::columns::{Form, Header, Place, fields, shown};
use std::path::Path as File;

/// Rows that a divided path may have; more would fill the memory before it told anything.
const ROWS: usize = 10_000_000;

/// A path as it was read.
pub struct PathFile<const N: usize> {
    /// \[s\], not falling.
    pub time: Vec<f64>,
    /// Motions in SI, or the stresses in their place.
    pub values: Vec<[f64; N]>,
    /// Components whose stress is prescribed.
    pub by_stress: [bool; N],
    /// Line of the file, from 1, of each row as written.
    lines: Vec<usize>,
    /// Steps from a row as written to the next.
    steps: usize,
    /// Columns that were passed over, as they belong to an answer: histories, and stresses beside all motions.
    pub ignored: Vec<String>,
}

impl<const N: usize> PathFile<N> {
    /// Reads a path.
    ///
    /// # Errors
    /// What is wrong, with the file, the line and the way out.
    pub fn read(file: &File, form: &Form<N>) -> Result<Self, String> {
        let name = file.display();
        let bytes = std::fs::read(file).map_err(|e| format!("{name}: cannot read this file: {e}"))?;
        let text = str::from_utf8(&bytes).map_err(|e| {
            let line = bytes[..e.valid_up_to()].iter().filter(|&&b| b == b'\n').count() + 1;
            format!("{name}, line {line}: not text in UTF-8; save the table as comma-separated UTF-8 text")
        })?;
        parse(text, form).map_err(|(line, what)| match line {
            Some(line) => format!("{name}, line {line}: {what}"),
            None => format!("{name}: {what}"),
        })
    }

    /// Puts equal steps between the rows.
    ///
    /// # Errors
    /// If that gives too many rows.
    pub fn divide(&mut self, steps: u32) -> Result<(), String> {
        let rows = (self.time.len() - 1).saturating_mul(steps as usize);
        if rows >= ROWS {
            return Err(format!("--divide {steps} gives {rows} steps; at most {ROWS} are possible"));
        }
        let (time, values) = (&self.time, &self.values);
        let mut finer = (vec![time[0]], vec![values[0]]);
        for (t, v) in time.windows(2).zip(values.windows(2)) {
            for k in 1..=steps {
                let part = f64::from(k) / f64::from(steps);
                // The last step ends on the row as written.
                let between = |a: f64, b: f64| if k == steps { b } else { a + part * (b - a) };
                finer.0.push(between(t[0], t[1]));
                finer.1.push(std::array::from_fn(|c| between(v[0][c], v[1][c])));
            }
        }
        (self.time, self.values) = finer;
        self.steps = steps as usize;
        Ok(())
    }

    /// Leaves out what comes from a row of the divided path on.
    pub fn truncate(&mut self, row: usize) {
        self.time.truncate(row);
        self.values.truncate(row);
    }

    /// The line whose row a step of the divided path leads to.
    pub fn line(&self, row: usize) -> usize {
        let written = row.div_ceil(self.steps).min(self.lines.len() - 1);
        self.lines[written]
    }
}

/// Line and what is wrong there.
type Fault = (Option<usize>, String);

fn parse<const N: usize>(text: &str, form: &Form<N>) -> Result<PathFile<N>, Fault> {
    let text = text.trim_start_matches('\u{feff}');
    if text.contains('\r') && !text.contains('\n') {
        let what = "its lines end with a carriage return alone, as on old Macs; save it with line ends of Unix or Windows";
        return Err((None, what.into()));
    }
    let lines = text.lines().enumerate().map(|(i, line)| (i + 1, line.trim()));
    let mut lines = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let Some((at, header)) = lines.next() else {
        return Err((None, format!("the file is empty; start with a line of names: {}", form.names())));
    };
    let header = Header::read(header, form).map_err(|what| (Some(at), what))?;
    let (mut time, mut values, mut numbers) = (Vec::new(), Vec::new(), Vec::new());
    for (number, line) in lines {
        let (t, v) = row(line, &header, form).map_err(|what| (Some(number), what))?;
        if time.last().is_some_and(|last| t < *last) {
            return Err((Some(number), "time falls here; sort the rows by time".into()));
        }
        time.push(t);
        values.push(v);
        numbers.push(number);
    }
    if numbers.is_empty() {
        return Err((Some(at), "there are no rows below the names; write one row of numbers a step".into()));
    }
    let Header { by_stress, ignored, .. } = header;
    Ok(PathFile { time, values, by_stress, lines: numbers, steps: 1, ignored })
}

fn row<const N: usize>(line: &str, header: &Header<N>, form: &Form<N>) -> Result<(f64, [f64; N]), String> {
    let Header { separator, columns, .. } = header;
    let fields = fields(line, *separator);
    let found = fields.clone().count();
    if found != columns.len() {
        // A comma in every number makes twice as many.
        let commas = *separator == ',' && found > columns.len() && !line.contains('.');
        let way_out = if commas {
            "decimal commas cannot stand beside commas between columns, write 0.012"
        } else {
            "give one value a column"
        };
        return Err(format!("{found} values under {} names; {way_out}", columns.len()));
    }
    if fields.clone().all(|field| !field.contains(|c: char| c.is_ascii_digit())) {
        return Err(format!(
            "no numbers on this line; a path has one line of names, with units in brackets: {}",
            form.with_units()
        ));
    }
    let (mut time, mut values) = (0.0, [0.0; N]);
    for (field, column) in fields.zip(columns).filter(|(_, c)| c.place != Place::Ignored) {
        let field = field.trim().trim_matches('"');
        let value = field.parse::<f64>().map_err(|_| not_a_number(field))? * column.factor;
        if !value.is_finite() {
            return Err(format!("'{}' is not finite; give a finite number", shown(field)));
        }
        match column.place {
            Place::Time => time = value,
            Place::Motion(k) | Place::Stress(k) => values[k] = value,
            Place::Ignored => {}
        }
    }
    Ok((time, values))
}

fn not_a_number(field: &str) -> String {
    let dotted = field.replacen(',', ".", 1);
    if dotted != field && dotted.parse::<f64>().is_ok() {
        return format!(
            "'{}' has a decimal comma; write decimal points in the whole file: {dotted}",
            shown(field)
        );
    }
    format!("'{}' is not a number; write numbers such as -1.5e-4", shown(field))
}
