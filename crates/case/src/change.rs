//! Values given by the paths of their keys, which change the text of a case before it is checked.
//!
//! A changed case is TOML again, comments kept, so what is checked, run and kept beside the results is a case file like any
//! other, and every check, unit and suggestion is that of the file.

mod edit;
mod layout;
mod text;

pub(crate) use text::Changed;

use toml::de::DeValue;

use crate::key_path;

/// A value in place of the one that a case has at a key, or in addition to those that it has.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// The path of the key: `material.rock.young`, `dynamic.sides`. Entries of lists go by their number from 0, by their `name`,
    /// or all together: `stage[0].release`, `stage[bench 1].release`, `stage[*].release`. A key or name with a dot or a bracket
    /// stands in quotes: `material."rock.a".young`.
    pub key: String,
    /// The value as it is written in a case, `"25 GPa"`, `0.4`, `{ x = 0.8, y = 0.8 }`; what is no value of TOML is a text.
    pub value: String,
    /// How it was given, for messages, which show this in place of a line of the file.
    pub given: String,
}

/// Characters of a change that messages show at most.
const SHOWN: usize = 200;

impl Change {
    pub fn new(key: impl Into<String>, value: impl Into<String>) -> Change {
        let (key, value) = (key.into(), value.into());
        let given = format!("{key}={value}");
        Change { key, value, given }
    }

    /// A change as it is given to an option of a command: `KEY=VALUE`.
    ///
    /// # Errors
    /// The text has no `=`.
    pub fn of_option(option: &str, text: &str) -> Result<Change, String> {
        let Some(at) = key_path::equals_sign(text) else {
            return Err(format!("{option} {text}: write KEY=VALUE, such as material.rock.young=\"25 GPa\""));
        };
        let given = format!("{option} {text}");
        Ok(Change { given, ..Change::new(text[..at].trim(), text[at + 1..].trim()) })
    }

    /// The value as TOML.
    fn toml(&self) -> String {
        let value = self.value.trim();
        match DeValue::parse(value) {
            // A comment would hide what stands behind it.
            Ok(parsed) if parsed.span() == (0..value.len()) => value.to_owned(),
            _ => key_path::quoted(value),
        }
    }

    /// How it was given, on one line.
    fn shown(&self) -> String {
        let line = self.given.split_whitespace().collect::<Vec<_>>().join(" ");
        match line.char_indices().nth(SHOWN) {
            Some((end, _)) => format!("{} …", &line[..end]),
            None => line,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_is_toml_or_else_a_text() {
        for (given, toml) in [
            ("0.4", "0.4"),
            (" true ", "true"),
            ("[\"a\", \"b\"]", "[\"a\", \"b\"]"),
            ("{ x = 0.8, y = 0.8 }", "{ x = 0.8, y = 0.8 }"),
            ("\"25 GPa\"", "\"25 GPa\""),
            ("'C:\\a'", "'C:\\a'"),
            ("25 GPa", "\"25 GPa\""),
            ("free-field", "\"free-field\""),
            ("", "\"\""),
            ("0.4 # less", "\"0.4 # less\""),
            ("1\nyoung = 2", "\"1\\u000Ayoung = 2\""),
            ("[\"a\"", "\"[\\\"a\\\"\""),
        ] {
            assert_eq!(Change::new("a", given).toml(), toml, "{given}");
        }
    }

    #[test]
    fn an_option_is_split_at_its_equals_sign() {
        let change = Change::of_option("--set", "stage[a=b].\"c=d\" = { x = 1 }").expect("good");
        assert_eq!((change.key.as_str(), change.value.as_str()), ("stage[a=b].\"c=d\"", "{ x = 1 }"));
        assert_eq!(change.shown(), "--set stage[a=b].\"c=d\" = { x = 1 }");
        let fault = Change::of_option("--set", "young").expect_err("no value");
        assert!(fault.contains("--set young: write KEY=VALUE"), "{fault}");
    }
}
