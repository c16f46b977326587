//! Paths of keys: `material.rock.young`, `stage[0].release`, `interface[lining-rock].friction`, `stage[*].release`.

use toml::de::DeValue;

/// One step of a path.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Part {
    /// A key of a table.
    Key(String),
    /// An entry of a list, from 0.
    Number(usize),
    /// The entry of a list of tables that has this `name`.
    Name(String),
    /// Every entry of a list.
    All,
}

/// Where a text of the form KEY=VALUE has its `=`: the first that no quotes and no brackets hold.
pub(crate) fn equals_sign(text: &str) -> Option<usize> {
    let (mut quote, mut escaped, mut bracket) = (None, false, false);
    // A quotation mark within a word is a letter of it.
    let mut begins = true;
    for (at, c) in text.char_indices() {
        match (quote, c) {
            (Some(_), _) if escaped => escaped = false,
            (Some('"'), '\\') => escaped = true,
            (Some(q), c) if q == c => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') if begins => quote = Some(c),
            (None, '[') => bracket = true,
            (None, ']') => bracket = false,
            (None, '=') if !bracket => return Some(at),
            _ => {}
        }
        begins = matches!(c, '.' | '[') || (begins && c.is_whitespace());
    }
    None
}

/// The parts of a path, a key first.
///
/// # Errors
/// What is wrong with it.
pub(crate) fn parse(path: &str) -> Result<Vec<Part>, String> {
    let mut parts = Vec::new();
    let mut rest = path.trim();
    loop {
        let (key, quoted, after) = word(rest, &['.', '[', ']'])?;
        if key.is_empty() && !quoted {
            return Err("a key is empty".to_owned());
        }
        parts.push(Part::Key(key));
        rest = after;
        while let Some(inside) = rest.strip_prefix('[') {
            let (name, quoted, after) = word(inside, &[']'])?;
            rest = after.strip_prefix(']').ok_or("a bracket is not closed")?.trim_start();
            parts.push(match name.parse() {
                _ if !quoted && name == "*" => Part::All,
                Ok(number) if !quoted && is_number(&name) => Part::Number(number),
                _ if name.is_empty() => return Err("brackets are empty".to_owned()),
                _ => Part::Name(name),
            });
        }
        if rest.is_empty() {
            return Ok(parts);
        }
        rest = rest.strip_prefix('.').ok_or_else(|| format!("`{rest}` follows without a dot"))?.trim_start();
    }
}

/// The word that a text begins with, up to one of `ends` or to its closing quotation mark; whether it is quoted; what follows.
fn word<'a>(text: &'a str, ends: &[char]) -> Result<(String, bool, &'a str), String> {
    let Some(quote) = text.chars().next().filter(|c| ['"', '\''].contains(c)) else {
        let (word, rest) = text.split_at(text.find(ends).unwrap_or(text.len()));
        return Ok((word.trim().to_owned(), false, rest));
    };
    let mut escaped = false;
    let end = text[1..].find(|c| {
        let closes = c == quote && !escaped;
        escaped = c == '\\' && quote == '"' && !escaped;
        closes
    });
    let end = end.ok_or("a quotation mark is not closed")? + 2;
    let (word, rest) = text.split_at(end);
    let parsed = DeValue::parse(word).map_err(|e| e.message().to_owned())?;
    Ok((parsed.get_ref().as_str().unwrap_or_default().to_owned(), true, rest.trim_start()))
}

fn is_number(name: &str) -> bool {
    !name.is_empty() && name.bytes().all(|b| b.is_ascii_digit())
}

/// The path of a key of the table at `path`.
pub(crate) fn below(path: &str, key: &str) -> String {
    let plain = !key.is_empty() && key == key.trim() && !key.contains(['.', '[', ']', '=', '"', '\'']);
    let key = if plain { key.to_owned() } else { quoted(key) };
    if path.is_empty() { key } else { format!("{path}.{key}") }
}

/// The name of an entry as it stands within the brackets of a path.
pub(crate) fn entry(name: &str) -> String {
    let plain =
        name == name.trim() && !is_number(name) && name != "*" && !name.contains([']', '[', '"', '\'', '=']);
    if plain { name.to_owned() } else { quoted(name) }
}

/// A text in double quotes, as in TOML.
pub(crate) fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() => quoted += &format!("\\u{:04X}", u32::from(c)),
            c => quoted.push(c),
        }
    }
    quoted + "\""
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(name: &str) -> Part {
        Part::Key(name.to_owned())
    }

    #[test]
    fn paths_are_taken_apart() {
        let name = |name: &str| Part::Name(name.to_owned());
        for (path, parts) in [
            ("dynamic.sides", vec![key("dynamic"), key("sides")]),
            ("stage[*].release", vec![key("stage"), Part::All, key("release")]),
            ("stage[12].release", vec![key("stage"), Part::Number(12), key("release")]),
            ("stage[bench 1].release", vec![key("stage"), name("bench 1"), key("release")]),
            ("stage[\"1\"].bolts[0]", vec![key("stage"), name("1"), key("bolts"), Part::Number(0)]),
            ("stage[a.b=c]", vec![key("stage"), name("a.b=c")]),
            ("material.\"rock.a\".young", vec![key("material"), key("rock.a"), key("young")]),
            ("material.'a\"b'", vec![key("material"), key("a\"b")]),
            (" material . rock ", vec![key("material"), key("rock")]),
        ] {
            assert_eq!(parse(path), Ok(parts), "{path}");
        }
        for (path, says) in [
            ("", "empty"),
            ("a..b", "empty"),
            ("a.", "empty"),
            ("stage[1", "not closed"),
            ("stage[]", "empty"),
            ("stage[1]release", "without a dot"),
            ("a.\"b", "not closed"),
            ("a]", "without a dot"),
        ] {
            let fault = parse(path).expect_err(path);
            assert!(fault.contains(says), "{path}: {fault}");
        }
    }

    #[test]
    fn written_paths_are_read_as_they_were_meant() {
        for text in ["rock", "rock.a", "a b", "a\"b", "a\\b", "围岩", "", "a=b", " a", "a[0]", "\n"] {
            let path = below("material", text);
            assert_eq!(parse(&path), Ok(vec![key("material"), key(text)]), "{path}");
            assert_eq!(equals_sign(&format!("{path}=1")), Some(path.len()), "{path}");
        }
        assert_eq!(equals_sign("stage[5' wall].release=1"), Some(22));
        for text in ["bench 1", "1", "*", "a]b", "a=b", "a.b", "a'b", "10 m"] {
            let path = format!("stage[{}]", entry(text));
            assert_eq!(parse(&path), Ok(vec![key("stage"), Part::Name(text.to_owned())]), "{path}");
        }
    }
}
