//! Numbers out of the results of a run.

use std::path::Path;

use serde_json::Value;
use tremolite_case::study::{Checks, Measure, MeasureOf, Take};
use tremolite_results::{Column, Reliance, State, Table};

/// What a run left, to take numbers out of.
pub struct Results<'a> {
    folder: &'a Path,
    summary: Value,
}

impl<'a> Results<'a> {
    /// The results in a folder; nothing where there is no summary.
    pub fn of(folder: &'a Path) -> Option<Results<'a>> {
        let text = std::fs::read(folder.join("summary.json")).ok()?;
        Some(Results { folder, summary: serde_json::from_slice(&text).ok()? })
    }

    /// A text at the top of the summary.
    pub fn text(&self, key: &str) -> &str {
        self.summary.get(key).and_then(Value::as_str).unwrap_or_default()
    }

    /// Its classes of state and of reliance; none in files of older versions.
    pub fn classes(&self) -> (Option<State>, Option<Reliance>) {
        let class = |of: &str| self.summary.get(of).and_then(|judged| judged.get("class")).cloned();
        let (state, reliance) = (class("state"), class("reliance"));
        let state = state.and_then(|class| serde_json::from_value(class).ok());
        (state, reliance.and_then(|class| serde_json::from_value(class).ok()))
    }

    /// The program that ran it.
    pub fn program(&self) -> &str {
        self.summary.pointer("/run/program").and_then(Value::as_str).unwrap_or_default()
    }

    /// The number of a measure, SI; none where the study wants it left out of this run.
    ///
    /// # Errors
    /// Why there is none, in words.
    pub fn number(&self, measure: &Measure) -> Result<Option<f64>, String> {
        if let Some((path, names)) = &measure.unless
            && let Ok(Value::String(listed)) = find(&self.summary, path.trim())
            && listed.split(',').any(|one| names.iter().any(|name| name == one.trim()))
        {
            return Ok(None);
        }
        let found = match &measure.of {
            MeasureOf::Summary { path, over } => {
                let above = at(&self.summary, path)?;
                match over {
                    None => Ok(above),
                    Some(over) => match at(&self.summary, over)? {
                        below if below != 0.0 => Ok(above / below),
                        _ => Err(format!("`{}` is 0, so nothing can be over it", over.value)),
                    },
                }
            }
            MeasureOf::Column { table, column, take } => self.column(table, column, *take),
            MeasureOf::Checks(which) => self.checks(*which),
        };
        match (found, measure.otherwise) {
            (Err(_), Some(otherwise)) => Ok(Some(otherwise)),
            (Ok(x), _) if !x.is_finite() => Err("it is no finite number".into()),
            (found, _) => found.map(Some),
        }
    }

    /// How many checks there are, but for those that say nothing of this run.
    fn checks(&self, which: Checks) -> Result<f64, String> {
        let all = self.summary.get("checks").and_then(Value::as_array).ok_or("summary.json has no checks")?;
        let is = |check: &Value, key: &str| check.get(key).and_then(Value::as_bool).unwrap_or(false);
        let counted = |check: &&Value| match which {
            _ if is(check, "not_applicable") => false,
            Checks::Judged => true,
            Checks::Passed => is(check, "pass"),
            Checks::Missed => !is(check, "pass"),
        };
        Ok(all.iter().filter(counted).count() as f64)
    }

    /// The unit of a measure, where the files tell it.
    pub fn unit(&self, measure: &Measure) -> Option<String> {
        match &measure.of {
            MeasureOf::Summary { .. } | MeasureOf::Checks(_) => None,
            MeasureOf::Column { table, column, .. } => {
                read(&self.folder.join(&table.value), column).ok()?.unit(column).map(str::to_owned)
            }
        }
    }

    fn column(&self, table: &str, column: &str, take: Take) -> Result<f64, String> {
        let read = read(&self.folder.join(table), column)?;
        let Some(values) = read.column(column) else {
            let names: Vec<&str> = read.columns.iter().map(|c| c.name.as_str()).collect();
            return Err(format!("{table} has no column `{column}`; {}", suggestion(column, &names)));
        };
        let finite = || values.iter().copied().filter(|x| x.is_finite());
        let (low, high) = finite().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        let found = match take {
            Take::MaxAbs => finite().fold(f64::NEG_INFINITY, |most, x| most.max(x.abs())),
            Take::Max => high,
            Take::Min => low,
            Take::Range => high - low,
            Take::First => finite().next().unwrap_or(f64::NAN),
            Take::Last => finite().next_back().unwrap_or(f64::NAN),
        };
        if found.is_finite() {
            Ok(found)
        } else {
            Err(format!("column `{column}` of {table} has no numbers"))
        }
    }
}

/// The number at a path: keys with dots between them, quoted or not where they have dots of their own, and entries of lists by their
/// number or their `id` or `name` in brackets.
fn at(summary: &Value, path: &str) -> Result<f64, String> {
    match find(summary, path.trim()) {
        Ok(Value::Number(n)) => n.as_f64().ok_or_else(|| format!("`{path}` is no number")),
        Ok(Value::Bool(flag)) => Ok(f64::from(u8::from(*flag))),
        Ok(Value::Null) => Err(format!("`{path}` has no value in summary.json")),
        Ok(_) => Err(format!("`{path}` of summary.json is no number but has others below it")),
        Err(why) => Err(why),
    }
}

fn find<'a>(value: &'a Value, path: &str) -> Result<&'a Value, String> {
    if path.is_empty() {
        return Ok(value);
    }
    match value {
        Value::Object(map) => {
            // The longest first, since a key may be the beginning of another with a dot.
            let mut keys: Vec<&String> = map.keys().collect();
            keys.sort_by_key(|key| std::cmp::Reverse(key.len()));
            let fitting = keys.iter().find_map(|key| Some((*key, after(path, key)?)));
            match fitting {
                Some((key, rest)) => find(&map[key.as_str()], rest),
                None => {
                    let names: Vec<&str> = map.keys().map(String::as_str).collect();
                    Err(format!("summary.json has no `{path}` there; {}", suggestion(path, &names)))
                }
            }
        }
        Value::Array(list) => {
            let inside = path.strip_prefix('[').and_then(|rest| rest.split_once(']'));
            let Some((word, rest)) = inside else {
                return Err(format!("`{path}` stands below a list: write [0], or [name]"));
            };
            let named = |entry: &&Value| {
                ["id", "name"].iter().any(|k| entry.get(k).and_then(Value::as_str) == Some(word))
            };
            let entry =
                word.parse::<usize>().ok().and_then(|k| list.get(k)).or_else(|| list.iter().find(named));
            let entry = entry.ok_or_else(|| format!("a list of {} has no entry [{word}]", list.len()))?;
            find(entry, rest.strip_prefix('.').unwrap_or(rest))
        }
        _ => Err(format!("nothing stands below, where `{path}` is looked for")),
    }
}

/// What follows a key at the beginning of a path; nothing where it is another.
fn after<'a>(path: &'a str, key: &str) -> Option<&'a str> {
    let quoted = || {
        let quote = path.chars().next().filter(|c| ['"', '\''].contains(c))?;
        path[1..].strip_prefix(key)?.strip_prefix(quote)
    };
    let rest = path
        .strip_prefix(key)
        .filter(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
        .or_else(quoted)?;
    Some(rest.strip_prefix('.').unwrap_or(rest))
}

/// What may have been meant.
fn suggestion(wanted: &str, known: &[&str]) -> String {
    match tremolite_case::nearest(wanted, known.iter().copied()) {
        Some(meant) => format!("did you mean `{meant}`?"),
        None => {
            let shown: Vec<&str> = known.iter().copied().take(30).collect();
            format!("there are {}{}", shown.join(", "), if known.len() > shown.len() { ", …" } else { "" })
        }
    }
}

/// A table of numbers; of one with words in it, as stages.csv has names, the columns without, and the wanted one.
fn read(path: &Path, wanted: &str) -> Result<Table, String> {
    let why = match Table::read(path) {
        Ok(table) => return Ok(table),
        Err(why) => why.to_string(),
    };
    let Ok(mut reader) = csv::Reader::from_path(path) else { return Err(why) };
    let headers: Vec<Column> = reader.headers().map_err(|_| why)?.iter().map(Column::parse).collect();
    let mut values: Vec<Option<Vec<f64>>> = vec![Some(Vec::new()); headers.len()];
    for (row, record) in reader.records().enumerate() {
        let record = record.map_err(|e| format!("{}: {e}", path.display()))?;
        for ((cell, column), header) in record.iter().zip(&mut values).zip(&headers) {
            let number = if cell.is_empty() { Some(f64::NAN) } else { cell.trim().parse().ok() };
            match (column.as_mut(), number) {
                (Some(column), Some(number)) => column.push(number),
                (Some(_), None) if header.name == wanted => {
                    return Err(format!(
                        "{}, line {}: '{cell}' in column '{wanted}' is no number",
                        path.display(),
                        row + 2
                    ));
                }
                _ => *column = None,
            }
        }
    }
    let (headers, values) =
        headers.into_iter().zip(values).filter_map(|(header, values)| Some((header, values?))).unzip();
    Ok(Table::new(headers, values))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SUMMARY: &str = r#"{
        "damage": {"a": {"volume": 1}, "a.lining": {"volume": 8.0, "measures": {"d": {"beyond": {"0.5": 2.0}}}}},
        "gap": null, "text": "no",
        "checks": [{"id": "energy", "value": 0.01, "pass": true}, {"id": "loose", "pass": false, "monitors": "A, D"},
                  {"id": "none", "pass": true, "not_applicable": true}]
    }"#;

    #[test]
    fn numbers_are_found_by_their_path() {
        let summary: Value = serde_json::from_str(SUMMARY).unwrap();
        for (path, number) in [
            ("damage.a.volume", 1.0),
            ("damage.a.lining.volume", 8.0),
            ("damage.\"a.lining\".volume", 8.0),
            ("damage.'a.lining'.measures.d.beyond.\"0.5\"", 2.0),
            ("damage.a.lining.measures.d.beyond.0.5", 2.0),
            ("checks[0].value", 0.01),
            ("checks[energy].value", 0.01),
        ] {
            assert_eq!(at(&summary, path), Ok(number), "{path}");
        }
        for (path, says) in [
            ("damege.a.volume", "there are checks, damage"),
            ("damage.b", "no `b`"),
            ("gap", "has no value"),
            ("damage", "is no number"),
            ("text", "is no number"),
            ("text.more", "nothing stands below"),
            ("checks.value", "write [0]"),
            ("checks[nobody].value", "no entry [nobody]"),
        ] {
            let why = at(&summary, path).unwrap_err();
            assert!(why.contains(says), "{path}: {why}");
        }
    }

    #[test]
    fn columns_are_taken_by_their_extremes() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("summary.json"), SUMMARY).unwrap();
        std::fs::write(folder.path().join("m.csv"), "time [s],u [m]\n0,1\n1,-3\n2,NaN\n3,2\n").unwrap();
        let results = Results::of(folder.path()).unwrap();
        for (take, number) in [
            (Take::MaxAbs, 3.0),
            (Take::Max, 2.0),
            (Take::Min, -3.0),
            (Take::Range, 5.0),
            (Take::First, 1.0),
            (Take::Last, 2.0),
        ] {
            assert_eq!(results.column("m.csv", "u", take), Ok(number), "{take:?}");
        }
        // Beside words.
        let stages = "stage,name,u [m],v [m]\n0,\"rock, at rest\",1,\n1,dig,-3,2\n2,line,x,4\n";
        std::fs::write(folder.path().join("stages.csv"), stages).unwrap();
        assert_eq!(results.column("stages.csv", "v", Take::First), Ok(2.0));
        assert_eq!(results.column("stages.csv", "stage", Take::Last), Ok(2.0));
        assert_eq!(read(&folder.path().join("stages.csv"), "v").unwrap().unit("v"), Some("m"));
        for (column, says) in [
            ("u", "line 4: 'x' in column 'u' is no number"),
            ("name", "no number"),
            ("w", "there are stage, v"),
        ] {
            let why = results.column("stages.csv", column, Take::Max).unwrap_err();
            assert!(why.contains(says), "{why}");
        }
        assert!(results.column("m.csv", "U", Take::Max).unwrap_err().contains("did you mean `u`?"));
        assert!(results.column("n.csv", "u", Take::Max).is_err());
    }

    #[test]
    fn checks_are_counted_and_measures_of_named_places_left_out() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("summary.json"), SUMMARY).unwrap();
        let results = Results::of(folder.path()).unwrap();
        let study = |measure: &str| {
            let text = format!(
                "title = \"t\"\ncase = \"c.toml\"\n[[row]]\nname = \"a\"\n[measure]\nm = {{ {measure} }}\n"
            );
            let study = tremolite_case::study::StudyFile::parse(Path::new("s.toml"), &text);
            results.number(&study.unwrap_or_else(|e| panic!("{measure}: {e}")).measures[0])
        };
        for (word, number) in [("passed", 1.0), ("missed", 1.0), ("judged", 2.0)] {
            assert_eq!(study(&format!("checks = \"{word}\"")), Ok(Some(number)));
        }
        let of = |names: &str| {
            study(&format!(
                "summary = 'damage.a.volume', unless = 'checks[loose].monitors', names = [{names}]"
            ))
        };
        assert_eq!([of("'A'"), of("'B', 'D'"), of("'B'")], [Ok(None), Ok(None), Ok(Some(1.0))]);
    }
}
