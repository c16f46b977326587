//! Runs beside one another: what their cases say otherwise, their numbers with the differences, their histories overlaid.
//!
//! The first run is that which the others are compared with. All is from the result files; what only some of the runs hold
//! is shown for those, with a dash for the rest.

mod case_text;
mod ended;
mod histories;
mod numbers;
mod page;

use std::path::{Path, PathBuf};

use tremolite_results::replace_file;

use crate::Error;
use crate::language::Language;
use crate::source::Source;

/// One of the runs.
struct Run {
    /// By which the page calls it.
    name: String,
    source: Source,
}

/// Writes the comparison of the result folders `folders`, two or more, into the file `page`.
///
/// Without `language` it is in that which the first run's case asks for. Equal result files give equal bytes.
///
/// # Errors
/// If one of the folders holds no results, or the page cannot be written.
pub fn compare(folders: &[PathBuf], page: &Path, language: Option<Language>) -> Result<(), Error> {
    let names = names(folders);
    let read = |(folder, name): (&PathBuf, String)| -> Result<Run, Error> {
        Ok(Run { name, source: Source::read(folder, language)? })
    };
    let runs: Vec<Run> = folders.iter().zip(names).map(read).collect::<Result<_, _>>()?;
    let language = runs.first().map(|run| run.source.language).unwrap_or_default();
    replace_file(page, page::html(&runs, language)?.as_bytes())?;
    Ok(())
}

/// The folders' own names; where two are the same, as much of the paths as tells them apart.
fn names(folders: &[PathBuf]) -> Vec<String> {
    let tail = |path: &PathBuf, parts: usize| {
        let all: Vec<_> = path.components().map(|c| c.as_os_str().to_string_lossy().into_owned()).collect();
        all[all.len().saturating_sub(parts)..].join("/")
    };
    let longest = folders.iter().map(|path| path.components().count()).max().unwrap_or(1);
    let told = |parts: &usize| {
        let mut names: Vec<String> = folders.iter().map(|path| tail(path, *parts)).collect();
        names.sort();
        names.windows(2).all(|pair| pair[0] != pair[1])
    };
    let parts = (1..=longest).find(told).unwrap_or(longest);
    folders.iter().map(|path| tail(path, parts)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_called_by_as_much_of_their_paths_as_tells_them_apart() {
        let names = |paths: &[&str]| names(&paths.iter().map(PathBuf::from).collect::<Vec<_>>());
        assert_eq!(names(&["results/a", "results/b/"]), ["a", "b"]);
        assert_eq!(names(&["x/soft/out", "x/stiff/out"]), ["soft/out", "stiff/out"]);
        assert_eq!(names(&["out", "out"]), ["out", "out"]);
    }
}
