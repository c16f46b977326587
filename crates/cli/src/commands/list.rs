//! `tremolite list` and `tremolite schema`: what the registries hold.

use crate::exit::{Code, Outcome};
use crate::terminal::print;
use tremolite::quantities::{Field, MONITOR, RELATIVE};
use tremolite_laws::materials::MATERIALS;
use tremolite_laws::{Dimension, Kind, Need, Parameter};

#[derive(clap::Args)]
pub struct Args {
    #[arg(value_parser = ["materials", "boundaries", "quantities", "formats"])]
    what: String,
}

pub fn run(args: &Args) -> Outcome {
    match args.what.as_str() {
        "materials" => materials(),
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
        Dimension::NONE => "",
        Dimension::LENGTH => "m",
        Dimension::TIME => "s",
        Dimension::RATE => "1/s",
        Dimension::PRESSURE => "Pa",
        Dimension::DENSITY => "kg/m3",
        Dimension::FRACTURE_ENERGY => "N/m",
        Dimension::STIFFNESS => "Pa/m",
        Dimension::ANGLE => "deg or rad",
        _ => "SI",
    }
}

fn parameter(p: &Parameter) {
    let kind = match p.kind {
        Kind::Number(d) => unit(d).to_owned(),
        Kind::Word(words) => words.join(" | "),
    };
    let need = match p.need {
        Need::Required => "required".to_owned(),
        Need::Number(x) => format!("default {x}"),
        Need::Word(w) => format!("default {w}"),
        Need::Optional(what) => what.to_owned(),
    };
    print(&format!("    {:24} {:16} {need:20} {}", p.name, kind, p.doc));
}

fn materials() {
    for law in MATERIALS {
        print(&format!("{}: {} ({})", law.name, law.summary, law.source));
        print("    density or unit_weight   kg/m3 or N/m3    required             mass per volume");
        law.parameters.iter().for_each(parameter);
        for column in law.history {
            print(&format!("    keeps {:18} {:16} {}", column.name, column.unit, column.doc));
        }
    }
}

fn boundaries() {
    print("base (dynamic.base)");
    for (name, doc) in [
        ("viscous-spring", "dashpots and springs on the scattered motion; the incident wave enters here"),
        ("viscous", "dashpots (Lysmer & Kuhlemeyer); the incident wave enters here"),
        ("fixed", "no displacement"),
        ("free", "no traction"),
    ] {
        print(&format!("    {name:16} {doc}"));
    }
    print("sides (dynamic.sides.x, dynamic.sides.y)");
    for (name, doc) in [
        ("periodic", "opposite nodes move as one: an endless row of such blocks"),
        ("viscous", "dashpots (Lysmer & Kuhlemeyer)"),
        ("roller", "no displacement normal to the side"),
        ("fixed", "no displacement"),
        ("free", "no traction"),
    ] {
        print(&format!("    {name:16} {doc}"));
    }
}

fn quantities() {
    print("monitors.csv, NAME.quantity");
    for q in MONITOR {
        print(&format!("    {:18} {:6} {}", q.name, q.unit, q.doc));
    }
    print("monitors.csv, pairs FIRST-SECOND.quantity");
    for q in RELATIVE {
        print(&format!("    {:18} {:6} {}", q.name, q.unit, q.doc));
    }
    print("fields/*.vtu, by the word in output.fields");
    for field in Field::ALL {
        let (name, doc) = field.description();
        print(&format!("    {name:18} {doc}"));
    }
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
