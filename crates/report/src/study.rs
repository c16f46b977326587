//! The page of a study, from `study.json` alone.

mod fragility;
mod page;
mod paper;
mod rising;
mod scatter;
mod tornado;

use std::fs;
use std::path::{Path, PathBuf};

use tremolite_results::replace_file;
use tremolite_results::study::Study;

use crate::{Error, Language};

/// A drawing with its name, `NAME.svg`, and what stands below it.
struct Figure {
    file: String,
    svg: String,
    caption: String,
}

/// Writes `study.html` and `figures/*.svg` into the folder of a study that holds a `study.json`, in `language` if given, else in that which the
/// study asks for; returns the page's path.
///
/// Equal files give equal bytes.
///
/// # Errors
/// If there is no such file, or the folder cannot be written to.
pub fn study(out: &Path, language: Option<Language>) -> Result<PathBuf, Error> {
    let study = Study::read(&out.join("study.json"))?;
    let language = language.unwrap_or_else(|| study.language.parse().unwrap_or_default());
    let folder = out.join("figures");
    fs::create_dir_all(&folder).map_err(|source| Error::Figures { path: folder.clone(), source })?;
    let parts = page::Parts {
        fragility: fragility::figures(&study, language),
        rising: rising::figures(&study, language),
        tornado: tornado::figures(&study, language),
        scatter: scatter::figures(&study, language),
    };
    for figure in parts.all() {
        replace_file(&folder.join(&figure.file), figure.svg.as_bytes())?;
    }
    let path = out.join("study.html");
    replace_file(&path, page::html(&study, language, &parts)?.as_bytes())?;
    Ok(path)
}

#[cfg(test)]
mod tests;
