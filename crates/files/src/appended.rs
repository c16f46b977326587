//! A file that grows, as tables of histories do.

use crate::faults::{Answer, Want, ask};
use crate::record::{Act, note};
use crate::sync_folder_of;
use std::fs::{File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// A file that is written from its end on. What was written is with the operating system at once, so that another program can read it,
/// and there to stay once it was [synced](Appended::sync).
#[derive(Debug)]
pub struct Appended {
    file: File,
    path: PathBuf,
}

impl Appended {
    /// Makes a file, or empties one of that name.
    ///
    /// # Errors
    /// As [`File::create`].
    pub fn create(path: &Path) -> io::Result<Appended> {
        ask(path, Want::Room)?;
        let file = File::create(path)?;
        note(path, || Act::Create(path.to_owned()));
        Ok(Appended { file, path: path.to_owned() })
    }

    /// Opens a file that is there.
    ///
    /// # Errors
    /// As [`File::open`].
    pub fn open(path: &Path) -> io::Result<Appended> {
        let file = OpenOptions::new().read(true).write(true).open(path)?;
        Ok(Appended { file, path: path.to_owned() })
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    /// How long it is \[bytes\].
    ///
    /// # Errors
    /// As [`File::metadata`].
    pub fn length(&self) -> io::Result<u64> {
        Ok(self.file.metadata()?.len())
    }

    /// Reads so many bytes from a place on; what is written next may overwrite what follows until it is [cut](Appended::cut).
    ///
    /// # Errors
    /// As [`Read::read_exact`]; the file may be shorter.
    pub fn read(&mut self, at: u64, bytes: &mut [u8]) -> io::Result<()> {
        self.file.seek(SeekFrom::Start(at))?;
        self.file.read_exact(bytes)
    }

    /// Cuts it to a length, and goes on from there.
    ///
    /// # Errors
    /// As [`File::set_len`].
    pub fn cut(&mut self, length: u64) -> io::Result<()> {
        ask(&self.path, Want::Else)?;
        self.file.set_len(length)?;
        note(&self.path, || Act::Cut(self.path.clone(), length));
        self.file.seek(SeekFrom::End(0))?;
        Ok(())
    }

    /// Waits until content and name are on the disk.
    ///
    /// # Errors
    /// As [`File::sync_all`].
    pub fn sync(&self) -> io::Result<()> {
        ask(&self.path, Want::Else)?;
        self.file.sync_all()?;
        note(&self.path, || Act::Sync(self.path.clone()));
        sync_folder_of(&self.path)
    }
}

impl Write for Appended {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let bytes = match ask(&self.path, Want::Room)? {
            Answer::Yes => bytes,
            Answer::Half => &bytes[..bytes.len().div_ceil(2)],
        };
        let count = self.file.write(bytes)?;
        note(&self.path, || Act::Write(self.path.clone(), bytes[..count].to_vec()));
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}
