//! `tremolite verify`: figures beside exact ones.

use crate::exit::{Code, Failure, Outcome};
use crate::terminal::print;
use tremolite_verify::{Check, Effort};

#[derive(clap::Args)]
pub struct Args {
    /// Problems to run (all by default); see the names in the first column
    names: Vec<String>,
    /// The long ones and the fine meshes as well
    #[arg(long)]
    full: bool,
    #[arg(long)]
    json: bool,
}

pub fn run(args: &Args) -> Outcome {
    let effort = if args.full { Effort::Full } else { Effort::Quick };
    let mut checks: Vec<Check> = Vec::new();
    if !args.json {
        print(&format!(
            "{:22} {:44} {:>14} {:>14} {:>10} {:>6}",
            "problem", "quantity", "value", "reference", "tolerance", "order"
        ));
    }
    let names: Vec<&str> = args.names.iter().map(String::as_str).collect();
    tremolite_verify::run(&names, effort, &mut |check| {
        if !args.json {
            let order = check.order.map_or(String::new(), |o| format!("{o:.2}"));
            let mark = if check.pass { "" } else { "  MISS" };
            print(&format!(
                "{:22} {:44} {:>14.6e} {:>14.6e} {:>10.1e} {order:>6}{mark}",
                check.name, check.quantity, check.value, check.reference, check.tolerance
            ));
        }
        checks.push(check.clone());
    })
    .map_err(Failure::input)?;
    let missed = checks.iter().filter(|c| !c.pass).count();
    if args.json {
        let list: Vec<serde_json::Value> = checks.iter().map(json).collect();
        print(&serde_json::Value::from(list).to_string());
    } else {
        print(&format!("{} of {} figures within tolerance", checks.len() - missed, checks.len()));
    }
    Ok(if missed == 0 { Code::Done } else { Code::Failed })
}

/// A check as JSON; a value that is not a number becomes null.
fn json(check: &Check) -> serde_json::Value {
    serde_json::json!({
        "name": check.name,
        "quantity": check.quantity,
        "value": check.value,
        "reference": check.reference,
        "tolerance": check.tolerance,
        "pass": check.pass,
        "order": check.order,
        "unit": check.unit,
        "note": check.note,
    })
}
