//! Files that appear complete or not at all.

use std::fs::{self, File};
use std::io::{self, BufWriter};
use std::path::Path;

/// Writes a file that appears complete or not at all: it is written under a neighbouring name that ends in
/// `.part` and then renamed.
pub(crate) fn whole_file<T, E: From<io::Error>>(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> Result<T, E>,
) -> Result<T, E> {
    let mut part = path.as_os_str().to_owned();
    part.push(".part");
    let attempt = || {
        let mut out = BufWriter::with_capacity(1 << 16, File::create(&part)?);
        let result = write(&mut out)?;
        out.into_inner().map_err(io::IntoInnerError::into_error)?.sync_all()?;
        fs::rename(&part, path)?;
        Ok(result)
    };
    attempt().inspect_err(|_| {
        // The half-written file is of no use; the first error is the one to tell.
        let _ = fs::remove_file(&part);
    })
}
