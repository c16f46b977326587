//! Whether a change is on: the environment says which one, or that those which are come by be noted. Copied into the program that is changed.

use std::sync::atomic::{AtomicU8, AtomicU32, Ordering::Relaxed};

/// All are off, and each that is come by is noted.
const NOTE: u32 = u32::MAX - 1;
/// Nobody has asked yet.
const UNSET: u32 = u32::MAX;

static ON: AtomicU32 = AtomicU32::new(UNSET);
static SEEN: [AtomicU8; 4096] = [const { AtomicU8::new(0) }; 4096];

#[inline(always)]
pub fn on(change: u32) -> bool {
    let on = ON.load(Relaxed);
    match on < NOTE {
        true => on == change,
        false => SEEN[change as usize].load(Relaxed) == 0 && asked(change),
    }
}

#[cold]
#[inline(never)]
fn asked(change: u32) -> bool {
    if ON.load(Relaxed) == UNSET {
        let on = match std::env::var("MUTANT").ok().as_deref() {
            Some("note") => NOTE,
            Some(number) => number.parse().unwrap(),
            None => 0,
        };
        ON.store(on, Relaxed);
    }
    if ON.load(Relaxed) == NOTE && SEEN[change as usize].swap(1, Relaxed) == 0 {
        use std::io::Write;
        let path = std::env::var("MUTANTS_SEEN").unwrap();
        let mut file = std::fs::OpenOptions::new().append(true).create(true).open(path).unwrap();
        file.write_all(format!("{change}\n").as_bytes()).unwrap();
    }
    ON.load(Relaxed) == change
}
