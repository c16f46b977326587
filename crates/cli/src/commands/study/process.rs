//! One run in a process of its own: this very program, in the folder of the run, which is locked for as long as the process lives.

use crate::exit::Failure;
use crate::machine;
use crate::terminal::say;
use std::fs::{self, File};
use std::io::{Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;
use tremolite_results::{CHECKPOINTS, ResultFolder, replace_file};
use tremolite_study::outcome::RunFolder;

/// How often a process is asked whether it still runs.
const LOOK: Duration = Duration::from_millis(50);

/// A run's folder that nobody else computes in.
pub struct Held {
    folder: RunFolder,
    lock: File,
}

/// How a process ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum End {
    /// It says itself what became of it, in its folder.
    Ended,
    /// A signal stopped it: it goes on another time.
    Stopped,
}

impl Held {
    /// Takes a folder for a case, and sets aside what is there of another; nothing where it is computed elsewhere.
    pub fn take(folder: RunFolder, bare: &str, case: &str) -> Result<Option<Held>, Failure> {
        let Some(lock) = locked(&folder)? else { return Ok(None) };
        if folder.bare().exists() && !folder.is_of(bare) {
            let aside = aside(&folder.0);
            fs::rename(&folder.0, &aside)
                .map_err(|e| Failure::failed(format!("{}: {e}", aside.display())))?;
            drop(lock);
            return Held::take(folder, bare, case);
        }
        let held = Held { folder, lock };
        // A run goes on with the very text it was started from, comments included.
        if !(held.folder.case().exists() && held.goes_on()) {
            replace_file(&held.folder.case(), case.as_bytes()).map_err(Failure::failed)?;
        }
        // Last, since it makes the folder one of this case.
        replace_file(&held.folder.bare(), bare.as_bytes()).map_err(Failure::failed)?;
        Ok(Some(held))
    }

    /// Sets results aside whose tables are not what their run wrote, or whose summary is lost, and says which; nothing while a process works there.
    pub fn set_aside_damaged(folder: &RunFolder) -> Result<Option<String>, Failure> {
        let Some(_lock) = locked(folder)? else { return Ok(None) };
        let why = folder.lost_summary().or_else(|| folder.damaged().into_iter().next());
        why.map(|why| set_aside(&folder.results(), &why)).transpose()
    }

    /// Whether a process works in a folder, be it of a study that was killed.
    pub fn is_elsewhere(folder: &RunFolder) -> Result<bool, Failure> {
        Ok(locked(folder)?.is_none())
    }

    /// Whether there is a checkpoint to go on from, or what the earthquake begins with.
    fn goes_on(&self) -> bool {
        ResultFolder::goes_on(&self.folder.results())
    }

    /// Runs it or goes on with it, from what another has come to before its earthquake where that is given.
    pub fn run(&self, from: Option<&Path>, threads: usize, stop: &AtomicBool) -> Result<End, Failure> {
        let from =
            from.map(|from| vec!["--overwrite".into(), "--start-from".into(), from.as_os_str().to_owned()]);
        let goes_on = self.goes_on().then(|| vec!["--resume".into()]);
        // What cannot be resumed, of another version, or shared, is refused before any computing.
        let ways = [goes_on, from, Some(vec!["--overwrite".into()])];
        let ways: Vec<Vec<std::ffi::OsString>> = ways.into_iter().flatten().collect();
        let checkpoints = self.folder.results().join("checkpoint");
        let no_checkpoint = || CHECKPOINTS.iter().all(|name| !checkpoints.join(name).exists());
        let from_own_stages = self.goes_on() && no_checkpoint();
        for (k, way) in ways.iter().enumerate() {
            let log = fs::OpenOptions::new().create(true).append(true).open(self.folder.log());
            let log = log.map_err(|e| Failure::failed(format!("{}: {e}", self.folder.log().display())))?;
            let start = log.metadata().map_or(0, |m| m.len());
            let status = wait(self.start(way, log, threads)?, stop)?;
            match status.code() {
                Some(3) => return Ok(End::Stopped),
                // Where its stages are of another version nothing was computed that would be lost.
                Some(code)
                    if k + 1 < ways.len()
                        && (code == 2
                            || k == 0 && from_own_stages && no_checkpoint() && !self.has_summary()) =>
                {
                    // What is refused, a checkpoint of another version or with other tables, is kept beside what begins anew.
                    if k == 0 && self.goes_on() {
                        let why = said(&self.folder.log(), start);
                        let why = why.lines().next().unwrap_or_default();
                        say(&set_aside(&self.folder.results(), why)?);
                    }
                }
                // Its summary says more.
                Some(0 | 1) if self.has_summary() => return Ok(End::Ended),
                _ if stop.load(Ordering::Relaxed) => return Ok(End::Stopped),
                _ => {
                    let why = format!("{}{}", how(status), said(&self.folder.log(), start));
                    replace_file(&self.folder.broken(), why.as_bytes()).map_err(Failure::failed)?;
                    return Ok(End::Ended);
                }
            }
        }
        Ok(End::Ended)
    }

    fn start(&self, way: &[std::ffi::OsString], log: File, threads: usize) -> Result<Child, Failure> {
        let failed = |e: std::io::Error| Failure::failed(format!("the program cannot be started: {e}"));
        let [program, before @ ..] = machine::again() else {
            return Err(Failure::failed("nothing says how this program is started once more"));
        };
        let mut command = Command::new(program);
        command.args(before).arg("run").arg(self.folder.case()).arg("--out").arg(self.folder.results());
        // Whether there is room for so many runs at once is the study's own choice.
        command.args(way).arg("--ignore-resources").arg("--threads").arg(threads.to_string());
        // The lock as its input, which it never reads: the folder stays locked until it ends, whatever becomes of this process.
        command.stdin(self.lock.try_clone().map_err(failed)?);
        command.stdout(log.try_clone().map_err(failed)?).stderr(Stdio::from(log));
        command.spawn().map_err(failed)
    }

    fn has_summary(&self) -> bool {
        let text = fs::read(self.folder.results().join("summary.json")).unwrap_or_default();
        let summary: serde_json::Value = serde_json::from_slice(&text).unwrap_or_default();
        matches!(summary["status"].as_str(), Some("done" | "failed"))
    }
}

/// The lock of a folder, which is made; nothing where another holds it.
fn locked(folder: &RunFolder) -> Result<Option<File>, Failure> {
    let failed = |e: std::io::Error| Failure::failed(format!("{}: {e}", folder.lock().display()));
    fs::create_dir_all(&folder.0).map_err(failed)?;
    let file =
        fs::OpenOptions::new().read(true).append(true).create(true).open(folder.lock()).map_err(failed)?;
    match file.try_lock() {
        Err(fs::TryLockError::WouldBlock) => Ok(None),
        // A file system without locks keeps nobody out.
        Err(fs::TryLockError::Error(_)) | Ok(()) => Ok(Some(file)),
    }
}

/// Sets results aside for a reason, which is told with their place.
fn set_aside(results: &Path, why: &str) -> Result<String, Failure> {
    let aside = aside(results);
    fs::rename(results, &aside).map_err(|e| Failure::failed(format!("{}: {e}", aside.display())))?;
    Ok(format!("{why}; what is there is kept as {}, and it is run again", aside.display()))
}

/// Where what was computed of an old case may go: NAME.old, NAME.old2 and so on.
fn aside(folder: &Path) -> PathBuf {
    let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let places = std::iter::once(format!("{name}.old")).chain((2..).map(|k| format!("{name}.old{k}")));
    places.map(|name| folder.with_file_name(name)).find(|place| !place.exists()).unwrap_or_default()
}

/// Waits for the end of a process, and passes on a signal to stop.
fn wait(mut child: Child, stop: &AtomicBool) -> Result<ExitStatus, Failure> {
    let mut told = false;
    loop {
        if let Some(status) = child.try_wait().map_err(Failure::failed)? {
            return Ok(status);
        }
        if stop.load(Ordering::Relaxed) && !std::mem::replace(&mut told, true) {
            terminate(&child);
        }
        std::thread::sleep(LOOK);
    }
}

/// Asks a process to write its checkpoint and end.
#[cfg(unix)]
fn terminate(child: &Child) {
    // One that has ended meanwhile is nothing to be told.
    let _ =
        rustix::process::kill_process(rustix::process::Pid::from_child(child), rustix::process::Signal::TERM);
}

#[cfg(not(unix))]
fn terminate(_: &Child) {}

fn how(status: ExitStatus) -> String {
    match status.code() {
        Some(2) => String::new(),
        Some(code) => format!("The program ended with status {code}. "),
        None => {
            format!("The program was ended: {status}. Memory may have run out: take fewer runs at once. ")
        }
    }
}

/// What a process said from its error on; nothing where it told none: lines of progress are no reason, and hold times of the clock.
fn said(log: &Path, start: u64) -> String {
    let mut text = String::new();
    let read = File::open(log).and_then(|mut file| {
        file.seek(SeekFrom::Start(start))?;
        file.read_to_string(&mut text)
    });
    if read.is_err() {
        return String::new();
    }
    text.find("error").map_or_else(String::new, |from| text[from..].trim().chars().take(2000).collect())
}
