//! A law file: one material on its own, for driving a single point.

use std::ops::Range;
use std::path::{Path, PathBuf};

use toml::de::DeTable;
use tremolite_laws::parameter::{Dimension, Values};

use crate::case::CASE;
use crate::check::Checker;
use crate::defaulted::Defaulted;
use crate::keys::{Key, Kind, Limit, Table};
use crate::law_table::LawTable;
use crate::laws::Laws;
use crate::material::MATERIAL;
use crate::{Problem, Report, Spanned, law_key, syntax};

const SIZE: Key = Key::optional(
    "size",
    Kind::Number(Dimension::LENGTH, Limit::Positive),
    "",
    "Extent of the element in every direction, for laws with a fracture energy",
);

/// What stands in the file beside its `[material]`.
static LAW_FILE: Table = Table {
    path: "",
    doc: "A law on its own.",
    keys: &[SIZE, Key::later("interface", "give a [material] table: only materials can be driven alone")],
    choice: &[],
};

/// A point has no weight: the density may be left out.
static WEIGHTLESS: Table = Table { path: "material", doc: "", keys: MATERIAL.keys, choice: &[] };

/// A material read from a file of its own, checked by the keys and the law as in a case.
///
/// The file holds one `[material]` without a name. Its density or unit weight may be left out, and is not kept. The
/// key `size`, above the table or in it, is the extent of the element.
#[derive(Clone, Debug, PartialEq)]
pub struct LawFile {
    /// The file as the user named it.
    pub path: PathBuf,
    /// Its text, unchanged.
    pub source: String,
    /// Name of one of the laws given to [`LawFile::read`].
    pub law: Spanned<String>,
    /// The law's parameters in SI, defaults filled in; the law has accepted them.
    pub parameters: Values,
    /// Extent of the element \[m\], above 0.
    pub size: Option<Spanned<f64>>,
    /// The header `[material]`.
    pub span: Range<usize>,
    /// Keys that were left out, with what is used instead.
    pub defaulted: Vec<Defaulted>,
}

impl LawFile {
    /// Reads and checks a law file. `laws` are the material laws it may name, usually
    /// [`MATERIALS`](tremolite_laws::materials::MATERIALS).
    ///
    /// # Errors
    /// All problems of the file at once.
    pub fn read<'a>(path: &Path, laws: impl Into<Laws<'a>>) -> Result<LawFile, Report> {
        LawFile::parse(path, &syntax::read(path, "law file")?, laws)
    }

    /// Checks the text of a law file. Touches no files; `path` names it in messages.
    ///
    /// # Errors
    /// All problems of the text at once: of its syntax, or else of its content.
    pub fn parse<'a>(path: &Path, source: &str, laws: impl Into<Laws<'a>>) -> Result<LawFile, Report> {
        let report = |problems| Report::new(path, source, problems);
        let document = syntax::parse(source).map_err(report)?;
        let mut checker = Checker::new(&CASE, laws.into());
        let file = checker.law_file(document.get_ref(), document.span());
        let Checker { problems, defaulted, .. } = checker;
        match file {
            Some(file) if problems.is_empty() => {
                Ok(LawFile { path: path.to_owned(), source: source.to_owned(), defaulted, ..file })
            }
            _ => Err(report(problems)),
        }
    }

    /// A report of problems found later, to be shown in this file's text.
    pub fn report(&self, problems: Vec<Problem>) -> Report {
        Report::new(&self.path, &self.source, problems)
    }
}

impl Checker<'_> {
    /// The file's content without its path and text; nothing only where a problem is kept.
    fn law_file(&mut self, written: &DeTable<'_>, span: Range<usize>) -> Option<LawFile> {
        let mut beside = written.clone();
        let material = beside.remove("material");
        let fields = self.table(&LAW_FILE, Some(&[]), &beside, span.clone(), "law file");
        let outside = fields.nodes.get(SIZE.name).and_then(|n| n.number());
        let Some(material) = material else {
            if self.problems.is_empty() {
                self.problem(span, "there is no material", "write [material] and the keys of one material");
            }
            return None;
        };
        let at = material.span();
        let Some(table) = material.get_ref().as_table() else {
            self.problem(at, "`material` should be a table", "write [material] and the keys of one material");
            return None;
        };
        if let Some(name) = lone_name(table) {
            let remedy = format!("write [material] instead of [material.{name}]");
            self.problem(at, "a law file has one material, without a name", remedy);
            return None;
        }
        let weightless = !(table.contains_key("density") || table.contains_key("unit_weight"));
        let keys = if weightless { &WEIGHTLESS } else { &MATERIAL };
        let laws = self.laws.materials;
        let form = LawTable { table: keys, laws, instead: &[], key: law_key::of, more: &[SIZE] };
        let fields = self.law(&form, table, at, "material");
        let inside = fields.nodes.get(SIZE.name).and_then(|n| n.number());
        if let (Some(_), Some(inside)) = (&outside, &inside) {
            self.problem(inside.span.clone(), "`size` is given twice", "keep one of the two");
        }
        Some(LawFile {
            path: PathBuf::new(),
            source: String::new(),
            law: fields.text("law")?,
            parameters: fields.values()?,
            size: outside.or(inside),
            span: fields.span.clone(),
            defaulted: Vec::new(),
        })
    }
}

/// The name of the first material, where all there is are materials with names as in a case.
fn lone_name<'a>(table: &'a DeTable<'_>) -> Option<&'a str> {
    let named = !table.is_empty() && table.iter().all(|(_, value)| value.get_ref().is_table());
    // The table lists names in alphabetical order; the message points at the first in the file.
    let first = table.iter().map(|(key, _)| key).min_by_key(|key| key.span().start);
    first.filter(|_| named).map(|key| key.get_ref().as_ref())
}
