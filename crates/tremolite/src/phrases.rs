//! Phrases one behind the other, as each language joins them.

use tremolite_results::{Said, said};

/// Sentences.
pub fn sentences(parts: impl IntoIterator<Item = Said>) -> Said {
    join(parts, |first, rest| said!("{first} {rest}", first = first, rest = rest))
}

/// Parts of a sentence, with commas.
pub fn listed(parts: impl IntoIterator<Item = Said>) -> Said {
    join(parts, |first, rest| said!("{first}, {rest}", first = first, rest = rest))
}

/// Clauses, with semicolons.
pub fn clauses(parts: impl IntoIterator<Item = Said>) -> Said {
    join(parts, |first, rest| said!("{first}; {rest}", first = first, rest = rest))
}

fn join(parts: impl IntoIterator<Item = Said>, both: impl Fn(Said, Said) -> Said) -> Said {
    parts.into_iter().reduce(both).unwrap_or_default()
}
