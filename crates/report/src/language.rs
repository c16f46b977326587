//! The language of the page.

use std::collections::HashMap;
use std::fmt::Display;
use std::str::FromStr;
use std::sync::LazyLock;

use tremolite_results::Said;
use tremolite_results::said::filled;

use crate::chinese::TABLES;

/// Pattern in English → in Chinese.
static CHINESE: LazyLock<HashMap<&'static str, &'static str>> =
    LazyLock::new(|| TABLES.iter().flat_map(|table| table.iter().copied()).collect());

/// The language of the page. The code speaks English; other languages have a pattern for each of its patterns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// Chinese, in simplified characters.
    Chinese,
}

impl FromStr for Language {
    type Err = String;

    /// `en` or `zh`.
    fn from_str(code: &str) -> Result<Self, String> {
        match code {
            "en" => Ok(Language::English),
            "zh" => Ok(Language::Chinese),
            other => Err(format!("there is no page in the language '{other}': en and zh are known")),
        }
    }
}

impl Language {
    /// As BCP 47 has it.
    pub(crate) fn code(self) -> &'static str {
        match self {
            Language::English => "en",
            Language::Chinese => "zh-CN",
        }
    }

    /// The pattern in this language; nothing where it has none, as for texts of a program's own observers.
    pub(crate) fn known(self, english: &str) -> Option<&str> {
        match self {
            Language::English => None,
            Language::Chinese => CHINESE.get(english).copied(),
        }
    }

    /// Sentences as a paragraph: Chinese sets no space between them.
    pub(crate) fn joined(self, sentences: &[String]) -> String {
        sentences.join(if self == Language::Chinese { "" } else { " " })
    }

    /// The pattern in this language; in English where it has none.
    pub(crate) fn pattern(self, english: &str) -> &str {
        match self {
            Language::English => english,
            Language::Chinese => CHINESE.get(english).copied().unwrap_or(english),
        }
    }

    /// Whether it has all patterns of a sentence.
    pub fn knows(self, said: &Said) -> bool {
        self == Language::English || said.all(&|english| self.known(english).is_some())
    }

    /// A sentence of a result file.
    pub(crate) fn tell(self, said: &Said) -> String {
        said.set(&|english| self.pattern(english).to_owned())
    }

    /// A sentence of a result file as plain text, or the English beside it where this language lacks a pattern of it.
    pub(crate) fn tell_or(self, said: &Said, english: &str) -> String {
        if said.is_empty() || !self.knows(said) { english.to_owned() } else { self.tell(said) }
    }

    /// A pattern with its slots filled. By the macro `say!`.
    pub(crate) fn fill(self, english: &str, slots: &[(&str, &dyn Display)]) -> String {
        let slot =
            |name: &str| slots.iter().find(|(known, _)| *known == name).map(|(_, value)| value.to_string());
        filled(self.pattern(english), slot)
    }
}

/// `say!(language, "largest: {name} at {time}", name = name, time = moment)`: a text in the page's language. Every pattern
/// stands in a table of [`chinese`](crate::chinese) as well, with the same slots; a test goes over all of them.
macro_rules! say {
    ($language:expr, $pattern:literal $(, $slot:ident = $value:expr)* $(,)?) => {
        $language.fill($pattern, &[$((stringify!($slot), &$value as &dyn ::std::fmt::Display)),*])
    };
}
pub(crate) use say;
