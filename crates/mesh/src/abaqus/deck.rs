//! The lines of an input file and of those that it includes: keyword lines, taken apart, and data lines.

use std::fs::File;
use std::path::{Path, PathBuf};

use crate::fault::Fault;
use crate::input::{Input, shown, whole};

/// Files open at a time; more is a mistake.
const DEEPEST: usize = 20;

/// What the current line is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum LineKind {
    Keyword,
    Data,
}

/// A name. Abaqus takes names without quotes in upper case, and those in quotes as they are.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Label {
    /// By which names are compared.
    pub key: String,
    pub shown: String,
}

impl Label {
    pub(super) fn new(text: &str) -> Self {
        let text = text.trim();
        match text.strip_prefix('"').and_then(|t| t.strip_suffix('"')) {
            Some(exact) => Label { key: exact.to_owned(), shown: exact.to_owned() },
            None => Label { key: text.to_uppercase(), shown: text.to_owned() },
        }
    }
}

/// A keyword line such as `*ELEMENT, TYPE=C3D8, ELSET=rock`.
#[derive(Debug, Default)]
pub(super) struct Keyword {
    /// In upper case, with single blanks.
    pub name: String,
    /// Names in upper case.
    parameters: Vec<(String, String)>,
}

impl Keyword {
    fn parse(text: &[u8]) -> Self {
        let text = crate::input::text(text);
        let mut parts = split_outside_quotes(text.trim_start_matches('*')).into_iter();
        let upper = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ").to_uppercase();
        let name = upper(parts.next().unwrap_or_default());
        let parameters = parts.filter(|p| !p.trim().is_empty()).map(|part| match part.split_once('=') {
            Some((name, value)) => (upper(name), value.trim().to_owned()),
            None => (upper(part), String::new()),
        });
        Keyword { name, parameters: parameters.collect() }
    }

    /// A parameter's value, empty if it has none.
    pub(super) fn get(&self, name: &str) -> Option<&str> {
        self.parameters.iter().find(|(n, _)| n == name).map(|(_, value)| value.as_str())
    }

    pub(super) fn has(&self, name: &str) -> bool {
        self.get(name).is_some()
    }

    /// A parameter that is a name.
    pub(super) fn label(&self, name: &str) -> Option<Label> {
        self.get(name).map(Label::new)
    }
}

/// The pieces between the commas that do not stand in quotes.
fn split_outside_quotes(text: &str) -> Vec<&str> {
    let mut quoted = false;
    text.split(|c| {
        quoted ^= c == '"';
        c == ',' && !quoted
    })
    .collect()
}

struct Included {
    path: PathBuf,
    /// Without links, to know a file that includes itself.
    real: PathBuf,
    input: Input<'static>,
}

/// The lines, includes followed.
pub(super) struct Deck<'i, 'a> {
    root: &'i mut Input<'a>,
    path: PathBuf,
    included: Vec<Included>,
    text: Vec<u8>,
    pub keyword: Keyword,
}

impl<'i, 'a> Deck<'i, 'a> {
    pub(super) fn new(root: &'i mut Input<'a>, path: &Path) -> Self {
        Deck {
            root,
            path: path.to_owned(),
            included: Vec::new(),
            text: Vec::new(),
            keyword: Keyword::default(),
        }
    }

    /// The next line that is no comment; none at the end. A keyword line comes with its continuations.
    pub(super) fn advance(&mut self) -> Result<Option<LineKind>, Fault> {
        loop {
            if !self.line()? {
                return Ok(None);
            }
            if !self.text.starts_with(b"*") {
                return Ok(Some(LineKind::Data));
            }
            let mut all = std::mem::take(&mut self.text);
            while all.ends_with(b",") && self.line()? {
                all.extend_from_slice(&self.text);
            }
            self.keyword = Keyword::parse(&all);
            self.text = all;
            match self.keyword.name.as_str() {
                "INCLUDE" => self.open()?,
                "NODE" | "ELEMENT" | "NSET" | "ELSET" if self.keyword.has("INPUT") => {
                    self.open()?;
                    return Ok(Some(LineKind::Keyword));
                }
                _ => return Ok(Some(LineKind::Keyword)),
            }
        }
    }

    /// Copies the next line that is no comment into `text`.
    fn line(&mut self) -> Result<bool, Fault> {
        loop {
            let more = match self.included.last_mut() {
                Some(file) => {
                    let more = file.input.advance();
                    copy(&file.input, &mut self.text);
                    more
                }
                None => {
                    let more = self.root.advance();
                    copy(self.root, &mut self.text);
                    more
                }
            };
            match more.map_err(|fault| self.placed(fault))? {
                true if self.text.starts_with(b"**") => {}
                true => return Ok(true),
                false if self.included.pop().is_some() => {}
                false => return Ok(false),
            }
        }
    }

    /// Goes on in the file that the keyword's INPUT names, relative to the one that names it.
    fn open(&mut self) -> Result<(), Fault> {
        let Some(name) = self.keyword.get("INPUT").filter(|name| !name.is_empty()) else {
            return Err(self.fault("INPUT with a file's name is missing"));
        };
        let name = name.trim_matches('"');
        let from = self.included.last().map_or(&self.path, |file| &file.path);
        let path = from.parent().unwrap_or(Path::new("")).join(name);
        let absent = |e: std::io::Error| {
            self.fault(format!(
                "the included file {} cannot be opened ({e}); put it beside this file, or remove the line",
                path.display()
            ))
        };
        let real = path.canonicalize().map_err(absent)?;
        let root = self.path.canonicalize().ok();
        if self.included.iter().any(|file| file.real == real) || root.as_ref() == Some(&real) {
            return Err(self.fault(format!("{} includes itself; remove the line", path.display())));
        }
        if self.included.len() >= DEEPEST {
            return Err(
                self.fault(format!("more than {DEEPEST} files include one another; put them into fewer"))
            );
        }
        let file = File::open(&path).map_err(absent)?;
        self.included.push(Included { path, real, input: Input::new(file) });
        Ok(())
    }

    /// The fields of the current data line, without blanks; a comma at the end counts for nothing.
    pub(super) fn fields(&self) -> impl Iterator<Item = &[u8]> {
        let text = self.text.strip_suffix(b",").unwrap_or(&self.text);
        text.split(|&b| b == b',').map(<[u8]>::trim_ascii)
    }

    /// Whether the data line goes on in the next one.
    pub(super) fn goes_on(&self) -> bool {
        self.text.ends_with(b",")
    }

    /// A field as a whole number.
    pub(super) fn number(&self, field: &[u8], what: &str) -> Result<u64, Fault> {
        whole(field).ok_or_else(|| self.misplaced(field, what))
    }

    /// A field as a finite real number; an empty one is 0.
    pub(super) fn real(&self, field: &[u8], what: &str) -> Result<f64, Fault> {
        if field.is_empty() {
            return Ok(0.0);
        }
        crate::input::real(field).ok_or_else(|| self.misplaced(field, what))
    }

    pub(super) fn misplaced(&self, field: &[u8], what: &str) -> Fault {
        self.fault(format!("`{}` stands where {what} should", shown(field)))
    }

    /// Number of the current line, in whichever file it is.
    pub(super) fn line_number(&self) -> usize {
        self.included.last().map_or(self.root.line(), |file| file.input.line())
    }

    /// A fault in the current line.
    pub(super) fn fault(&self, problem: impl Into<String>) -> Fault {
        self.placed(Fault::at(self.line_number(), problem))
    }

    fn placed(&self, fault: Fault) -> Fault {
        Fault { file: self.included.last().map(|file| file.path.clone()), ..fault }
    }
}

fn copy(input: &Input, text: &mut Vec<u8>) {
    text.clear();
    text.extend_from_slice(input.text());
}
