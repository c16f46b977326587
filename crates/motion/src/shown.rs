//! Words of a file and times in messages.

use std::borrow::Cow;

/// A time (s) to a microsecond, without the round-off of sums.
pub(crate) fn rounded(time: f64) -> f64 {
    let tidy = (time * 1e6).round() / 1e6;
    if tidy.is_finite() { tidy } else { time }
}

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
