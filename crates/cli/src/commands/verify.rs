//! `tremolite verify`: figures beside exact ones.

use crate::exit::{Code, Failure, Outcome};
use crate::terminal::print;
use tremolite_verify::{Check, Effort, Verification, Verified};

#[derive(clap::Args)]
pub struct Args {
    /// Problems to run (all by default); see the names in the first column
    names: Vec<String>,
    /// Finer meshes, series of parameters and long runs as well
    #[arg(long)]
    full: bool,
    /// Only the problems that `cargo test` leaves out because they take more than 2 s
    #[arg(long, conflicts_with_all = ["names", "full"])]
    beyond_tests: bool,
    /// On up to four levels of steps, in bands over each mesh that allows them: all figures must hold with them as well
    #[arg(long)]
    levels: bool,
    /// One list of all figures, each with the seconds of its problem
    #[arg(long)]
    json: bool,
}

pub fn run(args: &Args) -> Outcome {
    let effort = if args.full { Effort::Full } else { Effort::Verify };
    if args.levels {
        tremolite_verify::force_levels();
    }
    let names: Vec<&str> = args.names.iter().map(String::as_str).collect();
    let mut problems = tremolite_verify::select(&names).map_err(Failure::input)?;
    problems.retain(|problem| !args.beyond_tests || problem.from > Effort::Test);
    if !args.json {
        print(&format!(
            "{:22} {:44} {:>14} {:>14} {:>10} {:>6} {:>8}",
            "problem", "quantity", "value", "reference", "tolerance", "order", "seconds"
        ));
    }
    let mut all: Vec<(&Verification, Verified)> = Vec::new();
    for problem in problems {
        let verified = problem.verify(effort);
        if !args.json {
            for (k, check) in verified.checks.iter().enumerate() {
                // Beside a problem's first figure, for all of them.
                print(&row(check, (k == 0).then_some(verified.seconds)));
            }
        }
        all.push((problem, verified));
    }
    let missed: usize = all.iter().map(|(_, verified)| verified.missed()).sum();
    if args.json {
        let figures = all.iter().flat_map(|(_, v)| v.checks.iter().map(|check| json(check, v.seconds)));
        print(&serde_json::Value::from_iter(figures).to_string());
    } else {
        print(&conclusion(&all, missed));
    }
    Ok(if missed == 0 { Code::Done } else { Code::Failed })
}

fn row(check: &Check, seconds: Option<f64>) -> String {
    let order = check.order.map_or(String::new(), |o| format!("{o:.2}"));
    let seconds = seconds.map_or(String::new(), |s| format!("{s:.2}"));
    let tolerance = check.tolerance.map_or_else(|| "-".to_owned(), |t| format!("{t:.1e}"));
    let remark = check.remark().map_or_else(String::new, |remark| format!("  {remark}"));
    let row = format!(
        "{:22} {:44} {:>14.6e} {:>14.6e} {tolerance:>10} {order:>6} {seconds:>8}{remark}",
        check.name, check.quantity, check.value, check.reference
    );
    row.trim_end().to_owned()
}

fn conclusion(all: &[(&Verification, Verified)], missed: usize) -> String {
    let checks = || all.iter().flat_map(|(_, verified)| &verified.checks);
    let beside = checks().filter(|c| c.pass && c.tolerance.is_none()).count();
    let held = checks().count() - beside;
    let more = if beside > 0 { format!(", {beside} more for information") } else { String::new() };
    let seconds: f64 = all.iter().map(|(_, verified)| verified.seconds).sum();
    let count = all.len();
    let problems = if count == 1 { "1 problem".to_owned() } else { format!("{count} problems") };
    format!("{} of {held} figures within tolerance{more}; {problems} in {seconds:.1} s", held - missed)
}

/// A check as JSON with the seconds of its problem; a value that is not a number becomes null, and so does the tolerance
/// of one for information.
fn json(check: &Check, seconds: f64) -> serde_json::Value {
    serde_json::json!({
        "id": check.id(),
        "name": check.name,
        "quantity": check.quantity,
        "value": check.value,
        "reference": check.reference,
        "tolerance": check.tolerance,
        "pass": check.pass,
        "order": check.order,
        "unit": check.unit,
        "note": check.note,
        "problem_seconds": seconds,
    })
}
