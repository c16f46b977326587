//! A case as texts for others: on one line, and to be run from anywhere.

use std::path::{Path, PathBuf};

use toml::de::DeTable;

use super::Case;
use crate::{Spanned, inline, key_path, syntax};

impl Case {
    /// The case in one line without comments and without these of its tables: equal where two cases say the same in the same words.
    pub fn bare(&self, without: &[&str]) -> String {
        // The text has been parsed before.
        let parsed = syntax::parse(&self.source);
        parsed.map_or_else(
            |_| String::new(),
            |document| inline::table(&self.source, document.get_ref(), without),
        )
    }

    /// The keys of a table at the top of the case, each with its value on one line; none where there is no such table.
    pub fn entries(&self, table: &str) -> Vec<(String, String)> {
        let parsed: Option<toml::Spanned<DeTable<'_>>> = syntax::parse(&self.source).ok();
        let table = parsed.as_ref().and_then(|document| document.get_ref().get(table)?.get_ref().as_table());
        table.map_or_else(Vec::new, |table| inline::entries(&self.source, table))
    }

    /// The text of the case with the files that it names by absolute paths, to be run from any folder.
    pub fn placed(&self) -> String {
        let mut files: Vec<&Spanned<PathBuf>> = self.files();
        files.sort_by_key(|file| file.span.start);
        let mut text = self.source.clone();
        // From the back, so that places before stay.
        for file in files.into_iter().rev() {
            let place = absolute(&self.resolve(&file.value));
            text.replace_range(file.span.clone(), &key_path::quoted(&place.to_string_lossy()));
        }
        text
    }
}

fn absolute(path: &Path) -> PathBuf {
    let absolute = || std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    path.canonicalize().unwrap_or_else(|_| absolute())
}
