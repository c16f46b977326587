//! The numbers of `summary.json`.

use std::collections::BTreeMap;

use serde_json::{Map, Value};

use super::known::{Content, Kind, Known, factor};
use super::tokens::of_line;

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

/// The numbers of a summary on the way through it.
pub struct Leaves<'a> {
    pub copy: u64,
    pub content: &'a mut Content,
    /// Path without one or two of its parts → the numbers there.
    pub by_name: BTreeMap<String, Vec<f64>>,
}

impl Leaves<'_> {
    pub fn scale(&mut self, value: &mut Value, path: &mut Vec<String>) {
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
                // The page tells these in g as well.
                if name.contains("peak_acceleration") {
                    self.know(Kind::Leaf, format!("{name} in g"), scaled / 9.806_65);
                }
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

    pub fn know(&mut self, kind: Kind, name: String, value: f64) {
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
    pub fn peaks(&mut self, summary: &Value) {
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
    pub fn over(&mut self) {
        for (name, values) in std::mem::take(&mut self.by_name) {
            if values.len() > 1 {
                let most = values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
                self.know(Kind::Over, format!("largest of {name}"), most);
                self.know(Kind::Over, format!("sum of {name}"), values.iter().sum());
            }
        }
    }
}
