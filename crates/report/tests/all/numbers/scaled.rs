//! Copies of a result folder in which every number is another, each by a factor of its own.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use serde_json::{Map, Value};
use tremolite_mesh::vtu::{Array, Grid, Values};

use super::tokens::of_line;

/// What stands in a file, or what a reader may take from its rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A number of `summary.json`, or one in a text of it.
    Leaf,
    /// Largest, smallest, first or last of a column, or what stands in the same row.
    Extreme,
    /// The largest, or the sum, of numbers of one name in several places.
    Over,
    /// Largest or smallest of an array of a VTU file.
    Field,
    /// Another row of a column.
    Row,
}

/// A number that the page may show.
#[derive(Clone, Debug)]
pub struct Known {
    pub kind: Kind,
    pub name: String,
    pub value: f64,
}

/// The numbers of a folder, and words with digits in them.
#[derive(Default)]
pub struct Content {
    pub known: Vec<Known>,
    pub names: Vec<String>,
    /// The factor of places in field files.
    pub places: f64,
}

/// Leaves of the summary that name something, or say how the page is set; no numbers are taken from them.
const NAMING: [&str; 24] = [
    "title",
    "status",
    "verdict",
    "severity",
    "group",
    "placed",
    "stage",
    "id",
    "name",
    "key",
    "law",
    "kind",
    "unit",
    "bound",
    "pattern",
    "path",
    "hash",
    "started",
    "program",
    "command",
    "version",
    "instruction_set",
    "language",
    "names",
];

/// Factors by which what is called `name` is scaled in the copy `copy`; those of no other name or copy.
fn factor(copy: u64, name: &str) -> f64 {
    if copy == 0 {
        return 1.0;
    }
    let mut hash = 0xcbf2_9ce4_8422_2325_u64 ^ copy.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    for byte in name.bytes() {
        hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }
    hash ^= hash >> 33;
    hash = hash.wrapping_mul(0xff51_afd7_ed55_8ccd);
    hash ^= hash >> 33;
    // By half of the spread at least, up or down.
    let part = (hash >> 12) as f64 / (1_u64 << 52) as f64;
    let by = super::SPREAD * (0.5 + 0.5 * part);
    if hash & 1 == 0 { 1.0 + by } else { 1.0 - by }
}

/// Writes the copy `copy` of `from` into `to`; 0 is as it was.
pub fn scaled(from: &Path, to: &Path, copy: u64) -> Content {
    let mut content = Content { places: factor(copy, "places"), ..Content::default() };
    fs::create_dir_all(to).unwrap();
    let mut files: Vec<_> = fs::read_dir(from).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    for path in files {
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        let at = to.join(&name);
        if path.is_dir() {
            if !["figures", "checkpoint"].contains(&name.as_str()) {
                fields(&path, &at, &name, copy, &mut content);
            }
        } else if name == "summary.json" {
            let mut summary: Value = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
            let mut leaves = Leaves { copy, content: &mut content, by_name: BTreeMap::new() };
            leaves.scale(&mut summary, &mut Vec::new());
            leaves.over();
            leaves.peaks(&summary);
            let whole = summary["wall_seconds"].as_f64().unwrap_or(f64::NAN).round();
            for (what, part) in
                [("hours", whole / 3600.0), ("minutes", whole / 60.0 % 60.0), ("seconds", whole % 60.0)]
            {
                leaves.know(Kind::Leaf, format!("{what} of wall_seconds"), part.floor());
            }
            fs::write(at, serde_json::to_vec(&summary).unwrap()).unwrap();
        } else if name.ends_with(".csv") {
            fs::write(at, table(&name, &fs::read_to_string(&path).unwrap(), copy, &mut content)).unwrap();
        } else if name.ends_with(".pvd") {
            fs::write(at, listed(&name, &fs::read_to_string(&path).unwrap(), copy, &mut content)).unwrap();
        } else if name == "case.toml" {
            fs::copy(&path, at).unwrap();
        }
    }
    content.names.sort_by_key(|name| std::cmp::Reverse(name.len()));
    content.names.dedup();
    content
}

/// The numbers of a summary on the way through it.
struct Leaves<'a> {
    copy: u64,
    content: &'a mut Content,
    /// Path without one or two of its parts → the numbers there.
    by_name: BTreeMap<String, Vec<f64>>,
}

impl Leaves<'_> {
    fn scale(&mut self, value: &mut Value, path: &mut Vec<String>) {
        let last = path.last().cloned().unwrap_or_default();
        match value {
            Value::Object(object) => self.object(object, path),
            Value::Array(array) => {
                for (k, value) in array.iter_mut().enumerate() {
                    path.push(k.to_string());
                    self.scale(value, path);
                    path.pop();
                }
                let three: Vec<f64> = array.iter().filter_map(Value::as_f64).collect();
                if let [x, y, z] = three[..] {
                    let size = (x * x + y * y + z * z).sqrt();
                    self.know(Kind::Leaf, format!("size of {}", path.join(".")), size);
                }
            }
            Value::Number(number) => {
                let name = path.join(".");
                let by = factor(self.copy, &name);
                let scaled = match number.as_u64() {
                    // Whole numbers stay so; small ones go up by 0, 1 or 2.
                    Some(0) => 0.0,
                    Some(whole) if whole < 20 && self.copy > 0 => {
                        whole as f64 + ((by * 1e4) as u64 % 3) as f64
                    }
                    Some(whole) => (whole as f64 * by).round(),
                    None => number.as_f64().unwrap() * by,
                };
                *value = if number.is_u64() { Value::from(scaled as u64) } else { Value::from(scaled) };
                self.know(Kind::Leaf, name, scaled);
                for k in 0..path.len() {
                    let mut parts: Vec<&str> = path.iter().map(String::as_str).collect();
                    parts[k] = "*";
                    self.by_name.entry(parts.join(".")).or_default().push(scaled);
                    if k + 1 < parts.len() && k > 0 {
                        parts[k + 1] = "*";
                        self.by_name.entry(parts.join(".")).or_default().push(scaled);
                        let mut parts = parts.clone();
                        if k + 2 < parts.len() {
                            parts[k + 2] = "*";
                            self.by_name.entry(parts.join(".")).or_default().push(scaled);
                        }
                    }
                }
            }
            Value::String(text)
                if NAMING.contains(&last.as_str()) || path[0] == "positions" || last == "source" =>
            {
                self.name(text);
            }
            Value::String(text) => {
                // A slot holds a number with its unit or a name.
                let slot = path.iter().rev().nth(1).is_some_and(|part| part == "slots");
                if slot && !text.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '−') {
                    self.name(text);
                } else {
                    *text = self.text(text, &path.join("."));
                }
            }
            _ => {}
        }
    }

    fn object(&mut self, object: &mut Map<String, Value>, path: &mut Vec<String>) {
        for (key, value) in object.iter_mut() {
            self.name(key);
            path.push(key.clone());
            self.scale(value, path);
            path.pop();
        }
    }

    fn know(&mut self, kind: Kind, name: String, value: f64) {
        self.content.known.push(Known { kind, name, value });
    }

    fn name(&mut self, text: &str) {
        let named = text.contains(|c: char| c.is_ascii_digit()) && text.contains(|c: char| c.is_alphabetic());
        if named && text.parse::<f64>().is_err() {
            self.content.names.push(text.to_owned());
        }
    }

    /// A text with other numbers of as many decimals in it.
    fn text(&mut self, text: &str, name: &str) -> String {
        let mut out = String::new();
        let mut last = 0;
        for (k, (at, end, value, _)) in of_line(text).into_iter().enumerate() {
            let name = format!("{name}#{k}");
            let by = factor(self.copy, &name);
            let digits = &text[at..end];
            let own = digits.split(['\u{202f}', 'e']).next().unwrap_or_default();
            let decimals = own.split_once('.').map_or(0, |(_, behind)| behind.len());
            let new = if value == 0.0 || own.len() < digits.len() || self.copy == 0 {
                digits.to_owned()
            } else if value.abs() < 20.0 && decimals == 0 {
                format!("{}", value.abs() + ((by * 1e4) as u64 % 3) as f64)
            } else {
                format!("{:.decimals$}", value.abs() * by)
            };
            let shown: f64 = of_line(&new).first().map_or(f64::NAN, |found| found.2);
            self.know(Kind::Leaf, name, shown.abs() * value.signum());
            out.push_str(&text[last..at]);
            out.push_str(&new);
            last = end;
        }
        out + &text[last..]
    }

    /// The largest of all monitors, and of all pairs, of each quantity with its components, and when.
    fn peaks(&mut self, summary: &Value) {
        for part in ["monitors", "relative"] {
            let mut largest: BTreeMap<String, (f64, f64)> = BTreeMap::new();
            let all = summary[part].as_object().into_iter().flat_map(Map::values);
            for (quantity, peaks) in all.filter_map(Value::as_object).flatten() {
                if let (Some(max), Some(min)) = (peaks["max"].as_f64(), peaks["min"].as_f64()) {
                    let most = if max.abs() >= min.abs() { max } else { min };
                    self.know(Kind::Leaf, format!("larger of both {quantity} in {part}"), most);
                }
                for end in ["max", "min"] {
                    let (Some(value), Some(time)) =
                        (peaks[end].as_f64(), peaks[&format!("t_{end}")].as_f64())
                    else {
                        continue;
                    };
                    for name in [&quantity[..1], quantity] {
                        let most = largest.entry(name.to_owned()).or_default();
                        if value.abs() > most.0 {
                            *most = (value.abs(), time);
                        }
                    }
                }
            }
            for (name, (value, time)) in largest {
                self.know(Kind::Over, format!("largest {name} of {part}"), value);
                self.know(Kind::Over, format!("time of largest {name} of {part}"), time);
            }
        }
    }

    /// Numbers of one name together.
    fn over(&mut self) {
        for (name, values) in std::mem::take(&mut self.by_name) {
            if values.len() > 1 {
                let most = values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
                self.know(Kind::Over, format!("largest of {name}"), most);
                self.know(Kind::Over, format!("sum of {name}"), values.iter().sum());
            }
        }
    }
}

/// A table with other numbers; columns of whole numbers that name rows stay as they are.
fn table(file: &str, text: &str, copy: u64, content: &mut Content) -> String {
    const KEYS: [&str; 5] = ["stage", "bolt", "station", "name", "when"];
    let mut lines = text.lines();
    let header = lines.next().unwrap_or_default();
    let columns: Vec<&str> = header.split(',').collect();
    let own = |column: &str| column.split(" [").next().unwrap_or_default().to_owned();
    let mut rows: Vec<Vec<String>> = lines.map(entries).collect();
    let mut numbers: Vec<Option<Vec<f64>>> = Vec::new();
    for (k, column) in columns.iter().enumerate() {
        let name = own(column);
        content.name_of(column);
        let values: Option<Vec<f64>> =
            rows.iter().map(|row| row.get(k).and_then(|entry| entry.parse().ok())).collect();
        let keyed = KEYS.contains(&name.as_str()) || name == "state" || name.ends_with(".state");
        let Some(mut values) = values.filter(|_| !keyed) else {
            rows.iter().filter_map(|row| row.get(k)).for_each(|entry| content.name_of(entry));
            numbers.push(None);
            continue;
        };
        // One factor for all times, of which some are read beside one another.
        let by = if name.starts_with("time") {
            factor(copy, "time")
        } else {
            factor(copy, &format!("{file}:{column}"))
        };
        for (value, row) in values.iter_mut().zip(&mut rows) {
            *value *= by;
            row[k] = format!("{value}");
        }
        numbers.push(Some(values));
    }
    // All rows, and those that have one text in common.
    let mut parts: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for (k, row) in rows.iter().enumerate() {
        parts.entry(String::new()).or_default().push(k);
        let mut words = vec![];
        let texts =
            row.iter().zip(&numbers).filter(|(entry, own)| own.is_none() && entry.parse::<f64>().is_err());
        for (entry, _) in texts {
            parts.entry(format!(" where {entry}")).or_default().push(k);
            words.push(entry.as_str());
        }
        for pair in 0..words.len() {
            for other in pair + 1..words.len() {
                parts.entry(format!(" where {} and {}", words[pair], words[other])).or_default().push(k);
            }
        }
    }
    let known = &mut content.known;
    for (part, at) in &parts {
        if at.len() < 2 && part.contains(" and ") {
            continue;
        }
        for (column, values) in columns.iter().zip(&numbers).filter_map(|(c, v)| Some((own(c), v.as_ref()?)))
        {
            let by_size = |x: &&usize, y: &&usize| values[**x].total_cmp(&values[**y]);
            let finite = || at.iter().filter(|k| values[**k].is_finite());
            let marked = [
                ("largest", finite().max_by(by_size)),
                ("smallest", finite().min_by(by_size)),
                ("largest by size", finite().max_by(|x, y| values[**x].abs().total_cmp(&values[**y].abs()))),
                ("first", finite().next()),
                ("second", finite().nth(1)),
                ("last", finite().last()),
            ];
            for (what, row) in marked {
                let Some(&row) = row else { continue };
                for (other, values) in
                    columns.iter().zip(&numbers).filter_map(|(c, v)| Some((own(c), v.as_ref()?)))
                {
                    // Of tables of histories the time alone stands beside a value.
                    if other == column
                        || columns.len() < 20
                        || ["time", "period", "depth", "z"].contains(&other.as_str())
                    {
                        let name = format!("{file}: {other} at {what} {column}{part}");
                        known.push(Known { kind: Kind::Extreme, name, value: values[row] });
                    }
                }
            }
            let count = at.len() as f64;
            let sum: f64 = finite().map(|k| values[*k]).sum();
            known.push(Known {
                kind: Kind::Over,
                name: format!("{file}: mean of {column}{part}"),
                value: sum / count,
            });
        }
        known.push(Known { kind: Kind::Over, name: format!("{file}: rows{part}"), value: at.len() as f64 });
    }
    // Columns of one quantity together.
    let mut alike: BTreeMap<String, f64> = BTreeMap::new();
    for (column, values) in columns.iter().zip(&numbers).filter_map(|(c, v)| Some((c, v.as_ref()?))) {
        let most = values.iter().filter(|x| x.is_finite()).fold(0.0_f64, |most, x| most.max(x.abs()));
        let quantity = own(column).rsplit('.').next().unwrap_or_default().to_owned();
        for name in [quantity, column.split_once(" [").map_or("", |(_, unit)| unit).to_owned()] {
            let all = alike.entry(name).or_default();
            *all = all.max(most);
        }
        let name = format!("{file}: {}", own(column));
        known.extend(values.iter().map(|value| Known { kind: Kind::Row, name: name.clone(), value: *value }));
    }
    let alike = alike.into_iter();
    known.extend(alike.map(|(name, value)| Known {
        kind: Kind::Over,
        name: format!("{file}: largest of all {name}"),
        value,
    }));
    if file == "energy.csv" {
        let of = |name: &str| {
            columns.iter().position(|column| own(column) == name).and_then(|k| numbers[k].as_ref())
        };
        let held = ["kinetic", "strain", "hourglass", "interface", "bolts"].map(of);
        let sum = |row: usize| held.iter().flatten().map(|values| values[row]).sum::<f64>();
        let most = (0..rows.len()).map(sum).fold(0.0, f64::max);
        let error =
            of("error").map_or(0.0, |values| values.iter().fold(0.0_f64, |most, x| most.max(x.abs())));
        known.push(Known {
            kind: Kind::Over,
            name: "error over the largest energy held".into(),
            value: error / most,
        });
    }
    // How far a monitor is from where it was, the largest of its rows.
    for column in columns.iter().map(|column| own(column)).filter(|_| file == "monitors.csv") {
        let Some(monitor) = column.strip_suffix(".ux") else { continue };
        let of = |name: &str| columns.iter().position(|column| own(column) == format!("{monitor}.{name}"));
        let all: Vec<&Vec<f64>> =
            ["ux", "uy", "uz"].into_iter().filter_map(of).filter_map(|k| numbers[k].as_ref()).collect();
        let length = |row: usize| all.iter().map(|values| values[row].powi(2)).sum::<f64>().sqrt();
        let most = (0..rows.len()).map(length).fold(0.0, f64::max);
        known.push(Known {
            kind: Kind::Over,
            name: format!("length of the displacement of {monitor}"),
            value: most,
        });
    }
    let mut out = format!("{header}\n");
    for row in rows {
        let quoted = row.iter().map(|e| if e.contains(',') { format!("\"{e}\"") } else { e.clone() });
        out.push_str(&quoted.collect::<Vec<_>>().join(","));
        out.push('\n');
    }
    out
}

/// The entries of a line; texts with commas in them are quoted.
fn entries(line: &str) -> Vec<String> {
    let (mut all, mut quoted) = (vec![String::new()], false);
    for c in line.chars() {
        match c {
            '"' => quoted = !quoted,
            ',' if !quoted => all.push(String::new()),
            c => all.last_mut().unwrap().push(c),
        }
    }
    all
}

/// A list of field files with other times; stages keep their numbers.
fn listed(file: &str, text: &str, copy: u64, content: &mut Content) -> String {
    let line = |line: &str| {
        let time = line.split_once("timestep=\"").and_then(|(_, rest)| rest.split_once('"'));
        match time.filter(|_| !line.contains("stage")) {
            Some((time, _)) => {
                let scaled = time.parse::<f64>().unwrap() * factor(copy, "time");
                content.known.push(Known {
                    kind: Kind::Field,
                    name: format!("time in {file}"),
                    value: scaled,
                });
                line.replace(&format!("timestep=\"{time}\""), &format!("timestep=\"{scaled}\""))
            }
            None => line.to_owned(),
        }
    };
    text.lines().map(line).collect::<Vec<_>>().join("\n") + "\n"
}

impl Content {
    fn name_of(&mut self, text: &str) {
        let text = text.split(" [").next().unwrap_or_default();
        let named = text.contains(|c: char| c.is_ascii_digit()) && text.contains(|c: char| c.is_alphabetic());
        if named && text.parse::<f64>().is_err() && !self.names.iter().any(|name| name == text) {
            self.names.push(text.to_owned());
        }
    }
}

/// The field files of a folder with other numbers; their places have one factor in all files.
fn fields(from: &Path, to: &Path, folder: &str, copy: u64, content: &mut Content) {
    fs::create_dir_all(to).unwrap();
    let mut files: Vec<_> = fs::read_dir(from).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    for path in files.iter().filter(|path| path.extension().is_some_and(|ending| ending == "vtu")) {
        let file = path.file_name().unwrap().to_str().unwrap();
        let mut grid = Grid::read(path).unwrap();
        let places = factor(copy, "places");
        let mut known =
            |name: String, value: f64| content.known.push(Known { kind: Kind::Field, name, value });
        for i in 0..3 {
            let all = || grid.points.iter().map(|p| p[i] * places);
            known(format!("{folder}/{file}: largest place {i}"), all().fold(f64::MIN, f64::max));
            known(format!("{folder}/{file}: smallest place {i}"), all().fold(f64::MAX, f64::min));
        }
        for point in &mut grid.points {
            *point = point.map(|x| x * places);
        }
        for array in grid.point_data.iter_mut().chain(&mut grid.cell_data) {
            // Directions, and states, which some files hold as floating-point numbers.
            if array.name == "normal" || array.name.contains("state") {
                continue;
            }
            let by = factor(copy, &format!("{folder}/{file}: {}", array.name));
            scale(array, by);
            let finite = || (0..array.values.len()).map(|k| array.values.get(k)).filter(|x| x.is_finite());
            known(format!("{folder}/{file}: largest {}", array.name), finite().fold(f64::MIN, f64::max));
            known(format!("{folder}/{file}: smallest {}", array.name), finite().fold(f64::MAX, f64::min));
        }
        grid.write(&to.join(file)).unwrap();
    }
}

fn scale(array: &mut Array, by: f64) {
    match &mut array.values {
        Values::Float32(values) => values.iter_mut().for_each(|x| *x = (f64::from(*x) * by) as f32),
        Values::Float64(values) => values.iter_mut().for_each(|x| *x *= by),
        _ => {}
    }
}
