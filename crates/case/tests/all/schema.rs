//! The JSON schema says what the reader does.

use std::path::Path;

use serde_json::{Map, Value};
use toml::de::{DeTable, DeValue};
use tremolite_case::{Case, schema};
use tremolite_laws::interfaces::INTERFACES;
use tremolite_laws::materials::MATERIALS;

const EVERY_KEY: &str = include_str!("../cases/every-key.toml");
const FIRST_SHAKE: &str = include_str!("../../../../cases/first-shake/case.toml");

fn json(value: &DeValue<'_>) -> Value {
    match value {
        DeValue::String(s) => s.as_ref().into(),
        DeValue::Integer(n) => n.as_str().parse::<i64>().expect("a decimal integer").into(),
        DeValue::Float(x) => x.as_str().parse::<f64>().expect("a float").into(),
        DeValue::Boolean(b) => (*b).into(),
        DeValue::Datetime(d) => d.to_string().into(),
        DeValue::Array(a) => a.iter().map(|v| json(v.get_ref())).collect(),
        DeValue::Table(t) => t.iter().map(|(k, v)| (k.get_ref().to_string(), json(v.get_ref()))).collect(),
    }
}

fn case(source: &str) -> Value {
    let table = DeTable::parse(source).expect("good TOML").into_inner();
    json(&DeValue::Table(table))
}

/// The words of JSON Schema that our schema uses; any other is an error, so that none goes unchecked.
const WORDS: &[&str] = &[
    "$schema",
    "additionalProperties",
    "anyOf",
    "const",
    "dependentRequired",
    "default",
    "description",
    "enum",
    "examples",
    "exclusiveMinimum",
    "items",
    "maxItems",
    "maximum",
    "minItems",
    "minLength",
    "minProperties",
    "minimum",
    "not",
    "oneOf",
    "pattern",
    "properties",
    "required",
    "title",
    "type",
];

/// Whether a value fits a schema. Patterns of text are left to editors.
fn fits(schema: &Value, value: &Value) -> bool {
    let Value::Object(schema) = schema else { return schema != &Value::Bool(false) };
    schema.iter().all(|(word, rule)| {
        assert!(WORDS.contains(&word.as_str()), "{word}");
        let all = |each: &dyn Fn(&Value) -> bool| {
            rule.as_array().expect("an array").iter().filter(|r| each(r)).count()
        };
        let number = |holds: &dyn Fn(f64, f64) -> bool| {
            value.as_f64().is_none_or(|x| holds(x, rule.as_f64().expect("a number")))
        };
        let least =
            |length: Option<usize>| length.is_none_or(|n| n as u64 >= rule.as_u64().expect("a length"));
        match word.as_str() {
            "type" => match rule.as_str().expect("a type") {
                "object" => value.is_object(),
                "array" => value.is_array(),
                "string" => value.is_string(),
                "boolean" => value.is_boolean(),
                "number" => value.is_number(),
                "integer" => value.is_i64() || value.is_u64(),
                other => panic!("{other}"),
            },
            "enum" => rule.as_array().expect("words").contains(value),
            "const" => rule == value,
            "anyOf" => all(&|r| fits(r, value)) > 0,
            "oneOf" => all(&|r| fits(r, value)) == 1,
            "not" => !fits(rule, value),
            "dependentRequired" => value.as_object().is_none_or(|o| {
                let needed = |keys: &Value| {
                    keys.as_array().expect("keys").iter().all(|k| o.contains_key(k.as_str().expect("a key")))
                };
                rule.as_object().expect("keys").iter().all(|(k, keys)| !o.contains_key(k) || needed(keys))
            }),
            "required" => {
                value.as_object().is_none_or(|o| all(&|k| !o.contains_key(k.as_str().expect("a key"))) == 0)
            }
            "minimum" => number(&|x, limit| x >= limit),
            "maximum" => number(&|x, limit| x <= limit),
            "exclusiveMinimum" => number(&|x, limit| x > limit),
            "minItems" => least(value.as_array().map(Vec::len)),
            "maxItems" => value.as_array().is_none_or(|a| a.len() as u64 <= rule.as_u64().expect("a length")),
            "minLength" => least(value.as_str().map(str::len)),
            "minProperties" => least(value.as_object().map(Map::len)),
            "items" => value.as_array().is_none_or(|a| a.iter().all(|v| fits(rule, v))),
            "properties" => value.as_object().is_none_or(|o| {
                rule.as_object().expect("properties").iter().all(|(k, r)| o.get(k).is_none_or(|v| fits(r, v)))
            }),
            "additionalProperties" => value.as_object().is_none_or(|o| {
                let known = schema.get("properties").and_then(Value::as_object);
                let other = |k: &str| known.is_none_or(|p| !p.contains_key(k));
                o.iter().filter(|(k, _)| other(k)).all(|(_, v)| fits(rule, v))
            }),
            _ => true,
        }
    })
}

#[test]
fn good_cases_fit() {
    let schema = schema(MATERIALS);
    assert!(fits(&schema, &case(EVERY_KEY)));
    assert!(fits(&schema, &case(FIRST_SHAKE)));
    assert!(fits(&schema, &case(&EVERY_KEY.replace("lateral = { x = 0.8, y = 1.2 }", "lateral = \"80 %\""))));
    let (head, rest) = EVERY_KEY.split_once("lateral =").expect("initial stress");
    let (_, stages) = rest.split_once("[[stage]]").expect("stages");
    assert!(fits(&schema, &case(&format!("{head}[[stage]]{stages}"))), "none of the initial stresses");
}

#[test]
fn the_dynamic_run_is_required_beside_an_earthquake_alone() {
    let schema = schema(MATERIALS);
    let (head, rest) = EVERY_KEY.split_once("[motion]").expect("a motion");
    let (motion, rest) = rest.split_once("[dynamic]").expect("a dynamic run");
    let (_, tail) = rest.split_once("[[monitor]]").expect("a monitor");
    assert!(fits(&schema, &case(&format!("{head}[[monitor]]{tail}"))));
    assert!(!fits(&schema, &case(&format!("{head}[motion]{motion}[[monitor]]{tail}"))));
}

#[test]
fn what_the_reader_refuses_for_its_form_does_not_fit() {
    let schema = schema(MATERIALS);
    for (from, to) in [
        ("size_near = \"120 cm\"", "nears = \"120 cm\""),
        ("kind = \"within\"", "kind = \"outcrp\""),
        ("kind = \"within\"\n", ""),
        ("poisson = 0.48, ", ""),
        ("benches = 6", "benches = 0"),
        ("safety = 0.8", "safety = 1.5"),
        ("model_x_azimuth = \"30 deg\"", "model_x_azimuth = 30"),
        ("unit_weight = \"27 kN/m3\"", "unit_weight = \"27 kN/m3\"\ndensity = \"2700 kg/m3\""),
        ("unit_weight = \"27 kN/m3\"\n", ""),
        ("young = \"10 GPa\"\n", ""),
        ("law = \"elastic\"", "law = \"plastic\""),
        ("at = [\"0 m\", \"1 m\", \"-210 m\"]", "at = [0, 1]"),
        ("[material.rock]", "[mesh.file]\npath = \"a\"\n[material.rock]"),
        ("y = \"roller\"", "y = \"freefield\""),
        ("law = \"bandis\"", "law = \"bandi\""),
        ("law = \"bandis\"", "law = \"tied\""),
        ("law = \"tied\"", "law = \"bandis\""),
        ("max_closure = \"2 mm\"\n", ""),
        ("friction_coefficient = 0.7", "friktion = 0.7"),
        ("between = [\"transformer.bench*\", \"rock\"]", "between = [\"rock\"]"),
        ("contact_damping = 0.02", "contact_damping = 0.3"),
        ("contact_limit = 0.9", "contact_limit = 0"),
        ("viscosity = 0.04", "viscosity = 0.6"),
        ("release = 0.6", "release = 1.6"),
        ("release = \"100 %\"", "bolts = { pattern = \"crown\" }"),
        ("spacing = [\"1.5 m\", \"1.2 m\"]\n", ""),
        ("length = \"6 m\"\n", ""),
        ("pattern = \"systematic\"", "pattern = \"sistematic\""),
        ("pattern = \"systematic\"", "pattern = \"systematic\"\nfile = \"a.csv\""),
        ("diameter = \"25 mm\"", "diameter = 25"),
        ("plate = true", "plate = 1"),
        ("plate = true", "plate = \"tail\""),
        ("bond = { stiffness = \"10 GPa\", strength = \"300 kN/m\"", "bond = { stiffness = \"10 GPa\""),
        ("name = \"tunnel filled\"\n", ""),
        ("excavate = [\"transformer.bench*\"]", "excavate = []"),
        ("group = \"*.lining\"\nwithin", "within"),
        ("{ \"*.lining\" = \"0.2 MPa\", top = \"1 kPa\" }", "{}"),
        (
            "{ \"transformer.lining\" = \"concrete\", \"rock*\" = \"rock\" }",
            "{ transformer.lining = \"rock\" }",
        ),
        ("lateral = { x = 0.8, y = 1.2 }", "lateral = { x = 0.8 }"),
        ("lateral = { x = 0.8, y = 1.2 }", "lateral = -0.1"),
        ("lateral = { x = 0.8, y = 1.2 }", "lateral = 1\nstress = {}"),
        ("lateral = { x = 0.8, y = 1.2 }", "measured = [{ at = [0, 0, 0], zz = 1 }]"),
        ("tolerance = 1e-4", "tolerance = 0.1"),
        ("max_cycles = 5000", "max_cycles = 0"),
    ] {
        let source = EVERY_KEY.replacen(from, to, 1);
        assert!(!fits(&schema, &case(&source)), "{to}");
        assert!(Case::parse(Path::new("case.toml"), &source, MATERIALS).is_err(), "{to}");
    }
}

#[test]
fn editors_find_a_description_for_every_key_and_the_parameters_of_every_law() {
    fn walk(schema: &Value, count: &mut usize) {
        match schema {
            Value::Object(map) => {
                if let Some(Value::Object(properties)) = map.get("properties") {
                    for (key, property) in properties {
                        *count += 1;
                        assert!(property["description"].as_str().is_some_and(|d| d.len() > 5), "{key}");
                    }
                }
                map.values().for_each(|v| walk(v, count));
            }
            Value::Array(list) => list.iter().for_each(|v| walk(v, count)),
            _ => {}
        }
    }
    let schema = schema(MATERIALS);
    let mut count = 0;
    walk(&schema, &mut count);
    assert!(count > 80, "{count} keys");
    assert_eq!(schema["properties"]["output"]["properties"]["histories"]["default"], "0.01 s");
    let materials =
        schema["properties"]["material"]["additionalProperties"]["oneOf"].as_array().expect("laws");
    let interfaces = schema["properties"]["interface"]["items"]["oneOf"].as_array().expect("laws");
    assert_eq!(interfaces.last().map(|i| &i["properties"]["law"]["const"]), Some(&Value::from("tied")));
    for (law, table) in MATERIALS.iter().zip(materials).chain(INTERFACES.iter().zip(interfaces)) {
        assert_eq!(table["properties"]["law"]["const"], law.name);
        for parameter in law.parameters {
            assert!(table["properties"][parameter.name].is_object(), "{}.{}", law.name, parameter.name);
        }
    }
}
