//! What to write where in the text of a case, that a key has another value.

use std::ops::Range;

use toml::Spanned as Located;
use toml::de::{DeTable, DeValue};

use super::Change;
use super::layout::{Form, Layout};
use crate::key_path::{self, Part};
use crate::material::MATERIAL;
use crate::suggest;

/// Places of a text, from first to last, with what stands there instead.
type Edits = Vec<(Range<usize>, String)>;

pub(super) enum Edit {
    /// This is all.
    Done(Edits),
    /// What stands at the key in several lines goes first.
    First(Edits),
}

/// Why a change cannot be made.
#[derive(Debug)]
pub(super) struct Fault {
    pub message: String,
    pub remedy: String,
}

fn fault<T>(message: impl Into<String>, remedy: impl Into<String>) -> Result<T, Fault> {
    Err(Fault { message: message.into(), remedy: remedy.into() })
}

/// How a change is made in a text; none are needed in one that is no TOML, which is reported as such.
pub(super) fn edits(source: &str, change: &Change) -> Result<Edit, Fault> {
    let parts = match key_path::parse(&change.key) {
        Ok(parts) => parts,
        Err(why) => {
            return fault(
                format!("`{}` is no path of a key: {why}", change.key),
                "write the keys with dots, and entries of lists in brackets: stage[0].release",
            );
        }
    };
    let (document, errors) = DeTable::parse_recoverable(source);
    if !errors.is_empty() {
        return Ok(Edit::Done(Vec::new()));
    }
    let text = Layout(source);
    let mut editor = Editor { text, value: change.toml(), edits: Vec::new(), removed: Vec::new() };
    editor.key(&Home { table: document.get_ref(), form: Form::Root }, &[], document.get_ref(), &parts, "")?;
    let Editor { mut edits, mut removed, .. } = editor;
    edits.sort_by_key(|(place, _)| place.start);
    removed.sort_by_key(|place| place.start);
    if removed.is_empty() {
        return Ok(Edit::Done(edits));
    }
    Ok(Edit::First(removed.into_iter().map(|place| (place, String::new())).collect()))
}

/// A table that keys can be added to.
struct Home<'a> {
    table: &'a DeTable<'a>,
    form: Form,
}

struct Editor<'a> {
    text: Layout<'a>,
    value: String,
    edits: Edits,
    /// Lines of tables that are replaced as a whole.
    removed: Vec<Range<usize>>,
}

impl<'a> Editor<'a> {
    /// Sets a key of `table` or below it. `home` is the table itself or the next one around it that has a header or braces,
    /// `keys` lead from there to the table.
    fn key(
        &mut self,
        home: &Home<'a>,
        keys: &[&str],
        table: &'a DeTable<'a>,
        parts: &[Part],
        path: &str,
    ) -> Result<(), Fault> {
        let Some((Part::Key(key), rest)) = parts.split_first() else {
            return fault(
                format!("`{path}` is no list"),
                "leave the brackets out: entries of lists alone have a number or a name in brackets",
            );
        };
        let (around, path) = (path, key_path::below(path, key));
        let Some(value) = table.get(key.as_str()) else {
            return self.add(home, keys, table, parts, around);
        };
        if !rest.is_empty() {
            return self.below(home, &[keys, &[key.as_str()]].concat(), value, rest, &path);
        }
        match self.text.form(value) {
            Form::Plain | Form::Braces(_) => self.edits.push((value.span(), self.value.clone())),
            _ if matches!(home.form, Form::Braces(_)) => {
                return fault(
                    format!("`{path}` stands in braces as several keys with dots"),
                    "set them one by one, or the whole table in braces",
                );
            }
            _ => self.removed.extend(self.text.lines(value)),
        }
        Ok(())
    }

    /// Sets what `parts` lead to from a value on.
    fn below(
        &mut self,
        home: &Home<'a>,
        keys: &[&str],
        value: &'a Located<DeValue<'a>>,
        parts: &[Part],
        path: &str,
    ) -> Result<(), Fault> {
        match (value.get_ref(), parts) {
            (DeValue::Table(table), _) => match self.text.form(value) {
                Form::Spread => self.key(home, keys, table, parts, path),
                form => self.key(&Home { table, form }, &[], table, parts, path),
            },
            (DeValue::Array(entries), [Part::Key(key), ..]) => {
                let named = entries.iter().find_map(|entry| name(entry)).map_or_else(String::new, |name| {
                    format!(", or one by its name, {path}[{}].{key}", key_path::entry(name))
                });
                let message = format!("`{path}` is a list of {}", entries.len());
                fault(
                    message,
                    format!("set all of them, {path}[*].{key}, one by its number, {path}[0].{key}{named}"),
                )
            }
            (DeValue::Array(entries), [part, rest @ ..]) => {
                let entries: Vec<&'a Located<DeValue<'a>>> = entries.iter().collect();
                for k in chosen(&entries, part, path)? {
                    let path = format!("{path}[{k}]");
                    match self.text.form(entries[k]) {
                        _ if !rest.is_empty() => self.below(home, keys, entries[k], rest, &path)?,
                        Form::Header(_) => {
                            return fault(
                                format!("`{path}` is a table with a header"),
                                "set its keys one by one",
                            );
                        }
                        _ => self.edits.push((entries[k].span(), self.value.clone())),
                    }
                }
                Ok(())
            }
            (other, _) => fault(
                format!("`{path}` is {}, not a table", suggest::found(other)),
                format!("set `{path}` itself, or a key of a table"),
            ),
        }
    }

    /// Adds the key that the parts lead to from a table on that does not have the first of them.
    fn add(
        &mut self,
        home: &Home<'a>,
        keys: &[&str],
        table: &DeTable<'a>,
        parts: &[Part],
        path: &str,
    ) -> Result<(), Fault> {
        let mut names: Vec<&str> = keys.to_vec();
        for part in parts {
            let Part::Key(key) = part else {
                let list = key_path::below(path, names.last().copied().unwrap_or_default());
                return fault(
                    format!("there is no list `{list}`"),
                    "add it to the file, or set it as a whole",
                );
            };
            names.push(key);
        }
        if let (true, [Part::Key(name), _, ..]) = (path == MATERIAL.path, parts) {
            return unknown(name, table.keys().map(|key| key.get_ref().as_ref()), path);
        }
        let written: Vec<String> = names.iter().map(|name| toml_key(name)).collect();
        let written = format!("{} = {}", written.join("."), self.value);
        let last = self.text.end(home.table);
        let line_end = if self.text.0.contains("\r\n") { "\r\n" } else { "\n" };
        let edit = match (&home.form, last) {
            (Form::Braces(_), Some(last)) => (last..last, format!(", {written}")),
            (Form::Braces(braces), None) => {
                (braces.start + 1..braces.start + 1, format!(" {written}{}", self.gap(braces)))
            }
            (Form::Header(header), None) => self.behind_line(header.end, format!("{line_end}{written}")),
            (_, Some(last)) => self.behind_line(last, format!("{line_end}{written}")),
            (_, None) => {
                let start = self.text.0.len() - self.text.0.trim_start_matches('\u{feff}').len();
                (start..start, format!("{written}{line_end}"))
            }
        };
        self.edits.push(edit);
        Ok(())
    }

    /// What parts a key from the closing brace of an empty table.
    fn gap(&self, braces: &Range<usize>) -> &'static str {
        if self.text.0[braces.clone()].len() > 2 { "" } else { " " }
    }

    fn behind_line(&self, at: usize, text: String) -> (Range<usize>, String) {
        let at = self.text.line_end(at);
        (at..at, text)
    }
}

/// The numbers of the entries that a part of a path chooses.
fn chosen(entries: &[&Located<DeValue<'_>>], part: &Part, path: &str) -> Result<Vec<usize>, Fault> {
    match part {
        Part::Number(k) if *k >= entries.len() => fault(
            format!("there is no `{path}[{k}]`: the list has {}", entries.len()),
            match entries.len() {
                0 | 1 => format!("write {path}[0]"),
                many => format!("give a number from 0 to {}", many - 1),
            },
        ),
        Part::Number(k) => Ok(vec![*k]),
        Part::Name(wanted) => match entries.iter().position(|entry| name(entry) == Some(wanted)) {
            Some(k) => Ok(vec![k]),
            None => unknown(wanted, entries.iter().filter_map(|entry| name(entry)), path),
        },
        Part::All | Part::Key(_) => Ok((0..entries.len()).collect()),
    }
}

/// Refuses a name that is none of those known at a path.
fn unknown<'a, T>(wanted: &str, known: impl Iterator<Item = &'a str>, path: &str) -> Result<T, Fault> {
    let what = path.rsplit('.').next().unwrap_or(path);
    let list: Vec<&str> = known.collect();
    let remedy = match (suggest::nearest(wanted, list.iter().copied()), list.is_empty()) {
        (Some(meant), _) => format!("did you mean \"{meant}\"? Known are: {}", list.join(", ")),
        (None, true) => "none has a name: give its number from 0".to_owned(),
        (None, false) => format!("known are: {}", list.join(", ")),
    };
    fault(format!("there is no {what} `{wanted}`"), remedy)
}

/// The `name` of an entry of a list of tables.
fn name<'a>(entry: &'a Located<DeValue<'_>>) -> Option<&'a str> {
    entry.get_ref().as_table()?.get("name")?.get_ref().as_str()
}

/// A key as TOML.
fn toml_key(key: &str) -> String {
    let bare = !key.is_empty() && key.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_' || b == b'-');
    if bare { key.to_owned() } else { key_path::quoted(key) }
}
