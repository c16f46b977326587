//! `SHA256SUMS`: what a run that ended wrote, file by file, so that damage done later is found; `sha256sum -c SHA256SUMS` reads it as well.

use crate::folder::is_inside;
use crate::{Error, ResultFolder, replace_file};
use sha2::{Digest, Sha256};
use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

const NAME: &str = "SHA256SUMS";

/// SHA-256 of a file's bytes, in hexadecimal digits.
///
/// # Errors
/// If it cannot be read.
pub fn hash(path: &Path) -> io::Result<String> {
    let mut file = fs::File::open(path)?;
    let (mut hasher, mut buffer) = (Sha256::new(), vec![0; 1 << 16]);
    loop {
        match file.read(&mut buffer)? {
            0 => return Ok(hex(&hasher.finalize())),
            read => hasher.update(&buffer[..read]),
        }
    }
}

/// Bytes in hexadecimal digits.
pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

impl ResultFolder {
    /// `SHA256SUMS`, a line of digits and path for each file that the run wrote but for the page, figures, `log.txt` and checkpoints.
    pub fn checksums(&self) -> PathBuf {
        self.root().join(NAME)
    }

    /// Writes the checksums of what is there now.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn write_checksums(&self) -> Result<(), Error> {
        let mut lines = String::new();
        for path in self.written()? {
            let digits = hash(&path).map_err(Error::io(&path, "read this file"))?;
            let name = path.strip_prefix(self.root()).unwrap_or(&path);
            // With '/' on every system, as sha256sum has it.
            let name = name.iter().map(|part| part.to_string_lossy()).collect::<Vec<_>>().join("/");
            lines += &format!("{digits}  {name}\n");
        }
        replace_file(&self.checksums(), lines.as_bytes())
    }

    /// Leaves files out that were removed on purpose.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn leave_out(&self, gone: impl Fn(&str) -> bool) -> Result<(), Error> {
        let Some(text) = self.sums()? else { return Ok(()) };
        let stays = |line: &&str| !line.split_once("  ").is_some_and(|(_, name)| gone(name));
        let left: String = text.lines().filter(stays).map(|line| format!("{line}\n")).collect();
        if left == text { Ok(()) } else { replace_file(&self.checksums(), left.as_bytes()) }
    }

    /// The text of the checksums, if there are any.
    fn sums(&self) -> Result<Option<String>, Error> {
        let path = self.checksums();
        match fs::read_to_string(&path) {
            Err(e) if e.kind() == io::ErrorKind::NotFound => Ok(None),
            text => text.map(Some).map_err(Error::io(&path, "read this file")),
        }
    }

    /// Files that are not as the run that ended left them, or are missing, in words; none where there are no checksums, as while a run is under
    /// way.
    ///
    /// # Errors
    /// [`Error::Io`] if the checksums cannot be read.
    pub fn damaged(&self) -> Result<Vec<String>, Error> {
        self.damaged_among(|_| true)
    }

    /// The same of tables and the summary alone, which are all that numbers are taken from.
    ///
    /// # Errors
    /// As [`ResultFolder::damaged`].
    pub fn damaged_tables(&self) -> Result<Vec<String>, Error> {
        self.damaged_among(|name| name.ends_with(".csv") || name.ends_with(".json"))
    }

    fn damaged_among(&self, wanted: impl Fn(&str) -> bool) -> Result<Vec<String>, Error> {
        let path = self.checksums();
        let Some(text) = self.sums()? else { return Ok(Vec::new()) };
        let found = |line: &str| {
            // A folder may come from anybody: nothing outside it is read, and nothing that has no end.
            let Some((digits, name)) = line.split_once("  ").filter(|(_, name)| is_inside(name)) else {
                return Some(format!(
                    "{}: a line is no checksum of a file in this folder: {line:?}",
                    path.display()
                ));
            };
            if !wanted(name) {
                return None;
            }
            let file = self.root().join(name);
            if fs::metadata(&file).is_ok_and(|of| !of.is_file()) {
                return Some(format!("{}: it is no file", file.display()));
            }
            match hash(&file) {
                Ok(now) if now == digits => None,
                Ok(_) => Some(format!("{}: it is not what the run wrote", file.display())),
                Err(e) if e.kind() == io::ErrorKind::NotFound => {
                    Some(format!("{}: the run wrote it, and it is not there any more", file.display()))
                }
                Err(e) => Some(format!("{}: cannot read this file: {e}", file.display())),
            }
        };
        Ok(text.lines().filter_map(found).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_damaged_is_named_until_a_run_goes_on() {
        // The digest of no bytes, as sha256sum prints it.
        const NOTHING: &str = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
        let temp = tempfile::tempdir().unwrap();
        let folder = ResultFolder::create(Some(temp.path()), "case", false).unwrap();
        let field = folder.fields().join("000000.vtu");
        fs::write(&field, "field").unwrap();
        fs::write(folder.energy(), "").unwrap();
        fs::write(temp.path().join("own.csv"), "somebody's own").unwrap();
        assert!(folder.damaged().unwrap().is_empty());
        folder.write_checksums().unwrap();
        let text = fs::read_to_string(folder.checksums()).unwrap();
        assert!(text.contains(&format!("{NOTHING}  energy.csv\n")) && text.contains("  fields/000000.vtu\n"));
        assert_eq!(text.lines().count(), 2, "{text}");
        assert!(folder.damaged().unwrap().is_empty());

        fs::write(&field, "fielD").unwrap();
        fs::remove_file(folder.energy()).unwrap();
        let said = folder.damaged().unwrap().join("\n");
        assert!(said.contains("000000.vtu: it is not what the run wrote"), "{said}");
        assert!(said.contains("energy.csv: the run wrote it, and it is not there any more"), "{said}");

        // Names that lead elsewhere, or to what is no file.
        let odd = ["/dev/zero", "../own.csv", "fields/../../own.csv", "fields", ""]
            .map(|name| format!("{NOTHING}  {name}\n"));
        fs::write(folder.checksums(), odd.concat()).unwrap();
        let said = folder.damaged().unwrap();
        assert_eq!(
            said.iter().filter(|line| line.contains("no checksum of a file in this folder")).count(),
            3,
            "{said:?}"
        );
        assert_eq!(said.iter().filter(|line| line.ends_with("it is no file")).count(), 2, "{said:?}");

        // Of a run that goes on, whose files change.
        fs::create_dir_all(folder.checkpoint()).unwrap();
        fs::write(folder.checkpoint().join(crate::CHECKPOINTS[0]), "state").unwrap();
        drop(folder);
        let folder = ResultFolder::resume(Some(temp.path()), "case").unwrap();
        assert!(folder.checksums().exists(), "nothing was written yet");
        folder.unseal();
        assert!(!folder.checksums().exists() && folder.damaged().unwrap().is_empty());
    }
}
