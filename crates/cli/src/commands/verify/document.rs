//! Verification as a document: every problem with its formula, figures, plot, tolerances and their reasons, source.

use super::record::{Figure, Problem, Record};
use super::words::{cell, linked, number, of_text, share};
use std::fmt::Write;
use tremolite_report::convergence::{self, Levels};
use tremolite_verify::{PROBLEMS, Verification, text};

/// Tables that are longer are folded.
const SHORT: usize = 12;

/// The page, in Markdown; plots lie in `verification/` beside it.
pub fn page(record: &Record) -> String {
    let mut out = String::from(BEGINNING);
    out.push_str(&all_in_all(record));
    out.push_str("\n| problem | what is verified | figures | closest to its tolerance | run |\n|---|---|---|---|---|\n");
    for problem in PROBLEMS {
        let known = record.problem(problem.name);
        let [figures, closest, run] =
            known.map_or_else(|| ["–".into(), "–".into(), "**not run**".into()], row);
        let (name, summary) = (problem.name, cell(&of_text(problem.summary)));
        let _ = writeln!(out, "| [{name}](#{name}) | {summary} | {figures} | {closest} | {run} |");
    }
    for problem in PROBLEMS {
        out.push_str(&section(problem, record.problem(problem.name)));
    }
    out
}

/// The plots with the names of their files.
pub fn plots(record: &Record) -> Vec<(String, String)> {
    let known = PROBLEMS.iter().filter_map(|problem| record.problem(problem.name));
    known.filter_map(|problem| Some((format!("{}.svg", problem.name), plot(problem)?))).collect()
}

const BEGINNING: &str = "\
# Verification

Every method is verified by problems with exact or published solutions, which run through the same engine as cases. Here is what each compares, by which formula,
with which tolerance and for what reason, and what came of it when it was run last.

The page is written by the program: by `tremolite verify --full --write docs` after a run, or by `tremolite verify --recorded --write docs` from the figures on record,
[figures.json](verification/figures.json). `cargo test` fails where the page is not what the record gives, where its list of problems is not the program's, and where a figure
on record is beyond its tolerance. `cargo test` and `tremolite verify` run the problems; either fails on a figure beyond its tolerance, of an error or of an
order of convergence. `tremolite verify --against docs/verification/figures.json` fails as well where any order is below that on record of a run of the same kind, plain or full.

*Tolerance* is the largest difference from the reference that passes, in the unit of the value; figures without one are for information. *Share* is the difference over the
tolerance. *Order* is that of convergence between the two finest meshes or steps that were run. Symbols are those of [NOTATION.md](../NOTATION.md), sources those of
[references.bib](../references.bib). *Plain* runs are those of `tremolite verify`; *full* ones have finer meshes and series as well, and are shown where the record has both. Seconds are
of the run on record, whatever else its machine did.

";

fn all_in_all(record: &Record) -> String {
    let known: Vec<&Problem> = PROBLEMS.iter().filter_map(|problem| record.problem(problem.name)).collect();
    let figures = || known.iter().flat_map(|problem| &problem.figures);
    let held = figures().filter(|figure| figure.tolerance.is_some()).count();
    let missed = figures().filter(|figure| !figure.pass).count();
    let orders = figures().filter(|figure| figure.order.is_some()).count();
    let full = known.iter().filter(|problem| problem.full).count();
    let seconds: f64 = known.iter().map(|problem| problem.seconds).sum();
    let mut out = format!(
        "**{} problems, {} of them run, {full} in full: {held} figures held to a tolerance, {} beyond it, {} more for information; {orders} orders of convergence; {:.0} s.**\n",
        PROBLEMS.len(),
        known.len(),
        if missed == 0 { "none".to_owned() } else { missed.to_string() },
        figures().count() - held,
        seconds
    );
    if known.len() < PROBLEMS.len() {
        let left: Vec<String> = PROBLEMS
            .iter()
            .filter(|problem| record.problem(problem.name).is_none())
            .map(|problem| format!("[{0}](#{0})", problem.name))
            .collect();
        let _ = writeln!(out, "\nNot run: {}.", left.join(", "));
    }
    out
}

/// Figures, the closest to its tolerance, and the run, for the list.
fn row(problem: &Problem) -> [String; 3] {
    let closest = closest(problem).and_then(Figure::share).map_or_else(|| "–".into(), share);
    let run = format!("{}, {:.1} s", kind(problem), problem.seconds);
    [problem.figures.len().to_string(), closest, run]
}

fn kind(problem: &Problem) -> &'static str {
    if problem.full { "full" } else { "plain" }
}

fn closest(problem: &Problem) -> Option<&Figure> {
    let held = problem.figures.iter().filter(|figure| figure.share().is_some());
    held.max_by(|a, b| a.share().partial_cmp(&b.share()).unwrap_or(std::cmp::Ordering::Equal))
}

fn section(problem: &Verification, known: Option<&Problem>) -> String {
    let mut out = format!("\n## {}\n\n{}\n\n", problem.name, of_text(&text(problem)));
    let _ = writeln!(out, "**Source**: {}.\n", linked(&of_text(problem.source)));
    let Some(known) = known else {
        out.push_str("**Not run**: no figures are on record.\n");
        return out;
    };
    let beyond = known.figures.iter().filter(|figure| !figure.pass).count();
    let told = known.figures.iter().filter(|figure| figure.tolerance.is_none()).count();
    let _ = write!(out, "**Figures** ({} run, {:.1} s): {}", kind(known), known.seconds, known.figures.len());
    if told > 0 {
        let _ = write!(out, ", {told} of them for information");
    }
    let _ = write!(
        out,
        "; {}.",
        if beyond == 0 {
            "none is beyond its tolerance".to_owned()
        } else {
            format!("**{beyond} beyond the tolerance**")
        }
    );
    if let Some((figure, off)) =
        closest(known).and_then(|figure| Some((figure, figure.share()?))).filter(|(_, off)| *off > 0.0)
    {
        let _ =
            write!(out, " The closest to its own, at {} of it: {}.", share(off), of_text(&figure.quantity));
    }
    out.push_str("\n\n");
    if plot(known).is_some() {
        let _ = writeln!(
            out,
            "![Errors of {0} over the size of elements or steps](verification/{0}.svg)\n",
            problem.name
        );
    }
    out.push_str(&table(known));
    out
}

/// All figures, with the reasons of tolerances below.
fn table(problem: &Problem) -> String {
    let mut reasons: Vec<&str> = Vec::new();
    let mut rows = String::from(
        "| quantity | value | reference | tolerance | share | order | reason |\n|---|---|---|---|---|---|---|\n",
    );
    for figure in &problem.figures {
        let reason = match reasons.iter().position(|known| *known == figure.note) {
            Some(at) => at,
            None => {
                reasons.push(&figure.note);
                reasons.len() - 1
            }
        };
        let unit = if figure.unit == "1" { String::new() } else { format!(" {}", figure.unit) };
        let value = figure.value.map_or_else(|| "no number".into(), |value| number(value) + &unit);
        let value = if figure.pass { value } else { format!("**{value}, beyond**") };
        let order = figure.order.map_or_else(|| "–".into(), |order| format!("{order:.2}"));
        let _ = writeln!(
            rows,
            "| {} | {value} | {}{unit} | {} | {} | {order} | {} |",
            cell(&of_text(&figure.quantity)),
            number(figure.reference),
            figure.tolerance.map_or_else(|| "–".to_owned(), number),
            figure.share().map_or_else(|| "–".to_owned(), share),
            reason + 1
        );
    }
    if !reasons.is_empty() {
        rows.push_str("\nReasons:\n\n");
    }
    for (k, reason) in reasons.iter().enumerate() {
        let said = if reason.is_empty() { "for information".to_owned() } else { of_text(reason) };
        let _ = writeln!(rows, "{}. {said}", k + 1);
    }
    if problem.figures.len() <= SHORT {
        return rows;
    }
    format!("<details><summary>All {} figures</summary>\n\n{rows}\n</details>\n", problem.figures.len())
}

/// Errors over sizes, where there are levels; beside them the orders that are asked for.
fn plot(problem: &Problem) -> Option<String> {
    let mut lines: Vec<Levels> = Vec::new();
    let mut orders: Vec<f64> = Vec::new();
    for figure in problem.figures.iter().filter(|figure| figure.levels.len() > 1) {
        if !lines.iter().any(|line| line.errors == figure.levels) {
            lines.push(Levels { name: figure.quantity.clone(), errors: figure.levels.clone() });
        }
        // A figure that is the order itself, and judged.
        let is_order = figure.value.is_some() && figure.value == figure.order && figure.tolerance.is_some();
        if is_order && !orders.contains(&figure.reference) {
            orders.push(figure.reference);
        }
    }
    convergence::draw(&problem.name, &lines, &orders)
}
