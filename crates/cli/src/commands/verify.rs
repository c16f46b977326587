//! `tremolite verify`: figures beside exact ones, and the document of them.

mod document;
mod record;
mod words;

use crate::exit::{Code, Failure, Outcome};
use crate::terminal::print;
use record::Record;
use std::path::{Path, PathBuf};
use tremolite_results::replace_file;
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
    /// Write DIR/verification.md, with plots and DIR/verification/figures.json; figures of problems that do not run now stay as they are on record there
    #[arg(long, value_name = "DIR", conflicts_with = "levels")]
    write: Option<PathBuf>,
    /// Run nothing: write the document from the figures on record
    #[arg(long, requires = "write", conflicts_with_all = ["names", "full", "beyond_tests", "json", "against"])]
    recorded: bool,
    /// Fail as well where an order of convergence is below that in this record (docs/verification/figures.json)
    #[arg(long, value_name = "FILE", conflicts_with = "levels")]
    against: Option<PathBuf>,
}

pub fn run(args: &Args) -> Outcome {
    let effort = if args.full { Effort::Full } else { Effort::Verify };
    if args.levels {
        tremolite_verify::force_levels();
    }
    // Read before anything runs, which takes minutes.
    let folder = args.write.as_deref();
    let mut record = folder.map_or(Ok(Record::default()), |folder| Record::read(&figures(folder)))?;
    if let (true, Some(folder)) = (args.recorded, folder) {
        return write(&record, folder);
    }
    let known = match &args.against {
        Some(file) if !file.exists() => {
            return Err(Failure::input(format!("{}: there is no such file", file.display())));
        }
        Some(file) => Some(Record::read(file)?),
        None => None,
    };
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
    for (problem, verified) in &all {
        record.take(problem.name, args.full, verified);
    }
    if let Some(folder) = folder {
        std::fs::create_dir_all(plots(folder))
            .map_err(|e| Failure::failed(format!("{}: {e}", folder.display())))?;
        record.write(&figures(folder))?;
        write(&record, folder)?;
    }
    let lost = known.map_or(0, |known| orders(&known, args.full, &all));
    Ok(if missed + lost == 0 { Code::Done } else { Code::Failed })
}

/// Where plots and figures lie beside the page.
fn plots(folder: &Path) -> PathBuf {
    folder.join("verification")
}

fn figures(folder: &Path) -> PathBuf {
    plots(folder).join("figures.json")
}

/// Writes page and plots; fails where a figure on record is beyond its tolerance.
fn write(record: &Record, folder: &Path) -> Outcome {
    let put = |path: PathBuf, text: &str| replace_file(&path, text.as_bytes()).map_err(Failure::failed);
    put(folder.join("verification.md"), &document::page(record))?;
    for (name, svg) in document::plots(record) {
        put(plots(folder).join(name), &svg)?;
    }
    let mut beyond = 0;
    for (name, figure) in
        record.problems.iter().flat_map(|p| p.figures.iter().map(move |figure| (&p.name, figure)))
    {
        if !figure.pass {
            eprintln!("{name}: {}: beyond its tolerance on record", figure.quantity);
            beyond += 1;
        }
    }
    Ok(if beyond == 0 { Code::Done } else { Code::Failed })
}

/// Says which orders are below those on record, and how many could be compared; how many were lost.
fn orders(known: &Record, full: bool, all: &[(&Verification, Verified)]) -> usize {
    let (mut count, mut lost) = (0, 0);
    for (problem, verified) in all {
        let (compared, said) = known.orders(problem.name, full, verified);
        said.iter().for_each(|line| eprintln!("{line}"));
        (count, lost) = (count + compared, lost + said.len());
    }
    eprintln!("{count} orders of convergence beside those on record, {lost} lost");
    lost
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
