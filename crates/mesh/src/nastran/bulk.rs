//! Cards of bulk data: lines with their continuations, in small, large and free field.

use std::path::Path;

use super::names::Names;
use crate::cards::{Deck, Place, fields};
use crate::fault::Fault;
use crate::input::Input;

/// Columns of a name, eight fields and the mark of a continuation.
const SMALL: &[usize] = &[8, 8, 8, 8, 8, 8, 8, 8, 8, 8];
/// Columns of a name, four fields and the mark of a continuation.
const LARGE: &[usize] = &[8, 16, 16, 16, 16, 8];

/// A card with its continuations.
#[derive(Default)]
pub(super) struct Card {
    name: String,
    text: Vec<u8>,
    /// First byte of each field in `text`, and the byte behind its last.
    fields: Vec<[usize; 2]>,
    place: Place,
    /// The mark in the last field of the last line, without its sign.
    mark: Vec<u8>,
    /// What is wrong with its lines; executive and case control have other rules.
    problem: Option<&'static str>,
}

impl Card {
    /// In upper case.
    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// Field `k`, counted from 0 behind the name, without blanks.
    pub(super) fn field(&self, k: usize) -> &[u8] {
        self.fields.get(k).map_or(&[], |&[start, end]| &self.text[start..end])
    }

    /// How many fields there are up to the last one that is not blank.
    pub(super) fn count(&self) -> usize {
        self.fields.iter().rposition(|[start, end]| start < end).map_or(0, |k| k + 1)
    }

    pub(super) fn fault(&self, problem: impl Into<String>) -> Fault {
        self.place.fault(problem)
    }

    /// # Errors
    /// If its lines do not belong together, or one has too many fields.
    pub(super) fn check(&self) -> Result<(), Fault> {
        self.problem.map_or(Ok(()), |problem| Err(self.fault(problem)))
    }

    /// Begins a card, or goes on with it.
    fn extend(&mut self, line: &[u8], goes_on: bool) {
        let name = fields(line, SMALL).next().unwrap_or_default();
        let large = name.contains(&b'*');
        let wide = if large { 4 } else { 8 };
        let label = |text: &[u8]| text.iter().copied().filter(|b| !matches!(b, b'+' | b'*')).collect();
        if goes_on {
            let mark: Vec<u8> = label(name);
            if !mark.is_empty() && !self.mark.is_empty() && mark != self.mark {
                self.problem =
                    Some("a continuation has another mark than the line before it; sort the lines");
            }
            // Two lines of large field take the place of one of small field.
            self.fields.resize(self.fields.len().next_multiple_of(wide), [0, 0]);
        } else {
            self.name = crate::input::text(name.strip_suffix(b"*").unwrap_or(name)).trim().to_uppercase();
        }
        let first = self.fields.len();
        self.mark.clear();
        for (k, field) in fields(line, if large { LARGE } else { SMALL }).skip(1).enumerate() {
            if k < wide {
                let start = self.text.len();
                self.text.extend_from_slice(field);
                self.fields.push([start, self.text.len()]);
            } else if k == wide && matches!(field.first(), None | Some(b'+' | b'*')) {
                self.mark = label(field);
            } else if !field.is_empty() && k >= wide {
                self.problem = Some("a line has more than ten fields; continue it in a second line");
            }
        }
        self.fields.resize(first + wide, [0, 0]);
    }
}

/// The cards of a file, includes followed.
pub(super) struct Bulk<'i, 'a> {
    deck: Deck<'i, 'a>,
    /// The line that comes next, without comment; none at the end.
    next: Option<Vec<u8>>,
    /// The comments before it.
    comments: Vec<Vec<u8>>,
    begun: bool,
    card: Card,
}

impl<'i, 'a> Bulk<'i, 'a> {
    pub(super) fn new(root: &'i mut Input<'a>, path: &Path) -> Self {
        let card = Card::default();
        Bulk { deck: Deck::new(root, path), next: None, comments: Vec::new(), begun: false, card }
    }

    /// The next card; none at the end. Comments on the way may name properties.
    pub(super) fn next(&mut self, names: &mut Names) -> Result<Option<&Card>, Fault> {
        if !self.begun {
            self.begun = true;
            self.advance()?;
        }
        for comment in self.comments.drain(..) {
            names.comment(&comment);
        }
        let Some(line) = self.next.take() else { return Ok(None) };
        self.card.text.clear();
        self.card.fields.clear();
        self.card.mark.clear();
        self.card.problem = None;
        self.card.place = self.deck.place();
        self.card.extend(&line, false);
        loop {
            self.advance()?;
            match &self.next {
                Some(line) if continues(line) => self.card.extend(line, true),
                _ => return Ok(Some(&self.card)),
            }
        }
    }

    /// Goes to the next line that belongs to a card.
    fn advance(&mut self) -> Result<(), Fault> {
        loop {
            self.next = None;
            if !self.deck.advance()? {
                return Ok(());
            }
            let line = self.deck.line();
            let end = line.iter().position(|&b| b == b'$').unwrap_or(line.len());
            let (card, comment) = line.split_at(end);
            if comment.len() > 8 {
                self.comments.push(comment.to_vec());
            }
            let card = card.trim_ascii_end();
            let word = card.trim_ascii_start().to_ascii_uppercase();
            if word.starts_with(b"ENDDATA") {
                if !self.deck.leave() {
                    return Ok(());
                }
            } else if word.starts_with(b"INCLUDE") {
                let name = card.trim_ascii_start()[b"INCLUDE".len()..].to_vec();
                self.include(name)?;
            } else if word.starts_with(b"BEGIN") && word.windows(5).any(|w| w == b"SUPER") {
                return Err(self.deck.fault("superelements are not read; write one bulk data section"));
            } else if !word.is_empty() && !word.starts_with(b"BEGIN") {
                self.next = Some(expanded(card));
                return Ok(());
            }
        }
    }

    /// Goes on in a file; a name in quotes may go on in the next lines.
    fn include(&mut self, mut name: Vec<u8>) -> Result<(), Fault> {
        let quoted = name.trim_ascii_start().starts_with(b"'");
        let closed = |name: &[u8]| name.iter().filter(|&&b| b == b'\'').count() >= 2;
        while quoted && !closed(&name) && name.len() < 4096 && self.deck.advance()? {
            name.extend_from_slice(self.deck.line().trim_ascii());
        }
        let text = crate::input::text(&name);
        self.deck.include(text.trim().trim_matches(['\'', '"']))
    }
}

/// Whether a line goes on with the card before it.
fn continues(line: &[u8]) -> bool {
    let name = fields(line, SMALL).next().unwrap_or_default();
    matches!(name.first(), None | Some(b'+' | b'*')) && !name.starts_with(b"*(")
}

/// A line with blanks for its tabs, which go to every eighth column.
fn expanded(line: &[u8]) -> Vec<u8> {
    let mut wide = Vec::with_capacity(line.len());
    for &byte in line {
        match byte {
            b'\t' => wide.resize(wide.len() / 8 * 8 + 8, b' '),
            _ => wide.push(byte),
        }
    }
    wide
}
