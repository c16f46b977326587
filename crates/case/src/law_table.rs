//! A table that names a law: its own keys, and those that the law brings along.

use std::ops::Range;

use toml::de::DeTable;
use tremolite_laws::Choice;
use tremolite_laws::parameter::{self, LawInfo, Parameter, Values};

use crate::check::Checker;
use crate::fields::{Fields, Node};
use crate::keys::{Key, Need, Table};
use crate::{Diagnostic, suggest};

/// Stiffness (Pa or Pa/m) below which a bare number must be a slip: soft soil has as much, rock, concrete and their joints a
/// thousand times more.
const LEAST_STIFFNESS: f64 = 1e6;

/// A stiffness \[Pa/m\] and pressure \[Pa\] with which a law is asked about values that leave its own to be chosen.
const CHOICE: Choice = Choice { stiffness: 1e15, least: 0.0, pressure: 10e6 };

/// What may stand in a table that names a law.
pub(crate) struct LawTable<'a> {
    /// The keys that it has with any law.
    pub table: &'static Table,
    pub laws: &'a [LawInfo],
    /// Words that may stand in place of a law.
    pub instead: &'a [&'static str],
    /// What a law's parameter is as a key.
    pub key: fn(&Parameter) -> Key,
    /// Keys that it has with a known law alone.
    pub more: &'a [Key],
}

impl Checker<'_> {
    /// Checks a table against the keys of the law that it names, and by the law itself.
    pub(crate) fn law(
        &mut self,
        form: &LawTable<'_>,
        written: &DeTable<'_>,
        span: Range<usize>,
        path: &str,
    ) -> Fields {
        let law = written.get("law").and_then(|v| Some((v.get_ref().as_str()?, v.span())));
        let info = law.as_ref().and_then(|(law, _)| form.laws.iter().find(|l| l.name == *law));
        if let (Some((law, at)), None) = (law, info) {
            let names: Vec<&'static str> =
                form.laws.iter().map(|l| l.name).chain(form.instead.iter().copied()).collect();
            self.word(&names, law, &at, "law");
        }
        let keys: Option<Vec<Key>> =
            info.map(|i| i.parameters.iter().map(form.key).chain(form.more.iter().copied()).collect());
        let before = self.problems.len();
        let mut fields = self.table(form.table, keys.as_deref(), written, span, path);
        let keys = keys.unwrap_or_default();
        for key in &keys {
            if let Some(unit) = suggest::unit_of_stiffness(key) {
                self.bare_stiffness(key.name, unit, written, &mut fields);
            }
        }
        fields.parameters = info.map(|i| i.parameters.iter().map(|p| p.name).collect());
        if let Some(info) = info
            && (self.problems.len() == before || merely_incomplete(&fields, written))
        {
            self.ask_law(info, &keys, &fields);
        }
        fields
    }

    /// Refuses a stiffness that is a bare number, so in SI, and far below that of any rock or concrete.
    fn bare_stiffness(&mut self, key: &'static str, unit: &str, written: &DeTable<'_>, fields: &mut Fields) {
        let bare = written.get(key).is_some_and(|v| !v.get_ref().is_str());
        let value = fields.nodes.get(key).and_then(Node::number);
        let Some(value) = value.filter(|e| bare && e.value > 0.0 && e.value < LEAST_STIFFNESS) else {
            return;
        };
        // Nothing is stiffer than some hundred GPa.
        let prefix = if value.value < 1e3 { "G" } else { "M" };
        let message = format!("`{key}` = {} has no unit, and a bare number is in {unit}", value.value);
        self.problem(value.span, message, format!("write the unit: \"{} {prefix}{unit}\"?", value.value));
        fields.nodes.remove(key);
    }

    /// Places what the law refuses at the offending key. Every key that is given has been read, so what the law misses is
    /// missing; required keys have been reported already.
    fn ask_law(&mut self, info: &LawInfo, keys: &[Key], fields: &Fields) {
        let Some(values) = fields.values() else { return };
        let Err(refused) = (info.check)(&chosen(info, values)) else { return };
        for bad in refused {
            let required = |k: &Key| k.name == bad.name && matches!(k.need, Need::Required);
            if keys.iter().any(required) && !fields.nodes.contains_key(bad.name) {
                continue;
            }
            // The key, or a column and the table it is missing in.
            let (key, column) = bad.name.split_once('.').unwrap_or((bad.name, ""));
            let node = fields.nodes.get(key);
            let inner = node.and_then(Node::table).and_then(|table| table.nodes.get(column));
            let span = inner.or(node).map_or_else(|| fields.span.clone(), |n| n.span.clone());
            self.problems.push(Diagnostic::new(span, format!("`{}` {}", bad.name, bad.problem), bad.remedy));
        }
    }
}

/// The values with something in the place of what a model is to choose, so that the law can judge the others.
fn chosen(info: &LawInfo, values: Values) -> Values {
    let open = |p: &Parameter| matches!(p.need, parameter::Need::Chosen(_)) && !values.0.contains_key(p.name);
    if info.parameters.iter().any(open) { (info.chosen)(&values, &CHOICE) } else { values }
}

/// Whether all that is wrong with a table is what it leaves out; a refused column of a table would not be seen here.
fn merely_incomplete(fields: &Fields, written: &DeTable<'_>) -> bool {
    written
        .iter()
        .all(|(key, value)| !value.get_ref().is_table() && fields.nodes.contains_key(key.get_ref().as_ref()))
}
