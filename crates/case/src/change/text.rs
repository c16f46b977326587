//! The text of a changed case, each piece with where it comes from.

use std::collections::BTreeSet;
use std::ops::Range;

use super::Change;
use super::edit::{self, Edit, Fault};
use crate::{Diagnostic, report};

/// A text of which some pieces stand in the file and others come from changes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Changed {
    /// The file's text.
    pub original: String,
    pub changes: Vec<Change>,
    /// The text with all changes that could be made.
    pub text: String,
    /// One after the other they make the text.
    pieces: Vec<Piece>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece {
    length: usize,
    from: From,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum From {
    /// The original, from this byte on.
    File(usize),
    /// The change of this number.
    Change(usize),
}

impl Changed {
    /// The text with the changes made in their order, and the problems of those that cannot be made. A text that is no TOML
    /// stays as it is.
    pub fn new(original: &str, changes: &[Change]) -> (Changed, Vec<Diagnostic>) {
        let piece = Piece { length: original.len(), from: From::File(0) };
        let mut changed = Changed {
            original: original.to_owned(),
            changes: changes.to_vec(),
            text: original.to_owned(),
            pieces: vec![piece],
        };
        let mut problems = Vec::new();
        for (number, change) in changes.iter().enumerate() {
            if let Err(Fault { message, remedy }) = changed.make(number, change) {
                let mut problem = Diagnostic::new(0..0, message, remedy);
                problem.key.clone_from(&change.key);
                problem.set = Some(change.shown().into());
                problems.push(problem);
            }
        }
        (changed, problems)
    }

    fn make(&mut self, number: usize, change: &Change) -> Result<(), Fault> {
        loop {
            let (edits, again) = match edit::edits(&self.text, change)? {
                Edit::Done(edits) => (edits, false),
                Edit::First(edits) => (edits, true),
            };
            // From the back, so that places before stay.
            for (place, with) in edits.into_iter().rev() {
                self.splice(place, &with, number);
            }
            if !again {
                return Ok(());
            }
        }
    }

    fn splice(&mut self, place: Range<usize>, with: &str, number: usize) {
        self.text.replace_range(place.clone(), with);
        let new = Piece { length: with.len(), from: From::Change(number) };
        let mut pieces = Vec::new();
        let (mut start, mut placed) = (0, false);
        for piece in &self.pieces {
            let end = start + piece.length;
            let cut = |part: Range<usize>| {
                let from = match piece.from {
                    From::File(at) => From::File(at + part.start.saturating_sub(start)),
                    from => from,
                };
                (!part.is_empty()).then_some(Piece { length: part.len(), from })
            };
            pieces.extend(cut(start..end.min(place.start)));
            if !placed && end >= place.start {
                placed = true;
                pieces.push(new);
            }
            pieces.extend(cut(start.max(place.end)..end));
            start = end;
        }
        self.pieces = pieces;
    }

    /// Problems in the changed text as problems of the file and of the changes.
    pub fn placed(&self, mut problems: Vec<Diagnostic>) -> Vec<Diagnostic> {
        if self.changes.is_empty() {
            return problems;
        }
        report::find_keys(&self.text, &mut problems);
        for problem in problems.iter_mut().filter(|problem| problem.set.is_none()) {
            let last = problem.span.end.saturating_sub(1).max(problem.span.start);
            let (first, last) = (self.origin(problem.span.start), self.origin(last));
            if let (From::Change(a), From::Change(b)) = (first.0, last.0)
                && a == b
            {
                problem.set = Some(self.changes[a].shown().into());
            }
            let end = if let From::File(_) = last.0 { last.1 + 1 } else { last.1 };
            problem.span = first.1..end.max(first.1);
        }
        // A value for all entries of a list is wrong in each of them.
        let mut told = BTreeSet::new();
        problems.retain(|p| p.set.is_none() || told.insert((p.set.clone(), p.message.clone())));
        problems
    }

    /// Where the piece with this byte of the text comes from, and the byte of the original there, or behind which the piece
    /// stands.
    fn origin(&self, byte: usize) -> (From, usize) {
        let (mut start, mut before) = (0, 0);
        let mut last = From::File(0);
        for piece in &self.pieces {
            last = piece.from;
            if let From::File(at) = piece.from {
                if byte < start + piece.length {
                    return (last, at + byte - start);
                }
                before = at + piece.length;
            } else if byte < start + piece.length {
                return (last, before);
            }
            start += piece.length;
        }
        (last, before)
    }
}
