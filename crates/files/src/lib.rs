//! Files that a run writes, so that a machine which loses power leaves what was said to be kept; and [`text`] of files that others wrote.
//!
//! A file is there to stay once its content was synced, and its name once the folder was: [`replace`] does both, and [`Appended`] does
//! when it is told to. Everything that a run writes goes through here, so that a test can [`record`] it and ask of every
//! moment what a machine that lost power there would have left, or let the disk [fail](faults) at any moment.

#![forbid(unsafe_code)]

mod appended;
pub mod faults;
pub mod record;
pub mod text;

pub use appended::Appended;

use faults::{Want, ask};
use record::{Act, note};
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Replaces a file whole, or makes it: writes a neighbour whose name ends in `.part`, then renames it. A reader, and a machine that loses
/// power, sees the old content or the new.
///
/// # Errors
/// What `write` returns, and what the system does; the old file is then untouched.
pub fn replace<T, E: From<io::Error>>(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<Appended>) -> Result<T, E>,
) -> Result<T, E> {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(format!(".{}.part", std::process::id()));
    let part = path.with_file_name(name);
    let attempt = || {
        let mut out = BufWriter::with_capacity(1 << 16, Appended::create(&part)?);
        let result = write(&mut out)?;
        out.into_inner().map_err(io::IntoInnerError::into_error)?.sync()?;
        rename(&part, path)?;
        Ok(result)
    };
    attempt().inspect_err(|_| {
        // The half-written file is of no use; the first error is the one to tell.
        let _ = fs::remove_file(&part);
    })
}

/// The same with a content that is at hand.
///
/// # Errors
/// As [`replace`].
pub fn replace_with(path: &Path, content: &[u8]) -> io::Result<()> {
    replace(path, |out| out.write_all(content))
}

/// Whether a file has the name of one that [`replace`] did not finish: what else ends in `.part` is somebody's own.
pub fn is_half_written(path: &Path) -> bool {
    let name = path.file_name().and_then(|name| name.to_str()).and_then(|name| name.strip_suffix(".part"));
    let process = name.and_then(|name| name.rsplit_once('.')).map(|(_, process)| process);
    process.is_some_and(|process| process.parse::<u32>().is_ok())
}

/// Gives a file another name, in place of what had it before, for good.
///
/// # Errors
/// As [`fs::rename`].
pub fn rename(from: &Path, to: &Path) -> io::Result<()> {
    ask(to, Want::Else)?;
    fs::rename(from, to)?;
    note(to, || Act::Rename(from.to_owned(), to.to_owned()));
    sync_folder_of(to)
}

/// Makes a folder with those above it, for good.
///
/// # Errors
/// As [`fs::create_dir_all`].
pub fn make_folder(path: &Path) -> io::Result<()> {
    let missing: Vec<PathBuf> =
        path.ancestors().take_while(|folder| !folder.exists()).map(Path::to_owned).collect();
    if !missing.is_empty() {
        ask(path, Want::Room)?;
    }
    fs::create_dir_all(path)?;
    for folder in missing.iter().rev() {
        note(folder, || Act::Folder(folder.clone()));
        sync_folder_of(folder)?;
    }
    Ok(())
}

/// Removes a file, for good.
///
/// # Errors
/// As [`fs::remove_file`].
pub fn remove(path: &Path) -> io::Result<()> {
    ask(path, Want::Else)?;
    fs::remove_file(path)?;
    note(path, || Act::Remove(path.to_owned()));
    sync_folder_of(path)
}

/// Keeps the names in the folder that holds a path.
fn sync_folder_of(path: &Path) -> io::Result<()> {
    let Some(folder) = path.parent() else { return Ok(()) };
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    // Elsewhere folders cannot be opened, and renaming keeps by itself.
    if cfg!(unix) {
        match File::open(folder)?.sync_all() {
            // Some file systems on networks have no such thing.
            Err(e) if e.kind() != io::ErrorKind::InvalidInput && e.kind() != io::ErrorKind::Unsupported => {
                return Err(e);
            }
            _ => {}
        }
    }
    note(path, || Act::SyncFolder(folder.to_owned()));
    Ok(())
}
