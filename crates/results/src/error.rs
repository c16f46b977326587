//! What can go wrong with result files.

use std::io;
use std::path::{Path, PathBuf};

/// An error of reading or writing result files. Its text names the file, the line where there is
/// one, and the way out.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The operating system refused.
    #[error("{}: cannot {action}: {source}", path.display())]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// What was tried, as in 'cannot …'.
        action: &'static str,
        /// Why it did not work.
        source: io::Error,
    },
    /// An output folder given by the user holds the results of an earlier run.
    #[error(
        "{}: this folder holds results already; choose another one, or go on with --resume, or replace them \
         with --overwrite",
        path.display()
    )]
    Held {
        /// The folder.
        path: PathBuf,
    },
    /// Another run writes into the folder at this moment.
    #[error(
        "{}: another run is writing into this folder; wait until it ends or stop it, or choose another folder \
         with --out",
        path.display()
    )]
    Busy {
        /// The folder.
        path: PathBuf,
    },
    /// There is nothing to resume or to report on.
    #[error("{}: no results here ({what})", path.display())]
    NoResults {
        /// The folder.
        path: PathBuf,
        /// What was looked for.
        what: String,
    },
    /// The file is not what it should be.
    #[error("{}{}: {what}", path.display(), line.map(|n| format!(", line {n}")).unwrap_or_default())]
    Format {
        /// The file.
        path: PathBuf,
        /// Line number from 1, where one can be named.
        line: Option<usize>,
        /// What is wrong and what to do about it.
        what: String,
    },
}

impl Error {
    /// For `map_err` on an operation with one path.
    pub(crate) fn io(path: &Path, action: &'static str) -> impl FnOnce(io::Error) -> Error {
        let path = path.to_owned();
        move |source| Error::Io { path, action, source }
    }

    /// A fault in the content of a file.
    pub(crate) fn format(path: &Path, line: Option<usize>, what: impl Into<String>) -> Error {
        Error::Format { path: path.to_owned(), line, what: what.into() }
    }
}
