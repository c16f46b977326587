//! The way out, in words: what a key or a value should have been.

use toml::de::DeValue;
use tremolite_laws::parameter::Dimension;

use crate::keys::{Key, Kind, Limit, Need, Table};
use crate::law_key;
use crate::units::{self, UnitError};

/// The candidate most like a word, if one is close enough to be meant.
pub fn nearest<'a>(word: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    // No key is longer; the distance of a huge text would take long and mean nothing.
    if word.len() > 60 {
        return None;
    }
    let folded = word.to_lowercase();
    let distance = |c: &str| strsim::damerau_levenshtein(&folded, &c.to_lowercase());
    let (distance, candidate) = candidates.map(|c| (distance(c), c)).min_by_key(|(d, _)| *d)?;
    (distance <= word.chars().count() / 3).then_some(candidate)
}

/// What to write for an unknown key; `case` is the table of all tables, one of which may have it.
pub(crate) fn key<'a>(
    case: &'static Table,
    path: &str,
    name: &str,
    here: impl Iterator<Item = &'a str> + Clone,
) -> String {
    if let Some(meant) = nearest(name, here.clone()) {
        return format!("did you mean `{meant}`?");
    }
    let keys: Vec<&str> = here.collect();
    let list = format!("keys here: {}", keys.join(", "));
    // A key behind the header of a table within a table is that table's: its own comes before.
    let around = path.rsplit_once('.').map(|(around, _)| around);
    let in_it = around.and_then(|around| named(case, around)).filter(|table| has(table, name));
    match in_it.or_else(|| owner(case, name)) {
        Some(table) if Some(table.path) == around => {
            format!("`{name}` belongs to [[{}]], above its [[{path}]]; {list}", table.path)
        }
        Some(table) if table.path.is_empty() => {
            let of = table.keys.iter().find(|k| k.name == name);
            match of.map(|k| sample(k.name, &k.kind)).filter(|sample| sample.starts_with('[')) {
                Some(header) => format!("{header} is a table of its own; {list}"),
                None => format!("`{name}` belongs above all tables, at the top of the file; {list}"),
            }
        }
        Some(table) => format!("`{name}` belongs to [{}]; {list}", table.path),
        None => list,
    }
}

fn has(table: &Table, name: &str) -> bool {
    table.keys.iter().any(|k| k.name == name)
}

/// The table of a path, this one or below it.
fn named(table: &'static Table, path: &str) -> Option<&'static Table> {
    if table.path == path {
        return Some(table);
    }
    table.keys.iter().flat_map(|k| tables(&k.kind)).find_map(|t| named(t, path))
}

/// The first table below this one that has such a key.
fn owner(table: &'static Table, name: &str) -> Option<&'static Table> {
    if has(table, name) {
        return Some(table);
    }
    table.keys.iter().flat_map(|k| tables(&k.kind)).find_map(|t| owner(t, name))
}

/// The tables that a value of this kind may be.
pub(crate) fn tables(kind: &'static Kind) -> Vec<&'static Table> {
    match kind {
        Kind::Table(t) | Kind::Tables(t) | Kind::Brief(t, _) => vec![t],
        Kind::Materials(t) | Kind::Interfaces(t) => vec![t],
        Kind::Either(kinds) => kinds.iter().flat_map(tables).collect(),
        _ => Vec::new(),
    }
}

/// What to write for an unknown word.
pub(crate) fn word(text: &str, words: &[&'static str]) -> String {
    match nearest(text, words.iter().copied()) {
        Some(meant) => format!("did you mean \"{meant}\"?"),
        None => format!("write one of \"{}\"", words.join("\", \"")),
    }
}

/// What to write where a unit alone is expected.
pub(crate) fn unit(key: &str, error: &UnitError, dimension: Dimension) -> String {
    match error {
        UnitError::Unknown { meant: Some(_), .. } => error.remedy(key),
        _ => format!("write {}", sample("units", &Kind::Unit(dimension))),
    }
}

/// What to write for a required key that is missing.
pub(crate) fn missing(key: &Key) -> String {
    format!("add {} ({})", sample(key.name, &key.kind), key.doc)
}

/// The SI unit of a key that is a modulus of elasticity, or a stiffness per area; nothing of any other.
pub(crate) fn unit_of_stiffness(key: &Key) -> Option<&'static str> {
    match key.kind {
        Kind::Number(Dimension::PRESSURE, _) if key.doc.contains("modulus") => Some("Pa"),
        Kind::Number(Dimension::STIFFNESS, _) if key.name.contains("stiffness") => Some("Pa/m"),
        _ => None,
    }
}

/// What a value is in words.
pub(crate) fn found(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(text) if text.trim().is_empty() => "an empty text",
        DeValue::String(_) => "a text",
        DeValue::Integer(_) => "a whole number",
        DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date or time of day",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}

/// What a key is in words, to be read after 'should be'.
pub(crate) fn describe(key: &str, kind: &Kind) -> String {
    match kind {
        Kind::Number(dimension, _) => units::name_for(key, *dimension),
        Kind::Count(most) => format!("a whole number from 1 to {most}"),
        Kind::Text => "a text".to_owned(),
        Kind::File => "the name of a file".to_owned(),
        Kind::Name => "a name".to_owned(),
        Kind::Flag => "true or false".to_owned(),
        Kind::Unit(_) => "a unit".to_owned(),
        Kind::Permeability => "a permeability in m2 or m2/(Pa s)".to_owned(),
        Kind::Word(words) => format!("one of \"{}\"", words.join("\", \"")),
        Kind::List(kind, least, most) if least == most => {
            format!("a list of {least}, each {}", describe(key, kind))
        }
        Kind::List(kind, ..) => format!("a list, each {}", describe(key, kind)),
        Kind::Numbers(dimension) => format!("a list, each {}", units::name_for(key, *dimension)),
        Kind::Columns(_) => "a table of columns".to_owned(),
        Kind::Set(_) => "a table of numbers".to_owned(),
        Kind::Table(_) | Kind::Materials(_) => "a table".to_owned(),
        Kind::Map(_, kind) => format!("a table, each value {}", describe("", kind)),
        Kind::Tables(_) | Kind::Interfaces(_) => "a list of tables".to_owned(),
        Kind::Brief(table, keys) => table
            .brief(keys)
            .map_or_else(|| "a table".to_owned(), |kind| format!("a table or {}", describe(key, kind))),
        Kind::Either(kinds) => kinds.iter().map(|kind| describe(key, kind)).collect::<Vec<_>>().join(" or "),
    }
}

/// How a key of this kind is written.
pub(crate) fn sample(name: &str, kind: &Kind) -> String {
    match kind {
        Kind::Table(table) if !table.path.contains('.') => format!("[{}]", table.path),
        Kind::Tables(table) | Kind::Interfaces(table) => format!("[[{}]]", table.path),
        Kind::Materials(_) => "[material.rock]".to_owned(),
        _ => format!("{name} = {}", sample_value(name, kind)),
    }
}

fn sample_value(name: &str, kind: &Kind) -> String {
    match kind {
        Kind::Number(Dimension::NONE, _) | Kind::Count(_) => "…".to_owned(),
        Kind::Number(dimension, _) => {
            let like = units::example(name, *dimension);
            format!("\"… {}\"", like.split_once(' ').map_or("", |(_, unit)| unit))
        }
        Kind::Text | Kind::File | Kind::Name => "\"…\"".to_owned(),
        Kind::Flag => "true".to_owned(),
        Kind::Permeability => "\"… m2\"".to_owned(),
        Kind::Unit(dimension) => {
            let like = units::example(name, *dimension);
            format!("\"{}\"", like.split_once(' ').map_or(like.as_str(), |(_, unit)| unit))
        }
        Kind::Word(words) => format!("\"{}\"", words.join("\" | \"")),
        Kind::List(kind, least, _) => {
            format!("[{}]", vec![sample_value(name, kind); (*least).max(1)].join(", "))
        }
        Kind::Numbers(dimension) => {
            format!("[{}, …]", sample_value(name, &Kind::Number(*dimension, Limit::Any)))
        }
        Kind::Columns(columns) => {
            let keys = || columns.iter().map(law_key::column);
            let required = keys().filter(|k| matches!(k.need, Need::Required));
            let mut inside: Vec<String> = required.map(|k| sample(k.name, &k.kind)).collect();
            if inside.is_empty() {
                inside.extend(keys().next().map(|k| sample(k.name, &k.kind)));
            }
            format!("{{ {}, … }}", inside.join(", "))
        }
        Kind::Set(entries) => {
            let keys = entries.iter().map(law_key::of).filter(|k| matches!(k.need, Need::Required));
            let inside: Vec<String> = keys.map(|k| sample(k.name, &k.kind)).collect();
            format!("{{ {}, … }}", inside.join(", "))
        }
        Kind::Table(table) => {
            let keys = table.keys.iter().filter(|k| matches!(k.need, Need::Required));
            let inside: Vec<String> = keys.map(|k| sample(k.name, &k.kind)).collect();
            if inside.is_empty() { "{ … }".to_owned() } else { format!("{{ {} }}", inside.join(", ")) }
        }
        Kind::Brief(table, _) => {
            table.keys.first().map_or_else(|| "{ … }".to_owned(), |k| sample_value(k.name, &k.kind))
        }
        Kind::Map(like, kind) => {
            // The example of its dimension is a modulus; pressures are told in MPa.
            format!("{{ \"{like}\" = {} }}", sample_value("", kind).replace("GPa", "MPa"))
        }
        Kind::Either(kinds) => kinds.first().map_or_else(String::new, |kind| sample_value(name, kind)),
        Kind::Tables(_) | Kind::Materials(_) | Kind::Interfaces(_) => "{ … }".to_owned(),
    }
}

/// A sentence with its first letter as a capital; a symbol keeps its case, ν of a joint is not Ν.
pub(crate) fn capital(text: &str) -> String {
    let mut chars = text.chars();
    let Some(first) = chars.next().filter(|c| c.is_ascii_lowercase()) else { return text.to_owned() };
    // A symbol is one letter, or a letter with an index.
    match chars.clone().next() {
        Some(next) if next.is_alphabetic() || (first == 'a' && next == ' ') => {
            first.to_ascii_uppercase().to_string() + chars.as_str()
        }
        _ => text.to_owned(),
    }
}
