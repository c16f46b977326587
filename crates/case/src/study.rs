//! The study file: one page of TOML that says which cases are run beside one another, and what is made of their results.
//!
//! Its tables are checked as those of a case are, by tables of keys; keys of the case that it varies are checked by the case itself
//! once a plan is made, since only the case knows their units and limits.

mod check;
mod entries;
mod quantity;
mod read;
mod tables;
mod variation;
mod words;

pub use entries::{
    Correlation, Fragility, Ida, Levels, Measure, MeasureOf, RecordEntry, Row, RunWish, Sample, Scale,
};
pub use quantity::{Quantity, rounded};
pub use variation::{Bounds, Distribution, Setting, Variation, Varied};
pub use words::{Checks, Design, FailedRun, Keep, SampleKind, Take};

use std::path::{Path, PathBuf};

use crate::check::{Checker, UNITS, bare_si};
use crate::fields::Fields;
use crate::laws::Laws;
use crate::{Diagnostic, Language, Report, Spanned, syntax};
use tables::STUDY;

/// A study, read and checked as far as its file goes.
#[derive(Clone, Debug, PartialEq)]
pub struct StudyFile {
    /// The file as the user named it.
    pub path: PathBuf,
    /// Its text.
    pub source: String,
    /// What the study is about.
    pub title: Spanned<String>,
    /// The case, as written; relative to the study's folder.
    pub case: Spanned<PathBuf>,
    /// The page's language; that of the case where it is left out.
    pub language: Option<Language>,
    /// Keys that all runs have other than the case.
    pub set: Vec<Setting>,
    /// Keys that differ from run to run.
    pub vary: Vec<Varied>,
    /// Pairs of varied keys whose ranks go together.
    pub correlations: Vec<Correlation>,
    /// Runs with a name each, written one by one.
    pub rows: Vec<Row>,
    /// How samples are chosen; nothing where nothing is varied.
    pub sample: Option<Sample>,
    /// Records in place of the case's.
    pub records: Vec<RecordEntry>,
    /// How strong they are made.
    pub scale: Option<Scale>,
    /// Columns of the table of results.
    pub measures: Vec<Measure>,
    /// Fragility curves.
    pub fragilities: Vec<Fragility>,
    /// How it is run.
    pub run: RunWish,
}

impl StudyFile {
    /// Reads and checks a study file.
    ///
    /// # Errors
    /// All problems of the file at once.
    pub fn read(path: &Path) -> Result<StudyFile, Report> {
        StudyFile::parse(path, &syntax::read(path, "study file")?)
    }

    /// Checks the text of a study file. Touches no files; `path` names it in messages.
    ///
    /// # Errors
    /// All problems of the text at once: of its syntax, or else of its content.
    pub fn parse(path: &Path, source: &str) -> Result<StudyFile, Report> {
        let report = |problems| Report::new(path, source, problems);
        let document = syntax::parse(source).map_err(report)?;
        let written = document.get_ref();
        let mut problems = Vec::new();
        // Bare numbers of the study become those of its cases, which then are in SI as well.
        let units = written.get(UNITS.name).filter(|_| bare_si(written));
        let units = units.map(|at| Setting {
            path: Spanned::new(UNITS.name.to_owned(), at.span()),
            value: "\"SI\"".to_owned(),
        });
        let set = written
            .get("set")
            .map_or_else(Vec::new, |v| variation::settings(source, v, "set", &mut problems));
        let set = units.into_iter().chain(set).collect();
        let vary = written.get("vary").map_or_else(Vec::new, |v| variation::varied(source, v, &mut problems));
        let rows = written.get("row").map_or_else(Vec::new, |v| read::rows(source, v, &mut problems));
        let mut rest = written.clone();
        for by_hand in ["set", "vary", "row"] {
            rest.remove(by_hand);
        }
        let mut checker = Checker::new(&STUDY, Laws { materials: &[], interfaces: &[] }, written);
        let fields = checker.table(&STUDY, Some(&[]), &rest, document.span(), "");
        problems.extend(checker.problems);
        let records = fields.tables("record").filter_map(|f| read::record(source, written, f)).collect();
        let study = StudyFile::assemble(path, source, &fields, (set, vary, rows, records));
        match study {
            Some(study) if problems.is_empty() => {
                let problems = study.check();
                if problems.is_empty() { Ok(study) } else { Err(report(problems)) }
            }
            None if problems.is_empty() => {
                let remedy = "compare it with cases/first-shake/fragility.toml";
                Err(report(vec![Diagnostic::new(0..0, "the study is not complete", remedy)]))
            }
            _ => Err(report(problems)),
        }
    }

    /// A report of problems found later, to be shown in this file's text.
    pub fn report(&self, problems: Vec<Diagnostic>) -> Report {
        Report::new(&self.path, &self.source, problems)
    }

    /// The folder that paths of the study start from.
    pub fn directory(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new(""))
    }

    fn assemble(
        path: &Path,
        source: &str,
        f: &Fields,
        (set, vary, rows, records): (Vec<Setting>, Vec<Varied>, Vec<Row>, Vec<RecordEntry>),
    ) -> Option<StudyFile> {
        let case = f.text("case")?;
        let run = f.table("run")?;
        Some(StudyFile {
            path: path.to_owned(),
            source: source.to_owned(),
            title: f.text("title")?,
            case: Spanned::new(case.value.into(), case.span),
            language: f.word("language", Language::from_word).map(|word| word.value),
            set,
            vary,
            rows,
            records,
            correlations: f.tables("correlation").map(read::correlation).collect::<Option<_>>()?,
            sample: match f.table("sample") {
                Some(sample) => Some(read::sample(sample)?),
                None => None,
            },
            scale: match f.table("scale") {
                Some(scale) => Some(read::scale(scale)?),
                None => None,
            },
            measures: f.entries("measure").iter().map(read::measure).collect::<Option<_>>()?,
            fragilities: f.tables("fragility").map(read::fragility).collect::<Option<_>>()?,
            run: RunWish {
                at_once: run.count("at_once").map(|n| n.value),
                threads: run.count("threads").map(|n| n.value),
                keep: run.word("keep", Keep::from_word)?.value,
                share: run.flag("share")?,
            },
        })
    }
}

#[cfg(test)]
mod tests;
