//! Checks one value against its kind.

use std::borrow::Cow;
use std::ops::Range;

use toml::Spanned as Located;
use toml::de::{DeTable, DeValue};
use tremolite_laws::parameter::Dimension;

use crate::check::{Checker, given};
use crate::fields::{Fields, Item, Node};
use crate::keys::{Key, Kind, Limit};
use crate::law_key::{self, COLUMNS, SET};
use crate::{Spanned, key_path, renamed, suggest, units};

/// What to do about a name that [`begins_a_formula`].
pub const NO_FORMULA: &str = "names stand in tables, where spreadsheets take = + - @ at the beginning for a formula: begin with another character";

/// Whether a spreadsheet computes what begins so, in place of showing it. A number is no formula.
pub fn begins_a_formula(text: &str) -> bool {
    text.starts_with(['=', '+', '-', '@']) && !text.parse().is_ok_and(f64::is_finite)
}

/// Of water: density \[kg/m³\], dynamic viscosity \[Pa s\] at 20 °C; and gravity \[m/s²\].
const WATER_DENSITY: f64 = 1000.0;
const WATER_VISCOSITY: f64 = 1.0e-3;
const GRAVITY: f64 = 9.81;
const AREA: Dimension = Dimension { length: 2, mass: 0, time: 0, angle: 0 };
/// m²/(Pa s)
const MOBILITY: Dimension = Dimension { length: 3, mass: -1, time: 1, angle: 0 };

impl Checker<'_> {
    /// Checks a value; nothing if it is refused, and then the problem is kept.
    pub(crate) fn value(
        &mut self,
        kind: &Kind,
        value: &DeValue<'_>,
        span: Range<usize>,
        path: &str,
    ) -> Option<Node> {
        let span = self.placed(span);
        let item = match (kind, value) {
            (Kind::Number(dimension, limit), _) => self.number(*dimension, *limit, value, &span, path)?,
            (Kind::Count(most), DeValue::Integer(n)) => {
                let n = i64::from_str_radix(n.as_str(), n.radix()).ok().and_then(|n| u32::try_from(n).ok());
                match n {
                    Some(n) if n >= 1 && n <= *most => Item::Count(n),
                    _ => return self.wrong(kind, value, &span, path),
                }
            }
            (Kind::Text, DeValue::String(text)) if !text.trim().is_empty() => self.text(text, &span, path)?,
            (Kind::File, DeValue::String(text)) if !text.trim().is_empty() => Item::Text(text.to_string()),
            (Kind::Flag, DeValue::Boolean(flag)) => Item::Flag(*flag),
            (Kind::Name, DeValue::String(text)) => self.name(text, &span, path)?,
            (Kind::Unit(dimension), DeValue::String(text)) => match units::parse_unit(text, *dimension) {
                Ok(x) => Item::Number(x),
                Err(e) => {
                    let key = last(path);
                    return self.refuse(&span, path, &e.message(key), &suggest::unit(key, &e, *dimension));
                }
            },
            (Kind::Permeability, DeValue::String(text)) => self.permeability(text, &span, path)?,
            (Kind::Word(words), DeValue::String(text)) => self.word(words, text, &span, path)?,
            (Kind::List(kind, least, most), DeValue::Array(values))
                if (*least..=*most).contains(&values.len()) =>
            {
                let before = self.problems.len();
                let nodes: Vec<Node> =
                    values.iter().filter_map(|v| self.value(kind, v.get_ref(), v.span(), path)).collect();
                if self.problems.len() > before {
                    return None;
                }
                Item::List(nodes)
            }
            (Kind::Numbers(dimension), DeValue::Array(values)) if !values.is_empty() => {
                let before = self.problems.len();
                let each = Kind::Number(*dimension, Limit::Any);
                let nodes: Vec<Node> =
                    values.iter().filter_map(|v| self.value(&each, v.get_ref(), v.span(), path)).collect();
                if self.problems.len() > before {
                    return None;
                }
                Item::List(nodes)
            }
            (Kind::Columns(columns), DeValue::Table(t)) => {
                let keys: Vec<Key> = columns.iter().map(law_key::column).collect();
                let fields = self.table(&COLUMNS, Some(&keys), t, span.clone(), path);
                self.as_long(&fields);
                Item::Table(fields)
            }
            (Kind::Set(entries), DeValue::Table(t)) => {
                let keys: Vec<Key> = entries.iter().map(law_key::of).collect();
                Item::Table(self.table(&SET, Some(&keys), t, span.clone(), path))
            }
            (Kind::Table(table), DeValue::Table(t)) => {
                Item::Table(self.table(table, Some(&[]), t, span.clone(), path))
            }
            (Kind::Tables(table) | Kind::Interfaces(table), DeValue::Array(a))
                if !a.is_empty() && a.iter().all(|v| v.get_ref().is_table()) =>
            {
                let tables = a.iter().enumerate().filter_map(|(i, v)| {
                    let t = v.get_ref().as_table()?;
                    let path = format!("{path}[{}]", label(t, i));
                    let span = self.placed(v.span());
                    let fields = match kind {
                        Kind::Interfaces(_) => self.interface(table, t, span.clone(), &path),
                        _ => self.table(table, Some(&[]), t, span.clone(), &path),
                    };
                    Some(Node { item: Item::Table(fields), span })
                });
                Item::List(tables.collect())
            }
            (Kind::Brief(table, _), DeValue::Table(t)) => {
                Item::Table(self.table(table, Some(&[]), t, span.clone(), path))
            }
            (Kind::Brief(table, keys), _) if fits(kind, value) => {
                if let Some(brief) = table.brief(keys) {
                    self.value(brief, value, span.clone(), path)?;
                }
                let mut long = DeTable::new();
                for key in *keys {
                    let at = span.clone();
                    long.insert(
                        Located::new(at.clone(), Cow::Borrowed(*key)),
                        Located::new(at, value.clone()),
                    );
                }
                Item::Table(self.table(table, Some(&[]), &long, span.clone(), path))
            }
            (Kind::Map(_, each), DeValue::Table(t)) if !t.is_empty() => Item::Map(self.map(each, t, path)?),
            (Kind::Materials(table), DeValue::Table(t)) if !t.is_empty() => {
                Item::Materials(self.materials(table, t))
            }
            (Kind::Either(kinds), _) => return self.either(kind, kinds, value, &span, path),
            _ => return self.wrong(kind, value, &span, path),
        };
        Some(Node { item, span })
    }

    /// Checks the values of a table with free keys; nothing if one is refused.
    fn map(
        &mut self,
        each: &Kind,
        written: &DeTable<'_>,
        path: &str,
    ) -> Option<Vec<(Spanned<String>, Node)>> {
        let before = self.problems.len();
        let mut entries = Vec::new();
        for (name, (at, value)) in given(written) {
            let at = self.placed(at);
            if name.trim().is_empty() {
                self.problem(at, format!("a key of `{}` is empty", last(path)), "name what it is for");
                continue;
            }
            if let (DeValue::Table(inner), false) = (value.get_ref(), fits(each, value.get_ref())) {
                let whole = dotted(name, inner);
                let message = format!("`{name}` should be {}, not a table", suggest::describe("", each));
                self.problem(at, message, format!("put a name with dots in quotes: \"{whole}\" = …"));
                continue;
            }
            let path = format!("{path}.\"{}\"", name.escape_debug());
            if let Some(node) = self.value(each, value.get_ref(), value.span(), &path) {
                entries.push((Spanned::new(name.to_owned(), at), node));
            }
        }
        entries.sort_by_key(|(name, _)| name.span.start);
        (self.problems.len() == before).then_some(entries)
    }

    /// Refuses columns that do not have as many numbers as the first one written.
    fn as_long(&mut self, columns: &Fields) {
        let mut lists: Vec<(&'static str, &Node, usize)> = Vec::new();
        for (name, node) in &columns.nodes {
            if let Item::List(numbers) = &node.item {
                lists.push((name, node, numbers.len()));
            }
        }
        lists.sort_by_key(|(_, node, _)| node.span.start);
        let Some(&(first, _, rows)) = lists.first() else { return };
        for (name, node, found) in lists.into_iter().filter(|&(.., found)| found != rows) {
            let message = format!("`{name}` has {found} numbers, but `{first}` has {rows}");
            self.problem(node.span.clone(), message, "give each column one number a row");
        }
    }

    fn number(
        &mut self,
        dimension: Dimension,
        limit: Limit,
        value: &DeValue<'_>,
        span: &Range<usize>,
        path: &str,
    ) -> Option<Item> {
        let bare = |text: &str| text.parse::<f64>().ok();
        let x = match value {
            DeValue::String(text) => match units::parse(text, dimension) {
                Ok(x) => x,
                Err(e) => {
                    let key = last(path);
                    return self.refuse(span, path, &e.message(key), &e.remedy(key));
                }
            },
            DeValue::Integer(n) => match i128::from_str_radix(n.as_str(), n.radix()) {
                // Nearest double; no parameter needs more than 53 bits.
                Ok(n) => n as f64,
                Err(_) => return self.refuse(span, path, "is too large a number", "give a finite value"),
            },
            DeValue::Float(x) => bare(x.as_str()).unwrap_or(f64::NAN),
            _ => return self.wrong(&Kind::Number(dimension, limit), value, span, path),
        };
        if !x.is_finite() {
            return self.refuse(span, path, "is not a finite number", "give a finite value");
        }
        if !value.is_str() && self.lacks_unit(x, dimension) {
            return self.without_unit(x, dimension, span, path);
        }
        if !limit.holds(x) {
            let words = limit.words(dimension);
            return self.refuse(span, path, &format!("must be {words}"), &format!("give a value {words}"));
        }
        Some(Item::Number(x))
    }

    /// Whether a bare number is refused. Nothing is as much in any unit, but an angle of 0 in no unit is no angle.
    fn lacks_unit(&self, x: f64, dimension: Dimension) -> bool {
        match dimension {
            Dimension::NONE => false,
            Dimension::ANGLE => true,
            _ => x != 0.0 && !self.bare_si,
        }
    }

    fn without_unit(
        &mut self,
        x: f64,
        dimension: Dimension,
        span: &Range<usize>,
        path: &str,
    ) -> Option<Item> {
        let key = last(path);
        let mut remedy = format!("write \"{}\"", units::likely(key, x, dimension));
        // One word about it is enough for a file that is in SI throughout.
        if dimension != Dimension::ANGLE && !std::mem::replace(&mut self.told_of_si, true) {
            remedy += ", or put units = \"SI\" at the top of the file if all its bare numbers are in SI";
        }
        let message = format!("has no unit: {} is expected", units::name_for(key, dimension));
        self.refuse(span, path, &message, &remedy)
    }

    /// K = k ρ g/μ of a permeability k in m², and K = k ρ g of one in m²/(Pa s).
    fn permeability(&mut self, text: &str, span: &Range<usize>, path: &str) -> Option<Item> {
        let plain = ["(Pa s)", "(Pa*s)", "(Pa·s)"]
            .iter()
            .fold(text.to_owned(), |text, unit| text.replace(unit, "Pa/s"));
        let weight = WATER_DENSITY * GRAVITY;
        let conductivity = match (units::parse(&plain, AREA), units::parse(&plain, MOBILITY)) {
            (Ok(area), _) => area * weight / WATER_VISCOSITY,
            (_, Ok(mobility)) => mobility * weight,
            _ if units::parse(text, Dimension::VELOCITY).is_ok() => {
                let remedy = format!("write hydraulic_conductivity = \"{}\"", text.trim());
                return self.refuse(span, path, "in m/s is a hydraulic conductivity", &remedy);
            }
            _ => {
                let remedy =
                    "write it as \"1e-14 m2\" or \"1e-11 m2/(Pa s)\", or give `hydraulic_conductivity`";
                return self.refuse(span, path, "is not a permeability in m2 or m2/(Pa s)", remedy);
            }
        };
        if conductivity > 0.0 {
            Some(Item::Number(conductivity))
        } else {
            self.refuse(span, path, "must be above 0", "give a value above 0")
        }
    }

    /// A text, on one line or several.
    fn text(&mut self, text: &str, span: &Range<usize>, path: &str) -> Option<Item> {
        let commands = |c: char| c.is_control() && c != '\n';
        if text.contains(commands) {
            let remedy = "leave out tabs and other characters that do not print";
            return self.refuse(span, path, "has a control character in it", remedy);
        }
        Some(Item::Text(text.to_owned()))
    }

    fn name(&mut self, text: &str, span: &Range<usize>, path: &str) -> Option<Item> {
        let forbidden = |c: char| c.is_whitespace() || c.is_control() || ".,[]*?\"'".contains(c);
        if text.is_empty() || text.contains(forbidden) {
            return self.refuse(
                span,
                path,
                "cannot be used as a name",
                "names stand in headers and patterns: no blanks or quotes, and none of . , [ ] * ?",
            );
        }
        if begins_a_formula(text) {
            return self.refuse(span, path, "cannot be used as a name", NO_FORMULA);
        }
        Some(Item::Text(text.to_owned()))
    }

    pub(crate) fn word(
        &mut self,
        words: &[&'static str],
        text: &str,
        span: &Range<usize>,
        path: &str,
    ) -> Option<Item> {
        if words.contains(&text) {
            return Some(Item::Text(text.to_owned()));
        }
        let remedy = match renamed::word(text, words) {
            Some(new) => format!("write \"{new}\", its new name"),
            None => suggest::word(text, words),
        };
        self.refuse(span, path, &format!("cannot be \"{text}\""), &remedy)
    }

    fn either(
        &mut self,
        whole: &Kind,
        kinds: &'static [Kind],
        value: &DeValue<'_>,
        span: &Range<usize>,
        path: &str,
    ) -> Option<Node> {
        let fitting: Vec<&Kind> = kinds.iter().filter(|k| fits(k, value)).collect();
        let (problems, defaulted) = (self.problems.len(), self.defaulted.len());
        for kind in &fitting {
            self.problems.truncate(problems);
            self.defaulted.truncate(defaulted);
            let node = self.value(kind, value, span.clone(), path);
            if self.problems.len() == problems {
                return node;
            }
        }
        if fitting.is_empty() {
            return self.wrong(whole, value, span, path);
        }
        // A word of the list is a way out as well.
        if let [.., Kind::Word(words), _] = fitting[..]
            && let Some(problem) = self.problems.last_mut()
        {
            problem.remedy += &format!(", or \"{}\"", words.join("\", \""));
        }
        None
    }

    fn wrong<T>(&mut self, kind: &Kind, value: &DeValue<'_>, span: &Range<usize>, path: &str) -> Option<T> {
        let found = match (value, kind) {
            (
                DeValue::Array(a),
                Kind::List(..) | Kind::Numbers(_) | Kind::Tables(_) | Kind::Interfaces(_),
            ) => {
                format!("a list of {}", a.len())
            }
            (DeValue::Integer(n), Kind::Count(_)) => n.to_string(),
            (DeValue::Table(t), Kind::Map(..) | Kind::Materials(_)) if t.is_empty() => {
                "an empty one".to_owned()
            }
            _ => suggest::found(value).to_owned(),
        };
        let message = format!("should be {}, not {found}", suggest::describe(last(path), kind));
        self.refuse(span, path, &message, &format!("write {}", suggest::sample(last(path), kind)))
    }

    fn refuse<T>(&mut self, span: &Range<usize>, path: &str, message: &str, remedy: &str) -> Option<T> {
        self.problem(span.clone(), format!("`{}` {message}", last(path)), remedy);
        None
    }
}

/// Whether a value has the TOML type of a kind.
fn fits(kind: &Kind, value: &DeValue<'_>) -> bool {
    match kind {
        Kind::Number(..) => matches!(value, DeValue::String(_) | DeValue::Integer(_) | DeValue::Float(_)),
        Kind::Count(_) => value.is_integer(),
        Kind::Flag => matches!(value, DeValue::Boolean(_)),
        Kind::Text | Kind::File | Kind::Name | Kind::Unit(_) | Kind::Permeability | Kind::Word(_) => {
            value.is_str()
        }
        Kind::List(..) | Kind::Numbers(_) | Kind::Tables(_) | Kind::Interfaces(_) => value.is_array(),
        Kind::Table(_) | Kind::Map(..) | Kind::Columns(_) | Kind::Set(_) | Kind::Materials(_) => {
            value.is_table()
        }
        Kind::Brief(table, keys) => value.is_table() || table.brief(keys).is_some_and(|k| fits(k, value)),
        Kind::Either(kinds) => kinds.iter().any(|k| fits(k, value)),
    }
}

/// How an entry of a list of tables is called in a path: by its name, else by its number from 0.
fn label(table: &DeTable<'_>, index: usize) -> String {
    match table.get("name").and_then(|v| v.get_ref().as_str()) {
        Some(name) if name.len() < 60 => key_path::entry(name),
        _ => index.to_string(),
    }
}

/// The key at the end of a path; a free one with its quotes.
fn last(path: &str) -> &str {
    match path.ends_with('"').then(|| path.rfind(".\"")).flatten() {
        Some(at) => &path[at + 1..],
        None => path.rsplit('.').next().unwrap_or(path),
    }
}

/// A name that was written with dots and without quotes, and so has become tables: the first of its names in full.
fn dotted(name: &str, mut inner: &DeTable<'_>) -> String {
    let mut whole = name.to_owned();
    while let Some((key, value)) = inner.iter().next() {
        whole = format!("{whole}.{}", key.get_ref());
        let DeValue::Table(next) = value.get_ref() else { break };
        inner = next;
    }
    whole
}
