//! Words of a file in messages.

use std::borrow::Cow;

/// A word of a file as a message may show it: short and printable.
pub(crate) fn shown(word: &str) -> Cow<'_, str> {
    if word.chars().count() <= 40 && !word.chars().any(char::is_control) {
        return Cow::Borrowed(word);
    }
    let mut short: String =
        word.chars().take(40).map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect();
    short.push('…');
    Cow::Owned(short)
}
