//! The numbers of tables, and of lists of field files.

use std::collections::BTreeMap;

use super::known::{Content, Kind, Known, factor};

/// A table with other numbers; columns of whole numbers that name rows stay as they are.
pub fn table(file: &str, text: &str, copy: u64, content: &mut Content) -> String {
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
                ("last", finite().next_back()),
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
pub fn listed(file: &str, text: &str, copy: u64, content: &mut Content) -> String {
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
