//! Work on threads of its own while the interpreter is released, and what of it Python has to do meanwhile.

use crate::errors::{failed, unusable};
use crate::fork::refuse_child;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::cell::RefCell;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

/// How long Ctrl-C may go unseen.
const TICK: Duration = Duration::from_millis(20);

/// Something for Python to do on the thread that waits.
type Request = Box<dyn FnOnce(Python<'_>) + Send>;

/// Where work that is away leaves what Python is to do: callbacks run on the thread that called, where debuggers, plots and Ctrl-C
/// expect them.
#[derive(Default)]
pub struct Desk {
    requests: Mutex<Option<Sender<Request>>>,
    raised: Mutex<Option<PyErr>>,
}

impl Desk {
    /// Keeps what a script raised, until the work is over; the first of several.
    pub fn raise(&self, error: PyErr) {
        // Nothing panics while it holds this lock.
        if let Ok(mut raised) = self.raised.lock() {
            raised.get_or_insert(error);
        }
    }

    /// What a script raised.
    pub fn raised(&self) -> Option<PyErr> {
        self.raised.lock().ok()?.take()
    }

    /// Has Python do something and waits for what comes of it; nothing where nobody waits for the work.
    pub fn ask<T: Send + 'static>(&self, what: impl FnOnce(Python<'_>) -> T + Send + 'static) -> Option<T> {
        let requests = self.requests.lock().ok()?.clone()?;
        let (answer, answered) = channel();
        // Nobody waits where the caller has gone: then there is no answer either.
        let request: Request = Box::new(move |py| {
            let _ = answer.send(what(py));
        });
        requests.send(request).ok()?;
        drop(requests);
        answered.recv().ok()
    }

    fn open(&self, requests: Option<Sender<Request>>) {
        // Nothing panics while it holds this lock.
        if let Ok(mut held) = self.requests.lock() {
            *held = requests;
        }
    }
}

/// Who asked for what a thread of a pool works on.
#[derive(Clone, Default)]
pub struct Asker {
    pub desk: Arc<Desk>,
    pub stop: Arc<AtomicBool>,
}

thread_local! {
    static ASKER: RefCell<Option<Asker>> = const { RefCell::new(None) };
}

/// Who asked for what this thread works on; nobody where the work does not run a script's code.
pub fn asker() -> Option<Asker> {
    ASKER.with_borrow(Clone::clone)
}

/// Closes the desk when the work is over, however it ends.
struct Closing<'a>(&'a Desk);

impl Drop for Closing<'_> {
    fn drop(&mut self) {
        self.0.open(None);
    }
}

/// What came of work that was away.
pub struct Back<T> {
    pub result: T,
    /// What a signal raised meanwhile: Ctrl-C.
    pub interrupt: Option<PyErr>,
}

/// A pool of `threads` threads, or of all.
///
/// # Errors
/// In a forked child of a process that has computed, and for a number of threads that cannot be meant.
pub fn pool(threads: Option<usize>) -> PyResult<ThreadPool> {
    pool_of(threads, None)
}

/// The same, whose threads know who asked for their work.
///
/// # Errors
/// As [`pool`].
pub fn pool_of(threads: Option<usize>, asker: Option<Asker>) -> PyResult<ThreadPool> {
    refuse_child()?;
    let threads = threads.unwrap_or_else(|| thread::available_parallelism().map_or(1, usize::from));
    if !(1..=4096).contains(&threads) {
        return Err(unusable("threads is between 1 and 4096; leave it out for all"));
    }
    let begins = move |_| ASKER.set(asker.clone());
    ThreadPoolBuilder::new().num_threads(threads).start_handler(begins).build().map_err(failed)
}

/// Does work on a pool with the interpreter released, until it is done. A signal sets `stop`, which the work may heed.
///
/// # Errors
/// In a forked child, and where the work broke off by a fault of this program.
pub fn away<T: Send>(
    py: Python<'_>,
    pool: &ThreadPool,
    desk: &Desk,
    stop: &AtomicBool,
    work: impl FnOnce() -> T + Send,
) -> PyResult<Back<T>> {
    refuse_child()?;
    let (send, receive) = channel();
    desk.open(Some(send));
    thread::scope(|scope| {
        let worker = scope.spawn(|| {
            let _closing = Closing(desk);
            pool.install(work)
        });
        let interrupt = attend(py, receive, stop);
        match py.detach(|| worker.join()) {
            Ok(result) => Ok(Back { result, interrupt }),
            Err(_) => {
                Err(failed("a fault of this program broke off the work; please report it with the case"))
            }
        }
    })
}

/// Does what is asked for until nobody can ask any more; what a signal raised.
fn attend(py: Python<'_>, mut requests: Receiver<Request>, stop: &AtomicBool) -> Option<PyErr> {
    let mut interrupt = None;
    loop {
        let (back, got) = py.detach(move || {
            let got = requests.recv_timeout(TICK);
            (requests, got)
        });
        requests = back;
        let over = match got {
            Ok(request) => {
                request(py);
                false
            }
            Err(why) => why == RecvTimeoutError::Disconnected,
        };
        // Of short work too, since whoever asked for it knows better what to do with it than the next line of the script.
        if let Err(raised) = py.check_signals() {
            stop.store(true, Ordering::Relaxed);
            interrupt.get_or_insert(raised);
        }
        if over {
            return interrupt;
        }
    }
}
