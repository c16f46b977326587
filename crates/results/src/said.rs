//! Sentences that can be set in another language: a pattern in English with named slots, and what fills them.

use std::fmt;

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

/// A sentence, or a part of one. Numbers in slots are set as they are to be read, with their unit.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Said {
    /// English, with `{slot}` where something is put in.
    pub pattern: String,
    /// Slot → what stands there.
    #[serde(skip_serializing_if = "IndexMap::is_empty")]
    pub slots: IndexMap<String, Slot>,
}

/// What stands in a slot.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Slot {
    /// A number or a name, the same in all languages.
    Text(String),
    /// Sentences, one behind the other without a space.
    Said(Vec<Said>),
}

impl Said {
    /// A sentence without slots.
    pub fn plain(pattern: &str) -> Self {
        Said { pattern: pattern.into(), slots: IndexMap::new() }
    }

    /// Whether it says nothing, as in files that know of no patterns.
    pub fn is_empty(&self) -> bool {
        self.pattern.is_empty()
    }

    /// Whether `known` holds of its own pattern and of all in its slots.
    pub fn all(&self, known: &impl Fn(&str) -> bool) -> bool {
        let parts = |slot: &Slot| match slot {
            Slot::Text(_) => true,
            Slot::Said(parts) => parts.iter().all(|part| part.all(known)),
        };
        (self.is_empty() || known(&self.pattern)) && self.slots.values().all(parts)
    }

    /// The same with what stands in a slot.
    pub fn with(mut self, slot: &str, value: impl Into<Slot>) -> Self {
        self.slots.insert(slot.into(), value.into());
        self
    }

    /// The sentence in the language that has `pattern_of` of each English pattern.
    pub fn set(&self, pattern_of: &impl Fn(&str) -> String) -> String {
        let slot = |name: &str| {
            self.slots.get(name).map(|slot| match slot {
                Slot::Text(text) => text.clone(),
                Slot::Said(parts) => parts.iter().map(|part| part.set(pattern_of)).collect(),
            })
        };
        filled(&pattern_of(&self.pattern), slot)
    }
}

impl fmt::Display for Said {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.set(&str::to_owned))
    }
}

/// A pattern with its slots filled; one that nothing fills stays as it is.
pub fn filled(pattern: &str, slot: impl Fn(&str) -> Option<String>) -> String {
    let mut out = String::with_capacity(pattern.len());
    let mut rest = pattern;
    while let Some((before, behind)) = rest.split_once('{') {
        out.push_str(before);
        let found = behind.split_once('}').and_then(|(name, after)| Some((slot(name)?, after)));
        match found {
            Some((value, after)) => {
                out.push_str(&value);
                rest = after;
            }
            None => {
                out.push('{');
                rest = behind;
            }
        }
    }
    out.push_str(rest);
    out
}

impl From<String> for Slot {
    fn from(text: String) -> Self {
        Slot::Text(text)
    }
}

impl From<&str> for Slot {
    fn from(text: &str) -> Self {
        Slot::Text(text.into())
    }
}

impl From<&String> for Slot {
    fn from(text: &String) -> Self {
        Slot::Text(text.clone())
    }
}

impl From<Said> for Slot {
    fn from(said: Said) -> Self {
        Slot::Said(vec![said])
    }
}

impl From<Vec<Said>> for Slot {
    fn from(parts: Vec<Said>) -> Self {
        Slot::Said(parts)
    }
}

/// `said!("bolt {bolt} of {group}", bolt = 3.to_string(), group = name)`: a [`Said`]. Slots may be texts or other sentences.
#[macro_export]
macro_rules! said {
    ($pattern:literal $(, $slot:ident = $value:expr)* $(,)?) => {
        $crate::Said::plain($pattern)$(.with(stringify!($slot), $value))*
    };
}

#[cfg(test)]
mod tests {

    #[test]
    fn a_sentence_is_filled_and_its_parts_are_set_in_the_same_language() {
        let inner = said!("bolt {bolt} of {group}", bolt = "3", group = "a {b}");
        let whole = said!("{place}: slid {slip}", place = inner, slip = 4.to_string());
        assert_eq!(whole.to_string(), "bolt 3 of a {b}: slid 4");
        let other = |english: &str| match english {
            "bolt {bolt} of {group}" => "{group}: {bolt}".to_owned(),
            other => other.to_owned(),
        };
        assert_eq!(whole.set(&other), "a {b}: 3: slid 4");
        assert_eq!(said!("an open { and {none}").to_string(), "an open { and {none}");
        assert!(whole.all(&|pattern| pattern.starts_with("bolt") || pattern.starts_with('{')));
        assert!(!whole.all(&|pattern| pattern.starts_with('{')), "a part is not known");
    }
}
