//! A case from a file, with the files that it names.

use std::path::{Path, PathBuf};

use super::Case;
use crate::change::Change;
use crate::laws::Laws;
use crate::{Diagnostic, Report, Spanned, syntax};

impl Case {
    /// Reads and checks a case file. `laws` are those that it may name, usually
    /// [`MATERIALS`](tremolite_laws::materials::MATERIALS), which brings the interface laws along; see [`Laws`].
    ///
    /// # Errors
    /// All problems of the file at once, files that it names and that are not there included.
    pub fn read<'a>(path: &Path, laws: impl Into<Laws<'a>>) -> Result<Case, Report> {
        Case::read_in(path, path.parent().unwrap_or(Path::new("")), laws)
    }

    /// The same where relative paths start from another folder than the file's: a result folder's case names its files as
    /// they were named beside the original.
    ///
    /// # Errors
    /// As [`Case::read`].
    pub fn read_in<'a>(path: &Path, directory: &Path, laws: impl Into<Laws<'a>>) -> Result<Case, Report> {
        Case::read_changed(path, directory, &[], laws)
    }

    /// The same with other values at some keys, one change after the other.
    ///
    /// # Errors
    /// All problems of the changes and of the changed case at once, as [`Case::read`]; those that come from a change say so.
    pub fn read_changed<'a>(
        path: &Path,
        directory: &Path,
        changes: &[Change],
        laws: impl Into<Laws<'a>>,
    ) -> Result<Case, Report> {
        Case::parse_in(path, directory, &Case::text_of(path)?, changes, laws)?.with_files()
    }

    /// The text of a case file, unchecked.
    ///
    /// # Errors
    /// Why it cannot be read.
    pub fn text_of(path: &Path) -> Result<String, Report> {
        syntax::read(path, "case file")
    }

    /// Checks the text of a case whose relative paths start from `directory`, with other values at some keys. Touches no files.
    ///
    /// # Errors
    /// As [`Case::parse_changed`].
    pub fn parse_in<'a>(
        path: &Path,
        directory: &Path,
        source: &str,
        changes: &[Change],
        laws: impl Into<Laws<'a>>,
    ) -> Result<Case, Report> {
        let case = Case::parse_changed(path, source, changes, laws)?;
        Ok(Case { directory: directory.to_owned(), ..case })
    }

    /// This case with other values at some keys, in addition to the changes that it was read with. The file is not read again.
    ///
    /// # Errors
    /// As [`Case::read_changed`].
    pub fn with<'a>(&self, changes: &[Change], laws: impl Into<Laws<'a>>) -> Result<Case, Report> {
        self.parse_with(changes, laws)?.with_files()
    }

    /// As [`Case::with`], without a look at the files that it names.
    ///
    /// # Errors
    /// As [`Case::parse_changed`].
    pub fn parse_with<'a>(&self, changes: &[Change], laws: impl Into<Laws<'a>>) -> Result<Case, Report> {
        let changes = [&self.changed.changes, changes].concat();
        Case::parse_in(&self.path, &self.directory, &self.changed.original, &changes, laws)
    }

    /// The case, if all files that it names are there.
    fn with_files(self) -> Result<Case, Report> {
        let missing = self.missing_files(|_| false);
        if missing.is_empty() { Ok(self) } else { Err(self.report(missing)) }
    }

    /// The files that it names and that are not there, but for those that are `held` elsewhere, each at its place; `held` is asked
    /// for the name as it is written.
    pub fn missing_files(&self, held: impl Fn(&Path) -> bool) -> Vec<Diagnostic> {
        let missing = |f: &&Spanned<PathBuf>| !held(&f.value) && !self.resolve(&f.value).is_file();
        let missing = self.files().into_iter().filter(missing);
        let problem = |f: &Spanned<PathBuf>| {
            let looked = self.resolve(&f.value);
            let written = self.source.get(f.span.clone()).unwrap_or("").trim_matches(['"', '\'']);
            let remedy = syntax::forward_slashes(written).unwrap_or_else(|| {
                format!("paths start from the folder of the case; looked for {}", looked.display())
            });
            // A path may hold escapes that were not meant, `\t` for one.
            let name = f.value.display().to_string().escape_debug().to_string();
            Diagnostic::at(f, format!("there is no file {name}"), remedy)
        };
        missing.map(problem).collect()
    }
}
