//! Ranks that are processes started by MPI, as `mpirun` and schedulers of clusters do.
//!
//! Outside the default members: whoever builds it needs an MPI library with its headers, and libclang to read them. Everything that
//! the engine asks of other ranks is in [`Exchange`]; here it is said in MPI's words. MPI is asked by one thread at a time, whichever
//! that is (`MPI_THREAD_SERIALIZED`). What fails within MPI ends all ranks, as its own handler of errors does.

mod messages;

use messages::Messages;
use mpi::Threading;
use mpi::environment::Universe;
use mpi::topology::Communicator;
use std::sync::{Mutex, MutexGuard, PoisonError};
use tremolite_engine::exchange::{Exchange, Halo, To};

/// Why there is no world of ranks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoWorld {
    /// MPI was there before, or could not be started.
    NotStarted,
    /// It does not take calls from the threads that make them.
    Threads,
}

impl std::fmt::Display for NoWorld {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(match self {
            NoWorld::NotStarted => "MPI could not be started",
            NoWorld::Threads => {
                "this MPI library was built without MPI_THREAD_SERIALIZED; build it with threads"
            }
        })
    }
}

impl std::error::Error for NoWorld {}

/// All ranks that were started together, and which of them this process is.
pub struct World {
    rank: u32,
    ranks: u32,
    /// Ranks on this machine.
    here: u32,
    messages: Mutex<Messages>,
    /// MPI ends with it.
    universe: Universe,
}

// SAFETY: a universe is a sign that MPI was started. It is used by `Drop` alone, and MPI takes calls from any thread, one at a time.
unsafe impl Send for World {}
// SAFETY: all calls but the last go by the lock of `messages`.
unsafe impl Sync for World {}

impl World {
    /// Starts MPI.
    ///
    /// # Errors
    /// If it cannot be started.
    pub fn begin() -> Result<World, NoWorld> {
        let (universe, threading) =
            mpi::initialize_with_threading(Threading::Serialized).ok_or(NoWorld::NotStarted)?;
        if threading < Threading::Serialized {
            return Err(NoWorld::Threads);
        }
        let world = universe.world();
        let (rank, ranks) = (world.rank() as u32, world.size() as u32);
        let here = world.split_shared(world.rank()).size() as u32;
        Ok(World { rank, ranks, here, messages: Mutex::default(), universe })
    }

    /// Ranks on this machine.
    pub fn here(&self) -> u32 {
        self.here
    }

    /// Ends all ranks with a status, at once.
    pub fn abort(&self, status: i32) -> ! {
        self.universe.world().abort(status)
    }

    fn messages(&self) -> MutexGuard<'_, Messages> {
        self.messages.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Ends all ranks with a status, at once, if MPI was started; for where no world is at hand, as in a panic.
pub fn abort_all(status: i32) {
    if mpi::environment::is_initialized() {
        messages::abort(status);
    }
}

impl Exchange for World {
    fn rank(&self) -> u32 {
        self.rank
    }

    fn ranks(&self) -> u32 {
        self.ranks
    }

    fn start(&self, halo: &Halo, words: &mut Vec<f64>) {
        self.messages().start(halo, words);
    }

    fn finish(&self, _: &Halo, words: &mut Vec<f64>) {
        self.messages().finish(words);
    }

    fn gather(&self, own: &[f64], counts: &[usize], to: To) -> Vec<f64> {
        self.messages().gather(self.rank, own, counts, to)
    }

    fn agree(&self, bits: u64) -> u64 {
        self.messages().agree(bits)
    }
}
