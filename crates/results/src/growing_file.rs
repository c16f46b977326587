//! A table of text that grows with a run, and what a checkpoint keeps of it.

use crate::Error;
use std::fmt;
use std::fs::File;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};
use tremolite_files::Appended;

/// How much of a table is written, and what: a run that goes on asks that its table begins so.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    pub bytes: u64,
    /// CRC-32 of these bytes.
    pub crc: u32,
}

impl Extent {
    /// As two numbers that lose nothing, for a state.
    pub fn kept(self) -> [f64; 2] {
        [self.bytes as f64, f64::from(self.crc)]
    }

    /// Of what was kept.
    pub fn of_kept(kept: [f64; 2]) -> Extent {
        Extent { bytes: kept[0] as u64, crc: kept[1] as u32 }
    }

    /// Asks whether a file begins so.
    ///
    /// # Errors
    /// [`Error::Format`] if it does not; [`Error::Io`].
    pub fn check(self, path: &Path) -> Result<(), Error> {
        let file = File::open(path).map_err(Error::io(path, "open this file to go on with it"))?;
        let found = file.metadata().map_err(Error::io(path, "read this file"))?.len();
        self.check_length(path, found)?;
        let mut digest = crc32fast::Hasher::new();
        let mut known = BufReader::with_capacity(1 << 18, file).take(self.bytes);
        loop {
            let bytes = known.fill_buf().map_err(Error::io(path, "read this file"))?;
            let read = bytes.len();
            if read == 0 {
                break;
            }
            digest.update(bytes);
            known.consume(read);
        }
        if digest.finalize() == self.crc {
            return Ok(());
        }
        let what =
            "changed since the checkpoint was made; put the file of that run back, or start the run anew";
        Err(Error::format(path, None, what))
    }

    fn check_length(self, path: &Path, found: u64) -> Result<(), Error> {
        if found >= self.bytes {
            return Ok(());
        }
        let what = format!(
            "{found} bytes long, but the checkpoint was made at {}; put the file of that run back, or start the run anew",
            self.bytes
        );
        Err(Error::format(path, None, what))
    }

    fn digest(self) -> crc32fast::Hasher {
        crc32fast::Hasher::new_with_initial_len(self.crc, self.bytes)
    }
}

/// A file that is written from its end on, with what stands in it.
pub(crate) struct GrowingFile {
    file: Appended,
    path: PathBuf,
    bytes: u64,
    digest: crc32fast::Hasher,
}

impl GrowingFile {
    /// Starts a file, replacing one of that name.
    pub fn create(path: &Path) -> Result<Self, Error> {
        let file = Appended::create(path).map_err(Error::io(path, "write this file"))?;
        Ok(GrowingFile { file, path: path.to_owned(), bytes: 0, digest: crc32fast::Hasher::new() })
    }

    /// Opens a table of these headers (with their line end) behind what a checkpoint knows of it, and cuts off what was written later.
    ///
    /// # Errors
    /// [`Error::Format`] if it is shorter, has other columns, does not break after a row there, or does not hold what it held: it is then left as
    /// it is. [`Error::Io`].
    pub fn resume(path: &Path, header: &str, extent: Extent) -> Result<Self, Error> {
        let file = Self::of_this_length(path, header, extent)?;
        extent.check(path)?;
        file.cut(extent)
    }

    /// The same without a look at what stands between headers and end, for whoever wrote that a moment ago.
    pub fn go_on(path: &Path, header: &str, extent: Extent) -> Result<Self, Error> {
        Self::of_this_length(path, header, extent)?.cut(extent)
    }

    fn of_this_length(path: &Path, header: &str, extent: Extent) -> Result<Self, Error> {
        let Extent { bytes, .. } = extent;
        let mut file = Appended::open(path).map_err(Error::io(path, "open this file to go on with it"))?;
        let found = file.length().map_err(Error::io(path, "read this file"))?;
        extent.check_length(path, found)?;
        let foreign = "not the table of the run that made the checkpoint; put that file back, or start anew";
        if bytes < header.len() as u64 {
            return Err(Error::format(path, None, foreign));
        }
        let mut start = vec![0; header.len()];
        let mut end = [0];
        file.read(0, &mut start)
            .and_then(|()| file.read(bytes - 1, &mut end))
            .map_err(Error::io(path, "read this file"))?;
        if start != header.as_bytes() || end != *b"\n" {
            return Err(Error::format(path, None, foreign));
        }
        Ok(GrowingFile { file, path: path.to_owned(), bytes, digest: extent.digest() })
    }

    fn cut(mut self, extent: Extent) -> Result<Self, Error> {
        self.file.cut(extent.bytes).map_err(Error::io(&self.path, "cut this file at the checkpoint"))?;
        Ok(self)
    }

    /// Hands a text to the operating system in one piece: another program can read it at once.
    pub fn put(&mut self, text: &[u8]) -> Result<(), Error> {
        self.file.write_all(text).map_err(Error::io(&self.path, "write this file"))?;
        self.digest.update(text);
        self.bytes += text.len() as u64;
        Ok(())
    }

    pub fn extent(&self) -> Extent {
        Extent { bytes: self.bytes, crc: self.digest.clone().finalize() }
    }

    /// Waits until all is on the disk.
    pub fn sync(&self) -> Result<(), Error> {
        self.file.sync().map_err(Error::io(&self.path, "write this file"))
    }
}

impl fmt::Debug for GrowingFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("GrowingFile").field("path", &self.path).field("extent", &self.extent()).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn what_was_changed_before_its_end_is_refused_and_left_as_it_is() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("t.csv");
        let header = "time [s]\n";
        let mut file = GrowingFile::create(&path).unwrap();
        file.put(header.as_bytes()).unwrap();
        let rows: String = (0..60_000).map(|k| format!("{k}\n")).collect();
        file.put(rows.as_bytes()).unwrap();
        let extent = Extent::of_kept(file.extent().kept());
        assert_eq!(extent, file.extent());
        file.put(b"7\n").unwrap();
        drop(file);
        let whole = fs::read(&path).unwrap();
        // Digits at the beginning, in the middle and at the end, and one behind what the checkpoint knows.
        let (bytes, sound) = (extent.bytes as usize, |path: &Path| GrowingFile::resume(path, header, extent));
        for at in [header.len(), bytes / 2, bytes - 2, bytes] {
            let mut changed = whole.clone();
            changed[at] ^= 1;
            fs::write(&path, &changed).unwrap();
            let told = sound(&path).map(|file| file.extent()).map_err(|e| e.to_string());
            if at < bytes {
                assert!(told.unwrap_err().contains("changed since the checkpoint was made"), "{at}");
                assert_eq!(fs::read(&path).unwrap(), changed);
            } else {
                assert_eq!(told, Ok(extent));
                assert_eq!(fs::read(&path).unwrap(), whole[..bytes]);
            }
        }
        // It goes on to what one that never stopped has.
        let mut file = sound(&path).unwrap();
        file.put(b"7\n").unwrap();
        let mut other = GrowingFile::create(&folder.path().join("o.csv")).unwrap();
        other.put(&whole).unwrap();
        assert_eq!(file.extent(), other.extent());
    }
}
