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
            let tolerance = check.tolerance.map_or_else(|| "-".to_owned(), |t| format!("{t:.1e}"));
            let mark = match (check.pass, check.tolerance) {
                (true, Some(_)) => String::new(),
                (true, None) => {
                    format!("  for information: {:+.1} %", 100.0 * (check.value / check.reference - 1.0))
                }
                (false, _) => "  MISS".to_owned(),
            };
            print(&format!(
                "{:22} {:44} {:>14.6e} {:>14.6e} {tolerance:>10} {order:>6}{mark}",
                check.name, check.quantity, check.value, check.reference
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
        let beside = checks.iter().filter(|c| c.pass && c.tolerance.is_none()).count();
        let held = checks.len() - beside;
        let more = if beside > 0 { format!(", {beside} more for information") } else { String::new() };
        print(&format!("{} of {held} figures within tolerance{more}", held - missed));
    }
    Ok(if missed == 0 { Code::Done } else { Code::Failed })
}

/// A check as JSON; a value that is not a number becomes null, and so does the tolerance of one for information.
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
