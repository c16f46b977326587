//! Checks a case against its tables of keys: every problem is kept, defaults are filled in and listed.

use std::collections::BTreeMap;
use std::ops::Range;

use toml::Spanned as Located;
use toml::de::{DeTable, DeValue};

use crate::defaulted::Defaulted;
use crate::fields::{Fields, Item, Node};
use crate::keys::{Key, Kind, Need, Table, When};
use crate::laws::Laws;
use crate::renamed::{self, Azimuth};
use crate::{Diagnostic, suggest, units};

/// The keys of one table as they are written, with the place of the key and the value.
pub(crate) type Given<'a> = BTreeMap<&'a str, (Range<usize>, &'a Located<DeValue<'a>>)>;

/// In what the bare numbers of a file are. It stands above all tables.
pub(crate) const UNITS: Key = Key::optional(
    "units",
    Kind::Word(&["SI"]),
    "",
    "In what numbers without a unit are: \"SI\", angles excepted. Left out: every number that has a dimension has its unit; 0 needs none",
);

/// Whether the bare numbers of a file are in SI.
pub(crate) fn bare_si(file: &DeTable<'_>) -> bool {
    file.get(UNITS.name).is_some_and(|value| value.get_ref().as_str() == Some("SI"))
}

/// What is collected while a case is checked.
pub(crate) struct Checker<'a> {
    /// The table of all tables of a case, where a misplaced key may belong.
    case: &'static Table,
    pub laws: Laws<'a>,
    pub problems: Vec<Diagnostic>,
    pub defaulted: Vec<Defaulted>,
    /// Whether bare numbers are in SI, as the file says of itself.
    pub bare_si: bool,
    /// Whether a remedy has named that key already.
    pub told_of_si: bool,
    azimuth: Azimuth,
    /// The table in whose place defaults are read: their text is not part of the file.
    stand_in: Option<Range<usize>>,
}

impl<'a> Checker<'a> {
    /// A checker of a file, which may say of itself in what its bare numbers are.
    pub fn new(case: &'static Table, laws: Laws<'a>, file: &DeTable<'_>) -> Self {
        let (problems, defaulted) = (Vec::new(), Vec::new());
        Checker {
            case,
            laws,
            problems,
            defaulted,
            bare_si: bare_si(file),
            told_of_si: false,
            azimuth: Azimuth::of(file),
            stand_in: None,
        }
    }

    pub fn problem(&mut self, span: Range<usize>, message: impl Into<String>, remedy: impl Into<String>) {
        self.problems.push(Diagnostic::new(span, message, remedy));
    }

    /// Checks a table. `more` are keys beyond those of the table; nothing: further keys cannot be judged.
    pub fn table(
        &mut self,
        table: &'static Table,
        more: Option<&[Key]>,
        written: &DeTable<'_>,
        span: Range<usize>,
        path: &str,
    ) -> Fields {
        let given = given(written);
        let keys = || table.keys.iter().chain(more.unwrap_or_default());
        if more.is_some() {
            for (name, (at, value)) in given.iter().filter(|(name, _)| !keys().any(|k| k.name == **name)) {
                if let Some(new) = renamed::key(name, keys().map(|k| k.name)) {
                    let remedy = renamed::remedy(new, table.path, value, self.azimuth);
                    self.problem(at.clone(), format!("`{name}` of {} has another name", place(path)), remedy);
                    continue;
                }
                let here = keys().filter(|k| !ruled_out(k.when, &given));
                let remedy = suggest::key(self.case, table.path, name, here.map(|k| k.name));
                self.problem(at.clone(), format!("`{name}` is no key of {}", place(path)), remedy);
            }
        }
        self.choice(table, &given, &span, path);
        let mut nodes = BTreeMap::new();
        for key in keys() {
            if let Some(node) = self.key(key, &given, &span, path) {
                nodes.insert(key.name, node);
            }
        }
        Fields { table, span, nodes, parameters: None }
    }

    fn choice(&mut self, table: &Table, given: &Given<'_>, span: &Range<usize>, path: &str) {
        let has = |group: &&&[&str]| group.iter().any(|name| given.contains_key(name));
        let free = table.choice.iter().any(|group| group.is_empty());
        let named = table.choice.iter().filter(|group| !group.is_empty());
        let options: Vec<String> = named.map(|g| format!("`{}`", g.join("`/`"))).collect();
        let mut chosen = table.choice.iter().filter(has);
        match (chosen.next(), chosen.next()) {
            (None, _) if !options.is_empty() && !free => self.problem(
                self.placed(span.clone()),
                format!("{} needs one of {}", place(path), options.join(", ")),
                format!("give one of {}", options.join(", ")),
            ),
            (Some(first), Some(second)) => {
                let name = |group: &[&'static str]| group.iter().copied().find(|n| given.contains_key(n));
                let (Some(first), Some(second)) = (name(first), name(second)) else { return };
                let at = given.get(second).map_or(span.clone(), |(at, _)| at.clone());
                self.problem(
                    self.placed(at),
                    format!("`{second}` cannot stand beside `{first}`"),
                    format!(
                        "give {} one of {}",
                        if free { "at most" } else { "exactly" },
                        options.join(", ")
                    ),
                );
            }
            _ => {}
        }
    }

    fn key(&mut self, key: &Key, given: &Given<'_>, span: &Range<usize>, path: &str) -> Option<Node> {
        let written = given.get(key.name);
        if !applies(key.when, given) {
            if let (Some((at, _)), Some(when)) = (written, key.when.words()) {
                self.problem(at.clone(), format!("`{}` has a meaning only {when}", key.name), "leave it out");
            }
            return None;
        }
        let table = path;
        let path = if path.is_empty() { key.name.to_owned() } else { format!("{path}.{}", key.name) };
        if let Some((_, value)) = written {
            return self.value(&key.kind, value.get_ref(), value.span(), &path);
        }
        let span = self.placed(span.clone());
        match key.need {
            Need::RequiredBeside(beside, otherwise) if !given.contains_key(beside) => {
                let listed = self.defaulted.len();
                let node = self.default(key, otherwise, span, &path);
                self.defaulted.truncate(listed);
                node
            }
            Need::Required | Need::RequiredBeside(..)
                if renamed::has_old(key.name, |old| given.contains_key(old)) =>
            {
                None
            }
            Need::Required | Need::RequiredBeside(..) => {
                let message = format!("`{}` is missing in {}", key.name, place(table));
                self.problems.push(Diagnostic::new(span, message, suggest::missing(key)).missing(key.name));
                None
            }
            Need::Default(text) => self.default(key, text, span, &path),
            Need::Number(x) => {
                let text = match key.kind {
                    Kind::Number(dimension, _) => units::format(x, dimension),
                    _ => x.to_string(),
                };
                self.defaulted.push(Defaulted { key: path, value: text });
                Some(Node { item: Item::Number(x), span })
            }
            Need::Word(word) => {
                self.defaulted.push(Defaulted { key: path, value: word.to_owned() });
                Some(Node { item: Item::Text(word.to_owned()), span })
            }
            Need::Optional("") => None,
            Need::Optional(without) => {
                self.defaulted.push(Defaulted { key: path, value: without.to_owned() });
                None
            }
        }
    }

    /// Reads a default as if it stood in the file.
    fn default(&mut self, key: &Key, text: &'static str, span: Range<usize>, path: &str) -> Option<Node> {
        // Only constants of this crate come here; a test reads them all.
        let value = DeValue::parse(text).ok()?;
        if !matches!(value.get_ref(), DeValue::Table(_)) {
            let shown = value.get_ref().as_str().unwrap_or(text);
            self.defaulted.push(Defaulted { key: path.to_owned(), value: shown.to_owned() });
        }
        let outer = self.stand_in.replace(span.clone());
        let node = self.value(&key.kind, value.get_ref(), span, path);
        self.stand_in = outer;
        node
    }

    /// Where a value or problem is placed.
    pub fn placed(&self, span: Range<usize>) -> Range<usize> {
        self.stand_in.clone().unwrap_or(span)
    }
}

/// The keys of a table by name.
pub(crate) fn given<'a>(written: &'a DeTable<'a>) -> Given<'a> {
    written.iter().map(|(key, value)| (key.get_ref().as_ref(), (key.span(), value))).collect()
}

/// A table in messages, by its path.
fn place(path: &str) -> String {
    if path.is_empty() { "the case".to_owned() } else { format!("`{path}`") }
}

fn applies(when: When, given: &Given<'_>) -> bool {
    let is = |key: &str, word: &str| given.get(key).is_some_and(|(_, v)| v.get_ref().as_str() == Some(word));
    match when {
        When::Always => true,
        When::Is(key, word) => is(key, word),
        When::IsNot(key, word) => !is(key, word),
        When::Beside(key) => given.contains_key(key),
        When::BesideAny(keys) => keys.iter().any(|key| given.contains_key(key)),
        When::Without(key) => !given.contains_key(key),
        When::WithoutAny(keys) => !keys.iter().any(|key| given.contains_key(key)),
    }
}

/// Whether a key has no meaning whatever is added: what it is to stand beside may be misspelt.
fn ruled_out(when: When, given: &Given<'_>) -> bool {
    !matches!(when, When::Beside(_) | When::BesideAny(_)) && !applies(when, given)
}
