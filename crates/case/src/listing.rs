//! Keys of the case as they are listed for people.

use tremolite_laws::parameter::Dimension;

use crate::bolts::{BOLTS, BOND};
use crate::interface::INTERFACE;
use crate::keys::{Key, Kind, Need, Table};
use crate::mesh::MESH;
use crate::{suggest, units};

/// One key.
#[derive(Clone, Debug, PartialEq)]
pub struct Listed {
    pub name: &'static str,
    pub value: ListedValue,
    /// `required`, or what stands for it where it is left out, and when it has a meaning.
    pub need: String,
    pub doc: &'static str,
}

/// What a key's value looks like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ListedValue {
    Number(Dimension),
    /// In a word: `list`, `word`.
    Other(&'static str),
}

/// The keys that every `[[interface]]` has, whatever its law.
pub fn interface_keys() -> Vec<Listed> {
    INTERFACE.keys.iter().map(listed).collect()
}

/// The tables of `[mesh]`, each with its path, what it is, and its keys.
pub fn mesh_tables() -> Vec<(&'static str, &'static str, Vec<Listed>)> {
    let mut tables: Vec<&'static Table> = vec![&MESH];
    let mut next = 0;
    while let Some(table) = tables.get(next) {
        let below = table.keys.iter().flat_map(|key| suggest::tables(&key.kind));
        let new: Vec<_> = below.filter(|t| tables.iter().all(|known| known.path != t.path)).collect();
        tables.extend(new);
        next += 1;
    }
    tables.iter().map(|t| (t.path, t.doc, t.keys.iter().map(listed).collect())).collect()
}

/// The keys that every `[[stage.bolts]]` has, and those of its `bond`.
pub fn bolt_keys() -> [Vec<Listed>; 2] {
    [&BOLTS, &BOND].map(|table| table.keys.iter().map(listed).collect())
}

pub(crate) fn listed(key: &Key) -> Listed {
    let need = match (key.need, key.kind) {
        (Need::Required, _) => "required".to_owned(),
        (Need::RequiredBeside(key, _), _) => format!("required beside `{key}`"),
        (Need::Default(value), _) => format!("default {}", value.trim_matches('"')),
        (Need::Number(x), Kind::Number(d, _)) => format!("default {}", units::format(x, d)),
        (Need::Number(x), _) => format!("default {x}"),
        (Need::Word(word), _) => format!("default {word}"),
        (Need::Optional(""), _) => "may be left out".to_owned(),
        (Need::Optional(what), _) => format!("left out: {what}"),
    };
    let when = key.when.words().map_or_else(String::new, |words| format!("; only {words}"));
    Listed { name: key.name, value: value(&key.kind), need: need + &when, doc: key.doc }
}

fn value(kind: &Kind) -> ListedValue {
    ListedValue::Other(match kind {
        Kind::Number(dimension, _) => return ListedValue::Number(*dimension),
        Kind::Count(_) => "count",
        Kind::Text | Kind::File | Kind::Word(_) | Kind::Unit(_) | Kind::Permeability => "word",
        Kind::Flag => "flag",
        Kind::Name => "name",
        Kind::List(..) | Kind::Numbers(_) => "list",
        Kind::Either(kinds) => return kinds.first().map_or(ListedValue::Other("value"), value),
        Kind::Brief(..)
        | Kind::Map(..)
        | Kind::Table(_)
        | Kind::Columns(_)
        | Kind::Set(_)
        | Kind::Materials(_) => "table",
        Kind::Tables(_) | Kind::Interfaces(_) => "tables",
    })
}
