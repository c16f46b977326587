//! The folder of one run: its name, its files, and the rules that no run overwrites another by accident, and that no two
//! write into one folder at a time.

use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use crate::{Error, Status, Summary, columns};

/// What stages leave beside a checkpoint for other runs to begin with: the run itself goes on from it where it has nothing later.
pub const HAND_OVER: &str = "hand-over.bin";
/// What a run goes on from, and the one before it, for the case that the last is damaged.
pub const CHECKPOINTS: [&str; 2] = ["state.bin", "state.earlier.bin"];

/// Files and folders that only a run leaves behind. `case.toml` is not among them: a user may
/// well keep the case in the folder that is to hold its results.
const MARKS: [&str; 7] =
    ["log.txt", "summary.json", "monitors.csv", "energy.csv", "damage.csv", "fields.pvd", "checkpoint"];

/// The tables that runs may write.
pub const TABLES: [&str; 14] = [
    "monitors.csv",
    "energy.csv",
    "damage.csv",
    "interfaces.csv",
    "motion.csv",
    "transfer.csv",
    "free_field.csv",
    "spectra.csv",
    "depth.csv",
    "stages.csv",
    "relaxation.csv",
    "sections.csv",
    "utilisation.csv",
    "bolts.csv",
];

/// In front of the tables that a user's program adds.
pub const OWN_TABLES: &str = "own/";

/// Whether a path that a file of a result folder names lies in that folder.
pub(crate) fn is_inside(name: &str) -> bool {
    Path::new(name).components().all(|part| matches!(part, Component::Normal(_)))
}

/// The folder that holds the results of one run.
///
/// One that was made or opened for a run keeps all other runs out until it and its clones are dropped, or the process
/// ends, however it ends. Reading needs no leave.
#[derive(Clone, Debug)]
pub struct ResultFolder {
    root: PathBuf,
    /// `run.lock`, locked.
    _lock: Option<Arc<fs::File>>,
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
    /// [`Error::Busy`] if a run writes into it; [`Error::Held`] if `base` holds results and `overwrite` is false;
    /// [`Error::Io`].
    pub fn create(base: Option<&Path>, case_name: &str, overwrite: bool) -> Result<Self, Error> {
        match base {
            Some(base) => Self::claim(base, overwrite)?.ok_or_else(|| Error::Held { path: base.to_owned() }),
            None => Self::create_numbered(Path::new("results"), case_name, overwrite),
        }
    }

    /// As [`ResultFolder::create`] without `base`, in another folder than `results`.
    ///
    /// # Errors
    /// [`Error::Busy`] if a run writes into the folder that `overwrite` asks for; [`Error::Io`].
    pub fn create_numbered(parent: &Path, case_name: &str, overwrite: bool) -> Result<Self, Error> {
        let mut number = 1;
        loop {
            match Self::claim(&numbered(parent, case_name, number), overwrite) {
                Ok(None) => number += 1,
                Err(Error::Busy { .. }) if !overwrite => number += 1,
                Ok(Some(folder)) => return Ok(folder),
                Err(error) => return Err(error),
            }
        }
    }

    /// Opens a folder that holds results, for a report or to go on with a run.
    ///
    /// # Errors
    /// [`Error::NoResults`] if the folder is missing or holds none.
    pub fn open_existing(root: &Path) -> Result<Self, Error> {
        if MARKS.iter().any(|mark| root.join(mark).exists()) {
            return Ok(ResultFolder { root: root.to_owned(), _lock: None });
        }
        let what =
            if root.is_dir() { format!("none of {}", MARKS.join(", ")) } else { "no such folder".into() };
        Err(Error::NoResults { path: root.to_owned(), what })
    }

    /// Opens the folder whose run is to be resumed: `base`, or else the last of `results/<case
    /// name>`, `-2`, `-3` … that holds a checkpoint, or what its earthquake began with where the run was killed before its first.
    ///
    /// # Errors
    /// [`Error::NoResults`] if there is no checkpoint; [`Error::Busy`] if a run writes into the folder.
    pub fn resume(base: Option<&Path>, case_name: &str) -> Result<Self, Error> {
        match base {
            Some(base) => Self::with_checkpoint(base.to_owned())?.locked(true),
            None => Self::resume_numbered(Path::new("results"), case_name),
        }
    }

    /// As [`ResultFolder::resume`] without `base`, in another folder than `results`.
    ///
    /// # Errors
    /// As [`ResultFolder::resume`].
    pub fn resume_numbered(parent: &Path, case_name: &str) -> Result<Self, Error> {
        let candidates = || (1..).map(|n| numbered(parent, case_name, n)).take_while(|path| path.is_dir());
        let last = || candidates().last().unwrap_or_else(|| numbered(parent, case_name, 1));
        candidates()
            .filter_map(|path| Self::with_checkpoint(path).ok())
            .last()
            .ok_or_else(|| no_checkpoint(&last()))?
            .locked(true)
    }

    fn with_checkpoint(root: PathBuf) -> Result<Self, Error> {
        match ResultFolder::goes_on(&root) {
            true => Ok(ResultFolder { root, _lock: None }),
            false => Err(no_checkpoint(&root)),
        }
    }

    /// Whether a folder holds what its run can go on from: a checkpoint, or what its earthquake began with, where a run was killed or stopped and
    /// its checkpoint is lost. A run that ended keeps that for others alone.
    pub fn goes_on(root: &Path) -> bool {
        let folder = ResultFolder { root: root.to_owned(), _lock: None };
        let has = |name: &str| folder.checkpoint().join(name).is_file();
        CHECKPOINTS.into_iter().any(has) || has(HAND_OVER) && !folder.has_ended()
    }

    /// Whether a run came to an end here, good or bad. One that was stopped did not.
    fn has_ended(&self) -> bool {
        self.summary().exists()
            && Summary::read(&self.summary())
                .is_ok_and(|summary| summary.conclusion.status != Status::Stopped)
    }

    /// Whether a run was killed here before it had anything to go on from: it has begun, and neither ended nor left a checkpoint.
    pub fn was_cut_short(root: &Path) -> bool {
        let marked = MARKS.iter().any(|mark| root.join(mark).exists());
        marked && !root.join("summary.json").exists() && !ResultFolder::goes_on(root)
    }

    /// Waits until the tables that grow are on the disk, as a checkpoint that knows what is in them wants.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn sync(&self) -> Result<(), Error> {
        for folder in [self.root.clone(), self.own_tables()] {
            let Ok(entries) = fs::read_dir(&folder) else { continue };
            for path in entries.flatten().map(|entry| entry.path()) {
                if path.extension().is_some_and(|x| x == "csv") {
                    let synced = tremolite_files::Appended::open(&path).and_then(|table| table.sync());
                    synced.map_err(Error::io(&path, "write this file"))?;
                }
            }
        }
        Ok(())
    }

    /// Keeps other runs out, by a file that is made if it has to be and stays.
    fn locked(mut self, make: bool) -> Result<Self, Error> {
        let path = self.root.join("run.lock");
        let file = match fs::OpenOptions::new().read(true).append(make).create(make).open(&path) {
            Err(e) if e.kind() == io::ErrorKind::NotFound && !make => return Ok(self),
            file => file.map_err(Error::io(&path, "open this file"))?,
        };
        match file.try_lock() {
            Err(fs::TryLockError::WouldBlock) => return Err(Error::Busy { path: self.root }),
            // A file system without locks keeps nobody out.
            Err(fs::TryLockError::Error(_)) => {}
            Ok(()) => self._lock = Some(Arc::new(file)),
        }
        if make {
            self.tidy();
        }
        Ok(self)
    }

    /// Removes what a run that was killed had half written, which no other can go on with.
    fn tidy(&self) {
        let folders = [
            self.root.clone(),
            self.fields(),
            self.interface_fields(),
            self.stage_fields(),
            self.bolt_fields(),
            self.own_tables(),
            self.figures(),
            self.checkpoint(),
        ];
        let entries = folders.iter().filter_map(|folder| fs::read_dir(folder).ok()).flatten().flatten();
        let litter = entries.map(|entry| entry.path()).filter(|path| tremolite_files::is_half_written(path));
        for path in litter {
            // Litter that stays does no harm.
            let _ = tremolite_files::remove(&path);
        }
    }

    /// Removes the checksums of files that will now change; a loss of power may bring them back, and then they say so.
    pub fn unseal(&self) {
        if self.checksums().exists() {
            let _ = tremolite_files::remove(&self.checksums());
        }
    }

    /// Makes the folder and its `log.txt`; none if it holds results that must stay.
    fn claim(root: &Path, overwrite: bool) -> Result<Option<Self>, Error> {
        tremolite_files::make_folder(root).map_err(Error::io(root, "make this folder"))?;
        let held = !overwrite && MARKS.iter().any(|mark| root.join(mark).exists());
        // A folder that is refused is left as it is.
        let folder = ResultFolder { root: root.to_owned(), _lock: None }.locked(!held)?;
        if held {
            return Ok(None);
        }
        if overwrite {
            folder.clear()?;
        }
        match fs::File::create_new(folder.log()) {
            Ok(_) => {}
            Err(e) if e.kind() == io::ErrorKind::AlreadyExists => return Ok(None),
            Err(e) => return Err(Error::io(&folder.log(), "write this file")(e)),
        }
        for path in [folder.fields(), folder.figures()] {
            tremolite_files::make_folder(&path).map_err(Error::io(&path, "make this folder"))?;
        }
        Ok(Some(folder))
    }

    /// Files of its own folder that a run may write, but for the page and `log.txt`.
    fn tables(&self) -> Vec<PathBuf> {
        let files = [
            self.summary(),
            self.monitors(),
            self.energy(),
            self.damage(),
            self.pvd(),
            self.interfaces(),
            self.interfaces_pvd(),
            self.motion(),
            self.transfer(),
            self.free_field(),
            self.spectra(),
            self.depth(),
            self.stages(),
            self.stages_pvd(),
            self.relaxation(),
            self.sections(),
            self.utilisation(),
            self.bolts(),
            self.bolts_pvd(),
        ];
        let columns = files.iter().filter(|file| file.extension().is_some_and(|x| x == "csv"));
        let columns: Vec<PathBuf> = columns.map(|file| columns::beside(file)).collect();
        files.into_iter().chain(columns).collect()
    }

    /// Files that are there of those which a run writes into folders of their kind, by path.
    fn filed(&self, folders: &[(PathBuf, &str)]) -> Vec<PathBuf> {
        let of = |(folder, extension): &(PathBuf, &str)| {
            let entries = fs::read_dir(folder).ok().into_iter().flatten().flatten();
            let named = entries.map(|entry| entry.path());
            let mut named: Vec<PathBuf> =
                named.filter(|path| path.extension().is_some_and(|x| x == *extension)).collect();
            named.sort();
            named
        };
        folders.iter().flat_map(of).collect()
    }

    fn fields_and_tables(&self) -> [(PathBuf, &'static str); 7] {
        [
            (self.fields(), "vtu"),
            (self.fields(), "pvtu"),
            (self.interface_fields(), "vtu"),
            (self.stage_fields(), "vtu"),
            (self.stage_fields(), "pvtu"),
            (self.bolt_fields(), "vtu"),
            (self.own_tables(), "csv"),
        ]
    }

    /// What is there of a run's results, but for what can be made of them again.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub(crate) fn written(&self) -> Result<Vec<PathBuf>, Error> {
        let mut files = vec![self.case()];
        files.extend(self.tables());
        files.extend(self.filed(&self.fields_and_tables()));
        let mut there = Vec::new();
        for file in files {
            if file.try_exists().map_err(Error::io(&file, "read this file"))? {
                there.push(file);
            }
        }
        Ok(there)
    }

    /// Removes what a run writes. Other files in the folder stay.
    fn clear(&self) -> Result<(), Error> {
        let own = [self.log(), self.report(), self.checksums()];
        let figures = [(self.figures(), "svg")];
        let files = own.into_iter().chain(self.tables()).chain(self.filed(&self.fields_and_tables()));
        for file in files.chain(self.filed(&figures)) {
            remove(&file, |path| fs::remove_file(path))?;
        }
        remove(&self.checkpoint(), |path| fs::remove_dir_all(path))
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

    /// `fields/`, the field files: of a large mesh several pieces for each time, and a list of them.
    pub fn fields(&self) -> PathBuf {
        self.root.join("fields")
    }

    /// `interfaces.csv`, what opens and slides over time; only of runs with interfaces.
    pub fn interfaces(&self) -> PathBuf {
        self.root.join("interfaces.csv")
    }

    /// `interfaces.pvd`, the times of the interfaces' files.
    pub fn interfaces_pvd(&self) -> PathBuf {
        self.root.join("interfaces.pvd")
    }

    /// `interfaces/`, the pairs of all interfaces at those times.
    pub fn interface_fields(&self) -> PathBuf {
        self.root.join("interfaces")
    }

    /// `motion.csv`: the given motion and the incident wave.
    pub fn motion(&self) -> PathBuf {
        self.root.join("motion.csv")
    }

    /// `transfer.csv`: the motion at the place of a record over that of the incident wave, by frequency; of deconvolved records.
    pub fn transfer(&self) -> PathBuf {
        self.root.join("transfer.csv")
    }

    /// `free_field.csv`: velocities of the free field and the model, see [`crate::FreeField`].
    pub fn free_field(&self) -> PathBuf {
        self.root.join("free_field.csv")
    }

    /// `spectra.csv`: response spectra of the motion, the free field and the monitors.
    pub fn spectra(&self) -> PathBuf {
        self.root.join("spectra.csv")
    }

    /// `depth.csv`: peaks of the free field along depth, and of the model's vertical edge beside it.
    pub fn depth(&self) -> PathBuf {
        self.root.join("depth.csv")
    }

    /// `stages.csv`: a row a stage before the earthquake.
    pub fn stages(&self) -> PathBuf {
        self.root.join("stages.csv")
    }

    /// `stages.pvd`: what stands at the end of each stage.
    pub fn stages_pvd(&self) -> PathBuf {
        self.root.join("stages.pvd")
    }

    /// The folder of its files.
    pub fn stage_fields(&self) -> PathBuf {
        self.root.join("stages")
    }

    /// `own/`: tables that a user's program adds, see [`crate::own_table`].
    pub fn own_tables(&self) -> PathBuf {
        self.root.join("own")
    }

    /// `relaxation.csv`: how stages came to rest, every so many cycles.
    pub fn relaxation(&self) -> PathBuf {
        self.root.join("relaxation.csv")
    }

    /// `sections.csv`: section forces of linings.
    pub fn sections(&self) -> PathBuf {
        self.root.join("sections.csv")
    }

    /// `utilisation.csv`: what sections of linings use of their strength; only of runs that judge them.
    pub fn utilisation(&self) -> PathBuf {
        self.root.join("utilisation.csv")
    }

    /// `bolts.csv`: what bolts do at the end of stages and in the shaking; only of runs with bolts.
    pub fn bolts(&self) -> PathBuf {
        self.root.join("bolts.csv")
    }

    /// `bolts.pvd`, the times of the bolts' files.
    pub fn bolts_pvd(&self) -> PathBuf {
        self.root.join("bolts.pvd")
    }

    /// `bolts/`, the segments of all bolts at those times.
    pub fn bolt_fields(&self) -> PathBuf {
        self.root.join("bolts")
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
        what: if root.join("summary.json").exists() {
            "this run is complete, or its checkpoint is missing: there is nothing to go on with; --overwrite begins it anew"
                .into()
        } else {
            "no checkpoint to resume from; run without --resume".into()
        },
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_table_that_a_run_may_write_is_listed() {
        let folder = ResultFolder { root: PathBuf::from("out"), _lock: None };
        let name = |path: PathBuf| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let tables = folder.tables().into_iter().map(name).filter(|name| name.ends_with(".csv"));
        let mut tables: Vec<String> = tables.filter(|name| !name.contains(".columns")).collect();
        let mut listed = TABLES.to_vec();
        tables.sort();
        tables.dedup();
        listed.sort_unstable();
        assert_eq!(tables, listed);
    }
}
