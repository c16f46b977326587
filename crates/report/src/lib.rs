//! The report of a run: figures and one self-contained HTML page, from the result files alone.
//!
//! [`write()`] reads a result folder and leaves `figures/*.svg` and `report.html` in it. The page needs no
//! network and no scripts, prints on A4, and follows the reader's choice of a light or dark screen. What a file or
//! column does not give is left out with a sentence that says why.
//!
//! [`loops`] draws what comes of a law driven along a path, [`processing`] a record before and after its processing, [`convergence`]
//! errors over sizes; all from plain columns.

#![forbid(unsafe_code)]

mod bolts;
mod chapter;
pub mod chinese;
mod compare;
mod damage;
mod developed;
mod drawing;
mod energy;
mod facts;
mod flow;
mod free_field;
mod histories;
mod input;
mod interfaces;
mod language;
mod page;
mod quantities;
mod script;
mod section_forces;
mod section_maps;
mod sheets;
mod source;
mod spectra;
mod stages;
mod study;
mod verdict;
mod view;

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use indexmap::IndexMap;
use tremolite_results::study::StudyLimit;
use tremolite_results::{ResultFolder, Summary, replace_file};

pub use crate::compare::compare;
pub use crate::drawing::convergence;
pub use crate::drawing::loops;
pub use crate::drawing::state_strips::Strip;
pub use crate::input::processing;
pub use crate::language::Language;
use crate::page::contents::Content;
use crate::script::blocks::Blocks;
use crate::sheets::limits::LimitRow;
use crate::source::Source;
pub use crate::study::study;

/// Why no report could be written.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The folder holds no results, or the page could not be written into it.
    #[error(transparent)]
    Results(#[from] tremolite_results::Error),
    /// The folder for the figures could not be made.
    #[error("{}: cannot make this folder: {source}", path.display())]
    Figures {
        /// The folder.
        path: PathBuf,
        /// Why not.
        source: io::Error,
    },
    /// The page's template and its data disagree: a fault of this program, not of the results.
    #[error("the page could not be set: {0}")]
    Template(#[from] minijinja::Error),
}

/// Writes `figures/*.svg` and `report.html` into the result folder `dir`; returns the page's path.
///
/// Equal result files give equal bytes. A summary or table that is missing or damaged costs its part of the
/// page, which then says so; it is no error.
///
/// # Errors
/// If `dir` holds no results or cannot be written to.
pub fn write(dir: &Path) -> Result<PathBuf, Error> {
    set(&Source::read(dir, None)?)
}

/// As [`write()`], and the page's first two lines, in English: state and reliance, with their reasons.
///
/// # Errors
/// As of [`write()`].
pub fn write_answering(dir: &Path) -> Result<(PathBuf, [String; 2]), Error> {
    let mut source = Source::read(dir, None)?;
    let page = set(&source)?;
    source.language = Language::English;
    let verdict::Verdict { state, reliance, .. } = verdict::verdict(&source);
    Ok((page, [state.line(), reliance.line()]))
}

/// As [`write()`], in another language than the case asks for.
///
/// # Errors
/// As of [`write()`].
pub fn write_in(dir: &Path, language: Language) -> Result<PathBuf, Error> {
    set(&Source::read(dir, Some(language))?)
}

/// As [`write()`], in `language` if given, held to other limits of acceptance than those of the case: `displacement` (m), `crack_width`
/// (m), `damage` (share of a lining's volume), `utilisation` (1).
///
/// # Errors
/// As of [`write()`].
pub fn write_held(
    dir: &Path,
    language: Option<Language>,
    limits: impl IntoIterator<Item = (String, f64)>,
) -> Result<PathBuf, Error> {
    let mut source = Source::read(dir, language)?;
    if let Ok(summary) = &mut source.summary {
        summary.case.report.limits = limits.into_iter().collect();
    }
    set(&source)
}

/// The limits of acceptance of the case whose results are in `dir`, by their keys, beside what was found, as the page's first sheet has them; none
/// where it gives none.
///
/// # Errors
/// If `dir` holds no results, or no summary of them.
pub fn limits(dir: &Path) -> Result<IndexMap<String, StudyLimit>, Error> {
    // Most runs have none, and need not be read.
    if Summary::read(&ResultFolder::open_existing(dir)?.summary())?.case.report.limits.is_empty() {
        return Ok(IndexMap::new());
    }
    let source = Source::read(dir, Some(Language::English))?;
    Ok(sheets::limits::rows(&source, &source.facts()).into_iter().map(LimitRow::told).collect())
}

fn set(source: &Source) -> Result<PathBuf, Error> {
    let mut blocks = Blocks::default();
    let sections = page::contents::sections(source, view::is_wanted(source));
    let folder = source.folder.figures();
    fs::create_dir_all(&folder).map_err(|source| Error::Figures { path: folder.clone(), source })?;
    for placed in &sections {
        let Content::Section(section) = &placed.content else { continue };
        for figure in section.figures() {
            replace_file(&folder.join(&figure.file), figure.svg.as_bytes())?;
        }
    }
    let path = source.folder.report();
    let figures = sections.iter().flat_map(|placed| match &placed.content {
        Content::Section(section) => section.figures(),
        _ => Vec::new(),
    });
    let of_figures = figures.filter_map(|figure| Some((figure.file.as_str(), figure.curves.as_ref()?)));
    let words = page::html(source, &sections, 0, String::new())?.len();
    let room = page::size::limit(source.facts().computed.model.elements as usize)
        .saturating_sub(words + page::size::VIEW);
    let (curves, left) = script::curves::embedded(of_figures, &mut blocks, room);
    // The view is the part that can be made smaller, so it comes last.
    let rest = words + curves.len() + blocks.elements().len();
    let view = view::embedded(source, &mut blocks, rest);
    let data = curves + &view + &blocks.elements();
    replace_file(&path, page::html(source, &sections, left, data)?.as_bytes())?;
    Ok(path)
}
