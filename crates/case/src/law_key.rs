//! The keys that a law's parameters become.

use tremolite_laws::parameter::{self, Parameter};

use crate::keys::{Key, Kind, Limit, Need, Table, When};

/// A table of columns; which they may be, its entry in the law's parameters says.
pub(crate) static COLUMNS: Table =
    Table { path: "", doc: "Columns of numbers, as many in each.", keys: &[], choice: &[] };

/// A table of single numbers; which they may be, its entry in the law's parameters says.
pub(crate) static SET: Table = Table { path: "", doc: "One number each.", keys: &[], choice: &[] };

/// A law's parameter as a key of the table that names the law in a case.
pub(crate) fn of(parameter: &Parameter) -> Key {
    let kind = match parameter.kind {
        // Limits are the law's own to check.
        parameter::Kind::Number(dimension) => Kind::Number(dimension, Limit::Any),
        parameter::Kind::Word(words) => Kind::Word(words),
        parameter::Kind::Table(columns) => Kind::Columns(columns),
        parameter::Kind::Set(entries) => Kind::Set(entries),
    };
    let need = match parameter.need {
        parameter::Need::Required => Need::Required,
        parameter::Need::Number(x) => Need::Number(x),
        parameter::Need::Word(word) => Need::Word(word),
        parameter::Need::Optional(text) | parameter::Need::Chosen(text) => Need::Optional(text),
    };
    Key { name: parameter.name, kind, need, when: When::Always, doc: parameter.doc }
}

/// The same where the law stands alone, and no model is there to choose by.
pub(crate) fn alone(parameter: &Parameter) -> Key {
    match parameter.need {
        parameter::Need::Chosen(_) => Key { need: Need::Required, ..of(parameter) },
        _ => of(parameter),
    }
}

/// A column of a law's table as a key of that table.
pub(crate) fn column(parameter: &Parameter) -> Key {
    let key = of(parameter);
    match key.kind {
        Kind::Number(dimension, _) => Key { kind: Kind::Numbers(dimension), ..key },
        _ => key,
    }
}
