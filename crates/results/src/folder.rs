//! The folder of one run: its name, its files, and the rule that no run overwrites another by accident.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::Error;

/// Files and folders that only a run leaves behind. `case.toml` is not among them: a user may
/// well keep the case in the folder that is to hold its results.
const MARKS: [&str; 7] =
    ["log.txt", "summary.json", "monitors.csv", "energy.csv", "damage.csv", "fields.pvd", "checkpoint"];

/// The folder that holds the results of one run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ResultFolder {
    root: PathBuf,
}

impl ResultFolder {
    /// Prepares a folder for a new run and claims it by an empty `log.txt`.
    ///
    /// `base` is the folder the user asked for (`--out`); without one it is `results/<case name>`
    /// in the current folder, or `<case name>-2`, `-3` … where that is taken. Two runs that start
    /// at the same moment get different folders. `overwrite` empties a taken folder of what an
    /// earlier run wrote, and of nothing else.
    ///
    /// # Errors
    /// [`Error::Held`] if `base` holds results and `overwrite` is false; [`Error::Io`].
    pub fn create(base: Option<&Path>, case_name: &str, overwrite: bool) -> Result<Self, Error> {
        match base {
            Some(base) => Self::claim(base, overwrite)?.ok_or_else(|| Error::Held { path: base.to_owned() }),
            None => Self::create_numbered(Path::new("results"), case_name, overwrite),
        }
    }

    /// As [`ResultFolder::create`] without `base`, in another folder than `results`.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn create_numbered(parent: &Path, case_name: &str, overwrite: bool) -> Result<Self, Error> {
        let mut number = 1;
        loop {
            if let Some(folder) = Self::claim(&numbered(parent, case_name, number), overwrite)? {
                return Ok(folder);
            }
            number += 1;
        }
    }

    /// Opens a folder that holds results, for a report or to go on with a run.
    ///
    /// # Errors
    /// [`Error::NoResults`] if the folder is missing or holds none.
    pub fn open_existing(root: &Path) -> Result<Self, Error> {
        if MARKS.iter().any(|mark| root.join(mark).exists()) {
            return Ok(ResultFolder { root: root.to_owned() });
        }
        let what =
            if root.is_dir() { format!("none of {}", MARKS.join(", ")) } else { "no such folder".into() };
        Err(Error::NoResults { path: root.to_owned(), what })
    }

    /// Opens the folder whose run is to be resumed: `base`, or else the last of `results/<case
    /// name>`, `-2`, `-3` … that holds a checkpoint.
    ///
    /// # Errors
    /// [`Error::NoResults`] if there is no checkpoint.
    pub fn resume(base: Option<&Path>, case_name: &str) -> Result<Self, Error> {
        match base {
            Some(base) => Self::with_checkpoint(base.to_owned()),
            None => Self::resume_numbered(Path::new("results"), case_name),
        }
    }

    /// As [`ResultFolder::resume`] without `base`, in another folder than `results`.
    ///
    /// # Errors
    /// [`Error::NoResults`] if there is no checkpoint.
    pub fn resume_numbered(parent: &Path, case_name: &str) -> Result<Self, Error> {
        let candidates = (1..).map(|n| numbered(parent, case_name, n)).take_while(|path| path.is_dir());
        candidates
            .filter_map(|path| Self::with_checkpoint(path).ok())
            .last()
            .ok_or_else(|| no_checkpoint(&numbered(parent, case_name, 1)))
    }

    fn with_checkpoint(root: PathBuf) -> Result<Self, Error> {
        let folder = ResultFolder { root };
        match fs::read_dir(folder.checkpoint()).map(|mut entries| entries.next().is_some()) {
            Ok(true) => Ok(folder),
            _ => Err(no_checkpoint(&folder.root)),
        }
    }

    /// Makes the folder and its `log.txt`; none if it holds results that must stay.
    fn claim(root: &Path, overwrite: bool) -> Result<Option<Self>, Error> {
        fs::create_dir_all(root).map_err(Error::io(root, "make this folder"))?;
        let folder = ResultFolder { root: root.to_owned() };
        if overwrite {
            folder.clear()?;
        } else if MARKS.iter().any(|mark| root.join(mark).exists()) {
            return Ok(None);
        }
        match fs::File::create_new(folder.log()) {
            Ok(_) => {}
            Err(e) if e.kind() == io::ErrorKind::AlreadyExists => return Ok(None),
            Err(e) => return Err(Error::io(&folder.log(), "write this file")(e)),
        }
        for path in [folder.fields(), folder.figures()] {
            fs::create_dir_all(&path).map_err(Error::io(&path, "make this folder"))?;
        }
        Ok(Some(folder))
    }

    /// Removes what a run writes. Other files in the folder stay.
    fn clear(&self) -> Result<(), Error> {
        for file in [
            self.log(),
            self.summary(),
            self.monitors(),
            self.energy(),
            self.damage(),
            self.pvd(),
            self.report(),
        ] {
            remove(&file, |path| fs::remove_file(path))?;
        }
        remove(&self.checkpoint(), |path| fs::remove_dir_all(path))?;
        for (folder, extension) in [(self.fields(), "vtu"), (self.figures(), "svg")] {
            let Ok(entries) = fs::read_dir(&folder) else { continue };
            for entry in entries.flatten().filter(|e| e.path().extension().is_some_and(|x| x == extension)) {
                remove(&entry.path(), |path| fs::remove_file(path))?;
            }
        }
        Ok(())
    }

    /// The folder itself.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// `case.toml`, the case as it was read.
    pub fn case(&self) -> PathBuf {
        self.root.join("case.toml")
    }

    /// `summary.json`, see [`crate::Summary`].
    pub fn summary(&self) -> PathBuf {
        self.root.join("summary.json")
    }

    /// `monitors.csv`, the histories of the monitors.
    pub fn monitors(&self) -> PathBuf {
        self.root.join("monitors.csv")
    }

    /// `energy.csv`, the energy balance over time.
    pub fn energy(&self) -> PathBuf {
        self.root.join("energy.csv")
    }

    /// `damage.csv`, damage over time; only of runs whose laws can be damaged.
    pub fn damage(&self) -> PathBuf {
        self.root.join("damage.csv")
    }

    /// `fields.pvd`, the times of the field files; ParaView opens this one.
    pub fn pvd(&self) -> PathBuf {
        self.root.join("fields.pvd")
    }

    /// `fields/`, the field files.
    pub fn fields(&self) -> PathBuf {
        self.root.join("fields")
    }

    /// `figures/`, the report's figures.
    pub fn figures(&self) -> PathBuf {
        self.root.join("figures")
    }

    /// `report.html`.
    pub fn report(&self) -> PathBuf {
        self.root.join("report.html")
    }

    /// `checkpoint/`, made by the first checkpoint.
    pub fn checkpoint(&self) -> PathBuf {
        self.root.join("checkpoint")
    }

    /// `log.txt`.
    pub fn log(&self) -> PathBuf {
        self.root.join("log.txt")
    }
}

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

/// `parent/<case name>`, `parent/<case name>-2` …
fn numbered(parent: &Path, case_name: &str, number: u64) -> PathBuf {
    let name = folder_name(case_name);
    parent.join(if number == 1 { name } else { format!("{name}-{number}") })
}

/// A name that is one folder on every file system: letters and digits of any script, `-`, `_`,
/// `.`; anything else becomes `-`. At most 60 characters; never empty, hidden, or `..`.
fn folder_name(case_name: &str) -> String {
    let clean = |c: char| if c.is_alphanumeric() || matches!(c, '-' | '_' | '.') { c } else { '-' };
    let name: String = case_name.trim().chars().map(clean).take(60).collect();
    let name = name.trim_matches(|c| matches!(c, '.' | '-'));
    if name.is_empty() { "case".into() } else { name.into() }
}

fn no_checkpoint(root: &Path) -> Error {
    Error::NoResults {
        path: root.to_owned(),
        what: "no checkpoint to resume from; run without --resume".into(),
    }
}

fn remove(path: &Path, how: impl FnOnce(&Path) -> io::Result<()>) -> Result<(), Error> {
    match how(path) {
        Err(e) if e.kind() != io::ErrorKind::NotFound => {
            Err(Error::io(path, "remove the earlier results")(e))
        }
        _ => Ok(()),
    }
}
