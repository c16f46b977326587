//! The data lines of sets and surfaces.

use super::deck::{Deck, Label};
use super::part::{Entry, Set, Target};
use crate::fault::Fault;
use crate::input::whole;

/// A data line of a set.
pub(super) fn members(
    deck: &Deck,
    set: &mut Set,
    instance: Option<&str>,
    generate: bool,
) -> Result<(), Fault> {
    let line = deck.line_number();
    if generate {
        let mut range = [0, 0, 1];
        let mut count = 0;
        for (place, field) in range.iter_mut().zip(deck.fields()) {
            *place = deck.number(field, "a number of a range")?;
            count += 1;
        }
        if count < 2 || range[1] < range[0] || range[2] == 0 {
            return Err(
                deck.fault("a range needs a first and a last number, ascending, and a step if it is not 1")
            );
        }
        let target = Target::Range(range[0], range[1], range[2]);
        set.entries.push(Entry { instance: instance.map(str::to_owned), target, face: String::new(), line });
        return Ok(());
    }
    for field in deck.fields().filter(|f| !f.is_empty()) {
        match whole(field) {
            Some(number) => set.push(instance, number, line),
            None => set.entries.push(named(field, instance, line)),
        }
    }
    Ok(())
}

/// An entry such as `rock`, `Part-1-1.rock` or `Part-1-1.7`.
fn named(field: &[u8], instance: Option<&str>, line: usize) -> Entry {
    let text = crate::input::text(field);
    let (instance, name) = match (instance, text.split_once('.')) {
        (None, Some((instance, name))) if !text.starts_with('"') => {
            (Some(Label::new(instance).key), name.to_owned())
        }
        _ => (instance.map(str::to_owned), text.clone()),
    };
    let target = match whole(name.trim().as_bytes()) {
        Some(number) => Target::Range(number, number, 1),
        None => Target::Set(Label::new(&name).key),
    };
    Entry { instance, target, face: String::new(), line }
}

/// A data line of a surface.
pub(super) fn surface_entry(deck: &Deck, surface: &mut Set) -> Result<(), Fault> {
    let mut fields = deck.fields();
    let first = fields.next().unwrap_or_default();
    if first.is_empty() {
        return Err(deck.fault("the surface needs an element or element set here"));
    }
    let mut entry = named(first, None, deck.line_number());
    entry.face = crate::input::text(fields.next().unwrap_or_default()).to_uppercase();
    surface.entries.push(entry);
    Ok(())
}
