//! The JSON schema of the case file, for completion and checks in editors.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};
use toml::de::DeValue;
use tremolite_laws::parameter::{Dimension, LawInfo};

use crate::case::CASE;
use crate::interface::TIED;
use crate::keys::{Key, Kind, Limit, Need, Table, When};
use crate::law_key::{self, COLUMNS, SET};
use crate::laws::Laws;
use crate::{suggest, units};

/// The schema of a case that may name these laws (JSON Schema, draft 2020-12).
///
/// It says all that the tables of keys say, but for units: a value with a unit is any text that starts with a
/// number, and a bare number fits whether or not the file says `units = "SI"`. What lies between keys (names that must be known,
/// order of a window) only [`Case`](crate::Case) checks.
pub fn schema<'a>(laws: impl Into<Laws<'a>>) -> Value {
    let mut schema = table(&CASE, laws.into());
    schema.insert("$schema".into(), "https://json-schema.org/draft/2020-12/schema".into());
    schema.insert("title".into(), "Tremolite case".into());
    Value::Object(schema)
}

fn table(table: &Table, laws: Laws<'_>) -> Map<String, Value> {
    object(table.doc, table.keys.iter().copied(), table.choice, laws)
}

fn object(
    doc: &str,
    keys: impl Iterator<Item = Key>,
    choice: &[&[&str]],
    laws: Laws<'_>,
) -> Map<String, Value> {
    let mut properties = Map::new();
    let mut required: Vec<&str> = Vec::new();
    let mut beside: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for key in keys {
        properties.insert(key.name.to_owned(), property(&key, laws));
        if matches!((key.need, key.when), (Need::Required, When::Always)) {
            required.push(key.name);
        }
        let other = match (key.need, key.when) {
            (Need::RequiredBeside(other, _), _) | (Need::Required, When::Beside(other)) => Some(other),
            _ => None,
        };
        if let Some(other) = other {
            beside.entry(other).or_default().push(key.name);
        }
    }
    let mut schema = Map::new();
    schema.insert("type".into(), "object".into());
    schema.insert("description".into(), doc.into());
    schema.insert("properties".into(), Value::Object(properties));
    schema.insert("additionalProperties".into(), false.into());
    if !required.is_empty() {
        schema.insert("required".into(), json!(required));
    }
    if !beside.is_empty() {
        schema.insert("dependentRequired".into(), json!(beside));
    }
    if !choice.is_empty() {
        let any = |keys: &[&str]| {
            let each: Vec<Value> = keys.iter().map(|k| json!({ "required": [k] })).collect();
            json!({ "anyOf": each })
        };
        let one = |group: &&[&str]| match group {
            [] => json!({ "not": any(&choice.concat()) }),
            keys => any(keys),
        };
        schema.insert("oneOf".into(), choice.iter().map(one).collect());
    }
    schema
}

fn property(key: &Key, laws: Laws<'_>) -> Value {
    let mut schema = kind(key.name, &key.kind, laws);
    let mut doc = suggest::capital(key.doc);
    if let Some(when) = key.when.words() {
        doc += &format!(". Only {when}");
    }
    let default = match key.need {
        Need::RequiredBeside(other, _) => {
            doc += &format!(". Required beside `{other}`");
            None
        }
        Need::Required | Need::Optional("") => None,
        Need::Optional(without) => {
            doc += &format!(". Left out: {without}");
            None
        }
        Need::Default(text) => DeValue::parse(text).ok().map(|v| json(v.get_ref())),
        Need::Number(x) => Some(match key.kind {
            Kind::Number(dimension, _) if dimension != Dimension::NONE => units::format(x, dimension).into(),
            _ => json!(x),
        }),
        Need::Word(word) => Some(word.into()),
    };
    schema.insert("description".into(), doc.into());
    if let Some(default) = default {
        schema.insert("default".into(), default);
    }
    Value::Object(schema)
}

fn kind(key: &str, kind: &Kind, laws: Laws<'_>) -> Map<String, Value> {
    let schema = match kind {
        Kind::Number(dimension, limit) => return number(key, *dimension, *limit),
        Kind::Count(most) => json!({ "type": "integer", "minimum": 1, "maximum": most }),
        Kind::Text | Kind::File => json!({ "type": "string", "minLength": 1 }),
        Kind::Flag => json!({ "type": "boolean" }),
        Kind::Name => json!({ "type": "string", "pattern": r#"^[^\s.,\[\]*?"'=+@-][^\s.,\[\]*?"']*$"# }),
        Kind::Permeability => {
            json!({ "type": "string", "minLength": 1, "examples": ["1e-14 m2", "1e-11 m2/(Pa s)"] })
        }
        Kind::Unit(dimension) => {
            let like = units::example(key, *dimension);
            let unit = like.split_once(' ').map_or("", |(_, unit)| unit);
            json!({ "type": "string", "minLength": 1, "examples": [unit] })
        }
        Kind::Word(words) => json!({ "type": "string", "enum": words }),
        Kind::List(each, least, most) => json!({
            "type": "array", "items": self::kind(key, each, laws), "minItems": least, "maxItems": most,
        }),
        Kind::Numbers(dimension) => json!({
            "type": "array", "items": number(key, *dimension, Limit::Any), "minItems": 1,
        }),
        Kind::Columns(columns) => {
            return object(COLUMNS.doc, columns.iter().map(law_key::column), &[], laws);
        }
        Kind::Set(entries) => return object(SET.doc, entries.iter().map(law_key::of), &[], laws),
        Kind::Table(t) => return table(t, laws),
        Kind::Tables(t) => json!({ "type": "array", "items": table(t, laws) }),
        Kind::Brief(t, keys) => {
            let short = t.brief(keys).map(|brief| self::kind(key, brief, laws));
            json!({ "anyOf": [short, table(t, laws)] })
        }
        Kind::Map(_, each) => json!({
            "type": "object", "minProperties": 1, "additionalProperties": self::kind("", each, laws),
        }),
        Kind::Materials(t) => {
            let materials: Vec<Value> = laws.materials.iter().map(|law| of_law(t, law, laws)).collect();
            json!({ "type": "object", "minProperties": 1, "additionalProperties": { "oneOf": materials } })
        }
        Kind::Interfaces(t) => {
            let with_law = laws.interfaces.iter().map(|law| of_law(t, law, laws));
            let interfaces: Vec<Value> = with_law.chain([tied(t, laws)]).collect();
            json!({ "type": "array", "items": { "oneOf": interfaces } })
        }
        Kind::Either(kinds) => {
            let options: Vec<Value> = kinds.iter().map(|k| Value::Object(self::kind(key, k, laws))).collect();
            json!({ "anyOf": options })
        }
    };
    match schema {
        Value::Object(map) => map,
        _ => Map::new(),
    }
}

fn number(key: &str, dimension: Dimension, limit: Limit) -> Map<String, Value> {
    let mut bare = Map::new();
    bare.insert("type".into(), "number".into());
    match limit {
        Limit::Any => {}
        Limit::Positive => drop(bare.insert("exclusiveMinimum".into(), json!(0))),
        Limit::NotNegative => drop(bare.insert("minimum".into(), json!(0))),
        Limit::UpTo(most) => {
            bare.insert("exclusiveMinimum".into(), json!(0));
            bare.insert("maximum".into(), json!(most));
        }
        Limit::Within(most) => {
            bare.insert("minimum".into(), json!(0));
            bare.insert("maximum".into(), json!(most));
        }
    }
    let text = json!({
        "type": "string",
        "pattern": r"^\s*[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?\s*(\S.*)?$",
        "examples": [units::example(key, dimension)],
    });
    let mut schema = Map::new();
    if dimension == Dimension::ANGLE {
        schema.insert("anyOf".into(), json!([text]));
    } else {
        schema.insert("anyOf".into(), json!([text, bare]));
    }
    schema
}

/// A table that names this law.
fn of_law(table: &Table, law: &LawInfo, laws: Laws<'_>) -> Value {
    let keys = table.keys.iter().copied().chain(law.parameters.iter().map(law_key::of));
    named(object(table.doc, keys, table.choice, laws), law.name, law.summary)
}

/// An interface without a law, and without what has a meaning only with one.
fn tied(table: &Table, laws: Laws<'_>) -> Value {
    let keys = table.keys.iter().filter(|key| matches!(key.when, When::Always)).copied();
    named(object(table.doc, keys, table.choice, laws), TIED, "nothing slides or opens")
}

/// A table whose `law` is this word.
fn named(mut schema: Map<String, Value>, law: &str, doc: &str) -> Value {
    if let Some(Value::Object(properties)) = schema.get_mut("properties") {
        let word = json!({ "type": "string", "const": law, "description": doc });
        properties.insert("law".into(), word);
    }
    schema.insert("title".into(), law.into());
    Value::Object(schema)
}

/// A default as JSON.
fn json(value: &DeValue<'_>) -> Value {
    match value {
        DeValue::String(text) => text.as_ref().into(),
        DeValue::Integer(n) => n.as_str().parse::<i64>().map_or(Value::Null, Value::from),
        DeValue::Float(x) => x.as_str().parse::<f64>().map_or(Value::Null, Value::from),
        DeValue::Boolean(b) => (*b).into(),
        DeValue::Datetime(d) => d.to_string().into(),
        DeValue::Array(a) => a.iter().map(|v| json(v.get_ref())).collect(),
        DeValue::Table(t) => t.iter().map(|(k, v)| (k.get_ref().to_string(), json(v.get_ref()))).collect(),
    }
}
