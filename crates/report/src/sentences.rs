//! Sentences one behind the other.

use crate::language::Language;

/// As a paragraph: Chinese sets no space between sentences.
pub fn joined(language: Language, sentences: &[String]) -> String {
    sentences.join(if language == Language::Chinese { "" } else { " " })
}
