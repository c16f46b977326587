//! Columns of a state, which one process holds, or of which one of several ranks holds its own members' part.

use std::io::{self, BufRead, Seek};
use std::ops::Range;
use tremolite_engine::assembly::Assembly;
use tremolite_engine::ranks::RangeOf;
use tremolite_engine::state::StateColumn;
use tremolite_engine::{Ranks, ranks};
use tremolite_laws::{Octet, Row};

/// Numbers that are sent at once at most, unless one member has more: 8 MB.
const AT_ONCE: usize = 1 << 20;

/// Who has what of a state's columns: one process, or ranks with what their assemblies hold.
pub struct Among<'a>(pub Option<(&'a Ranks, &'a Assembly)>);

impl Among<'_> {
    /// Whether this process writes.
    pub(super) fn is_first(&self) -> bool {
        self.0.is_none_or(|(ranks, _)| ranks.is_first())
    }

    /// The slices of a column of members, and numbers of each of its items, where several ranks have it.
    fn shared(&self, name: &str) -> Option<(&Ranks, &Assembly, usize, RangeOf)> {
        let (ranks, assembly) = self.0?;
        let (width, range) = ranks::of_members(name)?;
        Some((ranks, assembly, width, range))
    }

    /// Numbers of a column that all ranks have together.
    pub(super) fn values(&self, name: &str, column: &StateColumn) -> usize {
        match self.shared(name) {
            Some((_, assembly, width, range)) if values(column) > 0 || !may_be_missing(column) => {
                width * range(&assembly.totals()).end
            }
            _ => values(column),
        }
    }

    /// Rows that this process has of as many of a column that may be missing.
    pub(super) fn rows(&self, name: &str, all: usize) -> usize {
        match self.shared(name) {
            // One more says that it is there (`KEPT`).
            Some((_, assembly, _, range)) if all > 0 => range(&assembly.held_totals()).end + 1,
            _ => all,
        }
    }

    /// Gives the numbers of a column, in pieces, to the first rank.
    pub(super) fn put(
        &self,
        name: &str,
        column: &StateColumn,
        put: &mut dyn FnMut(&[u8]) -> io::Result<()>,
    ) -> io::Result<()> {
        let Some((ranks, assembly, width, range)) = self.shared(name) else {
            return in_pieces(column, put);
        };
        if values(column) == 0 && may_be_missing(column) {
            return Ok(());
        }
        let own = |held: Range<usize>, words: &mut Vec<f64>| match column {
            StateColumn::Numbers(n) => words.extend_from_slice(&n[held]),
            StateColumn::Rows(r) | StateColumn::SomeRows(r) => words.extend(r[held].iter().flat_map(|r| r.0)),
            StateColumn::Octets(o) => words.extend(o[held].iter().flat_map(|o| o.0)),
            StateColumn::Scalars(_) | StateColumn::Count(_) => {}
        };
        let mut bytes = Vec::new();
        ranks.stream(assembly, (width, range), AT_ONCE, own, |words| {
            bytes.clear();
            bytes.extend(words.iter().flat_map(|x| x.to_bits().to_le_bytes()));
            put(&bytes)
        })
    }

    /// Takes the numbers of a column from a file, of which other ranks' are left out.
    pub(super) fn take(
        &self,
        name: &str,
        column: StateColumn,
        file: &mut (impl BufRead + Seek),
    ) -> io::Result<()> {
        let Some((_, assembly, width, range)) = self.shared(name) else { return whole(column, file) };
        if values(&column) == 0 && may_be_missing(&column) {
            return Ok(());
        }
        let mut column = column;
        for (m, (all, held)) in assembly.slices.iter().zip(&assembly.held).enumerate() {
            let held = range(held);
            match assembly.has(m) {
                true => take_range(&mut column, held, file)?,
                false => file.seek_relative(8 * (width * range(all).len()) as i64)?,
            }
        }
        if let StateColumn::SomeRows(rows) = column
            && let Some(last) = rows.last_mut()
        {
            *last = tremolite_engine::assembly::KEPT;
        }
        Ok(())
    }
}

fn may_be_missing(column: &StateColumn) -> bool {
    matches!(column, StateColumn::SomeRows(_))
}

/// Numbers that this process has of a column.
fn values(column: &StateColumn) -> usize {
    match column {
        StateColumn::Count(_) => 1,
        StateColumn::Scalars(s) => s.len(),
        StateColumn::Numbers(n) => n.len(),
        StateColumn::Rows(r) | StateColumn::SomeRows(r) => 4 * r.len(),
        StateColumn::Octets(o) => 8 * o.len(),
    }
}

/// Gives the numbers of a column that this process has as a whole.
fn in_pieces(column: &StateColumn, put: &mut dyn FnMut(&[u8]) -> io::Result<()>) -> io::Result<()> {
    let mut bytes = Vec::new();
    let mut some = |words: &mut dyn Iterator<Item = u64>| {
        bytes.clear();
        words.for_each(|word| bytes.extend(word.to_le_bytes()));
        put(&bytes)
    };
    match column {
        StateColumn::Count(c) => some(&mut std::iter::once(**c)),
        StateColumn::Scalars(s) => some(&mut s.iter().map(|x| x.to_bits())),
        StateColumn::Numbers(n) => {
            n.chunks(AT_ONCE).try_for_each(|part| some(&mut part.iter().map(|x| x.to_bits())))
        }
        StateColumn::Rows(r) | StateColumn::SomeRows(r) => r
            .chunks(AT_ONCE / 4)
            .try_for_each(|part| some(&mut part.iter().flat_map(|r| r.0.map(f64::to_bits)))),
        StateColumn::Octets(o) => o
            .chunks(AT_ONCE / 8)
            .try_for_each(|part| some(&mut part.iter().flat_map(|o| o.0.map(f64::to_bits)))),
    }
}

fn number(file: &mut impl BufRead) -> io::Result<u64> {
    let mut word = [0; 8];
    file.read_exact(&mut word)?;
    Ok(u64::from_le_bytes(word))
}

fn whole(column: StateColumn, file: &mut impl BufRead) -> io::Result<()> {
    match column {
        StateColumn::Count(c) => *c = number(file)?,
        StateColumn::Scalars(s) => {
            for x in s {
                *x = f64::from_bits(number(file)?);
            }
        }
        mut column => {
            let items = match &column {
                StateColumn::Numbers(n) => n.len(),
                StateColumn::Rows(r) | StateColumn::SomeRows(r) => r.len(),
                StateColumn::Octets(o) => o.len(),
                StateColumn::Count(_) | StateColumn::Scalars(_) => 0,
            };
            take_range(&mut column, 0..items, file)?;
        }
    }
    Ok(())
}

/// Takes some items of a column of numbers, rows or octets.
fn take_range(column: &mut StateColumn, range: Range<usize>, file: &mut impl BufRead) -> io::Result<()> {
    let take = |x: &mut f64| -> io::Result<()> {
        *x = f64::from_bits(number(file)?);
        Ok(())
    };
    match column {
        StateColumn::Numbers(n) => n[range].iter_mut().try_for_each(take),
        StateColumn::Rows(r) | StateColumn::SomeRows(r) => {
            r[range].iter_mut().flat_map(|Row(r)| r).try_for_each(take)
        }
        StateColumn::Octets(o) => o[range].iter_mut().flat_map(|Octet(o)| o).try_for_each(take),
        StateColumn::Scalars(_) | StateColumn::Count(_) => Ok(()),
    }
}
