//! What was done to files, for tests: what a machine that lost power at any moment would have left.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::{Mutex, PoisonError};

/// One thing that was done.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Act {
    /// A file was made, or emptied.
    Create(PathBuf),
    /// Bytes were added at its end.
    Write(PathBuf, Vec<u8>),
    /// It was cut to a length.
    Cut(PathBuf, u64),
    /// Its content is there to stay.
    Sync(PathBuf),
    Rename(PathBuf, PathBuf),
    Remove(PathBuf),
    Folder(PathBuf),
    /// The names in it are there to stay.
    SyncFolder(PathBuf),
}

static IS_ON: AtomicBool = AtomicBool::new(false);
/// The folder that is watched, and what was done below it.
static ACTS: Mutex<Option<(PathBuf, Vec<Act>)>> = Mutex::new(None);

/// Notes what was done to a path, if somebody records.
pub(crate) fn note(path: &Path, act: impl FnOnce() -> Act) {
    if !IS_ON.load(Relaxed) {
        return;
    }
    let mut acts = ACTS.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, acts)) = acts.as_mut().filter(|(root, _)| path.starts_with(root)) {
        acts.push(act());
    }
}

/// Begins to record what is done below a folder, in all threads. One record at a time: what was recorded before is dropped.
pub fn begin(root: &Path) {
    *ACTS.lock().unwrap_or_else(PoisonError::into_inner) = Some((root.to_owned(), Vec::new()));
    IS_ON.store(true, Relaxed);
}

/// How many things were done so far.
pub fn so_far() -> usize {
    let acts = ACTS.lock().unwrap_or_else(PoisonError::into_inner);
    acts.as_ref().map_or(0, |(_, acts)| acts.len())
}

/// Ends the record.
pub fn end() -> Vec<Act> {
    IS_ON.store(false, Relaxed);
    ACTS.lock().unwrap_or_else(PoisonError::into_inner).take().map_or(Vec::new(), |(_, acts)| acts)
}

/// What of all that was not synced a machine that loses power keeps: it may keep any of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loss {
    /// Names and contents as of the last sync.
    All,
    /// All names, but contents as of the last sync: a file that was made and renamed is empty.
    Contents,
    /// All names and lengths, but half of the new content is zeros: blocks that were given to the file and not written.
    Torn,
    /// All is kept, as where the process alone is killed.
    Nothing,
}

/// A file's content, and what of it is there to stay.
#[derive(Clone, Debug, Default)]
struct Content {
    now: Vec<u8>,
    synced: Vec<u8>,
}

impl Content {
    fn left(&self, loss: Loss) -> Vec<u8> {
        match loss {
            Loss::Nothing => self.now.clone(),
            Loss::All | Loss::Contents => self.synced.clone(),
            Loss::Torn => {
                let same = self.now.iter().zip(&self.synced).take_while(|(a, b)| a == b).count();
                let mut left = self.now.clone();
                let torn = same + (left.len() - same) / 2;
                left[torn..].fill(0);
                left
            }
        }
    }
}

/// A folder's names, by file: numbers of contents; and the folders.
#[derive(Clone, Debug, Default)]
struct Names {
    files: BTreeMap<PathBuf, usize>,
    folders: Vec<PathBuf>,
}

/// Makes `to` what a machine that lost power after these acts would have left of `root`, which was empty when they began.
///
/// # Errors
/// If a file cannot be written.
pub fn leave(acts: &[Act], loss: Loss, root: &Path, to: &Path) -> io::Result<()> {
    let mut contents: Vec<Content> = Vec::new();
    let (mut now, mut kept) = (Names::default(), Names::default());
    for act in acts {
        match act {
            Act::Create(path) => {
                // Emptying a file keeps what it is; a new one is another.
                match now.files.get(path) {
                    Some(&k) => contents[k].now.clear(),
                    None => {
                        now.files.insert(path.clone(), contents.len());
                        contents.push(Content::default());
                    }
                }
            }
            Act::Write(path, bytes) => {
                if let Some(&k) = now.files.get(path) {
                    contents[k].now.extend(bytes);
                }
            }
            Act::Cut(path, length) => {
                if let Some(&k) = now.files.get(path) {
                    contents[k].now.truncate(*length as usize);
                }
            }
            Act::Sync(path) => {
                if let Some(&k) = now.files.get(path) {
                    contents[k].synced = contents[k].now.clone();
                }
            }
            Act::Rename(from, other) => {
                if let Some(k) = now.files.remove(from) {
                    now.files.insert(other.clone(), k);
                }
            }
            Act::Remove(path) => {
                now.files.remove(path);
            }
            Act::Folder(path) => now.folders.push(path.clone()),
            Act::SyncFolder(folder) => {
                let inside = |path: &Path| path.parent() == Some(folder);
                kept.files.retain(|path, _| !inside(path));
                let files = now.files.iter().filter(|(path, _)| inside(path));
                kept.files.extend(files.map(|(path, k)| (path.clone(), *k)));
                kept.folders.retain(|path| !inside(path));
                kept.folders.extend(now.folders.iter().filter(|path| inside(path)).cloned());
            }
        }
    }
    let names = if loss == Loss::All { kept } else { now };
    let place = |path: &Path| path.strip_prefix(root).map(|inside| to.join(inside)).ok();
    fs::create_dir_all(to)?;
    // A folder is only found where those above it are.
    let is_there = |path: &Path| {
        let above = path.ancestors().skip(1).take_while(|folder| *folder != root);
        above.into_iter().all(|folder| names.folders.iter().any(|other| other == folder))
    };
    for folder in names.folders.iter().filter(|folder| is_there(folder)).filter_map(|folder| place(folder)) {
        fs::create_dir_all(folder)?;
    }
    for (path, &k) in names.files.iter().filter(|(path, _)| is_there(path)) {
        if let Some(place) = place(path) {
            fs::write(place, contents[k].left(loss))?;
        }
    }
    Ok(())
}
