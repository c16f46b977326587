//! TOML itself: text to a tree of values with their places.

use std::ops::Range;
use std::path::Path;

use toml::Spanned;
use toml::de::{DeTable, Error};

use crate::{Diagnostic, Report};

/// The text of a file; `what` it is called in messages.
pub(crate) fn read(path: &Path, what: &str) -> Result<String, Report> {
    let unreadable = |fault: String, remedy: String| {
        Report::new(path, "", vec![Diagnostic::new(0..0, format!("{}: {fault}", path.display()), remedy)])
    };
    let bytes = std::fs::read(path)
        .map_err(|e| unreadable(format!("cannot be read, {e}"), format!("check the path of the {what}")))?;
    String::from_utf8(bytes)
        .map_err(|_| unreadable("is not UTF-8 text".to_owned(), format!("save the {what} as UTF-8 text")))
}

/// Parses the text, or reports every place that is not TOML.
pub(crate) fn parse(source: &str) -> Result<Spanned<DeTable<'_>>, Vec<Diagnostic>> {
    let (table, errors) = DeTable::parse_recoverable(source);
    if errors.is_empty() {
        return Ok(table);
    }
    let mut problems: Vec<Diagnostic> = errors.iter().map(|e| problem(source, e)).collect();
    // One unclosed bracket can be reported many times over.
    problems.dedup_by(|a, b| a.message == b.message && (a.span == b.span || a.message.contains("nested")));
    Err(problems)
}

/// Rewords what the parser says for someone who does not know TOML.
fn problem(source: &str, error: &Error) -> Diagnostic {
    let span = error.span().unwrap_or(0..0);
    let found = source.get(span.clone()).unwrap_or("").trim();
    let (message, remedy): (String, String) = match error.message() {
        m if m.starts_with("string values must be quoted") && found.is_empty() => {
            ("a value is missing behind `=`".into(), "write a value: width = \"17 m\"".into())
        }
        m if m.starts_with("string values must be quoted") => {
            (format!("`{found}` is not in quotes"), format!("put it in quotes: \"{found}\""))
        }
        m if m.starts_with("duplicate key") => (
            format!("`{found}` is given twice"),
            "keep one of the two; `[[…]]` starts another entry of a list".into(),
        ),
        m if m.starts_with("key with no value") => {
            ("a key without `=`".into(), "write key = value; text behind a value starts with #".into())
        }
        m if m.starts_with("invalid basic string") => {
            ("a quotation mark is missing".into(), "close the text with \" on the same line".into())
        }
        m if m.starts_with("missing escaped value") || m.contains("unicode hexadecimal value") => {
            return escape(source, span);
        }
        m if m.starts_with("unclosed") => (m.replace(", expected", "; expected"), "close the bracket".into()),
        m if m.contains("recurs") => {
            ("tables or lists are nested too deeply".into(), "a case needs no more than five levels".into())
        }
        m => (m.to_owned(), "see https://toml.io for how TOML is written".into()),
    };
    Diagnostic::new(span, message, remedy)
}

/// A backslash in double quotes that begins no escape of TOML: nearly always one of a path of Windows. Marks the whole
/// text, so that further backslashes in it are reported once.
fn escape(source: &str, span: Range<usize>) -> Diagnostic {
    let start = source.get(..span.start).and_then(|before| before.rfind(['"', '\n'])).unwrap_or(0);
    let text = &source[start..];
    let inside = text.trim_start_matches(['"', '\n']);
    let from = start + text.len() - inside.len();
    let inside = &inside[..inside.find(['"', '\n', '\r']).unwrap_or(inside.len())];
    let end = from + inside.len();
    // With the quotes at both ends, where the second is there.
    let end = end + usize::from(source[end..].starts_with('"'));
    let remedy = forward_slashes(inside).unwrap_or_else(|| "write it twice: \\\\".to_owned());
    Diagnostic::new(start..end, "a backslash in double quotes begins an escape", remedy)
}

/// How a path is written whose text in the file, without its quotes, has backslashes.
pub(crate) fn forward_slashes(written: &str) -> Option<String> {
    let single = written.replace("\\\\", "\\");
    let forward = single.replace('\\', "/");
    (forward != written)
        .then(|| format!("write a path with forward slashes, \"{forward}\", or in single quotes, '{single}'"))
}
