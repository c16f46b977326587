//! The file of a path: which strains and stresses a material is taken through.

use std::path::Path as File;
use tremolite_case::units;
use tremolite_laws::Dimension;
use tremolite_laws::materials::MATERIALS;
use tremolite_laws::path::{Control, Path};

/// Columns of strain, xx, yy, zz, xy, yz, zx; shear as the engineering angle.
pub const STRAIN: [&str; 6] = ["exx", "eyy", "ezz", "gxy", "gyz", "gzx"];
/// Columns of stress in the same order.
pub const STRESS: [&str; 6] = ["sxx", "syy", "szz", "sxy", "syz", "szx"];

/// Rows that a divided path may have; more would fill the memory before it told anything.
const ROWS: usize = 10_000_000;

/// A path as it was read.
pub struct PathFile {
    pub path: Path,
    /// Line of the file, from 1, of each row as written.
    lines: Vec<usize>,
    /// Steps from a row as written to the next.
    steps: usize,
    /// Columns that were passed over, as they belong to an answer: histories, and stresses beside all strains.
    pub ignored: Vec<String>,
}

/// What a column holds, and what turns its numbers into SI.
struct Column {
    place: Place,
    factor: f64,
}

#[derive(Clone, Copy, PartialEq)]
enum Place {
    Time,
    Component(usize, Control),
    /// Part of an answer, not of a path.
    Ignored,
}

/// What a file says above its numbers.
struct Header {
    separator: char,
    columns: Vec<Column>,
    control: [Control; 6],
    ignored: Vec<String>,
}

impl PathFile {
    /// Reads a path.
    ///
    /// # Errors
    /// What is wrong, with the file, the line and the way out.
    pub fn read(file: &File) -> Result<PathFile, String> {
        let name = file.display();
        let bytes = std::fs::read(file).map_err(|e| format!("{name}: cannot read this file: {e}"))?;
        let text = str::from_utf8(&bytes).map_err(|e| {
            let line = bytes[..e.valid_up_to()].iter().filter(|&&b| b == b'\n').count() + 1;
            format!("{name}, line {line}: not text in UTF-8; save the table as comma-separated UTF-8 text")
        })?;
        parse(text).map_err(|(line, what)| match line {
            Some(line) => format!("{name}, line {line}: {what}"),
            None => format!("{name}: {what}"),
        })
    }

    /// Puts equal steps between the rows.
    ///
    /// # Errors
    /// If that gives too many rows.
    pub fn divide(&mut self, steps: u32) -> Result<(), String> {
        let rows = (self.path.time.len() - 1).saturating_mul(steps as usize);
        if rows >= ROWS {
            return Err(format!("--divide {steps} gives {rows} steps; at most {ROWS} are possible"));
        }
        let (time, values) = (&self.path.time, &self.path.values);
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
        (self.path.time, self.path.values) = finer;
        self.steps = steps as usize;
        Ok(())
    }

    /// The line whose row a step of the divided path leads to.
    pub fn line(&self, row: usize) -> usize {
        let written = row.div_ceil(self.steps).min(self.lines.len() - 1);
        self.lines[written]
    }
}

/// Line and what is wrong there.
type Fault = (Option<usize>, String);

fn parse(text: &str) -> Result<PathFile, Fault> {
    let text = text.trim_start_matches('\u{feff}');
    if text.contains('\r') && !text.contains('\n') {
        let what = "its lines end with a carriage return alone, as on old Macs; save it with line ends of Unix or Windows";
        return Err((None, what.into()));
    }
    let lines = text.lines().enumerate().map(|(i, line)| (i + 1, line.trim()));
    let mut lines = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let Some((at, header)) = lines.next() else {
        return Err((
            None,
            "the file is empty; start with a line of names: time,exx,eyy,ezz,gxy,gyz,gzx".into(),
        ));
    };
    let header = read_header(header).map_err(|what| (Some(at), what))?;
    let mut path = Path { time: Vec::new(), values: Vec::new(), control: header.control, size: None };
    let mut numbers = Vec::new();
    for (number, line) in lines {
        let (time, values) = row(line, &header).map_err(|what| (Some(number), what))?;
        if path.time.last().is_some_and(|last| time < *last) {
            return Err((Some(number), "time falls here; sort the rows by time".into()));
        }
        path.time.push(time);
        path.values.push(values);
        numbers.push(number);
    }
    if numbers.is_empty() {
        return Err((Some(at), "there are no rows below the names; write one row of numbers a step".into()));
    }
    Ok(PathFile { path, lines: numbers, steps: 1, ignored: header.ignored })
}

/// A line without the separator that some programs put behind the last field.
fn fields(line: &str, separator: char) -> impl Iterator<Item = &str> + Clone {
    line.strip_suffix(separator).unwrap_or(line).split(separator)
}

fn read_header(header: &str) -> Result<Header, String> {
    let separator = [',', ';', '\t'].into_iter().find(|c| header.contains(*c)).unwrap_or(',');
    let mut columns: Vec<Column> = fields(header, separator).map(column).collect::<Result<_, _>>()?;
    let has = |control| (0..6).all(|k| columns.iter().any(|c| c.place == Place::Component(k, control)));
    if has(Control::Strain) && has(Control::Stress) {
        // An answer: its strains are a path, its stresses what came of them.
        for column in &mut columns {
            if matches!(column.place, Place::Component(_, Control::Stress)) {
                column.place = Place::Ignored;
            }
        }
    }
    let control = control(&columns)?;
    let ignored = fields(header, separator).zip(&columns).filter(|(_, c)| c.place == Place::Ignored);
    let ignored = ignored.map(|(name, _)| split(name).0).collect();
    Ok(Header { separator, columns, control, ignored })
}

/// What each component prescribes.
fn control(columns: &[Column]) -> Result<[Control; 6], String> {
    let count = |place: Place| columns.iter().filter(|c| c.place == place).count();
    match count(Place::Time) {
        0 => return Err("there is no column time; add it, in s".into()),
        1 => {}
        _ => return Err("the column time is there twice; keep one".into()),
    }
    let mut control = [Control::Strain; 6];
    for (k, control) in control.iter_mut().enumerate() {
        let (strain, stress) = (STRAIN[k], STRESS[k]);
        match (count(Place::Component(k, Control::Strain)), count(Place::Component(k, Control::Stress))) {
            (1, 0) => {}
            (0, 1) => *control = Control::Stress,
            (0, 0) => {
                return Err(format!(
                    "neither {strain} nor {stress} is there; add {strain}, or {stress} to prescribe the stress, with \
                     zeros if it is to stay zero"
                ));
            }
            (1, 1) => {
                return Err(format!("{strain} and {stress} are both there; keep the one to be prescribed"));
            }
            (_, stresses) => {
                let name = if stresses > 1 { stress } else { strain };
                return Err(format!("the column {name} is there twice; keep one"));
            }
        }
    }
    Ok(control)
}

/// Name in small letters, and unit in brackets if there is one: `time [s]`, `Time`, `sxx[MPa]`.
fn split(header: &str) -> (String, &str) {
    let header = header.trim().trim_matches('"').trim();
    let end = header.find(|c: char| c.is_whitespace() || c == '[').unwrap_or(header.len());
    (header[..end].to_ascii_lowercase(), header[end..].trim())
}

/// A header `name` or `name [unit]`.
fn column(header: &str) -> Result<Column, String> {
    let (name, unit) = split(header);
    let name = name.as_str();
    let position = |names: [&str; 6]| names.iter().position(|n| *n == name);
    let (place, dimension) = if name == "time" {
        (Place::Time, Dimension::TIME)
    } else if let Some(k) = position(STRAIN) {
        (Place::Component(k, Control::Strain), Dimension::NONE)
    } else if let Some(k) = position(STRESS) {
        (Place::Component(k, Control::Stress), Dimension::PRESSURE)
    } else if MATERIALS.iter().any(|law| law.history.iter().any(|c| c.name == name)) {
        return Ok(Column { place: Place::Ignored, factor: 1.0 });
    } else {
        return Err(unknown(name));
    };
    if unit.is_empty() {
        return Ok(Column { place, factor: 1.0 });
    }
    let inside = unit.strip_prefix('[').and_then(|u| u.strip_suffix(']')).ok_or_else(|| {
        format!("'{}' behind {name} is no unit; write {name} or {name} [unit]", shown(unit))
    })?;
    let factor =
        units::parse_unit(inside, dimension).map_err(|e| format!("{name}: {e}; {}", e.remedy(name)))?;
    Ok(Column { place, factor })
}

fn unknown(name: &str) -> String {
    let known = format!("columns are time, {} or {}", STRAIN.join(", "), STRESS.join(", "));
    match name {
        "exy" | "eyz" | "ezx" | "exz" | "eyx" | "ezy" => {
            format!("'{name}' is no column of a path; shear is the engineering angle: gxy = 2 exy, gyz, gzx")
        }
        "gap" | "slip1" | "slip2" => {
            format!("'{name}' belongs to the path of an interface, which cannot be driven yet; {known}")
        }
        _ if name.parse::<f64>().is_ok() => {
            "a line of names is missing above the numbers: time,exx,eyy,ezz,gxy,gyz,gzx".into()
        }
        _ => format!("'{}' is no column of a path; {known}", shown(name)),
    }
}

fn row(line: &str, header: &Header) -> Result<(f64, [f64; 6]), String> {
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
        let what = "no numbers on this line; a path has one line of names, with units in brackets: time [s], sxx [MPa]";
        return Err(what.into());
    }
    let (mut time, mut values) = (0.0, [0.0; 6]);
    for (field, column) in fields.zip(columns).filter(|(_, c)| c.place != Place::Ignored) {
        let field = field.trim().trim_matches('"');
        let value = field.parse::<f64>().map_err(|_| not_a_number(field))? * column.factor;
        if !value.is_finite() {
            return Err(format!("'{}' is not finite; give a finite number", shown(field)));
        }
        match column.place {
            Place::Time => time = value,
            Place::Component(k, _) => values[k] = value,
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

/// A piece of a file, safe and short enough for a message.
fn shown(text: &str) -> String {
    text.chars().take(30).flat_map(char::escape_debug).collect()
}
