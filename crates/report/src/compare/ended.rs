//! How each run ended. What is said of the end of a run that is not done is said of its last row.

use tremolite_results::Status;

use super::Run;
use crate::chapter::text_table::Cell;
use crate::language::{Language, say};
use crate::quantities::scale::{moment, trimmed};
use crate::source::Source;

/// How a run ended, in words, and at which of how many seconds where it is not done.
pub fn status(run: &Run, language: Language) -> Cell {
    let words = match run.source.summary.as_ref().map(|summary| summary.conclusion.status) {
        Ok(Status::Done) => return Cell::number(say!(language, "done")),
        Ok(Status::Stopped) => say!(language, "stopped"),
        Ok(Status::Failed) => say!(language, "failed"),
        Err(_) => say!(language, "no summary"),
    };
    Cell::number(words).with(reached(&run.source, language))
}

/// How far a run that is not done came.
fn reached(source: &Source, language: Language) -> String {
    let last = |table: &tremolite_results::Table| table.column("time")?.last().copied();
    let Some(time) = source.monitors.as_ref().ok().and_then(last) else { return String::new() };
    // The motion is written in full before the first step.
    let whole = source.motion.as_ref().and_then(|table| last(table.as_ref().ok()?));
    match whole.filter(|whole| *whole > time) {
        Some(whole) => {
            let text = |t: f64| trimmed(&moment(t, whole));
            say!(language, "at {time} of {whole}\u{a0}s", time = text(time), whole = text(whole))
        }
        None => say!(language, "at {time}\u{a0}s", time = trimmed(&moment(time, time))),
    }
}

/// What to know of the runs that are not done.
pub fn warning(runs: &[Run], language: Language) -> Option<String> {
    let done = |run: &&Run| run.source.summary.as_ref().is_ok_and(|s| s.conclusion.status == Status::Done);
    let names: Vec<&str> = runs.iter().filter(|run| !done(run)).map(|run| run.name.as_str()).collect();
    (!names.is_empty()).then(|| {
        say!(
            language,
            "Not run to the end: {runs}. “At the end” means the last row that such a run wrote, and its largest values are \
             those up to there.",
            runs = names.join(", ")
        )
    })
}
