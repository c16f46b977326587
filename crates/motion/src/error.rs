//! What can be wrong with a record, and the way out.

use std::io;
use std::path::{Path, PathBuf};

/// An error of this crate. Every message says what is wrong, where, and what to do about it.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The file could not be read or written.
    #[error("{}: {source}", file.display())]
    Io { file: PathBuf, source: io::Error },

    /// The content of a file is not what its format promises. `line` counts from 1.
    #[error("{}, line {line}: {problem}; {remedy}", file.display())]
    Record { file: PathBuf, line: usize, problem: String, remedy: String },

    /// As [`Error::Record`], for content that has no lines. `byte` counts from 0, as programs that show bytes do; for packed
    /// files it is that of the unpacked content.
    #[error("{}, byte {byte}: {problem}; {remedy}", file.display())]
    Binary { file: PathBuf, byte: usize, problem: String, remedy: String },

    /// A step of processing cannot be applied to this channel.
    #[error("record '{channel}', '{step}': {problem}; {remedy}")]
    Process { channel: String, step: String, problem: String, remedy: String },

    /// Records do not fit together, or a parameter does not fit the record.
    #[error("{problem}; {remedy}")]
    Unsuitable { problem: String, remedy: String },
}

impl Error {
    /// What is wrong and where, and what to do about it, apart, for reports that set them apart. Together they are the
    /// error's text, but for an I/O error, whose text has no remedy.
    pub fn message_and_remedy(&self) -> (String, String) {
        let text = self.to_string();
        match self {
            Error::Io { .. } => (text, "check the file's name and place, and that it may be read".into()),
            Error::Record { remedy, .. }
            | Error::Binary { remedy, .. }
            | Error::Process { remedy, .. }
            | Error::Unsuitable { remedy, .. } => {
                let message = text.strip_suffix(remedy.as_str()).and_then(|m| m.strip_suffix("; "));
                (message.unwrap_or(&text).to_owned(), remedy.clone())
            }
        }
    }

    /// A [`Error::Record`]; `line` counts from 1.
    pub(crate) fn record(
        file: &Path,
        line: usize,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Error {
        Error::Record { file: file.to_path_buf(), line, problem: problem.into(), remedy: remedy.into() }
    }

    /// A [`Error::Binary`]; `byte` counts from 0.
    pub(crate) fn binary(
        file: &Path,
        byte: usize,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Error {
        Error::Binary { file: file.to_path_buf(), byte, problem: problem.into(), remedy: remedy.into() }
    }

    /// The same error, at a byte in place of a line.
    pub(crate) fn at_byte(self, byte: usize) -> Error {
        match self {
            Error::Record { file, problem, remedy, .. } => Error::Binary { file, byte, problem, remedy },
            other => other,
        }
    }

    /// A [`Error::Unsuitable`].
    /// What cannot be used, with a way out.
    pub fn unsuitable(problem: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error::Unsuitable { problem: problem.into(), remedy: remedy.into() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn message_and_remedy_are_the_text_apart() {
        let at = Path::new("a.txt");
        let process = Error::Process {
            channel: "a".into(),
            step: "taper 1 s".into(),
            problem: "short; very".into(),
            remedy: "cut".into(),
        };
        for (error, parts) in [
            (Error::record(at, 3, "no; number", "mend; it"), ("a.txt, line 3: no; number", "mend; it")),
            (Error::binary(at, 3, "no number", "mend it"), ("a.txt, byte 3: no number", "mend it")),
            (Error::unsuitable("no", "yes"), ("no", "yes")),
            (process, ("record 'a', 'taper 1 s': short; very", "cut")),
        ] {
            let (message, remedy) = error.message_and_remedy();
            assert_eq!((message.as_str(), remedy.as_str()), parts);
            assert_eq!(format!("{message}; {remedy}"), error.to_string());
        }
        let io = Error::Io { file: at.into(), source: io::ErrorKind::NotFound.into() };
        let (message, remedy) = io.message_and_remedy();
        assert!(message == io.to_string() && remedy.contains("name and place"), "{message}; {remedy}");
    }
}
