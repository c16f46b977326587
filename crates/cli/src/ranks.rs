//! Ranks: processes that `mpirun` or a scheduler started to work on one run together. The first speaks and writes.

use crate::exit::{Code, Failure};
use crate::terminal;
use std::hash::{DefaultHasher, Hasher};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tremolite::{Division, Exchange, Ranks};

/// A run's ranks, once they were started.
pub struct Started {
    exchange: Arc<dyn Exchange>,
    /// Ranks on this machine.
    here: u32,
}

/// What a rank says of which it does not know its own.
const UNKNOWN: u64 = 0;

/// Whether an error was told to all ranks, so that each ends by itself.
static AGREED: AtomicBool = AtomicBool::new(false);
/// The ranks that were started, which stay until all is said: a rank that fails ends the others before MPI itself would wait for them.
static STARTED: Mutex<Option<Arc<dyn Exchange>>> = Mutex::new(None);

fn kept() -> MutexGuard<'static, Option<Arc<dyn Exchange>>> {
    STARTED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Whether something that starts ranks has started this process, and more than one.
pub fn is_one_of_several() -> bool {
    let number = |name: &&str| std::env::var(name).ok()?.parse::<u32>().ok();
    // Open MPI; MPICH, Intel MPI and schedulers that start these by PMI; MVAPICH2.
    ["OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE"]
        .iter()
        .filter_map(number)
        .any(|ranks| ranks > 1)
}

/// The ranks that were started together, if there are several.
///
/// # Errors
/// If this program was built without MPI, or MPI cannot be started.
pub fn started() -> Result<Option<Started>, Failure> {
    if !is_one_of_several() {
        return Ok(None);
    }
    let started = begin()?;
    *kept() = Some(started.exchange.clone());
    if started.exchange.rank() > 0 {
        terminal::be_quiet();
    }
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        hook(panic);
        end_all(Code::Failed);
    }));
    // Before all else: programs that differ understand each other in nothing more than this.
    started.as_first("program", program())?;
    Ok(Some(started))
}

/// What this program is known by: the bytes of its file, where they can be read.
fn program() -> Option<u64> {
    let file = std::env::current_exe().ok()?;
    Some(known_by(&std::fs::read(file).ok()?))
}

fn known_by(bytes: &[u8]) -> u64 {
    let mut hasher = DefaultHasher::new();
    hasher.write(bytes);
    hasher.finish()
}

#[cfg(feature = "mpi")]
fn begin() -> Result<Started, Failure> {
    let world = tremolite_mpi::World::begin().map_err(Failure::failed)?;
    let here = world.here();
    Ok(Started { exchange: Arc::new(world), here })
}

#[cfg(not(feature = "mpi"))]
fn begin() -> Result<Started, Failure> {
    Err(Failure::input(
        "several ranks were started, and this program was built without MPI; build it with `cargo build --release \
         --features mpi -p tremolite-cli`, or start it without mpirun",
    ))
}

#[cfg(feature = "mpi")]
fn end_all(code: Code) {
    tremolite_mpi::abort_all(code as i32);
}

#[cfg(not(feature = "mpi"))]
fn end_all(_: Code) {}

/// Ends all ranks for a failure of this one, unless all know of it.
pub fn failed(failure: &Failure) {
    if kept().is_some() && !AGREED.load(Relaxed) {
        terminal::say_of_rank(&failure.message);
        end_all(failure.code);
    } else {
        terminal::say(&failure.message);
    }
}

/// Leaves the other ranks in good order, where all came so far.
pub fn end() {
    drop(kept().take());
}

impl Started {
    pub fn is_first(&self) -> bool {
        self.exchange.rank() == 0
    }

    /// What a rank came to, if all ranks came so far; else a failure of all: the first rank's, or of one that the first did not have.
    ///
    /// # Errors
    /// That failure.
    pub fn together<T>(&self, own: Result<T, Failure>) -> Result<T, Failure> {
        let rank = self.exchange.rank();
        let bit = if rank == 0 { 1 } else { 2 };
        let failed = self.exchange.agree(if own.is_err() { bit } else { 0 });
        if failed == 0 {
            return own;
        }
        AGREED.store(true, Relaxed);
        match own {
            Ok(_) => Err(Failure::of(Code::BadInput, String::new())),
            Err(failure) => {
                if failed & 1 == 0 {
                    terminal::say_of_rank(&failure.message);
                }
                Err(failure)
            }
        }
    }

    /// Whether all ranks have the case that the first has, `text` with what was set, and begin as it does.
    ///
    /// # Errors
    /// A failure of all if one has another.
    pub fn same_case(&self, text: &str, from: bool) -> Result<(), Failure> {
        self.as_first("case", Some(known_by(format!("{from} {text}").as_bytes())))
    }

    /// Whether all ranks have what the first has, by a number, where each knows its own.
    fn as_first(&self, what: &str, own: Option<u64>) -> Result<(), Failure> {
        let own = f64::from_bits(own.unwrap_or(UNKNOWN));
        let counts = vec![1; self.exchange.ranks() as usize];
        let all = self.exchange.gather(&[own], &counts, tremolite::exchange::To::All);
        let first = all[0].to_bits();
        let known = |bits: u64| first != UNKNOWN && bits != UNKNOWN;
        let Some(other) = all.iter().position(|one| one.to_bits() != first && known(one.to_bits())) else {
            return Ok(());
        };
        AGREED.store(true, Relaxed);
        Err(Failure::input(format!(
            "rank {other} runs another {what} than the first; start all ranks with the same program, case file, --set and --start-from"
        )))
    }

    /// Threads of each rank if none are asked for: what a rank may use, or its part of the machine where it may use all of it.
    pub fn threads(&self) -> usize {
        let may = crate::machine::threads();
        if may < crate::machine::cores() { may } else { (may / self.here as usize).max(1) }
    }

    /// A sentence where ranks may use fewer cores than their machine leaves them.
    pub fn bound(&self) -> Option<String> {
        let (may, cores) = (crate::machine::threads(), crate::machine::cores());
        (may * self.here as usize + self.here as usize <= cores).then(|| {
            format!(
                "each of {} ranks on this machine may use {may} of its {cores} cores; start with `mpirun --bind-to none`, or \
                 `--map-by socket:PE={}`, to use all",
                self.here,
                cores / self.here as usize
            )
        })
    }

    /// Numbers of the first rank, for all: the bytes of a text.
    pub fn told_by_first(&self, text: &str) -> String {
        let bytes: Vec<f64> =
            if self.is_first() { text.bytes().map(f64::from).collect() } else { Vec::new() };
        let mut counts = vec![0; self.exchange.ranks() as usize];
        counts[0] = self.exchange.agree(bytes.len() as u64) as usize;
        let bytes = self.exchange.gather(&bytes, &counts, tremolite::exchange::To::All);
        String::from_utf8_lossy(&bytes.into_iter().map(|byte| byte as u8).collect::<Vec<_>>()).into_owned()
    }

    /// The ranks at work on a model.
    pub fn at_work(&self, model: &tremolite::Model, assembly: &tremolite::Assembly) -> Arc<Ranks> {
        let division = Division::even(model, assembly, self.exchange.ranks());
        Arc::new(Ranks::new(self.exchange.clone(), division))
    }
}
