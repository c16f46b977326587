//! Facts of the machine: threads, memory used, and what it can do at best.

use std::ffi::OsString;
use std::hint::black_box;
use std::path::Path;
use std::sync::OnceLock;
use std::time::Instant;
use tremolite_laws::Isa;

/// What starts this program once more.
static AGAIN: OnceLock<Vec<OsString>> = OnceLock::new();

/// Keeps what starts this program once more: the program, and what stands before a command.
pub fn starts_again_by(again: Vec<OsString>) {
    // Of several calls in one process the first one's stays: it is the same program.
    let _ = AGAIN.set(again);
}

/// What starts this program once more.
pub fn again() -> &'static [OsString] {
    AGAIN.get().map_or(&[], Vec::as_slice)
}

/// Threads to use if none are asked for.
pub fn threads() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// Cores of the machine, whether this process may use them or not, where the system tells it; else what it may use.
pub fn cores() -> usize {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let cores = text.lines().filter(|line| line.starts_with("processor")).count();
    if cores > 0 { cores } else { threads() }
}

/// Largest resident memory of this process \[bytes\], where the system tells it.
pub fn peak_bytes() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"))?;
    Some(line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok()? * 1024)
}

/// Memory that a program may still take \[bytes\]: of the machine, or of what a container or a scheduler leaves; where the system
/// tells it.
pub fn free_memory() -> Option<u64> {
    let all = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = all.lines().find_map(|l| l.strip_prefix("MemAvailable:"))?;
    let machine = line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok()? * 1024;
    Some(group_memory().map_or(machine, |group| machine.min(group)))
}

/// What the control groups of this process (of either version), and those that they are in, leave of their limits at the least, if any has
/// one \[bytes\]: files that they have read give way.
fn group_memory() -> Option<u64> {
    let own = std::fs::read_to_string("/proc/self/cgroup").ok()?;
    let bytes = |text: &str| text.trim().parse::<u64>().ok();
    let left = |folder: &Path, [most, taken]: [&str; 2]| {
        let read = |file: &str| std::fs::read_to_string(folder.join(file)).ok();
        let (most, taken) = (bytes(&read(most)?)?, bytes(&read(taken)?)?);
        let files = read("memory.stat").and_then(|all| {
            let line = |name: &str| all.lines().find_map(|l| bytes(l.strip_prefix(name)?));
            line("total_inactive_file ").or_else(|| line("inactive_file "))
        });
        Some(most.saturating_sub(taken.saturating_sub(files.unwrap_or(0))))
    };
    let of_line = |line: &str| -> Option<u64> {
        let (kind, path) = line.split_once(':')?.1.split_once(':')?;
        let (root, files) = match kind {
            "" => (Path::new("/sys/fs/cgroup"), ["memory.max", "memory.current"]),
            "memory" => {
                (Path::new("/sys/fs/cgroup/memory"), ["memory.limit_in_bytes", "memory.usage_in_bytes"])
            }
            _ => return None,
        };
        let own = Path::new(path.trim_start_matches('/'));
        // Within a container the group's own path may not be there, but the container's is the root.
        own.ancestors().filter_map(|group| left(&root.join(group), files)).min()
    };
    own.lines().filter_map(of_line).min()
}

/// Bytes that are free on the disk of a folder, or of the folder that it will be made in; where the system tells it.
pub fn free_disk(folder: &Path) -> Option<u64> {
    let whole = std::path::absolute(folder).ok()?;
    whole.ancestors().find(|place| place.is_dir()).and_then(|place| fs4::available_space(place).ok())
}

/// The processor's name, where the system tells it.
pub fn processor() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name =
        info.lines().find_map(|l| l.strip_prefix("model name")?.split_once(':').map(|(_, n)| n.trim()));
    name.unwrap_or("unknown processor").to_owned()
}

/// An instruction set by the word of `--isa`; the best one without it.
pub fn isa(word: Option<&str>) -> Result<Isa, crate::exit::Failure> {
    let Some(word) = word else { return Ok(Isa::best()) };
    let known: Vec<&str> = Isa::ALL.iter().map(|i| i.name()).collect();
    match Isa::ALL.into_iter().find(|i| i.name() == word) {
        Some(isa) if isa.available() => Ok(isa),
        Some(isa) => {
            Err(crate::exit::Failure::input(format!("this processor has no {}; leave --isa out", isa.name())))
        }
        None => Err(crate::exit::Failure::input(format!("--isa is one of {}", known.join(", ")))),
    }
}

/// Memory bandwidth with some threads \[B/s\]: a ← b + s c over arrays far beyond the caches, best of five.
pub fn triad_bandwidth(threads: usize) -> f64 {
    const N: usize = 8 << 20;
    let worker = || {
        let b = vec![1.0_f64; N];
        let c = vec![2.0_f64; N];
        let mut a = vec![0.0_f64; N];
        let mut best = 0.0_f64;
        for _ in 0..5 {
            let begin = Instant::now();
            for ((a, b), c) in a.iter_mut().zip(&b).zip(&c) {
                *a = b + 0.5 * c;
            }
            black_box(&mut a);
            best = best.max(24.0 * N as f64 / begin.elapsed().as_secs_f64());
        }
        best
    };
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(worker)).collect();
        workers.into_iter().filter_map(|w| w.join().ok()).sum()
    })
}

/// Fused multiply–adds of one core, as floating-point operations a second, with the widest registers.
pub fn peak_flops() -> f64 {
    #[cfg(target_arch = "x86_64")]
    {
        use tremolite_laws::Lane;
        use tremolite_laws::lane::{Avx2, Avx512, Enabled};

        #[derive(Clone, Copy)]
        struct Here;
        // SAFETY: named below alone, in functions that are called where the processor has the instruction set.
        unsafe impl Enabled for Here {}

        #[inline(always)]
        fn chains<L: Lane>(rounds: u64) -> [L; 12] {
            let mut x = [L::splat(black_box(1.0)); 12];
            let (a, b) = (L::splat(black_box(1.0 - 1e-9)), L::splat(black_box(1e-9)));
            for _ in 0..rounds {
                for x in &mut x {
                    *x = x.mul_add(a, b);
                }
            }
            x
        }
        #[target_feature(enable = "avx512f,avx2,fma")]
        unsafe fn wide(rounds: u64) {
            black_box(chains::<Avx512<Here>>(rounds));
        }
        #[target_feature(enable = "avx2,fma")]
        unsafe fn middle(rounds: u64) {
            black_box(chains::<Avx2<Here>>(rounds));
        }
        const ROUNDS: u64 = 10_000_000;
        let begin = Instant::now();
        let width = match Isa::best() {
            // SAFETY: the instruction set is available.
            Isa::Avx512 => unsafe {
                wide(ROUNDS);
                8.0
            },
            // SAFETY: as above.
            Isa::Avx2 => unsafe {
                middle(ROUNDS);
                4.0
            },
            Isa::Scalar => return f64::NAN,
        };
        2.0 * width * 12.0 * ROUNDS as f64 / begin.elapsed().as_secs_f64()
    }
    #[cfg(not(target_arch = "x86_64"))]
    f64::NAN
}
