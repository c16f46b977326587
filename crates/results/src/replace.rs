//! Files that are replaced whole.

use std::fs;
use std::io::Write;
use std::path::Path;

use crate::Error;

/// Replaces a file whole: writes a neighbour, then renames it. A reader, and a machine that
/// loses power, sees the old content or the new.
///
/// # Errors
/// [`Error::Io`]; the old file is then untouched.
pub fn replace_file(path: &Path, content: &[u8]) -> Result<(), Error> {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(format!(".{}.part", std::process::id()));
    let part = path.with_file_name(name);
    let written = (|| {
        let mut file = fs::File::create(&part)?;
        file.write_all(content)?;
        file.sync_all()?;
        fs::rename(&part, path)
    })();
    written.map_err(|e| {
        // The rename may have failed for good (a folder of that name): leave no litter behind.
        let _ = fs::remove_file(&part);
        Error::io(path, "write this file")(e)
    })
}
