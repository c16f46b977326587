//! Values of TOML on one line: comments, spaces and headers gone, keys in alphabetical order. Equal values have equal texts,
//! but for how a number or text is spelt.

use toml::de::{DeTable, DeValue};

use crate::key_path;

/// The value on one line; `source` is the text that it was parsed from.
pub(crate) fn value(source: &str, written: &toml::Spanned<DeValue<'_>>) -> String {
    match written.get_ref() {
        DeValue::Table(inner) => table(source, inner, &[]),
        DeValue::Array(values) => {
            let values: Vec<String> = values.iter().map(|v| value(source, v)).collect();
            format!("[{}]", values.join(", "))
        }
        DeValue::String(text) => key_path::quoted(text),
        _ => source.get(written.span()).unwrap_or_default().trim().to_owned(),
    }
}

/// The table in braces, without the keys of `without`.
pub(crate) fn table(source: &str, written: &DeTable<'_>, without: &[&str]) -> String {
    let entries: Vec<String> = entries(source, written)
        .into_iter()
        .filter(|(name, _)| !without.contains(&name.as_str()))
        .map(|(name, value)| format!("{} = {value}", key(&name)))
        .collect();
    if entries.is_empty() { "{}".to_owned() } else { format!("{{ {} }}", entries.join(", ")) }
}

/// The keys of a table with their values on one line each.
pub(crate) fn entries(source: &str, written: &DeTable<'_>) -> Vec<(String, String)> {
    written.iter().map(|(name, v)| (name.get_ref().to_string(), value(source, v))).collect()
}

/// A key as TOML.
pub(crate) fn key(name: &str) -> String {
    let bare = !name.is_empty() && name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_' || b == b'-');
    if bare { name.to_owned() } else { key_path::quoted(name) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headers_comments_and_spaces_change_nothing() {
        let spread =
            "# of a case\n[b]\nx   = 1 # one\n[[b.list]]\nname = 'a\"b'\n[a.\"c d\"]\ny = [ 1,\n 2 ]\n";
        let short = "a = { \"c d\" = { y = [1, 2] } }\nb = { list = [{ name = \"a\\\"b\" }], x = 1 }";
        let bare = |source: &str| table(source, DeTable::parse(source).unwrap().get_ref(), &[]);
        assert_eq!(bare(spread), bare(short));
        assert_eq!(
            bare(spread),
            "{ a = { \"c d\" = { y = [1, 2] } }, b = { list = [{ name = \"a\\\"b\" }], x = 1 } }"
        );
        let document = DeTable::parse(spread).unwrap();
        assert_eq!(table(spread, document.get_ref(), &["a", "b"]), "{}");
    }
}
