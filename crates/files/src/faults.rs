//! A disk that is full or fails, for tests: from some moment on what is done to files goes wrong.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::{Mutex, PoisonError};

/// What goes wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// Nothing more can be made or written; half of the first write still fits.
    Full,
    /// Nothing at all can be done any more, as on a network drive that went away.
    Gone,
    /// One thing fails, all others go well.
    Once,
}

/// What somebody wants to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Want {
    /// A file or folder that was not there, or bytes.
    Room,
    /// What a full disk still does.
    Else,
}

/// The folder below which it goes wrong, how many things go well first, and what then happens.
struct Ahead {
    root: PathBuf,
    left: usize,
    fault: Fault,
    done: bool,
}

static IS_ON: AtomicBool = AtomicBool::new(false);
static AHEAD: Mutex<Option<Ahead>> = Mutex::new(None);

/// After so many more things below a folder, which all go well, a fault comes. One at a time, in all threads of the process.
pub fn begin(root: &Path, after: usize, fault: Fault) {
    let ahead = Ahead { root: root.to_owned(), left: after, fault, done: false };
    *AHEAD.lock().unwrap_or_else(PoisonError::into_inner) = Some(ahead);
    IS_ON.store(true, Relaxed);
}

/// The disk works again. Whether the fault came.
pub fn end() -> bool {
    IS_ON.store(false, Relaxed);
    AHEAD.lock().unwrap_or_else(PoisonError::into_inner).take().is_some_and(|ahead| ahead.done)
}

/// What comes of a wish.
pub(crate) enum Answer {
    Yes,
    /// Half of the bytes.
    Half,
}

/// Whether it goes well now.
///
/// # Errors
/// The fault, where there is one.
pub(crate) fn ask(path: &Path, want: Want) -> io::Result<Answer> {
    if !IS_ON.load(Relaxed) {
        return Ok(Answer::Yes);
    }
    let mut ahead = AHEAD.lock().unwrap_or_else(PoisonError::into_inner);
    let Some(ahead) = ahead.as_mut().filter(|ahead| path.starts_with(&ahead.root)) else {
        return Ok(Answer::Yes);
    };
    if ahead.left > 0 {
        ahead.left -= 1;
        return Ok(Answer::Yes);
    }
    let first = !std::mem::replace(&mut ahead.done, true);
    match ahead.fault {
        Fault::Full if want == Want::Else => {
            // It did not come yet: a full disk is seen by who wants room.
            ahead.done = !first;
            Ok(Answer::Yes)
        }
        Fault::Full if first => Ok(Answer::Half),
        Fault::Full => Err(io::ErrorKind::StorageFull.into()),
        Fault::Once if !first => Ok(Answer::Yes),
        Fault::Gone | Fault::Once => Err(io::Error::other("the disk failed")),
    }
}
