//! `tremolite list` and `tremolite schema`: what the registries hold.

use crate::exit::{Code, Outcome};
use crate::terminal::print;
use tremolite::quantities::{
    BOLT, BOLT_LINES, CELLS, Field, INTERFACE, MEASURES, MONITOR, Measure, PAIR, Quantity, RELATIVE,
    SHARE_OF_VOLUME, WET,
};
use tremolite_case::{
    BaseKind, BoltedFaces, Listed, ListedValue, Plate, Side, Top, bolt_keys, interface_keys, mesh_tables,
};
use tremolite_laws::interfaces::INTERFACES;
use tremolite_laws::materials::MATERIALS;
use tremolite_laws::{Dimension, Kind, LawInfo, Need, PairState, Parameter};
use tremolite_results::{BOLT_COLUMNS, CrackDirection};

#[derive(clap::Args)]
pub struct Args {
    #[arg(value_parser = ["keys", "mesh", "materials", "interfaces", "bolts", "boundaries", "quantities", "formats"])]
    what: String,
}

pub fn run(args: &Args) -> Outcome {
    match args.what.as_str() {
        "keys" => print(tremolite_case::reference(MATERIALS).trim_end()),
        "mesh" => mesh(),
        "materials" => materials(),
        "interfaces" => interfaces(),
        "bolts" => bolts(),
        "boundaries" => boundaries(),
        "quantities" => quantities(),
        _ => formats(),
    }
    Ok(Code::Done)
}

pub fn schema() -> Outcome {
    let schema = tremolite_case::schema(MATERIALS);
    print(&serde_json::to_string_pretty(&schema).unwrap_or_default());
    Ok(Code::Done)
}

fn unit(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::NONE => "1",
        Dimension::LENGTH => "m",
        Dimension::TIME => "s",
        Dimension::RATE => "1/s",
        Dimension::VELOCITY => "m/s",
        Dimension::ACCELERATION => "m/s2",
        Dimension::PRESSURE => "Pa",
        Dimension::DENSITY => "kg/m3",
        Dimension::FORCE => "N",
        Dimension::FRACTURE_ENERGY => "N/m",
        // A unit weight has the same dimension; N/m3 is the same unit.
        Dimension::STIFFNESS => "Pa/m",
        Dimension::ANGLE => "deg, rad",
        _ => "SI",
    }
}

/// One line of a table of a law: name, unit, meaning.
fn entry(name: &str, unit: &str, doc: &str) {
    print(&format!("    {name:25} {unit:10} {doc}"));
}

/// The line of a parameter, and those of its columns below it if it is a table.
fn parameter(p: &Parameter, indent: &str) {
    let (unit, doc) = match p.kind {
        Kind::Number(d) => (unit(d), p.doc.to_owned()),
        Kind::Word(words) => ("word", format!("{}: {}", p.doc, words.join(" | "))),
        Kind::Table(_) | Kind::Set(_) => ("table", p.doc.to_owned()),
    };
    let need = match (p.need, p.kind) {
        (Need::Required, _) => "required".to_owned(),
        (Need::Number(x), Kind::Number(d)) => format!("default {}", tremolite_case::units::format(x, d)),
        (Need::Number(x), _) => format!("default {x}"),
        (Need::Word(w), _) => format!("default {w}"),
        (Need::Optional(what), _) => format!("left out: {what}"),
        (Need::Chosen(what), _) => format!("left out in a case: {what}"),
    };
    entry(&format!("{indent}{}", p.name), unit, &format!("{doc} [{need}]"));
    if let Kind::Table(columns) | Kind::Set(columns) = p.kind {
        columns.iter().for_each(|column| parameter(column, "  "));
    }
}

fn materials() {
    for (k, material) in MATERIALS.iter().enumerate() {
        if k > 0 {
            print("");
        }
        law(material, || {
            entry("density", "kg/m3", "mass per volume [required, or unit_weight]");
            entry("unit_weight", "N/m3", "weight per volume [required, or density]");
        });
    }
}

fn interfaces() {
    print("every [[interface]] of a case, whatever its law\n  keys");
    keys(&interface_keys());
    for interface in INTERFACES {
        print("");
        law(interface, || {});
    }
    print("\nstates of a pair, in the column state of every law");
    for state in PairState::ALL {
        print(&format!("    {} {:8} {}", state.number(), state.word(), state.meaning()));
    }
}

fn mesh() {
    for (k, (path, doc, all)) in mesh_tables().into_iter().enumerate() {
        let blank = if k > 0 { "\n" } else { "" };
        print(&format!("{blank}[{path}] {doc}"));
        keys(&all);
    }
}

fn bolts() {
    let [own, bond] = bolt_keys();
    print("every [[stage.bolts]] of a case\n  keys");
    keys(&own);
    print("\n  keys of its bond");
    keys(&bond);
    for (heading, meanings) in [("pattern", BoltedFaces::MEANINGS), ("plate", Plate::MEANINGS)] {
        print(&format!("\n  {heading}"));
        for (word, meaning) in meanings {
            print(&format!("    {word:16} {meaning}"));
        }
    }
}

/// A line for each key of a case.
fn keys(keys: &[Listed]) {
    for key in keys {
        let unit = match key.value {
            ListedValue::Number(dimension) => unit(dimension),
            ListedValue::Other(word) => word,
        };
        entry(key.name, unit, &format!("{} [{}]", key.doc, key.need));
    }
}

/// What a law is, its parameters behind those that all of its kind have, and its history.
fn law(law: &LawInfo, first: impl Fn()) {
    print(&format!("{}: {} ({})\n  parameters", law.name, law.summary, law.source));
    first();
    law.parameters.iter().for_each(|p| parameter(p, ""));
    if !law.history.is_empty() {
        print("  history");
    }
    law.history.iter().for_each(|column| entry(column.name, column.unit, column.doc));
}

fn boundaries() {
    for (heading, meanings) in [
        ("base (dynamic.base)", BaseKind::MEANINGS),
        ("sides (dynamic.sides.x, dynamic.sides.y)", Side::MEANINGS),
        ("top (dynamic.top)", Top::MEANINGS),
    ] {
        print(heading);
        for (word, meaning) in meanings {
            print(&format!("    {word:16} {meaning}"));
        }
    }
}

fn quantities() {
    fn table<V>(heading: &str, quantities: &[Quantity<V>]) {
        print(heading);
        for q in quantities {
            print(&format!("    {:18} {:6} {}", q.name, q.unit, q.doc));
        }
    }
    table("monitors.csv, NAME.quantity", MONITOR);
    table("monitors.csv, NAME.quantity where there is water", WET);
    table("monitors.csv, NAME.quantity of monitors with `interface`", PAIR);
    table("monitors.csv, NAME.quantity of monitors with `bolt`", BOLT);
    table("monitors.csv, pairs FIRST-SECOND.quantity", RELATIVE);
    table("interfaces.csv, NAME.quantity of interfaces that are not tied", INTERFACE);
    print("bolts.csv, a row for each bolt of a group and time");
    for column in BOLT_COLUMNS {
        print(&format!("    {:18} {:6} {}", column.name, column.unit, column.doc));
    }
    print("damage.csv, GROUP.quantity, of groups that are no part of another and whose law keeps it");
    for measure in &MEASURES {
        for name in names(measure) {
            print(&format!("    {name:22} {SHARE_OF_VOLUME:6} {}", measure.meaning(name)));
        }
    }
    print(&format!("    {:22} {:6} widest crack of the group so far", "crack_opening", "m"));
    for direction in CrackDirection::ALL {
        print(&format!("    {:22} {:6} {}", direction.column(), "m", direction.meaning()));
    }
    table("fields/*.vtu, always (ParaView: Find Data, element is 3404)", &CELLS);
    table("bolts/*.vtu, a line for each segment of a bolt", &BOLT_LINES);
    print("fields/*.vtu, by the word in output.fields");
    for field in Field::ALL {
        let (name, doc) = field.description();
        print(&format!("    {name:18} {doc}"));
    }
}

/// What the laws call a measure of damage, each name once.
fn names(measure: &Measure) -> Vec<&'static str> {
    let mut names: Vec<&str> = Vec::new();
    for column in MATERIALS.iter().flat_map(|law| law.history).filter(|c| c.role == measure.role) {
        if !names.contains(&column.name) {
            names.push(column.name);
        }
    }
    names
}

fn formats() {
    print("meshes, recognised by content");
    for format in tremolite_mesh::read::FORMATS {
        print(&format!("    {}", format.name));
    }
    print("earthquake records, recognised by content");
    for format in tremolite_motion::FORMATS {
        print(&format!("    {}", format.name));
    }
}
