//! Measures of a study held against its case before the first run: tables, columns and paths that no run of it writes.

use tremolite_case::study::{MeasureOf, StudyFile};
use tremolite_case::{Case, Diagnostic, Spanned, nearest};
use tremolite_results::{OWN_TABLES, TABLES, check_summary_path};

/// Keys shown at most where none is near what is written.
const SHOWN: usize = 30;

/// Measures that no run of the case can hold, at their places in the study. Names of groups come from the mesh and are not looked at.
pub fn check(study: &StudyFile, case: &Case) -> Vec<Diagnostic> {
    let mut problems = Vec::new();
    for measure in &study.measures {
        let name = &measure.name.value;
        match &measure.of {
            MeasureOf::Summary { path, over } => {
                for path in std::iter::once(path).chain(over) {
                    problems.extend(summary(name, path, case));
                }
            }
            MeasureOf::Column { table, column, .. } => problems.extend(of_table(name, table, column, case)),
            MeasureOf::Checks(_) => {}
        }
    }
    problems
}

fn summary(measure: &str, path: &Spanned<String>, case: &Case) -> Option<Diagnostic> {
    if let Err((why, known)) = check_summary_path(path) {
        // The part that leads nowhere is the one that is nearly one of the keys there.
        let parts = || path.split(['.', '[', ']', '"', '\'']).filter(|part| !part.is_empty());
        let wrong =
            parts().find(|part| !known.contains(part) && nearest(part, known.iter().copied()).is_some());
        let last = wrong.or_else(|| parts().next_back()).unwrap_or_default();
        return Some(Diagnostic::at(
            path,
            format!("measure '{measure}': summary.json has no number `{}`: {why}", path.value),
            remedy(path, last, &known),
        ));
    }
    let below = path.strip_prefix("monitors.").or_else(|| path.strip_prefix("relative."))?;
    let below = below.trim_start_matches(['"', '\'']);
    let names = monitors(case);
    let known = names.iter().any(|name| below.strip_prefix(name.as_str()).is_some_and(ends));
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    (!known).then(|| {
        Diagnostic::at(
            path,
            format!("measure '{measure}': the case has no monitor of `{}`", path.value),
            remedy(path, below.split(['.', '"', '\'']).next().unwrap_or_default(), &names),
        )
    })
}

/// Whether a name ends in front of this rest.
fn ends(rest: &str) -> bool {
    rest.is_empty() || rest.starts_with(['.', '"', '\'', '['])
}

fn of_table(
    measure: &str,
    table: &Spanned<String>,
    column: &Spanned<String>,
    case: &Case,
) -> Option<Diagnostic> {
    if !TABLES.contains(&table.as_str()) {
        // A user's program adds tables of its own.
        return (!table.starts_with(OWN_TABLES)).then(|| {
            Diagnostic::at(
                table,
                format!("measure '{measure}': no run writes a table `{}`", table.value),
                remedy(table, table, &TABLES),
            )
        });
    }
    if table.value != "monitors.csv" || column.value == "time" {
        return None;
    }
    let names = monitors(case);
    let known =
        names.iter().any(|name| column.strip_prefix(name.as_str()).is_some_and(|rest| rest.starts_with('.')));
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let wanted = column.split('.').next().unwrap_or_default();
    (!known).then(|| {
        Diagnostic::at(
            column,
            format!("measure '{measure}': no monitor of the case has the column `{}`", column.value),
            remedy(column, wanted, &names),
        )
    })
}

/// The first parts of the columns of monitors.csv: monitors, and pairs of them.
fn monitors(case: &Case) -> Vec<String> {
    let name = |monitor: usize| case.monitors[monitor].name.value.as_str();
    let relatives = case.relatives.iter().map(|r| format!("{}-{}", name(r.between[0]), name(r.between[1])));
    case.monitors.iter().map(|monitor| monitor.name.value.clone()).chain(relatives).collect()
}

/// What may have been meant.
fn remedy(written: &str, wanted: &str, known: &[&str]) -> String {
    match nearest(wanted, known.iter().copied()) {
        Some(meant) => format!("write `{}`", written.replacen(wanted, meant, 1)),
        None if known.is_empty() => "see docs/studies.md for the paths".to_owned(),
        None => {
            let shown: Vec<&str> = known.iter().copied().take(SHOWN).collect();
            format!("write one of {}{}", shown.join(", "), if known.len() > shown.len() { ", …" } else { "" })
        }
    }
}
