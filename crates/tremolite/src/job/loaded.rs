//! A case with all that it names read, before it is a model.

use super::fault::{Fault, Remark};
use crate::setup::{Inputs, Laws, Setup, changed, original_folder, setup_of};
use std::path::{Path, PathBuf};
use tremolite_case::{self as case, Case, Change, Diagnostic};
use tremolite_laws::{Isa, LawInfo};

/// What a program gives beside a case.
#[derive(Clone)]
pub struct Given {
    /// Other values at some keys, one after the other.
    pub changes: Vec<Change>,
    /// What the case names and is in memory.
    pub inputs: Inputs,
    /// The laws that the case may name.
    pub laws: Laws,
    /// The instruction set of the kernels; results do not depend on it.
    pub isa: Isa,
}

impl Default for Given {
    /// No changes, the laws of the house, the best instruction set that the processor has.
    fn default() -> Self {
        Given { changes: Vec::new(), inputs: Inputs::default(), laws: Laws::default(), isa: Isa::best() }
    }
}

/// A case, its mesh, its records, and what it asks for.
pub struct Loaded {
    pub case: Case,
    pub setup: Setup,
    /// The folder from which a result folder's case names its files; none for a case that is no result folder's.
    pub original: Option<PathBuf>,
    /// What is not as the run of that result folder read it, a sentence each.
    pub changed: Vec<String>,
}

impl Loaded {
    /// Reads a case file and what it names.
    ///
    /// # Errors
    /// All problems of the file, of the changes, or of what it names, each at its place.
    pub fn read(path: &Path, given: &Given) -> Result<Loaded, Fault> {
        let original = original_folder(path);
        let directory = original.as_deref().or(path.parent()).unwrap_or(Path::new(""));
        let text = Case::text_of(path).map_err(refused)?;
        let mut loaded = Loaded::of_text(&text, path, directory, given)?;
        loaded.changed = changed(path, &loaded.setup.inputs);
        loaded.original = original;
        Ok(loaded)
    }

    /// Reads the text of a case and what it names: relative paths start from `directory`. Messages call it by `path`, which need
    /// not be there.
    ///
    /// # Errors
    /// As [`Loaded::read`].
    pub fn of_text(text: &str, path: &Path, directory: &Path, given: &Given) -> Result<Loaded, Fault> {
        let [materials, interfaces] = infos(&given.laws);
        let laws = case::Laws { materials: &materials, interfaces: &interfaces };
        let case = Case::parse_in(path, directory, text, &given.changes, laws).map_err(refused)?;
        Loaded::build(case, given)
    }

    /// Reads what a case names.
    ///
    /// # Errors
    /// As [`Loaded::read`].
    pub fn of(case: &Case, given: &Given) -> Result<Loaded, Fault> {
        let [materials, interfaces] = infos(&given.laws);
        let laws = case::Laws { materials: &materials, interfaces: &interfaces };
        let case = case.parse_with(&given.changes, laws).map_err(refused)?;
        Loaded::build(case, given)
    }

    /// Builds what a case asks for, whose changes have been made.
    fn build(case: Case, given: &Given) -> Result<Loaded, Fault> {
        let mut problems = case.missing_files(|file| given.inputs.has(file));
        problems.extend(given.inputs.not_named(&case).into_iter().map(|(kind, name)| {
            let named: Vec<String> =
                case.files().iter().map(|file| file.value.display().to_string()).collect();
            let remedy = match named.is_empty() {
                true => "the case names none; write path = \"…\" or file = \"…\" with that name".to_owned(),
                false => format!("the case names {}", named.join(", ")),
            };
            Diagnostic::new(
                0..0,
                format!("'{name}' is in memory among {kind}, but no key of the case asks for it there"),
                remedy,
            )
        }));
        if !problems.is_empty() {
            return Err(refused(case.report(problems)));
        }
        let setup = setup_of(&case, &given.inputs, &given.laws, given.isa).map_err(|report| Fault {
            remarks: Remark::of(&case, &case.warnings).into_iter().collect(),
            why: report.into(),
        })?;
        Ok(Loaded { case, setup, original: None, changed: Vec::new() })
    }

    /// What is unusual so far, in the order in which it is to be told.
    pub fn remarks(&self) -> Vec<Remark> {
        let Loaded { case, setup, original, changed } = self;
        let found = [&case.warnings, &setup.warnings].map(|problems| Remark::of(case, problems));
        let mut remarks: Vec<Remark> = found.into_iter().flatten().collect();
        if let Some(original) = original {
            remarks.push(Remark::Files(original.clone()));
            remarks.extend(changed.iter().cloned().map(Remark::Changed));
        }
        remarks
    }
}

/// A refusal before anything unusual was found.
fn refused(report: case::Report) -> Fault {
    Fault { remarks: Vec::new(), why: report.into() }
}

/// What the laws of materials and interfaces say of themselves.
pub(super) fn infos(laws: &Laws) -> [Vec<LawInfo>; 2] {
    [
        laws.materials.iter().map(|law| law.info).collect(),
        laws.interfaces.iter().map(|law| law.info).collect(),
    ]
}
