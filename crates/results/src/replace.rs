//! Files that are replaced whole.

use crate::Error;
use std::path::Path;

/// Replaces a file whole: a reader, and a machine that loses power, sees the old content or the new ([`tremolite_files::replace`]).
///
/// # Errors
/// [`Error::Io`]; the old file is then untouched.
pub fn replace_file(path: &Path, content: &[u8]) -> Result<(), Error> {
    tremolite_files::replace_with(path, content).map_err(Error::io(path, "write this file"))
}
