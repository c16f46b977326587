//! How the values of a case stand in its text.

use std::ops::Range;

use toml::Spanned as Located;
use toml::de::{DeTable, DeValue};

/// How a value stands in the text.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Form {
    /// The whole text.
    Root,
    /// Below this header.
    Header(Range<usize>),
    /// Within these braces.
    Braces(Range<usize>),
    /// Spread over keys with dots and headers of tables in it.
    Spread,
    /// As a list of headers.
    Headers,
    /// In one place: a number, a text, a list in brackets.
    Plain,
}

/// A text of TOML, for the places of what is parsed from it.
#[derive(Clone, Copy)]
pub(super) struct Layout<'a>(pub &'a str);

impl Layout<'_> {
    /// Where the line of a byte ends, before its line break.
    pub fn line_end(&self, at: usize) -> usize {
        let line = self.0[at..].split('\n').next().unwrap_or_default();
        at + line.trim_end_matches('\r').len()
    }

    pub fn form(&self, value: &Located<DeValue<'_>>) -> Form {
        let begins = |value: &Located<DeValue<'_>>, with: char| {
            value.get_ref().is_table() && self.0[value.span().start..].starts_with(with)
        };
        match value.get_ref() {
            DeValue::Table(_) if begins(value, '{') => Form::Braces(value.span()),
            DeValue::Table(_) if begins(value, '[') => Form::Header(value.span()),
            DeValue::Table(_) => Form::Spread,
            DeValue::Array(entries) if entries.iter().any(|entry| begins(entry, '[')) => Form::Headers,
            _ => Form::Plain,
        }
    }

    /// The end of the last value that stands in a table itself, not below the header of another; nothing where there is none.
    pub fn end(&self, table: &DeTable<'_>) -> Option<usize> {
        let ends = table.iter().filter_map(|(_, value)| match (self.form(value), value.get_ref()) {
            (Form::Spread, DeValue::Table(inner)) => self.end(inner),
            (Form::Plain | Form::Braces(_), _) => Some(value.span().end),
            _ => None,
        });
        ends.max()
    }

    /// The lines of a value that stands in several places.
    pub fn lines(&self, value: &Located<DeValue<'_>>) -> Vec<Range<usize>> {
        let mut places = Vec::new();
        self.places(value, &mut places);
        let lines = |place: Range<usize>| {
            let start = self.0[..place.start].rfind('\n').map_or(0, |at| at + 1);
            let end = self.0[place.end..].find('\n').map_or(self.0.len(), |at| place.end + at + 1);
            start..end
        };
        places.into_iter().map(lines).collect()
    }

    fn places(&self, value: &Located<DeValue<'_>>, places: &mut Vec<Range<usize>>) {
        if let Form::Header(header) = self.form(value) {
            places.push(header);
        }
        match value.get_ref() {
            DeValue::Array(entries) => entries.iter().for_each(|entry| self.places(entry, places)),
            DeValue::Table(table) => {
                for (key, value) in table {
                    match self.form(value) {
                        Form::Plain | Form::Braces(_) => places.push(key.span().start..value.span().end),
                        _ => self.places(value, places),
                    }
                }
            }
            _ => {}
        }
    }
}
