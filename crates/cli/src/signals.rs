//! Signals that stop a run with a checkpoint.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// A flag that is set once a signal asks to stop: SIGINT, SIGTERM, and SIGHUP, which a lost terminal sends, unless it is ignored
/// from the start as under `nohup`. Without a handler a signal ends the program at once; nothing worse.
pub fn stop_flag() -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    let mut signals = vec![signal_hook::consts::SIGINT, signal_hook::consts::SIGTERM];
    #[cfg(unix)]
    if hang_up_ignored() == Some(false) {
        signals.push(signal_hook::consts::SIGHUP);
    }
    for signal in signals {
        let _ = signal_hook::flag::register(signal, stop.clone());
    }
    stop
}

/// Whether SIGHUP is ignored; nothing where the system does not tell it, and its handling then stays as it is.
#[cfg(unix)]
fn hang_up_ignored() -> Option<bool> {
    ignored(&std::fs::read_to_string("/proc/self/status").ok()?, signal_hook::consts::SIGHUP)
}

/// Whether a signal is ignored by the mask of a process's status (proc_pid_status(5)): hexadecimal, a bit a signal from 1 on.
#[cfg(unix)]
fn ignored(status: &str, signal: i32) -> Option<bool> {
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"))?;
    let mask = u64::from_str_radix(mask.trim(), 16).ok()?;
    Some(mask >> (signal - 1) & 1 == 1)
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn a_signal_is_ignored_where_its_bit_is_set() {
        let status = |mask: &str| format!("Name:\tx\nSigIgn:\t{mask}\nSigCgt:\t0000000000000001\n");
        assert_eq!(ignored(&status("0000000000000001"), 1), Some(true));
        assert_eq!(ignored(&status("0000000000001000"), 1), Some(false));
        assert_eq!(ignored(&status("0000000000001000"), 13), Some(true));
        assert_eq!(ignored("Name:\tx\n", 1), None);
    }
}
