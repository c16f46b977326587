//! A law file: one law on its own, for driving a single point or pair.

use std::ops::Range;
use std::path::{Path, PathBuf};

use toml::de::{DeTable, DeValue};
use tremolite_laws::parameter::{Dimension, Values};

use crate::case::CASE;
use crate::check::{Checker, UNITS, given};
use crate::defaulted::Defaulted;
use crate::fields::{Fields, Node};
use crate::interface::INTERFACE;
use crate::keys::{Key, Kind, Limit, Table};
use crate::law_table::LawTable;
use crate::laws::Laws;
use crate::material::MATERIAL;
use crate::{Diagnostic, Report, Spanned, law_key, syntax};

const SIZE: Key = Key::optional(
    "size",
    Kind::Number(Dimension::LENGTH, Limit::Positive),
    "",
    "Extent of the element in every direction, for laws with a fracture energy",
);

/// What stands in the file beside the table of its law.
static LAW_FILE: Table = Table { path: "", doc: "A law on its own.", keys: &[SIZE, UNITS], choice: &[] };

/// A point has no weight: the density may be left out.
static WEIGHTLESS: Table = Table { path: "material", doc: "", keys: MATERIAL.keys, choice: &[] };

/// A pair lies between no bodies.
static PAIR: Table = Table {
    path: "interface",
    doc: "",
    keys: &[Key::required("law", Kind::Text, "the interface law")],
    choice: &[],
};

/// What a law file holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LawKind {
    /// A law of stress and strain at a point.
    Material,
    /// A law of traction, gap and slip at a pair.
    Interface,
}

impl LawKind {
    /// The table that holds it: `[material]`, `[interface]`.
    pub fn word(self) -> &'static str {
        match self {
            LawKind::Material => "material",
            LawKind::Interface => "interface",
        }
    }
}

/// A law read from a file of its own, checked by the keys and the law as in a case.
///
/// The file holds one `[material]` or one `[interface]`, without a name. A material's density or unit weight may be left
/// out, and is not kept; the key `size`, above its table or in it, is the extent of the element. Of an interface there are
/// its law and all parameters that the program would choose in a case.
#[derive(Clone, Debug, PartialEq)]
pub struct LawFile {
    /// The file as the user named it.
    pub path: PathBuf,
    /// Its text, unchanged.
    pub source: String,
    /// Among which laws the law is.
    pub kind: LawKind,
    /// Name of one of the laws given to [`LawFile::read`].
    pub law: Spanned<String>,
    /// The law's parameters in SI, defaults filled in; the law has accepted them.
    pub parameters: Values,
    /// Extent of the element \[m\], above 0; nothing for an interface.
    pub size: Option<Spanned<f64>>,
    /// The header `[material]` or `[interface]`.
    pub span: Range<usize>,
    /// Keys that were left out, with what is used instead.
    pub defaulted: Vec<Defaulted>,
}

impl LawFile {
    /// Reads and checks a law file. `laws` are those that it may name, usually
    /// [`MATERIALS`](tremolite_laws::materials::MATERIALS), which brings the interface laws along.
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
        let mut checker = Checker::new(&CASE, laws.into(), document.get_ref());
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
    pub fn report(&self, problems: Vec<Diagnostic>) -> Report {
        Report::new(&self.path, &self.source, problems)
    }
}

impl Checker<'_> {
    /// The file's content without its path and text; nothing only where a problem is kept.
    fn law_file(&mut self, written: &DeTable<'_>, span: Range<usize>) -> Option<LawFile> {
        let mut beside = written.clone();
        let tables = [LawKind::Material, LawKind::Interface].map(|kind| (kind, beside.remove(kind.word())));
        let fields = self.table(&LAW_FILE, Some(&[]), &beside, span.clone(), "law file");
        let outside = fields.nodes.get(SIZE.name).and_then(Node::number);
        let (kind, table) = match tables {
            [(kind, Some(table)), (_, None)] | [(_, None), (kind, Some(table))] => (kind, table),
            [(_, Some(a)), (_, Some(b))] => {
                let second = a.span().start.max(b.span().start);
                let at = if a.span().start == second { a.span() } else { b.span() };
                self.problem(at, "a law file has one law", "keep [material] or [interface]");
                return None;
            }
            [(_, None), (_, None)] => {
                // Also beside a key that is none: `[materials]` may be meant for one.
                let remedy = "write [material] or [interface] and the keys of its law";
                self.problem(span, "there is no material and no interface", remedy);
                return None;
            }
        };
        let at = table.span();
        let table = self.alone(kind, table.get_ref(), at.clone())?;
        let (fields, size) = match kind {
            LawKind::Material => {
                let fields = self.lone_material(table, at);
                let inside = fields.nodes.get(SIZE.name).and_then(Node::number);
                if let (Some(_), Some(inside)) = (&outside, &inside) {
                    self.problem(inside.span.clone(), "`size` is given twice", "keep one of the two");
                }
                (fields, outside.or(inside))
            }
            LawKind::Interface => {
                if let Some(size) = outside {
                    self.no_meaning(SIZE.name, size.span);
                }
                (self.lone_interface(table, at), None)
            }
        };
        Some(LawFile {
            path: PathBuf::new(),
            source: String::new(),
            kind,
            law: fields.text("law")?,
            parameters: fields.values()?,
            size,
            span: fields.span.clone(),
            defaulted: Vec::new(),
        })
    }

    /// The table of the one law, not a list or several by name as in a case.
    fn alone<'d>(
        &mut self,
        kind: LawKind,
        value: &'d DeValue<'d>,
        at: Range<usize>,
    ) -> Option<&'d DeTable<'d>> {
        let word = kind.word();
        if let (LawKind::Interface, DeValue::Array(_)) = (kind, value) {
            let remedy = "write [interface] instead of [[interface]]";
            self.problem(at, "a law file has one interface, not a list of them", remedy);
            return None;
        }
        let Some(table) = value.as_table() else {
            let remedy = format!("write [{word}] and the keys of one {word}");
            self.problem(at, format!("`{word}` should be a table"), remedy);
            return None;
        };
        if let Some(name) = lone_name(table) {
            let remedy = format!("write [{word}] instead of [{word}.{name}]");
            self.problem(at, format!("a law file has one {word}, without a name"), remedy);
            return None;
        }
        Some(table)
    }

    fn lone_material(&mut self, written: &DeTable<'_>, at: Range<usize>) -> Fields {
        let weightless = !(written.contains_key("density") || written.contains_key("unit_weight"));
        let table = if weightless { &WEIGHTLESS } else { &MATERIAL };
        let laws = self.laws.materials;
        let form = LawTable { table, laws, instead: &[], key: law_key::alone, more: &[SIZE] };
        self.law(&form, written, at, "material")
    }

    fn lone_interface(&mut self, written: &DeTable<'_>, at: Range<usize>) -> Fields {
        let mut own = written.clone();
        let of_a_case = INTERFACE.keys.iter().map(|key| key.name).filter(|name| *name != "law");
        for name in of_a_case.chain([SIZE.name]) {
            if own.remove(name).is_some()
                && let Some((at, _)) = given(written).get(name)
            {
                self.no_meaning(name, at.clone());
            }
        }
        let laws = self.laws.interfaces;
        let form = LawTable { table: &PAIR, laws, instead: &[], key: law_key::alone, more: &[] };
        self.law(&form, &own, at, "interface")
    }

    fn no_meaning(&mut self, key: &str, at: Range<usize>) {
        let message = format!("`{key}` has no meaning for an interface law alone");
        self.problem(at, message, "leave it out: a pair is driven per area, by its law alone");
    }
}

/// The name of the first law, where all there is are laws with names.
fn lone_name<'a>(table: &'a DeTable<'_>) -> Option<&'a str> {
    let named = !table.is_empty() && table.iter().all(|(_, value)| value.get_ref().is_table());
    // The table lists names in alphabetical order; the message points at the first in the file.
    let first = table.iter().map(|(key, _)| key).min_by_key(|key| key.span().start);
    first.filter(|_| named).map(|key| key.get_ref().as_ref())
}
