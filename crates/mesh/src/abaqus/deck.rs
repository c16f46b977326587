//! The lines of an input file: keyword lines, taken apart, and data lines.

use std::ops::Deref;
use std::path::Path;

use crate::cards;
use crate::fault::Fault;
use crate::input::Input;

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

/// The lines, includes followed.
pub(super) struct Deck<'i, 'a> {
    cards: cards::Deck<'i, 'a>,
    pub keyword: Keyword,
}

impl<'i, 'a> Deref for Deck<'i, 'a> {
    type Target = cards::Deck<'i, 'a>;

    fn deref(&self) -> &Self::Target {
        &self.cards
    }
}

impl<'i, 'a> Deck<'i, 'a> {
    pub(super) fn new(root: &'i mut Input<'a>, path: &Path) -> Self {
        Deck { cards: cards::Deck::new(root, path), keyword: Keyword::default() }
    }

    /// The next line that is no comment; none at the end. A keyword line comes with its continuations.
    pub(super) fn advance(&mut self) -> Result<Option<LineKind>, Fault> {
        loop {
            if !self.next_card()? {
                return Ok(None);
            }
            if !self.text().starts_with(b"*") {
                return Ok(Some(LineKind::Data));
            }
            let mut all = self.text().to_vec();
            while all.ends_with(b",") && self.next_card()? {
                all.extend_from_slice(self.text());
            }
            self.keyword = Keyword::parse(&all);
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

    /// Goes to the next line that is neither blank nor a comment.
    fn next_card(&mut self) -> Result<bool, Fault> {
        while self.cards.advance()? {
            if !self.text().is_empty() && !self.text().starts_with(b"**") {
                return Ok(true);
            }
        }
        Ok(false)
    }

    fn text(&self) -> &[u8] {
        self.cards.line().trim_ascii_start()
    }

    /// Goes on in the file that the keyword's INPUT names.
    fn open(&mut self) -> Result<(), Fault> {
        let Some(name) = self.keyword.get("INPUT").filter(|name| !name.is_empty()) else {
            return Err(self.fault("INPUT with a file's name is missing"));
        };
        self.cards.include(name.trim_matches('"'))
    }

    /// The fields of the current data line; a comma at the end counts for nothing.
    pub(super) fn fields(&self) -> cards::Fields<'_> {
        cards::fields(self.text().strip_suffix(b",").unwrap_or(self.text()), &[])
    }

    /// Whether the data line goes on in the next one.
    pub(super) fn goes_on(&self) -> bool {
        self.text().ends_with(b",")
    }

    /// A field as a finite real number; an empty one is 0.
    pub(super) fn real(&self, field: &[u8], what: &str) -> Result<f64, Fault> {
        if field.is_empty() {
            return Ok(0.0);
        }
        crate::input::real(field).ok_or_else(|| self.misplaced(field, what))
    }
}
